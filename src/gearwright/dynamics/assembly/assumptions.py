"""Assumptions: what a simulation of a sizing rests on that nobody measured, with its value and where it is from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from gearwright.dynamics.assembly.meshes import gear_pairs, stiffness_model
from gearwright.dynamics.assembly.orders import untold_orders
from gearwright.dynamics.assembly.translational import pin_stiffness
from gearwright.dynamics.model import System
from gearwright.sizing import Sizing, play_in_motion
from gearwright.spec import GROUND, Record, quantity_of
from gearwright.spec.checks import table_of
from gearwright.spec.design import DynamicsRules
from gearwright.units import text

Source = Literal["given", "default", "computed"]
_MEMBER = {"ring_tangential": "ring"}
"""Field of a set's bearings -> the member that it holds, where it is not called so."""


@dataclass(frozen=True)
class Assumption:
    """One thing that the dynamic model takes for granted."""

    subject: str
    """What it is about."""
    value: str
    """With its unit."""
    origin: Source
    """``"given"`` in the design file, its ``"default"``, or ``"computed"`` from the sizing."""
    path: str
    """Entry of the design file that changes it; empty where none does."""


def assumptions(sizing: Sizing, system: System) -> tuple[Assumption, ...]:
    """Return what a simulation rests on, in the order in which a reader asks.

    Args:
        sizing: What was sized.
        system: Assembled from it.
    """
    return (
        *_rules(sizing.design.dynamics),
        *_curves(sizing),
        *_backlash(sizing),
        *_bearings(sizing),
        *_inertias(sizing),
        *(Assumption(f"orders of {name}", words, "default", "") for name, words in untold_orders(sizing)),
        *_model(sizing, system),
    )


def _origin(record: Record, name: str) -> Source:
    return "given" if name in record.model_fields_set else "default"


def _rules(rules: DynamicsRules) -> Iterator[Assumption]:
    subjects = {
        "fidelity": "motions of planetary sets",
        "mesh_stiffness": "mesh stiffness model",
        "stiffness": "mesh stiffness over the mesh cycle",
        "harmonics": "harmonics of the mesh frequency kept",
        "mesh_damping": "damping ratio of meshes and bearings ζ",
        "shaft_damping": "damping ratio of shafts ζ",
        "machines": "machines in the model",
    }
    for name, subject in subjects.items():
        if name != "harmonics" or rules.stiffness == "varying":
            yield Assumption(subject, str(getattr(rules, name)), _origin(rules, name), f"dynamics.{name}")


def _curves(sizing: Sizing) -> Iterator[Assumption]:
    for mesh, curve in sizing.design.dynamics.curves.items():
        words = curve.file or f"{len(curve.phase_cycles)} points"
        yield Assumption(f"stiffness of {mesh}", words, "given", f"dynamics.curves.{mesh}")
    stated, pairs = sizing.design.dynamics, gear_pairs(sizing)
    for row in sizing.meshes:
        if row.name in stated.curves or row.stage in stated.curves:
            continue
        if (model := stiffness_model(sizing, row, pairs[row.name])) != stated.mesh_stiffness:
            words = f"{model}: its teeth are beyond those that {stated.mesh_stiffness} is for"
            yield Assumption(f"stiffness of {row.name}", words, "default", "dynamics.mesh_stiffness")


def _backlash(sizing: Sizing) -> Iterator[Assumption]:
    for name, stage in sizing.design.stages.items():
        plays = {mesh.name: play_in_motion(sizing, mesh.name) for mesh in sizing.meshes if mesh.stage == name}
        given, path = "backlash" in stage.model_fields_set, f"{sizing.design.table(name)}.backlash_um"
        if given or not any(plays.values()):
            words = f"{stage.backlash * 1e6:.4g} µm" if stage.backlash else "none: teeth stay in contact both ways"
            yield Assumption(f"backlash of {name}", words, _origin(stage, "backlash"), path)
            continue
        for mesh, play in plays.items():
            yield Assumption(f"backlash of {mesh}", f"{play * 1e6:.4g} µm, the mean of its fits", "computed", path)


def _bearings(sizing: Sizing) -> Iterator[Assumption]:
    if sizing.design.dynamics.fidelity == "rotational":
        if not sizing.design.supports:
            yield Assumption("bearings and pins", "rigid", "default", "dynamics.fidelity")
        return
    for name, planetary in sizing.design.planetaries.items():
        bearings = planetary.bearings
        for field, info in type(bearings).model_fields.items():
            quantity, path = quantity_of(info), f"planetaries.{name}.bearings.{field}"
            member = _MEMBER.get(field, field)
            if quantity is None or (field == "ring_tangential" and planetary.ring != GROUND):
                continue
            if member in bearings.rigid or (getattr(planetary, member, "") == "ground" and member != "ring"):
                yield Assumption(f"bearing of {name}.{field}", "rigid", "given", path)
                continue
            value = pin_stiffness(sizing, name) if field == "pin" else getattr(bearings, field)
            origin: Source = "computed" if field == "pin" and bearings.pin is None else _origin(bearings, field)
            words = text(value, quantity.dimension) if value else "none: floats"
            yield Assumption(f"bearing of {name}.{field}".replace("_", " "), words, origin, f"{path}_n_um")


def _inertias(sizing: Sizing) -> Iterator[Assumption]:
    for machine in sizing.machines:
        table = table_of(machine.name, sizing.design)
        origin: Source = "given" if machine.inertia_is_given else "computed" if machine.inertia else "default"
        path = f"{table}.{machine.name}.inertia_kg_m2"
        words = text(machine.inertia, "inertia") if machine.inertia else "none: not stated"
        yield Assumption(f"inertia of {machine.name}", words, origin, path)


def _model(sizing: Sizing, system: System) -> Iterator[Assumption]:
    arrays = system.arrays
    speed_dependent = np.any(arrays.loads.damping) or np.any(arrays.loads.quadratic)
    words = "depends on speed" if speed_dependent else "constant: does not change with speed"
    yield Assumption("torque of machines", words, "default", "")
    with_errors = bool(sizing.design.errors) or bool(np.any(arrays.error.cosine) or np.any(arrays.error.sine))
    errors: tuple[str, Source] = ("as the design states", "given") if with_errors else ("none: as drawn", "default")
    yield Assumption("errors of gears and shafts", *errors, "errors")
    yield Assumption("flanks", "no profile modification, contact along the whole width", "default", "")
    yield Assumption("shafts across sets and pairs", "coupled in rotation alone", "default", "")
