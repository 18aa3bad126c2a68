"""Plans: what is made of a system's numbers is kept with them, and never outlives them."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np

from gearwright.dynamics import DampingRatio, Model, Periodic, simulate
from gearwright.dynamics.codegen import topology
from gearwright.dynamics.model import kept, plan_of
from gearwright.dynamics.model.system import PLANS


def pair(stiffness: float = 1e8):
    """Return a pinion that drives a wheel, with loads that change with time."""
    model = Model()
    pinion, wheel = model.rotation("pinion", inertia=1e-4, speed=1000.0), model.rotation("wheel", inertia=1e-3)
    model.mesh(
        "mesh", {pinion: 0.025, wheel: 0.05}, stiffness=stiffness, damping=DampingRatio(0.05), backlash=1e-4,
        variation=Periodic({pinion: 20}, cosine=(0.2,)),
    )  # fmt: skip
    model.load(pinion, constant=50.0, schedule=[(0.0, 0.0), (0.01, 1.0), (0.02, 0.0)])
    model.load(wheel, constant=100.0)
    return model.build()


def test_equal_numbers_have_one_plan():
    assert plan_of(pair().arrays) is plan_of(pair().arrays)
    assert plan_of(pair(2e8).arrays) is not plan_of(pair().arrays)


def test_a_plan_of_a_plan_is_itself():
    plan = plan_of(pair().arrays)
    assert plan_of(plan) is plan


def test_what_is_made_is_made_once_for_a_plan_and_each_time_for_other_numbers():
    made = []
    for arrays in (plan_of(pair(3e8).arrays), pair(3e8).arrays):
        for _ in range(2):
            kept(arrays, ("test",), lambda: made.append(1))
    assert len(made) == 3


def test_numbers_that_change_in_place_have_another_plan():
    system = pair()
    before = simulate(system, 0.005)
    system.arrays.stiffness[0] *= 2.0
    after = simulate(system, 0.005)
    system.arrays.stiffness[0] /= 2.0
    again = simulate(system, 0.005)
    assert after.step != before.step
    np.testing.assert_array_equal(before.samples.line_force, again.samples.line_force)


def test_what_is_replaced_in_a_plan_is_a_plan_no_longer():
    plan = plan_of(pair().arrays)
    other = plan._replace(backlash=np.zeros(1))
    assert plan_of(other) is not other
    assert topology(plan).lines[0].gap
    assert not topology(other).lines[0].gap


def test_a_plan_that_was_let_go_keeps_nothing():
    plan, made = plan_of(pair().arrays), []
    for number in range(PLANS):
        plan_of(pair(1e6 * (1 + number)).arrays)
    for _ in range(2):
        kept(plan, ("test",), lambda: made.append(1))
    assert len(made) == 2


def test_runs_side_by_side_with_one_plan_do_not_disturb_each_other():
    """Clock tables with loads in them are filled while a run goes on: each run has its own."""
    system = pair()
    alone = simulate(system, 0.02)
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda _: simulate(replace(system), 0.02), range(8)))
    for trace in together:
        np.testing.assert_array_equal(trace.samples.line_force, alone.samples.line_force)
