"""The thesis's layshaft with three gears: its equations (2.45) and (2.46), corrected and as printed, against the beam.

Along the shaft: bearing 4, L_3, pinion 4 (meshes with 5), L_4, wheel 3a, b_1, wheel 3, L_2, bearing 3. Forces of the
meshes point down, those of the bearings up, as in the thesis; the numbers are chosen here, any would do.
"""

import numpy as np
import pytest

from gearwright.parts.shafts import PointLoads, diagram, supported

L3, L4, B1, L2 = 0.053, 0.073, 0.039, 0.034
LENGTH = L3 + L4 + B1 + L2
F45, F1A3A, F13 = 33.6e3, 8.4e3, 8.4e3


def corrected_reaction():
    """R_b3 by moments about bearing 4 in the sign convention of (2.45)'s own first line."""
    return (F45 * L3 + F1A3A * (L3 + L4) + F13 * (L3 + L4 + B1)) / LENGTH


def printed_reaction():
    """R_b3 as (2.45) prints it: F_45 with a minus sign."""
    return (F13 * (L3 + L4 + B1) + F1A3A * (L3 + L4) - F45 * L3) / LENGTH


def corrected_moment(x):
    """Q_b of (2.46) with the corrected signs and brackets, by sections, positive where the shaft sags."""
    reaction = F45 + F1A3A + F13 - corrected_reaction()
    pinion, first, second = L3, L3 + L4, L3 + L4 + B1
    return (
        reaction * x
        - F45 * np.maximum(x - pinion, 0.0)
        - F1A3A * np.maximum(x - first, 0.0)
        - F13 * np.maximum(x - second, 0.0)
    )


def layshaft():
    """The same shaft as a beam."""
    force = np.array([-F45, -F1A3A, -F13])
    loads = PointLoads(np.array([L3, L3 + L4, L3 + L4 + B1]), force, np.zeros(3), np.zeros(3))
    return supported(loads, (0.0, LENGTH), length=LENGTH)


def test_the_corrected_reaction_is_that_of_the_beam():
    """Both are exact statics; 1e-14 is rounding."""
    assert layshaft().force[-1] == pytest.approx(corrected_reaction(), rel=1e-14)


def test_the_corrected_moments_are_those_of_the_beam_in_every_section():
    """Pulvirenti 2023, (2.46) corrected; rounding of a few additions of some 1000 N m, read off a straight line."""
    drawn = diagram(layshaft())
    x = np.linspace(0.0, LENGTH, 101)
    assert np.interp(x, drawn.position, drawn.bending) == pytest.approx(corrected_moment(x), abs=1e-10)


def test_the_moment_vanishes_at_the_far_bearing():
    """The closing check that (2.46) must pass at x = L_2 of its last section; some 1000 N m, so 1e-12 of it."""
    assert abs(corrected_moment(np.array([LENGTH]))[0]) < 1e-9
    assert abs(diagram(layshaft()).bending[-1]) < 1e-9


def test_the_printed_reaction_leaves_the_shaft_out_of_balance():
    """Moments about bearing 4 do not close by 2 F_45 L_3: the sign of F_45 in (2.45) turns its moment around."""
    residual = F45 * L3 + F1A3A * (L3 + L4) + F13 * (L3 + L4 + B1) - printed_reaction() * LENGTH
    assert residual == pytest.approx(2.0 * F45 * L3, rel=1e-12)
    assert residual > 3.5e3
