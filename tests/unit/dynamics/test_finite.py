"""Numbers that are not finite neither enter nor leave the verbs of the dynamics, and the part is named."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import gearwright as gw
from gearwright.dynamics import campbell, frequency_response, modes, simulate, speed_map, statics
from gearwright.dynamics.model import line_matrix, refuse_not_finite
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


def test_a_stiffness_near_the_largest_number_has_the_rate_of_its_line_alone(system):
    """ω² = k d M⁻¹ dᵀ of a line beside which all others are soft: its root is far from what overflows."""
    stiff = spoilt(system, "stiffness", 0, 1.7e308)
    weight = line_matrix(stiff.arrays)[0]
    rate = math.sqrt(1.7e308) * math.sqrt(float(np.sum(weight**2 / stiff.arrays.mass)))
    assert 2.0 * math.pi * modes(stiff).frequency[-1] == pytest.approx(rate, rel=1e-9)
    assert 2.0 * math.pi * campbell(stiff, [0.9, 1.1]).frequency[0, -1] == pytest.approx(rate, rel=1e-9)


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
