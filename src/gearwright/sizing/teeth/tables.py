"""Which teeth of planetary sets can be put together, tabulated once: the search looks them up for every ratio asked."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.sizing.teeth.candidates import Reach, admissible, candidates, planet_counts, whole_below
from gearwright.sizing.teeth.closing import is_shifted
from gearwright.sizing.teeth.front import Front, Task
from gearwright.spec import Design, Planetary

LARGEST = 4096
"""Teeth of planets that are tabulated; sets of larger ones are looked at one by one [-]."""
_KEPT = 64
"""Tables that are kept [-]."""
_KNOWN: dict[tuple[Any, ...], Any] = {}


def admitted(task: Task, design: Design, small: Ints, large: Ints) -> Bools:
    """Tell which teeth some number of planets admits.

    Args:
        task: The stage.
        design: With the rules of the search.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
    """
    fits = [admissible(task, design, small, large, planets=n) for n in planet_counts(task.name, design)]
    return fits[0] if len(fits) == 1 else np.any(fits, axis=0)


def admitted_candidates(
    front: Front, task: Task, design: Design, target: Floats, *, reach: Reach
) -> tuple[Ints, Ints, Ints]:
    """Return the candidates for every ratio asked that some number of planets admits.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
        target: Tooth ratio asked of every choice [-].
        reach: How far it looks.

    Returns:
        Choice that each extends, teeth of pinion and wheel, or of sun and planet.
    """
    stage, rules = task.stage, design.teeth
    given = not isinstance(stage, Planetary) or stage.sun_teeth or stage.planet_teeth or stage.ring_teeth
    if not (given or is_shifted(task, design)):
        suns = np.arange(rules.sun_minimum, rules.largest_sun(reach.largest_sun) + 1)
        low = whole_below((target[:, None] - 1.0) * suns / 2.0)
        size = 1 << int(low.max(initial=255)).bit_length()
        if size <= LARGEST:
            windows = _windows(task, design, suns, size=size, around=reach.around)
            return _looked_up(windows, low, suns, reach.around)
    parent, small, large = candidates(front, task, design, target, reach=reach)
    fits = admitted(task, design, small, large)
    return parent[fits], small[fits], large[fits]


def _windows(task: Task, design: Design, suns: Ints, *, size: int, around: int) -> Any:
    """Return of every sun and planet, bit for bit, which of the planets around that one are admitted.

    Args:
        task: A planetary set of which no teeth are given, and none are shifted.
        design: With the rules of the search.
        suns: Teeth of suns that are looked at [-].
        size: Teeth beyond those of the largest planet [-].
        around: Tooth numbers on either side [-].
    """
    rules, counts = design.teeth, tuple(planet_counts(task.name, design))
    key = (counts, rules.planet_minimum, rules.hunting, len(suns), *suns[:1].tolist(), size, around)
    if key not in _KNOWN:
        if len(_KNOWN) >= _KEPT:
            _KNOWN.clear()
        planets = np.arange(size + around)
        grid = (np.broadcast_to(axis, (len(suns), len(planets))) for axis in (suns[:, None], planets))
        fits = admitted(task, design, *grid).astype(np.uint8)
        windows = np.zeros((len(suns), size), dtype=np.uint8)
        for bit in range(2 * around):
            windows |= fits[:, np.maximum(planets[:size] + 1 - around + bit, 1)] << np.uint8(bit)
        _KNOWN[key] = windows
    return _KNOWN[key]


def _looked_up(windows: Any, low: Ints, suns: Ints, around: int) -> tuple[Ints, Ints, Ints]:
    """Return the choice that each candidate extends, and the teeth of sun and planet.

    Args:
        windows: From `_windows`.
        low: (choices, suns) teeth of the planet below the wanted one [-].
        suns: Their teeth [-].
        around: Tooth numbers on either side [-].
    """
    count, size = windows.shape
    codes = windows.ravel()[low + size * np.arange(count)].ravel()
    some = np.flatnonzero(codes)
    owner, bit = np.nonzero(np.unpackbits(codes[some, None], axis=1, count=2 * around, bitorder="little"))
    place = some[owner]
    parent = place // count
    return parent, suns[place - parent * count], np.maximum(low.ravel()[place] + 1 - around + bit, 1)
