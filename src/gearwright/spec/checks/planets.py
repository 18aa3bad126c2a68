"""What can be wrong with planetary sets: members that are one shaft, given teeth that do not go together."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from gearwright.errors import DesignError, Problem, near
from gearwright.identity import Role
from gearwright.parts.planetary import assembles, most_planets, nearest_positions, tip_gap
from gearwright.spec.design import GROUND, SET_ROLES, Design, Planetary, stage_shifts

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
