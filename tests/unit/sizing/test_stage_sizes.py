"""Modules and face widths of stages: the list of ISO 54, the least width in whole millimetres, pairs on common axes."""

import math
import random

import pytest

from designs import PAIR, changed
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import STANDARD_MODULES
from gearwright.spec import at_level, edited, parse, read
from mounted_designs import HELICOPTER

SERIES_I = (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50)
SERIES_II = (1.125, 1.375, 1.75, 2.25, 2.75, 3.5, 4.5, 5.5, 7, 9, 11, 14, 18, 22, 28, 36, 45)
"""ISO 54:1996, table 1, without 6.5 mm, which the standard asks to avoid."""
ISO = PAIR + 'pinion_teeth = 23\nwheel_teeth = 69\n[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'


def test_standard_modules_are_both_series_of_iso_54():
    assert sorted(SERIES_I + SERIES_II) == list(STANDARD_MODULES)


def stage(sizing, name):
    """Return module and face width of a stage [m], and the least safety of its meshes over the asked one."""
    gear = next(gear for gear in sizing.gears if gear.stage == name)
    margins = [min(mesh.rating.bending_margin, mesh.rating.contact_margin) for mesh in sizing.meshes]
    return gear.module, gear.face_width, min(margins)


def lighter_widths(design, module, least, widest, most):
    """Yield whole widths of a module that is given [mm], from the least, whose complete gearbox is lighter [kg]."""
    for width in range(math.ceil(min(least, widest) - 1e-9), math.floor(widest + 1e-9) + 1):
        other = size(edited(design, {"overrides.stage.module_mm": module, "overrides.stage.face_width_mm": width}))
        if complete_mass(other).total >= most * (1.0 - 1e-9):
            return
        yield width, other


@pytest.mark.parametrize(("helix", "power"), [(0, 100), (0, 400), (15, 100), (15, 900), (25, 30)])
def test_no_standard_module_and_whole_width_give_a_lighter_complete_gearbox_that_passes(helix, power):
    """Of all modules from 0.7 times the chosen one, and widths from six modules and the asked overlap to the widest."""
    text = ISO.replace("power_kw = 100", f"power_kw = {power}") + f"helix_angle_deg = {helix}\n"
    sizing = size(parse(text))
    module, width, margin = stage(sizing, "stage")
    assert [check.name for check in sizing.checks if check.fails] == [] and margin >= 1.0 - 1e-9
    assert 1e3 * module in [pytest.approx(standard) for standard in STANDARD_MODULES]
    assert 1e3 * width == pytest.approx(round(1e3 * width))
    slant = math.radians(helix)
    overlap, looked = 1.15 * math.pi / math.sin(slant) if helix else 0.0, 0
    for other in (other for other in STANDARD_MODULES if other >= 0.7e3 * module):
        least, widest = max(6.0, overlap) * other, min(20.0, 0.8 * 23 / math.cos(slant)) * other
        for tried, found in lighter_widths(sizing.design, other, least, widest, complete_mass(sizing).total):
            assert [check.name for check in found.checks if check.fails] != [], (other, tried)
            looked += 1
    assert looked > 10


@pytest.mark.parametrize("method", ["iso6336", "agma2001"])
@pytest.mark.parametrize("modules", [2.0, 6.0, 9.0])
def test_a_face_is_no_narrower_than_the_rules_say_though_its_teeth_would_bear_more(method, modules):
    """Teeth of 2.5 mm that 5 kW hardly load."""
    text = changed(ISO.replace("power_kw = 100", "power_kw = 5"), 'rating = "iso6336"', f'rating = "{method}"')
    text += f"[gears.{method}]\nnarrowest_modules = {modules}\n"
    _, width, margin = stage(size(edited(parse(text), {"pairs.stage.module_mm": 2.5})), "stage")
    assert 1e3 * width == pytest.approx(math.ceil(2.5 * modules)) and margin > 1.0


@pytest.mark.parametrize("method", ["iso6336", "agma2003"])
@pytest.mark.parametrize("modules", [2.0, 6.0, 7.5])
def test_so_is_that_of_bevel_gears_over_their_mean_module(method, modules):
    text = changed(BEVEL.format(22, 66).replace("power_kw = 100", "power_kw = 2"), "iso6336", method)
    text = changed(text, "spiral_angle_deg = 30\n", "")
    text += f"[gears.{method}]\nnarrowest_modules = {modules}\n"
    module, width, margin = stage(size(edited(parse(text), {"pairs.stage.outer_module_mm": 5})), "stage")
    assert width >= modules * module > width - 1e-3 and margin > 1.0


def test_a_helical_pair_is_at_least_as_wide_as_its_overlap_asks():
    """ε_β = b sin β/(π m_n): the width that gives the asked overlap ratio, in whole millimetres."""
    text = ISO.replace("power_kw = 100", "power_kw = 10") + "helix_angle_deg = 30\noverlap_ratio = {}\n"
    for overlap in (1.0, 1.4):
        sizing = size(parse(text.format(overlap) + "[gears.iso6336]\nwidest_diameters = 3\n"))
        module, width, margin = stage(sizing, "stage")
        assert width >= overlap * math.pi * module / math.sin(math.radians(30.0)) - 1e-9 and margin >= 1.0 - 1e-9


def test_without_standard_modules_no_module_beside_the_chosen_gives_a_lighter_complete_gearbox():
    text = ISO + "[gears.iso6336]\nstandard_modules = false\nwidest_modules = 9\nwidest_diameters = 0.6\n"
    sizing, looked = size(parse(text)), 0
    module, width, margin = stage(sizing, "stage")
    assert 1e3 * width == pytest.approx(round(1e3 * width)) and margin >= 1.0 - 1e-9
    for part in (0.9, 0.97, 1.03, 1.1):
        other = 1e3 * part * module
        for tried, found in lighter_widths(sizing.design, other, 6.0 * other, 9.0 * other, complete_mass(sizing).total):
            assert [check.name for check in found.checks if check.fails] != [], (other, tried)
            looked += 1
    assert looked > 10


FREE = '[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n[gears.iso6336]\nstandard_modules = false\n'
SET = '[planetaries.stage]\nsun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = 3\n'
KINDS = {
    "spur": "",
    "helical": "",
    "internal": "internal = true\n",
    "bevel": 'kind = "bevel"\naxis_angle_deg = 90\nspiral_angle_deg = 30\n',
}


def of_any_power(kind, seed):
    """Return a stage of random teeth and power, whose modules are as they come, as text."""
    draw = random.Random(f"{kind} {seed}")
    if kind == "set":
        sun, planet = 3 * draw.randint(7, 13), 3 * draw.randint(7, 16)
        own, ratio = f"sun_teeth = {sun}\nplanet_teeth = {planet}\n", 2.0 + 2.0 * planet / sun
        text = changed(PAIR, '[pairs.stage]\npinion = "fast"\nwheel = "slow"\n', SET)
    else:
        pinion, wheel = draw.randint(19, 35), draw.randint(40, 100)
        own, ratio = f"pinion_teeth = {pinion}\nwheel_teeth = {wheel}\n{KINDS[kind]}", wheel / pinion
        text = PAIR
    text = changed(changed(text, "2000", repr(6000.0 / ratio)), "100", f"{10.0 ** draw.uniform(1.0, 3.3):.1f}")
    helix = f"[gears]\nhelix_angle_deg = {draw.randint(8, 30)}\n" if kind == "helical" else "[gears]\n"
    return text + own + changed(FREE, "[gears]\n", helix)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("kind", [*KINDS, "set"])
def test_modules_as_they_come_bear_their_loads_with_whole_millimetres_of_width(kind, seed):
    """A face that is cut to whole millimetres asks for a larger module; what is sized passes."""
    _, width, margin = stage(size(parse(of_any_power(kind, seed))), "stage")
    assert 1e3 * width == pytest.approx(round(1e3 * width), abs=1e-9)
    assert margin >= 1.0 - 1e-6


def test_pairs_on_common_axes_have_the_distance_of_the_one_that_needs_more():
    text = PAIR.replace('["fast", "slow"]', '["fast", "slow", "back"]')
    text = text.replace('shaft = "slow"\nspeed_rpm = 2000', 'shaft = "back"\nspeed_rpm = 700')
    text += "pinion_teeth = 23\nwheel_teeth = 69\n"
    text += '[pairs.next]\npinion = "slow"\nwheel = "back"\npinion_teeth = 25\nwheel_teeth = 71\n'
    alone = size(parse(text))
    tied = size(parse(text + 'coaxial_with = "stage"\n'))
    need = {gear.stage: gear.module for gear in alone.gears}
    have = {gear.stage: gear.module for gear in tied.gears}
    distance = max(need["stage"] * 92 / 2.0, need["next"] * 96 / 2.0)
    assert have["stage"] * 92 / 2.0 == pytest.approx(distance)
    assert have["next"] * 96 / 2.0 == pytest.approx(distance)


BEVEL = (
    PAIR
    + """kind = "bevel"
axis_angle_deg = 90
spiral_angle_deg = 30
pinion_teeth = {}
wheel_teeth = {}
[gears]
rating = "iso6336"
material = "carburised-9310"
"""
)


@pytest.mark.parametrize("asked", [20.0, 66.0, 99.0])
@pytest.mark.parametrize("teeth", [(17, 51), (22, 66)])
def test_a_bevel_pair_is_not_wider_than_a_third_of_its_cone_or_ten_modules(teeth, asked):
    """R_e = m_et √(z_1² + z_2²)/2; m_mn = cos β_m (m_et − b/(2 R_e/m_et)) (ISO 23509)."""
    given = f'[overrides]\n"stage.outer_module_mm" = 6\n"stage.face_width_mm" = {asked}\n'
    sizing = size(parse(BEVEL.format(*teeth) + given))
    cone = math.hypot(*teeth) / 2.0
    widest = 6.0 * min(cone / 3.0, 10.0)
    assert (widest == 60.0) == (teeth == (22, 66))
    width = min(asked, widest)
    mean = math.cos(math.radians(30.0)) * (6.0 - width / (2.0 * cone))
    for gear in sizing.gears:
        assert 1e3 * gear.face_width == pytest.approx(width)
        assert 1e3 * gear.module == pytest.approx(mean)
    check = next(check for check in sizing.checks if check.name == "stage.pinion face width")
    assert 1e3 * check.value == pytest.approx(asked)
    assert 1e3 * check.limit == pytest.approx(widest)


def test_an_open_bevel_width_is_the_least_whole_millimetre():
    text = HELICOPTER.replace('"bevel.outer_module_mm" = 8.5\n"bevel.face_width_mm" = 51\n', "")
    sizing = size(parse(text))
    gear = next(gear for gear in sizing.gears if gear.name == "bevel.pinion")

    def margin(sized):
        mesh = next(mesh for mesh in sized.meshes if mesh.stage == "bevel")
        return min(mesh.rating.bending_margin, mesh.rating.contact_margin)

    cone = math.hypot(17, 43) / 2.0
    outer = gear.module / math.cos(math.radians(35.0)) + gear.face_width / (2.0 * cone)
    assert 1e3 * outer in [pytest.approx(module) for module in STANDARD_MODULES]
    width = 1e3 * gear.face_width
    assert width == pytest.approx(round(width)) and margin(sizing) >= 1.0 - 1e-9
    given = {"overrides.bevel.outer_module_mm": 1e3 * outer, "overrides.bevel.face_width_mm": width - 1.0}
    assert margin(size(edited(sizing.design, given))) < 1.0
    lower = max(module for module in STANDARD_MODULES if module < 1e3 * outer - 1e-6)
    widest = min(cone / 3.0, 10.0) * lower
    given = {"overrides.bevel.outer_module_mm": lower, "overrides.bevel.face_width_mm": widest}
    assert margin(size(edited(sizing.design, given))) < 1.0


def test_pairs_on_common_axes_keep_one_distance_where_a_standard_sizes_them_and_both_bear():
    sizing = size(at_level(read(shipped_design("off-set-h1")), "preliminary"))
    distances = {mesh.stage: mesh.centre_distance for mesh in sizing.meshes}
    assert distances["first"] == pytest.approx(distances["motor-stage"], rel=1e-12)
    assert not [check.name for check in sizing.checks if check.fails]


def test_pairs_on_common_axes_with_modules_of_two_distances_fail_and_say_by_how_much():
    given = {"pairs.first.module_mm": 4.0, "pairs.motor-stage.module_mm": 4.02}
    sizing = size(edited(read(shipped_design("off-set-h1")), given))
    (check,) = [check for check in sizing.checks if check.what.startswith("axes of first")]
    apart = abs(distance_of(sizing, "first") - distance_of(sizing, "motor-stage"))
    assert check.fails and check.value == pytest.approx(apart) and apart > 1e-4


def distance_of(sizing, stage):
    return next(mesh.centre_distance for mesh in sizing.meshes if mesh.stage == stage)


def test_a_stage_that_would_scuff_has_the_module_and_width_with_which_it_does_not():
    """Mixed with a worse oil: its gears weigh more than if less were asked against scuffing."""
    design = edited(at_level(read(shipped_design("mixed")), "preliminary"), {"gears.iso6336.scuffing_stage": 8})
    sizing, easier = size(design), size(edited(design, {"gears.iso6336.scuffing_safety": 1.0}))
    assert [check.name for check in sizing.checks if check.fails] == []
    assert easier.mass < 0.98 * sizing.mass


def test_stages_of_equal_engines_have_one_size_though_each_is_loaded_most_in_a_case_of_its_own():
    """One engine of the helicopter out of two gives more while the other stands: two cases, one for each."""
    sizing = size(read(shipped_design("twin-engine-helicopter")))
    sizes = [{(gear.module, gear.face_width) for gear in sizing.gears if gear.stage == name}
             for name in ("input-1", "input-2")]  # fmt: skip
    cases = [{mesh.case for mesh in sizing.meshes if mesh.stage == name} for name in ("input-1", "input-2")]
    assert sizes[0] == sizes[1] and cases[0] != cases[1]
