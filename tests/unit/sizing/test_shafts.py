"""Shafts of whole gearboxes: the housing balances, what cancels does, what is given is kept."""

import math

import numpy as np
import pytest
from shaft_designs import ASKEW, INTERNAL, OFF_SET, SINGLE_HELIX, SPUR, WITH_MOTOR, sized

from gearwright.errors import DesignError

EVERY = [OFF_SET, SINGLE_HELIX, SPUR, ASKEW, WITH_MOTOR, INTERNAL]


@pytest.mark.parametrize("text", EVERY)
def test_all_bearings_together_hold_the_gearbox_against_its_machines(text):
    """Mesh forces are internal: bearing forces sum to zero, and their moment about x balances the machines' torques.

    Rounding of forces of 1e5 N on levers below 1 m.
    """
    sizing = sized(text)
    force = np.array([bearing.force for shaft in sizing.shafts for bearing in shaft.bearings])
    axis = np.array([shaft.axis for shaft in sizing.shafts for _ in shaft.bearings])
    torque = sum(sizing.flows["rated"].machine_torques.values())
    moment = np.sum(axis[:, 0] * force[:, 1] - axis[:, 1] * force[:, 0])
    assert np.abs(force.sum(axis=0)).max() < 1e-9 * np.abs(force).max()
    assert moment == pytest.approx(-torque, rel=1e-9)


@pytest.mark.parametrize("text", EVERY)
def test_thrusts_of_all_meshes_cancel_over_the_gearbox(text):
    """Action and reaction along x; and a single helix leaves some on its shaft."""
    sizing = sized(text)
    thrusts = [shaft.axial_force for shaft in sizing.shafts]
    assert sum(thrusts) == pytest.approx(0.0, abs=1e-9 * (1.0 + max(map(abs, thrusts))))
    assert any(abs(thrust) > 1.0 for thrust in thrusts) == (sizing.gears[-1].helix_angle > 0.0)


@pytest.mark.parametrize("text", EVERY)
def test_shear_bending_and_torsion_vanish_at_both_ends(text):
    """Free ends; rounding against the largest force and torque on the shaft."""
    for shaft in sized(text).shafts:
        lines = (*shaft.diagram.shear, *shaft.diagram.bending, shaft.diagram.torsion)
        largest = max(abs(value) for line in lines for value in line)
        assert all(max(abs(line[0]), abs(line[-1])) <= 1e-12 * largest for line in lines)


def test_a_pinion_between_two_opposite_wheels_carries_torsion_only():
    """Pulvirenti 2023, eq. 2.9: the forces of the two meshes cancel; 1e-12 of the mesh force of 17 kN is rounding."""
    sizing = sized(OFF_SET)
    pinion = sizing.shafts[0]
    assert pinion.bending_moment < 1e-9
    assert pinion.torque == pytest.approx(sizing.flows["rated"].machine_torques["turbine"])


def test_a_diameter_bears_the_section_where_bending_and_torsion_together_are_largest():
    """Pulvirenti 2023, eq. (2.47): every section of the diagram is at or below the allowable stress, one is at it."""
    for shaft in sized(WITH_MOTOR).shafts:
        y, z = (np.array(plane) for plane in shaft.diagram.bending)
        stress = 32.0 * np.sqrt(y**2 + z**2 + np.array(shaft.diagram.torsion) ** 2) / (math.pi * shaft.diameter**3)
        assert stress.max() == pytest.approx(785e6 / 2.0, rel=1e-9)


def test_parallel_layshafts_bend_differently_because_all_turn_one_way():
    """Tangential and radial force add on one side and oppose on the other: the mirror image turns the other way."""
    sizing = sized(SPUR)
    left, right = sizing.shafts[1:3]
    assert left.torque == pytest.approx(right.torque)
    assert left.bending_moment > 1.1 * right.bending_moment


def test_a_shaft_between_planetary_sets_has_no_bending_and_no_bearing_load():
    """Forces of equal planets cancel; what is left is the largest torque, as eq. (2.47) takes it."""
    text = (
        OFF_SET.split("[pairs.first]")[0].replace('"left", "right", ', '"middle", ')
        + """
[planetaries.first]
sun = "input"
ring = "ground"
carrier = "middle"
[planetaries.second]
sun = "middle"
ring = "ground"
carrier = "output"
"""
    )
    sizing = sized(text)
    middle = sizing.shafts[1]
    assert middle.bearings == () and middle.bending_moment == 0.0 and middle.axis == (0.0, 0.0)
    assert middle.torque == pytest.approx(abs(sizing.flows["rated"].meshes["second.sun-planet"].torques[0]))


def test_a_hollow_shaft_is_wider_and_lighter_at_the_same_stress():
    """d_o grows by (1 − κ⁴)^(−1/3); κ = 0.6: +4.7 % diameter, −30 % mass."""
    solid, hollow = (sized(OFF_SET + rule).shafts[1] for rule in ("", "[shafting]\nbore_ratio = 0.6\n"))
    assert hollow.diameter / solid.diameter == pytest.approx((1.0 - 0.6**4) ** (-1.0 / 3.0))
    assert hollow.stress == pytest.approx(solid.stress) and hollow.mass < 0.71 * solid.mass


def test_given_places_and_bearings_are_kept_and_an_overhung_wheel_bends_its_shaft_more():
    given = '[layout.output]\nlength_mm = 200\nfirst_bearing_mm = 100\nsecond_bearing_mm = 190\n' \
        '[layout.output.places."second.wheel"]\nposition_mm = 45\n'  # fmt: skip
    between, overhung = (sized(OFF_SET + rule).shafts[3] for rule in ("", given))
    assert [bearing.position for bearing in overhung.bearings] == pytest.approx([0.1, 0.19])
    assert 0.045 in overhung.diagram.position
    assert overhung.bending_moment > between.bending_moment


def test_everything_that_does_not_fit_on_a_shaft_is_named():
    wrong = "[layout.output]\nlength_mm = 50\nfirst_bearing_mm = 70\n[layout.output.places.fan]\nposition_mm = 3\n"
    with pytest.raises(DesignError) as caught:
        sized(OFF_SET + wrong)
    paths = {problem.path.removeprefix("layout.output.") for problem in caught.value.problems}
    assert paths == {"length_mm", "first_bearing_mm", "places.fan"}


def test_a_shaft_is_sized_around_its_given_bore():
    """The ring section bears what its load asks, just enough."""
    shaft = sized(SPUR + "[layout.input]\nbore_mm = 12\n").shafts[0]
    assert shaft.bore == 0.012
    assert shaft.margin == pytest.approx(1.0, abs=1e-12)
