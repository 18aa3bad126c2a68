"""Forbidden frequency bands in the search for tooth numbers, by stage and for whole trains."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Problem, text
from gearwright.sizing.teeth.front import Ban, Front, Task
from gearwright.spec import GROUND, Design, Pair, Planetary, case_named, edited
from gearwright.spec.design import ForbiddenBand, cases_forbidding
from gearwright.train import (
    PowerFlow,
    Targets,
    Train,
    Turning,
    asked_speeds,
    build_train,
    gears_of,
    members_of,
    passes,
    power_flow,
)

# ----------------------------------------------------------------------------------------------------------------------
# Forbidden bands of frequencies in the search: which teeth of a stage pass at none, in every case that turns alike.
#
# A case turns as the search does where the same machine keeps its speed and the same clutches hold: all its speeds are
# then those of the search times one factor, whatever the teeth. What other cases do only whole trains tell.
# ----------------------------------------------------------------------------------------------------------------------


_STILL = 1e-9
"""Part of the largest speed below which a shaft stands still [-]."""
_SAME = 1e-9
"""Part by which factors of two kept machines may differ [-]."""


class Banned(NamedTuple):
    """Stages with the bands that they are held against, and what they cannot tell."""

    tasks: list[Task]
    whole: frozenset[str]
    """Bands that only whole trains can be held against, in some case."""


def banned(
    tasks: Sequence[Task], design: Design, train: Train, nominal: Targets, flows: Mapping[str, PowerFlow]
) -> Banned:
    """Return the stages with what the forbidden bands of a design ask of each.

    Args:
        tasks: Stages of the search.
        design: With the bands.
        train: Its graph.
        nominal: Asked speeds.
        flows: Every load case at the asked ratios.
    """
    bans: dict[str, list[Ban]] = {task.name: [] for task in tasks}
    whole = set[str]()
    for name, band in design.teeth.forbidden.items():
        if design.epicyclics:
            whole.add(name)  # whose own teeth are given, and whose speeds stages after them read
        for case in cases_forbidding(design, band):
            factor = _factor(design, train, nominal, flows[case])
            for task in tasks:
                if not _passes(task, band, flows[case]):
                    continue
                if factor is None or task.edge is None:
                    whole.add(name)
                else:
                    bans[task.name].append(Ban(name, band, factor))
    return Banned([replace(task, bans=_distinct(bans[task.name])) for task in tasks], frozenset(whole))


def _distinct(bans: Sequence[Ban]) -> tuple[Ban, ...]:
    """Return bans of which no two ask the same: most cases turn at the same speeds."""
    kept: list[Ban] = []
    for ban in bans:
        if not any(ban.name == other.name and bool(ban.factor == other.factor) for other in kept):
            kept.append(ban)
    return tuple(kept)


def _passes(task: Task, band: ForbiddenBand, flow: PowerFlow) -> bool:
    """Tell whether anything of a stage passes that a band is about; not where it stands still, or turns as one."""
    planetary = isinstance(task.stage, Planetary)
    if band.of == "planet-pass" and not planetary:
        return False
    still = _STILL * max(abs(speed) for speed in flow.speeds.values())
    if isinstance(task.stage, Planetary):
        sun, ring, carrier = (flow.speeds[member] for member in members_of(task.stage))
        return bool(abs((ring if band.of == "planet-pass" else sun) - carrier) > still)
    shafts = () if task.edge is None else task.edge.fast
    return any(bool(abs(flow.speeds[shaft]) > still) for shaft in shafts)


def _factor(design: Design, train: Train, nominal: Targets, flow: PowerFlow) -> float | None:
    """Return by what all speeds of a case are those of the search, whatever the teeth; None where nothing tells [-]."""
    still = _STILL * max(abs(speed) for speed in flow.speeds.values())
    standing = {shaft for shaft in design.shafts if bool(abs(flow.speeds[shaft]) <= still)}
    brakes = {joint.name for joint in train.joints if joint.is_brake}
    if set(flow.joints) - brakes != set(nominal.design.clutches) or not standing <= {GROUND, *_held(design, nominal)}:
        return None
    said = case_named(design, flow.case).machines
    stated = any(drive.speed is not None for drive in said.values())
    asked = asked_speeds(design, said if stated else {})
    rated = asked_speeds(nominal.design, {})
    first, second = next(iter(asked), ""), next(iter(rated), "")
    if first != second or len(_kept(asked, flow)) != 1:
        return None
    return abs(asked[first]) / nominal.speeds[design.machines[first].shaft]


def _held(design: Design, nominal: Targets) -> Iterator[str]:
    """Yield the shafts that a brake holds in the case that asks for the speeds."""
    return (shaft for shaft in design.shafts if shaft not in nominal.design.shafts)


def _kept(asked: Mapping[str, float], flow: PowerFlow) -> list[str]:
    """Return the machines whose speeds a case keeps, of those that it asks for."""
    yielded = {machine.machine for machine in flow.yielded}
    return [name for name in asked if name not in yielded]


def clear(front: Front, task: Task) -> Bools:
    """Tell which choices pass at no frequency that is forbidden.

    Args:
        front: Choices with the stage's teeth.
        task: The stage, with its bans; their numbers may be one of each choice.
    """
    good = np.ones(len(front), dtype=bool)
    for ban in task.bans:
        good &= ~inside(front, task, ban)
    return good


def inside(front: Front, task: Task, ban: Ban) -> Bools:
    """Tell which choices pass at a frequency inside a band.

    Args:
        front: Choices with the stage's teeth.
        task: The stage.
        ban: One of its own.
    """
    return taken(ban.band, ban.factor * _rate(front, task, ban.band) / (2.0 * math.pi))


def taken(band: ForbiddenBand, frequency: Floats) -> Bools:
    """Tell which frequencies a band takes, themselves or a multiple of them, shape (n,).

    Args:
        band: The band; at its ends a frequency is allowed.
        frequency: Of teeth or planets that pass, shape (n,) [Hz].
    """
    within = np.zeros(len(frequency), dtype=bool)
    for harmonic in range(1, band.harmonics + 1):
        within |= (harmonic * frequency > band.lowest) & (harmonic * frequency < band.highest)
    return within


def ends_of(band: ForbiddenBand) -> str:
    """Return the ends of a band in words.

    Args:
        band: The band.
    """
    return f"{text(band.lowest, 'frequency')} to {text(band.highest, 'frequency')}"


def _rate(front: Front, task: Task, band: ForbiddenBand) -> Floats:
    """Return how often teeth mesh, or planets pass, in 2π s [1/s]."""
    stage, small = task.stage, gears_of(task.name, task.stage)[0]
    zero = np.zeros(len(front))
    if isinstance(stage, Planetary):
        sun, ring, carrier = (zero if node == GROUND else front.speeds[node] for node in members_of(stage))
        if band.of == "planet-pass":
            return np.asarray(front.planets[task.name] * np.abs(carrier - ring))
        return np.asarray(front.teeth[small] * np.abs(sun - carrier))
    assert task.edge is not None
    return np.asarray(front.teeth[small] * front.speeds[task.edge.fast[0]])


def refused(task: Task, fronts: Sequence[Front]) -> DesignError:
    """Return the error of a stage whose teeth all pass at forbidden frequencies, with what each band takes.

    Args:
        task: The stage.
        fronts: Its choices, all of which pass at some.
    """
    front = fronts[0].joined(fronts[1:])
    teeth = len(np.unique(np.stack([front.teeth[gear] for gear in gears_of(task.name, task.stage)]), axis=1).T)
    path = f"{'pairs' if isinstance(task.stage, Pair) else 'planetaries'}.{task.name}"
    names = dict.fromkeys(ban.name for ban in task.bans)
    return DesignError(_problem(path, task, front, name, teeth) for name in names)


def _problem(path: str, task: Task, front: Front, name: str, teeth: int) -> Problem:
    """Return what one band takes of the teeth of a stage."""
    own = [ban for ban in task.bans if ban.name == name]
    band = own[0].band
    within = np.any([inside(front, task, ban) for ban in own], axis=0)
    rates = np.concatenate([ban.factor * _rate(front, task, band) / (2.0 * math.pi) for ban in own])
    low, high = (text(float(end), "frequency") for end in (rates.min(), rates.max()))
    others = "" if bool(within.all()) else ", other bands the rest"
    passing = "planets pass" if band.of == "planet-pass" else "teeth mesh"
    message = (
        f"{ends_of(band)} takes {within.mean():.0%} of what {path} may have{others}: in {teeth} combinations its"
        f" {passing} at {low} to {high}; narrow the band, limit its cases, or allow more in [teeth] or in the speeds"
    )
    return Problem(f"teeth.forbidden.{name}", message)


# ----------------------------------------------------------------------------------------------------------------------
# Whole trains against forbidden bands of frequencies that no stage alone can be held against.
# ----------------------------------------------------------------------------------------------------------------------


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
