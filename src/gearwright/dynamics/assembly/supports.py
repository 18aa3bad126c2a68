"""Supports: the shafts that a design lets move across, on their bearings, and what they do to every mesh.

Translations are named ``SHAFT.y`` (and so on), those of a shaft with a sun, a ring or a carrier in the frame of that
planetary set's carrier. Damping ratios of meshes refer to their rotations alone, with or without translations.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gearwright.dynamics.model import AXES, Contact, DampingRatio, Line, Model, Owner, shift_weights
from gearwright.errors import Problem, refuse
from gearwright.identity import Kind, PartId, Role, carrier_part
from gearwright.sizing import Sizing
from gearwright.train import PowerFlow


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
    frames, moving = _frames(sizing, contacts, flow), set[str]()
    for shaft, support in supports.items():
        mass = support.mass or _moving_mass(sizing, shaft)
        across = _across(contacts, shaft)
        stiffness = dict.fromkeys((AXES[k] for k in across), support.radial)
        if support.axial is not None:
            stiffness[next(axis for axis in AXES if axis not in stiffness)] = support.axial
        for axis, value in stiffness.items():
            owner = Owner(PartId(Kind.SHAFT, shaft), axis)
            name = model.translation(f"{shaft}.{axis}", mass=mass, owner=owner)
            damping = DampingRatio(support.damping)
            model.support(f"{name} support", name, stiffness=value, damping=damping, owner=owner)
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
    refuse(problems)
    speeds = {str(carrier_part(name)): flow.speeds[stage.carrier] for name, stage in sizing.design.sets.items()}
    return {shaft: speeds.get(next(iter(carrier), ""), 0.0) for shaft, carrier in carriers.items()}


def _moving_mass(sizing: Sizing, shaft: str) -> float:
    """Return the mass of a shaft with all that it carries [kg]."""
    alone = next(sized.mass for sized in sizing.shafts if sized.name == shaft)
    gears = sum(gear.mass * gear.bodies / len(gear.shafts) for gear in sizing.gears if shaft in gear.shafts)
    carriers = 0.0
    for carrier in sizing.carriers:
        if carrier.shaft == shaft:
            planets = [gear for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET]
            carriers += carrier.mass + sum(planet.turning_mass * planet.bodies for planet in planets)
    return alone + gears + carriers


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
