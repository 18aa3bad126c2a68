"""A stage as a relation between its shafts' speeds: one ratio between two of them, or Willis's equation of three."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import SIDES, Kind, Role
from gearwright.spec import GROUND, Design, Epicyclic, Pair, Planetary
from gearwright.train.graph import shafts_of


@dataclass(frozen=True)
class Edge:
    """A stage as one ratio between two shafts: ω_fast / ω_slow = ratio(tooth ratio)."""

    stage: str
    fast: tuple[str, ...]
    """Shafts of the pinions, or of the sun (of the ring where the sun stands still)."""
    slow: tuple[str, ...]
    """Shafts of the wheels, or the other turning member's."""
    grounded: Role | Kind | None
    """Member of a planetary set that stands still; None for a pair, whose axes do."""

    def ratio(self, tooth_ratio: float) -> float:
        """Return the speed ratio of a tooth ratio z_2/z_1 or z_r/z_s [-]."""
        match self.grounded:
            case Role.RING:
                return 1.0 + tooth_ratio
            case Role.SUN:
                return 1.0 + 1.0 / tooth_ratio
            case _:
                return tooth_ratio

    def tooth_ratio(self, ratio: float) -> float:
        """Return the tooth ratio of a speed ratio [-]."""
        match self.grounded:
            case Role.RING:
                return ratio - 1.0
            case Role.SUN:
                return 1.0 / (ratio - 1.0)
            case _:
                return ratio


def edge_of(name: str, design: Design) -> Edge | None:
    """Return a stage as an edge between shafts, or None for a differential and for a compound set (see `ties_of`).

    Args:
        name: Name of the stage.
        design: The design.
    """
    stage = design.stages[name]
    if isinstance(stage, Epicyclic):
        return None
    if isinstance(stage, Pair):
        pinions, wheels = (shafts_of(side, stage, design) for side in SIDES)
        return Edge(name, tuple(pinions), tuple(wheels), None)
    if stage.ring == GROUND:
        return Edge(name, (stage.sun,), (stage.carrier,), Role.RING)
    if stage.carrier == GROUND:
        return Edge(name, (stage.sun,), (stage.ring,), Kind.CARRIER)
    if stage.sun == GROUND:
        return Edge(name, (stage.ring,), (stage.carrier,), Role.SUN)
    return None


def given_tooth_ratio(stage: Pair | Planetary) -> float | None:
    """Return the tooth ratio that a stage's own teeth give, if they do [-].

    Args:
        stage: As in the design.
    """
    if isinstance(stage, Pair):
        return stage.wheel_teeth / stage.pinion_teeth if stage.pinion_teeth and stage.wheel_teeth else None
    if stage.sun_teeth and stage.ring_teeth:
        return stage.ring_teeth / stage.sun_teeth
    known = stage.known_teeth
    return known[2] / known[0] if known else None


def asked_tooth_ratio(stage: Pair | Planetary) -> float | None:
    """Return the tooth ratio that a stage's teeth or its asked ratio give, if either does [-].

    Args:
        stage: As in the design.
    """
    if (tooth_ratio := given_tooth_ratio(stage)) is not None or stage.ratio is None:
        return tooth_ratio
    return stage.ratio if isinstance(stage, Pair) else stage.ratio - 1.0


def members_of(stage: Planetary) -> tuple[str, str, str]:
    """Return the shafts of sun, ring and carrier.

    Args:
        stage: A planetary set.
    """
    return stage.sun, stage.ring, stage.carrier


def willis_ratio(stage: Planetary, speeds: Mapping[str, Floats]) -> Floats:
    """Return z_r/z_s that lets the members turn at given speeds [-].

    Args:
        stage: A planetary set.
        speeds: Shaft -> speed without its sense; the ground is zero [rad/s].

    Source: Willis 1841, ω_s − ω_c = −(z_r/z_s) (ω_r − ω_c); with the carrier held the ring turns backwards.
    """
    sun, ring, carrier = (speeds[member] for member in members_of(stage))
    if stage.carrier == GROUND:
        return np.asarray(sun / ring)
    with np.errstate(divide="ignore"):
        return np.asarray((sun - carrier) / (carrier - ring))


def willis_speed(stage: Planetary, member: str, ratio: Floats, speeds: Mapping[str, Floats]) -> Floats:
    """Return the speed of one member from those of the other two, without its sense [rad/s].

    Args:
        stage: A planetary set.
        member: Shaft whose speed is asked.
        ratio: z_r/z_s [-].
        speeds: Shaft -> speed of the others [rad/s].

    Source: Willis 1841, ω_s + (z_r/z_s) ω_r = (1 + z_r/z_s) ω_c.
    """
    zero = np.zeros(len(ratio))
    sun, ring, carrier = (speeds.get(shaft, zero) for shaft in members_of(stage))
    if member == stage.sun:
        return np.abs((1.0 + ratio) * carrier - ratio * ring)
    if member == stage.ring:
        return np.abs(((1.0 + ratio) * carrier - sun) / ratio)
    return np.abs((sun + ratio * ring) / (1.0 + ratio))
