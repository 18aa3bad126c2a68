"""The bodies under the teeth of external gears by the rules of their stage, and planets around what they turn on."""

from __future__ import annotations

from dataclasses import replace

from gearwright.parts.gears import Blank, TransverseTooth, blank_volume, outline_area, widest_rounding
from gearwright.sizing.rating import BACKUP, RIMMED, TOOTH_HEIGHT
from gearwright.sizing.result import GearSizing
from gearwright.sizing.tooth_shape import cylindrical_gear
from gearwright.spec import Design
from gearwright.spec.design import GearRules

PLANET_HUB = 1.1
"""Seat of a bearing in a planet: outside over the bearing's own outside [-], an estimate."""
CORNER = 2e-3
"""Radius between web, rim and hub [m], an assumption."""
GROOVE = 2.0
"""Depth of a groove beside a web over its width between the corners, at most [-]: what is turned with usual tools, an
estimate."""
WALL = 0.6
"""Metal left under the roots where a shaft is as thick as they are, and around the roots of a ring, in modules [-]."""


def external_tooth(design: Design, gear: GearSizing) -> TransverseTooth:
    """Return what the outline of an external cylindrical gear follows from.

    Args:
        design: With the rules of its stage.
        gear: As sized.
    """
    rack = cylindrical_gear(design, gear).rack
    rack = replace(rack, fillet_radius=min(rack.fillet_radius, widest_rounding(rack)))
    return TransverseTooth(gear.teeth, gear.module, gear.helix_angle, gear.profile_shift, gear.tip_alteration, rack)


def ring_radii(design: Design, ring: GearSizing) -> tuple[float, float]:
    """Return the radius of a ring's roots and that of its outside, of which the former leaves some metal [m].

    Args:
        design: With the rules of its stage.
        ring: An internal gear, as sized.
    """
    root = external_tooth(design, ring)._replace(side=-1).root_radius
    return root, max(ring.pitch_diameter / 2.0 + ring.rim, root + WALL * ring.module)


def crown_volume(design: Design, gear: GearSizing) -> float:
    """Return what the teeth of an external cylindrical gear fill [m³].

    Args:
        design: With the rules of its stage.
        gear: As sized.
    """
    return gear.teeth * outline_area(external_tooth(design, gear)) * gear.face_width


def blank_by_rules(gear: GearSizing, rules: GearRules, root: float, *, seat: tuple[float, float]) -> Blank:
    """Return the body under the teeth of an external gear by the rules of its stage.

    Args:
        gear: As sized.
        rules: Of its stage.
        root: Radius of the root circle [m].
        seat: Diameters of bore and hub [m].
    """
    height = TOOTH_HEIGHT * gear.module
    stated = rules.rim_ratio if gear.role in RIMMED else None
    rim = root - (BACKUP if stated is None else stated) * height
    bore = min(seat[0] / 2.0, root - WALL * gear.module)
    hub = max(min(seat[1] / 2.0, root), bore)
    return Blank(root, max(rim, 0.0), hub, bore, gear.face_width, rules.web_thickness_ratio * gear.face_width)


def turned_out(blank: Blank) -> Blank:
    """Return a body whose grooves beside the web are at most as deep as a tool reaches; a narrow one is not turned.

    Args:
        blank: Its radii and widths, with the web that the rules give.
    """
    deepest = GROOVE * max(blank.rim_radius - blank.hub_radius - 2.0 * CORNER, 0.0)
    return blank._replace(web_width=max(blank.web_width, blank.width - 2.0 * deepest))


def planet_body_volume(design: Design, planet: GearSizing, outside: float) -> float:
    """Return what a planet fills under its teeth: rim, web, and a hub around what it turns on [m³].

    Args:
        design: With the rules of its stage.
        planet: As sized.
        outside: Diameter of what it turns on [m].
    """
    root = cylindrical_gear(design, planet).root_radius
    seat = (outside, PLANET_HUB * outside)
    return blank_volume(turned_out(blank_by_rules(planet, design.rules(planet.stage), root, seat=seat)))
