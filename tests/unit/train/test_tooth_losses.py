"""The direction of the tooth power, found as a linear complementarity problem."""

import numpy as np

from gearwright.train.flow import turned


def test_rows_that_disagree_turn_together_and_later_the_first_alone():
    senses, power = np.array([1.0, 1.0, -1.0]), np.array([-5.0, -5.0, -5.0])
    assert turned(None, power, 1.0, together=True).tolist() == [-1.0, -1.0, -1.0]
    assert turned(senses, power, 1.0, together=True).tolist() == [-1.0, -1.0, -1.0]
    assert turned(senses, power, 1.0, together=False).tolist() == [-1.0, 1.0, -1.0]


def test_power_within_the_noise_agrees_with_either_sense():
    senses = np.array([1.0, -1.0])
    assert turned(senses, np.array([-0.5, 0.5]), 1.0, together=True).tolist() == senses.tolist()
