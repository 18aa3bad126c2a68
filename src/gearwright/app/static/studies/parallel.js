/* Parallel coordinates: a line for every design; a brush on an axis, or its numbers below, keeps a part. */
import {at, made, number} from "/static/made.js";
import {ink} from "/static/plots.js";
import {held, title} from "/static/studies/table.js";

const SVG = at("axes").namespaceURI, TOP = 45, BOTTOM = 22, SIDE = 56, GRIP = 14;

function shape(tag, properties) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(properties)) element.setAttribute(name, value);
  return element;
}

export class Parallel {
  constructor(box, limits, table, changed) {
    Object.assign(this, {box, limits, table, changed, brushes: new Map()});
    this.ranges = new Map(table.columns.map(name => {
      const values = table.rows.map(row => row.values[name]).filter(Number.isFinite), low = Math.min(...values), high = Math.max(...values);
      return [name, low === high ? [low - 1, high + 1] : [low, high]];
    }));
    this.canvas = made("canvas", {ariaHidden: "true"});
    this.svg = shape("svg", {"aria-hidden": "true"});
    box.replaceChildren(this.canvas, this.svg);
    box.watch?.disconnect();
    box.watch = new ResizeObserver(() => this.draw());
    box.watch.observe(box);
    this.inputs();
    this.draw();
  }

  kept() {
    return this.table.rows.filter(row => [...this.brushes].every(([name, [low, high]]) => row.values[name] >= low && row.values[name] <= high));
  }

  /* The same limits as numbers, for who has no pointer. */
  inputs() {
    const rows = this.table.columns.map(name => {
      const fields = [0, 1].map(side => {
        const field = made("input", {inputMode: "decimal", ariaLabel: `${title(name)}, ${side ? "at most" : "at least"}`, placeholder: number(this.ranges.get(name)[side])});
        field.dataset.column = name;
        field.addEventListener("change", () => this.typed(name, side, field.value));
        return field;
      });
      return made("tr", {}, made("th", {scope: "row", textContent: title(name), title: name}), made("td", {}, fields[0]), made("td", {}, fields[1]));
    });
    this.limits.replaceChildren(made("table", {}, made("caption", {textContent: "Limits of what is kept"}), made("thead", {}, made("tr", {}, ...["", "at least", "at most"].map(textContent => made("th", {scope: "col", textContent})))), made("tbody", {}, ...rows)));
  }

  typed(name, side, text) {
    const brush = [...(this.brushes.get(name) || [-Infinity, Infinity])], value = text.trim() === "" ? NaN : Number(text);
    brush[side] = Number.isFinite(value) ? value : side ? Infinity : -Infinity;
    this.brush(name, brush);
  }

  brush(name, brush) {
    if (!brush || (brush[0] === -Infinity && brush[1] === Infinity)) this.brushes.delete(name);
    else this.brushes.set(name, brush);
    const [low, high] = [...this.limits.querySelectorAll("input")].filter(field => field.dataset.column === name), now = this.brushes.get(name) || [-Infinity, Infinity];
    low.value = Number.isFinite(now[0]) ? number(now[0], 6) : "";
    high.value = Number.isFinite(now[1]) ? number(now[1], 6) : "";
    this.draw();
    this.changed(this.kept());
  }

  x(k) { return SIDE + (k / Math.max(1, this.table.columns.length - 1)) * (this.box.clientWidth - 2 * SIDE); }

  y(name, value) {
    const [low, high] = this.ranges.get(name), tall = this.box.clientHeight - TOP - BOTTOM;
    return TOP + tall * (1 - (Math.min(high, Math.max(low, value)) - low) / (high - low));
  }

  value(name, y) {
    const [low, high] = this.ranges.get(name), tall = this.box.clientHeight - TOP - BOTTOM;
    return low + (1 - (y - TOP) / tall) * (high - low);
  }

  draw() {
    const {clientWidth: width, clientHeight: height} = this.box, ratio = devicePixelRatio || 1;
    if (!width || !height) return;
    [this.canvas.width, this.canvas.height] = [width * ratio, height * ratio];
    const pen = this.canvas.getContext("2d"), kept = new Set(this.kept()), {columns, rows} = this.table;
    pen.scale(ratio, ratio);
    const order = [...rows].sort((a, b) => kept.has(a) - kept.has(b) || a.front - b.front);
    for (const row of order) {
      const inside = kept.has(row);
      pen.strokeStyle = !inside ? ink("--hair") : row.front ? "#d55e00" : held(this.table, row) ? "#0072b2" : "#8c97a3";
      pen.globalAlpha = inside ? (row.front ? 1 : Math.max(0.12, Math.min(0.8, 60 / rows.length))) : 0.5;
      pen.lineWidth = row.front && inside ? 1.8 : 1;
      pen.beginPath();
      columns.forEach((name, k) => pen.lineTo(this.x(k), this.y(name, row.values[name])));
      pen.stroke();
    }
    this.svg.replaceChildren(...columns.flatMap((name, k) => this.axis(name, k)));
  }

  axis(name, k) {
    const x = this.x(k), bottom = this.box.clientHeight - BOTTOM, [low, high] = this.ranges.get(name), brush = this.brushes.get(name);
    const word = (text, y) => Object.assign(shape("text", {x, y, "text-anchor": "middle"}), {textContent: text});
    const found = [shape("line", {class: "axis", x1: x, x2: x, y1: TOP, y2: bottom}), this.heading(name, k), word(number(high), TOP - 2), word(number(low), bottom + 13)];
    if (brush) found.push(shape("rect", {class: "brush", x: x - 6, width: 12, y: this.y(name, brush[1]), height: Math.max(2, this.y(name, brush[0]) - this.y(name, brush[1]))}));
    const grip = shape("rect", {class: "grip", x: x - GRIP, width: 2 * GRIP, y: TOP, height: bottom - TOP, "data-column": name});
    grip.addEventListener("pointerdown", event => this.drag(name, event));
    return [...found, grip];
  }

  /* In three heights, and at both ends inside the picture. */
  heading(name, k) {
    const last = this.table.columns.length - 1, anchor = k === 0 ? "start" : k === last ? "end" : "middle";
    return Object.assign(shape("text", {x: k === 0 ? 4 : k === last ? this.box.clientWidth - 4 : this.x(k), y: 10 + 11 * (k % 3), "text-anchor": anchor}), {textContent: title(name)});
  }

  /* Down and up again keeps what lies between; a click alone keeps all of the axis. */
  drag(name, begun) {
    const from = begun.clientY - this.box.getBoundingClientRect().top;
    const moved = event => {
      const to = event.clientY - this.box.getBoundingClientRect().top;
      if (Math.abs(to - from) > 3) this.brush(name, [this.value(name, Math.max(from, to)), this.value(name, Math.min(from, to))]);
    };
    const ended = event => {
      removeEventListener("pointermove", moved);
      removeEventListener("pointerup", ended);
      if (Math.abs(event.clientY - this.box.getBoundingClientRect().top - from) <= 3) this.brush(name, null);
    };
    addEventListener("pointermove", moved);
    addEventListener("pointerup", ended);
    begun.preventDefault();
  }
}
