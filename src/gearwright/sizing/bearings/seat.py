"""One bearing seat: what it bears in proportion to the torques of the meshes, and what sits there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import PartId
from gearwright.sizing.pinned import PlanetBearingSizing
from gearwright.spec import GROUND
from gearwright.spec.design import BearingSeat, PlanetBearing
from gearwright.units import Force, Length


@dataclass(frozen=True)
class Seat:
    """One bearing seat, or several equal ones."""

    part: PartId
    """Bearing by the design's name, first or second of a shaft, or of the planets of a stage."""
    count: int
    """Equal seats: planets of a set [-]."""
    nodes: tuple[str, str]
    """What turns inside and what outside; the housing is ``ground``."""
    bore: Length
    """Diameter of shaft or pin [m]."""
    room: Length
    """Largest outside diameter: inside the rim of a planet; ∞ in the housing [m]."""
    forward: Floats
    """Force of the meshes along y and z on the bearing, or tangential and radial on a pin, and along x on the whole
    shaft, for a torque of 1 N m on gear a of one single mesh of each row, shape (meshes, 3) [N/(N m)]."""
    backward: Floats
    """The same for a torque of −1 N m."""
    swung: float = 0.0
    """Mass of a planet times the radius of its path [kg m]."""
    carrier: str = GROUND
    """Node whose speed swings it."""
    across: Force = 0.0
    """Of a rotor's force and moment, in any direction [N]."""
    rotor_side: float = 0.0
    """Sense along x in which a rotor's thrust pulls the shaft; 0 without a rotor [-]."""
    given: BearingSeat | None = None
    """What the design says of one on a shaft; the two usual bearings of a shaft have none."""
    fitted: PlanetBearing | None = None
    """What the design asks for inside a planet."""
    runs_on: PlanetBearingSizing | None = None
    """What was taken for it."""
    side_by_side: int = 1
    """Bearings of that kind in one seat [-]."""
    path: str = ""
    """Where the design says what sits there; empty for the two usual bearings of a shaft."""

    @property
    def holds_shaft(self) -> bool:
        """Whether it holds its shaft in the housing; what sits inside a planet holds none, and bears no thrust."""
        return self.nodes[1] == GROUND

    @property
    def name(self) -> str:
        """Its label: as the design calls it; else ``SHAFT.first``, ``SHAFT.second``, or ``STAGE.planet``."""
        return str(self.part)


def seat_forces(seat: Seat, torques: Floats, carrier_speed: Floats) -> tuple[Floats, Floats]:
    """Return the radial force on one seat and the meshes' force along its shaft [N], of the shape of the torques' rows.

    Args:
        seat: The seat.
        torques: On gear a of one single mesh of each row, shape (..., meshes) [N m].
        carrier_speed: Speed of what swings a planet, shape (...) [rad/s].

    Source: equilibrium; m r ω² of a planet stands across its tangential force; a rotor points where it loads most.
    """
    force = np.maximum(torques, 0.0) @ seat.forward + np.maximum(-torques, 0.0) @ seat.backward
    return _borne(seat, force, carrier_speed)


def seat_forces_along(seat: Seat, torques: Floats, carrier_speed: Floats) -> tuple[Floats, Floats]:
    """Return `seat_forces` of many loads, each of which has the same bits whatever others it is found with.

    Args:
        seat: The seat.
        torques: On gear a of one single mesh of each row, shape (n, meshes) [N m].
        carrier_speed: Speed of what swings a planet, shape (n,) or (1,) [rad/s].
    """
    force = np.zeros((len(torques), 3))
    for torque, forward, backward in zip(torques.T, seat.forward, seat.backward, strict=True):
        if forward.any() or backward.any():  # not the meshes of other shafts
            back = torque < 0.0
            along = np.where(back[:, None], backward, forward) if back.any() else forward
            force += np.abs(torque)[:, None] * along
    return _borne(seat, force, carrier_speed)


def _borne(seat: Seat, force: Floats, carrier_speed: Floats) -> tuple[Floats, Floats]:
    radial = np.hypot(force[..., 0], force[..., 1] + seat.swung * carrier_speed**2)
    return radial + seat.across, force[..., 2]
