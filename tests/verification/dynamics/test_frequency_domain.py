"""Time domain against frequency domain, and orders against modes."""

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Outputs, Periodic, campbell, frequency_response, modes, simulate
from gearwright.errors import DesignError


def geared_rotors(amplitude: float = 2e-6):
    """Return motor, gear pair and brake; a transmission error at tooth frequency, 30 teeth at 100 rad/s."""
    model = Model()
    model.rotation("motor", inertia=0.02, speed=100.0)
    for name, inertia in {"pinion": 1e-3, "wheel": 4e-3, "brake": 0.05}.items():
        model.rotation(name, inertia=inertia)
    model.shaft("input", "motor", "pinion", stiffness=2e4, damping=DampingRatio(0.03))
    error = Periodic({"pinion": 30}, (amplitude,))
    weights = {"pinion": 0.05, "wheel": 0.1}
    model.mesh("mesh", weights, stiffness=2e7, damping=DampingRatio(0.05), errors=[error])
    model.shaft("output", "wheel", "brake", stiffness=5e4, damping=DampingRatio(0.03))
    model.load("motor", constant=40.0)
    model.load("brake", constant=80.0)
    return model.build()


def test_time_integration_settles_to_the_frequency_response():
    """Amplitude of the mesh force at tooth frequency, by projection over whole cycles; the transient has decayed."""
    system = geared_rotors()
    frequency = 30 * 100.0 / (2 * np.pi)
    wanted = frequency_response(system, [frequency], errors={"mesh": 2e-6}).force("mesh")[0]
    step = 1.0 / (40 * frequency)
    trace = simulate(
        system, 1200 / frequency, step=step, outputs=Outputs(windows=((1100 / frequency, 1200 / frequency),))
    )
    window = trace.windows[0]
    turn = np.exp(-2j * np.pi * frequency * window.time[:-1])
    found = 2.0 * np.mean(window.force("mesh")[:-1] * turn)
    assert found == pytest.approx(wanted, rel=1e-6)


def test_the_response_to_a_slow_load_is_the_static_one():
    """At 1e-3 of the first natural frequency inertia adds 1e-6."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.support("spring", "rotor", stiffness=1e4)
    response = frequency_response(model.build(), [100.0 / (2 * np.pi) * 1e-3], loads={"rotor": 3.0})
    assert response.motion("rotor") == pytest.approx([3e-4], rel=2e-6)


def test_names_and_frequencies_of_a_response_are_checked():
    with pytest.raises(DesignError, match="did you mean mesh"):
        frequency_response(geared_rotors(), [1.0], errors={"mess": 1.0})
    with pytest.raises(DesignError, match="positive"):
        frequency_response(geared_rotors(), [0.0])


def test_campbell_crossings_are_where_tooth_frequency_meets_a_mode():
    """Without gyroscopic terms the speed is frequency over tooth order; damping moves frequencies by ζ²/2 only."""
    system = geared_rotors()
    diagram = campbell(system, np.linspace(0.05, 8.0, 30))
    undamped = modes(system).frequency[1:]
    tooth = 30 * 100.0 / (2 * np.pi)
    found = sorted(c.factor for c in diagram.crossings if c.order.frequency == pytest.approx(tooth))
    wanted = [f / tooth for f in undamped if f / tooth < 8.0]
    assert len(wanted) >= 2
    assert found == pytest.approx(wanted, rel=1e-2)


def test_margins_name_the_nearest_order_of_each_mode():
    system = geared_rotors()
    diagram = campbell(system, [0.5, 1.0, 1.5])
    distance, order, mode = diagram.margins(1.0)[0]
    assert order.frequency / diagram.frequency[1, mode] - 1.0 == pytest.approx(distance)
    assert len(diagram.margins(1.0)) == diagram.frequency.shape[1]


def test_modes_are_followed_by_shape_where_frequencies_cross():
    """A steady rotor and a whirl that the frame splits: the curves cross, the columns do not swap."""
    model = Model()
    model.rotation("clock", inertia=1.0, speed=100.0)
    model.rotation("steady", inertia=1.0, speed=0.0)
    model.support("steady spring", "steady", stiffness=150.0**2)
    for name in ("x", "y"):
        model.translation(name, mass=1.0)
        model.support(f"{name} spring", name, stiffness=120.0**2)
    model.rotating_frame("x", "y", speed=100.0)
    diagram = campbell(model.build(), np.linspace(0.0, 1.0, 41))
    # In the frame the orbit of a fixed-axis oscillator is seen at ω ± Ω: 120 ± 100 rad/s; the steady one stays at 150.
    ends = np.sort(2 * np.pi * diagram.frequency[-1])
    assert ends == pytest.approx([20.0, 150.0, 220.0], rel=1e-6)
    swing = np.ptp(2 * np.pi * diagram.frequency, axis=0)
    assert np.sort(swing) == pytest.approx([0.0, 100.0, 100.0], abs=1e-6)
