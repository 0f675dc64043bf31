# An environment of one's own: a shared object that a program loads. And what cannot be asked.
cat > count.c <<'FILE'
#include "lsys/environment.h"
static int answer(LsysScene *scene) {
  for (size_t i = 0; i < scene->messages; i++)
    if (scene->message[i].arity) scene->message[i].argument[0] = (double)(scene->lines * 100 + scene->message[i].module);
  return 1;
}
const LsysEnvironment lsys_environment = {LSYS_ENVIRONMENT_VERSION, LSYS_ENVIRONMENT_LINES, answer};
FILE
cc -shared -fPIC -I "$CASES/../../../runtime/include" count.c -o count.so
cat > plant.lsys <<'FILE'
environment: "./count.so"
axiom: F[F]?E(0)
?E(n) --> F?E(n)
steps: 2
FILE
lsysc interp plant.lsys
lsysc run plant.lsys
lsysc plant.lsys -o plant && ./plant
sed s:./count:count: plant.lsys > here.lsys && lsysc run here.lsys
lsysc fmt plant.lsys | head -1
lsysc analyze plant.lsys | head -2
rm count.so
./plant 2>&1 | sed 's/:.*//'
cat > whole.lsys <<'FILE'
axiom: AB?P(0)
homomorphism
A < B --> F
steps: 1
FILE
lsysc run whole.lsys
lsysc interp whole.lsys
