/* Natural frequencies and orders over speed; what lies under the pointer is named, with its separation margin. */
import {at, made, number} from "/static/made.js";
import {ink, plot, upright, word} from "/static/plots.js";

const KINDS = {mesh: ["--room", []], shaft: ["#6a6f76", [2, 4]], machine: ["#b35a94", [6, 4]]}, NEAR = 14;

export function campbell({head, column}) {
  const factor = column("factor"), all = column("frequency"), speeds = factor.map(value => value * head.rpm), count = factor.length;
  const modes = Array.from({length: head.modes}, (_, k) => all.subarray(k * count, (k + 1) * count));
  const criticals = [...head.critical_speeds, ...head.orders_of_machines].filter(row => row.frequency_hz !== null), main = head.critical_speeds;
  const highest = 1.12 * Math.max(...(main.filter(row => row.dynamic_force_percent >= 0.1).concat(main.slice(0, 3))).map(row => row.frequency_hz), 100);
  const drawing = {
    x: speeds, xLabel: `speed of ${head.shaft} [rpm]`, yLabel: "frequency [Hz]", legend: false, yRange: () => [0, highest],
    lines: modes.map((values, k) => ({label: `mode ${k + 1}`, values, colour: "#8c97a3", width: 1})),
    marks: one => { rays(one, head); dots(one, criticals); },
    moved: one => { const found = under(one, head, criticals, modes, speeds); if (found) at("campbell-read").textContent = found; },
  };
  window.campbell = {plot: plot(at("campbell"), drawing), criticals};
  table(criticals);
}

function rays(one, head) {
  const pen = one.ctx, {left, top, width, height} = one.bbox, [low, high] = [one.scales.x.min, one.scales.x.max];
  pen.save();
  pen.beginPath();
  pen.rect(left, top, width, height);
  pen.clip();
  for (const order of head.orders) {
    const [stroke, dash] = KINDS[order.kind];
    pen.strokeStyle = stroke.startsWith("--") ? ink(stroke) : stroke;
    pen.setLineDash(dash);
    pen.lineWidth = order.kind === "mesh" ? 1.4 : 0.7;
    pen.beginPath();
    for (const speed of [low, high]) pen.lineTo(one.valToPos(speed, "x", true), one.valToPos(order.frequency * speed / head.rpm, "y", true));
    pen.stroke();
  }
  pen.restore();
  const here = upright(one, head.rpm, ink("--ink"));
  if (here !== null) word(one, "operating", here + 4, top + height - 6 * devicePixelRatio, ink("--ink"));
  names(one, head, high);
}

/* Mesh orders are named where they leave the frame: on the right, or on top as far as there is room. */
function names(one, head, high) {
  const {left, top, width} = one.bbox, unit = devicePixelRatio;
  let free = left;
  for (const order of head.orders.filter(order => order.kind === "mesh").sort((a, b) => b.frequency - a.frequency)) {
    const end = order.frequency * high / head.rpm, right = end <= one.scales.y.max;
    const x = right ? left + width - 6.2 * order.name.length * unit : one.valToPos(one.scales.y.max * head.rpm / order.frequency, "x", true) - 2 * unit;
    if (!right && x < free) continue;
    word(one, order.name, x, right ? one.valToPos(end, "y", true) - 5 * unit : top + 12 * unit, ink(KINDS.mesh[0]));
    free = x + 6.4 * order.name.length * unit;
  }
}

const size = row => Math.max(2.5, 8 * Math.sqrt(Math.min(2, row.dynamic_force_percent / 100)));

function dots(one, criticals) {
  const pen = one.ctx;
  for (const row of criticals) {
    if (row.speed_rpm > one.scales.x.max || row.frequency_hz > one.scales.y.max) continue;
    pen.fillStyle = row.why ? "#ffffff00" : "#d55e00";
    pen.strokeStyle = "#d55e00";
    pen.beginPath();
    pen.arc(one.valToPos(row.speed_rpm, "x", true), one.valToPos(row.frequency_hz, "y", true), size(row) * devicePixelRatio, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  }
}

const apart = row => `${row.separation_margin_percent > 0 ? "+" : "−"}${number(Math.abs(row.separation_margin_percent), 3)} %`;

const said = row => `mode ${row.mode} at ${number(row.frequency_hz)} Hz meets ${row.order}${row.why ? ` (${row.why})` : ""} at ${number(row.speed_rpm)} rpm: separation margin ${apart(row)}, force amplitude ${number(row.dynamic_force_percent, 3)} % of the mean, ${row.verdict}`;

/* What is nearest to the pointer: a critical speed, else a natural frequency, with the order that comes nearest to it. */
function under(one, head, criticals, modes, speeds) {
  const {left, top} = one.cursor;
  if (left < 0) return "";
  const off = row => Math.hypot(one.valToPos(row.speed_rpm, "x") - left, one.valToPos(row.frequency_hz, "y") - top);
  const nearest = [...criticals].sort((a, b) => off(a) - off(b))[0];
  if (nearest && off(nearest) < NEAR) return said(nearest);
  const rpm = one.posToVal(left, "x"), k = one.cursor.idx ?? 0;
  const found = modes.map((values, mode) => ({mode, value: values[k], off: Math.abs(one.valToPos(values[k], "y") - top)})).sort((a, b) => a.off - b.off)[0];
  const order = head.orders.map(given => ({...given, now: given.frequency * rpm / head.rpm})).sort((a, b) => Math.abs(a.now - found.value) - Math.abs(b.now - found.value))[0];
  return `mode ${found.mode + 1}: ${number(found.value)} Hz at ${number(speeds[k])} rpm; nearest order ${order.name} at ${number(order.now)} Hz (${number(100 * (order.now / found.value - 1), 3)} %)`;
}

function table(criticals) {
  const row = one => made("tr", {className: ["clear", "not excited", "no criterion"].includes(one.verdict) ? "" : "fails"}, made("th", {scope: "row", textContent: one.order}), ...[one.mode, `${number(one.frequency_hz)} Hz`, `${number(one.speed_rpm)} rpm`, apart(one), one.limit_percent === null ? "–" : `${number(one.limit_percent, 3)} %`, `${number(one.dynamic_force_percent, 3)} %`, one.verdict].map(textContent => made("td", {textContent})));
  at("criticals").replaceChildren(made("table", {}, made("caption", {textContent: "Critical speeds, the worst first"}),
    made("thead", {}, made("tr", {}, ...["order", "mode", "frequency", "critical speed n", "separation margin n_op/n − 1", "limit", "force", "verdict"].map(textContent => made("th", {scope: "col", textContent})))), made("tbody", {}, ...criticals.slice(0, 40).map(row))));
}
