"""Generated code agrees with the plain right-hand side and with the generic kernel, on random structures."""

import numpy as np
from hypothesis import given, settings, strategies as st

from gearwright.dynamics.codegen import compiled, parameter_rows, parameters, topology
from gearwright.dynamics.equations import WORKS, reference
from gearwright.dynamics.model import check_structure, stacked
from gearwright.dynamics.motion import blank_record, stepper
from gearwright.errors import DesignError
from random_systems import random_system


def random_state(seed: int, size: int):
    rng = np.random.default_rng(seed)
    return np.concatenate([rng.normal(0.0, 0.1, size), rng.normal(0.0, 1.0, size), np.zeros(WORKS)])


@settings(max_examples=25)
@given(
    seed=st.integers(0, 2**32 - 1),
    bodies=st.integers(4, 20),
    lines=st.integers(1, 20),
    first=st.integers(0, 9000),
    coarse=st.booleans(),
)
def test_generated_code_agrees_with_plain_numpy(seed, bodies, lines, first, coarse):
    """Forces and deflections of a step, and the change of state over it, to 1e-12 of the largest term."""
    arrays, h = random_system(seed, bodies, lines, coarse=coarse).arrays, 1e-4
    size = len(arrays.mass)
    state = random_state(seed + 1, size)
    wanted = runge_kutta_step(arrays, first * h, h, state[: 2 * size])
    lines_then = reference.line_state(arrays, first * h, state[:size], state[size : 2 * size])
    record = blank_record(arrays, 1)
    stepper(arrays, "runge-kutta", h)(first, record, state)
    force, deflection = np.split(record[0, 2 * size : 2 * (size + lines)], 2)
    scale = 1e-12 * np.max(np.abs(lines_then.force))
    np.testing.assert_allclose(force, lines_then.force, rtol=1e-12, atol=scale)
    np.testing.assert_allclose(deflection, lines_then.deflection, rtol=1e-12, atol=1e-13)
    # The step changes speeds by h times forces over masses of at least 0.1.
    np.testing.assert_allclose(state[: 2 * size], wanted, rtol=1e-12, atol=max(1e-13, 10.0 * h * scale))


def runge_kutta_step(arrays, time, h, state):
    size = len(state) // 2

    def slope(t, y):
        return np.concatenate([y[size:], reference.acceleration(arrays, t, y[:size], y[size:])])

    # Times are counted in half steps, as the compiled codes do: at a kink of a load the last digit matters.
    first = round(time / h)
    early, middle, late = first * h, (first + 0.5) * h, (first + 1) * h
    k1 = slope(early, state)
    k2 = slope(middle, state + 0.5 * h * k1)
    k3 = slope(middle, state + 0.5 * h * k2)
    k4 = slope(late, state + h * k3)
    return state + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)


@settings(max_examples=15)
@given(seed=st.integers(0, 2**32 - 1))
def test_generated_and_generic_code_agree_over_a_run_with_works(seed):
    """600 steps across a block boundary; rounding grows with the motion, to less than 1e-9 of the largest state."""
    arrays = random_system(seed).arrays
    size = len(arrays.mass)
    ends = []
    for method in ("runge-kutta", "runge-kutta generic"):
        state = random_state(seed, size)
        advance, record = stepper(arrays, method, 1e-4), blank_record(arrays, 300)
        for first in (3700, 4000):
            advance(first, record, state)
        ends.append(state)
    np.testing.assert_allclose(ends[0], ends[1], rtol=1e-9, atol=1e-9 * np.max(np.abs(ends[1])))


@settings(max_examples=30)
@given(seed=st.integers(0, 40), other=st.integers(0, 40), lines=st.integers(1, 2), coarse=st.booleans())
def test_families_are_of_one_structure_where_topologies_are_equal(seed, other, lines, coarse):
    """Few lines, so that equal structures occur; numbers alone never matter."""
    arrays, second = (random_system(each, 4, lines, coarse=coarse).arrays for each in (seed, other))
    assert alike(arrays, second) is (topology(arrays) == topology(second))
    assert alike(arrays, arrays._replace(mass=2.0 * arrays.mass, tone_rate=3.0 * arrays.tone_rate))


def alike(*members):
    try:
        check_structure(stacked(members))
    except DesignError:
        return False
    return True


def test_the_numbers_of_a_family_are_those_of_its_members():
    """Bit for bit, whichever arrays they share."""
    arrays = random_system(7, coarse=True).arrays
    other = arrays._replace(stiffness=3.0 * arrays.stiffness, line_weight=-arrays.line_weight)
    layout, rows = parameter_rows(stacked([arrays, other]), 1e-4)
    for row, member in zip(rows, (arrays, other), strict=True):
        alone = parameters(member, 1e-4)
        assert alone[0] == layout
        assert np.array_equal(alone[1], row)


def test_systems_of_one_structure_share_one_code():
    """Numbers are parameters: another mass, stiffness or speed does not compile again."""
    arrays = random_system(5).arrays
    other = arrays._replace(mass=2.0 * arrays.mass, stiffness=3.0 * arrays.stiffness, tone_rate=0.5 * arrays.tone_rate)
    codes = [compiled(topology(each), parameters(each, 1e-5)[0]) for each in (arrays, other)]
    assert codes[0] is codes[1]
