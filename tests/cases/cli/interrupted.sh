# A signal while the linker runs ends both and removes what is unfinished.
printf 'axiom: A\nA --> AB\nsteps: 3\n' > algae.lsys
printf '#!/bin/sh\ntouch started\nexec sleep 100\n' > slow
chmod +x slow
lsysc algae.lsys --linker=./slow &
for i in 1 2 3 4 5 6 7 8 9 10; do
  [ -e started ] && break
  sleep 0.2
done
kill -TERM $!
wait $! 2> /dev/null
echo "status $?"
ls -A
