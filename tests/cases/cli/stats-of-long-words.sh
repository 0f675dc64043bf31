# Figures of words that nobody could walk through: sizes by composing parts, pictures as shared parts.
printf 'axiom: L\nL --> +RF-LFL-FR+\nR --> -LF+RFR+FL-\n' > hilbert.lsys
printf 'axiom: F, F&F\nF --> F[+F]F[-F]F\nangle: 30\n' > plant.lsys
lsysc hilbert.lsys && lsysc plant.lsys
./hilbert -n 40 --stats
./plant -n 30 --stats --axiom 1 | grep -E 'segments|high'
./plant -n 30 --stats | grep -E 'axiom|segments|length|low|end'
./hilbert -n 40 -o hilbert.svg && test $(wc -c < hilbert.svg) -lt 40000 && grep -c '<use' hilbert.svg
printf 'axiom: F(1)\nF(x) --> F(x)F(x+1)\n' > arguments.lsys
lsysc arguments.lsys && ./arguments -n 90 -o arguments.svg
