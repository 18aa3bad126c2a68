"""The verb: a mission flown quasi-steadily by a sized gearbox."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from gearwright.catalogue import propeller_map, read_propeller_map
from gearwright.errors import DesignError, Problem, near
from gearwright.machines import PropellerMap
from gearwright.mission.collect import Flown, Interval, collect
from gearwright.mission.flight import Flight
from gearwright.mission.gearbox import Oil, Point, drag, efficiencies, gearbox_of, operate
from gearwright.mission.profile import Moment, moments
from gearwright.mission.supply import supply_of
from gearwright.mission.thrust import performed, propeller_power
from gearwright.sizing import Sizing
from gearwright.spec import NO_MAP, Mission, engine_out, mission_problems
from gearwright.verbs import verb

TRIAL_POWER = 1e5
"""Power at which an operating point is found before it is scaled [W]; torques and powers are proportional."""


@verb
def fly(sizing: Sizing, mission: Mission, *, folder: Path | None = None) -> Flight:
    """Return the flight: what a mission asks of every shaft and mesh, and what it burns.

    Every interval is in equilibrium, with the power that spins the train up; the aircraft's own acceleration between
    two phases is left out. Drag and spin-up load the machines, not the meshes.

    Args:
        sizing: The sized transmission; it has one propeller.
        mission: What is flown, with one such gearbox for each of its engines.
        folder: Where a propeller map is looked for that is a file; left out: where the program runs.

    Raises:
        DesignError: A power that the machines cannot give, a battery that is empty or overloaded, a point outside the
            propeller map; with phase and time.

    Valid for: steady flight; a propeller map of one's own has the compressibility that it was measured with.
    """
    problems = mission_problems(mission)
    if problems:
        raise DesignError(problems)
    oil = Oil(mission.oil.inlet_temperature_k, mission.oil.roughness, _dipping(sizing, mission))
    flown = Flown(gearbox_of(sizing, _only_propeller(sizing), oil), mission, supply_of(sizing, mission))
    chart = _chart(mission, folder)
    charge = mission.battery.start_charge if mission.battery else 0.0
    burnt, intervals, point = 0.0, [], None
    for moment in moments(mission):
        try:
            values, point = _interval(flown, chart, moment, before=(point, charge, burnt))
        except DesignError as error:
            raise _placed(error, moment) from None
        intervals.append(Interval(moment.phase, values, point))
        charge = values["state_of_charge"]
        burnt += values["fuel_flow"] * moment.duration * (mission.phases[moment.phase].engines or mission.engines)
    return collect(flown, intervals, chart)


def _dipping(sizing: Sizing, mission: Mission) -> dict[str, float]:
    gears = [gear.name for gear in sizing.gears]
    unknown = [name for name in mission.oil.dip if name not in gears]
    if unknown:
        raise DesignError(
            [Problem(f"oil.dip.{name}", f"there is no gear {name!r}; {near(name, gears)}") for name in unknown]
        )
    return mission.oil.dip


def _only_propeller(sizing: Sizing) -> str:
    names = tuple(sizing.design.propellers)
    if len(names) != 1:
        raise DesignError([Problem("propellers", f"{len(names)} propellers; a mission is flown with one per gearbox")])
    return names[0]


def _chart(mission: Mission, folder: Path | None) -> PropellerMap | None:
    name = mission.propeller_map
    if name == NO_MAP:
        return None
    return read_propeller_map((folder or Path()) / name) if name.endswith(".csv") else propeller_map(name)


def _placed(error: DesignError, moment: Moment) -> DesignError:
    at = f"phases.{moment.phase}"
    return DesignError(
        [Problem(at, f"at {moment.time:.0f} s, {problem.path}: {problem.message}") for problem in error.problems]
    )


def _interval(
    flown: Flown, chart: PropellerMap | None, moment: Moment, *, before: tuple[Point | None, float, float]
) -> tuple[dict[str, float], Point]:
    """Return what is recorded of an interval, and the gearbox's operating point."""
    gearbox, mission, supply = flown
    last, charge, burnt = before
    parts = supply.parts(mission.phases[moment.phase])
    wanted = propeller_power(chart, gearbox, mission, now=(moment, burnt))
    spin_up = gearbox.inertia * moment.propeller_speed * moment.propeller_gain / moment.duration
    # Losses are those of the last interval's loads; where the loads change at once, they are found twice.
    point = _operating(flown, parts, moment, asked=(wanted, last, spin_up))
    if last is None or moment.starts_phase:
        point = _operating(flown, parts, moment, asked=(wanted, point, spin_up))
    friction, dragged = drag(gearbox, point), supply.dragged(gearbox, point, parts)
    carried = np.array([parts.get(name, 0.0) for name in gearbox.machines]) * (sum(friction) + dragged + spin_up)
    powers = point.machine_powers + carried
    lost = float(point.mesh_losses.sum())
    work = float(point.machine_powers.sum()) - lost
    rating = mission.engine.contingency if engine_out(mission, mission.phases[moment.phase]) else 1.0
    driven = supply.drive(gearbox, moment, (point, powers), (charge, rating, mission.phases[moment.phase].mode))
    return {
        **performed((mission.propeller_map, chart), gearbox, moment, work),
        **driven,
        "mesh_loss": lost,
        "bearing_loss": friction.bearings,
        "windage_loss": friction.windage,
        "churning_loss": friction.churning,
        "gearbox_heat": lost + sum(friction),
        "motor_loss": driven["motor_loss"] + dragged,
        "spin_up": spin_up,
    }, point


def _operating(
    flown: Flown, parts: Mapping[str, float], moment: Moment, *, asked: tuple[float | None, Point | None, float]
) -> Point:
    """Return the operating point for a propeller power, or for the machines' power where that is given.

    A propeller that the air drives has a negative power: it is found with machines that take power, so that losses
    stay losses.
    """
    gearbox, _, supply = flown
    wanted, last, spin_up = asked
    efficiency = efficiencies(gearbox, last) if last is not None else {}
    trial_power = math.copysign(TRIAL_POWER, wanted or 0.0)
    trial = {name: part * trial_power for name, part in parts.items()}
    point = operate(gearbox, trial, moment.propeller_speed, efficiency)
    if wanted is not None:
        return point.scaled(wanted / float(point.machine_powers.sum() - point.mesh_losses.sum()))
    before = point.scaled((moment.power or 0.0) / TRIAL_POWER)
    left = (moment.power or 0.0) - spin_up - sum(drag(gearbox, before)) - supply.dragged(gearbox, point, parts)
    if left <= 0.0:
        message = f"{(moment.power or 0.0) / 1e3:.4g} kW only spin the train up; give more, or a longer ramp_s"
        raise DesignError([Problem("power", message)])
    return point.scaled(left / TRIAL_POWER)
