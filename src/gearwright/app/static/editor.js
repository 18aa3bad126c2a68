/* The text of the design. */
import {at} from "/static/made.js";
import {on, set, state} from "/static/state.js";
import {Text} from "/static/texts.js";

const editor = new Text(at("editor"), "Design file in TOML", text => { set({text}); ends(); });

export const open = (text, draft) => editor.open(text, draft);
export const replace = (text, gesture) => editor.replace(text, gesture);
export const goTo = line => editor.goTo(line);

function ends() {
  at("undo").disabled = !editor.undoes;
  at("redo").disabled = !editor.redoes;
}

on("problems", () => editor.problems(state.problems, at("problems")));
at("undo").addEventListener("click", () => editor.undo());
at("redo").addEventListener("click", () => editor.redo());
