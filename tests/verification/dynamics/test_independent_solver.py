"""The compiled march against another solver: scipy's DOP853 on the right-hand side in plain numpy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gearwright.dynamics import DampingRatio, Model, Periodic, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import acceleration
from gearwright.dynamics.motion import default_step
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse


def geared_pair(load):
    """Two gears with backlash and a stiffness that swings by a third; driven and braked, free to turn."""
    model = Model()
    pinion = model.rotation("pinion", inertia=1e-3, speed=300.0)
    wheel = model.rotation("wheel", inertia=4e-3)
    swing = Periodic({pinion: 20}, (0.3,), (0.1,))
    model.mesh(
        "mesh",
        {pinion: 0.02, wheel: 0.04},
        stiffness=1e8,
        damping=DampingRatio(0.03),
        backlash=40e-6,
        variation=swing,
        errors=(Periodic({pinion: 1}, (5e-6,)),),
    )
    model.load(pinion, constant=load)
    model.load(wheel, constant=2.0 * load)
    return model.build()


def shipped(name, more):
    text = shipped_design(name).read_text(encoding="utf-8")
    return assemble(size(parse(f"{text}\n{more}")), stiffness="varying")


SYSTEMS = {
    "a loaded pair": lambda: geared_pair(30.0),
    "two sets in line": lambda: shipped("in-line-h2", ""),
    "a set that moves across": lambda: shipped("single-planetary", '[dynamics]\nfidelity = "translational"'),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_a_simulated_motion_is_that_of_another_solver_within_the_error_of_its_step(name):
    """From the rigid motion, loads put on at once. The step's error is what half the step changes: a method of order p
    leaves 2^p/(2^p − 1) of it, at most twice.
    """
    system = SYSTEMS[name]()
    arrays, count = system.arrays, len(system.arrays.mass)
    step = 0.25 * default_step(arrays)
    coarse, fine = (
        simulate(system, 200 * step, method="runge-kutta", step=h, start="rigid") for h in (step, step / 2.0)
    )
    time = coarse.samples.time

    def slope(instant, state):
        return np.concatenate([state[count:], acceleration(arrays, instant, state[:count], state[count:])])

    rest = np.zeros(2 * count)
    other = solve_ivp(slope, (0.0, time[-1]), rest, "DOP853", time, rtol=1e-10, atol=1e-16, max_step=step)
    exact = other.y[:count].T
    scale = np.abs(exact).max(axis=0)
    half = fine.samples.position[::2]
    np.testing.assert_allclose(fine.samples.time[::2], time, rtol=1e-12, atol=1e-15)
    change = np.abs(coarse.samples.position - half).max(axis=0) / scale
    assert change.max() < 1e-3
    assert np.all(np.abs(coarse.samples.position - exact).max(axis=0) / scale < 2.0 * change + 1e-9)
