"""Stages of a document: pairs, planetary sets and compound sets of a design."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gearwright.base import DesignError, Problem, Role, gear_part
from gearwright.exchange.rexs.arrangement import NEAR, Bodies, Gear, Gearing, GearTable as Table, stage_table
from gearwright.exchange.rexs.files import Asking, Component
from gearwright.parts.gears.cylindrical_gear import shifts_at, working_centre

# ----------------------------------------------------------------------------------------------------------------------
# Gears of a planetary stage as sets hold them: halves put together, helical teeth by their transverse section.
# ----------------------------------------------------------------------------------------------------------------------


def members(asking: Asking, bodies: Bodies, whole: Component, gears: Sequence[Gear]) -> dict[int, Gear]:
    """Return id of every gear -> the spur gear that stands for it; the two halves of a double-helical one have one.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        whole: The planetary stage.
        gears: All of it.
    """
    found: dict[int, Gear] = {}
    for gear in gears:
        half = next((other for other in found.values() if _are_half_gears(bodies, other, gear)), None)
        if half is None:
            found[gear.number] = gear
        else:
            found[half.number] = found[gear.number] = replace(half, width=half.width + gear.width, helix=half.helix)
    if any(gear.helix for gear in gears):
        angle = math.degrees(max(abs(gear.helix) for gear in gears))
        said = (
            f"its teeth of {angle:.4g}° are read as spur ones of the same transverse section, as sets of a design are"
        )
        asking.notes.append(f"line {whole.line}: {whole.path}: {said}")
    return {number: transverse(gear) for number, gear in found.items()}


def _are_half_gears(bodies: Bodies, one: Gear, other: Gear) -> bool:
    return (
        one.helix == -other.helix != 0.0
        and (one.component.kind, one.teeth, one.module) == (other.component.kind, other.teeth, other.module)
        and bodies.of(one.shaft) == bodies.of(other.shaft)
    )


def transverse(gear: Gear) -> Gear:
    """Return the spur gear that has the transverse section of a helical one.

    Args:
        gear: Of any helix angle.

    Source: ISO 21771:2007, m_t = m_n/cos β, tan α_t = tan α_n/cos β, x_t = x_n cos β.
    """
    if gear.helix == 0.0:
        return gear
    slope = math.cos(gear.helix)
    shift = None if gear.shift is None else gear.shift * slope
    angle = math.atan(math.tan(gear.pressure_angle) / slope)
    return replace(gear, module=gear.module / slope, helix=0.0, shift=shift, pressure_angle=angle)


def shifts_that_close(
    asking: Asking, whole: Component, members: tuple[Gear, Gear, Gear], centre: float | None
) -> Table:
    """Return the profile shifts of a simple set, without those that do not close where its other gears do.

    Args:
        asking: The document.
        whole: The planetary stage.
        members: Sun, a planet and ring, of spur teeth.
        centre: Centre distance as stated [m]; None where it is not.
    """
    sun, planet, ring = members
    shifts = {"sun_shift": sun.shift, "planet_shift": planet.shift, "ring_shift": ring.shift}
    try:
        stands = _stands(sun, planet, centre)
        if stands is not None and sun.shift is not None:
            shifts["planet_shift"] = _follows(asking, whole, planet, sun, (1, stands))
        known = shifts["planet_shift"]
        if stands is not None and known is None and sun.shift is not None:
            known = _sum(sun, planet, 1, stands) - sun.shift
        if stands is not None and known is not None:
            shifts["ring_shift"] = _follows(asking, whole, ring, replace(planet, shift=known), (-1, stands))
    except DesignError:  # base circles that do not reach each other: the design is refused in its own words
        pass
    return {key: shift for key, shift in shifts.items() if shift is not None}


def _stands(sun: Gear, planet: Gear, centre: float | None) -> float | None:
    """Return the working centre distance over the module [-]."""
    if centre is not None:
        return centre / sun.module
    if sun.shift is None or planet.shift is None:
        return None
    return working_centre(
        sun.teeth + planet.teeth, sun.shift + planet.shift, pressure_angle=sun.pressure_angle, helix_angle=0.0
    )


def _sum(one: Gear, other: Gear, sign: int, stands: float) -> float:
    return shifts_at(one.teeth + sign * other.teeth, stands, pressure_angle=one.pressure_angle, helix_angle=0.0)


def _follows(asking: Asking, whole: Component, gear: Gear, mate: Gear, meets: tuple[int, float]) -> float | None:
    """Return the shift of a gear; None where it does not close with its mate and so follows from it."""
    if gear.shift is None or mate.shift is None:
        return gear.shift
    sign, stands = meets
    closes = _sum(mate, gear, sign, stands) - mate.shift
    if abs(closes - gear.shift) <= NEAR:
        return gear.shift
    said = f"{gear.component.path} has a profile shift of {gear.shift:.4g}, which does not close: {closes:.4g} does"
    asking.notes.append(f"line {whole.line}: {whole.path}: {said}")
    return None


def closing(asking: Asking, whole: Component, planet: Gear, centrals: Sequence[Gear]) -> dict[int, float | None]:
    """Return sun or ring -> its shift, None where it follows as it does not close where the first of them does.

    Args:
        asking: The document.
        whole: The planetary stage.
        planet: Of spur teeth.
        centrals: What it meets, in the order in which they are trusted.
    """
    stands: float | None = None
    found: dict[int, float | None] = {}
    for gear in centrals:
        sign = -1 if gear.component.kind == "ring_gear" else 1
        found[gear.number] = gear.shift
        if gear.shift is None or planet.shift is None:
            continue
        if stands is None:
            sums, shifts = planet.teeth + sign * gear.teeth, planet.shift + gear.shift
            stands = working_centre(sums, shifts, pressure_angle=gear.pressure_angle, helix_angle=0.0)
        else:
            found[gear.number] = _follows(asking, whole, gear, planet, (sign, stands))
    return found


# ----------------------------------------------------------------------------------------------------------------------
# Planetary stages of several suns, rings or kinds of planets, as compound sets of a design.
# ----------------------------------------------------------------------------------------------------------------------


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
        kinds[_kind_of_member(gears[number], planets)][own] = _gear(
            gearing, bodies, gears, mates, named, number, planets=planets
        )
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


def _kind_of_member(gear: Gear, planets: frozenset[int]) -> str:
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
        stem = ONE[_kind_of_member(gear, planets)]
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
        role = {"planets": Role.PLANET, "rings": Role.RING, "suns": Role.SUN}[_kind_of_member(gear, planets)]
        gearing.labels[number] = str(gear_part(name, role, own=own))


# ----------------------------------------------------------------------------------------------------------------------
# Planetary stages of a document as planetary sets of a design.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Stages of a document, one by one: which belong to planetary sets, and which are pairs.
# ----------------------------------------------------------------------------------------------------------------------


SPACE = 3
"""Dimensions of space [-]."""
PARALLEL = 1e-3
"""Sine of the angle between axes that count as parallel [-]."""
SHARED = ("module_m", "outer_module_m", "centre_distance_m")
"""What a pair has from the one whose gear it shares."""


def read_stages(asking: Asking, bodies: Bodies, gears: dict[int, Gear]) -> Gearing:
    """Return pairs and planetary sets.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        gears: Gears by id.
    """
    gearing, document = Gearing(), asking.document
    ends = _ends(asking, gears)
    taken: set[int] = set()
    for whole in document.of_kind("planetary_stage"):
        own = [number for number in document.related("assembly", "assembly", whole.number, "part") if number in ends]
        taken |= set(own)
        asking.used.add(whole.number)
        read_set(asking, bodies, gearing, whole, {number: ends[number] for number in own})
    for number, pair in ends.items():
        if number in taken:
            continue
        other = next((k for k in ends if k > number and k not in taken and _are_halves(pair, ends[k], bodies)), None)
        taken |= {number, other or number}
        _pair(asking, bodies, gearing, (document.components[number], pair), () if other is None else ends[other])
    return gearing


def _are_halves(one: tuple[Gear, Gear], other: tuple[Gear, Gear], bodies: Bodies) -> bool:
    """Tell whether two stages are halves of a double-helical pair: equal gears of opposite hand on the same shafts."""
    return one[0].helix != 0.0 and all(
        bodies.of(first.shaft) == bodies.of(second.shaft) and first.teeth == second.teeth
        and first.module == second.module and first.width == second.width and first.helix == -second.helix
        for first, second in zip(one, other, strict=True)
    )  # fmt: skip


def _ends(asking: Asking, gears: dict[int, Gear]) -> dict[int, tuple[Gear, Gear]]:
    """Return stage -> its two gears."""
    ends: dict[int, tuple[Gear, Gear]] = {}
    for relation in asking.document.relations:
        roles = relation.roles
        if relation.kind != "stage" or roles.get("stage") not in asking.document.components:
            continue
        pair = [gears.get(roles.get(role, -1)) for role in ("gear_1", "gear_2")]
        if pair[0] is None or pair[1] is None:
            continue  # a worm stage, or a spline: its component is listed as not read
        ends[roles["stage"]] = (pair[0], pair[1])
        asking.used.add(roles["stage"])
    for stage in asking.document.of_kind("cylindrical_stage", "bevel_stage"):
        if stage.number not in ends:
            asking.refuse(stage, "has no two gears; give it a stage relation with gear_1 and gear_2")
    return ends


def _pair(
    asking: Asking, bodies: Bodies, gearing: Gearing, read: tuple[Component, tuple[Gear, Gear]],
    other_half: tuple[Gear, ...],
) -> None:  # fmt: skip
    """Add a pair; gears that stand in a former one are its."""
    stage, ends = read
    pinion, wheel = sorted(ends, key=lambda gear: (gear.component.kind == "ring_gear", gear.teeth))
    name = bodies.new_name(stage)
    table = stage_table(asking, stage, (pinion, wheel))
    if other_half:
        table["halves"] = 2
    follows = dict[int, float]()
    if {pinion.number, wheel.number} & gearing.owners.keys():  # module and distance follow from the gear that it shares
        follows = _closing(gearing, pinion, wheel, table.get("centre_distance_m"))
        table = {key: value for key, value in table.items() if key not in SHARED}
    for role, gear in (("pinion", pinion), ("wheel", wheel)):
        shaft = gearing.add_shaft(bodies.name(gear.shaft))
        table[role] = gearing.owners.get(gear.number, shaft)
        table[f"{role}_teeth"] = gear.teeth
        shift = gear.shift if gear.shift is not None else follows.get(gear.number)
        if shift is not None and gear.number not in gearing.owners and gear.component.kind != "bevel_gear":
            table[f"{role}_shift"] = shift
        same = [half.number for half in other_half if half.shaft == gear.shaft]
        for number in (gear.number, *same):
            gearing.owners.setdefault(number, f"{name}.{role}")
            gearing.labels.setdefault(number, gearing.owners[number])
        if role == "wheel":
            gearing.wheels.add(gear.number)
    table |= _kind(asking, stage, pinion, wheel)
    if pinion.shift is not None and pinion.component.kind == "bevel_gear":
        table["pinion_shift"] = pinion.shift
    gearing.pairs[name] = table
    gearing.stages[name] = (stage.number,)


def _closing(gearing: Gearing, pinion: Gear, wheel: Gear, centre: float | None) -> dict[int, float]:
    """Return the shift of a gear that a file does not state, where it closes with the shared one at their distance."""
    known = [gear for gear in (pinion, wheel) if gear.number in gearing.owners]
    free = [gear for gear in (pinion, wheel) if gear.number not in gearing.owners and gear.shift is None]
    if centre is None or len(known) != 1 or not free or known[0].shift is None or "bevel" in pinion.component.kind:
        return {}
    teeth = pinion.teeth + (-wheel.teeth if wheel.component.kind == "ring_gear" else wheel.teeth)
    try:
        sums = shifts_at(teeth, centre / pinion.module, pressure_angle=pinion.pressure_angle, helix_angle=pinion.helix)
    except DesignError:  # the design is refused in its own words
        return {}
    return {free[0].number: sums - known[0].shift}


def _kind(asking: Asking, stage: Component, pinion: Gear, wheel: Gear) -> Table:
    """Return what tells internal and bevel pairs."""
    if pinion.component.kind != "bevel_gear":
        if _cross(asking, pinion, wheel):
            asking.refuse(stage, "has gears on axes that cross; cylindrical gears on parallel axes are read")
        return {"internal": True} if wheel.component.kind == "ring_gear" else {}
    if asking.number(stage, "hypoid_offset"):
        asking.refuse(stage, "is hypoid: its hypoid_offset is not 0; only axes that meet are read")
    return {"kind": "bevel", "axis_angle_rad": asking.number(stage, "shaft_angle") or math.pi / 2.0}


def _cross(asking: Asking, pinion: Gear, wheel: Gear) -> bool:
    """Tell whether axes that a file states are not parallel."""
    ways = [asking.vector(gear.component, "u_axis_vector") for gear in (pinion, wheel)]
    if not all(way is not None and len(way) == SPACE and any(way) for way in ways):
        return False
    one, other = (np.asarray(way) / np.linalg.norm(np.asarray(way)) for way in ways)
    return bool(np.linalg.norm(np.cross(one, other)) > PARALLEL)


def refuse_nothing(asking: Asking, gearing: Gearing) -> None:
    """Refuse a document without a stage that can be read.

    Args:
        asking: The document.
        gearing: What was read of it.
    """
    if gearing.pairs or gearing.planetaries or gearing.compounds or asking.problems:
        return
    kinds = sorted({component.kind for component in asking.document.components.values()})
    said = (
        f"there is no cylindrical, bevel or planetary stage among {', '.join(kinds) or 'them'}; export the gears, too"
    )
    asking.problems.append(Problem("components", said))
