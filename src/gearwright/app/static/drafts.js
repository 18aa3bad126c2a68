/* Texts that are not saved, and which file is open: this window keeps them, so that a reload, or another file and back, finds them. */
const of = (kind, choice) => `draft of ${kind} ${choice}`;

/* What is not saved of a file, with the tag of the text that it was made from; null where nothing is. */
export const draft = (kind, choice) => JSON.parse(sessionStorage.getItem(of(kind, choice)));

function forget(kind, choice) { sessionStorage.removeItem(of(kind, choice)); }

export function keep(kind, choice, {text, saved, tag}) {
  forget(kind, choice); // a window keeps a few megabytes: where they are full, none is better than one of before
  try {
    if (text !== saved) sessionStorage.setItem(of(kind, choice), JSON.stringify({text, tag}));
  } catch { /* it is full */ }
}

export function opened(kind, choice) { sessionStorage.setItem(`open ${kind}`, choice); }

/* The file that was open last, if it is among those that there are. */
export function last(kind, choices) {
  const choice = sessionStorage.getItem(`open ${kind}`);
  return choices.includes(choice) ? choice : null;
}
