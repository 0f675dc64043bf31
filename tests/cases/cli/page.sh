# size:, background:, camera: and projection: say what the options of these names say, which count first.
printf 'axiom: F[&F]-F\nsize: 300 /* wide */\nbackground: #0d1b2a\ncamera: 30 , -20\nprojection: perspective\nangle: 40\n' > page.lsys
lsysc fmt page.lsys
lsysc page.lsys
lsysc interp page.lsys --format svg > options.svg
lsysc run page.lsys --format svg | cmp - options.svg && ./page --format svg | cmp - options.svg && head -n 2 options.svg
sed '/:.*[a3]/d' page.lsys > plain.lsys
printf 'axiom: F[&F]-F\nangle: 40\n' > plain.lsys
lsysc run plain.lsys --format svg --size 300 --background '#0d1b2a' --camera=30,-20 --projection perspective | cmp - options.svg
./page --format svg --size 100x50 --background transparent --camera 0,0 --projection orthographic | head -n 2
printf 'axiom: F\nF --> FF\nbackground: night\n' > flat.lsys
lsysc run flat.lsys -n 1 --shared --format svg | grep rect
