"""Geometry of compound epicyclic sets: how far planets stand from the axis, at which angles, and whether they fit.

Rings count with negative tooth numbers, so that (z_a + z_b) m/2 is every signed centre distance and one law holds for
all meshes: turned by α and β about axes that stand still, two gears stay in mesh where z_a α + z_b β is whole turns.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from gearwright.parts.planetary.assembly import ADDENDUMS

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
