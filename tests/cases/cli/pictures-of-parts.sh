# A PNG drawn from shared parts: the same bytes as from the segments while parts are bigger than an eighth of a pixel.
printf 'axiom: F--F--F\nF --> F+F--F+F\nangle: 60\n' > snowflake.lsys
printf 'axiom: A, A\nA --> {.F.+(120)F.}f[-A]@O(0.5)A\nangle: 40\n' > shapes.lsys
printf 'axiom: FX\nX --> [+F;X]F,[-F;X]\nangle: 35\n' > colours.lsys
lsysc snowflake.lsys && lsysc shapes.lsys && lsysc colours.lsys
same() { cmp one.png two.png && echo same; }
./snowflake -n 5 -o one.png && ./snowflake -n 5 --shared -o two.png && same
./shapes -n 3 -o one.png && ./shapes -n 3 --shared -o two.png && same
./colours -n 4 -o one.png --size 300x200 && ./colours -n 4 -o two.png --size 300x200 --shared && same
./colours -n 4 -o one.png --antialias off && ./colours -n 4 -o two.png --antialias off --shared && same
# 10^12 segments and 10^60, asked for or not, on any number of threads.
./snowflake -n 20 -o one.png && ./snowflake -n 20 --threads 1 --shared -o two.png && same
./snowflake -n 100 --size 200x200 --quiet -o one.png && head -c 4 one.png | tail -c 3 && echo
# What has no parts is drawn as it is, or refused where parts were asked for.
printf 'axiom: F&F\nF --> FF\n' > space.lsys
lsysc run space.lsys -n 3 --shared -o space.png
printf 'axiom: F(1)\nF(x) --> F(x)F(x)\n' > arguments.lsys
lsysc run arguments.lsys -n 3 --shared -o arguments.png
printf 'axiom: A\nA --> AB\nB --> BF\n' > chain.lsys
lsysc run chain.lsys -n 3000 --shared -o chain.png
