"""Tones, waterfalls and speed maps."""

import numpy as np
import pytest

from gearwright.dynamics import (
    DampingRatio,
    Model,
    Outputs,
    Periodic,
    frequency_response,
    simulate,
    speed_map,
    tone_amplitudes,
    waterfall,
)
from gearwright.errors import DesignError


def shaken(profile=((0.0, 1.0),)):
    """Return a rotor on a spring (15.9 Hz, ζ = 5 %) whose foot follows 1 and 3 per turn of a shaft at 8 Hz."""
    model = Model(profile=profile)
    model.rotation("shaft", inertia=1.0, speed=2.0 * np.pi * 8.0)
    model.rotation("rotor", inertia=1.0, speed=0.0)
    errors = [Periodic({"shaft": 1}, (1e-3, 0.0, 2e-4))]
    model.mesh("spring", {"rotor": 1.0}, stiffness=1e4, damping=DampingRatio(0.05), errors=errors)
    return model.build()


def test_tone_amplitudes_are_those_of_the_frequency_response():
    """After the transient (e^(−5·6)) the force consists of the two tones."""
    system = shaken()
    trace = simulate(system, 8.0, step=1e-3, outputs=Outputs(windows=((6.0, 8.0),)))
    window = trace.windows[0]
    found = {str(tone): share for tone, share in tone_amplitudes(system, window, window.force("spring"))}
    for order, error in ((1, 1e-3), (3, 2e-4)):
        wanted = frequency_response(system, [8.0 * order], errors={"spring": error}).force("spring")[0]
        assert found[f"{order} shaft"] == pytest.approx(wanted, rel=1e-6)


def test_too_few_instants_cannot_tell_tones_apart():
    system = shaken()
    trace = simulate(system, 0.1, step=1e-3, outputs=Outputs(samples=4))
    with pytest.raises(DesignError, match="cannot tell 2 tones apart"):
        tone_amplitudes(system, trace.samples, trace.samples.force("spring"))


def test_the_waterfall_of_a_run_up_follows_the_speed():
    """The first order's ridge is at 8 Hz times the speed factor, within two spectral lines."""
    system = shaken(profile=((0.0, 1.0), (20.0, 6.0)))
    trace = simulate(system, 20.0, step=2e-3, outputs=Outputs(windows=((0.0, 20.0),)), start="rigid")
    window = trace.windows[0]
    fall = waterfall(window, window.deflection("spring"), stretches=30)
    line = fall.frequency[1]
    for row in (10, 20, 28):
        expected = 8.0 * (1.0 + 5.0 * fall.time[row] / 20.0)
        near = np.abs(fall.frequency - expected) < 6.0
        ridge = fall.frequency[near][np.argmax(fall.amplitude[row, near])]
        assert ridge == pytest.approx(expected, abs=2.0 * line)


def test_a_waterfall_needs_instants_enough():
    trace = simulate(shaken(), 0.1, step=1e-3)
    with pytest.raises(DesignError, match="too short"):
        waterfall(trace.samples, trace.samples.force("spring"), stretches=64)


def test_the_speed_map_peaks_where_an_order_meets_the_mode():
    """Swing of the force against speed, beside the frequency response of both orders together; 1 % of lines."""
    system = shaken()
    factors = [0.4, 0.66, 1.0, 1.5, 2.0, 2.6]
    chart = speed_map(system, factors, settle=3.0, duration=6.0)
    wanted = []
    for factor in factors:
        response = frequency_response(system, [8.0 * factor], errors={"spring": 1e-3}).force("spring")[0]
        third = frequency_response(system, [24.0 * factor], errors={"spring": 2e-4}).force("spring")[0]
        wanted.append(np.sqrt((abs(response) ** 2 + abs(third) ** 2) / 2.0))
    assert chart.swing("spring") == pytest.approx(wanted, rel=1e-2)
    assert factors[int(np.argmax(chart.swing("spring")))] == 2.0


def test_a_speed_that_is_not_positive_is_refused():
    with pytest.raises(DesignError, match="positive"):
        speed_map(shaken(), [1.0, 0.0], settle=0.1, duration=0.2)
