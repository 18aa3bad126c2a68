/* The form: the same text, table by table. A change here is a change of the text, at the line of its key. */
import {change, idOf} from "/static/edits.js";
import {goTo} from "/static/editor.js";
import {at, made, number} from "/static/made.js";
import {on, state} from "/static/state.js";

let shape = "";
const inputs = new Map();

const isNumeric = field => field.kind === "number" || field.kind === "integer";

function valueOf(field, text) {
  if (text.trim() === "") return null;
  return isNumeric(field) ? Number(text.replace(",", ".")) : text;
}

/* A number that is being typed: what is none, or not yet, is marked and stays out of the text. */
function typed(group, id) {
  const {input, field} = inputs.get(id), value = valueOf(field, input.value), wrong = value !== null && !Number.isFinite(value);
  const empty = value === null && field.value !== null;
  input.classList.toggle("empty", empty);
  input.setAttribute("aria-invalid", String(wrong));
  if (wrong) at("help").textContent = `${[...group.path, field.key].join(".")}: ${input.value} is no number that can be computed with; the text keeps ${field.value ?? "it left out"}`;
  else if (empty) at("help").textContent = `${[...group.path, field.key].join(".")}: empty; it is left out of the text when you leave it`;
  else if (value !== null) change(group.path, field.key, {value});
}

/* Whoever leaves an empty number leaves it out; one that is wrong becomes again what the text says. */
function left(group, id) {
  if (!inputs.has(id)) return; // it is made anew
  const {input, field} = inputs.get(id), value = valueOf(field, input.value);
  if (value === null && field.value !== null) change(group.path, field.key, {value}, {});
  else if (value !== null && !Number.isFinite(value)) input.value = field.value ?? "";
  input.classList.remove("empty");
  input.setAttribute("aria-invalid", "false");
}

function tell(group, field) {
  const bounds = [field.least === null ? "" : `at least ${number(field.least)}`, field.most === null ? "" : `at most ${number(field.most)}`];
  const parts = [field.help, bounds.filter(Boolean).join(", "), field.default === null ? "" : `left out: ${field.default}`];
  at("help").textContent = `${[...group.path, field.key].join(".")}: ${parts.filter(Boolean).join("; ")}`;
  const drawn = at("drawn");
  drawn.hidden = !field.diagram;
  if (field.diagram) Object.assign(drawn, {src: `/diagrams/${field.diagram}`, alt: `What ${field.key} is measured from`});
}

function entry(group, field) {
  const id = idOf(group.path, field.key), numeric = isNumeric(field);
  const label = made("label", {textContent: field.name, title: field.help});
  const asked = text => {
    const value = valueOf(field, text);
    if (value !== null || field.value !== null) change(group.path, field.key, {value});
  };
  let input;
  if (field.choices.length) {
    input = made("select", {}, made("option", {value: "", textContent: field.default === null ? "–" : `(${field.default})`}), ...field.choices.map(choice => made("option", {value: choice, textContent: choice})));
    input.addEventListener("change", () => asked(input.value));
  } else if (field.kind === "boolean") {
    input = made("input", {type: "checkbox"});
    input.addEventListener("change", () => change(group.path, field.key, {value: input.checked}));
  } else if (field.kind === "other") {
    input = made("button", {type: "button", textContent: "in the text"});
    input.addEventListener("click", () => goTo(field.line || group.line || 1));
  } else {
    input = made("input", {type: "text", inputMode: numeric ? "decimal" : "text", autocomplete: "off", spellcheck: false});
    if (field.default !== null) input.placeholder = String(field.default);
    if (numeric) {
      input.addEventListener("input", () => typed(group, id));
      input.addEventListener("blur", () => left(group, id));
      input.addEventListener("keydown", event => (event.key === "Enter" ? left(group, id) : nudge(event, group, id)));
    } else input.addEventListener("change", () => asked(input.value));
  }
  input.id = `entry:${id}`;
  label.htmlFor = input.id;
  input.addEventListener("focus", () => tell(group, field));
  const row = made("div", {className: numeric ? "entry" : "entry words"}, label, input);
  if (numeric) row.append(unit(group, field));
  const slider = numeric && field.value !== null && field.key !== "schema" ? made("input", {type: "range", step: "any"}) : made("span");
  if (slider.type === "range") {
    slider.setAttribute("aria-label", `${group.path.join(" ")} ${field.name}`);
    slider.addEventListener("input", () => {
      const value = field.kind === "integer" ? Math.round(slider.value) : Number(Number(slider.value).toPrecision(4));
      input.value = value;
      typed(group, id);
    });
    slider.addEventListener("change", () => range(slider, inputs.get(id).field));
    slider.addEventListener("focus", () => tell(group, field));
  }
  row.append(slider);
  inputs.set(id, {input, slider, field});
  return row;
}

/* Up and down change a number by a hundredth, with Shift by a tenth, as wheels of instruments do. */
function nudge(event, group, id) {
  const {input, field} = inputs.get(id), way = {ArrowUp: 1, ArrowDown: -1}[event.key], value = valueOf(field, input.value);
  if (!way || value === null || !Number.isFinite(value)) return;
  event.preventDefault();
  const step = field.kind === "integer" ? 1 : Math.abs(value) * (event.shiftKey ? 0.1 : 0.01) || 0.01;
  input.value = Number((value + way * step).toPrecision(6));
  typed(group, id);
}

function unit(group, field) {
  if (field.units.length < 2 || field.value === null) return made("span", {className: "unit", textContent: field.unit});
  const select = made("select", {className: "unit", title: "Write it in another unit"}, ...field.units.map(key => made("option", {value: key, textContent: key === field.key ? field.unit : key.slice(field.key.length - ending(field).length)})));
  select.setAttribute("aria-label", `Unit of ${group.path.join(" ")} ${field.name}`);
  select.value = field.key;
  select.addEventListener("change", () => change(group.path, field.key, {key: select.value}));
  return select;
}

/* What of a key is its unit: behind what all keys of the quantity share. */
function ending(field) {
  let shared = 0;
  while (field.units.every(key => key[shared] !== undefined && key[shared] === field.units[0][shared])) shared++;
  return field.key.slice(field.key.lastIndexOf("_", shared) + 1);
}

function range(slider, field) {
  const value = field.value, whole = field.kind === "integer";
  const low = value > 0 ? value / 2 : value < 0 ? value * 2 : -1, high = value > 0 ? value * 2 : value < 0 ? value / 2 : 1;
  slider.min = Math.max(whole ? Math.floor(low) : low, field.least ?? -Infinity);
  slider.max = Math.min(whole ? Math.ceil(high) : high, field.most ?? Infinity);
  slider.step = whole ? 1 : "any";
  slider.value = value;
}

function build() {
  const open = new Set([...document.querySelectorAll("#form details[open]")].map(one => one.dataset.path));
  inputs.clear();
  at("form").replaceChildren(...state.form.map((group, k) => {
    const title = group.path.join(" ") || "design", more = made("details", {className: "more"}, made("summary", {textContent: `${group.possible.length} more`, title: "Entries that are left out"}));
    more.dataset.path = `${title}/more`;
    more.open = open.has(more.dataset.path);
    const fill = () => { if (more.open && more.children.length === 1) more.append(...group.possible.map(field => entry(group, field))); };
    more.addEventListener("toggle", fill);
    fill();
    const box = made("details", {open: shape === "" ? k < 8 : open.has(title)}, made("summary", {textContent: title, title: group.help}), ...group.written.map(field => entry(group, field)));
    if (group.possible.length) box.append(more);
    box.dataset.path = title;
    return box;
  }));
}

/* Whoever types into an entry that is made anew, as it is when the text takes it up, types on behind what stands there. */
function goOn(input, typed) {
  if (!input) return;
  input.focus();
  if (input.type !== "text") return;
  input.value = typed;
  input.setSelectionRange(typed.length, typed.length);
}

function show() {
  const now = state.form.map(group => [group.path.join("."), ...group.written.map(field => `${field.key}:${field.kind}`)].join(",")).join(";");
  const focused = document.activeElement?.id, typed = document.activeElement?.value;
  if (now !== shape) {
    build();
    shape = now;
    if (focused?.startsWith("entry:")) goOn(document.getElementById(focused), typed);
  }
  for (const group of state.form) for (const field of [...group.written, ...group.possible]) {
    const held = inputs.get(idOf(group.path, field.key));
    if (!held) continue;
    held.field = field;
    if (held.slider.type === "range" && held.slider !== document.activeElement) range(held.slider, field);
    if (field.kind === "boolean") held.input.checked = field.value === true;
    else if (field.kind !== "other" && held.input !== document.activeElement) held.input.value = field.value ?? "";
  }
}

/* An entry by its path, opened and focused; true if the form has it. */
export function focusEntry(path) {
  const group = state.form.find(one => [...one.written, ...one.possible].some(field => [...one.path, field.key].join(".") === path));
  const title = group && (group.path.join(" ") || "design"), box = [...document.querySelectorAll("#form details")].find(one => one.dataset.path === title);
  if (!box) return false;
  box.open = true;
  const key = path.slice(group.path.join(".").length + (group.path.length ? 1 : 0));
  if (!group.written.some(field => field.key === key)) {
    const more = box.querySelector("details.more");
    more.open = true;
    if (more.children.length === 1) more.append(...group.possible.map(field => entry(group, field)));
  }
  const {input} = inputs.get(idOf(group.path, key)) || {};
  input?.scrollIntoView({block: "center"});
  input?.focus();
  return Boolean(input);
}

on("form", show);
