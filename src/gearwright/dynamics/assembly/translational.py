"""Planetary sets of a sizing whose members also move across, on bearings that give way."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from gearwright.catalogue import materials
from gearwright.dynamics.model import Entries, Member, Model, PlanetarySet, System, add_planetary
from gearwright.parts.gears import GearPair
from gearwright.parts.planetary import even_positions, planet_phases
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import Sizing
from gearwright.spec import GROUND, Planetary
from gearwright.spec.checks import MEMBERS
from gearwright.train import PowerFlow


def add_stage(
    model: Model,
    sizing: Sizing,
    flow: PowerFlow,
    *,
    stage: str,
    inertias: Mapping[str, float],
    meshes: tuple[tuple[GearPair, StiffnessCurve], tuple[GearPair, StiffnessCurve]],
) -> None:
    """Add a planetary set with translations, in the frame of its carrier.

    Args:
        model: That gets it.
        sizing: What was sized.
        flow: The load case.
        stage: Name of the set.
        inertias: Body -> polar inertia with its share of the shafts [kg m²]; the carrier's without planets.
        meshes: Geometry and stiffness of the meshes with the sun and with the ring.

    Source: Lin & Parker 1999, J. Vib. Acoust. 121, 316-321.
    """
    planetary = sizing.design.planetaries[stage]
    shafts = {name: getattr(planetary, name) for name in MEMBERS}
    speeds = {name: flow.speeds[shaft] for name, shaft in shafts.items() if shaft != GROUND}
    set_ = _planetary_set(sizing, flow, stage=stage, inertias=inertias, meshes=meshes)
    add_planetary(model, set_, name=stage, speeds=speeds)


def _planetary_set(
    sizing: Sizing,
    flow: PowerFlow,
    *,
    stage: str,
    inertias: Mapping[str, float],
    meshes: tuple[tuple[GearPair, StiffnessCurve], tuple[GearPair, StiffnessCurve]],
) -> PlanetarySet:
    planetary, (inner, outer) = sizing.design.planetaries[stage], meshes
    places = even_positions(planetary.planets)
    members = _members(sizing, stage, inertias, (inner[0], outer[0]))
    return PlanetarySet(
        *members,
        sun_mesh=inner[1],
        ring_mesh=outer[1],
        pressure_angles=(inner[0].working_pressure_angle, outer[0].working_pressure_angle),
        positions=places,
        sun_teeth=inner[0].driver.teeth,
        phases=planet_phases(inner[0], outer[0], places),
        damping=sizing.design.dynamics.mesh_damping,
        backlash=planetary.backlash,
        flank=-1 if flow.meshes[f"{stage}.sun-planet"].torques[0] > 0.0 else 1,
    )


def _members(
    sizing: Sizing, stage: str, inertias: Mapping[str, float], pairs: tuple[GearPair, GearPair]
) -> tuple[Member, Member, Member, Member]:
    """Return sun, ring, carrier and one planet; what is part of the ground and rigid has no motion."""
    planetary, (inner, outer) = sizing.design.planetaries[stage], pairs
    mass = {gear.role: gear.mass for gear in sizing.gears if gear.stage == stage}
    mass["carrier"] = next(carrier.mass for carrier in sizing.carriers if carrier.stage == stage)
    gears = {gear.role: gear.inertia for gear in sizing.gears if gear.stage == stage}
    radius = {"sun": inner.driver.base_radius, "ring": outer.driven.base_radius, "carrier": inner.centre_distance}
    sun, ring, carrier = (
        Member(
            mass[name],
            # A member that stands still is no body of the train; a ring that does gives way as itself.
            inertias.get(f"{stage}.{name}", gears.get(name, 1.0)),
            radius[name],
            support=_support(planetary, name),
            torsion=_torsion(planetary, name, radius[name]),
        )
        for name in MEMBERS
    )
    pin = math.inf if "pin" in planetary.bearings.rigid else pin_stiffness(sizing, stage)
    return sun, ring, carrier, Member(mass["planet"], gears["planet"], inner.driven.base_radius, support=pin)


def pin_stiffness(sizing: Sizing, stage: str) -> float:
    """Return the stiffness of a planet's pin [N/m]: as the design says, or of the sized pin without its bearing.

    Args:
        sizing: What was sized.
        stage: Name of the planetary set.

    Source: cantilever of round section with its force at the middle of the planet, k = 3 E I/(b/2)³.
    """
    given = sizing.design.planetaries[stage].bearings.pin
    if given is not None:
        return given
    width = next(gear.face_width for gear in sizing.gears if gear.name == f"{stage}.planet")
    diameter = next(carrier.pin_diameter for carrier in sizing.carriers if carrier.stage == stage)
    modulus = materials()[sizing.design.rules(stage).material].elastic_modulus
    return 3.0 * modulus * math.pi / 64.0 * diameter**4 / (0.5 * width) ** 3


def _support(planetary: Planetary, name: str) -> float:
    held = name in ("sun", "carrier") and getattr(planetary, name) == GROUND
    return math.inf if held or name in planetary.bearings.rigid else float(getattr(planetary.bearings, name))


def _torsion(planetary: Planetary, name: str, radius: float) -> float:
    if getattr(planetary, name) != GROUND:
        return 0.0
    if name == "ring" and "ring" not in planetary.bearings.rigid:
        return planetary.bearings.ring_tangential * radius**2
    return math.inf


def with_preload(system: System, sizing: Sizing, flow: PowerFlow) -> System:
    """Return a system whose planets' centrifugal preload turns with the carrier.

    Written in the carrier's frame, a rotation of a whole set would otherwise drive itself: the centripetal term of the
    planets' tangential motion η has no counterpart. As the preloaded pins turn by θ, m Ω² η² becomes m Ω² (η − r θ)²,
    and a rotation of the whole is free again. Entries for η are there; those with θ are added.

    Args:
        system: As assembled.
        sizing: What was sized.
        flow: The load case.

    Source: potential of isotropic springs between pins and planets under centrifugal load, to second order in the
        displacements and first order in m Ω² over the pin's stiffness.
    """
    names, found = system.labels.coordinates, list[tuple[int, int, float]]()
    for stage, planetary in sizing.design.planetaries.items():
        carrier, speed = f"{stage}.carrier", flow.speeds[planetary.carrier]
        if f"{stage}.planet-1.tangential" not in names or carrier not in names:
            continue
        mass = next(gear.mass for gear in sizing.gears if gear.name == f"{stage}.planet")
        radius, turn = next(each.radius for each in sizing.carriers if each.stage == stage), names.index(carrier)
        for number in range(1, planetary.planets + 1):
            along, pull = names.index(f"{stage}.planet-{number}.tangential"), mass * speed**2 * radius
            found += [(along, turn, -pull), (turn, along, -pull), (turn, turn, pull * radius)]
    old, (row, column) = system.arrays.centripetal, np.array([each[:2] for each in found], np.int64).reshape(-1, 2).T
    value = np.append(old.value, [each[2] for each in found])
    entries = Entries(np.append(old.row, row), np.append(old.column, column), value)
    return replace(system, arrays=system.arrays._replace(centripetal=entries))
