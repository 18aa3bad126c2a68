/* What would change a number: each value that the design gives, or could give, moved a little; everything found anew. */
import {Dropped, Problems} from "/static/api.js";
import {focusEntry} from "/static/form.js";
import {begin} from "/static/jobs.js";
import {made, number, percent, ratio} from "/static/made.js";
import {state} from "/static/state.js";

const MOST = 8; // of each way
const NOISE = 1e-6; // of a share, below which it is rounding [1]
const MORE = /margin|density|life|safety/; // of such a number more is better: what raises it stands first
let text = "", found = null, asked = null;

/* Of the text as it stands, computed once. */
function moves() {
  if (text === state.answer.text && asked) return asked;
  text = state.answer.text;
  found = null;
  const mine = text;
  asked = begin("moved", text).answer.then(answer => answer.json()).then(told => { if (mine === text) found = told; return told; });
  asked.catch(() => { if (mine === text) asked = null; });
  return asked;
}

const step = one => {
  if (one.kind === "choice") return one.more;
  const name = one.path, unit = /_mm$/.test(name) && one.kind === "computed" && one.more - one.value === 1;
  return unit ? "+1 mm" : Number.isInteger(one.value) && one.more - one.value === 1 ? "+1" : "+1 %";
};
const KINDS = {written: "", default: ", now the default", computed: ", now computed", choice: ""};

/* Each way, the largest first; the better way before the other. */
function ways({handles, changes}, key) {
  const shares = changes[key] || [], margins = changes.worst_margin || [], now = state.answer.result.worst_margin;
  const list = handles.map((one, k) => ({...one, share: shares[k], margin: now * (1 + (margins[k] || 0))})).filter(one => one.share).sort((a, b) => Math.abs(b.share) - Math.abs(a.share));
  const found = [["lower", list.filter(one => one.share < 0).slice(0, MOST)], ["raise", list.filter(one => one.share > 0).slice(0, MOST)]];
  return MORE.test(key) ? found.reverse() : found;
}

function told_of([way, list]) {
  if (!list.length) return [made("p", {className: "hint", textContent: `No single step would ${way} it.`})];
  return [made("p", {className: "hint", textContent: `What would ${way} it, everything else found anew:`}), made("div", {className: "bars"}, ...list.flatMap(one => [handle(one), made("span", {textContent: percent(one.share)}, ...failing(one))]))];
}

/* What does not pass alone: other sizes have to follow it. */
const failing = one => (one.margin < 1 - NOISE ? [made("small", {className: "hint", textContent: `margin of sizing ${ratio(one.margin)}`})] : []);

/* Leads to its entry in the form. */
function handle(one) {
  const button = made("button", {type: "button", className: "why-button", title: `${number(one.value)} to ${number(one.more)}${KINDS[one.kind]}: show it in the form`, textContent: one.kind === "choice" ? `${one.path} = ${one.more}${one.value ? ` (now ${one.value})` : ""}` : `${step(one)} of ${one.path} (${number(one.value)}${KINDS[one.kind]})`});
  button.addEventListener("click", () => focusEntry(one.path));
  return made("span", {}, button);
}

/* A box that fills itself as soon as the answer is there. */
export function moved(key, box = made("div", {className: "moved"})) {
  box.replaceChildren(made("p", {className: "hint", textContent: "moving every value a little…"}));
  const mine = state.answer.text;
  moves().then(told => {
    if (mine !== state.answer.text) return;
    const found = ways(told, key);
    box.replaceChildren(...(found.some(([, list]) => list.length) ? found.flatMap(told_of) : [made("p", {className: "hint", textContent: "None of the values of the design moves it."})]));
    document.body.dataset.moved = key;
  }).catch(reason => {
    box.replaceChildren(made("p", {className: "hint", textContent: reason instanceof Dropped || reason instanceof Problems ? "" : reason.message}));
  });
  return box;
}
