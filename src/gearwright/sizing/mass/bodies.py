"""Masses and bodies of gears, shafts and carriers as manufactured, and masses of their bearings."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from gearwright.base import Kind, PartId, Problem, Role, refuse
from gearwright.catalogue import (
    SIMILARITY,
    STEEL_DENSITY,
    STEEL_SHARE,
    bored_mass,
    key_for_shaft,
    loaded_mass,
    rating_for,
)
from gearwright.parts.bearings import BearingKind
from gearwright.parts.bevel_geometry import WEB, BevelPair, bevel_dishes, bevel_volume, lightened_web
from gearwright.parts.carriers import BESIDE, BRIDGE
from gearwright.parts.gears import (
    Blank,
    SeatHub,
    TransverseTooth,
    blank_volume,
    face_crown,
    face_way,
    outline_area,
    revolved_volume,
)
from gearwright.sizing.bearing_seats import PlanetBody, Seat, bearing_seats, planet_bodies, seat_forces
from gearwright.sizing.casing import ring_seats
from gearwright.sizing.gear_geometry import (
    PLANET_HUB,
    blank_by_rules,
    cylindrical_gear,
    external_tooth,
    ring_radii,
    turned_out,
)
from gearwright.sizing.mass.record import CROWDED, MassItem
from gearwright.sizing.places import BOSS, IN_LINE, Run, along_body, bells, planets_span, plates_of, runs
from gearwright.sizing.rating import THINNEST_RIM, TOOTH_HEIGHT, geometry as standard_teeth, rating_of
from gearwright.sizing.result import Body, GearSizing, Sizing
from gearwright.sizing.shaft_results import CarrierSizing
from gearwright.spec import GROUND
from gearwright.spec.design import BUILT, PRELIMINARY, Pair

BEARING_SURE = 0.30
"""One standard deviation of a bearing that is not chosen, over its value [-]: its series, and what its thrust adds."""

# ----------------------------------------------------------------------------------------------------------------------
# What every bearing seat bears in the case that speaks for the design: load, and the rating that its life needs.
# ----------------------------------------------------------------------------------------------------------------------


class SeatDuty(NamedTuple):
    """A seat, its load and the rating that it needs."""

    seat: Seat
    load: float
    """Radial, at rated load [N]."""
    rating: float
    """C for the life that the design asks, mean load included [N]."""


def seat_duties(sizing: Sizing) -> Iterator[SeatDuty]:
    """Yield every seat of shafts and planets with its duty.

    Args:
        sizing: As sized.
    """
    flow, service = sizing.reference, sizing.design.service
    speeds = {**flow.speeds, GROUND: 0.0}
    torques = np.array([flow.meshes[mesh.name].torques[0] / mesh.count for mesh in sizing.train.meshes])
    for seat in bearing_seats(sizing):
        radial, _ = seat_forces(seat, torques, np.asarray(speeds[seat.carrier]))
        load, turning = float(radial), speeds[seat.nodes[0]] - speeds[seat.nodes[1]]
        rating = rating_for(load * service.mean_load, service.bearing_life, turning)
        yield SeatDuty(seat, load, rating)


# ----------------------------------------------------------------------------------------------------------------------
# What planets turn on: the bearing that the design names, or one that its load asks for, in the room that there is.
# ----------------------------------------------------------------------------------------------------------------------


_SHARE = STEEL_SHARE[BearingKind.CYLINDRICAL]
_LEAST = 0.08
"""Least section of a bearing, (D − d)/2 over d [-]: light needle and cylindrical roller bearings, an estimate."""
_RIM = 1.2 * 2.25 + 1.25
"""Wall of a planet from its pitch circle to its bearing, over the module, at least [-]: as rings have it."""


class PlanetBore(NamedTuple):
    """What a planet turns on."""

    body: str
    """Name of the planet's bearing."""
    bearing_diameter: float
    """Outside of the bearing, bore of the planet [m]."""
    mass: float
    """Of all bearings in one planet [kg]."""
    equal: int
    """Equal planets [-]."""
    named: bool
    """Whether the design names it."""
    crowded: bool
    """Whether the load asks for more than the room between pin and rim holds."""


def planet_bores(sizing: Sizing, duties: Sequence[SeatDuty]) -> dict[str, PlanetBore]:
    """Return planet gear -> what it turns on.

    Args:
        sizing: As sized.
        duties: From `seat_duties`.
    """
    ratings: dict[str, float] = {}
    for duty in duties:
        stage = duty.seat.part.name
        ratings[stage] = max(ratings.get(stage, 0.0), duty.rating)
    pins = {carrier.stage: carrier.pin_diameter for carrier in sizing.carriers}
    bores: dict[str, PlanetBore] = {}
    for body in planet_bodies(sizing.design, sizing.gears):
        bore = _named(body) or _estimated_bore(body, pins[body.stage], ratings)
        bores |= {step.name: bore for step in body.steps}
    return bores


def named_bores(sizing: Sizing) -> dict[str, PlanetBore]:
    """Return planet gear -> what it turns on, of the planets whose bearing the design names.

    Args:
        sizing: As sized.
    """
    bodies = [(body, _named(body)) for body in planet_bodies(sizing.design, sizing.gears)]
    return {step.name: bore for body, bore in bodies if bore is not None for step in body.steps}


def _named(body: PlanetBody) -> PlanetBore | None:
    """Return the bearings that sizing took for a planet, or that the design names; None where it asks for none."""
    taken = [step.runs_on for step in body.steps if step.runs_on is not None]
    if not taken:
        return None
    outside = max(runs_on.outer_diameter for runs_on in taken)
    return PlanetBore(
        str(body.part), outside, sum(runs_on.mass for runs_on in taken), body.steps[0].bodies, named=True, crowded=False
    )


def _estimated_bore(body: PlanetBody, pin: float, ratings: Mapping[str, float]) -> PlanetBore:
    """Return a bearing as heavy as its load asks, as wide as the planet, in the room between pin and rim."""
    steel = _SHARE * math.pi / 4.0 * body.width * STEEL_DENSITY
    wanted = math.sqrt(pin**2 + loaded_mass(ratings.get(body.stage, 0.0)) / steel)
    outside = max(min(max(wanted, pin * (1.0 + 2.0 * _LEAST)), _room(body)), pin)
    mass = steel * (outside**2 - pin**2)
    return PlanetBore(str(body.part), outside, mass, body.steps[0].bodies, named=False, crowded=wanted > outside)


def _room(body: PlanetBody) -> float:
    """Return the diameter inside the rim of a planet, of its smallest step [m]."""
    return min(step.pitch_diameter - 2.0 * _RIM * step.module for step in body.steps)


# ----------------------------------------------------------------------------------------------------------------------
# Bearings: chosen ones by the catalogue, the others by load and shaft.
# ----------------------------------------------------------------------------------------------------------------------


ENDS = 2
"""Bearings of a shaft whose own meshes load none, where a machine or a carrier sits on it [-]."""
_CHOSEN = 0.05
"""One standard deviation of a catalogue's mass, over its value: the steel's share of the room [-]."""
_BY_SIZE = "m = max((C/c)^1.5, k d³)"


def bearing_items(sizing: Sizing, duties: Sequence[SeatDuty], bores: Mapping[str, PlanetBore]) -> Iterator[MassItem]:
    """Yield every bearing of shafts and planets.

    Args:
        sizing: As sized.
        duties: From `seat_duties`.
        bores: From `planet_bores`.
    """
    for chosen in sizing.bearings:
        yield MassItem(
            chosen.name,
            "bearings",
            1,
            chosen.bearing.mass,
            _CHOSEN,
            chosen.bearing.designation,
            "catalogue of bearings",
        )
    yield from _estimated(sizing, duties)
    if sizing.design.housing.own:  # else what stands around the gearbox holds its shafts, too
        yield from _ends(sizing, duties)
    for bore in dict.fromkeys(bores.values()):
        formula = "catalogue" if bore.named else CROWDED if bore.crowded else "m = (C/c)^1.5 by load and life"
        source, sure = ("catalogue of bearings", _CHOSEN) if bore.named else (SIMILARITY, BEARING_SURE)
        yield MassItem(bore.body, "bearings", bore.equal, bore.mass, sure, formula, source)


def _estimated(sizing: Sizing, duties: Sequence[SeatDuty]) -> Iterator[MassItem]:
    """Yield the bearings of shafts that meshes load and the design leaves open."""
    built = {bearing.name for bearing in sizing.bearings}
    for seat, _, rating in duties:
        if GROUND in seat.nodes and seat.name not in built and not _in_planet(seat.part):
            mass = max(loaded_mass(rating), bored_mass(seat.bore))
            yield MassItem(seat.name, "bearings", seat.count, mass, BEARING_SURE, _BY_SIZE, SIMILARITY)


def _in_planet(part: PartId) -> bool:
    return part.kind is Kind.BEARING and part.role is not None


def _ends(sizing: Sizing, duties: Sequence[SeatDuty]) -> Iterator[MassItem]:
    """Yield what holds shafts that only carry torque: those with a machine or a carrier; suns between float."""
    loaded = {node for duty in duties for node in duty.seat.nodes if not _in_planet(duty.seat.part)}
    held = {machine.shaft for machine in sizing.design.machines.values()}
    held |= {carrier.shaft for carrier in sizing.carriers}
    for shaft in sizing.shafts:
        if shaft.name in held - loaded:
            yield MassItem(
                f"{shaft.name} bearings",
                "bearings",
                ENDS,
                bored_mass(shaft.diameter),
                BEARING_SURE,
                "m = k d³",
                SIMILARITY,
            )


# ----------------------------------------------------------------------------------------------------------------------
# The bodies of gears as they are made: teeth of the true tool over a rim, a web, a hub and the bore of their seat.
#
# What weighs them and what draws them take them from here.
# ----------------------------------------------------------------------------------------------------------------------


HUBS = {"": 1.25, "integral": 1.0, "spline": 1.3, "key": 1.8, "press-fit": 1.8}
"""Joint -> outside of the hub over the shaft's diameter [-]; estimates within what machine-element tables give for
steel. Nothing said: flanged or splined."""
THINNEST_WEB = 0.05
"""Web of a lightened wheel over its width, at least [-]: the least that a design may ask for."""


class Seats(NamedTuple):
    """What gears sit on."""

    bores: Mapping[str, PlanetBore]
    """Planet -> what it turns on."""
    shafts: Mapping[str, float]
    """Shaft -> diameter of its first sizing [m]."""


def seats_of(sizing: Sizing) -> Seats:
    """Return what gears sit on, planets on what their loads ask where the design names nothing.

    Args:
        sizing: As sized.
    """
    return Seats(planet_bores(sizing, tuple(seat_duties(sizing))), shaft_diameters(sizing))


def shaft_diameters(sizing: Sizing) -> dict[str, float]:
    """Return shaft -> diameter of its first sizing [m].

    Args:
        sizing: As sized.
    """
    return {shaft.name: shaft.diameter for shaft in sizing.shafts}


def tooth_of(sizing: Sizing, gear: GearSizing) -> TransverseTooth:
    """Return what the outline of a cylindrical gear follows from; a ring's shaper has the teeth of its smallest mate.

    Args:
        sizing: As sized.
        gear: One of its gears.
    """
    tooth = external_tooth(sizing.design, gear)
    if gear.name not in sizing.train.internal:
        return tooth
    mates = [mesh.gears[0] for mesh in sizing.train.meshes if mesh.gears[1] == gear.name]
    return tooth._replace(side=-1, shaper=min(sizing.teeth[mate] for mate in mates))


def bevel_cones(sizing: Sizing, stage: str) -> BevelPair:
    """Return the cones of a bevel pair; its gears are sized at their mean cones.

    Args:
        sizing: What was sized.
        stage: The pair.
    """
    mesh = next(mesh for mesh in sizing.train.meshes if mesh.stage == stage)
    gears = {gear.name: gear for gear in sizing.gears}
    pinion, wheel = (gears[name] for name in mesh.gears)
    rating = rating_of(sizing.design, stage, sizing.teeth)
    return standard_teeth.bevel_pair((pinion.teeth, wheel.teeth), pinion.module, pinion.face_width, rating)


def gear_volume(sizing: Sizing, gear: GearSizing, seats: Seats) -> float:
    """Return what one gear fills, teeth and body [m³].

    Args:
        sizing: As sized.
        gear: Of it.
        seats: What gears sit on.
    """
    kind = kind_of(sizing, gear)
    if kind == "bevel":
        pair, side = bevel_cones(sizing, gear.stage), 0 if gear.role is Role.PINION else 1
        bore = gear_blank(sizing, gear, seats).bore_radius
        web, hub = bevel_web(sizing, gear, bore), bevel_hub(sizing, gear, bore)
        return bevel_volume(pair, side, bore, web, hub, dish=bevel_dish(sizing, gear))
    if kind == "face" and gear.role is Role.WHEEL:
        return _face_volume(sizing, gear, gear_blank(sizing, gear, seats).bore_radius)
    tooth = tooth_of(sizing, gear)
    crown = gear.teeth * outline_area(tooth) * gear.face_width
    if gear.rim:
        wall = ring_outside(sizing, gear) ** 2 - tooth.root_radius**2
        return crown + math.pi * wall * gear.face_width
    return crown + blank_volume(gear_blank(sizing, gear, seats))


def _face_volume(sizing: Sizing, gear: GearSizing, bore: float) -> float:
    """Return what the wheel of a face gear fills [m³]."""
    pinion = pinion_of(sizing, gear)
    tooth, width = tooth_of(sizing, pinion), pinion.face_width
    way, foot = face_way(tooth, gear.teeth, width=width, bore=bore), tooth.rack.dedendum * tooth.module
    body = revolved_volume([*way, (foot, way[-1][1]), (foot, way[0][1])])
    return face_crown(tooth, gear.teeth, width) + body


def pinion_of(sizing: Sizing, wheel: GearSizing) -> GearSizing:
    """Return the pinion of a wheel of a pair, which decides the teeth of a face gear.

    Args:
        sizing: As sized.
        wheel: Of the pair.
    """
    return next(gear for gear in sizing.gears if gear.stage == wheel.stage and gear.role is Role.PINION)


def ring_outside(sizing: Sizing, gear: GearSizing) -> float:
    """Return the outer radius of a ring [m].

    Args:
        sizing: As sized.
        gear: A ring.
    """
    return ring_radii(sizing.design, gear)[1]


def bevel_web(sizing: Sizing, gear: GearSizing, bore: float) -> float:
    """Return the web of a bevel gear over its face width, by which a lightened wheel weighs its share [-].

    Args:
        sizing: As sized.
        gear: A bevel gear.
        bore: Radius of its bore [m].
    """
    share = sizing.design.rules(gear.stage).web_ratio
    if gear.role is Role.PINION or share >= 1.0:
        return WEB
    return lightened_web(bevel_cones(sizing, gear.stage), 1, bore, share, bevel_hub(sizing, gear, bore))


def bevel_dish(sizing: Sizing, gear: GearSizing) -> float:
    """Return by how much the web of a bevel wheel leans away from its apex towards the hub [-]; 0 of a pinion.

    Args:
        sizing: As sized.
        gear: A bevel gear.
    """
    return 0.0 if gear.role is Role.PINION else sizing.design.rules(gear.stage).web_dish


def bevel_hub(sizing: Sizing, gear: GearSizing, bore: float) -> SeatHub | None:
    """Return the hub of a bevel gear over its seat on a built shaft; None where none is sized, or of one piece with it.

    Args:
        sizing: As sized.
        gear: A bevel gear.
        bore: Radius of its bore [m].
    """
    joint = next((joint for joint in sizing.joints if joint.part == gear.name and joint.kind != "integral"), None)
    if joint is None:
        return None
    steps = next(built.steps for built in sizing.built_shafts if built.name == joint.shaft)
    edges = [edge for step in steps if step.seat == gear.name for edge in (step.start, step.end)]
    if not edges:
        return None
    pair, cut = sizing.design.pairs[gear.stage], joint.diameter
    if joint.kind == "key":
        cut += 2.0 * key_for_shaft(joint.diameter).section.hub_depth
    away = -1.0 if (pair.pinion_apex if gear.role is Role.PINION else pair.wheel_apex) == "second" else 1.0
    low, high = sorted(away * (edge - joint.position) for edge in (min(edges), max(edges)))
    return SeatHub(low, high, max(BOSS * cut / 2.0, bore))


def gear_blanks(sizing: Sizing) -> dict[str, Blank]:
    """Return external gear -> the body under its teeth as it is weighed.

    Args:
        sizing: As sized.
    """
    seats = seats_of(sizing)
    return {gear.name: gear_blank(sizing, gear, seats) for gear in sizing.gears if not gear.rim}


def gear_blank(sizing: Sizing, gear: GearSizing, seats: Seats) -> Blank:
    """Return the body of an external gear; a wheel that weighs a share of its disc has a web for it.

    Args:
        sizing: As sized.
        gear: Of it.
        seats: What gears sit on.
    """
    teeth, rules = cylindrical_gear(sizing.design, gear), sizing.design.rules(gear.stage)
    kind = kind_of(sizing, gear)
    blank = blank_by_rules(gear, rules, teeth.root_radius, seat=_seat(sizing, gear, seats))
    joint = sizing.design.joints.get(gear.name)
    if joint is not None and joint.kind == "integral":  # one piece with its shaft, as its sheet has it
        return blank._replace(web_width=blank.width)
    if gear.role is not Role.WHEEL:
        return turned_out(blank)
    blank = blank._replace(holes=rules.web_holes if kind == "cylindrical" else 0)
    thinnest = THINNEST_RIM * TOOTH_HEIGHT * gear.module
    blank = _lightened(blank, rules.web_ratio, thinnest) if rules.web_ratio < 1.0 else turned_out(blank)
    height = max(blank.rim_radius - blank.hub_radius, 0.0)
    return blank._replace(dish=rules.web_dish * height if kind == "cylindrical" else 0.0)


def _seat(sizing: Sizing, gear: GearSizing, seats: Seats) -> tuple[float, float]:
    """Return bore and outside of a gear's hub, on a built shaft of the steps under the gear [m]."""
    if gear.name in seats.bores:
        outside = seats.bores[gear.name].bearing_diameter
        return outside, PLANET_HUB * outside
    sized = max((seats.shafts.get(shaft, 0.0) for shaft in gear.shafts), default=0.0)
    joint = sizing.design.joints.get(gear.name)
    wall = (HUBS["" if joint is None else joint.kind] - 1.0) * sized
    bore = max((_under(sizing, gear, shaft) for shaft in gear.shafts), default=0.0) or sized
    return bore, bore + wall


def _under(sizing: Sizing, gear: GearSizing, shaft: str) -> float:
    """Return the largest diameter of a built shaft under a gear; 0 of another one [m]."""
    steps = next((built.steps for built in sizing.built_shafts if built.name == shaft), ())
    if not steps:
        return 0.0
    place, half = sizing.arrangement.plans[shaft].places[gear.name], gear.face_width / 2.0
    return max((step.diameter for step in steps if step.start < place + half and place - half < step.end), default=0.0)


def kind_of(sizing: Sizing, gear: GearSizing) -> str:
    """Return the kind of a gear's pair, such as ``bevel``; gears of sets are ``cylindrical``.

    Args:
        sizing: As sized.
        gear: Of it.
    """
    rules = sizing.design.stages[gear.stage]
    return rules.kind if isinstance(rules, Pair) else "cylindrical"


def _lightened(blank: Blank, share: float, thinnest: float) -> Blank:
    """Return a body with rim, hub and a web, bored where it is asked, that weighs a share of the solid one."""
    target = share * blank_volume(blank._replace(rim_radius=0.0))
    if blank.hub_radius >= blank.root_radius:
        return blank
    blank = blank._replace(rim_radius=max(blank.rim_radius, blank.hub_radius))
    web = blank.web_width
    bare = blank_volume(blank._replace(web_width=0.0))
    ring = math.pi * (blank.rim_radius**2 - blank.hub_radius**2 - blank.holes * blank.hole_radius**2)
    if target > bare + 0.5 * web * ring:
        return blank._replace(web_width=min((target - bare) / ring, blank.width))
    # A rim by the rules weighs too much: a thinner one under half of the web, without holes.
    web, blank = 0.5 * web, blank._replace(holes=0)
    hub = math.pi * (blank.hub_radius**2 - blank.bore_radius**2) * blank.width
    squared = math.pi * (blank.root_radius**2 * blank.width - blank.hub_radius**2 * web) + hub - target
    rim = math.sqrt(max(squared / (math.pi * (blank.width - web)), blank.hub_radius**2))
    inside = max(blank.rim_radius, blank.root_radius - thinnest)
    if rim <= inside or inside <= blank.hub_radius:
        return blank._replace(rim_radius=min(rim, inside), web_width=web)
    # The thinnest rim weighs too much above half of the web: a thinner web.
    blank = blank._replace(rim_radius=inside)
    left = (target - blank_volume(blank._replace(web_width=0.0))) / (math.pi * (inside**2 - blank.hub_radius**2))
    return blank._replace(web_width=max(left, min(web, THINNEST_WEB * blank.width)))


# ----------------------------------------------------------------------------------------------------------------------
# Gears as they are made: true teeth, a rim, a web and a hub; rings with their wall, bells of turning ones.
# ----------------------------------------------------------------------------------------------------------------------


_SOLID = "A_z b ρ + annuli; A_z = z ∫ 2 ψ r dr"
_SOURCE = "outline of the true tool; AGMA 2001-D04 (backup ratio 1.2); geometry"
_BELL, _SHEAR = "wall; disc, t = 2 T/(π d² τ) at its hub, a cone to t/3", "equilibrium of a disc in shear (Tresca)"
_SPLINE = "DIN 5480-1"
SURE = 0.10
"""One standard deviation of gears over their value, an estimate: bores, webs, holes that lighten [-]."""
SURE_BELL = 0.3
"""One standard deviation of bells over their value, an estimate: holes, joints, stiffness [-]."""


def gear_items(sizing: Sizing, bores: Mapping[str, PlanetBore]) -> Iterator[MassItem]:
    """Yield every gear, and the bell that joins a ring to its shaft where it turns.

    Args:
        sizing: As sized.
        bores: Planet -> what it turns on.
    """
    seats = Seats(bores, shaft_diameters(sizing))
    for gear in sizing.gears:
        given = sizing.given.get(f"{gear.name}.mass")
        if given is not None:
            yield MassItem(gear.name, "gears", gear.bodies, given.value, 0.02, "given", given.origin or "the design")
            continue
        yield gear_item(sizing, gear, seats)
    density = sizing.design.shaft_material.density
    for bell in bells(sizing):
        if f"{bell.ring.name}.mass" not in sizing.given:  # a ring's given mass is with its bell
            yield MassItem(bell_name(bell.ring), "gears", 1, bell.volume * density, SURE_BELL, _BELL, _SHEAR)
    for seat in ring_seats(sizing):
        if f"{seat.ring.name}.mass" not in sizing.given:
            steel = sizing.design.gear_material(seat.ring.stage).density
            teeth, keeper = seat_names(seat.ring)
            yield MassItem(teeth, "gears", 1, seat.teeth_volume * steel, SURE, "half of the height of splines", _SPLINE)
            yield MassItem(keeper, "gears", 1, seat.keeper_volume * density, SURE_BELL, "section", "estimate")


def bell_name(ring: GearSizing) -> str:
    """Return what the bell of a ring is called.

    Args:
        ring: That turns.
    """
    return f"{ring.name} bell"


def seat_names(ring: GearSizing) -> tuple[str, str]:
    """Return what the splines of a ring are called, and what keeps it in the housing.

    Args:
        ring: That stands in it.
    """
    return f"{ring.name} splines", f"{ring.name} keeper"


def gear_item(sizing: Sizing, gear: GearSizing, seats: Seats) -> MassItem:
    """Return one gear as it is made.

    Args:
        sizing: As sized.
        gear: Of it.
        seats: What gears sit on.
    """
    density = sizing.design.gear_material(gear.stage).density
    formula = "(A_z + π (r_o² − r_f²)) b ρ" if gear.rim else _SOLID
    return MassItem(gear.name, "gears", gear.bodies, gear_volume(sizing, gear, seats) * density, SURE, formula, _SOURCE)


# ----------------------------------------------------------------------------------------------------------------------
# Gears of a preliminary sizing: their mass and inertia are those of the bodies that the complete mass counts.
#
# A built shaft leaves out what is inside its gears, whose discs have it: there the inertia alone is that of the body,
# to which what lies inside adds little. The complete mass has bodies at every level.
# ----------------------------------------------------------------------------------------------------------------------


def as_made(sizing: Sizing) -> Sizing:
    """Return a preliminary sizing with gears as they are made: teeth, rims, webs, hubs, bores; a concept as it is.

    Args:
        sizing: With shafts and what planets turn on.
    """
    if sizing.level not in (PRELIMINARY, BUILT):
        return sizing
    seats = Seats(_bores(sizing), shaft_diameters(sizing))
    return replace(sizing, gears=tuple(_made(sizing, gear, seats) for gear in sizing.gears))


def _made(sizing: Sizing, gear: GearSizing, seats: Seats) -> GearSizing:
    """Return a gear with the mass of its body; its inertia goes with the mass, as rims lie outside and hubs inside."""
    if f"{gear.name}.mass" in sizing.given:
        return gear
    mass = gear_item(sizing, gear, seats).each
    inertia = gear.inertia if f"{gear.name}.inertia" in sizing.given else gear.inertia * (mass / gear.mass)
    return replace(gear, mass=mass if sizing.level == PRELIMINARY else gear.mass, inertia=inertia)


def _bores(sizing: Sizing) -> Mapping[str, PlanetBore]:
    """Return what planets turn on; of those on films, and where nothing fits, what their loads ask for."""
    named = named_bores(sizing)
    planets = {gear.name for gear in sizing.gears if gear.role is Role.PLANET}
    return named if planets <= named.keys() else planet_bores(sizing, tuple(seat_duties(sizing)))


# ----------------------------------------------------------------------------------------------------------------------
# How far webs of wheels may stand aside at their hubs; a design whose webs stand further is refused by its sizing.
# ----------------------------------------------------------------------------------------------------------------------


def refuse_dishes(sizing: Sizing) -> None:
    """Refuse every web that does not meet rim and hub with all of its thickness, and a dish of a wheel without a web.

    Args:
        sizing: With shafts.

    Raises:
        DesignError: With where the dish is written, how far the web may lean, and what to write.
    """
    if any(sizing.design.rules(name).web_dish for name in sizing.design.pairs):
        seats = Seats({}, shaft_diameters(sizing))
        wheels = [gear for gear in sizing.gears if gear.role is Role.WHEEL and gear.stage in sizing.design.pairs]
        refuse(problem for wheel in wheels for problem in _dish_problems(sizing, wheel, seats))


def _dish_problems(sizing: Sizing, wheel: GearSizing, seats: Seats) -> Iterator[Problem]:
    """Yield what is wrong with the dish of one wheel."""
    dish, path = sizing.design.rules(wheel.stage).web_dish, sizing.design.key_of(wheel.stage, "gears.web_dish")
    own = path != "gears.web_dish"
    limits = _dishes(sizing, wheel, seats)
    if not dish:
        return
    if limits is None:
        if own:
            yield Problem(path, f"{dish:g} given; {wheel.name} has no web between rim and hub: leave it out")
        return
    low, high = _inwards(limits)
    if low <= dish <= high:
        return
    lean = "must be 0" if low >= high else f"must be from {low:g} to {high:g}"
    why = f"{lean}, so that the web of {wheel.name} meets rim and hub with all of its thickness"
    fix = "lean it less" if own or len(sizing.design.pairs) == 1 else (
        f"lean it less, or write another web_dish in [pairs.{wheel.stage}.gears]"
    )  # fmt: skip
    yield Problem(path, f"{dish:g} given; {why}: {fix}")


def _dishes(sizing: Sizing, wheel: GearSizing, seats: Seats) -> tuple[float, float] | None:
    """Return the least and the largest dish of a wheel; None of one without a web."""
    if wheel.rim:
        return None
    blank = gear_blank(sizing, wheel, seats)
    if kind_of(sizing, wheel) == "bevel":
        bore = blank.bore_radius
        web, hub = bevel_web(sizing, wheel, bore), bevel_hub(sizing, wheel, bore)
        return bevel_dishes(bevel_cones(sizing, wheel.stage), 1, bore, web, hub)
    height, halves = blank.rim_radius - blank.hub_radius, max(wheel.bodies // max(len(wheel.shafts), 1), 1)
    joint = sizing.design.joints.get(wheel.name)
    if height <= 0.0 or (joint is not None and joint.kind == "integral"):
        return None
    most = halves * (blank.width - blank.web_width) / 2.0 / height
    return -most, most


def _inwards(limits: tuple[float, float]) -> tuple[float, float]:
    """Return limits with four decimals, either of which is allowed itself."""
    low, high = (math.ceil(1e4 * limits[0]) / 1e4, math.floor(1e4 * limits[1]) / 1e4)
    return low, high


# ----------------------------------------------------------------------------------------------------------------------
# Carriers as they are made: a plate on both sides of the planets, hollow pins through them, bridges with room.
#
# What weighs them and what draws them take them from here.
# ----------------------------------------------------------------------------------------------------------------------


CLEAR = 1.08
"""Hole of a plate over a shaft that goes through it without being tied to it, an assumption [-]."""
WIDEST = 0.8
"""Hole of a plate over its outer radius, at most [-]."""


class Plate(NamedTuple):
    """One plate of a carrier."""

    body: Body
    """Where it stands."""
    bore: float
    """Radius of the hole for the shafts that go through it [m]."""
    fill: float
    """Share of its disc that is left, the hole for shafts among what is taken, holes for pins not [-]."""

    @property
    def volume(self) -> float:
        """With its holes for pins closed [m³]."""
        radius = self.body.radius
        return math.pi * min(self.fill * radius**2, radius**2 - self.bore**2) * self.body.length


class Bridge(NamedTuple):
    """What joins both plates between two planets; lengths [m]."""

    width: float
    """Around the axis."""
    depth: float
    """Away from the axis."""
    radius: float
    """Of its middle, on the chord between neighbouring pins."""


class Cage(NamedTuple):
    """A carrier as it is made."""

    plates: tuple[Plate, ...]
    """One, or two where the second has room."""
    span: tuple[float, float]
    """From the inner face of one plate to that of the other, or to the far end of the planets, along the first plate's
    axis from its origin [m]."""
    whole: tuple[float, float]
    """Where pins begin and end: flush with the outer faces of their plates; as `span` [m]."""
    pin_diameter: float
    """[m]"""
    eye_wall: float
    """Metal of plates outside the holes for pins [m]."""
    pin_bore: float
    """[m]"""
    pins: int
    """[-]"""
    bridge: Bridge | None
    """None where planets leave no room."""
    bridges: int
    """[-]"""

    @property
    def volume(self) -> float:
        """[m³]"""
        length, pin = self.span[1] - self.span[0], math.pi / 4.0 * self.pin_diameter**2
        bridges = 0.0 if self.bridge is None else self.bridges * self.bridge.width * self.bridge.depth
        pins = self.pins * (pin * length - math.pi / 4.0 * self.pin_bore**2 * (self.whole[1] - self.whole[0]))
        return sum(plate.volume for plate in self.plates) + pins + bridges * length


def cage_of(sizing: Sizing, carrier: CarrierSizing, runs: Sequence[Run]) -> Cage:
    """Return a carrier as it is made.

    Args:
        sizing: As sized.
        carrier: Of it.
        runs: Shafts from end to end.
    """
    planets = [gear for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET]
    pins = {gear.shafts[0]: gear.bodies for gear in planets}
    bodies = plates_of(sizing, carrier.stage)
    fill = sizing.design.carriers.fill
    plates = tuple(Plate(body, plate_bore(sizing, body, runs), fill) for body in bodies)
    bridge = None
    if len(plates) > 1:
        bridge = _bridge_of(carrier) or bridge_between(sizing, carrier, planets)
    span = _between(sizing, bodies)
    ends = [end for body in bodies for end in along_body(bodies[0], body)]
    whole = (min(span[0], *ends), max(span[1], *ends))
    return Cage(
        plates, span, whole, carrier.pin_diameter, carrier.eye_wall, carrier.pin_bore or 0.0, sum(pins.values()),
        bridge, max(pins.values()),
    )  # fmt: skip


def _bridge_of(carrier: CarrierSizing) -> Bridge | None:
    """Return a bridge as it was sized; None where it was not."""
    sizes = (carrier.bridge_width, carrier.bridge_depth, carrier.bridge_radius)
    return None if None in sizes else Bridge(*(size or 0.0 for size in sizes))


def _between(sizing: Sizing, plates: Sequence[Body]) -> tuple[float, float]:
    """Return where pins begin and end along the axis of the first plate, from its origin [m]."""
    first = plates[0]
    if len(plates) > 1:
        low, high = along_body(first, plates[1])
        far = low if low > 0.0 else high
    else:
        low, high = planets_span(sizing, first)
        far = high if low > 0.0 else low
    return (first.length, far) if far > 0.0 else (far, 0.0)


def bridge_between(sizing: Sizing, carrier: CarrierSizing, planets: Sequence[GearSizing]) -> Bridge | None:
    """Return a bridge, as wide as neighbouring planets leave on their chord; None where they leave nothing.

    Args:
        sizing: As sized.
        carrier: Of it.
        planets: On its pins.

    Source: chord 2 r sin(π/N) less the tip diameter; between the tips of suns and rings away from the axis.
    """
    if len({gear.shafts[0] for gear in planets}) > 1:
        return None
    widest = max(planets, key=lambda gear: gear.pitch_diameter)
    tip = 2.0 * _tip(sizing, widest)
    width = 2.0 * carrier.radius * math.sin(math.pi / widest.bodies) - tip - 2.0 * BESIDE
    own = [gear for gear in sizing.gears if gear.stage == carrier.stage]
    suns = [_tip(sizing, gear) for gear in own if gear.role is Role.SUN]
    rings = [_tip(sizing, gear) for gear in own if gear.rim]
    middle = carrier.radius * math.cos(math.pi / widest.bodies)
    inner = max([middle - BRIDGE * tip / 2.0, *(radius + BESIDE for radius in suns)])
    within = [math.sqrt(max((radius - BESIDE) ** 2 - width**2 / 4.0, 0.0)) for radius in rings]
    outer = min([middle + BRIDGE * tip / 2.0, *within])
    if width <= 0.0 or outer <= inner or widest.bodies == 1:
        return None
    return Bridge(width, outer - inner, (outer + inner) / 2.0)


def _tip(sizing: Sizing, gear: GearSizing) -> float:
    return tooth_of(sizing, gear).tip_radius


def plate_bore(sizing: Sizing, plate: Body, runs: Sequence[Run]) -> float:
    """Return the radius of the hole that a plate has for the shafts that go through it [m].

    Args:
        sizing: As sized.
        plate: Its envelope.
        runs: Shafts from end to end.
    """
    return min(max((_through(sizing, run, plate) for run in runs), default=0.0), WIDEST * plate.radius)


def _through(sizing: Sizing, run: Run, plate: Body) -> float:
    """Return the radius of the hole that a shaft needs in a plate; 0 where it does not reach it [m]."""
    frame = sizing.arrangement.frames[run.shaft]
    axis, middle = np.asarray(frame.along), np.asarray(plate.origin) + plate.length / 2.0 * np.asarray(plate.direction)
    place = float((middle - np.asarray(frame.origin)) @ axis)
    beside = float(np.linalg.norm(middle - np.asarray(frame.origin) - place * axis))
    if beside > IN_LINE or abs(abs(float(np.asarray(plate.direction) @ axis)) - 1.0) > IN_LINE:
        return 0.0
    half = plate.length / 2.0
    radii = [radius for low, high, radius in run.steps if low < place + half and place - half < high]
    return max(radii, default=0.0) * (1.0 if run.shaft == plate.shaft else CLEAR)


# ----------------------------------------------------------------------------------------------------------------------
# Shafts and carriers as they are made: whole shafts through their gears, carriers of two plates with bridges.
# ----------------------------------------------------------------------------------------------------------------------


SURE_SHAFT = 0.25
"""One standard deviation of shafts over their value, an estimate: lengths before everything has its place [-]."""
SURE_CARRIER = 0.30
"""One standard deviation of carriers over their value, an estimate [-]."""


def shaft_items(sizing: Sizing) -> Iterator[MassItem]:
    """Yield every shaft from end to end, through its gears, whose bodies are bored here, as far as its place asks.

    Args:
        sizing: As sized.
    """
    built = {shaft.name for shaft in sizing.built_shafts}
    density, (reaches, _) = sizing.design.shaft_material.density, runs(sizing)
    for shaft in sizing.shafts:
        given = sizing.given.get(f"{shaft.name}.mass")
        if given is not None:
            yield MassItem(shaft.name, "shafts", 1, given.value, 0.02, "given", given.origin or "the design")
            continue
        volume = sum(run.volume for run in reaches if run.shaft == shaft.name)
        if volume == 0.0:  # the cage of planets, which is weighed as their carrier
            continue
        sure, source = (0.08, "its steps") if shaft.name in built else (SURE_SHAFT, "its place on its axis")
        yield MassItem(shaft.name, "shafts", 1, density * volume, sure, "Σ π/4 (d² − d_i²) l ρ", source)


def carrier_items(sizing: Sizing) -> Iterator[MassItem]:
    """Yield every carrier: a plate on both sides, hollow pins between them, and bridges.

    Args:
        sizing: As sized.
    """
    density, (reaches, _) = sizing.design.shaft_material.density, runs(sizing)
    for carrier in sizing.carriers:
        formula, source = "hollow pins; two plates; bridges", "first sizing; geometry"
        given = sizing.given.get(f"{carrier.part}.mass")
        if given is not None:
            yield MassItem(str(carrier.part), "carriers", 1, given.value, 0.02, "given", given.origin or "the design")
            continue
        mass = density * cage_of(sizing, carrier, reaches).volume
        yield MassItem(str(carrier.part), "carriers", 1, mass, SURE_CARRIER, formula, source)
