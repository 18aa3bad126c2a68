"""Modes are followed over speed by their shapes, where gyroscopic terms split and bend them."""

import numpy as np
import pytest

from gearwright.dynamics import Model, campbell
from gearwright.dynamics.model import add_planetary
from gearwright.validate.trains import lin_parker


def diagram(speeds):
    """Lin & Parker's set of four planets with its carrier at 20 to 1000 rad/s: 20 modes, translational pairs split."""
    model = Model()
    add_planetary(model, lin_parker(4), speeds={"carrier": 1000.0})
    return campbell(model.build(), [float(factor) for factor in np.linspace(0.02, 1.0, speeds)])


@pytest.mark.parametrize("speeds", [5, 9, 15])
def test_a_few_speeds_follow_every_mode_as_many_do(speeds):
    """Lin & Parker 1999, fig. 4: branches cross and veer; mode by mode the same end, 1e-9 is rounding."""
    assert diagram(speeds).frequency[-1] == pytest.approx(diagram(101).frequency[-1], rel=1e-9)


def test_branches_have_no_jumps():
    """Second differences of 101 speeds, over a mode's whole change: a swap of branches would be of order one."""
    frequency = diagram(101).frequency
    change = np.abs(frequency[-1] - frequency[0])
    bend = np.max(np.abs(np.diff(frequency, n=2, axis=0)), axis=0)
    assert np.all(bend < 0.01 * change + 1e-6)
