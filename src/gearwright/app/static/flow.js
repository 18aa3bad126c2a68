/* The power flow of a load case, drawn by the server, and the tabs of the cases. */
import {ask, Dropped, Problems} from "/static/api.js";
import {at, made} from "/static/made.js";
import {on, set, state} from "/static/state.js";
import {drawing} from "/static/svg.js";

let timer = 0;

function tabs() {
  if (!state.answer) return;
  const names = Object.keys(state.answer.result.cases);
  if (!names.includes(state.case)) set({case: state.answer.case});
  at("cases").replaceChildren(...names.map(name => {
    const tab = made("button", {type: "button", role: "tab", textContent: name, tabIndex: name === state.case ? 0 : -1});
    tab.setAttribute("aria-selected", String(name === state.case));
    tab.setAttribute("aria-controls", "flow");
    tab.addEventListener("click", () => set({case: name}));
    tab.addEventListener("keydown", event => step(event, names, name));
    return tab;
  }));
}

function step(event, names, name) {
  const way = {ArrowRight: 1, ArrowLeft: -1}[event.key];
  if (!way) return;
  set({case: names[(names.indexOf(name) + way + names.length) % names.length]});
  at("cases").querySelector("[aria-selected=true]").focus();
}

/* One drawing for whatever changes at once. */
function draw() {
  clearTimeout(timer);
  timer = setTimeout(drawn, 0);
}

async function drawn() {
  if (!state.answer || !state.case || state.view !== "design-view") return;
  try {
    const text = await (await ask("flow", state.answer.text, {case: state.case})).text();
    at("flow").replaceChildren(drawing(text, "flow"));
  } catch (reason) {
    if (!(reason instanceof Dropped || reason instanceof Problems)) at("status").textContent = reason.message;
  }
}

/* A name in the drawing selects its part: a stage its first gear, a shaft itself. */
at("flow").addEventListener("click", event => {
  const word = event.target.closest?.("text")?.textContent.trim(), result = state.answer?.result;
  if (!word || !result) return;
  const gear = result.gears.find(one => one.stage === word), shaft = result.shafts.find(one => one.name === word);
  if (gear || shaft) set({selected: gear ? gear.part : shaft.name});
});

on("answer", tabs);
on("case", tabs);
on("answer case view", draw);
