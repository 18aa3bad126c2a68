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
ASIDE = frozenset({"influences"})
"""Those of them that have a process of their own, as they take seconds where a standard rates gears."""
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
