/* The text of the design, and what is wrong with it at its line. */
import {
  EditorState, EditorView, HighlightStyle, StreamLanguage, defaultKeymap, drawSelection, highlightActiveLine, highlightSelectionMatches,
  history, historyKeymap, keymap, lineNumbers, lintGutter, lintKeymap, redo, searchKeymap, setDiagnostics, syntaxHighlighting, tags, toml, undo,
} from "/static/vendor/codemirror.min.js";
import {at, made} from "/static/made.js";
import {on, set, state} from "/static/state.js";

const colours = HighlightStyle.define([
  {tag: tags.comment, color: "var(--muted)"}, {tag: tags.propertyName, color: "var(--ink)"}, {tag: tags.string, color: "var(--green)"},
  {tag: tags.number, color: "var(--accent)"}, {tag: tags.bool, color: "var(--accent)"}, {tag: tags.atom, color: "var(--accent)"},
]);
const look = EditorView.theme({
  "&": {height: "100%", fontSize: "12.5px", color: "var(--ink)", backgroundColor: "var(--paper)"},
  "&.cm-focused": {outline: "2px solid var(--accent)", outlineOffset: "-2px"},
  ".cm-scroller": {fontFamily: "ui-monospace, 'DejaVu Sans Mono', monospace", overflow: "auto"},
  ".cm-gutters": {backgroundColor: "var(--ground)", color: "var(--muted)", border: "none"},
  ".cm-activeLine, .cm-activeLineGutter": {backgroundColor: "var(--mark)"},
  ".cm-cursor": {borderLeftColor: "var(--ink)"},
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground, .cm-content ::selection": {backgroundColor: "var(--chosen) !important"},
  ".cm-tooltip, .cm-panels": {backgroundColor: "var(--paper)", color: "var(--ink)", border: "1px solid var(--hair)"},
});
const nonce = document.querySelector("meta[name=style-nonce]").content;

const view = new EditorView({
  parent: at("editor"),
  state: EditorState.create({
    doc: "",
    extensions: [
      EditorView.cspNonce.of(nonce), lineNumbers(), history(), drawSelection(), highlightActiveLine(), highlightSelectionMatches(), lintGutter(),
      StreamLanguage.define(toml), syntaxHighlighting(colours), look,
      keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...lintKeymap]),
      EditorView.contentAttributes.of({"aria-label": "Design file in TOML"}),
      EditorView.updateListener.of(update => update.docChanged && set({text: update.state.doc.toString()})),
    ],
  }),
});
view.scrollDOM.tabIndex = 0;
view.scrollDOM.setAttribute("role", "group");
view.scrollDOM.setAttribute("aria-label", "Text, scrolled");

/* Put another text in its place as one change, as small as it can be, so that undo and the cursor stay useful. */
export function replace(text) {
  const old = view.state.doc.toString();
  let from = 0, end = 0;
  const most = Math.min(old.length, text.length);
  while (from < most && old[from] === text[from]) from++;
  while (end < most - from && old[old.length - 1 - end] === text[text.length - 1 - end]) end++;
  if (from === old.length && old.length === text.length) return;
  view.dispatch({changes: {from, to: old.length - end, insert: text.slice(from, text.length - end)}});
}

/* Another file: what was undone before belongs to the other one. */
export function begin(text) {
  replace(text);
}

export function goTo(number) {
  const line = view.state.doc.line(Math.max(1, Math.min(number, view.state.doc.lines)));
  view.dispatch({selection: {anchor: line.from, head: line.to}, effects: EditorView.scrollIntoView(line.from, {y: "center"})});
  view.focus();
}

function showProblems() {
  const document_ = view.state.doc;
  const marks = state.problems.map(problem => {
    const line = document_.line(Math.max(1, Math.min(problem.line || 1, document_.lines)));
    return {from: line.from, to: line.to, severity: "error", message: said(problem)};
  });
  view.dispatch(setDiagnostics(view.state, marks));
  at("problems").replaceChildren(...state.problems.map(problem => {
    const button = made("button", {type: "button", textContent: `${problem.line ? `line ${problem.line}: ` : ""}${said(problem)}`});
    button.addEventListener("click", () => goTo(problem.line || 1));
    return made("li", {}, button);
  }));
}

const said = problem => (problem.path ? `${problem.path}: ${problem.message}` : problem.message);

on("problems", showProblems);
at("undo").addEventListener("click", () => undo(view));
at("redo").addEventListener("click", () => redo(view));
