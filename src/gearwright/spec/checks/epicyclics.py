"""Checks of planetary and compound planetary stages: members, assembly conditions and load sharing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations, product

from gearwright.base import SIDES, DesignError, Problem, Role, near
from gearwright.parts.gears import FEWEST_TEETH
from gearwright.parts.planetary import (
    CLOSES,
    CompoundSet,
    assembles,
    can_assemble,
    most_planets,
    nearest_positions,
    pin_angles,
    pin_radii,
    reaches,
    tip_gap,
    touching,
)
from gearwright.spec.design import (
    GROUND,
    RATINGS,
    SET_ROLES,
    Design,
    Epicyclic,
    Pair,
    Planetary,
    compound_shifts,
    relative_modules,
    split_levels,
    stage_shifts,
)
from gearwright.spec.record import NAME_RULE, is_name

# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with planetary sets: members that are one shaft, given teeth that do not go together.
# ----------------------------------------------------------------------------------------------------------------------


MOST_PLANETS = 12
"""Largest number of planets that a design may ask for."""
LARGEST_LOAD_FACTOR = 3.0
"""K_γ, as of mesh_load_factor [-]."""


def planetary_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the members and the given teeth of planetary sets.

    Args:
        design: As typed.
    """
    allowed = [*design.shafts, GROUND]
    for name, planetary in design.planetaries.items():
        path = f"planetaries.{name}"
        members = {"sun": planetary.sun, "ring": planetary.ring, "carrier": planetary.carrier}
        for member, shaft in members.items():
            if shaft not in allowed:
                yield Problem(f"{path}.{member}", f"there is no shaft {shaft!r}; {near(shaft, allowed)}")
        for (first, shaft), (other, same) in combinations(members.items(), 2):
            if shaft == same:
                yield Problem(f"{path}.{other}", f"{same!r} is the {first} already; the three members are three shafts")
        unclosed = list(_unclosed(path, planetary))
        yield from unclosed or _together(path, name, design)


def load_factor_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with tables of load factors, and sets whose number of planets they lack.

    Args:
        design: As typed.
    """
    written = {"gears": design.gears} | {
        f"{design.table(name)}.gears": stage.gears for name, stage in design.stages.items() if stage.gears is not None
    }
    for path, rules in written.items():
        for count, factor in rules.planet_load_factors.items():
            where = f"{path}.planet_load_factors.{count}"
            if not count.isdecimal() or not 1 <= int(count) <= MOST_PLANETS:
                yield Problem(where, f"{count!r} is no number of planets; allowed: 1 to {MOST_PLANETS}")
            elif not 1.0 <= factor <= LARGEST_LOAD_FACTOR:
                yield Problem(where, f"{factor:g} is not allowed; give a number from 1 to {LARGEST_LOAD_FACTOR:g}")
    for name, stage in design.sets.items():
        table = design.rules(name).planet_load_factors
        planets = stage.planets_given if isinstance(stage, Planetary) else stage.sets
        if table and not table.keys() & (_counts(design) if planets is None else {str(planets)}):
            most = design.teeth.planets_maximum
            wanted = f"its {planets} planets are" if planets else f"none of 2 to {most} planets is"
            message = f"{wanted} in gears.planet_load_factors, which has {', '.join(table)}; add the factor"
            yield Problem(design.table(name), message)


def _counts(design: Design) -> set[str]:
    """Return the numbers of planets that are looked at where a set leaves its own out, as tables write them."""
    return {str(count) for count in range(2, design.teeth.planets_maximum + 1)}


def _unclosed(path: str, planetary: Planetary) -> Iterator[Problem]:
    """Find given teeth that leave no room for the others; whether all three close is for their profile shifts."""
    sun, planet, ring = planetary.sun_teeth, planetary.planet_teeth, planetary.ring_teeth
    if sun is not None and planet is not None and ring is not None:
        if ring <= max(sun, planet):
            yield Problem(f"{path}.ring_teeth", f"{ring} leaves no room for a sun of {sun} and planets of {planet}")
    elif sun is not None and ring is not None and (ring <= sun or (ring - sun) % 2):
        message = (
            f"{ring} leaves no planets beside a sun of {sun}: z_r − z_s = 2 z_p is even and above 0; with profile shift"
            " give planet_teeth, too"
        )
        yield Problem(f"{path}.ring_teeth", message)
    elif planet is not None and ring is not None and ring <= 2 * planet:
        yield Problem(f"{path}.ring_teeth", f"{ring} leaves no sun inside planets of {planet}: z_r = z_s + 2 z_p")


def _together(path: str, name: str, design: Design) -> Iterator[Problem]:
    """Find planets that stand into their neighbours, or whose teeth do not meet those of sun and ring."""
    planetary = design.planetaries[name]
    teeth, planets = planetary.known_teeth, planetary.planets_given
    if teeth is None or planets is None:
        return
    sun, planet, ring = teeth
    try:
        shifts = stage_shifts(design, name, dict(zip(SET_ROLES, teeth, strict=True)))
    except DesignError as error:
        yield from error.problems
        return
    centre = 0.5 * (sun + planet) if shifts.centre is None else shifts.centre
    tip = 0.5 * planet + 1.0 + sum(shifts.of(Role.PLANET))
    even = assembles(sun, ring, planets)
    if not even and not planetary.unequal_places:
        yield Problem(f"{path}.planets", _unassembled(teeth, planets, most_planets(centre, tip)))
    elif (gap := tip_gap(centre, tip, nearest_positions(sun, ring, planets))) <= 0.0:
        most = most_planets(centre, tip)
        yield Problem(
            f"{path}.planets",
            f"{planets} planets of {planet} teeth stand into each other by {-gap:.3g} modules: 2 a_w sin(Δψ/2) of the"
            f" nearest two must be above their tip diameter of {2.0 * tip:.4g} modules; give {most} or fewer, or"
            " smaller planets",
        )


def _unassembled(teeth: tuple[int, int, int], planets: int, most: int) -> str:
    """Return why equal planets cannot be put in, and what can: numbers of planets, teeth of the ring, other places."""
    sun, planet, ring = teeth
    counts = range(2, min(MOST_PLANETS, most) + 1)
    would = " or ".join(str(count) for count in counts if assembles(sun, ring, count))
    hint = f"give {would} planets, " if would else ""
    apart = sorted(range(-planets, planets + 1), key=abs)
    near_sets = [
        *((sun + more, planet, ring + more) for more in apart),
        *((sun, planet, ring + more) for more in apart),
    ]
    nearest = next(near_set for near_set in near_sets if assembles(near_set[0], near_set[2], planets))
    return (
        f"{planets} planets cannot be assembled at equal places: z_s + z_r = {sun} + {ring} = {sun + ring} is no"
        f" multiple of {planets}; {hint}unequal_places = true, or other teeth, such as"
        f" {nearest[0]}/{nearest[1]}/{nearest[2]}"
    )


# ----------------------------------------------------------------------------------------------------------------------
# Whether the planets of a compound set fit: pins that one distance serves, room beside each other, whole teeth.
# ----------------------------------------------------------------------------------------------------------------------


MOST_SETS = 12
"""Largest number of sets that a design may ask for."""
ROUNDED = 1e-9
"""Length by which rounding may let faces that only touch overlap [m]."""
FARTHEST = 4
"""Teeth by which a set that can be assembled may differ from one that cannot, to be named [-]."""


def fit_problems(name: str, design: Design) -> Iterator[Problem]:
    """Yield what keeps the planets of a compound set from being put in.

    Args:
        name: Of a set whose names all mean something.
        design: As typed.
    """
    path, epicyclic = f"epicyclics.{name}", design.epicyclics[name]
    try:
        compound = compound_shifts(design, name).shape(epicyclic.compound)
    except DesignError as error:
        yield from error.problems
        return
    modules = relative_modules(epicyclic)
    apart = [body for body, angle in pin_angles(compound, modules).items() if math.isnan(angle)]
    if apart:
        yield from _parted(path, compound, modules)
        return
    for first, second, overlap in touching(compound, modules):
        what = "those of the next set" if first == second else second
        fix = "give fewer sets, or planets of fewer teeth" if compound.sets > 1 else "give planets of fewer teeth"
        if second in epicyclic.centrals:
            fix = f"give {first} fewer teeth, or place_mm and face_width_mm of both with which they lie apart"
        message = f"{first} stands into {what} by {overlap:.2g} modules at the tips; {fix}"
        yield Problem(f"{path}.planets.{first}", message)
    yield from _in_one_place(path, epicyclic)
    if not can_assemble(compound):
        yield Problem(f"{path}.sets", _unassembled_compound(compound, modules))


def _in_one_place(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    """Find two suns, two rings or two steps of one planet whose places and widths lay their faces over each other."""
    whole = epicyclic.compound
    for table, kin in (("suns", epicyclic.suns), ("rings", epicyclic.rings), ("planets", epicyclic.planets)):
        for first, second in combinations([name for name in kin if name in whole.places], 2):
            room = sum(whole.widths.get(gear, 0.0) for gear in (first, second)) / 2.0
            apart = abs(whole.places[first] - whole.places[second])
            one_piece = table != "planets" or whole.bodies[first] == whole.bodies[second]
            if one_piece and (apart == 0.0 or apart < room - ROUNDED):
                message = f"its middle is {1e3 * apart:.4g} mm from that of {first}, on one axis, so that they stand"
                least = f" at least {1e3 * room:.4g} mm" if room else ""
                yield Problem(f"{path}.{table}.{second}.place", f"{message} into each other; place them{least} apart")


def _far_apart(compound: CompoundSet, modules: Mapping[str, float]) -> bool:
    """Tell whether suns and rings of some planet want its pin at distances that shifts may not take up."""
    for asked in reaches(compound).values():
        distances = [modules[group] * distance for group, distance in asked]
        if max(distances) - min(distances) > CLOSES * min(modules[group] for group, _ in asked) * (1.0 + 1e-9):
            return True
    return False


def _parted(path: str, compound: CompoundSet, modules: Mapping[str, float]) -> Iterator[Problem]:
    """Find meshed planets whose pins no triangle joins."""
    radii = pin_radii(compound, modules)
    for first, second in compound.between:
        one, other = (radii[compound.bodies[gear]] for gear in (first, second))
        distance = modules[compound.group(first)] * compound.distance(first, second)
        if not abs(one - other) <= distance <= one + other:
            message = (
                f"{first} and {second} cannot mesh: their pins stand {one:.4g} and {other:.4g} modules from the axis,"
                f" so that they are {abs(one - other):.4g} to {one + other:.4g} apart, and the teeth ask"
                f" {distance:.4g}; change the teeth of one"
            )
            yield Problem(f"{path}.planets.{first}", message)


def _unassembled_compound(compound: CompoundSet, modules: Mapping[str, float]) -> str:
    counts = [str(count) for count in range(1, MOST_SETS + 1) if _fits(replace(compound, sets=count), modules)]
    nearest = nearest_teeth(compound, modules)
    words = [f"give {' or '.join(counts)} set{'s' if counts != ['1'] else ''}"] if counts else []
    words += ["give " + ", ".join(f"{name} {teeth}" for name, teeth in nearest.items()) + " teeth"] if nearest else []
    fix = "; or ".join(words) or "give other teeth"
    return f"{compound.sets} equal sets cannot be assembled: no turn of the planets meets all teeth; {fix}"


def nearest_teeth(compound: CompoundSet, modules: Mapping[str, float]) -> dict[str, int]:
    """Return the gears of the nearest set that can be assembled and their tooth numbers; nothing where none is near.

    Args:
        compound: A set that cannot.
        modules: Group -> module, in any unit.
    """
    names = list(compound.teeth)
    changes = sorted(
        (change for change in product(range(-2, 3), repeat=len(names)) if 0 < sum(map(abs, change)) <= FARTHEST),
        key=lambda change: (sum(map(abs, change)), tuple(map(abs, change))),
    ) if len(names) <= 7 else []  # fmt: skip
    for change in changes:
        moved = {name: abs(compound.teeth[name]) + step for name, step in zip(names, change, strict=True)}
        tried = replace(
            compound,
            centres={},
            heights={},
            centrals={name: moved[name] * (1 if teeth > 0 else -1) for name, teeth in compound.centrals.items()},
            planets={name: moved[name] for name in compound.planets},
        )
        if min(moved.values()) >= FEWEST_TEETH and _fits(tried, modules):
            return {name: teeth for name, teeth in moved.items() if teeth != abs(compound.teeth[name])}
    return {}


def _fits(compound: CompoundSet, modules: Mapping[str, float]) -> bool:
    return (
        can_assemble(compound)
        and not _far_apart(compound, modules)
        and not any(math.isnan(angle) for angle in pin_angles(compound, modules).values())
        and not list(touching(compound, modules))
    )


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with compound epicyclic sets: names, members that nothing moves, circles, what does not fit.
# ----------------------------------------------------------------------------------------------------------------------


LEAST_EFFICIENCY = 0.5
"""Of a mesh, as in the rules of all gears [-]."""
_TABLES = ("suns", "rings", "planets")


def epicyclic_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the compound sets of a design; what does not fit together only of one that is whole.

    Args:
        design: As typed.
    """
    for name, epicyclic in design.epicyclics.items():
        path = f"epicyclics.{name}"
        yield from _shafts(path, epicyclic, design)
        yield from _bearings(path, epicyclic)
        named = [*_names(path, epicyclic), *_mates(path, epicyclic)]
        yield from named
        whole = named or [*_unmoved(path, epicyclic), *_circles(path, epicyclic)]
        if not named:
            whole += _contradictions(path, epicyclic)
            yield from whole
            yield from _efficiencies(path, epicyclic)
        if not whole:
            yield from fit_problems(name, design)


def _shafts(path: str, epicyclic: Epicyclic, design: Design) -> Iterator[Problem]:
    allowed = [*design.shafts, GROUND]
    paths = {f"{path}.{table}.{name}.shaft": gear.shaft for table in _TABLES[:2]
             for name, gear in getattr(epicyclic, table).items()}  # fmt: skip
    for where, shaft in {**paths, f"{path}.carrier": epicyclic.carrier}.items():
        if shaft not in allowed:
            yield Problem(where, f"there is no shaft {shaft!r}; {near(shaft, allowed)}")
    for where, shaft in paths.items():
        if shaft == epicyclic.carrier:
            message = (
                f"{shaft!r} is the carrier already, so that the set turns as one block, or not at all; put it on a"
                " shaft of its own, and join the two by a clutch where a gear wants that"
            )
            yield Problem(where, message)


def _bearings(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    for name, planet in epicyclic.planets.items():
        if planet.bearing is not None and planet.bearing.designation is None:
            message = "is left out; no bearing is chosen for planets of compound sets: name one, such as NU 2212"
            yield Problem(f"{path}.planets.{name}.bearing.designation", message)


def _names(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    """Find names that no path can hold, and gears that are called alike."""
    seen: dict[str, str] = {}
    for table in _TABLES:
        for name in getattr(epicyclic, table):
            if not is_name(name):
                yield Problem(f"{path}.{table}.{name}", f"{name!r} {NAME_RULE}")
            if name == "carrier" or name in seen:
                what = "the carrier" if name == "carrier" else f"one of the {seen[name]}"
                yield Problem(f"{path}.{table}.{name}", f"{what} is called so; every gear of a set has its own name")
            seen[name] = table
    if not epicyclic.planets:
        yield Problem(path, f"has no planets; add a table such as [{path}.planets.planet]")
    if not epicyclic.centrals:
        yield Problem(path, f"has neither sun nor ring; add a table such as [{path}.suns.sun]")


def _mates(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    """Find mates that are no gears of the set, or cannot mesh."""
    for name, planet in epicyclic.planets.items():
        where, others = f"{path}.planets.{name}", [gear for gear in epicyclic.toothed if gear != name]
        mate, steps = planet.in_one_piece_with, [step for step in epicyclic.planets if step != name]
        if mate is not None and mate not in steps:
            message = f"there is no other planet {mate!r} in this set; {near(mate, steps)}"
            yield Problem(f"{where}.in_one_piece_with", message)
        elif mate is not None and epicyclic.body(name) in (name, mate) and _first(epicyclic, mate) == name:
            yield Problem(f"{where}.in_one_piece_with", f"{mate!r} names it in turn; leave it out at one of the two")
        for gear in planet.meshes:
            if gear not in others:
                yield Problem(f"{where}.meshes", f"there is no other gear {gear!r} in this set; {near(gear, others)}")
            elif gear in epicyclic.planets and epicyclic.body(gear) == epicyclic.body(name):
                yield Problem(f"{where}.meshes", f"{gear!r} is in one piece with it, so that they cannot mesh")
            elif gear in epicyclic.rings and epicyclic.rings[gear].teeth <= planet.teeth:
                teeth = epicyclic.rings[gear].teeth
                message = f"{teeth} leaves no room inside for a planet of {planet.teeth}; give more"
                yield Problem(f"{path}.rings.{gear}.teeth", message)


def _first(epicyclic: Epicyclic, planet: str) -> str | None:
    return epicyclic.planets[planet].in_one_piece_with


def _unmoved(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    """Find members that no planet meshes, and planets whose place nothing says."""
    meshing = {gear for pair in epicyclic.mesh_pairs for gear in pair}
    for table in _TABLES[:2]:
        for name in getattr(epicyclic, table):
            if name not in meshing:
                planets = near(name, epicyclic.planets)
                message = f"no planet meshes with it; write it under meshes of one: {planets}, or leave it out"
                yield Problem(f"{path}.{table}.{name}", message)
    placed = {epicyclic.body(gear) for pair in epicyclic.mesh_pairs if set(pair) & epicyclic.centrals.keys()
              for gear in pair if gear in epicyclic.planets}  # fmt: skip
    for name in epicyclic.planets:
        if name not in meshing:
            yield Problem(f"{path}.planets.{name}.meshes", "it meshes with nothing; name a sun, a ring or a planet")
        elif epicyclic.body(name) not in placed:
            message = "it meshes with planets only, so that nothing says where it stands; let it mesh a sun or a ring"
            yield Problem(f"{path}.planets.{name}.meshes", message)


def _circles(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    """Find meshes that close a circle, which lock each other, and parts that nothing joins to the others."""
    root = {name: epicyclic.body(name) if name in epicyclic.planets else name for name in epicyclic.toothed}
    kept: list[tuple[str, str]] = []
    for first, second in epicyclic.mesh_pairs:
        here, there = root[first], root[second]
        if here == there:
            ring = ", ".join(f"{one}-{other}" for one, other in _way(kept, epicyclic, first, second))
            message = (
                f"{first}-{second} closes a circle of meshes with {ring}: gears that mesh in a circle lock each other;"
                " leave one of these meshes out"
            )
            yield Problem(path, message)
        kept.append((first, second))
        root = {name: there if value == here else value for name, value in root.items()}
    parts = list(dict.fromkeys(root.values()))
    if len(parts) > 1:
        groups = " and ".join(
            ", ".join(name for name in epicyclic.toothed if root[name] == part) for part in parts
        )  # fmt: skip
        message = f"no mesh joins {groups}; make them sets of their own with carriers on one shaft"
        yield Problem(path, message)


def _way(
    meshes: list[tuple[str, str]], epicyclic: Epicyclic, first: str, second: str
) -> list[tuple[str, str]]:  # fmt: skip
    """Return the meshes by which one gear leads to another already."""

    def body(gear: str) -> str:
        return epicyclic.body(gear) if gear in epicyclic.planets else gear

    ways: dict[str, list[tuple[str, str]]] = {body(first): []}
    for here in (queue := [body(first)]):
        for mesh in meshes:
            ends = body(mesh[0]), body(mesh[1])
            for start, end in (ends, ends[::-1]):
                if start == here and end not in ways:
                    ways[end] = [*ways[here], mesh]
                    queue.append(end)
    return ways.get(body(second), [])


def _contradictions(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    """Find modules and face widths of gears that teeth join, which have one of each."""
    tables = {name: table for table in _TABLES for name in getattr(epicyclic, table)}
    for group in dict.fromkeys(map(epicyclic.group, tables)):
        for key in ("module", "face_width"):
            every = {name: getattr(epicyclic.toothed[name], key) for name in tables if epicyclic.group(name) == group}
            given = {f"{tables[name]}.{name}": value for name, value in every.items() if value is not None}
            if given and max(given.values()) - min(given.values()) > 1e-9 * max(given.values()):
                values = ", ".join(f"{where}.{key}_mm = {1e3 * value:.6g}" for where, value in given.items())
                what = key.replace("_", " ")
                message = f"gears that mesh, directly or through others, have one {what}: {values}; give one value"
                yield Problem(f"{path}.{list(given)[-1]}.{key}", message)


def _efficiencies(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    known = [f"{first}-{second}" for first, second in epicyclic.mesh_pairs]
    for mesh, value in epicyclic.mesh_efficiencies.items():
        where = f"{path}.mesh_efficiencies.{mesh}"
        if mesh not in known:
            yield Problem(where, f"there is no mesh {mesh!r} in this set; {near(mesh, known)}")
        elif not LEAST_EFFICIENCY < value <= 1.0:
            yield Problem(where, f"{value:g}; give more than {LEAST_EFFICIENCY:g}, at most 1")


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with how planets and parallel paths are said to share their load.
# ----------------------------------------------------------------------------------------------------------------------


_FLOATING = ("level-3", "level-4")
"""Levels of planets of which a central member floats."""
_HELD = 2
"""Bearings by which a shaft is held across, so that nothing on it floats [-]."""
LARGEST_RELIEF = 0.05
"""Tip relief over the module, at most [-]: beyond, too little of the involute is left to carry; an estimate."""


def sharing_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with how stages are said to share their load, and with stated tip reliefs.

    Args:
        design: As typed.
    """
    for name, stage in design.stages.items():
        path = design.table(name)
        yield from _stated_twice(design, name, path)
        if isinstance(stage, Pair):
            yield from _of_paths(design, name, stage, path)
        else:
            yield from _of_planets(design, stage, path)
        yield from _relief(design, name)
    yield from _relief_stated_twice(design)


def _stated_twice(design: Design, name: str, path: str) -> Iterator[Problem]:
    """Find a way of sharing beside a factor that overrides it, or with a method that lets all share alike."""
    rules, stage = design.rules(name), design.stages[name]
    if stage.load_sharing is None:
        return
    if rules.mesh_load_factor is not None or rules.planet_load_factors:
        key = "mesh_load_factor" if rules.mesh_load_factor is not None else "planet_load_factors"
        yield Problem(f"{path}.load_sharing", f"has no effect: gears.{key} states K_γ; keep one of the two")
    elif not RATINGS[design.rating(name)].fatigue:
        title = RATINGS[design.rating(name)].title
        yield Problem(f"{path}.load_sharing", f"has no effect: with {title} all share alike; give mesh_load_factor")


def _of_planets(design: Design, stage: Planetary | Epicyclic, path: str) -> Iterator[Problem]:
    sharing = stage.load_sharing
    if sharing == "tolerances" and stage.pin_position is None:
        yield Problem(f"{path}.pin_position_um", 'is required with load_sharing = "tolerances"')
    if sharing != "tolerances" and stage.pin_position is not None:
        yield Problem(f"{path}.pin_position_um", 'has no effect without load_sharing = "tolerances"; leave it out')
    members = dict.fromkeys(stage.members)
    if sharing in _FLOATING and GROUND not in members and all(_is_held(design, shaft) for shaft in members):
        message = (
            f"{sharing!r} asks for a central member that floats, and {', '.join(members)} each run in {_HELD} bearings"
            " or more; leave one without bearings, or give level-1 or level-2"
        )
        yield Problem(f"{path}.load_sharing", message)


def _of_paths(design: Design, name: str, pair: Pair, path: str) -> Iterator[Problem]:
    if pair.load_sharing is not None and name not in split_levels(design):
        message = "has no effect: the pair is on no loop of parallel paths; leave it out"
        yield Problem(f"{path}.load_sharing", message)
    if pair.clocking is not None and pair.load_sharing not in (None, "clocked"):
        yield Problem(f"{path}.clocking_mrad", f"has no effect with load_sharing = {pair.load_sharing!r}; leave it out")
    elif pair.clocking is not None and name not in split_levels(design):
        yield Problem(f"{path}.clocking_mrad", "has no effect: the pair is on no loop of parallel paths; leave it out")
    if pair.load_sharing == "floating":
        single = [shafts[0] for side in SIDES if len(shafts := pair.named(side)) == 1]
        held = [shaft for shaft in single if _is_held(design, shaft)]
        if held and len(held) == len(single):
            message = f"'floating' asks for a gear that floats, and {held[0]} runs in {_HELD} bearings or more"
            yield Problem(f"{path}.load_sharing", f"{message}; leave it without bearings, or give clocked or rigid")


def _is_held(design: Design, shaft: str) -> bool:
    return sum(seat.shaft == shaft for seat in design.bearings.values()) >= _HELD


def _relief(design: Design, name: str) -> Iterator[Problem]:
    """Find a stated tip relief that leaves too little of the involute of a stated module."""
    stage = design.stages[name]
    module = None if isinstance(stage, Epicyclic) else stage.module
    if module is not None and (problem := relief_problem(design, name, module)) is not None:
        yield problem


def _relief_stated_twice(design: Design) -> Iterator[Problem]:
    """Find a rule for reliefs beside the amount that overrides it, in the same table."""
    tables = {"gears": design.gears} | {f"{design.table(name)}.gears": row.gears for name, row in design.stages.items()}
    for table, rules in tables.items():
        if rules is not None and {"tip_relief", "tip_relief_for"} <= rules.iso6336.model_fields_set:
            message = "has no effect: tip_relief_mm states the amount; keep one of the two"
            yield Problem(f"{table}.iso6336.tip_relief_for", message)


def relief_problem(design: Design, name: str, module: float) -> Problem | None:
    """Return what is wrong with the tip relief that is stated for a stage of some module; None where nothing is.

    Args:
        design: As typed.
        name: Of the stage.
        module: m_n of its teeth [m].
    """
    stage, relief = design.stages[name], design.rules(name).iso6336.tip_relief
    bevel = isinstance(stage, Pair) and stage.kind != "cylindrical"
    if bevel or relief is None or relief <= LARGEST_RELIEF * module:
        return None
    given, most = 1e3 * relief, 1e-3 * math.floor(1e6 * LARGEST_RELIEF * module + 1e-6)  # whole µm, in mm
    message = (
        f"{given:g} mm on a module of {1e3 * module:.4g} mm ({name}) leaves too little of the flank; give {most:.3g} mm"
        " or less, or leave it out: tips are then relieved for their load"
    )
    return Problem(_stated_at(design, name), message)


def _stated_at(design: Design, name: str) -> str:
    """Return where the tip relief of a stage is written: in its own table, or in that of all."""
    own = design.stages[name].gears
    stated = own is not None and "tip_relief" in own.iso6336.model_fields_set
    return f"{design.table(name)}.gears.iso6336.tip_relief_mm" if stated else "gears.iso6336.tip_relief_mm"
