// Runs the student's code in a worker of its own, without a network, and ends it in time.

const LIMIT = 2000; // ms that the student's code may take before it answers a batch of scenes
const LONGEST = 8000; // ms that it may take in all; the laws take as long as they need
const LATE = "Your code did not finish in time. Is there a loop that never ends?";

export class Runner {
  /** From the module of the laws and the text of worker.js. */
  constructor(module, text) {
    Object.assign(this, { module, text, worker: null, asked: 0 });
  }

  /** Runs the code, after ending what ran before. `heard` gets the answer, and `progress` how far it is. */
  run(code, task, { heard, progress = () => {} }) {
    this.worker?.terminate();
    const id = ++this.asked;
    const blob = (...text) => URL.createObjectURL(new Blob(text, { type: "text/javascript" }));
    const theirs = blob(code); // a script of its own, so that its lines are those of the editor
    const all = blob("\"use strict\";((student) => {", this.text, `})(() => ${task.exercise.name});`);
    const worker = new Worker(all);
    const { port1: port, port2 } = new MessageChannel();
    this.worker = worker;
    let [timer, isOver] = [0, false];
    const over = (answer) => {
      if (isOver) return;
      isOver = true;
      clearTimeout(timer);
      worker.terminate();
      port.close();
      [theirs, all].forEach((it) => URL.revokeObjectURL(it));
      if (id === this.asked) heard(answer);
    };
    let [left, since] = [LONGEST, null];
    const busy = (isBusy) => {
      clearTimeout(timer);
      if (since !== null) left -= performance.now() - since;
      since = isBusy ? performance.now() : null;
      if (isBusy) timer = setTimeout(() => over({ problem: { text: LATE } }), Math.max(0, Math.min(LIMIT, left)));
    };
    worker.onerror = (event) => {
      event.preventDefault();
      const text = (event.message ?? "It cannot be read.").replace(/^Uncaught |Failed to execute .*?: /g, "");
      over({ problem: { text, line: event.filename === theirs ? event.lineno : null } });
    };
    port.onmessage = ({ data }) => {
      if (isOver) return;
      if (data.report || data.pictures) return over(data);
      if (data.busy === undefined) progress(data);
      else busy(data.busy);
    };
    worker.postMessage({ module: this.module, code: theirs, ...task }, [port2]);
  }
}
