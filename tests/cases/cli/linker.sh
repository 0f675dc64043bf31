# The linker's errors are shown, and nothing is left behind.
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
lsysc algae.lsys --linker=no-such-linker; echo "status $?"
lsysc algae.lsys --linker=false; echo "status $?"
printf '#!/bin/sh\necho "crt1.o: cannot find it" >&2\nexit 3\n' > broken
chmod +x broken
lsysc algae.lsys --linker=./broken; echo "status $?"
lsysc algae.lsys --linker=' '; echo "status $?"
ls -A
lsysc algae.lsys --linker='cc -s' && ./algae
