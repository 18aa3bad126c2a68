// Writes the copy of CodeMirror that the workbench's editor is, and what it is: node tools/codemirror.mjs
// For maintainers alone: who installs, runs or tests gearwright needs no node.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const ESBUILD = "0.28.2";
const PACKAGES = {
  "@codemirror/commands": "6.11.1", "@codemirror/language": "6.13.1", "@codemirror/legacy-modes": "6.5.5", "@codemirror/lint": "6.9.8",
  "@codemirror/search": "6.7.2", "@codemirror/state": "6.7.6", "@codemirror/view": "6.43.15", "@lezer/highlight": "1.2.5",
};
const ENTRY = `export { EditorState, Compartment, Annotation } from "@codemirror/state";
export { EditorView, keymap, lineNumbers, highlightActiveLine, drawSelection } from "@codemirror/view";
export { StreamLanguage, HighlightStyle, syntaxHighlighting } from "@codemirror/language";
export { toml } from "@codemirror/legacy-modes/mode/toml";
export { history, historyKeymap, defaultKeymap, undo, redo } from "@codemirror/commands";
export { searchKeymap, highlightSelectionMatches } from "@codemirror/search";
export { lintGutter, setDiagnostics, lintKeymap } from "@codemirror/lint";
export { tags } from "@lezer/highlight";
`;
const folder = join(dirname(fileURLToPath(import.meta.url)), "..", "src", "gearwright", "app", "static", "vendor");
const work = mkdtempSync(join(tmpdir(), "codemirror-"));
const run = (program, ...words) => execFileSync(program, words, { cwd: work, stdio: "inherit" });
writeFileSync(join(work, "package.json"), '{"private": true}');
run("npm", "install", "--no-audit", "--no-fund", ...Object.entries(PACKAGES).map(pair => pair.join("@")), `esbuild@${ESBUILD}`);
writeFileSync(join(work, "entry.js"), ENTRY);
const made = join(folder, "codemirror.min.js"), meta = join(work, "meta.json");
run(join(work, "node_modules", ".bin", "esbuild"), "entry.js", "--bundle", "--minify", "--format=esm", "--legal-comments=eof",
  `--metafile=${meta}`, `--outfile=${made}`);
const names = Object.keys(JSON.parse(readFileSync(meta)).inputs).map(path => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1]);
const held = [...new Set(names.filter(Boolean))].sort().map(name => {
  const { version, license } = JSON.parse(readFileSync(join(work, "node_modules", name, "package.json")));
  const text = readFileSync(join(work, "node_modules", name, "LICENSE"), "utf8").trim();
  return { name, version, license, text };
});
const digest = createHash("sha512").update(readFileSync(made)).digest("hex");
writeFileSync(join(folder, "vendor.toml"), `# What codemirror.min.js is; tools/codemirror.mjs writes both.
bundled_by = "esbuild ${ESBUILD}"
sha512 = "${digest}"

[packages]
${held.map(({ name, version, license }) => `"${name}" = "${version}, ${license}"`).join("\n")}
`);
writeFileSync(join(folder, "LICENSES.txt"), held.map(({ name, version, text }) => `${name} ${version}\n\n${text}\n`).join("\n----\n\n"));
