"""A main gearbox of the UH-60's class whose tail rotor has a demand: the take-off is sized for it, not for a guess.

Reference: 350 kW at 4115 rpm want about 45 kg of bevel gears from a collector of 784 rpm, 20/105 teeth; where no case
said what the tail rotor takes, equilibrium left it 2525 of 3000 kW, and its gears weighed 235 kg. Tooth numbers are
searched between 17 and 25 for the pinions.
"""

import pytest

from designs import changed, problem
from gearwright.sizing import size
from gearwright.spec import parse

TRAIN = """\
schema = 1
name = "main gearbox of the UH-60's class"
level = "concept"
shafts = ["engine-1", "engine-2", "quill-1", "quill-2", "collector", "main", "tail"]
[turbines]
t700-1 = { shaft = "engine-1", power_kw = 1500, speed_rpm = 20900, limits.one-out = { power_kw = 1800 } }
t700-2 = { shaft = "engine-2", power_kw = 1500, speed_rpm = 20900 }
[rotors]
main-rotor = { shaft = "main", speed_rpm = 258, diameter_m = 16.36, thrust_kn = 98, hub_moment_nm = 20000 }
tail-rotor = { shaft = "tail", speed_rpm = 4115, diameter_m = 3.35 }
[pairs]
input-1 = { kind = "bevel", axis_angle_deg = 90, spiral_angle_deg = 35, pinion = "engine-1", wheel = "quill-1" }
input-2 = { kind = "bevel", axis_angle_deg = 90, spiral_angle_deg = 35, pinion = "engine-2", wheel = "quill-2" }
combining = { kind = "bevel", axis_angle_deg = 90, spiral_angle_deg = 35, pinion = ["quill-1", "quill-2"], \
wheel = "collector" }
tail-take-off = { kind = "bevel", axis_angle_deg = 90, spiral_angle_deg = 35, pinion = "tail", wheel = "collector" }
[planetaries]
main = { sun = "collector", ring = "ground", carrier = "main", planets = 5 }
[gears]
rating = "iso6336"
material = "carburised-9310"
web_ratio = 0.5
[teeth]
pinion_minimum = 17
pinion_maximum = 25
"""
CASES = """\
[cases.hover]
share = 0.99
t700-1.rating = 1
t700-2.rating = 1
tail-rotor.power_kw = -350
[cases.one-engine-out]
share = 0.01
t700-1.power_kw = 1800
tail-rotor.power_kw = -250
"""


SLOW = changed(TRAIN, 'pinion = "tail"', 'pinion = "tail", pinion_teeth = 20, wheel_teeth = 105')
"""The collector turns at 784 rpm, as the ratio of the take-off says."""


def take_off(sizing):
    """Return the mass of the take-off's gears [kg]."""
    return sum(gear.mass for gear in sizing.gears if gear.stage == "tail-take-off")


def test_the_tail_take_off_is_sized_for_what_the_tail_rotor_takes():
    """45 kg, as told, with the least module that bears the load; the lightest gears have a larger one, narrower faces,
    and weigh 42 kg; 2 kg for what a change of the rating's factors may make of it."""
    sizing = size(parse(SLOW + CASES))
    assert take_off(sizing) == pytest.approx(42.0, abs=2.0)
    for case, taken in (("hover", 350e3), ("one-engine-out", 250e3)):
        flow = sizing.flows[case]
        assert flow.machine_powers["tail-rotor"] == pytest.approx(-taken, rel=1e-12)
        assert flow.residual < 1e-12
    assert sizing.flows["hover"].machine_powers["main-rotor"] == pytest.approx(-2650e3, rel=1e-12)


def test_equal_parts_of_the_ratio_turn_the_collector_faster_and_make_the_take_off_lighter():
    """From an engine to the main rotor, three stages take equal parts of 20900/258: the collector turns at 1116 rpm.

    By hand: ∛81.0 = 4.327 each, 258 rpm · 4.327 = 1116 rpm, 4115/1116 = 3.69. A pinion of the same torque and teeth
    stays as large, and a wheel's mass goes with the square of its ratio: (3.70/5.25)² = 0.50 of 45 kg, 22 kg; 5 kg for
    whole millimetres of face width. It was 784 rpm where the shafts of two equal inputs were asked unequal speeds.
    """
    equal, slow = size(parse(TRAIN + CASES)), size(parse(SLOW + CASES))
    flow = equal.flows["hover"]
    assert flow.speeds["collector"] / flow.speeds["main"] == pytest.approx((20900 / 258) ** (1 / 3), rel=0.025)
    assert equal.teeth["tail-take-off.pinion"] == 20
    ratios = [sizing.teeth["tail-take-off.wheel"] / sizing.teeth["tail-take-off.pinion"] for sizing in (equal, slow)]
    assert take_off(equal) == pytest.approx((ratios[0] / ratios[1]) ** 2 * take_off(slow), abs=5.0)
    assert equal.gear_mass < slow.gear_mass


def test_two_rotors_without_a_demand_are_refused():
    """No split of the power is guessed; the message names both rotors and shows what to write."""
    found = problem(TRAIN, sized=True)
    assert found.path == "cases.rated"
    assert found.message.startswith("main-rotor and tail-rotor both balance one branch")
