# What needs no code generator does not load it.
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
cp "$(command -v lsysc)" .
./lsysc check algae.lsys && ./lsysc interp algae.lsys && ./lsysc help > /dev/null && ./lsysc --version
./lsysc run algae.lsys 2>&1 | sed 's/: \/.*/: .../'
LSYSC_HOME=$(dirname "$(dirname "$(command -v lsysc)")")/lib/lsysc ./lsysc run algae.lsys
