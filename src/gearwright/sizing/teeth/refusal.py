"""Why a stage has no tooth numbers, and what would do."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearwright.errors import DesignError, Problem, refuse
from gearwright.parts.planetary import assembles, neighbours_clear
from gearwright.spec import Design, Pair, Planetary, case_named
from gearwright.spec.checks import table_of
from gearwright.train import PowerFlow
from gearwright.units import text


def refusal(name: str, stage: Pair | Planetary, design: Design, tooth_ratio: float, *, fewest: int) -> DesignError:
    """Return the error of a stage without candidates: the planets that would fit, or the ratio that teeth would give.

    Args:
        name: Name of the stage.
        stage: As in the design.
        design: With the rules of the search.
        tooth_ratio: z_2/z_1 or z_r/z_s asked [-].
        fewest: Fewest teeth of pinions without undercut [-].
    """
    if isinstance(stage, Planetary):
        return DesignError([_planetary(name, stage, design, tooth_ratio)])
    smallest = design.teeth.pinion_minimum or fewest
    undercut = [teeth for teeth in (stage.pinion_teeth, stage.wheel_teeth) if teeth is not None and teeth < smallest]
    if undercut:
        more = "" if stage.kind == "bevel" else ", or more gears.profile_shift"
        message = f"{undercut[0]} teeth are undercut; use at least {smallest}{more}"
        return DesignError([Problem(f"pairs.{name}.pinion_teeth", message)])
    message = (
        f"no tooth numbers from {smallest} to {design.teeth.pinion_maximum} on the pinion give the ratio"
        f" {tooth_ratio:.4g} within {design.teeth.stage_tolerance:.1%}; allow more in teeth.stage_tolerance or"
        " teeth.pinion_maximum, or change the speeds"
    )
    return DesignError([Problem(f"pairs.{name}", message)])


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


def _planetary(name: str, stage: Planetary, design: Design, tooth_ratio: float) -> Problem:
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
            f" let {stage.planets} planets be assembled; leave one out, or change the speeds"
        )
        return Problem(path, message)
    if _fits(stage, design, tooth_ratio, 1, assembly=False):
        for count in range(stage.planets - 1, 0, -1):
            if _fits(stage, design, tooth_ratio, count, assembly=True):
                clear = _fits(stage, design, tooth_ratio, stage.planets, assembly=False)
                why = "cannot be assembled" if clear else "do not fit"
                return Problem(
                    f"{path}.planets", f"{stage.planets} planets {why} at ratio {ratio:.3g}; at most {count}"
                )
    low, high = _range(design)
    message = (
        f"no tooth numbers give the ratio {ratio:.4g} within {design.teeth.stage_tolerance:.1%}; with suns of"
        f" {design.teeth.sun_minimum} to {design.teeth.sun_maximum} teeth, planets of {design.teeth.planet_minimum} or"
        f" more, the ratio lies from {low:.3g} up, and below {high:.3g} for two planets or more; change the speeds, or"
        " the limits in [teeth]"
    )
    return Problem(path, message)


def _range(design: Design) -> tuple[float, float]:
    """Return the smallest ratio, and the one at which two planets touch [-]."""
    rules = design.teeth
    return 2.0 + 2.0 * rules.planet_minimum / rules.sun_maximum, 2.0 * (rules.sun_maximum - 2) / 2.0 + 2.0


def _fits(stage: Planetary, design: Design, tooth_ratio: float, planets: int, *, assembly: bool) -> bool:
    """Tell whether any tooth numbers within the tolerance suit a number of planets."""
    rules = design.teeth
    sun = np.array([stage.sun_teeth]) if stage.sun_teeth else np.arange(rules.sun_minimum, rules.sun_maximum + 1)
    wanted = (tooth_ratio - 1.0) / 2.0 * sun
    planet = np.concatenate([np.floor(wanted), np.floor(wanted) + 1.0]).astype(int)
    sun = np.concatenate([sun, sun])
    ring = sun + 2 * planet
    good = np.abs((1.0 + ring / sun) / (1.0 + tooth_ratio) - 1.0) <= rules.stage_tolerance
    good &= (planet >= rules.planet_minimum) & neighbours_clear(sun, planet, planets)
    if assembly:
        good &= assembles(sun, ring, planets)
    return bool(good.any())
