/* A plot from the keyboard: arrows move the cursor, plus and minus zoom, Home shows all, Enter sets the mark. */
const plots = new WeakMap();
const STEP = 0.01, LEAP = 0.1, ZOOM = 0.7;

export function keyed(box, plot, words) {
  if (!plots.has(box)) box.addEventListener("keydown", event => act(event, plots.get(box)));
  plots.set(box, plot);
  box.tabIndex = 0;
  box.setAttribute("role", "application");
  box.setAttribute("aria-label", `${words}. Arrow keys move the cursor, plus and minus zoom, Home shows all, Enter sets a mark.`);
}

function act(event, plot) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const share = event.shiftKey ? LEAP : STEP, [wide, high] = [plot.over.clientWidth, plot.over.clientHeight];
  const now = {left: plot.cursor.left < 0 ? wide / 2 : plot.cursor.left, top: plot.cursor.top < 0 ? high / 2 : plot.cursor.top};
  const move = (right, down) => () => point(plot, {left: held(now.left + right * share * wide, wide), top: held(now.top + down * share * high, high)});
  const action = {
    ArrowLeft: move(-1, 0), ArrowRight: move(1, 0), ArrowUp: move(0, -1), ArrowDown: move(0, 1),
    "+": () => zoom(plot, now.left, ZOOM), "-": () => zoom(plot, now.left, 1 / ZOOM),
    Home: () => plot.setScale("x", ends(plot)),
    Enter: () => { point(plot, now); plot.mark?.(); },
  }[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

const held = (value, most) => Math.max(0, Math.min(most, value));
const ends = plot => ({min: plot.data[0][0], max: plot.data[0].at(-1)});

function point(plot, place) {
  plot.keys = true; // the cursor is this plot's own, not that of another one
  plot.setCursor(place, true, true);
  plot.keys = false;
}

function zoom(plot, left, factor) {
  const {min, max} = plot.scales.x, at = plot.posToVal(left, "x"), all = ends(plot);
  plot.setScale("x", {min: Math.max(all.min, at - (at - min) * factor), max: Math.min(all.max, at + (max - at) * factor)});
}
