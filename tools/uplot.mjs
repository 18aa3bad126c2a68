// Writes the copy of uPlot that pages with lines over time carry, and what it is: node tools/uplot.mjs
// For maintainers alone: who installs, runs or tests gearwright needs no node.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { copyFileSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const UPLOT = "1.6.32";
const folder = join(dirname(fileURLToPath(import.meta.url)), "..", "src", "gearwright", "render", "uplot");
const work = mkdtempSync(join(tmpdir(), "uplot-"));
writeFileSync(join(work, "package.json"), '{"private": true}');
execFileSync("npm", ["install", "--no-audit", "--no-fund", `uplot@${UPLOT}`], { cwd: work, stdio: "inherit" });
const from = join(work, "node_modules", "uplot");
copyFileSync(join(from, "dist", "uPlot.iife.min.js"), join(folder, "uplot.min.js"));
copyFileSync(join(from, "dist", "uPlot.min.css"), join(folder, "uplot.min.css"));
copyFileSync(join(from, "LICENSE"), join(folder, "LICENSE.txt"));
const digest = name => createHash("sha512").update(readFileSync(join(folder, name))).digest("hex");
writeFileSync(join(folder, "uplot.toml"), `# What uplot.min.js and uplot.min.css are, as their makers built them; tools/uplot.mjs writes all three.
name = "uplot"
version = "${UPLOT}"
licence = "MIT"
sha512 = "${digest("uplot.min.js")}"
style_sha512 = "${digest("uplot.min.css")}"
`);
