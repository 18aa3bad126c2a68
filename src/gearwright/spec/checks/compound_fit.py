"""Whether the planets of a compound set fit: pins that one distance serves, room beside each other, whole teeth."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations, product

from gearwright.errors import DesignError, Problem
from gearwright.parts.gears import FEWEST_TEETH
from gearwright.parts.planetary import (
    CompoundSet,
    can_assemble,
    pin_angles,
    pin_radii,
    reaches,
    touching,
)
from gearwright.parts.planetary.compound import CLOSES
from gearwright.spec.design import Design, Epicyclic, compound_shifts, relative_modules

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
        yield Problem(f"{path}.sets", _unassembled(compound, modules))


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


def _unassembled(compound: CompoundSet, modules: Mapping[str, float]) -> str:
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
