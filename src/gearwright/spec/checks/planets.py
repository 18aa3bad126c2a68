"""What can be wrong with planetary sets: members that are one shaft, given teeth that do not go together."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from gearwright.errors import Problem, near
from gearwright.parts.gears import FEWEST_TEETH
from gearwright.parts.planetary import ADDENDUMS, assembles, most_planets, neighbours_clear
from gearwright.spec.design import GROUND, Design, Planetary

MOST_PLANETS = 12
"""Largest number of planets that a design may ask for."""


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
        yield from unclosed or _together(path, planetary)
        yield from _few_teeth(path, planetary, design.teeth.planet_minimum)


def given_set(planetary: Planetary) -> tuple[int, int, int] | None:
    """Return the teeth of sun, planet and ring where two of them are given, so that the third follows.

    Args:
        planetary: As in the design.
    """
    sun, planet, ring = planetary.sun_teeth, planetary.planet_teeth, planetary.ring_teeth
    if planet is None and sun is not None and ring is not None:
        planet = (ring - sun) // 2
    if sun is None and planet is not None and ring is not None:
        sun = ring - 2 * planet
    return None if sun is None or planet is None else (sun, planet, sun + 2 * planet)


def _unclosed(path: str, planetary: Planetary) -> Iterator[Problem]:
    sun, planet, ring = planetary.sun_teeth, planetary.planet_teeth, planetary.ring_teeth
    if sun is not None and planet is not None and ring is not None and sun + 2 * planet != ring:
        yield Problem(
            f"{path}.ring_teeth",
            f"{ring} does not close: z_s + 2 z_p = {sun} + 2·{planet} = {sun + 2 * planet}; give that, or leave it out",
        )
    elif sun is not None and ring is not None and (ring <= sun or (ring - sun) % 2):
        message = f"{ring} leaves no planets beside a sun of {sun}: z_r − z_s = 2 z_p is even and above 0"
        yield Problem(f"{path}.ring_teeth", message)
    elif planet is not None and ring is not None and ring <= 2 * planet:
        yield Problem(f"{path}.ring_teeth", f"{ring} leaves no sun inside planets of {planet}: z_r = z_s + 2 z_p")


def _together(path: str, planetary: Planetary) -> Iterator[Problem]:
    """Find planets that stand into their neighbours, or whose teeth do not meet those of sun and ring."""
    teeth, planets = given_set(planetary), planetary.planets_given
    if teeth is None or planets is None:
        return
    sun, planet, ring = teeth
    if not neighbours_clear(sun, planet, planets):
        yield Problem(
            f"{path}.planets",
            f"{planets} planets of {planet} teeth stand into each other: (z_s + z_p) sin(π/N) must be above"
            f" z_p + {ADDENDUMS} = {planet + ADDENDUMS}; give {most_planets(sun, planet)} or fewer, or smaller planets",
        )
    elif not assembles(sun, ring, planets):
        counts = range(1, min(MOST_PLANETS, most_planets(sun, planet)) + 1)
        would = " or ".join(str(count) for count in counts if count > 1 and assembles(sun, ring, count))
        hint = f"give {would} planets, or other teeth" if would else "give other teeth"
        yield Problem(
            f"{path}.planets",
            f"{planets} planets cannot be assembled: z_s + z_r = {sun} + {ring} = {sun + ring} is no multiple of"
            f" {planets}; {hint}",
        )


def _few_teeth(path: str, planetary: Planetary, planet_minimum: int) -> Iterator[Problem]:
    sun, planet = planetary.sun_teeth, planetary.planet_teeth
    if sun is not None and sun < FEWEST_TEETH:
        yield Problem(
            f"{path}.sun_teeth", f"{sun} is below {FEWEST_TEETH}, where the table of Lewis form factors begins"
        )
    if planet is not None and planet < max(planet_minimum, FEWEST_TEETH):
        yield Problem(
            f"{path}.planet_teeth",
            f"{planet} is below {max(planet_minimum, FEWEST_TEETH)}, the least of teeth.planet_minimum and of the table"
            " of Lewis form factors",
        )
