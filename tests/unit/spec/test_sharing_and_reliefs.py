"""Levels of sharing that no member floats for, and reliefs beyond their modules, are refused where they are written."""

import re

import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import edited, parse, read

HEAD = """\
schema = 1
name = "shared"
level = "{level}"
shafts = [{shafts}]
[turbines.turbine]
shaft = "fast"
power_kw = 300
speed_rpm = 6000
[loads.load]
shaft = "slow"
"""
GEARS = """\
[gears]
rating = "iso6336"
"""
PLANETARY = """\
[planetaries.set]
sun = "fast"
ring = "{ring}"
carrier = "slow"
planets = 3
sun_teeth = 30
planet_teeth = 27
ring_teeth = 84
module_mm = 3
"""
COMPOUND = """\
[epicyclics.set]
carrier = "slow"
sets = 3
[epicyclics.set.suns.sun]
shaft = "fast"
teeth = 30
[epicyclics.set.rings.ring]
shaft = "{ring}"
teeth = 84
[epicyclics.set.planets.planet]
teeth = 27
meshes = ["sun", "ring"]
"""
SPLIT = """\
[pairs.first]
pinion = "fast"
wheel = ["left", "right"]
pinion_teeth = 25
wheel_teeth = 75
module_mm = 3
[pairs.second]
pinion = ["left", "right"]
wheel = "slow"
pinion_teeth = 25
wheel_teeth = 75
module_mm = 4
"""
BETWEEN = """\
[pairs.first]
pinion = "fast"
wheel = "left"
pinion_teeth = 25
wheel_teeth = 40
module_mm = 4
[pairs.second]
pinion = "right"
wheel = "slow"
pinion_teeth = 25
wheel_teeth = 75
[pairs.between]
pinion = "first.wheel"
wheel = "second.pinion"
"""
LONE = """\
[pairs.first]
pinion = "fast"
wheel = "slow"
pinion_teeth = 30
wheel_teeth = 70
module_mm = 4
"""


def text(stages, *shafts, held=(), ring="third", level="concept"):
    """A design of some stages, with two bearings on each shaft that is held."""
    named = ", ".join(f'"{shaft}"' for shaft in ("fast", "slow", *shafts))
    seats = "".join(
        f'[bearings.{shaft}-{k}]\nshaft = "{shaft}"\nposition_mm = {40 * k}\n' for shaft in held for k in (1, 2)
    )
    head = HEAD.format(level="built" if held else level, shafts=named)
    return head + stages.replace("{ring}", ring) + GEARS + seats


def told(design, changes):
    """Path -> message of every problem of a design with some changes."""
    with pytest.raises(DesignError) as caught:
        size(edited(parse(design) if isinstance(design, str) else design, changes))
    paths = [problem.path for problem in caught.value.problems]
    assert len(paths) == len(set(paths))
    return {problem.path: problem.message for problem in caught.value.problems}


def refused(written):
    """Path -> message of every problem of a text."""
    with pytest.raises(DesignError) as caught:
        parse(written)
    return {problem.path: problem.message for problem in caught.value.problems}


@pytest.mark.parametrize(("stage", "table"), [(PLANETARY, "planetaries"), (COMPOUND, "epicyclics")])
@pytest.mark.parametrize("level", ["level-3", "level-4"])
def test_a_level_with_a_member_that_floats_is_refused_where_bearings_hold_them_all(stage, table, level):
    shared = stage.replace('carrier = "slow"\n', f'carrier = "slow"\nload_sharing = "{level}"\n')
    every = ("fast", "third", "slow")
    found = refused(text(shared, "third", held=every))
    assert list(found) == [f"{table}.set.load_sharing"]
    (message,) = found.values()
    assert f"'{level}' asks for a central member that floats" in message
    assert "fast, third, slow each run in 2 bearings or more" in message
    assert "leave one without bearings, or give level-1 or level-2" in message
    for free in every:
        parse(text(shared, "third", held=tuple(shaft for shaft in every if shaft != free)))
    for rigid in ("level-1", "level-2"):
        parse(text(shared.replace(level, rigid), "third", held=every))
    parse(text(shared, held=("fast", "slow"), ring="ground"))  # splines in the housing may let the ring float


def test_a_gear_that_is_to_float_between_two_paths_is_refused_where_bearings_hold_it_all_at_once():
    floating = SPLIT.replace("module_mm", 'load_sharing = "floating"\nmodule_mm')
    found = refused(text(floating, "left", "right", held=("fast", "slow", "left", "right")))
    assert list(found) == ["pairs.first.load_sharing", "pairs.second.load_sharing"]
    for message, shaft in zip(found.values(), ("fast", "slow"), strict=True):
        assert f"'floating' asks for a gear that floats, and {shaft} runs in 2 bearings or more" in message
        assert "leave it without bearings, or give clocked or rigid" in message
    assert list(refused(text(floating, "left", "right", held=("fast", "left", "right")))) == [
        "pairs.first.load_sharing"
    ]
    parse(text(floating, "left", "right", held=("left", "right")))


@pytest.mark.parametrize(
    ("stage", "table", "value", "allowed"),
    [
        (LONE, "pairs.first", "level-3", "'clocked', 'rigid', 'quill' or 'floating'"),
        (PLANETARY, "planetaries.set", "floating", "'level-1', 'level-2', 'level-3', 'level-4' or 'tolerances'"),
        (COMPOUND, "epicyclics.set", "clocked", "'level-1', 'level-2', 'level-3', 'level-4' or 'tolerances'"),
    ],
)
def test_a_way_of_sharing_of_another_kind_of_stage_is_refused_with_those_of_its_own(stage, table, value, allowed):
    shared = stage.replace("meshes =", "#").replace(
        "[epicyclics.set.suns", f'load_sharing = "{value}"\n[epicyclics.set.suns'
    )
    shared = shared.replace("module_mm", f'load_sharing = "{value}"\nmodule_mm').replace("#", "meshes =")
    found = refused(text(shared, "third" if stage is COMPOUND else "spare", ring="ground"))
    assert found[f"{table}.load_sharing"] == f"{value!r} is not known; allowed: {allowed}"


def test_clocking_gives_k_gamma_by_the_torque_that_is_split():
    """1 + 2 · 0.0375 a mrad · 367 N m over 300 kW at 628.3 rad/s, 477.5 N m (Krantz & Delgado 1996)."""
    split = edited(parse(text(SPLIT, "left", "right")), {"pairs.first.clocking_mrad": 2})
    loads = {mesh.stage: mesh.load_factor for mesh in size(split).meshes}
    assert loads["first"] == pytest.approx(1.0 + 2.0 * 0.0375 * 2.0 * 367.0 / (300e3 / 628.3185), rel=1e-4)
    assert loads["second"] == 1.06


def test_paths_that_close_no_loop_have_nothing_to_share():
    found = refused(text(LONE.replace("module_mm", 'load_sharing = "rigid"\nclocking_mrad = 1\nmodule_mm')))
    assert "has no effect: the pair is on no loop of parallel paths" in found["pairs.first.load_sharing"]
    assert "has no effect" in found["pairs.first.clocking_mrad"]


@pytest.mark.parametrize(
    ("design", "stage", "module"),
    [(text(LONE), "pairs.first", 4.0), (text(PLANETARY, ring="ground"), "planetaries.set", 3.0)],
)
def test_a_relief_beyond_a_twentieth_of_the_module_is_refused_in_its_own_table(design, stage, module):
    for table in ("gears", f"{stage}.gears"):
        key = f"{table}.iso6336.tip_relief_mm"
        (found,) = told(design, {key: 0.06 * module}).items()
        assert found[0] == key
        words = (
            f"{0.06 * module:g} mm on a module of {module:g} mm ({stage.split('.')[1]}) leaves too little of the flank"
        )
        assert (
            found[1]
            == f"{words}; give {0.05 * module:g} mm or less, or leave it out: tips are then relieved for their load"
        )
        edited(parse(design), {key: 0.05 * module})


def test_every_stage_has_its_own_limit_and_all_are_told_at_once():
    """Modules of 3 and 4 mm allow 0.15 and 0.2 mm."""
    split = text(SPLIT, "left", "right")
    own = {f"pairs.{name}.gears.iso6336.tip_relief_mm": 0.3 for name in ("first", "second")}
    found = told(split, own)
    assert list(found) == list(own)
    assert ["give 0.15 mm or less" in found[key] for key in own] == [True, False]
    assert ["give 0.2 mm or less" in found[key] for key in own] == [False, True]
    only = told(split, {"gears.iso6336.tip_relief_mm": 0.18})
    assert "on a module of 3 mm (first)" in only["gears.iso6336.tip_relief_mm"]


def test_a_relief_is_held_to_the_module_that_is_found_where_none_is_stated_and_bevel_gears_read_none():
    """EC120B: its helical pairs come to 2 and 1 mm, 100 and 50 µm; its bevel pair has no relief."""
    design = read(shipped_design("ec120b"))
    keys = [f"pairs.{name}.gears.iso6336.tip_relief_mm" for name in ("helical", "tail-take-off")]
    found = told(design, dict.fromkeys(keys, 0.4))
    assert list(found) == keys
    for key, stage in zip(keys, ("helical", "tail-take-off"), strict=True):
        module, most = re.search(rf"0.4 mm on a module of (\S+) mm \({stage}\) .* give (\S+) mm", found[key]).groups()
        assert 0.0 <= 0.05 * float(module) - float(most) < 1e-3
    assert size(edited(design, dict.fromkeys(keys, 0.03))).meshes
    compound = text(COMPOUND, ring="ground")
    (found,) = told(compound, {"gears.iso6336.tip_relief_mm": 0.3, "turbines.turbine.power_kw": 5}).items()
    module, most = re.search(r"0.3 mm on a module of (\S+) mm \(set\) .* give (\S+) mm or less", found[1]).groups()
    assert found[0] == "gears.iso6336.tip_relief_mm"
    assert 0.0 < 0.05 * float(module) - float(most) < 1e-3  # in whole micrometres, of which 1.125 mm allow 56.25


def test_of_modules_that_are_open_one_is_taken_of_which_a_given_relief_leaves_enough():
    """0.12 mm ask for 2.4 mm or more, where 1.125 mm would bear the load."""
    modules = {}
    for relief in (0.05, 0.12):
        changes = {"gears.iso6336.tip_relief_mm": relief, "turbines.turbine.power_kw": 5}
        modules[relief] = {gear.module for gear in size(edited(parse(text(COMPOUND, ring="ground")), changes)).gears}
    assert max(modules[0.05]) < 2.4e-3 <= min(modules[0.12])


def test_a_pair_between_gears_of_two_other_pairs_is_held_to_their_module():
    """It has no gear of its own; a twentieth of 4 mm is 0.2 mm."""
    between = text(BETWEEN, "left", "right")
    key = "pairs.between.gears.iso6336.tip_relief_mm"
    assert "on a module of 4 mm (between)" in told(between, {key: 0.3})[key]
    assert size(edited(parse(between), {key: 0.2})).meshes


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("tip_relief_mm", -0.01, "-0.01 mm is not allowed; give 0 or a value from 1e-06 to 0.5 mm"),
        ("tip_relief_mm", 3, "3 mm is not allowed; give 0 or a value from 1e-06 to 0.5 mm"),
        ("tip_relief_tolerance_mm", 0.3, "0.3 mm is not allowed; give 0 or a value from 1e-06 to 0.1 mm"),
        ("tip_relief_for", "noise", "'noise' is not known; allowed: 'load' or 'run-in'"),
    ],
)
def test_reliefs_that_no_module_allows_are_refused_with_what_is(key, value, words):
    assert told(text(LONE), {f"gears.iso6336.{key}": value}) == {f"gears.iso6336.{key}": words}


def test_an_amount_leaves_a_rule_for_reliefs_without_effect():
    both = {"gears.iso6336.tip_relief_mm": 0.03, "gears.iso6336.tip_relief_for": "run-in"}
    found = told(text(LONE), both)
    assert found == {
        "gears.iso6336.tip_relief_for": "has no effect: tip_relief_mm states the amount; keep one of the two"
    }
    edited(parse(text(SPLIT, "left", "right")), {
        "pairs.first.gears.iso6336.tip_relief_mm": 0.03, "gears.iso6336.tip_relief_for": "run-in"
    })  # fmt: skip
