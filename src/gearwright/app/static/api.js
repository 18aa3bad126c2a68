/* Questions to the server. Of each kind only the newest counts: an older one is dropped as a newer is asked. */
export const page = crypto.randomUUID();
const running = new Map();

export class Problems extends Error {
  constructor(problems) {
    super(problems.map(problem => problem.message).join("; "));
    this.problems = problems;
  }
}
export class Dropped extends Error {}

export async function ask(verb, text, options = {}) {
  const kind = `${options.page || ""} ${verb}`;
  running.get(kind)?.abort();
  const stopper = new AbortController();
  running.set(kind, stopper);
  try {
    return await sent(`/api/${verb}`, "POST", {page, ...options, text}, {}, stopper.signal);
  } catch (reason) {
    throw reason.name === "AbortError" ? new Dropped() : reason;
  } finally {
    if (running.get(kind) === stopper) running.delete(kind);
  }
}

export async function sent(path, method = "GET", body = undefined, headers = {}, signal = undefined) {
  const asked = {method, signal, headers: body === undefined ? headers : {"content-type": "application/json", ...headers}};
  if (body !== undefined) asked.body = JSON.stringify(body);
  let answer;
  try {
    answer = await fetch(path, asked);
  } catch (reason) {
    if (reason.name === "AbortError") throw reason;
    throw new Error("the server does not answer: start gearwright app again and reload");
  }
  if (answer.status === 422) throw new Problems((await answer.json()).problems);
  if (answer.status === 401) throw new Error("the server was started anew: open the address that it printed");
  if (answer.status === 409) throw new Dropped((await answer.json()).error);
  if (!answer.ok) throw Object.assign(new Error((await answer.json()).error), {status: answer.status});
  return answer;
}
