"""The duty spectrum of a flight: turns and time against load for every mesh, shaft and bearing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import by_name
from gearwright.mission.flight import Flight
from gearwright.mission.lives.duties import seat_duties
from gearwright.verbs import verb

CLASSES = 40
"""Load classes between nothing and the greatest load [-]."""


@dataclass(frozen=True)
class DutyBin:
    """One class of a spectrum."""

    load: float
    """Mean over its turns, without sign: torque on gear a of one mesh or inside a shaft [N m], radial force [N]."""
    speed: float
    """Mean over its time, without sign: of gear a relative to the carrier, of the shaft, or of the bearing [rad/s]."""
    time: float
    """[s]"""
    turns: float
    """Revolutions, of the same [-]."""


@verb
def mesh_spectrum(flight: Flight, mesh: str, *, classes: int = CLASSES) -> tuple[DutyBin, ...]:
    """Return the spectrum of one mesh.

    Args:
        flight: As flown.
        mesh: Name of its row, such as ``first.sun-planet``.
        classes: Number of load classes [-].
    """
    row = by_name(mesh, {candidate.name: candidate for candidate in flight.sizing.train.meshes}, "mesh")
    rolling = flight.speed(row.nodes[0]) - flight.speed(row.nodes[2])
    return _binned(flight, flight.meshes[mesh].torque, rolling, classes)


@verb
def shaft_spectrum(flight: Flight, shaft: str, *, classes: int = CLASSES) -> tuple[DutyBin, ...]:
    """Return the spectrum of one shaft.

    Args:
        flight: As flown.
        shaft: Its name.
        classes: Number of load classes [-].
    """
    node = by_name(shaft, flight.nodes, "shaft")
    return _binned(flight, node.torque, node.speed, classes)


@verb
def bearing_spectra(flight: Flight, *, classes: int = CLASSES) -> dict[str, tuple[DutyBin, ...]]:
    """Return the spectrum of the radial force in every bearing seat, by the seat's name.

    Args:
        flight: As flown.
        classes: Number of load classes [-].
    """
    return {seat.name: _binned(flight, duty.radial, duty.speed, classes) for seat, duty in seat_duties(flight)}


class Classed(NamedTuple):
    """Spectra of several flights; every array has a row for each flight and a column for each class."""

    load: Floats
    """Mean over its turns, without sign; over its time where there are none."""
    speed: Floats
    """Mean over its time, without sign [rad/s]."""
    time: Floats
    """[s]; 0 in empty classes."""
    turns: Floats
    """[-]"""

    def bins(self, flight: int) -> list[DutyBin]:
        """Return the classes of one flight that are not empty.

        Args:
            flight: Its number.
        """
        columns = (column[flight] for column in self)
        return [DutyBin(*row) for row in zip(*(column.tolist() for column in columns), strict=True) if row[2] > 0.0]


def classed(loads: Sequence[Floats], speeds: Sequence[Floats], times: Sequence[Floats], classes: int) -> Classed:
    """Sum what falls into each class of equal width, between nothing and the greatest load of each flight.

    Args:
        loads: Of every flight, shape (intervals,); signs do not count.
        speeds: As the loads [rad/s].
        times: Duration of every interval [s].
        classes: Number of load classes [-].
    """
    count = len(loads)
    load, speed, time = (np.concatenate(columns) for columns in (loads, speeds, times))
    load, speed = np.abs(load), np.abs(speed)
    owner = np.repeat(np.arange(count), [len(one) for one in loads])
    top = np.array([float(np.abs(one).max()) or 1.0 for one in loads])[owner]
    place = owner * classes + np.minimum((load / top * classes).astype(int), classes - 1)

    def summed(values: Floats) -> Floats:
        return np.asarray(np.bincount(place, values, count * classes).reshape(count, classes), dtype=float)

    turns = speed * time / (2.0 * np.pi)
    whole, total = summed(time), summed(turns)
    with np.errstate(invalid="ignore"):  # empty classes
        by_turns, by_time = summed(load * turns) / total, summed(load * time) / whole
        mean = summed(speed * time) / whole
    return Classed(np.where(total > 0.0, by_turns, by_time), mean, whole, total)


def _binned(flight: Flight, load: Floats, speed: Floats, classes: int) -> tuple[DutyBin, ...]:
    return tuple(classed([load], [speed], [flight.history.duration], classes).bins(0))
