"""Many systems side by side give what each gives alone."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Outputs, Periodic, simulate, simulate_many
from gearwright.dynamics.codegen import topology
from gearwright.dynamics.equations import unbalanced
from gearwright.dynamics.motion import STABLE, fastest_rate
from gearwright.dynamics.motion.ensemble import Clock
from gearwright.errors import DesignError, SolveError
from random_systems import random_system


def family(count: int):
    """Return systems of one structure with other stiffness, speed and errors, at constant speed."""
    base = random_system(11)
    arrays = base.arrays
    loads = arrays.loads._replace(schedules=arrays.loads.schedules._replace(dof=arrays.loads.schedules.dof[:0]))
    profile = arrays.profile._replace(factor=np.full_like(arrays.profile.factor, 1.1))
    members = []
    for number in range(count):
        scale = 1.0 + 0.05 * number
        changed = arrays._replace(
            stiffness=arrays.stiffness * scale,
            tone_rate=arrays.tone_rate / scale,
            error=arrays.error._replace(cosine=arrays.error.cosine * scale),
            loads=loads,
            profile=profile._replace(travel=1.1 * profile.time),
        )
        members.append(replace(base, arrays=changed))
    return members


def rest(systems):
    return np.zeros((len(systems), 2 * len(systems[0].arrays.mass)))


def test_each_trajectory_of_an_ensemble_is_the_run_of_its_system_alone():
    """Eleven systems fill one vector and part of another; the order of sums differs, so 1e-9 after 5000 steps.

    Extremes are those at the instants: only a run alone looks between them.
    """
    systems = family(11)
    many = simulate_many(systems, 0.5, step=1e-4, settle=0.1, start=rest(systems))
    for number in (0, 7, 8, 10):
        system, last = systems[number], Outputs(start=0.1, windows=((0.1, 0.5 - 1e-4),))
        alone = simulate(system, 0.5, step=1e-4, start="rigid", outputs=last, method="runge-kutta")
        scale = np.max(np.abs(alone.force.maximum))
        seen = alone.windows[0].line_force
        wanted = {
            "mean": alone.force.mean[0],
            "rms": alone.force.rms[0],
            "minimum": seen.min(0),
            "maximum": seen.max(0),
        }
        for key, values in wanted.items():
            np.testing.assert_allclose(getattr(many, key)[number], values, rtol=1e-9, atol=1e-9 * scale)


def different(count: int):
    """Return systems of one structure that differ in every number that has a meaning."""
    rng, members = np.random.default_rng(3), []
    for system in family(count):
        arrays = system.arrays

        def other(values, rng=rng):
            return values * rng.uniform(0.9, 1.1, len(values))

        series = {
            name: getattr(arrays, name)._replace(
                cosine=other(getattr(arrays, name).cosine), sine=other(getattr(arrays, name).sine)
            )
            for name in ("variation", "error")
        }
        loads = arrays.loads._replace(
            constant=other(arrays.loads.constant), damping=other(arrays.loads.damping),
            quadratic=other(arrays.loads.quadratic),
        )  # fmt: skip
        scale = float(rng.uniform(0.9, 1.1))
        plain = {name: other(getattr(arrays, name)) for name in ("mass", "stiffness", "damping", "backlash")}
        turned = {name: scale * getattr(arrays, name) for name in ("speed", "tone_rate", "slip")}
        framed = {
            name: getattr(arrays, name)._replace(value=power * getattr(arrays, name).value)
            for name, power in (("gyroscopic", scale), ("centripetal", scale**2))
        }
        weight = arrays.line_weight * float(rng.uniform(0.9, 1.1))
        members.append(
            replace(
                system, arrays=arrays._replace(line_weight=weight, loads=loads, **series, **plain, **turned, **framed)
            )
        )
    return members


def test_members_that_differ_in_every_number_are_the_runs_of_their_systems_alone():
    systems = different(5)
    many = simulate_many(systems, 0.2, step=5e-5, start=rest(systems))
    for number in (0, 3, 4):
        alone = simulate(systems[number], 0.2, step=5e-5, start="rigid", method="runge-kutta")
        scale = np.max(np.abs(alone.force.rms))
        np.testing.assert_allclose(many.rms[number], alone.force.rms[0], rtol=1e-8, atol=1e-8 * scale)


def test_results_do_not_depend_on_the_number_of_threads():
    systems = family(20)
    one, four = (simulate_many(systems, 0.05, step=1e-4, start=rest(systems), threads=threads) for threads in (1, 4))
    assert np.array_equal(one.rms, four.rms)
    assert np.array_equal(one.state, four.state)


def test_a_system_of_another_structure_is_named():
    with pytest.raises(DesignError, match=r"systems\.2: its structure differs"):
        simulate_many([*family(2), random_system(12)], 0.1)


def test_progress_counts_to_one():
    calls = []
    systems = family(20)
    simulate_many(systems, 0.01, step=1e-4, start=rest(systems), progress=calls.append)
    assert calls[-1] == 1.0
    assert len(calls) == 3


def test_a_trajectory_that_diverges_is_named():
    systems = family(3)
    arrays = systems[1].arrays
    # Negative damping drives the motion; next to no drag limits it.
    drag = 1e-12 * arrays.loads.quadratic
    wild = arrays.loads._replace(damping=np.full_like(arrays.loads.damping, -400.0), quadratic=drag)
    systems[1] = replace(systems[1], arrays=arrays._replace(loads=wild))
    with pytest.raises(SolveError, match="trajectory 1 diverged on line"):
        simulate_many(systems, 2.0, step=1e-4, start=rest(systems))


@pytest.mark.parametrize("number", ["stiffness", "mass"])
def test_a_step_that_is_too_large_for_one_of_many_is_refused(number):
    """One member a hundred times stiffer or lighter: its fastest mode is ten times as fast."""
    systems = family(3)
    arrays = systems[2].arrays
    scale = 100.0 if number == "stiffness" else 0.01
    systems[2] = replace(systems[2], arrays=arrays._replace(**{number: getattr(arrays, number) * scale}))
    step = 0.5 * STABLE / fastest_rate(systems[0].arrays)
    simulate_many(systems[:2], 10 * step, step=step, start=rest(systems[:2]))
    with pytest.raises(DesignError, match="would do"):
        simulate_many(systems, 10 * step, step=step, start=rest(systems))


def test_what_the_loads_of_one_member_leave_over_is_told_of_that_one():
    """Members alike in all that decides it are asked once; one with another load, and one heavier, are not alike."""
    systems = family(5)
    arrays = systems[3].arrays
    turned = arrays.loads._replace(constant=arrays.loads.constant + 1.0)
    systems[3] = replace(systems[3], arrays=arrays._replace(loads=turned))
    told = [[], [], [], [], []]
    for number, system in enumerate(systems):
        left = unbalanced(system)
        told[number] = [f"trajectory {number}: at the start {left}; the train speeds up or slows down"] if left else []
    notes = simulate_many(systems, 0.01, step=1e-4, start=rest(systems)).notes
    assert [note for note in notes if "at the start" in note] == [note for one in told for note in one]
    assert told[3] != told[2]


@pytest.mark.parametrize("members", [family, different])
def test_single_precision_gives_what_double_does_and_tells_the_difference(members):
    """Twenty systems fill a vector of sixteen and part of another. Rounding is 6e-8 of each of some thousand sums."""
    systems = members(20)
    double, single = (
        simulate_many(systems, 0.2, step=5e-5, start=rest(systems), precision=precision)
        for precision in ("double", "single")
    )
    scale = np.max(np.abs([double.minimum, double.maximum]), axis=0)
    for key in ("mean", "minimum", "maximum", "rms"):
        apart = np.abs(getattr(single, key) - getattr(double, key)) / scale
        assert 0.0 < np.max(apart) < 3e-4, key
    assert double.rounding == (0.0, 0.0)
    assert 1e-9 < single.rounding.peak < 3e-4
    peak = np.abs(scale - np.maximum(np.abs(single.minimum), np.abs(single.maximum))) / scale
    assert single.rounding.peak >= 0.999 * np.max(peak[[0, 3, 5, 8, 11, 14, 16, 19]][:, np.max(scale, axis=0) > 1.0])
    assert np.all(single.error >= single.rounding.peak)


def test_phases_keep_double_precision_however_long_a_run_is():
    """After 1e7 steps a phase in single precision would be off by a twentieth of a turn."""
    system = family(1)[0]
    shape = topology(system.arrays)
    clock = Clock([system.arrays], shape, 1e-4, 16)
    first = 10_000_001
    angle = system.arrays.tone_rate * 1.1 * 1e-4 * first
    turns = clock.turns(first, 3)
    assert turns.dtype == np.float32
    np.testing.assert_allclose(turns[0, : len(angle)], np.cos(angle), atol=1e-7)
    np.testing.assert_allclose(turns[0, clock.waves :][: len(angle)], np.sin(angle), atol=1e-7)


def test_motions_far_from_where_they_began_are_refused_in_single_precision():
    """A body that turned by 10 000 rad is known to a thousandth of one: teeth deflect by less."""
    model = Model()
    for name, speed in (("one", 100.0), ("other", None)):
        model.rotation(name, inertia=1e-3, speed=speed)
        model.load(name, constant=100.0)
    wave = Periodic({"one": 20}, (0.2,))
    model.mesh("mesh", {"one": 0.05, "other": 0.05}, stiffness=1e8, damping=DampingRatio(0.05), variation=wave)
    system = model.build()
    near, far = np.zeros((2, 1, 4))
    far[0, :2] = 1e4, -1e4
    assert simulate_many([system], 0.02, step=1e-6, start=near, precision="single").rounding.peak < 1e-3
    with pytest.raises(SolveError, match=r"single precision moves .* on line mesh of trajectory 0.*precision=.double"):
        simulate_many([system], 0.02, step=1e-6, start=far, precision="single")


def test_numbers_beyond_single_precision_are_refused():
    systems = family(2)
    arrays = systems[1].arrays
    systems[1] = replace(systems[1], arrays=arrays._replace(mass=arrays.mass * 1e42))
    with pytest.raises(DesignError, match=r"systems\.1: mobility .* has no place in single precision"):
        simulate_many(systems, 0.01, step=1e-4, start=rest(systems), precision="single")


def test_an_unknown_precision_is_refused():
    with pytest.raises(DesignError, match="double, single"):
        simulate_many(family(1), 0.01, precision="half")
