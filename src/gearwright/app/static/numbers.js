/* What the design amounts to: verdict, key numbers with their change, margins worst first. */
import {begin} from "/static/jobs.js";
import {at, change, made, named, number, percent, ratio} from "/static/made.js";
import {on, set, state} from "/static/state.js";

const KEYS = [
  ["mass_kg", "Train as sized", false], ["complete_total_kg", "Complete gearbox", false], ["worst_margin", "Worst margin of sizing", true],
  ["power_density_kw_kg", "Power density", true], ["envelope.length_mm", "Length", false], ["envelope.width_mm", "Width", false],
];
const read = (result, key) => key.split(".").reduce((part, name) => part?.[name], result);
const reviewed = () => (state.answer && state.review?.text === state.answer.text ? state.review : null);

function keys() {
  const {answer, pinned} = state;
  if (!answer) return;
  at("keys").replaceChildren(...KEYS.map(([key, title, more]) => {
    const value = read(answer.result, key), share = pinned ? change(value, read(pinned.answer.result, key)) : null;
    const better = share === null || share === 0 ? "" : (share > 0) === more ? "better" : "worse";
    const delta = made("span", {className: `change ${better}`, textContent: percent(share), title: better ? `${better} than the pinned one` : "against the pinned one"});
    delta.dataset.key = key;
    const unit = named(key.split(".").at(-1))[1];
    const why = made("button", {type: "button", className: "why-button", title: "Why?", ariaLabel: `${title}: why?`}, made("b", {className: key === "worst_margin" ? outcome(answer.result.margins) : "", textContent: key === "worst_margin" ? ratio(value) : number(value)}));
    why.addEventListener("click", () => set({asked: state.asked === key ? "" : key}));
    const shown = made("dd", {}, why, made("span", {className: "unit", textContent: ` ${unit} `}), delta);
    shown.dataset.key = key;
    return made("div", {}, made("dt", {textContent: title}), shown);
  }), ...worst());
}

/* What a full review says of all checks stands beside what sizing says of its own. */
function worst() {
  const row = reviewed()?.checks.find(one => one.status !== "not assessed" && one.status !== "waived");
  if (!row) return [];
  const shown = made("dd", {}, made("b", {className: outcome(reviewed().checks), textContent: said(row)}));
  shown.dataset.key = "review";
  return [made("div", {title: `${row.part}: ${row.check}`}, made("dt", {textContent: "Worst of the full review"}), shown)];
}

const outcome = checks => (checks.some(row => row.status === "fails") ? "bad" : "good");

function verdict() {
  const box = at("verdict"), {answer, stale, problems} = state, full = reviewed();
  if (stale) box.textContent = `${problems.length === 1 ? "One problem" : `${problems.length} problems`} in the text. What stands below is of the last valid text.`;
  else box.textContent = full ? `Full review: ${full.headline}` : answer ? answer.headline.replace("gearwright review", "Full review") : "";
  const fails = full ? outcome(full.checks) === "bad" : answer && !answer.holds; // what nobody has reviewed is not said to hold
  box.className = `verdict ${stale ? "stale" : fails ? "fails" : full ? "holds" : ""}`;
  document.body.classList.toggle("stale", stale);
}

/* The checks of the full review of this text, where there is one; else those of sizing. */
const shownChecks = () => (reviewed() || {checks: state.answer.result.margins}).checks;

const MARK = 3; // margins from here on fill the bar

const said = row => (row.margin === null ? row.status : ratio(row.margin));

function unassessed(rows) {
  const box = at("unassessed"), list = rows.filter(row => row.status === "not assessed");
  box.hidden = !list.length;
  box.firstElementChild.textContent = `${list.length} not assessed, and why`;
  box.lastElementChild.replaceChildren(...list.map(row => made("li", {}, made("b", {textContent: row.part}), ` ${row.check}: ${row.why || row.source}`)));
}

function margins() {
  if (!state.answer) return;
  at("margins-title").textContent = `${reviewed() ? "Checks of the full review" : "Margins of sizing"}, worst first`;
  const all = shownChecks(), rows = all.filter(row => row.status !== "not assessed");
  unassessed(all);
  at("margins").replaceChildren(...rows.map(row => {
    const filled = Math.max(0, Math.min(1, (row.margin ?? 0) / MARK)), fails = row.status === "fails";
    const bar = made("span", {className: "bar", ariaHidden: "true"}, made("span", {className: fails ? "fails" : "room"}));
    bar.firstChild.style.width = `${100 * filled}%`;
    const button = made("button", {type: "button", title: `${row.source}${row.case ? `, case ${row.case}` : ""}: ${number(row.value)} ${row.unit}, limit ${number(row.limit)} ${row.unit}`},
      made("span", {className: "part", textContent: row.part}), made("span", {className: "check", textContent: row.check}), made("span", {className: "value", textContent: said(row)}), bar);
    button.setAttribute("aria-pressed", String(row.part === state.selected));
    button.dataset.part = row.part;
    button.addEventListener("click", () => set({selected: state.selected === row.part ? "" : row.part}));
    return made("li", {className: row.status.replace(" ", "-")}, button);
  }));
}

function chosen() {
  for (const button of at("margins").querySelectorAll("button")) button.setAttribute("aria-pressed", String(button.dataset.part === state.selected));
}

let job = null;

const counted = checks => ["fails", "passes"].map(status => `${checks.filter(row => row.status === status).length} ${status.slice(0, -1).replace("passe", "pass")}`).join(", ");

async function review() {
  const text = state.text;
  at("stop").hidden = false;
  at("reviewed").textContent = "reviewing…";
  const mine = job = begin("review", text);
  try {
    const answer = await (await mine.answer).json();
    if (mine !== job) return;
    at("reviewed").textContent = counted(answer.result.checks);
    at("reviewed").dataset.text = text;
    at("reviewed").title = "gearwright review";
    set({review: {text, headline: answer.headline, checks: answer.result.checks.map(row => ({...row, check: row.mode, margin: row.reserve ?? row.ratio}))}});
  } catch (reason) {
    if (mine === job) at("reviewed").textContent = reason.message || "stopped";
  } finally {
    if (mine === job) at("stop").hidden = true;
  }
}

on("answer pinned review", keys);
on("answer stale problems review", verdict);
on("answer review", margins);
on("selected", chosen);
on("text", () => { if (at("reviewed").dataset.text && at("reviewed").dataset.text !== state.text) at("reviewed").textContent = "the text has changed since the review"; });
at("review").addEventListener("click", review);
at("stop").addEventListener("click", () => job?.stop().catch(() => {}));
