"""Planetary stages of a document as planetary sets of a design."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearwright.exchange.rexs.files import Component
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import Bodies
from gearwright.exchange.rexs.reading.compound import read_compound
from gearwright.exchange.rexs.reading.gearing import Gear, Gearing, stage_table
from gearwright.exchange.rexs.reading.members import members, shifts_that_close
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
    shafts = frozenset(asking.document.related("planet_shaft", "planetary_stage", whole.number, "shaft"))
    gears = {gear.number: gear for pair in ends.values() for gear in pair}
    stands = members(asking, bodies, whole, list(gears.values()))
    alone = {gear.number: gear for gear in stands.values()}
    planets = [gear for gear in alone.values() if gear.shaft in shafts]
    rings = [gear for gear in alone.values() if gear.component.kind == "ring_gear"]
    suns = [gear for gear in alone.values() if gear not in planets and gear not in rings]
    carriers = _carriers(asking, whole)
    if not carriers:
        asking.refuse(whole, "has no carrier; give it a planet_carrier_shaft relation, or a planet_carrier with shafts")
    elif not planets or not (suns or rings):
        counts = f"{len(suns)} suns, {len(rings)} rings and {len(planets)} planets"
        asking.refuse(whole, f"has {counts}; give it planet_shaft relations, and stages of planets with suns or rings")
    elif len(suns) == len(rings) == 1 and len({planet.shaft for planet in planets}) == len(planets) and _alike(planets):
        _add(asking, bodies, gearing, whole, (suns[0], planets, rings[0], carriers[0]), ends)
        gearing.labels |= {number: gearing.labels[gear.number] for number, gear in stands.items()}
    else:
        for number, pair in ends.items():
            stage_table(asking, asking.document.components[number], pair)
        meshes = [(first.number, second.number) for first, second in ends.values()]
        read_compound(asking, bodies, gearing, whole, stands, meshes, planets=shafts, carrier=carriers[0])


def _alike(planets: Sequence[Gear]) -> bool:
    return len({planet.teeth for planet in planets}) == 1


def _carriers(asking: Asking, whole: Component) -> list[int]:
    document = asking.document
    parts = document.related("assembly", "assembly", whole.number, "part")
    bodies = [part for part in parts if document.components[part].kind == "planet_carrier"]
    asking.used.update(bodies)
    asking.used.update(document.related("planet_pin", "planetary_stage", whole.number, "shaft"))
    return document.related("planet_carrier_shaft", "planetary_stage", whole.number, "shaft") or bodies


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
    table |= shifts_that_close(asking, whole, (sun, planets[0], ring), table.get("centre_distance_m"))
    gearing.planetaries[name] = table
    for gear, role in ((sun, Role.SUN), *((planet, Role.PLANET) for planet in planets), (ring, Role.RING)):
        gearing.labels[gear.number] = str(gear_part(name, role))
    gearing.stages[name] = tuple(ends)
