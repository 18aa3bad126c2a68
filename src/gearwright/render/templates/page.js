"use strict";
/* What the page can do beside being read: sort its tables, show US units, open a number. Without it the page is whole. */
(function () {
  const US = {
    "mm": ["in", 1 / 25.4], "µm": ["µin", 1 / 0.0254], "m": ["ft", 1 / 0.3048], "mm²": ["in²", 1 / 645.16], "N": ["lbf", 1 / 4.4482216152605], "kN": ["lbf", 1e3 / 4.4482216152605],
    "N m": ["lbf ft", 1 / 1.3558179483314], "kN m": ["lbf ft", 1e3 / 1.3558179483314], "MPa": ["psi", 1e6 / 6894.757293168], "kW": ["hp", 1 / 0.74569987158227],
    "kg": ["lb", 1 / 0.45359237], "kg/h": ["lb/h", 1 / 0.45359237], "kW/kg": ["hp/lb", 0.45359237 / 0.74569987158227], "N m/kg": ["lbf ft/lb", 0.45359237 / 1.3558179483314],
    "kg m²": ["lb ft²", 1 / (0.45359237 * 0.3048 * 0.3048)], "N/µm": ["lbf/in", 25.4e3 / 4.4482216152605], "kN m/rad": ["lbf ft/rad", 1e3 / 1.3558179483314],
    "m/s": ["ft/s", 1 / 0.3048], "l": ["gal", 1 / 3.785411784], "l/min": ["gal/min", 1 / 3.785411784], "g/mm": ["lb/in", 25.4e-3 / 0.45359237], "kJ": ["Btu", 1 / 1.05505585262], "°C": ["°F", 1.8, 32],
  };
  const written = (number, digits) => {
    const size = Math.abs(number);
    if (size < 1e-9) return "0";
    const text = size >= 1e12 || size < 1e-3 ? number.toExponential(digits - 1) : size >= 10 ** (digits - 1) ? number.toFixed(0) : number.toPrecision(digits);
    return text.replace("-", "\u2212");
  };
  const inUS = (value, unit) => (US[unit] ? [value * US[unit][1] + (US[unit][2] || 0), US[unit][0]] : [value, unit]);
  const valueOf = cell => (cell.dataset.v !== undefined ? Number(cell.dataset.v) : Number.parseFloat(cell.textContent.replace("\u2212", "-").replace("∞", "Infinity")));
  const tables = [...document.querySelectorAll("table:has(thead)")].filter(table => !table.matches(".plain"));
  for (const table of tables) for (const name of table.classList) {
    const place = /^n(\d+)$/.exec(name);
    if (place) for (const row of table.tBodies[0].rows) { const cell = row.cells[place[1] - 1]; if (cell && cell.firstChild) cell.classList.add("n"); }
  }
  const unitAt = heads => heads.findIndex(head => head.textContent.trim().startsWith("unit"));
  const unitOf = (cell, heads) => {
    const head = heads[cell.cellIndex], beside = unitAt(heads), named = head && /^(value|limit)/.test(head.textContent.trim()) ? cell.parentNode.cells[beside] : null;
    return (head && head.dataset.u) || (named && (named.dataset.si ?? named.textContent)) || "";
  };

  /* Units. */
  function units(us) {
    for (const span of document.querySelectorAll(".q[data-u]")) {
      span.dataset.si ??= span.textContent;
      const unit = span.dataset.u || (span.nextElementSibling && span.nextElementSibling.dataset.u) || "";
      if (!US[unit]) continue;
      const [value, name] = inUS(Number(span.dataset.v), unit);
      span.textContent = us ? written(value, Number(span.dataset.d || 4)) + (span.dataset.u ? " " + name : "") : span.dataset.si;
    }
    for (const table of tables) {
      const heads = [...table.tHead.rows[0].cells], column = unitAt(heads);
      for (const head of heads) if (US[head.dataset.u]) head.querySelector(".unit").textContent = us ? US[head.dataset.u][0] : head.dataset.u;
      for (const cell of table.querySelectorAll("td.n")) {
        const unit = unitOf(cell, heads), text = cell.firstChild;
        if (!US[unit] || !text) continue;
        cell.dataset.si ??= text.data;
        cell.dataset.v ??= valueOf(cell);
        text.data = us ? written(inUS(Number(cell.dataset.v), unit)[0], 4) : cell.dataset.si;
        if (heads[cell.cellIndex].dataset.u || column < 0) continue;
        const named = cell.parentNode.cells[column];
        named.dataset.si ??= named.textContent;
        named.textContent = us ? US[unit][0] : unit;
      }
    }
  }
  const button = document.getElementById("units");
  button.parentNode.hidden = false;
  button.addEventListener("click", () => {
    const us = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(us));
    units(us);
  });

  /* Order. */
  for (const table of tables) {
    const body = table.tBodies[0], heads = [...table.tHead.rows[0].cells];
    if (table.tBodies.length !== 1 || table.querySelector("tbody [rowspan], tbody [colspan]") || body.rows.length < 2) continue;
    const first = [...body.rows];
    heads.forEach((head, k) => {
      const sort = document.createElement("button");
      sort.type = "button";
      sort.className = "sort";
      sort.textContent = "↕";
      sort.setAttribute("aria-label", "Sort by " + (head.innerText.trim().replace(/\s+/g, " ") || "name"));
      head.append(sort);
      sort.addEventListener("click", () => {
        const now = head.getAttribute("aria-sort"), next = now === null ? "ascending" : now === "ascending" ? "descending" : null;
        for (const other of heads) { other.removeAttribute("aria-sort"); other.lastChild.textContent = "↕"; }
        if (next) { head.setAttribute("aria-sort", next); sort.textContent = next === "ascending" ? "↑" : "↓"; }
        const sign = next === "descending" ? -1 : 1;
        const rows = next ? [...first].sort((a, b) => {
          const [x, y] = [valueOf(a.cells[k]), valueOf(b.cells[k])];
          if (Number.isNaN(x) || Number.isNaN(y)) return Number.isNaN(x) && Number.isNaN(y) ? sign * a.cells[k].textContent.localeCompare(b.cells[k].textContent) : Number.isNaN(x) ? 1 : -1;
          return sign * (x - y || 0);
        }) : first;
        body.append(...rows);
      });
    });
  }

  /* A number, opened: its name, its value in both systems, how it was found, and what the file says of its part. */
  const dialog = document.getElementById("opened");
  function open(cell, table) {
    const heads = [...table.tHead.rows[0].cells], head = heads[cell.cellIndex], row = cell.parentNode.cells[0], list = dialog.querySelector("dl");
    const link = head.querySelector("a[href^='#f']"), unit = unitOf(cell, heads), mark = cell.querySelector(".mark");
    const word = head.querySelector(".word"), name = (word ? word.textContent + " " : "") + (link ? link : head).innerText.split("\n").filter(line => line && line !== (word && word.textContent))[0];
    document.getElementById("opened-name").textContent = row === cell ? name : row.textContent + ": " + name;
    list.replaceChildren();
    const say = (term, ...what) => {
      const dt = document.createElement("dt"), dd = document.createElement("dd");
      dt.textContent = term;
      dd.append(...what);
      list.append(dt, dd);
    };
    const value = valueOf(cell);
    say("value", (cell.dataset.v || cell.firstChild.data) + (unit ? " " + unit : ""));
    if (US[unit]) { const [us, called] = inUS(value, unit); say("in US units", written(us, 6) + " " + called); }
    if (link) {
      const made = document.getElementById(link.getAttribute("href").slice(1));
      if (made) { say("equation", ...[...made.cells[2].childNodes].map(node => node.cloneNode(true))); say("source", made.cells[3].textContent); }
    }
    const source = heads.findIndex(other => other.innerText.trim().startsWith("source"));
    if (!link && source >= 0) say("source", cell.parentNode.cells[source].textContent);
    if (mark) say("mark", mark.title);
    told(row.textContent.trim().split(/[.\s]/)[0], say);
    dialog.showModal();
    dialog.scrollTop = 0;
  }
  function told(part, say) {
    const said = part ? [...document.querySelectorAll("table.entries td:first-child code")].filter(code => code.textContent.split(".").includes(part)).slice(0, 8) : [];
    for (const code of said) {
      const cells = code.closest("tr").cells;
      say("in the file", code.textContent + " = " + cells[1].textContent + (cells.length > 3 && cells[2].textContent ? ", line " + cells[2].textContent : ""));
    }
  }

  /* A part that a figure names, opened: every row of the page that is its own, and what the file says of it. */
  const namedBy = table => Math.max(0, [...table.tHead.rows[0].cells].findIndex(head => head.textContent.trim().startsWith("part")));
  const rowsOf = new Map();
  for (const table of tables) if (!table.matches(".entries, .formulas")) for (const row of table.tBodies[0].rows) {
    const name = row.cells[namedBy(table)].textContent.trim();
    if (/^\p{L}/u.test(name)) rowsOf.set(name, [...(rowsOf.get(name) || []), [row, table]]);
  }
  function openPart(name) {
    const list = dialog.querySelector("dl");
    document.getElementById("opened-name").textContent = name;
    list.replaceChildren();
    const say = (term, what) => list.append(Object.assign(document.createElement("dt"), { textContent: term }), Object.assign(document.createElement("dd"), { textContent: what }));
    const own = [...rowsOf.keys()].filter(key => key === name || key.startsWith(name + ".") || key.startsWith(name + " "));
    for (const [key, row, table] of own.flatMap(key => rowsOf.get(key).map(([row, table]) => [key, row, table])).sort((a, b) => namedBy(a[2]) - namedBy(b[2]))) {
      const heads = [...table.tHead.rows[0].cells], caption = table.caption ? table.caption.textContent : "";
      const cells = [...row.cells].filter((cell, k) => k !== namedBy(table)).map(cell => [heads[cell.cellIndex].innerText.split("\n").filter(Boolean)[0].replace("↕", "").trim(), cell.textContent.trim(), unitOf(cell, heads)]);
      say((key === name ? "" : key + ": ") + caption, cells.filter(([, text]) => text).map(([head, text, unit]) => `${head} ${text}${unit && !head.startsWith("unit") ? " " + unit : ""}`).join(", "));
    }
    told(name, say);
    dialog.showModal();
    dialog.scrollTop = 0;
  }
  const byPart = text => (document.querySelector("table.entries") && (rowsOf.has(text) || [...rowsOf.keys()].some(key => key.startsWith(text + "."))) ? text : "");
  for (const drawing of document.querySelectorAll("figure:not([id^=live-]) svg.gw-figure")) {
    const known = new Set();
    for (const word of drawing.querySelectorAll("text")) {
      const name = word.textContent.trim(), part = known.has(name) || name.length < 2 ? "" : byPart(name);
      if (!part) continue;
      known.add(part);
      word.classList.add("part");
      word.tabIndex = 0;
      word.setAttribute("role", "button");
      word.addEventListener("click", () => openPart(part));
      word.addEventListener("keydown", event => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); openPart(part); } });
    }
    if (known.size) drawing.setAttribute("role", "group");
  }

  /* A figure that is wider than its room is scrolled by keys, too. */
  const scrolled = () => {
    for (const figure of document.querySelectorAll("figure, .formula")) {
      const over = figure.scrollWidth > figure.clientWidth;
      over ? figure.setAttribute("tabindex", "0") : figure.removeAttribute("tabindex");
    }
  };
  scrolled();
  addEventListener("resize", scrolled);

  for (const table of tables) {
    const cells = [...table.querySelectorAll("tbody td.n")];
    if (table.matches(".entries") || !cells.length) continue;
    cells.forEach((cell, k) => { cell.tabIndex = k ? -1 : 0; });
    table.addEventListener("click", event => { const cell = event.target.closest("tbody td.n"); if (cell) open(cell, table); });
    table.addEventListener("keydown", event => {
      const cell = event.target.closest("td.n");
      if (!cell) return;
      if (event.key === "Enter" || event.key === " ") { event.preventDefault(); open(cell, table); return; }
      const row = cell.parentNode, body = [...row.parentNode.rows], k = cell.cellIndex, at = body.indexOf(row);
      const next = { ArrowRight: () => row.cells[k + 1], ArrowLeft: () => row.cells[k - 1], ArrowDown: () => body[at + 1] && body[at + 1].cells[k], ArrowUp: () => body[at - 1] && body[at - 1].cells[k] }[event.key];
      const target = next && next();
      if (target && target.matches(".n")) { event.preventDefault(); cell.tabIndex = -1; target.tabIndex = 0; target.focus(); }
    });
  }
})();
