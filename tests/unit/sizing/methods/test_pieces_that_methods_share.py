"""Pieces that every method of rating shares, without a sizing: searches, widths, rims, shifts, teeth, rows."""

import inspect
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.identity import Role
from gearwright.parts.gears import ToothShift, contact_angles
from gearwright.parts.iso6336 import MeshGeometry
from gearwright.shipped import shipped_design
from gearwright.sizing.rating import Ask
from gearwright.sizing.rating.context import bends_both_ways, rate_row, row_ask
from gearwright.sizing.rating.geometry import (
    STANDARD_MODULES,
    cylindrical_mesh,
    fewest_virtual_teeth,
    least_width,
    narrowest,
    next_standard,
    push_angle,
    rim_factors,
    ring_problems,
    under_spectrum,
    widest_ratio,
    working_radii,
)
from gearwright.sizing.rating.lewis_hertz import working_angles
from gearwright.sizing.rating.protocol import _open_shifts, by_teeth, module_for
from gearwright.spec import edited, read
from rated_pieces import OFF_SET, near, rating


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
    """b = ε_β π m_n/sin β, and no less than six modules; straight teeth of methods without a width from one on."""
    slanted = SimpleNamespace(
        helix_angle=math.radians(20.0), rules=SimpleNamespace(overlap_ratio=1.3), proportions=None
    )
    straight = SimpleNamespace(helix_angle=0.0, rules=slanted.rules, proportions=None)
    usual = SimpleNamespace(narrowest_modules=6.0)
    assert least_width(slanted, 3e-3) == near(1.3 * math.pi * 3e-3 / math.sin(math.radians(20.0)))
    assert least_width(straight, 3e-3) == 3e-3
    straight.proportions = slanted.proportions = usual
    assert least_width(straight, 3e-3) == near(18e-3)
    assert least_width(slanted, 3e-3) == near(1.3 * math.pi * 3e-3 / math.sin(math.radians(20.0)))
    slanted.helix_angle = math.radians(60.0)
    assert least_width(slanted, 3e-3) == near(18e-3)
    asked = []

    def reserve(width):
        asked.append(width)
        return width / 12.4e-3

    assert narrowest(4.2e-3, 30.7e-3, reserve) == near(13e-3)
    assert min(asked) > 4e-3 and max(asked) < 31e-3
    assert narrowest(40e-3, 20e-3, reserve) == near(20e-3)
    assert narrowest(5e-3, 30e-3, lambda width: 1.0) == near(5e-3)


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
        rating = SimpleNamespace(rules=SimpleNamespace(rim_thickness_ratio=ratio, rim_ratio=None))
        with pytest.raises(DesignError, match="rates rims above"):
            rim_factors(rating, (Role.PLANET, Role.RING), internal=True)
        (problem,) = ring_problems(rating)
        assert problem.path == "gears.rim_thickness_ratio" and problem.message.endswith("give more than 3")
    assert not list(ring_problems(own))


@pytest.mark.parametrize("table", ["gears", "planetaries.first.gears"])
@pytest.mark.parametrize(
    ("entries", "key", "said"),
    [
        ({"rim_thickness_ratio": 1.2}, "rim_thickness_ratio", "give more than 3"),
        ({"iso6336.ring_cutter.teeth": 400}, "iso6336.ring_cutter.teeth", "400 given; a ring of"),
    ],
)
def test_what_the_method_does_not_cover_is_told_once_where_it_is_written(table, entries, key, said):
    design = edited(gw.read("hybrid-turboprop"), {f"{table}.{name}": value for name, value in entries.items()})
    with pytest.raises(DesignError) as refused:
        gw.size(design)
    assert {problem.path for problem in refused.value.problems} == {f"{table}.{key}"}
    assert len(set(refused.value.problems)) == len(refused.value.problems)
    assert said in refused.value.problems[0].message


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


def test_a_row_is_asked_without_load_and_of_width_one():
    rows = (("a", Role.SUN, 1), ("b", Role.PLANET, 3))
    gears = {name: SimpleNamespace(name=name, role=role, bodies=bodies, stage="s") for name, role, bodies in rows}
    one = {"name": "m", "stage": "s", "gears": ("a", "b"), "nodes": ("x", "y", "ground"), "sized": "s", "row": "row"}
    mesh = SimpleNamespace(**one, sign=-1, count=3)
    bored = SimpleNamespace(stages={"s": SimpleNamespace(sun_bore=12e-3, planet_bore=None)})
    train = SimpleNamespace(meshes=[mesh], gear=gears.__getitem__)
    found = row_ask(train, {"a": 20, "b": 31}, mesh, {"m": [5.0]}, bored)  # type: ignore[arg-type]
    assert (found.per_tooth, found.teeth, found.width_ratio, found.internal) == (0.0, (20, 31), 1.0, False)
    assert (found.passes, found.roles, found.idlers) == ((3.0, 1.0), (Role.SUN, Role.PLANET), (False, False))
    assert (found.bores, found.held, found.beyond, found.made) == ((12e-3, None), (False, False), (None, None), None)
    standing = SimpleNamespace(**one | {"nodes": ("x", "ground", "y")}, sign=1, count=1)
    train = SimpleNamespace(meshes=[standing], gear=gears.__getitem__)
    found = row_ask(train, {"a": 20, "b": 31}, standing, {"m": [5.0]}, bored)  # type: ignore[arg-type]
    assert (found.passes, found.held) == ((1.0, 1.0), (False, True))


def test_tips_that_interfere_do_not_roll():
    """√(r_a² − r_b²) of 50 mm over 43 mm cos 20° is 29.5 mm, the line of action has 21.2 mm."""
    usual = MeshGeometry((18.0, 43.0), 2.0, 20.0, 62.0, (20.9, 45.6))
    assert usual.rolls and not replace(usual, tip_radii=(20.9, 50.0)).rolls
    assert not replace(usual, tip_radii=(30.0, 45.6)).rolls


def test_a_row_asks_for_nothing_where_nothing_is_said():
    assert inspect.signature(rate_row).parameters["asked"].default == (0.0, 0.0)
