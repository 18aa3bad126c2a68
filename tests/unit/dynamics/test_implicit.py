"""The implicit step: second order, stable where explicit steps are not, right about contact."""

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Outputs, Periodic, simulate
from random_systems import random_system


def stiff_and_soft(stiff: float = 1e15):
    """Return a soft shaft (25 Hz) behind a mesh whose own mode lies at 1e15 N/m: 2e8 rad/s."""
    model = Model()
    model.rotation("pinion", inertia=1e-4, speed=50.0)
    model.rotation("wheel", inertia=1e-4)
    model.rotation("brake", inertia=0.01)
    wave = Periodic({"pinion": 20}, (0.1,))
    weights = {"pinion": 0.05, "wheel": 0.05}
    model.mesh("mesh", weights, stiffness=stiff, damping=DampingRatio(0.05), variation=wave)
    model.shaft("shaft", "wheel", "brake", stiffness=2.0, damping=DampingRatio(0.05))
    model.load("pinion", constant=1.0)
    model.load("brake", constant=1.0)
    return model.build()


def test_halving_the_implicit_step_divides_the_error_by_four():
    """Against Runge–Kutta at a fine step; smooth motion."""
    system, span = stiff_and_soft(1e5), Outputs(windows=((0.0, 0.1),))
    wanted = simulate(system, 0.1, step=2e-5, start="rigid", outputs=span).windows[0].position[-1]
    errors = []
    for step in (1e-3, 5e-4, 2.5e-4):
        run = simulate(system, 0.1, step=step, start="rigid", outputs=span, method="implicit")
        errors.append(np.max(np.abs(run.windows[0].position[-1] - wanted)))
    assert 3.0 < errors[0] / errors[1] < 5.5
    assert 3.0 < errors[1] / errors[2] < 5.5


def test_a_stiff_system_is_given_to_implicit_steps():
    """Explicit steps would have to be 5 ns; what excites is at 159 Hz. The soft shaft carries its load."""
    trace = simulate(stiff_and_soft(), 0.2)
    assert trace.method == "implicit"
    assert trace.step > 1e-4
    assert trace.force.of("shaft")["mean"][0] == pytest.approx(-1.0, rel=1e-3)


@pytest.mark.parametrize("seed", range(4))
def test_implicit_and_explicit_steps_agree_with_contact_and_frames(seed):
    """Random systems before their speed ramps: 2e-3 of the largest force at a step of 2e-5 s."""
    system, span = random_system(seed), Outputs(windows=((0.0, 0.08),))
    explicit, implicit = (
        simulate(system, 0.08, step=2e-5, start="rigid", outputs=span, method=method).windows[0].line_force
        for method in ("runge-kutta", "implicit")
    )
    assert np.max(np.abs(explicit - implicit)) < 2e-3 * np.max(np.abs(explicit))
