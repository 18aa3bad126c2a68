"""The scripts that make figures of pages answer a pointer; numbers come from `vector`, lines from uPlot."""

from functools import cache
from importlib.resources import files

OWN = ("panel.js", "live.js")
"""Scripts, in the order in which they build on each other."""
PARALLEL = "parallel.js"
"""What pages with parallel axes need beside them."""


@cache
def text(name: str) -> str:
    """Return a file of this room.

    Args:
        name: Such as ``live.js``.
    """
    return files("gearwright.render.live").joinpath(name).read_text(encoding="utf-8")
