# A view file's settings, and what is wrong with one.
mkdir sub
cat > sub/plant.v <<'FILE'
#define SIDES 12
/* the view */
angle factor: SIDES   // twelve
initial color: 3 4
initial line width: 0.5 pixels
tropism direction: -0.04, 1.0,0
initial elasticity: 0.25
z buffer: on
#ifdef FANCY
light: V: 1 2 3
#endif
function: ramp.func 100
surface: l leaf.obj 2
FILE
printf 'fver 1 1\nname: x\npoints: 2\n0 0\n1 1\n' > sub/ramp.func
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' > sub/leaf.obj
cat > plant.l <<'FILE'
Lsystem: 1
derivation length: 2
Axiom: A(0.25)
A(s) --> F[+(func(1,s)*90)~l]A(s+.25)
endlsystem
FILE
lsysc run -w plant.l --view sub/plant.v
lsysc run plant.l -DFANCY --view sub/plant.v -n 0
lsysc run -w plant.l --view sub/plant.v -n 1 --stats | grep -e box -e colour
lsysc fmt -w --view sub/plant.v plant.l > native.lsys && lsysc run native.lsys && head -10 native.lsys
printf 'axiom: F+F\nangle: 90\n' | lsysc interp -w --view sub/plant.v - -n 0 --stats | grep -e end -e colour
cat > sub/wrong.v <<'FILE'
angel factor: 3
foo
initial color: red
#define NUMBER x
initial line width: NUMBER
tropism: T: 1 2
tropism direction:
surface: l
function: nothing.func
curve: ramp.func
FILE
lsysc check -w --view sub/wrong.v plant.l
lsysc check -w --view none.v plant.l
printf 'ANGLE  FACTR : 3\nViewpont: 1 2 3\ncontuor: a.con\n' > sub/misspelt.v
lsysc check -w --view sub/misspelt.v plant.l
