"""What a flight does to the gears: Miner's sum of flanks and roots by ISO 6336-6, and the part that governs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.catalogue.gear_strength import gear_steel
from gearwright.dynamics.meshes import gear_pairs
from gearwright.errors import DesignError, Problem
from gearwright.mission.flight import Flight
from gearwright.mission.spectrum import DutyBin, mesh_spectrum
from gearwright.parts.gear_pair import GearPair
from gearwright.parts.iso6336_damage import StressBin, damage_parts
from gearwright.parts.iso6336_geometry import Value, mesh_geometry
from gearwright.parts.iso6336_life import LifeCurve, bending_life_curve, contact_life_curve
from gearwright.parts.iso6336_loads import MeshDuty, MeshQuality
from gearwright.parts.iso6336_rating import PairRating, rate_mesh
from gearwright.parts.iso6336_strength import GearSteel
from gearwright.spec import Design
from gearwright.units import Ratio

PITTING, BENDING = "pitting", "bending"
IDLER_MEAN_STRESS = 0.7
"""Y_M of planets, which are loaded on both flanks [-]; ISO 6336-3:2019, annex B."""
_LEAST_TORQUE = 1e-3
"""Load below which a bin does no damage [N m]."""


@dataclass(frozen=True)
class GearDamage:
    """One gear and one way to fail."""

    gear: str
    """Such as ``first.sun``."""
    mode: str
    """``pitting`` or ``bending``."""
    damage: Ratio
    """Miner's sum of one flight [-]."""
    hours: float
    """Of the flight [h]."""

    @property
    def flights(self) -> float:
        """Flights until the sum is 1; ∞ where nothing is damaged [-]."""
        return 1.0 / self.damage if self.damage > 0.0 else math.inf

    @property
    def life(self) -> float:
        """Flight hours until then [h]."""
        return self.flights * self.hours


def gear_damage(flight: Flight) -> tuple[GearDamage, ...]:
    """Return the damage of every gear in pitting and bending, the worst first.

    Args:
        flight: As flown; its mission names the steel.

    Source: ISO 6336-6:2019, clause 5, with the stresses of ISO 6336-2 and -3 in each class of the spectrum, K_A = 1.
        Several meshes on the same flank add up; a planet's two meshes load two flanks, and the worse one counts.

    Raises:
        DesignError: Teeth that ISO 6336 does not cover; with the mesh.

    Valid for: cylindrical gears; those of `unrated_stages` are left out.
    """
    rules = flight.mission.gears
    steel = gear_steel(rules.steel, rules.grade, rules.hardness_hv)
    pairs = gear_pairs(flight.sizing)
    sums: dict[tuple[str, str], list[float]] = {}
    for mesh in flight.sizing.train.meshes:
        if mesh.stage in unrated_stages(flight.sizing.design):
            continue
        try:
            found = _mesh_damage(flight, mesh.name, pairs[mesh.name], steel)
        except DesignError as error:
            raise DesignError([Problem(mesh.name, each.message) for each in error.problems]) from None
        for gear, modes in zip(mesh.gears, found, strict=True):
            for mode, damage in zip((PITTING, BENDING), modes, strict=True):
                sums.setdefault((gear, mode), []).append(damage)
    hours = flight.duration / 3600.0
    rows = [GearDamage(gear, mode, _joined(flight, gear, parts), hours) for (gear, mode), parts in sums.items()]
    return tuple(sorted(rows, key=lambda row: -row.damage))


def unrated_stages(design: Design) -> tuple[str, ...]:
    """Return the stages whose gears have no damage here: face and bevel gears, as ISO 6336 rates cylindrical ones.

    Args:
        design: As read.
    """
    return tuple(name for name, pair in design.pairs.items() if pair.kind != "cylindrical")


def _joined(flight: Flight, gear: str, parts: Sequence[float]) -> float:
    return max(parts) if flight.sizing.train.gear(gear).role == "planet" else sum(parts)


def _mesh_damage(flight: Flight, name: str, pair: GearPair, steel: GearSteel) -> list[tuple[float, float]]:
    """Return (pitting, bending) of gear a and gear b of a mesh; gear 1 of the pair is gear a."""
    bins = [each for each in mesh_spectrum(flight, name) if each.torque > _LEAST_TORQUE and each.turns > 0.0]
    if not bins:
        return [(0.0, 0.0), (0.0, 0.0)]
    contacts = _contacts_per_turn(flight, name)
    rating = _rated(flight, name, pair, (steel, steel), bins)
    damages = []
    for gear in (0, 1):
        relative = 1.0 if gear == 0 else abs(pair.driver.teeth / pair.driven.teeth)
        cycles = [each.turns * relative * contacts[gear] for each in bins]
        contact = rating.pitting.permissible[gear] / rating.contact_strength[gear].life
        root = rating.bending[gear].permissible / rating.root_strength[gear].life
        flank = _sum(cycles, rating.pitting.stresses[gear], contact, curve=contact_life_curve(steel.treatment))
        damages.append(
            (flank, _sum(cycles, rating.bending[gear].stress, root, curve=bending_life_curve(steel.treatment)))
        )
    return damages


def _sum(cycles: Sequence[float], stresses: Value, limits: Value, *, curve: LifeCurve) -> float:
    """Miner's sum over the classes; the limits differ from class to class by the film factors."""
    count = len(cycles)
    rows = zip(cycles, np.broadcast_to(stresses, count), np.broadcast_to(limits, count), strict=True)
    return sum(damage_parts([StressBin(float(stress), turns)], float(limit), curve)[0] for turns, stress, limit in rows)


def _contacts_per_turn(flight: Flight, name: str) -> tuple[float, float]:
    """Load cycles of a tooth per turn relative to the carrier: as many as equal mates pass it."""
    train = flight.sizing.train
    mesh = next(each for each in train.meshes if each.name == name)
    one, other = (train.gear(gear).bodies for gear in mesh.gears)
    return max(mesh.count / one, 1.0), max(mesh.count / other, 1.0)


def _rated(
    flight: Flight, name: str, pair: GearPair, steels: tuple[GearSteel, GearSteel], bins: Sequence[DutyBin]
) -> PairRating:
    train = flight.sizing.train
    mesh = next(each for each in train.meshes if each.name == name)
    factors = [IDLER_MEAN_STRESS if train.gear(gear).role == "planet" else 1.0 for gear in mesh.gears]
    duty = MeshDuty(
        np.array([each.torque for each in bins]),
        np.array([each.speed for each in bins]),
        1.0,
        mesh_load_factor=flight.sizing.design.rules(mesh.stage).mesh_load_factor or 1.0,
    )
    quality = replace(MeshQuality(grade=flight.mission.gears.flank_class), mean_stresses=(factors[0], factors[1]))
    return rate_mesh(mesh_geometry(pair), steels, duty, quality=quality)
