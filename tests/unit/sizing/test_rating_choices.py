"""Choices of a rating in the design file: static cases, methods C, two steels, rims, oils, reliability."""

import math

import pytest

from designs import problem
from gearwright.parts.agma2001 import reliability_factor, rim_factor_agma
from gearwright.parts.iso6336 import DynamicFactorBySpeed, LifeCurve, Treatment
from gearwright.sizing import size
from gearwright.sizing.insight import methods_beside
from gearwright.sizing.rating import METHODS, rating_of
from gearwright.spec import edited, parse

TEXT = """
schema = 1
name = "One pair"
level = "concept"
shafts = ["fast", "slow"]
[motors.drive]
shaft = "fast"
power_kw = 60
speed_rpm = 1500
[propellers.load]
shaft = "slow"
speed_rpm = 500
diameter_m = 2
[pairs.only]
pinion = "fast"
wheel = "slow"
pinion_teeth = 22
wheel_teeth = 66
module_mm = 5
face_width_mm = 45
[gears]
rating = "iso6336"
material = "carburised-9310"
[cases.run]
drive.rating = 1
share = 1
[cases.jam]
static = true
drive.torque_nm = 1500
"""
DESIGN = parse(TEXT)


def rated(**changes):
    design = edited(DESIGN, {f"gears.{key.replace('__', '.')}": value for key, value in changes.items()})
    return size(design)


def record(sizing):
    return sizing.meshes[0].rating


def modes(sizing):
    return {f"{check.part} {check.mode}": check for check in sizing.checks}


PLAIN = rated()


def test_a_static_case_is_held_against_static_strength_with_its_own_safeties():
    """Checks name the case; its stress is that of its torque without K_A, and the asked safeties are keys."""
    found = modes(PLAIN)
    for mode, limit in (("static pitting", 1.0), ("static tooth root", 1.4), ("yielding root", 1.0)):
        check = found[f"only.pinion {mode}"]
        assert check.case == "jam"
        assert check.limit == limit
    asked = modes(rated(iso6336__static_bending_safety=2.0))["only.wheel static tooth root"]
    assert asked.limit == 2.0
    plain = edited(DESIGN, {"gears.iso6336.tolerance_class": 5, "gears.iso6336.tip_relief_um": 0.0})
    torqued = edited(plain, {"cases.jam.drive.torque_nm": 3000})
    double, single = (record(size(each)).static.strengths[0] for each in (torqued, plain))
    assert float(double.bending_stress) / float(single.bending_stress) == pytest.approx(2.0, rel=0.03)
    assert record(rated()).static.strengths[0] == record(PLAIN).static.strengths[0]


def test_without_a_static_case_nothing_is_said_of_static_strength():
    calm = size(parse(TEXT[: TEXT.index("[cases.jam]")]))
    assert record(calm).static is None
    assert not any("static pitting" in name for name in modes(calm))


def test_methods_c_are_chosen_by_their_keys():
    chosen = record(rated(iso6336__dynamic_method="C", iso6336__root_method="C"))
    assert isinstance(chosen.factors.dynamic, DynamicFactorBySpeed)
    assert chosen.factors.bending[0].contact_ratio < 1.0
    assert record(PLAIN).factors.bending[0].contact_ratio is None
    slow = edited(
        DESIGN, {"gears.iso6336.dynamic_method": "C", "motors.drive.speed_rpm": 15, "propellers.load.speed_rpm": 5}
    )
    slope = next(row for row in _rows(size(slow)) if row.quantity == "slope")
    assert slope.limit == "greatest: up to 0.2 m/s"
    assert "only speed of K_V" in modes(rated(iso6336__dynamic_method="C"))


def test_a_wheel_of_its_own_steel_is_worked_by_the_hard_pinion():
    soft = {"steel": "through-hardened-alloy", "hardness_hv": 280.0}
    sizing = rated(iso6336__wheel=soft, iso6336__flank_roughness_um=1.0)
    found = record(sizing)
    assert found.mate_steel.treatment is Treatment.THROUGH_HARDENED
    assert found.steel.treatment is Treatment.CASE_HARDENED
    assert float(found.factors.contact_strength[1].work_hardening) > 1.0
    assert found.pitting[1] < record(PLAIN).pitting[1]
    assert any(row.chapter == "steel of the second gear" for row in _rows(sizing))
    making = METHODS["iso6336"].making(rating_of(sizing.design, "only"))
    assert "wheels and rings through-hardened-alloy MQ, 280 HV" in making.steel[1]


def test_a_thin_rim_raises_the_wheels_root_stress_by_the_standards_factor():
    thin = record(rated(rim_ratio=0.9))
    assert float(thin.factors.bending[1].rim) == pytest.approx(float(rim_factor_agma(0.9)))
    assert float(thin.factors.bending[0].rim) == 1.0


def test_reliability_divides_the_strengths_by_the_table_of_agma():
    sure = record(rated(iso6336__reliability=0.999))
    assert sure.steel.bending_strength == pytest.approx(record(PLAIN).steel.bending_strength / 1.25)
    assert float(reliability_factor(0.999)) == pytest.approx(1.25)
    assert "AGMA 2001-D04, table 11" in sure.steel.source
    assert min(sure.bending) < min(record(PLAIN).bending)


@pytest.mark.parametrize(("part", "factor"), [(0.5, 0.7), (0.9, 0.85), (0.999, 1.25), (0.9999, 1.5)])
def test_safeties_fall_by_the_factor_of_reliability_and_by_nothing_else(part, factor):
    """Film and running in follow the tabulated σ_Hlim: at 0.9999 it is 1500/1.5 MPa, where Z_L would be another."""
    plain, other = record(PLAIN), record(rated(iso6336__reliability=part))
    for kind in ("pitting", "bending"):
        for was, found in zip(getattr(plain, kind), getattr(other, kind), strict=True):
            assert found == pytest.approx(was / factor, rel=1e-9)


def test_some_pitting_and_the_end_of_the_curves_are_keys():
    pitted = record(rated(iso6336__some_pitting=True)).steel
    assert pitted.contact_life == LifeCurve((6e5, 1e7, 1e9, 1e10), (1.6, 1.3, 1.0, 0.85))
    assert record(rated(iso6336__life_factor_1e10=1.0)).steel.bending_life.factors[-1] == 1.0


def test_both_temperatures_of_scuffing_are_shown_and_one_is_judged():
    assert {"only scuffing"} <= set(modes(PLAIN))
    assert [check.symbol for check in PLAIN.checks if check.mode == "scuffing"] == ["S_intS"]
    both = [check.symbol for check in rated(iso6336__scuffing_method="both").checks if check.mode == "scuffing"]
    assert sorted(both) == ["S_B", "S_intS"]
    flash = rated(iso6336__scuffing_method="flash")
    assert [check.symbol for check in flash.checks if check.mode == "scuffing"] == ["S_B"]
    assert record(PLAIN).flash.safety == record(flash).flash.safety


def test_the_base_of_the_oil_lowers_friction_and_temperatures():
    mild = record(rated(iso6336__oil_type="polyalphaolefin"))
    assert mild.scuffing.friction == pytest.approx(0.8 * record(PLAIN).scuffing.friction)
    assert mild.flash.friction == pytest.approx(0.8 * record(PLAIN).flash.friction)
    hot = record(rated(iso6336__oil_viscosity_100=10.0))
    assert hot.scuffing.friction != record(PLAIN).scuffing.friction


def test_micropitting_is_assessed_where_the_oils_load_stage_is_given():
    assert record(PLAIN).micropitting is None
    film = rated(iso6336__micropitting_stage=10.0, iso6336__micropitting_safety=0.8)
    check = modes(film)["only micropitting"]
    assert check.value == record(film).micropitting.safety
    assert check.limit == 0.8
    assert (
        record(rated(iso6336__micropitting_stage=8.0)).micropitting.permissible > record(film).micropitting.permissible
    )


def test_micropitting_reads_the_relief_that_the_dynamic_factor_reads():
    """X_Ca = 1 + C_a/C_eff (0.24 ε_2 + 0.71 ε_2²), ε_2 = 66/(2 π) (tan α_a2 − tan 20°), cos α_a2 = 66 cos 20°/68."""
    angle = math.radians(20.0)
    longest = 66.0 / (2.0 * math.pi) * (math.tan(math.acos(66.0 / 68.0 * math.cos(angle))) - math.tan(angle))
    told = ({"iso6336__tip_relief_um": 0.0}, {"iso6336__tip_relief_um": 3.0}, {})
    films = [record(rated(iso6336__micropitting_stage=10.0, iso6336__tolerance_class=5, **key)) for key in told]
    for found in films:
        part = float(found.factors.relief.amount / found.factors.relief.deflection)
        by_hand = 1.0 + part * (0.24 * longest + 0.71 * longest**2)
        assert found.micropitting.tip_relief == pytest.approx(by_hand, rel=1e-9)
    assert films[0].micropitting.tip_relief == 1.0
    assert films[0].micropitting.safety < films[1].micropitting.safety < films[2].micropitting.safety
    coarse = record(rated(iso6336__micropitting_stage=10.0, iso6336__tolerance_class=7))
    assert coarse.micropitting.tip_relief == 1.0


def test_the_table_of_methods_has_the_new_rows():
    names = {row.aspect: row for row in methods_beside(rated(rim_ratio=0.9, iso6336__root_method="C"))[0].rows}
    for aspect in ("static S_H", "static S_F, S_y", "scuffing S_B", "rim Y_B, K_B", "load at the tip Y_ε"):
        assert "iso6336" in names[aspect].values
    assert names["rim Y_B, K_B"].values["agma2001"][1] == pytest.approx(names["rim Y_B, K_B"].values["iso6336"][1])


AGMA = parse(TEXT.replace('rating = "iso6336"', 'rating = "agma2001"'))


def test_agma_takes_a_softer_wheel_its_hardness_ratio_and_yielding():
    soft = size(edited(AGMA, {"gears.agma2001.wheel": {"hardness_hb": 300.0}, "gears.rim_ratio": 0.9}))
    found, plain = record(soft), record(size(AGMA))
    assert float(found.factors.hardness_ratio) > 1.0
    assert plain.factors.hardness_ratio == 1.0
    assert found.factors.rims == (1.0, pytest.approx(float(rim_factor_agma(0.9))))
    assert found.pitting[1] < plain.pitting[1]
    check = modes(soft)["only.wheel yielding root"]
    assert check.case == "jam"
    assert check.value < modes(size(AGMA))["only.wheel yielding root"].value


def test_what_the_standards_do_not_have_is_named_by_its_key():
    ring = TEXT.replace('wheel = "slow"\n', 'wheel = "slow"\ninternal = true\ngears = { rim_thickness_ratio = 2.5 }\n')
    told = problem(ring, sized=True)
    assert told.path == "pairs.only.gears.rim_thickness_ratio"
    assert "clause 9" in told.message
    wheel = '[gears.iso6336.wheel]\nsteel = "case-hardened"\nhardness_hv = 300\n'
    assert problem(TEXT + wheel).path == "gears.iso6336.wheel.hardness_hv"
    assert problem(TEXT + wheel.replace("case-hardened", "wood")).path.startswith("gears.iso6336.wheel")
    agma = TEXT.replace('"iso6336"', '"agma2001"') + "[gears.agma2001.wheel]\ngrade = 3\n"
    assert problem(agma).path == "gears.agma2001.wheel.grade"


def _rows(sizing):
    return list(METHODS["iso6336"].factors(record(sizing)))


def test_the_search_gives_rings_their_steel_and_not_planets():
    """Open teeth of a set with soft rings weigh their suns and planets as those of a set without."""
    text = TEXT[: TEXT.index("[pairs.only]")] + '[planetaries.set]\nsun = "fast"\nring = "ground"\ncarrier = "slow"\n'
    text += 'planets = 3\n[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
    hard, soft = (
        size(parse(text + more))
        for more in ("", '[gears.iso6336.wheel]\nsteel = "nitrided"\nhardness_hv = 650\nyield_strength_mpa = 700\n')
    )
    sun, planet = (next(mesh for mesh in each.meshes if mesh.row == "sun-planet").rating for each in (hard, soft))
    assert planet.mate_steel is None
    assert sun.steel == planet.steel
    ring = next(mesh for mesh in soft.meshes if mesh.row == "planet-ring").rating
    assert ring.mate_steel.treatment is Treatment.NITRIDED
