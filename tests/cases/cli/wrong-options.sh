# What is wrong with a command line is said in one line, with what was meant or wanted.
try() {
  echo "\$ lsysc $*"
  lsysc "$@"
  echo "status $?"
}
try --emti=exe plant.lsys
try --emit=exe
try --emit=picture plant.lsys
try plant.lsys -n 8
try run -n 8 plant.lsys
try plant.lsys -o
try -O7 plant.lsys
try -Wnosuch plant.lsys
try check
try check -o x plant.lsys
try a.lsys b.lsys
try missing.lsys
try .
try help nosuch
echo 'axiom: A' > a.lsys
try a.lsys -c -march=nosuch --target=aarch64-linux-gnu
try run a.lsys 5
try run -march=x86-64 a.lsys
try run a.lsys -n 1 -march=nosuch
try run a.lsys -n 1 -march=native
try a.lsys -c -S
try a.lsys --emit=llvm -c
try a.lsys -c --emit=obj -o -c.o
try a.lsys -c -O3 -march=x86-64-v99 --target=x86_64-linux-gnu
try a.lsys -c --target=wasm32
try a.lsys -c --target=powerpc64-linux-gnu
lsysc frobnicate plant.lsys
lsysc chek plant.lsys
