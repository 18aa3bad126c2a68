"""What can be wrong with compound epicyclic sets: names, members that nothing moves, circles, what does not fit."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem, near
from gearwright.spec.bounds import NAME_RULE, is_name
from gearwright.spec.checks.compound_fit import fit_problems
from gearwright.spec.design import GROUND, Design, Epicyclic

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
