"""What stages that are still to come weigh at the least, for teeth that are given: then nothing is left to bound."""

import math

import numpy as np
import pytest

from gearwright.sizing.rating import rating_of
from gearwright.sizing.teeth.candidates import Front, StageTask, admissible, planet_counts
from gearwright.sizing.teeth.criteria import weigh
from gearwright.sizing.teeth.search import STEP, Branch, _branch, _of_variant, branches_of, rest_of
from gearwright.sizing.teeth.stage import tooth_ratio
from gearwright.spec import parse
from gearwright.train import targets
from gearwright.train.kinematics import edge_of

CHAIN = """\
schema = 1
name = "three pairs in a row"
level = "concept"
shafts = ["fast", "second", "third", "slow"]
[turbines.turbine]
shaft = "fast"
power_kw = 100
speed_rpm = 9600
[propellers.propeller]
shaft = "slow"
speed_rpm = 1200
diameter_m = 2
"""
PAIRS = {"first": ("fast", "second", 20, 40), "second": ("second", "third", 25, 50), "third": ("third", "slow", 30, 60)}
TABLES = "".join(
    f'[pairs.{name}]\npinion = "{fast}"\nwheel = "{slow}"\npinion_teeth = {small}\nwheel_teeth = {large}\n'
    for name, (fast, slow, small, large) in PAIRS.items()
)
DESIGN = parse(CHAIN + TABLES)
TORQUES = {"first": 100.0, "second": 200.0, "third": 400.0}


def task_of(name, design=DESIGN):
    """Return a stage of the search at its nominal torque and speed."""
    edge = edge_of(name, design)
    speed = targets(design).speeds[edge.fast[0]]
    return StageTask(name, design.pairs[name], edge, name, rating_of(design, name), TORQUES[name], speed, speed)


def weight(name, speed, design=DESIGN):
    """Return what the gears of a stage weigh whose fast shaft turns at a speed [kg]."""
    task, (_, _, small, large) = task_of(name, design), PAIRS[name]
    front = Front({}, {task.edge.fast[0]: np.array([speed])}, {}, {})
    return weigh(front, task, np.array([small]), np.array([large]), planets=1).mass.item()


def lightest(branch, speed):
    return branch.at(np.array([speed])).item()


def test_gears_weigh_by_their_torque_which_is_less_where_the_shaft_turns_faster():
    assert weight("first", 1010.0) * 1010.0 == pytest.approx(weight("first", 1005.0) * 1005.0, rel=1e-12)


def test_the_last_stage_weighs_at_the_least_what_it_does_at_the_faster_end_of_a_step():
    """Given teeth weigh m ∝ 1/ω: within a step of the table, and the one before it, less by no more than two steps."""
    task, nominal = task_of("third"), targets(DESIGN)
    branch = _branch(task, "third", DESIGN, nominal, [])
    for factor in (1.0, 0.995, 1.013):
        speed = factor * nominal.speeds["third"]
        exact = weight("third", speed)
        assert exact * math.exp(-2.001 * STEP) <= lightest(branch, speed) <= exact
    assert branch.source == "third" and branch.nominal == nominal.speeds["third"]


def test_driven_from_its_slow_side_a_stage_turns_faster_by_its_teeth():
    """The propeller's shaft is known: 60/30 of its speed is the pinion's, which the weight goes by."""
    nominal = targets(DESIGN)
    branch = _branch(task_of("third"), "slow", DESIGN, nominal, [])
    for factor in (1.0, 0.99):
        exact = weight("third", 2.0 * factor * nominal.speeds["slow"])
        assert exact * math.exp(-2.001 * STEP) <= lightest(branch, factor * nominal.speeds["slow"]) <= exact


@pytest.mark.parametrize(
    ("known", "order"), [("fast", ("first", "second", "third")), ("slow", ("third", "second", "first"))]
)
def test_a_chain_weighs_what_its_stages_do_at_the_speeds_that_teeth_pass_on(known, order):
    """From either end, each stage at 1/2 or twice the speed of the one before; three tables give three times a step."""
    nominal, whole = targets(DESIGN), [task_of(name) for name in PAIRS]
    speeds = np.array([0.997, 1.0, 1.004]) * nominal.speeds[known]
    front = Front({}, {known: speeds}, {}, {})
    (branch,) = branches_of(front, whole, DESIGN, nominal)
    fast = speeds if known == "fast" else 8.0 * speeds
    exact = np.array([sum(weight(name, speed / 2.0**k) for k, name in enumerate(PAIRS)) for speed in fast])
    rest = rest_of(front, [branch])
    assert np.all(rest <= exact) and np.all(rest >= exact * math.exp(-7.0 * STEP))
    assert rest_of(front, [branch, branch]) == pytest.approx(2.0 * rest)


def test_a_stage_whose_both_sides_are_known_bounds_nothing():
    nominal = targets(DESIGN)
    front = Front({}, {shaft: np.array([nominal.speeds[shaft]]) for shaft in ("second", "third")}, {}, {})
    named = {branch.source for branch in branches_of(front, [task_of(name) for name in PAIRS], DESIGN, nominal)}
    assert named == {"second", "third"}


def test_beyond_its_table_a_branch_knows_no_mass():
    nominal = targets(DESIGN)
    branch = _branch(task_of("third"), "third", DESIGN, nominal, [])
    for far in (0.9, 1.1, 0.0):
        assert lightest(branch, far * nominal.speeds["third"]) == 0.0


def test_of_free_teeth_every_ratio_weighs_what_it_does_alone():
    design = parse(CHAIN + TABLES.replace("pinion_teeth = 30\nwheel_teeth = 60\n", ""))
    task = task_of("third", design)
    ratios, masses = _of_variant(task, design, (1.98, 2.02), task.speed)
    assert 2.0 in ratios.tolist() and len(ratios) > 20
    pairs = [(small, large) for small in range(18, 80) for large in (2 * small - 1, 2 * small, 2 * small + 1)]
    front = Front({}, {"third": np.full(len(pairs), task.speed)}, {}, {})
    alone = weigh(front, task, *(np.array(numbers) for numbers in zip(*pairs, strict=True)), planets=1).mass
    by_ratio = {}
    for (small, large), mass in zip(pairs, alone.tolist(), strict=True):
        by_ratio.setdefault(round(large / small, 12), []).append(mass)
    compared = [
        mass == pytest.approx(min(by_ratio[round(ratio, 12)], key=lambda other, own=mass: abs(other - own)), rel=1e-9)
        for ratio, mass in zip(ratios.tolist(), masses.tolist(), strict=True)
        if math.isfinite(mass) and round(ratio, 12) in by_ratio
    ]
    assert len(compared) > 20 and all(compared)


RULES = "[teeth]\npinion_maximum = 40\nstage_tolerance = 0.01\n"
FREE = CHAIN + TABLES.replace("pinion_teeth = 30\nwheel_teeth = 60\n", "") + RULES


def brute_force(task, design, asked, part):
    """Return the ratios of teeth within 1 % of z_2/z_1 + part between two, and their masses at the nominal speed."""
    low, high = (part + asked[0]) * 0.99 - part, (part + asked[1]) * 1.01 - part
    shaft, found = task.edge.fast[0], []
    for small in range(12, 41):
        for large in range(math.ceil(low * small), math.floor(high * small) + 1):
            numbers = np.array([small]), np.array([large])
            for planets in planet_counts(task.name, design):
                if admissible(task, design, *numbers, planets=planets).item():
                    front = Front({}, {shaft: np.array([task.speed])}, {}, {})
                    found.append(
                        (tooth_ratio(task, *numbers).item(), weigh(front, task, *numbers, planets=planets).mass.item())
                    )
    return found


@pytest.mark.parametrize("known", ["third", "slow"])
def test_a_free_pair_weighs_at_the_least_what_its_lightest_teeth_near_any_ratio_of_a_step_do(known):
    """Step by step: all teeth within the tolerance of what both ends of a step ask, at the faster end."""
    design = parse(FREE)
    task, nominal = task_of("third", design), targets(design)
    branch, teeth = _branch(task, known, design, nominal, []), 0
    for step in (0, 40, 279, 280, 559):
        ends = [nominal.speeds[known] * math.exp(STEP * (place - 280)) for place in (step, step + 1)]
        asked = sorted(
            end / nominal.speeds["slow"] if known == "third" else nominal.speeds["third"] / end for end in ends
        )
        choices = brute_force(task, design, asked, 0.0)
        fast = [ends[1] if known == "third" else ends[1] * ratio for ratio, _ in choices]
        least = min(mass * task.speed / speed for (_, mass), speed in zip(choices, fast, strict=True))
        assert branch.least[step] == pytest.approx(least, rel=1e-9)
        teeth += len(choices)
    assert len(branch.least) == 560 and teeth > 100


def test_behind_a_free_pair_the_next_turns_by_whichever_teeth_are_lightest_together():
    """The second pair is free and drives the third, of given teeth, whose table is read at both ends of a step."""
    text = CHAIN + TABLES.replace("pinion_teeth = 25\nwheel_teeth = 50\n", "")
    design = parse(text + RULES)
    task, nominal = task_of("second", design), targets(design)
    beyond = _branch(task_of("third", design), "third", design, nominal, [])
    beyond = Branch("third", beyond.nominal, np.linspace(3.0, 1.0, 560))  # falls with speed, by more than gears do
    branch = _branch(task, "second", design, nominal, [beyond])
    for step in (100, 280, 300):
        ends = [nominal.speeds["second"] * math.exp(STEP * (place - 280)) for place in (step, step + 1)]
        choices = brute_force(task, design, [end / nominal.speeds["third"] for end in ends], 0.0)
        weights = [
            mass * task.speed / ends[1] + min(beyond.at(np.array([end / ratio])).item() for end in ends)
            for ratio, mass in choices
        ]
        assert branch.least[step] == pytest.approx(min(weights), rel=1e-9)


@pytest.mark.parametrize("planets", ["planets = 3\n", ""])
def test_a_free_set_weighs_at_the_least_what_its_lightest_teeth_and_planets_do(planets):
    """z_r/z_s within 1 % of 1 + z_r/z_s; of a free number of planets whichever is lightest."""
    text = CHAIN.split("[turbines")[0].replace("three pairs in a row", "a set") + (
        '[turbines.turbine]\nshaft = "fast"\npower_kw = 100\nspeed_rpm = 6000\n'
        '[propellers.propeller]\nshaft = "slow"\nspeed_rpm = 1500\ndiameter_m = 2\n'
        f'[planetaries.only]\nsun = "fast"\nring = "ground"\ncarrier = "slow"\n{planets}'
        "[teeth]\npinion_maximum = 40\nsun_maximum = 60\nstage_tolerance = 0.01\nplanets_maximum = 4\n"
    )
    design = parse(text.replace('shafts = ["fast", "second", "third", "slow"]', 'shafts = ["fast", "slow"]'))
    edge, nominal = edge_of("only", design), targets(design)
    speed = nominal.speeds["fast"]
    task = StageTask("only", design.planetaries["only"], edge, "only", rating_of(design, "only"), 100.0, speed, speed)
    branch = _branch(task, "fast", design, nominal, [])
    for step in (200, 280):
        ends = [speed * math.exp(STEP * (place - 280)) for place in (step, step + 1)]
        asked = [end / nominal.speeds["slow"] - 1.0 for end in ends]
        low, high = (1.0 + asked[0]) * 0.99 - 1.0, (1.0 + asked[1]) * 1.01 - 1.0
        sun, planet = (numbers.ravel() for numbers in np.meshgrid(np.arange(12, 61), np.arange(12, 121)))
        near_enough = (low * sun <= sun + 2 * planet) & (sun + 2 * planet <= high * sun)
        sun, planet, least = sun[near_enough], planet[near_enough], math.inf
        for count in planet_counts("only", design):
            fits = admissible(task, design, sun, planet, planets=count)
            front = Front({}, {"fast": np.full(int(fits.sum()), speed)}, {}, {})
            least = min(least, weigh(front, task, sun[fits], planet[fits], planets=count).mass.min() * speed / ends[1])
        assert branch.least[step] == pytest.approx(least, rel=1e-9)
