"""The teeth of a sized cylindrical gear, as formulas and drawings take them, and where the planets of a set stand."""

from __future__ import annotations

import math
from collections.abc import Mapping

from gearwright.identity import Role, gear_part
from gearwright.parts.gears import BasicRack, CylindricalGear
from gearwright.parts.planetary import even_positions, nearest_positions
from gearwright.sizing.result import GearSizing
from gearwright.spec import Design
from gearwright.units import INCH

_LONGEST = 5
"""Digits of a pitch that somebody writes [-]."""


def cylindrical_gear(design: Design, gear: GearSizing) -> CylindricalGear:
    """Return the teeth of a cylindrical gear as an external one, with the basic rack ISO 53 A.

    Args:
        design: With the rules of its stage.
        gear: As sized; a ring's teeth count negative where they mesh, which is for the caller.
    """
    return CylindricalGear(
        gear.teeth,
        gear.module,
        gear.face_width,
        gear.helix_angle,
        profile_shift=gear.profile_shift,
        rack=BasicRack(pressure_angle=design.rules(gear.stage).pressure_angle),
        tip_alteration=gear.tip_alteration,
    )


def stated_pitch(module: float) -> float | None:
    """Return the diametral pitch π/p of a module where it is the shorter of the two numbers, as a design in inches has.

    Args:
        module: m [m].

    Returns:
        P = 1/m [1/m]; None where the module in millimetres has as few digits.

    >>> [pitch and round(0.0254 * pitch, 9) for pitch in map(stated_pitch, (3.175e-3, 2.54e-3, 2.5e-3, 1.4911e-3))]
    [8.0, 10.0, None, None]
    """
    pitch, most = 1.0 / module, _LONGEST + 1
    return pitch if _digits(INCH * pitch) < min(_digits(1e3 * module), most) else None


def _digits(number: float) -> int:
    """Return how many digits a number is written with; one more than any where it takes more."""
    lengths = range(1, _LONGEST + 1)
    return next((n for n in lengths if math.isclose(float(f"{number:.{n}g}"), number, rel_tol=1e-9)), _LONGEST + 1)


def planet_positions(design: Design, stage: str, teeth: Mapping[str, int]) -> tuple[float, ...]:
    """Return the angles of the planets of a set, the first at zero [rad].

    Args:
        design: That says whether they may stand unequally.
        stage: Name of the set.
        teeth: Gear -> tooth number [-].

    Source: `gearwright.parts.planetary.nearest_positions`.
    """
    planetary = design.planetaries[stage]
    if not planetary.unequal_places:
        return even_positions(planetary.planets)
    sun, ring = (teeth[str(gear_part(stage, role))] for role in (Role.SUN, Role.RING))
    return nearest_positions(sun, ring, planetary.planets)
