/* What a rating says of a mesh: what moves its safeties, and every factor with equation and clause. */
import {made, number, percent} from "/static/made.js";

export function handles(mesh) {
  return [
    made("h3", {textContent: `What would change ${mesh.mesh}`}),
    made("table", {}, made("caption", {textContent: "Change of the safeties for 1 % more of each"}), made("thead", {}, made("tr", {}, ...["value", "flanks", "roots", "for a margin of 1"].map(text => made("th", {scope: "col", textContent: text})))),
      made("tbody", {}, ...mesh.handles.map(one => made("tr", {},
        made("th", {scope: "row", textContent: `${one.handle} ${number(one.value)} ${one.unit}`}),
        ...[one.flank, one.root].map(share => made("td", {textContent: share === null ? "–" : percent(share / 100)})),
        made("td", {textContent: one.wanted === null ? "–" : `${number(one.wanted)} ${one.unit}`}))))),
  ];
}

export function factors(mesh) {
  const rows = mesh.factors.map(one => made("tr", {title: one.limit}, made("th", {scope: "row", textContent: `${one.quantity}${one.limit ? " (at its limit)" : ""}`}), made("td", {className: "formula", textContent: one.equation}),
    made("td", {textContent: `${one.values.map(value => number(value)).join(", ")} ${one.unit}`}), made("td", {className: "hint", textContent: one.clause})));
  return made("details", {}, made("summary", {textContent: `Every factor of ${mesh.mesh}: ${mesh.method}, ${mesh.edition}`}), made("table", {}, made("tbody", {}, ...rows)));
}
