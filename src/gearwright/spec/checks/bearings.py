"""What can be wrong with bearings: some that nothing reads, unknown designations, halves of a rating, places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.catalogue import bearing, bearings
from gearwright.errors import DesignError, Problem
from gearwright.identity import MEMBERS
from gearwright.spec.checks.mounting import APART
from gearwright.spec.design import Design, Epicyclic, PlanetBearing
from gearwright.units import apart


def bearing_problems(design: Design) -> Iterator[Problem]:
    """Yield bearings without effect, shafts whose bearings stand in two places, and bearings of planets that are not.

    Args:
        design: As typed.
    """
    moves = design.dynamics.fidelity == "translational"
    for name, planetary in design.planetaries.items():
        path = f"planetaries.{name}.bearings"
        if "bearings" in planetary.model_fields_set and not moves:
            message = (
                'has no effect on sets in rigid bearings; write dynamics.fidelity = "translational", or leave it out'
            )
            yield Problem(path, message)
        for member in MEMBERS:
            shaft = getattr(planetary, member)
            if moves and shaft in design.supports:
                yield Problem(f"supports.{shaft}", f"{name}.{member} has bearings in {path} too; keep one of the two")
    yield from _planet_bearings(design)


def _planet_bearings(design: Design) -> Iterator[Problem]:
    for name, stage in design.planetaries.items():
        if stage.planet_bearing is not None:
            path = f"planetaries.{name}"
            yield from _planet_bearing(f"{path}.planet_bearing", stage.planet_bearing)
            yield from _on_pin(path, f"{path}.planet_bearing", stage.pin_diameter, stage.planet_bearing)
    for name, epicyclic in design.epicyclics.items():
        path = f"epicyclics.{name}"
        for planet, gear in epicyclic.planets.items():
            if gear.bearing is not None and gear.bearing.designation is None:
                message = "is not chosen in compound sets; give the designation of a bearing of the catalogue"
                yield Problem(f"{path}.planets.{planet}.bearing", message)
            elif gear.bearing is not None:
                yield from _planet_bearing(f"{path}.planets.{planet}.bearing", gear.bearing)
                yield from _on_pin(path, f"{path}.planets.{planet}.bearing", epicyclic.pin_diameter, gear.bearing)
        for body in dict.fromkeys(epicyclic.body(planet) for planet in epicyclic.planets):
            yield from _held(path, epicyclic, [step for step in epicyclic.planets if epicyclic.body(step) == body])
        yield from _without_place(path, epicyclic)


def _on_pin(path: str, where: str, pin: float | None, asked: PlanetBearing) -> Iterator[Problem]:
    """Yield a bearing that is given beside a pin of another diameter."""
    fitted = bearings().get(asked.designation or "")
    if pin is not None and fitted is not None and abs(fitted.bore - pin) > APART:
        message = (
            f"{fitted.designation} has a bore of {1e3 * fitted.bore:g} mm, and {path}.pin_diameter_mm is {1e3 * pin:g};"
            " allowed: the pin's diameter; give a bearing of that bore, or leave the pin's diameter out"
        )
        yield Problem(f"{where}.designation", message)


_OF_FILMS = ("clearance", "least_film", "oil_temperature")
"""Keys of a plain bearing that are left out unless given."""
_BY_KIND = ("diameter", "width", "roller_diameter", "clearance", "least_film", "oil_temperature")
"""Keys that a bearing which is named has from the catalogue, or not at all."""


def _idle_keys(path: str, asked: PlanetBearing) -> Iterator[Problem]:
    """Yield keys without effect on a planet bearing of its kind."""
    given = [key for key in _BY_KIND if getattr(asked, key) is not None]
    if asked.designation is not None:
        if not asked.is_fitted:
            why = f"{asked.designation} is of the catalogue, and the kind {asked.kind} is made; keep one of the two"
            yield Problem(f"{path}.designation", why)
        yield from (Problem(f"{path}.{key}", "has no effect on a bearing of the catalogue") for key in given)
        return
    if asked.dynamic_rating is not None:
        yield Problem(path, "ratings of a maker belong to a designation; give that, too, or leave them out")
    if asked.spacing is not None:
        yield Problem(f"{path}.spacing", "has no effect without a designation; leave it out, or give that")
    if asked.kind == "plain" and asked.side_by_side > 1:
        yield Problem(f"{path}.side_by_side", "a film stands alone; leave it out, or take rolling bearings")
    idle = {"plain": ("roller_diameter",), "cylindrical": ("width", "roller_diameter", *_OF_FILMS)}
    for key in given:
        if key in idle.get(asked.kind, _OF_FILMS):
            yield Problem(f"{path}.{key}", f"has no effect on the kind {asked.kind}; leave it out")


def _planet_bearing(path: str, asked: PlanetBearing) -> Iterator[Problem]:
    if (asked.dynamic_rating is None) != (asked.static_rating is None):
        yield Problem(path, "one rating without the other; give dynamic_rating_kn and static_rating_kn, or neither")
    yield from _idle_keys(path, asked)
    if asked.oil_temperature is not None and asked.oil_temperature >= asked.largest_temperature:
        enters, leaves = apart(asked.oil_temperature, asked.largest_temperature, "temperature")
        message = f"oil enters at {enters}, and may leave at {leaves} at most"
        yield Problem(f"{path}.oil_temperature", f"{message}; give cooler oil, or a higher largest_temperature")
    if asked.designation is None:
        return
    try:
        width = bearing(asked.designation).width
    except DesignError as error:
        yield from (Problem(f"{path}.designation", problem.message) for problem in error.problems)
        return
    if asked.spacing is not None and asked.side_by_side == 1:
        yield Problem(f"{path}.spacing", "has no effect on one bearing; leave it out, or give side_by_side")
    elif asked.spacing is not None and asked.spacing < width:
        message = (
            f"{1e3 * asked.spacing:.4g} mm puts bearings of {1e3 * width:g} mm into each other; allowed: that and more"
        )
        yield Problem(f"{path}.spacing", message)


def _held(path: str, epicyclic: Epicyclic, steps: Sequence[str]) -> Iterator[Problem]:
    """Find bodies with places of some steps only, and such that their bearings cannot hold by statics."""
    places = {step: epicyclic.planets[step].place for step in steps}
    unplaced = [step for step, place in places.items() if place is None]
    fitted = {step: asked for step in steps if (asked := epicyclic.planets[step].bearing) is not None}
    if len(fitted) > 1 and unplaced:
        message = f"{' and '.join(fitted)} hold one planet by a bearing each: what each bears follows from the places"
        yield Problem(f"{path}.planets.{unplaced[0]}.place", f"{message} of its steps; give place_mm of every step")
    elif 0 < len(unplaced) < len(steps):
        message = "the other steps of this planet have a place; give place_mm of every step, or of none"
        yield Problem(f"{path}.planets.{unplaced[0]}.place", message)
    mates = {gear for pair in epicyclic.mesh_pairs if set(pair) & set(steps) for gear in pair}
    apart = {place for gear in mates if (place := epicyclic.toothed[gear].place) is not None}
    for step, asked in fitted.items():
        if len(fitted) == asked.side_by_side == 1 and not unplaced and len(apart) > 1:
            message = "one bearing cannot hold a planet whose meshes lie in several planes, which tilt it"
            fix = "give side_by_side = 2 with a spacing_mm, or a bearing in another step, too"
            yield Problem(f"{path}.planets.{step}.bearing", f"{message}; {fix}")


def _without_place(path: str, epicyclic: Epicyclic) -> Iterator[Problem]:
    """Find suns and rings with a place beside planets that have none."""
    for table, gears in (("suns", epicyclic.suns), ("rings", epicyclic.rings)):
        for name, gear in gears.items():
            mates = {mate for pair in epicyclic.mesh_pairs if name in pair for mate in pair if mate != name}
            if gear.place is not None and all(epicyclic.planets[mate].place is None for mate in mates):
                message = (
                    f"has no effect while {' and '.join(sorted(mates))} have no place; give theirs, or leave it out"
                )
                yield Problem(f"{path}.{table}.{name}.place", message)
