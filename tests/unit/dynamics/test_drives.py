"""Propellers, machines and clutches inside a System: every way of computing them gives the same motion."""

import math

import numpy as np
import pytest

from designs import HYBRID
from driven_train import PITCH, SPEED, driven_state, driven_train, propeller
from gearwright.dynamics import Model, replay, simulate
from gearwright.dynamics.equations import WORKS, kernel, reference
from gearwright.dynamics.model import ClutchDrive, MachineDrive
from gearwright.dynamics.motion import simulate_many
from gearwright.errors import DesignError, SolveError
from gearwright.spec import parse
from gearwright.store import StoredRun, load, save

DURATION = 0.3


@pytest.mark.parametrize("one_way", [False, True])
@pytest.mark.parametrize("seed", range(4))
def test_compiled_laws_are_those_in_plain_python(seed, one_way):
    system = driven_train(one_way=one_way)
    arrays, (q, v, x) = system.arrays, driven_state(system, seed)
    size, lines = len(q), len(arrays.stiffness)
    state = np.concatenate([q, v, np.zeros(WORKS), x])
    slope, output = np.zeros_like(state), np.zeros(2 * lines + len(system.labels.drives))
    now = kernel.empty_instant(arrays)
    kernel.set_instant(arrays, 0.055, now)
    kernel.derivative(arrays, now, state, slope, output)
    expected = reference.acceleration(arrays, 0.055, q, v, x)
    acting = reference.driven(arrays, 0.055, v, x)
    assert slope[size : 2 * size] == pytest.approx(expected, rel=1e-12, abs=1e-12 * np.max(np.abs(expected)))
    assert slope[2 * size + WORKS :] == pytest.approx(acting.rate, rel=1e-12, abs=1e-15)
    assert output[2 * lines :] == pytest.approx(acting.output, rel=1e-12, abs=1e-15)


def test_generated_and_generic_code_agree():
    """Both take the same steps; what differs is rounding, which this stable train does not amplify."""
    system = driven_train()
    one, other = (simulate(system, DURATION, method=each) for each in ("runge-kutta", "runge-kutta generic"))
    assert one.samples.drives[-1] == pytest.approx(other.samples.drives[-1], rel=1e-8, abs=1e-9)
    assert one.samples.line_force[-1] == pytest.approx(other.samples.line_force[-1], rel=1e-7)


def test_adaptive_steps_find_the_same_motion():
    """Tolerance: both methods' own error estimates, about 1e-4 of the forces."""
    system = driven_train()
    fixed, *adaptive = (simulate(system, DURATION, method=each) for each in ("auto", "tsit5", "tsit5 generic"))
    for each in adaptive:
        assert each.samples.drive("propeller pitch")[-1] == pytest.approx(
            fixed.samples.drive("propeller pitch")[-1], rel=1e-4
        )


def test_energy_closes_with_drives():
    """Drives are loads: their work enters and leaves by the same book; tolerance: that of the steps."""
    assert simulate(driven_train(), DURATION).work.imbalance < 1e-5


def test_a_run_is_saved_loaded_and_replayed(tmp_path):
    system = driven_train()
    trace = simulate(system, DURATION)
    save(StoredRun(parse(HYBRID), "rated", trace), tmp_path / "run.nc")
    again = load(tmp_path / "run.nc").trace
    assert np.array_equal(again.samples.drives, trace.samples.drives)
    assert again.labels == trace.labels
    assert np.array_equal(again.drive.of("propeller torque")["mean"], trace.drive.of("propeller torque")["mean"])
    part = replay(system, again, trace.samples.time[2000], trace.samples.time[2001])
    assert np.array_equal(part.drives[0], trace.samples.drives[2000])


def test_a_propeller_that_leaves_its_map_is_refused_with_time_speed_and_pitch():
    model = Model()
    model.rotation("hub", inertia=10.0, speed=SPEED)
    model.rotation("propeller", inertia=100.0)
    model.shaft("shaft", "hub", "propeller", stiffness=1e6)
    model.drive(propeller(set_speed=SPEED + 40.0))
    with pytest.raises(SolveError, match=r"propeller leaves its map at .* rpm at a pitch of .*°"):
        simulate(model.build(), 5.0)


def test_a_machine_keeps_its_limits_and_its_slope():
    """T = u (1 + κ (1 − ω/ω_r)) with ω 1 % below ω_r, and the power limit: P/ω."""
    model = Model()
    model.rotation("a", inertia=1.0, speed=99.0)
    model.rotation("b", inertia=1.0)
    model.shaft("shaft", "a", "b", stiffness=1e4)
    model.drive(MachineDrive("free", "a", 50.0, 100.0, 2.0))
    model.drive(MachineDrive("held", "b", -80.0, 100.0, 0.0, 1e3, 99.0 * 60.0))
    acting = reference.driven(model.build().arrays, 0.0, np.zeros(2))
    assert acting.torque == pytest.approx([50.0 * 1.02, -60.0])
    assert list(acting.output) == pytest.approx([51.0, 99.0, 0.0, -60.0, 99.0, 1.0])


def test_every_problem_of_a_drive_is_told_at_once():
    model = Model()
    model.rotation("a", inertia=1.0, speed=1.0)
    model.rotation("b", inertia=1.0)
    model.shaft("shaft", "a", "b", stiffness=1.0)
    model.drive(propeller("c", diameter=0.0))
    model.drive(MachineDrive("m", "a", ((1.0, 2.0), (0.5, 1.0)), 0.0))
    model.drive(ClutchDrive("m", "a", "d", 1.0, 0.0, math.inf))
    with pytest.raises(DesignError) as caught:
        model.build()
    text = str(caught.value)
    for part in ("no such rotation: c", "diameter is 0", "times must rise", "speed is 0", "no such rotation: d"):
        assert part in text
    assert "damping is 0" in text
    assert "the name is used 2 times" in text


def test_what_cannot_carry_drives_says_so():
    system = driven_train()
    with pytest.raises(DesignError, match="implicit steps do not carry"):
        simulate(system, 0.1, method="implicit")
    with pytest.raises(DesignError, match="exact needs"):
        simulate(system, 0.1, method="exact")
    with pytest.raises(DesignError, match="ensembles run at constant speed"):
        simulate_many([system], 0.1)


def test_start_states_are_those_that_were_given():
    assert driven_train().arrays.drives.start == pytest.approx([PITCH, 0.0, 0.0, 0.0])
