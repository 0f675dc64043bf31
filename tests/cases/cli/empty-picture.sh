# A picture in which nothing is drawn is written, and a note says so; --quiet does not, nor a film, whose beginning may be empty.
printf 'axiom: A,B\nA --> AX\nB --> B\n' > empty.lsys
printf 'axiom: A\nA --> FA\n' > grows.lsys
for format in svg pdf png obj glb; do
  lsysc run empty.lsys -n 2 -o empty.$format && test -s empty.$format && echo $format
done
lsysc interp empty.lsys -n 2 -o empty.svg --quiet
lsysc run grows.lsys -n 2 --frames -o film.png
lsysc run grows.lsys -n 2 --frames -o film.obj
lsysc run grows.lsys -n 2 --svg-animate -o film.svg
lsysc run grows.lsys -n 1 -o one.svg
