"""A damper of a design: its slip loads the train, its heat closes the power, and nothing else changes."""

import dataclasses
import re

import numpy as np
import pytest

import gearwright as gw
from designs import HYBRID, problem
from gearwright.dynamics import modes, simulate, statics
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import redundancy
from gearwright.dynamics.model import line_matrix
from gearwright.dynamics.sharing import sharing_problem, sharing_study
from gearwright.errors import DesignError
from gearwright.identity import Kind
from gearwright.mission import fly
from gearwright.render.schematic import power_flow_figure, schematic_figure
from gearwright.sizing import size
from gearwright.spec import parse, parse_mission
from gearwright.train import branches

C = 0.1
DAMPER = f"""
[dampers.drum]
driving = "middle"
driven = "output"
damping_nm_s_rad = {C}
"""


@pytest.fixture(scope="module")
def damped():
    return size(parse(HYBRID + DAMPER))


@pytest.fixture(scope="module")
def plain():
    return size(parse(HYBRID))


def test_its_heat_closes_the_power_of_every_case(damped):
    """P = c (ω_driving − ω_driven)², which the propeller lacks."""
    for case, flow in damped.flows.items():
        slip = flow.speeds["middle"] - flow.speeds["output"]
        assert flow.loss == pytest.approx(C * slip**2, rel=1e-12), case
        assert sum(flow.machine_powers.values()) == pytest.approx(C * slip**2, rel=1e-9)
        assert flow.residual < 1e-9
        at_middle = [branch.torque for branch in branches(damped.train, flow) if branch.shaft == "middle"]
        assert sum(at_middle) == pytest.approx(0.0, abs=1e-9 * max(map(abs, at_middle)))
        (drum,) = [
            branch.torque
            for branch in branches(damped.train, flow)
            if branch.part.kind is Kind.DAMPER and branch.shaft == "output"
        ]
        assert drum == pytest.approx(C * slip, rel=1e-12)


def test_its_torque_is_the_static_force_of_the_dynamic_model(damped):
    flow = damped.flows["cruise"]
    system = assemble(damped, "cruise")
    line = system.labels.lines.index("drum damper")
    assert statics(system).force[line] == pytest.approx(C * (flow.speeds["middle"] - flow.speeds["output"]), rel=1e-9)
    assert system.labels.line_owners[line].part.name == "drum"


def test_it_changes_no_mode_and_no_redundancy(damped, plain):
    """Of one and the same gearbox: the damper is taken out of the train, and all sizes stay."""
    without = dataclasses.replace(damped, train=dataclasses.replace(damped.train, dampers=()))
    systems = [assemble(sizing, "cruise", stiffness="constant") for sizing in (damped, without)]
    frequencies = [modes(system).frequency for system in systems]
    assert frequencies[0] == pytest.approx(frequencies[1], rel=1e-9)
    assert redundancy(systems[0]).count == redundancy(assemble(plain, "cruise", stiffness="constant")).count


@pytest.mark.parametrize("method", ["exact", "runge-kutta", "implicit"])
def test_a_train_in_equilibrium_stays_there_and_its_heat_is_counted(damped, method):
    """Nothing moves, so that the machines' power less the propeller's is the damper's heat; rounding of 1 ms."""
    system = assemble(damped, "cruise", stiffness="constant")
    step = None if method == "exact" else 2e-7
    trace = simulate(system, 1e-4, method=method, step=step)
    flow = damped.flows["cruise"]
    assert trace.work.dissipated == pytest.approx(flow.loss * trace.duration, rel=1e-6)
    assert trace.work.driven - trace.work.braked == pytest.approx(trace.work.dissipated, rel=1e-5)
    force = trace.force.of("drum damper")
    assert np.ptp(force["mean"]) < 1e-6 * abs(force["mean"][0])


def test_paths_share_their_load_as_without_it(damped):
    """Equal planets carry alike, what the damper lets past them is missing, and both ways to the forces agree."""
    problem = sharing_problem(damped, "second", case="cruise")
    force, places = (
        redundancy(problem.system).perfect,
        [problem.system.labels.lines.index(name) for name in problem.lines],
    )
    assert redundancy(assemble(damped, "cruise", stiffness="constant")).perfect == pytest.approx(
        statics(assemble(damped, "cruise", stiffness="constant")).force, rel=1e-9
    )
    assert force[places] == pytest.approx(np.full(len(places), force[places].mean()), rel=1e-9)
    flow, sun = damped.flows["cruise"], problem.system.labels.coordinates.index("second.sun")
    arms = line_matrix(problem.system.arrays)[places, sun]
    assert abs(arms @ force[places]) == pytest.approx(abs(flow.meshes["second.sun-planet"].torques[0]), rel=1e-9)
    assert sharing_study(problem).problem.lines == problem.lines


def test_shafts_that_turn_alike_lose_nothing_and_fly():
    text = HYBRID.replace('"output"]', '"output", "drum"]').replace(
        "[planetaries.first]",
        '[clutches.tie]\ndriving = "drum"\ndriven = "middle"\nkind = "engaged"\n[planetaries.first]',
    )
    text = text.replace('[motors.electric]\nshaft = "middle"', '[motors.electric]\nshaft = "drum"')
    text += DAMPER.replace('driven = "output"', 'driven = "drum"')
    sizing = size(parse(text))
    assert all(flow.dampers["drum"].loss == 0.0 for flow in sizing.flows.values())
    assert sizing.flows["cruise"].dampers["drum"].slip == 0.0
    assert fly(sizing, parse_mission(MISSION)).balance.residual < 1e-9
    assert schematic_figure(sizing).axes
    assert power_flow_figure(sizing, "cruise").axes


MISSION = """
schema = 1
name = "m"
propeller_map = "none"
[phases.one]
altitude_ft = 1000
tas_kt = 100
duration_min = 2
power_kw = 900
propeller_speed_rpm = 1212
mode = "conventional"
"""


def test_a_mission_refuses_a_damper_that_slips(damped):
    with pytest.raises(DesignError, match=r"dampers\.drum: its shafts turn at different speeds"):
        fly(damped, parse_mission(MISSION))


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('driven = "output"', 'driven = "middle"', "a damper joins two different shafts"),
        ('driven = "output"', 'driven = "outputs"', "there is no shaft 'outputs'.*output"),
        (f"damping_nm_s_rad = {C}", "damping_nm_s_rad = -1", "dampers.drum.damping_nm_s_rad"),
        (f"damping_nm_s_rad = {C}", "damping_nm_s_rad = 0", "dampers.drum.damping_nm_s_rad"),
        (f"damping_nm_s_rad = {C}", "damping = 1", "the unit is missing; write one of damping_nm_s_rad"),
        ("[dampers.drum]", '[clutches.drum]\ndriving = "input"\ndriven = "middle"\n[dampers.drum]', "clutches.drum is"),
    ],
)  # fmt: skip
def test_what_is_no_damper_is_refused(old, new, says):
    text = HYBRID + DAMPER
    assert old in text
    assert re.search(says, "{0.path}: {0.message}".format(problem(text.replace(old, new))))


def test_a_design_with_a_damper_is_saved_and_loaded(damped, tmp_path):
    gw.save(damped, tmp_path / "sizing.json")
    assert gw.load(tmp_path / "sizing.json") == damped
