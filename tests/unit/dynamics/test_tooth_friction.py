"""A model of a case with losses stands at the power flow's torques: friction of the teeth is part of its loads."""

import pytest

from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.assembly.meshes import base_circles
from gearwright.dynamics.equations import statics
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import edited, read

TRAINS = [
    ("wolfrom-reducer", {}),
    ("ravigneaux-automatic", {}),
    ("contra-rotating-propellers", {}),
    ("geared-turbofan-star", {}),
    ("in-line-h2", {"gears.mesh_efficiency": 0.98}),
    ("off-set", {"gears.mesh_efficiency": 0.98}),
    ("in-line", {"gears.mesh_efficiency": 0.98, "dynamics.fidelity": "translational"}),
]


@pytest.mark.parametrize("name, edits", TRAINS, ids=lambda value: value if isinstance(value, str) else "")
def test_statics_of_every_case_balance_and_give_the_tooth_forces_of_the_flow(name, edits):
    """1e-6 of the force: what a static solution of stiffnesses far apart leaves; once the train sped up instead."""
    sizing = size(edited(read(shipped_design(name)), edits))
    for case, flow in sizing.flows.items():
        system = assemble(sizing, case, stiffness="constant")
        force = dict(zip(system.labels.lines, statics(system).force, strict=True))
        rows = {}
        for mesh in sizing.train.meshes:  # parallel meshes of a pair share as they are stiff
            rows.setdefault(mesh.stage if mesh.stage in sizing.design.pairs else mesh.name, []).append(mesh)
        for row, meshes in rows.items():
            found = sum(value for line, value in force.items() if line.startswith(row))
            torques = sum(abs(flow.meshes[mesh.name].multiplier) for mesh in meshes) * sizing.teeth[meshes[0].gears[0]]
            assert found == pytest.approx(torques / base_circles(sizing, meshes[0]).first, rel=1e-6, abs=1e-6)
