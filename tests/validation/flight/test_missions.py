"""The shipped missions beside what is published of them."""

import numpy as np
import pytest

from gearwright.mission import fly, phase_summaries
from gearwright.sizing import size
from gearwright.spec import parse, parse_mission
from shipped_work import flown


def phase(name):
    """Return the intervals of a phase."""
    return np.array([each == name for each in flown().phase])


def test_green_taxi_leaves_the_first_stage_without_force():
    """Pulvirenti 2023, §4.2.1: the motor drives behind stage 1, whose forces are zero; 1e-9 of the cruise force."""
    cruise = np.abs(flown().meshes["first.sun-planet"].force[phase("cruise")]).max()
    assert np.abs(flown().meshes["first.sun-planet"].force[phase("taxi-out")]).max() < 1e-9 * cruise
    assert np.abs(flown().meshes["second.sun-planet"].force[phase("taxi-out")]).min() > 0.0


def test_cruise_has_the_torque_ratios_of_the_thesis():
    """Pulvirenti 2023, §4.1: T_EM about 2 T_GT, T_c1 about 6 T_GT, T_c2 above 20 T_GT.

    Tolerance 0.5 of 6: they are words for 20000/4500/1212 rpm; stage 1 alone gives T_c1 = 4.45 T_GT, and with the
    motor on the same shaft 6.45 T_GT.
    """
    k = int(np.flatnonzero(phase("cruise"))[0])
    turbine = flown().machines["gas-turbine"].power[k] / flown().nodes["input"].speed[k]
    motor = flown().machines["electric"].power[k] / flown().nodes["intermediate"].speed[k]
    output = flown().history.propeller_power[k] / flown().nodes["output"].speed[k]
    assert motor / turbine == pytest.approx(2.0, abs=0.1)
    assert flown().nodes["intermediate"].torque[k] / turbine == pytest.approx(6.0, abs=0.5)
    assert output / turbine > 20.0


def test_cruise_is_313_knots_at_mach_052():
    """Pulvirenti 2023, figure 4.1; Saint-Venant gives M 0.520 at FL250 (printed digit)."""
    assert flown().history.mach[phase("cruise")] == pytest.approx(0.520, abs=5e-4)


def test_two_planetary_stages_lose_about_half_a_percent_each_at_power():
    """Anderson and Loewenthal (1980): 0.5 to 1 % a stage with bearings; here without churning and pumps, 0.2 to 0.8 %.

    The OH-58A's whole transmission, a bevel stage, accessories and pumps more, measured 98.3 to 98.8 % (Coy,
    Mitchell and Hamrock 1987); a gear train alone must not lie below it.
    """
    cruise = next(row for row in phase_summaries(flown()) if row.name == "cruise")
    assert 0.984 < cruise.efficiency < 0.996


def test_the_regional_mission_covers_its_250_nautical_miles():
    """The distance of its name, through still air; 2 % as phases have round durations."""
    flight = flown("in-line", "regional-250nm")
    miles = (flight.history.true_airspeed * flight.history.duration).sum() / 1852.0
    assert miles == pytest.approx(250.0, rel=0.02)
    assert flight.balance.residual < 1e-6


@pytest.mark.parametrize("design", ["in-line-h1", "mixed-h1", "off-set-h1"])
def test_every_hybrid_of_the_thesis_flies_the_mission(design):
    """One mission, other trains: the energies close, and the meshes lose between 0.2 and 2 % of the work."""
    flight = flown(design)
    assert flight.balance.residual < 1e-6
    assert 0.002 < flight.balance.mesh_loss / flight.balance.propeller < 0.02


def test_a_helicopter_like_train_keeps_97_to_99_per_cent_of_its_power():
    """Measured: UH-60A 97.3 to 97.5 % (Mitchell, Oswald and Coe, NASA TP-2626), OH-58A 98.3 to 98.8 % (Coy, Mitchell
    and Hamrock 1987). Those are whole transmissions with accessories, so that the band is that of 97 to 99 %; the
    trains flown have two stages and a dry sump. Start-up at a sixth of the power is left out.
    """
    for design, mission in (("face-gear-split-torque", "rotor-schedule"), ("ec120b", "ec120b-sortie")):
        rows = phase_summaries(flown(design, mission))
        assert all(0.97 < row.efficiency < 0.99 for row in rows if row.name != "start-up")


def test_a_train_with_the_teeth_of_the_oh_58a_loses_what_was_measured():
    """Coy, Mitchell and Hamrock (1987), heat balance with eleven oils of 355 to 372 K: 98.3 to 98.8 % at 224 kW.

    The train has their tooth numbers and speeds, a spur pair in place of the bevel pair, and no accessories.
    """
    flight = fly(size(parse(OH58A_LIKE)), parse_mission(HOVER))
    assert 0.983 < phase_summaries(flight)[0].efficiency < 0.988


OH58A_LIKE = """
schema = 1
name = "Pair and planetary set with the ratio and power of the OH-58A"
level = "concept"
shafts = ["input", "intermediate", "mast"]
[turbines.engine]
shaft = "input"
power_kw = 224
speed_rpm = 6060
[propellers.rotor]
shaft = "mast"
speed_rpm = 354
diameter_m = 10.8
blades = 2
[pairs.first]
pinion = "input"
wheel = "intermediate"
pinion_teeth = 19
wheel_teeth = 71
[planetaries.second]
sun = "intermediate"
ring = "ground"
carrier = "mast"
planets = 4
sun_teeth = 27
planet_teeth = 35
"""
HOVER = """
schema = 1
name = "hover"
propeller_map = "none"
[oil]
inlet_temperature_k = 355
[phases.hover]
altitude_ft = 0
tas_kt = 0
duration_min = 10
power_kw = 224
propeller_speed_rpm = 347.5
"""
