/* Two gearboxes side by side: skeletons, and solids that turn with one camera and one time. */
/* global Gearbox, THREE, View */
import {Dropped, Problems, ask} from "/static/api.js";
import {at} from "/static/made.js";
import {drawing} from "/static/svg.js";
import {ground, solids, stand} from "/static/solids.js";

const sides = {pinned: {}, now: {}};
let leading = null;

export async function twins(pinned, now, name) {
  for (const [side, text] of [["pinned", pinned], ["now", now]]) {
    if (sides[side].text === text) continue;
    try {
      await shown(side, text, name);
    } catch (reason) {
      if (!(reason instanceof Dropped || reason instanceof Problems)) at("beside-told").textContent = reason.message;
    }
  }
  together();
}

async function shown(side, text, name) {
  const [sketch, model] = await Promise.all([ask("schematic", text, {page: side}).then(answer => answer.text()), solids(text, {page: side})]);
  at(`schematic-${side}`).replaceChildren(drawing(sketch, side));
  const gearbox = new Gearbox(model.glb), one = sides[side];
  gearbox.pose(0, gearbox.cases.includes(name) ? name : gearbox.cases[0]);
  if (!one.view) {
    one.view = new View(at(`solids-${side}`), gearbox, model.facts.up);
    one.view.orbit.addEventListener("change", () => follow(side));
  } else {
    one.view.scene.remove(one.view.gearbox.root);
    for (const shape of one.view.gearbox.shapes) shape.geometry.dispose();
    one.view.scene.add(gearbox.root);
    one.view.gearbox = gearbox;
    if (stand(one.view, model.facts.up)) one.view.orbit.addEventListener("change", () => follow(side));
  }
  one.view.scene.background = new THREE.Color(ground());
  one.text = text;
  document.body.dataset[`twin${side}`] = String(Number(document.body.dataset[`twin${side}`] || 0) + 1);
}

/* Both are seen from where the larger one fills its picture, so that sizes can be compared. */
function together() {
  const {pinned, now} = sides;
  if (!pinned.view || !now.view) return;
  const length = one => one.view.gearbox.box.getSize(new THREE.Vector3()).length(), larger = length(pinned) > length(now) ? "pinned" : "now";
  leading = null;
  sides[larger].view.home();
  follow(larger);
  for (const one of [pinned, now]) one.view.draw();
  window.twins = sides;
}

/* One camera for both: what one is turned to, the other shows. */
function follow(side) {
  const from = sides[side].view, to = sides[side === "pinned" ? "now" : "pinned"].view;
  if (!to || (leading && leading !== side)) return;
  leading = side;
  to.camera.position.copy(from.camera.position).sub(from.orbit.target).add(to.orbit.target);
  to.size_ = from.size_ = Math.max(to.size_, from.size_);
  to.orbit.update();
  to.draw();
  leading = null;
}

for (const side of ["pinned", "now"]) at(`solids-${side}`).addEventListener("keydown", event => {
  const {view} = sides[side], way = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]}[event.key];
  if (!view || !way) return;
  event.preventDefault();
  view.turn(...way);
  follow(side);
});
