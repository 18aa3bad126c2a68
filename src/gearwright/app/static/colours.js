/* What colours of the solids mean, and those that the exported page does not have: temperatures. */
/* global THREE */
import {at, made, number} from "/static/made.js";

const COLD = 0x3b6fb6, EVEN = 0xf2e6c9, HOT = 0xb40426, NONE = 0xb9bec5;

/* Temperatures of the parts that have one, their least and their most [°C]. */
function spread(facts) {
  const known = Object.entries(facts.parts).filter(([, part]) => typeof part.temperature === "number");
  const values = known.map(([, part]) => part.temperature);
  return values.length ? {low: Math.min(...values), high: Math.max(...values)} : null;
}

export function painted(gearbox, facts, selected) {
  const range = spread(facts);
  for (const body of gearbox.bodies) {
    if (!body.solid) continue;
    const value = facts.parts[body.label]?.temperature, share = range && typeof value === "number" ? (value - range.low) / (range.high - range.low || 1) : null;
    const hue = share === null ? new THREE.Color(NONE) : share < 0.5 ? new THREE.Color(COLD).lerp(new THREE.Color(EVEN), 2 * share) : new THREE.Color(EVEN).lerp(new THREE.Color(HOT), 2 * share - 1);
    body.solid.material.color.copy(hue);
    body.solid.material.emissive.set(selected && body.label === selected ? 0x664f00 : 0x000000);
  }
  for (const button of at("parts").querySelectorAll("button")) {
    const value = facts.parts[button.dataset.part]?.temperature, body = gearbox.bodies.find(one => one.label === button.dataset.part && one.solid);
    button.lastChild.textContent = typeof value === "number" ? `${number(value, 3)} °C` : "";
    if (body) button.firstChild.style.background = `#${body.solid.material.color.getHexString()}`;
  }
}

const SCALES = {
  margin: ["linear-gradient(90deg, #d55e00, #f0e6c8 50%, #0072b2)", () => ["0.5", "1", "2 or more"]],
  force: ["linear-gradient(90deg, #f3ead7, #8c1d04)", facts => ["0", "", `${number(Math.max(0, ...Object.values(facts.parts).map(part => part.force || 0)) / 1000, 3)} kN`]],
  temperature: ["linear-gradient(90deg, #3b6fb6, #f2e6c9 50%, #b40426)", facts => { const range = spread(facts); return range ? [`${number(range.low, 3)} °C`, "", `${number(range.high, 3)} °C`] : ["no temperature is known"]; }],
};

export function legend(by, facts) {
  const box = at("legend"), scale = SCALES[by];
  if (!scale) return box.replaceChildren();
  const [low, , high] = scale[1](facts), bar = made("i");
  bar.style.background = scale[0];
  const words = by === "temperature" && facts.heat ? ` (${facts.heat})` : "";
  return box.replaceChildren(...(high === undefined ? [low + words] : [low, bar, high + words]));
}
