"""Planetary stages as bodies and connections, translational by Lin and Parker (1999) or rotational."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Literal, NamedTuple

from gearwright.base import MEMBERS, Kind, PartId, Problem, Role, Row, gear_part, member_part, mesh_part, refuse
from gearwright.dynamics.model.elements import DampingRatio, Line, Periodic
from gearwright.dynamics.model.model import Body, Model
from gearwright.dynamics.model.system import Owner
from gearwright.parts.planetary import PlanetPhases
from gearwright.parts.stiffness import StiffnessCurve

# ----------------------------------------------------------------------------------------------------------------------
# What the dynamics of one planetary set needs to know: members, meshes, places of the planets, errors.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# A planetary set as bodies and lines: with translations (Lin & Parker 1999) or purely rotational, by its supports.
#
# Translations are written in the frame of the carrier: x and y of sun, ring and carrier, radial and tangential ones of
# each planet. Rotations are absolute angles, so that the mass matrix is diagonal.
#
# Coordinates are named ``sun``, ``sun.x``, ``sun.y`` (likewise ``ring``, ``carrier``), ``planet-1``,
# ``planet-1.radial``, ``planet-1.tangential``; lines ``sun-planet-1``, ``planet-ring-1``, ``planet-1.pin.radial``,
# ``sun.support.x`` …
# ----------------------------------------------------------------------------------------------------------------------


PIN = ("radial", "tangential")
"""Directions in which a planet moves on its pin."""


def add_planetary(
    model: Model, planetary: PlanetarySet, *, name: str = "", speeds: Mapping[str, float] | None = None
) -> None:
    """Add a planetary set to a model; shafts and loads join it by the names of its coordinates.

    Args:
        model: Model that gets coordinates and lines.
        planetary: The set.
        name: Put before every name, with a point.
        speeds: Reference speeds [rad/s] of sun, ring or carrier that are given; the others follow from the lines. The
            carrier's brings Coriolis and centripetal terms and the centrifugal load of the planets on their pins.
            The torsional spring of a member whose speed is given holds it beside its turning, as a heavy machine does.

    Source: Lin & Parker 1999, J. Vib. Acoust. 121, 316-321. The geometric stiffness of the preload is left out, so that
        with a carrier speed the rigid rotation diverges slowly.

    Raises:
        DesignError: With everything that is missing.
    """
    refuse(set_problems(planetary, speeds or {}))
    writer = _Writer(model, planetary, name, speeds or {})
    carried = len(planetary.positions) * planetary.planet.mass if math.isinf(planetary.planet.support) else 0.0
    _central(writer, Role.SUN, planetary.sun)
    _central(writer, Role.RING, planetary.ring)
    _central(writer, Kind.CARRIER, planetary.carrier, carried=carried)
    for number, position in enumerate(planetary.positions, start=1):
        _planet(writer, number, position)
        _sun_mesh(writer, number, position)
        _ring_mesh(writer, number, position)


class _Motion(NamedTuple):
    """A displacement: coordinates with their weights, and what errors add."""

    weights: Mapping[str, float]
    constant: float = 0.0


@dataclass(frozen=True)
class _Writer:
    """Where a set is written to."""

    model: Model
    planetary: PlanetarySet
    stage: str
    """Name of the set; empty where it stands alone."""
    speeds: Mapping[str, float]

    @property
    def frame(self) -> float:
        """Speed of the carrier's frame [rad/s]."""
        return self.speeds.get("carrier", 0.0)

    def member(self, member: Role | Kind) -> PartId:
        """Return who sun, ring or carrier is."""
        return member_part(self.stage, member)

    def planet(self, number: int) -> PartId:
        """Return who a planet is, counted from 1."""
        return gear_part(self.stage, Role.PLANET, number=number)

    def turns(self, part: PartId | None) -> bool:
        """Tell whether a speed is given for a member, and it is not zero."""
        return any(speed and self.member(which) == part for which, speed in self._given())

    def _given(self) -> Iterator[tuple[Role | Kind, float]]:
        for which in MEMBERS:
            yield which, self.speeds.get(which, 0.0)

    def line(self, owner: Owner, motion: _Motion, stiffness: float) -> None:
        """Add a spring on a motion, unless it is zero or infinite."""
        if motion.weights and 0.0 < stiffness < math.inf:
            errors = (Periodic(constant=-motion.constant),) if motion.constant else ()
            damping = DampingRatio(self.planetary.damping)
            # A member that turns is held beside its turning, as by the heavy machine on its shaft.
            self.model.add(
                Line(
                    _name(owner),
                    motion.weights,
                    stiffness,
                    damping,
                    errors=errors,
                    kind="support",
                    owner=owner,
                    turns_along=owner.what == "support.rotation" and self.turns(owner.part),
                )
            )


def _name(owner: Owner) -> str:
    """Return what a coordinate or a support of a part is called: ``sun``, ``sun.x``, ``planet-1.pin.radial``."""
    return f"{owner.part}.{owner.what}" if owner.what else str(owner.part)


def _coordinate(part: PartId, direction: str, stiffness: float) -> _Motion:
    """Return a coordinate's motion, which is nothing where an infinite stiffness holds it."""
    return _Motion({} if math.isinf(stiffness) else {_name(Owner(part, direction)): 1.0})


def _central(writer: _Writer, which: Role | Kind, member: Member, *, carried: float = 0.0) -> None:
    """Add sun, ring or carrier with its supports; `carried` is the mass of planets on rigid pins [kg]."""
    part, model = writer.member(which), writer.model
    if not math.isinf(member.torsion):
        inertia = member.inertia + carried * member.radius**2
        model.rotation(str(part), inertia=inertia, speed=writer.speeds.get(which), owner=Owner(part))
        turning = _coordinate(part, "", member.torsion)
        writer.line(Owner(part, "support.rotation"), turning, member.torsion)
    if not math.isinf(member.support):
        across = [Owner(part, axis) for axis in ("x", "y")]
        for owner in across:
            model.translation(_name(owner), mass=member.mass + carried, owner=owner)
            moved = _coordinate(part, owner.what, member.support)
            writer.line(Owner(part, f"support.{owner.what}"), moved, member.support)
        if writer.frame:
            model.rotating_frame(*map(_name, across), speed=writer.frame)


def _planet(writer: _Writer, number: int, position: float) -> None:
    """Add a planet and, where it is elastic, its pin."""
    planet, part, model = writer.planetary.planet, writer.planet(number), writer.model
    model.rotation(str(part), inertia=planet.inertia, owner=Owner(part))
    writer.line(Owner(part, "support.rotation"), _coordinate(part, "", planet.torsion), planet.torsion)
    if math.isinf(planet.support):
        return
    radial, tangential = (Owner(part, direction) for direction in PIN)
    model.translation(_name(radial), mass=planet.mass, owner=radial)
    # The tangential path turns with the carrier, so its reference speed follows from the pin's line.
    model.bodies.append(Body(_name(tangential), planet.mass, "m", None, tangential))
    for direction, pin, place in zip(PIN, _pin(writer, number, position), _places(writer, number), strict=True):
        writer.line(Owner(part, f"pin.{direction}"), _combined((1.0, pin), (-1.0, place)), planet.support)
    if writer.frame:
        model.rotating_frame(_name(radial), _name(tangential), speed=writer.frame)
        centrifugal = planet.mass * writer.planetary.carrier.radius * writer.frame**2
        model.load(_name(radial), constant=centrifugal)


def _pin(writer: _Writer, number: int, position: float) -> tuple[_Motion, _Motion]:
    """Radial and tangential motion of the carrier at a pin, with the pin's error."""
    carrier, part = writer.planetary.carrier, writer.member(Kind.CARRIER)
    error = writer.planetary.errors.get(number, PlanetError())
    x, y = (_coordinate(part, axis, carrier.support) for axis in ("x", "y"))
    turn = _coordinate(part, "", carrier.torsion)
    sine, cosine = math.sin(position), math.cos(position)
    return (
        _combined((cosine, x), (sine, y), (1.0, _Motion({}, error.radial))),
        _combined((-sine, x), (cosine, y), (carrier.radius, turn), (1.0, _Motion({}, error.tangential))),
    )


def _places(writer: _Writer, number: int) -> tuple[_Motion, _Motion]:
    part, support = writer.planet(number), writer.planetary.planet.support
    radial, tangential = (_coordinate(part, direction, support) for direction in PIN)
    return radial, tangential


def _centre(writer: _Writer, number: int, position: float) -> tuple[_Motion, _Motion]:
    """Radial and tangential motion of a planet's centre."""
    rigid = math.isinf(writer.planetary.planet.support)
    return _pin(writer, number, position) if rigid else _places(writer, number)


def _sun_mesh(writer: _Writer, number: int, position: float) -> None:
    """Add f [−x sin(ψ − fα) + y cos(ψ − fα) + r_s θ_s − η cos α + r_p θ_p] − ζ sin α."""
    p, flank = writer.planetary, writer.planetary.flank
    angle = p.pressure_angles[0]
    radial, tangential = _centre(writer, number, position)
    thickness = p.errors.get(number, PlanetError()).tooth_thickness
    motion = _combined(
        (flank, _tooth(writer, Role.SUN, p.sun, position - flank * angle)),
        (-flank * math.cos(angle), tangential),
        (flank * p.planet.radius, _Motion({str(writer.planet(number)): 1.0})),
        (-math.sin(angle), radial),
        (1.0, _Motion({}, thickness)),
    )
    phase = p.phases.sun[number - 1] if p.phases else 0.0
    run_out = _run_out(writer, Role.SUN, p.sun, position - flank * angle)
    _mesh(
        writer,
        mesh_part(writer.stage, Row.SUN_PLANET, number=number),
        motion,
        curve=p.sun_mesh,
        backlash=p.backlash[0],
        phase=phase,
        run_out=run_out,
    )


def _ring_mesh(writer: _Writer, number: int, position: float) -> None:
    """Add f [−x sin(ψ + fα) + y cos(ψ + fα) + r_r θ_r − η cos α − r_p θ_p] + ζ sin α."""
    p, flank = writer.planetary, writer.planetary.flank
    angle = p.pressure_angles[1]
    radial, tangential = _centre(writer, number, position)
    motion = _combined(
        (flank, _tooth(writer, Role.RING, p.ring, position + flank * angle)),
        (-flank * math.cos(angle), tangential),
        (-flank * p.planet.radius, _Motion({str(writer.planet(number)): 1.0})),
        (math.sin(angle), radial),
    )
    phase = p.phases.ring[number - 1] if p.phases else 0.0
    run_out = _run_out(writer, Role.RING, p.ring, position + flank * angle)
    _mesh(
        writer,
        mesh_part(writer.stage, Row.PLANET_RING, number=number),
        motion,
        curve=p.ring_mesh,
        backlash=p.backlash[1],
        phase=phase,
        run_out=run_out,
    )


def _tooth(writer: _Writer, which: Role, member: Member, direction: float) -> _Motion:
    """Motion of a central gear's flank along the line of action, which stands at `direction` to its y axis."""
    part = writer.member(which)
    x, y = (_coordinate(part, axis, member.support) for axis in ("x", "y"))
    turn = _coordinate(part, "", member.torsion)
    return _combined((-math.sin(direction), x), (math.cos(direction), y), (member.radius, turn))


def _run_out(writer: _Writer, which: Role, member: Member, direction: float) -> tuple[Periodic, ...]:
    """Error of an eccentric gear: its centre circles once per turn against the carrier."""
    if not member.run_out:
        return ()
    turns: dict[Role | Kind, int] = {which: 1, Kind.CARRIER: -1}
    amplitude = -writer.planetary.flank * member.run_out
    return (Periodic(_rotations(writer, turns), sine=(amplitude,), offset=-direction),)


def _mesh(
    writer: _Writer,
    part: PartId,
    motion: _Motion,
    *,
    curve: StiffnessCurve,
    backlash: float,
    phase: float,
    run_out: tuple[Periodic, ...],
) -> None:
    """Add one mesh."""
    p = writer.planetary
    variation = None
    if curve.cosine:
        teeth = p.flank * p.sun_teeth
        variation = Periodic(
            phase=_rotations(writer, {Role.SUN: teeth, Kind.CARRIER: -teeth}),
            cosine=[value / curve.mean for value in curve.cosine],
            sine=[value / curve.mean for value in curve.sine],
            offset=2.0 * math.pi * phase,
        )
    constant = (Periodic(constant=-motion.constant),) if motion.constant else ()
    writer.model.mesh(
        str(part),
        motion.weights,
        stiffness=curve.mean,
        damping=DampingRatio(p.damping),
        backlash=backlash,
        variation=variation,
        errors=(*constant, *run_out),
        owner=Owner(part),
    )


def _rotations(writer: _Writer, counts: Mapping[Role | Kind, int]) -> dict[str, int]:
    """Counts of the rotations that can turn, by full name."""
    free = {which: not math.isinf(getattr(writer.planetary, which).torsion) for which in counts}
    return {str(writer.member(which)): count for which, count in counts.items() if free[which]}


def _combined(*parts: tuple[float, _Motion]) -> _Motion:
    """Weighted sum of motions."""
    weights: dict[str, float] = {}
    for factor, motion in parts:
        for name, weight in motion.weights.items():
            weights[name] = weights.get(name, 0.0) + factor * weight
    return _Motion(weights, sum(factor * motion.constant for factor, motion in parts))
