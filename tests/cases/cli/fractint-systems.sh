# A file of several systems: listed, chosen by name, and what is said when there is none of that name.
cat > several.l <<'END'
; two curves and a comment
Koch (triangle) { ; the island
  Angle 6
  Axiom f--f--f
  f=f+f--f+f
}
comment { axiom is not read here }
Levy {
  angle=8
  axiom=f
  f=+f--f+
}
END
lsysc --list-systems several.l
lsysc interp several.l -n 1 --count
lsysc interp -w --system levy several.l -n 4 --stats | grep -E '^(segments|colour)'
lsysc fmt -w --system KOCH several.l
lsysc check --system levi several.l; echo "status $?"
