# What fmt prints is the same grammar: same syntax tree, and printed again the same text; of other
# notations the same words and drawings.
folders="$CASES/../derive $CASES/../seeds $CASES/../../../grammars"
for f in $(find $folders -name '*.lsys' ! -path '*/include/*'); do
  cp "$f" here.lsys
  lsysc fmt -w -I "$(dirname "$f")" here.lsys > once.lsys || { echo "$f cannot be printed"; continue; }
  lsysc fmt -w -I "$(dirname "$f")" once.lsys > twice.lsys
  cmp -s once.lsys twice.lsys || echo "$f changes when it is printed twice"
  lsysc check -w --dump=ast -I "$(dirname "$f")" here.lsys > before
  lsysc check -w --dump=ast -I "$(dirname "$f")" once.lsys > after
  cmp -s before after || echo "$f becomes another tree"
done
for f in $CASES/../derive/*.l $CASES/../seeds/*.txt; do
  lsysc fmt -w "$f" > native.lsys
  lsysc fmt -w native.lsys | cmp -s - native.lsys || echo "$f changes when it is printed twice"
  for g in "$f" native.lsys; do
    lsysc interp -w "$g" -n 3 --hash --stats | sed -n '/^segments/,$p'
  done > both
  half=$(($(wc -l < both) / 2))
  head -n $half both > before
  tail -n $half both | cmp -s - before || echo "$f gives another word or drawing"
done
lsysc fmt --to=cpfg plant.lsys
