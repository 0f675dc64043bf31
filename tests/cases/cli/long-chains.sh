# Chains of last successors take constant stack at every -O.
cat > chain.lsys <<'G'
axiom: A(0)M
A(x) --> B(x+1)
B(x) : x > 3 --> C(x*0.5,x)
B(x) --> A(x+2)
C(x,y) --> HB(y/2)
M --> N : 0.5
M --> M : 0.5
N --> M : 1
N --> N : 1
G
ulimit -s 1024
for o in 0 1 2 3; do
  lsysc -w chain.lsys -O$o -o chain
  ./chain -n 1000000 --count | tail -n 1
done
