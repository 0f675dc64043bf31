# The length of a curve is a number.
printf 'cver 1 1\nname: line\npoints: 4 4\ntype: open\n0 0 0 1\n1 0 0 1\n2 0 0 1\n6 3 0 1\n' > line.con
printf 'curve line: line.con\naxiom: A(curveGAL(line))A(curveGAL(1) - curveGAL(line))A(curveX(1, 0))\n' > a.lsys
lsysc interp a.lsys -n 0
lsysc run a.lsys -n 0
printf 'curve line: line.con\naxiom: A(curveGAL(2))\n' | lsysc check -
