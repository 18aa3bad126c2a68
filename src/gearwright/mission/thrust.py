"""Thrust and power required in flight: drag, propeller operating point and helicopter trim."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.air import Air, Polar, drag_force, dynamic_force, stall_speed
from gearwright.base import GRAVITY, Bools, DesignError, Floats, Ints, Problem, apart
from gearwright.catalogue import compressed
from gearwright.elementwise import Values, functions
from gearwright.machines import (
    Airframe,
    Disc,
    MachMap,
    PropellerMap,
    Stream,
    angle_for_power,
    angle_for_thrust,
    antitorque,
    coefficients,
    governs,
    lift,
    map_at,
)
from gearwright.mission.charts import angle_along, at_tips, governs_along, power_and_thrust, squeezed_along
from gearwright.mission.profile import Course, Moment, Stretch
from gearwright.spec import Aircraft, Mission, Phase, Rotorcraft, Setting

# ----------------------------------------------------------------------------------------------------------------------
# Forces on the aircraft: drag with flaps and gear, friction of its wheels, and the thrust that a path needs.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_FLAPS: dict[str | None, Setting] = {"take-off": "take-off", "approach": "landing", "landing": "landing"}
"""Kind of phase -> setting of flaps and gear where the phase does not say it."""


class Attitude(NamedTuple):
    """Where an aircraft is on its path, and how it moves."""

    air: Air
    speed: Values
    """True airspeed [m/s]."""
    slope: Values
    """sin γ of the path [-]."""
    rolls: Values
    """Part of the weight that the wing leaves to the wheels, which they bear [-]; 0 in flight."""


def polar_of(aircraft: Aircraft, phase: Phase) -> Polar:
    """Return the drag polar with the flaps, the gear and the extra drag of a phase.

    Args:
        aircraft: Of the mission.
        phase: With its kind.
    """
    flaps = aircraft.flaps(setting_of(phase))
    extra = (flaps.extra_drag if flaps is not None else 0.0) + phase.extra_drag
    return Polar(aircraft.wing_area, aircraft.zero_lift_drag + extra, aircraft.induced)


def setting_of(phase: Phase) -> Setting:
    """Return how flaps and gear stand in a phase.

    Args:
        phase: With its kind.
    """
    return phase.flaps or USUAL_FLAPS.get(phase.kind, "clean")


def friction_of(aircraft: Aircraft, phase: Phase) -> float:
    """Return μ of the wheels in a phase on the ground [-].

    Args:
        aircraft: Of the mission.
        phase: With its kind.
    """
    return aircraft.braking_friction if phase.kind == "landing" else aircraft.rolling_friction


def resistance(aircraft: Aircraft, phase: Phase, weight: float, at: Attitude) -> float:
    """Return what holds the aircraft back: drag, and friction of wheels that bear what the wing does not [N].

    Args:
        aircraft: Of the mission.
        phase: With its kind.
        weight: m g [N].
        at: Where it is.

    Source: `held_back`.
    """
    wheels = friction_of(aircraft, phase), aircraft.roll_lift
    return float(held_back(polar_of(aircraft, phase), wheels, weight, at))


def held_back(polar: Polar, wheels: tuple[Values, Values], weight: Values, at: Attitude) -> Values:
    """Return what holds aircraft back [N].

    Args:
        polar: With flaps, gear and extra drag.
        wheels: Their friction μ, and the lift coefficient on them [-].
        weight: m g [N].
        at: Where they are.

    Source: D = q S (C_D0 + k C_L²), L = m g cos γ in flight; μ (m g − L) on the wheels.
    """
    of, reference = functions(at.slope, weight), dynamic_force(polar, at.air, at.speed)
    flown = weight * of.sqrt(of.max(1.0 - at.slope**2, 0.0))
    rolled = of.min(wheels[1] * reference, flown)
    lift = at.rolls * rolled + (1.0 - at.rolls) * flown
    return drag_force(polar, reference, lift) + wheels[0] * (flown - lift)


def lowest_speed(aircraft: Aircraft, phase: Phase, air: Air, weight: float) -> float | None:
    """Return the stall speed in a phase [m/s]; None where the aircraft does not say its highest lift.

    Args:
        aircraft: Of the mission.
        phase: With its kind.
        air: Where it is flown.
        weight: m g [N].
    """
    flaps = aircraft.flaps(setting_of(phase))
    return None if flaps is None else stall_speed(polar_of(aircraft, phase), air, weight, flaps.highest_lift)


def stated_thrust(aircraft: Aircraft, phase: Phase, moment: Moment, mass: float) -> float:
    """Return the thrust of all propellers that a stated path needs [N].

    Args:
        aircraft: Of the mission.
        phase: Of the moment.
        moment: Where it is flown.
        mass: Of the aircraft now [kg].

    Source: `path_thrust`.
    """
    slope = moment.climb / moment.true_airspeed if moment.true_airspeed else 0.0
    at = Attitude(moment.air, moment.true_airspeed, slope, 1.0 if phase.kind == "taxi" else 0.0)
    refuse_stall(aircraft, phase, mass * GRAVITY, at)
    return float(path_thrust(resistance(aircraft, phase, mass * GRAVITY, at), mass, at, moment.acceleration))


def path_thrust(held: Values, mass: Values, at: Attitude, acceleration: Values) -> Values:
    """Return the thrust of all propellers that holds aircraft on their paths [N].

    Args:
        held: What holds them back [N].
        mass: Now [kg].
        at: Where they are.
        acceleration: dV/dt [m/s²].

    Source: T = D + μ (m g − L) + m g sin γ + m dV/dt.
    """
    return held + mass * GRAVITY * at.slope + mass * acceleration


def refuse_stall(aircraft: Aircraft, phase: Phase, weight: float, at: Attitude) -> None:
    """Refuse a flight below the stall.

    Args:
        aircraft: Of the mission.
        phase: With its kind.
        weight: m g [N].
        at: Where it is.
    """
    lowest = None if at.rolls else lowest_speed(aircraft, phase, at.air, weight)
    if lowest is not None and at.speed < lowest:
        speed, stall = apart(at.speed, lowest, "velocity")
        message = (
            f"flies {speed}, and stalls below {stall} with flaps {setting_of(phase)!r}; fly faster, lighter, or with"
            " other flaps"
        )
        raise DesignError([Problem("aircraft", message)])


# ----------------------------------------------------------------------------------------------------------------------
# Trim of a helicopter: what main and tail rotor take at a weight, a speed and a rate of climb.
# ----------------------------------------------------------------------------------------------------------------------


class Trim(NamedTuple):
    """What the rotors take."""

    main: float
    """Power of the main rotor's shaft [W]."""
    tail: float | None
    """Of the tail rotor's [W]; None where the mission says nothing of it."""
    thrust: float
    """Of the main rotor [N]."""


def trimmed(craft: Rotorcraft, mission: Mission, moment: Moment, *, diameter: float, burnt: float) -> Trim:
    """Return what main and tail rotor take in an interval.

    Args:
        craft: The helicopter.
        mission: Of it.
        moment: Where it is flown; the propeller's speed is that of the main rotor.
        diameter: Of the main rotor [m].
        burnt: Fuel so far [kg].

    Source: `lift` and `antitorque`.

    Raises:
        DesignError: Blades that stall, or a descent into the rotor's own wake.
    """
    disc = Disc(diameter, craft.solidity, craft.profile_drag, craft.induced_factor)
    speed, climb, mass = moment.propeller_speed, moment.climb, craft.mass - burnt
    forward = math.sqrt(max(moment.true_airspeed**2 - climb**2, 0.0)) if moment.true_airspeed > abs(climb) else 0.0
    carried = Airframe(mass, craft.flat_plate_area, craft.download)
    stream = Stream(moment.air.density, forward, climb, speed)
    found = lift(disc, carried, stream, mass * moment.acceleration * moment.true_airspeed)
    if found.loading > craft.highest_loading:
        message = (
            f"blades bear C_T/σ {found.loading:.3g} at {moment.altitude:.0f} m, and stall beyond"
            f" {craft.highest_loading:.3g}; be lighter, fly lower, or turn the rotor faster"
        )
        raise DesignError([Problem("rotorcraft", message)])
    return Trim(found.power, _tail(craft, mission, moment, (found.power, forward)), found.thrust)


def _tail(craft: Rotorcraft, mission: Mission, moment: Moment, main: tuple[float, float]) -> float | None:
    """Return the power of the tail rotor [W]; `main` is the main rotor's power [W] and the forward speed [m/s]."""
    tail, (power, forward) = craft.tail, main
    if tail is None:
        return None
    first = next(iter(mission.phases.values())).propeller_speed
    disc = Disc(tail.diameter, tail.solidity, tail.profile_drag, tail.induced_factor)
    stream = Stream(moment.air.density, forward, 0.0, tail.speed * moment.propeller_speed / first)
    return antitorque(disc, stream, power / moment.propeller_speed, tail.arm).power


# ----------------------------------------------------------------------------------------------------------------------
# What flight asks of one propeller, and what the propeller makes of the power that reaches it.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST_LIFT = 10.0
"""Lift coefficient that no wing has, whatever its flaps [-]: beyond it a phase is no flight."""
SQUEEZED_ROUNDS = 8
"""Rounds in which the factor of compressibility settles: it hardly changes with the thrust [-]."""


class Blades(NamedTuple):
    """The propeller of one gearbox."""

    map_name: str
    """Shipped map, file, or none."""
    chart: PropellerMap | MachMap | None
    """None where powers are schedules."""
    diameter: float
    """[m]"""


class Advance(NamedTuple):
    """How a propeller screws through the air."""

    diameter: float
    """[m]"""
    turns: float
    """Per second [1/s]."""
    ratio: float
    """J = V/(n D) [-]."""


class Performance(NamedTuple):
    """What a propeller does with a power."""

    advance_ratio: Values
    """[-]"""
    pitch: Values | None = None
    """[rad]; like the others None where powers are schedules."""
    compressibility: Values | None = None
    """Factor on the thrust [-]."""
    thrust: Values | None = None
    """[N]"""


class Borne(NamedTuple):
    """What the wing has to bear."""

    mass: float
    """Of the aircraft at the start [kg]."""
    burnt: float
    """By all engines so far [kg]."""
    reference: float
    """What a lift coefficient of 1 bears: q S [N]."""

    @property
    def weight(self) -> float:
        """Now [N]."""
        return (self.mass - self.burnt) * GRAVITY


class Wanted(NamedTuple):
    """What an interval asks of a propeller; both are None where the machines' power is given."""

    power: float | None = None
    """Of its shaft [W]."""
    pitch: float | None = None
    """Blade angle that takes it [rad]; None where powers are schedules."""


def wanted_of(blades: Blades, mission: Mission, moment: Moment, *, burnt: float) -> Wanted:
    """Return what an interval asks of a propeller: power, and the blade angle that was chosen for it.

    Two blade angles take the same power, one on either side of the angle of least power. So the angle is never found
    again from the power: it is the one that is held, or the one that gives the thrust, which only rises with the angle
    until the blades stall. Only where the machines' power is given the angle follows from it, on the coarse side, which
    is the one that a governor finds (`performed`).

    Args:
        blades: The propeller.
        mission: With phases and aircraft.
        moment: Where it is flown.
        burnt: Fuel that all engines have burnt so far [kg].

    Raises:
        DesignError: Pitch or thrust lie outside the map.
    """
    phase = mission.phases[moment.phase]
    if moment.power is None and mission.rotorcraft is not None:
        return Wanted(trimmed(mission.rotorcraft, mission, moment, diameter=blades.diameter, burnt=burnt).main)
    if moment.power is not None or blades.chart is None:
        return Wanted()
    advance = diameter, turns, ratio = _advance(blades, moment)
    chart = map_at(blades.chart, _tip_mach(advance, moment))
    angle = phase.pitch
    if angle is None:
        needed = _needed_thrust(mission, moment, phase, burnt)
        thrust = needed / (moment.air.density * turns**2 * diameter**4)
        try:
            angle = angle_for_thrust(chart, ratio, _incompressible(blades.map_name, moment, advance, thrust))
            if phase.kind != "taxi":  # on the ground blades may be that fine
                _refuse_ungoverned(chart, ratio, angle)
        except DesignError as error:
            raise _too_steep(error, moment, phase, needed) from None
    return Wanted(coefficients(chart, ratio, angle).power * moment.air.density * turns**3 * diameter**5, angle)


def _refuse_ungoverned(chart: PropellerMap, ratio: float, angle: float) -> None:
    """Refuse blades below the angle of least power, where a finer pitch takes more: no governor holds a speed there."""
    if not governs(chart, ratio, angle):
        message = (
            f"blades at {math.degrees(angle):.3g}° give the thrust, below the angle of least power, where no governor"
            " holds the speed; ask for less braking, or give pitch"
        )
        raise DesignError([Problem("propeller", message)])


def _advance(blades: Blades, moment: Moment) -> Advance:
    turns = moment.propeller_speed / (2.0 * math.pi)
    return Advance(blades.diameter, turns, moment.true_airspeed / (turns * blades.diameter))


def _needed_thrust(mission: Mission, moment: Moment, phase: Phase, burnt: float) -> float:
    """Return the thrust of one propeller: (D + m g sin γ + m dV/dt)/engines with D = q S (C_D0 + k C_L²)."""
    aircraft = mission.aircraft
    if aircraft is None:  # `mission_problems` refuses it
        raise DesignError([Problem("aircraft", "a phase needs a thrust; give an [aircraft]")])
    _refuse_empty(aircraft, burnt)
    if phase.kind is not None:
        return stated_thrust(aircraft, phase, moment, aircraft.mass - burnt) / (phase.engines or mission.engines)
    dynamic = 0.5 * moment.air.density * moment.true_airspeed**2 * aircraft.wing_area
    borne = Borne(aircraft.mass, burnt, dynamic)
    _refuse_no_flight(moment, borne)
    weight = borne.weight
    slope = moment.climb / moment.true_airspeed
    lift = weight * math.sqrt(1.0 - slope**2) / dynamic
    drag_force = dynamic * (aircraft.zero_lift_drag + phase.extra_drag + aircraft.induced * lift**2)
    return float(drag_force + weight * (slope + moment.acceleration / GRAVITY)) / (phase.engines or mission.engines)


def _too_steep(error: DesignError, moment: Moment, phase: Phase, thrust: float) -> DesignError:
    """Return what is wrong with a thrust that the propeller does not give; one that brakes is named as such."""
    if thrust >= 0.0 or phase.kind is None:
        return error
    speed, sink = moment.true_airspeed, -moment.climb
    message = (
        f"at {speed:.4g} m/s, sinking {max(sink, 0.0):.3g} m/s and gaining {moment.acceleration:.3g} m/s², the aircraft"
        f" is held by less than it weighs down the path: a propeller would have to brake by {-thrust / 1e3:.3g} kN, and"
        " governed it does not; sink or slow down more gently, set flaps, turn the propeller at another speed, or fly a"
        " map in all states (6-blades-af115-all-states)"
    )
    return DesignError([Problem("descent", message)])


def windmilling(error: DesignError, blades: Blades, moment: Moment, wanted: Wanted) -> DesignError:
    """Return why machines cannot take what the air puts into a propeller that has to brake an aircraft.

    Args:
        error: What is wrong with the machines.
        blades: The propeller.
        moment: Where it is flown.
        wanted: Of the propeller.
    """
    if wanted.power is None or wanted.power >= 0.0 or wanted.pitch is None or moment.climb >= 0.0:
        return error
    _, thrust = thrust_at(blades, moment, wanted.pitch)
    message = (
        f"sinking {-moment.climb:.3g} m/s at {moment.true_airspeed:.4g} m/s, drag holds the aircraft by less than it"
        f" weighs down the path: each propeller brakes by {-thrust / 1e3:.3g} kN and the air drives it with"
        f" {-wanted.power / 1e3:.4g} kW; sink or slow down more gently, or set flaps"
    )
    return DesignError([Problem("descent", message), *error.problems])


def _refuse_empty(aircraft: Aircraft, burnt: float) -> None:
    """Refuse fuel that is not on board."""
    if aircraft.fuel is not None and burnt > aircraft.fuel:
        message = f"{burnt:.4g} kg are burnt, and {aircraft.fuel:.4g} kg are on board; take more, or fly shorter"
        raise DesignError([Problem("aircraft.fuel", message)])


def _refuse_no_flight(moment: Moment, borne: Borne) -> None:
    """Refuse what no wing does."""
    if borne.weight <= 0.0:
        message = (
            f"{borne.burnt:.4g} kg of fuel are burnt, and the aircraft has {borne.mass:.4g} kg; give its mass, or fly"
            " shorter"
        )
        raise DesignError([Problem("aircraft.mass", message)])
    if borne.weight > LARGEST_LIFT * borne.reference:
        message = (
            f"at {moment.true_airspeed:.3g} m/s no wing bears {borne.weight / 1e3:.4g} kN; fly faster, or give power"
            " or pitch"
        )
        raise DesignError([Problem("aircraft", message)])
    if abs(moment.climb) > moment.true_airspeed:
        message = f"climbs {moment.climb:.3g} m/s at {moment.true_airspeed:.3g} m/s; fly faster, or climb slower"
        raise DesignError([Problem("aircraft", message)])


def _incompressible(name: str, moment: Moment, advance: Advance, thrust: float) -> float:
    """Return the C_T of the map that compressibility brings down to a thrust coefficient."""
    estimate = thrust
    for _ in range(SQUEEZED_ROUNDS):
        estimate = thrust / _factor(name, moment, advance, estimate)
    return estimate


def _factor(name: str, moment: Moment, advance: Advance, thrust: float) -> float:
    return compressed(name, advance.ratio, thrust, mach=moment.mach, tip_mach=_tip_mach(advance, moment))


def _tip_mach(advance: Advance, moment: Moment) -> float:
    return float(math.pi * advance.turns * advance.diameter / moment.air.sound_speed)


def thrust_at(blades: Blades, moment: Moment, pitch: float) -> tuple[float, float]:
    """Return power and thrust of a propeller whose blade angle is held [W], [N].

    Args:
        blades: The propeller, with a map.
        moment: Where it is flown.
        pitch: Blade angle [rad].

    Raises:
        DesignError: The point lies outside the map.
    """
    assert blades.chart is not None  # `mission_problems` refuses it
    advance = diameter, turns, ratio = _advance(blades, moment)
    found = coefficients(map_at(blades.chart, _tip_mach(advance, moment)), ratio, pitch)
    factor = _factor(blades.map_name, moment, advance, found.thrust)
    scale = moment.air.density * turns**2 * diameter**4
    return found.power * scale * turns * diameter, factor * found.thrust * scale


def performed(blades: Blades, moment: Moment, work: float, *, pitch: float | None = None) -> Performance:
    """Return what a propeller does with a power.

    Args:
        blades: The propeller.
        moment: Where it is flown.
        work: Power that reaches the propeller [W].
        pitch: Blade angle from which the power was found (`wanted_of`) [rad]; left out: the one that a governor finds.

    Raises:
        DesignError: The power lies outside the map, or the Mach number outside its charts.
    """
    density, advance = moment.air.density, _advance(blades, moment)
    if blades.chart is None:
        return Performance(advance.ratio)
    diameter, turns, ratio = advance
    chart = map_at(blades.chart, _tip_mach(advance, moment))
    angle = angle_for_power(chart, ratio, work / (density * turns**3 * diameter**5)) if pitch is None else pitch
    thrust = coefficients(chart, ratio, angle).thrust
    factor = _factor(blades.map_name, moment, advance, thrust)
    return Performance(ratio, angle, factor, factor * thrust * density * turns**2 * diameter**4)


# ----------------------------------------------------------------------------------------------------------------------
# Aircraft and propellers in many intervals at once: thrusts that paths need, angles that give them, what powers make.
# ----------------------------------------------------------------------------------------------------------------------


class Craft(NamedTuple):
    """Aircraft of intervals, shape (n,) each; mass is NaN where power or pitch are given."""

    mass: Floats
    """At the start of the flight [kg]."""
    fuel: Floats
    """On board; infinite where a mission does not say it [kg]."""
    area: Floats
    zero_lift: Floats
    induced: Floats
    friction: Floats
    roll_lift: Floats
    """Lift coefficient on the wheels [-]."""
    highest_lift: Floats
    """NaN where an aircraft does not say it [-]."""
    rolls: Floats
    """1 on the wheels, 0 in flight."""
    plain: Floats
    """1 where a phase has no kind."""

    @property
    def polar(self) -> Polar:
        """With flaps and gear; fields of shape (n,)."""
        return Polar(self.area, self.zero_lift, self.induced)

    @property
    def asks(self) -> Bools:
        """Where a thrust is asked."""
        return ~np.isnan(self.mass)

    def at(self, lanes: Ints) -> Craft:
        """Return the aircraft of some intervals.

        Args:
            lanes: Which.
        """
        return Craft(*(column[lanes] for column in self))


def craft_of(stretches: Sequence[Stretch], counts: Sequence[int]) -> Craft | None:
    """Return the aircraft of all intervals; None where none is asked for a thrust.

    Args:
        stretches: The phases of all flights.
        counts: Intervals of each.
    """
    rows = [_row(stretch) for stretch in stretches]
    if all(math.isnan(row[0]) for row in rows):
        return None
    return Craft(*np.repeat(np.array(rows), counts, axis=0).T.copy())


def _row(stretch: Stretch) -> tuple[float, ...]:
    phase, aircraft = stretch.phase, stretch.mission.aircraft
    if aircraft is None or phase.power is not None or phase.pitch is not None:
        return (math.nan,) * len(Craft._fields)
    plain, drag = phase.kind is None, polar_of(aircraft, phase)
    flaps = None if plain else aircraft.flaps(setting_of(phase))
    return (
        aircraft.mass,
        math.inf if aircraft.fuel is None else aircraft.fuel,
        drag.area,
        aircraft.zero_lift_drag + phase.extra_drag if plain else drag.zero_lift,
        drag.induced,
        friction_of(aircraft, phase),
        aircraft.roll_lift,
        math.nan if flaps is None else flaps.highest_lift,
        float(phase.kind == "taxi"),
        float(plain),
    )


def needed_thrust(craft: Craft, course: Course, burnt: Floats) -> tuple[Floats, Bools]:
    """Return the thrust of all propellers that paths need, shape (n,) [N], and where nothing flies so.

    Args:
        craft: The aircraft.
        course: Where they are.
        burnt: Fuel of all engines so far, shape (n,) [kg].

    Source: `path_thrust`.
    """
    speed, mass = course.true_airspeed, craft.mass - burnt
    slope = np.where(speed == 0.0, 0.0, course.climb / np.where(speed == 0.0, 1.0, speed))
    at = Attitude(course.air, speed, slope, craft.rolls)
    weight, reference = mass * GRAVITY, dynamic_force(craft.polar, course.air, speed)
    stalls = (craft.rolls == 0.0) & (weight > reference * craft.highest_lift)
    unborne = (craft.plain == 1.0) & ((weight > LARGEST_LIFT * reference) | (np.abs(course.climb) > speed))
    held = held_back(craft.polar, (craft.friction, craft.roll_lift), weight, at)
    thrust = path_thrust(held, mass, at, course.acceleration)
    return thrust, stalls | unborne | (mass <= 0.0) | (burnt > craft.fuel)


def angle_for_thrusts(blades: Blades, course: Course, craft: Craft, thrust: Floats) -> tuple[Floats, Floats, Bools]:
    """Return the blade angles that give thrusts [rad], the powers that they take [W], and what lies outside.

    Args:
        blades: The propeller, with a map.
        course: Where it is flown.
        craft: The aircraft.
        thrust: Of one propeller, shape (n,) [N].

    Source: `wanted_of`.
    """
    chart, (turns, ratio, tips) = _chart(blades), _turning(blades, course)
    wanted = thrust / (course.air.density * turns**2 * blades.diameter**4)
    estimate, outside = wanted, np.zeros(len(wanted), bool)
    for _ in range(SQUEEZED_ROUNDS):
        factor = squeezed_along(blades.map_name, ratio, estimate, mach=course.mach, tip_mach=tips)
        better, outside = wanted / factor.value, factor.outside
        if np.array_equal(better, estimate):
            break
        estimate = better

    def found(own: PropellerMap, ratio: Floats, estimate: Floats) -> tuple[Floats, Floats, Bools, Bools]:
        angle = angle_along(own, ratio, estimate, own.thrust)
        power, _, left = power_and_thrust(own, ratio, angle.value)
        return angle.value, power, ~governs_along(own, ratio, angle.value), angle.outside | left

    angle, taken, ungoverned, beyond = at_tips(chart, tips, found, ratio, estimate)
    power = taken * course.air.density * turns**3 * blades.diameter**5
    return angle, power, outside | beyond | ((craft.rolls == 0.0) & ungoverned)


def asked_power(blades: Blades, course: Course, pitch: Floats) -> tuple[Floats, Bools]:
    """Return the power of the propeller's shaft [W], NaN where the machines' power is given, and what lies outside.

    Args:
        blades: The propeller.
        course: Where it is flown.
        pitch: That is held, NaN where none is, shape (n,) [rad].

    Source: `wanted_of`.
    """
    power, outside = np.full(len(pitch), math.nan), np.zeros(len(pitch), bool)
    if blades.chart is None:
        return power, outside
    held = np.isnan(course.power) & ~np.isnan(pitch)
    if held.any():
        turns, ratio, tips = _turning(blades, course)
        taken, _, left = at_tips(blades.chart, tips[held], power_and_thrust, ratio[held], pitch[held])
        power[held] = taken * course.air.density[held] * turns[held] ** 3 * blades.diameter**5
        outside[held] = left
    return power, outside


def performance_along(blades: Blades, course: Course, work: Floats, *, pitch: Floats) -> tuple[Performance, Bools]:
    """Return what a propeller does with its powers, fields of shape (n,), and where its charts do not reach.

    Args:
        blades: The propeller.
        course: Where it is flown.
        work: Powers that reach it, shape (n,) [W].
        pitch: Blade angle from which the power was found, NaN where the machines' power is given, shape (n,) [rad].

    Source: `performed`.
    """
    turns, ratio, tips = _turning(blades, course)
    if blades.chart is None:
        return Performance(ratio), np.zeros(len(work), bool)
    density, held = course.air.density, np.isnan(course.power)

    def found(own: PropellerMap, ratio: Floats, taken: Floats, pitch: Floats) -> tuple[Floats, Floats, Bools]:
        governed = angle_along(own, ratio, taken, own.power)
        angle = np.where(np.isnan(pitch), governed.value, pitch)
        _, thrust, left = power_and_thrust(own, ratio, angle)
        return angle, thrust, (governed.outside & np.isnan(pitch)) | left

    taken = work / (density * turns**3 * blades.diameter**5)
    angle, thrust, outside = at_tips(blades.chart, tips, found, ratio, taken, np.where(held, pitch, math.nan))
    factor = squeezed_along(blades.map_name, ratio, thrust, mach=course.mach, tip_mach=tips)
    force = factor.value * thrust * density * turns**2 * blades.diameter**4
    return Performance(ratio, angle, factor.value, force), outside | factor.outside


def _chart(blades: Blades) -> PropellerMap | MachMap:
    assert blades.chart is not None  # `mission_problems` refuses it
    return blades.chart


def _turning(blades: Blades, course: Course) -> tuple[Floats, Floats, Floats]:
    """Return turns per second [1/s], advance ratio [-] and Mach number of the tips' rotation [-]."""
    turns = course.propeller_speed / (2.0 * math.pi)
    ratio = course.true_airspeed / (turns * blades.diameter)
    return turns, ratio, math.pi * turns * blades.diameter / course.air.sound_speed
