"""The bearings of one shaft as the design seats them, and how they share the force along it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.parts.bearings import LoadFactors, taper_pair_thrusts
from gearwright.spec import Design
from gearwright.spec.design import LOCATES, BearingSeat
from gearwright.units import text

_NOTHING = 1e-9
"""Axial over radial force below which it is rounding [-]."""


def seats_of(design: Design, shaft: str) -> dict[str, BearingSeat]:
    """Return the bearings of a shaft by name, in order along it.

    Args:
        design: The design.
        shaft: Name of the shaft.
    """
    seats = {name: seat for name, seat in design.bearings.items() if seat.shaft == shaft}
    return dict(sorted(seats.items(), key=lambda item: item[1].position))


def radial_places(seats: Mapping[str, BearingSeat]) -> tuple[float, float] | None:
    """Return where the two radial bearings of a shaft stand [m]; None where the design gives it no bearings.

    Args:
        seats: From `seats_of`.
    """
    places = [seat.position for seat in seats.values() if seat.radial]
    return (places[0], places[1]) if len(places) == 2 else None


def axial_forces(
    shaft: str,
    seats: Mapping[str, BearingSeat],
    axial: Floats,
    *,
    radial: Mapping[str, Floats],
    factors: Mapping[str, LoadFactors],
    cases: tuple[str, ...],
) -> dict[str, Floats]:
    """Return the axial force in every bearing of a shaft [N], (cases,) each.

    A force goes to the bearing that locates the shaft towards it. Two taper bearings take what `taper_pair_thrusts`
    makes of it and of their radial loads.

    Args:
        shaft: Name of the shaft.
        seats: Its bearings, from its plan.
        axial: Force along the shaft in every case, positive towards its second end [N].
        radial: Bearing -> its radial force in every case [N].
        factors: Taper bearing -> its e, X, Y.
        cases: Names of the load cases.

    Raises:
        DesignError: If nothing takes a force along the shaft.
    """
    tapers = {LOCATES[seat.locates][0]: name for name, seat in seats.items() if seat.kind == "taper"}
    taken = {name: np.zeros_like(axial) for name in seats}
    if len(tapers) == 2:
        second, first = tapers[1], tapers[-1]
        for k, force in enumerate(axial):
            pair = (float(radial[second][k]), float(radial[first][k]))
            thrusts = taper_pair_thrusts(pair, float(force), (factors[second], factors[first]))
            taken[second][k], taken[first][k] = thrusts
        return taken
    largest = max(float(np.max(force)) for force in radial.values())
    for sign in (-1, 1):
        pushed = np.maximum(sign * axial, 0.0)
        if pushed.max() > _NOTHING * largest:
            taken[_taker(shaft, seats, sign, pushed, cases)] += pushed
    return taken


def _taker(shaft: str, seats: Mapping[str, BearingSeat], sign: int, pushed: Floats, cases: tuple[str, ...]) -> str:
    """Return the bearing that takes an axial force of one sign, or say what is missing."""
    for name, seat in seats.items():
        if sign in LOCATES[seat.locates]:
            return name
    end, worst = ("first", "second")[sign > 0], int(np.argmax(pushed))
    able = [name for name, seat in seats.items() if seat.kind != "cylindrical"]
    hint = (
        f'write locates = "both" at {able[0]}'
        if able
        else 'add one of kind = "four-point" with locates = "both" and radial = false'
    )
    message = (
        f"{shaft!r} is pushed towards its {end} end with {text(float(pushed[worst]), 'force')} in case {cases[worst]},"
        f" and no bearing takes that; {hint}"
    )
    raise DesignError([Problem(f"bearings.{able[0] if able else next(iter(seats))}.locates", message)])
