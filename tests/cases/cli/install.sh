# The installed tree works wherever it stands, and C programs link the run time by pkg-config.
build=$(dirname "$(dirname "$(command -v lsysc)")")
cmake --install "$build" --prefix "$PWD/moved" > /dev/null || exit
(cd moved && find . -type f ! -path './include/*' ! -path './lib/cmake/*' ! -name lsysc-llvm.so | sort)
# The code generator is there, too, unless lsysc holds it (LSYSC_STATIC_LLVM).
if [ -e "$build/lib/lsysc/lsysc-llvm.so" ]; then ls moved/lib/lsysc/lsysc-llvm.so > missing 2>&1 || cat missing; fi
PATH=$PWD/moved/bin:$PATH
export PKG_CONFIG_PATH="$PWD/moved/share/pkgconfig"
printf 'axiom: A\nA --> AB\nB --> A\nsteps: 5\n' > algae.lsys
lsysc algae.lsys && ./algae
lsysc -c algae.lsys
cat > main.c <<'C'
#include <lsys/abi.h>
extern const LsysGrammar lsys_grammar;
int main(void) {
  char *arguments[] = {"mine", "-n", "2", NULL};
  return lsys_main(&lsys_grammar, 3, arguments);
}
C
if command -v pkg-config > /dev/null; then
  flags=$(pkg-config --cflags --libs lsysrt)
else
  flags="-Imoved/include -Lmoved/lib/lsysc -llsysrt -lm -lpthread"
fi
cc main.c algae.o $flags -o mine && ./mine
