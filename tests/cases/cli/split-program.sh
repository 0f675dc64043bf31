# A grammar of many productions is compiled in two parts at once: every time to the same bytes, and as run does it.
cp "$CASES/../../../benchmarks/grammars/twenty.lsys" .
lsysc twenty.lsys --verbose -o one 2>&1 | grep -o '\.one-[^ ]*\.o' | wc -l
lsysc twenty.lsys -o two && cmp one two
for command in ./one 'lsysc interp twenty.lsys' 'lsysc run twenty.lsys -O1' 'lsysc run twenty.lsys -O2'; do
  $command -n 9 --seed 7 --hash
done | uniq | wc -l
# What stands alone is one file.
lsysc twenty.lsys -c && nm twenty.o | grep -c ' [TDBR] '
ls -A
