"""Shafts with bearings: what is laid fits together, what the user gives is kept, what cannot be is named."""

import re
from itertools import pairwise

import pytest

from designs import changed, problems
from gearwright.catalogue import bearings
from gearwright.checks import worst_first
from gearwright.dynamics import modes
from gearwright.dynamics.assembly import assemble
from gearwright.identity import Kind
from gearwright.sizing import size
from gearwright.sizing.arrangement import envelope
from gearwright.spec import parse
from mounted_designs import HELICOPTER, PAIR, ROTOR, given, sized

EVERY = [PAIR, ROTOR, HELICOPTER]


@pytest.mark.parametrize("text", EVERY)
def test_steps_cover_the_shaft_without_gaps_and_bearings_sit_on_their_bores(text):
    sizing = sized(text)
    for built, shaft in zip(sizing.built_shafts, sizing.shafts, strict=True):
        assert (built.steps[0].start, built.steps[-1].end) == (0.0, pytest.approx(shaft.length))
        assert all(one.end == pytest.approx(other.start, abs=1e-12) for one, other in pairwise(built.steps))
        seats = {step.seat: step for step in built.steps if step.seat}
        for each in sizing.bearings:
            if each.shaft == built.name:
                assert seats[each.name].diameter == pytest.approx(each.inner_diameter)
                assert seats[each.name].end - seats[each.name].start == pytest.approx(each.width)


@pytest.mark.parametrize("text", EVERY)
def test_parts_can_be_slid_on_from_both_ends(text):
    """From the thickest step outwards seats do not grow; between two seats there may be a shoulder."""
    for built in sized(text).built_shafts:
        diameters = [step.diameter for step in built.steps]
        thickest = diameters.index(max(diameters))
        for side in (built.steps[: thickest + 1], built.steps[thickest:][::-1]):
            seats = [step.diameter for step in side if step.seat]
            assert seats == sorted(seats)


@pytest.mark.parametrize("text", EVERY)
def test_sizes_that_are_free_bear_what_is_asked(text):
    """Every check of shafts, bearings and joints but that of their places holds; the worst of all is the sizing's."""
    sizing = sized(text)
    kinds = (Kind.SHAFT, Kind.BEARING, Kind.JOINT)
    own = [check for check in sizing.checks if check.part.kind in kinds and check.clause != "bodies in space"]
    assert len(own) > 20
    assert min(check.margin for check in own) >= 1.0 - 1e-9
    assert sizing.worst_margin == sizing.checks[0].margin
    assert sizing.checks == worst_first(sizing.checks)


def test_no_lighter_bearing_of_its_bore_would_do():
    """Each chosen size is the lightest of its bore that lives; NU bearings of the first shaft."""
    sizing = sized(PAIR)
    for each in sizing.bearings:
        others = [
            one.designation
            for one in bearings().values()
            if one.kind is each.bearing.kind and one.bore == each.inner_diameter and one.mass < each.mass
        ]
        if each.bearing.kind.value.startswith("taper"):
            continue  # another taper bearing changes the thrust of both
        for name in others:
            fixed = sized(given(PAIR, each.name, f'designation = "{name}"'))
            found = next(one for one in fixed.bearings if one.name == each.name)
            assert found.life < found.wanted_life or found.static_safety < found.wanted_static_safety


def test_mass_and_stiffness_follow_from_the_steps():
    """Without what lies in gears; springs in a row: 1/k = Σ L/(G I_p). A thicker shaft is heavier and stiffer."""
    thin, thick = sized(PAIR), sized(changed(PAIR, "[layout.input]\n", "[layout.input]\ndiameter_mm = 45\n"))
    one, other = (each.shafts[0] for each in (thin, thick))
    assert other.diameter == pytest.approx(0.045)
    assert other.mass > one.mass
    assert other.stiffness > one.stiffness
    steps = thin.built_shafts[0].steps
    volume = sum(
        0.25 * 3.141592653589793 * each.diameter**2 * (each.end - each.start) for each in steps if "." not in each.seat
    )
    assert one.mass == pytest.approx(7850.0 * volume, rel=1e-12)
    assert thin.mass == pytest.approx(thin.parts_mass)
    assert thin.bearing_mass == pytest.approx(sum(each.mass for each in thin.bearings))


def test_a_bore_makes_a_shaft_lighter_and_not_weaker_than_asked():
    hollow = sized(changed(PAIR, "[layout.output]\n", "[layout.output]\nbore_ratio = 0.6\n"))
    solid = sized(PAIR)
    assert hollow.shafts[1].mass < solid.shafts[1].mass
    assert hollow.built_shafts[1].bore == pytest.approx(0.6 * min(b.inner_diameter for b in hollow.bearings[3:]))
    assert hollow.built_shafts[1].weakest.fatigue_safety >= 1.5


def test_more_safety_asks_for_more_metal():
    more = sized(changed(PAIR, "[service]\n", "[service]\nshaft_fatigue_safety = 3\n"))
    assert more.built_shafts[1].weakest.fatigue_safety >= 3.0
    assert more.shafts[1].mass > sized(PAIR).shafts[1].mass


def test_a_given_bearing_is_rated_as_it_is():
    """A small one lives too short: a margin below 1 that is shown, not refused."""
    sizing = sized(given(PAIR, "1b", 'designation = "NU 206"'))
    found = next(each for each in sizing.bearings if each.name == "1b")
    assert found.designation == "NU 206"
    check = next(check for check in sizing.checks if check.name == "1b life")
    assert check.ratio == pytest.approx(found.life / found.wanted_life)
    assert check.margin == pytest.approx((found.life / found.wanted_life) ** 0.3)  # rollers: p = 10/3
    assert check.margin < 1.0
    assert sizing.worst_margin <= check.margin


def test_a_given_bore_and_a_given_seat_are_kept():
    sizing = sized(
        given(PAIR, "1b", "bore_mm = 35") + "diameter_mm = 70\n"  # the last table is the wheel's joint
    )
    assert next(each for each in sizing.bearings if each.name == "1b").inner_diameter == pytest.approx(0.035)
    assert next(each for each in sizing.joints if each.part == "helical.wheel").diameter == pytest.approx(0.070)


def test_kinds_of_joints_bear_the_torque_with_the_application_factor():
    """T = 2031 N m times 1.25; spline and press fit stay below their pressures; the key is too long for its hub."""
    for kind, name in {"spline": "DIN 5480 - W", "press-fit": "DIN 7190"}.items():
        sizing = sized(changed(PAIR, 'kind = "spline"', f'kind = "{kind}"'))
        joint = next(each for each in sizing.joints if each.part == "helical.wheel")
        assert joint.designation.startswith(name)
        assert joint.torque == pytest.approx(1.25 * 512.479 * 107 / 27, rel=1e-5)
        assert 0.0 < joint.pressure <= joint.allowed_pressure
        assert joint.rim is not None and joint.rim > 1.2


def test_a_key_sits_on_a_shaft_that_is_strong_enough_for_its_keyway():
    """A light pair: the key fits; its notch is among the sections, with K_f near 2 (Shigley, table 7-1: 2.14)."""
    text = changed(PAIR, "power_kw = 322", "power_kw = 30")
    sizing = sized(changed(text, 'kind = "spline"', 'kind = "key"\nhub_length_mm = 45\ndiameter_mm = 40'))
    joint = next(each for each in sizing.joints if each.kind == "key")
    assert joint.designation.startswith("DIN 6885 - A ")
    assert joint.pressure <= joint.allowed_pressure == 150e6
    notched = [each for each in sizing.built_shafts[1].sections if each.place == "key at helical.wheel"]
    assert notched
    assert all(1.8 < each.bending_notch < 2.14 and each.fatigue_safety >= 1.5 for each in notched)


def test_a_machine_with_a_joint_has_a_seat_at_its_place():
    text = PAIR + '[joints.rotor]\nkind = "spline"\nhub_length_mm = 50\n'
    sizing = sized(text)
    step = next(each for each in sizing.built_shafts[1].steps if each.seat == "rotor")
    assert step.end - step.start == pytest.approx(0.05)
    assert {each.part for each in sizing.joints} == {"helical.pinion", "helical.wheel", "rotor"}


def test_dynamics_and_envelope_take_built_shafts():
    """What is built is what turns: the torsional line of a shaft has the stiffness of its steps."""
    sizing = sized(PAIR)
    assert envelope(sizing).length == pytest.approx(0.300)
    system = assemble(sizing)
    assert max(modes(system).frequency) > 100.0  # Hz


SIZED = {
    "nothing takes the axial force": (
        ('locates = "both"\nradial = false', 'locates = "first"\nradial = false'),
        "bearings.1x.locates",
        "'input' is pushed towards its second end with 2870 N in case rated, and no bearing takes that;",
    ),
    "a life that no size gives": (
        ("bearing_life_h = 5000", "bearing_life_h = 2e6"),
        "bearings.1x",
        "lives 2000000 h with s_0 = 1.5 under 0 N across and 2870 N along; the nearest, QJ ",
    ),
    "no room in the housing": (
        ("[bearings.1b]\n", "[bearings.1b]\nlargest_outer_diameter_mm = 20\n"),
        "bearings.1b.largest_outer_diameter",
        "no cylindrical roller bearing has at most 20 mm outside",
    ),
    "a key longer than its hub": (
        ('kind = "spline"', 'kind = "key"'),
        "joints.helical.wheel",
        'a spline does with',
    ),
    "a shaft thicker than its pinion": (
        (
            "bearing_life_h = 5000\n",
            'bearing_life_h = 500\nshaft_fatigue_safety = 5\n[overrides]\n"helical.module_mm" = 1.6\n',
        ),
        "joints.helical.pinion",
        "which has a root circle of",
    ),
    "bearings that stand into each other": (
        ("position_mm = 15\n", "position_mm = 30\n"),
        "bearings.1a.position",
        "mm into 1x; put its middle at",
    ),
    "a bearing over the end": (
        ("position_mm = 15\n", "position_mm = 4\n"),
        "bearings.1x.position",
        "mm into the first end; put its middle at 8.5 mm",
    ),
    "a gear in a bearing": (
        ('"helical.wheel" = { position_mm = 90 }', '"helical.wheel" = { position_mm = 50 }'),
        "layout.places.helical.wheel",
        "mm into 2a; put its middle at",
    ),
    "a seat that cannot be slid over": (
        ("[bearings.1a]\n", '[bearings.1a]\ndesignation = "NU 204"\n'),
        "bearings.1a",
        "has a seat of 20 mm on 'input' and must be slid over 25 mm further out; give it 25 mm or more",
    ),
    "a hub on more than its gear": (
        ('kind = "integral"\n', 'kind = "key"\nhub_length_mm = 200\ndiameter_mm = 75\n'),
        "joints.helical.pinion",
        "leaves no rim: the root circle of the gear has",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", SIZED)
def test_what_cannot_be_built_is_named_with_what_would_do(case):
    (old, new), path, words = SIZED[case]
    found = problems(changed(PAIR, old, new), sized=True)
    assert any(each.path == path and words in each.message for each in found), found


def test_all_shafts_tell_their_problems_at_once():
    text = changed(changed(PAIR, "position_mm = 15\n", "position_mm = 4\n"), 'kind = "spline"', 'kind = "key"')
    assert {each.path for each in problems(text, sized=True)} >= {"bearings.1x.position", "joints.helical.wheel"}


def test_shafts_in_bearings_of_300_mm_are_built():
    """A pair four times as long, at a quarter of its speed, on light bearings."""
    text = re.sub(r"(length_mm|position_mm) = (\d+)", lambda found: f"{found[1]} = {4 * int(found[2])}", PAIR)
    for old, new in {
        "power_kw = 322": "power_kw = 3000", "speed_rpm = 6000": "speed_rpm = 1500",
        "speed_rpm = 1514": "speed_rpm = 378.5",
        "[bearings.1x]\n": '[bearings.1x]\ndesignation = "QJ 1032"\n',
        "[bearings.1a]\n": '[bearings.1a]\ndesignation = "NU 1032"\n',
        "[bearings.1b]\n": '[bearings.1b]\ndesignation = "NU 1032"\n',
        '[bearings.2a]\n': '[bearings.2a]\ndesignation = "61960"\n',
        '[bearings.2b]\n': '[bearings.2b]\ndesignation = "NU 1060"\n',
        'kind = "taper"\nlocates = "first"': 'kind = "deep-groove"\nlocates = "both"',
        'kind = "taper"\nlocates = "second"': 'kind = "cylindrical"',
    }.items():  # fmt: skip
        text = changed(text, old, new)
    sizing = size(parse(text))
    seats = {step.seat: 1e3 * step.diameter for built in sizing.built_shafts for step in built.steps if step.seat}
    assert [seats[name] for name in ("1x", "1a", "1b", "2a", "2b")] == pytest.approx([160, 160, 160, 300, 300])
    assert max(step.diameter for built in sizing.built_shafts for step in built.steps) > 0.3


def test_designs_without_bearings_are_sized_as_before():
    plain = parse(PAIR.split("[bearings.1x]")[0])
    sizing = size(plain)
    assert not sizing.built_shafts and not sizing.bearings and sizing.system_life is None
    assert sizing.bearing_mass == 0.0
