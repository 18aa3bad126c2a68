/* The text and its numbers beside the pinned ones. */
import {at, change, made, named, percent, told} from "/static/made.js";
import {Dropped, Problems, ask, sent} from "/static/api.js";
import {on, set, state} from "/static/state.js";
import {twins} from "/static/twins.js";

/* Lines that differ, by the longest common subsequence of both texts. */
export function lines(before, after) {
  const a = before.split("\n"), b = after.split("\n"), longest = Array.from({length: a.length + 1}, () => new Uint32Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; i--) for (let j = b.length - 1; j >= 0; j--)
    longest[i][j] = a[i] === b[j] ? longest[i + 1][j + 1] + 1 : Math.max(longest[i + 1][j], longest[i][j + 1]);
  const found = [];
  for (let i = 0, j = 0; i < a.length || j < b.length;) {
    if (i < a.length && j < b.length && a[i] === b[j]) { found.push([" ", a[i]]); i++; j++; }
    else if (j >= b.length || (i < a.length && longest[i + 1][j] >= longest[i][j + 1])) found.push(["−", a[i++]]);
    else found.push(["+", b[j++]]);
  }
  return found;
}

/* Numbers by name: plain ones, and those of each part. */
function flat(result) {
  const found = new Map();
  for (const [key, value] of Object.entries(result)) if (typeof value === "number") found.set(key, value);
  for (const [key, value] of Object.entries(result.envelope)) found.set(`envelope ${key}`, value);
  for (const [key, value] of Object.entries(result.teeth)) found.set(`teeth ${key}`, value);
  for (const room of ["gears", "shafts", "carriers"]) for (const record of result[room]) for (const key of ["module_mm", "face_width_mm", "diameter_mm", "mass_kg"])
    if (typeof record[key] === "number") found.set(`${record.part || record.name} ${key}`, record[key]);
  for (const row of result.complete_mass.parts) found.set(`complete: ${row.part}, ${row.group}_kg`, row.total_kg);
  for (const row of result.margins) if (typeof row.margin === "number") found.set(`margin ${row.part} ${row.check}`, row.margin);
  return found;
}

function show() {
  const {answer, pinned, view} = state;
  if (view !== "compare-view" || !answer || !pinned) return;
  const rows = lines(pinned.text, answer.text);
  const near = rows.map((_, k) => rows.slice(Math.max(0, k - 2), k + 3).some(([mark]) => mark !== " "));
  const shown = rows.filter((_, k) => near[k]).map(([mark, text]) => made("div", {className: mark === "+" ? "more" : mark === "−" ? "less" : ""}, `${mark} ${text}`));
  at("difference").replaceChildren(...(shown.length ? shown : [made("p", {className: "hint", textContent: "The texts are equal. Change something, or pin another text."})]));
  const then = flat(pinned.answer.result), now = flat(answer.result), body = made("tbody");
  for (const key of new Set([...then.keys(), ...now.keys()])) {
    const share = change(now.get(key), then.get(key));
    if (share === 0 && !["mass_kg", "worst_margin"].includes(key)) continue;
    const [words, unit] = named(key);
    body.append(made("tr", {}, made("th", {scope: "row", textContent: words}), ...[then.get(key), now.get(key)].map(value => made("td", {textContent: value === undefined ? "–" : `${told(key, value)} ${unit}`})), made("td", {textContent: percent(share)})));
  }
  at("beside").replaceChildren(made("table", {}, made("thead", {}, made("tr", {}, ...["", "pinned", "now", "change"].map(text => made("th", {scope: "col", textContent: text})))), body));
}

/* Another design in the place of the pinned one. */
function choices() {
  const group = (label, names, prefix) => made("optgroup", {label}, ...(names || []).map(name => made("option", {value: prefix + name, textContent: name})));
  at("beside-of").replaceChildren(new Option("the pinned text", ""), group("In the folder", state.files, "files/"), group("Shipped", state.designs, "designs/"));
}

async function beside(place) {
  if (!place) return;
  const [room, name] = place.split("/");
  try {
    const {text} = await (await sent(`/api/${room}/${encodeURIComponent(name)}`)).json();
    const answer = await (await ask("size", text, {page: "beside"})).json();
    set({pinned: {text, answer: {...answer, text}, name, own: true}});
    at("beside-told").textContent = `${name} is pinned now`;
  } catch (reason) {
    if (reason instanceof Dropped) return;
    at("beside-told").textContent = reason instanceof Problems ? `${name} cannot be sized: ${reason.message}` : reason.message;
  }
}

on("answer pinned view", show);
on("answer pinned view", () => { if (state.view === "compare-view" && state.answer && state.pinned) twins(state.pinned.text, state.answer.text, state.case); });
on("files designs", choices);
at("beside-of").addEventListener("change", event => beside(event.target.value));
at("pin").addEventListener("click", () => { if (state.answer) set({pinned: {text: state.answer.text, answer: state.answer, own: true}}); at("status").textContent = "pinned: changes are told against this text"; });
