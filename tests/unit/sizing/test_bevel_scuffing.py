"""Bevel gears against scuffing: their virtual cylindrical gears, and what makes them hotter."""

import math
from dataclasses import astuple, replace

import numpy as np
import pytest

from gearwright.identity import Kind, PartId
from gearwright.parts.bevel_geometry import BevelPair, BevelTooth
from gearwright.parts.iso6336 import GearSteel, Treatment
from gearwright.parts.iso10300 import BevelDuty, VirtualPair, rate_bevel, virtual_mesh
from gearwright.parts.scuffing import ScuffingMesh, flash_temperature, integral_temperature
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating import METHODS, rating_of
from gearwright.sizing.rating.iso6336_scuffing import oil_of, scuffing_checks
from gearwright.sizing.rating.iso10300 import SCUFFING, bevel_scuffing
from gearwright.spec import edited, read

DESIGN = read(shipped_design("ec120b"))
SIZING = size(DESIGN)
RATING = rating_of(DESIGN, "bevel", SIZING.teeth)
(BEVEL,) = (mesh.rating for mesh in SIZING.meshes if mesh.name == "bevel")
STEEL = GearSteel("case-hardened", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6)
DUTY = BevelDuty(2031.1, 158.5, 8e-6, 1.25)


def pair(spiral=35.0, **changes):
    tooth = BevelTooth(profile_shift=0.3)
    return replace(BevelPair((17, 43), 8.5e-3, 51e-3, math.radians(spiral), tooth=tooth), **changes)


def temperatures(bevel, duty=DUTY, rating=RATING):
    return bevel_scuffing(rating, rate_bevel(bevel, (STEEL, STEEL), duty, 3500.0 * 3600.0))


def scuffed(bevel, duty=DUTY, rating=RATING):
    return temperatures(bevel, duty, rating).integral


@pytest.mark.parametrize("spiral", [0.0, 12.0, 35.0])
def test_the_virtual_mesh_is_the_virtual_pair_of_iso_10300(spiral):
    """One geometry by two rooms: ε_α, ε_β, base pitch, working at the reference centre."""
    virtual = VirtualPair(pair(spiral))
    mesh = virtual_mesh(virtual)
    assert mesh.transverse_contact_ratio == pytest.approx(virtual.profile_ratio, rel=1e-12)
    assert mesh.overlap_ratio == pytest.approx(virtual.face_ratio, rel=1e-12, abs=1e-15)
    assert mesh.base_pitch == pytest.approx(virtual.base_pitch, rel=1e-12)
    assert mesh.working_angle == pytest.approx(virtual.transverse_angle, rel=1e-9)
    assert np.asarray(mesh.pitch_diameters) == pytest.approx(virtual.diameters, rel=1e-12)


def test_a_bevel_mesh_is_as_hot_as_the_cylindrical_pair_that_stands_for_it():
    """w_Bt = K_A K_V K_Hβ K_Hα F_mt/(0.85 b) at v_mt, by hand."""
    rated = rate_bevel(pair(), (STEEL, STEEL), DUTY, 3500.0 * 3600.0)
    loads, rules = rated.loads, RATING.rules.iso6336
    force = 2.0 * 2031.1 / pair().mean_diameters[0] / (0.85 * 51e-3)
    by_hand = ScuffingMesh(
        virtual_mesh(VirtualPair(pair())),
        force * 1.25 * loads.dynamic * loads.face_contact * loads.transverse_contact,
        force * 1.25,
        158.5 * pair().mean_diameters[0] / 2.0,
        rules.flank_roughness / 6.0,
        grade=rules.tolerance_class,
        elastic_modulus=RATING.material.elastic_modulus,
        poisson_ratio=RATING.material.poisson_ratio,
    )
    found, hand = bevel_scuffing(RATING, rated), integral_temperature(by_hand, oil_of(rules))
    assert astuple(found.integral) == pytest.approx(astuple(hand), rel=1e-12)
    plain = flash_temperature(by_hand, oil_of(rules))
    assert found.flash.friction == pytest.approx(plain.friction, rel=1e-12)
    assert found.flash.contact < plain.contact  # crowned teeth do not bear at their tips, where these slide most


def test_load_speed_and_roughness_heat_and_a_better_oil_bears_more():
    base = scuffed(pair())
    assert scuffed(pair(), replace(DUTY, pinion_torque=3000.0)).integral > base.integral
    assert scuffed(pair(), replace(DUTY, pinion_speed=300.0)).flash_mean > base.flash_mean
    rough = rating_of(edited(DESIGN, {"gears.iso6336.flank_roughness_um": 8}), "bevel", SIZING.teeth)
    assert scuffed(pair(), rating=rough).integral > base.integral
    oil = rating_of(edited(DESIGN, {"gears.iso6336.scuffing_stage": 12}), "bevel", SIZING.teeth)
    better = scuffed(pair(), rating=oil)
    assert better.integral == base.integral
    assert better.scuffing > base.scuffing


def test_a_design_is_checked_and_shows_it():
    (check,) = [check for check in SIZING.checks if str(check.part) == "bevel" and check.mode == "scuffing"]
    assert check.clause == "ISO/TR 13989-2, 6.2"
    assert (check.value, check.limit) == (BEVEL.scuffing.safety, 1.5)
    rows = [row for row in METHODS["iso10300"].factors(BEVEL) if row.chapter == "scuffing"]
    assert rows and all(row.clause.startswith("ISO/TR 13989-2, 6.2; as ISO/TS 6336-21") for row in rows)
    asked = size(edited(DESIGN, {"gears.iso6336.scuffing_safety": 1.7}))
    (check,) = [check for check in asked.checks if str(check.part) == "bevel" and check.mode == "scuffing"]
    assert check.limit == 1.7


@pytest.mark.parametrize("spiral", [0.0, 12.0, 35.0])
def test_lines_over_the_zone_bear_the_whole_force_wherever_they_are(spiral):
    """Σ p* l_b of lines one base pitch apart, each with its share at its middle; even about the middle of the path."""
    virtual = VirtualPair(pair(spiral))
    middle, quarter = virtual.load_share(0.0), 0.25 * virtual.path
    assert virtual.load_share(quarter) == pytest.approx(virtual.load_share(-quarter), rel=1e-9)
    step = virtual.base_pitch * math.cos(virtual.base_helix_angle)
    lines = [virtual._line(number * step) for number in range(-9, 10)]
    whole = virtual.effective_width / math.cos(virtual.base_helix_angle)
    assert middle * sum(line.peak * line.length for line in lines) == pytest.approx(whole * lines[9].peak, rel=1e-12)
    assert virtual.load_share(0.5 * virtual.path) == pytest.approx(0.0, abs=1e-6)  # tips fade out


def test_lines_that_all_bear_alike_share_by_the_contact_ratio():
    """Without crowning, e_LS → ∞, wide spirals bear 1/ε_vα, as ISO/TS 6336-20 has it, but for the shortened lines."""
    virtual = VirtualPair(pair(35.0), peak_exponent=1e6)
    flat = virtual.load_share(0.0) * (1.0 - (1.0 - math.sqrt(0.85)))
    assert flat == pytest.approx(1.0 / virtual.profile_ratio, rel=0.1)  # the zone holds 2 or 3 lines, not ε_γ of them


def test_the_flash_temperature_may_be_what_is_asked_for():
    asked = size(edited(DESIGN, {"gears.iso6336.scuffing_method": "both", "gears.iso6336.scuffing_stage": 12}))
    checks = [check for check in asked.checks if str(check.part) == "bevel" and check.mode == "scuffing"]
    assert sorted(check.symbol for check in checks) == ["S_B", "S_intS"]
    clause = next(check.clause for check in checks if check.symbol == "S_B")
    assert clause == "ISO/TS 6336-20 on the virtual cylindrical gears"


def test_contact_on_one_side_of_the_pitch_point_has_no_integral_temperature():
    """x_hm1 > 1: the wheel's tip ends before the pitch point, where X_ε has no meaning, as in cylindrical pairs."""
    sided = pair(tooth=BevelTooth(profile_shift=1.05))
    assert virtual_mesh(VirtualPair(sided)).addendum_contact_ratios[1] < 0.0
    found = temperatures(sided)
    assert found.integral is None
    assert found.flash.safety > 0.0
    (check,) = scuffing_checks(replace(BEVEL, scuffing=None), PartId(Kind.MESH, "bevel"), clauses=SCUFFING)
    assert (check.symbol, check.clause, check.value) == ("S_B", SCUFFING[1], BEVEL.flash.safety)
    rows = METHODS["iso10300"].factors(replace(BEVEL, scuffing=None))
    assert "scuffing" not in {row.chapter for row in rows}
