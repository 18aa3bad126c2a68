/* Lines that a reader zooms into and measures: uPlot in the colours of the page, with a common cursor and a mark. */
/* global uPlot */
import {keyed} from "/static/keyed.js";
import {made} from "/static/made.js";

let loaded = null;
const drawn = new Set();
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#b35a94", "#2b8cbe", "#b07a00", "#6a6f76", "#8c564b"];

/* Fifty kilobytes that nobody waits for who does not look. */
export function library() {
  loaded ??= new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = "/static/uplot/uplot.min.js";
    script.addEventListener("load", done);
    script.addEventListener("error", () => failed(new Error("uplot.min.js does not load")));
    document.head.append(script);
  });
  return loaded;
}

export const colour = k => COLOURS[k % COLOURS.length];
export const ink = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function axis(label, options = {}) {
  return {
    label, stroke: () => ink("--ink"), font: "11px system-ui, sans-serif", labelFont: "11px system-ui, sans-serif", labelSize: 16, size: options.size || 34,
    grid: {stroke: () => ink("--hair"), width: 1}, ticks: {stroke: () => ink("--hair"), width: 1, size: 4}, ...options,
  };
}

/* A plot in a box of the page. `lines`: {label, values, colour, dash, unit}; `marks`: draws on the canvas after the lines. */
export function plot(box, {x, xLabel, yLabel, lines, sync = "", log = false, legend = true, marks = null, moved = null, yRange = null, xRange = null, zoomed = null}) {
  const short = value => (value === null || value === undefined ? "–" : Number(value.toPrecision(5)).toString());
  const old = [...drawn].find(one => one.box === box);
  if (old) { old.watch.disconnect(); old.plot.destroy(); drawn.delete(old); }
  box.replaceChildren();
  const series = [{label: xLabel, value: (_, value) => short(value)}, ...lines.map((line, k) => ({
    label: line.unit ? `${line.label} [${line.unit}]` : line.label, stroke: line.colour || colour(k), width: line.width || 1.2, dash: line.dash, points: {show: false},
    value: (_, value) => short(value), spanGaps: false,
  }))];
  const made_ = new uPlot({
    width: Math.max(160, box.clientWidth), height: Math.max(120, box.clientHeight - (legend ? 26 : 0)), series,
    scales: {x: {time: false, ...(xRange ? {range: xRange} : {})}, y: {distr: log ? 3 : 1, ...(yRange ? {range: yRange} : {})}},
    axes: [axis(xLabel, {size: 30}), axis(yLabel, {size: 56})],
    legend: {show: legend, live: true}, cursor: {sync: sync ? {key: sync} : undefined, drag: {x: true, y: false}, points: {size: 6}},
    hooks: {draw: marks ? [marks] : [], setCursor: moved ? [moved] : [], setScale: zoomed ? [zoomed] : []},
  }, [x, ...lines.map(line => line.values)], box);
  const watch = new ResizeObserver(() => {
    if (box.clientWidth && box.clientHeight) made_.setSize({width: box.clientWidth, height: Math.max(120, box.clientHeight - (legend ? Math.min(80, made_.root.querySelector(".u-legend").offsetHeight) : 0))});
  });
  watch.observe(box);
  drawn.add({box, plot: made_, watch});
  keyed(box, made_, `${yLabel} over ${xLabel}`);
  box.dataset.points = String(x.length);
  return made_;
}

/* A mark that a click sets, and how far the cursor is from it. */
export function measure(plots, output, unit, told) {
  let mark = null;
  for (const one of plots) {
    one.mark = () => {
      mark = one.cursor.left < 0 ? null : one.posToVal(one.cursor.left, "x");
      for (const other of plots) other.redraw(false);
    };
    one.over.addEventListener("click", one.mark);
    (one.hooks.draw ??= []).push(() => mark !== null && upright(one, mark, ink("--accent")));
    (one.hooks.setCursor ??= []).push(() => {
      if (one.cursor.left < 0 || !(one.keys || one.cursor.event?.target === one.over)) return;
      const at = one.posToVal(one.cursor.left, "x");
      output.textContent = mark === null ? `${at.toPrecision(5)} ${unit}; click to measure from here` : told(mark, at);
    });
  }
}

export function upright(plot_, at, stroke, dash = []) {
  const pen = plot_.ctx, left = Math.round(plot_.valToPos(at, "x", true));
  if (left < plot_.bbox.left || left > plot_.bbox.left + plot_.bbox.width) return null;
  pen.save();
  pen.strokeStyle = stroke;
  pen.setLineDash(dash);
  pen.beginPath();
  pen.moveTo(left, plot_.bbox.top);
  pen.lineTo(left, plot_.bbox.top + plot_.bbox.height);
  pen.stroke();
  pen.restore();
  return left;
}

export function word(plot_, text, left, top, stroke, slanted = false) {
  const pen = plot_.ctx, size = 10 * devicePixelRatio;
  pen.save();
  pen.fillStyle = stroke;
  pen.font = `${size}px system-ui, sans-serif`;
  pen.translate(left, top);
  if (slanted) pen.rotate(-Math.PI / 2);
  pen.fillText(text, 0, 0);
  pen.restore();
}

/* Colours follow the scheme of the system. */
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { for (const one of drawn) one.plot.redraw(); });

/* Boxes by name, of which some are chosen. */
export function choice(box, names, chosen, changed) {
  box.replaceChildren(...names.map((name, k) => {
    const input = made("input", {type: "checkbox", checked: chosen.has(name), name});
    input.addEventListener("change", () => { if (input.checked) chosen.add(name); else chosen.delete(name); changed(); });
    return made("label", {}, input, ` ${name}`);
  }));
}
