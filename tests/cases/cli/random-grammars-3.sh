# Random grammars through all engines (tests/README.md); shows one on which they differ.
build=$(dirname "$(dirname "$(command -v lsysc)")")
if "$build/tests/grammar_fuzz" --first 501 --count 250 --jobs 1 --backend "$build/lib/lsysc/lsysc-llvm.so" \
  --lsysc "$build/bin/lsysc" 2> differ; then echo agree; else cat differ; fi | grep -v '^grammars'
