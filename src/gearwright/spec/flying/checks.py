"""What does not fit together in a mission: phases, powers, altitudes, battery, steel, oil."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from gearwright.air import height
from gearwright.catalogue import USUAL_HARDNESS, gear_steel
from gearwright.errors import DesignError, Problem, near
from gearwright.spec.checks import STEEL_KEYS
from gearwright.spec.flying.aircraft import aircraft_problems, kind_problems
from gearwright.spec.flying.strategies import strategy_problems
from gearwright.spec.missions import NO_MAP, BatteryRules, GearLifeRules, Mission, OilRules, Phase, window_problems
from gearwright.spec.power import WindingRules

_SAME_ALTITUDE = 0.1
"""Altitudes nearer than this are the same [m]."""
SLOWEST = 30.0
"""Airspeed of a cruise over a distance, for a count of intervals before it is flown [m/s]."""
MOST_INTERVALS = 10_000
"""Intervals into which a mission may be cut: some seconds of work, and a day of flight in steps of ten [-]."""


def mission_problems(mission: Mission) -> list[Problem]:
    """Return what does not fit together in a mission.

    Args:
        mission: Typed, but not yet checked.
    """
    problems: list[Problem] = []
    last: float | None = None
    for name, phase in mission.phases.items():
        messages = (*_plain(phase, mission, last), *_drive(phase, mission), *_start(phase, last))
        problems += [Problem(f"phases.{name}", message) for message in messages]
        last = phase.altitude
    problems += aircraft_problems(mission)
    if mission.rotorcraft is not None and (mission.aircraft is not None or mission.propeller_map != NO_MAP):
        message = f'a helicopter has neither wing nor propeller; leave [aircraft] out, propeller_map = "{NO_MAP}"'
        problems.append(Problem("rotorcraft", message))
    problems += strategy_problems(mission)
    problems += _network(mission)
    problems += _shares(mission.motor.loss_shares)
    problems += [
        *_steel(mission.gears),
        *_battery(mission.battery),
        *_cells(mission.battery),
        *_windings(mission.motor.heat),
        *_dips(mission.oil),
    ]
    if not problems:
        problems += _intervals(mission)
    return [*problems, *window_problems(mission.windows, mission.phases, spools=mission.engine.spool is not None)]


def _battery(rules: BatteryRules | None) -> Iterator[Problem]:
    if rules is not None and rules.full_voltage_v < rules.empty_voltage_v:
        message = f"{rules.full_voltage_v:g} V is less than the {rules.empty_voltage_v:g} V at no charge; exchange them"
        yield Problem("battery.full_voltage_v", message)


def _cells(rules: BatteryRules | None) -> Iterator[Problem]:
    """Yield what is wrong with a curve of open-circuit voltage."""
    cells = rules.cells if rules else None
    if cells is None:
        return
    charges, voltages, at = cells.ocv_charge, cells.ocv_v, "battery.cells"
    if (charges is None) != (voltages is None):
        yield Problem(at, "a curve needs ocv_charge and ocv_v; give both, or none")
    elif charges and voltages:
        if len(charges) != len(voltages):
            yield Problem(
                f"{at}.ocv_v", f"{len(voltages)} voltages at {len(charges)} states of charge; give one for each"
            )
        if charges[0] != 0.0 or charges[-1] != 1.0 or any(b <= a for a, b in pairwise(charges)):
            yield Problem(f"{at}.ocv_charge", "they must rise from 0 to 1; sort them, and add the ends")
        if min(voltages) <= 0.0 or any(b < a for a, b in pairwise(voltages)):
            yield Problem(f"{at}.ocv_v", "they must be above 0 and never fall; exchange them")
    if cells.lowest_temperature_k >= cells.highest_temperature_k:
        message = (
            f"{cells.highest_temperature_k:g} K is not above the lowest, {cells.lowest_temperature_k:g} K; raise it"
        )
        yield Problem(f"{at}.highest_temperature_k", message)


def _network(mission: Mission) -> Iterator[Problem]:
    network = mission.oil.network
    if network is not None and network.dry_from is not None and network.dry_from not in mission.phases:
        message = f"there is no phase {network.dry_from!r}; {near(network.dry_from, mission.phases)}"
        yield Problem("oil.network.dry_from", message)


def _shares(shares: list[float] | None) -> Iterator[Problem]:
    if shares is not None and (min(shares) < 0.0 or abs(sum(shares) - 1.0) > 1e-6):
        message = f"parts of a loss are 0 or more and add up to 1, and these to {sum(shares):g}; change them"
        yield Problem("motor.loss_shares", message)


def _windings(rules: WindingRules | None) -> Iterator[Problem]:
    if rules is None:
        return
    for key in ("coolant_temperature_k", "start_temperature_k", "derate_from_k"):
        value = getattr(rules, key)
        if value is not None and value >= rules.highest_winding_k:
            message = f"{rules.highest_winding_k:g} K is not above {key}, {value:g} K; raise it, or lower the other"
            yield Problem("motor.heat.highest_winding_k", message)


def _dips(oil: OilRules) -> Iterator[Problem]:
    for gear, dip in oil.dip.items():
        if not 0.0 <= dip <= 1.0:
            yield Problem(f"oil.dip.{gear}", f"{dip:g} of a gear cannot dip into oil; give 0 to 1")


def _intervals(mission: Mission) -> Iterator[Problem]:
    """Yield that a mission has more intervals than can be flown."""
    count, altitude = 0.0, None
    for phase in mission.phases.values():
        start = phase.from_altitude if phase.from_altitude is not None else altitude
        climb, altitude = phase.altitude - (phase.altitude if start is None else start), phase.altitude
        duration = climb / phase.rate_of_climb if phase.rate_of_climb else phase.duration or 0.0
        duration += (phase.distance or 0.0) / SLOWEST
        count += duration / mission.step + 2.0
    if count > MOST_INTERVALS:
        message = (
            f"cuts the phases into {count:,.0f} intervals, at most {MOST_INTERVALS:,} are flown; longer steps help"
        )
        yield Problem("step", message)


def _steel(rules: GearLifeRules) -> list[Problem]:
    if rules.steel is None:
        return []  # a flight knows the material
    try:
        gear_steel(rules.steel, rules.grade or "MQ", rules.hardness_hv or USUAL_HARDNESS)
    except DesignError as error:
        return [
            Problem(f"gears.{STEEL_KEYS.get(problem.path, problem.path)}", problem.message)
            for problem in error.problems
        ]
    return []


def _plain(phase: Phase, mission: Mission, last: float | None) -> Iterator[str]:
    """Yield what is wrong with speed, power and altitude, by what a phase says of itself or of its aircraft."""
    if phase.kind is not None:
        yield from kind_problems(phase, mission, _first_altitude(phase, last))
        return
    for key in ("distance", "path_angle", "flaps", "end_speed"):
        if getattr(phase, key) is not None:
            yield f"{key} is read where an aircraft flies; give a kind too, or leave it out"
    yield from _speed(phase)
    yield from _power(phase, mission)
    yield from _altitude(phase, last)


def _first_altitude(phase: Phase, last: float | None) -> float:
    start = phase.from_altitude if phase.from_altitude is not None else last
    return phase.altitude if start is None else start


def _start(phase: Phase, last: float | None) -> Iterator[str]:
    start = _first_altitude(phase, last)
    if last is not None and abs(start - last) > _SAME_ALTITUDE:
        yield f"it starts at {height(start)}, but the phase before ended at {height(last)}; make them equal"


def _speed(phase: Phase) -> Iterator[str]:
    stated = [name for name in ("cas", "tas", "mach") if getattr(phase, name) is not None]
    if len(stated) != 1:
        yield f"{' and '.join(stated) or 'no speed'} given; give one of cas, tas and mach"
    if phase.from_cas is not None and phase.from_tas is not None:
        yield "from_cas and from_tas given; give one of them"


def _power(phase: Phase, mission: Mission) -> Iterator[str]:
    stated = [name for name in ("power", "pitch") if getattr(phase, name) is not None]
    if len(stated) > 1:
        yield "power and pitch given; the propeller's speed allows only one of them"
    craft = mission.rotorcraft
    if not stated and mission.aircraft is None and craft is None:
        yield "nothing sets its power; give power or pitch, or an [aircraft] that needs a thrust"
    if phase.power is None and mission.propeller_map == NO_MAP and (craft is None or phase.pitch is not None):
        yield "without a propeller map only a power can be flown; give power, or a propeller_map"
    if phase.end_power is not None and phase.power is None:
        yield "end_power without power; give both, or only power"


def _drive(phase: Phase, mission: Mission) -> Iterator[str]:
    """Yield what is wrong with who drives."""
    if phase.mode == "hybrid" and phase.electric_share is None:
        yield "hybrid without electric_share; give the motors' part of the power, such as 0.3"
    if phase.mode != "hybrid" and phase.electric_share is not None:
        yield f'electric_share in {phase.mode} mode; write mode = "hybrid", or leave it out'
    if phase.mode != "conventional" and mission.battery is None:
        yield f"{phase.mode} mode without a [battery]; give one with energy_kwh"
    if phase.engines is not None and phase.engines > mission.engines:
        yield f"{phase.engines} engines work of {mission.engines}; give at most those"


def _altitude(phase: Phase, last: float | None) -> Iterator[str]:
    start = _first_altitude(phase, last)
    climb = phase.altitude - start
    if (phase.duration is None) == (phase.rate_of_climb is None):
        yield "give one of duration and rate_of_climb"
    elif phase.rate_of_climb is not None and not phase.rate_of_climb * climb > 0.0:
        yield (
            f"a rate of climb of {phase.rate_of_climb:.3g} m/s never leads from {height(start)} to"
            f" {height(phase.altitude)}; turn its sign, or give a duration"
        )
