/* A mission flown by the design as it stands: picked or written, flown, and what it does to the gearbox. */
import {Dropped, Problems, sent} from "/static/api.js";
import {draft, keep, last, opened} from "/static/drafts.js";
import {Task, begin, unpacked} from "/static/jobs.js";
import {at, made, number, ratio} from "/static/made.js";
import {library} from "/static/plots.js";
import {on, set, state} from "/static/state.js";
import {Text} from "/static/texts.js";
import {timeline} from "/static/flight/timeline.js";
import {windows} from "/static/flight/windows.js";

const PAUSE = 400, FIRST = "thesis", KIND = "mission";
let editor = null, timer = 0, flown = "", taking = 0;
let choice = "", saved = "", tag = ""; // of the mission: its place, its text there, and the tag of that

const nameOf = place => place.slice(place.indexOf(":") + 1);
const places = () => [...state.missions.map(name => `shipped:${name}`), ...(state.files || []).filter(file => file !== state.name).map(file => `file:${file}`)];

function choices() {
  if (!editor) return;
  const group = (label, prefix) => made("optgroup", {label}, ...places().filter(place => place.startsWith(prefix)).map(place => made("option", {value: place, textContent: nameOf(place)})));
  at("mission").replaceChildren(group("Shipped", "shipped:"), group("In the folder", "file:"));
  at("mission").value = choice;
}

/* Missions are read when somebody looks for the first time. */
async function open() {
  if (state.view !== "flight-view" || editor || !state.missions) return;
  editor = new Text(at("mission-editor"), "Mission in TOML", changed);
  const fitting = state.missions.find(one => one.startsWith(state.name.replace(/\.toml$/, ""))) || FIRST;
  await take(last(KIND, places()) || `shipped:${state.missions.includes(fitting) ? fitting : state.missions[0]}`);
}

async function take(place) {
  const mine = ++taking, shipped = place.startsWith("shipped:");
  try {
    const told = await (await sent(`/api/${shipped ? "designs" : "files"}/${encodeURIComponent(nameOf(place))}`)).json();
    if (mine !== taking) return;
    const own = draft(KIND, place);
    [choice, saved, tag] = [place, told.text, own?.tag ?? told.tag];
    opened(KIND, place);
    editor.open(told.text, own?.text);
  } finally {
    choices();
  }
}

function changed(text) {
  keep(KIND, choice, {text, saved, tag});
  clearTimeout(timer);
  timer = setTimeout(check, PAUSE);
}

/* What is wrong is told while one types; the windows of the mission are offered. */
async function check() {
  try {
    const told = await (await begin("mission", state.text, {mission: editor.text}).answer).json();
    editor.problems([], at("mission-problems"));
    windows(told.windows, () => editor.text);
  } catch (reason) {
    wrong(reason);
  }
}

function wrong(reason) {
  if (reason instanceof Problems) editor.problems(reason.problems, at("mission-problems"));
  else if (!(reason instanceof Dropped)) at("status").textContent = reason.message;
}

const task = new Task(at("fly-line"), "Fly", told => {
  if (!editor || !state.answer) return null;
  const text = state.answer.text, mission = editor.text;
  return {
    ...begin("fly", text, {mission}, told),
    taken: async answer => {
      await library();
      const found = await unpacked(answer);
      editor.problems([], at("mission-problems"));
      flown = text + mission;
      show(found);
      timeline(found);
      document.body.dataset.flown = String(Number(document.body.dataset.flown || 0) + 1);
    },
    failed: wrong,
  };
});

const KEYS = [
  ["fuel", head => `${number(head.fuel_kg)} kg`], ["flown", head => `${number(head.duration_s / 60)} min`], ["from the battery", head => `${number(head.balance.battery_kj / 3600)} kWh`],
  ["hottest oil", head => `${number(head.oil_hottest_k - 273.15, 3)} °C`], ["oil", head => `${number(head.oil_flow_l_min, 3)} l/min`], ["worst margin of the flight", head => ratio(head.margin)],
];

function show({head}) {
  at("flight-verdict").textContent = head.headline;
  at("flight-verdict").className = `verdict ${head.verdict === "fails" ? "fails" : "holds"}`;
  at("flight-keys").replaceChildren(...KEYS.map(([title, value]) => made("div", {}, made("dt", {textContent: title}), made("dd", {textContent: value(head)}))));
  const rows = head.damage.map(row => {
    const pick = made("button", {type: "button", textContent: row.part, title: "Select it everywhere"});
    pick.addEventListener("click", () => set({selected: row.part.replace(/^bearing of /, "")}));
    return made("tr", {}, made("th", {scope: "row"}, pick), ...[row.mode, row.damage.toExponential(2), row.flights === null ? "–" : number(row.flights, 4), row.life_h === null ? "–" : `${number(row.life_h, 4)} h`].map(textContent => made("td", {textContent})));
  });
  at("damage").replaceChildren(made("table", {}, made("thead", {}, made("tr", {}, ...["part", "fails by", "damage", "flights", "life"].map(textContent => made("th", {scope: "col", textContent})))), made("tbody", {}, ...rows)), ...head.not_rated.map(textContent => made("p", {className: "hint", tabIndex: 0, textContent})));
  URL.revokeObjectURL(at("sankey").src);
  at("sankey").src = URL.createObjectURL(new Blob([head.sankey], {type: "image/svg+xml"}));
  at("sankey").hidden = false;
}

async function save() {
  const mine = taking, place = choice, {text} = editor, name = nameOf(place), given = name.endsWith(".toml") ? name : `${name}-mine.toml`;
  try {
    const told = await (await sent(`/api/files/${encodeURIComponent(given)}`, "PUT", {text}, tag ? {"if-match": `"${tag}"`} : {"if-none-match": "*"})).json();
    keep(KIND, place, {text: draft(KIND, place)?.text ?? text, saved: text, tag: told.tag});
    if (mine === taking) {
      [choice, saved, tag] = [`file:${given}`, text, told.tag];
      opened(KIND, choice);
    }
    if (!state.files.includes(given)) set({files: [...state.files, given].sort()});
    at("status").textContent = `saved ${given}; gearwright fly ${state.name} ${given} flies it`;
  } catch (reason) {
    at("status").textContent = reason.message;
  }
}

on("answer", () => { if (flown && state.answer && !flown.startsWith(state.answer.text)) at("flight-verdict").textContent += at("flight-verdict").textContent.endsWith("changed since.") ? "" : " The design has changed since."; });
on("files name", choices);
on("view missions", () => open().catch(reason => { at("status").textContent = reason.message; }));
at("mission").addEventListener("change", event => take(event.target.value).catch(reason => { at("status").textContent = reason.message; }));
at("mission-save").addEventListener("click", save);
export {task};
