/* The text of the design. */
import {at} from "/static/made.js";
import {on, set, state} from "/static/state.js";
import {Text} from "/static/texts.js";

const editor = new Text(at("editor"), "Design file in TOML", text => set({text}));

export const replace = text => editor.replace(text);
export const goTo = line => editor.goTo(line);

on("problems", () => editor.problems(state.problems, at("problems")));
at("undo").addEventListener("click", () => editor.undo());
at("redo").addEventListener("click", () => editor.redo());
