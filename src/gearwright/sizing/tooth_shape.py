"""The teeth of a sized cylindrical gear, as formulas and drawings take them, and where the planets of a set stand."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.identity import Role, gear_part
from gearwright.parts.gears import BasicRack, CylindricalGear
from gearwright.parts.planetary import even_positions, nearest_positions
from gearwright.sizing.result import GearSizing
from gearwright.spec import Design


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
