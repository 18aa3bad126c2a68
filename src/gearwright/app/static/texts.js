/* Editors of TOML texts, with what is wrong at its line. */
import {
  Annotation, EditorState, EditorView, HighlightStyle, StreamLanguage, defaultKeymap, drawSelection, highlightActiveLine, highlightSelectionMatches,
  history, historyKeymap, keymap, lineNumbers, lintGutter, lintKeymap, redo, searchKeymap, setDiagnostics, syntaxHighlighting, tags, toml, undo,
} from "/static/vendor/codemirror.min.js";
import {made} from "/static/made.js";

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
const said = problem => (problem.path ? `${problem.path}: ${problem.message}` : problem.message);

const gestured = Annotation.define(); // by which gesture of the form a text was changed
const TYPED = 500; // a pause that ends what is typed in one go [ms]

export class Text {
  constructor(parent, label, changed) {
    Object.assign(this, {changed, gesture: null, time: 0});
    this.extensions = [
      EditorView.cspNonce.of(nonce), lineNumbers(), history({newGroupDelay: Infinity, joinToEvent: (...change) => this.goesOn(...change)}),
      drawSelection(), highlightActiveLine(), highlightSelectionMatches(), lintGutter(),
      StreamLanguage.define(toml), syntaxHighlighting(colours), look,
      keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...lintKeymap]),
      EditorView.contentAttributes.of({"aria-label": label}),
      EditorView.updateListener.of(update => update.docChanged && this.follow(update.transactions.at(-1))),
    ];
    this.view = new EditorView({parent, state: this.fresh("")});
    this.view.scrollDOM.tabIndex = 0;
    this.view.scrollDOM.setAttribute("role", "group");
    this.view.scrollDOM.setAttribute("aria-label", `${label}, scrolled`);
  }

  get text() { return this.view.state.doc.toString(); }

  get undoes() { return undo({state: this.view.state, dispatch: () => {}}); }

  get redoes() { return redo({state: this.view.state, dispatch: () => {}}); }

  fresh(doc) { return EditorState.create({doc, extensions: this.extensions}); }

  /* What is typed in one go is undone in one go, and so is one gesture of the form; nothing else belongs together. */
  goesOn(change, adjacent) {
    const gesture = change.annotation(gestured), typed = change.isUserEvent("input.type") || change.isUserEvent("delete");
    if (gesture || this.gesture) return gesture === this.gesture;
    return typed && adjacent && performance.now() - this.time < TYPED;
  }

  follow(change) {
    Object.assign(this, {gesture: change.annotation(gestured), time: performance.now()});
    this.changed(this.text);
  }

  /* Another file: its history begins here. What of it is not saved yet is the first step, which undo takes back. */
  open(text, draft = text) {
    this.gesture = null;
    this.view.setState(this.fresh(text));
    if (draft === text) this.changed(text);
    else this.replace(draft);
  }

  /* Put another text in its place as one change, as small as it can be, so that undo and the cursor stay useful. */
  replace(text, gesture = {}) {
    const old = this.text;
    let from = 0, end = 0;
    const most = Math.min(old.length, text.length);
    while (from < most && old[from] === text[from]) from++;
    while (end < most - from && old[old.length - 1 - end] === text[text.length - 1 - end]) end++;
    if (from === old.length && old.length === text.length) return;
    this.view.dispatch({changes: {from, to: old.length - end, insert: text.slice(from, text.length - end)}, annotations: gestured.of(gesture)});
  }

  undo() { undo(this.view); }

  redo() { redo(this.view); }

  goTo(number) {
    const {view} = this, line = view.state.doc.line(Math.max(1, Math.min(number, view.state.doc.lines)));
    view.dispatch({selection: {anchor: line.from, head: line.to}, effects: EditorView.scrollIntoView(line.from, {y: "center"})});
    view.focus();
  }

  problems(found, list) {
    const document_ = this.view.state.doc;
    const marks = found.map(problem => {
      const line = document_.line(Math.max(1, Math.min(problem.line || 1, document_.lines)));
      return {from: line.from, to: line.to, severity: "error", message: said(problem)};
    });
    this.view.dispatch(setDiagnostics(this.view.state, marks));
    list.replaceChildren(...found.map(problem => {
      const button = made("button", {type: "button", textContent: `${problem.line ? `line ${problem.line}: ` : ""}${said(problem)}`});
      button.addEventListener("click", () => this.goTo(problem.line || 1));
      return made("li", {}, button);
    }));
  }
}
