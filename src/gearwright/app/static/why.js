/* The selected part: its numbers, the equation and source of each, its checks, and what would move its margins. */
import {ask, Dropped, Problems} from "/static/api.js";
import {at, made, named, number, percent, ratio} from "/static/made.js";
import {on, state} from "/static/state.js";

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
    if (own || meshes) found.push([record, kind]);
  }
  return found;
}

function table(record, kind, definitions) {
  const body = made("tbody"), properties = definitions[kind]?.properties || {};
  for (const [key, value] of Object.entries(record)) {
    if (typeof value !== "number") continue;
    const [words, unit] = named(key), meant = properties[key] || {};
    const from = [meant.description, meant.equation, meant.source].filter(Boolean);
    const cell = made("td", {}, made("details", {}, made("summary", {}, `${number(value)} ${unit}`), ...from.map((text, k) => made("p", {className: k ? "formula" : "", textContent: text}))));
    body.append(made("tr", {}, made("th", {scope: "row", textContent: words}), cell));
  }
  return made("table", {}, made("caption", {textContent: record.name || record.part}), body);
}

function handles(influences) {
  const meshes = influences.filter(mesh => mesh.mesh === state.selected || records().some(([record]) => record.name === mesh.mesh));
  return meshes.flatMap(mesh => [
    made("h3", {textContent: `What would change ${mesh.mesh}`}),
    made("table", {}, made("caption", {textContent: "Change of the safeties for 1 % more of each"}), made("thead", {}, made("tr", {}, ...["value", "flanks", "roots", "for a margin of 1"].map(text => made("th", {scope: "col", textContent: text})))),
      made("tbody", {}, ...mesh.handles.map(one => made("tr", {},
        made("th", {scope: "row", textContent: `${one.handle} ${number(one.value)} ${one.unit}`}),
        ...[one.flank, one.root].map(share => made("td", {textContent: share === null ? "–" : percent(share / 100)})),
        made("td", {textContent: one.wanted === null ? "–" : `${number(one.wanted)} ${one.unit}`}))))),
  ]);
}

async function show() {
  const box = at("why"), part = state.selected;
  if (!part || !state.answer) {
    box.replaceChildren(made("p", {className: "hint", textContent: "Select a part: its numbers, where they come from and what would change them."}));
    return;
  }
  try {
    const definitions = await meanings();
    if (part !== state.selected) return;
    const checks = state.answer.result.margins.filter(row => row.part === part);
    const judged = checks.map(row => made("li", {textContent: `${row.check}: ${number(row.value)} ${row.unit}, limit ${number(row.limit)} ${row.unit}, margin ${ratio(row.margin)} (${row.source})`}));
    const open = new Set([...box.querySelectorAll("details[open]")].map(one => one.closest("tr").firstChild.textContent));
    box.replaceChildren(made("h3", {textContent: part}), made("ul", {}, ...judged), ...records().map(([record, kind]) => table(record, kind, definitions)));
    for (const one of box.querySelectorAll("details")) one.open = open.has(one.closest("tr").firstChild.textContent);
    const text = state.answer.text;
    clearTimeout(timer);
    timer = setTimeout(() => moved(part, text), PAUSE);
  } catch (reason) {
    if (!(reason instanceof Dropped || reason instanceof Problems)) at("status").textContent = reason.message;
  }
}

async function moved(part, text) {
  try {
    const {influences} = await (await ask("influences", text)).json();
    if (part === state.selected && text === state.answer.text) at("why").append(...handles(influences));
  } catch (reason) {
    if (!(reason instanceof Dropped || reason instanceof Problems)) at("status").textContent = reason.message;
  }
}

on("selected answer", show);
