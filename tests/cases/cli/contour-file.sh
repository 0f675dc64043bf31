# Contours of generalised cylinders from files: the same mesh by every engine, by number, from view files; what is wrong.
mkdir sub
three() { for p in "$@"; do echo "${p%,*} ${p#*,} 0 3"; done; }
drawn() { # NAME TYPE POINT...: corners, as each point counts three times
  printf 'cver 1 1\nname: %s\npoints: %d\ntype: %s\nsamples: 40\n' "$1" $(($# - 2)) "$2"
  shift 2
  three "$@"
}
drawn square closed 1,-1 1,1 -1,1 -1,-1 > sub/square.con
drawn back closed 1,-1 -1,-1 -1,1 1,1 > sub/back.con
drawn roof 'open endpoint' -1,0 0,1 1,0 > sub/roof.con
drawn dot closed 1,1 > sub/dot.con
cat > prism.lsys <<'FILE'
contour 3: sub/square.con
contour 1: sub/roof.con
axiom: #(2)@!(4)@#(3)@Gsf(3)@Ge(1)
FILE
lsysc run prism.lsys --format obj > run.obj && grep ^v run.obj
lsysc interp prism.lsys --format obj | cmp - run.obj && lsysc prism.lsys -o prism && ./prism --format obj | cmp - run.obj && echo same
sed 's/square/back/' prism.lsys | lsysc run - --format obj | cmp - run.obj && echo turned round
echo a number of its own, instead of a ribbon
sed 's/@#(3)/@#(1)/; s/@!(4)/@!(3)/' prism.lsys | lsysc interp - --format obj | grep '^v '
echo a number that there is not
sed 's/@#(3)/@#(3)@#(4)@#(-1)/' prism.lsys | lsysc run - --format obj | cmp - run.obj && echo same
echo of a view file
printf 'contour: roof.con\ncontour: square.con 3\n' > sub/prism.v
printf 'axiom: #(2)@!(4)@#(3)@Gsf(3)@Ge(1)\nwidths_are_lengths: 1\n' > bare.lsys
lsysc fmt --view sub/prism.v bare.lsys | grep contour
lsysc run --view sub/prism.v bare.lsys --format obj | grep -c '^v '
cat > wrong.lsys <<'FILE'
contour 0: sub/square.con
contour 256: sub/square.con
contour 2: sub/square.con
contour 2: sub/roof.con
contour 3: sub/none.con
contour 4: sub/dot.con
contour 5: disc(1)
contour leaf: sub/square.con
axiom: F
FILE
lsysc check wrong.lsys
echo as cpfg has it: the number first, and the sides that cylinders have
printf 'contour: 3 square.con\ncontour sides: 4\n' > sub/cpfg.v
sed 's/@!(4)//' bare.lsys | lsysc run --view sub/cpfg.v - --format obj | grep '^v ' > view.obj && grep '^v ' run.obj | cmp - view.obj && echo same
printf 'contour: 3 square.con\npolygonization level: 1\n' > sub/level.v
sed 's/@!(4)//' bare.lsys | lsysc run --view sub/level.v - --format obj | grep '^v ' | cmp - view.obj && echo same
sed '3s/@!(4)//; 1s/^/contour_sides: 4\n/' prism.lsys | sed 's/@!(4)//' | lsysc interp - --format obj | cmp - run.obj && echo same
echo several of a file, and all ways to say what they are
point() { printf '%s %s 0 3\n' $1 $2; }
square() { point 1 -1; point 1 1; point -1 1; point -1 -1; }
{ printf 'contourgalleryver 1 1\nitems: 3\ncver 1 1\nname: first\npoints: 2 6\ntype: open\n' && point 1 0 && point 2 0
  printf 'cver 1 3\nname: second\npoints: 4 12\ntype: cr\nsamples: 40\nbackground image\nany.png\nmarkers: 2\n1\n2\n' && square
  printf 'cver 1 2\nname: third\npoints: 4 12\ntype: ce\n' && square; } > sub/several.cset
sed 's/contour 3.*/contour 2: sub\/several.cset/' prism.lsys | lsysc run - --format obj | cmp - run.obj && echo same
sed 's/contour 3.*/contour 2: sub\/several.cset/; s/@#(3)/@#(4)/' prism.lsys | lsysc run - --format obj | grep -c '^v '
sed 's/contour 1.*/contour 254: sub\/several.cset/' prism.lsys | lsysc check -
printf '4 2 closed\n1 -1\n1 1\n-1 1\n-1 -1\n' > sub/old.con
printf 'contour 1: sub/old.con\naxiom: #(2)@#(1)@Gsf(3)@Ge(1)\n' | lsysc run - --format obj | grep -c '^v '
printf '4 closed\n1 -1\n' > sub/old.con
printf 'contour 1: sub/old.con\naxiom: F\n' | lsysc check -
# In an axis, x is -U and y is -L.
drawn bow 'open endpoint' 0,0 1,0 1,1 > sub/bow.con
printf 'contour 1: sub/bow.con\ncontour_sides: 4\naxiom: #(2)@#(1)@Gsf(3)@Ge(1)\n' | lsysc run - --format obj | grep '^v ' | head -5 | cut -d' ' -f1-4
