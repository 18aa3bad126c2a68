"""Numbers that are not finite neither enter nor leave the verbs of the dynamics, and the part is named."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import gearwright as gw
from gearwright.dynamics import campbell, frequency_response, modes, simulate, speed_map, statics
from gearwright.dynamics.model import refuse_not_finite
from gearwright.errors import SolveError

VERBS = {
    "modes": modes,
    "statics": statics,
    "campbell": lambda system: campbell(system, [0.9, 1.1]),
    "frequency_response": lambda system: frequency_response(system, [100.0], loads={"propeller": 1.0}),
    "simulate": lambda system: simulate(system, 1e-3),
    "speed_map": lambda system: speed_map(system, np.array([0.9, 1.0]), settle=0.0, duration=1e-3),
}


@pytest.fixture(scope="module")
def system():
    return gw.assemble(gw.size(gw.read("single-planetary")))


def spoilt(system, field, place, value):
    values = getattr(system.arrays, field).copy()
    values[place] = value
    return dataclasses.replace(system, arrays=system.arrays._replace(**{field: values}))


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize(
    ("field", "value", "sentence"),
    [
        ("mass", np.inf, "mass or inertia of {0} is inf"),
        ("mass", 0.0, "mass or inertia of {0} is nan"),
        ("stiffness", np.nan, "stiffness of {1} is nan"),
        ("damping", np.inf, "damping of {1} is inf"),
    ],
)
def test_a_number_that_is_none_is_refused_with_its_part(system, verb, field, value, sentence):
    names = (system.labels.coordinates[1], system.labels.lines[1])
    with pytest.raises(SolveError) as caught:
        VERBS[verb](spoilt(system, field, 1, value))
    assert sentence.format(*names) in str(caught.value)


@pytest.mark.parametrize("verb", ["modes", "campbell"])
def test_what_overflows_is_a_solve_error_and_no_number(system, verb):
    """A stiffness near the largest number that there is: its products are infinite."""
    with pytest.raises(SolveError):
        VERBS[verb](spoilt(system, "stiffness", 0, 1.7e308))


def test_first_part_that_is_wrong_is_named():
    refuse_not_finite([[1.0, 2.0]], ["one", "other"], "force")
    with pytest.raises(SolveError, match="force of other is inf, no finite number"):
        refuse_not_finite([[1.0, 2.0], [3.0, np.inf]], ["one", "other"], "force")


def test_any_sequence_of_speeds_is_taken(system):
    """A NumPy array was a bare ValueError."""
    found = [speed_map(system, speeds, settle=0.0, duration=1e-3) for speeds in ([0.9, 1.0], np.array([0.9, 1.0]))]
    assert np.array_equal(found[0].forces.mean, found[1].forces.mean)
    for wrong in ([], np.zeros(2), np.array([[1.0]]), [np.nan], "12"):
        with pytest.raises(gw.DesignError):
            speed_map(system, wrong, settle=0.0, duration=1e-3)
