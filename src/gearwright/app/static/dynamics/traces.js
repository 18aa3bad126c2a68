/* Forces and torques over time: the whole run or its end at every step, with a common cursor, zoom and a mark. */
import {at, number} from "/static/made.js";
import {choice, measure, plot} from "/static/plots.js";

const chosen = new Set();
let found = null, known = "";

export function traces(given) {
  found = given;
  const names = found.head.lines.map(line => line.name);
  if (known !== names.join()) {
    known = names.join();
    chosen.clear();
    for (const family of new Set(found.head.lines.map(line => line.family))) chosen.add(found.head.lines.find(line => line.family === family).name);
  }
  choice(at("trace-lines"), names, chosen, draw);
  const {head} = found, notes = [`${head.method}, ${number(head.step_s * 1e6)} µs a step, peaks to ${(100 * head.error).toPrecision(2)} %`, ...head.notes];
  at("run-notes").textContent = notes.join("; ");
  draw();
}

function draw() {
  if (!found) return;
  const part = at("stretch").value, time = found.column(`${part} time`);
  if (!time) return;
  const units = [["N", "forces", "force [N]"], ["N m", "torques", "torque [N m]"]], plots = [];
  for (const [unit, box, label] of units) {
    const shown = found.head.lines.filter(line => line.unit === unit && chosen.has(line.name));
    at(box).hidden = !shown.length;
    if (shown.length) plots.push(plot(at(box), {x: time, xLabel: "time [ms]", yLabel: label, sync: "run", lines: shown.map(line => ({label: line.name, values: found.column(`${part} ${line.name}`)}))}));
  }
  measure(plots, at("measured"), "ms", (mark, here) => {
    const apart = here - mark;
    return `${mark.toPrecision(5)} ms to ${here.toPrecision(5)} ms: Δt = ${apart.toPrecision(4)} ms, 1/Δt = ${(1000 / Math.abs(apart)).toPrecision(4)} Hz`;
  });
}

at("stretch").addEventListener("change", draw);
