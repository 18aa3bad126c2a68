"""Planetary stages: assembly conditions, compound planets, mesh phasing and load sharing.

Their kinematics are `train`'s, their motion is for `dynamics`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from statistics import NormalDist
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Bools, Problem, refuse
from gearwright.parts.gears import GearPair, half_angle_at, involute

# ----------------------------------------------------------------------------------------------------------------------
# Which tooth numbers make a planetary set that can be put together, and where its planets stand.
# ----------------------------------------------------------------------------------------------------------------------


ADDENDUMS = 2
"""Tip circles of neighbouring planets stand two modules outside the pitch circle's diameter."""


def assembles(sun_teeth: ArrayLike, ring_teeth: ArrayLike, planets: int) -> Bools:
    """Tell whether equally spaced planets can be assembled.

    Args:
        sun_teeth: z_s [-].
        ring_teeth: z_r [-].
        planets: N [-].

    Source: (z_s + z_r)/N integer, whatever the profile shifts; VDI 2157, any text on epicyclic gears.
    """
    return np.asarray((np.asarray(sun_teeth) + np.asarray(ring_teeth)) % planets == 0)


def even_positions(planets: int) -> tuple[float, ...]:
    """Return the angles of equally spaced planets, the first at zero.

    Args:
        planets: Number of planets N [-].

    Returns:
        ψ_n = 2π n/N [rad]; Pulvirenti 2023, eq. (3.34), prints N − 1.

    Source: Parker & Lin 2004, J. Mech. Des. 126, 365-370.
    """
    return tuple(2.0 * math.pi * n / planets for n in range(planets))


def nearest_positions(sun_teeth: int, ring_teeth: int, planets: int) -> tuple[float, ...]:
    """Return the angles at which planets can be put in, nearest to equal ones, the first at zero.

    Args:
        sun_teeth: z_s [-].
        ring_teeth: z_r [-].
        planets: N [-].

    Returns:
        ψ_n = 2π/(z_s + z_r) · round(n (z_s + z_r)/N) [rad]; planets that are opposite each other stay so.

    Source: teeth of sun and ring meet a planet at whole multiples of 2π/(z_s + z_r); VDI 2157.

    >>> places = nearest_positions(27, 99, 4)
    >>> [round(math.degrees(second - first), 2) for first, second in zip(places, places[1:])]
    [91.43, 88.57, 91.43]
    """
    total = sun_teeth + ring_teeth
    if total % planets == 0:
        return even_positions(planets)
    return tuple(2.0 * math.pi / total * math.floor(n * total / planets + 0.5) for n in range(planets))


def tip_gap(centre: float, tip_radius: float, positions: Sequence[float]) -> float:
    """Return the least gap between the tip circles of neighbouring planets, in the unit of the radii.

    Args:
        centre: Radius of the pin circle a_w [m], or over the module.
        tip_radius: Of a planet r_a [m], or over the module.
        positions: Angles of the planets [rad], in order.

    Returns:
        2 a_w sin(Δψ/2) − 2 r_a of the nearest two; infinite for one planet.

    Source: chord of the pin circle; VDI 2157.

    >>> round(tip_gap(27.0, 19.0, even_positions(3)), 3)
    8.765
    """
    if len(positions) < 2:
        return math.inf
    closed = [*positions, positions[0] + 2.0 * math.pi]
    nearest = min(after - before for before, after in pairwise(closed))
    return 2.0 * centre * math.sin(0.5 * min(nearest, math.pi)) - 2.0 * tip_radius


def neighbours_clear(sun_teeth: ArrayLike, planet_teeth: ArrayLike, planets: int) -> Bools:
    """Tell whether the tips of neighbouring planets stay clear of each other.

    Args:
        sun_teeth: z_s [-].
        planet_teeth: z_p [-].
        planets: N [-].

    Source: (z_s + z_p) sin(π/N) > z_p + 2 for standard addenda.
    """
    if planets == 1:
        return np.ones(np.broadcast(sun_teeth, planet_teeth).shape, dtype=bool)
    reach = (np.asarray(sun_teeth) + np.asarray(planet_teeth)) * math.sin(math.pi / planets)
    return np.asarray(reach > np.asarray(planet_teeth) + ADDENDUMS)


def most_planet_teeth(sun_teeth: int, planets: int) -> float:
    """Return the tooth number below which planets must stay to pass their neighbours [-].

    Args:
        sun_teeth: z_s [-].
        planets: N, at least 3; two planets pass each other whatever their teeth [-].

    Source: z_p = (z_s sin(π/N) − 2)/(1 − sin(π/N)), the limit of `neighbours_clear`.

    >>> round(most_planet_teeth(18, 4), 2)
    36.63
    """
    sine = math.sin(math.pi / planets)
    return (sun_teeth * sine - ADDENDUMS) / (1.0 - sine)


def most_planets(centre: float, tip_radius: float) -> int:
    """Return the largest number of equally spaced planets whose tips stay clear [-].

    Args:
        centre: Radius of the pin circle a_w [m], or over the module.
        tip_radius: Of a planet r_a [m], or over the module.

    Source: N = floor(π / asin(r_a/a_w)), which replaces Pulvirenti 2023, eq. (1.4).

    >>> most_planets(22.5, 14.5)
    4
    """
    sine = tip_radius / centre
    if sine >= 1.0:
        return 1
    count = int(math.pi / math.asin(sine))
    return count if tip_gap(centre, tip_radius, even_positions(count)) > 0.0 else count - 1


# ----------------------------------------------------------------------------------------------------------------------
# Geometry of compound epicyclic sets: how far planets stand from the axis, at which angles, and whether they fit.
#
# Rings count with negative tooth numbers, so that (z_a + z_b) m/2 is every signed centre distance and one law holds for
# all meshes: turned by α and β about axes that stand still, two gears stay in mesh where z_a α + z_b β is whole turns.
# ----------------------------------------------------------------------------------------------------------------------


CLOSES = 1.0
"""Modules by which two distances of one pin from the axis may differ and shifts take it up with any teeth [-]."""
_ROUNDED = 1e-9
"""Length by which rounding may let faces that only touch overlap [m]."""


@dataclass(frozen=True)
class CompoundSet:
    """Gears and meshes of a compound set, without sizes."""

    sets: int
    """Equal sets of planets around the carrier, N."""
    centrals: Mapping[str, int]
    """Sun or ring -> tooth number, negative of a ring."""
    planets: Mapping[str, int]
    """Planet, or step of one -> tooth number."""
    bodies: Mapping[str, str]
    """Planet or step -> the body that it is part of, called as one of its steps."""
    meshes: tuple[tuple[str, str], ...]
    """Every mesh, as its two gears."""
    groups: Mapping[str, str] = field(default_factory=dict)
    """Gear -> those that have its module; left out: all have one."""
    centres: Mapping[tuple[str, str], float] = field(default_factory=dict)
    """Mesh, as in ``meshes`` -> working centre distance over its module; left out: the reference one [-]."""
    heights: Mapping[str, float] = field(default_factory=dict)
    """Gear -> how far its tips stand outside its pitch circle over its module, 1 + x + k; left out: 1 [-]."""
    places: Mapping[str, float] = field(default_factory=dict)
    """Gear -> middle of its face along the axis, where it is given [m]."""
    widths: Mapping[str, float] = field(default_factory=dict)
    """Gear -> width of its meshes, where it is given [m]."""

    @cached_property
    def teeth(self) -> Mapping[str, int]:
        """Gear -> tooth number, negative of a ring."""
        return {**self.centrals, **self.planets}

    def group(self, gear: str) -> str:
        """Return what has one module with a gear."""
        return self.groups.get(gear, "")

    def distance(self, first: str, second: str) -> float:
        """Return the working centre distance of two gears that mesh over their module [-].

        Args:
            first: One of them.
            second: The other.

        Source: |z_1 + z_2|/2 without shift, ISO 21771:2007, with rings negative.
        """
        reference = abs(self.teeth[first] + self.teeth[second]) / 2.0
        return self.centres.get((first, second), self.centres.get((second, first), reference))

    @cached_property
    def at_centre(self) -> tuple[tuple[str, str], ...]:
        """Meshes with a sun or ring: that and its planet."""
        ordered = ((first, second) if first in self.centrals else (second, first) for first, second in self.meshes)
        return tuple(pair for pair in ordered if pair[0] in self.centrals)

    @cached_property
    def between(self) -> tuple[tuple[str, str], ...]:
        """Meshes of two planets."""
        return tuple(pair for pair in self.meshes if not set(pair) & self.centrals.keys())


def reaches(compound: CompoundSet) -> dict[str, list[tuple[str, float]]]:
    """Return body -> what its meshes with suns and rings ask of its distance from the axis.

    Args:
        compound: The set.

    Returns:
        Group of gears, and distance over their module, |z_p + z_c|/2 without shift [-], for each mesh.

    Source: centre distance, ISO 21771:2007, with rings negative.
    """
    asked: dict[str, list[tuple[str, float]]] = {}
    for central, planet in compound.at_centre:
        distance = compound.distance(central, planet)
        asked.setdefault(compound.bodies[planet], []).append((compound.group(planet), distance))
    return asked


def module_ratios(compound: CompoundSet) -> dict[str, float]:
    """Return group -> its module over that of the first group, by the stepped planets whose steps reach one pin [-].

    Args:
        compound: The set. A group that no such planet ties to the others has the module of the first one.

    Source: (z_p1 + z_c1) m_1 = (z_p2 + z_c2) m_2, the common centre distance of stepped planets.
    """
    ratio: dict[str, float] = {compound.group(next(iter(compound.teeth))): 1.0}
    steps = list(reaches(compound).values())
    for _ in range(len(compound.teeth)):
        for asked in steps:
            for known, reach in [(group, distance) for group, distance in asked if group in ratio][:1]:
                for group, distance in asked:
                    ratio.setdefault(group, ratio[known] * reach / distance)
    return {compound.group(gear): ratio.get(compound.group(gear), 1.0) for gear in compound.teeth}


def pin_radii(compound: CompoundSet, modules: Mapping[str, float]) -> dict[str, float]:
    """Return body -> distance of its pin from the axis, the mean of what its meshes with suns and rings ask [m].

    Args:
        compound: The set.
        modules: Group -> module [m].

    Source: centre distance, ISO 21771:2007; with profile shift they ask for one, without it whole teeth may differ.
    """
    return {
        body: sum(modules[group] * distance for group, distance in asked) / len(asked)
        for body, asked in reaches(compound).items()
    }


def pin_angles(compound: CompoundSet, modules: Mapping[str, float]) -> dict[str, float]:
    """Return body -> angle of its pin in the first set, counted from the first body's [rad]; NaN where none closes.

    Args:
        compound: The set. Planets that no mesh ties to the first one stand at its angle.
        modules: Group -> module [m].

    Source: cosine rule in the triangle of both pins and the axis: 2 R_a R_b cos φ = R_a² + R_b² − a².
    """
    radii, angles = pin_radii(compound, modules), dict[str, float]()
    for start in dict.fromkeys(compound.bodies.values()):
        angles.setdefault(start, 0.0)
        for _ in compound.between:
            for here, there, distance in _steps(compound, modules):
                if here in angles and there not in angles and {here, there} <= radii.keys():
                    cosine = (radii[here] ** 2 + radii[there] ** 2 - distance**2) / (2.0 * radii[here] * radii[there])
                    angles[there] = angles[here] + (math.acos(cosine) if abs(cosine) <= 1.0 else math.nan)
    return angles


def _steps(compound: CompoundSet, modules: Mapping[str, float]) -> Iterator[tuple[str, str, float]]:
    """Yield both bodies of every mesh of planets, either way, with their centre distance [m]."""
    for first, second in compound.between:
        distance = modules[compound.group(first)] * compound.distance(first, second)
        ends = compound.bodies[first], compound.bodies[second]
        yield (*ends, distance)
        yield (*ends[::-1], distance)


def planes(compound: CompoundSet) -> dict[str, frozenset[tuple[str, int]]]:
    """Return gear -> the planes along the axis in which it lies, as its group and a number.

    Suns of one group lie side by side, and so do its rings; a planet lies where its suns and rings do, and the longer
    of two meshed planets, the one with more mates, reaches into the plane of the other.

    Args:
        compound: The set.

    Source: what must not stand in one place.
    """
    place: dict[str, set[tuple[str, int]]] = {gear: set() for gear in compound.planets}
    found: dict[str, frozenset[tuple[str, int]]] = {}
    for inner in (True, False):
        for central in (name for name, teeth in compound.centrals.items() if (teeth > 0) == inner):
            mates = [planet for first, planet in compound.at_centre if first == central]
            taken = {key for name, keys in found.items() if (compound.centrals[name] > 0) == inner for key in keys}
            own = sorted(key for mate in mates for key in place[mate] if key not in taken)
            group = compound.group(central)
            key = own[0] if own else (group, sum(known[0] == group for known in taken))
            found[central] = frozenset({key})
            for mate in mates:
                place[mate].add(key)
    mates_of = {gear: sum(gear in pair for pair in compound.meshes) for gear in compound.planets}
    for pair in compound.between:
        short, long = sorted(pair, key=lambda gear: mates_of[gear])
        if not place[short]:
            place[short] |= set(sorted(place[long])[:1]) or {(compound.group(short), 0)}
        if not place[short] & place[long]:
            place[long] |= place[short]
    return found | {gear: frozenset(keys) for gear, keys in place.items()}


def touching(compound: CompoundSet, modules: Mapping[str, float]) -> Iterator[tuple[str, str, float]]:
    """Yield every two gears whose tip circles overlap although they do not mesh, and the overlap [m].

    Args:
        compound: The set.
        modules: Group -> module [m].

    Source: tip circles d_a = (z + 2 (1 + x + k)) m in the planes that both lie in, rings with negative z; neighbours
        at 2π/N.
    """
    radii, angles, lie = pin_radii(compound, modules), pin_angles(compound, modules), planes(compound)
    tips = {
        gear: (z + ADDENDUMS * compound.heights.get(gear, 1.0)) / 2.0 * modules[compound.group(gear)]
        for gear, z in compound.teeth.items()
    }
    names = [gear for gear in compound.planets if compound.bodies[gear] in radii]
    for k, first in enumerate(names):
        for second in names[k:]:
            gap = _least_gap(compound, radii, angles, (first, second), tips)
            if gap <= 0.0 and _meet(compound, lie, first, second):
                yield first, second, -gap
        for central, teeth in compound.centrals.items():
            meshes = {(first, central), (central, first)} & set(compound.meshes)
            if not meshes and _meet(compound, lie, first, central):
                gap = math.copysign(radii[compound.bodies[first]], teeth) - tips[first] - tips[central]
                if gap <= 0.0:
                    yield first, central, -gap


def _meet(compound: CompoundSet, lie: Mapping[str, frozenset[tuple[str, int]]], first: str, second: str) -> bool:
    """Tell whether two gears lie beside each other along the axis: by their places, or by the planes of their mates."""
    if {first, second} <= compound.places.keys():
        apart = abs(compound.places[first] - compound.places[second])
        if {first, second} <= compound.widths.keys():
            return apart < sum(compound.widths[gear] * len(lie[gear]) for gear in (first, second)) / 2.0 - _ROUNDED
        if apart == 0.0:
            return True
    bodies = {compound.bodies[planet] for central, planet in compound.at_centre if central == second}
    return bool(lie[first] & lie[second]) and compound.bodies[first] not in bodies


def _least_gap(
    compound: CompoundSet, radii: Mapping[str, float], angles: Mapping[str, float], pair: tuple[str, str],
    tips: Mapping[str, float],
) -> float:  # fmt: skip
    """Return the least gap between the tips of two planets of any two sets that do not mesh [m]."""
    bodies = tuple(compound.bodies[gear] for gear in pair)
    mates = pair in compound.between or pair[::-1] in compound.between
    gaps = [math.inf]
    for number in range(compound.sets):
        if number == 0 and (mates or bodies[0] == bodies[1]):
            continue
        turn = angles[bodies[1]] - angles[bodies[0]] + 2.0 * math.pi * number / compound.sets
        apart = abs(radii[bodies[0]] - cmath.rect(radii[bodies[1]], turn))
        gaps.append(apart - tips[pair[0]] - tips[pair[1]])
    return min(gaps)


# ----------------------------------------------------------------------------------------------------------------------
# Whether equal, evenly spaced compound planets can be put in, and how each turns to fit: cosets of whole teeth.
#
# The set at φ = 2π n/N is the first one turned by φ with the carrier, while suns and rings stay. A planet body turns
# on its pin by ψ so that its teeth meet theirs again: z_p ψ ≡ z_c φ for each mesh with a sun or ring (rings
# negative), and z_a ψ_a ≡ −z_b ψ_b for two planets, all in whole turns. What ψ may be is a coset: one angle, plus
# whole parts of a turn.
# ----------------------------------------------------------------------------------------------------------------------


class Turns(NamedTuple):
    """Angles that a body may have, in turns: ``first`` + k/``parts`` for every whole k; any where ``parts`` is 0."""

    first: Fraction
    parts: int

    def common(self, other: Turns) -> Turns | None:
        """Return what both allow, or None."""
        if not self.parts or not other.parts:
            return other if not self.parts else self
        step = math.lcm(self.parts, other.parts)
        gap = (other.first - self.first) * step
        if gap.denominator != 1:
            return None
        # first + k/parts for the k that hits the other: k (step/parts) ≡ gap (mod step/other.parts)
        left, right = step // self.parts, step // other.parts
        count = int(gap) * pow(left, -1, right) % right if right > 1 else 0
        return Turns(self.first + Fraction(count, self.parts), math.gcd(self.parts, other.parts))

    def seen_by(self, teeth: int, mate: int) -> Turns:
        """Return what a mate of so many teeth may turn where this body meshes with it by some teeth of its own."""
        if not self.parts:
            return self
        fine = self.parts // math.gcd(teeth, self.parts)
        return Turns(-self.first * teeth / mate, fine * mate)


ANY = Turns(Fraction(0), 0)


def fitting_turns(compound: CompoundSet, *, number: int = 1) -> dict[str, Turns] | None:
    """Return body -> how it may turn on its pin in a set, beside the first set; None where it cannot be put in.

    Args:
        compound: Whose meshes make no circle.
        number: Of the set, counted from the first, which is 0.

    Source: integer conditions of whole teeth; of simple planets (z_s + z_r)/N, VDI 2157; of stepped ones the condition
        with the least common multiple, Müller 1998, Die Umlaufgetriebe.
    """
    part = Fraction(number, compound.sets)
    own: dict[str, Turns] = dict.fromkeys(compound.bodies.values(), ANY)
    for central, planet in compound.at_centre:
        body, teeth = compound.bodies[planet], compound.teeth[planet]
        both = own[body].common(Turns(compound.teeth[central] * part / teeth, teeth))
        if both is None:
            return None
        own[body] = both
    # A tree of planets settles when each has heard as many times from its mates as there are meshes.
    for _ in compound.between:
        for first, second in (*compound.between, *(pair[::-1] for pair in compound.between)):
            here, there = compound.bodies[first], compound.bodies[second]
            heard = own[there].common(own[here].seen_by(compound.teeth[first], compound.teeth[second]))
            if heard is None:
                return None
            own[there] = heard
    return own


def can_assemble(compound: CompoundSet) -> bool:
    """Tell whether equal, evenly spaced sets of planets can be put in.

    Args:
        compound: The set.

    Source: as `fitting_turns`; what holds from the first set to the second holds on to every other.

    >>> simple = {"s": 18, "r": -54}, {"p": 18}, {"p": "p"}, (("s", "p"), ("p", "r"))
    >>> can_assemble(CompoundSet(4, *simple)), can_assemble(CompoundSet(5, *simple))
    (True, False)
    """
    return fitting_turns(compound) is not None


# ----------------------------------------------------------------------------------------------------------------------
# How the meshes of a planetary set follow each other: relative mesh phases and what they excite.
#
# A phase is a fraction of a mesh cycle by which a mesh runs ahead: its stiffness is k(φ + 2π γ), with φ the phase of
# the set's first sun mesh. Planet positions are counted in the direction in which the driving sun turns beside the
# carrier.
# ----------------------------------------------------------------------------------------------------------------------


_WHOLE = 1e-6  # of a cycle; positions come from whole teeth, so a real phase is far from this


@dataclass(frozen=True)
class PlanetPhases:
    """Relative phases of all meshes of a set."""

    sun: tuple[float, ...]
    """Phase γ_sn of each planet's sun mesh against the first planet's, in cycles [-], 0 ≤ γ < 1."""
    ring: tuple[float, ...]
    """Phase of each planet's ring mesh against the first planet's sun mesh, γ_rn + γ_rs, in cycles [-]."""


def planet_phases(sun_mesh: GearPair, ring_mesh: GearPair, positions: Sequence[float]) -> PlanetPhases:
    """Return the relative mesh phases of a planetary set whose sun drives.

    Args:
        sun_mesh: Sun (driver) and planet.
        ring_mesh: Planet (driver) and ring.
        positions: Angles of the planets ψ_n [rad].

    Source: Parker & Lin 2004, J. Mech. Des. 126, 365-370: γ_sn = −z_s ψ_n/2π, γ_rn = z_r ψ_n/2π for planets numbered
        in the sun's direction; γ_rs from the planet's tooth thickness, see `sun_to_ring_phase`.

    Raises:
        DesignError: when the planets cannot be put in at these positions.
    """
    sun, ring = sun_mesh.driver.teeth, -ring_mesh.driven.teeth
    refuse(
        Problem(
            f"positions.{n}",
            f"{math.degrees(psi):.4f}° given; the teeth fit at whole multiples of 360°/{sun + ring}",
        )
        for n, psi in enumerate(positions)
        if abs(_centred((sun + ring) * (psi - positions[0]) / (2.0 * math.pi))) > _WHOLE
    )
    shift = sun_to_ring_phase(sun_mesh, ring_mesh)
    turns = [(psi - positions[0]) / (2.0 * math.pi) for psi in positions]
    return PlanetPhases(
        sun=tuple(_cycle(-sun * turn) for turn in turns), ring=tuple(_cycle(ring * turn + shift) for turn in turns)
    )


def sun_to_ring_phase(sun_mesh: GearPair, ring_mesh: GearPair) -> float:
    """Return the phase of a planet's ring mesh against its own sun mesh, both counted from their pitch points.

    Args:
        sun_mesh: Sun (driver) and planet.
        ring_mesh: Planet (driver) and ring.

    Returns:
        γ_rs in cycles [-], 0 ≤ γ < 1. Without profile shift it is 0 for an odd and ½ for an even planet.

    Source: by geometry, as Parker & Lin 2004 ask: the sun touches one flank of a planet tooth, the ring the other, half
        a turn away: γ_rs = −z_p (π + inv α_ws + inv α_wr − 2 ψ_b)/2π with ψ_b the half angle of the tooth at its base.
    """
    planet = ring_mesh.driver
    angles = involute(sun_mesh.working_pressure_angle) + involute(ring_mesh.working_pressure_angle)
    turn = math.pi + angles - 2.0 * half_angle_at(planet, planet.base_radius)
    return _cycle(-planet.teeth * turn / (2.0 * math.pi))


def excited_modes(sun_teeth: int, planets: int, harmonic: int) -> str:
    """Return which family of modes a mesh harmonic can excite in a set of equal, equally spaced planets.

    Args:
        sun_teeth: Number of teeth of the sun z_s [-].
        planets: Number of planets N [-].
        harmonic: Harmonic of the mesh frequency l [-].

    Returns:
        ``"rotational"``, ``"translational"`` or ``"planet"``; the other two families stay silent.

    Source: Parker 2000, J. Sound Vib. 236, 561-573: by l z_s mod N being 0, 1 or N − 1, or another number.

    >>> excited_modes(27, 4, 1)
    'translational'
    """
    remainder = (harmonic * sun_teeth) % planets
    if remainder == 0:
        return "rotational"
    return "translational" if remainder in (1, planets - 1) else "planet"


def _centred(value: float) -> float:
    """Distance to the nearest whole number."""
    return value - round(value)


def _cycle(value: float) -> float:
    """Fraction of a cycle, with rounding noise below a whole taken for the whole."""
    part = value - math.floor(value)
    return 0.0 if part > 1.0 - 1e-9 or part < 1e-9 else part


# ----------------------------------------------------------------------------------------------------------------------
# Mesh load factors K_γ of planets and of parallel paths: one pin out of place, tolerances of all, clocking.
# ----------------------------------------------------------------------------------------------------------------------


def pin_error_share(
    planets: int, error: float, force: float, *, stiffness: tuple[float, float], pressure_angle: float, floating: bool
) -> float:
    """Return the share of the planet whose pin stands out of place, L_1 [-].

    Args:
        planets: Number of evenly spaced planets N [-].
        error: Tangential error of its pin, positive where it loads the planet more e [m].
        force: Carrier torque over the pin radius F [N].
        stiffness: Mean mesh stiffness with the sun and with the ring k_sp, k_rp [N/m].
        pressure_angle: Working transverse pressure angle of both meshes α [rad].
        floating: One central member is free to move across.

    Returns:
        L_1 = 1/N + c K e/F with K = 4 cos² α/(1/k_sp + 1/k_rp); c = (N − 3)/N with a floating member, else
        (N − 1)/N.

    Source: Ligata, Kahraman & Singh 2009, J. Mech. Des. 131, 041010 (N = 4: 1/4 + K e/(4 F)); for every N by projection
        onto what the free motions cannot take up.

    Valid for: rigid ring, carrier and pins; all planets loaded; N ≥ 3.

    >>> set_up = dict(stiffness=(5e8, 5e8), pressure_angle=math.radians(24.6), floating=True)
    >>> [round(pin_error_share(n, 1e-5, 4e4, **set_up), 6) for n in (3, 4, 5, 6)]
    [0.333333, 0.301669, 0.282671, 0.270005]
    """
    free = 3 if floating else 1
    loop = 4.0 * math.cos(pressure_angle) ** 2 / (1.0 / stiffness[0] + 1.0 / stiffness[1])
    return 1.0 / planets + (planets - free) / planets * loop * error / force


def pin_error_within(
    planets: int, load_factor: float, force: float, *, stiffness: tuple[float, float], pressure_angle: float,
    floating: bool,
) -> float:  # fmt: skip
    """Return by how much one pin may stand out of place along the circle, so that a load factor is kept [m].

    Args:
        planets: Number of evenly spaced planets N [-].
        load_factor: K_γ = N L_1, at least 1 [-].
        force: Carrier torque over the pin radius F [N].
        stiffness: Mean mesh stiffness with the sun and with the ring k_sp, k_rp [N/m].
        pressure_angle: Working transverse pressure angle of both meshes α [rad].
        floating: One central member is free to move across.

    Returns:
        e = (K_γ − 1) F/(N c K); without limit for three planets with a floating member.

    Source: `pin_error_share`, solved for the error.

    Valid for: as `pin_error_share`.

    >>> round(1e6 * pin_error_within(4, 1.15, 4e4, stiffness=(5e8, 5e8), pressure_angle=0.42, floating=False), 3)
    2.399
    """
    reach = 1e-6
    per = pin_error_share(planets, reach, force, stiffness=stiffness, pressure_angle=pressure_angle, floating=floating)
    rise = (planets * per - 1.0) / reach
    return (load_factor - 1.0) / rise if rise > 0.0 else math.inf


RARE = 0.01
"""Part of the sets whose most loaded planet may bear more than K_γ says [-]."""
CLOCKED = 0.0375
"""Load that moves from one of two paths to the other for each mrad of clocking at `CLOCKED_TORQUE` [1/mrad]."""
CLOCKED_TORQUE = 367.0
"""Torque of the input of the split that was measured [N m]."""


def path_stiffness(meshes: float, width: float, *, bearing: float, pressure_angle: float) -> float:
    """Return the tangential force on a planet's teeth for each metre that its pin stands out of place [N/m].

    Args:
        meshes: c_γ of one mesh, as a mean of both [N/m²].
        width: Face width b [m].
        bearing: Radial stiffness of a planet's bearing on its pin [N/m].
        pressure_angle: Working transverse pressure angle α [rad].

    Source: both meshes in parallel behind the bearing in series, c_γ b cos² α/(1 + 2 c_γ b cos² α/k).

    >>> round(path_stiffness(20e9, 57e-3, bearing=1e9, pressure_angle=math.radians(20.0)) / 1e6)
    334
    """
    mesh = meshes * width * math.cos(pressure_angle) ** 2
    return mesh / (1.0 + 2.0 * mesh / bearing)


def tolerance_load_factor(planets: int, deviation: float, force: float, *, stiffness: float, floating: bool) -> float:
    """Return K_γ of a set whose pins stand out of place at random: 99 of 100 sets share better [-].

    Args:
        planets: Number of planets p [-].
        deviation: Standard deviation of the tangential place of a planet: of pin, runout and tooth thickness [m].
        force: Tangential force of one mesh F_t where all share alike [N].
        stiffness: From `path_stiffness` [N/m].
        floating: Whether a central member is free to move across.

    Returns:
        1 + z √((p − f)/p) s k/F_t, f = 3 with a floating member and 1 without, z the normal deviate that one planet
        surpasses in 0.01/p of all cases: p planets together do so in at most one set of a hundred.

    Source: projection of random errors onto what the free motions cannot take up, with Bonferroni's bound on the
        largest of p; from five planets on it is the 99th percentile of random sets within 0.001, for four 0.025 above.

    Valid for: all planets loaded, K_γ below 2.

    >>> round(tolerance_load_factor(5, 10e-6, 28500.0, stiffness=334e6, floating=True), 2)
    1.21
    """
    free = 3 if floating else 1
    deviate = NormalDist().inv_cdf(1.0 - RARE / planets)
    return 1.0 + deviate * math.sqrt(max(planets - free, 0) / planets) * deviation * stiffness / force


def clocking_load_factor(clocking: float, torque: float) -> float:
    """Return K_γ of two paths that are clocked to each other [-].

    Args:
        clocking: By how much their clocking misses [rad].
        torque: Of the input of the split [N m].

    Source: Krantz & Delgado 1996, NASA TM-107202: 53 % at most in one of two paths within 0.8 mrad at 367 N m; K_γ − 1
        falls with the torque.

    >>> round(clocking_load_factor(0.8e-3, 367.0), 2)
    1.06
    """
    return 1.0 + 2.0 * CLOCKED * 1e3 * clocking * CLOCKED_TORQUE / torque
