"""What the bearings of a sized train lose."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.catalogue import bearing_friction, equivalent_loads
from gearwright.errors import DesignError
from gearwright.parts.bearings import BearingKind, run_film, taper_factors
from gearwright.parts.losses import (
    RunningBearing,
    bearing_torque_constant,
    bearing_torque_palmgren,
    bearing_torque_skf,
)
from gearwright.sizing.arrangement import axial_forces
from gearwright.sizing.bearings import Fitted, Seat, fitted_in, seat_forces
from gearwright.sizing.losses.limits import bearing_limits
from gearwright.sizing.losses.oil import Oil
from gearwright.sizing.planets import STANDING, film_oil
from gearwright.sizing.result import Sizing
from gearwright.units import CELSIUS


@dataclass(frozen=True)
class SeatLoss:
    """What the bearings of one seat, or of several equal ones, lose."""

    seat: str
    count: int
    """Equal bearings [-]."""
    power: float
    """Of all of them [W]."""
    method: str
    """Whose friction."""
    limit: str
    """Limits of it at which it is taken; empty where it holds."""


def bearing_losses(
    sizing: Sizing, seats: tuple[Seat, ...], torques: Floats, *, speeds: Mapping[str, float], oil: Oil
) -> Iterator[SeatLoss]:
    """Yield what the bearings of every seat lose; one of unknown size by a constant coefficient.

    Args:
        sizing: As sized.
        seats: From `bearing_seats`.
        torques: On gear a of one single mesh of each row, shape (meshes,) [N m].
        speeds: Node -> its speed, of the ground too [rad/s].
        oil: In them.
    """
    forces = {seat.name: seat_forces(seat, torques, np.array(speeds[seat.carrier])) for seat in seats}
    along = {} if oil.bearings == "constant" else _along(sizing, seats, forces)
    for seat in seats:
        turning, radial = abs(speeds[seat.nodes[0]] - speeds[seat.nodes[1]]), float(forces[seat.name][0])
        if seat.runs_on is not None and seat.runs_on.journal is not None:
            yield SeatLoss(seat.name, seat.count, seat.count * _film_power(seat, radial, turning, oil), "film", "")
            continue
        fitted = None if oil.bearings == "constant" else fitted_in(sizing, seat)
        if fitted is None:
            torque, name = bearing_torque_constant(radial, seat.bore), "constant"
            limit = bearing_limits(name, turning, oil)
            yield SeatLoss(seat.name, seat.count, seat.count * torque * turning, name, limit)
        else:
            load = (radial / fitted.side_by_side, along.get(seat.name, 0.0) / fitted.side_by_side)
            power = fitted.side_by_side * _torque(fitted, load, turning, oil) * turning
            count, limit = seat.count * fitted.side_by_side, bearing_limits(oil.bearings, turning, oil)
            yield SeatLoss(seat.name, count, seat.count * power, oil.bearings, limit)


def _film_power(seat: Seat, radial: float, turning: float, oil: Oil) -> float:
    """Return what the film of one planet loses [W]; its oil enters as the design says, or as warm as all of it."""
    assert seat.runs_on is not None and seat.runs_on.journal is not None and seat.fitted is not None
    if turning < STANDING or radial <= 0.0:
        return 0.0
    given = seat.fitted.oil_temperature
    supply = oil.temperature if given is None else given + CELSIUS
    return run_film(seat.runs_on.journal, radial, turning, film_oil(oil.grade, oil.density, supply)).power


def _torque(fitted: Fitted, load: tuple[float, float], turning: float, oil: Oil) -> float:
    """Return the friction torque of one bearing [N m]."""
    taken, friction = fitted.bearing, bearing_friction(fitted.bearing)
    radial, axial = load
    if oil.bearings == "palmgren":
        return bearing_torque_palmgren(
            max(equivalent_loads(taken, radial, axial)[0], radial), (taken.bore + taken.outer_diameter) / 2.0, turning,
            viscosity=oil.viscosity, oil_factor=friction.oil_factor, load_factor=friction.load_factor,
        )  # fmt: skip
    running = RunningBearing(
        taken.kind, taken.bore, taken.outer_diameter, taken.static_rating, taken.geometry.contact_angle, radial, axial
    )
    return bearing_torque_skf(running, friction, turning, viscosity=oil.viscosity)


def _along(sizing: Sizing, seats: tuple[Seat, ...], forces: Mapping[str, tuple[Floats, Floats]]) -> dict[str, float]:
    """Return the axial force in every bearing that the design seats [N]."""
    found: dict[str, float] = {}
    for shaft in dict.fromkeys(seat.nodes[0] for seat in seats if seat.given is not None):
        given = {seat.name: seat.given for seat in seats if seat.nodes[0] == shaft and seat.given is not None}
        first = next(seat for seat in seats if seat.name in given)
        thrust = sum(screw.thrust for screw in sizing.design.airscrews.values() if screw.shaft == shaft)
        along = np.array([float(forces[first.name][1]) + first.rotor_side * thrust])
        tapers = {
            sized.name: taper_factors(sized.bearing.geometry.contact_angle)
            for sized in sizing.bearings
            if sized.name in given and sized.bearing.kind is BearingKind.TAPER
        }
        radial = {name: np.array([float(forces[name][0])]) for name in given}
        try:
            axial = axial_forces(shaft, given, along, radial=radial, factors=tapers, cases=("",))
        except DesignError:  # what no bearing takes, as beside the cases that sized it, rubs in none
            continue
        found |= {name: float(force[0]) for name, force in axial.items()}
    return found
