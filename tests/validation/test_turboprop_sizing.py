"""In-Line, In-Line hybrid 2 and Off-Set gearboxes of the thesis: torques, teeth, masses.

Reference: Pulvirenti 2023, chapter 2, with the corrected equations (cube roots in 2.1 and 2.2, torque of the second sun
from T_GT τ_1 + T_EM), 2051 kW, 20 000 to 1212 rpm, R_p0.2 = 785 MPa, HB 600, factors 2.5 and 1.5.
"""

import math

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read
from gearwright.units import RPM

ONE_PER_CENT = 0.01
"""The reference rounds its masses to 0.1 kg and its tooth factors to three digits."""
FOUR_DIGITS = 1e-4
"""The reference torques are printed with four digits."""


@pytest.fixture(scope="module")
def hybrid():
    return size(read(shipped_design("in-line-h2")))


@pytest.fixture(scope="module")
def conventional():
    return size(read(shipped_design("in-line")))


def test_machine_torques_of_the_hybrid(hybrid):
    torque = {machine.name: machine.torque for machine in hybrid.machines}
    assert torque["gas-turbine"] == pytest.approx(499.4, rel=FOUR_DIGITS)
    assert torque["electric"] == pytest.approx(2132.7, rel=FOUR_DIGITS)


def test_the_second_sun_carries_turbine_and_motor(hybrid):
    """T_s2 = T_GT τ_1 + T_EM = 4352 N m, with τ_1 = 20 000/4500 met exactly by 54 and 186 teeth."""
    flow = hybrid.flows["rated"]
    assert abs(flow.meshes["second.sun-planet"].torques[0]) == pytest.approx(4352, rel=FOUR_DIGITS)


def test_the_propeller_torque_is_the_power_over_its_speed(hybrid):
    """16 160 N m belongs to the nominal 1212 rpm; the chosen teeth turn the propeller at 1221.4 rpm."""
    flow = hybrid.flows["rated"]
    speed = flow.speeds["output"]
    assert speed / RPM == pytest.approx(1221.4, rel=FOUR_DIGITS)
    assert abs(flow.machine_torques["propeller"]) * abs(speed) / (1212 * RPM) == pytest.approx(16_160, rel=FOUR_DIGITS)


@pytest.mark.parametrize(
    ("name", "teeth", "gears"),
    [
        ("in-line-h2", (54, 66, 186, 57, 48, 153), 34.0),
        ("in-line", (59, 61, 181, 57, 58, 173), 40.4),
    ],
)
def test_teeth_and_gear_mass_of_the_in_line_boxes(name, teeth, gears):
    sizing = size(read(shipped_design(name)))
    parts = [f"{stage}.{part}" for stage in ("first", "second") for part in ("sun", "planet", "ring")]
    assert tuple(sizing.teeth[part] for part in parts) == teeth
    assert sizing.gear_mass == pytest.approx(gears, rel=ONE_PER_CENT)


def test_teeth_and_gear_mass_of_the_off_set_box():
    """15/61, 15/61; 176.7 kg with α and cos β as the thesis prints them."""
    sizing = size(read(shipped_design("off-set")))
    assert set(sizing.teeth.values()) == {15, 61}
    assert sizing.gear_mass == pytest.approx(176.7, rel=ONE_PER_CENT)


@pytest.mark.parametrize(("name", "published"), [("in-line-h2", 8.8), ("in-line", 9.5)])
def test_shafts_and_carriers_weigh_what_the_stand_in_rules_give(name, published):
    """Within 20 % to the pins' outer edge, where those rules end: our plates bear T_c as torsion at their hub, too.

    The metal outside the pins, which lets them be pressed in, makes that 29 % of In-Line, whose planets swing most.
    """
    sizing = size(read(shipped_design(name)))
    whole, steel = sizing.shaft_mass + sizing.carrier_mass, sizing.design.shaft_material
    eyes = sum(
        sizing.design.carriers.fill * math.pi * steel.density * one.plate_thickness
        * (one.reach**2 - (one.reach - one.eye_wall) ** 2)
        for one in sizing.carriers
    )  # fmt: skip
    assert published < whole - eyes == pytest.approx(published, rel=0.20)
    assert whole == pytest.approx(published, rel=0.29)


def test_assembly_and_clearance_hold_for_the_chosen_teeth(hybrid, conventional):
    """(z_s + z_r)/N is whole, and (z_s + z_p) sin(π/N) > z_p + 2."""
    for sizing in (hybrid, conventional):
        for stage, planetary in sizing.design.planetaries.items():
            sun, planet, ring = (sizing.teeth[f"{stage}.{part}"] for part in ("sun", "planet", "ring"))
            assert (sun + ring) % planetary.planets == 0
            assert (sun + planet) * math.sin(math.pi / planetary.planets) > planet + 2
            assert sun + 2 * planet == ring


def test_continuous_modules_leave_no_reserve(hybrid):
    """Modules are the largest that bending or contact asks for, so that the governing margin is one; rounding only."""
    margins = [min(mesh.bending_margin, mesh.contact_margin) for mesh in hybrid.meshes]
    assert min(margins) == pytest.approx(1.0, rel=1e-9)
    assert hybrid.worst_margin == pytest.approx(1.0, rel=1e-9)
