"""What can be wrong with how planets and parallel paths are said to share their load."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import Problem
from gearwright.identity import SIDES
from gearwright.spec.design import GROUND, RATINGS, Design, Epicyclic, Pair, Planetary, split_levels

_FLOATING = ("level-3", "level-4")
"""Levels of planets of which a central member floats."""
_HELD = 2
"""Bearings by which a shaft is held across, so that nothing on it floats [-]."""
LARGEST_RELIEF = 0.05
"""Tip relief over the module, at most [-]: beyond, too little of the involute is left to carry; an estimate."""


def sharing_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with how stages are said to share their load, and with stated tip reliefs.

    Args:
        design: As typed.
    """
    for name, stage in design.stages.items():
        path = design.table(name)
        yield from _stated_twice(design, name, path)
        if isinstance(stage, Pair):
            yield from _of_paths(design, name, stage, path)
        else:
            yield from _of_planets(design, stage, path)
        yield from _relief(design, name)
    yield from _relief_stated_twice(design)


def _stated_twice(design: Design, name: str, path: str) -> Iterator[Problem]:
    """Find a way of sharing beside a factor that overrides it, or with a method that lets all share alike."""
    rules, stage = design.rules(name), design.stages[name]
    if stage.load_sharing is None:
        return
    if rules.mesh_load_factor is not None or rules.planet_load_factors:
        key = "mesh_load_factor" if rules.mesh_load_factor is not None else "planet_load_factors"
        yield Problem(f"{path}.load_sharing", f"has no effect: gears.{key} states K_γ; keep one of the two")
    elif not RATINGS[design.rating(name)].fatigue:
        title = RATINGS[design.rating(name)].title
        yield Problem(f"{path}.load_sharing", f"has no effect: with {title} all share alike; give mesh_load_factor")


def _of_planets(design: Design, stage: Planetary | Epicyclic, path: str) -> Iterator[Problem]:
    sharing = stage.load_sharing
    if sharing == "tolerances" and stage.pin_position is None:
        yield Problem(f"{path}.pin_position_um", 'is required with load_sharing = "tolerances"')
    if sharing != "tolerances" and stage.pin_position is not None:
        yield Problem(f"{path}.pin_position_um", 'has no effect without load_sharing = "tolerances"; leave it out')
    members = dict.fromkeys(stage.members)
    if sharing in _FLOATING and GROUND not in members and all(_is_held(design, shaft) for shaft in members):
        message = (
            f"{sharing!r} asks for a central member that floats, and {', '.join(members)} each run in {_HELD} bearings"
            " or more; leave one without bearings, or give level-1 or level-2"
        )
        yield Problem(f"{path}.load_sharing", message)


def _of_paths(design: Design, name: str, pair: Pair, path: str) -> Iterator[Problem]:
    if pair.load_sharing is not None and name not in split_levels(design):
        message = "has no effect: the pair is on no loop of parallel paths; leave it out"
        yield Problem(f"{path}.load_sharing", message)
    if pair.clocking is not None and pair.load_sharing not in (None, "clocked"):
        yield Problem(f"{path}.clocking_mrad", f"has no effect with load_sharing = {pair.load_sharing!r}; leave it out")
    elif pair.clocking is not None and name not in split_levels(design):
        yield Problem(f"{path}.clocking_mrad", "has no effect: the pair is on no loop of parallel paths; leave it out")
    if pair.load_sharing == "floating":
        single = [shafts[0] for side in SIDES if len(shafts := pair.named(side)) == 1]
        held = [shaft for shaft in single if _is_held(design, shaft)]
        if held and len(held) == len(single):
            message = f"'floating' asks for a gear that floats, and {held[0]} runs in {_HELD} bearings or more"
            yield Problem(f"{path}.load_sharing", f"{message}; leave it without bearings, or give clocked or rigid")


def _is_held(design: Design, shaft: str) -> bool:
    return sum(seat.shaft == shaft for seat in design.bearings.values()) >= _HELD


def _relief(design: Design, name: str) -> Iterator[Problem]:
    """Find a stated tip relief that leaves too little of the involute of a stated module."""
    stage = design.stages[name]
    module = None if isinstance(stage, Epicyclic) else stage.module
    if module is not None and (problem := relief_problem(design, name, module)) is not None:
        yield problem


def _relief_stated_twice(design: Design) -> Iterator[Problem]:
    """Find a rule for reliefs beside the amount that overrides it, in the same table."""
    tables = {"gears": design.gears} | {f"{design.table(name)}.gears": row.gears for name, row in design.stages.items()}
    for table, rules in tables.items():
        if rules is not None and {"tip_relief", "tip_relief_for"} <= rules.iso6336.model_fields_set:
            message = "has no effect: tip_relief_mm states the amount; keep one of the two"
            yield Problem(f"{table}.iso6336.tip_relief_for", message)


def relief_problem(design: Design, name: str, module: float) -> Problem | None:
    """Return what is wrong with the tip relief that is stated for a stage of some module; None where nothing is.

    Args:
        design: As typed.
        name: Of the stage.
        module: m_n of its teeth [m].
    """
    stage, relief = design.stages[name], design.rules(name).iso6336.tip_relief
    bevel = isinstance(stage, Pair) and stage.kind != "cylindrical"
    if bevel or relief is None or relief <= LARGEST_RELIEF * module:
        return None
    given, most = 1e3 * relief, 1e-3 * math.floor(1e6 * LARGEST_RELIEF * module + 1e-6)  # whole µm, in mm
    message = (
        f"{given:g} mm on a module of {1e3 * module:.4g} mm ({name}) leaves too little of the flank; give {most:.3g} mm"
        " or less, or leave it out: tips are then relieved for their load"
    )
    return Problem(_stated_at(design, name), message)


def _stated_at(design: Design, name: str) -> str:
    """Return where the tip relief of a stage is written: in its own table, or in that of all."""
    own = design.stages[name].gears
    stated = own is not None and "tip_relief" in own.iso6336.model_fields_set
    return f"{design.table(name)}.gears.iso6336.tip_relief_mm" if stated else "gears.iso6336.tip_relief_mm"
