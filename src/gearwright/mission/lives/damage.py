"""What a flight does to the gears: Miner's sum of flanks and roots by the method of each stage."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from gearwright.errors import DesignError, Problem
from gearwright.identity import PartId, Role
from gearwright.mission.flight import Flight
from gearwright.mission.lives.spectrum import mesh_spectrum
from gearwright.ranking import largest_first
from gearwright.sizing.rating import Damage, MeshSpectrum, method_for, rating_of, row_ask
from gearwright.spec import Design
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
    train = flight.sizing.train
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


def _loads(flight: Flight) -> dict[str, list[float]]:
    """Return mesh row -> torque on its first gear in every interval [N m]."""
    return {name: mesh.torque.tolist() for name, mesh in flight.meshes.items()}


def _mesh_damage(flight: Flight, mesh: Mesh) -> tuple[Damage, Damage]:
    """Return what the flight does to gear a and gear b of a mesh."""
    bins = [duty for duty in mesh_spectrum(flight, mesh.name) if duty.load > _LEAST_TORQUE and duty.turns > 0.0]
    if not bins:
        return Damage(0.0, 0.0), Damage(0.0, 0.0)
    rating = rating_of(flight.sizing.design, mesh.stage, flight.sizing.teeth).of_mesh(mesh)
    gears = [gear for name in mesh.gears for gear in flight.sizing.gears if gear.name == name]
    spectrum = MeshSpectrum(
        rating=replace(rating, service=rating.service.model_copy(update={"application_factor": 1.0})),
        ask=row_ask(flight.sizing.train, flight.sizing.teeth, mesh, _loads(flight)),
        module=gears[0].module,
        face_width=min(gear.face_width for gear in gears),
        torques=[duty.load * rating.load_factor for duty in bins],
        speeds=[duty.speed for duty in bins],
        turns=[duty.turns for duty in bins],
        steel=flight.mission.gears,
    )
    return method_for(rating).damage(spectrum)
