# check reads all files and says what is wrong with each.
printf 'axiom: A\nA --> AB\n' > good.lsys
printf 'axiom: A\nA AB\n' > bad.lsys
lsysc check good.lsys; echo "status $?"
lsysc check good.lsys bad.lsys missing.lsys good.lsys; echo "status $?"
lsysc bad.lsys; echo "status $?"
ls -A
