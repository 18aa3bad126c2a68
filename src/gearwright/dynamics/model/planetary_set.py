"""What the dynamics of one planetary set needs to know: members, meshes, places of the planets, errors."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from gearwright.errors import Problem
from gearwright.identity import MEMBERS
from gearwright.parts.planetary import PlanetPhases
from gearwright.parts.stiffness import StiffnessCurve


@dataclass(frozen=True)
class Member:
    """Sun, ring, carrier or one planet. Infinite stiffness takes a motion out of the model, zero lets it float."""

    mass: float
    """Mass [kg]; the carrier's without planets."""
    inertia: float
    """Polar moment of inertia about its own axis [kg m²]; the carrier's without planets."""
    radius: float
    """Base radius; of the carrier, the radius of its pins [m]."""
    support: float = math.inf
    """Radial stiffness of its bearing, of a planet that of its pin [N/m]."""
    torsion: float = 0.0
    """Stiffness that holds its rotation to the housing [N m/rad]."""
    run_out: float = 0.0
    """Eccentricity of the teeth of sun or ring [m]."""


@dataclass(frozen=True)
class PlanetError:
    """How one planet differs from the drawing."""

    radial: float = 0.0
    """Pin too far out [m]."""
    tangential: float = 0.0
    """Pin too far ahead in the positive direction of rotation [m]."""
    tooth_thickness: float = 0.0
    """Tooth too thick, along the line of action of the sun mesh [m]."""


@dataclass(frozen=True)
class PlanetarySet:
    """One planetary set with N equal planets."""

    sun: Member
    """Sun."""
    ring: Member
    """Ring."""
    carrier: Member
    """Carrier."""
    planet: Member
    """One planet; its support is the pin with its bearing."""
    sun_mesh: StiffnessCurve
    """Mesh of the sun with one planet."""
    ring_mesh: StiffnessCurve
    """Mesh of one planet with the ring."""
    pressure_angles: tuple[float, float]
    """Working transverse pressure angles of sun and ring mesh [rad]."""
    positions: tuple[float, ...]
    """Angles of the planets ψ_n [rad]."""
    sun_teeth: int = 0
    """Number of teeth of the sun [-]; only a varying stiffness needs it."""
    phases: PlanetPhases | None = None
    """Relative mesh phases; only a varying stiffness needs them."""
    errors: Mapping[int, PlanetError] = field(default_factory=dict)
    """Planet, counted from 1 -> its error."""
    damping: float = 0.0
    """Damping ratio ζ of every line [-]."""
    backlash: tuple[float, float] = (0.0, 0.0)
    """Backlash of the meshes with the sun and with the ring along their lines of action [m]; 0: linear."""
    flank: Literal[1, -1] = 1
    """1: the torque on the sun is positive; −1: it is negative and the other flanks touch."""


def rotational(planetary: PlanetarySet) -> PlanetarySet:
    """Return the set without translations: rigid bearings and pins.

    Args:
        planetary: The set.

    Source: Kahraman 1994, J. Sound Vib. 173, 125-130.
    """
    return replace(
        planetary,
        sun=replace(planetary.sun, support=math.inf),
        ring=replace(planetary.ring, support=math.inf),
        carrier=replace(planetary.carrier, support=math.inf),
        planet=replace(planetary.planet, support=math.inf),
    )


def set_problems(planetary: PlanetarySet, speeds: Mapping[str, float]) -> Iterator[Problem]:
    """Yield what keeps a set from being written as lines.

    Args:
        planetary: The set.
        speeds: Reference speeds that are given [rad/s], by member.
    """
    members = {name: getattr(planetary, name) for name in ("sun", "ring", "carrier", "planet")}
    for name, member in members.items():
        for what in ("support", "torsion"):
            if not getattr(member, what) >= 0.0:
                message = f"{getattr(member, what):.6g} given; must be 0 (floating), positive or infinite (fixed)"
                yield Problem(f"{name}.{what}", message)
    if not planetary.positions:
        yield Problem("positions", "there is no planet; give the angle of each")
    for number in planetary.errors:
        if not 1 <= number <= len(planetary.positions):
            yield Problem(f"errors.{number}", f"no such planet; they count from 1 to {len(planetary.positions)}")
    if planetary.sun_mesh.cosine or planetary.ring_mesh.cosine:
        if planetary.sun_teeth <= 0:
            yield Problem("sun_teeth", f"{planetary.sun_teeth} given; a varying mesh stiffness needs the sun's teeth")
        if planetary.phases is None or len(planetary.phases.sun) != len(planetary.positions):
            yield Problem("phases", "a varying mesh stiffness needs the phase of every planet: see `planet_phases`")
    moving = any(not math.isinf(member.support) for member in members.values())
    if moving and speeds and "carrier" not in speeds and not math.isinf(planetary.carrier.torsion):
        yield Problem("speeds.carrier", "missing; a set with translations is written in the frame of its carrier")
    for name in speeds:
        if name not in MEMBERS:
            yield Problem(f"speeds.{name}", "no such member; give the speed of sun, ring or carrier")
        elif math.isinf(members[name].torsion):
            yield Problem(f"speeds.{name}", "its rotation is fixed; leave its speed out")
