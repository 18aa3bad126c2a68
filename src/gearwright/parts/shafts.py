"""Shafts: bearing reactions, bending, torsion, first critical speed, and the joints between shaft and hub."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import DesignError, Floats, Problem
from gearwright.units import Density, Length, Ratio, Stress

# ----------------------------------------------------------------------------------------------------------------------
# Shafts: bearing reactions, bending and torsion, deflection, and first critical speed.
#
# What joins hubs to them is in `joints`.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Shaft-hub joints: parallel keys, involute splines and interference fits.
#
# The notches that they make in the shaft are in `shafts`.
# ----------------------------------------------------------------------------------------------------------------------


# ----------------------------------------------------------------------------------------------------------------------
# Parallel keys: pressure on their flanks by DIN 6892, and shear and bearing by Shigley.
# ----------------------------------------------------------------------------------------------------------------------


TWO_KEYS_SHARE = 0.75
"""φ: what each of two keys bears, because they do not fit alike [-] (DIN 6892:2012, method C)."""
LONGEST_BEARING = 1.3
"""l_tr/d beyond which more length does not bear more [-] (DIN 6892:2012)."""


@dataclass(frozen=True)
class KeySection:
    """Section of a parallel key and of its keyways."""

    width: Length
    """b [m]."""
    height: Length
    """h [m]."""
    shaft_depth: Length
    """t_1, depth of the keyway in the shaft [m]."""
    hub_depth: Length
    """t_2, depth of the keyway in the hub [m]."""


def bearing_length(section: KeySection, length: float, hub_length: float) -> float:
    """Return the length of a key with round ends that bears on its flanks l_tr [m].

    Args:
        section: Of the key [m].
        length: l, with the round ends [m].
        hub_length: [m].

    Source: DIN 6892:2012, form A: l_tr = l − b.

    Raises:
        DesignError: If the key is longer than its hub, or all round ends.
    """
    if length > hub_length:
        message = f"{1e3 * length:g} mm is longer than its hub; allowed: up to {1e3 * hub_length:g} mm"
        raise DesignError([Problem("key.length", message)])
    if length <= section.width:
        message = f"{1e3 * length:g} mm leaves no flat flank; allowed: above {1e3 * section.width:g} mm"
        raise DesignError([Problem("key.length", message)])
    return length - section.width


def key_pressure(torque: float, diameter: float, section: KeySection, *, bearing_length: float, keys: int = 1) -> float:
    """Return the mean pressure on the flank of a key in the hub [Pa].

    Args:
        torque: T [N m].
        diameter: d of the shaft [m].
        section: Of the key [m].
        bearing_length: l_tr [m].
        keys: One, or two opposite ones [-].

    Source: DIN 6892:2012, method C: p = 2 T / (d (h − t_1) l_tr i φ), φ = 1 for one key and 0.75 for two.

    Valid for: one or two keys.

    Raises:
        DesignError: If there are neither one nor two keys.

    >>> section = KeySection(14e-3, 9e-3, 5.5e-3, 3.8e-3)
    >>> round(key_pressure(500.0, 0.05, section, bearing_length=0.056) / 1e6, 2)
    102.04
    """
    return 2.0 * torque / (diameter * _bearing_height(section) * bearing_length * _effective(keys))


def key_length(torque: float, diameter: float, section: KeySection, *, allowable: float, keys: int = 1) -> float:
    """Return the bearing length l_tr that a torque asks for [m].

    Args:
        torque: T [N m].
        diameter: d of the shaft [m].
        section: Of the key [m].
        allowable: Pressure that the weakest of shaft, hub and key bears, about 0.9 R_e over safety [Pa].
        keys: One, or two opposite ones [-].

    Source: DIN 6892:2012, method C solved for l_tr; useful up to 1.3 d.

    Raises:
        DesignError: If there are neither one nor two keys.
    """
    return 2.0 * torque / (diameter * _bearing_height(section) * allowable * _effective(keys))


def _bearing_height(section: KeySection) -> float:
    return section.height - section.shaft_depth


def _effective(keys: int) -> float:
    if keys not in (1, 2):
        raise DesignError([Problem("key.count", f"{keys} given; allowed: 1 or 2; use a spline for more torque")])
    return 1.0 if keys == 1 else 2.0 * TWO_KEYS_SHARE


# ----------------------------------------------------------------------------------------------------------------------
# Involute splines of DIN 5480: teeth for a shaft, diameters, and the length that a torque asks for.
# ----------------------------------------------------------------------------------------------------------------------


MODULES = (
    0.5e-3,
    0.6e-3,
    0.75e-3,
    0.8e-3,
    1e-3,
    1.25e-3,
    1.5e-3,
    1.75e-3,
    2e-3,
    2.5e-3,
    3e-3,
    4e-3,
    5e-3,
    6e-3,
    8e-3,
    10e-3,
)
"""Modules of the standard [m] (DIN 5480-1:2006)."""
BEARING_SHARE = 0.75
"""Share of the teeth that bear in a first sizing [-] (usual for flank centred splines of grade 8)."""
SHORTEST_RATIO = 0.6
"""l/d_B below which a hub rocks on its shaft [-] (usual for gears without another seat)."""
HOBBED = 0.60
"""Dedendum h_fP of a hobbed shaft over its module [-]; broached 0.55, shaped 0.65, cold rolled 0.84 (DIN 5480-1:2006,
basic rack profile)."""
ROOT_DEPTH = 1.1 + 2.0 * HOBBED
"""(d_B − d_f1)/m of a hobbed shaft [-]: d_f1 = m z + 2 x m − 2 h_fP with m z + 2 x m = d_B − 1.1 m."""
_SHIFT = (-0.05, 0.45)
"""Range of the profile shift x of shafts [-] (DIN 5480-1:2006)."""


class Spline(NamedTuple):
    """A shaft-hub joint with involute teeth of 30°."""

    reference_diameter: float
    """d_B [m]."""
    module: float
    """m [m]."""
    teeth: int
    """z [-]."""
    profile_shift: float
    """x of the shaft [-]; that of the hub is −x."""

    @property
    def pitch_diameter(self) -> float:
        """D = m z [m]."""
        return self.module * self.teeth

    @property
    def shaft_tip(self) -> float:
        """Tip diameter of the shaft d_a1 = d_B − 0.2 m [m]."""
        return self.reference_diameter - 0.2 * self.module

    @property
    def hub_tip(self) -> float:
        """Tip diameter of the hub d_a2 = d_B − 2 m [m]."""
        return self.reference_diameter - 2.0 * self.module

    @property
    def shaft_root(self) -> float:
        """Root diameter of the hobbed shaft d_f1 = d_B − 2.3 m [m]; DIN 5480-2 lists d_B − 2.2 m, the largest."""
        return self.reference_diameter - ROOT_DEPTH * self.module


def spline(reference_diameter: float, module: float) -> Spline:
    """Return the teeth of DIN 5480 on a shaft.

    Of two numbers of teeth with an allowed shift the even one is taken, as the standard does.

    Args:
        reference_diameter: d_B, that of the bearing or shaft [m].
        module: m [m].

    Source: DIN 5480-1:2006: d_B = m (z + 2 x + 1.1) with −0.05 ≤ x ≤ 0.45.

    Raises:
        DesignError: If the module is not standard or too few teeth fit.

    >>> spline(0.120, 0.003).teeth
    38
    """
    if not any(math.isclose(module, standard) for standard in MODULES):
        closest = min(MODULES, key=lambda standard: abs(standard - module))
        message = f"{1e3 * module:g} mm is not a module of DIN 5480; the nearest is {1e3 * closest:g} mm"
        raise DesignError([Problem("spline.module", message)])
    room = reference_diameter / module - 1.1
    fewest, most = math.ceil(room - 2.0 * _SHIFT[1] - 1e-9), math.floor(room - 2.0 * _SHIFT[0] + 1e-9)
    teeth = next((z for z in range(fewest, most + 1) if z % 2 == 0), fewest)
    if teeth < 6:
        message = f"{1e3 * reference_diameter:g} mm has room for {teeth} teeth of {1e3 * module:g} mm; 6 are needed"
        raise DesignError([Problem("spline.reference_diameter", message)])
    return Spline(reference_diameter, module, teeth, (room - teeth) / 2.0)


def spline_pressure(torque: float, joint: Spline, length: float, *, share: float = BEARING_SHARE) -> float:
    """Return the mean pressure on the flanks of a spline [Pa].

    Args:
        torque: T [N m].
        joint: Teeth [m].
        length: Bearing length l [m].
        share: Of the teeth that bear k [-].

    Source: first sizing as in Roloff/Matek, Maschinenelemente, with DIN 5480 heights: p = 2 T/(d_m h l z k),
        h = (d_a1 − d_a2)/2 = 0.9 m, d_m = (d_a1 + d_a2)/2 = d_B − 1.1 m.
    """
    return spline_length(torque, joint, share=share, allowable=1.0) / length


def spline_length(torque: float, joint: Spline, *, allowable: float, share: float = BEARING_SHARE) -> float:
    """Return the bearing length that a torque asks for [m]; 0.6 d_B at least keeps the hub from rocking.

    Args:
        torque: T [N m].
        joint: Teeth [m].
        allowable: Pressure on the flanks [Pa].
        share: Of the teeth that bear k [-].

    Source: as `spline_pressure`, solved for l.
    """
    height = (joint.shaft_tip - joint.hub_tip) / 2.0
    middle = (joint.shaft_tip + joint.hub_tip) / 2.0
    return 2.0 * torque / (middle * height * joint.teeth * share * allowable)


# ----------------------------------------------------------------------------------------------------------------------
# Press fits by Lamé and DIN 7190: pressure from interference, torque by friction, stress in hub and shaft.
# ----------------------------------------------------------------------------------------------------------------------


SMOOTHING = 0.8
"""Share of both roughnesses R_z that pressing smooths away, each on both sides [-] (DIN 7190:2001)."""


@dataclass(frozen=True)
class FitPart:
    """Shaft or hub of a press fit."""

    diameter_ratio: Ratio
    """Q: bore over joint diameter for the shaft (0 if solid), joint over outer diameter for the hub [-]."""
    elastic_modulus: Stress
    """E [Pa]."""
    poisson_ratio: Ratio = 0.3
    """ν [-]."""
    roughness: Length = 0.0
    """R_z of the seat [m]."""
    density: Density = 7850.0
    """ρ [kg/m³]."""

    def __post_init__(self) -> None:
        """Refuse a part without a wall."""
        if not 0.0 <= self.diameter_ratio < 1.0:
            message = f"{self.diameter_ratio:g} given; allowed: 0 to below 1, or nothing is left of the part"
            raise DesignError([Problem("diameter_ratio", message)])


def fit_pressure(interference: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the pressure in a press fit [Pa].

    Args:
        interference: Difference of the diameters as made U [m].
        diameter: Of the joint d [m].
        shaft: Inner part [Pa, m].
        hub: Outer part [Pa, m].

    Source: Lamé 1852; DIN 7190:2001: U − 0.8 (R_z,i + R_z,a) = p d (c_i/E_i + c_a/E_a),
        c_a = (1 + Q_a²)/(1 − Q_a²) + ν_a, c_i = (1 + Q_i²)/(1 − Q_i²) − ν_i.

    Valid for: elastic parts of equal length, at rest; turning, with what `centrifugal_loss` leaves of U.

    Raises:
        DesignError: If the parts do not overlap once their roughness is smoothed.
    """
    lost = SMOOTHING * (shaft.roughness + hub.roughness)
    if interference <= lost:
        message = f"{1e6 * interference:.4g} µm given; the fit holds above {1e6 * lost:.4g} µm, which smoothing takes"
        raise DesignError([Problem("interference", message)])
    return (interference - lost) / (diameter * (_widening(hub, 1.0) + _widening(shaft, -1.0)))


def fit_interference(pressure: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the interference as made that gives a pressure [m].

    Args:
        pressure: p [Pa].
        diameter: Of the joint d [m].
        shaft: Inner part [Pa, m].
        hub: Outer part [Pa, m].

    Source: as `fit_pressure`, solved for U.
    """
    lost = SMOOTHING * (shaft.roughness + hub.roughness)
    return lost + pressure * diameter * (_widening(hub, 1.0) + _widening(shaft, -1.0))


def _widening(part: FitPart, sign: float) -> float:
    square = part.diameter_ratio**2
    return ((1.0 + square) / (1.0 - square) + sign * part.poisson_ratio) / part.elastic_modulus


def centrifugal_loss(speed: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the interference that turning takes from a press fit, as the hub widens more than the shaft [m].

    Args:
        speed: Of both [rad/s].
        diameter: Of the joint d [m].
        shaft: Inner part [Pa, m].
        hub: Outer part [Pa, m].

    Source: Lamé 1852 with body forces (Timoshenko and Goodier, Theory of elasticity, art. 32): the bore of a free ring
        widens by ρ ω² d³/(16 E) ((3 + ν)/Q² + 1 − ν) in diameter, a free shaft by ρ ω² d³/(16 E) (1 − ν + (3 + ν) Q²).

    Valid for: parts of plane stress, each of one density.
    """
    cube = speed**2 * diameter**3 / 16.0
    nu, mu = hub.poisson_ratio, shaft.poisson_ratio
    widened = hub.density / hub.elastic_modulus * ((3.0 + nu) / hub.diameter_ratio**2 + 1.0 - nu)
    thickened = shaft.density / shaft.elastic_modulus * (1.0 - mu + (3.0 + mu) * shaft.diameter_ratio**2)
    return cube * (widened - thickened)


def fit_torque(pressure: float, diameter: float, length: float, *, friction: float) -> float:
    """Return the torque at which a press fit slips [N m].

    Args:
        pressure: p [Pa].
        diameter: Of the joint d [m].
        length: Of the joint l [m].
        friction: μ, 0.14 to 0.2 for steel on steel [-].

    Source: DIN 7190:2001: T = π/2 d² l μ p.
    """
    return math.pi / 2.0 * diameter**2 * length * friction * pressure


def hub_stress(pressure: float, hub: FitPart) -> float:
    """Return Tresca's equivalent stress at the bore of a hub [Pa].

    Args:
        pressure: p [Pa].
        hub: Outer part [Pa, m].

    Source: Lamé 1852: σ_t − σ_r = p (1 + Q²)/(1 − Q²) + p = 2 p/(1 − Q²).
    """
    return 2.0 * pressure / (1.0 - hub.diameter_ratio**2)


def shaft_fit_stress(pressure: float, shaft: FitPart) -> float:
    """Return Tresca's equivalent stress in the shaft of a press fit [Pa].

    Args:
        pressure: p [Pa].
        shaft: Inner part [Pa, m].

    Source: Lamé 1852: p where solid, and at the bore of a hollow shaft |σ_t| = 2 p/(1 − Q²).
    """
    return pressure if shaft.diameter_ratio == 0.0 else 2.0 * pressure / (1.0 - shaft.diameter_ratio**2)
