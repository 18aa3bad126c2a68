"""Pieces of ratings where they end: shifted centres, small pinions, rings and their cutters, cases that do not last."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.parts.agma2001 import load_distribution_factor
from gearwright.parts.gears import ToothShift, contact_angles
from gearwright.parts.iso6336 import (
    GearSteel,
    Treatment,
    knee_curve,
    shifted_mesh,
    static_notch_sensitivity,
    static_strength,
    static_work_hardening,
)
from gearwright.parts.iso6336.loads import lead_allowance
from gearwright.sizing.rating import (
    Ask,
    iso6336_scuffing as flanks,
    iso10300 as bevels,
    stage_width_ratio,
    under_spectrum,
)
from gearwright.sizing.rating.context import Context
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.iso6336_inputs import _lasting, beyond_ranges, steel_of
from gearwright.sizing.rating.iso6336_scuffing import oil_film
from gearwright.sizing.rating.iso10300 import bevel_surfaces
from gearwright.sizing.rating.lewis_hertz import LewisHertz
from gearwright.sizing.rating.protocol import Load, LoadedMesh, steel_rows
from gearwright.spec.design.rules import RingCutter
from rated_pieces import METHODS, loaded, near, rating


def test_shifted_gears_press_at_their_working_circles_by_lewis_and_hertz():
    """d_w = 2 a_w z/(z_1 + z_2), tan β_w = tan β d_w/d, cos α_wt = a cos α_t/a_w, tan α_wn = tan α_wt cos β_w."""
    own = rating("lewis-hertz")
    lean, cosine = own.helix_angle, math.cos(own.helix_angle)
    reference = 41.0 / cosine
    centre = reference + 0.6
    own = replace(own, shifts=own.shifts._replace(centre=centre))
    load = Load("x", 690.0, Ask(30.0, (23, 59), 10.0), 1.0)
    rated = LewisHertz().rate(LoadedMesh(own, 4e-3, 40e-3, load, (load,), (0.0, 0.0)))
    working = [2.0 * centre * 4e-3 * z / 82.0 for z in (23, 59)]
    force = 1380.0 / working[0]
    assert rated.bending_stress == near(force / (40e-3 * 4e-3 * rated.form_factor))
    turned = math.atan(math.tan(lean) * centre / reference)
    transverse = math.acos(reference / centre * math.cos(math.atan(math.tan(own.rules.pressure_angle) / cosine)))
    normal = math.atan(math.tan(transverse) * math.cos(turned))
    angles = contact_angles(normal, turned, transverse=own.rules.contact_angles == "transverse")
    stress = 0.418 * math.sqrt(
        force * own.material.elastic_modulus * (2.0 / working[0] + 2.0 / working[1]) * math.cos(angles.line)
        / (40e-3 * math.cos(angles.pressure) * math.sin(angles.pressure))
    )  # fmt: skip
    assert rated.contact_stress == pytest.approx(stress, rel=2e-3)  # 0.418 is √(0.35/2) to three digits


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_shifted_mesh_has_its_lengths_in_modules(sign):
    """ISO 21771: r = |z| m_n/(2 cos β), tips at r ± (1 + x + k) m_n, a_w as given or r_2 ± r_1."""
    shifts = ToothShift(0.3, -0.05), ToothShift(-0.1, -0.02)
    lean = math.radians(15.0)
    given = {"pressure_angle": math.radians(20.0), "helix_angle": lean, "module": 3e-3, "face_width": 25e-3}
    first, second = (z * 3e-3 / (2.0 * math.cos(lean)) for z in (20.0, 70.0))
    free = shifted_mesh((20.0, sign * 70.0), shifts, None, **given)
    held = shifted_mesh((20.0, sign * 70.0), shifts, 30.0, **given)
    assert (free.centre_distance, held.centre_distance) == (near(second + sign * first), near(90e-3))
    assert free.tip_radii == held.tip_radii == pytest.approx((first + 1.25 * 3e-3, second + sign * 0.88 * 3e-3))
    assert [tooth.profile_shift for tooth in free.proportions] == [0.3, -0.1]
    assert (free.face_width, free.module, free.helix_angle) == (25e-3, 3e-3, lean)


def test_a_steel_keeps_its_own_lives_and_takes_those_that_the_rules_ask_for():
    own = rating("iso6336")
    asked = replace(
        own, rules=own.rules.model_copy(
            update={"iso6336": own.rules.iso6336.model_copy(update={"life_factor_1e10": 0.92})}
        ),
    )  # fmt: skip
    plain = replace(steel_of(own), contact_life=None, bending_life=None)
    found = _lasting(plain, asked)
    assert (found.contact_life.factors[-1], found.bending_life.factors[-1]) == (0.92, 0.92)
    curve = knee_curve(4e6, 9.0, greatest=1.5)
    stated = _lasting(replace(plain, contact_life=curve, bending_life=curve), asked)
    assert stated.contact_life == stated.bending_life == curve
    assert _lasting(plain, own) == plain
    pitted = own.rules.iso6336.model_copy(update={"some_pitting": True})
    case = replace(plain, treatment=Treatment.CASE_HARDENED)
    some = _lasting(case, replace(own, rules=own.rules.model_copy(update={"iso6336": pitted})))
    assert some.contact_life.cycles == (6e5, 1e7, 1e9, 1e10)


def test_cutters_with_as_many_teeth_as_the_ring_are_refused_and_of_wheels_nothing_is_asked():
    own = rating("iso6336")

    def told(cutter: int, teeth: int) -> list[str]:
        tool = RingCutter(teeth=cutter, shift=0.1, tip_radius=0.2)
        rules = own.rules.model_copy(update={"iso6336": own.rules.iso6336.model_copy(update={"ring_cutter": tool})})
        straight = replace(own, rules=rules, helix_angle=0.0)
        return [problem.path + ": " + problem.message for problem in METHODS["iso6336"].refuse(straight, (23, teeth))]

    assert told(30, -90) == told(95, 90) == []
    for cutter in (90, 95):
        (line,) = told(cutter, -90)
        assert (
            line == f"gears.iso6336.ring_cutter.teeth: {cutter} given; a ring of 90 teeth is cut by fewer than it has"
        )
    (line,) = told(89, -90)
    assert line.startswith("gears.iso6336.ring_cutter: ")


def test_pinions_of_few_teeth_hold_their_width_by_their_diameter():
    """b ≤ 20 m_n and b ≤ 0.8 d_1, d_1 = z_1 m_n/cos β of the smaller gear."""
    own = rating("iso6336")
    own = replace(own, rules=own.rules.model_copy(update={"face_width_ratio": None}))
    most, part = own.proportions.widest_modules, own.proportions.widest_diameters
    small, large = np.array([17, 60]), np.array([71, 90])
    expected = [min(most, part * z / math.cos(own.helix_angle)) for z in (17, 60)]
    assert expected[0] < most and expected[1] == most
    assert stage_width_ratio(own, small, large) == pytest.approx(expected, rel=1e-12)


def test_a_case_that_comes_once_is_none_that_lasts():
    mesh = SimpleNamespace(name="m")
    flows = {name: SimpleNamespace(meshes={"m": SimpleNamespace(multiplier=value)})
             for name, value in (("cruise", 3.0), ("brake", -4.0), ("climb", 5.0))}  # fmt: skip
    cases = {name: SimpleNamespace(static=name == "brake") for name in flows}
    context = Context(
        SimpleNamespace(cases=cases), SimpleNamespace(meshes=[mesh]), {}, flows, {}, {},  # type: ignore[arg-type]
    )  # fmt: skip
    assert context.lasting == {"m": [3.0, 5.0]}


def test_films_have_ranges_of_their_own():
    """ISO/TS 6336-22: external pairs, 0 < u ≤ 1000/5, and 1 ≤ ε_α ≤ 2."""

    def told(ratio: float, contact: float) -> list[str]:
        mesh = SimpleNamespace(
            transverse_contact_ratio=contact, helix_angle=0.1, module=3e-3, face_width=30e-3, teeth=(20.0, 71.0),
            pitch_diameters=(0.06, 0.2), side=1.0, ratio=ratio, proportions=[SimpleNamespace(profile_shift=0.0)] * 2,
        )  # fmt: skip
        rated = SimpleNamespace(bending=[SimpleNamespace(section=SimpleNamespace(notch=2.0))] * 2)
        assert beyond_ranges(mesh, rated) == ()  # type: ignore[arg-type]
        return [entry.quantity for entry in beyond_ranges(mesh, rated, films=True)]  # type: ignore[arg-type]

    for ratio, contact in ((0.001, 1.5), (200.0, 1.5), (3.0, 1.0), (3.0, 1.1), (3.0, 2.0)):
        assert told(ratio, contact) == []
    assert told(-0.001, 1.5) == told(200.1, 1.5) == ["u of the oil film"]
    assert told(3.0, 2.001) == ["ε_α of the oil film"]


@pytest.mark.parametrize("shift", [0.0, 1.05])
def test_contact_on_one_side_of_the_pitch_point_has_no_integral_temperature(shift):
    """x = 1.05 and −1.05: the wheel's tips end below its pitch circle, ε_2 < 0."""
    own = rating("iso6336")
    own = replace(own, shifts=own.shifts._replace(gears=(ToothShift(shift), ToothShift(-shift)), centre=None))
    mesh = loaded("iso6336", own=own)
    film = oil_film(mesh, METHODS["iso6336"].rate(mesh).factors)
    assert (film.integral is None) == (shift > 1.0)
    assert film.flash.safety > 0.0


@pytest.mark.parametrize("method", list(METHODS))
@pytest.mark.parametrize("mode", ["pitting_safety", "bending_safety"])
def test_the_reserve_of_a_mesh_is_that_of_its_record(method, mode):
    """By whichever asked safety decides, with one load and with three."""
    own = rating(method)
    if method != "lewis-hertz":
        table = "iso6336" if method == "iso10300" else method
        rules = getattr(own.rules, table).model_copy(update={mode: 9.0})
        own = replace(own, rules=own.rules.model_copy(update={table: rules}))
    for cases in (1, 3):
        mesh = loaded(method, cases=cases, own=own)
        known = METHODS[method]
        rated = known.rate(mesh)
        assert known.reserve_of(mesh) == near(known.reserve(rated))
        assert known.reserve(rated) == near(min(rated.bending_margin, rated.contact_margin**2))


def test_strengths_are_cited_by_the_steels_own_source_or_by_what_they_are():
    steel = replace(steel_of(rating("iso6336")), source="a certificate")
    assert {row.clause for row in steel_rows(steel)} == {"a certificate"}
    assert {row.clause for row in steel_rows(replace(steel, source=""))} == {"as stated, or ISO 6336-5:2016, table 1"}


def test_rows_of_both_gears_stand_side_by_side():
    rated = METHODS["iso6336"].rate(loaded("iso6336"))
    rows = {(row.chapter, row.quantity): row.values for row in METHODS["iso6336"].factors(rated)}
    lives = [strength.life for strength in rated.factors.root_strength]
    assert lives[0] != lives[1] and rows["strength of roots", "life"] == tuple(lives)
    assert rows["tooth root", "safety"] == tuple(root.safety for root in rated.factors.bending)


@pytest.mark.parametrize("name", ["iso6336", "iso6336-2006", "din3990"])
def test_a_range_is_cited_by_the_edition_that_rates(name):
    own = replace(rating("iso6336"), helix_angle=math.radians(33.0), method=name)
    rated = Iso6336(name, "").rate(loaded("iso6336", own=own))
    (beyond,) = rated.beyond
    assert beyond.clause.startswith({"iso6336": "ISO 6336-3:2019", "iso6336-2006": "ISO 6336-3:2006"}.get(name, "DIN"))


def test_bevel_flanks_scuff_by_the_load_that_their_virtual_gears_share(monkeypatch):
    """At every twentieth of half the path as ISO 10300-1 has it, straight between, even about the middle."""
    known = []
    monkeypatch.setattr(bevels, "flash_peak", lambda mesh, oil, sharing: known.append(sharing))
    mesh = loaded("iso10300", 2600.0, width=30e-3)
    factors = METHODS["iso10300"].rate(mesh).factors
    known.clear()
    bevels.bevel_scuffing(mesh.rating, factors)
    place = np.linspace(-0.31, 0.42, 401)
    found = known[0](place)
    virtual = factors.virtual
    for number in range(0, 401, 10):
        share = virtual.load_share(abs(number / 400.0 - 0.5) * virtual.path)
        assert found[number] == pytest.approx(share, rel=1e-9)
    assert found[205] == pytest.approx(0.5 * (found[200] + found[210]), rel=1e-9)


@pytest.mark.parametrize("gear", [0, 1])
def test_static_strength_of_one_gear_by_hand(gear):
    """σ_HG = σ_Hlim Z_NT Z_W, σ_FG = 2 σ_Flim Y_NT Y_δ, S_y = R_p0.2/(σ_F/Y_S): 1.6 and 2.5; nitrided 1.3 and 1.6."""
    steels = (
        GearSteel("case", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6, yield_strength=900e6),
        GearSteel("nitrided", Treatment.NITRIDED, "MQ", 700.0, 1200e6, 400e6),
    )
    roots = [SimpleNamespace(stress=300e6 + 50e6 * k, section=SimpleNamespace(stress_correction=1.8 + 0.3 * k))
             for k in (0, 1)]  # fmt: skip
    found = static_strength(SimpleNamespace(stresses=(1000e6, 950e6)), roots, steels, gear)  # type: ignore[arg-type]
    flank, root = ((1.6, 2.5), (1.3, 1.6))[gear]
    limits = (1500e6, 1200e6)[gear] * flank, 2.0 * (500e6, 400e6)[gear] * root * found.notch_sensitivity
    assert (found.contact_life, found.bending_life, found.work_hardening) == (flank, root, 1.0)
    assert (found.contact_limit, found.bending_limit) == (near(limits[0]), near(limits[1]))
    assert found.contact_safety == near(limits[0] / (1000e6, 950e6)[gear])
    assert (found.contact_stress, found.bending_stress) == ((1000e6, 950e6)[gear], 300e6 + 50e6 * gear)
    assert found.bending_safety == near(limits[1] / found.bending_stress)
    assert found.notch_sensitivity == static_notch_sensitivity(1.8 + 0.3 * gear, steels[gear])
    assert found.yielding_safety == (None if gear else near(900e6 / (300e6 / 1.8)))


def test_a_soft_wheel_bears_more_once_by_what_its_hard_mate_works_into_it():
    """σ_HG = σ_Hlim Z_NT Z_W = 600 · 1.6 · (1.05 − (0.95 · 150 − 130)/680) MPa; the mate itself does not harden."""
    steels = (
        GearSteel("hard", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 500e6),
        GearSteel("soft", Treatment.THROUGH_HARDENED, "MQ", 150.0, 600e6, 200e6),
    )
    roots = [SimpleNamespace(stress=300e6, section=SimpleNamespace(stress_correction=1.8)) for _ in steels]
    found = static_strength(SimpleNamespace(stresses=(1000e6, 950e6)), roots, steels, 1)  # type: ignore[arg-type]
    hardening = 1.05 - (0.95 * 150.0 - 130.0) / 680.0
    assert found.work_hardening == near(hardening)
    assert found.contact_limit == near(600e6 * 1.6 * hardening)


def test_flanks_and_roots_of_bevels_have_their_own_roughness():
    own = rating("iso10300")
    rules = own.rules.iso6336.model_copy(update={"flank_roughness": 3e-6, "root_roughness": 17e-6})
    found = bevel_surfaces(replace(own, rules=own.rules.model_copy(update={"iso6336": rules})))
    assert (found.flank_roughness, found.root_roughness) == (3e-6, 17e-6)


@pytest.mark.parametrize("treatment", list(Treatment))
@pytest.mark.parametrize("mate", list(Treatment))
def test_only_soft_steels_harden_under_hard_mates_in_static_strength(treatment, mate):
    """ISO 6336-2:2006, clause 13: 1.05 − (HB − 130)/680, HB = 0.95 HV; cast irons and cases stay what they are."""
    steel = GearSteel("one", treatment, "MQ", 150.0, 500e6, 200e6)
    other = GearSteel("other", mate, "MQ", 600.0, 1500e6, 400e6)
    works = treatment.value in ("St", "V") and mate.value in ("Eh", "IF", "NT", "NV", "NVc")
    assert static_work_hardening(steel, other) == near(1.05 - (142.5 - 130.0) / 680.0 if works else 1.0)


@pytest.mark.parametrize(
    ("inches", "part"),
    [(0.5, -0.025), (1.0, -0.025), (1.2, -0.0375 + 0.0125 * 1.2), (16.9, -0.0375 + 0.0125 * 16.9),
     (17.2, -0.1109 + 0.0207 * 17.2 - 0.000228 * 17.2**2), (30.0, -0.1109 + 0.0207 * 30.0 - 0.000228 * 900.0)],
)  # fmt: skip
@pytest.mark.parametrize("slender", [0.3, 1.2])
def test_proportions_count_by_three_pieces_of_c_pf(inches, part, slender):
    """AGMA 2001-D04, eqs 38 to 40: F/(10 d), at least 0.05, and the piece; commercial units add C_ma."""
    alignment = 0.127 + 0.0158 * inches - 1.093e-4 * inches**2
    expected = 1.0 + 0.8 * ((max(slender / 10.0, 0.05) + part) * 1.1 + alignment * 0.8)
    found = load_distribution_factor(
        inches * 0.0254, inches * 0.0254 / slender, crowning=0.8, offset=1.1, adjustment=0.8
    )
    assert float(found) == near(expected)


def test_corrections_of_a_module_end_where_rounding_cannot_tell_them_apart():
    """Loads could grow by (m/m*)^p, and a correction leaves 1 − p/3 of the logarithm of the gap: none at p = 3."""
    asked = []

    def gap(power: float):
        def known(module: float, width: float) -> float:
            asked.append((module, width))
            return (module / 3e-3) ** power

        return known

    assert under_spectrum(2e-3, 12.0, gap(3.0)) == near(3e-3)
    assert [width for _, width in asked] == pytest.approx([12.0 * module for module, _ in asked])
    exact = under_spectrum(2e-3, 12.0, gap(2.0))
    assert exact == near(3e-3 * (2.0 / 3.0) ** (3.0**-6))
    for coarse, most in ((lambda module: 5e-3, 2), (lambda module: round(module, 5), 6)):
        asked.clear()
        found = under_spectrum(2e-3, 12.0, gap(2.0), coarse)
        assert coarse(found) == coarse(exact) and len(asked) <= most


def test_relief_is_asked_for_by_the_load_with_k_a_and_the_share_of_its_path(monkeypatch):
    """w of the deflection: K_A K_γ F_t/b; w_Bt has all factors."""
    seen = []
    own = rating("iso6336")
    mesh = loaded("iso6336", own=own)
    factors = METHODS["iso6336"].rate(mesh).factors
    loads = replace(factors.loads, application=1.25, mesh_load=1.2)
    monkeypatch.setattr(flanks, "flash_peak", lambda scuffed, oil: seen.append(scuffed))
    oil_film(mesh, replace(factors, loads=loads))
    line = float(factors.tangential_force) / mesh.face_width
    assert (seen[0].nominal_load, seen[0].specific_load) == (near(1.5 * line), near(line * float(loads.contact)))


@pytest.mark.parametrize(("speed", "most"), [(4.0, math.inf), (5.0, math.inf), (5.1, 45.0), (10.0, 45.0), (10.1, 22.0)])
@pytest.mark.parametrize("treatment", [Treatment.GREY_IRON, Treatment.FERRITIC_NODULAR_IRON])
def test_brittle_irons_run_in_without_end_up_to_five_metres_a_second(treatment, speed, most):
    """ISO 6336-1:2006, 7.5.2.5: 0.55 F_βx, at most 45 µm to 10 m/s and 22 µm beyond."""
    steel = GearSteel("iron", treatment, "MQ", 200.0, 350e6, 60e6)
    for deviation in (10e-6, 60e-6, 300e-6):
        assert float(lead_allowance(deviation, steel, speed)) == near(min(0.55 * deviation, most * 1e-6))
