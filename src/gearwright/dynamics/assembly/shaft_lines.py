"""Lines along the shafts of a sizing, to its machines and across its clutches."""

from __future__ import annotations

from collections.abc import Iterator, Set
from itertools import pairwise
from typing import NamedTuple

from gearwright.dynamics.assembly.bodies import Assembly
from gearwright.identity import Kind, PartId
from gearwright.parts.shafts import shaft_diameter, torsional_stiffness
from gearwright.spec import GROUND
from gearwright.train import Damper, Joint


class ShaftLine(NamedTuple):
    """A line that twists."""

    name: str
    """Unique name."""
    part: PartId
    """Shaft, machine or clutch."""
    first: str
    """Body at the end that drives."""
    second: str
    """Body at the other end."""
    stiffness: float
    """[N m/rad]."""


def shaft_lines(assembly: Assembly, slipping: Set[str]) -> Iterator[ShaftLine]:
    """Yield every line along a shaft, to a machine or across a clutch.

    Args:
        assembly: With all bodies.
        slipping: Clutches that are drives instead of lines.
    """
    sizing = assembly.sizing
    shafts = {shaft.name: shaft for shaft in sizing.shafts}
    for name, members in assembly.members.items():
        pieces = len(members) - 1
        for k, (first, second) in enumerate(pairwise(members)):
            line = f"{name} shaft" if pieces == 1 else f"{name} shaft {k + 1}"
            yield ShaftLine(line, PartId(Kind.SHAFT, name), first, second, shafts[name].stiffness * pieces)
    for machine in assembly.turning_machines:
        end, shaft = assembly.seat(machine), machine.shaft
        driving = assembly.flow.machine_powers[machine.name] >= 0.0
        ends = (machine.name, end) if driving else (end, machine.name)
        own = PartId(Kind.MACHINE, machine.name)
        alone = sum(neighbour.shaft == shaft for neighbour in sizing.machines) == 1
        if len(assembly.members[shaft]) == 1 and alone:
            yield ShaftLine(f"{shaft} shaft", PartId(Kind.SHAFT, shaft), *ends, shafts[shaft].stiffness)
        else:
            yield ShaftLine(f"{machine.name} shaft", own, *ends, _stub_stiffness(assembly, machine.torque))
    for joint in sizing.train.joints:
        if joint.name in assembly.flow.joints and joint.name not in slipping and not joint.is_brake:
            yield clutch_line(assembly, joint)


class Brake(NamedTuple):
    """A line that holds a shaft to the housing."""

    name: str
    part: PartId
    body: str
    """That it holds."""
    stiffness: float
    """[N m/rad]."""


def brakes(assembly: Assembly) -> Iterator[Brake]:
    """Yield every brake that holds, as stiff as the shaft that it holds.

    Args:
        assembly: With all bodies.
    """
    shafts = {shaft.name: shaft for shaft in assembly.sizing.shafts}
    for joint in assembly.sizing.train.joints:
        if joint.is_brake and joint.name in assembly.flow.joints:
            name = joint.driven if joint.driving == GROUND else joint.driving
            part = PartId(Kind.CLUTCH, joint.name)
            yield Brake(f"{joint.name} clutch", part, assembly.members[name][-1], shafts[name].stiffness)


def clutch_line(assembly: Assembly, joint: Joint) -> ShaftLine:
    """Return the line across a clutch, as stiff as the softer of its shafts.

    Args:
        assembly: With all bodies.
        joint: The clutch.
    """
    stiffness = min(shaft.stiffness for shaft in assembly.sizing.shafts if shaft.name in (joint.driving, joint.driven))
    return ShaftLine(f"{joint.name} clutch", PartId(Kind.CLUTCH, joint.name), *link_ends(assembly, joint), stiffness)


def link_ends(assembly: Assembly, link: Joint | Damper) -> tuple[str, str]:
    """Return the bodies that a clutch or damper joins.

    Args:
        assembly: With all bodies.
        link: What joins two shafts.
    """
    return assembly.members[link.driving][-1], assembly.members[link.driven][0]


def _stub_stiffness(assembly: Assembly, torque: float) -> float:
    """Return the stiffness of a machine's own shaft, sized by its torque [N m/rad]."""
    rules = assembly.sizing.design.shafting
    material = assembly.sizing.design.shaft_material
    diameter = shaft_diameter(0.0, torque, (material.yield_strength or 0.0) / rules.safety, bore_ratio=rules.bore_ratio)
    return torsional_stiffness(diameter, rules.end_length, material.shear_modulus, bore=rules.bore_ratio * diameter)
