"""What the page may ask: verb -> module of this folder that has a function of that name. It loads nothing itself."""

from __future__ import annotations

QUICK = {
    "edit": "verbs",
    "flow": "verbs",
    "form": "verbs",
    "influences": "verbs",
    "meaning": "verbs",
    "model": "verbs",
    "schematic": "verbs",
    "size": "verbs",
}
"""What answers at once."""
BESIDE = {"form": "form", "meaning": "form", "influences": "influences"}
"""Those that need no sizing, or take seconds where a standard rates gears -> a process in which no number waits."""
LIMITS = {"form": 60.0, "influences": 900.0}
"""After which an answer of such a process is no longer waited for [s]."""
LONG = {
    "campbell": "motions",
    "close": "closing",
    "export": "verbs",
    "fly": "flights",
    "mission": "flights",
    "modes": "motions",
    "moved": "trials",
    "report": "verbs",
    "resume": "trials",
    "review": "verbs",
    "rows": "trials",
    "runup": "motions",
    "simulate": "motions",
    "study": "trials",
    "variant": "trials",
    "window": "flights",
}
"""Jobs, which tell how far they are, in processes that can be ended."""
