# A full disk is an error, not a silent loss.
lsysc help > /dev/full; echo "status $?"
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
lsysc run algae.lsys > /dev/full; echo "status $?"
lsysc --emit=llvm algae.lsys -o /dev/full; echo "status $?"
