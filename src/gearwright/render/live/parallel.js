/* Cases across parallel axes: a stretch of an axis, drawn or written, leaves the lines, rows and points that lie in it. */
function liveParallel(figure, given, arrays) {
  const SPACE = "http://www.w3.org/2000/svg", WIDE = 1000, HIGH = 300, SIDE = 60, TOP = 12;
  const make = (tag, more = {}, text = "") => { const part = document.createElement(tag); for (const [name, value] of Object.entries(more)) part.setAttribute(name, value); part.textContent = text; return part; };
  const draw = (tag, more) => { const part = document.createElementNS(SPACE, tag); for (const [name, value] of Object.entries(more)) part.setAttribute(name, value); return part; };
  const called = label => label.split("\n")[0].split(": ")[0].trim();
  const columns = given.v.map(place => arrays[place]), count = columns[0].length, names = given.n;
  const ends = columns.map(values => [Math.min(...values), Math.max(...values)]), span = ends.map(([low, high]) => high - low || 1);
  const across = k => SIDE + (k * (WIDE - 2 * SIDE)) / (names.length - 1), up = (k, value) => TOP + HIGH * (1 - (value - ends[k][0]) / span[k]);
  const value = (k, y) => ends[k][0] + span[k] * (1 - (y - TOP) / HIGH), shown = number => String(+number.toPrecision(5));
  const ranges = names.map(() => null), picture = draw("svg", { viewBox: `0 0 ${WIDE} ${HIGH + 2 * TOP}`, class: "live-parallel", "aria-hidden": "true" });
  const lines = given.i.map(row => [row, picture.appendChild(draw("polyline", { points: columns.map((values, k) => `${across(k).toFixed(1)},${up(k, values[row]).toFixed(1)}`).join(" "), class: given.e.includes(row) ? "chosen" : "" }))]);
  const boxes = names.map((_, k) => { picture.append(draw("line", { x1: across(k), x2: across(k), y1: TOP, y2: TOP + HIGH })); return picture.appendChild(draw("rect", { x: across(k) - 9, width: 18, y: 0, height: 0 })); });
  const list = make("div", { class: "live-ranges" }), note = make("p", { class: "live-stretch", role: "status" }), section = figure.closest("section");
  const fields = names.map((name, k) => {
    const group = list.appendChild(make("fieldset")), title = group.appendChild(make("legend", {}, name));
    return ["least", "most"].map((which, end) => {
      const field = group.appendChild(make("input", { type: "number", step: "any", "aria-label": `${which} ${name}`, placeholder: shown(ends[k][end]) }));
      field.addEventListener("change", () => { const [least, most] = fields[k].map((one, e) => (one.value === "" ? ends[k][e] : Number(one.value))); set(k, fields[k].every(one => one.value === "") ? null : [least, most]); });
      return field;
    });
  });
  const inside = (k, number) => !ranges[k] || (number >= ranges[k][0] - 5e-4 * span[k] && number <= ranges[k][1] + 5e-4 * span[k]);
  const isKept = row => names.every((_, k) => inside(k, columns[k][row]));

  /* Tables of the chapter whose columns are called as axes, and its figures over two of them. */
  const heading = head => { const copy = head.cloneNode(true); for (const part of copy.querySelectorAll("button, .unit, .word")) part.remove(); return copy.textContent.trim() + (head.dataset.u ? ` [${head.dataset.u}]` : ""); };
  const number = cell => Number(cell.dataset.v ?? cell.textContent.replace("\u2212", "-"));
  function tables() {
    for (const table of section.querySelectorAll("table")) {
      const heads = table.tHead ? [...table.tHead.rows[0].cells].map(heading) : [], places = names.map(name => heads.indexOf(called(name)));
      if (places.filter(place => place >= 0).length < 2) continue;
      for (const row of table.tBodies[0].rows) row.hidden = !places.every((place, k) => place < 0 || Number.isNaN(number(row.cells[place])) || inside(k, number(row.cells[place])));
    }
  }
  function points(kept) {
    for (const plot of livePlots.filter(plot => plot.root.closest("section") === section)) {
      const [x, y] = plot.labels.map(label => names.findIndex(name => called(name) === called(label)));
      if (x < 0 || y < 0) continue;
      const near = (row, a, b) => Math.abs(columns[x][row] - a) < 1e-3 * span[x] && Math.abs(columns[y][row] - b) < 1e-3 * span[y], every = [...Array(count).keys()];
      plot.kept = kept.length === count ? null : (a, b) => kept.some(row => near(row, a, b)) || !every.some(row => near(row, a, b));
      plot.redraw();
    }
  }
  function set(k, range) {
    ranges[k] = range;
    fields[k].forEach((field, end) => { field.value = range ? shown(range[end]) : ""; });
    const [low, high] = range || [0, 0], top = range ? up(k, high) : 0;
    boxes[k].setAttribute("y", top);
    boxes[k].setAttribute("height", range ? Math.max(1, up(k, low) - top) : 0);
    const kept = [...Array(count).keys()].filter(isKept), among = new Set(kept);
    for (const [row, line] of lines) line.classList.toggle("out", !among.has(row));
    note.textContent = kept.length < count ? `${kept.length} of ${count} cases lie in the stretches; empty the fields, or click the axes, to see all` : "";
    tables();
    points(kept);
  }
  let held = null;
  const place = event => { const box = picture.getBoundingClientRect(); return [((event.clientX - box.left) / box.width) * WIDE, Math.min(TOP + HIGH, Math.max(TOP, ((event.clientY - box.top) / box.height) * (HIGH + 2 * TOP)))]; };
  picture.addEventListener("pointerdown", event => {
    const [x, y] = place(event), k = names.reduce((best, _, other) => (Math.abs(across(other) - x) < Math.abs(across(best) - x) ? other : best), 0);
    held = { k, y };
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener("pointermove", event => { if (held && Math.abs(place(event)[1] - held.y) > 3) set(held.k, [value(held.k, place(event)[1]), value(held.k, held.y)].sort((a, b) => a - b)); });
  picture.addEventListener("pointerup", event => { if (held && Math.abs(place(event)[1] - held.y) <= 3) set(held.k, null); held = null; });
  picture.addEventListener("pointercancel", () => { held = null; });
  const whole = make("div", { class: "live-grid" });
  whole.append(picture, list, note);
  whole.style.setProperty("--columns", 1);
  figure.prepend(whole);
  figure.classList.add("is-live");
}
