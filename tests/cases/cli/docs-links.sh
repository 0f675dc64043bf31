# Every file that the documents link to is there, every grammar is in the gallery's list, and nothing else is.
cd "$CASES/../../.." || exit 1
for page in README.md CONTRIBUTING.md CHANGELOG.md tests/README.md docs/*.md docs/gallery/README.md; do
  grep -o '](\([^)#]*\)' "$page" | cut -c3- | grep -v '^http' | sort -u | while read -r link; do
    [ -e "$(dirname "$page")/$link" ] || echo "$page: no $link"
  done
done
for picture in docs/gallery/*.png; do
  name=$(basename "$picture" .png)
  grep -q "^$name|" docs/gallery/pictures || echo "$picture is not in the list"
done
for grammar in grammars/own/*.lsys; do
  grep -q "|own/$(basename "$grammar" .lsys)|" docs/gallery/pictures || echo "$grammar has no picture"
done
echo checked
