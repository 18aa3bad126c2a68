/* One keystroke: the text waits a moment, is sized, and every pane follows; what is older is dropped. */
import {Dropped, Problems, ask} from "/static/api.js";
import {start} from "/static/files.js";
import {at} from "/static/made.js";
import {on, set, state} from "/static/state.js";
import "/static/form.js";
import "/static/numbers.js";
import "/static/flow.js";
import "/static/why.js";
import "/static/closing.js";
import "/static/viewer.js";
import "/static/compare.js";
import "/static/dynamics/dynamics.js";
import "/static/flight/flight.js";
import "/static/studies/studies.js";

const PAUSE = 120; // after the last keystroke [ms]
let timer = 0, asked = 0;

async function follow() {
  const text = state.text, mine = ++asked, begun = performance.now();
  try {
    const sizing = ask("size", text);
    laid(text, mine);
    const answer = {...(await (await sizing).json()), text};
    if (mine !== asked) return;
    const pinned = state.pinned || {text, answer};
    set({answer, pinned, problems: [], stale: false});
    at("status").textContent = `sized in ${Math.round(performance.now() - begun)} ms`;
  } catch (reason) {
    if (reason instanceof Dropped || mine !== asked) return;
    if (reason instanceof Problems) { set({problems: reason.problems, stale: true}); at("status").textContent = "a problem in the text: see Design"; }
    else at("status").textContent = reason.message;
  }
  document.body.dataset.ready = String(mine);
}

/* The form follows the text as long as that is TOML, whatever else is wrong with it. */
async function laid(text, mine) {
  try {
    const form = await (await ask("form", text)).json();
    if (mine === asked) set({form});
  } catch (reason) {
    if (!(reason instanceof Dropped || reason instanceof Problems)) at("status").textContent = reason.message;
  }
}

function show() {
  const known = [...document.querySelectorAll("main > section")].map(section => section.id);
  const view = known.includes(location.hash.slice(1)) ? location.hash.slice(1) : known[0];
  for (const id of known) at(id).hidden = id !== view;
  for (const link of document.querySelectorAll("nav a")) {
    if (link.dataset.view === view) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  set({view});
}

on("text", () => {
  clearTimeout(timer);
  timer = setTimeout(follow, state.answer && !state.entered ? PAUSE : 0);
});
addEventListener("hashchange", show);
show();
start().catch(reason => { at("status").textContent = reason.message; });
