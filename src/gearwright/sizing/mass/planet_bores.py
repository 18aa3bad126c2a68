"""What planets turn on: the bearing that the design names, or one that its load asks for, in the room that there is."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from gearwright.catalogue import STEEL_DENSITY, STEEL_SHARE
from gearwright.parts.bearings import BearingKind
from gearwright.sizing.bearings import PlanetBody, planet_bodies
from gearwright.sizing.mass.duties import SeatDuty
from gearwright.sizing.mass.rolling_mass import loaded_mass
from gearwright.sizing.result import Sizing

_SHARE = STEEL_SHARE[BearingKind.CYLINDRICAL]
_LEAST = 0.08
"""Least section of a bearing, (D − d)/2 over d [-]: light needle and cylindrical roller bearings, an estimate."""
_RIM = 1.2 * 2.25 + 1.25
"""Wall of a planet from its pitch circle to its bearing, over the module, at least [-]: as rings have it."""


class PlanetBore(NamedTuple):
    """What a planet turns on."""

    body: str
    """Name of the planet's bearing."""
    bearing_diameter: float
    """Outside of the bearing, bore of the planet [m]."""
    mass: float
    """Of all bearings in one planet [kg]."""
    equal: int
    """Equal planets [-]."""
    named: bool
    """Whether the design names it."""
    crowded: bool
    """Whether the load asks for more than the room between pin and rim holds."""


def planet_bores(sizing: Sizing, duties: Sequence[SeatDuty]) -> dict[str, PlanetBore]:
    """Return planet gear -> what it turns on.

    Args:
        sizing: As sized.
        duties: From `seat_duties`.
    """
    ratings: dict[str, float] = {}
    for duty in duties:
        stage = duty.seat.part.name
        ratings[stage] = max(ratings.get(stage, 0.0), duty.rating)
    pins = {carrier.stage: carrier.pin_diameter for carrier in sizing.carriers}
    bores: dict[str, PlanetBore] = {}
    for body in planet_bodies(sizing.design, sizing.gears):
        bore = _named(body) or _estimated(body, pins[body.stage], ratings)
        bores |= {step.name: bore for step in body.steps}
    return bores


def named_bores(sizing: Sizing) -> dict[str, PlanetBore]:
    """Return planet gear -> what it turns on, of the planets whose bearing the design names.

    Args:
        sizing: As sized.
    """
    bodies = [(body, _named(body)) for body in planet_bodies(sizing.design, sizing.gears)]
    return {step.name: bore for body, bore in bodies if bore is not None for step in body.steps}


def _named(body: PlanetBody) -> PlanetBore | None:
    """Return the bearings that sizing took for a planet, or that the design names; None where it asks for none."""
    taken = [step.runs_on for step in body.steps if step.runs_on is not None]
    if not taken:
        return None
    outside = max(runs_on.outer_diameter for runs_on in taken)
    return PlanetBore(
        str(body.part), outside, sum(runs_on.mass for runs_on in taken), body.steps[0].bodies, named=True, crowded=False
    )


def _estimated(body: PlanetBody, pin: float, ratings: Mapping[str, float]) -> PlanetBore:
    """Return a bearing as heavy as its load asks, as wide as the planet, in the room between pin and rim."""
    steel = _SHARE * math.pi / 4.0 * body.width * STEEL_DENSITY
    wanted = math.sqrt(pin**2 + loaded_mass(ratings.get(body.stage, 0.0)) / steel)
    outside = max(min(max(wanted, pin * (1.0 + 2.0 * _LEAST)), _room(body)), pin)
    mass = steel * (outside**2 - pin**2)
    return PlanetBore(str(body.part), outside, mass, body.steps[0].bodies, named=False, crowded=wanted > outside)


def _room(body: PlanetBody) -> float:
    """Return the diameter inside the rim of a planet, of its smallest step [m]."""
    return min(step.pitch_diameter - 2.0 * _RIM * step.module for step in body.steps)
