# A signal while the linker runs ends both and removes what is unfinished.
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
printf '#!/bin/sh\ntouch started\nexec sleep 100\n' > slow
chmod +x slow
lsysc algae.lsys --linker=./slow &
while ! [ -e started ]; do
  sleep 0.1
done
kill -TERM $!
wait $! 2> /dev/null
echo "status $?"
ls -A
rm started
# One while a program writes removes what it has written.
printf 'axiom: F\nF --> F+F-F-F+F\n' > koch.lsys
lsysc koch.lsys
for signal in INT QUIT TERM HUP; do
  timeout --foreground --preserve-status -s $signal 0.2 ./koch -n 11 -o koch.svg 2> /dev/null
  ls -A
done
