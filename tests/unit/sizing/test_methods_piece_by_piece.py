"""Every piece of a method of rating by itself, without a sizing: searches, widths, rims, shifts, judgements."""

import inspect
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.identity import Kind, PartId, Role
from gearwright.parts.agma2001 import bending_geometry, miner_sum, overload_distribution
from gearwright.parts.agma2003 import BENDING, CONTACT
from gearwright.parts.bevel import BOTH_OVERHUNG, ONE_OVERHUNG, STRADDLE
from gearwright.parts.gears import ToothShift, contact_angles
from gearwright.parts.iso6336 import Edition, MeshGeometry, RatingMethod, Treatment
from gearwright.parts.losses import OIL_DENSITY
from gearwright.parts.micropitting import FilmMesh, OilGrade, film_thickness
from gearwright.shipped import shipped_design
from gearwright.sizing.rating import METHODS as ALL
from gearwright.sizing.rating import Ask, rating_of
from gearwright.sizing.rating.agma2001.inputs import hobbed_pair, yield_strength_of
from gearwright.sizing.rating.agma2001.inputs import making_of as cylindrical_making_of
from gearwright.sizing.rating.agma2001.method import Agma2001
from gearwright.sizing.rating.agma2001.yielding import worst_yielding, yielding_checks
from gearwright.sizing.rating.agma2003.inputs import making_of as bevel_making_of
from gearwright.sizing.rating.agma2003.method import Agma2003
from gearwright.sizing.rating.context import bends_both_ways, row_ask
from gearwright.sizing.rating.factors import Factor
from gearwright.sizing.rating.iso6336.inputs import clause_of, quality_of, steel_of
from gearwright.sizing.rating.iso6336.limits import limited
from gearwright.sizing.rating.iso6336.method import Iso6336
from gearwright.sizing.rating.iso6336.miner import Strain, of_each, safeties
from gearwright.sizing.rating.iso6336.scuffing import film_checks, oil_film, oil_of, scuffing_checks
from gearwright.sizing.rating.iso6336.static_cases import static_checks
from gearwright.sizing.rating.iso10300.inputs import bevel_duty, bevel_surfaces
from gearwright.sizing.rating.iso10300.limits import limited as bevel_limited
from gearwright.sizing.rating.iso10300.method import Iso10300
from gearwright.sizing.rating.lewis_hertz.method import LewisHertz
from gearwright.sizing.rating.lewis_hertz.strength import (
    bending_allowable,
    contact_allowable,
    first_modules,
    width_ratio,
    working_angles,
)
from gearwright.sizing.rating.protocol import Load, LoadedMesh, MeshSpectrum
from gearwright.sizing.rating.rims import rim_factors
from gearwright.sizing.rating.rows import rate_row
from gearwright.sizing.rating.rules import _open_shifts
from gearwright.sizing.rating.search import by_teeth, module_for
from gearwright.sizing.rating.standard_teeth import (
    bevel_pair,
    cylindrical_mesh,
    fewest_virtual_teeth,
    push_angle,
    widest_ratio,
    working_radii,
)
from gearwright.sizing.rating.widths import (
    STANDARD_MODULES,
    bevel_width,
    narrowest,
    next_standard,
    overlap_width,
    under_spectrum,
)
from gearwright.spec import edited, parse, read
from mounted_designs import HELICOPTER

METHODS = {
    "lewis-hertz": LewisHertz(),
    "iso6336": Iso6336(),
    "iso10300": Iso10300(),
    "agma2001": Agma2001(),
    "agma2003": Agma2003(),
}
OFF_SET = read(shipped_design("off-set"))
BEVEL = parse(HELICOPTER)


def rating(method: str, **rules: object):
    """Return the resolved rules of a stage that a method rates, without sizing its design."""
    bevel = method in ("iso10300", "agma2003")
    stage = "pairs.bevel.gears" if bevel else "gears"
    told = {f"{stage}.{key}": value for key, value in {"rating": method, **rules}.items()}
    return rating_of(edited(BEVEL if bevel else OFF_SET, told), "bevel" if bevel else "first")


def loaded(method: str, torque: float = 700.0, *, cases: int = 1, module: float = 4e-3, width: float = 40e-3, own=None):
    own = own or rating(method)
    ask = Ask(torque / 23, (23, 59), width / module, speed=500.0)
    loads = tuple(
        Load(f"case {k}", torque * (1.0 - 0.2 * k), ask._replace(per_tooth=torque * (1.0 - 0.2 * k) / 23), 3.6e6)
        for k in range(cases)
    )
    return LoadedMesh(own, module, width, loads[0], loads, (1e-3, 2e-3))


def near(value: float) -> object:
    return pytest.approx(value, rel=1e-9)


MESH, FIRST, SECOND = (PartId(Kind.MESH, name) for name in ("mesh", "one", "two"))


# What all methods share


def test_modules_are_searched_to_the_asked_safeties():
    """S_F = (m/2)³ and S_H² = (m/3)³: the modules are 2 ∛S_F and 3 ∛S_H² mm; nothing loaded asks for none."""

    def safeties_at(module):
        return (module / 2e-3) ** 3, np.sqrt((module / 3e-3) ** 3)

    found = module_for(safeties_at, np.array([40.0, 900.0]), (1.6, 1.2))
    assert found[0] == pytest.approx([2e-3 * 1.6 ** (1 / 3)] * 2, rel=1e-12)
    assert found[1] == pytest.approx([3e-3 * 1.44 ** (1 / 3)] * 2, rel=1e-12)
    assert [float(np.sum(part)) for part in module_for(safeties_at, np.zeros(2), (1.6, 1.2))] == [0.0, 0.0]


def test_a_search_begins_at_three_tenths_of_the_cube_root_and_takes_four_steps():
    tried = []

    def safeties_at(module):
        tried.append(module.copy())
        return np.ones_like(module), np.ones_like(module)

    module_for(safeties_at, np.array([1000.0]), (1.0, 1.0))
    assert [float(t[0, 0]) for t in tried] == pytest.approx([3e-3] * 4)


def test_one_search_serves_all_loads_of_a_pair_of_teeth_by_the_cube_root():
    calls = []

    def search(teeth, torque, speed, ratio):
        calls.append((teeth, torque, speed, ratio))
        return 1e-3 * teeth[0] * torque ** (1 / 3), 1e-3 * teeth[1] * torque ** (1 / 3)

    ask = Ask(np.array([1.0, 8.0, 2.0]), (np.array([20, 20, 25]), np.array([40, 40, 75])), 9.0, speed=300.0)
    bending, contact = by_teeth(ask, search)
    torques = np.array([20.0, 160.0, 50.0])
    assert bending == pytest.approx(1e-3 * np.array([20, 20, 25]) * np.cbrt(torques))
    assert contact == pytest.approx(1e-3 * np.array([40, 40, 75]) * np.cbrt(torques))
    assert calls == [((20, 40), 20.0, 300.0, 9.0), ((25, 75), 50.0, 300.0, 9.0)]
    none = by_teeth(ask._replace(per_tooth=np.zeros(3)), search)
    assert [float(np.sum(part)) for part in none] == [0.0, 0.0]


def test_modules_of_series_one_and_two_are_those_of_iso_54():
    first = (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50)
    second = (1.125, 1.375, 1.75, 2.25, 2.75, 3.5, 4.5, 5.5, 7, 9, 11, 14, 18, 22, 28, 36, 45)
    assert tuple(sorted(first + second)) == STANDARD_MODULES
    for needed, taken in ((0.2, 1.0), (1.0, 1.0), (1.01, 1.125), (5.6, 6.0), (49.0, 50.0), (53.0, 53.0)):
        assert next_standard(needed * 1e-3) == near(taken * 1e-3)
    assert next_standard(2e-3 * (1.0 + 1e-12)) == near(2e-3)


def test_a_module_under_a_spectrum_closes_its_gap():
    """Loads may grow by (m/2.5 mm)³ (b/25 mm)⁰: six corrections of its cube root end at 2.5 mm."""
    widths = []

    def gap(module, width):
        widths.append(width / module)
        return (module / 2.5e-3) ** 3

    assert under_spectrum(4e-3, 11.0, gap) == near(2.5e-3)
    assert widths == pytest.approx([11.0] * 6)


def test_widths_by_overlap_and_by_whole_millimetres():
    """b = ε_β π m_n/sin β; straight teeth from one module on."""
    slanted = SimpleNamespace(helix_angle=math.radians(20.0), rules=SimpleNamespace(overlap_ratio=1.3))
    assert overlap_width(slanted, 3e-3) == near(1.3 * math.pi * 3e-3 / math.sin(math.radians(20.0)))
    assert overlap_width(SimpleNamespace(helix_angle=0.0, rules=slanted.rules), 3e-3) == 3e-3
    asked = []

    def reserve(width):
        asked.append(width)
        return width / 12.4e-3

    assert narrowest(4.2e-3, 30.7e-3, reserve) == near(13e-3)
    assert min(asked) > 4e-3 and max(asked) < 31e-3
    assert narrowest(40e-3, 20e-3, reserve) == near(20e-3)
    assert narrowest(5e-3, 30e-3, lambda width: 1.0) == near(5e-3)


@pytest.mark.parametrize("is_open", [False, True])
def test_widths_of_bevel_pairs_end_at_the_widest_or_at_the_safeties(is_open):
    """b of λ = b/m_mn: b = λ m_et cos β (1 − b/(2 R_e))."""
    own = rating("iso10300")
    own = replace(own, rules=own.rules.model_copy(update={"face_width_ratio": None if is_open else 8.0}))
    cosine, cone = math.cos(own.helix_angle), 4e-3 * math.hypot(17, 43) / 2.0
    tried = []

    def gap(module, width):
        tried.append((module, width))
        return width / 20.3e-3

    found = bevel_width((17, 43), 4e-3, 8.0, own, gap)
    if is_open:
        assert found == near(21e-3)
        assert all(m == near(cosine * (4e-3 - b * 4e-3 / (2.0 * cone))) for m, b in tried)
        enough = bevel_width((17, 43), 4e-3, 8.0, own, lambda module, width: 2.0)
        widest = 8.0 * 4e-3 * cosine / (1.0 + 8.0 * 4e-3 * cosine / (2.0 * cone))
        mean = cosine * (4e-3 - widest * 4e-3 / (2.0 * cone))
        least = own.rules.overlap_ratio * math.pi * mean / math.sin(own.helix_angle)
        assert enough == near(1e-3 * math.ceil(1e3 * least))
    else:
        assert found == near(8.0 * 4e-3 * cosine * (1.0 - found / (2.0 * cone))) and not tried


def test_rims_have_their_factor_where_they_are_given():
    """Y_B = 1.6 ln(2.242 h_t/s_R) and, of a ring, 1.15 ln(8.324 m/s_R) with s_R = 3.1 − 1.25; solid gears have 1."""
    own = SimpleNamespace(rules=SimpleNamespace(rim_thickness_ratio=3.1, rim_ratio=0.7))
    thin, ring = 1.6 * math.log(2.242 / 0.7), 1.15 * math.log(8.324 / 1.85)
    assert rim_factors(own, (Role.PINION, Role.WHEEL), internal=False) == (1.0, near(thin))
    assert rim_factors(own, (Role.PLANET, Role.RING), internal=True) == (near(thin), near(ring))
    assert rim_factors(own, (Role.SUN, Role.PLANET), internal=False) == (1.0, near(thin))
    solid = SimpleNamespace(rules=SimpleNamespace(rim_thickness_ratio=9.0, rim_ratio=None))
    assert rim_factors(solid, (Role.PINION, Role.WHEEL), internal=False) == (1.0, 1.0)
    for ratio in (2.9, 3.0):
        with pytest.raises(Exception, match="give more than 3"):
            rim_factors(
                SimpleNamespace(rules=SimpleNamespace(rim_thickness_ratio=ratio, rim_ratio=None)),
                (Role.PLANET, Role.RING), internal=True,
            )  # fmt: skip


@pytest.mark.parametrize(
    ("pinion", "wheel", "rule", "shifts"),
    [(None, None, 0.0, (0.0, 0.0)), (0.3, None, 0.1, (0.3, -0.3)), (None, -0.2, 0.1, (0.2, -0.2)),
     (0.3, 0.4, 0.1, (0.3, -0.3)), (None, None, 0.15, (0.15, -0.15))],
)  # fmt: skip
def test_shifts_before_teeth_are_chosen_keep_the_reference_centre(pinion, wheel, rule, shifts):
    stage = OFF_SET.pairs["first"].model_copy(update={"pinion_shift": pinion, "wheel_shift": wheel})
    found = _open_shifts(stage, SimpleNamespace(profile_shift=rule))  # type: ignore[arg-type]
    assert tuple(gear.profile_shift for gear in found.gears) == pytest.approx(shifts)


def test_shifts_of_sets_go_round_from_sun_to_ring():
    sets = read(shipped_design("single-planetary"))
    stage = next(iter(sets.planetaries.values())).model_copy(update={"sun_shift": 0.25})
    found = _open_shifts(stage, SimpleNamespace(profile_shift=0.1))  # type: ignore[arg-type]
    assert tuple(gear.profile_shift for gear in found.gears) == pytest.approx((0.25, -0.25, 0.25))


def mesh_row(name: str, gears: tuple[str, str], sign: int):
    return SimpleNamespace(name=name, gears=gears, sign=sign)


@pytest.mark.parametrize(
    ("loads", "both"),
    [({"a": [5.0], "b": [5.0]}, True), ({"a": [5.0], "b": [-5.0]}, False), ({"a": [5.0], "b": [1e-7]}, False),
     ({"a": [5.0, -4.0], "b": [0.0]}, True), ({"a": [5.0], "b": [0.0]}, False), ({"a": [5.0, -4e-6], "b": []}, False),
     ({"a": [5.0, -6e-6], "b": []}, True)],
)  # fmt: skip
def test_a_gear_bends_both_ways_between_two_mates_or_in_two_cases(loads, both):
    """The torque on a wheel is that on its pinion's side, turned by the mesh: an idler hands on what it gets."""
    meshes = [mesh_row("a", ("first", "idler"), -1), mesh_row("b", ("idler", "last"), -1)]
    train = SimpleNamespace(meshes=meshes, gear=lambda name: SimpleNamespace(role=Role.WHEEL))
    loads = {name: [value if name == "a" else -value for value in values] for name, values in loads.items()}
    assert bends_both_ways(train, "idler", loads) is both  # type: ignore[arg-type]


# Teeth


def test_proportions_working_circles_and_push_of_cylindrical_meshes():
    """λ ≤ 20 and 0.8 z/cos β; r_w = a_w z/(z_1 + z_2), of rings z_2 − z_1; cos α_wt = a cos α_t/a_w."""
    own = rating("iso6336")
    own = replace(own, helix_angle=math.radians(12.0))
    limits = own.proportions
    assert float(widest_ratio(own, np.array([10.0]))[0]) == near(
        limits.widest_diameters * 10.0 / math.cos(own.helix_angle)
    )
    assert float(widest_ratio(own, np.array([90.0]))[0]) == limits.widest_modules
    cosine = math.cos(own.helix_angle)
    plain = replace(own, shifts=own.shifts._replace(centre=None))
    assert working_radii(20, 50, plain, internal=False, module=3e-3) == pytest.approx(
        (20 * 1.5e-3 / cosine, 50 * 1.5e-3 / cosine)
    )
    moved = replace(own, shifts=own.shifts._replace(centre=36.5))
    assert working_radii(20, 50, moved, internal=False, module=3e-3) == pytest.approx(
        (36.5 * 3e-3 * 2 / 7, 36.5 * 3e-3 * 5 / 7)
    )
    ring = replace(own, shifts=own.shifts._replace(centre=15.6))
    assert working_radii(20, 50, ring, internal=True, module=3e-3) == pytest.approx((15.6e-3 * 2, 15.6e-3 * 5))
    transverse = math.atan(math.tan(own.rules.pressure_angle) / cosine)
    for teeth, kind, internal in ((70, moved, False), (30, ring, True)):
        angle = math.acos(teeth / (2.0 * cosine) * math.cos(transverse) / kind.shifts.centre)
        assert push_angle(20, 50, kind, internal=internal) == near(angle)
    assert push_angle(20, 50, plain, internal=False) == near(transverse)
    mesh = cylindrical_mesh((20, 50), 3e-3, 25e-3, plain)
    assert (float(mesh.teeth[1]), float(mesh.module), float(mesh.face_width)) == (50.0, 3e-3, 25e-3)
    assert float(cylindrical_mesh((20, 50), 3e-3, 25e-3, plain, internal=True).teeth[1]) == -50.0


@pytest.mark.parametrize("shift", [-0.2, 0.0, 0.35])
def test_the_fewest_virtual_teeth_fall_with_the_shift(shift):
    own = rating("iso10300")
    first = ToothShift(shift)
    own = replace(own, helix_angle=math.radians(30.0), shifts=own.shifts._replace(gears=(first, *own.shifts.gears[1:])))
    alpha = own.rules.pressure_angle
    transverse = math.atan(math.tan(alpha) / math.cos(math.radians(30.0)))
    straight = 1.25 - 0.3 * (1.0 - math.sin(alpha)) - shift
    assert fewest_virtual_teeth(own) == near(2.0 * straight * math.cos(math.radians(30.0)) / math.sin(transverse) ** 2)


# Lewis and Hertz


def test_lewis_and_hertz_by_hand():
    """m³ = 2 T/z cos β …/(λ Y σ): checked by σ = F/(b m Y) and the allowables that it was asked for."""
    own = rating("lewis-hertz", idler_factor=0.7)
    material, rules = own.material, own.rules
    assert rules.idler_factor == 0.7
    allowed = material.yield_strength / rules.bending_safety
    assert bending_allowable(own, idler=False) == near(allowed)
    assert bending_allowable(own, idler=True) == near(allowed * rules.idler_factor)
    assert contact_allowable(own) == near(2.5e6 * material.surface_hardness / rules.contact_safety)
    assert width_ratio(rules.model_copy(update={"face_width_ratio": 7.0}), 0.3) == 7.0
    open_width = rules.model_copy(update={"face_width_ratio": None, "overlap_ratio": 1.2})
    assert width_ratio(open_width, 0.0) == 10.0
    assert width_ratio(open_width, math.radians(20.0)) == near(1.2 * math.pi / math.sin(math.radians(20.0)))


@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("idlers", [(False, False), (True, False)])
def test_modules_of_lewis_and_hertz_are_at_their_allowables(internal, idlers):
    """Rated with the module that it asks for, each stress is what is allowed; its margin is 1."""
    own, ask = rating("lewis-hertz", idler_factor=0.7), Ask(31.0, (23, 59), 9.0, internal=internal, idlers=idlers)
    for mode, module in zip(("bending", "contact"), first_modules(ask, own), strict=True):
        load = Load("x", 31.0 * 23, ask, 1.0)
        rated = METHODS["lewis-hertz"].rate(
            LoadedMesh(own, float(module), 9.0 * float(module), load, (load,), (1e-3, 2e-3))
        )
        assert getattr(rated, f"{mode}_margin") == pytest.approx(1.0, rel=1e-9)
        assert getattr(rated, f"{mode}_stress") == pytest.approx(getattr(rated, f"{mode}_allowable"), rel=1e-9)
        assert (rated.module_bending, rated.module_contact, rated.case) == (1e-3, 2e-3, "x")


def test_an_idle_mesh_of_lewis_and_hertz_has_margins_without_end():
    rated = METHODS["lewis-hertz"].rate(loaded("lewis-hertz", 0.0))
    assert (rated.bending_stress, rated.contact_stress) == (0.0, 0.0)
    assert (rated.bending_margin, rated.contact_margin) == (math.inf, math.inf)


@pytest.mark.parametrize("transverse", [False, True])
def test_contact_angles_are_normal_or_transverse_as_asked(transverse):
    own = rating("lewis-hertz", contact_angles="transverse" if transverse else "normal")
    own = replace(own, helix_angle=math.radians(15.0), shifts=own.shifts._replace(centre=None))
    expected = contact_angles(own.rules.pressure_angle, math.radians(15.0), transverse=transverse)
    assert working_angles(own, Ask(1.0, (20, 50), 9.0), stretch=1.0) == expected
    moved = replace(own, shifts=own.shifts._replace(centre=37.0))
    stretch = 2.0 * 37.0 / 70.0
    lean = math.atan(math.tan(math.radians(15.0)) * stretch * math.cos(math.radians(15.0)))
    at_t = math.acos(35.0 / math.cos(math.radians(15.0)) / 37.0 * math.cos(
        math.atan(math.tan(own.rules.pressure_angle) / math.cos(math.radians(15.0)))))  # fmt: skip
    found = working_angles(moved, Ask(1.0, (20, 50), 9.0), stretch=stretch)
    whole = contact_angles(math.atan(math.tan(at_t) * math.cos(lean)), lean, transverse=transverse)
    assert tuple(found) == pytest.approx(tuple(whole))


# Judgements


ROWS = {
    "iso6336": ("ISO 6336-2, 5.3", "ISO 6336-3, 5.2"), "agma2001": ("AGMA 2001-D04, eq. 4", "AGMA 2001-D04, eq. 13"),
    "iso10300": ("ISO 10300-2, eq. 5", "ISO 10300-3, eq. 5"),
    "agma2003": ("AGMA 2003-D19, eq. 2", "AGMA 2003-D19, eq. 6"),
}  # fmt: skip


@pytest.mark.parametrize("method", ROWS)
@pytest.mark.parametrize("cases", [1, 2])
def test_every_safety_is_judged_by_its_clause_on_its_gear(method, cases):
    rated = METHODS[method].rate(loaded(method, cases=cases, width=30e-3))
    checks = list(METHODS[method].checks(rated, MESH, (FIRST, SECOND)))
    for gear, part in enumerate((FIRST, SECOND)):
        own = [check for check in checks if check.part == part]
        rows = [(c.mode, c.clause, c.value, c.limit, c.symbol, c.at_most) for c in own]
        assert rows == [
            ("pitting", ROWS[method][0], rated.pitting[gear], rated.pitting_asked, "S_H", False),
            ("tooth root", ROWS[method][1], rated.bending[gear], rated.bending_asked, "S_F", False),
        ]
    rest = {check.mode: check for check in checks if check.part == MESH}
    assert len(rest) + 4 == len(checks)
    if method.startswith("agma"):
        speed = rated.factors.speed if method == "agma2001" else rated.factors.mesh.speed
        check = rest["velocity"]
        assert (check.value, check.limit, check.at_most) == (float(speed), rated.velocity_limit, True)
        assert check.dimension == "velocity" and check.exponent is None
    assert rated.bending_margin == near(min(rated.bending) / rated.bending_asked)
    assert rated.contact_margin == near(min(rated.pitting) / rated.pitting_asked)
    assert (rated.module_bending, rated.module_contact, rated.case) == (1e-3, 2e-3, "case 0")


@pytest.mark.parametrize("method", [*ROWS, "lewis-hertz"])
def test_reserves_take_the_root_or_the_square_of_the_flank(method):
    for bending, contact, reserve in ((1.3, 1.2, 1.3), (1.6, 1.2, 1.44), (0.9, 0.5, 0.25)):
        rated = SimpleNamespace(bending_margin=bending, contact_margin=contact)
        assert METHODS[method].reserve(rated) == near(reserve)  # type: ignore[arg-type]


@pytest.mark.parametrize("method", ["agma2001", "agma2003", "iso6336", "iso10300"])
def test_two_equal_halves_of_a_life_rate_as_the_whole(method):
    """Miner: one case of all the life, or two of half of it under the same load, have the same safeties."""
    whole = loaded(method, width=30e-3)
    half = tuple(whole.heaviest._replace(life=1.8e6, case=name) for name in ("a", "b"))
    halves = METHODS[method].rate(whole._replace(loads=half))
    alone = METHODS[method].rate(whole)
    assert halves.pitting == pytest.approx(alone.pitting, rel=1e-6)
    assert halves.bending == pytest.approx(alone.bending, rel=1e-6)
    lighter = METHODS[method].rate(whole._replace(loads=(half[0],)))
    assert min(lighter.pitting) > min(alone.pitting)


def test_yielding_is_judged_in_the_worst_static_case_of_agma_2001():
    """s_ay K_y J K_f F m_t/(W_max K_my) with W = T/r_1: 3 and 2 kN m once."""
    own = rating("agma2001")
    mesh = loaded("agma2001", cases=3, own=own)
    assert worst_yielding(mesh) is None
    loads = tuple(
        mesh.loads[0]._replace(torque=torque, static=static, case=name)
        for torque, static, name in ((9000.0, False, "lasts"), (2000.0, True, "light"), (3000.0, True, "worst"))
    )
    found = worst_yielding(mesh._replace(loads=loads))
    assert found.case == "worst"
    pair = hobbed_pair(mesh.heaviest.ask, 10.0, own)
    for gear in (0, 1):
        strength = yield_strength_of(own, gear)
        assert found.strengths[gear] == strength
        geometry = bending_geometry(pair, gear)
        transverse = 4e-3 / math.cos(own.helix_angle)
        force = 3000.0 / (0.5 * transverse * 23)
        expected = (
            strength * own.rules.agma2001.yield_factor * float(geometry.factor) * float(geometry.stress_correction)
        )
        expected *= 40e-3 * transverse / (force * float(overload_distribution(40e-3)))
        assert found.safeties[gear] == pytest.approx(expected, rel=1e-9)
    rated = SimpleNamespace(static=found, yielding_asked=1.3)
    checks = list(yielding_checks(rated, (FIRST, SECOND)))
    assert [(c.part, c.mode, c.value, c.limit, c.symbol, c.case) for c in checks] == [
        (part, "yielding root", found.safeties[gear], 1.3, "S_y", "worst") for gear, part in enumerate((FIRST, SECOND))
    ]
    assert list(yielding_checks(SimpleNamespace(static=None, yielding_asked=1.3), (FIRST, SECOND))) == []


def test_static_cases_of_iso_6336_are_judged_by_the_one_that_comes_nearest():
    mesh = loaded("iso6336", cases=2)
    loads = (
        mesh.loads[0],
        mesh.loads[0]._replace(torque=1200.0, static=True, case="light", life=1.0),
        mesh.loads[0]._replace(torque=2400.0, static=True, case="worst", life=1.0),
    )
    rated = METHODS["iso6336"].rate(mesh._replace(loads=loads))
    assert rated.static.case == "worst"
    asked = rated.static_asked
    rows = [(c.part, c.mode, c.value, c.limit, c.symbol, c.exponent) for c in static_checks(rated, (FIRST, SECOND))]
    expected = []
    for part, strength in zip((FIRST, SECOND), rated.static.strengths, strict=True):
        expected.append((part, "static pitting", float(strength.contact_safety), asked[0], "S_H", 0.5))
        expected.append((part, "static tooth root", float(strength.bending_safety), asked[1], "S_F", 1.0))
        if strength.yielding_safety is not None:
            expected.append((part, "yielding root", float(strength.yielding_safety), asked[2], "S_y", 1.0))
    assert rows == expected


def test_scuffing_and_micropitting_are_judged_by_the_asked_method():
    film = SimpleNamespace(
        scuffing=SimpleNamespace(safety=2.1), flash=SimpleNamespace(safety=3.2),
        micropitting=SimpleNamespace(safety=1.4, point="AB"), scuffing_asked=1.8, micropitting_asked=1.1,
    )  # fmt: skip
    rows = {}
    for by in ("integral", "flash", "both"):
        film.scuffing_by = by
        rows[by] = [
            (c.part, c.mode, c.value, c.limit, c.symbol)
            for checks in (scuffing_checks(film, MESH), film_checks(film, MESH))
            for c in checks
        ]
    tiny = (MESH, "micropitting", 1.4, 1.1, "S_λ")
    assert rows["integral"] == [(MESH, "scuffing", 2.1, 1.8, "S_intS"), tiny]
    assert rows["flash"] == [(MESH, "scuffing", 3.2, 1.8, "S_B"), tiny]
    assert rows["both"] == [(MESH, "scuffing", 2.1, 1.8, "S_intS"), (MESH, "scuffing", 3.2, 1.8, "S_B"), tiny]
    film.micropitting = film.flash = film.scuffing = None
    assert list(film_checks(film, MESH)) == list(scuffing_checks(film, MESH)) == []


# Limits


def rows_of(values: dict) -> list[Factor]:
    return [Factor(chapter, quantity, "", (value,), "ratio", "") for (chapter, quantity), value in values]


def test_every_clamp_of_iso_6336_is_named_at_its_value_and_nowhere_else():
    """K_3 2 and 1, K_α 1, Z_B 1, Z_W 1 and 1.2, Z_X 1, Y_X 1, 0.8, 0.85, Y_B 1, Y_DT 1 and 0.7."""
    clamps = [
        ("dynamic factor", "slope", 1.0, "least: from 3 m/s"),
        ("dynamic factor", "slope", 2.0, "greatest: up to 0.2 m/s"),
        ("load factors", "transverse contact", 1.0, "least"), ("load factors", "transverse bending", 1.0, "least"),
        ("pitting", "single contact", 1.0, "least: pitch point"),
        ("strength of flanks", "work hardening", 1.0, "least"),
        ("strength of flanks", "work hardening", 1.2, "greatest: 130 HB"),
        ("strength of flanks", "size", 1.0, "greatest"),
        ("strength of roots", "size", 1.0, "greatest"), ("strength of roots", "size", 0.8, "least"),
        ("strength of roots", "size", 0.85, "least"), ("tooth root", "rim", 1.0, "least: thick rim"),
        ("tooth root", "deep tooth", 1.0, "greatest"), ("tooth root", "deep tooth", 0.7, "least"),
    ]  # fmt: skip
    steel = steel_of(rating("iso6336"))
    mild = replace(steel, contact_strength=1000e6)
    for chapter, quantity, value, words in clamps:
        row = Factor(chapter, quantity, "", (value,), "ratio", "")
        at, beside = limited([row, replace(row, values=(value * 1.001,))], None, (mild, mild))  # type: ignore[arg-type]
        assert (at.limit, beside.limit) == (words, "")


@pytest.mark.parametrize(
    ("strength", "words"),
    [(700e6, "σ_Hlim counts as 850"), (850e6, "σ_Hlim counts as 850"), (1000e6, ""), (1200e6, "σ_Hlim counts as 1200"),
     (1500e6, "σ_Hlim counts as 1200")],
)  # fmt: skip
def test_film_and_life_stand_at_their_limits_by_the_softer_steel(strength, words):
    steel = replace(steel_of(rating("iso6336")), contact_strength=strength, treatment=Treatment.CASE_HARDENED)
    other = replace(steel, contact_strength=1600e6, treatment=Treatment.NITRIDED)
    strengths = SimpleNamespace(lubricant=0.97, speed=0.98, roughness=1.01)
    rated = SimpleNamespace(contact_strength=(strengths, strengths))
    values = {"lubricant": 0.97, "speed": 0.98, "roughness": 1.01}
    for name, value in values.items():
        row = Factor("strength of flanks", name, "", (value,), "ratio", "")
        (found,) = limited([row], rated, (other, steel))  # type: ignore[arg-type]
        assert found.limit == words
    for chapter, values in (("strength of flanks", {1.6: "greatest: static", 1.3: "greatest: static"}),
                            ("strength of roots", {2.5: "greatest: static", 1.6: "greatest: static"})):  # fmt: skip
        for value, word in (values | {0.85: "least: 1e10 cycles", 1.0: ""}).items():
            (found,) = limited([Factor(chapter, "life", "", (value,), "ratio", "")], rated, (other, steel))  # type: ignore[arg-type]
            assert found.limit == word


@pytest.mark.parametrize(
    ("eased", "words"), [(1.0, "K_F0 least, or straight teeth"), (1.15, "K_F0 greatest"), (1.08, "")]
)
@pytest.mark.parametrize(
    ("strength", "film"),
    [
        (850e6, "σ_Hlim counts as 850"),
        (1000e6, ""),
        (1200e6, "σ_Hlim counts as 1200"),
        (1500e6, "σ_Hlim counts as 1200"),
    ],
)
def test_every_clamp_of_iso_10300_is_named_at_its_value_and_nowhere_else(eased, words, strength, film):
    steel = replace(steel_of(rating("iso6336")), contact_strength=strength, treatment=Treatment.CASE_HARDENED)
    loads = SimpleNamespace(face_contact=1.65, face_bending=1.65 / eased)
    rated = SimpleNamespace(loads=loads, pitting=SimpleNamespace(film=(0.91, 0.93)))
    clamps = [
        ("load factors", "transverse contact", 1.0, "least"), ("load factors", "transverse bending", 1.0, "least"),
        ("tooth root", "contact ratio", 0.625, "least: ε_vβ from 1"), ("tooth root", "spiral", 1.0, "straight teeth"),
        ("tooth root", "size", 1.0, "greatest"), ("tooth root", "size", 0.8, "least"),
        ("tooth root", "size", 0.85, "least"),
        ("mesh", "contact life", 1.6, "greatest: static"), ("mesh", "contact life", 0.85, "least: 1e10 cycles"),
        ("mesh", "root life", 2.5, "greatest: static"), ("mesh", "root life", 0.85, "least: 1e10 cycles"),
        ("load factors", "face bending", 1.65 / eased, words), ("pitting", "film", 0.91, film),
    ]  # fmt: skip
    for chapter, quantity, value, expected in clamps:
        row = Factor(chapter, quantity, "", (value,), "ratio", "")
        at, beside = bevel_limited([row, replace(row, values=(value * 1.001,))], rated, steel)  # type: ignore[arg-type]
        assert (at.limit, beside.limit) == (expected, "")


# Inputs of the methods


def test_clauses_are_those_of_the_edition():
    for source, former, din in (
        ("ISO 6336-1:2019, clause 4", "ISO 6336-1:2006, clause 4", "DIN 3990-1:1987"),
        ("ISO 6336-2:2019, clause 5", "ISO 6336-2:2006, clause 5", "DIN 3990-2:1987"),
        ("ISO 6336-3:2019, clause 5", "ISO 6336-3:2006, clause 5", "DIN 3990-3:1987"),
        ("ISO 1328-1:2013", "ISO 1328-1:2013", "ISO 1328-1:2013"),
    ):
        assert clause_of(source, Edition.ISO2019) == source
        assert clause_of(source, Edition.ISO2006) == former
        assert clause_of(source, Edition.DIN1987) == din


def test_what_iso_10300_is_told_of_a_stage():
    for name, mounting in (("straddle", STRADDLE), ("one-overhung", ONE_OVERHUNG), ("both-overhung", BOTH_OVERHUNG)):
        own = rating("iso10300")
        rules = own.rules.iso6336.model_copy(
            update={"mounting": name, "profile_crowning": "low", "oil_viscosity": 150.0}
        )
        own = replace(own, rules=own.rules.model_copy(update={"iso6336": rules, "cutter_radius": None}))
        pair = bevel_pair((17, 43), 4e-3, 30e-3, own)
        duty = bevel_duty(own, pair, 321.0, 45.0)
        assert (duty.mounting, duty.cutter_radius) == (mounting, math.inf)
        assert (duty.pinion_torque, duty.pinion_speed) == (321.0, 45.0)
        assert duty.density == own.material.density
        surfaces = bevel_surfaces(own)
        assert (surfaces.peak_exponent, surfaces.viscosity) == (3.0, near(150e-6))
        high = own.rules.model_copy(update={"iso6336": rules.model_copy(update={"profile_crowning": "high"})})
        assert bevel_surfaces(replace(own, rules=high)).peak_exponent == 1.5


def test_the_oil_of_a_design_is_thinned_to_its_temperature():
    """By Walther between ν_40 and ν_100 where both are given; η = ν ρ; the load stage and X_L by its kind."""
    rules = rating("iso6336").rules.iso6336.model_copy(
        update={"oil_viscosity": 150.0, "oil_viscosity_100": 15.5, "oil_temperature": 80.0, "scuffing_stage": 11,
                "oil_type": "polyglycol"}
    )  # fmt: skip
    low, high = math.log10(math.log10(150.7)), math.log10(math.log10(16.2))
    part = math.log10(353.0 / 313.0) / math.log10(373.0 / 313.0)
    expected = 10.0 ** (10.0 ** (low + (high - low) * part)) - 0.7
    oil = oil_of(rules)
    assert oil.dynamic_viscosity == pytest.approx(1e-6 * expected * OIL_DENSITY, rel=1e-9)
    assert (oil.temperature, oil.load_stage, oil.kind, oil.supply) == (80.0, 11.0, 0.7, 1.2)
    assert oil.viscosity_40 == near(150e-6)
    at_40 = oil_of(rules.model_copy(update={"oil_viscosity_100": None, "oil_temperature": 40.0}))
    assert at_40.dynamic_viscosity == pytest.approx(150e-6 * OIL_DENSITY, rel=1e-9)


def test_making_of_bevel_gears_by_agma_2003():
    own = rating("agma2003")
    changed = {"steel": "through-hardened", "grade": 1, "hardness_hb": 300.0, "wheel_hardness_hb": 240.0}
    rules = own.rules.agma2003.model_copy(update=changed | {"crowned": False, "mounting": "both-overhung"})
    told = replace(own, rules=own.rules.model_copy(update={"agma2003": rules, "cutter_radius": 0.1}))
    making = bevel_making_of(told)
    assert making.hardnesses == (300.0, 240.0)
    assert (making.crowning, making.mounting, making.cutter_radius) == (2.0, 1.25, 0.1)
    psi = 6894.757
    assert making.strengths[0].bending == pytest.approx((44.0 * 300.0 + 2100.0) * psi, rel=1e-6)
    assert making.strengths[1].contact == pytest.approx((341.0 * 240.0 + 23620.0) * psi, rel=1e-6)
    same = replace(
        told, rules=told.rules.model_copy(update={"agma2003": rules.model_copy(update={"wheel_hardness_hb": None})})
    )
    assert bevel_making_of(same).hardnesses == (300.0, 300.0)
    carburised = rules.model_copy(update={"steel": "carburised", "crowned": True})
    usual = bevel_making_of(
        replace(own, rules=own.rules.model_copy(update={"agma2003": carburised, "cutter_radius": None}))
    )
    assert usual.hardnesses is None and (usual.crowning, usual.cutter_radius) == (1.5, math.inf)


def test_life_slopes_of_agma_are_the_inverse_of_its_exponents():
    assert METHODS["agma2003"].life_slope(rating("agma2003"), "pitting", None) == near(1.0 / 0.0602)
    assert METHODS["agma2003"].life_slope(rating("agma2003"), "bending", None) == near(1.0 / 0.1192)
    assert METHODS["agma2001"].life_slope(rating("agma2001"), "pitting", None) == near(1.0 / 0.056)
    assert METHODS["agma2001"].life_slope(rating("agma2001"), "bending", None) == near(1.0 / 0.1192)
    steel = steel_of(rating("iso6336"))
    assert steel.treatment is Treatment.NITRIDED
    slopes = [Iso6336().life_slope(rating("iso6336"), mode, None) for mode in ("pitting", "bending")]
    assert slopes == pytest.approx([math.log(20.0) / math.log(1.3), math.log(3000.0) / math.log(1.6)], rel=1e-6)


def test_strains_of_several_loads_are_taken_apart_in_order():
    strain = Strain(np.array([1.0, 2.0]), 5.0, np.array([3.0, 4.0]), np.array([6.0, 7.0]))
    second = Strain(8.0, 9.0, 10.0, 11.0)
    parts = of_each(((strain, second), (second, strain)), 2)
    assert parts[0] == ((Strain(1.0, 5.0, 3.0, 6.0), second), (second, Strain(1.0, 5.0, 3.0, 6.0)))
    assert parts[1] == ((Strain(2.0, 5.0, 4.0, 7.0), second), (second, Strain(2.0, 5.0, 4.0, 7.0)))


def test_a_single_load_has_the_safety_of_its_own_limit():
    steel = steel_of(rating("iso6336"))
    rows = [Strain(100.0, 1.0, value, 1e7) for value in (150.0, 160.0, 170.0, 180.0)]
    assert safeties([((rows[0], rows[1]), (rows[2], rows[3]))], (steel, steel)) == ((1.5, 1.6), (1.7, 1.8))


# What a rating hands on


def told(method: str, **asked: float):
    """Return rules of a method with asked safeties that are not 1, K_A = 1.25 and a helix."""
    own = rating(method)
    table = "iso6336" if method == "iso10300" else method
    rules = own.rules.model_copy(update={table: getattr(own.rules, table).model_copy(update=asked)})
    return replace(own, rules=rules, service=own.service.model_copy(update={"application_factor": 1.25}))


@pytest.mark.parametrize("method", ROWS)
def test_a_rating_hands_on_stresses_margins_and_peaks(method):
    own = told(method, pitting_safety=1.3, bending_safety=1.7)
    rated = METHODS[method].rate(loaded(method, width=30e-3, own=own))
    assert (rated.pitting_asked, rated.bending_asked) == (1.3, 1.7)
    assert rated.contact_margin == near(min(rated.pitting) / 1.3)
    assert rated.bending_margin == near(min(rated.bending) / 1.7)
    factors = rated.factors
    if method.startswith("agma"):
        roots = [float(gear.bending_stress) for gear in factors.gears]
        flanks = [float(gear.contact_stress) for gear in factors.gears]
        peak = (factors if method == "agma2001" else factors.mesh).dynamic
        # (A + Q_v − 3)² ft/min with A = 50 + 56 (1 − 0.25 (12 − Q_v)^⅔)
        quality = getattr(own.rules, method).quality_number
        base = 50.0 + 56.0 * (1.0 - 0.25 * (12.0 - quality) ** (2.0 / 3.0))
        assert rated.velocity_limit == pytest.approx((base + quality - 3.0) ** 2 * 0.3048 / 60.0, rel=1e-9)
    else:
        roots = [float(root.stress) for root in factors.bending]
        pitting = factors.pitting
        flanks = [float(s) for s in pitting.stresses] if method == "iso6336" else [pitting.stress]
        peak = factors.loads.dynamic
    assert roots[0] != roots[1]
    assert rated.bending_stress == max(roots) and rated.contact_stress == max(flanks)
    assert rated.peaks == near(1.25 * float(peak))
    assert len(rated.pitting) == len(rated.bending) == 2 and len(set(rated.bending)) == 2


@pytest.mark.parametrize("method", ROWS)
def test_every_row_of_a_rating_stands_in_its_chapter(method):
    rows = list(METHODS[method].factors(METHODS[method].rate(loaded(method, width=30e-3))))
    chapters = {row.chapter for row in rows}
    assert "mesh" in chapters and all(isinstance(chapter, str) for chapter in chapters)
    assert {"strength of flanks", "tooth root"} <= chapters or {"tooth root"} <= chapters or method == "agma2001"
    assert all(row.values and row.clause for row in rows)


@pytest.mark.parametrize("method", ["iso10300", "agma2003"])
@pytest.mark.parametrize("teeth", [(17, 43), (30, 90), (20, 25)])
def test_bevel_widths_are_three_tenths_of_the_cone_and_ten_modules_at_most(method, teeth):
    """b = 0.30 R_e, at most 10 m_et; λ = b/m_mn, m_mn = m_et cos β (1 − b/(2 R_e))."""
    own = rating(method)
    cone = math.hypot(*teeth) / 2.0
    width = min(0.3 * cone, 10.0)
    mean = math.cos(own.helix_angle) * (1.0 - width / (2.0 * cone))
    found = METHODS[method].width_ratio(own, *(np.array([z]) for z in teeth))
    assert float(found[0]) == near(width / mean)


def test_how_gears_are_made_is_said_in_the_words_of_each_method():
    iso = rating("iso6336").rules.iso6336
    made = Iso6336().making(rating("iso6336"))
    assert made.accuracy == f"{iso.tolerance_class} ISO 1328-1" and made.iso_class == iso.tolerance_class
    assert made.roughness == (iso.flank_roughness, iso.root_roughness)
    assert made.steel[0] == "ISO 6336-5" and made.iso_steel == steel_of(rating("iso6336"))
    bevel = Iso10300().making(rating("iso10300"))
    assert bevel.accuracy.endswith("ISO 17485") and bevel.iso_class is None
    assert LewisHertz().making(rating("lewis-hertz")).accuracy == "not chosen (Lewis and Hertz)"
    for method, name in ((Agma2001(), "agma2001"), (Agma2003(), "agma2003")):
        own = rating(name)
        rules = getattr(own.rules, name)
        for steel, shown in (("carburised", False), ("through-hardened", True)):
            other = rules.model_copy(update={"steel": steel, "hardness_hb": 320.0, "grade": 2})
            made = method.making(replace(own, rules=own.rules.model_copy(update={name: other})))
            assert made.accuracy.startswith(f"Q_v {rules.quality_number} AGMA")
            assert made.steel[1].startswith(f"{steel}, grade 2") and ("320 HB" in made.steel[1]) is shown


def test_a_wheel_of_its_own_steel_by_agma_2001():
    """Grade 1 at 240 HB: s_at = 77.3 HB + 12 800, s_ac = 322 HB + 29 100 psi; rims by 1.6 ln(2.242/m_B)."""
    own = rating("agma2001")
    rules = own.rules.agma2001
    wheel = SimpleNamespace(steel="through-hardened", grade=1, hardness_hb=240.0)
    other = rules.model_copy(update={"steel": "through-hardened", "grade": 1, "hardness_hb": 300.0, "wheel": wheel})
    changed = replace(own, rules=own.rules.model_copy(update={"agma2001": other, "rim_ratio": 0.8}))
    making = cylindrical_making_of(changed)
    psi = 6894.757
    assert making.strength.bending == pytest.approx((77.3 * 300.0 + 12800.0) * psi, rel=1e-6)
    assert making.wheel.strength.bending == pytest.approx((77.3 * 240.0 + 12800.0) * psi, rel=1e-6)
    assert making.wheel.strength.contact == pytest.approx((322.0 * 240.0 + 29100.0) * psi, rel=1e-6)
    hard = making.wheel.hardnesses
    assert (hard.pinion, hard.wheel, hard.hard_pinion, hard.hard_wheel) == (300.0, 240.0, False, False)
    assert hard.roughness == rules.flank_roughness
    assert making.rims == (1.0, near(1.6 * math.log(2.242 / 0.8)))
    assert cylindrical_making_of(own).rims == (1.0, 1.0)
    case = other.model_copy(update={"steel": "carburised"})
    told_case = cylindrical_making_of(replace(changed, rules=changed.rules.model_copy(update={"agma2001": case})))
    assert told_case.wheel.hardnesses.hard_pinion and not told_case.wheel.hardnesses.hard_wheel


def test_a_steel_that_is_not_known_bears_nothing_by_lewis_and_hertz():
    own = rating("lewis-hertz")
    unknown = replace(own, material=replace(own.material, surface_hardness=None, yield_strength=None))
    assert contact_allowable(unknown) == bending_allowable(unknown, idler=False) == 0.0


def test_stresses_of_lewis_and_hertz_are_judged_with_their_margins():
    rated = METHODS["lewis-hertz"].rate(loaded("lewis-hertz"))
    checks = LewisHertz().checks(rated, MESH, (FIRST, SECOND))
    rows = [(c.part, c.mode, c.clause, c.value, c.limit, c.case) for c in checks]
    assert rows == [
        (MESH, "bending", "Pulvirenti 2023, eq. 2.1", rated.bending_stress, near(rated.bending_allowable), "case 0"),
        (MESH, "contact", "Pulvirenti 2023, eq. 2.2", rated.contact_stress, near(rated.contact_allowable), "case 0"),
    ]


def test_lewis_and_hertz_of_a_mesh_by_hand():
    """F = 2 T/d_1, σ = F/(b m Y) with the smaller gear's Y, 1/r_1 ± 1/r_2; d = z m/cos β."""
    own = rating("lewis-hertz")
    own = replace(own, shifts=own.shifts._replace(centre=None))
    for internal in (False, True):
        ask = Ask(30.0, (23, 59), 10.0, internal=internal)
        load = Load("x", 690.0, ask, 1.0)
        rated = LewisHertz().rate(LoadedMesh(own, 4e-3, 40e-3, load, (load,), (0.0, 0.0)))
        diameters = [z * 4e-3 / math.cos(own.helix_angle) for z in (23, 59)]
        force = 2.0 * 690.0 / diameters[0]
        assert rated.bending_stress == near(force / (40e-3 * 4e-3 * rated.form_factor))
        curvature = 2.0 / diameters[0] + (-2.0 if internal else 2.0) / diameters[1]
        angles = contact_angles(
            own.rules.pressure_angle, own.helix_angle, transverse=own.rules.contact_angles == "transverse"
        )
        stress = 0.418 * math.sqrt(
            force * own.material.elastic_modulus * curvature * math.cos(angles.line)
            / (40e-3 * math.cos(angles.pressure) * math.sin(angles.pressure))
        )  # fmt: skip
        assert rated.contact_stress == pytest.approx(stress, rel=2e-3)  # 0.418 is √(0.35/2) to three digits


def test_the_weakest_treatment_of_a_mesh_says_what_film_it_needs():
    """W_W 0.5 through-hardened, 0.65 induction-hardened, 1 case-hardened, 1.5 nitrided: the softer flank of two."""
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"micropitting_stage": 8})
    own = replace(own, rules=own.rules.model_copy(update={"iso6336": rules}), helix_angle=0.0)
    mesh = loaded("iso6336", own=own)
    factors = METHODS["iso6336"].rate(mesh).factors
    film = oil_film(mesh, factors)
    assert steel_of(own).treatment is Treatment.NITRIDED
    bare = film.micropitting.permissible / 1.5
    wheel = SimpleNamespace(steel="case-hardened", grade="MQ", hardness_hv=700.0, yield_strength=None)
    mixed = own.rules.model_copy(update={"iso6336": rules.model_copy(update={"wheel": wheel})})
    other = oil_film(mesh._replace(rating=replace(own, rules=mixed)), factors)
    assert other.micropitting.permissible == pytest.approx(bare, rel=1e-9)
    geometry = cylindrical_mesh((23, 59), 4e-3, 40e-3, own)
    force = 2.0 * 700.0 / (23 * 4e-3)
    line = FilmMesh(
        geometry, force, float(factors.loads.contact), 500.0, rules.flank_roughness / 6.0, grade=rules.tolerance_class,
        elastic_modulus=own.material.elastic_modulus, poisson_ratio=own.material.poisson_ratio, supply=1.2,
    )  # fmt: skip
    alone = film_thickness(line, OilGrade(rules.oil_viscosity * 1e-6), rules.oil_temperature)
    assert film.micropitting.films == pytest.approx(alone.relative(rules.flank_roughness / 6.0).tolist(), rel=1e-6)
    assert film.flash is not None and film.integral is not None


def test_a_steel_of_the_asked_reliability_is_that_of_the_table():
    assert "K_R" not in steel_of(rating("iso6336")).source
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"reliability": 0.999})
    surer = steel_of(replace(own, rules=own.rules.model_copy(update={"iso6336": rules})))
    assert "K_R = 1.25" in surer.source
    assert surer.contact_strength == near(steel_of(own).contact_strength / 1.25)
    assert surer.bending_strength == near(steel_of(own).bending_strength / 1.25)


def test_a_row_is_asked_without_load_and_of_width_one():
    rows = (("a", Role.SUN, 1), ("b", Role.PLANET, 3))
    gears = {name: SimpleNamespace(name=name, role=role, bodies=bodies) for name, role, bodies in rows}
    mesh = SimpleNamespace(name="m", gears=("a", "b"), sign=-1, count=3)
    train = SimpleNamespace(meshes=[mesh], gear=gears.__getitem__)
    found = row_ask(train, {"a": 20, "b": 31}, mesh, {"m": [5.0]})  # type: ignore[arg-type]
    assert (found.per_tooth, found.teeth, found.width_ratio, found.internal) == (0.0, (20, 31), 1.0, False)
    assert (found.passes, found.roles, found.idlers) == ((3.0, 1.0), (Role.SUN, Role.PLANET), (False, False))
    fewer = SimpleNamespace(name="m", gears=("a", "b"), sign=1, count=1)
    assert row_ask(train, {"a": 20, "b": 31}, fewer, {"m": [5.0]}).passes == (1.0, 1.0)  # type: ignore[arg-type]


def test_yield_strengths_of_two_steels_are_each_gears_own():
    """482 HB − 32 800 psi of AGMA 2001-D04, clause 16.4: 300 HB and 240 HB."""
    own = rating("agma2001")
    wheel = SimpleNamespace(steel="through-hardened", grade=1, hardness_hb=240.0)
    other = own.rules.agma2001.model_copy(
        update={"steel": "through-hardened", "grade": 1, "hardness_hb": 300.0, "wheel": wheel}
    )
    changed = replace(own, rules=own.rules.model_copy(update={"agma2001": other}))
    mesh = loaded("agma2001", own=changed)
    once = mesh.loads[0]._replace(static=True)
    found = worst_yielding(mesh._replace(loads=(once,)))
    assert found.strengths == pytest.approx([(482.0 * hb - 32800.0) * 6894.757 for hb in (300.0, 240.0)], rel=1e-6)
    unknown = replace(own, material=replace(own.material, yield_strength=None))
    case = own.rules.agma2001.model_copy(update={"steel": "carburised", "grade": 1, "wheel": None})
    bare = replace(unknown, rules=own.rules.model_copy(update={"agma2001": case}))
    assert worst_yielding(mesh._replace(rating=bare, loads=(once,))) is None


@pytest.mark.parametrize("method", ["agma2001", "agma2003"])
def test_damages_of_agma_are_turns_over_what_the_curves_bear(method):
    """N where the stress cycle factor equals the stress over its limit; the wheel turns 23/59 as often, three mates."""
    torque = 900.0 if method == "agma2001" else 2600.0
    own = loaded(method, torque, width=30e-3)
    ask = own.heaviest.ask._replace(passes=(2.0, 3.0))
    load = own.heaviest._replace(ask=ask, life=1.0)
    factors = METHODS[method].rate(own._replace(heaviest=load, loads=(load,))).factors
    spectrum = MeshSpectrum(
        own.rating, ask, own.module, own.face_width, torques=(torque,), speeds=(500.0,), turns=(3e6,), steel=None
    )  # type: ignore[arg-type]
    mesh = factors if method == "agma2001" else factors.mesh
    damages = [parts.within() for parts in METHODS[method].damage(spectrum)]
    making = (cylindrical_making_of if method == "agma2001" else bevel_making_of)(own.rating)
    curves = making.curves_of(0) if method == "agma2001" else (CONTACT, BENDING)
    for gear, turns in enumerate((2.0 * 3e6, 3.0 * 3e6 * 23 / 59)):
        one = factors.gears[gear]
        flank = float(one.contact_stress * mesh.contact_cycles[gear] / one.contact_limit)
        root = float(one.bending_stress * mesh.bending_cycles[gear] / one.bending_limit)
        assert damages[gear].pitting == pytest.approx(miner_sum(curves[0], [flank], [turns]), rel=1e-9)
        assert damages[gear].bending == pytest.approx(miner_sum(curves[1], [root], [turns]), rel=1e-9)
        assert damages[gear].pitting > 0.0


def test_method_c_says_up_to_which_speed_it_holds():
    """v z_1/100 √(u²/(1 + u²)) below 3 m/s (ISO 6336-1:2006, clause 6)."""
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"dynamic_method": "C"})
    mesh = loaded("iso6336", own=replace(own, rules=own.rules.model_copy(update={"iso6336": rules})))
    rated = METHODS["iso6336"].rate(mesh)
    (check,) = (c for c in METHODS["iso6336"].checks(rated, MESH, (FIRST, SECOND)) if c.mode == "speed of K_V")
    assert (check.part, check.limit, check.at_most, check.dimension) == (MESH, 3.0, True, "velocity")
    speed = 500.0 * 23 * 4e-3 / math.cos(own.helix_angle) / 2.0
    assert check.value == pytest.approx(speed * 0.23 * 59 / math.hypot(23, 59), rel=1e-9)
    assert check.exponent is None and check.symbol == "v z_1/100"


def test_methods_have_their_editions_by_name():
    editions = {name: method.edition for name, method in ALL.items()}
    assert editions == {
        "lewis-hertz": "Lewis and Hertz", "iso6336": "ISO 6336, method B", "iso6336-2006": "ISO 6336:2006, method B",
        "din3990": "DIN 3990:1987, method B", "iso10300": "ISO 10300, method B1", "agma2001": "ANSI/AGMA 2001-D04",
        "agma2003": "ANSI/AGMA 2003-D19",
    }  # fmt: skip
    for name in ("iso6336", "iso6336-2006", "din3990"):
        assert ALL[name].rate(loaded("iso6336", own=rating(name))).method == name


@pytest.mark.parametrize(("root", "dynamic"), [("B", "B"), ("C", "B"), ("B", "C")])
def test_roots_and_dynamic_factors_are_rated_by_the_methods_that_are_asked(root, dynamic):
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"root_method": root, "dynamic_method": dynamic})
    asked = replace(own, rules=own.rules.model_copy(update={"iso6336": rules}))
    quality = quality_of(asked, idlers=(True, False))
    assert (quality.choices.root, quality.choices.dynamic) == (RatingMethod(root), RatingMethod(dynamic))
    assert quality.mean_stresses == (0.7, 1.0)


def test_all_that_iso_6336_computes_has_its_rows():
    own = rating("iso6336")
    wheel = SimpleNamespace(steel="case-hardened", grade="MQ", hardness_hv=700.0, yield_strength=None)
    rules = own.rules.iso6336.model_copy(update={"micropitting_stage": 8, "wheel": wheel})
    own = replace(own, rules=own.rules.model_copy(update={"iso6336": rules}))
    mesh = loaded("iso6336", own=own)
    once = mesh.loads[0]._replace(static=True, life=1.0, case="once")
    rated = METHODS["iso6336"].rate(mesh._replace(loads=(mesh.loads[0], once)))
    rows = list(METHODS["iso6336"].factors(rated))
    chapters = list(dict.fromkeys(row.chapter for row in rows))
    expected = {"steel", "steel of the second gear", "mesh", "dynamic factor", "face load factor", "pitting"}
    expected |= {"tooth root", "scuffing", "scuffing, flash temperature", "micropitting", "static strength"}
    assert expected <= set(chapters)
    second = {row.quantity: row.values for row in rows if row.chapter == "steel of the second gear"}
    assert second["contact strength"] == (rated.mate_steel.contact_strength,)


def test_tips_that_interfere_do_not_roll():
    """√(r_a² − r_b²) of 50 mm over 43 mm cos 20° is 29.5 mm, the line of action has 21.2 mm."""
    usual = MeshGeometry((18.0, 43.0), 2.0, 20.0, 62.0, (20.9, 45.6))
    assert usual.rolls and not replace(usual, tip_radii=(20.9, 50.0)).rolls
    assert not replace(usual, tip_radii=(30.0, 45.6)).rolls


def test_a_row_asks_for_nothing_where_nothing_is_said():
    assert inspect.signature(rate_row).parameters["asked"].default == (0.0, 0.0)
