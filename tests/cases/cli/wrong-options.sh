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
lsysc frobnicate plant.lsys
lsysc chek plant.lsys
