"""Candidates of the search for teeth, listed a second time by loops; ways from the machines to the stages."""

import math

import numpy as np
import pytest

from designs import HYBRID, PAIR, changed, problem
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.sizing.rating import rating_of
from gearwright.sizing.teeth.candidates import (
    Front,
    Reach,
    StageTask,
    admissible,
    all_candidates,
    candidates,
    fewest_teeth,
    given_teeth,
    is_given,
)
from gearwright.sizing.teeth.stage import refusal
from gearwright.spec import edited, parse
from gearwright.train import targets as targets_of
from gearwright.train.kinematics import edge_of

RULES = "[teeth]\nsun_minimum = 20\nsun_maximum = 24\nplanet_minimum = 17\npinion_minimum = 19\npinion_maximum = 22\n"


def task_of(design, name):
    """Return a stage as the search sees it, without load."""
    rating = rating_of(design, name)
    return StageTask(name, design.stages[name], edge_of(name, design), name, rating, 0.0, 1.0, 1.0)


def listed(found):
    """Return parents, small and large teeth as a set of triples."""
    triples = list(zip(*(column.tolist() for column in found), strict=True))
    assert len(set(triples)) == len(triples)
    return set(triples)


def around(wanted, reach):
    """Return the whole numbers beside a wanted one: of a whole one itself and what is below."""
    low = math.ceil(wanted * (1.0 - 1e-12)) - 1
    return range(max(low + 1 - reach, 1), low + reach + 1)


@pytest.mark.parametrize("reach", [1, 4])
@pytest.mark.parametrize("given", ["", "pinion_teeth = 21\n", "wheel_teeth = 61\n"])
def test_candidates_of_a_pair_are_the_whole_numbers_beside_its_ratio(reach, given):
    design = parse(PAIR + given + RULES)
    targets = np.array([2.9, 3.0])
    front = Front({}, {"fast": np.array([1.0, 1.0])}, {}, {})
    found = listed(candidates(front, task_of(design, "stage"), design, targets, reach=Reach(reach, 59)))
    expected = set()
    for parent, target in enumerate(targets):
        for pinion in [21] if "pinion" in given else range(19, 23):
            for wheel in [61] if "wheel" in given else around(target * pinion, reach):
                expected.add((parent, pinion, wheel))
    assert found == expected


@pytest.mark.parametrize("given", ["", "sun_teeth = 22\n", "planet_teeth = 30\n", "ring_teeth = 79\n"])
def test_candidates_of_a_set_are_the_planets_beside_its_ratio(given):
    design = parse(changed(HYBRID, "planets = 3\n", f"planets = 3\n{given}") + RULES)
    targets = np.array([3.44, 3.5])
    front = Front({}, {"input": np.array([1.0, 1.0])}, {}, {})
    found = listed(candidates(front, task_of(design, "first"), design, targets, reach=Reach(1, 59)))
    expected = set()
    for parent, target in enumerate(targets):
        for sun in [22] if "sun" in given else range(20, 25):
            wanted = (79 - sun) / 2.0 if "ring" in given else (target - 1.0) / 2.0 * sun
            for planet in [30] if "planet_" in given else around(wanted, 1):
                expected.add((parent, sun, planet))
    assert found == expected


@pytest.mark.parametrize("shared", ["stage.pinion", "stage.wheel"])
def test_candidates_beside_a_gear_that_is_chosen_keep_it(shared):
    """A wheel on a chosen pinion, a pinion on a chosen wheel: the whole numbers beside it, or what is given."""
    side, other = ("pinion", "wheel") if shared == "stage.pinion" else ("wheel", "pinion")
    for given in ("", f"{other}_teeth = 33\n"):
        text = PAIR.replace('["fast", "slow"]', '["fast", "slow", "third"]')
        text += f'[pairs.next]\n{side} = "{shared}"\n{other} = "third"\n{given}'
        design = parse(text + RULES)
        chosen, targets = np.array([23, 29]), np.array([1.5, 1.7])
        front = Front({shared: chosen}, {"fast": np.array([1.0, 1.0])}, {}, {})
        found = listed(candidates(front, task_of(design, "next"), design, targets, reach=Reach(1, 59)))
        expected = set()
        for parent, (teeth, target) in enumerate(zip(chosen.tolist(), targets, strict=True)):
            for mate in [33] if given else around(teeth * target if side == "pinion" else teeth / target, 1):
                expected.add((parent, teeth, mate) if side == "pinion" else (parent, mate, teeth))
        assert found == expected


def test_all_candidates_reach_to_a_ratio_of_ten():
    design = parse(PAIR + RULES)
    found = listed(all_candidates(task_of(design, "stage"), design))
    assert found == {(0, pinion, wheel) for pinion in range(19, 23) for wheel in range(19, 221)}
    fixed = parse(PAIR + "pinion_teeth = 20\n" + RULES)
    found = listed(all_candidates(task_of(fixed, "stage"), fixed))
    assert found == {(0, 20, wheel) for wheel in range(19, 201)}
    sets = parse(HYBRID + RULES)
    found = listed(all_candidates(task_of(sets, "first"), sets))
    assert found == {(0, sun, planet) for sun in range(20, 25) for planet in range(17, 121)}
    free = parse(PAIR)
    found = listed(all_candidates(task_of(free, "stage"), free))
    most = free.teeth.pinion_maximum
    assert found == {(0, pinion, wheel) for pinion in range(18, most + 1) for wheel in range(18, 10 * most + 1)}


@pytest.mark.parametrize("hunting", [False, True])
@pytest.mark.parametrize("ring", [None, 97])
def test_sets_that_can_be_put_together_are_counted_out(hunting, ring):
    """(z_s + z_r)/n whole, tips of neighbours apart, planets not too small; hunting: no common factor in any mesh."""
    given = f"ring_teeth = {ring}\n" if ring else ""
    text = changed(HYBRID, "planets = 3\n", f"planets = 3\n{given}") + RULES
    design = parse(text + f"hunting = {str(hunting).lower()}\n")
    suns, planets = (grid.ravel() for grid in np.meshgrid(np.arange(20, 45), np.arange(10, 45)))
    found = admissible(task_of(design, "first"), design, suns, planets, planets=3)
    for sun, planet, good in zip(suns.tolist(), planets.tolist(), found.tolist(), strict=True):
        outer = sun + 2 * planet
        fits = (sun + outer) % 3 == 0 and planet >= 17
        fits = fits and (sun + planet) * math.sin(math.pi / 3) > planet + 2
        fits = fits and (ring is None or outer == ring)
        if hunting:
            fits = fits and math.gcd(sun, planet) == 1 and math.gcd(planet, outer) == 1
        assert good == fits, (sun, planet)


@pytest.mark.parametrize("hunting", [False, True])
def test_pairs_that_can_be_cut_are_counted_out(hunting):
    design = parse(PAIR + RULES + f"hunting = {str(hunting).lower()}\n")
    small, large = (grid.ravel() for grid in np.meshgrid(np.arange(15, 30), np.arange(15, 60)))
    found = admissible(task_of(design, "stage"), design, small, large, planets=1)
    for pinion, wheel, good in zip(small.tolist(), large.tolist(), found.tolist(), strict=True):
        assert good == (min(pinion, wheel) >= 19 and (not hunting or math.gcd(pinion, wheel) == 1))


def test_bevel_pinions_are_cut_by_their_virtual_teeth():
    """z_v = z_1/cos δ_1 = z_1 √(z_1² + z_2²)/z_2 against 2 h* cos β/sin² α_t."""
    text = PAIR + 'kind = "bevel"\naxis_angle_deg = 90\n[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
    design = parse(text)
    task = task_of(design, "stage")
    assert fewest_teeth(task.rating) == 8
    angle = task.rating.rules.pressure_angle
    spiral = design.pairs["stage"].spiral_angle
    transverse = math.atan(math.tan(angle) / math.cos(spiral))
    limit = 2.0 * (1.25 - 0.3 * (1.0 - math.sin(angle))) * math.cos(spiral) / math.sin(transverse) ** 2
    small, large = (grid.ravel() for grid in np.meshgrid(np.arange(6, 22), np.arange(15, 60)))
    found = admissible(task, design, small, large, planets=1)
    for pinion, wheel, good in zip(small.tolist(), large.tolist(), found.tolist(), strict=True):
        virtual = pinion * math.hypot(pinion, wheel) / wheel
        assert good == (min(pinion, wheel) >= 8 and virtual >= limit), (pinion, wheel)


@pytest.mark.parametrize(
    ("rules", "fewest"),
    [("", 18), ("profile_shift = 0.2\n", 14), ("helix_angle_deg = 20\n", 15), ("pressure_angle_deg = 25\n", 12),
     ("pressure_angle_deg = 28\n", 12)],
)  # fmt: skip
def test_fewest_teeth_are_those_of_the_rack_or_of_lewis(rules, fewest):
    """2 cos β (1 − x)/sin² α_t, at least the 12 teeth at which Lewis's table begins: 11.2 and 9.1 at 25° and 28°."""
    assert fewest_teeth(rating_of(parse(PAIR + "[gears]\n" + rules), "stage")) == fewest


def test_teeth_that_are_all_given_are_taken_as_they_are():
    text = changed(HYBRID, "planets = 3\n", "planets = 3\nsun_teeth = 24\nring_teeth = 90\n")
    text = changed(text, "planets = 5\n", "planets = 5\nplanet_teeth = 30\nring_teeth = 90\n")
    design = parse(text)
    assert all(is_given(stage) for stage in design.stages.values())
    assert given_teeth(design) == {
        "first.sun": 24, "first.planet": 33, "first.ring": 90, "second.sun": 30, "second.planet": 30, "second.ring": 90,
    }  # fmt: skip
    half = parse(changed(HYBRID, "planets = 3\n", "planets = 3\nsun_teeth = 24\n"))
    assert not is_given(half.stages["first"]) and not is_given(parse(PAIR + "wheel_teeth = 60\n").stages["stage"])
    assert given_teeth(parse(PAIR + "pinion_teeth = 21\nwheel_teeth = 60\n")) == {"stage.pinion": 21, "stage.wheel": 60}


def test_a_front_weighs_its_groups_and_takes_choices():
    front = Front(
        {"a": np.array([1, 2])}, {"s": np.array([3.0, 4.0])}, {"g": np.array([2.0, 3.0]), "h": np.array([1.0, 1.0])},
        {"g": np.array([10.0, 20.0]), "h": np.array([5.0, 7.0])},
    )  # fmt: skip
    assert front.mass.tolist() == [25.0, 67.0]
    again = front.take(np.array([1, 1, 0]))
    assert again.teeth["a"].tolist() == [2, 2, 1] and again.mass.tolist() == [67.0, 67.0, 25.0]
    assert Front({}, {}, {}, {}).mass.tolist() == [0.0]


CLUTCHED = changed(PAIR, '["fast", "slow"]', '["engine", "fast", "slow", "tail"]')
CLUTCHED = changed(CLUTCHED, 'shaft = "fast"\npower_kw', 'shaft = "engine"\npower_kw')
CLUTCHED = changed(CLUTCHED, 'shaft = "slow"\nspeed_rpm', 'shaft = "tail"\nspeed_rpm')
CLUTCHED += '[clutches.a]\ndriving = "engine"\ndriven = "fast"\nkind = "{}"\n'
CLUTCHED += '[clutches.b]\ndriving = "{}"\ndriven = "{}"\nkind = "engaged"\n'


@pytest.mark.parametrize("ends", [("slow", "tail"), ("tail", "slow")])
def test_speeds_are_known_across_clutches_both_ways(ends):
    """Only through them the stage lies between a turbine and a propeller whose speeds are given."""
    sizing = size(parse(CLUTCHED.format("overrunning", *ends)))
    assert sizing.teeth == size(parse(PAIR)).teeth
    speeds = sizing.flows["rated"].speeds
    assert (speeds["engine"], speeds["slow"]) == pytest.approx((speeds["fast"], speeds["tail"]))
    assert abs(speeds["slow"] / speeds["fast"]) == pytest.approx(1.0 / 3.0, rel=0.025)


@pytest.mark.parametrize("planets", [3, 4, 5, 6, 7, 8])
def test_the_planets_that_do_fit_are_counted_by_trying(planets):
    """All suns from 18 to 59 with both planets beside the ratio, in order of the number of planets."""
    text = changed(changed(HYBRID, "speed_rpm = 1212", "speed_rpm = 900"), "planets = 5", f"planets = {planets}")
    design = parse(text + "[teeth]\nsun_maximum = 59\n")
    rules, ratio = design.teeth, 4500 / 900

    def fits(count, assembled):
        for sun in range(rules.sun_minimum, rules.sun_maximum + 1):
            for planet in (math.floor((ratio - 2.0) / 2.0 * sun), math.floor((ratio - 2.0) / 2.0 * sun) + 1):
                near = abs((2.0 + 2.0 * planet / sun) / ratio - 1.0) <= rules.stage_tolerance
                clear = (sun + planet) * math.sin(math.pi / count) > planet + 2 if count > 1 else True
                whole = not assembled or (2 * sun + 2 * planet) % count == 0
                if near and clear and whole and planet >= rules.planet_minimum:
                    return True
        return False

    error = refusal("second", design.stages["second"], design, ratio - 1.0, fewest=18, nominal=targets_of(design))
    (found,) = error.problems
    most = max((count for count in range(1, planets) if fits(count, True)), default=0)
    why = "cannot be assembled" if fits(planets, False) else "do not fit"
    assert found.message == f"{planets} planets {why} at ratio 5; at most {most}"


def test_the_range_of_ratios_is_that_of_the_limits():
    """2 + 2 z_p/z_s at the least."""
    text = changed(HYBRID, "speed_rpm = 4500", "speed_rpm = 19000")
    found = problem(text + "[teeth]\nsun_maximum = 50\nplanet_minimum = 15\n", sized=True)
    assert found.message.startswith(
        "1 + z_r/z_s = 1.053 is below 2.6, the least with suns of up to 50 teeth and planets"
    )


def test_the_bodies_of_a_choice_weigh_what_the_gears_do():
    """Search and sizing agree: of two designs with given teeth the one that the free search takes is the lighter."""
    free = size(parse(PAIR + "[teeth]\npinion_maximum = 24\n"))
    masses = {}
    for pinion in range(18, 25):
        for wheel in around(3.0 * pinion, 1):
            if abs(wheel / pinion / 3.0 - 1.0) <= 0.025:
                given = {"pairs.stage.pinion_teeth": pinion, "pairs.stage.wheel_teeth": wheel}
                masses[pinion, wheel] = size(edited(free.design, given)).gear_mass
    assert free.gear_mass == pytest.approx(min(masses.values()), rel=1e-9)


def test_what_nothing_reaches_asks_for_its_teeth():
    with pytest.raises(DesignError):
        size(parse(CLUTCHED.format("open", "slow", "tail")))
