/* What one gesture changes is undone by one step: while a pointer or a key is held on an entry, and what follows at once. */
const REST = 1000; // after which a gesture is over [ms]
let gesture = {}, held = false, time = 0;

/* The gesture that a change of an entry belongs to. */
export function gestureOf(entry) {
  const now = performance.now();
  if (gesture.entry !== entry || (!held && now - time > REST)) gesture = {entry};
  time = now;
  return gesture;
}

function press(event) {
  if (event.type === "pointerdown" || (!event.repeat && performance.now() - time > REST)) gesture = {};
  held = true;
}

function release() { [held, time] = [false, performance.now()]; }

for (const kind of ["pointerdown", "keydown"]) addEventListener(kind, press, true);
for (const kind of ["pointerup", "pointercancel", "keyup"]) addEventListener(kind, release, true);
addEventListener("blur", release); // of the window
