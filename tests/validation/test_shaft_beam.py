"""A published countershaft in both planes; its reactions and resulting moments are cases of `gearwright validate`."""

import numpy as np
import pytest

from gearwright.parts.shafts import diagram, supported
from gearwright.units import INCH
from gearwright.validate.shafts import BEARINGS, LENGTH, POUND_INCH, countershaft


def test_moment_diagrams_of_shigleys_countershaft():
    """Same example, figure: M in both planes and together at both gears and at the shoulder I; printed to 1 lbf in."""
    drawn = diagram(supported(countershaft(), BEARINGS, length=LENGTH))
    places = np.array([2.75, 7.50, 8.50]) * INCH
    y, z = (np.interp(places, drawn.position, plane) / POUND_INCH for plane in drawn.bending)
    assert y == pytest.approx([713.0, 1472.0, 1632.0], abs=1.0)
    assert z == pytest.approx([230.0, 3341.0, 3996.0], abs=1.0)
    assert np.hypot(y, z) == pytest.approx([749.0, 3651.0, 4316.0], abs=1.0)
    assert np.abs(drawn.torsion).max() / POUND_INCH == pytest.approx(3240.0)
