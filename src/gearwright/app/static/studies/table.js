/* Rows of a study as numbers by name, and the best of them as a table. */
import {made, named, told} from "/static/made.js";

const LISTED = 30;

/* Numbers that vary, inputs first; rows that cannot be built are left out. */
export function flat(found) {
  const rows = found.rows.map((row, k) => ({...row, at: k, front: found.front.includes(k), values: {...numeric(row.inputs), ...numeric(row.results)}})).filter(row => !row.problem);
  const names = [...new Set(rows.flatMap(row => Object.keys(row.values)))];
  const columns = names.filter(name => { const first = rows[0].values[name]; return rows.some(row => row.values[name] !== first); });
  const wish = Object.entries(found.objectives || {})[0], goal = wish ? names.find(name => name === wish[0] || name.startsWith(`${wish[0]}_`)) : "";
  const limits = (found.kept || []).map(bound => ({...bound, column: names.find(name => name === bound.result || name.startsWith(`${bound.result}_`))})).filter(bound => bound.column);
  return {rows, columns: columns.length ? columns : names.slice(0, 2), goal, sign: wish?.[1] === "maximum" ? -1 : 1, limits, changes: found.changes || {}};
}

const numeric = record => Object.fromEntries(Object.entries(record).filter(([, value]) => typeof value === "number"));

export function held(table, row) {
  return table.limits.every(({column, minimum, maximum}) => (minimum === null || row.values[column] >= minimum) && (maximum === null || row.values[column] <= maximum));
}

export function title(name) {
  const last = name.split(".").slice(-2).join(" "), [words, unit] = named(last);
  return unit ? `${words} [${unit}]` : words;
}

export function listed(box, table, rows, picked) {
  const sorted = [...rows].sort((a, b) => held(table, b) - held(table, a) || (table.goal ? table.sign * (a.values[table.goal] - b.values[table.goal]) : a.at - b.at)).slice(0, LISTED);
  const body = sorted.map(row => {
    const open = made("button", {type: "button", textContent: row.design});
    open.addEventListener("click", () => picked(row));
    return made("tr", {className: held(table, row) ? "" : "fails"}, made("th", {scope: "row"}, open), ...table.columns.map(name => made("td", {textContent: told(name, row.values[name])})), made("td", {textContent: row.front ? "front" : held(table, row) ? "" : "breaks a limit"}));
  });
  box.replaceChildren(made("table", {}, made("caption", {textContent: `The first ${sorted.length}; click one to open it`}), made("thead", {}, made("tr", {}, ...["design", ...table.columns.map(title), ""].map(textContent => made("th", {scope: "col", textContent})))), made("tbody", {}, ...body)));
}
