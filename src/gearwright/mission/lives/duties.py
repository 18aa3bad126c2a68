"""What a flight lays on each bearing: force across and along, speed and the oil in it, interval by interval."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError
from gearwright.mission.consumers import flown_airscrew
from gearwright.mission.flight import Flight
from gearwright.parts.bearings import (
    BearingKind,
    LoadFactors,
    taper_factors,
)
from gearwright.parts.losses import oil_viscosity
from gearwright.sizing.arrangement import axial_forces
from gearwright.sizing.bearings import Seat, bearing_seats, seat_forces
from gearwright.units import text

_ROUNDING = 1e-9
"""Axial over the largest radial force below which opposite helices cancel [-]."""


class SeatDuty(NamedTuple):
    """What one seat bears over a flight; every array has one value per interval."""

    radial: Floats
    """[N]"""
    axial: Floats
    """[N]"""
    speed: Floats
    """Of one ring against the other, without sign [rad/s]."""
    time: Floats
    """Duration [s]."""
    viscosity: Floats | None = None
    """ν of the oil in it, where the flight follows its temperature [m²/s]."""
    missing: str = ""
    """Why its axial force is not known; empty where it is."""

    @property
    def turns(self) -> Floats:
        """Revolutions of each interval [-]."""
        return self.speed * self.time / (2.0 * math.pi)


class ThrustNote(NamedTuple):
    """What becomes of the thrust on a shaft whose bearings the design does not describe."""

    words: str
    """Which shaft, how much, what is missing."""
    taken: bool
    """Whether one of two usual bearings is taken to bear it."""


def seat_duties(flight: Flight) -> tuple[tuple[Seat, SeatDuty], ...]:
    """Return every seat with what it bears in every interval of a flight.

    The meshes' forces along a shaft and a propeller's thrust go to the bearings that locate the shaft, as in sizing; on
    a shaft without bearings in the design, to that of its two usual ones that bears less across. Bearings inside
    planets bear none of it.

    Args:
        flight: As flown.
    """
    seats = {seat.name: seat for seat in bearing_seats(flight.sizing)}
    torques = np.stack([flight.meshes[mesh.name].torque for mesh in flight.sizing.train.meshes], axis=-1)
    forces = {name: seat_forces(seat, torques, flight.speed(seat.carrier)) for name, seat in seats.items()}
    axial = {name: np.zeros_like(radial) for name, (radial, _) in forces.items()}
    missing: dict[str, str] = {}
    for shaft, on_shaft in _held(seats).items():
        try:
            axial |= _located(flight, shaft, on_shaft, forces)
        except DesignError as error:  # a flight's thrust that sizing did not know
            missing |= dict.fromkeys(on_shaft, "; ".join(problem.message for problem in error.problems))
    duties, warmth = [], _thickness(flight)
    for name, seat in seats.items():
        speed = np.abs(flight.speed(seat.nodes[0]) - flight.speed(seat.nodes[1]))
        duty = SeatDuty(
            forces[name][0], axial[name], speed, flight.history.duration, warmth, missing.get(name, "")
        )  # fmt: skip
        duties.append((seat, duty))
    return tuple(duties)


def thrust_notes(flight: Flight) -> Iterator[ThrustNote]:
    """Yield where the thrust of a propeller or rotor goes to no bearing that the design describes, and what to write.

    Args:
        flight: As flown.
    """
    held = _held({seat.name: seat for seat in bearing_seats(flight.sizing)})
    for shaft in dict.fromkeys(screw.shaft for screw in flight.sizing.design.airscrews.values()):
        thrust, seats = float(np.abs(_thrust(flight, shaft)).max()), held.get(shaft, {})
        if not thrust or any(seat.given is not None for seat in seats.values()):
            continue
        usual = f"that of {' and '.join(seats)} which bears less across is taken to bear it"
        yield ThrustNote(
            f"{shaft}: up to {text(thrust, 'force')} of thrust, and the design describes no bearing of it;"
            f" {usual if seats else 'where it goes is not assessed'}; describe them in [bearings.NAME] with"
            f' shaft = "{shaft}", one of them with locates = "both"',
            bool(seats),
        )


def _held(seats: Mapping[str, Seat]) -> dict[str, dict[str, Seat]]:
    """Return shaft -> the seats that hold it in the housing, by their names."""
    held: dict[str, dict[str, Seat]] = {}
    for name, seat in seats.items():
        if seat.holds_shaft:
            held.setdefault(seat.nodes[0], {})[name] = seat
    return held


def _thickness(flight: Flight) -> Floats | None:
    """Return ν of the oil as warm as bearings run, per interval [m²/s]; None where a flight does not follow them."""
    warm, oil = flight.history.bearings_temperature, flight.sizing.design.oil
    if warm is None:
        return None
    grade = (oil.viscosity_40 * 1e-6, oil.viscosity_100 * 1e-6)
    return np.array([oil_viscosity(temperature, grade) for temperature in warm.tolist()])


def _located(
    flight: Flight, shaft: str, seats: Mapping[str, Seat], forces: Mapping[str, tuple[Floats, Floats]]
) -> dict[str, Floats]:
    """Return the axial force in every bearing of one shaft, without sign."""
    radial = {name: forces[name][0] for name in seats}
    first = next(iter(seats))
    along = forces[first][1] + seats[first].rotor_side * _thrust(flight, shaft)
    along = np.where(np.abs(along) > _ROUNDING * max(float(force.max()) for force in radial.values()), along, 0.0)
    located_by_design = {name: seat.given for name, seat in seats.items() if seat.given is not None}
    if located_by_design:
        return axial_forces(
            shaft,
            located_by_design,
            along,
            radial=radial,
            factors=_taper_factors(flight, located_by_design),
            cases=flight.phase,
        )
    lightest_loaded = min(radial, key=lambda name: float(radial[name].mean()))
    return {name: np.abs(along) if name == lightest_loaded else np.zeros_like(along) for name in seats}


def _thrust(flight: Flight, shaft: str) -> Floats:
    """Return the thrust on a shaft, of what flies by the map where there is one, else as the design says [N]."""
    screws = {name: screw for name, screw in flight.sizing.design.airscrews.items() if screw.shaft == shaft}
    if flight.history.thrust is not None and flown_airscrew(flight.sizing) in screws:
        return flight.history.thrust
    return np.full(len(flight.phase), sum(screw.thrust for screw in screws.values()))


def _taper_factors(flight: Flight, names: Iterable[str]) -> dict[str, LoadFactors]:
    sized = (seat for seat in flight.sizing.bearings if seat.name in names)
    geometries = {seat.name: seat.bearing.geometry for seat in sized}
    return {
        name: taper_factors(inside.contact_angle)
        for name, inside in geometries.items()
        if inside.kind is BearingKind.TAPER
    }
