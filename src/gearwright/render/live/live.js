/* Every figure with curves, drawn anew where a reader points and zooms; the still one stays for paper and for those who do not see. */
const livePlots = [];
function liveFigures(given, bytes) {
  const plots = livePlots;
  const make = (tag, name, text = "") => Object.assign(document.createElement(tag), { className: name, textContent: text });

  function numbers() {
    const count = bytes.length / 2;
    let at = 0;
    return given.ranges.map(([length, low, high, power]) => {
      let step = 0;
      return Array.from({ length }, () => {
        step = (step + bytes[at] + 256 * bytes[count + at++]) & 65535;
        const value = low + (step / 16383) * (high - low);
        return step === 16384 ? null : power ? 10 ** value : value;
      });
    });
  }

  /* Names of curves with the values under the pointer, and the one that is nearest; a name hides and shows its curves. */
  function legend(panel, groups, arrays) {
    const list = make("p", "live-key"), across = list.appendChild(make("span", "live-at")), near = list.appendChild(make("span", "live-near")), values = [];
    const bands = panel.m.filter(mark => mark.k !== "line" && mark.n), named = groups.filter(group => group.name);
    for (const [name, mark, group] of [...(named.length || bands.length || groups.length > 1 ? named : groups).map(group => [group.name, group.mark, group]), ...bands.map(mark => [mark.n, mark, null])]) {
      const item = list.appendChild(make(group ? "button" : "span", "live-name")), sample = item.appendChild(make("i", ""));
      sample.dataset.colour = group || mark.k === "key" || mark.k === "path" ? (mark.p && mark.f) || mark.s : Array.isArray(mark.f) ? mark.f[0] : mark.f;
      sample.style.background = livePanel.css(sample.dataset.colour);
      item.append(name || panel.y.l || "value");
      values.push([mark, group, item.appendChild(make("output", ""))]);
      if (!group) continue;
      item.type = "button";
      item.setAttribute("aria-pressed", "true");
      item.addEventListener("click", () => {
        const show = item.getAttribute("aria-pressed") !== "true";
        item.setAttribute("aria-pressed", String(show));
        for (const place of group.places) list.plot.setSeries(place, { show });
      });
    }
    const shape = modeShape();
    const at = (column, place) => { let k = place; while (k > 0 && column[k] === undefined) k--; return column[k]; };
    const within = (mark, value) => { const k = arrays[mark.x].findIndex(x => x > value) - 1; return k < 0 ? "" : `${livePanel.shown(arrays[mark.y][k], 4)} to ${livePanel.shown(arrays[mark.u][k], 4)}`; };
    list.tell = u => {
      shape(u);
      const place = u.cursor.idx, out = place == null || u.cursor.left < 0, value = out ? null : u.posToVal(u.cursor.left, "x");
      across.textContent = out ? "" : `${panel.name} ${livePanel.shown(value, 5)}`;
      const close = u.near && u.series[u.near] && !out ? u.series[u.near] : null;
      near.textContent = close && close.label ? `${close.label}: ${livePanel.shown(at(u.data[u.near], place), 4)}` : "";
      for (const [mark, group, output] of values) output.textContent = out ? "" : group ? livePanel.shown(at(u.data[group.places[0]], place), 4).replace("–", "") : mark.k === "fill" ? within(mark, value) : "";
    };
    return list;
  }

  /* The mode whose curve is nearest: what the table of modes says of it, and its shape where the page draws it. */
  function modeShape() {
    const box = make("div", "live-shape");
    box.hidden = true;
    box.setAttribute("aria-hidden", "true");
    let last = 0;
    const said = number => {
      const table = [...document.querySelectorAll("table")].find(one => one.caption && one.caption.textContent.startsWith("Natural frequencies"));
      const within = words => { const [first, end] = words.split("–").map(Number); return number >= first && number <= (end || first); };
      const row = table && [...table.tBodies[0].rows].find(one => within(one.cells[0].textContent.trim()));
      return row ? `${row.cells[2].textContent} moves most; ${row.cells[3].textContent} holds ${row.cells[4].textContent} % of the energy` : "";
    };
    const drawn = number => {
      const title = document.getElementById("drawn-modes-title"), whole = title && title.parentNode;
      const heads = whole ? [...whole.querySelectorAll("text")].filter(text => /^\d+: /.test(text.textContent)) : [], place = heads.findIndex(text => parseInt(text.textContent, 10) === number);
      if (place < 0) return "";
      const [, , width, height] = whole.getAttribute("viewBox").split(" ").map(Number), top = text => Number(text.getAttribute("y")) - 100, next = heads[place + 1];
      const copy = whole.cloneNode(true);
      for (const part of copy.querySelectorAll("title, desc, defs")) part.remove();
      for (const name of ["width", "height", "aria-labelledby", "role"]) copy.removeAttribute(name);
      for (const text of copy.querySelectorAll("text")) for (const name of ["tabindex", "role"]) text.removeAttribute(name);
      copy.setAttribute("viewBox", `0 ${top(heads[place])} ${width} ${(next ? top(next) : height - 90) - top(heads[place])}`);
      return copy;
    };
    return u => {
      const close = u.near && u.cursor.left >= 0 && u.series[u.near] ? /^mode (\d+),/.exec(u.series[u.near].label || "") : null, number = close ? Number(close[1]) : 0;
      if (!box.parentNode) u.root.parentNode.append(box);
      box.hidden = !number;
      box.classList.toggle("left", u.cursor.left > u.bbox.width / devicePixelRatio / 2);
      if (number && number !== last) box.replaceChildren(make("p", "", said(number)), drawn(number));
      last = number || last;
    };
  }

  /* Zooming into a figure over two columns of a table of its chapter leaves the rows that are inside. */
  function brush(figure, panel) {
    const called = label => label.split("\n")[0].split(": ")[0].trim();
    const heading = head => { const copy = head.cloneNode(true); for (const part of copy.querySelectorAll("button, .unit, .word")) part.remove(); return copy.textContent.trim() + (head.dataset.u ? ` [${head.dataset.u}]` : ""); };
    const value = cell => Number(cell.dataset.v ?? cell.textContent.replace("\u2212", "-"));
    const within = (scale, number) => number >= scale.min - 1e-4 * Math.abs(scale.min) && number <= scale.max + 1e-4 * Math.abs(scale.max);
    const found = [];
    for (const table of figure.closest("section").querySelectorAll("table")) {
      const heads = table.tHead ? [...table.tHead.rows[0].cells].map(heading) : [], [x, y] = [panel.x.l, panel.y.l].map(label => heads.indexOf(called(label)));
      if (x >= 0 && y >= 0) found.push([table, x, y]);
    }
    const note = make("p", "live-brush");
    note.setAttribute("role", "status");
    return u => {
      for (const [table, x, y] of found) {
        const rows = [...table.tBodies[0].rows];
        for (const row of rows) row.hidden = !(within(u.scales.x, value(row.cells[x])) && within(u.scales.y, value(row.cells[y])));
        const kept = rows.filter(row => !row.hidden).length;
        if (!note.parentNode) table.parentNode.before(note);
        note.textContent = kept < rows.length ? `${kept} of ${rows.length} rows: those in the stretch of the figure that is shown; double-click the figure to see all` : "";
      }
    };
  }

  function keys(box, u, panel) {
    box.addEventListener("keydown", event => {
      const { left, top } = u.cursor, width = u.bbox.width / devicePixelRatio, step = event.shiftKey ? width / 10 : width / 100;
      const { min, max } = u.scales.x, middle = u.posToVal(left < 0 ? width / 2 : left, "x"), across = limits => uPlot.sync(u.cursor.sync.key).plots.forEach(mate => mate.setScale("x", limits));
      const zoom = factor => across({ min: middle - (middle - min) * factor, max: middle + (max - middle) * factor });
      const does = { ArrowRight: () => u.setCursor({ left: Math.min(width, Math.max(0, left) + step), top: Math.max(1, top) }), ArrowLeft: () => u.setCursor({ left: Math.max(0, left - step), top: Math.max(1, top) }),
        "+": () => zoom(0.5), "-": () => zoom(2), Escape: () => { livePanel.whole(u, panel); across({ min: Math.min(...panel.x.a), max: Math.max(...panel.x.a) }); } }[event.key];
      if (does && event.target === box) { event.preventDefault(); does(); }
    });
  }

  function show(figure, panels, arrays) {
    if (panels[0].k === "parallel") { liveParallel(figure, panels[0], arrays); return; }
    const grid = make("div", "live-grid"), narrow = () => figure.clientWidth < 620, columns = Math.max(...panels.map(panel => panel.c)) + 1;
    grid.style.setProperty("--columns", columns);
    figure.prepend(grid);
    for (const panel of panels) {
      const below = panels.filter(other => other.c === panel.c && other.x.l);
      const mates = panels.filter(other => other.c === panel.c);
      panel.aside = (mates.some(other => other.z) && !panel.z ? 72 : 0) + Math.max(...mates.map(other => (other.off ? 0 : other.o[1])));
      panel.name = (panel.x.l || (below.length ? below.at(-1).x.l : "")).split("\n")[0];
      const box = grid.appendChild(make("div", "live-panel")), { data, series, groups } = livePanel.curves(panel, arrays), key = legend(panel, groups, arrays), area = make("div", "live-area");
      if (panel.t) box.append(make("p", "live-title", panel.t));
      if (panel.off) key.replaceChildren(...panel.m.filter(mark => mark.k === "box" && mark.n).map(mark => { const item = make("span", "live-name", mark.n), sample = make("i", ""); sample.style.background = livePanel.css(mark.f); item.prepend(sample); return item; }));
      box.append(area, key, ...panel.x.l.split("\n").slice(1).map(line => make("p", "live-more", line)));
      if (!panel.off) area.tabIndex = 0;
      area.setAttribute("role", "group");
      area.setAttribute("aria-label", `${panel.t || panel.y.l || "panel"}: arrow keys move the pointer, plus and minus zoom, Escape shows all`);
      const u = new uPlot(livePanel.options(panel, series, arrays, key.tell, brush(figure, panel)), data, area);
      key.plot = u;
      u.labels = [panel.x.l, panel.y.l];
      keys(area, u, panel);
      const fit = () => u.setSize({ width: Math.max(200, Math.floor(area.clientWidth)), height: (panel.off ? panel.h + 8 : Math.max(120, Math.round(panel.h * (narrow() ? 0.9 : 1.1))) + 56) + panel.o[0] });
      fit();
      new ResizeObserver(fit).observe(area);
      plots.push(u);
    }
    figure.classList.add("is-live");
  }

  const arrays = numbers(), figures = Object.entries(given.figures).map(([id, panels]) => [document.getElementById(`live-${id}`), panels]).filter(([figure]) => figure);
  const watch = new IntersectionObserver(entries => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      watch.unobserve(target);
      show(target, figures.find(([figure]) => figure === target)[1], arrays);
    }
  }, { rootMargin: "600px" });
  for (const [figure] of figures) watch.observe(figure);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { livePanel.forget(); plots.forEach(plot => plot.redraw()); });
}
