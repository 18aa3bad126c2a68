"""Rotors with consistent mass against closed forms: beams, rods, Jeffcott, whirl, instability, gears that roll."""

import math

import numpy as np
import pytest

from gearwright.dynamics import Model, campbell, frequency_response, modes, simulate, statics
from gearwright.dynamics.model import (
    Bearing,
    Disc,
    GearContact,
    Line,
    Rotor,
    Segment,
    add_bearing,
    add_gear_contact,
    add_rotor,
)
from gearwright.errors import DesignError, SolveError
from gearwright.validate.shafts import shaft_whirl as whirl, timoshenko_frequency

LENGTH, DIAMETER = 0.25, 0.05
WALL = 1e15
"""Stiffness that holds an end [N/m]: it gives way by 2e-7 of what the shaft does."""


def equal(count, length=LENGTH, diameter=DIAMETER):
    return Rotor([Segment(length / count, diameter)] * count)


def in_walls(count, speed=None):
    model = Model()
    rotor = equal(count)
    shaft = add_rotor(model, "shaft", rotor, speed=speed)
    for station in (0, count):
        for axis in ("x", "y"):
            model.add(Line(f"wall {station} {axis}", shaft.at(station)[axis], WALL, kind="support"))
    return model.build()


def test_bending_frequencies_converge_to_timoshenkos_from_above_with_the_square_of_the_length():
    """A consistent mass bounds from above; shear that is constant along an element costs the square of its length."""
    exact = timoshenko_frequency(Segment(LENGTH, DIAMETER), LENGTH, 1)
    errors = []
    for count in (4, 8, 16):
        frequency = modes(in_walls(count)).frequency
        errors.append(float(frequency[np.argmin(np.abs(frequency - exact))] / exact - 1.0))
    assert min(errors) > 0.0
    assert [errors[0] / errors[1], errors[1] / errors[2]] == pytest.approx([4.0, 4.0], rel=0.12)
    assert errors[2] < 1.2e-4


def test_a_free_rod_twists_and_stretches_as_dalembert_says():
    """f = √(G/ρ)/(2 L) and √(E/ρ)/(2 L); linear elements are too stiff by (n π h)²/24 of the frequency."""
    model, part = Model(), Segment(1.0 / 20, 0.1)
    shaft = add_rotor(model, "rod", Rotor([part] * 20))
    model.add(Line("weak", shaft.at(0)["x"], 1e-3, kind="support"))
    frequency = modes(model.build()).frequency
    for modulus in (part.shear_modulus, part.elasticity):
        exact = math.sqrt(modulus / part.density) / 2.0 * (1.0 + (math.pi / 20) ** 2 / 24.0)
        assert np.min(np.abs(frequency / exact - 1.0)) < 1e-5


def test_a_spinning_shaft_whirls_as_timoshenkos_beam():
    backward, forward = whirl(Segment(LENGTH, DIAMETER), LENGTH, 20000.0)
    diagram = campbell(in_walls(8, speed=20000.0), [0.999, 1.0])
    for exact, sign in ((backward, -1.0), (forward, 1.0)):
        place = int(np.argmin(np.abs(diagram.frequency[-1] / exact - 1.0)))
        assert diagram.frequency[-1, place] == pytest.approx(exact, rel=6e-4)
        assert math.copysign(1.0, diagram.whirl[-1, place]) == sign


def test_whirl_is_the_slope_of_the_frequency_over_the_speed():
    """dω/ω over dΩ/Ω by central differences of the diagram itself."""
    diagram = campbell(in_walls(4, speed=20000.0), [0.99, 1.0, 1.01])
    slope = (diagram.frequency[2] - diagram.frequency[0]) / (0.02 * diagram.frequency[1])
    np.testing.assert_allclose(diagram.whirl[1], slope, rtol=2e-3, atol=1e-6)


def test_a_jeffcott_rotor_turns_critical_at_the_root_of_stiffness_over_mass():
    """ω² = 48 E I/(L³ m) of a slender shaft without mass; its bearings' damping at a rigid mode: ζ = c/(2 √(k m))."""
    part = Segment(0.5, 0.01, density=1.0)
    rotor = Rotor([part, part], {1: Disc(10.0, 1e-9, 2e-9)})
    model = Model()
    shaft = add_rotor(model, "jeffcott", rotor)
    for station in (0, 2):
        add_bearing(model, f"bearing {station}", shaft.at(station), Bearing((1e12, 1e12)))
    exact = math.sqrt(48.0 * part.elasticity * part.second_moment / 10.0) / (2.0 * math.pi)
    found = modes(model.build()).frequency
    assert np.min(np.abs(found / exact - 1.0)) < 5e-4  # shear gives way by 12 E I/(κ G A L²)


@pytest.mark.parametrize(("share", "stable"), [(0.99, True), (1.01, False)])
def test_cross_coupling_drives_a_rigid_rotor_beyond_its_damping(share, stable):
    """m λ² + c λ + k ∓ i k_xy = 0 loses stability at k_xy = c √(k/m)."""
    stiffness, damping = 2e6, 400.0
    rotor = Rotor([Segment(0.1, 0.08)] * 2)
    onset = damping * math.sqrt(3.0 * stiffness / rotor.mass)
    model = Model()
    shaft = add_rotor(model, "stiff", rotor, speed=100.0, highest=1.0)
    cross = share * onset
    bearing = Bearing((stiffness,) * 2, (cross, -cross), damping=(damping,) * 2)
    for station in (0, 1, 2):
        add_bearing(model, f"bearing {station}", shaft.at(station), bearing)
    diagram = campbell(model.build(), [0.999, 1.0])
    assert (float(np.min(diagram.damping[-1])) > 0.0) is stable


def test_unequal_cross_terms_are_refused_where_they_have_no_potential():
    model = Model()
    shaft = add_rotor(model, "shaft", equal(2), speed=10.0)
    for station in (0, 2):
        add_bearing(model, f"bearing {station}", shaft.at(station), Bearing((1e8, 1e8), (1e6, -1e6)))
    system = model.build()
    for verb in (statics, lambda one: simulate(one, 1e-4)):
        with pytest.raises(SolveError, match="unequal cross terms"):
            verb(system)


def test_equal_cross_terms_act_along_principal_axes():
    """K = [[k, q], [q, k]]: springs k ± q under 45°, so a rigid mass has √((k ± q)/m)."""
    model = Model()
    rotor = Rotor([Segment(0.1, 0.08)] * 2)
    shaft = add_rotor(model, "stiff", rotor, highest=1.0)
    for station in (0, 2):
        add_bearing(model, f"bearing {station}", shaft.at(station), Bearing((1e6, 1e6), (4e5, 4e5)))
    found = modes(model.build()).frequency
    for principal in (6e5, 1.4e6):
        exact = math.sqrt(2.0 * principal / rotor.mass) / (2.0 * math.pi)
        assert np.min(np.abs(found / exact - 1.0)) < 1e-9


CONTACTS = [
    GearContact((0.1, 0.25), math.radians(20.0)),
    GearContact((0.1, 0.25), math.radians(22.0), helix_angle=math.radians(-18.0), place=0.7, sense=-1),
    GearContact((0.1, -0.25), math.radians(20.0), helix_angle=math.radians(12.0), place=-2.0),
]


@pytest.mark.parametrize("contact", CONTACTS)
def test_gears_that_move_as_one_body_or_roll_do_not_press(contact):
    """Shifts and turns of both gears with their common housing, and pure rolling, stretch no line of action."""
    first, second = contact.levers()
    centre = (contact.radii[0] + contact.radii[1]) * np.array([math.cos(contact.place), math.sin(contact.place), 0.0])
    for axis in np.eye(3):
        assert (first[:3] + second[:3]) @ axis == pytest.approx(0.0, abs=1e-15)
        about_first = first[3:] @ axis + second[3:] @ axis + second[:3] @ np.cross(axis, centre)
        assert about_first == pytest.approx(0.0, abs=1e-15)
    assert first[5] / contact.radii[0] - second[5] / contact.radii[1] == pytest.approx(0.0, abs=1e-15)
    assert abs(first[5]) < abs(contact.radii[0]) * math.cos(contact.pressure_angle) + 1e-15


def test_a_helical_pair_presses_along_its_axis_by_the_tangent_of_the_helix():
    """F_a = F_t tan β, F_r = F_t tan α_t at the working pitch circle (ISO 21771)."""
    contact = GearContact((0.1, 0.25), math.radians(21.0), helix_angle=math.radians(15.0))
    push = contact.direction()
    assert push[2] / push[1] == pytest.approx(-math.tan(math.radians(15.0)), rel=1e-12)
    assert push[0] / push[1] == pytest.approx(math.tan(math.radians(21.0)), rel=1e-12)


def geared(highest=None, stiffness=2e8):
    """Two shafts in bearings, geared; torques in balance."""
    model = Model()
    gear = (Disc(5.0, 0.012, 0.024), Disc(20.0, 0.3, 0.6))
    names, contact = ("pinion", "wheel"), CONTACTS[1]
    placed = [
        add_rotor(model, name, Rotor([Segment(0.1, 0.05)] * 4, {2: disc}), highest=highest,
                  speed=(100.0, -40.0)[number])
        for number, (name, disc) in enumerate(zip(names, gear, strict=True))
    ]  # fmt: skip
    for name, shaft in zip(names, placed, strict=True):
        for station in (0, 4):
            axial = (1e8, 0.0) if station == 0 else (0.0, 0.0)
            add_bearing(model, f"{name} {station}", shaft.at(station), Bearing((2e8, 1e8), axial=axial))
    add_gear_contact(model, "mesh", (placed[0].at(2), placed[1].at(2)), contact, stiffness=stiffness)
    lever = contact.levers()[0][5]
    model.load("pinion", constant=100.0 if lever > 0.0 else -100.0)
    model.load("wheel", constant=(100.0 if lever > 0.0 else -100.0) * 0.25 / 0.1)
    return model.build(), lever


def test_statics_of_geared_rotors_transmit_the_torque():
    system, lever = geared()
    still = statics(system)
    assert still.force[system.labels.lines.index("mesh")] == pytest.approx(100.0 / abs(lever), rel=1e-9)


def test_geared_rotors_have_modes_between_those_of_shafts_alone_and_of_rigid_teeth():
    """Rayleigh: frequencies rise with the mesh stiffness, and each lies below the next one of the uncoupled system."""
    soft, usual, stiff = (modes(geared(stiffness=value)[0]).frequency for value in (1e2, 2e8, 1e13))
    count = len(usual) - 1
    assert np.all(soft <= usual * (1.0 + 1e-9))
    assert np.all(usual <= stiff * (1.0 + 1e-9))
    assert np.all(usual[:count] <= soft[1:] * (1.0 + 1e-6) + 1e-3)


def test_free_modes_above_the_range_may_be_left_out():
    whole, part = (modes(geared(highest)[0]).frequency for highest in (None, 30000.0))
    assert len(part) < len(whole)
    low = whole[(whole > 0.0) & (whole < 1500.0)]
    np.testing.assert_allclose(part[np.argmin(np.abs(part[:, None] - low), axis=0)], low, rtol=5e-3)


def test_geared_rotors_run_and_answer():
    """The line of many weights goes through the compiled run and the frequency response alike."""
    system, _ = geared(highest=5000.0)
    answer = frequency_response(system, [100.0, 200.0], errors={"mesh": 1e-6})
    assert np.all(np.abs(answer.force("mesh")) > 0.0)
    trace = simulate(system, 2e-4)
    assert all(np.isfinite(value) for value in trace.force.of("mesh").values())


@pytest.mark.parametrize(
    ("rotor", "message"),
    [
        (Rotor([]), "there is none; give the stretches of the shaft"),
        (Rotor([Segment(0.0, 0.1)]), "a segment needs length"),
        (Rotor([Segment(0.1, 0.1, bore=0.2)]), "a segment needs length"),
        (Rotor([Segment(math.nan, 0.1)]), "a segment needs length"),
        (Rotor([Segment(0.1, 0.1)], {3: Disc(1.0, 1.0, 1.0)}), "no such station; they count from 0 to 1"),
        (Rotor([Segment(0.1, 0.1)], {0: Disc(-1.0, 1.0, 1.0)}), "not negative"),
    ],
)
def test_impossible_rotors_are_refused(rotor, message):
    with pytest.raises(DesignError, match=message):
        add_rotor(Model(), "rotor", rotor)


@pytest.mark.parametrize(
    ("bearing", "message"),
    [
        (Bearing((1e6, 1e6), (2e6, 2e6)), "smallest principal stiffness"),
        (Bearing((1e6, 1e6), damping=(-1.0, 0.0)), "smallest principal damping"),
        (Bearing((math.inf, 1e6)), "every coefficient must be finite"),
        (Bearing((1e6, 1e6), axial=(-1.0, 0.0)), "along or against tilting"),
    ],
)
def test_impossible_bearings_are_refused(bearing, message):
    model = Model()
    shaft = add_rotor(model, "rotor", equal(2))
    with pytest.raises(DesignError, match=message):
        add_bearing(model, "bearing", shaft.at(0), bearing)


def test_a_place_that_a_rotor_does_not_have_is_refused():
    shaft = add_rotor(Model(), "rotor", equal(2))
    with pytest.raises(DesignError, match="there is no place of rotor '7'"):
        shaft.at(7)
