"""Planetary sets of a sizing whose members also move across, on bearings that give way."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from gearwright.dynamics.assembly.bodies import Assembly
from gearwright.dynamics.assembly.contacts import push_sense
from gearwright.dynamics.assembly.meshes import gear_of
from gearwright.dynamics.model import Entries, Member, PlanetarySet, System, add_planetary
from gearwright.identity import MEMBERS, Kind, Role, Row, carrier_part, gear_part, member_part, mesh_part
from gearwright.parts.planetary import planet_phases
from gearwright.sizing import CarrierSizing, GearSizing, Sizing, planet_positions, play_in_motion
from gearwright.spec import GROUND, Planetary
from gearwright.train import PowerFlow


def add_moving_set(assembly: Assembly, stage: str) -> None:
    """Add a planetary set with translations, in the frame of its carrier.

    Args:
        assembly: That gets it; its carrier is without planets.
        stage: Name of the set.

    Source: Lin & Parker 1999, J. Vib. Acoust. 121, 316-321.
    """
    planetary, flow = assembly.sizing.design.planetaries[stage], assembly.flow
    shafts = {str(member): getattr(planetary, member) for member in MEMBERS}
    speeds = {name: flow.speeds[shaft] for name, shaft in shafts.items() if shaft != GROUND}
    add_planetary(assembly.model, _planetary_set(assembly, stage), name=stage, speeds=speeds)


def _planetary_set(assembly: Assembly, stage: str) -> PlanetarySet:
    rows = tuple(str(mesh_part(stage, row)) for row in (Row.SUN_PLANET, Row.PLANET_RING))
    inner, outer = (assembly.pairs[row] for row in rows)
    places = planet_positions(assembly.sizing.design, stage, assembly.sizing.teeth)
    return PlanetarySet(
        *_members(assembly, stage),
        sun_mesh=assembly.curve(rows[0]),
        ring_mesh=assembly.curve(rows[1]),
        pressure_angles=(inner.working_pressure_angle, outer.working_pressure_angle),
        positions=places,
        sun_teeth=inner.driver.teeth,
        phases=planet_phases(inner, outer, places),
        damping=assembly.sizing.design.dynamics.mesh_damping,
        backlash=(play_in_motion(assembly.sizing, rows[0]), play_in_motion(assembly.sizing, rows[1])),
        flank=push_sense(assembly.flow, rows[0]),
    )


def _members(assembly: Assembly, stage: str) -> tuple[Member, Member, Member, Member]:
    """Return sun, ring, carrier and one planet; what is part of the ground and rigid has no motion."""
    sizing, planetary = assembly.sizing, assembly.sizing.design.planetaries[stage]
    inner, outer = (assembly.pairs[str(mesh_part(stage, row))] for row in (Row.SUN_PLANET, Row.PLANET_RING))
    gears: dict[Role | Kind, GearSizing] = {gear.role: gear for gear in sizing.gears if gear.stage == stage}
    mass = {role: gear.turning_mass for role, gear in gears.items()} | {Kind.CARRIER: _carrier(sizing, stage).mass}
    radii = (inner.driver.base_radius, outer.driven.base_radius, inner.centre_distance)
    radius: dict[Role | Kind, float] = dict(zip(MEMBERS, radii, strict=True))

    def member(role: Role | Kind) -> Member:
        # A member that stands still is no body of the train; a ring that does gives way as itself.
        standing = gears[role].inertia if role in gears else 1.0
        rotor = assembly.rotors.get(str(member_part(stage, role)))
        support, torsion = _support(planetary, role), _torsion(planetary, role, radius[role])
        return Member(mass[role], rotor.inertia if rotor else standing, radius[role], support=support, torsion=torsion)

    pin = math.inf if "pin" in planetary.bearings.rigid else pin_stiffness(sizing, stage)
    planet = Member(mass[Role.PLANET], gears[Role.PLANET].turning_inertia, inner.driven.base_radius, support=pin)
    return member(Role.SUN), member(Role.RING), member(Kind.CARRIER), planet


def _carrier(sizing: Sizing, stage: str) -> CarrierSizing:
    return next(carrier for carrier in sizing.carriers if carrier.stage == stage)


def _planet(sizing: Sizing, stage: str) -> GearSizing:
    return gear_of(sizing, str(gear_part(stage, Role.PLANET)))


def pin_stiffness(sizing: Sizing, stage: str) -> float:
    """Return the stiffness of a planet's pin [N/m]: as the design says, or of the sized pin without its bearing.

    Args:
        sizing: What was sized.
        stage: Name of the planetary set.

    Source: cantilever of round section of the shafts' steel, its force at the middle of the planet, k = 3 E I/(b/2)³.
    """
    stated = sizing.design.planetaries[stage].bearings.pin
    if stated is not None:
        return stated
    width, diameter = _planet(sizing, stage).face_width, _carrier(sizing, stage).pin_diameter
    modulus = sizing.design.shaft_material.elastic_modulus
    return 3.0 * modulus * math.pi / 64.0 * diameter**4 / (0.5 * width) ** 3


def _support(planetary: Planetary, name: Role | Kind) -> float:
    grounded = name is not Role.RING and getattr(planetary, name) == GROUND
    return math.inf if grounded or name in planetary.bearings.rigid else float(getattr(planetary.bearings, name))


def _torsion(planetary: Planetary, name: Role | Kind, radius: float) -> float:
    if getattr(planetary, name) != GROUND:
        return 0.0
    if name is Role.RING and name.value not in planetary.bearings.rigid:
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
    names, old = system.labels.coordinates, system.arrays.centripetal
    rows, columns, values = list[int](), list[int](), list[float]()
    for stage, planetary in sizing.design.planetaries.items():
        carrier, speed = str(carrier_part(stage)), flow.speeds[planetary.carrier]
        paths = [f"{gear_part(stage, Role.PLANET, number=k + 1)}.tangential" for k in range(planetary.planets)]
        if paths[0] not in names or carrier not in names:
            continue
        radius, turn = _carrier(sizing, stage).radius, names.index(carrier)
        pull = _planet(sizing, stage).turning_mass * speed**2 * radius
        for along in map(names.index, paths):
            rows += [along, turn, turn]
            columns += [turn, along, turn]
            values += [-pull, -pull, pull * radius]
    added = Entries(np.array(rows, np.int64), np.array(columns, np.int64), np.array(values))
    entries = Entries(*(np.append(*parts) for parts in zip(old, added, strict=True)))
    return replace(system, arrays=system.arrays._replace(centripetal=entries))
