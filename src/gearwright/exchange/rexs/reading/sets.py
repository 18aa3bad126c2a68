"""Planetary stages of a document as planetary sets of a design."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import Bodies
from gearwright.exchange.rexs.reading.document import Component
from gearwright.exchange.rexs.reading.gearing import Gear, Gearing, stage_table
from gearwright.identity import Role, gear_part


def read_set(
    asking: Asking, bodies: Bodies, gearing: Gearing, whole: Component, ends: Mapping[int, tuple[Gear, Gear]]
) -> None:
    """Add a planetary set, or say why its planetary stage is none.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: To which it is added.
        whole: The planetary stage.
        ends: Its stages, by id, with their gears.
    """
    shafts = set(asking.document.related("planet_shaft", "planetary_stage", whole.number, "shaft"))
    gears = {gear.number: gear for pair in ends.values() for gear in pair}
    planets = [gear for gear in gears.values() if gear.shaft in shafts]
    rings = [gear for gear in gears.values() if gear.component.kind == "ring_gear"]
    suns = [gear for gear in gears.values() if gear not in planets and gear not in rings]
    carriers = _carriers(asking, whole)
    if not carriers:
        asking.refuse(whole, "has no carrier; give it a planet_carrier_shaft relation, or a planet_carrier with shafts")
    if _is_simple(asking, whole, suns, rings, planets) and carriers:
        _add(asking, bodies, gearing, whole, (suns[0], planets, rings[0], carriers[0]), ends)


def _carriers(asking: Asking, whole: Component) -> list[int]:
    document = asking.document
    parts = document.related("assembly", "assembly", whole.number, "part")
    bodies = [part for part in parts if document.components[part].kind == "planet_carrier"]
    asking.used.update(bodies)
    asking.used.update(document.related("planet_pin", "planetary_stage", whole.number, "shaft"))
    return document.related("planet_carrier_shaft", "planetary_stage", whole.number, "shaft") or bodies


def _is_simple(
    asking: Asking, whole: Component, suns: Sequence[Gear], rings: Sequence[Gear], planets: Sequence[Gear]
) -> bool:
    counts = f"{len(suns)} suns, {len(rings)} rings and {len(planets)} planets"
    if len(suns) != 1 or len(rings) != 1 or not planets:
        asking.refuse(whole, f"has {counts}; sets of one sun, one ring and planets that mesh with both are read")
        return False
    if len({planet.teeth for planet in planets}) > 1:
        asking.refuse(whole, "has planets of different tooth numbers; sets of equal planets are read")
        return False
    return True


def _add(
    asking: Asking, bodies: Bodies, gearing: Gearing, whole: Component,
    members: tuple[Gear, Sequence[Gear], Gear, int], ends: Mapping[int, tuple[Gear, Gear]],
) -> None:  # fmt: skip
    sun, planets, ring, carrier = members
    name = bodies.new_name(whole)
    first = asking.document.components[min(ends)]
    for number in ends:
        stage_table(asking, asking.document.components[number], ends[number])
    table = stage_table(asking, first, (sun, *planets, ring))
    table |= {
        "sun": gearing.add_shaft(bodies.name(sun.shaft)), "ring": gearing.add_shaft(bodies.name(ring.shaft)),
        "carrier": gearing.add_shaft(bodies.name(carrier)), "planets": len(planets), "sun_teeth": sun.teeth,
        "planet_teeth": planets[0].teeth, "ring_teeth": ring.teeth,
    }  # fmt: skip
    shifts = {"sun_shift": sun.shift, "planet_shift": planets[0].shift, "ring_shift": ring.shift}
    table |= {key: shift for key, shift in shifts.items() if shift is not None}
    gearing.planetaries[name] = table
    for gear, role in ((sun, Role.SUN), *((planet, Role.PLANET) for planet in planets), (ring, Role.RING)):
        gearing.labels[gear.number] = str(gear_part(name, role))
    gearing.stages[name] = tuple(ends)
