"""Rattle: motions that part from their neighbours are named, others are not."""

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Outputs, Periodic, simulate


def rattling(ratio: float):
    """Return a lightly loaded mesh with backlash (ω = 10 000 rad/s, ζ = 2 %), stiffness ± 30 % at `ratio` ω."""
    model = Model()
    model.rotation("clock", inertia=1.0, speed=1e4 * ratio)
    model.rotation("rotor", inertia=1e-4, speed=0.0)
    wave, error = Periodic({"clock": 1}, (0.3,)), Periodic({"clock": 1}, (6e-5,))
    damping = DampingRatio(0.02)
    model.mesh("mesh", {"rotor": 0.05}, stiffness=4e6, damping=damping, backlash=1e-4, variation=wave, errors=[error])
    model.load("rotor", constant=3.0)
    return model.build()


@pytest.mark.parametrize(("ratio", "parts"), [(0.5, True), (1.3, False)])
def test_the_note_says_whether_a_start_a_billionth_away_ends_elsewhere(ratio, parts):
    """Two whole runs from starts 1e-9 apart: at 0.5 ω they end a tenth of the motion apart or more, at 1.3 ω not."""
    system, last = rattling(ratio), Outputs(windows=((0.45, 0.5),))
    runs = [
        simulate(system, 0.5, step=2e-5, start=(np.array([0.0, 1e-4 * (1.0 + shift)]), np.zeros(2)), outputs=last)
        for shift in (0.0, 1e-9)
    ]
    one, other = (run.windows[0].deflection("mesh") for run in runs)
    apart = np.max(np.abs(one - other)) / np.ptp(one)
    assert bool(apart > 0.1) is parts
    assert any("chaotic" in note for note in runs[0].notes) is parts
    assert any("first lost contact" in note for note in runs[0].notes)
