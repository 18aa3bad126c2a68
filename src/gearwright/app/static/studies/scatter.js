/* Two numbers of every kept design: the front stands out, what breaks a limit is pale; a dot opens its design. */
import {at, number, told} from "/static/made.js";
import {ink} from "/static/plots.js";
import {held, title} from "/static/studies/table.js";

const FRAME = {left: 62, top: 10, right: 14, bottom: 34}, NEAR = 9;
let dots = [], last = null;

export function scatter(canvas, table, rows, {x, y, picked}) {
  last = {canvas, table, rows, x, y, picked};
  draw();
}

function draw() {
  if (!last?.canvas.clientWidth) return;
  const {canvas, table, rows, x, y} = last, ratio = devicePixelRatio || 1, {clientWidth: width, clientHeight: height} = canvas;
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  const pen = canvas.getContext("2d"), spread = name => {
    const values = rows.map(row => row.values[name]).filter(Number.isFinite), low = Math.min(...values), high = Math.max(...values), room = 0.05 * (high - low || Math.abs(high) || 1);
    return [low - room, high + room];
  };
  pen.scale(ratio, ratio);
  const [xs, ys] = [spread(x), spread(y)], wide = width - FRAME.left - FRAME.right, tall = height - FRAME.top - FRAME.bottom;
  const across = value => FRAME.left + ((value - xs[0]) / (xs[1] - xs[0])) * wide, up = value => FRAME.top + tall * (1 - (value - ys[0]) / (ys[1] - ys[0]));
  shade(pen, {x, y, across, up, table, xs, ys});
  pen.strokeStyle = ink("--hair");
  pen.strokeRect(FRAME.left, FRAME.top, wide, tall);
  pen.fillStyle = ink("--ink");
  pen.font = "11px system-ui, sans-serif";
  for (let k = 0; k <= 4; k++) {
    const [a, b] = [xs[0] + ((xs[1] - xs[0]) * k) / 4, ys[0] + ((ys[1] - ys[0]) * k) / 4];
    pen.textAlign = "center";
    pen.fillText(number(a), across(a), height - 19);
    pen.textAlign = "right";
    pen.fillText(number(b), FRAME.left - 4, up(b) + 4);
  }
  pen.textAlign = "center";
  pen.fillText(`${title(x)} across, ${title(y)} up`, FRAME.left + wide / 2, height - 4);
  dots = rows.map(row => ({row, left: across(row.values[x]), top: up(row.values[y])})).sort((a, b) => a.row.front - b.row.front);
  for (const {row, left, top} of dots) {
    pen.fillStyle = row.front ? "#d55e00" : held(table, row) ? "#0072b2" : "#b9bec5";
    pen.beginPath();
    pen.arc(left, top, row.front ? 5 : 3.5, 0, 2 * Math.PI);
    pen.fill();
  }
  canvas.dataset.dots = String(dots.length);
}

/* Where a limit of the study is broken. */
function shade(pen, {x, y, across, up, table, xs, ys}) {
  pen.fillStyle = ink("--bad-ground");
  for (const {column, minimum, maximum} of table.limits) {
    if (column === y && minimum !== null && minimum > ys[0]) pen.fillRect(across(xs[0]), up(Math.min(minimum, ys[1])), across(xs[1]) - across(xs[0]), up(ys[0]) - up(Math.min(minimum, ys[1])));
    if (column === y && maximum !== null && maximum < ys[1]) pen.fillRect(across(xs[0]), up(ys[1]), across(xs[1]) - across(xs[0]), up(Math.max(maximum, ys[0])) - up(ys[1]));
    if (column === x && minimum !== null && minimum > xs[0]) pen.fillRect(across(xs[0]), up(ys[1]), across(Math.min(minimum, xs[1])) - across(xs[0]), up(ys[0]) - up(ys[1]));
    if (column === x && maximum !== null && maximum < xs[1]) pen.fillRect(across(Math.max(maximum, xs[0])), up(ys[1]), across(xs[1]) - across(Math.max(maximum, xs[0])), up(ys[0]) - up(ys[1]));
  }
}

const under = event => dots.map(dot => ({...dot, off: Math.hypot(dot.left - event.offsetX, dot.top - event.offsetY)})).sort((a, b) => a.off - b.off).find(dot => dot.off < NEAR)?.row;

at("scatter").addEventListener("pointermove", event => {
  const row = under(event);
  if (row) at("scatter-read").textContent = `${row.design}: ${Object.entries(row.values).filter(([name]) => last.table.columns.includes(name)).map(([name, value]) => `${title(name)} ${told(name, value)}`).join(", ")}`;
});
at("scatter").addEventListener("click", event => { const row = under(event); if (row) last.picked(row); });
new ResizeObserver(draw).observe(at("scatter"));
