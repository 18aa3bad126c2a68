"""Two ways to one model: a sized gearbox, and its stages written as planetary sets with rigid bearings."""

import math
from importlib.resources import files

import numpy as np
import pytest

from gearwright.dynamics.assembly import assemble, gear_pairs, mesh_curve
from gearwright.dynamics.equations import line_state, modes
from gearwright.dynamics.model import Member, Model, PlanetarySet, add_planetary
from gearwright.parts.planetary import even_positions, planet_phases
from gearwright.sizing import size
from gearwright.spec import read


def as_set(sizing, system, stage):
    """One stage of a sizing with the assembled bodies' inertias."""
    inertia = dict(zip(system.labels.coordinates, system.arrays.mass, strict=True))
    pairs, meshes = gear_pairs(sizing), {mesh.name: mesh for mesh in sizing.meshes}
    sun_mesh, ring_mesh = pairs[f"{stage}.sun-planet"], pairs[f"{stage}.planet-ring"]
    curves = [
        mesh_curve(sizing, meshes[f"{stage}.{end}"], pairs[f"{stage}.{end}"]) for end in ("sun-planet", "planet-ring")
    ]
    planet = next(gear for gear in sizing.gears if gear.name == f"{stage}.planet")
    places = even_positions(planet.bodies)
    radius = sun_mesh.centre_distance
    carrier = inertia[f"{stage}.carrier"] - planet.bodies * planet.mass * radius**2
    return PlanetarySet(
        sun=Member(1.0, inertia[f"{stage}.sun"], sun_mesh.driver.base_radius),
        ring=Member(1.0, 1.0, ring_mesh.driven.base_radius, torsion=math.inf),
        carrier=Member(1.0, carrier, radius),
        planet=Member(planet.mass, inertia[f"{stage}.planet-1"], sun_mesh.driven.base_radius),
        sun_mesh=curves[0],
        ring_mesh=curves[1],
        pressure_angles=(sun_mesh.working_pressure_angle, ring_mesh.working_pressure_angle),
        positions=places,
        sun_teeth=sun_mesh.driver.teeth,
        phases=planet_phases(sun_mesh, ring_mesh, places),
    )


@pytest.mark.parametrize("design", ["single-planetary", "in-line", "in-line-h2"])
def test_a_sized_gearbox_and_its_stages_written_as_sets_are_one_model(design):
    """Natural frequencies, speeds, and every mesh stiffness at some instant; 1e-9 is rounding."""
    path = files("gearwright.shipped") / "designs" / f"{design}.toml"
    sizing = size(read(path))
    system = assemble(sizing, stiffness="varying")
    labels, arrays = system.labels, system.arrays
    inertia = dict(zip(labels.coordinates, arrays.mass, strict=True))
    speed = dict(zip(labels.coordinates, arrays.speed, strict=True))
    model = Model()
    stages = {name.partition(".")[0] for name in labels.coordinates if name.endswith(".sun")}
    for stage in stages:
        speeds = {"carrier": float(speed[f"{stage}.carrier"])}
        add_planetary(model, as_set(sizing, system, stage), name=stage, speeds=speeds)
    for name in labels.coordinates:
        if "." not in name:
            model.rotation(name, inertia=float(inertia[name]))
    for number, kind in enumerate(labels.line_kinds):
        if kind == "shaft":
            row = slice(arrays.line_start[number], arrays.line_start[number + 1])
            ends = sorted(zip(arrays.line_weight[row], arrays.line_dof[row], strict=True), reverse=True)
            first, second = (labels.coordinates[dof] for _, dof in ends)
            model.shaft(labels.lines[number], first, second, stiffness=float(arrays.stiffness[number]))
    written = model.build()
    assert modes(written).frequency == pytest.approx(modes(system).frequency, rel=1e-9, abs=1e-6)
    for name, value in zip(written.labels.coordinates, written.arrays.speed, strict=True):
        assert value == pytest.approx(speed[name])
    rest, time = np.zeros(len(arrays.mass)), 1.2345e-3
    stiffness = dict(zip(labels.lines, line_state(arrays, time, rest, rest).stiffness, strict=True))
    found = line_state(written.arrays, time, rest, rest).stiffness
    for name, value in zip(written.labels.lines, found, strict=True):
        assert value == pytest.approx(stiffness[name], rel=1e-9), name
