/* The gearbox turning: the solids of the last valid text, drawn by the scripts that the exported page has too. */
/* global Gearbox, View, Motion, Panel, THREE */
import {Dropped, Problems} from "/static/api.js";
import {at, made} from "/static/made.js";
import {legend, painted} from "/static/colours.js";
import {shake} from "/static/shaking.js";
import {ground, solids, stand} from "/static/solids.js";
import {on, set, state} from "/static/state.js";

let view = null, motion = null, panel = null, facts = null, shown = "", of = "", by = "part";

async function load() {
  if (state.view !== "gearbox-view" || !state.answer || shown === state.answer.text) return;
  const text = state.answer.text;
  try {
    const model = await solids(text);
    if (state.answer.text !== text) return;
    facts = model.facts;
    take(new Gearbox(model.glb));
    shown = text;
    document.body.dataset.model = String(Number(document.body.dataset.model || 0) + 1);
  } catch (reason) {
    if (reason instanceof Dropped || reason instanceof Problems) return;
    at("without").hidden = false;
    at("without").textContent = `This browser shows no three-dimensional pictures here (${reason.message}).`;
  }
}

const FITS = 1.5; // so much larger or smaller, a gearbox is seen from where the other one was
const length = gearbox => gearbox.box.getSize(new THREE.Vector3()).length();

/* Put another gearbox in the place of the one that is seen; section and time stay, and of the same design the camera. */
function take(gearbox) {
  for (const body of gearbox.bodies) body.label = facts.labels[body.name] || body.part;
  if (view === null) {
    view = new View(at("picture"), gearbox, facts.up);
    motion = new Motion(gearbox, view, on => { at("go").textContent = on ? "Stop" : "Turn"; at("go").setAttribute("aria-pressed", String(on)); });
  } else {
    view.scene.remove(view.gearbox.root);
    for (const shape of view.gearbox.shapes) shape.geometry.dispose();
    view.scene.add(gearbox.root);
    view.gearbox = motion.gearbox = gearbox;
    const other = of !== state.name || Math.abs(Math.log(length(gearbox) / view.size_)) > Math.log(FITS);
    if (stand(view, facts.up) || other) view.home();
  }
  of = state.name;
  shake(gearbox, motion);
  paper();
  at("parts").replaceChildren();
  panel = new Panel(facts, gearbox, pick);
  at("case").replaceChildren(...gearbox.cases.map(name => new Option(name, name)));
  motion.name = gearbox.cases.includes(state.case) ? state.case : gearbox.cases[0];
  at("case").value = motion.name;
  looks();
  gearbox.explode(facts.explode, Number(at("apart").value));
  select();
  if (!shown) at("slow").value = Math.log10(Math.max(1, motion.fastest() / 0.6));
  pace();
  motion.show();
  window.gearbox = {gearbox, view, motion};
}

const pick = label => set({selected: state.selected === label ? "" : label});

function select() {
  if (!panel) return;
  panel.show(state.selected);
  if (!facts.parts[state.selected]) at("numbers").append(made("p", {className: "hint", textContent: "Click a part, or choose it in the list."}));
  panel.colour(by === "temperature" ? "part" : by, state.selected);
  if (by === "temperature") painted(view.gearbox, facts, state.selected);
  legend(by, facts);
  view.draw();
}

function paper() {
  view.scene.background = new THREE.Color(ground());
}

function pace() {
  motion.slow = Math.pow(10, Number(at("slow").value));
  const rounds = (motion.fastest() / motion.slow / (2 * Math.PI)) * 60;
  at("pace").textContent = `1 : ${Math.round(motion.slow).toLocaleString("en")}, the fastest part at ${rounds.toPrecision(2)} rpm`;
}

function looks() {
  for (const box of document.querySelectorAll("[data-look]")) for (const body of view.gearbox.bodies)
    if (body.solid && box.dataset.look.split(" ").includes(body.look)) body.solid.visible = box.checked;
}

function step() {
  const label = facts.parts[state.selected]?.teeth ? state.selected : facts.first;
  motion.go(false);
  motion.step(facts.parts[label].teeth, view.gearbox.bodies.find(body => body.label === label && body.solid));
}

function cut() {
  at("depth").disabled = !at("section").value;
  view.cut(at("section").value, Number(at("depth").value));
}

function picture() {
  view.renderer.render(view.scene, view.camera);
  const link = document.createElement("a");
  link.href = at("picture").toDataURL("image/png");
  link.download = "gearbox.png";
  link.click();
}

const ready = action => event => view && action(event);
const listen = (id, kind, action) => at(id).addEventListener(kind, ready(action));
listen("case", "change", event => { set({case: event.target.value}); });
listen("slow", "input", pace);
listen("go", "click", () => motion.go(!motion.runs));
listen("step", "click", step);
listen("home", "click", () => view.home());
listen("section", "change", cut);
listen("depth", "input", cut);
listen("apart", "input", event => { view.gearbox.explode(facts.explode, Number(event.target.value)); view.draw(); });
listen("colour", "change", event => { by = event.target.value; select(); });
listen("photo", "click", picture);
for (const box of document.querySelectorAll("[data-look]")) box.addEventListener("change", ready(() => { looks(); view.draw(); }));
let down = null;
listen("picture", "pointerdown", event => { down = [event.clientX, event.clientY]; });
listen("picture", "pointerup", event => {
  if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
  const body = view.under(event.clientX, event.clientY);
  if (body) pick(body.label);
});
const keys = {
  ArrowLeft: () => view.turn(-0.1, 0), ArrowRight: () => view.turn(0.1, 0), ArrowUp: () => view.turn(0, 0.1), ArrowDown: () => view.turn(0, -0.1),
  "+": () => view.zoom(0.9), "-": () => view.zoom(1.1), " ": () => motion.go(!motion.runs), n: step, Home: () => view.home(),
};
listen("picture", "keydown", event => {
  if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  keys[event.key]();
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", ready(() => { paper(); view.draw(); }));
on("answer view", load);
on("selected", select);
on("view", ready(() => { if (state.view !== "gearbox-view") motion.go(false); }));
on("case", ready(() => { if (view.gearbox.cases.includes(state.case)) { at("case").value = state.case; motion.select(state.case); pace(); } }));
