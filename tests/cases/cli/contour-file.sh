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
