"""The bodies of gears as they are made: teeth of the true tool over a rim, a web, a hub and the bore of their seat.

What weighs them and what draws them take them from here.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from gearwright.catalogue import key_for_shaft
from gearwright.identity import Role
from gearwright.parts.bevel import WEB, BevelPair, bevel_volume, lightened_web
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
from gearwright.sizing.blanks import PLANET_HUB, blank_by_rules, external_tooth, ring_radii, turned_out
from gearwright.sizing.mass.duties import seat_duties
from gearwright.sizing.mass.planet_bores import PlanetBore, planet_bores
from gearwright.sizing.places import BOSS
from gearwright.sizing.rating import THINNEST_RIM, TOOTH_HEIGHT, rating_of, standard_teeth
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.sizing.tooth_shape import cylindrical_gear
from gearwright.spec.design import Pair

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
