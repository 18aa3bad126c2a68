"""Circle, length and offset that a gearbox takes, and whether it keeps to what its design leaves it."""

import math

import numpy as np
import pytest

import gearwright as gw
from gearwright.sizing.casing import housed
from gearwright.sizing.housing_shell import CLEARANCE, ways_of
from gearwright.sizing.installation import chance_to_fit, circle_around, installation_of
from gearwright.sizing.mass.complete import weighed_wall
from shipped_work import sized

LIMITS = ("diameter", "length", "offset")


def bounded(**limits):
    """Return the star with an installation envelope [mm], sized."""
    return gw.size(
        gw.edited(gw.read("star"), {f"installation_envelope.{name}_mm": most for name, most in limits.items()})
    )


def test_three_equal_discs_lie_in_the_circle_about_their_middles():
    """Middles on an equilateral triangle of side a: R = a/√3 + r."""
    corners = [
        np.array([math.cos(turn), math.sin(turn)]) / math.sqrt(3.0)
        for turn in (0.3, 0.3 + 2 * math.pi / 3, 0.3 - 2 * math.pi / 3)
    ]
    reach = np.max([ways_of(48) @ corner + 0.25 for corner in corners], axis=0)
    radius, middle = circle_around(reach)
    assert radius == pytest.approx(1.0 / math.sqrt(3.0) + 0.25, rel=2e-3)
    assert np.hypot(*middle) < 2e-3


def test_two_discs_lie_in_the_circle_over_their_far_ends():
    reach = np.max([ways_of(48) @ np.array([place, 0.0]) + own for place, own in ((-0.2, 0.1), (0.3, 0.15))], axis=0)
    radius, middle = circle_around(reach)
    assert radius == pytest.approx(0.375, rel=1e-9)
    assert middle[0] == pytest.approx(0.075, rel=1e-9)


def test_a_coaxial_gearbox_takes_the_circle_of_its_widest_body_with_clearance_and_wall():
    """A coaxial set's widest ring decides: nothing of it stands beside its axis."""
    sizing = sized("star")
    widest = max(body.radius for body in housed(sizing))
    taken = installation_of(sizing)
    assert taken.diameter == pytest.approx(2.0 * (CLEARANCE * widest + weighed_wall(sizing).thickness), rel=1e-9)
    assert taken.offset == 0.0
    assert taken.frontal_area == pytest.approx(math.pi / 4.0 * taken.diameter**2)


@pytest.mark.parametrize("design", ["off-set", "ec120b", "mixed-h1"])
def test_no_body_reaches_beyond_circle_and_length(design):
    sizing = sized(design)
    taken, bodies = installation_of(sizing), sizing.arrangement.bodies
    ends = [body.origin.x + part * body.length * body.direction.x for body in bodies for part in (0.0, 1.0)]
    assert max(ends) - min(ends) <= taken.length
    across = [(body.origin.y, body.origin.z, body.radius) for body in housed(sizing) if abs(body.direction.x) > 0.999]
    apart = max(math.dist(one[:2], other[:2]) + one[2] + other[2] for one in across for other in across)
    assert apart <= taken.diameter


def test_the_offset_is_that_of_the_axes_of_turbine_and_propeller():
    sizing = sized("off-set")
    frames = sizing.arrangement.frames
    first, last = (frames[shaft].origin for shaft in (sizing.design.shafts[0], sizing.design.shafts[-1]))
    assert installation_of(sizing).offset == pytest.approx(math.hypot(first.y - last.y, first.z - last.z))


def test_what_is_asked_is_checked_and_nothing_else():
    taken = installation_of(sized("star"))
    assert not [check for check in sized("star").checks if "envelope" in check.mode]
    wide, tight = 1e3 * taken.diameter + 1.0, 1e3 * taken.length - 1.0
    found = {check.mode: check for check in bounded(diameter=wide, length=tight).checks if "envelope" in check.mode}
    assert {mode: check.fails for mode, check in found.items()} == {
        "installation envelope diameter": False, "installation envelope length": True,
    }  # fmt: skip
    assert found["installation envelope length"].margin == pytest.approx((taken.length - 1e-3) / taken.length)


def test_what_just_fits_fits_with_one_half_and_five_per_cent_are_one_deviation():
    taken = installation_of(sized("star"))
    assert chance_to_fit(sized("star")) == 1.0
    just, wider = (bounded(diameter=1e3 * times * taken.diameter) for times in (1.0, 1.05))
    assert chance_to_fit(just) == pytest.approx(0.5, abs=1e-6)
    assert chance_to_fit(wider) == pytest.approx(0.8413, abs=1e-4)
    both = bounded(diameter=1e3 * taken.diameter, length=1e3 * taken.length)
    assert chance_to_fit(both) == pytest.approx(0.25, abs=1e-6)
