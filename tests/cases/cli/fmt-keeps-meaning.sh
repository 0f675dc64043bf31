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
for f in $CASES/../derive/fractint-*.l $CASES/../seeds/*.txt; do
  lsysc fmt -w "$f" > native.lsys
  lsysc fmt -w native.lsys | cmp -s - native.lsys || echo "$f changes when it is printed twice"
  for output in "--hash" "--stats"; do
    lsysc interp -w "$f" -n 3 $output > before
    lsysc interp -w native.lsys -n 3 $output > after
    cmp -s before after || echo "$f gives another $output"
  done
done
