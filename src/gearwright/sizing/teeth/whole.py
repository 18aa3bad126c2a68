"""Whole trains against forbidden bands of frequencies that no stage alone can be held against."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.sizing.teeth.forbidden import ends_of, taken
from gearwright.spec import Design, edited
from gearwright.spec.design import cases_forbidding
from gearwright.train import Train, Turning, build_train, passes, power_flow

Teeth = tuple[Mapping[str, int], Mapping[str, int]]
"""Gear -> tooth number, and planetary set -> number of planets where the design leaves it open [-]."""
TRIED = 2_000
"""Trains that are held against them [-]."""


def clear_places(
    design: Design, train: Train, bands: Set[str], trains: Iterable[tuple[int, Teeth]], *, wanted: int,
) -> list[int]:  # fmt: skip
    """Return the places of the first trains that pass at no frequency of some bands, as many as are wanted.

    Args:
        design: With its cases.
        train: Its graph.
        bands: Names of bands.
        trains: Place and teeth of each, the lightest first.
        wanted: How many [-].

    Raises:
        DesignError: If none of those that are tried is clear, with the bands.
    """
    clear, tried = list[int](), 0
    for place, (teeth, planets) in trains:
        if len(clear) == wanted or tried == TRIED:
            break
        tried += 1
        if _is_clear(design, train, bands, teeth, planets):
            clear.append(place)
    if not clear:
        raise DesignError(_problems(design, bands, tried))
    return clear


def _is_clear(
    design: Design, train: Train, bands: Set[str], teeth: Mapping[str, int], planets: Mapping[str, int]
) -> bool:
    """Tell whether a train passes at no frequency of some bands in any of their cases."""
    if planets:
        design = edited(design, {f"planetaries.{stage}.planets": count for stage, count in planets.items()})
        train = build_train(design)
    turning = Turning(design, train, teeth)
    for name in bands:
        band = design.teeth.forbidden[name]
        for case in cases_forbidding(design, band):
            flow = power_flow(design, train, teeth, case, turning=turning)
            frequencies = [frequency for _, frequency in passes(design, train, teeth, flow, band.of)]
            if taken(band, np.array(frequencies)).any():
                return False
    return True


def _problems(design: Design, bands: Set[str], tried: int) -> Iterator[Problem]:
    most = "" if tried < TRIED else " lightest"
    for name in sorted(bands):
        band = design.teeth.forbidden[name]
        message = (
            f"none of the {tried}{most} trains that the rules of [teeth] allow keeps out of {ends_of(band)} in every"
            " case, with what else is forbidden; narrow the band, limit its cases, or allow more in [teeth] or in the"
            " speeds"
        )
        yield Problem(f"teeth.forbidden.{name}", message)
