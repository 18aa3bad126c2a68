/* The dynamics view: a run of the load case and what follows from it, drawn as soon as somebody looks. */
import {Dropped} from "/static/api.js";
import {Task, begin, unpacked} from "/static/jobs.js";
import {at} from "/static/made.js";
import {library} from "/static/plots.js";
import {on, set, state} from "/static/state.js";
import {campbell} from "/static/dynamics/campbell.js";
import {modes} from "/static/dynamics/modes.js";
import {spectra} from "/static/dynamics/spectra.js";
import {traces} from "/static/dynamics/traces.js";
import {waterfall} from "/static/dynamics/waterfall.js";

const PAUSE = 400; // after the last change of the text [ms]
let timer = 0;
const seen = {};

const key = () => `${state.case}\n${at("duration").value}\n${state.answer?.text}`;

/* One kind of answer: begun for the text as it stands, shown when it comes, with the text that it is of. */
function kind(box, title, verb, options, show, auto) {
  const task = new Task(at(box), title, told => {
    if (!state.answer) return null;
    const mine = key();
    seen[verb] = mine;
    return {
      ...begin(verb, state.answer.text, {case: state.case, ...options()}, told),
      taken: async answer => {
        await library();
        const found = answer.headers.get("content-type").startsWith("application/json") ? await answer.json() : await unpacked(answer);
        if (mine === key()) show(found);
        document.body.dataset[verb] = mine === key() ? String(Number(document.body.dataset[verb] || 0) + 1) : "";
      },
      failed: reason => { if (!(reason instanceof Dropped)) seen[verb] = ""; },
    };
  });
  return {task, verb, auto};
}

const duration = () => ({duration: Math.min(2, Math.max(0.002, Number(at("duration").value) / 1000 || 0.05))});
const kinds = [
  kind("run-line", "Run", "simulate", duration, found => { traces(found); spectra(found); set({run: found}); }, true),
  kind("campbell-line", "Campbell", "campbell", () => ({}), campbell, true),
  kind("modes-line", "Modes", "modes", () => ({}), modes, true),
  kind("waterfall-line", "Run up", "runup", () => ({speeds: Number(at("speeds").value) || 21, lowest: Number(at("lowest").value) || 0.3, highest: Number(at("highest").value) || 1.3}), waterfall, false),
];

function follow() {
  clearTimeout(timer);
  if (state.view !== "dynamics-view" || !state.answer || !state.case || state.stale) return;
  timer = setTimeout(() => { for (const one of kinds) if (one.auto && seen[one.verb] !== key()) one.task.go(); }, seen.simulate ? PAUSE : 0);
}

function cases() {
  if (!state.answer) return;
  at("dynamics-case").replaceChildren(...Object.keys(state.answer.result.cases).map(name => new Option(name, name, false, name === state.case)));
}

function tab(chosen) {
  for (const button of at("vibration-tabs").querySelectorAll("button")) {
    const mine = button.dataset.panel === chosen;
    button.setAttribute("aria-selected", String(mine));
    button.tabIndex = mine ? 0 : -1;
    at(button.dataset.panel).hidden = !mine;
  }
}

const tabs = [...at("vibration-tabs").querySelectorAll("button")];
for (const [k, button] of tabs.entries()) {
  button.addEventListener("click", () => tab(button.dataset.panel));
  button.addEventListener("keydown", event => {
    const way = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (!way) return;
    const next = tabs[(k + way + tabs.length) % tabs.length];
    tab(next.dataset.panel);
    next.focus();
  });
}
at("dynamics-case").addEventListener("change", event => set({case: event.target.value}));
at("duration").addEventListener("change", follow);
on("answer case", cases);
on("answer case view stale", follow);
