"""What a model's parts are when their fields are left out, and what bearings of rotors become."""

import math

import numpy as np
import pytest

from gearwright.dynamics import Model
from gearwright.dynamics.model import Bearing, Segment, add_bearing
from gearwright.errors import DesignError

JOURNAL = {axis: {f"j {axis}": 1.0} for axis in ("x", "y", "z", "tilt x", "tilt y")}


def lines(bearing, **given):
    """Return name -> weights, stiffness and damping of the lines that a bearing becomes."""
    model = Model()
    add_bearing(model, "b", JOURNAL, bearing, **given)
    return {line.name: (dict(line.weights), line.stiffness, line.damping) for line in model.lines}


def test_a_mesh_and_a_shaft_have_no_damping_unless_it_is_said():
    model = Model()
    for body in ("a", "b", "c"):
        model.rotation(body, inertia=1.0)
    model.mesh("mesh", {"a": 0.1, "b": 0.2}, stiffness=1e8)
    model.shaft("shaft", "b", "c", stiffness=1e4)
    assert model.build().arrays.damping.tolist() == [0.0, 0.0]
    assert model.build().arrays.backlash.tolist() == [0.0, 0.0]


def test_a_segment_is_a_solid_round_of_steel_unless_it_is_said():
    """A = π d²/4, I = π d⁴/64, G = E/2(1 + ν)."""
    solid, hollow = Segment(0.3, 0.04), Segment(0.3, 0.04, 0.02, 100e9, 0.25, 4500.0)
    assert solid.area == pytest.approx(math.pi * 0.04**2 / 4.0)
    assert solid.second_moment == pytest.approx(math.pi * 0.04**4 / 64.0)
    assert solid.shear_modulus == pytest.approx(206e9 / 2.6)
    assert (solid.density, hollow.density) == (7850.0, 4500.0)
    assert hollow.area == pytest.approx(math.pi * (0.04**2 - 0.02**2) / 4.0)
    assert hollow.second_moment == pytest.approx(math.pi * (0.04**4 - 0.02**4) / 64.0)
    assert hollow.shear_modulus == pytest.approx(40e9)


def test_a_bearing_is_a_spring_for_every_direction_that_it_holds():
    bearing = Bearing((2e8, 3e8), damping=(50.0, 70.0), axial=(1e7, 11.0), tilting=(5e4, 3.0))
    found = lines(bearing)
    across = {next(iter(weights)): (k, c) for weights, k, c in found.values() if k in (2e8, 3e8)}
    assert across == {"j x": (2e8, 0.0), "j y": (3e8, 0.0)}
    damped = {next(iter(weights)): c for weights, k, c in found.values() if not k}
    assert damped == {"j x": 50.0, "j y": 70.0}
    assert found["b z"] == ({"j z": 1.0}, 1e7, 11.0)
    assert found["b tilt x"] == ({"j tilt x": 1.0}, 5e4, 3.0)
    assert found["b tilt y"] == ({"j tilt y": 1.0}, 5e4, 3.0)


def test_a_bearing_of_which_only_two_numbers_are_given_is_two_springs():
    found = lines(Bearing((1e8, 1e8)))
    assert sorted(k for _, k, _ in found.values()) == [1e8, 1e8]
    assert all(c == 0.0 for *_, c in found.values())


def test_cross_terms_alike_turn_the_axes_and_unlike_follow():
    """K = [[3, 1], [1, 3]] is 4 along the diagonal and 2 across it; with k_xy = −k_yx nothing is left to turn."""
    alike = lines(Bearing((3e8, 3e8), cross_stiffness=(1e8, 1e8)))
    assert sorted(k for _, k, _ in alike.values()) == pytest.approx([2e8, 4e8])
    for weights, stiffness, _ in alike.values():
        assert abs(weights["j x"]) == pytest.approx(math.sqrt(0.5))
        assert weights["j x"] * weights["j y"] == pytest.approx(0.5 if stiffness > 3e8 else -0.5)
    unlike = lines(Bearing((3e8, 3e8), cross_stiffness=(1e8, -1e8)))
    assert sorted(k for _, k, _ in unlike.values()) == pytest.approx([3e8, 3e8])


def test_a_bearing_on_a_housing_feels_how_far_they_part():
    found = lines(Bearing((1e8, 2e8)), housing={"x": {"h x": 1.0}, "y": {"h y": 1.0}})
    springs = {k: weights for weights, k, _ in found.values()}
    assert springs == {1e8: {"j x": 1.0, "h x": -1.0}, 2e8: {"j y": 1.0, "h y": -1.0}}


@pytest.mark.parametrize(
    ("bearing", "words"),
    [(Bearing((math.nan, 1e8)), "finite"), (Bearing((1e8, -1e8)), "principal stiffness"),
     (Bearing((1e8, 1e8), damping=(1.0, -1.0)), "principal damping"),
     (Bearing((1e8, 1e8), axial=(-1.0, 0.0)), "negative"), (Bearing((1e8, 1e8), tilting=(0.0, -2.0)), "negative")],
)  # fmt: skip
def test_a_bearing_that_drives_or_is_no_number_is_refused(bearing, words):
    with pytest.raises(DesignError, match=words):
        lines(bearing)


def test_matrices_of_a_bearing_have_the_direct_terms_on_their_diagonal():
    stiffness, damping = Bearing((1.0, 2.0), (3.0, 4.0), (5.0, 6.0), (7.0, 8.0)).matrices()
    assert np.array_equal(stiffness, [[1.0, 3.0], [4.0, 2.0]])
    assert np.array_equal(damping, [[5.0, 7.0], [8.0, 6.0]])
