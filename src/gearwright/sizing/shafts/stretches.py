"""Stepped shafts as stretches of one diameter, and their bending: deflection, critical speed, face load factor."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import Check, DesignError, Floats, Problem, apart, largest, not_assessed, text
from gearwright.catalogue import Bearing
from gearwright.parts import Material
from gearwright.parts.iso6336 import Misalignment, face_load_factor, mesh_springs
from gearwright.parts.shafts import BentLine, Sections, bent_line, between, critical_speed, influence, lumped_shaft
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.rating import Context, cylindrical_mesh, method_for
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso6336_inputs import quality_of, steels_of
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.sizing.shaft_results import BuiltShaft
from gearwright.spec.design import BearingSeat
from gearwright.train import INTERNAL

# ----------------------------------------------------------------------------------------------------------------------
# A shaft from end to end as stretches of one diameter: what sits on it, and what lies between.
#
# Parts are put on from both ends, so that diameters fall from the thickest stretch outwards. That is, in this order:
# the gears of one piece with the shaft; the hub between the bearings that needs the thickest seat; the stretch between
# the bearings. The hub of a spline passes with its own teeth over what is further out, so that its seat is thicker than
# that by their height, and an end that sticks out of it and carries nothing is thinner. A bearing leans on a shoulder
# on its inner side where the next seat is thick enough for one, else on a spacer ring. A hub at the thickest seat leans
# on a collar on its longer side.
#
# Shoulders are as high as makers ask for their bearings: `SHOULDER` of the ring height D − d on the diameter, with a
# fillet of `BEARING_FILLET` of it: 52 mm and 1 mm for a 6209, 69 mm and 1.3 mm for an NU 2212, 101 mm and 1.5 mm for a
# 33118, where SKF prints 52 mm and 1 mm, 69 mm and 1.5 mm, 101 mm and 2 mm.
# ----------------------------------------------------------------------------------------------------------------------


SHOULDER = 0.175
"""Shoulder over bore of a bearing, on the diameter, over D − d [-]."""
BEARING_FILLET = 0.025
"""Fillet at the seat of a bearing over D − d [-]."""
SHOULDER_WIDTH = 0.1
"""Width of a bearing's shoulder, over its diameter, where the shaft is thinner beyond it, an estimate [-]."""
COLLAR = 1.15
"""Collar beside a hub over the hub's seat [-]."""
LARGEST_BODY = 1.5
"""Diameter of a gear of one piece that still stiffens its shaft, over the shaft beside it [-]."""
SAME = 1e-9
"""Lengths that differ by less are the same [m]."""
Kind = Literal["bearing", "integral", "hub", "between"]
Choose = Callable[[str, float, float], Bearing]
"""Bearing, smallest and largest bore -> the one that is taken."""


class SeatedPart(NamedTuple):
    """What sits on a shaft and has a width."""

    name: str
    kind: Kind
    middle: float
    """From the shaft's first end [m]."""
    width: float
    """[m]; of a bearing the one that was taken last."""
    limit: float = math.inf
    """Root diameter of a gear of one piece [m]."""

    @property
    def start(self) -> float:
        """From the shaft's first end [m]."""
        return self.middle - self.width / 2.0

    @property
    def end(self) -> float:
        """From the shaft's first end [m]."""
        return self.middle + self.width / 2.0


class ShaftStretch(NamedTuple):
    """A part of a shaft between two places."""

    name: str
    """Item that sits here, or ``after NAME`` of what lies before."""
    kind: Kind
    start: float
    """[m]"""
    end: float
    """[m]"""
    diameter: float = 0.0
    """[m]"""
    shoulder: float = 0.0
    """Diameter that a bearing here wants beside it [m]."""
    fillet: float = 0.0
    """Fillet that a bearing here allows [m]; zero for what is no bearing."""

    @property
    def length(self) -> float:
        """[m]"""
        return self.end - self.start

    def of(self, diameter: float) -> ShaftStretch:
        """Return the stretch with a diameter.

        Args:
            diameter: [m].
        """
        return ShaftStretch(self.name, self.kind, self.start, self.end, diameter, self.shoulder, self.fillet)


@dataclass(frozen=True)
class Wanted:
    """What decides the diameters of a shaft."""

    items: tuple[SeatedPart, ...]
    """In order."""
    length: float
    """Of the shaft [m]."""
    needed: Mapping[str, float]
    """ShaftStretch -> diameter that it needs [m]; what carries nothing is not in it."""
    fixed: Mapping[str, float]
    """Hub -> diameter that the user gives [m]."""
    core: float | None
    """Thickest diameter without gears of one piece that the user gives [m]."""
    bearings: tuple[float, float]
    """Middles of the radial bearings [m]."""
    passes: Mapping[str, Callable[[float], float]] = field(default_factory=dict)
    """Hub with teeth -> what it slides over, by the diameter of its seat [m]; others slide over that."""

    def over(self, hub: str, diameter: float) -> float:
        """Return what a hub slides over [m].

        Args:
            hub: Its name.
            diameter: Of its seat [m].
        """
        return self.passes[hub](diameter) if hub in self.passes else diameter


def lay(shaft: str, wanted: Wanted, choose: Choose) -> tuple[tuple[ShaftStretch, ...], dict[str, Bearing]]:
    """Return the stretches of a shaft, and the bearings that they were laid for.

    Args:
        shaft: Its name, for messages.
        wanted: What decides.
        choose: Gives every bearing.

    Raises:
        DesignError: If a part cannot be slid on, or the shaft is thicker than its pinion.
    """
    bare = _bare(wanted.items, wanted.length)
    low, high = _thickest(bare, wanted)
    if wanted.core is not None and bare[low].kind == "integral":
        beside = {bare[low - 1].name: wanted.core, bare[high + 1].name: wanted.core}
        wanted = replace(wanted, needed={**wanted.needed, **beside})
    limit = min((item.limit for item in wanted.items if item.kind == "integral"), default=math.inf)
    chosen: dict[str, Bearing] = {}

    def bounded(name: str, smallest: float, largest: float) -> Bearing:
        chosen[name] = choose(name, smallest, largest)
        return chosen[name]

    left = _climb(shaft, bare[:low], wanted, bounded, limit=limit)
    right = _climb(shaft, bare[high + 1 :][::-1], wanted, bounded, limit=limit)
    # A hub at the thickest place leans on a collar, and is slid on from the other side.
    beyond = right if _collar(bare, low) == low - 1 else left
    past = beyond[-1].diameter if beyond and bare[low].kind == "hub" else 0.0
    middle = _necked(_core(shaft, bare[low : high + 1], (left, right), wanted, past=past), (left, right), wanted)
    first, last = middle[0], middle[-1]
    most_left = _past(wanted, first) if beyond is left else first.diameter
    most_right = _past(wanted, last) if beyond is right else last.diameter
    laid = [*_shouldered(left, most_left), *middle, *_shouldered(right, most_right)[::-1]]
    return tuple(_ends(_collared(laid, low, low + len(middle) - 1), wanted)), chosen


def _bare(items: Sequence[SeatedPart], length: float) -> list[ShaftStretch]:
    """Return the stretches without diameters: between, item, between, and so on; those between may have no length."""
    bare, reached, before = [], 0.0, ""
    for item in items:
        bare += [ShaftStretch(f"after {before}".strip(), "between", reached, item.start)]
        bare += [ShaftStretch(item.name, item.kind, item.start, item.end)]
        reached, before = item.end, item.name
    return [*bare, ShaftStretch(f"after {before}".strip(), "between", reached, length)]


def _thickest(bare: list[ShaftStretch], wanted: Wanted) -> tuple[int, int]:
    """Return the first and the last stretch from which on diameters fall outwards."""
    integral = [k for k, stretch in enumerate(bare) if stretch.kind == "integral"]
    if integral:
        return integral[0], integral[-1]
    low, high = wanted.bearings
    inside = [k for k, stretch in enumerate(bare) if low < (stretch.start + stretch.end) / 2.0 < high]
    hubs = [k for k in inside if bare[k].kind == "hub"]
    if hubs:
        thickest = largest(hubs, lambda k: wanted.fixed.get(bare[k].name, wanted.needed.get(bare[k].name, 0.0)))
        return thickest, thickest
    longest = largest([k for k in inside if bare[k].kind == "between"], lambda k: bare[k].length)
    return longest, longest


def _climb(shaft: str, bare: list[ShaftStretch], wanted: Wanted, choose: Choose, *, limit: float) -> list[ShaftStretch]:
    """Return stretches from an end inwards with diameters that do not fall."""
    climbed: list[ShaftStretch] = []
    reached = 0.0
    for stretch in bare:
        needed = max(reached, wanted.needed.get(stretch.name, 0.0))
        if stretch.kind == "bearing":
            laid = _seated(stretch, choose(stretch.name, needed, limit))
        elif stretch.kind == "hub":
            laid = stretch.of(wanted.fixed.get(stretch.name, _passing(stretch.name, wanted, needed, reached)))
        else:
            laid = stretch.of(whole_millimetres(needed) if needed > reached else reached)
        _refuse_past(shaft, laid, wanted, reached)
        climbed = [*_shouldered(climbed, _past(wanted, laid)), laid] if laid.kind != "between" else [*climbed, laid]
        reached = laid.diameter
    return climbed


def _passing(hub: str, wanted: Wanted, needed: float, past: float) -> float:
    """Return the thinnest seat that a hub needs and that lets it slide over what is further out [m]."""
    diameter = whole_millimetres(needed)
    while wanted.over(hub, diameter) < past - SAME:
        diameter += 1e-3
    return diameter


def _refuse_past(shaft: str, laid: ShaftStretch, wanted: Wanted, past: float) -> None:
    """Raise where a part does not slide over what is further out."""
    over = _past(wanted, laid)
    if over < past - SAME:
        least = _passing(laid.name, wanted, past, past) if laid.kind == "hub" else past
        leaves, further = apart(over, past, "length")
        seat = f"{text(laid.diameter, 'length')}"
        has = f"a seat of {leaves}" if over == laid.diameter else f"teeth that leave {leaves} in a seat of {seat}"
        message = (
            f"{laid.name} has {has} on {shaft!r} and must be slid over {further} further out;"
            f" give it {text(least, 'length')} or more, or move it"
        )
        raise DesignError([Problem(_path(laid), message)])


def _path(stretch: ShaftStretch) -> str:
    return f"bearings.{stretch.name}" if stretch.kind == "bearing" else f"joints.{stretch.name}"


def _seated(stretch: ShaftStretch, bearing: Bearing) -> ShaftStretch:
    """Return the seat of a bearing."""
    height = bearing.outer_diameter - bearing.bore
    return stretch._replace(
        diameter=bearing.bore,
        shoulder=whole_millimetres(bearing.bore + SHOULDER * height),
        fillet=BEARING_FILLET * height,
    )


def whole_millimetres(length: float) -> float:
    """Return a length or a diameter rounded up to whole millimetres [m].

    Args:
        length: [m].
    """
    return math.ceil(1e3 * length - 1e-6) / 1e3


def _past(wanted: Wanted, inner: ShaftStretch) -> float:
    """Return how thick a shaft may be that what sits on a stretch is slid over [m]."""
    return wanted.over(inner.name, inner.diameter) if inner.kind == "hub" else inner.diameter


def _shouldered(side: list[ShaftStretch], most: float) -> list[ShaftStretch]:
    """Return stretches whose last one, beside a bearing, is its shoulder where what sits further in goes over that."""
    if len(side) < 2 or side[-1].kind != "between" or not side[-1].length > SAME:
        return side
    wanted = side[-2].shoulder
    return [*side[:-1], side[-1].of(wanted)] if side[-1].diameter < wanted <= most + SAME else side


def _core(
    shaft: str,
    middle: list[ShaftStretch],
    sides: tuple[list[ShaftStretch], list[ShaftStretch]],
    wanted: Wanted,
    *,
    past: float,
) -> list[ShaftStretch]:
    """Return the thickest stretches with their diameters; a hub there slides over what is past it."""
    beside = max((side[-1].diameter for side in sides if side), default=0.0)
    needed = max(beside, *(wanted.needed.get(stretch.name, 0.0) for stretch in middle))
    if middle[0].kind == "integral":
        return _integral(shaft, middle, beside, wanted)
    (only,) = middle
    if only.kind == "between":
        needed = max(needed, *(side[-1].shoulder for side in sides if side), 0.0)
    diameter = wanted.fixed.get(only.name, wanted.core)
    if diameter is not None and diameter < beside - SAME:
        given, seats = apart(diameter, beside, "length")
        message = f"{given} is thinner than the seats beside it, {seats}; give that or more"
        raise DesignError([Problem(f"layout.{shaft}.diameter", message)])
    laid = only.of(_passing(only.name, wanted, needed, past) if diameter is None else diameter)
    _refuse_past(shaft, laid, wanted, past)
    return [laid]


def _necked(
    middle: list[ShaftStretch], sides: tuple[list[ShaftStretch], list[ShaftStretch]], wanted: Wanted
) -> list[ShaftStretch]:
    """Return a long stretch between two bearings as a neck between their shoulders, as thick as strength asks."""
    only = middle[0]
    ends = [side[-1] for side in sides if side]
    if only.kind != "between" or wanted.core is not None or len(ends) < 2:
        return middle
    neck = whole_millimetres(max(wanted.needed.get(only.name, 0.0), min(end.diameter for end in ends)))
    shoulders = [whole_millimetres(max(end.shoulder, end.diameter)) for end in ends]
    wide = [SHOULDER_WIDTH * shoulder if shoulder > neck + SAME else 0.0 for shoulder in shoulders]
    if not 0.0 < sum(wide) < only.length / 2.0:
        return middle
    first, last = only.start + wide[0], only.end - wide[1]
    return [
        *([only._replace(name=f"collar of {ends[0].name}", end=first, diameter=shoulders[0])] if wide[0] else []),
        only._replace(start=first, end=last, diameter=neck),
        *([only._replace(name=f"collar of {ends[1].name}", start=last, diameter=shoulders[1])] if wide[1] else []),
    ]


def _integral(shaft: str, middle: list[ShaftStretch], beside: float, wanted: Wanted) -> list[ShaftStretch]:
    """Return gears of one piece with the shaft, and what lies between them."""
    limits = {item.name: item.limit for item in wanted.items}
    laid = []
    for stretch in middle:
        if stretch.kind in ("bearing", "hub"):
            message = "it lies between gears of one piece with the shaft and cannot be slid on; move it, or join a gear"
            raise DesignError([Problem(_path(stretch), message)])
        needed = max(beside, wanted.needed.get(stretch.name, 0.0))
        body = min(limits.get(stretch.name, math.inf), LARGEST_BODY * needed)
        laid.append(stretch.of(whole_millimetres(needed) if stretch.kind == "between" else body))
        if stretch.kind == "integral" and needed > limits[stretch.name] + SAME:
            asked, root = apart(needed, limits[stretch.name], "length")
            message = (
                f"the shaft {shaft!r} needs {asked} beside this gear, which has a root circle of {root}; give the gear"
                " more teeth or a larger module, or put the bearings nearer to it"
            )
            raise DesignError([Problem(f"joints.{stretch.name}", message)])
    return laid


def _collared(stretches: list[ShaftStretch], low: int, high: int) -> list[ShaftStretch]:
    """Return stretches with a collar on the longer side of a hub at the thickest place."""
    if stretches[low].kind != "hub" or low != high or (at := _collar(stretches, low)) is None:
        return stretches
    beyond = [stretches[k].shoulder for k in (at - 1, at + 1) if 0 <= k < len(stretches)]
    collar = whole_millimetres(max(COLLAR * stretches[low].diameter, *beyond))
    return [stretch.of(collar) if k == at else stretch for k, stretch in enumerate(stretches)]


def _collar(stretches: Sequence[ShaftStretch], hub: int) -> int | None:
    """Return which of the stretches beside a hub has its collar: the longer one; None where neither has a length."""
    sides = [k for k in (hub - 1, hub + 1) if stretches[k].length > SAME]
    return largest(sides, lambda k: stretches[k].length) if sides else None


def _ends(stretches: list[ShaftStretch], wanted: Wanted) -> list[ShaftStretch]:
    """Return the stretches that have a length; an end that carries nothing is as thick as what slides over it."""
    if stretches[0].diameter == 0.0:
        stretches = [stretches[0].of(_beside(stretches[1], wanted)), *stretches[1:]]
    if stretches[-1].diameter == 0.0:
        stretches = [*stretches[:-1], stretches[-1].of(_beside(stretches[-2], wanted))]
    return [stretch for stretch in stretches if stretch.length > SAME]


def _beside(stretch: ShaftStretch, wanted: Wanted) -> float:
    """Return how thick an end beside a part is: as the part's seat, beside a hub with teeth as they leave it [m]."""
    over = wanted.over(stretch.name, stretch.diameter)
    return stretch.diameter if over == stretch.diameter else math.floor(1e3 * over + 1e-6) / 1e3


# ----------------------------------------------------------------------------------------------------------------------
# How a built shaft bends: slopes at bearings and gears, deflection, first critical speed.
# ----------------------------------------------------------------------------------------------------------------------


GEAR_SLOPE = 0.5e-3
"""Largest slope of a shaft under a gear that is not crowned [rad] (Shigley, table 7-2)."""
BEARING_SLOPES = {"deep-groove": 3e-3, "cylindrical": 1.2e-3, "taper": 1.2e-3}
"""Kind of bearing -> largest slope of the shaft in it [rad] (Shigley, table 7-2, upper values)."""


@dataclass(frozen=True)
class BentShaft:
    """A built shaft, bent by all load cases."""

    sections: Sections
    line: BentLine | None
    """None where only torque acts."""
    bearings: tuple[float, float]
    """Middles of the radial bearings [m]."""
    material: Material
    rows: Sequence[int]
    """Loads that last, by which it must be stiff [-]."""

    def slope(self, place: float) -> float:
        """Return the largest slope of all cases [rad].

        Args:
            place: From the shaft's first end [m].
        """
        return 0.0 if self.line is None else self._largest(self.line.slope, place)

    def deflection(self, place: float) -> float:
        """Return the largest deflection of all cases [m].

        Args:
            place: From the shaft's first end [m].
        """
        return 0.0 if self.line is None else self._largest(self.line.deflection, place)

    def _largest(self, values: Floats, place: float) -> float:
        assert self.line is not None
        planes = between(self.line.position, values, np.array([place]))[..., 0].tolist()
        return max(math.hypot(*planes[k]) for k in self.rows)

    def critical_speed(self, places: Mapping[str, float], masses: Mapping[str, float]) -> float | None:
        """Return the first critical speed in bending of the shaft with its gears, in rigid bearings [rad/s].

        Args:
            places: Gear -> middle [m].
            masses: Gear -> mass [kg].
        """
        if self.line is None:
            return None
        middles, pieces = lumped_shaft(self.sections, self.material.density)
        where = np.append(middles, [places[name] for name in masses])
        weights = np.append(pieces, [masses[name] for name in masses])
        order = np.argsort(where, kind="stable")
        shape = influence(self.sections, self.bearings, where[order], elastic_modulus=self.material.elastic_modulus)
        return critical_speed(shape, weights[order])


def bend(forces: ShaftForces, stretches: Sequence[ShaftStretch], material: Material, *, bore: float) -> BentShaft:
    """Return a shaft bent by what acts on it.

    Args:
        forces: In every load case.
        stretches: From end to end.
        material: Steel.
        bore: Of the shaft [m].
    """
    edges = np.array([stretches[0].start, *(stretch.end for stretch in stretches)])
    diameters = np.array([stretch.diameter for stretch in stretches])
    sections = Sections(edges, diameters, np.full(len(diameters), bore))
    line = None
    if forces.bends:
        line = bent_line(forces.drawn, sections, forces.plan.bearings, elastic_modulus=material.elastic_modulus)
    return BentShaft(sections, line, forces.plan.bearings, material, forces.of_use)


def slope_excess(bent: BentShaft, seats: Mapping[str, BearingSeat], gears: Mapping[str, float]) -> float:
    """Return the largest slope over what is allowed there [-]; up to 1 the shaft is stiff enough.

    Args:
        bent: The shaft.
        seats: Its bearings.
        gears: Gear -> middle [m].
    """
    ratios = [bent.slope(place) / GEAR_SLOPE for place in gears.values()]
    ratios += [
        bent.slope(seat.position) / BEARING_SLOPES[seat.kind] for seat in seats.values() if seat.kind in BEARING_SLOPES
    ]
    return max(ratios, default=0.0)


# ----------------------------------------------------------------------------------------------------------------------
# K_Hβ by the bending lines of the shafts that carry a mesh, once they are built (ISO 6336-1, clause 7, method B).
# ----------------------------------------------------------------------------------------------------------------------


_CLAUSE = "ISO 6336-1, clause 7, by the bending lines"
_OPEN = 'its shafts are not built; give their [bearings], or take face_method = "C"'


def face_load_checks(
    context: Context, gears: Sequence[GearSizing], meshes: Sequence[MeshSizing], built: Sequence[BuiltShaft]
) -> Iterator[Check]:
    """Yield, where a design asks for method B, K_Hβ by the shafts' bending lines against what the safeties leave.

    Args:
        context: What sizing reads.
        gears: As sized.
        meshes: As sized.
        built: Shafts with bearings.

    Source: ISO 6336-1:2006, clause 7.5: f_sh of method C for the pinion's own bend and twist, and b (θ_1 + θ_2) of the
        shafts under both gears, the largest slopes of all cases as if they opened the mesh together.
    """
    slopes = {place: slope for shaft in built for place, slope in shaft.slopes}
    known = {gear.name: gear for gear in gears}
    for mesh in meshes:
        rating = context.ratings[mesh.stage]
        if not isinstance(mesh.rating, Iso6336Rating) or rating.rules.iso6336.face_method != "B":
            continue
        if all(name in slopes for name in mesh.gears):
            factor = face_factor_by_lines(context, mesh, known, slopes)
            limit = float(mesh.rating.factors.face.contact) * method_for(rating).reserve(mesh.rating)
            yield Check(
                mesh.part, "face load", _CLAUSE, factor, limit, at_most=True, exponent=None, symbol="K_Hβ",
                case=mesh.rating.case,
            )  # fmt: skip
        else:
            yield not_assessed(mesh.part, "face load", _CLAUSE, _OPEN)


def face_factor_by_lines(
    context: Context, mesh: MeshSizing, gears: Mapping[str, GearSizing], slopes: Mapping[str, float]
) -> float:
    """Return K_Hβ with the slopes of the shafts under both gears [-].

    Args:
        context: What sizing reads.
        mesh: Rated by ISO 6336.
        gears: Name -> gear.
        slopes: Gear -> slope of its shaft there [rad].

    Source: ISO 6336-1:2006, clauses 7.5 and 7.6.
    """
    rating, rated = context.ratings[mesh.stage], mesh.rating
    assert isinstance(rated, Iso6336Rating)
    first, second = (gears[name] for name in mesh.gears)
    internal = any(row.name == mesh.name and row.sign == INTERNAL for row in context.train.meshes)
    pair = cylindrical_mesh((first.teeth, second.teeth), first.module, first.face_width, rating, internal=internal)
    loads = rated.factors.loads
    specific = float(rated.factors.tangential_force) / first.face_width * float(loads.application * loads.mesh_load)
    tilt = first.face_width * sum(slopes[name] for name in mesh.gears)
    steels = steels_of(rating, (first.role, second.role))
    found = face_load_factor(
        pair,
        Misalignment(rated.factors.face.deflection + tilt, rated.factors.face.manufacture),
        steels,
        stiffness=mesh_springs(pair, specific, steels=steels).face,
        specific_load=specific * loads.dynamic,
        speed=rated.factors.speed,
        modification=quality_of(rating, idlers=(False, False)).helix,
    )
    return float(found.contact)
