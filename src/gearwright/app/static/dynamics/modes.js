/* Natural frequencies as a list; each shape is shown on the solids. */
import {at, made, number} from "/static/made.js";
import {set, state} from "/static/state.js";

export function modes(found) {
  const rows = found.modes.map((mode, k) => {
    const show = made("button", {type: "button", textContent: "On the solids", disabled: mode.frequency_hz === 0});
    show.addEventListener("click", () => {
      const shape = Object.fromEntries(Object.entries(found.shapes).map(([name, turns]) => [name, turns[k]]));
      set({shaken: {kind: "mode", title: `Mode ${mode.number}, ${number(mode.frequency_hz)} Hz`, shape, text: state.answer.text, case: found.case}});
      location.hash = "gearbox-view";
    });
    return made("tr", {}, made("th", {scope: "row", textContent: mode.number}), ...[mode.frequency_hz ? `${number(mode.frequency_hz)} Hz` : "rigid", mode.highest_kinetic_energy, mode.highest_strain_energy].map(textContent => made("td", {textContent})), made("td", {}, show));
  });
  at("modes").replaceChildren(made("table", {}, made("caption", {textContent: `Undamped natural frequencies, case ${found.case}`}),
    made("thead", {}, made("tr", {}, ...["mode", "frequency", "moves most", "strained most", "shape"].map(textContent => made("th", {scope: "col", textContent})))), made("tbody", {}, ...rows)));
}

/* The end of the run, slowly, on the solids. */
at("run-solids").addEventListener("click", () => {
  const {run} = state;
  if (!run?.column("turn time")) return;
  const turns = Object.fromEntries(Object.keys(run.head.columns).filter(name => name.startsWith("turn ") && name !== "turn time").map(name => [name.slice(5), run.column(name)]));
  set({shaken: {kind: "run", title: `The last ${number(run.column("turn time").at(-1) * 1000 - run.column("turn time")[0] * 1000, 3)} ms of the run`, time: run.column("turn time"), turns, text: state.answer.text, case: run.head.case}});
  location.hash = "gearbox-view";
});
