"""One thread works on the matrices of a gear train; whoever calls has its own number of threads again afterwards."""

import threading

import numpy as np
import pytest
import scipy.linalg
from threadpoolctl import threadpool_info, threadpool_limits

from gearwright.arrays import one_blas_thread
from gearwright.dynamics import Model, modes
from gearwright.optimum.generations import conditioned


def threads():
    """Return the threads of every BLAS that is loaded."""
    return {one["num_threads"] for one in threadpool_info() if one["user_api"] == "blas"}


@pytest.fixture(autouse=True)
def three():
    with threadpool_limits(3, user_api="blas"):
        if not threads():
            pytest.skip("numpy's linear algebra is of a kind that shares nothing")
        yield
        assert threads() == {3}


def row_of(count):
    model = Model()
    for k in range(count):
        model.rotation(f"b{k}", inertia=0.01 + 1e-5 * k)
    for k in range(count - 1):
        model.shaft(f"s{k}", f"b{k}", f"b{k + 1}", stiffness=1e5)
    return model.build()


def test_threads_are_one_inside_and_as_before_outside():
    with one_blas_thread():
        assert threads() == {1}
        with one_blas_thread():
            assert threads() == {1}
        assert threads() == {1}
    assert threads() == {3}


def test_threads_are_as_before_after_an_exception():
    with pytest.raises(ZeroDivisionError), one_blas_thread():
        raise ZeroDivisionError
    assert threads() == {3}


def test_of_two_blocks_that_overlap_the_last_hands_back():
    entered, leave = threading.Event(), threading.Event()

    def other():
        with one_blas_thread():
            entered.set()
            leave.wait(10.0)

    thread = threading.Thread(target=other)
    with one_blas_thread():
        thread.start()
        assert entered.wait(10.0)
    assert threads() == {1}
    leave.set()
    thread.join()
    assert threads() == {3}


def test_the_modes_of_a_row_of_bodies_are_found_by_one_thread(monkeypatch):
    seen, real = [], np.linalg.svd
    monkeypatch.setattr(np.linalg, "svd", lambda *given, **named: (seen.append(threads()), real(*given, **named))[1])
    modes(row_of(60))
    assert set(map(frozenset, seen)) == {frozenset({1})}


def test_what_is_learnt_of_results_is_learnt_by_one_thread(monkeypatch):
    seen, real = [], scipy.linalg.cho_solve
    monkeypatch.setattr(scipy.linalg, "cho_solve", lambda *given: (seen.append(threads()), real(*given))[1])
    places = np.linspace(0.0, 1.0, 9)[:, None]
    conditioned(places, np.sin(places[:, 0]), np.log([0.5, 1e-3]))
    assert seen == [{1}]
