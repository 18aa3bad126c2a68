"""Planetary stages of several suns, rings or kinds of planets, as compound sets of a design."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from gearwright.errors import DesignError
from gearwright.exchange.rexs.files import Component
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import Bodies
from gearwright.exchange.rexs.reading.gearing import Gear, Gearing, Table
from gearwright.exchange.rexs.reading.members import closing
from gearwright.identity import Role, gear_part

Mates = Mapping[int, Sequence[int]]
"""Gear -> the gears that it meshes with."""
ONE = {"suns": "sun", "rings": "ring", "planets": "planet"}
"""Table of a compound set -> what one of its gears is called."""


def read_compound(
    asking: Asking, bodies: Bodies, gearing: Gearing, whole: Component, stands: Mapping[int, Gear],
    meshes: Iterable[tuple[int, int]], *, planets: frozenset[int], carrier: int,
) -> None:  # fmt: skip
    """Add a compound set, or say why its planetary stage is none.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gearing: To which it is added.
        whole: The planetary stage.
        stands: Id of every gear -> the spur gear that stands for it.
        meshes: Ids of gears in mesh.
        planets: Shafts of planets.
        carrier: What turns the pins.
    """
    gears = {gear.number: gear for gear in stands.values()}
    mates: dict[int, list[int]] = {number: [] for number in gears}
    for one, other in {tuple(sorted((stands[first].number, stands[second].number))) for first, second in meshes}:
        mates[one].append(other)
        mates[other].append(one)
    classes = _classes(gears, mates, planets)
    counts = sorted({len(shafts) for shafts in classes})
    if len(counts) != 1:
        listed = " and ".join(map(str, counts)) or "no"
        asking.refuse(whole, f"has {listed} planets of each kind; sets that repeat a number of times are read")
        return
    name = bodies.new_name(whole)
    named = _names(gears, classes, planets)
    gears |= _closed(asking, whole, gears, mates, (named.keys(), planets))
    table: Table = {"carrier": gearing.add_shaft(bodies.name(carrier)), "sets": counts[0]}
    kinds: dict[str, dict[str, Any]] = {"suns": {}, "rings": {}, "planets": {}}
    for number, own in named.items():
        kinds[_kind(gears[number], planets)][own] = _gear(gearing, bodies, gears, mates, named, number, planets=planets)
    _in_one_piece(kinds["planets"], gears, named, planets)
    gearing.compounds[name] = table | {key: value for key, value in kinds.items() if value}
    _label(gearing, name, stands, classes, named, planets=planets)


def _closed(
    asking: Asking, whole: Component, gears: Mapping[int, Gear], mates: Mates,
    asked: tuple[Iterable[int], frozenset[int]],
) -> dict[int, Gear]:  # fmt: skip
    """Return suns and rings whose shift does not close with the planets, without it."""
    found: dict[int, Gear] = {}
    named, planets = asked
    for number in (number for number in named if gears[number].shaft in planets):
        met = [gears[mate] for mate in mates[number] if gears[mate].shaft not in planets]
        met.sort(key=lambda gear: (gear.component.kind == "ring_gear", gear.number))
        try:
            shifts = closing(asking, whole, gears[number], met)
        except DesignError:  # no centre distance: the design is refused in its own words
            continue
        found |= {mate: replace(gears[mate], shift=None) for mate, shift in shifts.items()
                  if shift is None and gears[mate].shift is not None}  # fmt: skip
    return found


def _kind(gear: Gear, planets: frozenset[int]) -> str:
    if gear.shaft in planets:
        return "planets"
    return "rings" if gear.component.kind == "ring_gear" else "suns"


def _classes(gears: Mapping[int, Gear], mates: Mates, planets: frozenset[int]) -> list[list[int]]:
    """Return the shafts of planets that are alike: equal gears which meet the same suns and rings."""
    found: dict[tuple[object, ...], list[int]] = {}
    for shaft in sorted({gear.shaft for gear in gears.values()} & planets):
        found.setdefault(tuple(_looks(gears, mates, shaft, planets)), []).append(shaft)
    return list(found.values())


def _looks(gears: Mapping[int, Gear], mates: Mates, shaft: int, planets: frozenset[int]) -> list[tuple[object, ...]]:
    return sorted(
        (gear.teeth, tuple(sorted(mate for mate in mates[number] if gears[mate].shaft not in planets)),
         sum(gears[mate].shaft in planets for mate in mates[number]))
        for number, gear in gears.items() if gear.shaft == shaft
    )  # fmt: skip


def _names(gears: Mapping[int, Gear], classes: Sequence[Sequence[int]], planets: frozenset[int]) -> dict[int, str]:
    """Return gear -> its name in the set, of suns, rings and one planet of each kind."""
    first = {shafts[0] for shafts in classes}
    named: dict[int, str] = {}
    counts: dict[str, int] = {}
    for number in sorted(gears):
        gear = gears[number]
        if gear.shaft in planets and gear.shaft not in first:
            continue
        stem = ONE[_kind(gear, planets)]
        counts[stem] = counts.get(stem, 0) + 1
        named[number] = stem if counts[stem] == 1 else f"{stem}-{counts[stem]}"
    return named


def _gear(
    gearing: Gearing, bodies: Bodies, gears: Mapping[int, Gear], mates: Mates, named: Mapping[int, str], number: int, *,
    planets: frozenset[int],
) -> Table:  # fmt: skip
    gear = gears[number]
    joined = _joined(mates, number)
    table: Table = {"teeth": gear.teeth, "module_m": gear.module,
                    "face_width_m": min(gears[other].width for other in joined)}  # fmt: skip
    if gear.shift is not None:
        table["shift"] = gear.shift
    if gear.shaft not in planets:
        return {"shaft": gearing.add_shaft(bodies.name(gear.shaft))} | table
    met = [_first(gears, named, mate, planets) for mate in mates[number]]
    return table | {"meshes": list(dict.fromkeys(met))}


def _first(gears: Mapping[int, Gear], named: Mapping[int, str], mate: int, planets: frozenset[int]) -> str:
    """Return the name of a gear, or of the planet that speaks for its kind."""
    if mate in named:
        return named[mate]
    alike = [own for number, own in named.items()
             if gears[number].shaft in planets and gears[number].teeth == gears[mate].teeth]  # fmt: skip
    return alike[0]


def _joined(mates: Mates, number: int) -> set[int]:
    """Return all gears that teeth join to one."""
    found, waiting = set[int](), [number]
    while waiting:
        one = waiting.pop()
        if one not in found:
            found.add(one)
            waiting += mates[one]
    return found


def _in_one_piece(
    tables: dict[str, Any], gears: Mapping[int, Gear], named: Mapping[int, str], planets: frozenset[int]
) -> None:
    """Say which steps of planets are one piece, and name every mesh of two planets once."""
    first: dict[int, str] = {}
    for number, own in named.items():
        if gears[number].shaft in planets:
            piece = first.setdefault(gears[number].shaft, own)
            if piece != own:
                tables[own]["in_one_piece_with"] = piece
    for own, table in tables.items():
        for mate in [mate for mate in table["meshes"] if own in tables.get(mate, {}).get("meshes", ())]:
            tables[mate]["meshes"].remove(own)


def _label(
    gearing: Gearing, name: str, stands: Mapping[int, Gear], classes: Sequence[Sequence[int]],
    named: Mapping[int, str], *, planets: frozenset[int],
) -> None:  # fmt: skip
    """Note what the design calls every gear of a document."""
    speaks = {shaft: shafts[0] for shafts in classes for shaft in shafts}
    by_place = {(gear.shaft, gear.teeth): named[gear.number] for gear in stands.values() if gear.number in named}
    for number, gear in stands.items():
        own = named.get(gear.number) or by_place[speaks.get(gear.shaft, gear.shaft), gear.teeth]
        role = {"planets": Role.PLANET, "rings": Role.RING, "suns": Role.SUN}[_kind(gear, planets)]
        gearing.labels[number] = str(gear_part(name, role, own=own))
