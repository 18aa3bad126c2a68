"""How a stepped shaft bends: deflection and slope along it, and the influence of loads on each other."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.parts.shafts.beam import Diagram, PointLoads, diagram, supported


class Sections(NamedTuple):
    """A shaft of n cylinders, end to end."""

    edges: Floats
    """x where cylinders begin and end [m], (n + 1,)."""
    diameter: Floats
    """[m], (n,)."""
    bore: Floats
    """[m], (n,)."""


class BentLine(NamedTuple):
    """A bent shaft between and beyond its bearings."""

    position: Floats
    """x of the stations [m], (k,)."""
    deflection: Floats
    """[m], (..., k)."""
    slope: Floats
    """[rad], (..., k)."""


def flexural_rigidity(sections: Sections, position: Floats, elastic_modulus: float) -> Floats:
    """Return E I of the cylinder in which each place stands [N m²], as position.

    Args:
        sections: Of the shaft [m].
        position: x, not on an edge [m], (k,).
        elastic_modulus: E [Pa].

    Source: E π (d⁴ − d_i⁴)/64.
    """
    within = np.clip(np.searchsorted(sections.edges, position, side="right") - 1, 0, len(sections.diameter) - 1)
    return elastic_modulus * math.pi / 64.0 * (sections.diameter**4 - sections.bore**4)[within]


def bent_line(drawn: Diagram, sections: Sections, bearings: ArrayLike, *, elastic_modulus: float) -> BentLine:
    """Return deflection and slope along a shaft under its bending moments.

    The moment runs straight and the section is constant between stations, so that the integrals are exact.

    Args:
        drawn: Bending moments in balance [N m].
        sections: Of the shaft [m].
        bearings: x of the two bearings, where nothing deflects [m], (2,).
        elastic_modulus: E [Pa].

    Source: Euler and Bernoulli, E I w″ = M.

    Valid for: slender shafts; shear is left out.

    Raises:
        DesignError: If a load or bearing stands outside the shaft, or there are not two bearings.
    """
    seats = np.asarray(bearings, dtype=float)
    if seats.size != 2 or seats[0] == seats[1]:
        message = f"{seats.tolist()} given; a bent line rests on two bearings at two places"
        raise DesignError([Problem("bearings", message)])
    places = np.unique(np.concatenate([drawn.position, sections.edges, seats]))
    _check_inside(sections, np.concatenate([drawn.position, seats]))
    steps = np.diff(places)
    rigidity = flexural_rigidity(sections, places[:-1] + steps / 2.0, elastic_modulus)
    left = _moments(drawn, places[:-1] + 1e-9 * steps) / rigidity
    right = _moments(drawn, places[1:] - 1e-9 * steps) / rigidity
    slope = _summed(steps * (left + right) / 2.0)
    deflection = _summed(steps * slope[..., :-1] + steps**2 * (2.0 * left + right) / 6.0)
    at = np.searchsorted(places, seats)
    tilt = (deflection[..., at[1]] - deflection[..., at[0]]) / (places[at[1]] - places[at[0]])
    chord = deflection[..., at[0], None] + tilt[..., None] * (places - places[at[0]])
    return BentLine(places, deflection - chord, slope - tilt[..., None])


def _check_inside(sections: Sections, places: Floats) -> None:
    first, last = sections.edges[0], sections.edges[-1]
    outside = places[(places < first - 1e-12) | (places > last + 1e-12)]
    if outside.size:
        message = f"{1e3 * outside[0]:.6g} mm is outside the shaft; allowed: {1e3 * first:.6g} to {1e3 * last:.6g} mm"
        raise DesignError([Problem("loads", message)])


def _moments(drawn: Diagram, places: Floats) -> Floats:
    """Return the bending moment at places, zero beyond the outermost loads, in every plane."""
    inside = (places >= drawn.position[0]) & (places <= drawn.position[-1])
    return np.where(inside, between(drawn.position, drawn.bending, places), 0.0)


def between(stations: Floats, values: Floats, places: Floats) -> Floats:
    """Return all rows of values straight between stations, and as at the ends beyond them, (..., n).

    Args:
        stations: x, never falling [m], (k,).
        values: At the stations [any unit], (..., k).
        places: x [m], (n,).

    Source: linear interpolation.
    """
    left = np.minimum(np.maximum(stations.searchsorted(places, side="right") - 1, 0), len(stations) - 1)
    right = np.minimum(left + 1, len(stations) - 1)
    start, past = values.take(left, axis=-1), places - stations[left]
    steps = stations[right] - stations[left]
    flat = (past <= 0.0) | (steps <= 0.0)
    rise = values.take(right, axis=-1) - start
    return np.where(flat, start, rise / np.where(flat, 1.0, steps) * past + start)


def _summed(pieces: Floats) -> Floats:
    """Return running sums that begin at zero."""
    return np.concatenate([np.zeros((*pieces.shape[:-1], 1)), np.cumsum(pieces, axis=-1)], axis=-1)


def influence(sections: Sections, bearings: ArrayLike, places: ArrayLike, *, elastic_modulus: float) -> Floats:
    """Return the deflection at every place for a force of 1 N at every other [m/N], (n, n), symmetric.

    Args:
        sections: Of the shaft [m].
        bearings: x of the two bearings [m], (2,).
        places: x of the forces [m], (n,).
        elastic_modulus: E [Pa].

    Source: Maxwell 1864; Budynas & Nisbett, Shigley's Mechanical Engineering Design, eq. (7-24).

    Raises:
        DesignError: If a place or bearing stands outside the shaft.
    """
    stations = np.asarray(places, dtype=float)
    none = np.zeros((len(stations), len(stations)))
    loads = PointLoads(stations, np.eye(len(stations)), none, none)
    balanced = supported(loads, bearings, length=float(sections.edges[-1]))
    line = bent_line(diagram(balanced), sections, bearings, elastic_modulus=elastic_modulus)
    return line.deflection[:, np.searchsorted(line.position, stations)]
