"""Forces of a flight in words: thrust beside drag, block fuel, take-off, and what an aircraft would not fly so."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.mission import Flight, PhaseForces, phase_forces, phase_summaries
from gearwright.spec import Phase
from gearwright.units import GRAVITY, NAUTICAL_MILE

TELLING = 0.05
"""Part of the thrust that may be left over before it is told [-]."""
JUMP = 0.5
"""Airspeed that may jump before it is told: rounding of knots [m/s]."""


def forces_text(flight: Flight) -> list[str]:
    """Return the forces on the aircraft, phase by phase, as lines of text; none where the mission has no aircraft.

    Args:
        flight: As flown.
    """
    rows = phase_forces(flight)
    if not rows:
        return []
    head = f"{'phase':15} {'NM':>7} {'mass kg':>8} {'thrust kN':>10} {'drag kN':>8} {'path kN':>8} {'left over':>10}"
    return ["", head, *map(_row, rows), *_fuel(flight, rows), *_roll(flight, rows), *_told(flight, rows)]


def _row(row: PhaseForces) -> str:
    thrust, left = (f"{value / 1e3:.2f}" if value is not None else "–" for value in (row.thrust, row.left_over))
    return (
        f"{row.name:15} {row.distance / NAUTICAL_MILE:7.1f} {row.mass:8.0f} {thrust:>10} {row.drag / 1e3:8.2f}"
        f" {row.path / 1e3:8.2f} {left:>10}"
    )


def _fuel(flight: Flight, rows: Sequence[PhaseForces]) -> Iterator[str]:
    """Yield block fuel and reserves, of the whole aircraft."""
    spent = {True: 0.0, False: 0.0}
    for row, summary in zip(rows, phase_summaries(flight), strict=True):
        engines = flight.mission.phases[row.name].engines or flight.mission.engines
        spent[row.reserve] += engines * summary.fuel
    beside = f", reserves of {spent[True]:.0f} kg beside it" if spent[True] else ""
    yield f"Block fuel of the aircraft {spent[False]:.0f} kg{beside}"


def _roll(flight: Flight, rows: Sequence[PhaseForces]) -> Iterator[str]:
    """Yield distances of take-offs and landings."""
    for row in rows:
        kind = flight.mission.phases[row.name].kind
        if kind in ("take-off", "landing"):
            yield f"{row.name}: {row.distance:.0f} m, of which {row.roll:.0f} m roll"


def _told(flight: Flight, rows: Sequence[PhaseForces]) -> Iterator[str]:
    """Yield airspeeds that jump, and thrust that drag and path do not explain."""
    for row in rows:
        if abs(row.jump) > JUMP:
            yield (
                f"Note: {row.name} starts {abs(row.jump):.1f} m/s {'faster' if row.jump > 0.0 else 'slower'} than the"
                f" phase before ended: {row.jump_acceleration:.2f} m/s² within a step of {flight.mission.step:g} s"
            )
        left, implied = row.left_over, row.implied
        phase = flight.mission.phases[row.name]
        if phase.kind is not None or left is None or implied is None or abs(left) <= TELLING * abs(row.thrust or 0.0):
            continue
        friction, most = (
            _braking(phase, row),
            flight.mission.aircraft.braking_friction if flight.mission.aircraft else 0.0,
        )
        if friction is not None and 0.0 < friction <= most:
            yield f"{row.name}: brakes hold {left / 1e3:.1f} kN, {friction:.2f} of the weight"
            continue
        unexplained = f"{left / 1e3:.1f} kN of thrust are not explained by drag and path"
        more = f", and brakes hold {most:g} of the weight" if friction else ""
        yield f"Note: {row.name}, {unexplained}: {implied:.2f} m/s²{more}"


def _braking(phase: Phase, row: PhaseForces) -> float | None:
    """Return the friction with which wheels hold what is left over [-]; None where a phase does not end at a stand."""
    if row.left_over is None or 0.0 not in (phase.tas, phase.cas, phase.mach):
        return None
    return row.left_over / (row.mass * GRAVITY)
