/* A design whose free sizes meet every check, as `gearwright close` finds it; where none does, what is not met and what helps. */
import {offered} from "/static/files.js";
import {Task, begin} from "/static/jobs.js";
import {at, change, made, number, percent, ratio} from "/static/made.js";
import {on, set, state} from "/static/state.js";

let of = ""; // the text that is closed

new Task(at("close-line"), "Make it pass", told => {
  if (!state.answer) return null;
  at("unmet").replaceChildren();
  const mine = of = state.text, {name} = state;
  return {...begin("close", of, {variants: at("variants").checked, anew: at("anew").checked}, told), taken: async answer => { if (mine === of && name === state.name) show(await answer.json()); }};
});
at("close-line").firstChild.title = "gearwright close: choose every free size so that all checks are met";

/* What was found is of the text that it was asked of; of another one it is greyed, and says so. */
function old() {
  const changed = Boolean(of) && state.text !== of && at("unmet").childElementCount > 0;
  at("unmet").classList.toggle("old", changed);
  if (changed && !at("unmet").querySelector(".since")) at("unmet").prepend(made("p", {className: "since", textContent: "The text has changed since: this is of the one before."}));
  if (!changed) at("unmet").querySelector(".since")?.remove();
}

function show(found) {
  const options = [[found.design_file, `${found.unmet.length ? "as far as it came" : "as it was closed"}, ${weighed(found.complete_mass_kg)}`]];
  if (found.variant) options.unshift([found.variant.design_file, `${found.variant.what}, ${weighed(found.variant.complete_mass_kg)}`]);
  const buttons = options.map(([text, words]) => {
    const button = made("button", {type: "button", textContent: `Open ${words}`});
    button.addEventListener("click", () => { offered(text, words); at("unmet").replaceChildren(); });
    return button;
  });
  const unmet = found.unmet.map(one => made("li", {}, pick(one.check.part), ` ${one.check.mode}: margin ${ratio(one.check.reserve ?? one.check.ratio)}. What helps: ${one.helps}${one.kept ? `. Given and kept: ${one.kept}` : ""}`));
  const tried = found.tried.map(one => made("li", {className: "hint", textContent: `${one.what} does not meet ${one.why}`}));
  at("unmet").replaceChildren(made("p", {textContent: found.variant ? `A variant meets everything: ${found.variant.what}.` : found.headline}), ...buttons, made("ul", {}, ...unmet, ...tried));
  at("unmet").scrollTop = 0;
  old();
  document.body.dataset.closed = found.outcome;
}

/* Beside what stands on the page. */
function weighed(mass) {
  const share = percent(change(mass, state.answer.result.complete_total_kg));
  return `${number(mass)} kg complete${share ? ` (${share === "=" ? "as now" : share})` : ""}`;
}

function pick(part) {
  const button = made("button", {type: "button", className: "why-button", textContent: part});
  button.addEventListener("click", () => set({selected: part}));
  return button;
}

on("text", old);
on("name", () => { of = ""; at("unmet").replaceChildren(); }); // what was found for one file is not opened under the name of another
