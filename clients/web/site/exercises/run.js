// Runs the student's code in a worker of its own, without a network, and ends it in time.

const LIMIT = 2000; // ms that the student's code may take before it answers a batch of scenes
const LONGEST = 8000; // ms that it may take in all; the laws take as long as they need
const SILENT = 10000; // ms that the laws may take between two batches
const LATE = "Your code did not finish in time. Is there a loop that never ends?";
const LOST = "Your code ended the worker in which it ran. Does it call close?";

export class Runner {
  /** From the module of the laws and the text of worker.js; `warm` hears whether a worker is ready. */
  constructor(module, text, warm) {
    Object.assign(this, { module, text, warm, worker: null, spare: null, asked: 0 });
  }

  /** A worker that finds the student's function by this name. The laws run in it before, if it shall be warm. */
  start(name, isWarm) {
    const text = ["\"use strict\";((student) => {", this.text, `})(() => ${name});`];
    const url = URL.createObjectURL(new Blob(text, { type: "text/javascript" }));
    const worker = new Worker(url);
    worker.onmessage = () => {
      worker.onmessage = null; // what the student's code posts is not heard
      URL.revokeObjectURL(url);
      if (this.spare?.worker === worker) this.warm(true);
    };
    worker.postMessage({ module: this.module, isWarm });
    return worker;
  }

  /** The worker that waits for code of this name. It is started before the click, since its start would be felt after it. */
  taken(name) {
    const { spare } = this;
    this.spare = null;
    this.warm(false);
    if (spare?.name === name) return spare.worker;
    spare?.worker.terminate();
    return this.start(name, false);
  }

  /** Runs the code, after ending what ran before. `heard` gets the answer, and `progress` how far it is. */
  run(code, task, { heard, progress = () => {} }) {
    this.worker?.terminate();
    const id = ++this.asked;
    const { name } = task.exercise;
    const worker = this.taken(name);
    // a script of its own, so that its lines are those of the editor
    const theirs = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
    const { port1: port, port2 } = new MessageChannel();
    this.worker = worker;
    let [timer, isOver] = [0, false];
    const over = (answer) => {
      if (isOver) return;
      isOver = true;
      clearTimeout(timer);
      worker.terminate();
      port.close();
      URL.revokeObjectURL(theirs);
      if (id !== this.asked) return;
      heard(answer);
      this.spare = { name, worker: this.start(name, true) };
    };
    let [left, since] = [LONGEST, null];
    const busy = (isBusy) => {
      clearTimeout(timer);
      if (since !== null) left -= performance.now() - since;
      since = isBusy ? performance.now() : null;
      timer = isBusy ? setTimeout(() => over({ problem: { text: LATE } }), Math.max(0, Math.min(LIMIT, left)))
        : setTimeout(() => over({ problem: { text: LOST } }), SILENT);
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
    busy(false);
    worker.postMessage({ code: theirs, ...task }, [port2]);
  }
}
