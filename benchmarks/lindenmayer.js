// lindenmayer.js -- the npm package of this name at work: name of a row, steps, repetitions;
// prints modules and the seconds of the fastest repetition. Status 3: the package is not installed.
'use strict';
const systems = {
  koch: {axiom: 'F-F-F-F', productions: {F: 'F-F+F+FF-F-F+F'}},
  plant: {axiom: 'X', productions: {X: 'F[+X][-X]FX', F: 'FF'}},
};
let LSystem;
try {
  LSystem = require('lindenmayer');
} catch (error) {
  process.exit(3);
}
const [row, steps, repetitions] = process.argv.slice(2);
let best = Infinity, modules = 0;
for (let i = 0; i < Number(repetitions); i++) {
  const system = new LSystem(systems[row]);
  const begin = process.hrtime.bigint();
  modules = system.iterate(Number(steps)).length;
  best = Math.min(best, Number(process.hrtime.bigint() - begin) / 1e9);
}
console.log(modules, best);
