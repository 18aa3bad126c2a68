"""Masses of shaft and planet bearings, from the catalogue or estimated from load and bore."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np

from gearwright.base import Kind, PartId
from gearwright.catalogue import STEEL_DENSITY, STEEL_SHARE, bearings
from gearwright.parts.bearings import BearingKind
from gearwright.sizing.bearing_seats import PlanetBody, Seat, bearing_seats, planet_bodies, seat_forces
from gearwright.sizing.mass.record import CROWDED, MassItem
from gearwright.sizing.result import Sizing
from gearwright.spec import GROUND

# ----------------------------------------------------------------------------------------------------------------------
# What a rolling bearing weighs before one is chosen: by the load that it must bear, and by the shaft that it holds.
# ----------------------------------------------------------------------------------------------------------------------


SOURCE = "similarity through the catalogue's cylindrical roller bearings (ISO 15, ISO 281)"
SURE = 0.30
"""One standard deviation of a bearing that is not chosen, over its value [-]: its series, and what its thrust adds."""
_LIGHT = 0.25
"""Share of the catalogue's sizes that are the lightest around their shaft [-]."""


class Similar(NamedTuple):
    """How the mass of similar bearings grows."""

    by_load: float
    """C/m^(2/3) [N/kg^(2/3)]: at equal stress ratings grow as areas and masses as volumes."""
    by_bore: float
    """m/d³ of light series [kg/m³]."""


@cache
def similar() -> Similar:
    """Return the geometric means over the catalogue's cylindrical roller bearings."""
    rollers = [size for size in bearings().values() if size.kind == BearingKind.CYLINDRICAL and size.bore >= 0.03]
    loads = np.log([size.dynamic_rating / size.mass ** (2.0 / 3.0) for size in rollers])
    bores = np.sort(np.log([size.mass / size.bore**3 for size in rollers]))
    return Similar(float(np.exp(loads.mean())), float(np.exp(np.quantile(bores, _LIGHT))))


def rating_for(load: float, life: float, speed: float) -> float:
    """Return the dynamic rating that a roller bearing needs [N].

    Args:
        load: Equivalent dynamic load P [N].
        life: L_10h [s].
        speed: Of its rings against each other [rad/s].

    Source: ISO 281:2007, L_10 = (C/P)^(10/3).
    """
    turns = life * abs(speed) / (2.0 * math.pi)
    return float(load * max(turns / 1e6, 0.0) ** 0.3)


def loaded_mass(rating: float) -> float:
    """Return the mass of a roller bearing with a rating [kg].

    Args:
        rating: C [N].
    """
    return float((rating / similar().by_load) ** 1.5)


def bored_mass(bore: float) -> float:
    """Return the mass of a bearing of light series on a shaft [kg].

    Args:
        bore: d [m].
    """
    return similar().by_bore * bore**3


# ----------------------------------------------------------------------------------------------------------------------
# What every bearing seat bears in the case that speaks for the design: load, and the rating that its life needs.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# What planets turn on: the bearing that the design names, or one that its load asks for, in the room that there is.
# ----------------------------------------------------------------------------------------------------------------------


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
        bore = _named(body) or _estimated_bore(body, pins[body.stage], ratings)
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


def _estimated_bore(body: PlanetBody, pin: float, ratings: Mapping[str, float]) -> PlanetBore:
    """Return a bearing as heavy as its load asks, as wide as the planet, in the room between pin and rim."""
    steel = _SHARE * math.pi / 4.0 * body.width * STEEL_DENSITY
    wanted = math.sqrt(pin**2 + loaded_mass(ratings.get(body.stage, 0.0)) / steel)
    outside = max(min(max(wanted, pin * (1.0 + 2.0 * _LEAST)), _room(body)), pin)
    mass = steel * (outside**2 - pin**2)
    return PlanetBore(str(body.part), outside, mass, body.steps[0].bodies, named=False, crowded=wanted > outside)


def _room(body: PlanetBody) -> float:
    """Return the diameter inside the rim of a planet, of its smallest step [m]."""
    return min(step.pitch_diameter - 2.0 * _RIM * step.module for step in body.steps)


# ----------------------------------------------------------------------------------------------------------------------
# Bearings: chosen ones by the catalogue, the others by load and shaft.
# ----------------------------------------------------------------------------------------------------------------------


ENDS = 2
"""Bearings of a shaft whose own meshes load none, where a machine or a carrier sits on it [-]."""
_CHOSEN = 0.05
"""One standard deviation of a catalogue's mass, over its value: the steel's share of the room [-]."""
_BY_SIZE = "m = max((C/c)^1.5, k d³)"


def bearing_items(sizing: Sizing, duties: Sequence[SeatDuty], bores: Mapping[str, PlanetBore]) -> Iterator[MassItem]:
    """Yield every bearing of shafts and planets.

    Args:
        sizing: As sized.
        duties: From `seat_duties`.
        bores: From `planet_bores`.
    """
    for chosen in sizing.bearings:
        yield MassItem(
            chosen.name,
            "bearings",
            1,
            chosen.bearing.mass,
            _CHOSEN,
            chosen.bearing.designation,
            "catalogue of bearings",
        )
    yield from _estimated(sizing, duties)
    if sizing.design.housing.own:  # else what stands around the gearbox holds its shafts, too
        yield from _ends(sizing, duties)
    for bore in dict.fromkeys(bores.values()):
        formula = "catalogue" if bore.named else CROWDED if bore.crowded else "m = (C/c)^1.5 by load and life"
        source, sure = ("catalogue of bearings", _CHOSEN) if bore.named else (SOURCE, SURE)
        yield MassItem(bore.body, "bearings", bore.equal, bore.mass, sure, formula, source)


def _estimated(sizing: Sizing, duties: Sequence[SeatDuty]) -> Iterator[MassItem]:
    """Yield the bearings of shafts that meshes load and the design leaves open."""
    built = {bearing.name for bearing in sizing.bearings}
    for seat, _, rating in duties:
        if GROUND in seat.nodes and seat.name not in built and not _in_planet(seat.part):
            mass = max(loaded_mass(rating), bored_mass(seat.bore))
            yield MassItem(seat.name, "bearings", seat.count, mass, SURE, _BY_SIZE, SOURCE)


def _in_planet(part: PartId) -> bool:
    return part.kind is Kind.BEARING and part.role is not None


def _ends(sizing: Sizing, duties: Sequence[SeatDuty]) -> Iterator[MassItem]:
    """Yield what holds shafts that only carry torque: those with a machine or a carrier; suns between float."""
    loaded = {node for duty in duties for node in duty.seat.nodes if not _in_planet(duty.seat.part)}
    held = {machine.shaft for machine in sizing.design.machines.values()}
    held |= {carrier.shaft for carrier in sizing.carriers}
    for shaft in sizing.shafts:
        if shaft.name in held - loaded:
            yield MassItem(
                f"{shaft.name} bearings", "bearings", ENDS, bored_mass(shaft.diameter), SURE, "m = k d³", SOURCE
            )
