"""Journal bearings against published tables."""

import math

import pytest
from scipy.optimize import brentq

from gearwright.parts.bearings import film_load

near = pytest.approx

DATABOOK = {
    0.5: [(0.798, 0.4), (0.517, 0.5), (0.323, 0.6), (0.187, 0.7), (0.0926, 0.8), (0.0582, 0.85), (0.0315, 0.9)],
    1.0: [(0.284, 0.4), (0.194, 0.5), (0.131, 0.6), (0.0828, 0.7), (0.0469, 0.8), (0.0195, 0.9)],
}
"""S = η N D B/F (1/ψ)² over ε at B/D, a bearing with two axial grooves: Someya (ed.), Journal-Bearing Databook (1989),
pages 14 and 17, as carried by the public repository VictorLier/Tribology."""


@pytest.mark.parametrize(("number", "eccentricity"), DATABOOK[0.5])
def test_databook_of_half_width(number, eccentricity):
    """S = 1/(2 π So). The grooves cost up to 3 % of the load; the print rounds to 0.5 %."""
    assert 1.0 / (2.0 * math.pi * film_load(eccentricity, 0.5)) == near(number, rel=0.035)


@pytest.mark.parametrize(("number", "eccentricity"), DATABOOK[1.0])
def test_databook_of_full_width(number, eccentricity):
    """The grooves cost more of a wide film, up to 9 % at ε = 0.6 to 0.8: the full bearing sits less eccentric."""
    load = 1.0 / (2.0 * math.pi * number)
    sits = brentq(lambda part: float(film_load(part, 1.0)) - load, 0.02, 0.98)
    assert sits == near(eccentricity, abs=0.025)
    assert sits <= eccentricity + 0.005
