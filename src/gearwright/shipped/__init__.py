"""Design files that come with gearwright; `gearwright new` copies them."""

from __future__ import annotations

from pathlib import Path

from gearwright.errors import DesignError, Problem, near

_DESIGNS = Path(__file__).parent / "designs"


def shipped_designs() -> tuple[str, ...]:
    """Return the names of all shipped designs."""
    return tuple(sorted(path.stem for path in _DESIGNS.glob("*.toml")))


def shipped_design(name: str) -> Path:
    """Return the path of a shipped design file.

    Args:
        name: Such as ``in-line-h2``.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name not in shipped_designs():
        raise DesignError([Problem("name", f"there is no shipped design {name!r}; {near(name, shipped_designs())}")])
    return _DESIGNS / f"{name}.toml"
