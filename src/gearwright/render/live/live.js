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
    const bands = panel.m.filter(mark => mark.k === "fill" && mark.n), named = groups.filter(group => group.name);
    for (const [name, mark, group] of [...(named.length || bands.length || groups.length > 1 ? named : groups).map(group => [group.name, group.mark, group]), ...bands.map(mark => [mark.n, mark, null])]) {
      const item = list.appendChild(make(group ? "button" : "span", "live-name")), sample = item.appendChild(make("i", ""));
      sample.dataset.colour = group ? mark.s : mark.f;
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
    const at = (column, place) => { let k = place; while (k > 0 && column[k] === undefined) k--; return column[k]; };
    const within = (mark, value) => { const k = arrays[mark.x].findIndex(x => x > value) - 1; return k < 0 ? "" : `${livePanel.shown(arrays[mark.y][k], 4)} to ${livePanel.shown(arrays[mark.u][k], 4)}`; };
    list.tell = u => {
      const place = u.cursor.idx, out = place == null || u.cursor.left < 0, value = out ? null : u.posToVal(u.cursor.left, "x");
      across.textContent = out ? "" : `${panel.name} ${livePanel.shown(value, 5)}`;
      const close = u.near && u.series[u.near] && !out ? u.series[u.near] : null;
      near.textContent = close && close.label ? `${close.label}: ${livePanel.shown(at(u.data[u.near], place), 4)}` : "";
      for (const [mark, group, output] of values) output.textContent = out ? "" : group ? livePanel.shown(at(u.data[group.places[0]], place), 4).replace("–", "") : within(mark, value);
    };
    return list;
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
      const u = new uPlot(livePanel.options(panel, series, arrays, key.tell), data, area);
      key.plot = u;
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
