"""Meshes of a sizing: their geometry, and their stiffness by the model that the design names."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.parts import Material
from gearwright.parts.gears import CylindricalGear, GearPair
from gearwright.parts.iso6336 import relief_term
from gearwright.parts.stiffness import (
    MeshStiffness,
    StiffnessCurve,
    cut_square_wave,
    mesh_curve_iso6336,
    mesh_stiffness_energy,
    mesh_stiffness_iso6336,
    mesh_stiffness_kuang_yang,
    sampled_curve,
)
from gearwright.sizing import GearSizing, MeshSizing, Sizing, cylindrical_gear
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.spec import Pair
from gearwright.spec.design import MeshCurve
from gearwright.train import INTERNAL, PowerFlow

_OF_SHAPE = ("profile_shift", "helix_angle", "teeth")
"""Arguments at whose ends a model of stiffness ends, and strain energy does not."""


def gear_pairs(sizing: Sizing) -> dict[str, GearPair]:
    """Return the geometry of every mesh row, one mesh of it, gear a first; of bevel gears the virtual pair.

    Args:
        sizing: What was sized.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    pairs = {}
    for mesh, row in zip(sizing.meshes, sizing.train.meshes, strict=True):
        stage = sizing.design.stages[mesh.stage]
        first, second = (cylindrical_gear(sizing.design, gears[gear]) for gear in mesh.gears)
        if isinstance(stage, Pair) and stage.kind == "bevel":
            first, second = _virtual(first, second)
        second = replace(second, teeth=-second.teeth) if row.sign == INTERNAL else second
        unmoved = first.profile_shift + second.profile_shift == 0.0
        pairs[mesh.name] = GearPair(first, second, None if unmoved else mesh.centre_distance)
    return pairs


def gear_of(sizing: Sizing, name: str) -> GearSizing:
    """Return a gear by its name.

    Args:
        sizing: What was sized.
        name: Such as ``first.wheel``.
    """
    return next(gear for gear in sizing.gears if gear.name == name)


def _virtual(pinion: CylindricalGear, wheel: CylindricalGear) -> tuple[CylindricalGear, CylindricalGear]:
    """Return Tredgold's cylindrical gears at the mean cone, z/cos δ to whole teeth: for the stiffness of a tooth."""
    slant = math.hypot(pinion.teeth, wheel.teeth)
    virtual_pinion = replace(pinion, teeth=round(pinion.teeth * slant / wheel.teeth))
    return virtual_pinion, replace(wheel, teeth=round(wheel.teeth * slant / pinion.teeth))


def mesh_curve(sizing: Sizing, mesh: MeshSizing, pair: GearPair, *, harmonics: int | None = None) -> StiffnessCurve:
    """Return the stiffness of one mesh of a row along its line of action, by the design's model.

    Args:
        sizing: What was sized.
        mesh: The row at its worst case, whose specific load counts.
        pair: Its geometry.
        harmonics: Of the mesh frequency; 0 gives the mean; left out: as the design says.

    Raises:
        DesignError: If the model does not hold for these gears, with the mesh.
    """
    rules, name = sizing.design.dynamics, mesh.stage
    orders = rules.harmonics if harmonics is None else harmonics
    stated = rules.curves.get(mesh.name) or rules.curves.get(name)
    try:
        curve = _sampled(stated, orders) if stated is not None else _by_model(sizing, mesh, pair, orders)
    except DesignError as error:
        at = f"dynamics.curves.{mesh.name}" if stated is not None else "dynamics.mesh_stiffness"
        fix = "" if stated is not None else _other_model(rules.mesh_stiffness)
        raise DesignError(
            Problem(at, f"{mesh.name}: {problem.message}{fix if problem.path in _OF_SHAPE else ''}")
            for problem in error.problems
        ) from None
    stage = sizing.design.stages[name]
    return _known(curve, stage) if isinstance(stage, Pair) else curve


def variation_left(sizing: Sizing, mesh: MeshSizing, flow: PowerFlow) -> float:
    """Return what tip relief leaves of the variation of a mesh's stiffness in a load case, B_k, at most 1 [-].

    Relief makes up for the deflection of one load, that of K_A and K_γ included; B_k says what is left at another. A
    stated stiffness is taken as it is, and so are teeth whose method of rating knows no relief.

    Args:
        sizing: What was sized.
        mesh: A row of it.
        flow: The load case.

    Source: ISO 6336-1:2006, clause 6.5.5.
    """
    design, rated, stage = sizing.design, mesh.rating, sizing.design.stages[mesh.stage]
    stated = mesh.name in design.dynamics.curves or mesh.stage in design.dynamics.curves
    if (
        stated
        or not isinstance(rated, Iso6336Rating)
        or (isinstance(stage, Pair) and stage.stiffness_swing is not None)
    ):
        return 1.0
    first = gear_of(sizing, mesh.gears[0])
    radius = 0.5 * first.pitch_diameter / first.teeth
    width = min(gear_of(sizing, gear).face_width for gear in mesh.gears)
    load = abs(flow.meshes[mesh.name].multiplier) / mesh.count / radius / width
    load *= design.service.application_factor * mesh.load_factor
    if load <= 0.0:
        return 1.0
    return min(float(relief_term(rated.factors.relief, load, grade=rated.made.grade)), 1.0)


def _other_model(model: str) -> str:
    """Return what a user writes where a model ends at the shape of the teeth."""
    if model == "energy":
        return ""
    return f'; {model!r} ends there: write dynamics.mesh_stiffness = "energy", which follows any shape of the teeth'


def _sampled(stated: MeshCurve, harmonics: int) -> StiffnessCurve:
    phase = 2.0 * math.pi * np.array(stated.phase_cycles)
    return sampled_curve(phase, stated.stiffness_n_m, harmonics=harmonics, source=stated.file or "design")


def stiffness_model(sizing: Sizing, mesh: MeshSizing, pair: GearPair) -> str:
    """Return by which model a mesh is as stiff as it is: strain energy where no model is asked and the usual one ends.

    Args:
        sizing: What was sized.
        mesh: The row at its worst case.
        pair: Its geometry.
    """
    rules = sizing.design.dynamics
    if "mesh_stiffness" in rules.model_fields_set:
        return rules.mesh_stiffness
    try:
        _iso(mesh, pair, _materials(sizing, mesh))
    except DesignError as error:
        if any(problem.path in _OF_SHAPE for problem in error.problems):
            return "energy"
    return rules.mesh_stiffness


def _by_model(sizing: Sizing, mesh: MeshSizing, pair: GearPair, harmonics: int) -> StiffnessCurve:
    made = _materials(sizing, mesh)
    match stiffness_model(sizing, mesh, pair):
        case "energy":
            return mesh_stiffness_energy(pair, materials=made, harmonics=harmonics)
        case "kuang-yang":
            return mesh_stiffness_kuang_yang(pair, harmonics=harmonics, elastic_moduli=_moduli(made))
        case "square-wave":
            wave = cut_square_wave(_iso(mesh, pair, made).mesh * pair.face_width)
            return replace(wave, cosine=wave.cosine[:harmonics], sine=wave.sine[:harmonics])
    return mesh_curve_iso6336(pair, _iso(mesh, pair, made), harmonics=harmonics)


def _materials(sizing: Sizing, mesh: MeshSizing) -> tuple[Material, Material]:
    """Return what both gears are of: that of the stage, with E and ν of the classes that they are rated as."""
    material, rated = sizing.design.gear_material(mesh.stage), mesh.rating
    if not isinstance(rated, Iso6336Rating):
        return material, material
    first, second = (
        replace(material, elastic_modulus=steel.elastic_modulus, poisson_ratio=steel.poisson_ratio)
        for steel in (rated.steel, rated.mate_steel or rated.steel)
    )
    return first, second


def _iso(mesh: MeshSizing, pair: GearPair, made: tuple[Material, Material]) -> MeshStiffness:
    # A mesh that idles in every case has no load; the standard's method asks for some.
    load = max(mesh.tangential_force / pair.face_width, 1.0)
    return mesh_stiffness_iso6336(pair, specific_load=load, elastic_moduli=_moduli(made))


def _moduli(made: tuple[Material, Material]) -> tuple[float, float]:
    return made[0].elastic_modulus, made[1].elastic_modulus


def _known(curve: StiffnessCurve, pair: Pair) -> StiffnessCurve:
    """Return a stiffness curve with what the design gives of it: its mean, its first harmonic."""
    mean = pair.mesh_stiffness or curve.mean
    if pair.stiffness_swing is not None and curve.cosine:
        return StiffnessCurve(mean, (pair.stiffness_swing * mean,), (0.0,), "design")
    if pair.mesh_stiffness is None:
        return curve
    scale = mean / curve.mean
    return StiffnessCurve(mean, tuple(scale * a for a in curve.cosine), tuple(scale * b for b in curve.sine), "design")
