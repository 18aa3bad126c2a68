"""Backlash of sized teeth: what their thicknesses, as the design allows them, and the place of the axes leave."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated, TypeVar

from gearwright.catalogue import centre_allowance, thickness_allowances
from gearwright.errors import DesignError, Problem
from gearwright.parts.gears import base_helix_angle, centre_play, circumferential_play, span_allowance
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.spec import Design, Pair, Planetary
from gearwright.units import Length, Origin, Quantity

_DIN = "DIN 3967:1978; DIN 3964:1980"
Both = tuple[float, float]
T = TypeVar("T")


@dataclass(frozen=True)
class Backlash:
    """Backlash of a mesh, the least and the most that its tolerances leave."""

    normal: Annotated[Both, Quantity("length"), Origin("j_bn = −Σ E_sn cos α_n ± 2 A_a sin α_wt cos β_b", _DIN)]
    """Along the normal of the flanks j_bn [m]."""
    circumferential: Annotated[Both, Quantity("length"), Origin("j_wt = j_bn/(cos α_wt cos β_b)", "ISO 21771:2007")]
    """Along the working pitch circles j_wt [m]."""
    mean: Annotated[float, Quantity("length"), Origin("(j_bn,min + j_bn,max)/(2 cos β_b)", "ISO 21771:2007")]
    """Half way between, along the transverse line of action, as dynamics takes it [m]."""
    opened: Length
    """What the thickest teeth leave along the normal where the axes stand as drawn [m]."""
    closed: Length
    """What the axes may take of it, or add [m]."""


def fit_of(design: Design, gear: GearSizing) -> str | None:
    """Return the fit of the teeth of a cylindrical gear; None where the design says nothing of it.

    Args:
        design: With the gear's stage.
        gear: As sized.
    """
    stage = design.stages[gear.stage]
    if isinstance(stage, Pair) and stage.kind != "cylindrical":
        return None
    if isinstance(stage, Pair | Planetary):
        own: str | None = getattr(stage, f"{gear.role}_allowance")
    else:
        own = stage.toothed[gear.own].allowance
    return own or design.rules(gear.stage).allowance


def thickness_of(design: Design, gear: GearSizing) -> Both | None:
    """Return lower and upper allowance of the normal tooth thickness of a gear; None where the design gives none [m].

    Args:
        design: With the gear's stage.
        gear: As sized.

    Source: DIN 3967:1978.
    """
    fit = fit_of(design, gear)
    return None if fit is None else _of_table(design, gear.stage, thickness_allowances, (gear.pitch_diameter, fit))


def _of_table(design: Design, stage: str, table: Callable[[float, str], T], asked: tuple[float, str]) -> T:
    """Return what a table has, or say of which stage it has none."""
    try:
        return table(*asked)
    except DesignError as error:
        path = design.key_of(stage, f"gears.{'centre_' if table is centre_allowance else ''}allowance")
        raise DesignError(Problem(path, f"{asked[1]!r}, but {part.message}") for part in error.problems) from None


def backlash_of(design: Design, gears: Mapping[str, GearSizing], mesh: MeshSizing) -> Backlash | None:
    """Return the backlash of a mesh; None where the design gives none of its gears an allowance.

    Args:
        design: With the mesh's stage.
        gears: By name.
        mesh: As sized.

    Source: DIN 3967:1978, DIN 3964:1980.
    """
    pair = [gears[name] for name in mesh.gears]
    allowances = [allowed for gear in pair if (allowed := thickness_of(design, gear)) is not None]
    if not allowances:
        return None
    rules = design.rules(mesh.stage)
    helix = base_helix_angle(rules.pressure_angle, pair[0].helix_angle)
    low, high = (
        -span_allowance(sum(allowed[end] for allowed in allowances), pressure_angle=rules.pressure_angle)
        for end in (1, 0)
    )
    fit = rules.centre_allowance
    missed = 0.0 if fit is None else _of_table(design, mesh.stage, centre_allowance, (mesh.centre_distance, fit))
    play = centre_play(missed, working_angle=mesh.working_pressure_angle, helix_angle=helix)
    normal = (low - play, high + play)
    around = tuple(
        circumferential_play(end, working_angle=mesh.working_pressure_angle, helix_angle=helix) for end in normal
    )
    return Backlash(normal, (around[0], around[1]), 0.5 * sum(normal) / math.cos(helix), opened=low, closed=play)


def play_in_motion(sizing: Sizing, mesh: str) -> Length:
    """Return the backlash of a mesh along its line of action: given, or the mean that its fits leave [m].

    Args:
        sizing: What was sized.
        mesh: Name of a row.
    """
    row = next(row for row in sizing.meshes if row.name == mesh)
    stage = sizing.design.stages[row.stage]
    if "backlash" in stage.model_fields_set:
        return stage.backlash
    play = backlash_of(sizing.design, {gear.name: gear for gear in sizing.gears}, row)
    return stage.backlash if play is None else play.mean
