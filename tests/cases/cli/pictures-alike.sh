# Pictures do not depend on where the parts of a word end: all engines give the same bytes.
printf 'axiom: F\nF --> F+F-F-FF+F+F-F\nsteps: 6\n' > koch.lsys
printf 'axiom: X\nX --> XFX-F[XF]\nF --> FF+\nangle: 60\nsteps: 6\n' > tree.lsys
for grammar in koch tree; do
  lsysc $grammar.lsys
  for format in svg pdf ply; do
    lsysc interp $grammar.lsys -o one.$format && ./$grammar -o two.$format && ./$grammar --threads 7 -o three.$format
    cmp one.$format two.$format && cmp one.$format three.$format && echo $grammar $format
  done
done
