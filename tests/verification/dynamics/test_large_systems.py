"""Large systems: what spanning trees, sparse factors and bounds say is what dense matrices say."""

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Periodic, modes, simulate, statics
from gearwright.dynamics.equations import damped_rates, line_state, split_rigid
from gearwright.dynamics.equations.modes import is_sparse, motions_of_graph, rigid_motions, settled, stiffness_matrix
from gearwright.dynamics.equations.statics import steady_load
from gearwright.dynamics.model import LARGE, line_matrix
from gearwright.dynamics.motion import fastest_rate
from gearwright.dynamics.motion.steps import damping_bound, rate_bound
from gearwright.errors import DesignError, SolveError
from random_systems import random_system


def train(bodies, *, backlash=0.0, rings=0, balanced=True):
    """Return a chain of gears that turns freely; rings close loops over three gears by shafts and supported bodies."""
    rng, model = np.random.default_rng(bodies + rings), Model()
    for number in range(bodies):
        model.rotation(f"{number}", inertia=float(rng.uniform(0.5e-3, 2e-3)), speed=500.0 if number == 0 else None)
    for number in range(bodies - 1):
        model.mesh(
            f"{number}", {f"{number}": 0.05, f"{number + 1}": 0.05}, stiffness=float(rng.uniform(0.5e8, 2e8)),
            damping=DampingRatio(0.05), backlash=backlash, variation=Periodic({"0": 20}, (0.2, 0.1)),
        )  # fmt: skip
    for number in range(rings):
        model.shaft(f"ring {number}", f"{3 * number}", f"{3 * number + 2}", stiffness=1e5, damping=10.0)
    model.load("0", constant=100.0)
    model.load(f"{bodies - 1}", constant=100.0 * (-1.0) ** bodies * (1.0 if balanced else 2.0))
    return model.build()


def span_of(motions, mass):
    """Return the projector on motions of unit mass."""
    scaled = np.sqrt(mass)[:, None] * motions
    return scaled @ scaled.T


@pytest.mark.parametrize("seed", range(30))
def test_the_graph_finds_the_rigid_motions_of_any_structure(seed):
    arrays = random_system(np.random.default_rng(seed)).arrays
    found, wanted = motions_of_graph(arrays), split_rigid(arrays)[0]
    assert found.shape == wanted.shape
    # Both are orthonormal to rounding; what is left is the conditioning of the smallest singular value that counts.
    np.testing.assert_allclose(span_of(found, arrays.mass), span_of(wanted, arrays.mass), atol=1e-8)


def test_loops_that_close_and_loops_that_block_are_told_apart():
    for radius, free in ((0.05, 1), (0.06, 0)):
        model = Model()
        for name in "abc":
            model.rotation(name, inertia=1.0)
        for first, second, weight in (("a", "b", 0.05), ("b", "c", -0.05), ("a", "c", radius)):
            model.mesh(first + second, {first: 0.05, second: weight}, stiffness=1e8)
        assert motions_of_graph(model.build().arrays).shape == (3, free)


@pytest.mark.parametrize("backlash", [0.0, 1e-4])
def test_sparse_statics_are_the_dense_ones(backlash):
    system = train(40, backlash=backlash, rings=8, balanced=False)
    arrays, still = system.arrays, np.zeros(40)
    start = line_state(arrays, 0.0, still, still)
    found = settled(arrays, steady_load(arrays, 0.0), start.stiffness, -start.deflection)
    wanted = statics(system, balance="accelerate")
    scale = np.max(np.abs(wanted.position))
    np.testing.assert_allclose(found, wanted.position, atol=1e-9 * scale)
    force = line_state(arrays, 0.0, found, still).force
    np.testing.assert_allclose(force, wanted.force, atol=1e-9 * np.max(np.abs(wanted.force)))


def test_statics_of_a_train_beyond_what_is_dense_balance_every_body():
    system = train(LARGE + 50, backlash=1e-4, rings=20)
    assert is_sparse(system.arrays)
    found = statics(system)
    left = line_matrix(system.arrays).T @ found.force - system.arrays.loads.constant
    assert np.max(np.abs(left)) < 1e-9 * 100.0
    assert rigid_motions(system.arrays).shape[1] == 1


def test_large_loads_that_do_not_balance_are_refused_with_the_motion():
    with pytest.raises(SolveError, match="nothing holds the motion"):
        statics(train(LARGE + 1, balanced=False))


@pytest.mark.parametrize("seed", range(20))
def test_rates_and_damping_are_bounded_safely(seed):
    """The bound is above the eigenvalue, and at most three times: it does not see the signs of loops."""
    arrays = random_system(np.random.default_rng(seed)).arrays
    fastest, bound = fastest_rate(arrays), rate_bound(arrays)
    assert fastest <= bound * (1.0 + 1e-9)
    assert bound <= 3.0 * fastest


def test_the_damping_of_every_mode_is_above_its_bound():
    arrays = train(60, rings=10).arrays
    rates = damped_rates(arrays, 1.0)
    damping = -rates.real / np.abs(rates)
    bounds = np.array([damping_bound(arrays, rate) for rate in np.abs(rates)])
    assert np.all(bounds > 0.0)
    assert np.all(damping >= bounds * (1.0 - 1e-6))


def test_a_train_beyond_what_is_dense_moves_as_accurately_as_it_says():
    system = train(LARGE + 10)
    coarse, fine = (simulate(system, 0.0005, step=step) for step in (None, 1e-6))
    peaks = [np.maximum(np.abs(trace.force.minimum[0]), np.abs(trace.force.maximum[0])) for trace in (coarse, fine)]
    away = np.max(np.abs(peaks[0] - peaks[1]) / np.max(peaks[1]))
    assert away <= coarse.error <= 0.01
    assert abs(coarse.work.imbalance) < 1e-4


def test_lowest_modes_of_a_large_train_are_those_of_dense_matrices():
    """Lanczos' method and the whole eigenproblem, which take other ways; tolerance: the square of the residual."""
    system = train(LARGE + 40, rings=20)
    few = modes(system, 12)
    assert few.rigid == 1
    assert np.max(few.residual) < 1e-8
    assert len(few.residual) == 12
    elastic = split_rigid(system.arrays)[1]
    matrix = elastic.T @ stiffness_matrix(system.arrays, system.arrays.stiffness) @ elastic
    wanted = np.sqrt(np.linalg.eigvalsh(matrix)[:12]) / (2.0 * np.pi)
    np.testing.assert_allclose(few.frequency[1:], wanted, rtol=1e-9)
    overlap = few.shapes.T @ (system.arrays.mass[:, None] * few.shapes)
    np.testing.assert_allclose(overlap, np.eye(13), atol=1e-8)
    np.testing.assert_allclose(np.sum(few.line_energy[:, 1:], axis=0), 1.0, rtol=1e-7)


def test_modes_of_a_chain_of_thousands_are_those_of_its_closed_form():
    """Equal bodies and lines in a row: ω = 2 √(k r²/J) sin(n π/(2 N)); residuals are told."""
    bodies, model = 3000, Model()
    for number in range(bodies):
        model.rotation(f"{number}", inertia=1e-3)
    for number in range(bodies - 1):
        model.shaft(f"shaft {number}", f"{number}", f"{number + 1}", stiffness=1e5)
    found = modes(model.build(), 5)
    wanted = 2.0 * np.sqrt(1e5 / 1e-3) * np.sin(np.arange(6) * np.pi / (2 * bodies)) / (2.0 * np.pi)
    np.testing.assert_allclose(found.frequency, wanted, rtol=1e-7, atol=1e-9)
    assert np.max(found.residual) < 1e-6


def test_a_count_of_modes_below_one_is_refused():
    with pytest.raises(DesignError, match="0 modes; ask for one or more"):
        modes(train(4), 0)


def test_speeds_of_a_large_train_follow_line_by_line():
    """As those of a small one by least squares: teeth alternate the sense, and a line that cannot fit is named."""
    system = train(LARGE + 10)
    np.testing.assert_allclose(system.arrays.speed, 500.0 * (-1.0) ** np.arange(LARGE + 10), rtol=1e-12)
    model = Model()
    for number in range(LARGE + 10):
        model.rotation(f"{number}", inertia=1e-3, speed={0: 500.0, LARGE: 400.0}.get(number))
    for number in range(LARGE + 9):
        model.mesh(f"{number}", {f"{number}": 0.05, f"{number + 1}": 0.05}, stiffness=1e8)
    with pytest.raises(DesignError, match="it would stretch steadily"):
        model.build()
