"""Module and face width of a bevel pair as sizing makes them, for the search.

A narrower face of the same outer module has a larger mean module and bears about as much, so that faces become much
narrower than the widest that are allowed: the search cannot leave that out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearwright.ranking import largest
from gearwright.sizing.rating import (
    LEAST_TORQUE,
    Ask,
    Load,
    LoadedMesh,
    Rating,
    bevel_module,
    bevel_pair,
    bevel_width,
    mean_module,
    method_for,
    modules,
    next_standard,
    under_spectrum,
)
from gearwright.spec import Design, case_named
from gearwright.train import Mesh, PowerFlow


def bevel_size(rating: Rating, rows: Sequence[Load], teeth: tuple[int, int], ratio: float) -> tuple[float, float]:
    """Return mean normal module and face width of a bevel pair under the heaviest case of each row [m].

    Args:
        rating: Resolved rules.
        rows: Loads of its rows, as a task of the search has them.
        teeth: z_1, z_2 [-].
        ratio: λ = b/m_mn of the widest face [-].
    """
    if not rows:
        return 0.0, 0.0
    loaded = [_with_teeth(load, teeth, ratio) for load in rows]
    method, rules = method_for(rating), rating.proportions

    def gap(module: float, width: float) -> float:
        meshes = (LoadedMesh(rating, module, width, load, (load,), (0.0, 0.0)) for load in loaded)
        return min(method.reserve_of(mesh) for mesh in meshes)

    needed = max(float(module) for load in loaded for module in modules(load.ask, rating))

    def outer_of(module: float) -> float:
        outer = bevel_pair(teeth, module, ratio * module, rating).outer_module
        return next_standard(outer) if rules is not None and rules.standard_modules else outer

    outer = bevel_module(teeth, outer_of(under_spectrum(needed, ratio, gap, outer_of)), ratio, rating, gap)
    width = bevel_width(teeth, outer, ratio, rating, gap)
    return mean_module(teeth, outer, width, rating), width


def bevel_rows(
    design: Design, meshes: Sequence[Mesh], flows: Mapping[str, PowerFlow], rating: Rating
) -> tuple[Load, ...]:
    """Return of each loaded row of a pair the heaviest case, over the whole life.

    Args:
        design: With its cases.
        meshes: The rows.
        flows: Every load case at the asked ratios.
        rating: Resolved rules.
    """
    lasting = {case: flow for case, flow in flows.items() if not case_named(design, case).static}
    rows = (
        largest((_load(case, mesh, flow, rating) for case, flow in lasting.items()), lambda load: load.torque)
        for mesh in meshes
    )
    return tuple(load for load in rows if load.torque > LEAST_TORQUE)


def _load(case: str, mesh: Mesh, flow: PowerFlow, rating: Rating) -> Load:
    """Return a case as one mesh of a row feels it over the whole life."""
    torque = abs(flow.meshes[mesh.name].torques[0]) / mesh.count * rating.load_factor
    speed = abs(flow.speeds[mesh.nodes[0]] - flow.speeds[mesh.nodes[2]])
    return Load(case, torque, Ask(0.0, (1, 1), 1.0, speed=speed), rating.service.life)


def _with_teeth(load: Load, teeth: tuple[int, int], ratio: float) -> Load:
    return load._replace(ask=load.ask._replace(per_tooth=load.torque / teeth[0], teeth=teeth, width_ratio=ratio))
