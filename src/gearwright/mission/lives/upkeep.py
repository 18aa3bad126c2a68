"""Maintenance of a gearbox: what is looked at or changed when, what decides it, and what has to come out before."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

from gearwright.base import CELSIUS, GEARBOX, Check, Kind, Life, PartId, Role, carrier_part, smallest_first, text
from gearwright.mission.flight import Flight
from gearwright.mission.lives.life import Durability
from gearwright.parts.bearings import system_life, weibull_slope
from gearwright.parts.upkeep import LEAKAGE, lip_life, lip_wear_life, oil_life
from gearwright.sizing import Sizing
from gearwright.sizing.bearing_seats import PlanetBody, bearing_seats, planet_bodies
from gearwright.sizing.making import ENDS, Withdrawn, leaves_past, withdrawals
from gearwright.sizing.result import Body
from gearwright.sizing.shafts.ends import LIP_WARMER, Exit, exits_of

# ----------------------------------------------------------------------------------------------------------------------
# One task of maintenance, and all of a gearbox in the order of their intervals.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Upkeep:
    """One task of maintenance."""

    part: PartId
    """To what it is done."""
    task: str
    """What is done."""
    interval: Life | None
    """After which [s]; None where nothing says it."""
    decides: str
    """What of it lives so long, or why nothing says it."""
    first: tuple[str, ...]
    """What has to come off before, in this order; empty where nothing has."""
    opens: bool
    """Whether the housing has to be opened."""
    source: str

    @property
    def removed_first(self) -> str:
        """What has to come off before, in words."""
        return ", then ".join(self.first) or "nothing"


def upkeep_of(sizing: Sizing, flight: Flight | None = None, lives: Durability | None = None) -> tuple[Upkeep, ...]:
    """Return the maintenance of a gearbox, the shortest interval first.

    Args:
        sizing: As sized.
        flight: Of it; None: its oil is as warm as the design says.
        lives: Of the flight.
    """
    tasks = [*_oil(sizing, flight), *_seals(sizing), *_planets(sizing, lives), *_modules(sizing)]
    known = [task for task in tasks if task.interval is not None]
    return (
        *smallest_first(known, lambda task: task.interval or 0.0),
        *(task for task in tasks if task.interval is None),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Oil, its filter, the chip detector: what a gearbox's own system has outside of its housing.
# ----------------------------------------------------------------------------------------------------------------------


INSPECTION = 100.0 * 3600.0
"""Between looks at a chip detector and at the outside [s]: 14 CFR 91.409(b), inspection of aircraft for hire."""
FILTERS = 2.0
"""Changes of a filter in one of the oil, an estimate [-]."""
_OIL_SOURCE = "SKF, Rolling bearings, oil bath: a year up to 50 °C, three months at 100 °C (from memory)"


def _oil(sizing: Sizing, flight: Flight | None) -> Iterator[Upkeep]:
    housing = sizing.design.housing
    if housing.oil_system == "shared":
        return
    warm = sizing.design.oil.temperature if flight is None else flight.hottest_oil - CELSIUS
    life = oil_life(warm)
    yield Upkeep(GEARBOX, "change oil", life, f"it ages at {warm:.0f} °C", (), opens=False, source=_OIL_SOURCE)
    if housing.oil_system == "own":
        why = "half of the oil's life; its indicator of pressure loss before"
        yield Upkeep(GEARBOX, "change oil filter", life / FILTERS, why, (), opens=False, source="estimate")
        why = "chips of teeth and bearings before they fail; its signal between inspections"
        source = "14 CFR 91.409(b), 29.1337(e)"
        yield Upkeep(GEARBOX, "look at chip detector", INSPECTION, why, (), opens=False, source=source)


# ----------------------------------------------------------------------------------------------------------------------
# Seals: pressed into covers from outside, behind the machine towards which the shaft leaves.
# ----------------------------------------------------------------------------------------------------------------------


_SEAL_SOURCE = "Arrhenius, half for 10 K; 250 000 km of sliding: estimates; DIN 3761 (from memory)"


def _seals(sizing: Sizing) -> Iterator[Upkeep]:
    for leaves in exits_of(sizing):
        part, task = PartId(Kind.MACHINE, leaves.machine), "change seal"
        if leaves.elastomer is None:
            yield Upkeep(part, task, None, leaves.lacking, (leaves.machine,), opens=False, source=_SEAL_SOURCE)
        else:
            life, why = _lip(sizing, leaves)
            yield Upkeep(part, task, life, why, (leaves.machine,), opens=False, source=_SEAL_SOURCE)


def _lip(sizing: Sizing, leaves: Exit) -> tuple[float, str]:
    """Return how long a lip lives [s], and by what."""
    lip, warm = leaves.elastomer, sizing.design.oil.temperature + LIP_WARMER
    assert lip is not None
    tight = f"lets through {1e6 * 3600.0 * LEAKAGE:.3g} mg/h at most"
    heat = lip_life(lip.hottest, warm)
    wear = lip_wear_life(leaves.velocity) if leaves.velocity else math.inf
    if heat < wear:
        return heat, f"{lip.mark} at {warm:.0f} °C; {tight}"
    return wear, f"{lip.mark} worn at {text(leaves.velocity, 'velocity')}; {tight}"


# ----------------------------------------------------------------------------------------------------------------------
# Bearings of planets: the first of a set to fail, and what stands between it and the nearer end of the housing.
# ----------------------------------------------------------------------------------------------------------------------


_SET_SOURCE = "ISO 281; Weibull's product over the set"


def _planets(sizing: Sizing, lives: Durability | None) -> Iterator[Upkeep]:
    for body in planet_bodies(sizing.design, sizing.gears):
        first = (*way_to(sizing, body.stage), str(carrier_part(body.stage)))
        life, why = _set_life(sizing, body, lives)
        yield Upkeep(body.part, "change bearings", life, why, first, opens=True, source=_SET_SOURCE)


def _set_life(sizing: Sizing, body: PlanetBody, lives: Durability | None) -> tuple[float | None, str]:
    """Return the life of all bearings of a set together [s], and by what."""
    if any(step.runs_on is not None and step.runs_on.journal is not None for step in body.steps):
        return None, "a film bears: it has no rating life, wear of starts decides"
    kinds = [step.runs_on.bearing.kind for step in body.steps if step.runs_on and step.runs_on.bearing]
    parts = {seat.part for seat in bearing_seats(sizing) if _is_of(seat.part, body)}
    names = {str(part) for part in parts}
    rows = [] if lives is None else [row for row in lives.bearings.rows if row.seat in names]
    singles = [(3600.0 * row.life, weibull_slope(row.bearing.kind)) for row in rows for _ in range(row.count)]
    over = " over the flight" if rows else ""
    if not rows and kinds:
        known = [check.value for check in sizing.checks if check.dimension == "life" and check.part in parts]
        equal = body.steps[0].bodies
        singles = [(life, weibull_slope(kinds[0])) for life in known if life is not None for _ in range(equal)]
    if not singles:
        return None, "the design names no bearing of its planets"
    life = system_life([one for one, _ in singles], [slope for _, slope in singles])
    return life, f"L_10 of all {len(singles)} together{over}"


def _is_of(part: PartId, body: PlanetBody) -> bool:
    """Tell whether a bearing sits in a body of planets."""
    return (part.kind, part.name, part.role) == (Kind.BEARING, body.stage, Role.PLANET) and part.own in {
        step.own for step in body.steps
    }


class _Stage(NamedTuple):
    """A stage as it stands along the first shaft; lengths [m]."""

    name: str
    low: float
    high: float
    bodies: tuple[Body, ...]


def way_to(sizing: Sizing, stage: str) -> tuple[str, ...]:
    """Return what stands before a stage on its way out by the nearer end of the housing along the first shaft.

    That is the end with fewer stages before it, of equals the first: machines at that end, the housing there, then
    those stages, from outside.

    Args:
        sizing: As sized.
        stage: Its name.
    """
    stages = _stages(sizing)
    own = next(one for one in stages if one.name == stage)
    ways = []
    for end in (-1, 1):
        before = [one for one in stages if one is not own and _blocks(one, own, end)]
        ways.append((end, sorted(before, key=lambda one: one.low + one.high, reverse=end > 0)))
    end, before = min(ways, key=lambda way: len(way[1]))
    machines = [name for name, shaft in sizing.train.machines.items() if _beyond(sizing, name, shaft, own, end)]
    opened = [f"housing at its {ENDS[end]} end"] if sizing.design.housing.own else []
    return (*machines, *opened, *(one.name for one in before))


def _stages(sizing: Sizing) -> list[_Stage]:
    found = list[_Stage]()
    for name in sizing.design.stages:
        bodies = tuple(
            body for body in sizing.arrangement.bodies
            if body.part.kind in (Kind.GEAR, Kind.CARRIER) and body.part.name == name
        )  # fmt: skip
        ends = [place for body in bodies for place in _ends(body)]
        found.append(_Stage(name, min(ends), max(ends), bodies))
    return found


def _ends(body: Body) -> tuple[float, float]:
    """Return where a body begins and ends along the first shaft [m]."""
    across = math.sqrt(max(1.0 - body.direction.x**2, 0.0))
    reach = [body.origin.x + one.place * body.direction.x for one in body.stations]
    wide = [across * one.radius for one in body.stations]
    return (
        min(x - r for x, r in zip(reach, wide, strict=True)),
        max(x + r for x, r in zip(reach, wide, strict=True)),
    )


def _blocks(other: _Stage, own: _Stage, end: int) -> bool:
    """Tell whether a stage stands before another on its way to an end: beyond its middle, and in line with it."""
    ahead = end * (other.low + other.high - own.low - own.high) > 0.0
    return ahead and any(
        math.hypot(one.origin.y - two.origin.y, one.origin.z - two.origin.z) < one.radius + two.radius
        for one in other.bodies
        for two in own.bodies
    )


def _beyond(sizing: Sizing, machine: str, shaft: str, own: _Stage, end: int) -> bool:
    """Tell whether a machine stands beyond a stage towards an end of the housing."""
    plan, frame = sizing.arrangement.plans.get(shaft), sizing.arrangement.frames.get(shaft)
    if plan is None or frame is None or machine not in plan.places:
        return False
    place = frame.origin.x + plan.places[machine] * frame.along.x
    return place > own.high if end > 0 else place < own.low


# ----------------------------------------------------------------------------------------------------------------------
# Modules: shafts in bearings with all that sits on them, and the fewest others that must come out before.
# ----------------------------------------------------------------------------------------------------------------------


_MODULE_SOURCE = "ISO 281, Weibull's product; bodies drawn out along their axes"


def _modules(sizing: Sizing) -> Iterator[Upkeep]:
    out, stuck = withdrawals(sizing)
    ways = {step.shaft: step for step in out}
    for shaft in sizing.built_shafts:
        own = [bearing for bearing in sizing.bearings if bearing.shaft == shaft.name]
        slopes = [weibull_slope(bearing.bearing.kind) for bearing in own]
        life = system_life([bearing.judged_life or bearing.life for bearing in own], slopes)
        part, why = PartId(Kind.SHAFT, shaft.name), f"L_10 of its {len(own)} bearings together"
        if shaft.name in stuck:
            first: tuple[str, ...] = (f"housing beside it: locked in with {', '.join(stuck)}",)
        else:
            first = _before(sizing, ways[shaft.name], out)
        asked = life if math.isfinite(life) else None
        yield Upkeep(part, "overhaul with its bearings", asked, why, first, opens=True, source=_MODULE_SOURCE)


def _before(sizing: Sizing, step: Withdrawn, out: Sequence[Withdrawn]) -> tuple[str, ...]:
    """Return the fewest shafts that must leave before one can, with the machines beside it and the housing's end."""
    every = [one.shaft for one in out]
    earlier = out[: out.index(step)]
    for count in range(len(earlier) + 1):
        for chosen in combinations(earlier, count):
            if all(
                leaves_past(sizing, one, [name for name in every if name not in [gone.shaft for gone in chosen[:k]]])
                for k, one in enumerate((*chosen, step))
            ):
                machines = [name for name, shaft in sizing.train.machines.items() if shaft == step.shaft]
                shafts = [f"shaft {one.shaft}" for one in chosen]
                return (*machines, f"covers and housing at the {ENDS[step.way]} end of {step.shaft}", *shafts)
    return ()


# ----------------------------------------------------------------------------------------------------------------------
# What is asked between overhauls, where a design asks for it.
# ----------------------------------------------------------------------------------------------------------------------


def upkeep_checks(sizing: Sizing, tasks: Sequence[Upkeep]) -> Iterator[Check]:
    """Yield of every task that opens the housing whether its interval is the one that is asked; nothing where none is.

    Args:
        sizing: As sized.
        tasks: From `upkeep_of`.
    """
    asked = sizing.design.housing.overhaul_interval
    for task in tasks if asked is not None else ():
        if task.opens and task.interval is not None:
            yield Check(
                task.part, "overhaul interval", task.source, task.interval, asked, "life", exponent=None,
                place=task.decides,
            )  # fmt: skip
