/* Designs that are opened, saved and exported. */
import {Dropped, sent} from "/static/api.js";
import {draft, keep, last, opened} from "/static/drafts.js";
import {open as edit, replace} from "/static/editor.js";
import {begin} from "/static/jobs.js";
import {at, made} from "/static/made.js";
import {on, set, state} from "/static/state.js";

let opening = 0; // how often a file was opened: what was asked of one before belongs to that one
let tagged = ""; // of what is saved

const KIND = "design", chosen = () => (state.shipped ? "shipped:" : "file:") + state.name;

function choices() {
  const group = (label, names, prefix) => made("optgroup", {label}, ...names.map(name => made("option", {value: prefix + name, textContent: name})));
  at("design").replaceChildren(group("In the folder", state.files, "file:"), group("Shipped", state.designs, "shipped:"));
  at("design").value = chosen();
}

export async function start() {
  const told = await (await sent("/api/start")).json();
  const {files, designs} = told;
  set({files, designs, missions: told.missions, studies: told.studies, journals: told.journals});
  at("formats").replaceChildren(...told.formats.map(format => format_(format, `gearwright export ${told.name} --to ${format}`)), format_("report", ""));
  const before = last(KIND, [...files.map(name => `file:${name}`), ...designs.map(name => `shipped:${name}`)]);
  if (before) await open(before).catch(() => {});
  if (!state.name) taken(told.name, told.shipped, told);
}

/* What was not saved of a file stands on top of what is saved, by its old tag: what has changed meanwhile is not written over. */
function taken(name, shipped, {text, tag}) {
  const own = draft(KIND, (shipped ? "shipped:" : "file:") + name) || {text, tag};
  opening++;
  tagged = tag;
  set({name, shipped, tag: own.tag, saved: text, text: own.text, pinned: null, selected: "", case: "", problems: []});
  edit(text, own.text);
  opened(KIND, chosen());
  choices();
  document.title = `${name} – gearwright`;
}

/* Another text, such as a variant of a study: not saved yet, and told against what the user pinned, else the one before it. */
export async function offered(text, words, of = state.name) {
  const own = state.pinned?.own, pinned = state.answer && !own ? {text: state.answer.text, answer: state.answer} : state.pinned;
  if (of !== state.name) await open(`${state.designs.includes(of) ? "shipped" : "file"}:${of}`);
  set({pinned});
  replace(text);
  at("status").textContent = `${words}; told against what ${own ? "is pinned" : "was there before"}`;
}

async function open(choice) {
  const mine = ++opening, [kind, name] = [choice.slice(0, choice.indexOf(":")), choice.slice(choice.indexOf(":") + 1)], shipped = kind === "shipped";
  try {
    const told = await (await sent(`/api/${shipped ? "designs" : "files"}/${encodeURIComponent(name)}`)).json();
    if (mine === opening) taken(name, shipped, told);
  } finally {
    if (mine === opening) choices();
  }
}

/* Where it came from, or under a name of its own where it was shipped. */
async function save() {
  if (!state.shipped) return write(state.name, {"if-match": `"${state.tag}"`});
  at("name").value = `${state.name}.toml`;
  at("naming").showModal();
}

async function write(name, headers) {
  const {text} = state, mine = opening, place = chosen();
  try {
    const {tag} = await (await sent(`/api/files/${encodeURIComponent(name)}`, "PUT", {text}, headers)).json();
    if (!state.files.includes(name)) set({files: [...state.files, name].sort()});
    keep(KIND, place, {text: draft(KIND, place)?.text ?? text, saved: text, tag});
    if (mine === opening) {
      tagged = tag;
      set({name, shipped: false, tag, saved: text});
      opened(KIND, chosen());
    }
    choices();
    at("status").textContent = `saved ${name}`;
  } catch (reason) {
    at("status").textContent = reason.message;
  }
}

function format_(name, line) {
  const button = made("button", {type: "button"}, made("b", {textContent: name}), made("code", {textContent: line}));
  button.dataset.format = name;
  button.addEventListener("click", () => give(name));
  return made("div", {}, button);
}

async function give(format) {
  at("status").textContent = `making ${format}…`;
  try {
    const answer = await begin(format === "report" ? "report" : "export", state.text, {format}).answer;
    const link = made("a", {href: URL.createObjectURL(await answer.blob()), download: `${state.name.replace(/\.toml$/, "")}-${format === "report" ? "report.html" : `gearbox.${ENDINGS[format] || format.split("-")[0]}`}`});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    at("status").textContent = `${link.download} was made`;
  } catch (reason) {
    if (!(reason instanceof Dropped)) at("status").textContent = reason.message;
  }
}
const ENDINGS = {netcdf: "nc"};

/* Who comes back to the window is told if the file has changed meanwhile. */
async function look() {
  if (state.shipped || !state.name) return;
  const mine = opening, {tag} = state;
  try {
    const told = await (await sent(`/api/files/${encodeURIComponent(state.name)}`)).json();
    if (mine !== opening || tag !== state.tag || told.tag === tag) return;
    if (state.text === state.saved) taken(state.name, false, told);
    else at("status").textContent = `${state.name} has changed on the disk; save under another name, or open it again`;
  } catch (reason) {
    at("status").textContent = reason.message;
  }
}

function title() {
  at("save").disabled = !state.shipped && state.text === state.saved;
  for (const button of at("formats").querySelectorAll("button")) {
    const format = button.dataset.format, {name} = state;
    button.lastChild.textContent = format === "report" ? `gearwright report ${name}` : `gearwright export ${name} --to ${format}`;
  }
}

on("text saved name", title);
on("files", choices);
on("text saved name shipped tag", () => {
  if (state.text === state.saved) set({tag: tagged});
  keep(KIND, chosen(), state);
});
at("design").addEventListener("change", event => open(event.target.value).catch(reason => { at("status").textContent = reason.message; }));
at("save").addEventListener("click", save);
at("naming").addEventListener("close", () => { if (at("naming").returnValue === "save") write(at("name").value, {"if-none-match": "*"}); });
document.addEventListener("keydown", event => { if ((event.ctrlKey || event.metaKey) && event.key === "s") { event.preventDefault(); save(); } });
addEventListener("focus", look);
addEventListener("beforeunload", event => { if (state.text !== state.saved) event.preventDefault(); });
document.addEventListener("click", event => { if (!at("export").contains(event.target)) at("export").open = false; });
