"""Which open teeth of a planetary set its profile shifts close: those given, a centre distance, or a rule of balance.

Where no shift is asked for, z_r = z_s + 2 z_p closes every set. Else sun, planet and ring are tried as sizing takes
them: shifts within their limits, no undercut, no pointed tip, no interference in the ring, planets beside each other.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gearwright.arrays import Bools, Ints
from gearwright.errors import DesignError
from gearwright.identity import Role
from gearwright.parts.planetary import nearest_positions, tip_gap
from gearwright.sizing.teeth.front import Task
from gearwright.spec import Design, Planetary
from gearwright.spec.design import SET_ROLES, StageShifts, stage_shifts

FARTHEST = 4.0
"""Modules by which no shifts bring a given centre distance nearer to that of teeth without shift [-]."""


def ring_variants(task: Task, design: Design) -> tuple[Task, ...]:
    """Return a stage with every number of teeth by which a chosen ring may differ from z_s + 2 z_p, the least first.

    Args:
        task: The stage.
        design: With the rules of the search.
    """
    most = design.teeth.ring_deviation
    if not most or not isinstance(task.stage, Planetary) or task.stage.known_teeth is not None:
        return (task,)
    return tuple(replace(task, deviation=teeth) for teeth in sorted(range(-most, most + 1), key=abs))


def is_shifted(task: Task, design: Design) -> bool:
    """Tell whether the teeth of a planetary set have shifts that its design asks for, beyond those of all its gears.

    Args:
        task: The stage.
        design: With its rules.
    """
    stage = task.stage
    if not isinstance(stage, Planetary):
        return False
    shifts = (stage.sun_shift, stage.planet_shift, stage.ring_shift)
    asked = stage.centre_distance is not None or any(shift is not None for shift in shifts)
    return asked or task.deviation != 0 or design.rules(task.name).balanced_shifts is not None


def closed(task: Task, design: Design, small: Ints, large: Ints, ring: Ints, *, planets: int) -> Bools:
    """Tell which teeth of a planetary set with shifts close, so that planets pass each other.

    Args:
        task: The stage.
        design: With its rules.
        small: Of the sun [-].
        large: Of planets [-].
        ring: Of the ring [-].
        planets: Number of planets [-].
    """
    good = _near(task, small + large) & _near(task, ring - large)
    triples, place = np.unique(np.stack([small, large, ring])[:, good], axis=1, return_inverse=True)
    fits = [_stands(task, design, (int(z_s), int(z_p), int(z_r)), planets) for z_s, z_p, z_r in triples.T]
    good[good] = np.array(fits, dtype=bool)[place.ravel()]
    return good


def _near(task: Task, total: Ints) -> Bools:
    """Tell which sums of teeth stand near enough to the given centre distance for a look; all, where none is given."""
    stage = task.stage
    if stage.centre_distance is None or stage.module is None:
        return np.ones(total.shape, dtype=bool)
    return np.asarray(np.abs(stage.centre_distance / stage.module - total / 2.0) <= FARTHEST)


def _stands(task: Task, design: Design, teeth: tuple[int, int, int], planets: int) -> bool:
    """Tell whether one set closes and its planets pass each other."""
    if teeth not in task.closed:
        task.closed[teeth] = _shifts(task.name, design, teeth)
    shifts = task.closed[teeth]
    if shifts is None:
        return False
    sun, planet, ring = teeth
    centre = 0.5 * (sun + planet) if shifts.centre is None else shifts.centre
    tip = 0.5 * planet + 1.0 + sum(shifts.of(Role.PLANET))
    return tip_gap(centre, tip, nearest_positions(sun, ring, planets)) > 0.0


def _shifts(name: str, design: Design, teeth: tuple[int, int, int]) -> StageShifts | None:
    """Return the shifts that close a set; None where none do."""
    try:
        return stage_shifts(design, name, dict(zip(SET_ROLES, teeth, strict=True)))
    except DesignError:
        return None
