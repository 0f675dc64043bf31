# A polygon of 131,072 vertices is a picture or a model in a moment, in the page and in space.
printf 'axiom: {A.}\nA --> AA\nhomomorphism\nA --> F(200)+F(0.5)+F(200)-F(0.5)-\nendlsystem\nangle: 90\nsteps: 15\n' > comb.lsys
printf 'axiom: {A.}\nA --> AA\nhomomorphism\nA --> +(89)F(200)-(178)F(200)+(89)\nendlsystem\nangle: 90\nsteps: 16\n' > zigzag.lsys
printf 'axiom: &(30){A.}\nA --> AA\nhomomorphism\nA --> F(2)+F(0.5)+F(1.5)-F(0.5)-\nendlsystem\nangle: 90\nsteps: 15\n' > tilted.lsys
for grammar in comb zigzag tilted; do
  for format in svg png ply; do
    timeout 60 lsysc run $grammar.lsys -o $grammar.$format; echo "$grammar $format $?"
  done
  head -c 400 $grammar.ply | grep -a face
done
