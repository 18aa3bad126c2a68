"use strict";
/* Joins page, picture and time. Without WebGL the page keeps its drawing of the train and says so. */
(function start() {
  const at = id => document.getElementById(id), facts = JSON.parse(at("facts").textContent), canvas = at("picture");
  const data = Uint8Array.from(atob(at("model").textContent.trim()), letter => letter.charCodeAt(0)).buffer;
  let gearbox, view;
  try {
    gearbox = new Gearbox(data);
    view = new View(canvas, gearbox, facts.up);
  } catch (reason) {
    at("without").hidden = false;
    at("without").querySelector("p").append(" (" + reason.message + ")");
    at("stage").hidden = true;
    return;
  }
  for (const body of gearbox.bodies) body.label = facts.labels[body.name] || body.part;
  const motion = new Motion(gearbox, view, on => { at("go").textContent = on ? "Stop" : "Turn"; at("go").setAttribute("aria-pressed", String(on)); });
  let picked = "", by = "part";
  const pick = label => { picked = picked === label ? "" : label; panel.show(picked); panel.colour(by, picked); view.draw(); };
  const panel = new Panel(facts, gearbox, pick);
  for (const name of gearbox.cases) at("case").append(new Option(name, name));
  at("case").addEventListener("change", event => { motion.select(event.target.value); pace(); });
  const pace = () => {
    motion.slow = Math.pow(10, Number(at("slow").value));
    const rounds = (motion.fastest() / motion.slow / (2 * Math.PI)) * 60;
    at("pace").textContent = "1 : " + Math.round(motion.slow).toLocaleString("en") + ", the fastest part at " + rounds.toPrecision(2) + " rpm";
  };
  at("slow").value = Math.log10(Math.max(1, motion.fastest() / 0.6));
  at("slow").addEventListener("input", pace);
  at("go").addEventListener("click", () => motion.go(!motion.runs));
  at("step").addEventListener("click", () => step());
  const step = () => {
    const label = facts.parts[picked] && facts.parts[picked].teeth ? picked : facts.first;
    motion.go(false);
    motion.step(facts.parts[label].teeth, gearbox.bodies.find(body => body.label === label && body.solid));
  };
  const cut = () => { at("depth").disabled = !at("section").value; view.cut(at("section").value, Number(at("depth").value)); };
  at("section").addEventListener("change", cut);
  at("depth").addEventListener("input", cut);
  at("apart").addEventListener("input", event => { gearbox.explode(facts.explode, Number(event.target.value)); view.draw(); });
  at("colour").addEventListener("change", event => { by = event.target.value; at("legend").hidden = by !== "margin"; at("burden").hidden = by !== "force"; panel.colour(by, picked); view.draw(); });
  for (const box of document.querySelectorAll("[data-look]")) {
    const looks = box.dataset.look.split(" ");
    const shown = () => { for (const body of gearbox.bodies) if (body.solid && looks.includes(body.look)) body.solid.visible = box.checked; };
    box.addEventListener("change", () => { shown(); view.draw(); });
    shown();
  }
  at("home").addEventListener("click", () => view.home());
  let down = null;
  canvas.addEventListener("pointerdown", event => { down = [event.clientX, event.clientY]; });
  canvas.addEventListener("pointerup", event => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
    const body = view.under(event.clientX, event.clientY);
    if (body) pick(body.label);
  });
  const keys = {
    ArrowLeft: () => view.turn(-0.1, 0), ArrowRight: () => view.turn(0.1, 0), ArrowUp: () => view.turn(0, 0.1), ArrowDown: () => view.turn(0, -0.1),
    "+": () => view.zoom(0.9), "-": () => view.zoom(1.1), " ": () => motion.go(!motion.runs), n: step, Home: () => view.home(),
  };
  canvas.addEventListener("keydown", event => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  pace();
  panel.colour(by, picked);
  motion.show();
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches || location.hash === "#still";
  motion.go(!calm);
  window.gearbox = {gearbox, view, motion, pick};
  document.body.dataset.ready = "yes";
})();
