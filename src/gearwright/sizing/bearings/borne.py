"""What the bearing of one planet bears in every load case of a design."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import Bearing, BearingSpectrum
from gearwright.parts.bearings import film_speed, pair_factor
from gearwright.sizing.bearings.duty import duty_of
from gearwright.sizing.bearings.seat import Seat, seat_forces
from gearwright.sizing.rating import Context


class PlanetLoad(NamedTuple):
    """Load and speed of a planet's bearing, by load case."""

    radial: Floats
    """[N]"""
    axial: Floats
    """[N]"""
    speeds: list[float]
    """Of the planet against its carrier, in which its load stands still [rad/s]."""


def borne_by(context: Context, seat: Seat) -> PlanetLoad:
    """Return what the bearings of a planet bear in every case.

    Args:
        context: What sizing reads.
        seat: Inside the planet.
    """
    flows = context.flows.values()
    torques = np.array([[flow.meshes[m.name].torques[0] / m.count for m in context.train.meshes] for flow in flows])
    carrier = [flow.speeds[seat.carrier] for flow in flows]
    radial, axial = seat_forces(seat, torques, np.array(carrier))
    inner, outer = seat.nodes
    speeds = [film_speed(flow.speeds[inner], flow.speeds[outer], flow.speeds[inner]) for flow in flows]
    return PlanetLoad(radial, axial, speeds)


def planet_duty(context: Context, seat: Seat, fitted: Bearing, borne: PlanetLoad) -> BearingSpectrum:
    """Return what one of the equal bearings of a planet bears over the life that is asked of it.

    Args:
        context: What sizing reads.
        seat: Inside the planet.
        fitted: The bearing.
        borne: By all of them.
    """
    share = pair_factor(fitted.kind, seat.side_by_side)
    life = None if seat.fitted is None else seat.fitted.life
    return duty_of(context, borne.radial / share, borne.axial, borne.speeds, life=life)
