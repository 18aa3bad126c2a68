"""Why a stage has no tooth numbers, and what would do."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearwright.errors import DesignError, Problem, refuse
from gearwright.parts.planetary import assembles, neighbours_clear
from gearwright.spec import Design, Pair, Planetary, case_named
from gearwright.spec.checks import table_of
from gearwright.spec.design import SUN_LIMITS
from gearwright.train import PowerFlow, Targets, tooth_ratio_range
from gearwright.units import apart, text


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
