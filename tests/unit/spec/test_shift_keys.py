"""Profile shifts as a design file gives them: what follows from what, and what is refused with the nearest that can."""

import math

import pytest

from designs import PAIR, changed, problem, problems
from gearwright.dynamics.assembly import assemble
from gearwright.errors import DesignError
from gearwright.identity import Role
from gearwright.parts.gears import CylindricalGear, GearPair, tip_clearances, working_centre
from gearwright.parts.iso6336 import specific_slidings
from gearwright.sizing import cylindrical_gear, planet_positions, size
from gearwright.sizing.rating import cylindrical_mesh, rating_of
from gearwright.spec import parse
from gearwright.spec.design import StageShifts, stage_shifts

SPUR = "pinion_teeth = 20\nwheel_teeth = 60\nmodule_mm = 2\n"
TEETH = {Role.PINION: 20, Role.WHEEL: 60}
RULES = "[gears]\nhelix_angle_deg = 0\n"


def pair_shifts(keys: str, rules: str = "") -> StageShifts:
    return stage_shifts(parse(f"{PAIR}{SPUR}{keys}{RULES}{rules}"), "stage", TEETH)


def shifts_of(shifts: StageShifts) -> list[float]:
    return [gear.profile_shift for gear in shifts.gears]


def one_set(sun: int, planet: int, ring: int, keys: str = "", *, planets: int = 3) -> str:
    """A turbine, a planetary set of given teeth, a propeller."""
    driving = PAIR[: PAIR.index("[pairs.stage]")]
    machines = changed(driving, "speed_rpm = 2000", f"speed_rpm = {6000.0 * sun / (sun + ring):.1f}")
    return (
        f'{machines}[planetaries.first]\nsun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = {planets}\n'
        f"sun_teeth = {sun}\nplanet_teeth = {planet}\nring_teeth = {ring}\n{keys}"
    )


def planetary(keys: str, rules: str = "") -> str:
    """18/36/93 teeth, whose ring has three more than close without shift."""
    return one_set(18, 36, 93, "module_mm = 2.1\n" + keys) + rules


def test_one_shift_leaves_its_opposite_to_the_mate():
    """x_1 + x_2 = 0 keeps the reference centre distance."""
    shifts = pair_shifts("pinion_shift = 0.3\n")
    assert shifts_of(shifts) == [0.3, -0.3]
    assert shifts.centre is None
    assert [gear.tip_alteration for gear in shifts.gears] == [0.0, 0.0]


def test_two_shifts_give_the_centre_distance_and_shorten_the_tips():
    """By hand for 20/60, x = 0.4 and 0.3: inv α_w = inv 20° + 2 tan 20° 0.7/80; k = (a_w − a)/m − 0.7."""
    shifts = pair_shifts("pinion_shift = 0.4\nwheel_shift = 0.3\n")
    wanted = math.tan(math.radians(20.0)) * (1.0 + 2.0 * 0.7 / 80.0) - math.radians(20.0)
    low, high = 0.3, 0.5
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if math.tan(middle) - middle < wanted else (low, middle)
    centre = 40.0 * math.cos(math.radians(20.0)) / math.cos(low)
    assert shifts.centre == pytest.approx(centre, rel=1e-12)
    assert shifts.gears[0].tip_alteration == pytest.approx(centre - 40.0 - 0.7, rel=1e-9)


def test_shifts_follow_from_a_centre_distance():
    """81.3 mm of 80 mm; the sum closes there again, and a given shift leaves the rest to its mate."""
    shifts = pair_shifts("centre_distance_mm = 81.3\n")
    closed = pair_shifts(
        f"pinion_shift = {shifts.gears[0].profile_shift}\nwheel_shift = {shifts.gears[1].profile_shift}\n"
    )
    assert closed.centre == pytest.approx(81.3 / 2.0, rel=1e-9)
    some = pair_shifts("centre_distance_mm = 81.3\npinion_shift = 0.5\n")
    assert sum(shifts_of(some)) == pytest.approx(sum(shifts_of(shifts)))
    assert some.gears[0].profile_shift == 0.5


def test_balanced_sliding_slides_alike_at_both_roots():
    """ζ_f1 = ζ_f2; without shift the pinion of 20/60 slides far more at its root."""
    plain, even = (
        rating_of(parse(f"{PAIR}{SPUR}{RULES}{rule}"), "stage", {"stage.pinion": 20, "stage.wheel": 60})
        for rule in ("", 'balanced_shifts = "sliding"\n')
    )
    first, second = specific_slidings(cylindrical_mesh((20, 60), 2e-3, 0.02, even))
    assert first == pytest.approx(second, rel=1e-3)
    worse, _ = specific_slidings(cylindrical_mesh((20, 60), 2e-3, 0.02, plain))
    assert worse > 1.5 * first


def test_balanced_strength_makes_roots_of_one_stress():
    """S_F of both gears of one steel agree where Y_F Y_S does; notch and size factors part them by little."""
    text = f'{PAIR}{SPUR}face_width_mm = 20\n{RULES}rating = "iso6336"\nmaterial = "carburised-9310"\n'
    plain, even = (size(parse(text + rule)).meshes[0].rating.bending for rule in ("", 'balanced_shifts = "strength"\n'))
    assert even[0] == pytest.approx(even[1], rel=0.03)
    assert min(even) > min(plain)


def test_a_planetary_set_closes_by_its_shifts():
    """x_s + x_p and x_p + x_r give one centre distance, and the ring follows from the other two."""
    shifts = stage_shifts(
        parse(planetary("sun_shift = 0.389\nplanet_shift = 0.504\n")),
        "first",
        {Role.SUN: 18, Role.PLANET: 36, Role.RING: 93},
    )
    assert shifts.of(Role.RING).profile_shift == pytest.approx(0.117, abs=1e-3)
    assert shifts.centre is not None
    assert 2.1 * shifts.centre == pytest.approx(58.4002, abs=1e-4)


def test_a_planetary_set_that_does_not_close_is_balanced_where_the_rules_say_so():
    design = parse(planetary("", '[gears]\nbalanced_shifts = "strength"\n'))
    shifts = stage_shifts(design, "first", {Role.SUN: 18, Role.PLANET: 36, Role.RING: 93})
    assert shifts.centre == pytest.approx(0.5 * (27.0 + 28.5))
    assert all(math.isfinite(gear.profile_shift) for gear in shifts.gears)


def test_the_ratio_and_the_mesh_forces_of_a_shifted_set_balance():
    """1 + 93/18, and the torque of the sun from the force at its working circle."""
    sizing = size(parse(planetary("centre_distance_mm = 58.4\nsun_shift = 0.389\n")))
    flow, mesh = sizing.flows[next(iter(sizing.flows))], next(m for m in sizing.meshes if m.name == "first.sun-planet")
    assert flow.speeds["fast"] / flow.speeds["slow"] == pytest.approx(1.0 + 93.0 / 18.0)
    worst = sizing.flows[mesh.case].meshes[mesh.name].torques[0]
    assert 3.0 * mesh.tangential_force * mesh.working_diameter / 2.0 == pytest.approx(abs(worst) * mesh.load_factor)
    assert mesh.working_diameter == pytest.approx(2.0 * 58.4e-3 * 18.0 / 54.0)


def test_planets_may_stand_unequally_where_the_design_allows_it():
    """27/99 with four planets: 126 places, 32 and 31 of them apart: 91.43° and 88.57°."""
    sizing = size(parse(one_set(27, 36, 99, "unequal_places = true\n", planets=4)))
    places = [math.degrees(place) for place in planet_positions(sizing.design, "first", sizing.teeth)]
    assert places == pytest.approx([0.0, 32 * 360 / 126, 180.0, 180.0 + 32 * 360 / 126])
    assert assemble(sizing).labels.lines


@pytest.mark.parametrize(
    ("text", "path", "words"),
    [
        (planetary(""), "planetaries.first.ring_teeth", ("does not close without profile shift", "90 teeth")),
        (planetary("centre_distance_mm = 58.4\nsun_shift = 0.389\nplanet_shift = 0.6\n"),
         "planetaries.first.sun_shift", ("give sun_shift = 0.29", "leave one of them out")),
        (planetary("centre_distance_mm = 40\n"), "planetaries.first.centre_distance", ("base circles roll on each",)),
        (changed(planetary("centre_distance_mm = 58.4\n"), "module_mm = 2.1\n", ""),
         "planetaries.first.centre_distance", ("only with the module",)),
        (PAIR + SPUR + "pinion_shift = 1.5\n" + RULES, "pairs.stage.pinion_shift", ("points 20 teeth", "give at most")),
        (PAIR + SPUR + "wheel_shift = 0.6\n" + RULES, "pairs.stage.pinion_shift",
         ("undercuts 20 teeth", "at least -0.170", "28 teeth")),
        (PAIR + SPUR + "centre_distance_mm = 81.3\npinion_shift = 0.3\nwheel_shift = 0.1\n" + RULES,
         "pairs.stage.wheel_shift", ("pinion_shift = 0.3 and wheel_shift = 0.1 close at", "give wheel_shift = ")),
        (PAIR + "internal = true\npinion_teeth = 18\nwheel_teeth = 69\nwheel_tip_alteration = 0\n" + RULES,
         "pairs.stage.wheel_teeth", ("dig 0.072 modules past the involute", "wheel_tip_alteration = -0.073", "teeth")),
        (PAIR + "internal = true\npinion_teeth = 40\nwheel_teeth = 44\n" + RULES,
         "pairs.stage.wheel_teeth", ("trochoidal interference", "teeth")),
    ],
)  # fmt: skip
def test_shifts_that_make_no_gears_are_refused_with_what_would(text: str, path: str, words: tuple[str, ...]):
    found = problems(text, sized=True)
    assert found[0].path.removesuffix("_mm") == path
    assert all(word in found[0].message for word in words), found[0].message


def test_what_is_told_of_contradicting_shifts_closes():
    """33 + 18 = 69 − 18: the ring closes where sun and planet do with x_r + x_p = −(x_s + x_p), so −0.5 − 0.2."""
    given = "sun_shift = 0.3\nplanet_shift = 0.2\nring_shift = {}\n"
    found = problem(one_set(33, 18, 69, given.format(0.5)))
    assert found.path == "planetaries.first.ring_shift"
    assert "give ring_shift = -0.7000, or leave one of them out" in found.message
    parse(one_set(33, 18, 69, given.format(-0.7)))


def test_a_tip_alteration_is_advised_only_where_its_key_takes_it():
    """Teeth that dig 0.347 modules past the involute with k = −0.5 already ask −0.848; the key ends at −0.6."""
    text = one_set(12, 33, 78, "sun_shift = 1.4\n")
    dug = next(found for found in problems(text, sized=True) if "past the involute" in found.message)
    assert "ring_tip_alteration" not in dug.message
    assert "give more shift to the gear inside" in dug.message
    found = problem(one_set(33, 18, 69, "ring_tip_alteration = -0.848\n"))
    assert "give a value from -0.6 to 0.3" in found.message


def test_planets_that_only_touch_with_their_shifted_tips_are_refused():
    """Four planets of 64 about a sun of 32: 96 sin 45° = 67.88 above 66; tips of 2 (32 + 1 + 0.8 + 0.2) = 68 touch."""
    parse(one_set(32, 64, 160, planets=4))
    parse(one_set(32, 64, 160, "planet_shift = 0.8\n", planets=4))
    found = problem(one_set(32, 64, 160, "planet_shift = 0.8\nplanet_tip_alteration = 0.2\n", planets=4))
    assert found.path == "planetaries.first.planets"
    assert "stand into each other by 0.118 modules" in found.message
    assert found.message.endswith("give 3 or fewer, or smaller planets")


def test_a_rings_tips_are_as_short_as_the_involute_of_its_planets_asks():
    """18 teeth in 69: the full addendum would dig 0.072 modules past the involute."""
    sizing = size(parse(one_set(33, 18, 69)))
    ring = next(gear for gear in sizing.gears if gear.name == "first.ring")
    assert ring.tip_alteration == pytest.approx(-0.072, abs=1e-3)
    assert cylindrical_gear(sizing.design, ring).tip_alteration == ring.tip_alteration
    assert all(check.ratio is None or check.ratio >= 1.0 for check in sizing.checks if "interference" in check.mode)


def test_a_bevel_pair_has_opposite_shifts():
    bevel = (
        changed(PAIR, "speed_rpm = 2000", "speed_rpm = 2154")
        + 'kind = "bevel"\naxis_angle_deg = 90\npinion_teeth = 14\nwheel_teeth = 39\n'
    )
    rules = '[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
    sizing = size(parse(bevel + "pinion_shift = 0.4\n" + rules))
    assert [gear.profile_shift for gear in sizing.gears] == [0.4, -0.4]
    usual = size(parse(bevel + rules + 'balanced_shifts = "strength"\n'))
    assert usual.gears[0].profile_shift == pytest.approx(0.505, abs=5e-4)
    found = problem(bevel + "pinion_shift = 0.4\nwheel_shift = 0.1\n" + rules, sized=True)
    assert found.path == "pairs.stage.wheel_shift"


def test_less_crowned_bevel_flanks_spread_their_load_further():
    """e_LS = 3 instead of 1.5 (ISO 10300-2, table 5) lowers the contact stress of the same pair."""
    cones = "axis_angle_deg = 90\nspiral_angle_deg = 35\n"
    sizes = cones + "pinion_teeth = 20\nwheel_teeth = 60\nouter_module_mm = 5\nface_width_mm = 30\n"
    rules = '[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n[gears.iso6336]\nprofile_crowning = "{}"\n'
    high, low = (
        size(parse(PAIR + 'kind = "bevel"\n' + sizes + rules.format(how))).meshes[0].rating for how in ("high", "low")
    )
    assert low.contact_stress < 0.98 * high.contact_stress


@pytest.mark.parametrize("distance", [60, 76, 86.5, 90, 120, 1e4])
def test_a_centre_distance_that_no_shift_reaches_is_refused_with_those_that_are(distance):
    """20/60 of module 2 reach 38 to 42.5 modules, by x_1 + x_2 of −3 to 3."""
    told = problem(f"{PAIR}{SPUR}centre_distance_mm = {distance}\n{RULES}")
    assert told.path == "pairs.stage.centre_distance_mm"
    assert "modules" in told.message


def test_one_shift_given_leaves_no_more_than_a_tooth_can_take_to_the_other():
    told = problem(f"{PAIR}{SPUR}centre_distance_mm = 83\npinion_shift = 0\n{RULES}")
    assert told.path == "pairs.stage.centre_distance_mm"
    assert "of the wheel; shifts up to ±1.5 reach" in told.message


@pytest.mark.parametrize("total", [-0.4, 0.0, 0.3, 0.9, 1.4])
def test_the_sum_of_shifts_at_a_centre_distance_is_the_same_however_it_is_divided(total):
    """x_1 + x_2 belongs to a_w; balance, a given shift or the mate's shift divide it, and mirrored teeth mirror it."""
    centre = 2.0 * working_centre(80, total, pressure_angle=math.radians(20.0), helix_angle=0.0)
    ways = ("", "pinion_shift = 0.2\n", f"wheel_shift = {total - 0.3}\n")
    sums = [sum(shifts_of(pair_shifts(f"centre_distance_mm = {centre!r}\n{way}"))) for way in ways]
    assert sums == pytest.approx([total] * 3, abs=1e-6)
    even = f"{PAIR}pinion_teeth = 40\nwheel_teeth = 40\nmodule_mm = 2\ncentre_distance_mm = {centre!r}\n{RULES}"
    slower = changed(even, "speed_rpm = 2000", "speed_rpm = 6000")
    first, second = shifts_of(stage_shifts(parse(slower), "stage", {Role.PINION: 40, Role.WHEEL: 40}))
    assert first == pytest.approx(second, abs=2e-3)


@pytest.mark.parametrize(
    ("teeth", "ways"), [((33, 18, 69), "give 2 or 3 or 6 planets"), ((27, 36, 99), "give 2 or 3 planets")]
)
def test_four_planets_that_do_not_go_together_are_refused_and_stand_where_they_fit(teeth, ways):
    """33 + 69 = 102 and 27 + 99 = 126 are no multiples of 4; places are multiples of 360°/(z_s + z_r)."""
    told = problem(one_set(*teeth, "module_mm = 2\n", planets=4))
    assert told.path == "planetaries.first.planets"
    assert ways in told.message
    design = parse(one_set(*teeth, "module_mm = 2\nunequal_places = true\n", planets=4))
    places = planet_positions(design, "first", {"first.sun": teeth[0], "first.ring": teeth[2]})
    steps = [place * (teeth[0] + teeth[2]) / (2.0 * math.pi) for place in places]
    assert steps == pytest.approx([round(step) for step in steps])


@pytest.mark.parametrize(("key", "wrong"), [("pinion_shift = 1.4", "at most"), ("pinion_shift = -0.9", "needs")])
def test_shifts_of_bevel_gears_that_point_or_undercut_them_are_refused_by_their_key(key, wrong):
    """20/60: virtual teeth 21.1; x_hm1 = 1.4 leaves nothing at the tip, −0.9 is far below −0.18."""
    text = PAIR + 'kind = "bevel"\naxis_angle_deg = 90\npinion_teeth = 20\nwheel_teeth = 60\n' + key
    rules = '\n[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
    with pytest.raises(DesignError, match=rf"pairs.stage.pinion_shift: .*({wrong})"):
        size(parse(text + rules))


def test_tips_that_run_into_the_root_of_a_mate_are_refused_in_sets():
    """Basic rack: tips stand 1 + k out, roots 1.25 deep, c = 0.25 − k modules: none is left at k = 0.25."""
    for gear in ("sun", "planet"):
        text = one_set(30, 30, 90, f"module_mm = 3\n{gear}_tip_alteration = 0.3\n", planets=3)
        found = problem(text)
        assert found.path == f"planetaries.first.{gear}_tip_alteration"
        assert "its tips run 0.05 modules (0.15 mm) into the root of" in found.message
        assert f"give {gear}_tip_alteration = 0.249 or below" in found.message
        assert problem(text.replace("= 0.3\n", "= 0.25\n")).path == found.path
        parse(text.replace("= 0.3\n", "= 0.249\n"))


def test_tips_that_run_into_the_root_of_a_mate_are_refused_in_pairs():
    """c = a_w − r_a1 − r_f2: 20 and 60 teeth at 40 modules, tips at 10 + 1 + k, roots at 30 − 1.25."""
    with pytest.raises(DesignError) as caught:
        pair_shifts("pinion_tip_alteration = 0.3\nwheel_tip_alteration = 0.26\n")
    pinion, wheel = caught.value.problems
    assert pinion.path.removesuffix("_mm") == "pairs.stage.pinion_tip_alteration"
    assert "0.05 modules (0.1 mm) into the root of wheel" in pinion.message
    assert wheel.path == "pairs.stage.wheel_tip_alteration"
    assert "0.01 modules (0.02 mm) into the root of pinion" in wheel.message
    pair_shifts("pinion_tip_alteration = 0.249\nwheel_tip_alteration = 0.249\n")


def test_the_room_of_tips_above_roots_follows_the_centre_distance():
    """20 and ±60 teeth of 1 m, unshifted, c = 0.25; 0.1 m further apart: more outside, less in a ring, and for both."""
    pinion = CylindricalGear(20, 1.0, 1.0)
    outside = GearPair(pinion, CylindricalGear(60, 1.0, 1.0), 40.1)
    inside = GearPair(pinion, CylindricalGear(-60, 1.0, 1.0, tip_alteration=0.05), 20.1)
    assert tip_clearances(outside) == pytest.approx((0.35, 0.35))
    assert tip_clearances(inside) == pytest.approx((0.15, 0.10))
