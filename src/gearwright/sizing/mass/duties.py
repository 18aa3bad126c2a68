"""What every bearing seat bears in the case that speaks for the design: load, and the rating that its life needs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from gearwright.sizing.bearings import Seat, bearing_seats, seat_forces
from gearwright.sizing.mass.rolling_mass import rating_for
from gearwright.sizing.result import Sizing
from gearwright.spec import GROUND


class SeatDuty(NamedTuple):
    """A seat, its load and the rating that it needs."""

    seat: Seat
    load: float
    """Radial, at rated load [N]."""
    rating: float
    """C for the life that the design asks, mean load included [N]."""


def seat_duties(sizing: Sizing) -> Iterator[SeatDuty]:
    """Yield every seat of shafts and planets with its duty.

    Args:
        sizing: As sized.
    """
    flow, service = sizing.reference, sizing.design.service
    speeds = {**flow.speeds, GROUND: 0.0}
    torques = np.array([flow.meshes[mesh.name].torques[0] / mesh.count for mesh in sizing.train.meshes])
    for seat in bearing_seats(sizing):
        radial, _ = seat_forces(seat, torques, np.asarray(speeds[seat.carrier]))
        load, turning = float(radial), speeds[seat.nodes[0]] - speeds[seat.nodes[1]]
        rating = rating_for(load * service.mean_load, service.bearing_life, turning)
        yield SeatDuty(seat, load, rating)
