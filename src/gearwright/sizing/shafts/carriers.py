"""Carriers of planetary sets: pins, plates, bridges that keep planets straight, and their checks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from gearwright.base import Check, Role, carrier_part, gear_part, largest, stressed
from gearwright.parts import Material
from gearwright.parts.carriers import (
    BESIDE,
    PIN_BORE,
    Asked,
    Elastic,
    Frame,
    Stiff,
    Window,
    cantilever_tilt,
    clamped_pressure,
    eye_stress,
    eye_wall,
    hole_pressure,
    lag_tilt,
    pin_bore,
    pin_diameter,
    pin_mass,
    pin_stress,
    plate_band,
    plate_lag,
    plate_mass,
    plate_shear_stress,
    plate_stiffness,
    shared_lever,
    stiff_frame,
)
from gearwright.parts.iso6336 import flank_tolerances, usual_class
from gearwright.sizing.gear_geometry import external_tooth, pin_circle, planet_push, set_pins
from gearwright.sizing.loads import PinLoad, pin_length, pin_loads
from gearwright.sizing.rating import Context
from gearwright.sizing.rating.iso6336_inputs import HELIX
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shaft_results import CarrierSizing, ShaftSizing
from gearwright.spec.design import CONCEPT

# ----------------------------------------------------------------------------------------------------------------------
# Carriers of planetary sets: cantilever pins under tooth forces and the planets' centrifugal force, and the plate.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDING = 1e-9
"""Torque on a free carrier over the largest of its parts that counts as none [-]."""
THROUGH = 1e-3
"""Room between a plate and the tips of the ring that it is put in through, an assumption [m]."""


class _Pins(NamedTuple):
    """Equal pins of one planet body."""

    radius: float
    """Of the circle that they stand on [m]."""
    length: float
    """[m]"""
    seat: float = 0.0
    """Diameter under what the planets turn on; 0 where it follows the strength [m]."""
    rings: float = 0.0
    """Mass of inner rings on one [kg]."""


NO_FRAME = Stiff((0.0, 0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""What asks a carrier for no stiffness."""


class _CarrierDuty(NamedTuple):
    """What a carrier has to bear, and on what."""

    equal: int
    """Pins of each planet body [-]."""
    torque: float
    """[N m]"""
    hub: float
    """Diameter of its shaft; 0 where it stands still [m]."""
    plates: int = 1
    """That share the force of a pin [-]."""


def size_carriers(
    context: Context, gears: tuple[GearSizing, ...], shafts: tuple[ShaftSizing, ...],
    two_sided: tuple[str, ...] = (), roomy: tuple[str, ...] = (),
) -> tuple[CarrierSizing, ...]:  # fmt: skip
    """Return the carrier of every planetary set.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        shafts: From `size_shafts`.
        two_sided: Sets with a plate on both sides, as their shaft goes on behind both.
        roomy: Sets with room for a second plate beyond their planets; it shares the force where bridges tie it, but
            at level concept, where pins are cantilevers in one plate, as the thesis has them.
    """
    by_name = {gear.name: gear for gear in gears}
    diameters = {shaft.name: shaft.diameter for shaft in shafts}
    room = {} if context.design.level == CONCEPT else {**dict.fromkeys(roomy, 1), **dict.fromkeys(two_sided, 2)}
    simple = [_carrier(context, name, by_name, diameters, room.get(name, 0)) for name in context.design.planetaries]
    compound = [_compound(context, name, by_name, diameters, room.get(name, 0)) for name in context.design.epicyclics]
    return tuple(
        _twice(context, carrier) if carrier.stage in two_sided and carrier.free_plate is None else carrier
        for carrier in (*simple, *compound)
    )


def _twice(context: Context, carrier: CarrierSizing) -> CarrierSizing:
    """Return a carrier with a second plate, on which its shaft goes on; its pins are as they were sized."""
    given, reach = context.given, carrier.reach
    more = plate_mass(
        reach, carrier.plate_thickness, context.design.shaft_material.density, fill=context.design.carriers.fill
    )
    return replace(
        carrier,
        mass=given.get(f"{carrier.part}.mass", carrier.mass + more),
        inertia=given.get(f"{carrier.part}.inertia", carrier.inertia + more * reach**2 / 2.0),
    )


def _carrier(
    context: Context, name: str, gears: Mapping[str, GearSizing], diameters: Mapping[str, float], beyond: int
) -> CarrierSizing:
    """Return the carrier of a simple set, with two plates where a second one has room and bridges can tie it."""
    planet, radius = gears[str(gear_part(name, Role.PLANET))], pin_circle(context, name, gears)
    torques = _torques(context, name)
    loads = _loads(context, name, planet, radius, torques=torques, push=planet_push(context, gears, name))
    pins = {str(Role.PLANET): _pins_of(planet, radius)}
    count = context.design.planetaries[name].planets
    asked = _CarrierDuty(count, max(torques), diameters.get(context.design.sets[name].carrier, 0.0))
    return _lighter(context, name, pins, loads, asked=asked, gears=gears, planet=planet, beyond=beyond)


def _compound(
    context: Context, name: str, gears: Mapping[str, GearSizing], diameters: Mapping[str, float], beyond: int
) -> CarrierSizing:
    """Return the carrier of a compound set, with two plates as a simple one where it has one planet in a row."""
    stage, own = context.design.epicyclics[name], {gear.own: gear for gear in gears.values() if gear.stage == name}
    pins = {
        body: _Pins(abs(place), pin_length(stage, body, own)) for body, place in set_pins(context, name, own).items()
    }
    torque, loads = max(map(abs, _carrier_torques(context, name))), pin_loads(context, name, own)
    asked = _CarrierDuty(stage.sets, torque, diameters.get(stage.carrier, 0.0))
    planets = [own[step] for step in stage.planets]
    single = planets[0] if len(planets) == 1 else None
    return _lighter(context, name, pins, loads, asked=asked, gears=gears, planet=single, beyond=beyond)


def _lighter(
    context: Context, name: str, pins: Mapping[str, _Pins], loads: Sequence[PinLoad], *, asked: _CarrierDuty,
    gears: Mapping[str, GearSizing], planet: GearSizing | None, beyond: int,
) -> CarrierSizing:  # fmt: skip
    """Return the lighter carrier of one plate and of two with bridges that keeps planets straight.

    Where the design says how many plates, that; where its shaft goes on behind a second one, two; where neither keeps
    planets straight, the one that tilts them less.
    """
    rules, room = context.design.carriers, _room(context, name, gears)
    one = _sized(context, name, pins, loads, asked=asked, room=room)
    if context.design.level == CONCEPT or planet is None:
        return one
    allowed = _misalignment_allowed(context, planet)
    one = _leaning(context, planet, one, asked.equal, allowed)
    if not beyond or asked.equal < 2:
        return one
    two = _of_two_plates(context, name, pins, loads, asked=asked, gears=gears, planet=planet, allowed=allowed)
    if two is None or rules.plates == 2 or beyond > 1:
        return two or one
    stiff = Stiff((_clamping(context, planet, one, asked.equal, allowed), 0.0), one.reach, 0.0, 0.0, 0.0, 0.0, 0.0)
    one = _sized(context, name, pins, loads, asked=asked, room=room, frame=stiff)
    one = replace(_leaning(context, planet, one, asked.equal, allowed), alone=True)
    if rules.plates == 1:
        return one
    straight = [(carrier.misalignment or 0.0) <= allowed * _JUST for carrier in (one, two)]
    if straight[0] != straight[1]:
        return one if straight[0] else two
    if not straight[0]:
        return one if (one.misalignment or 0.0) < (two.misalignment or 0.0) else two
    bridges = asked.equal * (two.bridge_width or 0.0) * (two.bridge_depth or 0.0) * planet.face_width
    return one if one.mass < two.mass + bridges * context.design.shaft_material.density else two


def _of_two_plates(
    context: Context, name: str, pins: Mapping[str, _Pins], loads: Sequence[PinLoad], *, asked: _CarrierDuty,
    gears: Mapping[str, GearSizing], planet: GearSizing, allowed: float,
) -> CarrierSizing | None:  # fmt: skip
    """Return a carrier of two plates as strong and as stiff as it must be; None where planets leave no bridges."""
    room, shared = _room(context, name, gears), asked._replace(plates=2)
    strong = _sized(context, name, pins, loads, asked=shared, room=room)
    tip = external_tooth(context.design, planet).tip_radius + BESIDE
    suns = [gear for gear in gears.values() if gear.stage == name and gear.role is Role.SUN]
    inner = max((external_tooth(context.design, sun).tip_radius + BESIDE for sun in suns), default=0.0)
    outer = max(room if math.isfinite(room) else strong.reach, strong.reach)
    window = Window(asked.equal, strong.radius, tip, inner, outer, planet.face_width)
    material, rules = context.design.shaft_material, context.design.carriers
    least = (strong.plate_thickness, strong.free_plate or strong.plate_thickness)
    bending = (material.yield_strength or math.inf) / context.design.shafting.safety
    factor, force = _modified(context, planet), abs(strong.tangential_force)
    if rules.torque_at == "middle":  # both plates lag alike, and planets stay straight
        factor = 0.0
    tilt = allowed / (factor * planet.face_width) if factor else math.inf
    frame = stiff_frame(window, Asked(force, tilt, least, strong.reach, bending, rules.fill), _moduli(material))
    if not frame.width > 0.0:
        return None
    found = _sized(context, name, pins, loads, asked=shared, room=room, frame=frame)
    free = found.free_plate or found.plate_thickness
    sizes = (frame.width, frame.depth, frame.radius)
    own = Frame(asked.equal, found.radius, planet.face_width, *sizes, free, plate_band(found.reach, rules.fill))
    lag = float(plate_lag(force, own, _moduli(material))) if factor else 0.0
    return replace(
        found,
        bridge_width=frame.width,
        bridge_depth=frame.depth,
        bridge_radius=frame.radius,
        misalignment=factor * planet.face_width * lag_tilt(lag, planet.face_width, free),
        largest_misalignment=allowed,
    )


def _leaning(context: Context, planet: GearSizing, carrier: CarrierSizing, count: int, allowed: float) -> CarrierSizing:
    """Return a carrier of one plate with how far its cantilever pins and its plate let planets lean."""
    off = _modified(context, planet) * planet.face_width
    tilt = _cantilever(context, planet, carrier, count, carrier.plate_thickness)
    return replace(carrier, misalignment=off * tilt, largest_misalignment=allowed)


def _cantilever(context: Context, planet: GearSizing, carrier: CarrierSizing, count: int, plate: float) -> float:
    """Return the tilt of planets on pins in one plate, which bend, and with which the plate turns [rad]."""
    moduli, force = _moduli(context.design.shaft_material), abs(carrier.tangential_force)
    width, pin = planet.face_width, carrier.pin_diameter
    band = plate_band(carrier.reach, context.design.carriers.fill)
    tilt = cantilever_tilt(force, width, pin, moduli, bore=carrier.pin_bore or 0.0)
    if count < 3:
        return tilt
    turns = plate_stiffness(count, carrier.radius, pin, plate=plate, band=band, moduli=moduli)
    return tilt + float(force * (width + plate) / 2.0 / turns)


def _clamping(context: Context, planet: GearSizing, carrier: CarrierSizing, count: int, allowed: float) -> float:
    """Return the least thickness of a plate that clamps cantilever pins and keeps planets straight [m].

    Where none does, as thick as planets are wide.
    """
    material, rules = context.design.shaft_material, context.design.carriers
    pressure = (material.yield_strength or math.inf) / rules.safety
    off = _modified(context, planet) * planet.face_width

    def holds(plate: float) -> bool:
        pressed = clamped_pressure(carrier.pin_force, planet.face_width, carrier.pin_diameter, plate)
        return pressed <= pressure and off * _cantilever(context, planet, carrier, count, plate) <= allowed

    low, high = carrier.plate_thickness, max(carrier.plate_thickness, planet.face_width)
    if holds(low):
        return low
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


_HALVINGS = 20


def _moduli(material: Material) -> Elastic:
    return Elastic(material.elastic_modulus, material.shear_modulus)


_UNSURE = 1.33
"""Factor on deflections of ISO 6336-1:2006, clause 7.5 [-]."""
_PART = 0.5
"""Misalignment by the carrier over the helix slope tolerance of planets, at most [-]: an assumption."""
_JUST = 1.0 + 1e-9


def _modified(context: Context, planet: GearSizing) -> float:
    """Return what is left of a deflection of teeth after their helix modification, 1.33 B_1 [-]."""
    return _UNSURE * HELIX[context.design.rules(planet.stage).iso6336.helix_modification].deflection


def _misalignment_allowed(context: Context, planet: GearSizing) -> float:
    """Return how far teeth of planets may be out of line over their face by the carrier: half of f_Hβ [m]."""
    if (stated := context.design.carriers.largest_misalignment) is not None:
        return stated
    grade: float | None = context.design.rules(planet.stage).iso6336.tolerance_class
    if grade is None:
        row = next(mesh for mesh in context.train.meshes if mesh.stage == planet.stage)
        teeth = context.teeth[row.gears[0]]
        speed = context.asks[row.name].fastest * abs(teeth) * planet.module / 2.0
        grade = float(usual_class(speed))
    tolerances = flank_tolerances(planet.pitch_diameter, planet.module, planet.face_width, grade=grade)
    return _PART * float(tolerances.helix_slope)


def _room(context: Context, name: str, gears: Mapping[str, GearSizing]) -> float:
    """Return the radius of the narrowest ring of a set inside its teeth, through which a plate goes [m]."""
    rings = [gear for gear in gears.values() if gear.stage == name and gear.rim]
    tips = [external_tooth(context.design, ring)._replace(side=-1).tip_radius for ring in rings]
    return min(tips, default=math.inf) - THROUGH


def _pins_of(planet: GearSizing, radius: float) -> _Pins:
    """Return the pins of a simple set: as thick as what the planets turn on asks."""
    runs_on = planet.runs_on
    if runs_on is None:
        return _Pins(radius, planet.face_width)
    return _Pins(radius, planet.face_width, runs_on.pin_diameter, runs_on.standing_mass)


def _sized(
    context: Context,
    name: str,
    pins: Mapping[str, _Pins],
    loads: Sequence[PinLoad],
    *,
    asked: _CarrierDuty,
    room: float,
    frame: Stiff = NO_FRAME,
) -> CarrierSizing:
    """Return a carrier with equal pins, as strong as the one that is loaded most needs; as stiff as a frame."""
    rules, given, shaft = context.design.carriers, context.given, context.design.sets[name].carrier
    material, torque, hub = context.design.shaft_material, asked.torque, asked.hub
    allowable = (material.yield_strength or 0.0) / rules.safety
    worst, pulled = largest(loads, lambda load: load.pin * load.lever), largest(loads, lambda load: load.pin).pin
    length, outermost = pins[worst.body].length, max(equal.radius for equal in pins.values())
    lever, shared = worst.lever, asked.plates > 1
    if shared:
        pulled, lever = pulled / 2.0, shared_lever(length, max(rules.plate_ratio * length / 2.0, frame.plates[1]))
    needed = pin_diameter(worst.pin, lever, allowable)
    hollow = needed / math.cbrt(1.0 - PIN_BORE**4) if shared else needed
    pin = given.get(f"{name}.pin_diameter", max(hollow, pins[worst.body].seat))
    bore = pin_bore(pin, needed) if pins[worst.body].seat or shared else 0.0
    if shared and f"{name}.pin_diameter" in given:  # which its load moves as little as the pin
        bore = PIN_BORE * pin
    room = room - outermost - pin / 2.0
    thinnest = max(rules.plate_ratio * length / asked.plates, pulled / (pin * allowable))
    if room > 0.0:  # where the ring leaves less metal outside the pins, plates are thicker
        thinnest = max(thinnest, pulled / (room * allowable))
    thickness = max(_thickness(thinnest, torque, hub, allowable=allowable), frame.plates[0])
    thickness = given.get(f"{name}.plate_thickness", thickness)
    least = max(min(thinnest, thickness), frame.plates[1]) if shared else thickness
    wall = max(eye_wall(pulled, least, allowable / 2.0, needed=needed), frame.reach - outermost - pin / 2.0)
    wall = given.get(f"{name}.eye_wall", room if 0.0 < room < wall else wall)
    bending = pin_stress(worst.pin, lever, pin, bore=bore)
    shear = plate_shear_stress(torque, hub, thickness) if hub else 0.0
    torn, pressed = eye_stress(pulled, least, wall), hole_pressure(pulled, pin, least)
    reach = outermost + pin / 2.0 + wall
    together = thickness + least if shared else thickness
    plate = plate_mass(reach, together, material.density, fill=rules.fill)
    held, about = _pins_mass(pins, asked.equal, (pin, bore), material.density)
    part = carrier_part(name)
    return CarrierSizing(
        stage=name,
        shaft=shaft,
        case=worst.case,
        torque=torque,
        tangential_force=abs(worst.tangential),
        centrifugal_force=worst.centrifugal,
        radial_force=worst.radial,
        pin_force=worst.pin,
        radius=pins[worst.body].radius,
        pin_diameter=pin,
        pin_bore=bore or None,
        pin_stress=bending,
        pin_margin=allowable / bending if bending else math.inf,
        plate_thickness=thickness,
        plate_stress=shear,
        plate_margin=allowable / 2.0 / shear if shear else None,
        eye_wall=wall,
        eye_stress=torn,
        eye_margin=allowable / 2.0 / torn if torn else math.inf,
        hole_pressure=pressed,
        hole_margin=allowable / pressed if pressed else math.inf,
        reach=reach,
        mass=given.get(f"{part}.mass", held + plate),
        inertia=given.get(f"{part}.inertia", about + plate * reach**2 / 2.0),
        free_plate=least if shared else None,
    )


def _pins_mass(
    pins: Mapping[str, _Pins], count: int, diameters: tuple[float, float], density: float
) -> tuple[float, float]:
    """Return the mass of all pins [kg], and their inertia about the carrier's axis with the rings on them [kg m²]."""
    pin, bore = diameters
    masses = {body: count * pin_mass(pin, equal.length, density, bore=bore) for body, equal in pins.items()}
    about = sum((mass + count * pins[body].rings) * pins[body].radius ** 2 for body, mass in masses.items())
    return sum(masses.values()), about


def _carrier_torques(context: Context, name: str) -> list[float]:
    """Return the torque that the teeth put on a carrier in every case [N m]."""
    rows = [mesh.name for mesh in context.train.meshes if mesh.stage == name]
    torques = [[flow.meshes[row].torques[2] for row in rows] for flow in context.flows.values()]
    return [sum(parts) if abs(sum(parts)) > ROUNDING * max(map(abs, parts)) else 0.0 for parts in torques]


def _torques(context: Context, name: str) -> list[float]:
    """Return the size of the torque on a simple set's carrier in every case [N m]."""
    rows = [mesh.name for mesh in context.train.meshes if mesh.stage == name]
    return [abs(sum(flow.meshes[row].torques[2] for row in rows)) for flow in context.flows.values()]


def _loads(
    context: Context, name: str, planet: GearSizing, radius: float, *, torques: Sequence[float], push: float
) -> list[PinLoad]:
    """Return what every case puts on a pin of a simple set."""
    stage, factor = context.design.planetaries[name], context.ratings[name].load_factor
    loads = []
    for (case, flow), torque in zip(context.flows.items(), torques, strict=True):
        centrifugal = planet.turning_mass * radius * flow.speeds[stage.carrier] ** 2
        tangential = torque * factor / (stage.planets * radius)
        radial = push * tangential
        pin = math.hypot(tangential, centrifugal + radial)
        loads.append(PinLoad(case, str(Role.PLANET), tangential, radial, centrifugal, pin, planet.face_width))
    return loads


def _thickness(thinnest: float, torque: float, hub: float, *, allowable: float) -> float:
    """Return the plate's thickness: its share of the face width, or what its hub needs in shear (Tresca) [m]."""
    if not hub:
        return thinnest
    return thinnest * max(1.0, plate_shear_stress(torque, hub, thinnest) / (allowable / 2.0))


def carrier_checks(carrier: CarrierSizing) -> Iterator[Check]:
    """Yield the checks of a carrier's pins, of the plate around them and, where it turns, of the plate at its hub.

    Args:
        carrier: As sized.
    """
    part, case = carrier.part, carrier.case
    yield stressed(
        part,
        "pin bending",
        "cantilever" if carrier.free_plate is None else "beam on two supports",
        carrier.pin_stress,
        carrier.pin_margin,
        case=case,
    )
    yield stressed(part, "pin in its hole", "p = F/(d t)", carrier.hole_pressure, carrier.hole_margin, case=case)
    yield stressed(part, "eye shear", "tear-out, Tresca", carrier.eye_stress, carrier.eye_margin, case=case)
    if carrier.plate_margin is not None:
        yield stressed(part, "plate shear", "Tresca", carrier.plate_stress, carrier.plate_margin, case=case)
