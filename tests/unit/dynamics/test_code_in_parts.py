"""Code of large structures is written in parts: it computes what the whole would, and compiles in proportion."""

import numpy as np
import pytest

from driven_train import driven_train
from gearwright.dynamics import simulate, simulate_many
from gearwright.dynamics.codegen import generate as written_in_parts, parameters, topology
from gearwright.dynamics.codegen.generate import SPLIT, assembly
from gearwright.dynamics.codegen.topology import Writer
from gearwright.dynamics.equations import reference
from gearwright.dynamics.motion import blank_record, stepper
from gearwright.dynamics.motion.simulate import LARGEST_COMPILED, LARGEST_GENERATED, WORTH_GENERATING
from random_systems import random_system


@pytest.mark.parametrize("seed", range(3))
def test_large_structures_move_as_the_generic_code_moves_them(seed):
    """Lines of any kind, frames, schedules, ramps: a hundred steps agree to rounding, which grows with the motion."""
    arrays = random_system(seed, bodies=30, lines=SPLIT + 20).arrays
    ends, records = [], []
    for method in ("runge-kutta", "runge-kutta generic"):
        state, record = np.zeros(2 * len(arrays.mass) + 6), blank_record(arrays, 100)
        stepper(arrays, method, 1e-5)(0, record, state)
        ends.append(state)
        records.append(record[:, : 2 * (len(arrays.mass) + len(arrays.stiffness))])
    np.testing.assert_allclose(ends[0], ends[1], rtol=1e-10, atol=1e-12 * np.max(np.abs(ends[1])))
    np.testing.assert_allclose(records[0], records[1], rtol=1e-9, atol=1e-11 * np.max(np.abs(records[1])))


def test_the_first_row_is_that_of_plain_numpy():
    arrays = random_system(7, bodies=30, lines=SPLIT + 20).arrays
    size, lines = len(arrays.mass), len(arrays.stiffness)
    state = np.random.default_rng(0).normal(0.0, 0.1, 2 * size + 6)
    wanted = reference.line_state(arrays, 0.0, state[:size], state[size : 2 * size])
    record = blank_record(arrays, 1)
    stepper(arrays, "runge-kutta", 1e-5)(0, record, state)
    scale = 1e-12 * np.max(np.abs(wanted.force))
    np.testing.assert_allclose(record[0, 2 * size : 2 * size + lines], wanted.force, rtol=1e-12, atol=scale)


def test_lanes_of_large_structures_are_their_single_runs():
    system = steady(random_system(3, bodies=30, lines=SPLIT + 20))
    many = simulate_many([system] * 2, 0.002, step=1e-5)
    alone = simulate(system, 0.002, step=1e-5, method="runge-kutta")
    np.testing.assert_allclose(many.rms[1], alone.force.rms[0], rtol=1e-9, atol=1e-9 * np.max(many.rms))
    single = simulate_many([system] * 2, 0.002, step=1e-5, precision="single")
    np.testing.assert_allclose(single.rms[1], many.rms[1], rtol=1e-4, atol=1e-5 * np.max(many.rms))


def steady(system):
    """Return a system at constant speed without schedules, as ensembles want it."""
    arrays = system.arrays
    still = type(arrays.profile)(np.zeros(1), np.ones(1), np.zeros(1))
    none = type(arrays.loads.schedules)(np.zeros(0, dtype=np.int64), np.zeros(1, dtype=np.int64), *np.zeros((2, 0)))
    backlash = np.where(np.isinf(arrays.backlash), 0.0, arrays.backlash)
    loads = arrays.loads._replace(schedules=none)
    changed = arrays._replace(profile=still, loads=loads, backlash=backlash)
    return type(system)(changed, system.labels)


def test_drives_work_in_parts_too(monkeypatch):
    system = driven_train()
    whole = written_as(system, monkeypatch, 10**6)
    parts = written_as(system, monkeypatch, 0)
    np.testing.assert_allclose(parts, whole, rtol=1e-9, atol=1e-9 * np.max(np.abs(whole)))


def written_as(system, monkeypatch, split):
    """Return the end of a run whose code is in parts above so many lines."""
    from gearwright.dynamics.codegen import generate as march, generate as native

    monkeypatch.setattr(march, "SPLIT", split)
    monkeypatch.setattr(written_in_parts, "SPLIT", split)
    native.compiled.cache_clear()
    arrays = system.arrays
    state = np.concatenate([np.zeros(2 * len(arrays.mass) + 6), arrays.drives.start])
    record = blank_record(arrays, 200)
    stepper(arrays, "runge-kutta", 1e-5)(0, record, state)
    native.compiled.cache_clear()
    return state


def test_the_code_grows_with_the_lines():
    """Twice the lines, twice the text, within what names and clocks add."""
    lengths = []
    for lines in (SPLIT + 40, 2 * SPLIT + 80):
        arrays = random_system(1, bodies=lines // 3, lines=lines).arrays
        writer = Writer(topology(arrays), parameters(arrays, 1e-5)[0], 1, frozenset())
        lengths.append(len(assembly(writer)))
    assert lengths[1] < 2.3 * lengths[0]


def test_short_runs_of_large_trains_take_generic_code_and_say_so():
    system = steady(random_system(2, bodies=30, lines=LARGEST_GENERATED + 10))
    trace = simulate(system, 0.001, step=1e-5)
    assert trace.method == "runge-kutta generic"
    assert f"{LARGEST_GENERATED + 10} lines and fewer than {WORTH_GENERATING} steps" in trace.notes[0]
    assert LARGEST_COMPILED > LARGEST_GENERATED
