# Every format of pictures and models gives the same bytes on any number of threads, and a full disk, a closed pipe and
# too little memory end them all. The words are long enough for many blocks; `bush` has polygons in between.
printf 'axiom: X\nX --> F[+X]F[-X]+X\nF --> FF\nangle: 20\nsteps: 9\n' > plant.lsys
printf 'axiom: A\nA --> F[&A/{.F.+F.}]F[!A]\nF --> FF\nangle: 30\nsteps: 9\n' > bush.lsys
for grammar in plant bush; do
  lsysc $grammar.lsys
  for format in svg pdf png obj ply glb json; do
    for threads in 1 2 7; do
      ./$grammar --threads $threads --format $format | cksum
    done | sort -u | wc -l
  done
done
for format in svg pdf png obj ply glb json; do
  ./plant --threads 7 --format $format > /dev/full; echo "status $?"
  case $format in svg | obj | json) ./plant --threads 7 --format $format | head -c 1 > closed ;; esac
done
lsysc run plant.lsys -n 8 --threads 7 --max-memory 1M -o plant.json 2>&1 | sed "s|memory: .*|memory|"
ls *.json 2> /dev/null
