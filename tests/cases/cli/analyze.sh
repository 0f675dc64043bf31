# The report on a deterministic grammar, and on one whose size only deriving tells.
cat > tree.lsys <<'END'
axiom: !(1)F(200)A
steps: 100
A --> !(1.7)F(50)[&(19)F(50)A]/(95)[&(19)F(50)A]
F(l) --> F(l*1.1)
END
cat > signal.lsys <<'END'
axiom: A[+A]B
A < A --> B : 0.5
A < A --> C : 0.5
ignore: +
END
lsysc analyze tree.lsys
echo
lsysc analyze signal.lsys
