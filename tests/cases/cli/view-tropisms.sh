# Tropisms and torques of a view file are numbered as they stand, and what is wrong with them.
cat > plant.v <<'FILE'
tropism direction: 1,0,0
tropism: T: 3 0 0 I: 0.5 E: 1 S: 0.1
torque: T: -1 0 0 E: 0.5
tropism: T: 0 1 0 A: 90 E: 0
FILE
printf 'Lsystem: 1\nderivation length: 1\nAxiom: F@Ts(1,0)@Td(2,0.5)/@Tp+F@Tx(1)@Tf\nA-->B\nendlsystem\n' > plant.l
lsysc run -w plant.l --view plant.v --stats | grep -e end
lsysc fmt -w plant.l --view plant.v > native.lsys && grep tropism native.lsys
lsysc run -w native.lsys --stats | grep -e end
cat > wrong.v <<'FILE'
tropism: E: 1
tropism: I: 2 T: 1 2 3
torque: T: 1 2 3 B: 2
torque: T: 1 2 3 E:
tropism: T: 1 2 3
tropism: T: 1 2 3
tropism: T: 1 2 3
tropism: T: 1 2 3
torque: T: 1 2 3
FILE
lsysc check -w --view wrong.v plant.l
