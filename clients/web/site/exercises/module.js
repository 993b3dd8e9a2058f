// How the module of the laws gets its numbers: no JSON, for which it would be a tenth larger.

const MODELS = ["lambert", "phong", "blinn_phong"];
const KINDS = ["directional", "point", "spot"];
const bits = (all, chosen = []) => chosen.reduce((sum, name) => sum + 2 ** all.indexOf(name), 0);

/** Writes numbers into the module's memory. */
export function write(exports, numbers) {
  const at = exports.numbers(numbers.length); // the memory may grow there
  new Float64Array(exports.memory.buffer, at, numbers.length).set(numbers);
}

/** A scene as `picture::scene` takes it; a ball has the points. */
export function numbersOf({ model, m, k_a, k_d, k_s, i_a, lights }) {
  const none = [0, 0, 0];
  const triples = lights.map(({ kind, intensity, l, position, attenuation = none, axis = none, angle = 0 }) =>
    [intensity, l ?? position, attenuation, axis, [KINDS.indexOf(kind), angle, 0]]);
  return [MODELS.indexOf(model), m, k_a, k_d, k_s, i_a, triples].flat(Infinity);
}

/** A profile as `check` takes it: the models, the kinds of light, and whether a highlight may be behind the surface. */
export const profileOf = ({ models, lights, departs }) => [bits(MODELS, models), bits(KINDS, lights), departs ? 1 : 0];
