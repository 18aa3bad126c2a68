"""What a flight does to the gears: Miner's sum of flanks and roots by the method of each stage."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.identity import PartId, Role
from gearwright.mission.flight import Flight
from gearwright.mission.lives.spectrum import CLASSES, Classed, classed
from gearwright.ranking import largest_first
from gearwright.sizing import Sizing
from gearwright.sizing.as_sized import made_of, rating_as_sized
from gearwright.sizing.rating import Ask, Damage, MeshSpectrum, method_for, reverse_parts, row_ask
from gearwright.spec import Design
from gearwright.spec.missions import GearLifeRules
from gearwright.train import Gear, Mesh
from gearwright.units import Ratio
from gearwright.verbs import verb

PITTING, BENDING = "pitting", "bending"
_LEAST_TORQUE = 1e-3
"""Load below which a bin does no damage [N m]."""


@dataclass(frozen=True)
class GearDamage:
    """One gear and one way to fail."""

    part: PartId
    """Such as the sun of a stage."""
    mode: str
    """``pitting`` or ``bending``."""
    damage: Ratio
    """Miner's sum of one flight [-]."""
    hours: float
    """Of the flight [h]."""

    @property
    def gear(self) -> str:
        """Its label, such as ``first.sun``."""
        return str(self.part)

    @property
    def flights(self) -> float:
        """Flights until the sum is 1; ∞ where nothing is damaged [-]."""
        return 1.0 / self.damage if self.damage > 0.0 else math.inf

    @property
    def life(self) -> float:
        """Flight hours until then [h]."""
        return self.flights * self.hours


@verb
def gear_damage(flight: Flight) -> tuple[GearDamage, ...]:
    """Return the damage of every gear in pitting and bending, the worst first.

    Args:
        flight: As flown; its mission names the steel of gears whose method knows no life (Lewis and Hertz).

    Source: Miner 1945, with the stresses and the S-N curves of each stage's method in each class of the spectrum (ISO
        6336-6:2019, clause 5; AGMA 2001-D04, clause 17), K_A = 1.
        Several meshes on the same flank add up; a planet's two meshes load two flanks, and the worse one counts.

    Raises:
        DesignError: Teeth that the method does not cover; with the mesh.

    Valid for: cylindrical and bevel gears (ISO 10300 rates the latter); those of `unrated_stages` are left out.
    """
    (found,) = gear_damages([flight])
    if isinstance(found, DesignError):
        raise found
    return found


@verb
def gear_damages(flights: Sequence[Flight]) -> list[tuple[GearDamage, ...] | DesignError]:
    """Return the damage of the gears for each of many flights, with the bits that it has alone.

    Args:
        flights: Of one gearbox.

    Source: `gear_damage`.
    """
    try:
        return list(_damages(flights))
    except DesignError as error:
        return [error] if len(flights) == 1 else [found for flight in flights for found in gear_damages([flight])]


def _damages(flights: Sequence[Flight]) -> list[tuple[GearDamage, ...]]:
    """Return the damage of the gears for each of many flights, all of which can be rated."""
    if not flights:
        return []
    train, unrated = flights[0].sizing.train, unrated_stages(flights[0].sizing.design)
    sums: list[dict[tuple[str, str], list[float]]] = [{} for _ in flights]
    loads = [extremes(flight) for flight in flights]
    for mesh in train.meshes:
        if mesh.stage in unrated:
            continue
        try:
            damages = _mesh_damages(flights, mesh, loads)
        except DesignError as error:
            raise DesignError([Problem(mesh.name, problem.message) for problem in error.problems]) from None
        for by_gear, both in zip(sums, damages, strict=True):
            for gear, modes in zip(mesh.gears, both, strict=True):
                for mode, damage in zip((PITTING, BENDING), modes, strict=True):
                    by_gear.setdefault((gear, mode), []).append(damage)
    return [_worst_first(flight, by_gear) for flight, by_gear in zip(flights, sums, strict=True)]


def _worst_first(flight: Flight, sums: Mapping[tuple[str, str], Sequence[float]]) -> tuple[GearDamage, ...]:
    hours, train = flight.duration / 3600.0, flight.sizing.train
    rows = [
        GearDamage(train.gear(gear).part, mode, _joined(train.gear(gear), parts), hours)
        for (gear, mode), parts in sums.items()
    ]
    return tuple(largest_first(rows, lambda row: row.damage))


@verb
def unrated_stages(design: Design) -> tuple[str, ...]:
    """Return the stages whose gears have no damage here: face gears, which no standard rates.

    Args:
        design: As read.
    """
    return tuple(name for name, pair in design.pairs.items() if pair.kind == "face")


def _joined(gear: Gear, parts: Sequence[float]) -> float:
    return max(parts) if gear.role is Role.PLANET else sum(parts)


def extremes(flight: Flight) -> dict[str, tuple[float, float]]:
    """Return mesh row -> least and greatest torque on its first gear [N m].

    Args:
        flight: As flown.
    """
    return {name: (float(mesh.torque.min()), float(mesh.torque.max())) for name, mesh in flight.meshes.items()}


def _mesh_damages(
    flights: Sequence[Flight], mesh: Mesh, loads: Sequence[Mapping[str, tuple[float, float]]]
) -> list[tuple[Damage, Damage]]:
    """Return what each flight does to gear a and gear b of a mesh, in pitting and bending.

    Flights with the same steel, whose teeth are loaded on the same flanks, are rated together, class by class.
    """
    sizing = flights[0].sizing
    rolling = [flight.speed(mesh.nodes[0]) - flight.speed(mesh.nodes[2]) for flight in flights]
    torques = [flight.meshes[mesh.name].torque for flight in flights]
    spectra = classed(torques, rolling, [flight.history.duration for flight in flights], CLASSES)
    counts = damaging(spectra)
    damages: list[tuple[Damage, Damage]] = [(Damage(0.0, 0.0), Damage(0.0, 0.0))] * len(flights)
    for ask, steel, members in alike(flights, mesh, loads, [bool(row.any()) for row in counts]):
        kept = counts[members]
        load, speed, turns = (column[members][kept] for column in (spectra.load, spectra.speed, spectra.turns))
        spectrum = spectrum_of(sizing, mesh, ask, steel, load=load, speed=speed, turns=turns)
        both = method_for(spectrum.rating).damage(spectrum)
        ends = np.cumsum(kept.sum(axis=1)).tolist()
        for flight, start, end in zip(members, [0, *ends], ends, strict=False):
            damages[flight] = (both[0].within(start, end), both[1].within(start, end))
    return damages


def damaging(spectra: Classed) -> NDArray[np.bool_]:
    """Return which classes load a tooth at all, shape (flights, classes).

    Args:
        spectra: Of a mesh.
    """
    return np.asarray((spectra.load > _LEAST_TORQUE) & (spectra.turns > 0.0))


def spectrum_of(
    sizing: Sizing, mesh: Mesh, ask: Ask, steel: GearLifeRules, *, load: Floats, speed: Floats, turns: Floats
) -> MeshSpectrum:
    """Return what loads ask of a mesh, K_A = 1.

    Args:
        sizing: As sized.
        mesh: Row of it.
        ask: Of its teeth.
        steel: Of the mission.
        load: Torques on the first gear, of one mesh [N m].
        speed: Of the first gear against the carrier at each [rad/s].
        turns: Of it at each [-].
    """
    rating = rating_as_sized(sizing, mesh.stage).of_mesh(mesh)
    gears = [gear for name in mesh.gears for gear in sizing.gears if gear.name == name]
    return MeshSpectrum(
        rating=replace(rating, service=rating.service.model_copy(update={"application_factor": 1.0})),
        ask=ask,
        module=gears[0].module,
        face_width=min(gear.face_width for gear in gears),
        torques=(load * rating.load_factor).tolist(),
        speeds=speed.tolist(),
        turns=turns.tolist(),
        steel=steel,
    )


def alike(
    flights: Sequence[Flight], mesh: Mesh, loads: Sequence[Mapping[str, tuple[float, float]]], loaded: Sequence[bool]
) -> list[tuple[Ask, GearLifeRules, list[int]]]:
    """Return which flights that load a mesh ask the same of it, of gears of the same steel.

    Args:
        flights: Of one gearbox.
        mesh: Row of it.
        loads: `extremes` of each flight.
        loaded: Which of them load it.
    """
    groups: list[tuple[Ask, GearLifeRules, list[int]]] = []
    for k, flight in enumerate(flights):
        if not loaded[k]:
            continue
        train, steel = flight.sizing.train, flight.mission.gears
        ask = row_ask(train, flight.sizing.teeth, mesh, loads[k], flight.sizing.design)
        sized = next(row for row in flight.sizing.meshes if row.name == mesh.name)
        ask = ask._replace(reverse=reverse_parts(train, mesh, loads[k]), made=made_of(sized))
        members = next((found for same, made, found in groups if same == ask and made == steel), None)
        if members is None:
            groups.append((ask, steel, [k]))
        else:
            members.append(k)
    return groups
