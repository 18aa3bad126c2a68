/* What the page knows, in one object; whoever shows a part of it is told when that part changes. */
const told = new Map();

export const state = {
  name: "", shipped: true, tag: "", saved: "",
  text: "", problems: [], stale: false,
  files: null, designs: null, missions: null, studies: null, journals: null,
  answer: null, form: [], pinned: null,
  case: "", selected: "", asked: "", view: "design-view",
  review: null, // of a text: every check
  run: null, shaken: null, // a simulated run; what the solids show beside their steady turning
  entered: false, // true while the form changes the text: such a change is whole and waits for nothing
};

export function on(keys, listener) {
  for (const key of keys.split(" ")) told.set(key, [...(told.get(key) || []), listener]);
}

export function set(changes) {
  const due = new Set();
  for (const [key, value] of Object.entries(changes)) {
    if (state[key] === value) continue;
    state[key] = value;
    for (const listener of told.get(key) || []) due.add(listener);
  }
  for (const listener of due) listener();
}
