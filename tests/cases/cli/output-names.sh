# The program is named after the grammar and stands in the current folder; nothing is overwritten that is no program.
mkdir plants
printf 'axiom: A\nA --> AB\nsteps: 3\n' > plants/algae.lsys
cp plants/algae.lsys nosuffix
lsysc plants/algae.lsys && ./algae
lsysc plants/algae.lsys && echo "a program may be replaced"
lsysc plants/algae.lsys -o other && ./other -n 1
lsysc plants/algae.lsys -o plants
lsysc plants/algae.lsys -o plants/algae.lsys
lsysc nosuffix
echo text > notes
lsysc plants/algae.lsys -o notes
lsysc plants/algae.lsys -o /dev/null
lsysc plants/algae.lsys -o nowhere/algae
lsysc plants/algae.lsys -o -
cat notes
ls -A . plants
