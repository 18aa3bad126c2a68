/* Designs that are opened, saved and exported. */
import {Dropped, sent} from "/static/api.js";
import {replace} from "/static/editor.js";
import {begin} from "/static/jobs.js";
import {at, made} from "/static/made.js";
import {on, set, state} from "/static/state.js";

let files = [], designs = [];

function choices() {
  const group = (label, names, prefix) => made("optgroup", {label}, ...names.map(name => made("option", {value: prefix + name, textContent: name})));
  at("design").replaceChildren(group("In the folder", files, "file:"), group("Shipped", designs, "shipped:"));
  at("design").value = (state.shipped ? "shipped:" : "file:") + state.name;
}

export async function start() {
  const told = await (await sent("/api/start")).json();
  files = told.files;
  designs = told.designs;
  set({files, designs, missions: told.missions, studies: told.studies, journals: told.journals});
  taken(told.name, told.shipped, told);
  at("formats").replaceChildren(...told.formats.map(format => format_(format, `gearwright export ${told.name} --to ${format}`)), format_("report", ""));
}

function taken(name, shipped, {text, tag}) {
  set({name, shipped, tag, saved: text, pinned: null, selected: "", case: ""});
  replace(text);
  set({text});
  choices();
  document.title = `${name} – gearwright`;
}

/* Another text, such as a variant of a study: not saved yet, and told against what the user pinned, else the one before it. */
export function offered(text, words) {
  const own = state.pinned?.own;
  if (state.answer && !own) set({pinned: {text: state.answer.text, answer: state.answer}});
  replace(text);
  at("status").textContent = `${words}; told against what ${own ? "is pinned" : "was there before"}`;
}

async function open(choice) {
  if (state.text !== state.saved && !confirm("What is not saved is lost. Open another design?")) {
    choices();
    return;
  }
  const [kind, name] = [choice.slice(0, choice.indexOf(":")), choice.slice(choice.indexOf(":") + 1)], shipped = kind === "shipped";
  const told = await (await sent(`/api/${shipped ? "designs" : "files"}/${encodeURIComponent(name)}`)).json();
  taken(name, shipped, told);
}

/* Where it came from, or under a name of its own where it was shipped. */
async function save() {
  if (!state.shipped) return write(state.name, {"if-match": `"${state.tag}"`});
  at("name").value = `${state.name}.toml`;
  at("naming").showModal();
}

async function write(name, headers) {
  const text = state.text;
  try {
    const {tag} = await (await sent(`/api/files/${encodeURIComponent(name)}`, "PUT", {text}, headers)).json();
    if (!files.includes(name)) files = [...files, name].sort();
    set({files});
    set({name, shipped: false, tag, saved: text});
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
  try {
    const told = await (await sent(`/api/files/${encodeURIComponent(state.name)}`)).json();
    if (told.tag === state.tag) return;
    if (state.text === state.saved) taken(state.name, false, told);
    else at("status").textContent = `${state.name} has changed on the disk; save under another name, or open it again`;
  } catch (reason) {
    at("status").textContent = reason.message;
  }
}

function title() {
  at("save").disabled = !state.shipped && state.text === state.saved;
  for (const button of at("formats").querySelectorAll("button")) {
    const format = button.dataset.format, name = state.shipped ? state.name : state.name;
    button.lastChild.textContent = format === "report" ? `gearwright report ${name}` : `gearwright export ${name} --to ${format}`;
  }
}

on("text saved name", title);
at("design").addEventListener("change", event => open(event.target.value).catch(reason => { at("status").textContent = reason.message; }));
at("save").addEventListener("click", save);
at("naming").addEventListener("close", () => { if (at("naming").returnValue === "save") write(at("name").value, {"if-none-match": "*"}); });
document.addEventListener("keydown", event => { if ((event.ctrlKey || event.metaKey) && event.key === "s") { event.preventDefault(); save(); } });
addEventListener("focus", look);
addEventListener("beforeunload", event => { if (state.text !== state.saved) event.preventDefault(); });
document.addEventListener("click", event => { if (!at("export").contains(event.target)) at("export").open = false; });
