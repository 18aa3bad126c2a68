"""Scripts and styles of the page on which a gearbox turns, and the copy of three.js that it carries.

What the page says is in `pages`; `tools/three.mjs` makes the copy.
"""

import tomllib
from functools import cache
from importlib.resources import files

OWN = ("model.js", "view.js", "motion.js", "panel.js", "main.js")
"""Scripts of the page, in the order in which they build on each other."""


@cache
def text(name: str) -> str:
    """Return a file of this room.

    Args:
        name: Such as ``view.js``.
    """
    return files("gearwright.render.solids").joinpath(name).read_text(encoding="utf-8")


def scripts() -> tuple[str, ...]:
    """Return all scripts of the page, three.js first."""
    return (text("three.min.js"), *(text(name) for name in OWN))


def bundled() -> dict[str, str]:
    """Return name, version, licence and digest of the copy of three.js."""
    return {key: str(value) for key, value in tomllib.loads(text("three.toml")).items()}
