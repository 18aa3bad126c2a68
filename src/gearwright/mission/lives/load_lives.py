"""Loads of a flight beside the load changes that teeth bear at each: the spectrum, the S-N curve and Miner's parts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import PartId
from gearwright.mission.flight import Flight
from gearwright.mission.lives.damage import BENDING, PITTING, alike, damaging, extremes, spectrum_of, unrated_stages
from gearwright.mission.lives.spectrum import CLASSES, classed
from gearwright.ranking import largest_first
from gearwright.sizing.rating import method_for
from gearwright.train import Mesh
from gearwright.verbs import verb

LADDER = np.geomspace(0.1, 4.0, 61)
"""Loads of an S-N curve over the greatest of the flight [-]."""


@dataclass(frozen=True, eq=False)
class LoadLife:
    """One gear in one mesh, and one way to fail."""

    part: PartId
    """Such as the sun of a stage."""
    mesh: str
    """Whose flank it is, such as ``first.sun-planet``."""
    mode: str
    """``pitting`` or ``bending``."""
    force: Floats
    """Tangential force of one mesh in each class of the spectrum [N], shape (classes,)."""
    changes: Floats
    """Load changes of a tooth in each class in one flight [-], shape (classes,)."""
    damage: Floats
    """Miner's part of each class in one flight [-], shape (classes,)."""
    ladder: Floats
    """Forces of the S-N curve, rising [N], shape (steps,)."""
    borne: Floats
    """Load changes that the tooth bears at each; ∞ where it bears any number [-], shape (steps,)."""

    @property
    def total(self) -> float:
        """Miner's sum of one flight [-]."""
        return float(self.damage.sum())


@verb
def load_lives(flight: Flight) -> tuple[LoadLife, ...]:
    """Return every flank and root with its spectrum and its S-N curve, the most damaged first.

    Of a planet, whose two meshes load two flanks, the more damaged one is told.

    Args:
        flight: As flown.

    Source: `gear_damage`, class by class; N of a load from Miner's part of one load change, 1/D.

    Raises:
        DesignError: Teeth that the method of a stage does not cover.

    Valid for: the mean speed of each mesh, on which the film factors of ISO 6336-2 depend.
    """
    unrated = unrated_stages(flight.sizing.design)
    rows: dict[tuple[str, str], LoadLife] = {}
    for mesh in flight.sizing.train.meshes:
        for row in _of_mesh(flight, mesh) if mesh.stage not in unrated else ():
            known = rows.get((str(row.part), row.mode))
            if known is None or row.total > known.total:
                rows[str(row.part), row.mode] = row
    return tuple(largest_first(list(rows.values()), lambda row: row.total))


def _of_mesh(flight: Flight, mesh: Mesh) -> Iterator[LoadLife]:
    rolling = flight.speed(mesh.nodes[0]) - flight.speed(mesh.nodes[2])
    duty = flight.meshes[mesh.name]
    classes = classed([duty.torque], [rolling], [flight.history.duration], CLASSES)
    kept = damaging(classes)[0]
    if not kept.any():
        return
    ((ask, steel, _),) = alike([flight], mesh, [extremes(flight)], [True])
    load, speed, turns = classes.load[0][kept], classes.speed[0][kept], classes.turns[0][kept]
    arm = float(np.max(np.abs(duty.torque)) / np.max(np.abs(duty.force)))
    ladder = load.max() * LADDER
    both = spectrum_of(flight.sizing, mesh, ask, steel, load=load, speed=speed, turns=turns)
    mean = np.full(len(ladder), np.average(speed, weights=turns))
    curve = spectrum_of(flight.sizing, mesh, ask, steel, load=ladder, speed=mean, turns=np.ones(len(ladder)))
    method = method_for(both.rating)
    first, second = (float(np.asarray(teeth)) for teeth in ask.teeth)
    pairs = zip(mesh.gears, method.damage(both), method.damage(curve), (1.0, first / second), ask.passes, strict=True)
    for name, parts, steps, ratio, passes in pairs:
        for mode in (PITTING, BENDING):
            damage, one = (np.array(getattr(found, mode)) for found in (parts, steps))
            with np.errstate(divide="ignore"):
                borne = ratio * passes / one
            yield LoadLife(
                flight.sizing.train.gear(name).part, mesh.name, mode, load / arm, turns * ratio * passes, damage,
                ladder / arm, borne,
            )  # fmt: skip
