# Every format of pictures and models, by its suffix or by name; films; parts written once; what is wrong is said.
printf 'axiom: F\nF --> F[+F]F[-F]F\nangle: 25.7\nsteps: 3\n' > plant.lsys
printf 'axiom: A\nA --> F&[FA]/A\nangle: 30\nsteps: 3\n' > bush.lsys
lsysc plant.lsys && lsysc bush.lsys
for format in svg pdf png ply glb json; do
  ./bush -o bush.$format && ./bush --format $format > stdout.$format && cmp bush.$format stdout.$format
done
./bush -o bush.obj && head -n 2 bush.obj && head -n 1 bush.mtl
ls
head -c 8 bush.pdf; echo
head -c 4 bush.png | tail -c 3 && echo
head -n 2 bush.ply | tail -n 1
head -c 4 bush.glb && echo
./plant -n 1 -o - --format svg --size 100x100 --line-width 2
./plant -n 2 --frames -o film.png && ls film*
./plant -n 2 --svg-animate -o growth.svg && grep -c '<animate' growth.svg
./plant -n 40 --shared -o big.svg && test $(wc -c < big.svg) -lt 40000 && echo "5^40 segments"
./bush -n 30 --shared -o big.glb && head -c 4 big.glb && echo
./bush --shared -o big.svg
./plant --shared -o big.obj
./plant -o plant.svg --size 0x10
./plant -o plant.svg --background purpel
./plant -o plant.svg --camera 30
./plant -o plant.svg --projection flat
./plant -o plant.svg --colour-by height
./plant -o plant.svg --palette red,,blue
./plant -o plant.glb --sides 2
./plant --frames
printf 'axiom: F(1e308)F(1e308)' > far.lsys
lsysc run far.lsys -o far.svg
printf 'axiom: F]F(0/0){f' > odd.lsys
lsysc run odd.lsys -o odd.svg && ls odd.svg

./plant -n 0 --palette red --count --camera 1,2
./plant -n 0 --palette red --count --camera 1,2 --quiet
