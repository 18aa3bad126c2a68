/* Amplitudes over frequency of the end of a run; every mesh frequency and its multiples are named. */
import {at} from "/static/made.js";
import {choice, ink, plot, upright, word} from "/static/plots.js";

const ORDERS = 3, FLOOR = 1e-5;
const chosen = new Set();
let found = null, known = "", top = true;

/* Of rows of one set, which share a frequency, the set is named. */
function orders(meshes) {
  const names = new Map();
  for (const [mesh, frequency] of Object.entries(meshes)) {
    const place = frequency.toPrecision(7), stage = mesh.slice(0, mesh.lastIndexOf("."));
    if (!names.has(place)) names.set(place, stage || mesh);
  }
  return [...names].flatMap(([frequency, name]) => Array.from({length: ORDERS}, (_, k) => ({name: k ? `${name} × ${k + 1}` : `${name} mesh`, frequency: (k + 1) * Number(frequency)}))).sort((a, b) => a.frequency - b.frequency);
}

export function spectra(given) {
  found = given;
  const names = found.head.lines.filter(line => found.column(`spectrum ${line.name}`)).map(line => line.name);
  if (known !== names.join()) {
    known = names.join();
    chosen.clear();
    const forces = found.head.lines.filter(line => line.unit === "N");
    for (const family of new Set((forces.length ? forces : found.head.lines).map(line => line.family))) chosen.add(found.head.lines.find(line => line.family === family).name);
  }
  choice(at("spectrum-lines"), names, chosen, draw);
  draw();
}

function draw() {
  const frequency = found?.column("spectrum frequency");
  if (!frequency) return;
  const named = orders(found.head.meshes), last = 1.1 * Math.max(...named.map(order => order.frequency), 100), end = frequency.findIndex(value => value > last);
  const cut = values => values.subarray(1, end < 0 ? values.length : end), shown = [...chosen].filter(name => found.column(`spectrum ${name}`));
  const lines = shown.map(name => ({label: name, values: cut(found.column(`spectrum ${name}`))}));
  const most = Math.max(1e-9, ...lines.map(line => Math.max(...line.values)));
  plot(at("spectrum"), {
    x: cut(frequency), xLabel: "frequency [Hz]", yLabel: "amplitude [N or N m]", log: true, lines, yRange: () => [most * FLOOR, most * 2],
    marks: one => { top = true; for (const order of named) mark(one, order); },
    moved: one => read(one, named),
  });
  at("orders").textContent = `orders: ${named.filter(order => order.frequency <= last).map(order => `${order.name} ${Math.round(order.frequency)} Hz`).join(", ")}`;
}

function mark(one, order) {
  const left = upright(one, order.frequency, ink("--muted"), [2, 3]);
  if (left !== null) word(one, order.name, left + 11 * devicePixelRatio, one.bbox.top + one.bbox.height * (top ? 0.35 : 0.75), ink("--muted"), true);
  top = !top;
}

function read(one, named) {
  if (one.cursor.left < 0) return;
  const here = one.posToVal(one.cursor.left, "x"), near = [...named].sort((a, b) => Math.abs(a.frequency - here) - Math.abs(b.frequency - here))[0];
  if (near) at("spectrum-read").textContent = `${here.toPrecision(5)} Hz; nearest order: ${near.name} at ${near.frequency.toPrecision(5)} Hz`;
}
