/* Seconds of a mission on the elastic train, computed on a click. */
import {Task, begin, unpacked} from "/static/jobs.js";
import {at, made, number, ratio} from "/static/made.js";
import {library, plot} from "/static/plots.js";
import {state} from "/static/state.js";

let wanted = "", mission = () => "", found = null;

const task = new Task(at("window-line"), "Again", told => {
  if (!wanted || !state.answer) return null;
  return {
    ...begin("window", state.answer.text, {mission: mission(), window: wanted}, told),
    taken: async answer => {
      await library();
      found = await unpacked(answer);
      show();
      document.body.dataset.window = found.head.window;
    },
  };
});
task.button.hidden = true;

export function windows(given, text) {
  mission = text;
  at("windows").replaceChildren(...Object.entries(given).map(([name, words]) => {
    const button = made("button", {type: "button", textContent: name, title: words});
    button.addEventListener("click", () => { wanted = name; task.go(); });
    return button;
  }));
  if (!Object.keys(given).length) at("windows").replaceChildren(made("span", {className: "hint", textContent: "The mission has no [windows]."}));
}

function show() {
  const {head} = found;
  at("window-found").hidden = false;
  at("window-verdict").textContent = `${head.window}: ${head.headline}. ${number(head.duration_s, 3)} s from ${number(head.start_s / 60, 4)} min on.`;
  at("window-of").replaceChildren(...head.series.map(one => new Option(`${one.name}${one.unit ? ` [${one.unit}]` : ""}`, one.name)));
  const worst = head.meshes[0]?.mesh, first = head.series.find(one => worst && one.name.startsWith(worst));
  if (first) at("window-of").value = first.name;
  const share = row => row.peak_force_n !== undefined ? [row.mesh, `${number(row.peak_force_n)} N`, `${number(row.rated_force_n)} N`, Math.min(row.bending_margin, row.contact_margin)] : [row.shaft, `${number(row.peak_torque_nm)} N m`, `${number(row.rated_torque_nm)} N m`, row.margin];
  const rows = [...head.meshes, ...head.shafts].map(share).map(([name, ...cells]) => made("tr", {}, made("th", {scope: "row", textContent: name}), ...cells.map(value => made("td", {textContent: typeof value === "string" ? value : ratio(value)}))));
  at("window-peaks").replaceChildren(made("table", {}, made("thead", {}, made("tr", {}, ...["part", "peak tangential force F_t, or torque", "sized for", "least margin"].map(textContent => made("th", {scope: "col", textContent})))), made("tbody", {}, ...rows)));
  draw();
}

function draw() {
  const one = found?.head.series.find(line => line.name === at("window-of").value);
  if (one) plot(at("window-plot"), {x: found.column("time"), xLabel: "time [s]", yLabel: `${one.what ? `${one.what}, ` : ""}${one.name} [${one.unit || "-"}]`, lines: [{label: one.name, values: found.column(one.name)}]});
}

at("window-of").addEventListener("change", draw);
