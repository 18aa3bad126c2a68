"""What a design leaves to usual values in its load factors, each with its source and what it moves in the mass."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated

from gearwright.errors import GearwrightError
from gearwright.sizing.rating import load_sharing
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso6336.inputs import EDITIONS, clause_of
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.sizing.stages import geared
from gearwright.sizing.teeth import Chosen
from gearwright.spec import edited
from gearwright.spec.design import RATINGS, given_values
from gearwright.spec.edit import Value
from gearwright.units import Origin, Quantity
from gearwright.verbs import verb

_RELIEVED = "C_a = C_eff in the case that does most damage, at most 0.02 m_n"
_CLASS = "by pitch-line velocity: 4 above 60 m/s, 5 from 15 m/s on, 6 below"


@dataclass(frozen=True)
class UsualValue:
    """A value that a design leaves open, as it was taken."""

    stage: str
    quantity: str
    """With its symbol."""
    value: str
    source: str
    otherwise: str
    """What it is held against."""
    mass: Annotated[float | None, Quantity("mass"), Origin("Δm of the gears, their teeth as they are", "sized anew")]
    """By how much its gears would weigh more with the other value [kg]; None where sizes are given or nothing does."""


@verb
def usual_values(sizing: Sizing) -> tuple[UsualValue, ...]:
    """Return the load factors, tip reliefs and classes that a design leaves open, and what others would weigh.

    Args:
        sizing: As sized; its teeth are kept.
    """
    return tuple(value for stage in sizing.design.stages for value in _of_stage(sizing, stage))


def _of_stage(sizing: Sizing, stage: str) -> Iterator[UsualValue]:
    design, table = sizing.design, sizing.design.table(stage)
    meshes = [mesh for mesh in sizing.meshes if mesh.stage == stage]
    sharing = load_sharing(design, stage)
    factor = max(mesh.load_factor for mesh in meshes)
    if sharing.usual and RATINGS[design.rating(stage)].fatigue and factor > 1.0:
        mass = _change(sizing, {f"{table}.gears.mesh_load_factor": 1.0})
        yield UsualValue(stage, "load sharing K_γ", f"{factor:.3g}", sharing.words, "1, all alike", mass)
    made = [mesh.rating.made for mesh in meshes if isinstance(mesh.rating, Iso6336Rating)]
    rules = design.rules(stage).iso6336
    if made and rules.tip_relief is None:
        low, high = (pick(one.relief for one in made) for pick in (min, max))
        words = f"{1e6 * low:.3g}" if low == high else f"{1e6 * low:.3g} to {1e6 * high:.3g}"
        mass = _change(sizing, {f"{table}.gears.iso6336.tip_relief_mm": 0.0})
        clause = clause_of("ISO 6336-1, 6.5.5", EDITIONS[design.rating(stage)])
        source = f"{clause}: {_RELIEVED if rules.tip_relief_for == 'load' else 'C_ay by running in'}"
        yield UsualValue(stage, "tip relief C_a", f"{words} µm", source, "none", mass)
    if made and rules.tolerance_class is None:
        own = int(min(one.grade for one in made))
        mass = _change(sizing, {f"{table}.gears.iso6336.tolerance_class": own + 1})
        yield UsualValue(stage, "flank class A", f"{own}", _CLASS, f"{own + 1}", mass)


def _change(sizing: Sizing, changes: Mapping[str, Value]) -> float | None:
    """Return by how much gears weigh more with some changes, their teeth as they are [kg]."""
    try:
        design = edited(sizing.design, dict(changes))
        other = geared(design, sizing.train, Chosen(dict(sizing.teeth), {}), given=given_values(design).values)
    except GearwrightError:
        return None
    before, after = (sum(_volume(gear) for gear in gears) for gears in (sizing.gears, other.gears))
    return None if before == after else sum(gear.bodies * gear.mass for gear in sizing.gears) * (after / before - 1.0)


def _volume(gear: GearSizing) -> float:
    """Return what all bodies of a gear take as discs, of a ring its wall [m³]."""
    wall = 4.0 * gear.rim * gear.pitch_diameter if gear.rim else gear.pitch_diameter**2
    return gear.bodies * wall * gear.face_width
