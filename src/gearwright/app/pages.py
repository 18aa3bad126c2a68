"""The files that the browser gets: the page, its scripts and styles, and the scripts that turn the gearbox.

Only what is listed here is ever given out, by its name alone.
"""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files as resources
from importlib.resources.abc import Traversable
from typing import Any, NamedTuple

NONCE = "THE-NONCE"
"""In the page, where a number that is used once stands."""
ROOMS = ("dynamics", "flight", "studies", "vendor")
"""Folders of scripts."""
LENT = {
    "solids": ("three.min.js", "model.js", "view.js", "motion.js", "panel.js"),
    "uplot": ("uplot.min.js", "uplot.min.css"),
}
"""Files that pages of `render` have too."""
_KINDS = {"js": "text/javascript", "css": "text/css", "svg": "image/svg+xml"}


class Given(NamedTuple):
    """A file that is given out."""

    at: Traversable
    kind: str

    def read_bytes(self) -> bytes:
        """Return its content."""
        return self.at.read_bytes()


@cache
def files() -> dict[str, Given]:
    """Return name in the address -> file."""
    own = resources("gearwright.app") / "static"
    found = {at.name: at for at in own.iterdir()}
    found |= {f"{room}/{at.name}": at for room in ROOMS for at in (own / room).iterdir()}
    for name, given in LENT.items():
        found |= {f"{name}/{file}": resources(f"gearwright.render.{name}") / file for file in given}
    kinds = {name: _KINDS.get(name.rpartition(".")[2], "") for name in found}
    return {name: Given(at, kinds[name]) for name, at in found.items() if kinds[name]}


@cache
def index() -> str:
    """Return the page."""
    return (resources("gearwright.app") / "static" / "index.html").read_text(encoding="utf-8")


def bundled() -> dict[str, Any]:
    """Return bundle -> version of its packages, their licences and its digest."""
    place = resources("gearwright.app") / "static" / "vendor" / "vendor.toml"
    return tomllib.loads(place.read_text(encoding="utf-8"))
