# What stands in wide registers outlives the moment when a chunk is full, on whatever processor the JIT generates for.
printf 'steps: 12\naxiom: BB\n[] --> *\nA(a,b) --> BF(1)\nB --> A(0.001,3)BA(1,0.25)\n' > pairs.lsys
for options in -O0 -O1 -O2 -O3; do
  lsysc run -w $options pairs.lsys --hash
done | uniq
lsysc interp -w pairs.lsys --hash
