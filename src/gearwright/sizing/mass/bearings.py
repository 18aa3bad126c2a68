"""Bearings: chosen ones by the catalogue, the others by load and shaft."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from gearwright.identity import Kind, PartId
from gearwright.sizing.mass.duties import SeatDuty
from gearwright.sizing.mass.planet_bores import PlanetBore
from gearwright.sizing.mass.record import CROWDED, MassItem
from gearwright.sizing.mass.rolling_mass import SOURCE, SURE, bored_mass, loaded_mass
from gearwright.sizing.result import Sizing
from gearwright.spec import GROUND

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
