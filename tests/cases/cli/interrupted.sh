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
