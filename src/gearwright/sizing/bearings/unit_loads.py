"""Flows in which one row of meshes carries a unit torque: what seats bear in proportion is read from them."""

from __future__ import annotations

from dataclasses import replace

from gearwright.sizing.rating import Context
from gearwright.train import Mesh, PowerFlow


def unit_loads(context: Context) -> Context:
    """Return what sizing reads, with the first case and then one for each sign of a unit torque on each mesh row.

    They are called by the sign and the row: ``1first.sun-planet`` and ``-1first.sun-planet``.

    Args:
        context: With the cases of the design, or the first of them.
    """
    rated = context.reference
    cases = {
        f"{sign}{mesh.name}": _unit(context, rated, mesh, sign) for mesh in context.train.meshes for sign in (1, -1)
    }
    return replace(context, flows={rated.case: rated, **cases})


def _unit(context: Context, rated: PowerFlow, loaded: Mesh, sign: int) -> PowerFlow:
    """Return a flow in which one row of meshes carries ±1 N m on gear a of each single mesh, without losses."""
    meshes = {name: replace(flow, torques=(0.0, 0.0, 0.0)) for name, flow in rated.meshes.items()}
    torque = sign * loaded.count
    ratio = loaded.sign * context.teeth[loaded.gears[1]] / context.teeth[loaded.gears[0]]
    torques = (torque, -torque * ratio, torque * (ratio - 1.0))
    meshes[loaded.name] = replace(rated.meshes[loaded.name], torques=torques)
    return PowerFlow("", rated.speeds, {}, {}, meshes)
