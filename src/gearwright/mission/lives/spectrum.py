"""The duty spectrum of a flight: turns and time against load for every mesh, shaft and bearing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import by_name
from gearwright.mission.flight import Flight
from gearwright.mission.lives.bearings import seat_duties
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


def _binned(flight: Flight, load_of: Floats, speed: Floats, classes: int) -> tuple[DutyBin, ...]:
    """Sum what falls into each class of equal width; empty classes are left out."""
    load, turning, time = np.abs(load_of), np.abs(speed), flight.history.duration
    turns = turning * time / (2.0 * np.pi)
    top = float(load.max()) or 1.0
    place = np.minimum((load / top * classes).astype(int), classes - 1)
    bins = []
    for k in np.unique(place):
        in_class = place == k
        total = float(turns[in_class].sum())
        weights = turns[in_class] if total else time[in_class]
        mean = float(np.average(load[in_class], weights=weights))
        bins.append(
            DutyBin(
                mean, float(np.average(turning[in_class], weights=time[in_class])), float(time[in_class].sum()), total
            )
        )
    return tuple(bins)
