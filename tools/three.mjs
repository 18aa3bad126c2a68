// Writes the copy of three.js that the page of the turning gearbox carries, and what it is: node tools/three.mjs
// For maintainers alone: who installs, runs or tests gearwright needs no node.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const THREE = "0.180.0", ESBUILD = "0.25.10";
const TAKEN = `WebGLRenderer, Scene, PerspectiveCamera, HemisphereLight, DirectionalLight, Mesh, Group, BufferGeometry,
  BufferAttribute, InstancedMesh, MeshPhongMaterial, Color, Plane, Vector2, Vector3, Quaternion, Box3, Raycaster, DoubleSide`;
const folder = join(dirname(fileURLToPath(import.meta.url)), "..", "src", "gearwright", "render", "solids");
const work = mkdtempSync(join(tmpdir(), "three-"));
writeFileSync(join(work, "package.json"), '{"private": true}');
execFileSync("npm", ["install", "--no-audit", "--no-fund", `three@${THREE}`, `esbuild@${ESBUILD}`], { cwd: work, stdio: "inherit" });
writeFileSync(join(work, "entry.js"), `export { ${TAKEN} } from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";`);
execFileSync(join(work, "node_modules", ".bin", "esbuild"), ["entry.js", "--bundle", "--minify", "--format=iife",
  "--global-name=THREE", "--legal-comments=eof", `--outfile=${join(folder, "three.min.js")}`], { cwd: work, stdio: "inherit" });
const digest = createHash("sha512").update(readFileSync(join(folder, "three.min.js"))).digest("hex");
writeFileSync(join(folder, "three.toml"), `# What three.min.js is; tools/three.mjs writes both.
name = "three"
version = "${THREE}"
licence = "MIT"
bundled_by = "esbuild ${ESBUILD}"
sha512 = "${digest}"
`);
