"""Checks of bearings, shaft-hub joints, supports and manufacturing errors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from gearwright.base import MEMBERS, DesignError, Problem, apart, near
from gearwright.catalogue import Bearing, bearing, bearings
from gearwright.parts.shaft_fatigue import RELIABILITY_DEVIATES
from gearwright.parts.shafts import MODULES
from gearwright.spec.design import (
    LOCATES,
    NOTHING_GIVEN,
    BearingSeat,
    Design,
    Epicyclic,
    Given,
    Joint,
    PlanetBearing,
    given_values,
)

# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with bearings and joints: names that point nowhere, shafts that are not held.
# ----------------------------------------------------------------------------------------------------------------------


KINDS = {
    "deep-groove": "deep-groove ball",
    "cylindrical": "cylindrical roller",
    "taper": "taper roller",
    "four-point": "four-point contact ball",
}
"""Kind of a seat as written -> kind of bearing in the catalogue."""
WHOLE = 1e-6
"""How far from a reliability of the table one may be [-]."""
MOST_HOLLOW = 0.9
"""Largest bore over the diameter of any part of a shaft with bearings [-]."""
APART = 1e-6
"""Two bearings nearer than this stand in one place [m]."""


def mounting_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the bearings and the joints of a design.

    Args:
        design: As typed.
    """
    given = given_values(design).values
    for name, seat in design.bearings.items():
        yield from _seat(name, seat, design, given)
    for shaft in dict.fromkeys(seat.shaft for seat in design.bearings.values()):
        yield from _held_shaft(shaft, design)
    yield from _as_given(design, given)
    yield from _strength(design)
    for part, joint in design.joints.items():
        yield from _joint(part, joint, design)


def _seat(name: str, seat: BearingSeat, design: Design, given: Mapping[str, Given]) -> Iterator[Problem]:
    path = f"bearings.{name}"
    if seat.shaft not in design.shafts:
        yield Problem(f"{path}.shaft", f"there is no shaft {seat.shaft!r}; {near(seat.shaft, design.shafts)}")
    length = given.get(f"{seat.shaft}.length")
    if length is not None and seat.position > length.value:
        place, end = apart(seat.position, length.value, "length")
        message = f"{place} is outside the shaft; allowed: 0 to {end}, its length"
        yield Problem(f"{path}.position", message)
    yield from _tasks(path, seat)
    yield from _size(path, seat)
    yield from _around(path, seat, design, given)


def _around(path: str, seat: BearingSeat, design: Design, given: Mapping[str, Given]) -> Iterator[Problem]:
    """Find bearings that are given and larger than their shaft, and bores that leave their seats no wall."""
    layout, named = design.layout.get(seat.shaft, NOTHING_GIVEN), bearings().get(seat.designation or "")
    bore, key = (seat.bore, "bore") if named is None else (named.bore, "designation")
    if bore is None:
        return
    what = f"a seat of {1e3 * bore:g} mm" if named is None else f"{named.designation} with a bore of {1e3 * bore:g} mm"
    thickest = given.get(f"{seat.shaft}.diameter")
    if thickest is not None and not layout.as_given and bore > thickest.value + APART:
        message = (
            f"{what} on a shaft that layout.{seat.shaft}.diameter_mm makes {1e3 * thickest.value:g} mm at its thickest;"
            f" allowed: up to {1e3 * thickest.value:g} mm; give a smaller bore, or that diameter as much more"
        )
        yield Problem(f"{path}.{key}", message)
    if layout.bore is not None and layout.bore > MOST_HOLLOW * bore:
        message = (
            f"{1e3 * layout.bore:g} mm through {what} at {path}; allowed: up to {1e3 * MOST_HOLLOW * bore:.4g} mm;"
            " give a smaller bore, or a larger bearing"
        )
        yield Problem(f"layout.{seat.shaft}.bore", message)


def _tasks(path: str, seat: BearingSeat) -> Iterator[Problem]:
    """Find bearings that bear nothing, or what their kind cannot bear."""
    if seat.kind == "cylindrical" and seat.locates != "none":
        message = f'{seat.locates!r}: an NU bearing bears no axial force; use kind = "four-point" or "deep-groove"'
        yield Problem(f"{path}.locates", message)
    elif seat.kind == "taper" and seat.locates in ("none", "both"):
        message = f'{seat.locates!r}: a taper bearing locates one way; write locates = "first" or "second"'
        yield Problem(f"{path}.locates", message)
    elif not seat.radial and seat.locates == "none":
        yield Problem(path, 'it bears nothing; write locates = "both", or leave out radial = false')
    if seat.kind in ("taper", "cylindrical") and not seat.radial:
        yield Problem(f"{path}.radial", f"a {seat.kind} bearing always bears radial force; leave it out")


def _size(path: str, seat: BearingSeat) -> Iterator[Problem]:
    of_kind = {bearing.designation: bearing for bearing in bearings().values() if bearing.kind == KINDS[seat.kind]}
    if seat.designation is not None:
        yield from _designated(path, seat, bearings().get(seat.designation))
    elif seat.dynamic_rating is not None or seat.static_rating is not None:
        yield Problem(path, "a maker's rating belongs to one bearing; give its designation too")
    if seat.bore is not None and not any(abs(bearing.bore - seat.bore) < APART for bearing in of_kind.values()):
        closest = min(of_kind.values(), key=lambda bearing: abs(bearing.bore - (seat.bore or 0.0)))
        message = f"no {seat.kind} bearing has {1e3 * seat.bore:g} mm; the nearest has {1e3 * closest.bore:g} mm"
        yield Problem(f"{path}.bore", message)


def _designated(path: str, seat: BearingSeat, bearing: Bearing | None) -> Iterator[Problem]:
    if bearing is None:
        name = seat.designation or ""
        nearest = near(name, bearings())
        if not nearest.startswith("did"):
            nearest = "such are " + ", ".join(list(bearings())[:: len(bearings()) // 6])
        yield Problem(f"{path}.designation", f"{name!r} is not in the catalogue; {nearest}")
        return
    kind = next(word for word, meant in KINDS.items() if meant == bearing.kind)
    if kind != seat.kind:
        message = f"{bearing.designation} is a {bearing.kind} bearing, not {seat.kind}; write kind = {kind!r}"
        yield Problem(f"{path}.kind", message)
    if seat.bore is not None and abs(bearing.bore - seat.bore) > APART:
        message = f"{1e3 * seat.bore:g} mm, but {bearing.designation} has {1e3 * bearing.bore:g} mm; leave one out"
        yield Problem(f"{path}.bore", message)
    if seat.largest_outer_diameter is not None and bearing.outer_diameter > seat.largest_outer_diameter + APART:
        outer = 1e3 * bearing.outer_diameter
        message = f"{1e3 * seat.largest_outer_diameter:g} mm, but {bearing.designation} has {outer:g} mm"
        yield Problem(f"{path}.largest_outer_diameter", message)


def _held_shaft(shaft: str, design: Design) -> Iterator[Problem]:
    """Find shafts that do not rest on two bearings, or are held along their axis twice."""
    seats = {name: seat for name, seat in design.bearings.items() if seat.shaft == shaft}
    for (first_name, first), (second_name, second) in combinations(seats.items(), 2):
        if abs(first.position - second.position) < APART:
            message = f"{1e3 * second.position:g} mm, where {first_name} stands already; move one of them by its width"
            yield Problem(f"bearings.{second_name}.position", message)
    yield from _radial(shaft, seats)
    yield from _located(seats)
    layout = design.layout.get(shaft)
    ratio = design.shafting.bore_ratio if layout is None or layout.bore_ratio is None else layout.bore_ratio
    if ratio > MOST_HOLLOW:
        path = "shafting.bore_ratio" if layout is None or layout.bore_ratio is None else f"layout.{shaft}.bore_ratio"
        yield Problem(path, f"{ratio:g} leaves too thin a wall in the seats of bearings; give {MOST_HOLLOW:g} or less")
    for key in ("first_bearing", "second_bearing"):
        if layout is not None and getattr(layout, key) is not None:
            yield Problem(f"layout.{shaft}.{key}", "its bearings stand in [bearings] already; leave this out")


def _as_given(design: Design, given: Mapping[str, Given]) -> Iterator[Problem]:
    """Find shafts that are to be taken as given and of which too little is."""
    for shaft, layout in design.layout.items():
        if layout.as_given and f"{shaft}.diameter" not in given:
            yield Problem(f"layout.{shaft}.diameter_mm", "is required with as_given = true: how thick the shaft is")
        if layout.as_given and not any(seat.shaft == shaft for seat in design.bearings.values()):
            message = f"{shaft!r} has no bearings and is one cylinder in any case; give it [bearings], or leave it out"
            yield Problem(f"layout.{shaft}.as_given", message)


def _radial(shaft: str, seats: Mapping[str, BearingSeat]) -> Iterator[Problem]:
    radial = [name for name, seat in seats.items() if seat.radial]
    path = f"bearings.{radial[-1] if radial else next(iter(seats))}"
    if len(radial) < 2:
        message = (
            f"{len(radial)} radial bearing{'s' if len(radial) != 1 else ''} on {shaft!r}: it would fall; add another"
            f" [bearings.NAME] with shaft = {shaft!r}, so that there are two"
        )
        yield Problem(path, message)
    elif len(radial) > 2:
        free = [name for name in radial if seats[name].locates != "none" and seats[name].kind != "taper"]
        hint = f"write radial = false at {free[0]}" if free else f"leave {radial[-1]} out"
        message = f"{len(radial)} radial bearings on {shaft!r} ({', '.join(radial)}): statics knows two; {hint}"
        yield Problem(path, message)


def _located(seats: Mapping[str, BearingSeat]) -> Iterator[Problem]:
    """Find forces along the shaft that two bearings take, and taper bearings without their mate."""
    for sign, end in ((-1, "first"), (1, "second")):
        takers = [name for name, seat in seats.items() if sign in LOCATES[seat.locates]]
        for name in takers[1:]:
            message = f"{takers[0]} locates the shaft towards its {end} end already; let one of the two do it"
            yield Problem(f"bearings.{name}.locates", message)
    tapers = {name: seat.locates for name, seat in seats.items() if seat.kind == "taper"}
    for name, towards in tapers.items():
        if towards in ("first", "second") and len(set(tapers.values())) < 2:
            other = "second" if towards == "first" else "first"
            message = f'a taper bearing pushes its shaft away; add another that locates = "{other}"'
            yield Problem(f"bearings.{name}.locates", message)


def _strength(design: Design) -> Iterator[Problem]:
    """Find what the fatigue of shafts with bearings needs and does not have."""
    asked = design.shafting.reliability
    if design.bearings and not any(abs(asked - reliability) < WHOLE for reliability in RELIABILITY_DEVIATES):
        allowed = ", ".join(f"{reliability:g}" for reliability in RELIABILITY_DEVIATES)
        yield Problem("shafting.reliability", f"{asked:g} given; allowed: {allowed}")


def _joint(part: str, joint: Joint, design: Design) -> Iterator[Problem]:
    path, parts = f"joints.{part}", [*_seated_gears(design), *design.machines]
    if part not in parts:
        quoted = "; a name with a point stands in quotes" if "." in near(part, parts) else ""
        yield Problem(path, f"there is no gear or machine {part!r}; {near(part, parts)}{quoted}")
    if part in design.machines and joint.kind != "integral" and joint.hub_length is None:
        yield Problem(f"{path}.hub_length_mm", "is required for a machine: how long its hub is on the shaft")
    written = joint.model_fields_set
    only = {"module": ("spline",), "friction": ("press-fit",), "safety": ("press-fit",), "interference": ("press-fit",),
            "length": ("key", "spline", "press-fit"), "hub_length": ("key", "spline", "press-fit"),
            "pressure": ("key", "spline"), "form": ("key",)}  # fmt: skip
    for field, kinds in only.items():
        if field in written and joint.kind not in kinds:
            message = f"it says nothing about a joint of kind {joint.kind!r}, only about {' and '.join(kinds)}"
            yield Problem(f"{path}.{field}", f"{message}; leave it out")
    if joint.length is not None and joint.hub_length is not None and joint.length > joint.hub_length:
        message = f"{1e3 * joint.length:g} mm is longer than its hub; allowed: up to {1e3 * joint.hub_length:g} mm"
        yield Problem(f"{path}.length", message)
    if joint.module is not None and not any(abs(joint.module - module) < APART for module in MODULES):
        closest = min(MODULES, key=lambda module: abs(module - (joint.module or 0.0)))
        message = f"{1e3 * joint.module:g} mm is not a module of DIN 5480; the nearest is {1e3 * closest:g} mm"
        yield Problem(f"{path}.module", message)


def _seated_gears(design: Design) -> Iterator[str]:
    """Yield every gear that a shaft can carry."""
    for name, pair in design.pairs.items():
        for side in ("pinion", "wheel"):
            if "." not in "".join(getattr(pair, side)):
                yield f"{name}.{side}"
    yield from (f"{name}.sun" for name in design.planetaries)
    yield from (f"{name}.{sun}" for name, epicyclic in design.epicyclics.items() for sun in epicyclic.suns)


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with bearings: some that nothing reads, unknown designations, halves of a rating, places.
# ----------------------------------------------------------------------------------------------------------------------


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
            yield from _held_planets(
                path, epicyclic, [step for step in epicyclic.planets if epicyclic.body(step) == body]
            )
        yield from _without_place(path, epicyclic)


def _on_pin(path: str, where: str, pin: float | None, asked: PlanetBearing) -> Iterator[Problem]:
    """Yield a bearing that is given and does not go over a pin that is; a thinner pin may carry a sleeve."""
    fitted = bearings().get(asked.designation or "")
    if pin is not None and fitted is not None and pin > fitted.bore + APART:
        message = (
            f"{fitted.designation} has a bore of {1e3 * fitted.bore:g} mm, and {path}.pin_diameter_mm is {1e3 * pin:g};"
            f" allowed: a pin of up to {1e3 * fitted.bore:g} mm; give a larger bearing, or leave the pin's diameter out"
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


def _held_planets(path: str, epicyclic: Epicyclic, steps: Sequence[str]) -> Iterator[Problem]:
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


# ----------------------------------------------------------------------------------------------------------------------
# What can be wrong with supports and errors: names that point nowhere.
# ----------------------------------------------------------------------------------------------------------------------


def motion_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with a design's supports and errors.

    Args:
        design: As typed.
    """
    for shaft in design.supports:
        if shaft not in design.shafts:
            yield Problem(f"supports.{shaft}", f"there is no shaft {shaft!r}; {near(shaft, design.shafts)}")
    yield from _errors(design)


def _errors(design: Design) -> Iterator[Problem]:
    gears, planets = set(_central_gears(design)), set(_planets(design))
    for name, part in design.errors.items():
        path, known = f"errors.{name}", gears | planets | set(design.shafts)
        if name not in known:
            quoted = "" if "." not in near(name, known) else "; a name with a point stands in quotes"
            yield Problem(path, f"there is no such gear, shaft or planet; {near(name, known)}{quoted}")
        elif name not in planets and (part.pin_radial or part.pin_tangential):
            yield Problem(path, f"only planets have pins; {near(name, planets)}")
        elif name in design.shafts and (part.tooth_thickness or part.clocking):
            yield Problem(path, f"tooth_thickness and clocking belong to a gear; {near(name, gears)}")


def _central_gears(design: Design) -> Iterator[str]:
    """Yield the name of every gear body but planets."""
    for name, pair in design.pairs.items():
        for side in ("pinion", "wheel"):
            shafts = [pair.pinion, pair.wheel][side == "wheel"]
            names = [shafts] if isinstance(shafts, str) else shafts
            if len(names) > 1:
                yield from (f"{name}.{side}.{shaft}" for shaft in names)
            elif "." not in "".join(names):
                yield f"{name}.{side}"
    for name in design.planetaries:
        yield from (f"{name}.sun", f"{name}.ring")
    yield from (f"{name}.{gear}" for name, epicyclic in design.epicyclics.items() for gear in epicyclic.centrals)


def _planets(design: Design) -> Iterator[str]:
    for name, stage in design.planetaries.items():
        yield from (f"{name}.planet-{k + 1}" for k in range(stage.planets))
    for name, epicyclic in design.epicyclics.items():
        bodies = dict.fromkeys(map(epicyclic.body, epicyclic.planets))
        yield from (f"{name}.{body}-{k + 1}" for body in bodies for k in range(epicyclic.sets))
