/* Entries of the form that are changed: each change is a change of the text, at the line of its key. */
import {Dropped, Problems, ask} from "/static/api.js";
import {replace} from "/static/editor.js";
import {gestureOf} from "/static/gestures.js";
import {at} from "/static/made.js";
import {state} from "/static/state.js";

let busy = false;
const waiting = new Map();

export const idOf = (path, key) => [...path, key].join("/");

/* Changes wait while one is on its way; of each entry the last value is taken. One that was made of an older text is made anew. */
export async function change(path, key, options, gesture = gestureOf(idOf(path, key))) {
  waiting.set(idOf(path, key), {asked: {path: [...path, key], ...options}, gesture, name: state.name});
  if (busy) return;
  busy = true;
  try {
    while (waiting.size) {
      const [id, {asked, gesture, name}] = waiting.entries().next().value, old = state.text;
      waiting.delete(id);
      if (name !== state.name) continue;
      const {text} = await (await ask("edit", old, asked)).json();
      if (old === state.text && name === state.name) enter(text, gesture);
      else if (!waiting.has(id)) waiting.set(id, {asked, gesture, name});
    }
  } catch (reason) {
    if (reason instanceof Problems) at("help").textContent = reason.message;
    else if (!(reason instanceof Dropped)) at("status").textContent = reason.message;
  } finally {
    busy = false;
  }
}

function enter(text, gesture) {
  state.entered = true;
  replace(text, gesture);
  state.entered = false;
}
