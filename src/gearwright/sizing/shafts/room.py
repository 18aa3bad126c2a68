"""Parts of a built shaft that have no room beside each other, and bores that leave too little metal: refused."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.errors import DesignError, Problem, refuse
from gearwright.sizing.shafts.stretches import Item, Stretch
from gearwright.spec.checks import MOST_HOLLOW
from gearwright.units import apart, text

_OVERLAP = 1e-6
"""How far parts may stand into each other [m]."""


def refuse_overlaps(items: Sequence[Item], length: float) -> None:
    """Raise where parts stand into each other or out over an end of the shaft.

    Args:
        items: What sits on the shaft, in order.
        length: Of the shaft [m].

    Raises:
        DesignError: With the place that would do, for every such part.
    """
    edges = [("the first end", 0.0), *((item.name, item.end) for item in items)]
    problems = []
    for (before, reached), item in zip(edges, items, strict=False):
        over = reached - item.start
        if over > _OVERLAP:
            problems.append(Problem(_path(item), _close(item, before, over, item.middle + over)))
    last = items[-1]
    over = last.end - length
    if over > _OVERLAP:
        problems.append(Problem(_path(last), _close(last, "the second end", over, last.middle - over)))
    refuse(problems)


def refuse_thin(shaft: str, stretches: Sequence[Stretch], *, bore: float) -> None:
    """Raise where the bore leaves too thin a wall.

    Args:
        shaft: Its name.
        stretches: From end to end.
        bore: Of the shaft [m].

    Raises:
        DesignError: With the largest bore that would do.
    """
    thin = min(stretches, key=lambda stretch: stretch.diameter)
    if thin.diameter < bore / MOST_HOLLOW - 1e-9:
        given, most = apart(bore, MOST_HOLLOW * thin.diameter, "length")
        message = (
            f"{given} leave too thin a wall in {text(thin.diameter, 'length')} ({thin.name}); the bore may be"
            f" {MOST_HOLLOW:.0%} of that: give {most} or less"
        )
        raise DesignError([Problem(f"layout.{shaft}.bore_mm", message)])


def _close(item: Item, neighbour: str, over: float, place: float) -> str:
    return (
        f"{item.name} is {1e3 * item.width:.4g} mm wide and stands {1e3 * over:.3g} mm into {neighbour}; put its middle"
        f" at {1e3 * place:.4g} mm, or make room"
    )


def _path(item: Item) -> str:
    return f"bearings.{item.name}.position" if item.kind == "bearing" else f"layout.places.{item.name}"
