"""Loads of propellers and rotors on shafts in bearings, case by case: of use, of fatigue, and as limit loads.

What a design states holds in every case. What it leaves open is taken by default, and every case tells what of.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import GRAVITY, Floats, Force, Ratio, Torque, largest
from gearwright.machines import propeller_inertia, rotor_loads
from gearwright.machines.propeller_loads import (
    BLADES_SHARE,
    LIMIT_FACTOR,
    TORQUE_LIMIT,
    TORQUE_STOP,
    TURNING,
    WITH_TURNING,
    blades_inertia,
    disc_velocity,
    flight_thrust,
    gyroscopic_moment,
    incidence_of,
    once_per_turn,
    static_thrust,
)
from gearwright.machines.rotor_loads import HOVER_SHARE, tail_thrust_rise, usual_hub_moment
from gearwright.machines.rotors import blade_mass
from gearwright.spec import Airscrew, Design, Propeller
from gearwright.spec.design import AIRSCREW_LOADS, CONCEPT, FLIGHTS, FlightLoads, Rotor, shares_of
from gearwright.train import PowerFlow

# ----------------------------------------------------------------------------------------------------------------------
# The cases of an airscrew: rows of its loads, each of one load case of the design.
# ----------------------------------------------------------------------------------------------------------------------


Use = Literal["life", "fatigue", "limit"]
"""What a case is for: lives of bearings and fatigue; fatigue alone; yield, static safety and ultimate strength."""
ASSUMED = "assumed"
_OF_CASES = {"thrust": "thrust", "in_plane_force": "force", "hub_moment": "moment"}


@dataclass(frozen=True)
class AirscrewCase:
    """Loads of a propeller or a rotor on its shaft in one case."""

    airscrew: str
    name: str
    """Such as `climb`, `excitation factor 3`, `load factor 3.5`."""
    case: str
    """Load case of the design whose torques it goes with."""
    use: Use
    share: Ratio
    """Of what its load case lasts [-]; 0 of what counts for no life."""
    torque_factor: Ratio
    """Torque over that of its load case [-]."""
    thrust: Force
    """Along the shaft, away from the gears [N]."""
    force: Force
    """Across the shaft, weight among it [N]."""
    moment: Torque
    """At its place on the shaft, in the plane of the force [N m]."""
    origin: str
    """`stated`, or `assumed` with what was taken."""


def airscrew_cases(design: Design, flows: Mapping[str, PowerFlow], name: str) -> tuple[AirscrewCase, ...]:
    """Return the loads of a propeller or rotor in every case; none where all are stated, or the flow drives it.

    Args:
        design: With it.
        flows: Load cases of the design, by name.
        name: Of the propeller or rotor.

    Source: `machines.propeller_loads` and `machines.rotor_loads`; CS-23, -25, -27 and -29 as told there.
    """
    screw = design.airscrews[name]
    if len(screw.stated_loads) == len(AIRSCREW_LOADS):
        return ()
    reference = largest(flows, lambda case: abs(flows[case].machine_powers[name]))
    if not flows[reference].machine_powers[name] < 0.0:
        return ()
    if isinstance(screw, Propeller):
        found = _propeller(design, flows, name, screw, reference)
    elif isinstance(screw, Rotor):
        found = _rotor(design, flows, name, screw, reference)
    else:
        return ()
    return tuple(_with_stated(case, screw) for case in found)


def _with_stated(case: AirscrewCase, screw: Airscrew) -> AirscrewCase:
    """Return a case with what a design states of its loads in place of what is assumed."""
    stated = {_OF_CASES[key]: getattr(screw, key) for key in screw.stated_loads}
    if not stated:
        return case
    words = f"stated: {', '.join(key for key in AIRSCREW_LOADS if key in screw.stated_loads)}; {case.origin}"
    return replace(case, origin=words, **stated)


def loads_table(design: Design, flows: Mapping[str, PowerFlow]) -> tuple[AirscrewCase, ...]:
    """Return the loads of every propeller and rotor in every case, stated or assumed; none of a concept.

    On a shaft without bearings what is assumed acts on nothing: no moment on a span that nobody laid out.

    Args:
        design: As read.
        flows: Load cases of the design, by name.
    """
    if design.level == CONCEPT:
        return ()
    rows = list[AirscrewCase]()
    for name, screw in design.airscrews.items():
        stated = AirscrewCase(
            name, "every case", "", "life", 1.0, 1.0, screw.thrust, screw.in_plane_force, screw.hub_moment, "stated"
        )
        rows += airscrew_cases(design, flows, name) or ([stated] if screw.stated_loads else [])
    return tuple(rows)


class UsualLoads(NamedTuple):
    """What an airscrew puts on its shaft in usual flight."""

    thrust: float
    """[N]"""
    force: float
    """Across the shaft [N]."""
    moment: float
    """[N m]"""


def usual_loads(design: Design, flows: Mapping[str, PowerFlow], name: str, *, in_bearings: bool) -> UsualLoads:
    """Return the stated loads of an airscrew; what is assumed in bearings by the cubic mean over the cases of use.

    Args:
        design: With it.
        flows: Load cases of the design, by name.
        name: Of the propeller or rotor.
        in_bearings: Whether the design gives its shaft bearings.
    """
    screw, shares = design.airscrews[name], shares_of(design)
    lasting = [case for case in airscrew_cases(design, flows, name) if case.use == "life"] if in_bearings else []
    weights = np.array([case.share * (shares.get(case.case, 0.0) if shares else 1.0) for case in lasting])
    if not weights.sum() > 0.0:
        return UsualLoads(screw.thrust, screw.in_plane_force, screw.hub_moment)
    loads = np.array([(case.thrust, case.force, case.moment) for case in lasting])
    means = np.cbrt(weights @ loads**3 / weights.sum())
    return UsualLoads(*means.tolist())


def usual_thrust(design: Design, flows: Mapping[str, PowerFlow], shaft: str, *, in_bearings: bool) -> float:
    """Return the thrust of all airscrews on a shaft in usual flight [N].

    Args:
        design: With them.
        flows: Load cases of the design, by name.
        shaft: Its name.
        in_bearings: Whether the design gives it bearings.
    """
    screws = [name for name, screw in design.airscrews.items() if screw.shaft == shaft]
    return sum(usual_loads(design, flows, name, in_bearings=in_bearings).thrust for name in screws)


# ----------------------------------------------------------------------------------------------------------------------
# Propellers: take-off, climb and cruise for life, an excitation factor for fatigue, manoeuvres and peaks as limits.
# ----------------------------------------------------------------------------------------------------------------------


class Flown(NamedTuple):
    """A case of flight of a propeller by default."""

    share: float
    """Of the life [-]."""
    incidence: float
    """[rad]"""
    pace: float
    """Airspeed over the velocity (P/(2 ρ A))^(1/3) [-]."""
    efficiency: float
    """T V/P [-]."""


FLOWN: Mapping[str, Flown] = {
    "take-off": Flown(0.05, math.radians(10.0), 1.51, 0.72),
    "climb": Flown(0.10, math.radians(6.0), 2.13, 0.80),
    "cruise": Flown(0.85, math.radians(2.0), 3.14, 0.86),
}
"""Cases of flight, as of a regional turboprop: 62, 87.5 and 129 m/s of one with 2051 kW and 3.93 m."""
_WORDS = {"take": "take-off", "climb": "climb", "cruise": "cruise", "descent": "cruise", "hold": "cruise"}
"""Word in the name of a load case -> how it is flown; any other as climb."""


def flown_as(case: str) -> str:
    """Return the case of flight that a load case is taken for by its name.

    Args:
        case: Name of a load case.

    >>> flown_as("cruise-high"), flown_as("rated")
    ('cruise', 'climb')
    """
    return next((flight for word, flight in _WORDS.items() if word in case.lower()), "climb")


class _Hub(NamedTuple):
    """A propeller as its mass and its turning load the shaft."""

    weight: float
    """[N]"""
    inertia: float
    """[kg m²]"""
    words: str


def _hub(screw: Propeller) -> _Hub:
    """Return weight and inertia of a propeller with where they come from."""
    loads, blade = screw.loads, screw.loads.blade_mass or blade_mass(screw.diameter)
    mass = loads.mass or screw.blades * blade / BLADES_SHARE
    if screw.inertia is not None:
        inertia = screw.inertia
    elif loads.blade_mass is not None:
        inertia = float(blades_inertia(screw.blades, blade, screw.diameter))
    else:
        inertia = propeller_inertia(screw.diameter, screw.blades)
    return _Hub(GRAVITY * mass, inertia, f"{mass:.3g} kg, {inertia:.3g} kg m²")


class _Point(NamedTuple):
    """What a propeller does to its shaft at a point of flight, its mass left out."""

    thrust: float
    """[N]"""
    side: float
    """[N]"""
    moment: float
    """[N m]"""
    words: str


class _Turned(NamedTuple):
    """A propeller in a load case of its design."""

    screw: Propeller
    case: str
    power: float
    """That it takes [W]."""
    speed: float
    """[rad/s]"""
    pace: float
    """Velocity that scales its airspeeds [m/s]."""

    @property
    def pulse(self) -> float:
        """Moment over its mean: of two blades it swells from nothing to twice that [-]."""
        return 2.0 if self.screw.blades == 2 else 1.0

    @property
    def at_rest(self) -> float:
        """Thrust at rest [N]."""
        return float(static_thrust(self.power, self.screw.diameter))

    def flying(self, flight: str, factor: float | None = None) -> _Point:
        """Return what it does in a case of flight, or there at the incidence of an excitation factor."""
        flown, cases = FLOWN[flight], self.screw.loads.cases
        own = cases.get(self.case, cases.get(flight, FlightLoads()))
        airspeed = own.airspeed or flown.pace * self.pace
        angle = own.incidence if own.incidence is not None else flown.incidence
        angle = angle if factor is None else float(incidence_of(factor, airspeed))
        if not self.power > 0.0 or not self.speed:
            return _Point(0.0, 0.0, 0.0, "no power")
        thrust = min(float(flight_thrust(self.power, airspeed, flown.efficiency)), self.at_rest)
        found = once_per_turn(thrust, airspeed, angle, diameter=self.screw.diameter, speed=self.speed)
        words = f"as {flight}, {airspeed:.3g} m/s, {math.degrees(angle):.3g}° of incidence, η {flown.efficiency:g}"
        return _Point(thrust, float(found.force), self.pulse * float(found.moment), words)


NOTHING = _Point(0.0, 0.0, 0.0, "weight alone")


def _propeller(
    design: Design, flows: Mapping[str, PowerFlow], name: str, screw: Propeller, reference: str
) -> Iterator[AirscrewCase]:
    """Yield what a propeller does to its shaft."""
    hub = _hub(screw)
    pace = float(disc_velocity(-flows[reference].machine_powers[name], screw.diameter))
    turned = {
        case: _Turned(screw, case, max(-flow.machine_powers[name], 0.0), abs(flow.speeds[screw.shaft]), pace)
        for case, flow in flows.items()
    }

    def row(label: str, case: str, use: Use, at: _Point, *, share: float = 0.0, turning: float = 1.0,
            factor: float = 1.0) -> AirscrewCase:  # fmt: skip
        across = at.side + factor * hub.weight
        words = f"{ASSUMED}: {at.words}; {hub.words}" + (f"; torque x {turning:g}" if turning != 1.0 else "")
        moment = at.moment + across * screw.loads.overhang
        return AirscrewCase(name, label, case, use, share, turning, at.thrust, across, moment, words)

    usual = [(flight, reference, flight, FLOWN[flight].share) for flight in FLIGHTS] if not design.cases else [
        (case, case, flown_as(case), 1.0) for case in flows if not _is_static(design, case)
    ]  # fmt: skip
    for label, case, flight, share in usual:
        yield row(label, case, "life", turned[case].flying(flight), share=share)
    for case in (case for case in flows if _is_static(design, case)):
        yield row(case, case, "limit", NOTHING)
    own, excited = turned[reference], screw.loads.excitation_factor
    yield row(f"excitation factor {excited:g}", reference, "fatigue", own.flying("climb", excited))
    climb, given = own.flying("climb"), screw.loads.gyroscopic
    rates = TURNING[given] if isinstance(given, str) else tuple(given)
    resisted = own.pulse * float(gyroscopic_moment(hub.inertia, own.speed, math.hypot(*rates)))
    words = f"{rates[0]:g} and {rates[1]:g} rad/s of pitch and yaw, {climb.words}, n = {WITH_TURNING:g}"
    both = climb._replace(moment=climb.moment + resisted, words=words)
    yield row("turning", reference, "limit", both, turning=TORQUE_LIMIT, factor=WITH_TURNING)
    yield row(f"load factor {LIMIT_FACTOR:g}", reference, "limit", climb, turning=TORQUE_LIMIT, factor=LIMIT_FACTOR)
    rest = _Point(own.at_rest, 0.0, 0.0, "0.72 of the ideal disc's at rest")
    yield row("static thrust", reference, "limit", rest, turning=TORQUE_LIMIT)
    stop = NOTHING._replace(words="sudden stop or malfunction")
    yield row("torque peak", reference, "limit", stop, turning=TORQUE_STOP)


def _is_static(design: Design, case: str) -> bool:
    return case in design.cases and design.cases[case].static


# ----------------------------------------------------------------------------------------------------------------------
# Rotors of helicopters: usual flight, manoeuvres without end, and the load factor as a limit; tail rotors their peak.
# ----------------------------------------------------------------------------------------------------------------------


SMALL = 0.5
"""Diameter of a tail rotor over the main rotor's, at most [-]."""


def is_tail_rotor(design: Design, name: str) -> bool:
    """Tell whether a rotor is a tail rotor: less than half as large as another.

    Args:
        design: With its rotors.
        name: Of one.
    """
    return design.rotors[name].diameter < SMALL * max(rotor.diameter for rotor in design.rotors.values())


def _rotor(
    design: Design, flows: Mapping[str, PowerFlow], name: str, screw: Rotor, reference: str
) -> Iterator[AirscrewCase]:
    """Yield what a helicopter's rotor does to its mast."""
    loads, tail = screw.loads, is_tail_rotor(design, name)
    weight = float(static_thrust(-flows[reference].machine_powers[name], screw.diameter, share=HOVER_SHARE))
    said = f"{weight / 1e3:.3g} kN hover at the power of {reference}, figure of merit 0.7; {loads.hub} hub"

    def row(label: str, case: str, use: Use, factor: float, *, turned: float = 1.0, more: float = 1.0) -> AirscrewCase:
        thrust = factor * weight
        moment = more * float(usual_hub_moment(loads.hub, weight if use == "limit" else thrust, screw.diameter))
        words = f"{factor:.3g} x {said}" + (f", torque x {turned:g}" if turned != 1.0 else "")
        lasting, across = 1.0 if use == "life" else 0.0, loads.h_force * thrust
        return AirscrewCase(name, label, case, use, lasting, turned, thrust, across, moment, f"{ASSUMED}: {words}")

    for case, flow in flows.items():
        if _is_static(design, case):
            words = f"{ASSUMED}: nothing but its torque"
            yield AirscrewCase(name, case, case, "limit", 0.0, 1.0, 0.0, 0.0, 0.0, words)
        else:
            yield row(case, case, "life", rotor_loads.USUAL_FACTOR if flow.speeds[screw.shaft] else 0.0)
    yield row("manoeuvres", reference, "fatigue", rotor_loads.TIRING_FACTOR)
    if tail:
        peak = rotor_loads.TAIL_PEAK / rotor_loads.TAIL_SHARE
        yield row("yaw", reference, "limit", tail_thrust_rise(), turned=peak, more=rotor_loads.LIMIT_MOMENT)
    else:
        yield row(f"load factor {loads.load_factor:g}", reference, "limit", loads.load_factor,
                  turned=rotor_loads.TORQUE_LIMIT, more=rotor_loads.LIMIT_MOMENT)  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# Rows of loads on one shaft: those of its airscrew, or the load cases of the design where it has none by default.
# ----------------------------------------------------------------------------------------------------------------------


class LoadRow(NamedTuple):
    """One row of loads on a shaft."""

    name: str
    case: int
    """Number of the load case of the design whose torques it takes [-]."""
    use: Use
    share: float
    """Of what that case lasts [-]."""
    torque_factor: float
    """[-]"""


class AirscrewRows(NamedTuple):
    """What one airscrew puts on its shaft, row by row."""

    thrust: Floats
    """[N], (rows,)"""
    force: Floats
    """[N], (rows,)"""
    moment: Floats
    """[N m], (rows,)"""


def shaft_rows(
    design: Design, flows: Mapping[str, PowerFlow], shaft: str, *, in_bearings: bool
) -> tuple[tuple[LoadRow, ...], dict[str, AirscrewRows]]:
    """Return the rows of loads on a shaft, and what each of its airscrews does in them.

    Without bearings there is no span that anybody laid out, so that nothing is assumed; nor where several airscrews on
    one shaft, as on one that is split, leave their loads open: then what is stated holds.

    Args:
        design: As read.
        flows: Load cases by name.
        shaft: Its name.
        in_bearings: Whether the design gives it bearings.

    Returns:
        Rows, empty where every load case of the design is one; airscrew -> its loads in them.
    """
    screws = {name: screw for name, screw in design.airscrews.items() if screw.shaft == shaft}
    assumed = {name: cases for name in screws if in_bearings and (cases := airscrew_cases(design, flows, name))}
    if len(assumed) != 1:
        return (), _stated(screws, len(flows))
    ((own, cases),) = assumed.items()
    order = list(flows)
    rows = tuple(LoadRow(case.name, order.index(case.case), case.use, case.share, case.torque_factor) for case in cases)
    loads = _stated(screws, len(rows))
    loads[own] = AirscrewRows(*(np.array([getattr(case, key) for case in cases]) for key in AirscrewRows._fields))
    return rows, loads


def _stated(screws: Mapping[str, Airscrew], count: int) -> dict[str, AirscrewRows]:
    """Return what a design states of airscrews, the same in every row."""
    return {
        name: AirscrewRows(*(np.full(count, load) for load in (screw.thrust, screw.in_plane_force, screw.hub_moment)))
        for name, screw in screws.items()
    }
