"""The copy of uPlot that draws lines over time where a reader zooms and measures: its script, its style, what it is.

`tools/uplot.mjs` makes the copy; figures that stand still are `vector`'s.
"""

import tomllib
from functools import cache
from importlib.resources import files


@cache
def text(name: str) -> str:
    """Return a file of this room.

    Args:
        name: ``uplot.min.js`` or ``uplot.min.css``.
    """
    return files("gearwright.render.uplot").joinpath(name).read_text(encoding="utf-8")


def bundled() -> dict[str, str]:
    """Return name, version, licence and digests of the copy of uPlot."""
    return {key: str(value) for key, value in tomllib.loads(text("uplot.toml")).items()}
