"""Choices by hand: which teeth can be made, how many planets, which machines drive, which case presses films."""

import cmath
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from designs import HYBRID, ONE_SET, PAIR
from gearwright.parts.gears import ToothShift
from gearwright.parts.planetary import _least_gap
from gearwright.sizing import size
from gearwright.sizing.rating import rating_of
from gearwright.sizing.teeth.candidates import Ban, Front, StageTask, admissible, fewest_teeth
from gearwright.sizing.teeth.criteria import _distinct, weigh
from gearwright.sizing.teeth.stage import weighed_front
from gearwright.spec import parse
from gearwright.spec.design import StageShifts
from gearwright.train import targets
from gearwright.train.kinematics import edge_of
from gearwright.train.load_case import _may_drive

SET = (
    ONE_SET.format(speed=1200)
    + 'sun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = 3\nsun_teeth = 30\nplanet_teeth = 45\n'
    + 'module_mm = 3\nface_width_mm = 40\n[planetaries.set.planet_bearing]\nkind = "plain"\n'
    + "least_film_um = 0.5\nlargest_pressure_mpa = 50\n"
)


def task_of(name, text):
    """Return a stage of the search at 100 N m."""
    design = parse(text)
    edge = edge_of(name, design)
    speed = targets(design).speeds[edge.fast[0]]
    stage = design.simple_stages[name]
    return StageTask(name, stage, edge, name, rating_of(design, name), 100.0, speed, speed), design


def test_a_wheel_that_is_shifted_outwards_may_have_fewer_teeth():
    """z ≥ 2 (1 − x)/sin² 20°: 17.1 for x = 0 and 13.7 for x = 0.2."""
    task, design = task_of("stage", PAIR)
    shifts = StageShifts((ToothShift(0.0), ToothShift(0.2)))
    task = replace(task, rating=replace(task.rating, shifts=shifts))
    assert (fewest_teeth(task.rating), fewest_teeth(task.rating, 1)) == (18, 14)
    small, large = np.array([17, 18, 18, 18]), np.array([60, 13, 14, 60])
    assert admissible(task, design, small, large, planets=1).tolist() == [False, False, True, True]


@pytest.mark.parametrize("hunting", [True, False])
def test_hunting_teeth_have_no_common_factor(hunting):
    task, design = task_of("stage", PAIR + f"[teeth]\nhunting = {str(hunting).lower()}\n")
    small, large = np.array([20, 20, 21]), np.array([60, 61, 63])
    assert admissible(task, design, small, large, planets=1).tolist() == [not hunting, True, not hunting]


def test_every_number_of_planets_that_can_be_put_in_weighs_its_own():
    """z_s + z_r a multiple of N: teeth 24/36/96 take 2, 3, 4, 5, 6; 25/36/97 take 2 alone. In the order of teeth."""
    task, design = task_of("first", HYBRID.replace("planets = 3\n", "") + "[teeth]\nplanets_maximum = 5\n")
    small, large = np.array([24, 25, 24]), np.array([36, 36, 33])
    front = Front({}, {task.edge.fast[0]: np.full(3, task.speed)}, {}, {})
    whole = weighed_front(front, task, design, small, large)
    expected = []
    for planets in (2, 3, 4, 5):
        fits = admissible(task, design, small, large, planets=planets)
        for k in np.flatnonzero(fits):
            alone = Front({}, {task.edge.fast[0]: np.full(1, task.speed)}, {}, {})
            mass = weigh(alone, task, small[k : k + 1], large[k : k + 1], planets=planets).mass.item()
            expected.append((int(k), planets, pytest.approx(mass, rel=1e-12)))
    expected.sort(key=lambda entry: entry[:2])
    assert {planets for _, planets, _ in expected} == {2, 3, 4} and len(expected) < 12
    teeth = list(zip(small[[k for k, *_ in expected]].tolist(), (planets for _, planets, _ in expected), strict=True))
    assert list(zip(whole.teeth["first.sun"].tolist(), whole.planets["first"].tolist(), strict=True)) == teeth
    assert whole.mass.tolist() == [mass for *_, mass in expected]


def test_bans_of_one_name_and_factor_are_kept_once():
    band, other = SimpleNamespace(), SimpleNamespace()
    bans = [Ban("a", band, 1.0), Ban("a", band, 1.0), Ban("a", band, 2.0), Ban("b", other, 1.0), Ban("b", other, 1.0)]
    assert [(ban.name, ban.factor) for ban in _distinct(bans)] == [("a", 1.0), ("a", 2.0), ("b", 1.0)]
    assert _distinct([]) == ()


@pytest.mark.parametrize(
    ("stated", "power", "torque", "drives"),
    [
        (False, None, None, True), (True, None, None, False), (True, 5e3, None, True), (True, -5e3, None, False),
        (True, None, 7.0, True), (True, None, -7.0, False), (True, 0.0, 0.0, False),
    ],
)  # fmt: skip
def test_a_machine_may_drive_that_balances_or_gives_power_or_torque(stated, power, torque, drives):
    assert _may_drive(SimpleNamespace(stated=stated, power=power, torque=torque)) is drives


@pytest.mark.parametrize("order", [("climb", "cruise"), ("cruise", "climb")])
def test_a_film_is_pressed_the_most_in_the_case_of_the_largest_load(order):
    """500 kW against 300 kW, whichever stands first; the film alone in the heavier case is pressed as hard."""
    powers = {"climb": 500, "cruise": 300}
    cases = "".join(f"[cases.{name}]\nshare = 0.5\nturbine.power_kw = {powers[name]}\n" for name in order)
    both, alone = (
        next(check for check in size(parse(SET + text)).checks if check.mode == "film pressure")
        for text in (cases, "[cases.climb]\nshare = 1\nturbine.power_kw = 500\n")
    )
    assert both.case == "climb" and both.value == pytest.approx(alone.value, rel=1e-9)


@pytest.mark.parametrize("pair", [("a", "b"), ("b", "a")])
def test_planets_that_mesh_may_touch_in_their_set_but_not_in_the_next(pair):
    """Pins at 100 and 150 mm, 20° apart, three sets: the nearest others are 100° and 140° off."""
    radii, angles, tips = {"p": 0.10, "q": 0.15}, {"p": 0.0, "q": math.radians(20.0)}, {"a": 0.03, "b": 0.04}
    compound = SimpleNamespace(bodies={"a": "p", "b": "q"}, between=[("a", "b")], sets=3)
    apart = [abs(0.10 - cmath.rect(0.15, math.radians(angle))) for angle in (140.0, 260.0)]
    assert _least_gap(compound, radii, angles, pair, tips) == pytest.approx(min(apart) - 0.07, rel=1e-12)
    free = SimpleNamespace(bodies=compound.bodies, between=[], sets=3)
    within = abs(0.10 - cmath.rect(0.15, math.radians(20.0)))
    assert _least_gap(free, radii, angles, pair, tips) == pytest.approx(within - 0.07, rel=1e-12)


def test_one_set_of_planets_on_one_pin_has_no_gap():
    compound = SimpleNamespace(bodies={"a": "p", "b": "p"}, between=[], sets=1)
    assert _least_gap(compound, {"p": 0.1}, {"p": 0.0}, ("a", "b"), {"a": 0.03, "b": 0.04}) == math.inf
