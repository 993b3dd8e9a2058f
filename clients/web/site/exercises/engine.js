// The laws and the crate, as the page itself asks them: for the list of mistakes, and for what these draw.
import { numbersOf, write } from "./module.js";
import { CANDIDATES, planted } from "./renderer.js";

const SIZE = 20; // enough to see which pictures differ
export class Engine {
  constructor(module) {
    const page = { shade_all: () => 1, goes_on() {} }; // a run of the laws is the worker's
    this.exports = new WebAssembly.Instance(module, { page }).exports;
  }

  /** The names of the mistakes and their words, as the laws' table has them. */
  mistakes() {
    this.exports.mistakes();
    const { memory, text, text_length } = this.exports;
    const list = new TextDecoder().decode(new Uint8Array(memory.buffer, text(), text_length()));
    return list.trim().split("\n").map((line, number) => {
      const [id, says] = line.split("\t");
      return { number, id, says: says.replace("the profile says", "it should be") }; // a profile is unknown to students
    });
  }

  /** The right colors of a small picture, or those that a mistake gives. */
  colors(scene, mistake = null) {
    const { memory, draw } = this.exports;
    write(this.exports, numbersOf(scene));
    const from = draw(SIZE, mistake?.number ?? 1e6);
    const numbers = new Float64Array(memory.buffer, from, 15 * SIZE * SIZE);
    const first = mistake ? 12 : 9;
    return Array.from({ length: 3 * SIZE * SIZE }, (_, i) => numbers[15 * Math.floor(i / 3) + first + (i % 3)]);
  }

  /** How much two pictures differ to the eye. */
  static distance(a, b) {
    const level = (x) => Math.min(1, Math.max(0, x || 0)) ** (1 / 2.2);
    return a.reduce((sum, x, i) => sum + Math.abs(level(x) - level(b[i])), 0) / a.length;
  }

  /** The scene in which a mistake is seen best, and how well. */
  best_scene(mistake) {
    const scored = CANDIDATES.map((scene) => {
      return { scene, seen: Engine.distance(this.colors(scene), this.colors(scene, mistake)) };
    });
    return scored.reduce((best, it) => (it.seen > 1.3 * best.seen ? it : best));
  }

  /** Three other mistakes, whose pictures are not the same: those that look most alike. */
  others(mistake, all, scene) {
    const [mine, right] = [this.colors(scene, mistake), this.colors(scene)];
    const scored = all.filter(({ id }) => id !== mistake.id).map((it) => {
      const colors = this.colors(scene, it);
      return { it, apart: Engine.distance(mine, colors), seen: Engine.distance(right, colors) };
    });
    // one that draws the right picture would be too easy to rule out
    const unlike = scored.filter(({ apart, seen }) => apart > 1e-3 && seen > 1e-3);
    unlike.sort((a, b) => a.apart - b.apart);
    return [0, 2, 4].map((i) => unlike[i]?.it).filter(Boolean);
  }

  /** Whether there is something to see or to mend. */
  is_exercise(mistake) {
    return planted(mistake.id) !== undefined || this.best_scene(mistake).seen > 1e-3;
  }
}
