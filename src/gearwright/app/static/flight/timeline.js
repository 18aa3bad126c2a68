/* Histories of a flight, one under the other, with a common cursor; phases are named on the first. */
import {at, number} from "/static/made.js";
import {choice, ink, plot, upright, word} from "/static/plots.js";

const FIRST = ["altitude", "true airspeed", "propeller power", "fuel flow", "state of charge", "gearbox heat", "oil behind the gearbox"];
const chosen = new Set();
let found = null, known = "";

export function timeline(given) {
  found = given;
  const names = found.head.series.map(one => one.name);
  if (known !== names.join()) {
    known = names.join();
    chosen.clear();
    for (const name of FIRST) if (names.includes(name)) chosen.add(name);
    for (const one of found.head.series) if (one.group === "machines" || one.group === "shafts") chosen.add(one.name);
  }
  choice(at("flight-lines"), names, chosen, draw);
  draw();
}

/* Histories of one unit share a plot, but for those of the flight itself. */
function groups() {
  const all = new Map();
  for (const one of found.head.series.filter(one => chosen.has(one.name))) {
    const key = one.group === "flight" ? one.name : `${one.group} ${one.unit}`;
    all.set(key, [...(all.get(key) || []), one]);
  }
  return [...all.values()];
}

function draw() {
  if (!found) return;
  const time = found.column("time"), boxes = [], plots = [];
  at("timeline").replaceChildren(...groups().map(() => { const box = document.createElement("div"); box.className = "plot"; boxes.push(box); return box; }));
  for (const [k, group] of groups().entries()) {
    plots.push(plot(boxes[k], {
      x: time, xLabel: "time [min]", yLabel: `[${group[0].unit || "-"}]`, sync: "flight",
      lines: group.map(one => ({label: one.name, values: found.column(one.name)})), marks: one => phases(one, k === 0), moved: one => read(one),
      zoomed: (one, key) => { if (key === "x") together(plots, one); },
    }));
  }
}

/* All show the same stretch of time. */
function together(plots, from) {
  const {min, max} = from.scales.x;
  for (const one of plots) if (one !== from && (one.scales.x.min !== min || one.scales.x.max !== max)) one.setScale("x", {min, max});
}

function phases(one, named) {
  let free = -Infinity;
  for (const phase of found.head.stretches) {
    const left = upright(one, phase.start, ink("--hair"));
    if (!named || left === null || left < free) continue;
    word(one, phase.name, left + 3, one.bbox.top + 10 * devicePixelRatio, ink("--muted"));
    free = left + 6 * devicePixelRatio * phase.name.length;
  }
}

function read(one) {
  if (one.cursor.left < 0 || one.cursor.event?.target !== one.over) return;
  const here = one.posToVal(one.cursor.left, "x"), phase = found.head.stretches.find(part => part.start <= here && here < part.end);
  at("flight-read").textContent = `${number(here)} min${phase ? `, ${phase.name}` : ""}`;
}
