"""Confirm: dynamic factors by a forced response of the whole train at the operating speeds of every case."""

from __future__ import annotations

from collections.abc import Mapping

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


def changes_of(design: Design, factors: Mapping[str, float]) -> dict[str, Value]:
    """Return the changes that give confirmed dynamic factors to the stages that take them.

    Args:
        design: Where they are written; what it asks for itself holds where it is more.
        factors: Stage -> K_V [-].
    """
    changes: dict[str, Value] = {}
    for stage, factor in factors.items():
        if takes_factor(design, stage):
            own = design.rules(stage).iso6336.least_dynamic_factor
            upwards = min(round(-(-factor // STEP) * STEP, 3), LARGEST)
            if upwards > own:
                changes[f"{design.table(stage)}.gears.iso6336.least_dynamic_factor"] = upwards
    return changes
