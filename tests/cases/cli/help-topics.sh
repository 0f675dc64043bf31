# Every command and topic that `help` lists has a text.
for topic in $(lsysc help | sed -n '/^commands:/,$s/^  \([a-z][a-z]*\) .*/\1/p'); do
  lsysc help $topic > text || echo "no help on $topic"
  [ -s text ] || echo "nothing on $topic"
  grep -n ' $' text | head -1
  awk -v t=$topic 'length($0) > 110 && t !~ /man|bash|zsh|fish/ { print t ": " $0 }' text
done
command -v groff > /dev/null && lsysc help man | groff -man -Tutf8 -ww 2>&1 > /dev/null
lsysc help bash | bash -n
lsysc --version
lsysc run --help | head -1
