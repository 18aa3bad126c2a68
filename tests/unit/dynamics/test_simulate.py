"""Running a system: outputs, replay, refusals, interruption."""

import math
import tracemalloc
from dataclasses import replace

import numpy as np
import pytest

from gearwright.dynamics import (
    Accuracy,
    DampingRatio,
    Line,
    Model,
    Outputs,
    Periodic,
    replay,
    simulate,
    statics,
    tone_amplitudes,
)
from gearwright.dynamics.motion import CHECKPOINTS, default_step
from gearwright.dynamics.motion.record import BLOCK, Recorder
from gearwright.dynamics.motion.steps import whole_step
from gearwright.errors import DesignError, SolveError
from random_systems import random_system


def driven_pair(backlash: float = 0.0, constant: bool = False):
    """Return a pinion that drives a wheel against a brake, mesh frequency 3183 Hz, natural frequency 5.3 kHz."""
    model = Model()
    pinion = model.rotation("pinion", inertia=1e-4, speed=1000.0)
    wheel = model.rotation("wheel", inertia=1e-3)
    variation = None if constant else Periodic({pinion: 20}, cosine=(0.2,))
    model.mesh(
        "mesh",
        {pinion: 0.025, wheel: 0.05},
        stiffness=1e8,
        damping=DampingRatio(0.05),
        backlash=backlash,
        variation=variation,
        errors=[Periodic({wheel: 1}, cosine=(5e-6,))],
    )
    model.load(pinion, constant=50.0)
    model.load(wheel, constant=100.0)
    return model.build()


@pytest.mark.parametrize("constant", [True, False])
def test_a_window_is_replayed_bit_for_bit(constant):
    """The window begins and ends inside blocks; the replay starts from the checkpoint before it."""
    system = driven_pair(constant=constant)
    trace = simulate(system, 0.05, outputs=Outputs(windows=((0.0311, 0.0322),)))
    again, once = replay(system, trace, 0.0311, 0.0322), trace.windows[0]
    assert len(once.time) > 15
    assert np.array_equal(again.line_force, once.line_force)
    assert np.array_equal(again.velocity, once.velocity)


def test_a_replay_takes_no_row_from_before_it_begins():
    """Evenly spaced instants begin at zero; those before the checkpoint stand in no block."""
    system = driven_pair()
    trace = simulate(system, 0.05, outputs=Outputs(windows=((0.0311, 0.0322),)))
    first = BLOCK * (round(0.0311 / trace.step) // BLOCK)
    recorder = Recorder(system, Outputs(), step=trace.step, steps=round(0.05 / trace.step))
    recorder.record[:] = 1.0
    recorder.take(first, BLOCK)
    seen = recorder.samples()
    stride = recorder.frame.stretches[0].step
    assert len(seen.time) == len(range(-(-first // stride) * stride, first + BLOCK, stride))
    assert np.all(seen.line_force == 1.0)


def test_statistics_of_bins_are_those_of_every_step():
    """Extremes of forces reach between the steps, by less than a step can hide: a half of the second difference."""
    system = driven_pair()
    trace = simulate(system, 0.02, outputs=Outputs(bins=3, start=0.005, windows=((0.0, 0.02),)))
    force = trace.windows[0].force("mesh")
    for number in range(3):
        low, high = (round(edge / trace.step) for edge in trace.force.edges[number : number + 2])
        part = force[low:high]
        values = trace.force.of("mesh")
        assert values["mean"][number] == pytest.approx(np.mean(part), rel=1e-12)
        between = 0.5 * np.max(np.abs(np.diff(part, 2)))
        assert np.min(part) - between <= values["minimum"][number] <= np.min(part)
        assert np.max(part) <= values["maximum"][number] <= np.max(part) + between
        assert trace.deflection.of("mesh")["maximum"][number] == np.max(trace.windows[0].deflection("mesh")[low:high])
        assert values["rms"][number] == pytest.approx(np.sqrt(np.mean(part**2)), rel=1e-12)


def test_samples_are_bounded_and_cover_the_run():
    trace = simulate(driven_pair(), 0.02, outputs=Outputs(samples=50))
    assert 25 <= len(trace.samples.time) <= 50
    assert trace.samples.time[-1] > 0.95 * 0.02


@pytest.mark.parametrize("step", [4e-5, 2e-5, 5e-6])
def test_the_measured_error_covers_the_true_one(step):
    """Against a run at a thirty-second of the step; a step that was given is kept, and marked if it is too large."""
    system = driven_pair()
    coarse, fine = (simulate(system, 0.004, step=size, start="rigid") for size in (step, step / 32.0))
    found, wanted = (trace.force.whole("mesh") for trace in (coarse, fine))
    assert abs(found.maximum / wanted.maximum - 1.0) <= coarse.error
    assert abs(found.rms / wanted.rms - 1.0) <= coarse.rms_error
    assert coarse.step == step
    late = coarse.error > 0.01 or coarse.rms_error > 0.001
    assert any("the step was given" in note for note in coarse.notes) is late


def test_a_run_looks_between_its_steps_without_having_been_asked():
    """By default peaks are right to 1 %, root mean squares to 0.1 %, and the run says how right they are."""
    trace = simulate(driven_pair(), 0.01, start="rigid")
    assert 0.0 < trace.error <= 0.01
    assert 0.0 < trace.rms_error <= 0.001


@pytest.mark.parametrize("asked", [1e-3, 1e-4])
def test_an_accuracy_chooses_the_step(asked):
    """The measured error comes out below what was asked, and not needlessly small: 4 halvings of the step at most.

    The run ends beside a crest, which was once told by its second difference, and its peak came from finer steps.
    """
    trace = simulate(driven_pair(), 0.01, step=Accuracy(asked), start="rigid")
    assert 1e-3 * asked < trace.error <= asked


def test_crests_between_steps_ask_for_no_finer_ones():
    """Three harmonics of the stiffness beyond the mode show in the force alone: the first step does.

    While a crest could stand anywhere between two instants, the run was repeated at half the step.
    """
    model = Model()
    pinion, wheel = model.rotation("pinion", inertia=1e-4, speed=1000.0), model.rotation("wheel", inertia=1e-3)
    waves = Periodic({pinion: 60}, cosine=(0.1, 0.1, 0.1))
    radii = {pinion: 0.025, wheel: 0.05}
    model.mesh("mesh", radii, stiffness=1e8, damping=DampingRatio(0.05), variation=waves)
    model.load(pinion, constant=50.0)
    model.load(wheel, constant=100.0)
    system = model.build()
    trace, fine = simulate(system, 0.05), simulate(system, 0.05, step=1e-7)
    assert trace.step == whole_step(0.05, default_step(system.arrays))
    assert trace.force.maximum[0, 0] == pytest.approx(fine.force.maximum[0, 0], rel=trace.error)
    assert np.max(trace.samples.force("mesh")) < (1.0 - trace.error) * fine.force.maximum[0, 0]


def test_an_accuracy_that_instants_cannot_show_is_marked():
    trace = simulate(driven_pair(), 0.01, step=Accuracy(1e-9), start="rigid")
    assert any("asked were 1.0e-09" in note for note in trace.notes)


def test_an_accuracy_that_cannot_be_is_refused():
    with pytest.raises(DesignError, match=r"accuracy 0\.0"):
        simulate(driven_pair(), 0.01, step=Accuracy(0.0), start="rigid")


def test_contact_loss_is_noted_with_line_and_time():
    """The variation of 20 % near resonance lifts the teeth."""
    trace = simulate(driven_pair(backlash=50e-6), 0.01, start="rigid")
    assert any(note.startswith("line mesh first lost contact at") for note in trace.notes)


def test_auto_says_what_it_picked():
    exact, varying = simulate(driven_pair(constant=True), 0.001), simulate(driven_pair(), 0.001)
    assert (exact.method, varying.method) == ("exact", "runge-kutta")
    assert "constant stiffness" in exact.notes[0]


def test_loads_that_do_not_balance_are_noted():
    """100 N m on the wheel stand against 2 × 50 N m on the pinion; 90 N m do not."""
    system = driven_pair()
    constant = system.arrays.loads.constant * np.array([1.0, 0.9])
    loads = system.arrays.loads._replace(constant=constant)
    unequal = replace(system, arrays=system.arrays._replace(loads=loads))
    assert any("do not balance: they leave" in note for note in simulate(unequal, 0.001).notes)
    assert not any("balance" in note for note in simulate(system, 0.001).notes)


def test_an_unknown_output_names_the_nearest():
    trace = simulate(driven_pair(), 0.001)
    with pytest.raises(DesignError, match="no such line; did you mean mesh"):
        trace.samples.force("mehs")
    with pytest.raises(DesignError, match="no such coordinate; did you mean wheel"):
        trace.velocity.of("whel")


def test_a_step_that_is_too_large_is_refused_with_the_one_that_would_do():
    with pytest.raises(DesignError, match="would do") as caught:
        simulate(driven_pair(), 0.01, step=1e-4)
    would_do = float(str(caught.value).split("a step of ")[1].split(" s")[0])
    assert simulate(driven_pair(), 0.01, step=would_do).error < 0.1


@pytest.mark.parametrize("duration", [0.0, -1.0, math.nan, math.inf, 1e9])
def test_a_duration_that_cannot_be_is_refused(duration):
    with pytest.raises(DesignError, match="duration"):
        simulate(driven_pair(), duration)


def test_a_method_that_cannot_be_is_refused():
    with pytest.raises(DesignError, match="did you mean exact"):
        simulate(driven_pair(), 0.01, method="exakt")
    with pytest.raises(DesignError, match="exact needs constant stiffness"):
        simulate(driven_pair(), 0.01, method="exact")


def test_windows_outside_the_run_are_refused():
    with pytest.raises(DesignError, match=r"outputs\.windows"):
        simulate(driven_pair(), 0.01, outputs=Outputs(windows=((0.005, 0.02),)))


def test_divergence_is_named_with_time_line_and_value():
    """Load that grows with speed is negative damping: the motion grows without bound."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.support("anchor", "rotor", stiffness=1e4)
    model.load("rotor", constant=1.0, damping=-60.0)
    with pytest.raises(SolveError, match=r"diverged at .* s: line anchor carries"):
        simulate(model.build(), 5.0, start="rigid", method="runge-kutta")


def test_memory_does_not_grow_with_the_duration():
    """Samples, bins and checkpoints have their numbers (663 and 884 of 1000): half more for eight times the time."""
    system = driven_pair()
    step = simulate(system, 0.05).step  # one step for all, so that they share the clock tables that are kept
    peaks = []
    tracemalloc.start()
    for duration in (5.0, 40.0):
        tracemalloc.reset_peak()
        simulate(system, duration, step=step)
        peaks.append(tracemalloc.get_traced_memory()[1])
    tracemalloc.stop()
    assert peaks[1] < 1.5 * peaks[0]


def test_an_interruption_keeps_what_was_done():
    calls = []

    def stop(fraction: float) -> None:
        calls.append(fraction)
        if fraction > 0.4:
            raise KeyboardInterrupt

    trace = simulate(driven_pair(), 0.5, outputs=Outputs(bins=10), progress=stop)
    assert 0.4 * 0.5 < trace.duration < 0.5 * 0.5
    assert trace.duration == pytest.approx(calls[-1] * 0.5, rel=1e-2)
    assert trace.notes[-1].startswith("interrupted at")
    assert trace.force.edges[-1] == pytest.approx(trace.duration)
    assert np.all(np.isfinite(trace.force.mean))
    assert trace.work.imbalance < 1e-4


@pytest.mark.parametrize("seed", range(8))
def test_every_run_says_where_its_energy_went(seed):
    """Random loops with errors, frames and a speed ramp: within 1e-6; with contact that opens and closes, 1e-3.

    Each contact that changes inside a step leaves an error of second order in the step.
    """
    system = random_system(seed)
    assert simulate(system, 0.38, start="rigid", step=2e-4).work.imbalance < 1e-3
    linear = replace(system, arrays=system.arrays._replace(backlash=np.zeros_like(system.arrays.backlash)))
    assert simulate(linear, 0.38, start="rigid", step=2e-4).work.imbalance < 1e-6


@pytest.mark.parametrize("bins", [1, 3])
def test_order_amplitudes_are_those_of_every_step(bins):
    """Summed up block by block they are the least squares of the whole record: to rounding of the normal equations."""
    system = driven_pair()
    asked = Outputs(bins=bins, windows=((0.0, 0.05),), orders=("mesh",))
    trace = simulate(system, 0.05, outputs=asked, start="rigid")
    every = trace.windows[0]
    force = every.force("mesh")
    for number in range(bins):
        part = slice(*(round(edge / trace.step) for edge in trace.orders.edges[number : number + 2]))
        wanted = dict(tone_amplitudes(system, replace(every, time=every.time[part]), force[part]))
        found = dict(zip(trace.orders.tones, trace.orders.of("mesh")[number], strict=True))
        assert set(found) == set(wanted)
        for tone, amplitude in wanted.items():
            assert found[tone] == pytest.approx(amplitude, abs=1e-8 * np.max(np.abs(force)))


def test_a_known_wave_has_its_own_amplitude():
    """A rotor is shaken by E cos φ through a spring and a damper: its closed form, with f = ω² q for a mass of one."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.rotation("clock", inertia=1.0, speed=10.0)
    model.add(Line("spring", {"rotor": 1.0}, 1e4, damping=40.0, errors=(Periodic({"clock": 1}, (1e-3,)),)))
    trace = simulate(model.build(), 10.0, outputs=Outputs(start=5.0, orders=("spring",)), start="rigid")
    k, c, w = 1e4, 40.0, 10.0
    response = (k + 1j * w * c) / (k - w * w + 1j * w * c)
    wanted = w * w * response * 1e-3
    # After 5 s the start has decayed by e^-100; a line's force is −m q̈ where nothing else acts.
    assert trace.orders.of("spring")[0, 0] == pytest.approx(wanted, rel=1e-9)


def test_an_order_of_an_unknown_line_names_the_nearest_before_anything_runs():
    with pytest.raises(DesignError, match=r"outputs\.mehs: no such line; did you mean mesh"):
        simulate(driven_pair(), 10.0, outputs=Outputs(orders=("mehs",)))


def kept(trace) -> int:
    """Return how many numbers a trace holds."""
    parts = [trace.samples, trace.force, trace.deflection, trace.velocity, trace.checkpoints, trace.orders]
    return sum(np.size(value) for part in parts for value in vars(part).values() if isinstance(value, np.ndarray))


def test_what_is_kept_does_not_grow_with_the_duration():
    """Samples thin out and checkpoints spread: eighty times the time keeps no more than the limits of both allow."""
    asked = Outputs(samples=200, bins=4, orders=("mesh",))
    short, long = (simulate(driven_pair(), duration, outputs=asked) for duration in (0.25, 20.0))
    states, row = 2 * 2 + 6, 2 * 2 + 2 * 1 + 1
    fixed = kept(short) - np.size(short.samples.time) * row - np.size(short.checkpoints.step) * (states + 1)
    assert np.size(short.checkpoints.step) < 100
    assert kept(long) <= fixed + 200 * row + (CHECKPOINTS + 1) * (states + 1)
    assert np.size(long.samples.time) <= 200


@pytest.mark.parametrize("method", ["statics", "simulate"])
def test_a_body_that_nothing_holds_is_named_with_its_motion(method):
    """An idler that no line touches, under a load: statics refuses it, a run says that it speeds up."""
    model = Model()
    model.rotation("rotor", inertia=1.0)
    model.rotation("idler", inertia=1.0)
    model.support("anchor", "rotor", stiffness=1e4, damping=1.0)
    model.load("idler", constant=3.0)
    system = model.build()
    if method == "statics":
        with pytest.raises(SolveError, match=r"nothing holds the motion \(idler 1\)"):
            statics(system)
    else:
        assert any("idler 1" in note and "speeds up" in note for note in simulate(system, 0.01).notes)


def test_a_billion_seconds_are_refused_with_the_longest_run_at_that_step():
    with pytest.raises(DesignError, match=r"duration: 1e\+09 s takes .* steps; at most .* s at this step"):
        simulate(driven_pair(), 1e9)


@pytest.mark.parametrize("step", [0.0, -1e-6, math.nan, math.inf])
@pytest.mark.parametrize("method", ["runge-kutta", "tsit5"])
def test_a_step_that_is_no_length_of_time_is_refused(step, method):
    with pytest.raises(DesignError, match="step"):
        simulate(driven_pair(), 0.01, step=step, method=method)
