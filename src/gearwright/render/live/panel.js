"use strict";
/* One panel of a figure by uPlot: curves that a pointer follows, and beneath and above them all else that the still panel shows. */
const livePanel = (function () {
  const RATIO = () => window.devicePixelRatio || 1, DASH = { "--": [6, 3], ":": [1.5, 2.5] };
  let probe, looks = new Map();
  const css = name => (/^[a-z]+(-\d)?$/.test(name) && name !== "transparent" ? `var(--gw-${name})` : name);
  const colour = name => {
    const css = livePanel.css(name);
    if (!looks.has(css)) {
      probe ??= document.body.appendChild(Object.assign(document.createElement("i"), { hidden: true }));
      probe.style.color = css;
      looks.set(css, getComputedStyle(probe).color);
    }
    return looks.get(css);
  };
  const ink = colour;
  const forget = () => { looks = new Map(); };
  const shown = (value, digits = 6) => {
    if (value == null || Number.isNaN(value)) return "–";
    const size = Math.abs(value), text = size >= 1e7 || (size > 0 && size < 1e-4) ? value.toExponential(digits > 4 ? 1 : 2) : String(+value.toPrecision(digits));
    return text.replace(/-/g, "\u2212");
  };

  /* What is no curve: drawn by hand on the canvas, in the data's own units, inside the frame. */
  function draw(u, marks, arrays) {
    const { ctx, bbox } = u, ratio = RATIO(), scale = mark => (mark.z ? "z" : "y");
    const x = value => u.valToPos(value, "x", true), y = (value, mark) => u.valToPos(value, scale(mark), true);
    const pen = mark => { ctx.strokeStyle = colour(mark.s); ctx.lineWidth = mark.w * ratio * 1.3; ctx.setLineDash((DASH[mark.d] || []).map(step => step * ratio)); };
    const spot = (left, top, mark) => {
      const radius = mark.r * ratio * 1.33 * (mark.p === "." ? 0.5 : 1), corners = { "^": [[0, -1], [1, 1], [-1, 1]], v: [[0, 1], [1, -1], [-1, -1]], s: [[-1, -1], [1, -1], [1, 1], [-1, 1]], D: [[0, -1], [1, 0], [0, 1], [-1, 0]] }[mark.p];
      const dot = new Path2D();
      if (corners) { corners.forEach(([dx, dy]) => dot.lineTo(left + dx * radius, top + dy * radius)); dot.closePath(); } else dot.arc(left, top, radius, 0, 7);
      ctx.fillStyle = colour(mark.f);
      ctx.fill(dot);
      if (mark.e) { ctx.save(); ctx.setLineDash([]); ctx.lineWidth = ratio; ctx.strokeStyle = colour(mark.e); ctx.stroke(dot); ctx.restore(); }
    };
    const ways = {
      fill(mark) {
        const [across, low, high] = [arrays[mark.x], arrays[mark.y], arrays[mark.u]];
        ctx.beginPath();
        across.forEach((value, k) => ctx.lineTo(x(value), y(high[k], mark)));
        for (let k = across.length - 1; k >= 0; k--) ctx.lineTo(x(across[k]), y(low[k], mark));
        ctx.fillStyle = colour(mark.f);
        ctx.fill();
      },
      box(mark) {
        const [left, low, right, high] = mark.b;
        ctx.fillStyle = colour(mark.f || "transparent");
        ctx.fillRect(x(left), y(high, mark), x(right) - x(left), y(low, mark) - y(high, mark));
      },
      rule(mark) {
        const [low, high] = mark.b.map(value => (mark.o === "x" ? x(value) : y(value, mark)));
        if (low !== high) { ctx.fillStyle = colour(mark.s); mark.o === "x" ? ctx.fillRect(low, bbox.top, high - low, bbox.height) : ctx.fillRect(bbox.left, high, bbox.width, low - high); return; }
        pen(mark);
        ctx.beginPath();
        mark.o === "x" ? (ctx.moveTo(low, bbox.top), ctx.lineTo(low, bbox.top + bbox.height)) : (ctx.moveTo(bbox.left, low), ctx.lineTo(bbox.left + bbox.width, low));
        ctx.stroke();
      },
      path(mark) {
        pen(mark);
        ctx.beginPath();
        let broken = true;
        arrays[mark.x].forEach((value, k) => {
          const up = arrays[mark.y][k];
          if (value == null || up == null) { broken = true; return; }
          if (mark.p) {
            ctx.globalAlpha = (mark.a ?? 1) * (u.kept && !u.kept(value, up) ? 0.12 : 1);
            spot(x(value), y(up, mark), mark);
            ctx.globalAlpha = mark.a ?? 1;
          }
          if (mark.d !== "" || !mark.p) ctx[broken ? "moveTo" : "lineTo"](x(value), y(up, mark));
          broken = false;
        });
        ctx.stroke();
      },
      dots(mark) {
        arrays[mark.x].forEach((value, k) => {
          if (value == null || arrays[mark.y][k] == null) return;
          ctx.beginPath();
          ctx.arc(x(value), y(arrays[mark.y][k], mark), (mark.s[k] ?? mark.s[0]) * ratio * 1.33, 0, 7);
          ctx.fillStyle = colour(mark.f[mark.i[k] || 0]);
          ctx.fill();
          if (mark.e) { ctx.strokeStyle = colour(mark.e); ctx.lineWidth = ratio; ctx.setLineDash([]); ctx.stroke(); }
        });
      },
    };
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const mark of marks) if (ways[mark.k]) { ctx.globalAlpha = mark.a ?? 1; ways[mark.k](mark); }
    ctx.restore();
  }

  function words(u, marks) {
    const { ctx, bbox } = u, ratio = RATIO(), px = 1.333 * ratio;
    ctx.save();
    for (const mark of marks) {
      if (mark.k !== "word") continue;
      const [across, up, dx, dy] = mark.b, [ha, va, turned, size] = mark.j;
      const left = (mark.o[0] === "a" ? bbox.left + across * bbox.width : u.valToPos(across, "x", true)) + dx * px;
      const top = (mark.o[1] === "a" ? bbox.top + (1 - up) * bbox.height : u.valToPos(up, mark.z ? "z" : "y", true)) - dy * px;
      if (left < bbox.left - 1 || top < bbox.top - 90 * ratio || top > bbox.top + bbox.height + 2 || left > bbox.left + bbox.width + 90 * ratio) continue;
      if (mark.d) {
        Object.assign(ctx, { strokeStyle: colour(mark.e), lineWidth: 0.6 * ratio });
        ctx.beginPath();
        ctx.moveTo(u.valToPos(mark.d[0], "x", true), u.valToPos(mark.d[1], "y", true));
        ctx.lineTo(left, top);
        ctx.stroke();
      }
      ctx.save();
      ctx.translate(left, top);
      ctx.rotate((-turned * Math.PI) / 180);
      ctx.font = `${Math.max(size, 6.5) * px}px system-ui, sans-serif`;
      ctx.textAlign = ha;
      ctx.textBaseline = { center: "middle", baseline: "alphabetic" }[va] || va;
      ctx.fillStyle = colour(mark.f);
      mark.s.split("\n").forEach((line, k) => ctx.fillText(line, 0, k * size * px * 1.2));
      ctx.restore();
    }
    ctx.restore();
  }

  /* Stairs have two values at a place: joined with other curves the second one stands a hair beside the first. */
  const apart = values => {
    const hair = 1e-7;
    let last = -Infinity;
    return values.map(value => (last = value == null || value > last ? value : last + hair * Math.abs(last || 1)));
  };

  /* Curves with a common x, and the groups of them that one name of the legend stands for. */
  function curves(panel, arrays) {
    const tables = new Map(), series = [{}], groups = [];
    for (const mark of panel.m.filter(mark => mark.k === "line")) {
      if (!tables.has(mark.x)) tables.set(mark.x, []);
      tables.get(mark.x).push(mark);
    }
    const order = [...tables.values()].flat();
    order.forEach((mark, k) => {
      let group = mark.n ? null : groups.find(other => other.mark.s === mark.s && other.mark.d === mark.d);
      if (!group) groups.push(group = { mark, name: mark.n || "", places: [] });
      group.places.push(k + 1);
      series.push({
        label: mark.i || group.name, scale: mark.z ? "z" : "y", stroke: () => colour(mark.s), width: mark.w * 1.33, alpha: mark.a ?? 1, dash: DASH[mark.d], spanGaps: false,
        points: { show: !!mark.p, size: 2.66 * (mark.r || 2) * (mark.p === "." ? 0.5 : 1), fill: mark.f ? () => colour(mark.f) : undefined }, ...(mark.d === "" ? { paths: () => null } : {}),
      });
    });
    const data = !tables.size ? [] : uPlot.join([...tables].map(([x, marks]) => [apart(arrays[x]), ...marks.map(mark => arrays[mark.y])]));
    return { data: data.length ? data : [[...panel.x.a].sort((a, b) => a - b), [null, null]], series: data.length ? series : [{}, { scale: "y" }], groups };
  }

  /* Whole decades of a logarithmic axis, as many as there is room for; within one of them a few even steps. */
  function decades(u, side, low, high) {
    const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9), step = Math.max(1, Math.ceil((last - first) / 6));
    if (last <= first) return [0, 1, 2, 3].map(k => +(low + (k / 3) * (high - low)).toPrecision(3));
    return Array.from({ length: Math.floor((last - first) / step) + 1 }, (_, k) => 10 ** (first + k * step));
  }
  const power = value => { const high = Math.round(Math.log10(value)); return Math.abs(high) <= 3 || Math.abs(value / 10 ** high - 1) > 1e-6 ? shown(value, 3) : "10" + [...String(high)].map(digit => "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(digit)]).join(""); };

  function axis(given, more) {
    const marked = given.g && !given.v ? { splits: decades, filter: (u, splits) => splits, values: (u, splits) => splits.map(power) } : given.v ? { splits: given.v, values: (u, splits) => splits.map(value => given.w[given.v.indexOf(value)] ?? "") } : { values: (u, splits) => splits.map(value => (value == null ? "" : shown(value))) };
    return { stroke: () => ink("ink"), grid: { stroke: () => ink("hair"), width: 1 }, ticks: { stroke: () => ink("muted"), width: 1, size: 4 }, font: "12px system-ui, sans-serif",
      labelFont: "12px system-ui, sans-serif", labelSize: 18, label: given.l.split("\n")[0] || undefined, ...marked, ...more };
  }
  const wide = values => 12 + 7 * Math.max(1, ...(values || []).map(value => String(value || "").length));
  const upright = { size: (u, values) => Math.max(54, wide(values)), labelFont: "11px system-ui, sans-serif" };

  /* The options of uPlot for a panel; limits are those of the still figure until a reader zooms. */
  function options(panel, series, arrays, tell, brushed) {
    const scale = given => ({ time: false, auto: false, distr: given.g ? 3 : 1, min: Math.min(...given.a), max: Math.max(...given.a), dir: given.a[0] > given.a[1] ? -1 : 1, range: (u, low, high) => [low, high] });
    const axes = [axis(panel.x, { size: 26 }), axis(panel.y, { scale: "y", ...upright, label: panel.off ? " " : panel.y.l.replace("\n", " ") || " " })], scales = { x: scale(panel.x), y: scale(panel.y) };
    if (panel.z) { scales.z = scale(panel.z); axes.push(axis(panel.z, { scale: "z", side: 1, grid: { show: false }, ...upright })); }
    if (panel.off) axes.forEach(one => Object.assign(one, { stroke: "transparent", grid: { show: false }, ticks: { show: false }, values: () => [] }));
    if (panel.off) axes[0].size = 4;
    return {
      width: 320, height: panel.h + 50, series, axes, scales, legend: { show: false }, padding: [10 + panel.o[0], 16 + panel.aside, 0, 0], focus: { alpha: 1 },
      cursor: { drag: { x: true, y: true, uni: 24, setScale: true }, sync: { key: `${panel.x.l}|${panel.x.a}`, setSeries: false, scales: ["x", null] }, points: { size: 7 }, focus: { prox: 16 }, bind: { dblclick: u => () => { whole(u, panel); return null; } } },
      hooks: { drawAxes: [u => draw(u, panel.m, arrays)], draw: [u => words(u, panel.m)], setCursor: [u => tell(u)], setScale: [u => { if (u.status) brushed(u); }], setSeries: [(u, place) => { u.near = place; tell(u); }] },
    };
  }
  const whole = (u, panel) => u.batch(() => { for (const key of ["x", "y", "z"]) if (panel[key]) u.setScale(key, { min: Math.min(...panel[key].a), max: Math.max(...panel[key].a) }); });
  return { curves, options, whole, shown, css, forget };
})();
