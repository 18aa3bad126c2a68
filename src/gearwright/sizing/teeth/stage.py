"""Tooth numbers of one stage in the search, and the reason where none are admissible."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Ints, Problem, apart, refuse, text
from gearwright.parts.planetary import assembles, neighbours_clear
from gearwright.sizing.teeth.candidates import (
    REACHES,
    Front,
    Needs,
    Reach,
    StageTask,
    admissible,
    admitted,
    admitted_candidates,
    all_candidates,
    fewest_teeth,
    is_given,
    lightest,
    planet_counts,
    ring_teeth,
    ring_variants,
    shares_gear,
)
from gearwright.sizing.teeth.criteria import clear, refused, weigh
from gearwright.spec import GROUND, Design, Pair, Planetary, case_named
from gearwright.spec.checks import table_of
from gearwright.spec.design import SUN_LIMITS
from gearwright.train import PowerFlow, Targets, gears_of, members_of, tooth_ratio_range, willis_ratio, willis_speed

# ----------------------------------------------------------------------------------------------------------------------
# Why a stage has no tooth numbers, and what would do.
# ----------------------------------------------------------------------------------------------------------------------


def refusal(
    name: str, stage: Pair | Planetary, design: Design, tooth_ratio: float, *, fewest: int, nominal: Targets
) -> DesignError:
    """Return the error of a stage without candidates: the planets that would fit, or the ratio that teeth would give.

    Args:
        name: Name of the stage.
        stage: As in the design.
        design: With the rules of the search.
        tooth_ratio: z_2/z_1 or z_r/z_s asked [-].
        fewest: Fewest teeth of pinions without undercut [-].
        nominal: With what all stages together can give.
    """
    if isinstance(stage, Planetary):
        return DesignError([_planetary(name, stage, design, tooth_ratio, nominal)])
    smallest = design.teeth.pinion_minimum or fewest
    undercut = [teeth for teeth in (stage.pinion_teeth, stage.wheel_teeth) if teeth is not None and teeth < smallest]
    if undercut:
        more = "" if stage.kind == "bevel" else ", or more gears.profile_shift"
        message = f"{undercut[0]} teeth are undercut; use at least {smallest}{more}"
        return DesignError([Problem(f"pairs.{name}.pinion_teeth", message)])
    return DesignError([Problem(f"pairs.{name}", _pair(stage, design, tooth_ratio, smallest))])


def _pair(stage: Pair, design: Design, tooth_ratio: float, smallest: int) -> str:
    """Return why no teeth of a pair do, by what limits them: the pinion that is given, or those that are looked at."""
    rules, given = design.teeth, stage.pinion_teeth
    start, fix = (
        (f"no wheel gives a pinion of {given} teeth", "leave pinion_teeth out, allow more in teeth.stage_tolerance")
        if given
        else (
            f"no tooth numbers from {smallest} to {rules.pinion_maximum} on the pinion give",
            "allow more in teeth.stage_tolerance or teeth.pinion_maximum",
        )
    )
    hunting = " and have no common factor" if rules.hunting else ""
    if stage.centre_distance is not None and stage.module is not None:
        hunting += f" at a centre distance of {stage.centre_distance / stage.module:.4g} modules"
        fix = f"change centre_distance or module, {fix}"
    return (
        f"{start} the ratio {tooth_ratio:.4g} within {rules.stage_tolerance:.1%}{hunting}; {fix}, or change the speeds"
    )


def contradiction(name: str, stage: Pair | Planetary, design: Design, tooth_ratio: float) -> DesignError:
    """Return the error of a stage whose tooth numbers all contradict the speeds of the machines.

    Args:
        name: Name of the stage.
        stage: As in the design.
        design: With the tolerance.
        tooth_ratio: z_2/z_1 or z_r/z_s that teeth give [-].
    """
    teeth = "z_2/z_1" if isinstance(stage, Pair) else "z_r/z_s"
    asked = f"the asked ratio {stage.ratio:.4g}" if stage.ratio is not None else f"{teeth} = {tooth_ratio:.4g}"
    message = (
        f"tooth numbers that give {asked} turn a machine at another speed than it asks for, by more than"
        f" {design.teeth.speed_tolerance:.1%}; change the ratio or the speeds, or allow more in teeth.speed_tolerance"
    )
    return DesignError([Problem(f"{'pairs' if isinstance(stage, Pair) else 'planetaries'}.{name}", message)])


def refuse_contradictions(design: Design, flows: Mapping[str, PowerFlow]) -> None:
    """Raise where the teeth give a machine another speed than it asks for.

    Args:
        design: With the asked speeds and the tolerance.
        flows: Every load case at the chosen teeth.

    Raises:
        DesignError: With both speeds of every such machine.
    """
    problems: dict[str, Problem] = {}
    for case, flow in flows.items():
        for yielded in flow.yielded:
            drive = case_named(design, case).machines.get(yielded.machine)
            stated = drive is not None and drive.speed is not None
            table = f"cases.{case}" if stated else table_of(yielded.machine, design)
            path = f"{table}.{yielded.machine}.speed"
            if abs(yielded.deviation) > design.teeth.speed_tolerance:
                message = (
                    f"{text(yielded.asked, 'speed')} is asked, but the teeth and the other speeds give"
                    f" {text(yielded.actual, 'speed')} ({yielded.deviation:+.1%}); change the speed or the teeth, or"
                    " allow more in teeth.speed_tolerance"
                )
                problems.setdefault(path, Problem(path, message))
    refuse(problems.values())


def _planetary(name: str, stage: Planetary, design: Design, tooth_ratio: float, nominal: Targets) -> Problem:
    """Return the problem of a planetary set."""
    path, ratio = f"planetaries.{name}", 1.0 + tooth_ratio
    written = ", ".join(
        f"{part} = {teeth}"
        for part in ("sun_teeth", "planet_teeth", "ring_teeth")
        if (teeth := getattr(stage, part)) is not None
    )
    if written:
        message = (
            f"no tooth numbers with {written} give the ratio {ratio:.4g} within {design.teeth.stage_tolerance:.1%} and"
            f" let {stage.planets_given or 'any number of'} planets be assembled; leave one out, or change the speeds"
        )
        return Problem(path, message)
    if by := _closed_by(stage):
        message = (
            f"no teeth of the ratio {ratio:.4g} within {design.teeth.stage_tolerance:.1%} close {by} and let"
            f" {stage.planets_given or 'any number of'} planets be assembled; change them, or the limits in [teeth]"
        )
        return Problem(f"{path}.centre_distance" if stage.centre_distance else path, message)
    given = stage.planets_given
    if given is not None and _fits(stage, design, tooth_ratio, 1, assembly=False):
        for count in range(given - 1, 0, -1):
            if _fits(stage, design, tooth_ratio, count, assembly=True):
                clear = _fits(stage, design, tooth_ratio, given, assembly=False)
                why = "cannot be assembled" if clear else "do not fit"
                return Problem(f"{path}.planets", f"{given} planets {why} at ratio {ratio:.3g}; at most {count}")
    return Problem(
        path, f"{_limit(stage, design, ratio)}{_together(nominal)}; change the speeds, or the limits in [teeth]"
    )


def _closed_by(stage: Planetary) -> str:
    """Return what is given that the teeth of a set have to close by; nothing where nothing is."""
    if stage.centre_distance is not None and stage.module is not None:
        return f"by shifts at a centre distance of {stage.centre_distance / stage.module:.4g} modules"
    shifts = (stage.sun_shift, stage.planet_shift, stage.ring_shift)
    return "with the shifts that are given" if any(shift is not None for shift in shifts) else ""


def _limit(stage: Planetary, design: Design, ratio: float) -> str:
    """Return which limit the ratio of a planetary set is beyond."""
    rules, planets = design.teeth, stage.planets_given
    least, most = (1.0 + tooth_ratio for tooth_ratio in tooth_ratio_range(stage, design, sun=SUN_LIMITS[-1]))
    if ratio < least:
        teeth = f"suns of up to {rules.largest_sun(SUN_LIMITS[-1])} teeth and planets of {rules.planet_minimum} or more"
        asked, bound = apart(ratio, least, "ratio")
        return f"1 + z_r/z_s = {asked} is below {bound}, the least with {teeth}"
    if ratio > most:
        asked, bound = apart(ratio, most, "ratio")
        return f"1 + z_r/z_s = {asked} is above {bound}, where {planets} planets touch each other"
    return (
        f"no tooth numbers give 1 + z_r/z_s = {ratio:.4g} within {rules.stage_tolerance:.1%} in the limits of [teeth]"
    )


def _together(nominal: Targets) -> str:
    """Return what all stages from the machine to the propeller give, where that is the reason; else nothing."""
    least, most = nominal.reach
    if least <= nominal.total <= most:
        return ""
    below = nominal.total < least
    bound, asked = apart(least if below else most, nominal.total, "ratio", 3)
    nearest = f"no ratio {'below' if below else 'above'} {bound}"
    return f"; all stages to the propeller together give {nearest}, and {asked} is asked"


def _fits(stage: Planetary, design: Design, tooth_ratio: float, planets: int, *, assembly: bool) -> bool:
    """Tell whether any tooth numbers within the tolerance suit a number of planets."""
    rules = design.teeth
    sun = (
        np.array([stage.sun_teeth])
        if stage.sun_teeth
        else np.arange(rules.sun_minimum, rules.largest_sun(SUN_LIMITS[-1]) + 1)
    )
    wanted = (tooth_ratio - 1.0) / 2.0 * sun
    planet = np.concatenate([np.floor(wanted), np.floor(wanted) + 1.0]).astype(int)
    sun = np.concatenate([sun, sun])
    ring = sun + 2 * planet
    good = np.abs((1.0 + ring / sun) / (1.0 + tooth_ratio) - 1.0) <= rules.stage_tolerance
    good &= (planet >= rules.planet_minimum) & neighbours_clear(sun, planet, planets)
    if assembly:
        good &= assembles(sun, ring, planets)
    return bool(good.any())


# ----------------------------------------------------------------------------------------------------------------------
# One stage of the search: its candidates beside what the teeth chosen so far leave of the asked speeds.
# ----------------------------------------------------------------------------------------------------------------------


PARENTS = 2000
"""Choices that a stage multiplies by its candidates at once, so that memory is bounded [-]."""


MANY = 256
"""Ratios asked from which those that occur more than once are looked up once [-]."""


class Extended(NamedTuple):
    """A front with one more stage."""

    front: Front
    weighed: int
    """Candidates that were weighed [-]."""
    left_out: float
    """Combinations that cannot win [-]."""


def extend(
    front: Front, task: StageTask, design: Design, nominal: Targets, *, needs: Needs, may_win: Callable[[Front], Bools]
) -> Extended:
    """Multiply the front by a stage's candidates and keep those that its rules admit; look further only if none is.

    Where bearings of planets ask for a face, which few teeth have, it looks further at once.
    Of the choices that leave the same to the stages after them only the lightest is kept.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
        nominal: Asked speeds.
        needs: What the stages after it read.
        may_win: Tells of which choices something may become the lightest.

    Raises:
        DesignError: If no candidate is left, with what would do.
    """
    forbidden = list[Front]()
    for reach in REACHES[1:] if task.rating.least_area else REACHES:
        near, grown, weighed, left_out = list[Floats](), list[Front](), 0, 0.0
        for part, variant in product(_parts(front), ring_variants(task, design)):
            ratios, added = _grown(part, variant, design, asked_ratios(part, task, nominal), reach=reach)
            near.append(ratios)
            if added is None:
                continue
            weighed += len(added)
            if task.bans:
                good = clear(added, task)
                if not good.any():
                    forbidden.append(added)
                    continue
                added = added.take(good)
            kept = lightest(added, needs)
            winning = may_win(kept)
            left_out += float(kept.tally["combinations"][~winning].sum())
            grown.append(kept.take(winning))
        if grown:
            whole = lightest(grown[0].joined(grown[1:]), needs) if len(grown) > 1 else grown[0]
            return Extended(whole, weighed, left_out)
    if forbidden:
        raise refused(task, forbidden)
    actual = np.concatenate(near)
    if len(actual):
        raise contradiction(task.name, task.stage, design, float(np.median(actual)))
    ratio, fewest = float(np.median(asked_ratios(front, task, nominal))), fewest_teeth(task.rating)
    raise refusal(task.name, task.stage, design, ratio, fewest=fewest, nominal=nominal)


def _parts(front: Front) -> Iterator[Front]:
    """Yield the front piece by piece."""
    if len(front) <= PARENTS:
        yield front
        return
    for start in range(0, len(front), PARENTS):
        yield front.take(np.arange(start, min(start + PARENTS, len(front))))


def _grown(
    front: Front, task: StageTask, design: Design, target: Floats, *, reach: Reach
) -> tuple[Floats, Front | None]:
    """Return the tooth ratios that are near enough, and the choices that keep the machines' speeds, weighed."""
    parent, small, large = near_candidates(front, task, design, target, reach=reach)
    actual = tooth_ratio(task, small, large)
    grown = front.take(parent)
    speeds = new_speeds(grown, task, actual)
    good = _speeds_hold(task, design, speeds, len(small))
    if not good.any():
        return actual, None
    grown = replace(grown, speeds={**grown.speeds, **speeds})
    if not good.all():
        grown, small, large = grown.take(good), small[good], large[good]
    return actual, weighed_front(grown, task, design, small, large)


def weighed_front(front: Front, task: StageTask, design: Design, small: Ints, large: Ints) -> Front:
    """Add a stage's teeth and bodies to the front, with every number of planets, candidate after candidate.

    Args:
        front: Choices of the stages before, one for each candidate.
        task: The stage.
        design: With the rules of the search.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
    """
    fronts, places, counts = list[Front](), list[Ints](), planet_counts(task.name, design)
    if len(counts) == 1 and not task.twin:  # by which the candidates are chosen
        return weigh(front, task, small, large, planets=counts[0])
    for planets in counts:
        fits = admissible(task, design, small, large, planets=planets)
        if task.twin in front.planets:
            fits = fits & (front.planets[task.twin] == planets)
        if fits.all():
            fronts.append(weigh(front, task, small, large, planets=planets))
            places.append(np.arange(len(small)))
        elif fits.any():
            fronts.append(weigh(front.take(fits), task, small[fits], large[fits], planets=planets))
            places.append(np.flatnonzero(fits))
    if len(fronts) == 1:
        return fronts[0]
    return fronts[0].joined(fronts[1:]).take(np.argsort(np.concatenate(places), kind="stable"))


def near_candidates(
    front: Front, task: StageTask, design: Design, target: Floats, *, reach: Reach
) -> tuple[Ints, Ints, Ints]:
    """Return a stage's candidates that some number of planets admits and that are near enough to what is asked.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
        target: Tooth ratio asked of every choice [-].
        reach: How far it looks.
    """
    if not task.twin and not is_open(front, task, design):
        if len(target) < MANY or shares_gear(front, task):
            return _near_of(front, task, design, target, reach=reach)
        distinct, place = np.unique(target, return_inverse=True)
        parent, small, large = _near_of(front, task, design, distinct, reach=reach)
        parent, index = _repeated(parent, place, len(distinct))
        return parent, small[index], large[index]
    if task.twin:
        names = gears_of(task.twin, task.stage)
        parent, small, large = np.arange(len(front)), front.teeth[names[0]], front.teeth[names[1]]
    else:
        parent, small, large = all_candidates(task, design)
    fits = admitted(task, design, small, large)
    parent, small, large = parent[fits], small[fits], large[fits]
    if not task.twin:
        return parent, small, large
    near = _near(task, design, tooth_ratio(task, small, large), target[parent])
    return parent[near], small[near], large[near]


def _near_of(front: Front, task: StageTask, design: Design, target: Floats, *, reach: Reach) -> tuple[Ints, Ints, Ints]:
    """Return the candidates for some ratios that are admitted and near enough."""
    parent, small, large = admitted_candidates(front, task, design, target, reach=reach)
    near = _near(task, design, tooth_ratio(task, small, large), target[parent])
    return parent[near], small[near], large[near]


def _repeated(owner: Ints, place: Ints, count: int) -> tuple[Ints, Ints]:
    """Return who has a candidate, and which, where each has those of one of so many owners, in their order."""
    own = np.bincount(owner, minlength=count)
    first, many = np.cumsum(own) - own, own[place]
    parent = np.arange(len(place)).repeat(many)
    return parent, np.arange(len(parent)) + (first[place] - np.cumsum(many) + many).repeat(many)


def tooth_ratio(task: StageTask, small: Ints, large: Ints) -> Floats:
    """Return z_2/z_1 or z_r/z_s [-].

    Args:
        task: The stage.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
    """
    if not isinstance(task.stage, Planetary):
        return np.asarray(large / small)
    if task.stage.known_teeth is not None or task.deviation:
        return np.asarray(ring_teeth(task, small, large) / small)
    return np.asarray(1.0 + 2.0 * large / small)


def is_open(front: Front, task: StageTask, design: Design) -> bool:
    """Tell whether a stage's ratio is the search's own choice: the first of those that share an open ratio.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
    """
    if design.teeth.split == "equal" or task.edge is None or is_given(task.stage) or task.stage.ratio is not None:
        return False
    known = {machine.shaft for machine in design.machines.values()} | set(front.speeds)
    far = task.edge.slow if task.edge.fast[0] in front.speeds else task.edge.fast
    return len(front) == 1 and not known & set(far)


def _near(task: StageTask, design: Design, actual: Floats, asked: Floats) -> Bools:
    """Tell which tooth ratios are within the tolerance; given teeth are as they are."""
    if is_given(task.stage):
        return np.ones(len(actual), dtype=bool)
    carrier_part = 1.0 if isinstance(task.stage, Planetary) else 0.0
    return np.asarray(np.abs((carrier_part + actual) / (carrier_part + asked) - 1.0) <= design.teeth.stage_tolerance)


def asked_ratios(front: Front, task: StageTask, nominal: Targets) -> Floats:
    """Return the tooth ratio asked of every choice in the front [-].

    Args:
        front: Choices of the stages before.
        task: The stage.
        nominal: Asked speeds.
    """
    count = len(front)

    def speed(shaft: str) -> Floats:
        return front.speeds.get(shaft, np.full(count, nominal.speeds.get(shaft, 0.0)))

    if isinstance(task.stage, Planetary):
        return willis_ratio(task.stage, {member: speed(member) for member in members_of(task.stage)})
    edge = nominal.edges[task.name]
    return np.asarray(speed(_known(edge.fast, front)) / speed(_known(edge.slow, front)))


def _known(shafts: tuple[str, ...], front: Front) -> str:
    return next((shaft for shaft in shafts if shaft in front.speeds), shafts[0])


def new_speeds(front: Front, task: StageTask, ratio: Floats) -> dict[str, Floats]:
    """Return the speeds of the shafts that a stage reaches.

    Args:
        front: Choices with the stage's candidates.
        task: The stage.
        ratio: Tooth ratio of each [-].
    """
    known = front.speeds
    if isinstance(task.stage, Planetary):
        missing = [member for member in members_of(task.stage) if member != GROUND and member not in known]
        return {member: willis_speed(task.stage, member, ratio, known) for member in missing}
    edge = task.edge
    if edge is None:
        return {}
    source = next(shaft for shaft in (*edge.fast, *edge.slow) if shaft in known)
    fast = known[source] if source in edge.fast else known[source] * ratio
    reached = {**dict.fromkeys(edge.fast, fast), **dict.fromkeys(edge.slow, fast / ratio)}
    return {shaft: speed for shaft, speed in reached.items() if shaft not in known}


def _speeds_hold(task: StageTask, design: Design, speeds: Mapping[str, Floats], count: int) -> Bools:
    """Tell which choices keep the machines' speeds within the tolerance; given teeth are as they are."""
    good = np.ones(count, dtype=bool)
    if is_given(task.stage):
        return good
    for machine in design.machines.values():
        if machine.shaft in speeds and machine.asked_speed is not None:
            good &= np.abs(speeds[machine.shaft] / machine.asked_speed - 1.0) <= design.teeth.speed_tolerance
    return good
