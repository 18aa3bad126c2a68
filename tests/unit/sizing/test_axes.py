"""Axes in the cross-section: centre distances, triangles, who shares an axis, and what does not close."""

import math

import pytest
from shaft_designs import ASKEW, OFF_SET, WITH_MOTOR, sized

from gearwright.errors import DesignError


def axes(sizing):
    """Return shaft -> place as a complex number [m]."""
    return {shaft.name: complex(*shaft.axis) for shaft in sizing.shafts}


def centre_distance(sizing, stage):
    """Return half the sum of the pitch diameters of a pair [m]."""
    return sum(gear.pitch_diameter for gear in sizing.gears if gear.stage == stage) / 2.0


@pytest.mark.parametrize("text", [OFF_SET, ASKEW, WITH_MOTOR])
def test_every_mesh_has_its_centre_distance(text):
    """Geometry; rounding only."""
    sizing = sized(text)
    place = axes(sizing)
    for mesh in sizing.train.meshes:
        one, other, _ = mesh.nodes
        assert abs(place[one] - place[other]) == pytest.approx(centre_distance(sizing, mesh.stage), rel=1e-12)


def test_two_layshafts_stand_opposite_and_the_output_square_to_them():
    """Offset of input and output: √(a_2² − a_1²), the triangle of axes with the layshafts opposite on the pinion."""
    sizing = sized(OFF_SET)
    place, first, second = axes(sizing), centre_distance(sizing, "first"), centre_distance(sizing, "second")
    assert place["left"] == pytest.approx(-place["right"])
    assert abs(place["output"] - place["input"]) == pytest.approx(math.sqrt(second**2 - first**2))


def test_the_order_of_the_shafts_in_the_file_only_turns_the_picture():
    """Distances between all axes stay; circles that touch are found to the square root of rounding."""
    one, other = (
        axes(sized(OFF_SET.replace('["input", "left", "right", "output"]', order)))
        for order in ('["input", "left", "right", "output"]', '["right", "output", "left", "input"]')
    )
    for shaft in one:
        for mate in one:
            assert abs(one[shaft] - one[mate]) == pytest.approx(abs(other[shaft] - other[mate]), abs=1e-8)


def test_the_hub_with_the_shortest_centre_distance_stands_between_the_layshafts():
    """The motor's pair has the smaller wheels here; the other hubs leave the line of the layshafts."""
    sizing = sized(WITH_MOTOR)
    place = axes(sizing)
    assert centre_distance(sizing, "boost") < centre_distance(sizing, "first")
    assert (place["left"] + place["right"]) / 2.0 == pytest.approx(place["motor"])
    assert abs(place["input"] - place["motor"]) > 0.02


def test_a_given_angle_is_the_direction_from_the_axis_that_it_meshes_with():
    place = axes(sized(ASKEW))
    assert math.degrees(math.atan2(place["left"].imag, place["left"].real)) == pytest.approx(-30.0)
    assert math.degrees(math.atan2(place["right"].imag, place["right"].real)) == pytest.approx(-160.0)


def test_an_angle_of_the_output_picks_the_other_crossing():
    below, above = (axes(sized(OFF_SET + rule)) for rule in ("", "[layout.output]\nangle_deg = 120\n"))
    assert above["output"] == pytest.approx(below["output"].conjugate())


def test_three_layshafts_close_only_around_one_axis():
    """Three points at equal distance from two axes: these axes coincide, so both centre distances must be equal."""
    three = OFF_SET.replace('"left", "right"', '"left", "right", "third"')
    with pytest.raises(DesignError, match=r"pairs\.second: the axes .* stand"):
        sized(three)
    coaxial = sized(three + '[overrides]\n"first.module_mm" = 4\n"second.module_mm" = 4\n')
    assert abs(axes(coaxial)["output"]) < 1e-9
    assert all(shaft.bending_moment < 1e-9 for shaft in coaxial.shafts if shaft.name in ("input", "output"))


def test_a_pair_between_two_shafts_of_one_axis_is_refused():
    text = OFF_SET + '[clutches.lock]\ndriving = "input"\ndriven = "left"\nkind = "open"\n'
    with pytest.raises(DesignError, match="share an axis"):
        sized(text)
