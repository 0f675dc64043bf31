# Random grammars through all engines (tests/README.md); shows one on which they differ.
build=$(dirname "$(dirname "$(command -v lsysc)")")
module=$build/lib/lsysc/lsysc-llvm.so
if [ -e "$module" ]; then set -- --backend "$module"; else set --; fi  # a compiler that holds LLVM has none to lend
if "$build/tests/grammar_fuzz" --first 501 --count 250 --jobs 1 "$@" --lsysc "$build/bin/lsysc" 2> differ; then
  echo agree
else
  cat differ
fi | grep -v '^grammars'
