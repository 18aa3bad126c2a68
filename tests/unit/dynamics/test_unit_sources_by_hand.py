"""One error of size 1 on the line of one mesh, whose direction is (0, 0.6, 0.8) from the pinion into the wheel."""

from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.dynamics.model import Contact
from gearwright.dynamics.model.elements import Carried
from gearwright.dynamics.sharing.solutions import unit_source

SIDES = (
    Carried("pinion", "fast", 0.05, {"pinion": 1.0}, {"fast": 1.0}, {}),
    Carried("wheel", "slow", -0.1, {"wheel": 1.0}, {"slow": 1.0}, {}),
)
CONTACTS = (Contact("mesh", (0.0, 0.6, 0.8), SIDES),)


def system(speed):
    """Return the lines and speeds of two gears on two shafts; the wheel turns at minus half of the pinion's speed."""
    labels = SimpleNamespace(lines=("other", "mesh"), coordinates=("pinion", "fast", "wheel", "slow"))
    return SimpleNamespace(labels=labels, arrays=SimpleNamespace(speed=np.array([1.0, 1.0, -0.5, -0.5]) * speed))


@pytest.mark.parametrize(
    ("part", "speed", "amplitude", "rate"),
    [
        ("pinion", 100.0, -0.6 + 0.8j, 100.0),  # −(0.6 cos θ + 0.8 sin θ) = Re((−0.6 + 0.8 i) e^(iθ))
        ("pinion", -100.0, -0.6 - 0.8j, -100.0),  # to e^(i|rate|t): the conjugate
        ("wheel", 100.0, 0.6 + 0.8j, -50.0),  # the direction is the other on its side, and it turns backwards
        ("slow", -100.0, 0.6 - 0.8j, 50.0),
    ],
)
def test_an_eccentricity_turns_with_its_part(part, speed, amplitude, rate):
    source = unit_source(system(speed), CONTACTS, part, "eccentricity")
    assert source.turning == pytest.approx([0.0, amplitude])
    assert source.rate == rate
    assert (source.part, source.kind, source.size, source.angle) == (part, "eccentricity", 1.0, 0.0)
    assert not source.still.any()


@pytest.mark.parametrize(
    ("part", "kind", "still"),
    [
        ("pinion", "radial", (-0.6, -0.8)),  # along y, then along z
        ("wheel", "radial", (0.6, 0.8)),
        ("pinion", "clocking", (-0.05, 0.0)),  # its lever
        ("wheel", "clocking", (0.1, 0.0)),
        ("wheel", "tooth_thickness", (-1.0, 0.0)),  # a thicker tooth shortens the line on either side
        ("pinion", "axial", (0.0, 0.0)),  # a spur gear's line is square to its shaft
    ],
)
def test_what_stands_has_no_rate(part, kind, still):
    source = unit_source(system(100.0), CONTACTS, part, kind)
    assert source.still == pytest.approx(np.array([[0.0, still[0]], [0.0, still[1]]]), abs=1e-12)
    assert (source.rate, source.turning.any()) == (0.0, False)
