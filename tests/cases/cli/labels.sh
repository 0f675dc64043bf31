# Labels: numbers and texts, drawn as lines where lines are drawn, as texts in JSON; models have none.
cat > labels.lsys <<'END'
axiom: A(1)
A(x) : x < 3 --> F(3)[-(90)@L("x = %.2f", x)]+(40)A(x+1)
A(x) : x > 2 --> F(3)@L("\"ä\" %%\n\\")[@L(7)]
steps: 3
END
lsysc run labels.lsys
lsysc run labels.lsys | sed 's/^/axiom: /' > word.lsys && lsysc interp word.lsys
lsysc fmt labels.lsys | cmp - labels.lsys
lsysc labels.lsys
for format in svg pdf png json; do
  ./labels -o one.$format && lsysc interp labels.lsys -o two.$format && cmp one.$format two.$format
done
sed -n '/labels/,$p' one.json
# A number and a text in the same place; what would stand beyond the page is moved onto it.
printf 'axiom: F(1)@L("A")\n' > letter.lsys
lsysc run letter.lsys --format svg --size 100x100 | grep path
printf 'axiom: F(1)@L("AAAA")\n' > letter.lsys
lsysc run letter.lsys --format svg --size 100x20 | grep path
lsysc run labels.lsys --format obj | grep -c '^v ' && lsysc run labels.lsys --format binary | strings | grep @L
# Blocks of the word that come again have theirs, too.
printf 'axiom: X\nX --> X[@L("left")+X]@L(3)-X@L("right")\nsteps: 8\ninterpretation\nX --> F\n' > blocks.lsys
lsysc run blocks.lsys -o one.json && lsysc interp blocks.lsys -o two.json && cmp one.json two.json && grep -c left one.json
# Quotes and line ends survive fmt in blocks, too.
printf 'axiom: A\nEnd: {\n  printf("a\\"b\\\\\\n%%g\\n", 3);\n}\nsteps: 0\n' > print.lsys
lsysc fmt print.lsys | cmp - print.lsys && lsysc interp print.lsys
