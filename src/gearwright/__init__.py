"""gearwright designs aircraft transmissions and shows how they behave.

>>> import gearwright as gw
>>> design = gw.read(gw.shipped_design("in-line-h2"))
>>> sizing = gw.size(design)
>>> round(sizing.gear_mass, 1)
34.0
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from gearwright.version import __version__ as __version__

if TYPE_CHECKING:
    from gearwright.dynamics import Model, Outputs, modes, simulate
    from gearwright.dynamics.assembly import assemble
    from gearwright.errors import DesignError, SolveError
    from gearwright.render.pages.report import report
    from gearwright.reviews import review
    from gearwright.shipped import shipped_design, shipped_designs
    from gearwright.sizing import size
    from gearwright.spec import parse, read, schema
    from gearwright.store import StoredRun, load, save

_VERBS = {
    "DesignError": "errors",
    "Model": "dynamics",
    "Outputs": "dynamics",
    "SolveError": "errors",
    "StoredRun": "store",
    "assemble": "dynamics.assembly",
    "load": "store",
    "modes": "dynamics",
    "parse": "spec",
    "read": "spec",
    "report": "render.pages.report",
    "review": "reviews",
    "save": "store",
    "schema": "spec",
    "shipped_design": "shipped",
    "shipped_designs": "shipped",
    "simulate": "dynamics",
    "size": "sizing",
}
"""Public name -> module; loaded on first use, so that ``gearwright --help`` stays quick."""

__all__ = [
    "DesignError",
    "Model",
    "Outputs",
    "SolveError",
    "StoredRun",
    "assemble",
    "load",
    "modes",
    "parse",
    "read",
    "report",
    "review",
    "save",
    "schema",
    "shipped_design",
    "shipped_designs",
    "simulate",
    "size",
]


def __getattr__(name: str) -> object:
    """Load a public verb on its first use."""
    if name not in _VERBS:
        raise AttributeError(f"module 'gearwright' has no attribute {name!r}")
    value: object = getattr(import_module(f"gearwright.{_VERBS[name]}"), name)
    return value
