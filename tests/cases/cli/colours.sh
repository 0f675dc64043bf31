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
# What is shown draws with the keys of modules that stay.
printf 'axiom: D\nA --> CD\nD --> A\ninterpretation\nC --> F : 1\nC --> f : 1\n' > keys.lsys
for engine in run interp; do lsysc $engine keys.lsys -n 20 --colour-by age --format json | grep '^\[' | grep -o '[0-9]*\]' | tr '\n' ' '; echo; done
printf 'axiom: A\nA --> D(asin(3),10)\nD(a,b) --> D(1,-((a+b))*b)\ninterpretation\nD(a,b) --> F\n' > nan.lsys # one nan is as good as another
for engine in run interp; do lsysc $engine nan.lsys -n 4 --colour-by age --format json | grep '^\[' | grep -o '[0-9]*\]'; done
# Whatever the grammar, and the engine: contexts, letters alone, decomposition, state, rings, predecessors of several
# modules, the cut, sub-L-systems, and homomorphism that sees neighbours.
printf 'axiom: A(1)F(1)\nF(x) < A(y) --> F(x)\nA(x) > F(y) --> A(x+1)F(y)\n' > context.lsys
printf 'axiom: FfFf\nf < F --> fF\nF > f --> F\nf --> F\n' > letters.lsys
printf 'axiom: AF\nF < A --> F\nA > F --> AFF\ndecomposition\nF --> G\n' > decomposed.lsys
printf 'axiom: F\nStart: { n = 0; }\nF : { n = n + 1; } n %% 2 == 1 --> FFG\ndecomposition\nG --> F\n' > state.lsys
printf 'axiom: FFGG\nring lsystem\nG < F --> F\nF < G --> FF\n' > ring.lsys
printf 'axiom: FGFGF\nF G --> GFF\n' > pseudo.lsys
printf 'axiom: F[FG%%F]F[FFH]\nG --> F\nH --> %%FG\nF --> F\n' > cut.lsys
printf 'lsystem: 1\naxiom: F?(2)FF$F\nF --> FG\nG --> F\nendlsystem\nlsystem: 2\nF --> GG\nendlsystem\n' > systems.lsys
printf 'axiom: FA\nF --> FB\nA < A --> A\nA --> AA\ninterpretation\nF < B --> F+F\nA --> F\n' > looks.lsys
printf 'axiom: A\nA < A --> A\nA --> D(asin(3),10)\nD(a,b) --> D(1,-((a+b))*b)\ninterpretation\nD(a,b) --> F\n' > nans.lsys
for grammar in nans context letters decomposed state ring pseudo cut systems looks; do
  lsysc interp $grammar.lsys -n 3 --colour-by age --format json > one.json || continue
  for options in '' '--threads 3' '--engine step'; do
    lsysc run $grammar.lsys -n 3 --colour-by age $options --format json > two.json && cmp one.json two.json
  done
  echo $grammar: $(grep '^\[' one.json | grep -o '[0-9]*\]' | tr -d ']')
done
./age -n 3 --colour-by age --shared -o shared.svg
# JSON has the index of each segment's colour, and by age the step of birth as the last number.
for by in pen order kind age; do ./age -n 3 --colour-by $by --format json | grep '^\[' | cut -d, -f8- | tr '\n' ' ' && echo; done
./age -n 3 --colour-by progress --format json
./age -n 3 --palette red --format json > /dev/null
