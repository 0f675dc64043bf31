# `colours:` gives the first colours of the palette, --palette others, --colour-by those of something else.
printf 'axiom: F'"'"'F'"'"'F'"'"'F\ncolours: #8b5a2b, #2b8\ncolours: brown\n' > palette.lsys
colours() { grep -o 'stroke="#[0-9a-f]*"' | sort -u | tr '\n' ' ' && echo; }
for engine in run interp; do
  lsysc $engine palette.lsys --format svg | colours
done
lsysc palette.lsys && ./palette --format svg --palette red,#00f | colours
./palette --format svg --colour-by kind | colours
./palette -o model.obj && grep -c newmtl model.mtl && sed -n 2p model.mtl
lsysc fmt palette.lsys
lsysc check - < palette.lsys
# Births: the trunk comes in step 1, its first branches in step 2, and so on; G is never born again, H is every time.
printf 'axiom: GHA\nA --> F[+A]F\nH --> G\nG --> G\ninterpretation\nA --> F\nendlsystem\n' > age.lsys
lsysc age.lsys
for steps in 0 1 3; do
  ./age -n $steps --colour-by age --palette red,green,blue,white -o one.svg && colours < one.svg
  lsysc interp age.lsys -n $steps --colour-by age --palette red,green,blue,white -o two.svg && cmp one.svg two.svg
done
printf 'axiom: AF\nF < A --> F\nA > F --> A\ndecomposition\nF --> FF\n' > context.lsys
lsysc run context.lsys -n 2 --colour-by age --format svg
lsysc interp context.lsys -n 2 --colour-by age --format svg | colours
printf 'axiom: AB\nA --> AB\ninterpretation\nA > B --> F\n' > looks.lsys
lsysc interp looks.lsys -n 2 --colour-by age --format svg
./age -n 3 --colour-by age --shared -o shared.svg
# JSON has the index of each segment's colour, and by age the step of birth as the last number.
for by in pen order kind age; do ./age -n 3 --colour-by $by --format json | grep '^\[' | cut -d, -f8- | tr '\n' ' ' && echo; done
./age -n 3 --colour-by progress --format json
./age -n 3 --palette red --format json
