"""Are adaptive steps what they claim: the pair's order, its interpolant, its tolerance, its repeatability."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from test_integration import chain, oscillator

from gearwright.dynamics import Accuracy, Outputs, Periodic, replay, simulate
from gearwright.dynamics.equations import kernel
from gearwright.dynamics.motion import integrators
from gearwright.errors import DesignError, SolveError


def rocked_chain():
    """Return a chain with varying mesh stiffness, and run-out."""
    return chain(variation=Periodic({"rotor 0": 10}, (0.2, 0.1)), errors=[Periodic({"rotor 0": 1}, (1e-5,))])


WHOLE = Outputs(windows=((0.0, 0.01),))
USUAL = 1.3e-5
"""Default step of that chain [s]."""


@cache
def fine_forces(step: float):
    """Return the force of that chain's mesh by RK4, which both forms of the adaptive method are held against."""
    fine = simulate(rocked_chain(), 0.01, step=step, outputs=WHOLE, start="rigid", method="runge-kutta")
    return fine.windows[0].force("mesh")


def turned(length: float, steps: int) -> tuple[float, float]:
    """Return the error of an undamped oscillation (100 rad/s) after fixed steps, and halfway through the last one."""
    arrays = oscillator().arrays._replace(damping=np.zeros(1))
    right = integrators.Right(0, np.zeros(1), np.zeros(2), kernel.empty_instant(arrays))
    state, ahead, slopes, row = np.zeros(8), np.zeros(8), np.zeros((7, 8)), np.zeros(8)
    state[0], slopes[0, 1] = 1.0, -1e4
    for step in range(steps):
        if step:
            state[:], slopes[0] = ahead, slopes[6]
        integrators.attempt(arrays, right, integrators.Step(step * length, length), state, slopes, ahead)
    integrators.read_row(
        arrays, right, integrators.Step((steps - 1) * length, length), 0.5 * length, state, slopes, row
    )
    end, middle = steps * length, (steps - 0.5) * length
    return _off(ahead, end), _off(row, middle)


def _off(state: np.ndarray, time: float) -> float:
    """Return the distance of q and q̇/ω from cos ωt and −sin ωt."""
    return float(np.hypot(state[0] - np.cos(100.0 * time), state[1] / 100.0 + np.sin(100.0 * time)))


def test_the_pair_is_of_fifth_order_and_its_interpolant_of_fourth_or_more():
    """A fixed time of 0.05 s (5 rad): halving the step divides the errors by 2⁵; between steps by at least 2⁴."""
    errors = np.array([turned(0.05 / steps, steps) for steps in (20, 40, 80)])
    orders = np.log2(errors[:-1] / errors[1:])
    assert np.all((orders[:, 0] > 4.7) & (orders[:, 0] < 5.6))
    assert np.all(orders[:, 1] > 3.8)


def test_its_weights_are_those_of_the_order_conditions():
    """Σ b = 1, Σ b c^k = 1/(k + 1) to fourth power, rows of the tableau add up to their nodes; to print rounding."""
    weights = integrators.STAGES[6]
    for power in range(5):
        assert weights @ integrators.NODES**power == pytest.approx(1.0 / (power + 1), abs=1e-14)
    assert np.sum(integrators.STAGES, axis=1) == pytest.approx(integrators.NODES, abs=1e-14)
    # The embedded result is of fourth order: its difference meets the conditions up to the third power.
    assert [integrators.EMBEDDED @ integrators.NODES**power for power in range(4)] == pytest.approx(
        [0.0] * 4, abs=1e-13
    )
    # At θ = 1 the interpolant is the step itself.
    assert np.sum(integrators.INTERPOLANT, axis=1) == pytest.approx(weights, abs=1e-13)


@pytest.mark.parametrize("method", ["tsit5", "tsit5 generic"])
@pytest.mark.parametrize("asked", [1e-3, 1e-5, 1e-7])
def test_forces_are_as_accurate_as_asked(method, asked):
    """Against RK4 at 1/16 of its default step or less, which leaves below 1e-9; what is not shown to hold is marked.

    Instants never lie near enough for a peak to be seen to 1e-7.
    """
    found = simulate(rocked_chain(), 0.01, method=method, step=Accuracy(asked), outputs=WHOLE, start="rigid")
    parts = max(1, round(16.0 * found.step / USUAL))
    force, wanted = found.windows[0].force("mesh"), fine_forces(found.step / parts)[::parts]
    true = np.max(np.abs(force - wanted)) / np.max(np.abs(wanted))
    assert true <= 1.5 * asked
    marked = any("asked were" in note for note in found.notes)
    assert marked is (found.error > asked or found.rms_error > 0.1 * asked)
    assert not marked or asked < 1e-4


def test_statistics_and_energy_are_those_of_fixed_steps():
    """Both look at the same instants, 2e-5 s apart; the default tolerance leaves about 1e-4 of the force, RK4 far less.

    Works are sums over the run, in which errors of both signs cancel: to 1e-5.
    """
    system = rocked_chain()
    fixed = simulate(system, 0.05, step=2e-5, start="rigid", method="runge-kutta")
    free = simulate(system, 0.05, step=2e-5, start="rigid", method="tsit5")
    for key in ("mean", "minimum", "maximum", "rms"):
        assert free.force.of("mesh")[key] == pytest.approx(fixed.force.of("mesh")[key], rel=2e-4)
    assert free.work.driven == pytest.approx(fixed.work.driven, rel=1e-5)
    assert free.work.imbalance < 1e-5


@pytest.mark.parametrize("window", [(0.111, 0.122), (0.245, 0.25)])
def test_adaptive_runs_are_replayed_bit_for_bit(window):
    """Windows that begin and end inside blocks, and one that ends with the run, whose last block is short."""
    system = rocked_chain()
    trace = simulate(system, 0.25, method="tsit5", outputs=Outputs(windows=(window,)), start="rigid")
    again, once = replay(system, trace, *window), trace.windows[0]
    assert len(once.time) > 14
    assert np.array_equal(again.line_force, once.line_force)
    assert np.array_equal(again.velocity, once.velocity)


def test_a_run_that_lost_its_tolerance_cannot_be_replayed():
    system = rocked_chain()
    trace = replace(simulate(system, 0.01, method="tsit5", start="rigid"), tolerance=0.0)
    with pytest.raises(DesignError, match=r"trace\.tolerance: .*can only be repeated at the tolerance"):
        replay(system, trace, 0.001, 0.002)


def test_nothing_to_measure_by_is_refused():
    system = oscillator()
    with pytest.raises(DesignError, match="there is none: use runge-kutta"):
        simulate(system, 0.1, method="tsit5", start="rigid")


def test_a_motion_that_cannot_be_followed_is_named_with_its_time():
    """A load that grows with the square of speed, the wrong way, goes to infinity in finite time: 1/(b θ̇₀) = 1 s."""
    system = oscillator()
    zero = np.zeros(1)
    wild = system.arrays.loads._replace(quadratic=np.array([-1.0]), constant=zero)
    system = replace(system, arrays=system.arrays._replace(loads=wild, stiffness=np.array([1e-9]), damping=zero))
    with pytest.raises(SolveError, match=r"the run diverged at (0\.999\d*|1) s"):
        simulate(system, 2.0, method="tsit5", step=1e-3, start=(zero, np.ones(1)))
