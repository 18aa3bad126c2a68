"""Torque of a short-circuited motor against its voltage equations, step by step, and against limits by hand."""

import math

import numpy as np
import pytest

from gearwright.machines import Winding, marched, short_circuit_torque

WINDING = Winding(back_emf=250.0, inductance=0.1e-3, resistance=0.01, pole_pairs=6, rated_speed=471.2)


def test_the_closed_form_solves_the_voltage_equations():
    """d- and q-axis separately by Runge-Kutta from the loaded state; 1e-6 is the error of its steps."""
    speed, before = 467.6, 1005.0
    linkage, electric = WINDING.linkage, WINDING.pole_pairs * speed
    per_current = 1.5 * WINDING.pole_pairs * linkage

    def rates(state):
        direct, quadrature = state
        return np.array([
            (-WINDING.resistance * direct + electric * WINDING.inductance * quadrature) / WINDING.inductance,
            (-WINDING.resistance * quadrature - electric * (WINDING.inductance * direct + linkage))
            / WINDING.inductance,
        ])  # fmt: skip

    time, states = marched(rates, (0.0, before / per_current), duration=0.02, step=5e-6)
    torque = short_circuit_torque(WINDING, speed, before=before, time=time)
    assert torque == pytest.approx(per_current * states[:, 1], abs=1e-6 * np.abs(torque).max())


def test_a_motor_without_flux_gives_no_torque():
    still = WINDING._replace(back_emf=0.0)
    assert np.all(short_circuit_torque(still, 400.0, before=0.0, time=np.linspace(0.0, 0.1, 50)) == 0.0)


def test_without_resistance_the_peak_is_three_e_squared_over_speed_and_reactance_and_stays():
    """T = −3 E²/(Ω X) sin ω t; 1e-3: instants of the sampling."""
    ideal = WINDING._replace(resistance=0.0)
    speed = ideal.rated_speed
    torque = short_circuit_torque(ideal, speed, before=0.0, time=np.linspace(0.0, 0.1, 20_001))
    peak = 3.0 * ideal.back_emf**2 / (speed * ideal.pole_pairs * speed * ideal.inductance)
    assert -torque.min() == pytest.approx(peak, rel=1e-3)
    assert -torque[10_000:].min() == pytest.approx(peak, rel=1e-3)


@pytest.mark.parametrize("share", [0.2, 1.0, 5.0])
def test_what_is_left_takes_the_copper_losses_from_the_shaft(share):
    """−T Ω = 3/2 R |i|² of the settled current, greatest at ω L = R; 1e-9 is what has not decayed."""
    speed = share * WINDING.resistance / WINDING.inductance / WINDING.pole_pairs
    electric = WINDING.pole_pairs * speed
    current = electric * WINDING.linkage / math.hypot(WINDING.resistance, electric * WINDING.inductance)
    kept = short_circuit_torque(WINDING, speed, before=500.0, time=np.array([1.0]))[0]
    assert -kept * speed == pytest.approx(1.5 * WINDING.resistance * current**2, rel=1e-9)
    assert -kept <= 0.75 * WINDING.pole_pairs * WINDING.linkage**2 / WINDING.inductance * (1.0 + 1e-9)
