# Sizes that a careless program would not survive.

echo "a million steps"
printf 'axiom: A(0)\nA(x) --> A(x+1)\n' > count.lsys
printf 'axiom: A\nA --> BA\n' > chain.lsys
lsysc count.lsys && ./count -n 1000000
lsysc chain.lsys && ./chain -n 1000000 --count && ./chain -n 1000000 | wc -c

echo "an axiom of a million modules"
awk 'BEGIN { printf "axiom: "; for (i = 0; i < 1000000; i++) printf "A"; print "\nA --> AB" }' > long.lsys
lsysc interp long.lsys -n 1 --count

echo "brackets a hundred thousand deep"
awk 'BEGIN { printf "axiom: "; for (i = 0; i < 100000; i++) printf "[F+"; for (i = 0; i < 100000; i++) printf "]"; print "" }' > deep.lsys
lsysc interp deep.lsys --stats | grep -E 'total|segments'

echo "parentheses that nest too deep, and one number too long"
awk 'BEGIN { printf "axiom: A("; for (i = 0; i < 100000; i++) printf "("; print "1" }' > nested.lsys
lsysc check nested.lsys 2>&1 | cut -c 1-100 | head -1
awk 'BEGIN { printf "axiom: A("; for (i = 0; i < 100000; i++) printf "9"; print ")" }' > number.lsys
lsysc check number.lsys 2>&1 | cut -c 1-100 | head -1

echo "more modules than fit anywhere"
printf 'axiom: A\nA --> AA\n' > double.lsys
lsysc double.lsys && ./double -n 200 --count

echo "a word of 10^8 modules in 100 MB of addresses"
(ulimit -v 100000 2> /dev/null; ./double -n 27 --hash)

echo "what turtles, pictures and models hold"
printf 'axiom: A\nA --> [[[[[[[[[[AF\n' > open.lsys
lsysc run -w open.lsys -n 1000000 --max-memory 64M -o open.svg 2>&1 | sed "s|memory: .* are in use|memory: N MiB are in use|"
printf 'axiom: F&F\n' > space.lsys
lsysc run space.lsys --size 9000 --max-memory 100M -o space.png
printf 'axiom: F\nF --> F&[F]F+\n' > bush.lsys
lsysc run bush.lsys -n 12 --max-memory 16M -o bush.svg 2>&1 | sed "s|memory: .* wanted|memory: N MiB more are wanted|"
ls *.svg *.png 2> /dev/null
