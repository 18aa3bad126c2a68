"""What a flight does to the gears: Miner's sum of flanks and roots by ISO 6336-6, and the part that governs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.identity import Role
from gearwright.mission.flight import Flight
from gearwright.mission.lives.spectrum import mesh_spectrum
from gearwright.parts.iso6336 import LifeCurve, StressBin, damage_parts, life_curves
from gearwright.sizing.rating import Rating, Strain, rating_of, row_ask, steel_of, strains_under
from gearwright.spec import Design
from gearwright.spec.design import Iso6336Rules
from gearwright.train import Mesh
from gearwright.units import Ratio
from gearwright.verbs import verb

PITTING, BENDING = "pitting", "bending"
_OIL_VISCOSITY = 100.0
"""ν_40 where the design does not rate by ISO 6336 [mm²/s]: the film factor Z_L is 1 there."""
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


@verb
def gear_damage(flight: Flight) -> tuple[GearDamage, ...]:
    """Return the damage of every gear in pitting and bending, the worst first.

    Args:
        flight: As flown; its mission names the steel of gears that its design does not rate by ISO 6336.

    Source: ISO 6336-6:2019, clause 5, with the stresses of ISO 6336-2 and -3 in each class of the spectrum, K_A = 1.
        Several meshes on the same flank add up; a planet's two meshes load two flanks, and the worse one counts.

    Raises:
        DesignError: Teeth that ISO 6336 does not cover; with the mesh.

    Valid for: cylindrical and bevel gears (ISO 10300 rates the latter); those of `unrated_stages` are left out.
    """
    sums: dict[tuple[str, str], list[float]] = {}
    for mesh in flight.sizing.train.meshes:
        if mesh.stage in unrated_stages(flight.sizing.design):
            continue
        try:
            damages = _mesh_damage(flight, mesh)
        except DesignError as error:
            raise DesignError([Problem(mesh.name, problem.message) for problem in error.problems]) from None
        for gear, modes in zip(mesh.gears, damages, strict=True):
            for mode, damage in zip((PITTING, BENDING), modes, strict=True):
                sums.setdefault((gear, mode), []).append(damage)
    hours = flight.duration / 3600.0
    rows = [GearDamage(gear, mode, _joined(flight, gear, parts), hours) for (gear, mode), parts in sums.items()]
    return tuple(sorted(rows, key=lambda row: -row.damage))


@verb
def unrated_stages(design: Design) -> tuple[str, ...]:
    """Return the stages whose gears have no damage here: face gears, which no standard rates.

    Args:
        design: As read.
    """
    return tuple(name for name, pair in design.pairs.items() if pair.kind == "face")


def _joined(flight: Flight, gear: str, parts: Sequence[float]) -> float:
    return max(parts) if flight.sizing.train.gear(gear).role is Role.PLANET else sum(parts)


def _mesh_damage(flight: Flight, mesh: Mesh) -> list[tuple[float, float]]:
    """Return (pitting, bending) of gear a and gear b of a mesh."""
    bins = [duty for duty in mesh_spectrum(flight, mesh.name) if duty.load > _LEAST_TORQUE and duty.turns > 0.0]
    if not bins:
        return [(0.0, 0.0), (0.0, 0.0)]
    rating, ask = _rating(flight, mesh.stage), row_ask(flight.sizing.train, flight.sizing.teeth, mesh)
    gear = next(gear for gear in flight.sizing.gears if gear.name == mesh.gears[0])
    mate = next(gear for gear in flight.sizing.gears if gear.name == mesh.gears[1])
    width = min(gear.face_width, mate.face_width)
    loads = [duty.load * rating.load_factor for duty in bins]
    strains = strains_under(
        rating, ask, loads, speeds=[duty.speed for duty in bins], module=gear.module, face_width=width
    )
    curves = life_curves(steel_of(rating))
    damages = []
    for side, relative in enumerate((1.0, gear.teeth / mate.teeth)):
        cycles = [duty.turns * relative * ask.passes[side] for duty in bins]
        flank, root = (_sum(cycles, pair[side], curve) for pair, curve in zip(strains, curves, strict=True))
        damages.append((flank, root))
    return damages


def _sum(cycles: Sequence[float], strain: Strain, curve: LifeCurve) -> float:
    """Miner's sum over the classes; the limits differ from class to class by the film factors."""
    count = len(cycles)
    rows = zip(cycles, np.broadcast_to(strain.stress, count), np.broadcast_to(strain.endurance, count), strict=True)
    return sum(damage_parts([StressBin(float(stress), turns)], float(limit), curve)[0] for turns, stress, limit in rows)


def _rating(flight: Flight, stage: str) -> Rating:
    """Return the rules of a stage that ISO 6336 rates, or the mission's steel for the others; K_A is 1 in a flight."""
    rating, rules = rating_of(flight.sizing.design, stage), flight.mission.gears
    service = rating.service.model_copy(update={"application_factor": 1.0})
    if rating.by_standard:
        return replace(rating, service=service)
    standard = Iso6336Rules(
        steel=rules.steel,
        grade=rules.grade,
        hardness_hv=rules.hardness_hv,
        tolerance_class=rules.flank_class,
        helix_modification="none",
        oil_viscosity=_OIL_VISCOSITY,
    )
    return replace(rating, rules=rating.rules.model_copy(update={"iso6336": standard}), service=service)
