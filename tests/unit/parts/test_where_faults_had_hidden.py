"""Places of the rating that no usual pair shows: far ends of faces and curves, arrays of which a part is good."""

import cmath
import math
import sys
from dataclasses import replace

import numpy as np
import pytest

from gearwright.errors import DesignError, SolveError
from gearwright.parts import scuffing
from gearwright.parts.agma908 import HobbedPair, LoadPlace, bending_geometry
from gearwright.parts.agma2001 import hardened_pinion_factor
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth, bevel_blank
from gearwright.parts.iso6336 import (
    MeshGeometry,
    ShaperCutter,
    StrengthLine,
    ToothProportions,
    Treatment,
    allowable_stress,
    bending_life_curve,
    contact_life_curve,
    endurable_cycles,
)
from gearwright.parts.iso6336.geometry import LoadedTooth, root_section, shaped_fillet
from gearwright.parts.losses import oil_viscosity
from gearwright.parts.micropitting import BASES, OilGrade

FLASH = sys.modules[scuffing.Oil.__module__]
TWENTY = math.radians(20.0)


def near(value: float) -> object:
    return pytest.approx(value, rel=1e-10)


@pytest.mark.parametrize("cutter", [None, 0.09])
@pytest.mark.parametrize("side", [0, 1])
def test_the_ends_of_a_bevel_blank_are_points_turned_by_the_pitch_angle(side, cutter):
    """ISO 23509:2016, 7.7 and 7.9: a tip at R + i h, turned by δ, is d_a/2 above the axis; faces rise by tan θ_a."""
    pair = BevelPair((14, 39), 4.5e-3, 25e-3, math.radians(35.0), tooth=BevelTooth(profile_shift=0.4))
    blank = bevel_blank(pair, cutter)
    slope = math.tan(blank.root_angle_below[1 - side])
    turn = cmath.rect(1.0, math.atan2((14, 39)[side], (39, 14)[side]))
    outer = 4.5e-3 * math.hypot(14, 39) / 2.0
    mean = 4.5e-3 * math.cos(math.radians(35.0)) * (outer - 12.5e-3) / outer * (1.0 + (0.4, -0.4)[side])
    ends = [
        2.0 * ((outer - place) * turn + 1j * (mean + (12.5e-3 - place) * slope) * turn).imag for place in (0, 25e-3)
    ]
    assert blank.outer_tip_diameter[side] == near(ends[0])
    assert blank.inner_tip_diameter[side] == near(ends[1])


def test_stresses_that_would_last_for_more_cycles_than_numbers_reach_last_for_ever():
    """N = 5e7 e^p, p = ln 200 ln(1/f)/ln(1/0.85) of ISO 6336-6, clause 5: finite at p = 590, endless from 600 on."""
    curve = contact_life_curve(Treatment.CASE_HARDENED)
    factors = {p: math.exp(-p * math.log(1.0 / 0.85) / math.log(200.0)) for p in (590.0, 610.0, 745.0)}
    assert endurable_cycles(curve, factors[590.0]) == pytest.approx(5e7 * math.exp(590.0), rel=1e-9)
    assert endurable_cycles(curve, factors[610.0]) == endurable_cycles(curve, factors[745.0]) == math.inf
    assert bending_life_curve(Treatment.NITROCARBURISED).factors == (1.1, 1.0, 0.85)


@pytest.mark.parametrize(("given", "nearest"), [(195.0, "nearest is 200"), (365.0, "nearest is 360")])
def test_a_hardness_outside_a_row_is_answered_with_the_end_that_is_next(given, nearest):
    with pytest.raises(DesignError, match=nearest):
        allowable_stress(StrengthLine(1.313e6, 373e6, (200.0, 360.0)), given)


@pytest.mark.parametrize("wheel", [170.0, 180.0, 300.0, 400.0, 430.0])
@pytest.mark.parametrize("rough", [0.0, 0.8e-6])
def test_a_hard_pinion_works_wheels_as_if_they_had_180_to_400_brinell(wheel, rough):
    """AGMA 2001-D04, 14.2: 1 + 0.00075 e^(−0.0112 f_p) (450 − HB), f_p in µin: 1 µm is 39.37 µin."""
    hardness = {170.0: 180.0, 430.0: 400.0}.get(wheel, wheel)
    expected = 1.0 + 0.00075 * math.exp(-0.0112 * rough / 25.4e-9) * (450.0 - hardness)
    assert hardened_pinion_factor(wheel, rough) == near(expected)


@pytest.mark.parametrize(
    ("base", "lubricant", "scale", "exponent"),
    [
        ("mineral", 1.0, 2.657e-8, 0.1348),
        ("polyalphaolefin", 0.8, 1.466e-8, 0.0507),
        ("polyglycol", 0.7, 1.392e-8, 0.1572),
        ("water-soluble polyglycol", 0.6, 1.392e-8, 0.1572),
        ("phosphate ester", 1.3, 2.657e-8, 0.1348),
        ("traction", 1.5, 2.657e-8, 0.1348),
    ],
)
def test_oils_stiffen_under_pressure_by_their_base(base, lubricant, scale, exponent):
    """ISO/TR 15144-1:2014, eqs 8 to 11: α_38 = s η_38^e, α = α_38 (1 + 516 (1/T − 1/311 K)); table 3: X_L."""
    oil = OilGrade(220e-6, 19e-6, 890.0, BASES[base])
    low, high = math.log10(math.log10(220.7)), math.log10(math.log10(19.7))
    part = math.log10(311.0 / 313.0) / math.log10(373.0 / 313.0)
    viscosity = (10.0 ** (10.0 ** (low + (high - low) * part)) - 0.7) * 1e-6 * (890.0 - 0.7 * (311.0 - 289.0))
    assert float(oil.pressure_coefficient(38.0)) == near(scale * viscosity**exponent)
    warm = 1.0 + 516.0 * (1.0 / 363.0 - 1.0 / 311.0)
    assert float(oil.pressure_coefficient(90.0)) == near(scale * viscosity**exponent * warm)
    assert oil.base.lubricant == lubricant


def test_one_mesh_of_an_array_that_interferes_is_enough_for_none_to_roll():
    usual = MeshGeometry((20.0, 60.0), 2e-3, 20e-3, 80e-3, (22e-3, 62e-3))
    tall = replace(usual, tip_radii=(22e-3, 75e-3))
    both = replace(usual, tip_radii=(22e-3, np.array([62e-3, 75e-3])))
    assert (usual.rolls, tall.rolls, both.rolls) == (True, False, False)


def test_root_sections_of_an_array_are_those_of_its_teeth_one_by_one():
    """Newton's iteration ends when all are found, not the first: 9 teeth and 4000, small and large fillets."""
    teeth, radius, dedendum = np.array([9.0, 17.3, 60.0, 4000.0]), np.array([0.1, 0.38, 0.25, 0.4]), 1.25
    load = teeth + 1.7
    whole = root_section(LoadedTooth(teeth, load, TWENTY, ToothProportions(dedendum, radius, 0.5)))
    for place in range(len(teeth)):
        tooth = ToothProportions(dedendum, radius[place], 0.5)
        alone = root_section(LoadedTooth(teeth[place], load[place], TWENTY, tooth))
        for name in ("tangent_angle", "chord", "fillet_radius", "lever", "form", "stress_correction"):
            assert getattr(whole, name)[place] == pytest.approx(float(getattr(alone, name)), rel=1e-11), name
    with pytest.raises(SolveError):  # the load of one tooth lies below its root
        low = load - np.array([0.0, 0.0, 0.0, 6.0])
        root_section(LoadedTooth(teeth, low, TWENTY, ToothProportions(dedendum, radius, 0.5)))


def test_shaped_fillets_of_an_array_are_those_of_its_rings_one_by_one():
    rings, shifts = np.array([60.0, 81.0, 150.0, 400.0]), np.array([-0.3, 0.0, 0.2, 0.6])
    cutters = np.array([20.0, 31.0, 50.0, 35.0])
    whole = shaped_fillet(ToothProportions(1.25, 0.2, shifts, cutter=ShaperCutter(cutters, 0.1)), rings, TWENTY)
    for place in range(len(rings)):
        tooth = ToothProportions(1.25, 0.2, shifts[place], cutter=ShaperCutter(cutters[place], 0.1))
        alone = shaped_fillet(tooth, rings[place], TWENTY)
        for name in alone._fields:
            assert getattr(whole, name)[place] == pytest.approx(float(getattr(alone, name)), rel=1e-11), name


def test_an_oil_of_one_viscosity_thins_as_a_turbine_oil():
    hot = 100e-6 * oil_viscosity(373.15) / oil_viscosity(313.15)
    assert float(OilGrade(100e-6).kinematic(100.0)) == near(hot)
    assert float(OilGrade(100e-6).kinematic(70.0)) == near(float(OilGrade(100e-6, hot).kinematic(70.0)))


def test_scuffing_counts_supply_structure_and_oil_as_printed():
    """ISO/TS 6336-20:2017, eq. 22, table 2 and eq. 27."""
    assert (FLASH.SPRAY, FLASH.DIP, FLASH.SUBMERGED) == (1.2, 1.0, 0.2)
    structures = ["AUSTENITIC", "CASE_HARDENED_USUAL", "PHOSPHATED", "COPPER_PLATED", "NITRIDED"]
    assert [getattr(FLASH, name) for name in structures] == [0.85, 1.0, 1.25, 1.5, 1.5]
    oils = ["MINERAL", "POLYALPHAOLEFIN", "NON_WATER_POLYGLYCOL", "WATER_POLYGLYCOL", "PHOSPHATE_ESTER"]
    assert [getattr(FLASH, name) for name in oils] == [1.0, 0.8, 0.7, 0.6, 1.3]


@pytest.mark.parametrize(("overlap", "same"), [(0.95, False), (1.05, True), (1.2, True), (1.6, True)])
def test_helical_teeth_of_agma_are_loaded_at_their_tips_from_an_overlap_of_one(overlap, same):
    """AGMA 908-B89, clause 5: below it at the highest point of single contact."""
    slant = math.radians(18.0)
    pair = HobbedPair((25, 64), helix_angle=slant, face_width=overlap * math.pi / math.sin(slant))
    heights = [float(bending_geometry(pair, 0, place).height) for place in (LoadPlace.SINGLE_CONTACT, LoadPlace.TIP)]
    assert (heights[0] == heights[1]) is same
