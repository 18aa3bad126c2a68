"""Large systems: what spanning trees, sparse factors and bounds say is what dense matrices say."""

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Periodic, simulate, statics
from gearwright.dynamics.equations import damped_rates, line_state, split_rigid
from gearwright.dynamics.equations.sparse import is_sparse, motions_of_graph, rigid_motions, settled
from gearwright.dynamics.equations.statics import steady_load
from gearwright.dynamics.model import LARGE, line_matrix
from gearwright.dynamics.motion import fastest_rate
from gearwright.dynamics.motion.steps import damping_bound
from gearwright.dynamics.motion.steps.bounds import rate_bound
from gearwright.errors import SolveError
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
