"""Confirm: dynamic factors by a forced response at the speeds of every case, load factors by the stated errors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from gearwright.dynamics.sharing import load_factors
from gearwright.dynamics.vibration import forced_factors
from gearwright.errors import GearwrightError
from gearwright.sizing import Sizing
from gearwright.spec import Design
from gearwright.spec.design import RATINGS, case_named
from gearwright.spec.edit import Value

STEP = 1e-3
"""To which a dynamic factor is written, upwards [-]."""
LARGEST = 5.0
"""That the key takes [-]."""
LARGEST_SHARE = 3.0
"""K_γ that the key takes [-]."""
ABOVE = 1.002
"""Factor on K_γ, as the next size shares its load a little otherwise [-]."""


class Factors(NamedTuple):
    """By how much teeth bear more than their torque says."""

    dynamic: Mapping[str, float]
    """Stage -> K_V [-]."""
    sharing: Mapping[str, float]
    """Stage -> K_γ [-]."""


def shared(sizing: Sizing) -> dict[str, float]:
    """Return stage -> K_γ by the errors of the design, of those that do not state one themselves [-].

    Args:
        sizing: As proportioned.
    """
    return {stage: ABOVE * factor for stage, factor in load_factors(sizing).items()}


def confirmed(sizing: Sizing) -> dict[str, float]:
    """Return stage -> largest dynamic factor of its meshes in all cases that last, by forced response [-].

    A case of which no equilibrium is found has none; its run says why, as a check that is not assessed.

    Args:
        sizing: As proportioned.
    """
    factors: dict[str, float] = {}
    stages = {mesh.name: mesh.stage for mesh in sizing.meshes}
    for case in sizing.flows:
        if case_named(sizing.design, case).static:
            continue
        try:
            forced = forced_factors(sizing, case)
        except GearwrightError:
            continue
        for mesh, factor in forced.items():
            factors[stages[mesh]] = max(factors.get(stages[mesh], 1.0), factor)
    return factors


def takes_factor(design: Design, stage: str) -> bool:
    """Tell whether the method of a stage takes a dynamic factor.

    Args:
        design: With its rules.
        stage: Pair or set.
    """
    return RATINGS[design.rating(stage)].table == "iso6336" and design.rating(stage) != "iso10300"


def changes_of(design: Design, factors: Factors) -> dict[str, Value]:
    """Return the changes that give confirmed factors to the stages that take them.

    Args:
        design: Where they are written; what it asks for itself holds where it is more, and its own K_γ always.
        factors: As confirmed.
    """
    changes: dict[str, Value] = {}
    for stage, factor in factors.dynamic.items():
        if takes_factor(design, stage):
            own = design.rules(stage).iso6336.least_dynamic_factor
            upwards = min(_upwards(factor), LARGEST)
            if upwards > own:
                changes[f"{design.table(stage)}.gears.iso6336.least_dynamic_factor"] = upwards
    for stage, factor in factors.sharing.items():
        if takes_share(design, stage):
            changes[f"{design.table(stage)}.gears.mesh_load_factor"] = min(_upwards(factor), LARGEST_SHARE)
    return changes


def takes_share(design: Design, stage: str) -> bool:
    """Tell whether a design leaves the load factor of a stage open.

    Args:
        design: With its rules.
        stage: Pair or set.
    """
    rules = design.rules(stage)
    return rules.mesh_load_factor is None and not rules.planet_load_factors


def _upwards(factor: float) -> float:
    return round(-(-factor // STEP) * STEP, 3)
