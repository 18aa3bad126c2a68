/* Drawings of the server in the page: their rules of style go into a sheet of their own, as the page's policy allows none inside. */
const sheets = new Map();

export function drawing(text, name) {
  if (!sheets.has(name)) {
    sheets.set(name, new CSSStyleSheet());
    document.adoptedStyleSheets.push(sheets.get(name));
  }
  const rules = /<style>(.*?)<\/style>/s.exec(text);
  sheets.get(name).replaceSync(rules ? rules[1] : "");
  const drawn = document.adoptNode(new DOMParser().parseFromString(rules ? text.replace(rules[0], "") : text, "image/svg+xml").documentElement);
  drawn.removeAttribute("width");
  drawn.removeAttribute("height");
  return drawn;
}
