# What symbols without an argument add: to the line width, the colour, the elasticity.
cat > plant.l <<'END'
Lsystem: 1
derivation length: 0
Axiom: F#F;F!!!F,F[-(90)_F_F]_(0.5)-(90)F
endlsystem
END
cat > plant.v <<'END'
color increment: 10
line width increment: 1.5
initial line width: 2
elasticity increment: 0.25
tropism direction: 0,-2,0
END
lsysc fmt -w --view plant.v plant.l
lsysc run -w --view plant.v plant.l -o plant.svg
grep -o 'stroke-width="[^"]*"' plant.svg
lsysc run -w --view plant.v plant.l --stats | grep -e colour -e end
lsysc run -w plant.l -o plant.svg
grep -o 'stroke-width="[^"]*"' plant.svg
