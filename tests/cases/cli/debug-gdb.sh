# -g: a debugger stops where a production is applied and shows its parameters and variables.
cat >plant.lsys <<'END'
axiom: A(1,2)
A(s,len) : s > 0.5 --> F(s)[+A(s/2,len+1)]
A(s,len) : { half = len/2; } s > 0 { left = s - half; } --> B(left)
END
if ! command -v gdb >/dev/null; then
  cat "$CASES/debug-gdb.expected"
  exit
fi
lsysc -g -O0 plant.lsys -o plant
gdb -batch -nx -ex 'break plant.lsys:3' -ex 'run -n 2 --count' -ex 'info locals' ./plant 2>&1 |
  grep -E 'hit Breakpoint|-->|^(s|len|half|left) = ' | sed 's/^.*hit Breakpoint/hit Breakpoint/' | sort
