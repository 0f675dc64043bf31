# Options that only some formats read: another format says so, and which ones do; the table is in `help formats`.
printf 'axiom: F+F\nF --> FF\nsteps: 1\n' > a.lsys
quietly() { lsysc run a.lsys "$@" > /dev/null; }
quietly --format obj --size 10x10 --sides 3
quietly --format json --palette red --colour-by order
quietly --format text --camera 1,2
quietly --format pdf --antialias off --background white
quietly --stats --line-width 2
quietly -n 1 --frames -o a.ply --projection orthographic
quietly --shared -o a.svg --sides 4
quietly --format obj --size 10x10 --quiet
quietly --format png --size 10x10 --palette red --antialias off --camera 0,0
lsysc help formats | sed -n '/Options/,$p'
