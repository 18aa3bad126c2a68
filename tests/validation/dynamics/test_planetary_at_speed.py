"""Gyroscopic planetary set: the set of Cooley & Parker 2012 at carrier speed, against an independent program."""

import math

import numpy as np
import pytest

from gearwright.dynamics import Model, campbell, modes
from gearwright.dynamics.model import add_planetary
from gearwright.errors import DesignError
from gearwright.validate.trains import cooley_parker

SCALE = math.sqrt(1e7 / 1.86)
"""√(k_p/m_p) [rad/s]."""
AT_SPEED = {
    0.1: (0.675359, 0.786856, 0.908488, 0.978774, 1.057944, 1.104295, 1.198022, 1.340846, 1.362129, 1.400263, 1.577574,
          1.93094, 4.953829, 5.002266, 5.566604, 6.262682, 6.303444, 7.741319),
    0.5: (0.309152, 0.645633, 0.669306, 0.694029, 0.937099, 1.129517, 1.196084, 1.336207, 1.450315, 1.674514, 1.94002,
          1.950934, 4.914676, 5.149438, 5.592666, 6.202185, 6.406258, 7.747992),
}  # fmt: skip
"""Carrier speed over √(k_p/m_p) -> natural frequencies over it, by a program of its own from the energies; the paper
prints them as a figure."""


def at_speed(carrier):
    planetary = cooley_parker(3)
    along = math.cos(planetary.pressure_angles[0]) * planetary.carrier.radius
    model = Model()
    # The ring stands, so that the sun runs twice as far along its base circle as the pins do along their path.
    add_planetary(
        model, planetary, speeds={"carrier": carrier, "ring": 0.0, "sun": 2.0 * along * carrier / planetary.sun.radius}
    )
    return model.build()


@pytest.mark.parametrize("factor", AT_SPEED)
def test_frequencies_of_a_turning_set_are_those_of_an_independent_program(factor):
    """Members whose rotations springs hold turn all the same; six digits, so within one of the last."""
    diagram = campbell(at_speed(factor * SCALE), [0.999, 1.0])
    found = np.sort(2.0 * np.pi * diagram.frequency[-1]) / SCALE
    np.testing.assert_allclose(found, AT_SPEED[factor], atol=1e-6)
    assert np.max(np.abs(diagram.damping[-1])) < 1e-9


def test_a_slow_set_has_the_frequencies_of_one_at_rest():
    model = Model()
    add_planetary(model, cooley_parker(3))
    still = modes(model.build()).frequency
    slow = np.sort(campbell(at_speed(1e-3), [0.999, 1.0]).frequency[-1])
    np.testing.assert_allclose(slow, still[still > 0.0], rtol=1e-6)


def test_a_held_member_without_a_speed_still_stands():
    """The ring's spring keeps it at rest; a sun that is held but has no speed cannot turn."""
    with pytest.raises(DesignError, match=r"sun\.support\.rotation.*would stretch steadily"):
        model = Model()
        add_planetary(model, cooley_parker(3), speeds={"carrier": 10.0})
        model.build()
