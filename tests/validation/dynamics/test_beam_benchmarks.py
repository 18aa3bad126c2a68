"""Bending shafts: how the frequencies converge to the closed form. The closed forms themselves are published cases."""

from gearwright.dynamics import modes
from gearwright.dynamics.model import Segment
from gearwright.validate.shafts import simply_supported, timoshenko_frequency


def test_frequencies_converge_with_the_square_of_the_segment_length():
    """Lumped masses: error falls by about four with each halving."""
    wanted = timoshenko_frequency(Segment(0.25, 0.05), 0.25, 1)
    errors = []
    for count in (5, 10, 20):
        found = modes(simply_supported(count, Segment(0.25 / count, 0.05)))
        errors.append(abs(next(f for f, many in found.groups() if many == 2) - wanted))
    assert 3.0 < errors[0] / errors[1] < 5.0
    assert 3.0 < errors[1] / errors[2] < 5.0
