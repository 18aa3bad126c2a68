"""Lines of the meshes whose gears only turn: one per planet, or one for the halves of a double-helical gear."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

from gearwright.dynamics.assembly.bodies import Assembly
from gearwright.dynamics.assembly.compound_sets import planet_body
from gearwright.dynamics.assembly.contacts import base_circles, direction_between, push_sense
from gearwright.dynamics.assembly.meshes import gear_of
from gearwright.dynamics.model import DampingRatio, Owner, Periodic
from gearwright.identity import PartId, Role, Row, carrier_part, gear_part, mesh_part
from gearwright.parts.planetary import planet_phases
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import planet_positions, play_in_motion
from gearwright.spec import GROUND, Epicyclic, Planetary
from gearwright.train import Mesh


@dataclass(frozen=True)
class _Teeth:
    """What one line of a mesh row has of its own."""

    line: PartId
    curve: StiffnessCurve
    planet: int
    """Counted from 1; 0 without planets."""
    count: int
    """Meshes side by side in it."""
    phase: float
    """In cycles."""


def add_mesh_row(assembly: Assembly, mesh: Mesh) -> None:
    """Add the lines of a mesh row, in their relative mesh phases.

    Args:
        assembly: With all bodies.
        mesh: The row.
    """
    stage, curve = assembly.sizing.design.stages[mesh.stage], assembly.curve(mesh.name)
    if isinstance(stage, Planetary):
        inner, outer = (assembly.pairs[str(mesh_part(mesh.stage, row))] for row in (Row.SUN_PLANET, Row.PLANET_RING))
        phases = planet_phases(
            inner, outer, planet_positions(assembly.sizing.design, mesh.stage, assembly.sizing.teeth)
        )
        for k, phase in enumerate(phases.sun if mesh.row is Row.SUN_PLANET else phases.ring, start=1):
            _add_line(assembly, mesh, _Teeth(mesh.part._replace(number=k), curve, k, 1, phase))
    elif isinstance(stage, Epicyclic):
        for k, phase in enumerate(assembly.compound_phases(mesh.stage)[mesh.name], start=1):
            _add_line(assembly, mesh, _Teeth(mesh.part._replace(number=k), curve, k, 1, phase))
    else:
        _add_line(assembly, mesh, _Teeth(mesh.part, curve, 0, mesh.count, _parallel_phase(assembly, mesh)))


def _parallel_phase(assembly: Assembly, mesh: Mesh) -> float:
    """Return the phase of a pair behind the first of its parallel ones, by their places around the gear they share.

    A tooth of the shared gear passes the places one after the other, in the sense in which it turns [cycles].
    """
    row = [parallel for parallel in assembly.sizing.train.meshes if parallel.stage == mesh.stage]
    shared = 0 if len({parallel.nodes[0] for parallel in row}) == 1 else 1
    seen, first = (
        direction_between(assembly.sizing, pair.nodes[shared], pair.nodes[1 - shared]) for pair in (mesh, row[0])
    )
    angle = cmath.phase(seen / first)
    sense = 1.0 if assembly.flow.speeds[mesh.nodes[shared]] >= 0.0 else -1.0
    return (-sense * assembly.sizing.teeth[mesh.gears[shared]] * angle / (2.0 * math.pi)) % 1.0


def _add_line(assembly: Assembly, mesh: Mesh, teeth: _Teeth) -> None:
    """Add δ = r_a (θ_a − θ_c) − s r_b (θ_b − θ_c), signed so that its force is positive in the case."""
    design, curve = assembly.sizing.design, teeth.curve
    sense, circles = push_sense(assembly.flow, mesh.name), base_circles(assembly.sizing, mesh)
    first, second = sense * circles.first, -sense * mesh.sign * circles.second
    bodies = mesh_bodies(assembly, mesh, teeth.planet)
    weights = {
        body: weight
        for body, node, weight in zip(bodies, mesh.nodes, (first, second, -first - second), strict=True)
        if node != GROUND
    }
    variation = None
    if curve.cosine:
        variation = Periodic(
            phase=mesh_phase(assembly, mesh),
            cosine=[value / curve.mean for value in curve.cosine],
            sine=[value / curve.mean for value in curve.sine],
            offset=2.0 * math.pi * teeth.phase,
        )
    assembly.model.mesh(
        str(teeth.line),
        weights,
        stiffness=curve.mean * teeth.count,
        damping=DampingRatio(design.dynamics.mesh_damping),
        backlash=play_in_motion(assembly.sizing, mesh.name),
        variation=variation,
        owner=Owner(teeth.line),
    )


def mesh_bodies(assembly: Assembly, mesh: Mesh, planet: int) -> tuple[str, str, str]:
    """Return the bodies of gear a, gear b and carrier.

    Args:
        assembly: With all bodies.
        mesh: A row.
        planet: Counted from 1; 0 without planets.
    """
    if planet:
        gears = [assembly.sizing.train.gear(gear).part for gear in mesh.gears]
        first, second = (
            planet_body(assembly.sizing, part, planet) if part.role is Role.PLANET else part for part in gears
        )
        return str(first), str(second), str(carrier_part(mesh.stage))
    first, second = (
        gear_of(assembly.sizing, gear).body(shaft) for gear, shaft in zip(mesh.gears, mesh.nodes, strict=False)
    )
    return str(first), str(second), GROUND


def mesh_phase(assembly: Assembly, mesh: Mesh) -> dict[str, int]:
    """Return the mesh phase as integers of rotations, growing with time: z (θ − θ_c) of the sun or of gear a.

    Args:
        assembly: With all bodies.
        mesh: The row.
    """
    sizing, speeds = assembly.sizing, assembly.flow.speeds
    stage = sizing.design.stages[mesh.stage]
    if isinstance(stage, Planetary):
        gear, node, carrier = str(gear_part(mesh.stage, Role.SUN)), stage.sun, stage.carrier
        bodies = (gear, str(carrier_part(mesh.stage)))
    elif isinstance(stage, Epicyclic):
        gear, node, carrier = mesh.gears[0], mesh.nodes[0], stage.carrier
        first, _, third = mesh_bodies(assembly, mesh, 1)
        bodies = (first, third)
    else:
        gear, node, carrier = mesh.gears[0], mesh.nodes[0], GROUND
        bodies = (mesh_bodies(assembly, mesh, 0)[0], GROUND)
    teeth = sizing.teeth[gear] if speeds[node] >= speeds[carrier] else -sizing.teeth[gear]
    counts = {bodies[0]: teeth} if node != GROUND else {}
    if carrier != GROUND:
        counts[bodies[1]] = -teeth
    return counts
