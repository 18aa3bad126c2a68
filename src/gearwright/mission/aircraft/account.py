"""Forces of a flight, phase by phase: thrust beside drag, what is left over, and airspeeds that jump."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import Annotated, NamedTuple

from gearwright.mission.flight import Flight
from gearwright.mission.moments import Attitude, Moment, moments, resistance
from gearwright.showing import Shown
from gearwright.spec import Aircraft
from gearwright.units import GRAVITY, Distance, Force, Mass, Origin, Quantity, Time
from gearwright.verbs import verb

USUAL_LIFT = 1.5
"""C_L beyond which an aircraft that says nothing of its stall stands on its wheels [-]; an assumption."""


@dataclass(frozen=True, repr=False)
class PhaseForces(Shown):
    """Mean forces of a phase of a flight, of the whole aircraft."""

    name: str
    duration: Time
    """[s]"""
    distance: Distance
    """Through the air [m]."""
    roll: Annotated[float, Quantity("ground_roll")]
    """On the wheels [m]."""
    mass: Mass
    """At its start [kg]."""
    thrust: Force | None
    """Of all propellers [N]; None without a propeller map."""
    drag: Annotated[Force, Origin("q S (C_D0 + k C_L²) + μ (m g − L)", "drag polar of the mission")]
    """Of air and wheels [N]."""
    path: Annotated[Force, Origin("m (g sin γ + dV/dt)", "Newton")]
    """What height and speed of the path take [N]."""
    jump: Annotated[float, Quantity("velocity")]
    """Of the true airspeed, from the end of the phase before to its start [m/s]."""
    jump_acceleration: Annotated[float, Quantity("acceleration"), Origin("ΔV/Δt", "over one step of the mission")]
    """What the jump means if it takes one interval [m/s²]."""
    reserve: bool
    """True where it is flown for its fuel only."""

    @property
    def left_over(self) -> Force | None:
        """Thrust that the path does not explain [N]; near 0 where an aircraft flies the phase."""
        return None if self.thrust is None else self.thrust - self.drag - self.path

    @property
    def implied(self) -> Annotated[float | None, Quantity("acceleration")]:
        """Acceleration along the path that the thrust left over would mean [m/s²]."""
        return None if self.left_over is None else self.left_over / self.mass


class _Row(NamedTuple):
    """Of one interval, or sums over them times the duration."""

    duration: float
    distance: float
    roll: float
    thrust: float
    drag: float
    path: float


@verb
def phase_forces(flight: Flight) -> tuple[PhaseForces, ...]:
    """Return what thrust, drag and path of each phase come to; nothing where the mission has no aircraft.

    Args:
        flight: As flown; a phase that states its power is held against the drag polar too.

    Source: Newton along the path: T = D + μ (m g − L) + m g sin γ + m dV/dt.
    """
    aircraft = flight.mission.aircraft
    if aircraft is None:
        return ()
    return tuple(_phases(flight, aircraft))


def _phases(flight: Flight, aircraft: Aircraft) -> Iterator[PhaseForces]:
    mission, burnt, last = flight.mission, 0.0, None
    rows = enumerate(moments(mission, flight.paths))
    for name, group in groupby(rows, key=lambda row: row[1].phase):
        flown, phase, mass = list(group), mission.phases[name], aircraft.mass - burnt
        engines = phase.engines or mission.engines
        sums = list[_Row]()
        for (k, moment), stage in zip(flown, _stages(flight, aircraft, [moment for _, moment in flown]), strict=True):
            sums.append(_row(flight, aircraft, k, moment, stage=stage, mass=aircraft.mass - burnt))
            burnt += float(flight.history.fuel_flow[k]) * moment.duration * engines
        total = _Row(*(sum(column) for column in zip(*sums, strict=True)))
        starts, ends = (_at_end(flown[place][1], sense) for place, sense in ((0, -1.0), (-1, 1.0)))
        jump, last = 0.0 if last is None else starts - last, ends
        yield PhaseForces(
            name=name,
            duration=total.duration,
            distance=total.distance,
            roll=total.roll,
            mass=mass,
            thrust=None if flight.history.thrust is None else total.thrust / total.duration,
            drag=total.drag / total.duration,
            path=total.path / total.duration,
            jump=jump,
            jump_acceleration=jump / mission.step,
            reserve=phase.reserve,
        )


def _at_end(moment: Moment, sense: float) -> float:
    """Return the true airspeed at the end of an interval, or at its start where the sense is -1 [m/s]."""
    return moment.true_airspeed + sense * 0.5 * moment.acceleration * moment.duration


def _stages(flight: Flight, aircraft: Aircraft, flown: list[Moment]) -> tuple[str, ...]:
    """Return what the aircraft does in the intervals of a phase: on its wheels where no wing bears it."""
    name, weight = flown[0].phase, aircraft.mass * GRAVITY
    if name in flight.paths:
        return flight.paths[name].stages
    highest = (aircraft.highest_lift or USUAL_LIFT) * aircraft.wing_area
    lifts = (highest * 0.5 * moment.air.density * moment.true_airspeed**2 for moment in flown)
    return tuple("flight" if lift >= weight else "roll" for lift in lifts)


def _row(flight: Flight, aircraft: Aircraft, k: int, moment: Moment, *, stage: str, mass: float) -> _Row:
    """Return the share of the k-th interval in the sums: what the aircraft does there, and its mass [kg]."""
    phase, weight, duration = flight.mission.phases[moment.phase], mass * GRAVITY, moment.duration
    slope = moment.climb / moment.true_airspeed if moment.true_airspeed else 0.0
    rolls = {"roll": 1.0, "rotation": 0.5}.get(stage, 0.0)
    held = resistance(aircraft, phase, weight, Attitude(moment.air, moment.true_airspeed, slope, rolls))
    engines = phase.engines or flight.mission.engines
    thrust = 0.0 if flight.history.thrust is None else engines * float(flight.history.thrust[k])
    way = moment.true_airspeed * duration
    path = weight * slope + mass * moment.acceleration
    return _Row(duration, way, way if stage == "roll" else 0.0, thrust * duration, held * duration, path * duration)
