/* Why a number is what it is: its meaning, equation and source, what it is made of, what limits it, what would change it. */
import {ask, Dropped, Problems} from "/static/api.js";
import {at, made, named, number, ratio} from "/static/made.js";
import {factors, handles} from "/static/ratings.js";
import {moved} from "/static/moves.js";
import {on, set, state} from "/static/state.js";

const ROOMS = {
  gears: "GearSizing", meshes: "MeshSizing", shafts: "ShaftSizing", carriers: "CarrierSizing", bearings: "BearingSizing", machines: "MachineSizing", joints: "JointSizing",
};
const PAUSE = 600; // after the last change, as what moves margins takes seconds where gears are rated by standards [ms]
let meaning = null, timer = 0;

async function meanings() {
  if (!meaning) meaning = (await (await ask("meaning", "")).json());
  return meaning;
}

function records() {
  const found = [], result = state.answer.result;
  for (const [room, kind] of Object.entries(ROOMS)) for (const record of result[room]) {
    const own = [record.part, record.name].includes(state.selected), meshes = room === "meshes" && record.gears.includes(state.selected);
    if (own || meshes) found.push([room, record, kind]);
  }
  return found;
}

const label = record => record.name || record.part || (record.row ? `${record.stage}.${record.row}` : `${record.stage}.${record.role || "carrier"}`);

function table(room, record, kind, definitions) {
  const body = made("tbody"), properties = definitions[kind]?.properties || {};
  for (const [key, value] of Object.entries(record)) {
    if (typeof value !== "number") continue;
    const [words, unit] = named(key), told = made("div");
    const details = made("details", {}, made("summary", {}, `${number(value)} ${unit}`), ...meant(properties[key]), told);
    details.dataset.key = `${room}.${room === "carriers" ? record.stage : label(record)}.${key}`;
    details.addEventListener("toggle", () => { if (details.open && !told.childElementCount) moved(details.dataset.key, told); });
    body.append(made("tr", {}, made("th", {scope: "row", textContent: words}), made("td", {}, details)));
  }
  return made("table", {}, made("caption", {textContent: `${label(record)}: open a number for its source and what would change it`}), body);
}

function meant(one = {}) {
  const {description, equation, source} = one;
  return [[description, ""], [equation, "formula"], [source && `Source: ${source}`, "hint"]].filter(([text]) => text).map(([textContent, className]) => made("p", {className, textContent}));
}

/* What a check found beside its limit; a frequency that has to stay away, and what counts in whole pieces, has no margin. */
const judged = row => (row.value === null ? "not assessed" : `${number(row.value)} ${row.unit}, ${row.margin !== null ? "limit" : row.at_most ? "at most" : "at least"} ${number(row.limit)} ${row.unit}${row.margin === null ? `: ${row.status}` : `, margin ${ratio(row.margin)}`}`);

/* A part of the gearbox: its checks, its numbers, its rating. */
async function part(box) {
  const selected = state.selected, definitions = await meanings();
  if (selected !== state.selected || state.asked) return;
  const checks = (state.review?.text === state.answer.text ? state.review.checks : state.answer.result.margins).filter(row => row.part === selected);
  const list = checks.map((row, k) => made("li", {textContent: `${k ? "" : "Limits it most: "}${row.check}${row.case ? `, ${row.case}` : ""}: ${judged(row)}${row.source ? ` (${row.source})` : ""}${row.why ? `; ${row.why}` : ""}`}));
  const open = new Set([...box.querySelectorAll("details[open]")].map(one => one.dataset.key));
  box.replaceChildren(made("h3", {textContent: selected}), made("ul", {}, ...list), ...records().map(([room, record, kind]) => table(room, record, kind, definitions)));
  for (const one of box.querySelectorAll("details")) one.open = open.has(one.dataset.key);
  const text = state.answer.text;
  clearTimeout(timer);
  timer = setTimeout(() => rated(selected, text), PAUSE);
}

/* A number of the whole design: what it is made of, and what limits the design. */
async function whole(box) {
  const key = state.asked, definitions = await meanings(), {result} = state.answer;
  if (key !== state.asked) return;
  const [plain, unit] = named(key.split(".").at(-1)), words = key === "worst_margin" ? "worst margin of sizing" : plain, value = key.split(".").reduce((from, name) => from?.[name], result);
  const one = key.startsWith("envelope.") ? definitions.Envelope?.properties?.[key.slice(9)] : definitions.SizeAnswer?.properties?.[key];
  const back = made("button", {type: "button", textContent: "Close"});
  back.addEventListener("click", () => set({asked: ""}));
  box.replaceChildren(made("h3", {}, `Why ${words} ${key === "worst_margin" ? ratio(value) : number(value)} ${unit}? `, back), ...meant(one), moved(key.replace("complete_total", "complete_mass")), limit(result), ...made_of(key, result));
}

function made_of(key, result) {
  const complete = key.startsWith("complete"), parts = complete ? result.complete_mass.parts : /mass|density/.test(key) ? result.masses : [];
  if (!parts.length) return [];
  const rows = [...parts].sort((a, b) => b.total_kg - a.total_kg).slice(0, 8), total = parts.reduce((sum, row) => sum + row.total_kg, 0);
  return [made("table", {}, made("caption", {textContent: `Made of ${parts.length} entries, the heaviest first`}), made("tbody", {}, ...rows.map(row => made("tr", {},
    made("th", {scope: "row"}, picked(row.part), ` ${row.group === "gears" || row.group === "shafts" ? "" : row.group}`, ...(row.formula ? [made("details", {}, made("summary", {className: "formula", textContent: row.formula}), made("p", {className: "hint", textContent: row.source}))] : [])),
    made("td", {textContent: `${row.count > 1 ? `${row.count} × ` : ""}${number(row.each_kg)} kg`}), made("td", {textContent: `${(100 * row.total_kg / total).toFixed(1)} %`})))))];
}

function picked(name) {
  const button = made("button", {type: "button", className: "why-button", textContent: name});
  button.addEventListener("click", () => set({selected: name, asked: ""}));
  return button;
}

function limit(result) {
  const row = (state.review?.text === state.answer.text ? state.review.checks : result.margins).find(one => one.margin !== null && one.margin !== undefined);
  if (!row) return made("p", {textContent: "Nothing limits it: no check is assessed."});
  return made("p", {}, "What limits the design: ", picked(row.part), ` ${row.check}, ${number(row.value)} ${row.unit} of ${number(row.limit)} ${row.unit}, margin ${ratio(row.margin)} (${row.source}).`);
}

async function show() {
  const box = at("why");
  if (!state.answer || (!state.selected && !state.asked)) {
    box.replaceChildren(made("p", {className: "hint", textContent: "Select a part, or a number above: where it comes from, what limits it and what would change it."}));
    return;
  }
  try {
    await (state.asked ? whole(box) : part(box));
  } catch (reason) {
    if (!(reason instanceof Dropped || reason instanceof Problems)) at("status").textContent = reason.message;
  }
}

/* What only a rating knows: every factor with its clause, and what 1 % of each value does to the safeties. */
async function rated(selected, text) {
  try {
    const told = await (await ask("influences", text)).json();
    if (selected !== state.selected || text !== state.answer.text || state.asked) return;
    const mine = name => name === selected || records().some(([, record]) => [record.name, `${record.stage}.${record.row}`].includes(name));
    at("why").append(...told.influences.filter(one => mine(one.mesh)).flatMap(handles), ...told.factors.filter(one => mine(one.mesh)).map(factors));
  } catch (reason) {
    if (!(reason instanceof Dropped || reason instanceof Problems)) at("status").textContent = reason.message;
  }
}

on("selected", () => { if (state.selected && state.asked) set({asked: ""}); });
on("selected asked", () => { at("why").scrollTop = 0; });
on("selected answer asked review", show);
