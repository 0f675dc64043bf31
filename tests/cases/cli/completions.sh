# The shells complete commands, topics, options of lsysc and of the program, their values, params and grammars.
printf 'param wind = 3\naxiom: F\nsteps: 0\n' > plant.lsys
mkdir other && touch notes.txt
lsysc help bash > completions
bash -s << 'END'
. ./completions
compopt() { :; }
try() {
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
  _lsysc
  echo "$* => ${COMPREPLY[*]}"
}
try lsysc ''
try lsysc help tu
try lsysc run ''
try lsysc run p
try lsysc check --d
try lsysc run plant.lsys --ca
try lsysc run plant.lsys --format p
try lsysc run plant.lsys --projection ''
try lsysc run plant.lsys -D ''
try lsysc run plant.lsys -o n
try lsysc --emit = ''
try lsysc -O
try lsysc -Wun
END
lsysc help zsh > completions.zsh
lsysc help fish > completions.fish
if command -v zsh > /dev/null; then zsh -n completions.zsh; fi
if command -v fish > /dev/null; then fish -n completions.fish; fi
