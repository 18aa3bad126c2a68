/* What a train does beside its steady turning, on the solids: the shape of a mode, or the end of a simulated run. */
/* global Gearbox, THREE */
import {at} from "/static/made.js";
import {on, set, state} from "/static/state.js";

const LARGEST = 0.12, ROUND = 3; // turn of the body that turns most, as it is shown at first [rad]; time of one swing of a mode [s]
let watched = null;

/* From now on every pose of this gearbox has the motion in it. */
export function shake(gearbox, motion) {
  watched = {gearbox, motion};
  gearbox.pose = (seconds, name) => {
    const {shaken} = state;
    if (!shaken) return Gearbox.prototype.pose.call(gearbox, seconds, name);
    const now = shaken.kind === "mode" ? mode(shaken, seconds * motion.slow) : run(shaken, seconds);
    Gearbox.prototype.pose.call(gearbox, now.seconds, name);
    const about = new THREE.Vector3(0, 0, 1), turn = new THREE.Quaternion();
    for (const body of gearbox.bodies) if (now.turns[body.name]) body.frame.quaternion.multiply(turn.setFromAxisAngle(about, now.turns[body.name]));
    return gearbox.settle();
  };
  told();
}

const enlarged = () => 10 ** Number(at("enlarge").value);

function mode({shape}, seconds) {
  const swing = LARGEST * enlarged() * Math.sin((2 * Math.PI * seconds) / ROUND);
  return {seconds: 0, turns: Object.fromEntries(Object.entries(shape).map(([name, part]) => [name, part * swing]))};
}

/* The record goes round; between two instants of it lies a straight line. */
function run({time, turns, most}, seconds) {
  const length = time.at(-1) - time[0], here = (((seconds % length) + length) % length) / length * (time.length - 1), k = Math.min(time.length - 2, Math.floor(here)), part = here - k;
  const scale = (LARGEST / most) * enlarged();
  return {seconds, turns: Object.fromEntries(Object.entries(turns).map(([name, values]) => [name, scale * (values[k] + part * (values[k + 1] - values[k]))]))};
}

function told() {
  const {shaken} = state;
  at("shaking").hidden = !shaken;
  if (!shaken) return;
  if (shaken.kind === "run" && !shaken.most) shaken.most = Math.max(1e-12, ...Object.values(shaken.turns).map(values => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0)));
  const scale = shaken.kind === "run" ? `, ${Math.round(Number(((LARGEST / shaken.most) * enlarged()).toPrecision(2))).toLocaleString("en")} times enlarged, beside the steady turning` : ", enlarged, without the steady turning";
  at("shaken").textContent = shaken.title + scale;
}

function shown() {
  told();
  if (!watched) return;
  if (state.shaken && state.case !== state.shaken.case && watched.gearbox.cases.includes(state.shaken.case)) set({case: state.shaken.case});
  watched.motion.show();
}

on("shaken", () => {
  shown();
  if (watched && state.shaken && !matchMedia("(prefers-reduced-motion: reduce)").matches) watched.motion.go(true);
});
on("answer", () => { if (state.shaken && state.shaken.text !== state.answer.text) set({shaken: null}); });
at("enlarge").addEventListener("input", shown);
at("calm").addEventListener("click", () => { set({shaken: null}); watched?.motion.go(false); });
