/* Computations that take long: begun, followed by their events, ended; of one kind and window the newest counts. */
import {Dropped, page, sent} from "/static/api.js";
import {made} from "/static/made.js";

/* Begin one; `told` takes how far it is. The answer arrives as a promise; stop() ends the computation. */
export function begin(verb, text, options = {}, told = () => {}) {
  let name = "", stopped = false;
  const stop = async () => { // its last event says that it has ended
    stopped = true;
    if (name) await sent(`/api/jobs/${name}/stop`, "POST", {});
  };
  const answer = (async () => {
    const begun = await (await sent(`/api/jobs/${verb}`, "POST", {...options, text, page})).json();
    name = begun.job;
    if (stopped) await stop();
    const end = await followed(name, told);
    if (end.replaced) throw new Dropped("");
    if (end.stopped) throw new Dropped(end.stopped);
    return sent(`/api/jobs/${name}/result`);
  })();
  return {answer, stop};
}

/* Events until the end; the browser takes up a line that broke where it was. */
function followed(name, told) {
  return new Promise((done, failed) => {
    const source = new EventSource(`/api/jobs/${name}/events`);
    let misses = 0;
    source.addEventListener("message", event => {
      misses = 0;
      const news = JSON.parse(event.data);
      if ("done" in news) return told(news);
      source.close();
      done(news);
    });
    source.addEventListener("error", () => {
      if (++misses < 3 && source.readyState !== EventSource.CLOSED) return;
      source.close();
      failed(new Error("the server does not answer: start gearwright app again and reload"));
    });
  });
}

/* A line of the page for one kind of computation: a button that begins, one that ends, how far it is, what went wrong. */
export class Task {
  constructor(box, title, start, options = {}) {
    this.start = start;
    this.button = made("button", {type: "button", textContent: title});
    this.end = made("button", {type: "button", textContent: options.end || "Stop", hidden: true});
    this.bar = made("progress", {max: 1, hidden: true, ariaLabel: `${title}: how far`});
    this.words = made("span", {className: "hint"});
    this.words.setAttribute("role", "status");
    this.running = null;
    this.button.addEventListener("click", () => this.go());
    this.end.addEventListener("click", () => this.running?.stop().catch(() => {}));
    box.append(this.button, this.end, this.bar, this.words);
  }

  async go() {
    const job = this.start(news => this.told(news));
    if (!job) return;
    this.running = job;
    this.end.hidden = this.bar.hidden = false;
    this.bar.removeAttribute("value");
    this.words.textContent = "";
    const begun = performance.now();
    try {
      await job.taken(await job.answer);
      if (this.running === job) this.words.textContent = `${((performance.now() - begun) / 1000).toFixed(1)} s`;
    } catch (reason) {
      if (this.running === job) this.failed(reason, job);
    } finally {
      if (this.running === job) {
        this.running = null;
        this.end.hidden = this.bar.hidden = true;
      }
    }
  }

  told(news) {
    this.bar.value = news.done;
    this.words.textContent = news.words || `${Math.round(100 * news.done)} %`;
  }

  failed(reason, job) {
    this.words.textContent = reason.message || "stopped";
    if (job.failed) job.failed(reason);
  }
}

/* Words and columns of numbers out of one answer. */
export async function unpacked(answer) {
  const buffer = await answer.arrayBuffer(), length = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const column = name => {
    const place = head.columns[name];
    return place ? new Float32Array(buffer, 4 + length + 4 * place[0], place[1]) : null;
  };
  return {head, column};
}
