"""Studies: the same verbs over many designs."""

from importlib import import_module
from typing import TYPE_CHECKING

from gearwright.base import callable_layer
from gearwright.study.engine import for_engine, for_requirement
from gearwright.study.running import compare, fly_many, run
from gearwright.study.tables import Row, Table

if TYPE_CHECKING:
    from gearwright.study.architectures import EqualLife, equal_life

__all__ = ["EqualLife", "Row", "Table", "compare", "equal_life", "fly_many", "for_engine", "for_requirement", "run"]

callable_layer(__name__, run)


def __getattr__(name: str) -> object:
    """Load what closes and reviews designs on its first use: workers of studies start sooner without."""
    if name not in ("EqualLife", "equal_life"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module("gearwright.study.architectures"), name)
