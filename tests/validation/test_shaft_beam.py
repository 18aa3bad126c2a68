"""A published countershaft: reactions, moment diagrams and the stress of the governing section."""

import numpy as np
import pytest

from gearwright.parts.beam import PointLoads, diagram, supported
from gearwright.units import INCH, POUND_FORCE

POUND_INCH = POUND_FORCE * INCH
BEARINGS = (0.75 * INCH, 10.75 * INCH)
LENGTH = 11.5 * INCH


def countershaft():
    """Gears 3 and 4 of Shigley's countershaft: W_23 = (197, 540) lbf, W_54 = (885, 2431) lbf, torque 3240 lbf in."""
    force = np.array([[-197.0, -885.0], [540.0, -2431.0]]) * POUND_FORCE
    torque = np.array([3240.0, -3240.0]) * POUND_INCH
    return PointLoads(np.array([2.75, 8.50]) * INCH, force, np.zeros((2, 2)), torque)


def test_bearing_reactions_of_shigleys_countershaft():
    """Budynas & Nisbett, Shigley's Mechanical Engineering Design, ex. 7-2; printed to 0.1 lbf."""
    reactions = supported(countershaft(), BEARINGS, length=LENGTH).force[:, 2:] / POUND_FORCE
    assert reactions[0] == pytest.approx([356.7, 725.3], abs=0.1)
    assert reactions[1] == pytest.approx([115.0, 1776.0], abs=0.1)


def test_moment_diagrams_of_shigleys_countershaft():
    """Same example, figure: M in both planes and together at both gears and at the shoulder I; printed to 1 lbf in."""
    drawn = diagram(supported(countershaft(), BEARINGS, length=LENGTH))
    places = np.array([2.75, 7.50, 8.50]) * INCH
    y, z = (np.interp(places, drawn.position, plane) / POUND_INCH for plane in drawn.bending)
    assert y == pytest.approx([713.0, 1472.0, 1632.0], abs=1.0)
    assert z == pytest.approx([230.0, 3341.0, 3996.0], abs=1.0)
    assert np.hypot(y, z) == pytest.approx([749.0, 3651.0, 4316.0], abs=1.0)
    assert np.abs(drawn.torsion).max() / POUND_INCH == pytest.approx(3240.0)
