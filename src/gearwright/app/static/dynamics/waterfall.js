/* Spectra of one force over speed as a map, with the orders named; what lies under the pointer is told. */
import {at, made, number} from "/static/made.js";
import {ink} from "/static/plots.js";

const DECADES = 3, FRAME = {left: 58, top: 10, right: 120, bottom: 34};
let found = null;

export function waterfall(given) {
  found = given;
  at("waterfall-of").replaceChildren(...found.head.lines.map(name => new Option(name, name)));
  at("waterfall-of").value = found.head.loudest[0]?.line || found.head.lines[0];
  at("loudest").textContent = found.head.loudest.map(row => `${row.line} swings most at ${number(row.speed_rpm)} rpm: ${number(row.swing_n)} N about ${number(row.mean_n)} N, ${row.order}`).join("; ");
  draw();
}

/* The map as numbers: the largest amplitude in each cell, up to the highest frequency that shows. */
function cells(line, tall) {
  const factor = found.column("factor"), frequency = found.column("frequency"), all = found.column(`amplitude ${line}`), wide = frequency.length;
  let most = 0, last = 1;
  for (const value of all) most = Math.max(most, value);
  for (let k = 0; k < all.length; k++) if (all[k] > most * 10 ** -DECADES) last = Math.max(last, k % wide);
  const end = Math.min(wide, Math.ceil(1.05 * last) + 2), grid = new Float32Array(factor.length * tall);
  for (let s = 0; s < factor.length; s++) for (let k = 0; k < end; k++) {
    const row = Math.min(tall - 1, Math.floor((k / end) * tall));
    grid[s * tall + row] = Math.max(grid[s * tall + row], all[s * wide + k]);
  }
  return {grid, most, top: frequency[end - 1], factor};
}

const shade = share => {
  const stops = [[245, 247, 249], [140, 190, 225], [0, 114, 178], [8, 38, 70]], place = Math.min(0.9999, Math.max(0, share)) * 3, k = Math.floor(place), part = place - k;
  return stops[k].map((from, c) => Math.round(from + part * (stops[k + 1][c] - from)));
};

function draw() {
  const canvas = at("waterfall"), line = at("waterfall-of").value;
  if (!found || !line || !canvas.clientWidth) return;
  const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight, tall = Math.max(40, height - FRAME.top - FRAME.bottom), map = cells(line, Math.min(240, tall));
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  const pen = canvas.getContext("2d"), wide = width - FRAME.left - FRAME.right, count = map.factor.length, rows = Math.min(240, tall);
  pen.scale(ratio, ratio);
  const x = value => FRAME.left + ((value - map.factor[0]) / (map.factor[count - 1] - map.factor[0])) * wide, y = value => FRAME.top + tall * (1 - value / map.top);
  for (let s = 0; s < count; s++) for (let r = 0; r < rows; r++) {
    const value = map.grid[s * rows + r];
    pen.fillStyle = `rgb(${shade(value > 0 ? 1 + Math.log10(value / map.most) / DECADES : 0).join()})`;
    pen.fillRect(FRAME.left + (s / count) * wide, FRAME.top + tall * (1 - (r + 1) / rows), wide / count + 0.6, tall / rows + 0.6);
  }
  pen.fillStyle = pen.strokeStyle = ink("--ink");
  pen.font = "11px system-ui, sans-serif";
  for (let k = 0; k <= 4; k++) {
    pen.fillText(`${(map.top * k / 4000).toPrecision(3)}`, 24, y(map.top * k / 4) + 4);
    const at_ = map.factor[0] + (map.factor[count - 1] - map.factor[0]) * k / 4;
    pen.fillText(String(Math.round(at_ * found.head.rpm)), x(at_) - 14, height - 18);
  }
  pen.fillText(`speed of ${found.head.shaft} [rpm]`, FRAME.left + wide / 2 - 60, height - 4);
  pen.fillText("kHz", 2, FRAME.top + 10);
  let free = Infinity;
  for (const order of [...found.head.orders].sort((a, b) => a.frequency - b.frequency)) {
    const end = y(order.frequency * map.factor[count - 1]);
    if (end < FRAME.top || end > free - 11) continue;
    pen.fillText(order.name, FRAME.left + wide + 4, end + 3);
    free = end;
  }
  canvas.map = {...map, wide, tall, rows};
}

at("waterfall").addEventListener("pointermove", event => {
  const {map} = at("waterfall");
  if (!map) return;
  const s = Math.floor(((event.offsetX - FRAME.left) / map.wide) * map.factor.length), r = Math.floor((1 - (event.offsetY - FRAME.top) / map.tall) * map.rows);
  if (s < 0 || r < 0 || s >= map.factor.length || r >= map.rows) return;
  const frequency = ((r + 0.5) / map.rows) * map.top, factor = map.factor[s], order = [...found.head.orders].sort((a, b) => Math.abs(a.frequency * factor - frequency) - Math.abs(b.frequency * factor - frequency))[0];
  at("waterfall-read").textContent = `${number(factor * found.head.rpm)} rpm, ${number(frequency)} Hz: ${number(map.grid[s * map.rows + r])} N; nearest order ${order?.name || "none"}`;
});
at("waterfall-of").addEventListener("change", draw);
new ResizeObserver(draw).observe(at("waterfall"));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
