"use strict";
/* Words beside the picture: the parts as a list, the numbers of one, colours and what they mean. */
class Panel {
  constructor(facts, gearbox, picked) {
    this.facts = facts;
    this.gearbox = gearbox;
    this.list = document.getElementById("parts");
    this.numbers = document.getElementById("numbers");
    this.most = Math.max(0, ...Object.values(facts.parts).map(part => part.force || 0));
    for (const [label, part] of Object.entries(facts.parts)) {
      const item = document.createElement("li"), button = document.createElement("button");
      button.type = "button";
      button.textContent = part.title;
      button.dataset.part = label;
      button.setAttribute("aria-pressed", "false");
      const swatch = document.createElement("span");
      swatch.className = "swatch";
      button.prepend(swatch);
      const number = document.createElement("span");
      number.className = "margin";
      button.append(number);
      button.addEventListener("click", () => picked(label));
      item.append(button);
      this.list.append(item);
    }
  }

  show(label) {
    this.numbers.replaceChildren();
    for (const button of this.list.querySelectorAll("button")) button.setAttribute("aria-pressed", String(button.dataset.part === label));
    const part = this.facts.parts[label];
    if (!part) return;
    const heading = document.createElement("h2");
    heading.textContent = part.title;
    this.numbers.append(heading, this.table("", part.rows));
    if (part.checks.length) this.numbers.append(this.table("Checks, the worst first: 1 is just enough", part.checks));
  }

  table(caption, rows) {
    const table = document.createElement("table");
    if (caption) table.createCaption().textContent = caption;
    for (const [name, value] of rows) {
      const row = table.insertRow(), head = document.createElement("th");
      head.scope = "row";
      head.textContent = name;
      row.append(head);
      row.insertCell().textContent = value;
    }
    return table;
  }

  /* Blue has room, white is just enough, orange fails; grey has no check. The number stands beside every name, too. */
  /* A margin to the nearest; what is below 1 never reads as 1. */
  static said(margin) {
    let digits = 3;
    while (margin < 1 - 1e-9 && Number(margin.toPrecision(digits)) >= 1) digits++;
    return margin >= 100 ? margin.toFixed(0) : margin.toPrecision(digits);
  }

  static hue(margin) {
    if (margin === null) return new THREE.Color(0xb9bec5);
    const fails = new THREE.Color(0xd55e00), even = new THREE.Color(0xf0e6c8), room = new THREE.Color(0x0072b2);
    return margin < 1 ? fails.lerp(even, Math.max(0, (margin - 0.5) / 0.5) * 0.5) : even.lerp(room, Math.min(1, (margin - 1) / 1));
  }

  /* Pale bears little, dark red bears the most of all parts; grey has no force of its own. */
  static burden(share) {
    return share === null ? new THREE.Color(0xb9bec5) : new THREE.Color(0xf3ead7).lerp(new THREE.Color(0x8c1d04), Math.sqrt(share));
  }

  hueOf(part, by, own) {
    if (by === "margin") return Panel.hue(part ? part.margin : null);
    if (by === "force") return Panel.burden(part && part.force !== null ? part.force / (this.most || 1) : null);
    return own;
  }

  colour(by, label) {
    for (const body of this.gearbox.bodies) {
      if (!body.solid) continue;
      const part = this.facts.parts[body.label];
      const hue = this.hueOf(part, by, body.own.color);
      if (body.solid.material === body.own) {
        const cut = body.own.userData.glass && !body.own.transparent;
        body.solid.material = Gearbox.paint(new THREE.Color(), body.own.userData.glass);
        Gearbox.clear(body.solid.material, !cut);
      }
      body.solid.material.color.copy(hue);
      body.solid.material.emissive.set(label && body.label === label ? 0x664f00 : 0x000000);
    }
    for (const button of this.list.querySelectorAll("button")) {
      const body = this.gearbox.bodies.find(one => one.label === button.dataset.part && one.solid);
      const part = this.facts.parts[button.dataset.part];
      button.lastChild.textContent = by === "force" ? part.force_text : part.margin === null ? "" : Panel.said(part.margin);
      button.firstChild.style.background = body ? "#" + body.solid.material.color.getHexString() : "none";
    }
  }
}
