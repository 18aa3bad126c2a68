/* Studies: written, run in the journal that the command line has too, paused and gone on with; a dot opens its design. */
import {Dropped, Problems, sent} from "/static/api.js";
import {draft, keep, last, opened} from "/static/drafts.js";
import {offered} from "/static/files.js";
import {Task, begin} from "/static/jobs.js";
import {at, made, number} from "/static/made.js";
import {on, set, state} from "/static/state.js";
import {Text} from "/static/texts.js";
import {Parallel} from "/static/studies/parallel.js";
import {scatter} from "/static/studies/scatter.js";
import {flat, listed} from "/static/studies/table.js";

const OWN = "this"; // the design on the page, as studies call it
const KIND = "study";
let editor = null, table = null, parallel = null, shipped = "", running = "", saved = "", picking = 0;

function open() {
  if (state.view !== "studies-view" || !state.studies) return;
  if (!editor) {
    editor = new Text(at("study-editor"), "Study in TOML", text => keep(KIND, shipped, {text, saved, tag: ""}));
    at("study").replaceChildren(new Option("of this design", ""), ...state.studies.map(name => new Option(name, name)));
    pick(last(KIND, state.studies) || "").catch(wrong);
  }
  journals();
  vary();
}

/* A study of the design on the page: what is to be varied is added by the list. */
const FRESH = `schema = 1\nname = "What makes it lighter"\ndesigns = ["${OWN}"]                  # the design on the page, as it stands\nresults = ["mass", "complete_mass", "worst_margin", "power_density"]\n\n[axes]\n\n[objectives]\ncomplete_mass = "minimum"\n\n[constraints]\nworst_margin = {minimum = 0.9999}\n\n[sampling]\nmethod = "sobol"\ncount = 128\nseed = 1\n`;

async function pick(name) {
  const mine = ++picking, text = name ? (await (await sent(`/api/designs/${encodeURIComponent(name)}`)).json()).text : FRESH;
  if (mine !== picking) return;
  [shipped, saved] = [name, text];
  at("study").value = name;
  at("journal").value = free(name || "lighter");
  opened(KIND, name);
  editor.open(text, draft(KIND, name)?.text);
}

/* A name that no journal has. */
function free(stem) {
  const there = state.journals || [];
  let name = `${stem}.journal`;
  for (let k = 2; there.includes(name); k++) name = `${stem}-${k}.journal`;
  return name;
}

function journals() {
  at("journals").replaceChildren(new Option("", ""), ...(state.journals || []).map(name => new Option(name, name)));
}

function vary() {
  const groups = state.form.filter(group => group.written.some(numeric)).map(group => made("optgroup", {label: group.path.join(".") || "design"},
    ...group.written.filter(numeric).map(field => made("option", {value: [...group.path, field.key].join("."), textContent: `${(group.path.slice(1).join(" ") || group.path[0] || "design")}: ${field.name} = ${field.value} ${field.unit}`}))));
  at("vary").replaceChildren(...groups);
}

const numeric = field => typeof field.value === "number" && field.key !== "schema";

function add() {
  const path = at("vary").value, field = state.form.flatMap(group => group.written.map(one => [[...group.path, one.key].join("."), one])).find(([name]) => name === path)?.[1];
  if (!field) return;
  const whole = field.kind === "integer", low = whole ? Math.max(field.least ?? 1, field.value - 1) : Number((0.9 * field.value).toPrecision(6)), high = whole ? field.value + 1 : Number((1.1 * field.value).toPrecision(6));
  const line = whole ? `"${path}" = {values = [${Array.from({length: high - low + 1}, (_, k) => low + k).join(", ")}]}` : `"${path}" = {from = ${low}, to = ${high}}`;
  editor.replace(editor.text.includes(`"${path}"`) ? editor.text : editor.text.replace(/^\[axes\]\n((?:"[^\n]*\n)*)/m, (_, before) => `[axes]\n${before}${line}\n`));
}

const wrong = reason => { if (reason instanceof Problems) editor.problems(reason.problems, at("study-problems")); else if (!(reason instanceof Dropped)) at("status").textContent = reason.message; };

async function taken(answer) {
  editor.problems([], at("study-problems"));
  show(await answer.json());
  if (!state.journals.includes(running)) set({journals: [...state.journals, running].sort()});
  document.body.dataset.studied = String(Number(document.body.dataset.studied || 0) + 1);
}

/* Paused: what is finished stands in the journal, and is shown. */
async function paused(reason) {
  if (!(reason instanceof Dropped)) return wrong(reason);
  try {
    const found = await (await begin("rows", state.text, {journal: running}).answer).json();
    if (!state.journals.includes(running)) set({journals: [...state.journals, running].sort()});
    at("journals").value = running;
    if (found.rows.length) show(found);
    at("study-words").textContent = `Paused: ${found.done} of ${found.total} are finished and kept in ${running}. Go on here, or by gearwright resume ${running}.`;
    document.body.dataset.paused = String(found.done);
  } catch (why) {
    at("study-words").textContent = why.message;
  }
}

const run = new Task(at("study-line"), "Run", told => {
  if (!editor) return null;
  running = at("journal").value;
  at("study-command").textContent = `gearwright study ${shipped || "STUDY.toml"} --journal ${running}`;
  return {...begin("study", state.text, {study: editor.text, journal: running}, told), taken, failed: paused};
}, {end: "Pause"});

new Task(at("resume-line"), "Go on", told => {
  if (!at("journals").value) { at("status").textContent = "choose a journal to go on with"; return null; }
  running = at("journals").value;
  at("study-command").textContent = `gearwright resume ${running}`;
  return {...begin("resume", state.text, {journal: running}, told), taken, failed: paused};
}, {end: "Pause"});

function show(found) {
  table = flat(found);
  at("study-words").textContent = found.words.join(" ") || `${table.rows.length} designs, ${found.rows.length - table.rows.length} cannot be built.`;
  if (found.rows.some(row => row.design === OWN) && state.answer) at("study-words").textContent += ` The design on the page as it stands: ${number(state.answer.result.complete_total_kg)} kg complete.`;
  if (found.left_out) at("study-words").textContent += ` Of many, every ${Math.round(1 + found.left_out / found.rows.length)}th is drawn.`;
  parallel = new Parallel(at("parallel"), at("limits"), table, kept);
  for (const [id, first] of [["scatter-x", table.columns[0]], ["scatter-y", table.goal || table.columns.at(-1)]]) {
    at(id).replaceChildren(...table.columns.map(name => new Option(name, name)));
    at(id).value = first;
  }
  kept(parallel.kept());
}

function kept(rows) {
  at("kept").textContent = `${rows.length} of ${table.rows.length} kept`;
  scatter(at("scatter"), table, rows, {x: at("scatter-x").value, y: at("scatter-y").value, picked: variant});
  listed(at("study-rows"), table, rows, variant);
}

/* The design of a row, as a text that differs from its design by the row's entries alone. */
async function variant(row) {
  try {
    const changes = {...table.changes, ...row.inputs};
    const told = await (await begin("variant", state.text, {design: row.design, changes}).answer).json();
    await offered(told.text, `a variant of ${row.design}: ${Object.entries(row.inputs).map(([path, value]) => `${path} = ${value}`).join(", ")}`, row.design === OWN ? state.name : row.design);
    location.hash = "design-view";
  } catch (reason) {
    at("status").textContent = reason.message;
  }
}

on("view studies form", open);
on("journals", journals);
at("study").addEventListener("change", event => pick(event.target.value).catch(reason => { at("status").textContent = reason.message; }));
at("vary-add").addEventListener("click", add);
for (const id of ["scatter-x", "scatter-y"]) at(id).addEventListener("change", () => parallel && kept(parallel.kept()));
export {run};
