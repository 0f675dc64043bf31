# A full disk is an error, not a silent loss.
lsysc help > /dev/full; echo "status $?"
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
lsysc run algae.lsys > /dev/full; echo "status $?"
lsysc --emit=llvm algae.lsys -o /dev/full; echo "status $?"
lsysc algae.lsys
./algae --help > /dev/full; echo "status $?"
# So is a limit of the size of files, which leaves none behind.
(ulimit -f 1; ./algae -n 20000 -o algae.txt); echo "status $?"
ls -A
