# What each pass took is told on standard error; what the command gives stays as it is.
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
# The names of the passes.
names() { sed 's/ *[0-9.]* ms$//' "$1" | tr '\n' ';'; echo; }
lsysc algae.lsys --times 2> compile; names compile
./algae
lsysc run algae.lsys --times 2> run; names run
lsysc interp --times algae.lsys 2> interp; names interp
lsysc check --times algae.lsys 2> check; names check
awk '{ if ($1 == "total") exit !(sum > $(NF-1) - 0.1 && sum < $(NF-1) + 0.1); sum += $(NF-1) }' compile && echo 'the parts sum up'
