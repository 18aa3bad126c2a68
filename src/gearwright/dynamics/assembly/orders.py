"""Orders of a sized train that no line makes: blades, poles and slots of its machines, teeth and planets that pass.

Each is so many times in a turn of some shafts, with the reason; it says what it shakes, not how hard.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from gearwright.dynamics.assembly.bodies import Assembly
from gearwright.dynamics.assembly.mesh_lines import mesh_phase
from gearwright.dynamics.model import Owner
from gearwright.identity import SIDES, Kind, PartId
from gearwright.sizing import Sizing
from gearwright.spec import GROUND, Airscrew, ElectricMachine, Machine, Pair
from gearwright.train import INTERNAL, Mesh


class _Times(NamedTuple):
    """How often in a turn, and why."""

    what: str
    times: float
    why: str


def add_orders(assembly: Assembly) -> None:
    """Add the orders of every machine, and those of teeth and planets that pass.

    Args:
        assembly: With all bodies and meshes.
    """
    design = assembly.sizing.design
    for sized in assembly.sizing.machines:
        body = assembly.loaded_body(sized)
        owner = Owner(PartId(Kind.MACHINE, sized.name))
        for order in _machine_orders(design.machines[sized.name]):
            name = f"{sized.name} {order.what}"
            assembly.model.order(name, {body: order.times}, on=[body], why=order.why, owner=owner)
    for mesh in assembly.sizing.train.meshes:
        _add_hunting(assembly, mesh)
        stage = design.stages[mesh.stage]
        if isinstance(stage, Pair):
            _add_sidebands_of_turning(assembly, mesh)
        elif mesh.sign == INTERNAL:
            _add_planet_pass(assembly, mesh)


def untold_orders(sizing: Sizing) -> Iterator[tuple[str, str]]:
    """Yield each electric machine whose orders are left out, and what to give for them.

    Args:
        sizing: What was sized.
    """
    for name, machine in sizing.design.machines.items():
        if isinstance(machine, ElectricMachine):
            missing = [field for field in ("poles", "slots") if getattr(machine, field) is None]
            if missing:
                yield name, f"none of the electric kind: give {' and '.join(missing)} of {name}"


def _machine_orders(machine: Machine) -> Iterator[_Times]:
    """Yield how often a machine acts in a turn of its shaft.

    Source: counting: blades, pairs of poles and slots that pass in a turn; three phases ripple at six times the
        electrical frequency, poles and slots face each other alike lcm(poles, slots) times in a turn.
    """
    yield _Times("1P", 1.0, "once per turn")
    if isinstance(machine, Airscrew):
        yield _Times("blade pass", float(machine.blades), f"{machine.blades} blades")
        yield _Times("twice blade pass", 2.0 * machine.blades, f"2 × {machine.blades} blades")
    elif isinstance(machine, ElectricMachine):
        yield from _electric_orders(machine.poles, machine.slots)


def _electric_orders(poles: int | None, slots: int | None) -> Iterator[_Times]:
    if poles is not None:
        yield _Times("electrical", 0.5 * poles, f"{poles} poles")
        yield _Times("twice electrical", 1.0 * poles, f"{poles} poles, unequal phases")
        yield _Times("six times electrical", 3.0 * poles, f"{poles} poles, ripple of three phases")
    if slots is not None:
        yield _Times("slots", float(slots), f"{slots} slots")
    if poles is not None and slots is not None and math.lcm(poles, slots) != slots:
        yield _Times("cogging", float(math.lcm(poles, slots)), f"lcm of {poles} poles and {slots} slots")


def _add_hunting(assembly: Assembly, mesh: Mesh) -> None:
    """Add the frequency at which the same two teeth meet, unless a gear turns as often.

    Source: counting: every lcm(z_a, z_b) teeth, so the mesh frequency over it.
    """
    first, second = (assembly.sizing.teeth[gear] for gear in mesh.gears)
    together = math.lcm(first, second)
    if together > max(first, second):
        turns = {body: teeth / together for body, teeth in mesh_phase(assembly, mesh).items()}
        why = f"the same teeth of {first} and {second} meet"
        _add(assembly, mesh, f"{mesh.name} hunting tooth", turns, why=why)


def _add_sidebands_of_turning(assembly: Assembly, mesh: Mesh) -> None:
    """Add the mesh frequency less and plus a turn of each gear of a pair."""
    phase = mesh_phase(assembly, mesh)
    for side, node in zip(SIDES, mesh.nodes, strict=False):
        if node != GROUND:
            _add_sidebands(assembly, mesh, phase, {_body(assembly, node): 1.0}, name=f"{side} turn")


def _add_planet_pass(assembly: Assembly, mesh: Mesh) -> None:
    """Add how often planets pass a place of their ring, and the sidebands that it gives the mesh.

    Source: McFadden & Smith 1985, Proc. Inst. Mech. Eng. C 199, 65-70.
    """
    _, ring, carrier = mesh.nodes
    turns = {}
    if carrier != GROUND:
        turns[_body(assembly, carrier)] = float(mesh.count)
    if ring != GROUND:
        turns[_body(assembly, ring)] = -float(mesh.count)
    _add(assembly, mesh, f"{_short(assembly, mesh)} planet pass", turns, why=f"{mesh.count} planets")
    _add_sidebands(assembly, mesh, mesh_phase(assembly, mesh), turns, name="planet pass")


def _add_sidebands(
    assembly: Assembly, mesh: Mesh, phase: Mapping[str, float], turns: Mapping[str, float], *, name: str
) -> None:
    for sign, word in ((-1.0, "less"), (1.0, "plus")):
        both = {body: phase.get(body, 0.0) + sign * turns.get(body, 0.0) for body in {**phase, **turns}}
        _add(assembly, mesh, f"{_short(assembly, mesh)} mesh {word} {name}", both, why=f"mesh modulated by {name}")


def _add(assembly: Assembly, mesh: Mesh, name: str, turns: Mapping[str, float], *, why: str) -> None:
    """Add an order that shakes the first mesh of a row; what stands still, as all members do, is left out."""
    lines = [line.name for line in assembly.model.lines if line.owner.part and line.owner.part.is_of(mesh.part)]
    if any(turns.values()):
        assembly.model.order(name, turns, on=lines[:1], why=why, owner=Owner(mesh.part))


def _short(assembly: Assembly, mesh: Mesh) -> str:
    """Return the stage of a row, where no other row of it has the same orders, or else the row."""
    alike = [row for row in assembly.sizing.train.meshes if (row.stage, row.row) == (mesh.stage, mesh.row)]
    return mesh.stage if len(alike) == 1 else mesh.name


def _body(assembly: Assembly, node: str) -> str:
    return assembly.members[node][0]
