# run and interp take the options of a compiled program behind the grammar.
printf 'param k = 2 in 1..9\naxiom: A(1)\nA(x) --> A(x*k)B\nsteps: 2\n' > grow.lsys
for engine in run interp; do
  lsysc $engine grow.lsys
  lsysc $engine -w grow.lsys -n 3 -D k=3
  lsysc $engine grow.lsys -n 4 --count -o -
  lsysc $engine grow.lsys -o word.txt && cat word.txt
  lsysc $engine grow.lsys -D k=10; echo "status $?"
  lsysc $engine grow.lsys --frobnicate; echo "status $?"
done
printf 'axiom: A\nA --> AB\n' | lsysc interp - -n 2
printf 'axiom: A\nA --> AB\n' | lsysc run - -n 2
