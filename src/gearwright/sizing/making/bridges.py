"""Whether carriers go through their rings, and have room for bridges, which tie a second plate to the first.

Sizing has pins that one plate holds; the complete mass counts a second plate and bridges. A planet of tip diameter d_a
is put in through the window between two bridges, on the chord 2 r sin(π/N) of neighbouring pins. Half of the torque
crosses to the second plate: each bridge bends as a beam with both ends held, M = F L/2 with F = T/(2 N r).
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.checks import Check, not_assessed
from gearwright.identity import Role
from gearwright.sizing import CarrierSizing, GearSizing, Sizing
from gearwright.sizing.making.running import OFF
from gearwright.sizing.mass import BRIDGE, tooth_of
from gearwright.sizing.shafts.carriers import THROUGH

_CLAUSE = "window between bridges; beam with both ends held"
_HELP = "one plate must hold the pins; fewer planets, or smaller ones, would leave bridges room"


def bridge_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether plates go through rings, and what planets leave on the pin circle is thick enough for a bridge.

    Args:
        sizing: As sized.
    """
    for carrier in sizing.carriers:
        yield from _through(sizing, carrier)
        planets = [gear for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET]
        if carrier.stage in sizing.design.planetaries and max(gear.bodies for gear in planets) > 1:
            yield _bridges(sizing, carrier, planets[0])


def _through(sizing: Sizing, carrier: CarrierSizing) -> Iterator[Check]:
    """Yield whether the plates of a carrier, with their eyes, pass the tips of the narrowest ring of their set."""
    tips = [tooth_of(sizing, gear).tip_radius for gear in sizing.gears if gear.stage == carrier.stage and gear.rim]
    if tips:
        yield Check(
            carrier.part, "plate through its ring", "tip circle", carrier.reach, min(tips) - THROUGH, "length",
            at_most=True, exponent=None, symbol="r",
        )  # fmt: skip


def _bridges(sizing: Sizing, carrier: CarrierSizing, planet: GearSizing) -> Check:
    room, needed = bridge_room(carrier, planet), bridge_needed(sizing, carrier, planet)
    if room < needed:
        why = f"planets leave {1e3 * max(room, 0.0):.3g} mm for bridges that need {1e3 * needed:.3g} mm: {_HELP}"
        return not_assessed(carrier.part, "bridges between planets", _CLAUSE, why)
    return Check(carrier.part, "bridges between planets", _CLAUSE, room, needed, "length", exponent=None)


def bridge_room(carrier: CarrierSizing, planet: GearSizing) -> float:
    """Return the thickness that neighbouring planets, put in through windows, leave for a bridge [m].

    Args:
        carrier: As sized.
        planet: On its pins.
    """
    tip = planet.pitch_diameter + 2.0 * planet.module * (1.0 + planet.profile_shift + planet.tip_alteration)
    return 2.0 * carrier.radius * math.sin(math.pi / planet.bodies) - tip - 2.0 * OFF


def bridge_needed(sizing: Sizing, carrier: CarrierSizing, planet: GearSizing) -> float:
    """Return the thickness that half of the carrier's torque asks of a bridge [m].

    Args:
        sizing: As sized.
        carrier: Of it.
        planet: On its pins.
    """
    allowed = (sizing.design.shaft_material.yield_strength or math.inf) / sizing.design.shafting.safety
    force = carrier.torque / (2.0 * planet.bodies * carrier.radius)
    moment, depth = force * planet.face_width / 2.0, BRIDGE * planet.pitch_diameter
    return math.sqrt(6.0 * moment / (depth * allowed))
