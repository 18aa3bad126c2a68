/* Solids of a text, and the scripts that draw them, which the exported page has too. */
import {ask} from "/static/api.js";

let loaded = null;

/* Half a megabyte, which nobody waits for who does not look. */
export function scripts() {
  loaded ??= ["three.min", "model", "view", "motion", "panel"].reduce((before, name) => before.then(() => new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = `/static/solids/${name}.js`;
    script.addEventListener("load", done);
    script.addEventListener("error", () => failed(new Error(`${script.src} does not load`)));
    document.head.append(script);
  })), Promise.resolve());
  return loaded;
}


/* The solids as GLB, and what is said of them. */
export async function solids(text, options = {}) {
  const [answer] = await Promise.all([ask("model", text, options), scripts()]);
  const buffer = await answer.arrayBuffer(), length = new DataView(buffer).getUint32(0, true);
  return {facts: JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))), glb: buffer.slice(4 + length)};
}

export const ground = () => (matchMedia("(prefers-color-scheme: dark)").matches ? 0x171b21 : 0xf4f6f8);

/* What is upright of another gearbox is upright on the picture; true where it was another way before. */
export function stand(view, up) {
  const now = new THREE.Vector3().fromArray(up);
  if (now.distanceTo(view.up) < 1e-9) return false;
  view.up.copy(now);
  view.camera.up.copy(now);
  view.orbit.dispose(); // it keeps what was upright as it was made
  view.orbit = new THREE.OrbitControls(view.camera, view.canvas);
  view.orbit.addEventListener("change", () => view.draw());
  return true;
}
