# Help on a single name or symbol comes from whichever tables know it, from lsysc and from a compiled program.
printf 'axiom: A\nsteps: 1\n' > a.lsys
lsysc a.lsys
for word in + nran colours: camera glb unreachable dump maximum_depth F_l turtl nrand zzzzzz; do
  echo "--- $word"
  lsysc help "$word" 2>&1
done
echo "--- program"
./a --help @Gs
./a --help turtl 2>&1
lsysc run --help | grep -c '^  --'
./a -h | head -1
lsysc -h | head -1
lsysc run -h | head -1
lsysc run a.lsys -h turtle | head -1
lsysc a 2>&1
mv a.lsys b.lsys
lsysc b 2>&1
lsysc help func
lsysc help curveGAL
