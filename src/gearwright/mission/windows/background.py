"""Mission quantities over time in an event window: torques, losses, air and airspeed, and their curves."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.base import DesignError, Floats, Problem
from gearwright.mission.flight import Flight, History
from gearwright.mission.gearbox import (
    Gearbox,
    Point,
    balanced,
    drag_of,
    flown_airscrew,
    gearbox_of,
    no_losses,
    point_of,
    stage_losses,
)
from gearwright.mission.plant import flown_oil
from gearwright.mission.profile import moments
from gearwright.mission.strategies import driven
from gearwright.mission.supply import Supply, dragged_along, supply_of
from gearwright.spec import Phase, WindowRules, engine_out as out_of_engines

# ----------------------------------------------------------------------------------------------------------------------
# What a mission asks during a window of it: machines' torques, losses, air, airspeed and set speed against time.
# ----------------------------------------------------------------------------------------------------------------------


Curve = list[tuple[float, float]]
"""(time from the window's start [s], value)."""


class Turning(NamedTuple):
    """How the gearbox turns at one instant."""

    speed: float
    """Of the propeller [rad/s]."""
    spin_up: float
    """Power into everything that turns [W]."""


class GearboxEquilibrium(NamedTuple):
    """The gearbox in equilibrium at one instant, as curves need it."""

    torques: Mapping[str, float]
    """Machine -> torque without its own drag, with what spins the train up [N m]."""
    resistances: Mapping[str, float]
    """Shaft -> torque that mesh losses take from it [N m]."""


class Brake(NamedTuple):
    """What holds a shaft until it stands, and then holds it."""

    machine: str
    """On whose shaft it acts."""
    torque: float
    """At most [N m]."""
    curve: Curve
    """Torque at the speed of the start, if nothing limited it [N m]."""
    speed: float
    """Of that shaft at the start [rad/s]."""
    creep: float
    """Part of it below which the torque falls with the speed [-]."""


@dataclass(frozen=True)
class Background:
    """What goes on in a window without its event."""

    flight: Flight
    gearbox: Gearbox
    supply: Supply
    phase: str
    """In which it starts."""
    start: float
    """From the start of the mission [s]."""
    torques: Mapping[str, Curve]
    """Machine -> its torque without drag [N m]."""
    resistances: Mapping[str, Curve]
    """Shaft -> torque of losses [N m]."""
    density: Curve
    """[kg/m³]"""
    airspeed: Curve
    """[m/s]"""
    speed: Curve
    """Set speed of the propeller [rad/s]."""
    pitch: Curve
    """Added to the governor's reference [rad]."""
    interval: int
    """Interval of the flight in which it starts."""
    limits: bool = True
    """False: a fault gives machines torques beyond their limits."""
    held_speed: Curve | None = None
    """What the propeller's governor holds in place of the set speed [rad/s]."""
    strike: Curve | None = None
    """Torque that stops the propeller, negative [N m]."""
    brake: Brake | None = None
    """What brings everything to rest."""


def background(flight: Flight, rules: WindowRules) -> Background:
    """Return what a mission asks during a window.

    Machines follow the mission into the next phase, within `over`. Air and airspeed stay those of the phase in which
    the window starts: between two phases the mission leaves the aircraft's acceleration out, which takes longer than a
    window.

    Args:
        flight: As flown.
        rules: Where the window lies.
    """
    phase, at, duration, over = rules.phase, rules.at, rules.duration, rules.over
    oil = flown_oil(flight.sizing, flight.mission)
    gearbox = gearbox_of(flight.sizing, flown_airscrew(flight.sizing), oil)
    supply = supply_of(flight.sizing, flight.mission, flight.engine_deck)
    history, in_phase = flight.history, np.flatnonzero(np.array(flight.phase) == phase)
    first = history.time - 0.5 * history.duration
    start = float(first[in_phase[0]]) + at
    seen = np.flatnonzero((first + history.duration > start) & (first < start + duration))
    seen = np.union1d(seen, np.clip(seen + 1, 0, len(first) - 1))
    seen = np.union1d(seen, np.clip(seen - 1, 0, len(first) - 1))
    stages = {int(k): _stage(flight, gearbox, supply, int(k)) for k in seen}
    times = _knots(flight, stages, start, over)
    air = [(float(history.time[k]) - start, int(k)) for k in in_phase]
    names, shafts = gearbox.machines, set(_shafts(gearbox).values()) if rules.losses else set()
    return Background(
        flight=flight,
        gearbox=gearbox,
        supply=supply,
        phase=phase,
        start=start,
        torques={name: [(time, stages[k].torques[name]) for time, k in times] for name in names},
        resistances={shaft: [(time, stages[k].resistances[shaft]) for time, k in times] for shaft in shafts},
        density=[(time, float(history.air_density[k])) for time, k in air],
        airspeed=[(time, float(history.true_airspeed[k])) for time, k in air],
        speed=_speed_curve(history, seen, start),
        pitch=steady(0.0),
        interval=int(np.searchsorted(first, start, side="right")) - 1,
    )


def _knots(
    flight: Flight, stages: Mapping[int, GearboxEquilibrium], start: float, over: float
) -> list[tuple[float, int]]:
    """Return (time, interval): middles of intervals, and both ends of what happens between two phases."""
    history, knots = flight.history, list[tuple[float, int]]()
    for k in sorted(stages):
        begin = float(history.time[k] - 0.5 * history.duration[k]) - start
        if k - 1 in stages and flight.phase[k] != flight.phase[k - 1]:
            knots += [(begin, k - 1), (begin + over, k)]
        middle = float(history.time[k]) - start
        if not knots or middle > knots[-1][0]:
            knots.append((middle, k))
    return knots


def _speed_curve(history: History[Floats], seen: NDArray[np.intp], start: float) -> Curve:
    """Return the set speed at the edges of intervals."""
    length, speed, gain = history.duration, history.propeller_speed, history.propeller_gain
    edges = [(float(history.time[k] - 0.5 * length[k]) - start, float(speed[k] - 0.5 * gain[k])) for k in seen]
    last = seen[-1]
    end = (float(history.time[last] + 0.5 * length[last]) - start, float(speed[last] + 0.5 * gain[last]))
    return [*edges, end]


def _stage(flight: Flight, gearbox: Gearbox, supply: Supply, k: int) -> GearboxEquilibrium:
    phase = flown_phase(flight, k)
    powers = {name: float(flight.machines[name].power[k]) for name in gearbox.machines}
    return staged(gearbox, supply, phase, powers=powers, turning=turning_at(flight, k))


def flown_phase(flight: Flight, k: int) -> Phase:
    """Return the phase of an interval as it was driven there: a strategy's share may change within it.

    Args:
        flight: As flown.
        k: Number of the interval.
    """
    phase = flight.mission.phases[flight.phase[k]]
    return driven(phase, float(flight.history.electric_share[k])) if phase.strategy is not None else phase


def turning_at(flight: Flight, k: int) -> Turning:
    """Return how the gearbox turns in an interval of a flight.

    Args:
        flight: As flown.
        k: Number of the interval.
    """
    return Turning(float(flight.history.propeller_speed[k]), float(flight.history.spin_up[k]))


def changed_stage(
    back: Background, rules: WindowRules, phase: Phase, powers: Mapping[str, float]
) -> GearboxEquilibrium:
    """Return the gearbox in equilibrium with what machines give after a window's event.

    Args:
        back: What goes on.
        rules: With the window's name of the event.
        phase: Whose mode says which machines carry drag and spin-up.
        powers: Machine -> power into the train [W].

    Raises:
        DesignError: A turbine cannot give its power where the window is flown.
    """
    flight, k = back.flight, back.interval
    moment = next(islice(moments(flight.mission, flight.paths), k, None))
    rating = flight.mission.engine.contingency if out_of_engines(flight.mission, phase) else 1.0
    for name in back.supply.engines:
        power, speed = powers[name], abs(float(flight.machines[name].speed[k]))
        try:
            back.supply.limited(name, moment._replace(power=power), power=power, speed=speed, rating=rating)
        except DesignError as error:
            raise DesignError([Problem("windows", f"{rules.event}: {one}") for one in error.problems]) from None
    return staged(back.gearbox, back.supply, phase, powers=powers, turning=turning_at(flight, k))


def staged(
    gearbox: Gearbox, supply: Supply, phase: Phase, *, powers: Mapping[str, float], turning: Turning
) -> GearboxEquilibrium:
    """Return the gearbox in equilibrium at an interval's speed, with machines of given powers.

    Args:
        gearbox: The gearbox.
        supply: Its machines.
        phase: Whose mode says which machines carry drag and spin-up.
        powers: Of the machines, with drag and spin-up, as the flight records them [W].
        turning: Speed and spin-up of that interval.
    """
    train, (speed, gain), parts = gearbox.sizing.train, turning, supply.parts(phase)
    turns, oil, drag = np.array([speed]), np.full(1, np.nan), np.zeros(1)
    given = np.array([[powers[name] for name in gearbox.machines]])
    share = np.where(given == 0.0, 0.0, [[parts.get(name, 0.0) for name in gearbox.machines]])
    point = _balanced(gearbox, given, turns, no_losses(gearbox, 1))
    for _ in range(3):  # drag follows from the loads, which it hardly changes
        parted = stage_losses(gearbox, point.mesh_torques, point.speeds, oil)
        point = _balanced(gearbox, given - share * (drag + gain), turns, parted)
        nodes = dict(zip(train.nodes, np.abs(point.speeds).T, strict=True))
        speeds = {name: nodes[train.machines[name]] for name in gearbox.machines}
        dragged = dragged_along(supply, {name: np.array([name in parts]) for name in supply.motors}, speeds)
        drag = sum(drag_of(gearbox, point.mesh_torques, point.speeds, oil)) + dragged
    lost, turned = float(drag[0]), {name: float(value[0]) for name, value in nodes.items()}
    torques = {
        name: (power - parts.get(name, 0.0) * lost) / turned[train.machines[name]] for name, power in powers.items()
    }
    return GearboxEquilibrium(torques, _resistances(gearbox, point.mesh_losses[0], turned))


def _balanced(gearbox: Gearbox, powers: Floats, speed: Floats, lost: Floats) -> Point:
    carried = balanced(gearbox, powers, speed, lost)
    if carried.faults[0] is not None:
        raise carried.faults[0]
    return point_of(gearbox, carried)


def _resistances(gearbox: Gearbox, losses: Floats, speeds: Mapping[str, float]) -> dict[str, float]:
    """Return the losses of each stage's meshes as a torque on its first shaft that turns."""
    train = gearbox.sizing.train
    resistances = dict.fromkeys(_shafts(gearbox).values(), 0.0)
    for mesh, loss in zip(train.meshes, losses, strict=True):
        shaft = _shafts(gearbox)[mesh.stage]
        resistances[shaft] += float(loss) / speeds[shaft]
    return resistances


def _shafts(gearbox: Gearbox) -> dict[str, str]:
    """Return the first shaft of each stage: of gear a, else the carrier, else of gear b."""
    train, first_shafts = gearbox.sizing.train, dict[str, str]()
    for mesh in train.meshes:
        shafts = [node for node in (mesh.nodes[0], mesh.nodes[2], mesh.nodes[1]) if node in train.nodes]
        first_shafts.setdefault(mesh.stage, next(node for node in shafts if node not in train.planet_nodes))
    return first_shafts


# ----------------------------------------------------------------------------------------------------------------------
# Curves of a window: values, steps, blends.
# ----------------------------------------------------------------------------------------------------------------------


LAGS = 8.0
"""Time constants after which what decays is gone: 3e-4 is left [-]."""
LAG_POINTS = 80
"""Points of a decay: straight lines between them are off by 1e-3 of it."""


def value_at(curve: Curve, time: float) -> float:
    """Return a curve's value; it is held before its first and after its last point.

    Args:
        curve: (time [s], value).
        time: [s].
    """
    times, values = zip(*curve, strict=True)
    return float(np.interp(time, times, values))


def steady(value: float) -> Curve:
    """Return a curve that stays at a value.

    Args:
        value: In the curve's unit.
    """
    return [(0.0, value)]


def stepped(curve: Curve, rules: WindowRules, change: float) -> Curve:
    """Return a curve that is higher by a change after the event.

    Args:
        curve: (time [s], value).
        rules: When, and how long it takes.
        change: In the curve's unit.
    """
    return blended(curve, [(time, value + change) for time, value in curve], rules)


def blended(before: Curve, after: Curve, rules: WindowRules) -> Curve:
    """Return one curve that becomes another while the event lasts.

    Args:
        before: (time [s], value).
        after: The same.
        rules: When, and how long it takes.
    """
    start, end = rules.event_at, rules.event_at + rules.over
    times = sorted({start, end, *(time for curve in (before, after) for time, _ in curve)})
    share = np.clip((np.array(times) - start) / rules.over, 0.0, 1.0)
    return [
        (time, (1.0 - part) * value_at(before, time) + part * value_at(after, time))
        for time, part in zip(times, share.tolist(), strict=True)
    ]


def until(curve: Curve, rules: WindowRules) -> Curve:
    """Return what a curve does before the event.

    Args:
        curve: (time [s], value).
        rules: When the event is.
    """
    first = [(time, value) for time, value in curve if time < rules.event_at]
    return [*first, (rules.event_at - 1e-9, value_at(curve, rules.event_at))]


def lagged(before: Curve, after: float, rules: WindowRules) -> Curve:
    """Return a curve that goes to a value with the event's time constant.

    Args:
        before: (time [s], value).
        after: Value in the end.
        rules: When, and by which lag.
    """
    lag = rules.lag or 1.0
    late = np.linspace(0.0, LAGS * lag, LAG_POINTS + 1)
    values = after + (value_at(before, rules.event_at) - after) * np.exp(-late / lag)
    values[-1] = after
    return [*until(before, rules), *zip((rules.event_at + late).tolist(), values.tolist(), strict=True)]
