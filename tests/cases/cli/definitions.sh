# -D: a textual macro in cpfg's files, a value or a param's default in native ones; behind `run FILE` the program's, too.
cat > tree.l <<'FILE'
lsystem: 1
derivation length: 2
#ifdef SIZE
axiom: A(SIZE)
#else
axiom: A(1)
#endif
param growth = 2
A(x) --> F(x)A(x*growth*RATE)
endlsystem
FILE
lsysc interp -w tree.l -D RATE=1+1
lsysc run -w tree.l -D RATE=1 -D SIZE=3 -D growth=5
lsysc -w -D RATE=1 -Dgrowth=7 tree.l -o tree && ./tree && ./tree -D growth=2
lsysc check -w tree.l
cat > tree.lsys <<'FILE'
param rate = 2 in 1..9
#ifdef BIG
axiom: A(size+1)
#else
axiom: A(1)
#endif
A(x) --> F(x)A(x*rate)
steps: 2
FILE
lsysc interp tree.lsys -D rate=3
lsysc interp -D BIG -D size=2*3 -D rate=4 tree.lsys
lsysc check tree.lsys -D rate=20
lsysc interp tree.lsys -D size=4
lsysc check -D 3=4 tree.lsys
lsysc fmt -D rate=4 tree.lsys | head -1
