"""Tooth thicknesses and centre distances as a design allows them, and the backlash that follows."""

import math
from itertools import pairwise

import pytest

from designs import PAIR, changed, problem
from gearwright.catalogue import THICKNESS_FITS, thickness_allowances
from gearwright.checks import Status
from gearwright.dynamics.assembly import assemble
from gearwright.errors import DesignError
from gearwright.parts.gears import CylindricalGear, half_angle_at, thinned
from gearwright.sizing import backlash_of, size
from gearwright.spec import edited, parse
from gearwright.spec.design import GearRules

SPUR = f"{PAIR}pinion_teeth = 20\nwheel_teeth = 60\nmodule_mm = 2\nface_width_mm = 20\n"
TWENTY = math.radians(20.0)
UM = 1e-6


def play(text: str, mesh: int = 0):
    sizing = size(parse(text))
    return backlash_of(sizing.design, {gear.name: gear for gear in sizing.gears}, sizing.meshes[mesh])


def test_backlash_follows_from_both_thicknesses_and_the_place_of_the_axes():
    """By hand, DIN 3967: d = 40 and 120 mm, cd25: −54, −84 and −70, −110 µm; DIN 3964: IT7 of 80 mm is 30 µm."""
    found = play(SPUR + '[gears]\nhelix_angle_deg = 0\nallowance = "cd25"\ncentre_allowance = "js7"\n')
    axes = 2.0 * 15.0 * math.sin(TWENTY)
    least, most = (54 + 70) * math.cos(TWENTY) - axes, (84 + 110) * math.cos(TWENTY) + axes
    assert found.normal == pytest.approx((least * UM, most * UM))
    assert found.circumferential == pytest.approx((least * UM / math.cos(TWENTY), most * UM / math.cos(TWENTY)))
    assert found.mean == pytest.approx(0.5 * (least + most) * UM)


def test_backlash_of_helical_teeth_is_that_of_din_3967_around_the_reference_circles():
    """j_t = −ΣE_sn/cos β without shift, which is the normal backlash over cos α_t cos β_b."""
    found = play(SPUR + '[gears]\nhelix_angle_deg = 25\nallowance = "bc26"\n')
    allowed = [thickness_allowances(1e-3 * 2 * z / math.cos(math.radians(25.0)), "bc26") for z in (20, 60)]
    for end, found_end in zip((1, 0), found.circumferential, strict=True):
        assert found_end == pytest.approx(-sum(gear[end] for gear in allowed) / math.cos(math.radians(25.0)))


def test_a_gear_has_its_own_allowance_or_that_of_the_rules():
    own = play(f'{SPUR}wheel_allowance = "a24"\n[gears]\nhelix_angle_deg = 0\nallowance = "cd25"\n')
    assert own.normal[0] == pytest.approx((54 + 180) * UM * math.cos(TWENTY))
    one = play(f'{SPUR}wheel_allowance = "a24"\n[gears]\nhelix_angle_deg = 0\n')
    assert one.normal[0] == pytest.approx(180 * UM * math.cos(TWENTY))
    assert play(f"{SPUR}[gears]\nhelix_angle_deg = 0\n") is None


@pytest.mark.parametrize("diameter", [0.005, 0.05, 0.3, 0.863, 9.0])
def test_a_later_letter_leaves_less_and_a_larger_number_lets_more_through(diameter):
    letters = [series for series, tolerance in THICKNESS_FITS.values() if tolerance == 25]
    upper = [thickness_allowances(diameter, f"{series}25")[1] for series in letters]
    assert upper == sorted(upper)
    assert upper[-1] == 0.0
    widths = [high - low for low, high in (thickness_allowances(diameter, f"c{number}") for number in range(21, 31))]
    assert widths == sorted(widths)
    assert widths[0] > 0.0


def test_backlash_grows_with_the_allowance_and_not_with_the_order_of_gears():
    """Mirror symmetry: what the pinion leaves and the wheel keeps is what the wheel leaves and the pinion keeps."""
    text = SPUR.replace("wheel_teeth = 60", "wheel_teeth = 20").replace("speed_rpm = 2000", "speed_rpm = 6000")
    plays = [play(f'{text}[gears]\nhelix_angle_deg = 0\nallowance = "{series}26"\n').normal for series in "hgfedcba"]
    assert all(tight[0] < loose[0] and tight[1] < loose[1] for tight, loose in pairwise(plays))
    assert plays[0][0] == 0.0
    rules = "[gears]\nhelix_angle_deg = 0\n"
    assert play(f'{text}pinion_allowance = "c25"\nwheel_allowance = "e24"\n{rules}') == play(
        f'{text}pinion_allowance = "e24"\nwheel_allowance = "c25"\n{rules}'
    )


def test_thinned_teeth_are_as_much_thinner_as_the_allowance_says_and_as_high():
    for teeth in (20, -60):
        gear = CylindricalGear(teeth, 2e-3, 0.02, profile_shift=0.3)
        thin = thinned(gear, -80e-6)
        arcs = [2.0 * half_angle_at(each, each.pitch_radius) * each.pitch_radius for each in (gear, thin)]
        assert arcs[0] - arcs[1] == pytest.approx(80e-6)
        assert thin.tip_radius == pytest.approx(gear.tip_radius)


def test_motion_takes_the_mean_where_the_design_gives_no_backlash_and_what_is_given_where_it_does():
    text = SPUR + '[gears]\nhelix_angle_deg = 0\nallowance = "cd25"\n'
    fitted = parse(text)
    mean = play(text).mean
    assert set(assemble(size(fitted)).arrays.backlash) >= {mean}
    given = edited(fitted, {"pairs.stage.backlash_um": 40})
    assert max(assemble(size(given)).arrays.backlash) == pytest.approx(40 * UM)
    none = edited(fitted, {"pairs.stage.backlash_um": 0})
    assert max(assemble(size(none)).arrays.backlash) == 0.0


def test_both_meshes_of_a_set_have_the_backlash_of_their_own_gears():
    """The ring's reference circle is larger, and so is its allowance."""
    text = (
        changed(PAIR[: PAIR.index("[pairs.stage]")], "speed_rpm = 2000", "speed_rpm = 1500")
        + '[planetaries.set]\nsun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = 3\nsun_teeth = 24\n'
        'planet_teeth = 24\nring_teeth = 72\nmodule_mm = 2\n[gears]\nallowance = "cd25"\n'
    )
    for fidelity in ("rotational", "translational"):
        sizing = size(parse(f'{text}[dynamics]\nfidelity = "{fidelity}"\n'))
        system = assemble(sizing)
        gears = {gear.name: gear for gear in sizing.gears}
        inner, outer = (backlash_of(sizing.design, gears, mesh).mean for mesh in sizing.meshes)
        rows = dict(zip(system.labels.lines, system.arrays.backlash, strict=True))
        assert rows["set.sun-planet-1"] == pytest.approx(inner)
        assert rows["set.planet-ring-2"] == pytest.approx(outer)
        assert outer > inner


def test_tolerances_that_eat_the_backlash_fail_a_check():
    """h25 leaves nothing, and axes that come 35 µm nearer take 24 µm of it."""
    text = SPUR + '[gears]\nhelix_angle_deg = 0\nallowance = "{}25"\ncentre_allowance = "js9"\n'
    for series, status in (("h", Status.FAILS), ("c", Status.PASSES)):
        check = next(check for check in size(parse(text.format(series))).checks if check.mode == "backlash")
        assert check.status is status
    assert next(c for c in size(parse(text.format("h"))).checks if c.mode == "backlash").limit == pytest.approx(
        2 * 37e-6 * math.sin(TWENTY)
    )


@pytest.mark.parametrize("fit", ["cd", "25cd", "cd31", "i25", "CD25", ""])
def test_a_fit_that_is_none_is_refused_with_what_one_is(fit):
    told = problem(SPUR + f'[gears]\nallowance = "{fit}"\n')
    assert told.path == "gears.allowance"
    assert told.message.startswith(f"{fit!r} is not known")
    assert "cd25" in told.message
    assert "js11" in problem(SPUR + '[gears]\ncentre_allowance = "h7"\n').message


def test_fits_that_nothing_reads_are_told():
    bevel = changed(PAIR, 'wheel = "slow"\n', 'wheel = "slow"\nkind = "bevel"\naxis_angle_deg = 90\n')
    rules = '[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
    assert "this pair is bevel" in problem(bevel + 'wheel_allowance = "cd25"\n' + rules).message
    assert "this pair is bevel" in problem(bevel + '[pairs.stage.gears]\nallowance = "cd25"\n' + rules).message
    assert "give allowance, too" in problem(SPUR + '[pairs.stage.gears]\ncentre_allowance = "js7"\n').message


def test_a_centre_distance_beyond_the_table_is_refused_where_its_fit_is_written():
    huge = SPUR.replace("module_mm = 2", "module_mm = 100") + '[gears]\nallowance = "a25"\ncentre_allowance = "js7"\n'
    with pytest.raises(DesignError, match=r"  gears.centre_allowance.*up to 3150 mm"):
        size(parse(huge))


def test_without_a_fit_there_is_no_check_of_it():
    assert GearRules().allowance is None
    assert not [check for check in size(parse(SPUR)).checks if check.mode == "backlash"]
