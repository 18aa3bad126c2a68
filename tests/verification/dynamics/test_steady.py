"""Periodic motions and their stability."""

import math

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Outputs, Periodic, periodic, simulate
from gearwright.dynamics.vibration import common_period
from gearwright.errors import DesignError


def parametric(depth: float, ratio: float, zeta: float = 0.01):
    """Return a rotor on a spring of changing stiffness, ω = 100 rad/s, excited at `ratio` ω, lightly loaded."""
    model = Model()
    model.rotation("clock", inertia=1.0, speed=100.0 * ratio)
    model.rotation("rotor", inertia=1.0, speed=0.0)
    wave = Periodic({"clock": 1}, (depth,))
    model.mesh("spring", {"rotor": 1.0}, stiffness=1e4, damping=DampingRatio(zeta), variation=wave)
    model.load("rotor", constant=1.0)
    return model.build()


def test_the_orbit_is_where_a_long_run_settles():
    """Transients decay as e^(−ζωt); after 20 s at ζ = 5 % nothing of them is left."""
    system = parametric(0.2, 1.7, zeta=0.05)
    orbit = periodic(system)
    periods = round(20.0 / orbit.period)
    step = orbit.period / (len(orbit.samples.time) - 1)
    last = Outputs(windows=((periods * orbit.period, (periods + 1) * orbit.period),))
    run = simulate(system, (periods + 1) * orbit.period, step=step, outputs=last, method="runge-kutta")
    np.testing.assert_allclose(
        run.windows[0].force("spring")[:100], orbit.samples.force("spring")[:100], rtol=0.0, atol=1e-6
    )


def test_multipliers_of_a_constant_spring_are_those_of_the_damped_oscillator():
    """e^(λT) with λ = −ζω ± iω√(1−ζ²); RK4 at the default step leaves 1e-4."""
    orbit = periodic(parametric(1e-12, 1.7), step=1e-4)
    turn = np.exp((-1.0 + 1j * 100.0 * math.sqrt(1 - 1e-4)) * orbit.period)
    elastic = orbit.multipliers[np.argsort(np.abs(np.abs(orbit.multipliers) - abs(turn)))][:2]
    assert np.sort(elastic.imag) == pytest.approx(sorted([turn.imag, -turn.imag]), abs=1e-6)
    assert orbit.stable


@pytest.mark.parametrize(("depth", "stable"), [(0.03, True), (0.05, False)])
def test_the_principal_instability_of_mathieus_equation_begins_where_it_should(depth, stable):
    """At twice the natural frequency the motion is unstable where the relative depth exceeds 4 ζ (here 0.04).

    Source: Nayfeh, Mook 1979, Nonlinear Oscillations, section 5.2: first-order boundary of the principal tongue.
    """
    assert periodic(parametric(depth, 2.0)).stable is stable


def test_the_common_period_is_that_of_the_whole_numbers():
    """Tones of 3 and 4 per turn and run-out of 1 per turn repeat with the turn; 6 and 4 in half of it."""
    model = Model()
    model.rotation("shaft", inertia=1.0, speed=2.0 * math.pi)
    model.rotation("rotor", inertia=1.0, speed=0.0)
    waves = [Periodic({"shaft": 6}, (1e-6,)), Periodic({"shaft": 4}, (1e-6,))]
    model.mesh("mesh", {"rotor": 1.0}, stiffness=1.0, errors=waves)
    assert common_period(model.build().arrays) == pytest.approx(0.5, rel=1e-12)
    model.mesh("other", {"rotor": 1.0}, stiffness=1.0, errors=[Periodic({"shaft": 1}, (1e-6,))])
    assert common_period(model.build().arrays) == pytest.approx(1.0, rel=1e-12)


def test_a_system_without_tones_has_no_period():
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.support("spring", "rotor", stiffness=1.0)
    with pytest.raises(DesignError, match="a periodic motion needs one"):
        periodic(model.build())
