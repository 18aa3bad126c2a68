"""Geometry: where every mesh of a sizing stands in space, as contacts; what moves and errs there joins the model.

Translations are named ``SHAFT.y`` (and so on), those of a shaft with a sun, a ring or a carrier in the frame of that
planetary set's carrier. Damping ratios of meshes refer to their rotations alone, with or without translations.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

from gearwright.dynamics.model import (
    AXES,
    Carried,
    Contact,
    DampingRatio,
    Line,
    Model,
    Turns,
    contact_errors,
    crossing_axis,
    face_push_direction,
    push_direction,
    shift_weights,
)
from gearwright.errors import DesignError, Problem, near
from gearwright.parts.gears import transverse_pressure_angle
from gearwright.parts.planetary import even_positions
from gearwright.sizing import GearSizing, Sizing
from gearwright.spec import GROUND, Pair, Planetary
from gearwright.spec.design import PartErrors
from gearwright.train import INTERNAL, Mesh, PowerFlow


def contacts_of(sizing: Sizing, flow: PowerFlow) -> tuple[Contact, ...]:
    """Return every mesh of a sizing as a contact, on the flanks that carry in a load case.

    Args:
        sizing: What was sized.
        flow: The load case.

    Raises:
        DesignError: If the pinion of a face gear lies neither along y nor along z.
    """
    found: list[Contact] = []
    for mesh in sizing.train.meshes:
        stage = sizing.design.stages[mesh.stage]
        found += _planets(sizing, flow, mesh, stage) if isinstance(stage, Planetary) else [_pair(sizing, flow, mesh)]
    return tuple(found)


def body_of(sizing: Sizing, gear: str, shaft: str) -> str:
    """Return the name of a gear's body on a shaft: with the shaft's name where several shafts carry equal ones.

    Args:
        sizing: What was sized.
        gear: Such as ``first.wheel``.
        shaft: That carries it.
    """
    several = len(_gear(sizing, gear).shafts) > 1
    return f"{gear}.{shaft}" if several else gear


def _gear(sizing: Sizing, name: str) -> GearSizing:
    return next(gear for gear in sizing.gears if gear.name == name)


def _sense(flow: PowerFlow, mesh: Mesh) -> float:
    """Return the sense in which gear a pushes: against the torque that the mesh puts on it."""
    return -1.0 if flow.meshes[mesh.name].torques[0] > 0.0 else 1.0


def base_radii(sizing: Sizing, mesh: Mesh) -> tuple[float, float, float]:
    """Return both base radii [m] and the transverse pressure angle [rad]; of bevel gears at the mean cone.

    Args:
        sizing: What was sized.
        mesh: A row of its train.

    Source: ISO 21771:2007, r_b = d/2 cos α_t with tan α_t = tan α_n / cos β.
    """
    normal, gear = sizing.design.rules(mesh.stage).pressure_angle, _gear(sizing, mesh.gears[0])
    angle = transverse_pressure_angle(normal, gear.helix_angle)
    one, other = (_gear(sizing, name).pitch_diameter / 2.0 * math.cos(angle) for name in mesh.gears)
    return one, other, angle


def _first_body(sizing: Sizing, shaft: str) -> str:
    """Return the body whose rotation stands for a shaft's, so that its errors are one tone."""
    for stage in (*sizing.design.planetaries, *sizing.design.pairs):
        for gear in sizing.gears:
            if gear.stage == stage and shaft in gear.shafts:
                return body_of(sizing, gear.name, shaft)
        if stage in sizing.design.planetaries and sizing.design.planetaries[stage].carrier == shaft:
            return f"{stage}.carrier"
    return ""


def _pair(sizing: Sizing, flow: PowerFlow, mesh: Mesh) -> Contact:
    one, other, angle = base_radii(sizing, mesh)
    sense = _sense(flow, mesh)
    axes = {shaft.name: complex(*shaft.axis) for shaft in sizing.shafts}
    towards = axes[mesh.nodes[1]] - axes[mesh.nodes[0]]
    face = isinstance(stage := sizing.design.stages[mesh.stage], Pair) and stage.kind == "face"
    axis = crossing_axis(towards) if face else "x"
    if axis is None:
        message = "a face gear stands along y or z from its pinion; give 0, 90, 180 or -90"
        raise DesignError([Problem(f"layout.{mesh.nodes[1]}.angle_deg", message)])
    if face:
        direction = face_push_direction(towards, angle, sense=sense)
    else:
        direction = push_direction(-towards if mesh.sign == INTERNAL else towards, angle, sense=sense)
    levers = (sense * one, -mesh.sign * sense * other)
    return Contact(
        mesh.name,
        direction,
        (
            _carried(sizing, mesh, 0, lever=levers[0], axis=axis),
            _carried(sizing, mesh, 1, lever=levers[1], axis="x"),
        ),
    )


def _carried(sizing: Sizing, mesh: Mesh, end: int, *, lever: float, axis: str) -> Carried:
    shaft = mesh.nodes[end]
    turns = {_first_body(sizing, shaft): 1} if shaft != GROUND else {}
    return Carried(body_of(sizing, mesh.gears[end], shaft), shaft, lever, turns, turns, {}, axis)


def _planets(sizing: Sizing, flow: PowerFlow, mesh: Mesh, stage: Planetary) -> Iterator[Contact]:
    one, other, angle = base_radii(sizing, mesh)
    sense, at_sun = _sense(flow, mesh), mesh.name.endswith("sun-planet")
    frame = {f"{mesh.stage}.carrier": -1} if stage.carrier != GROUND else {}
    for k, position in enumerate(even_positions(stage.planets), start=1):
        towards = complex(math.cos(position), math.sin(position))
        planet = f"{mesh.stage}.planet-{k}"
        member, shaft = (f"{mesh.stage}.sun", stage.sun) if at_sun else (f"{mesh.stage}.ring", stage.ring)
        own: Turns = {member: 1, **frame} if shaft != GROUND else frame
        central = Carried(member, shaft, 0.0, own, own, frame)
        carried = Carried(planet, stage.carrier, 0.0, {planet: 1, **frame}, {}, frame, "x", towards)
        first, second = (central, carried) if at_sun else (carried, central)
        sides = (first._replace(lever=sense * one), second._replace(lever=-mesh.sign * sense * other))
        yield Contact(f"{mesh.name}-{k}", push_direction(towards, angle, sense=sense), sides)


def add_supports(model: Model, sizing: Sizing, contacts: tuple[Contact, ...], flow: PowerFlow) -> None:
    """Let the shafts that the design supports move: translations, bearings, and what they do to every mesh.

    Args:
        model: With every mesh as a line of rotations.
        sizing: What was sized.
        contacts: From `contacts_of`.
        flow: The load case, whose carrier speeds turn the frames.

    Raises:
        DesignError: If a shaft carries gears of two frames.
    """
    supports = sizing.design.supports
    if not supports:
        return
    frames = _frames(sizing, contacts, flow)
    moving: set[str] = set()
    for shaft, support in supports.items():
        mass = support.mass or _moving_mass(sizing, shaft)
        across = _across(contacts, shaft)
        stiffness = dict.fromkeys((AXES[k] for k in across), support.radial)
        if support.axial is not None:
            stiffness[next(axis for axis in AXES if axis not in stiffness)] = support.axial
        for axis, value in stiffness.items():
            name = model.translation(f"{shaft}.{axis}", mass=mass)
            model.support(f"{name} support", name, stiffness=value, damping=DampingRatio(support.damping))
            moving.add(name)
        if frames[shaft]:
            model.rotating_frame(*(f"{shaft}.{AXES[k]}" for k in across), speed=frames[shaft])
    _shift(model, {contact.line: contact for contact in contacts}, moving)


def _across(contacts: tuple[Contact, ...], shaft: str) -> tuple[int, int]:
    return next((side.across for contact in contacts for side in contact.sides if side.shaft == shaft), (1, 2))


def _frames(sizing: Sizing, contacts: tuple[Contact, ...], flow: PowerFlow) -> dict[str, float]:
    """Return shaft -> speed of the frame that its translations are written in [rad/s]."""
    carriers: dict[str, set[str]] = {shaft: set() for shaft in sizing.design.supports}
    for contact in contacts:
        for side in contact.sides:
            if side.shaft in carriers:
                carriers[side.shaft].add(next(iter(side.housing_turns), ""))
    problems = [
        Problem(f"supports.{shaft}", "it carries gears of a planetary set and of another frame; leave its support out")
        for shaft, carrier in carriers.items()
        if len(carrier) > 1
    ]
    if problems:
        raise DesignError(problems)
    speeds = {
        f"{name}.carrier": flow.speeds[planetary.carrier] for name, planetary in sizing.design.planetaries.items()
    }
    return {shaft: speeds.get(next(iter(carrier), ""), 0.0) for shaft, carrier in carriers.items()}


def _moving_mass(sizing: Sizing, shaft: str) -> float:
    """Return the mass of a shaft with all that it carries [kg]."""
    own = next(each.mass for each in sizing.shafts if each.name == shaft)
    gears = sum(gear.mass * gear.bodies / len(gear.shafts) for gear in sizing.gears if shaft in gear.shafts)
    carriers = 0.0
    for carrier in sizing.carriers:
        if carrier.shaft == shaft:
            planet = _gear(sizing, f"{carrier.stage}.planet")
            carriers += carrier.mass + planet.mass * planet.bodies
    return own + gears + carriers


def _shift(model: Model, contacts: Mapping[str, Contact], moving: set[str]) -> None:
    inertia = {body.name: body.mass for body in model.bodies}
    for number, line in enumerate(model.lines):
        if line.name in contacts:
            shifts = {name: value for name, value in shift_weights(contacts[line.name]).items() if name in moving}
            weights = {**line.weights, **shifts}
            model.lines[number] = replace(line, weights=weights, damping=_damper(line, inertia))


def _damper(line: Line, inertia: Mapping[str, float]) -> float:
    """Return a mesh's damping for its rotations alone, 2 ζ √(k m_eff) [N s/m]."""
    if not isinstance(line.damping, DampingRatio):
        return line.damping
    mobility = sum(weight**2 / inertia[name] for name, weight in line.weights.items())
    return line.damping.damper(line.stiffness, mobility)


def add_errors(model: Model, contacts: tuple[Contact, ...], parts: Mapping[str, PartErrors]) -> None:
    """Give every mesh the errors of its gears and shafts.

    Args:
        model: With every mesh as a line.
        contacts: From `contacts_of`.
        parts: Gear body, shaft or planet -> its errors.

    Raises:
        DesignError: If a part does not exist, or a clocking angle at which teeth do not go together.
    """
    problems = list(_unknown(contacts, parts))
    if problems:
        raise DesignError(problems)
    by_line = {contact.line: contact for contact in contacts}
    problems = [
        problem for line in model.lines if line.name in by_line for problem in _jams(line, by_line[line.name], parts)
    ]
    if problems:
        raise DesignError(problems)
    for number, line in enumerate(model.lines):
        if line.name in by_line:
            found = contact_errors(by_line[line.name], parts)
            model.lines[number] = replace(line, errors=(*line.errors, *found))


def _unknown(contacts: tuple[Contact, ...], parts: Mapping[str, PartErrors]) -> Iterator[Problem]:
    known = {name for contact in contacts for side in contact.sides for name in (side.gear, side.shaft)} - {GROUND}
    for name in parts:
        if name not in known:
            yield Problem(f"errors.{name}", f"there is no such gear, shaft or planet; {near(name, known)}")


def _jams(line: Line, contact: Contact, parts: Mapping[str, PartErrors]) -> Iterator[Problem]:
    """Yield clocking angles at which the teeth of a mesh with backlash do not go together."""
    for side in contact.sides:
        moved = abs(side.lever * parts[side.gear].clocking) if side.gear in parts else 0.0
        if moved > line.backlash > 0.0:
            most = math.degrees(line.backlash / abs(side.lever))
            message = (
                f"it moves the teeth of {line.name} by {moved * 1e6:.4g} µm, more than their backlash of "
                f"{line.backlash * 1e6:.4g} µm, so they do not go together; give at most {most:.4g} deg"
            )
            yield Problem(f"errors.{side.gear}.clocking", message)
