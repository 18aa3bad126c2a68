"""Shafts: bearing reactions, bending and torsion, deflection, and first critical speed.

What joins hubs to them is in `joints`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import DesignError, Floats, Problem

# ----------------------------------------------------------------------------------------------------------------------
# Shafts under bending and torsion by Tresca: stress, diameter, mass, torsional stiffness; solid or hollow.
# ----------------------------------------------------------------------------------------------------------------------


def shaft_stress(bending_moment: float, torque: float, diameter: float, *, bore: float = 0.0) -> float:
    """Return Tresca's equivalent stress at the surface [Pa].

    Args:
        bending_moment: [N m].
        torque: [N m].
        diameter: Outer diameter [m].
        bore: Inner diameter [m].

    Source: Pulvirenti 2023, eq. (2.47): √(σ_b² + 4 τ²) with σ_b = 32 M/(π d³), τ = 16 T/(π d³).
    """
    section = math.pi * (diameter**4 - bore**4) / (32.0 * diameter)
    return math.hypot(bending_moment, torque) / section


def shaft_diameter(bending_moment: float, torque: float, allowable: float, *, bore_ratio: float = 0.0) -> float:
    """Return the smallest outer diameter that bears bending and torsion [m].

    Args:
        bending_moment: [N m].
        torque: [N m].
        allowable: Allowable stress [Pa].
        bore_ratio: Bore over outer diameter [-].

    Source: Pulvirenti 2023, eq. (2.47) solved for d.

    >>> round(1e3 * shaft_diameter(0.0, 499.43, 785e6 / 2), 2)
    23.49
    """
    load = 32.0 * math.hypot(bending_moment, torque) / (math.pi * allowable * (1.0 - bore_ratio**4))
    return math.cbrt(load)


def shaft_diameter_around(bore: float, bending_moment: float, torque: float, *, allowable: float) -> float:
    """Return the smallest outer diameter around a given bore that bears bending and torsion [m].

    Args:
        bore: Inner diameter [m].
        bending_moment: [N m].
        torque: [N m].
        allowable: Allowable stress [Pa].

    Source: Pulvirenti 2023, eq. (2.47) for a ring: d⁴ − 32 √(M² + T²) d / (π σ) − d_i⁴ = 0, by Newton from above.

    >>> round(1e3 * shaft_diameter_around(15e-3, 0.0, 499.43, allowable=785e6 / 2), 2)
    24.67
    """
    solid = 32.0 * math.hypot(bending_moment, torque) / (math.pi * allowable)
    diameter = math.cbrt(solid) + bore
    for _ in range(50):
        step = (diameter**4 - solid * diameter - bore**4) / (4.0 * diameter**3 - solid) if diameter else 0.0
        diameter -= step
        if step <= 1e-15 * diameter:
            break
    return diameter


def shaft_mass(diameter: float, length: float, density: float, *, bore: float = 0.0) -> float:
    """Return the mass of a shaft of one diameter [kg].

    Args:
        diameter: Outer diameter [m].
        length: [m].
        density: ρ [kg/m³].
        bore: Inner diameter [m].

    Source: cylinder.
    """
    return math.pi / 4.0 * (diameter**2 - bore**2) * length * density


def shaft_inertia(mass: float, diameter: float, *, bore: float = 0.0) -> float:
    """Return the polar inertia of a shaft of one diameter [kg m²].

    Args:
        mass: [kg].
        diameter: Outer diameter [m].
        bore: Inner diameter [m].

    Source: cylinder, m (d_o² + d_i²) / 8.
    """
    return mass * (diameter**2 + bore**2) / 8.0


def torsional_stiffness(diameter: float, length: float, shear_modulus: float, *, bore: float = 0.0) -> float:
    """Return the torsional stiffness of a shaft of one diameter [N m/rad].

    Args:
        diameter: Outer diameter [m].
        length: [m].
        shear_modulus: G [Pa].
        bore: Inner diameter [m].

    Source: Pulvirenti 2023, eq. (3.12): K = π G d⁴ / (32 L).
    """
    return math.pi * shear_modulus * (diameter**4 - bore**4) / (32.0 * length)


# ----------------------------------------------------------------------------------------------------------------------
# A shaft as a beam on two bearings: reactions, shear, bending and torsion under point loads, by equilibrium alone.
#
# Planes and load cases are leading axes of the arrays, so that one call serves both planes of every case. A bearing
# gives a force and no couple; bearings and loads may stand anywhere along the shaft, in any order.
#
# Signs: x runs along the shaft from its left end. The shear force at a section is the sum of the forces left of it, the
# bending moment is the moment of these forces about the section, dM/dx = V, and the torsion is the sum of the torques
# left of it. A couple is positive if it turns as a positive force does that acts right of the origin.
# ----------------------------------------------------------------------------------------------------------------------


class PointLoads(NamedTuple):
    """What acts on a shaft at points."""

    position: Floats
    """x of every load [m], (n,)."""
    force: Floats
    """Transverse forces [N], (..., n)."""
    couple: Floats
    """Bending couples, such as an axial force times its lever [N m], (..., n)."""
    torque: Floats
    """Torques about the shaft's axis [N m], (..., n)."""


class Diagram(NamedTuple):
    """Shear, bending and torsion just left and just right of every load; straight lines lie between."""

    position: Floats
    """x, each one twice [m], (2 n,)."""
    shear: Floats
    """[N], (..., 2 n)."""
    bending: Floats
    """[N m], (..., 2 n)."""
    torsion: Floats
    """[N m], (..., 2 n)."""


def bearing_reactions(loads: PointLoads, bearings: ArrayLike) -> Floats:
    """Return the forces of two bearings on a shaft [N], (..., 2).

    Args:
        loads: What acts on the shaft [m, N, N m].
        bearings: x of the two bearings [m], (2,).

    Source: equilibrium of forces and moments; Pulvirenti 2023, eqs (2.43) and (2.45), the latter corrected.

    Raises:
        DesignError: If there are not two bearings at two places.

    >>> middle = PointLoads(np.array([0.5]), np.array([-100.0]), np.zeros(1), np.zeros(1))
    >>> bearing_reactions(middle, [0.0, 1.0]).tolist()
    [50.0, 50.0]
    """
    first, second = _two(np.asarray(bearings, dtype=float))
    moment = loads.force @ (loads.position - first) + loads.couple.sum(axis=-1)
    right = -moment / (second - first)
    return np.stack([-loads.force.sum(axis=-1) - right, right], axis=-1)


def _two(bearings: Floats) -> tuple[float, float]:
    if bearings.size != 2:
        message = (
            f"{bearings.size} given; two bearings hold a shaft: with fewer it falls, with more statics is not enough"
        )
        raise DesignError([Problem("bearings", message)])
    if bearings[0] == bearings[1]:
        raise DesignError([Problem("bearings", f"both stand at {1e3 * bearings[0]:g} mm; give two different places")])
    return float(bearings[0]), float(bearings[1])


def supported(loads: PointLoads, bearings: ArrayLike, *, length: float) -> PointLoads:
    """Return the loads with the reactions of the bearings among them, in balance.

    Args:
        loads: What acts on the shaft [m, N, N m].
        bearings: x of the two bearings [m], (2,).
        length: Of the shaft [m]; every load and bearing stands between 0 and it.

    Source: equilibrium; Pulvirenti 2023, eqs (2.43) and (2.45), the latter corrected.

    Raises:
        DesignError: If a load or a bearing stands outside the shaft.
    """
    seats = np.asarray(bearings, dtype=float)
    reactions = bearing_reactions(loads, seats)
    for entry, places in (("loads", loads.position), ("bearings", seats)):
        outside = places[(places < 0.0) | (places > length)]
        if outside.size:
            message = f"{1e3 * outside[0]:.6g} mm is outside the shaft; allowed: 0 to {1e3 * length:.6g} mm"
            raise DesignError([Problem(entry, message)])
    return PointLoads(
        np.concatenate([loads.position, seats]),
        np.concatenate([loads.force, reactions], axis=-1),
        _padded(loads.couple),
        _padded(loads.torque),
    )


def _padded(values: Floats) -> Floats:
    """Return values with zeros for the two bearings."""
    return np.concatenate([values, np.zeros((*values.shape[:-1], 2))], axis=-1)


def diagram(loads: PointLoads) -> Diagram:
    """Return shear, bending and torsion along a shaft under all that acts on it, reactions included.

    The largest bending moment stands at one of the stations, also that of both planes together, because the moment runs
    straight between them. Loads at one place keep their order.

    Args:
        loads: In balance [m, N, N m].

    Source: Pulvirenti 2023, eqs (2.44) and (2.46), the latter corrected: M(x) = Σ F_k (x − x_k) − Σ C_k over x_k < x.
    """
    order = np.argsort(loads.position, kind="stable")
    position, torque = loads.position[order], loads.torque[..., order]
    torsion = torque.cumsum(axis=-1)
    stations, twisted = position.repeat(2), _both_sides(torsion - torque, torsion)
    if not (loads.force.any() or loads.couple.any()):
        straight = np.zeros((*loads.force.shape[:-1], len(stations)))
        return Diagram(stations, straight, straight, twisted)
    force, couple = loads.force[..., order], loads.couple[..., order]
    shear = force.cumsum(axis=-1)
    carried = np.zeros(shear.shape)
    carried[..., 1:] = (shear[..., :-1] * (position[1:] - position[:-1])).cumsum(axis=-1)
    bending = carried - couple.cumsum(axis=-1)
    return Diagram(stations, _both_sides(shear - force, shear), _both_sides(bending + couple, bending), twisted)


def _both_sides(left: Floats, right: Floats) -> Floats:
    return np.stack([left, right], axis=-1).reshape(*left.shape[:-1], -1)


# ----------------------------------------------------------------------------------------------------------------------
# How a stepped shaft bends: deflection and slope along it, and the influence of loads on each other.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# First critical speed in bending of masses on a shaft.
# ----------------------------------------------------------------------------------------------------------------------


def critical_speed(coefficients: Floats, masses: ArrayLike) -> float:
    """Return the first critical speed of masses on a shaft without gyroscopic effect [rad/s].

    Args:
        coefficients: From `influence` [m/N], (n, n).
        masses: [kg], (n,).

    Source: largest root of |δ_ij m_j − I/ω²| = 0 (Budynas & Nisbett, Shigley, eqs (7-26) to (7-28)).
    """
    weights = np.asarray(masses, dtype=float)
    if weights.min(initial=0.0) < 0.0 or weights.sum() <= 0.0:
        raise DesignError([Problem("masses", f"{weights.tolist()} kg given; none is below 0, and some are above")])
    roots = np.sqrt(weights)
    return float(1.0 / math.sqrt(np.linalg.eigvalsh(roots[:, None] * coefficients * roots)[-1]))


def lumped_shaft(sections: Sections, density: float, *, pieces: int = 40) -> tuple[Floats, Floats]:
    """Return a shaft's own mass as points: places [m] and masses [kg], each (pieces,).

    Args:
        sections: Of the shaft [m].
        density: ρ [kg/m³].
        pieces: Equal lengths [-].

    Source: ρ π/4 (d² − d_i²) L of the cylinder in the middle of each piece.
    """
    edges = np.linspace(sections.edges[0], sections.edges[-1], pieces + 1)
    middle = (edges[:-1] + edges[1:]) / 2.0
    within = np.searchsorted(sections.edges, middle, side="right") - 1
    area = math.pi / 4.0 * (sections.diameter**2 - sections.bore**2)[within]
    return middle, density * area * np.diff(edges)
