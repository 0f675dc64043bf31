# A word that no disk holds is refused before work starts; no file is left behind.
printf 'axiom: b\na --> ab\nb --> a\n' > algae.lsys
lsysc run algae.lsys -n 300 -o word.txt 2>&1 | sed 's/room for [^ ]* bytes/room for N bytes/'
lsysc run algae.lsys -n 100000 -o word.txt 2>&1 | sed 's/room for [^ ]* bytes/room for N bytes/'
ls
lsysc run algae.lsys -n 10 -o word.txt && wc -c < word.txt
# What can be written but takes too long is said, too, but for the beginning of a word.
timeout 0.5 lsysc run algae.lsys -n 100 --hash; echo "status $?"
lsysc run algae.lsys -n 100 2> errors | head -c 20; sed 's/.*: error/error/' errors
