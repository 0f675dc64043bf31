# Each stage can be had as a file, or on standard output.
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
lsysc -c algae.lsys
lsysc -S algae.lsys
lsysc --emit=llvm algae.lsys
lsysc --emit=bc algae.lsys
ls -A
lsysc --emit=llvm algae.lsys -o - | grep -c '@lsys_grammar ='
lsysc --dump=ir algae.lsys | grep -c '@lsys_grammar ='
grep -c lsys_grammar algae.s
