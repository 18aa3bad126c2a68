"""Particulars of a sizing: what follows from it beside its own fields, worked out before tables and pages show it.

`render` only reads: what it shows of a sizing is a field of the sizing or stands here.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gearwright.base import Life, Mass, verb
from gearwright.catalogue import rated_steel
from gearwright.parts import Material
from gearwright.parts.iso6336 import GearSteel, LifeCurve, life_curves
from gearwright.sizing import (
    AskedSpeed,
    BearingForce,
    MassPart,
    MeshBeside,
    MeshFactors,
    Passing,
    RatedMesh,
    Sizing,
    UsualValue,
    asked_speeds,
    bearing_forces,
    governing_case,
    mass_groups,
    mass_parts,
    mesh_factors,
    methods_beside,
    passing,
    planet_positions,
    rated_factors,
    remarks,
    usual_values,
)
from gearwright.sizing.airscrew_loads import AirscrewCase, loads_table
from gearwright.sizing.arrangement import Envelope, envelope
from gearwright.sizing.losses import LossBalance, loss_balance
from gearwright.sizing.mass import CompleteMass, Statistics, complete_mass, statistics_beside
from gearwright.sizing.rating import method_for, rating_of
from gearwright.train import Branch, Loop, branches, recirculation

if TYPE_CHECKING:
    from gearwright.dynamics import System
    from gearwright.dynamics.assembly import Assumption
    from gearwright.dynamics.sharing import PathShare

# ----------------------------------------------------------------------------------------------------------------------
# What every text and table of a sizing shows.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class UsedMaterial:
    """A material of a design, with the steel as which its gears are rated."""

    material: Material
    steel: GearSteel | None
    """As its gears are rated; None where no gear is of it."""
    lives: tuple[LifeCurve, LifeCurve] | None
    """S-N curves of its flanks and its roots; None without the steel."""
    as_stated: bool
    """Whether its gears are rated as the steel that the material itself states."""


@dataclass(frozen=True)
class Particulars:
    """What follows from a sizing beside its own fields; case by case in the order of the design."""

    sizing: Sizing
    governing: str
    """Load case with the least margin."""
    complete: CompleteMass
    statistics: Statistics
    """What real gearboxes of its power and speeds weigh."""
    mass_parts: tuple[MassPart, ...]
    """Of the train as sized, the heaviest first."""
    mass_groups: Mapping[str, Mass]
    """Of the train as sized [kg]."""
    envelope: Envelope
    losses: Mapping[str, LossBalance]
    """Load case -> where its power goes."""
    branches: Mapping[str, tuple[Branch, ...]]
    """Load case -> every part on every shaft, shaft by shaft."""
    loops: Mapping[str, tuple[Loop, ...]]
    """Load case -> circles in which power runs."""
    passing: tuple[Passing, ...]
    """How gearbox and epicyclic sets pass power."""
    asked_speeds: tuple[AskedSpeed, ...]
    """Speeds that the teeth give only nearly."""
    airscrew_loads: tuple[AirscrewCase, ...]
    """Of propellers and rotors by case, stated or assumed."""
    bearing_forces: tuple[BearingForce, ...]
    """Of shafts of one diameter."""
    system_life: Life | None
    """Of all bearings of built shafts together, 90 % reliable [s]; None without any."""
    pins: Mapping[str, tuple[float, ...]]
    """Planetary set -> angles at which its pins stand [rad]."""
    load_factors: tuple[MeshFactors, ...]
    """Of the meshes that ISO 6336 rates."""
    materials: tuple[UsedMaterial, ...]
    remarks: tuple[str, ...]
    """What no check says, in sentences."""


@verb
def particulars(sizing: Sizing) -> Particulars:
    """Return what texts and tables show of a sizing beside its own fields.

    Args:
        sizing: As sized.

    >>> import gearwright as gw
    >>> round(particulars(gw.size(gw.read("star"))).complete.total, 1)
    112.7
    """
    design, flows, complete = sizing.design, sizing.flows, complete_mass(sizing)
    return Particulars(
        sizing=sizing,
        governing=governing_case(sizing),
        complete=complete,
        statistics=statistics_beside(sizing, complete),
        mass_parts=mass_parts(sizing),
        mass_groups=mass_groups(sizing),
        envelope=envelope(sizing),
        losses={case: loss_balance(sizing, case) for case in flows},
        branches={case: _shaft_by_shaft(sizing, case) for case in flows},
        loops={case: recirculation(sizing.train, flow) for case, flow in flows.items()},
        passing=passing(sizing),
        asked_speeds=asked_speeds(sizing),
        airscrew_loads=loads_table(design, flows),
        bearing_forces=bearing_forces(sizing),
        system_life=sizing.system_life,
        pins={stage: tuple(planet_positions(design, stage, sizing.teeth)) for stage in design.planetaries},
        load_factors=tuple(mesh_factors(sizing)),
        materials=_used_materials(sizing),
        remarks=remarks(sizing),
    )


def _shaft_by_shaft(sizing: Sizing, case: str) -> tuple[Branch, ...]:
    of_case = branches(sizing.train, sizing.flows[case])
    return tuple(branch for shaft in sizing.design.shafts for branch in of_case if branch.shaft == shaft)


def paths_of(sizing: Sizing) -> tuple[PathShare, ...]:
    """Return the shares of parallel meshes of pairs in the governing case; who has none waits for no dynamics to load.

    Args:
        sizing: As sized.
    """
    meshes = Counter(mesh.stage for mesh in sizing.train.meshes)
    if all(meshes[stage] < 2 for stage in sizing.design.pairs):
        return ()
    from gearwright.dynamics.sharing import path_shares

    return path_shares(sizing)


def _used_materials(sizing: Sizing) -> tuple[UsedMaterial, ...]:
    """Return the materials of a design, once for each steel as which they are rated."""
    used: dict[tuple[str, GearSteel | None], Material] = {}
    for stage in sizing.design.stages:
        rating = rating_of(sizing.design, stage)
        used[rating.material.name, method_for(rating).making(rating).iso_steel] = rating.material
    shaft = sizing.design.shaft_material
    if shaft.name not in {name for name, _ in used}:
        used[shaft.name, None] = shaft
    return tuple(used_material(material, steel) for (_, steel), material in used.items())


def used_material(material: Material, steel: GearSteel | None) -> UsedMaterial:
    """Return a material with the S-N curves of the steel as which its gears are rated.

    Args:
        material: The material.
        steel: As its gears are rated; None where they are not.
    """
    as_stated = steel is not None and material.steel is not None and steel == rated_steel(material)
    return UsedMaterial(material, steel, None if steel is None else life_curves(steel), as_stated)


# ----------------------------------------------------------------------------------------------------------------------
# What the report shows beside them: what every rating rests on, and what the dynamic model does.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Reported:
    """What the report of a sizing shows of it."""

    particulars: Particulars
    factors: tuple[RatedMesh, ...]
    """Every factor of the meshes whose method has more than stresses and margins."""
    methods: tuple[MeshBeside, ...]
    """Meshes by every method, where a mesh has such factors; none where none has."""
    usual: tuple[UsualValue, ...]
    """What the design leaves open of its ratings."""
    nominal: tuple[str, ...]
    """Stages whose method has no factors for peaks of the load."""
    paths: tuple[PathShare, ...]
    """From `paths_of`."""
    assumptions: tuple[Assumption, ...]
    """What a simulation rests on; none without a system."""


def reported(facts: Particulars, system: System | None = None) -> Reported:
    """Return what the report of a sizing shows of it.

    Args:
        facts: Its particulars.
        system: Assembled from it, where the report has its dynamics.
    """
    sizing, factors = facts.sizing, rated_factors(facts.sizing)
    return Reported(
        particulars=facts,
        factors=factors,
        methods=tuple(methods_beside(sizing)) if factors else (),
        usual=usual_values(sizing),
        nominal=tuple(stage for stage in sizing.design.stages if not method_for(rating_of(sizing.design, stage)).peaks),
        paths=paths_of(sizing),
        assumptions=() if system is None else _assumptions(sizing, system),
    )


def _assumptions(sizing: Sizing, system: System) -> tuple[Assumption, ...]:
    from gearwright.dynamics.assembly import assumptions

    return assumptions(sizing, system)
