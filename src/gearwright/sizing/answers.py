"""Results of a sizing by name, mass breakdown, governing load cases, efficiencies and remarks.

How they are shown is for `render`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from types import MappingProxyType
from typing import Annotated, NamedTuple, get_args, get_type_hints

from gearwright.base import (
    GEARBOX,
    Check,
    DesignError,
    Kind,
    Length,
    Mass,
    Origin,
    PartId,
    Problem,
    Quantity,
    Ratio,
    Speed,
    largest_first,
    marks_at,
    near,
    text,
    verb,
)
from gearwright.parts.gears import GearPair
from gearwright.sizing.arrangement import envelope
from gearwright.sizing.bearing_seats import planet_bodies
from gearwright.sizing.gear_geometry import cylindrical_gear
from gearwright.sizing.losses import lost_power
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.result import GearSizing, MachineSizing, MeshSizing, Sizing
from gearwright.sizing.shaft_results import CarrierSizing, ShaftSizing
from gearwright.spec import Design, Pair
from gearwright.spec.design import CONCEPT
from gearwright.train import INTERNAL, Efficiency, PowerFlow, Train, efficiencies, shaft_powers

# ----------------------------------------------------------------------------------------------------------------------
# What optimisers want little of beside mass, loss and room: shaken meshes, flanks to be ground.
# ----------------------------------------------------------------------------------------------------------------------


def excitation(sizing: Sizing) -> float:
    """Return by how much changing contact lines shake all meshes [N]: √(Σ N (F_t s)²) over rows of N meshes.

    It stands for noise where nobody knows flanks and housing: the quieter of two gearboxes for one power has the less.

    Args:
        sizing: As sized; bevel and face gears are left out.

    Source: s = 2 |sinc(ε_α) sinc(ε_β)|, sinc(x) = sin(πx)/(πx): first harmonic over the mean of the length of contact
        lines of perfect cylindrical gears, Maatar and Velex 1996, J. Mech. Des. 118 (3), 358-363.
    """
    rows = [(mesh.count, mesh.tangential_force * swing_of(pair)) for mesh, pair in _pairs(sizing)]
    return math.sqrt(sum(count * force * force for count, force in rows))


def swing_of(pair: GearPair) -> float:
    """Return the first harmonic of the length of contact lines over its mean [-].

    Args:
        pair: Of cylindrical gears.

    Source: as `excitation`.
    """
    return abs(2.0 * _sinc(pair.transverse_contact_ratio) * _sinc(pair.overlap_ratio))


def _sinc(ratio: float) -> float:
    angle = math.pi * max(abs(ratio), 1e-9)
    return math.sin(angle) / angle


def _pairs(sizing: Sizing) -> Iterator[tuple[MeshSizing, GearPair]]:
    """Yield every row of cylindrical gears with the geometry of one mesh."""
    gears = {gear.name: gear for gear in sizing.gears}
    for mesh, row in zip(sizing.meshes, sizing.train.meshes, strict=True):
        stage = sizing.design.stages[mesh.stage]
        if isinstance(stage, Pair) and stage.kind != "cylindrical":
            continue
        first, second = (cylindrical_gear(sizing.design, gears[gear]) for gear in mesh.gears)
        second = replace(second, teeth=-second.teeth) if row.sign == INTERNAL else second
        moved = first.profile_shift + second.profile_shift != 0.0
        yield mesh, GearPair(first, second, mesh.centre_distance if moved else None)


def flank_area(sizing: Sizing) -> float:
    """Return the area of all flanks, 2 z b h/cos β of every gear [m²], h = 2.25 m_n: what is cut and ground.

    It stands for cost: time and wear of tools go with it, whatever they cost.

    Args:
        sizing: As sized.
    """
    return sum(
        gear.bodies * 2.0 * gear.teeth * gear.face_width * 2.25 * gear.module / math.cos(gear.helix_angle)
        for gear in sizing.gears
    )


# ----------------------------------------------------------------------------------------------------------------------
# How a train and its epicyclic sets pass power in every case, driven from either side; what locks itself, by name.
# ----------------------------------------------------------------------------------------------------------------------


SOURCE = "equilibrium with the loss of every mesh, relative to its carrier (Müller 1998, Die Umlaufgetriebe)"


@dataclass(frozen=True)
class Passing:
    """Efficiency of the teeth of a train or of one of its sets, in one case."""

    case: str
    part: str
    """The gearbox, or a planetary or compound set."""
    driving: str
    """Shafts that give power to it, the largest first."""
    driven: str
    """Shafts that take power from it."""
    forwards: Annotated[Ratio, Origin("η = P_out/P_in", SOURCE)]
    """As the case drives it [-]."""
    backwards: Annotated[Ratio, Origin("η with every torque turned", SOURCE)]
    """Where the driven shafts drive it [-]; what is not above zero locks."""
    locking: str
    """Who cannot drive it, and who can, where it is self-locking; else empty."""


def passing(sizing: Sizing) -> tuple[Passing, ...]:
    """Return how power passes in every case with losses: the gearbox, and each set where it has several stages.

    Args:
        sizing: As sized.
    """
    return tuple(
        _row(case, part, way)
        for case, flow in sizing.flows.items()
        if flow.loss
        for part, way in _shown(sizing.design, ways_of(sizing, flow))
    )


def ways_of(sizing: Sizing, flow: PowerFlow, parts: Collection[str] | None = None) -> dict[str, Efficiency]:
    """Return how every stage passes power in a case, and the gearbox under an empty name.

    Args:
        sizing: As sized.
        flow: One of its cases.
        parts: Stages that are asked for, or the empty name; left out: all.
    """
    return efficiencies(sizing.design, sizing.train, sizing.teeth, flow, sizing.design.efficiencies, parts=parts)


def locking_checks(
    design: Design, train: Train, teeth: Mapping[str, float], flows: Mapping[str, PowerFlow]
) -> Iterator[Check]:
    """Yield a check that fails of every stage to which all its shafts give power: a case drives it as it locks.

    Args:
        design: With the efficiencies of its meshes.
        train: Its graph.
        teeth: Tooth number of every gear.
        flows: Its cases.
    """
    for case, flow in flows.items():
        powers = shaft_powers(train, flow)
        given = {stage: [power for (giver, _), power in powers.items() if giver == stage] for stage in design.stages}
        swallowing = [stage for stage, own in given.items() if _swallows(own)]
        ways = efficiencies(design, train, teeth, flow, design.efficiencies) if swallowing else {}
        for stage in swallowing:
            way = ways.get(stage)
            if way is not None and way.forwards <= 0.0:
                yield Check(
                    part=PartId(Kind.STAGE, stage), mode="self-locking", clause=SOURCE, case=case, exponent=None,
                    value=-sum(given[stage]), limit=0.0, dimension="power",
                    at_most=True, why=way.locking,
                )  # fmt: skip


def _swallows(powers: Sequence[float]) -> bool:
    """Tell whether a stage that gives such powers to its shafts [W] gives none any of what it gets; beside rounding."""
    least, most = min(powers, default=0.0), max(powers, default=0.0)
    return least < 0.0 and most <= -1e-9 * least


def _shown(design: Design, ways: Mapping[str, Efficiency]) -> Iterator[tuple[str, Efficiency]]:
    """Yield the gearbox and its epicyclic sets, of a gearbox that is one set the set alone."""
    sets = {stage: way for stage, way in ways.items() if stage and not isinstance(design.stages[stage], Pair)}
    if "" in ways and not (len(design.stages) == 1 and sets):
        yield str(GEARBOX), ways[""]
    yield from sets.items()


def _row(case: str, part: str, way: Efficiency) -> Passing:
    driving, driven = ", ".join(way.driving), ", ".join(way.driven)
    locking = f"self-locking: {way.locking}" if way.locking else ""
    return Passing(case, part, driving, driven, way.forwards, way.backwards, locking)


# ----------------------------------------------------------------------------------------------------------------------
# Results of a sizing by name, for studies and scripts: ``mass``, ``motor_mass``, ``gears.first.sun.module`` …
# ----------------------------------------------------------------------------------------------------------------------


TEXT = "text"
"""Dimension of a result that is a name, such as the part that governs."""


class Named(NamedTuple):
    """A result with its dimension."""

    value: float | str
    """In SI; a text where the result is a name."""
    dimension: str
    """Such as ``"mass"``, a key of the table of shown units; ``TEXT`` of a text."""


@verb
def named_results(sizing: Sizing) -> dict[str, Named]:
    """Return every number of a sizing by its dotted name.

    Args:
        sizing: What was sized.
    """
    return {**_totals(sizing, [*_TOTALS, *_SUMS, *_MORE]), **dict(_part_results(sizing))}


def total_results(sizing: Sizing) -> dict[str, Named]:
    """Return what a sizing amounts to, by name.

    Args:
        sizing: What was sized.
    """
    return {name: total(sizing) for name, total in _TOTALS.items()}


def complete_results(sizing: Sizing) -> dict[str, Named]:
    """Return the sum of all parts and the limits of its band of 68 %, by name.

    Args:
        sizing: What was sized.
    """
    mass = complete_mass(sizing)
    return {name: Named(value, "mass") for name, value in zip(_SUMS, (mass.total, *mass.band), strict=True)}


def asked_results(sizing: Sizing, asked: Collection[str]) -> dict[str, Named]:
    """Return results of a sizing with those that are asked among them, where it has them; little more than need be.

    Args:
        sizing: What was sized.
        asked: Their names.
    """
    if all(name in _TOTALS or name in _SUMS or name in _MORE for name in asked):
        return _totals(sizing, asked)
    return named_results(sizing)


def _totals(sizing: Sizing, asked: Collection[str]) -> dict[str, Named]:
    """Return totals by name, each computed only where it is asked for."""
    sums = complete_results(sizing) if set(asked) & set(_SUMS) else {}
    more = {**_TOTALS, **_MORE}
    return {name: sums[name] if name in sums else more[name](sizing) for name in asked}


def _backwards(sizing: Sizing) -> Named:
    """Return the efficiency of a gearbox that its driven machines drive; what is not above zero locks itself."""
    ways = ways_of(sizing, sizing.reference, ("",)) if sizing.reference.loss else {}
    return Named(ways[""].backwards if "" in ways else 1.0, "ratio")


def _efficiency(flow: PowerFlow) -> float:
    """Return power out over power in, of mesh losses alone [-]."""
    return 1.0 - flow.loss / sum(power for power in flow.machine_powers.values() if power > 0.0)


_SUMS = ("complete_mass", "complete_mass.low", "complete_mass.high")
"""Results of the complete mass."""
_TOTALS: Mapping[str, Callable[[Sizing], Named]] = MappingProxyType({
    "mass": lambda sizing: Named(sizing.mass, "mass"),
    "gear_mass": lambda sizing: Named(sizing.gear_mass, "mass"),
    "shaft_mass": lambda sizing: Named(sizing.shaft_mass, "mass"),
    "carrier_mass": lambda sizing: Named(sizing.carrier_mass, "mass"),
    "motor_mass": lambda sizing: Named(sizing.motor_mass, "mass"),
    "total_mass": lambda sizing: Named(sizing.mass + sizing.machines_mass, "mass"),
    "inverter_mass": lambda sizing: Named(sizing.inverter_mass, "mass"),
    "cooling_mass": lambda sizing: Named(sizing.cooling_mass, "mass"),
    "power_density": lambda sizing: Named(sizing.power_density, "specific_power"),
    "total_power_density": lambda sizing: Named(sizing.total_power_density, "specific_power"),
    "worst_margin": lambda sizing: Named(sizing.worst_margin, "ratio"),
    "efficiency": lambda sizing: Named(_efficiency(sizing.reference), "ratio"),
    "efficiency_backwards": _backwards,
})  # fmt: skip
"""What a sizing amounts to, each computed only where it is asked for."""
_MORE: Mapping[str, Callable[[Sizing], Named]] = MappingProxyType({
    "loss": lambda sizing: Named(lost_power(sizing), "power"),
    "excitation": lambda sizing: Named(excitation(sizing), "force"),
    "flank_area": lambda sizing: Named(flank_area(sizing), "area"),
    "envelope.width": lambda sizing: Named(envelope(sizing).width, "length"),
    "envelope.height": lambda sizing: Named(envelope(sizing).height, "length"),
    "envelope.length": lambda sizing: Named(envelope(sizing).length, "length"),
    "envelope.volume": lambda sizing: Named(envelope(sizing).volume, "volume"),
})  # fmt: skip
"""More of them, of which nobody is told who asks for none by name."""


@verb
def pick(results: dict[str, Named], name: str) -> Named:
    """Return one result.

    Args:
        results: From `named_results`.
        name: Its name.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name not in results:
        raise DesignError([Problem(f"results.{name}", f"there is no such result; {near(name, results)}")])
    return results[name]


def _part_results(sizing: Sizing) -> Iterator[tuple[str, Named]]:
    """Yield the numbers of every gear, mesh, shaft, carrier and machine."""
    for group in ("gears", "meshes", "shafts", "carriers", "machines"):
        for part in getattr(sizing, group):
            name = getattr(part, "stage" if group == "carriers" else "name")
            for field, dimension in _QUANTITIES[type(part)]:
                value = getattr(part, field)
                if value is not None:
                    yield f"{group}.{name}.{field}", Named(float(value), dimension)
    for case, flow in sizing.flows.items():
        for shaft, speed in flow.speeds.items():
            yield f"cases.{case}.{shaft}.speed", Named(speed, "speed")
        for machine, power in flow.machine_powers.items():
            yield f"cases.{case}.{machine}.power", Named(power, "power")
            yield f"cases.{case}.{machine}.torque", Named(flow.machine_torques[machine], "torque")


def _quantities(kind: type) -> tuple[tuple[str, str], ...]:
    """Return the numbers of a record: those with a dimension, whole ones, and those that a record inside made."""
    hints = get_type_hints(kind, include_extras=True)
    values = []
    for field in fields(kind):
        marks = [mark for mark in get_args(hints[field.name])[1:] if isinstance(mark, Quantity)]
        if marks:
            values.append((field.name, marks[0].dimension))
        elif hints[field.name] is int:
            values.append((field.name, "number"))
    handed = [
        name for name, entry in vars(kind).items() if isinstance(entry, property) and marks_at(kind, name).made_in
    ]
    return (*values, *((name, marks_at(kind, name).dimension) for name in handed))


_QUANTITIES = {kind: _quantities(kind) for kind in (GearSizing, MeshSizing, ShaftSizing, CarrierSizing, MachineSizing)}
"""Record -> its numbers, looked up once."""


# ----------------------------------------------------------------------------------------------------------------------
# Breakdown: masses part by part, forces on bearings, and speeds that the teeth give only nearly.
# ----------------------------------------------------------------------------------------------------------------------


KEPT = 1e-9
"""Deviation of a speed below which it counts as kept [-]; rounding is far below."""
ROUNDING = 1e-9
"""Force beside the largest that counts as rounding [-]."""


@dataclass(frozen=True)
class MassPart:
    """One line of the mass breakdown."""

    part: str
    group: str
    """gears, shafts, carriers or planet bearings."""
    count: int
    """How many of it [-]."""
    each: Mass
    """Of one [kg]."""
    total: Mass
    """Of all [kg]."""
    share: Annotated[float, Quantity("percent")]
    """Of the sum of these parts [-]."""


@dataclass(frozen=True)
class AskedSpeed:
    """A speed that the teeth give only nearly."""

    case: str
    machine: str
    asked: Speed
    """[rad/s]"""
    actual: Speed
    """[rad/s]"""
    deviation: Annotated[float, Quantity("percent"), Origin("actual / asked − 1", "kinematics of the teeth")]
    """[-]"""


@dataclass(frozen=True)
class BearingForce:
    """What one bearing carries in the case that governs its shaft."""

    shaft: str
    case: str
    position: Length
    """From the shaft's first end [m]."""
    radial_force: Annotated[float, Quantity("force"), Origin("√(F_y² + F_z²)", "equilibrium in both planes")]
    """[N]"""


def mass_parts(sizing: Sizing) -> tuple[MassPart, ...]:
    """Return the mass breakdown of gears, shafts, carriers and weighed planet bearings, heaviest first.

    Args:
        sizing: As sized.
    """
    return tuple(largest_first(_mass_rows(sizing), lambda row: row.total))


def mass_groups(sizing: Sizing) -> dict[str, Mass]:
    """Return the mass of gears, shafts, carriers and weighed planet bearings, of those that there are [kg].

    Args:
        sizing: As sized.
    """
    groups = dict[str, Mass]()
    for row in _mass_rows(sizing):
        groups[row.group] = groups.get(row.group, 0.0) + row.total
    return groups


def _mass_rows(sizing: Sizing) -> list[MassPart]:
    """Return the parts group by group."""
    parts = [(gear.name, "gears", gear.bodies, gear.mass) for gear in sizing.gears]
    parts += [(shaft.name, "shafts", 1, shaft.mass) for shaft in sizing.shafts]
    parts += [(str(carrier.part), "carriers", 1, carrier.mass) for carrier in sizing.carriers]
    if sizing.level != CONCEPT:
        parts += [(f"{gear.name} bearing", "planet bearings", gear.bodies, gear.runs_on.mass)
                  for gear in sizing.gears if gear.runs_on]  # fmt: skip
    return [
        MassPart(part, group, count, mass, count * mass, count * mass / sizing.parts_mass)
        for part, group, count, mass in parts
    ]


def asked_speeds(sizing: Sizing) -> tuple[AskedSpeed, ...]:
    """Return every asked speed that the teeth do not give exactly.

    Args:
        sizing: As sized.
    """
    return tuple(
        AskedSpeed(case, yielded.machine, yielded.asked, yielded.actual, yielded.deviation)
        for case, flow in sizing.flows.items()
        for yielded in flow.yielded
        if abs(yielded.deviation) > KEPT
    )


def bearing_forces(sizing: Sizing) -> tuple[BearingForce, ...]:
    """Return the load of every bearing on shafts of one diameter, shaft by shaft.

    Args:
        sizing: As sized.
    """
    built = {shaft.name for shaft in sizing.built_shafts}
    largest = max((bearing.radial_force for shaft in sizing.shafts for bearing in shaft.bearings), default=0.0)
    return tuple(
        BearingForce(shaft.name, shaft.case, bearing.position, _above_rounding(bearing.radial_force, largest))
        for shaft in sizing.shafts
        for bearing in shaft.bearings
        if shaft.name not in built
    )


def _above_rounding(value: float, largest: float) -> float:
    return value if value > ROUNDING * largest else 0.0


# ----------------------------------------------------------------------------------------------------------------------
# Which load cases are looked at where none is named: the one that sizes, and those that fail.
# ----------------------------------------------------------------------------------------------------------------------


EQUAL = 1e-6
"""Part by which margins may differ and be equal [-]: what sizing makes just enough in two cases is so in both."""


def governing_case(sizing: Sizing) -> str:
    """Return the load case with the least margin of the sizing, the earlier in the file of equals.

    A case in which nothing turns is taken only where it does in none.

    Args:
        sizing: As sized.
    """
    turning = _turning(sizing)
    margins = dict.fromkeys(turning, math.inf)
    for check in sizing.checks:
        if check.case in margins and check.margin is not None:
            margins[check.case] = min(margins[check.case], check.margin)
    least = min(margins.values())
    return next(case for case in turning if margins[case] <= least * (1.0 + EQUAL))


def telling_cases(sizing: Sizing) -> tuple[str, ...]:
    """Return the governing case, and behind it every other one in which a check of the sizing fails.

    Args:
        sizing: As sized.
    """
    failing = {check.case for check in sizing.checks if check.fails}
    return tuple(dict.fromkeys([governing_case(sizing), *(case for case in _turning(sizing) if case in failing)]))


def _turning(sizing: Sizing) -> list[str]:
    """Return the cases in which a machine turns, in the order of the file; all where it does in none."""
    cases = list(sizing.design.cases or sizing.flows)
    turning = [case for case in cases if any(sizing.flows[case].speeds[one.shaft] for one in sizing.machines)]
    return turning or cases


# ----------------------------------------------------------------------------------------------------------------------
# What a sizing gives although nobody makes it so: teeth too small to cut, planets that their bearings use up.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_MODULE = 0.2e-3
"""Below it teeth are those of watches, moulded or punched rather than cut [m]; an estimate: standards of gears in fine
mechanics begin about here."""


def remarks(sizing: Sizing) -> tuple[str, ...]:
    """Return what to know of a sizing that no check says, as sentences with the path to change.

    Args:
        sizing: As sized.
    """
    return (*_small_teeth(sizing), *_bored_away(sizing))


def _small_teeth(sizing: Sizing) -> Iterator[str]:
    """Yield a sentence where modules are smaller than gears are cut."""
    small = {gear.stage: gear.module for gear in sizing.gears if gear.module < LEAST_MODULE}
    if small:
        modules = ", ".join(f"{stage} {text(module, 'length')}" for stage, module in small.items())
        paths = ", ".join(f"{sizing.design.table(stage)}.module_mm" for stage in small)
        least = text(LEAST_MODULE, "length")
        yield (
            f"Modules below {least}, which nobody cuts: {modules}. What the loads ask is less than what can be made;"
            f" give {paths}, such as 0.3."
        )


def _bored_away(sizing: Sizing) -> Iterator[str]:
    """Yield a sentence for every planet whose bearing is larger outside than its root circle."""
    for body in planet_bodies(sizing.design, sizing.gears):
        for step in body.steps:
            if step.runs_on is None:
                continue
            root = 2.0 * cylindrical_gear(sizing.design, step).root_radius
            outside = step.runs_on.outer_diameter
            if outside >= root:
                path = f"planetaries.{step.stage}.planet_bearing"
                yield (
                    f"{path}: {step.runs_on.designation} is {text(outside, 'length', 4)} outside and the root circle of"
                    f" {step.name} {text(root, 'length', 4)}: nothing is left of the planet, and neither its mass nor"
                    f" its life says anything. Give a smaller one, or a larger module or more teeth to {step.stage}."
                )
