# Every picture of the gallery can be drawn; small here, since this is about the commands.
here=$PWD
while IFS='|' read -r name grammar options caption; do
  case $name in '#'*) continue ;; esac
  lsysc run "$CASES/../../../grammars/$grammar.lsys" -o "$here/$name.png" $options --size=60x60 || echo "$name fails"
done < "$CASES/../../../docs/gallery/pictures"
find . -name '*.png' -size -1 # empty ones
echo drawn
