"""K_γ, N, tip relief, class and bores where a design states none or some: what sizing takes, by hand."""

import math
from functools import cache

import pytest

from designs import problem
from gearwright.errors import DesignError
from gearwright.parts.iso6336 import running_in_relief
from gearwright.render.drawings.gear_sheet import tooth_grid
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.insight import gear_relief, made_of, rating_as_sized
from gearwright.sizing.rating import load_sharing, rating_of
from gearwright.sizing.rating.iso6336_inputs import steel_of
from gearwright.spec import edited, parse, read
from gearwright.spec.design import split_levels

PAIR = """\
schema = 1
name = "one pair"
shafts = ["fast", "slow"]
level = "concept"
[turbines.turbine]
shaft = "fast"
power_kw = {power}
speed_rpm = {speed}
[loads.load]
shaft = "slow"
[pairs.stage]
pinion = "fast"
wheel = "slow"
pinion_teeth = 30
wheel_teeth = 70
module_mm = 4
face_width_mm = 40
wheel_bore_mm = 100
[gears]
rating = "iso6336"
material = "18CrNiMo7-6"
[service]
life_h = 1000
"""
SET = """\
schema = 1
name = "one set"
shafts = ["fast", "slow"]
level = "concept"
[turbines.turbine]
shaft = "fast"
power_kw = 300
speed_rpm = 6000
[loads.load]
shaft = "slow"
[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
sun_teeth = 30
planet_teeth = 27
ring_teeth = 84
module_mm = 3
face_width_mm = 30
[gears]
rating = "iso6336"
material = "18CrNiMo7-6"
"""
OF_TEETH = "sun_teeth = 30\nplanet_teeth = 27\nring_teeth = 84\n"
TRAIN = """\
schema = 1
name = "train"
shafts = {shafts}
level = "concept"
{machines}[propellers.propeller]
shaft = "out"
speed_rpm = 600
diameter_m = 2
[gears]
rating = "iso6336"
"""
ENGINE = '[turbines.{name}-engine]\nshaft = "{name}"\npower_kw = 100\nspeed_rpm = 6000\n'


def train(shafts, engines, pairs):
    machines = "".join(ENGINE.format(name=name) for name in engines)
    text = TRAIN.format(shafts=shafts, machines=machines).replace("'", '"')
    for name, (pinion, wheel) in pairs.items():
        text += f"[pairs.{name}]\npinion = {pinion!r}\nwheel = {wheel!r}\nratio = 3\n".replace("'", '"')
    return parse(text)


def pair(speed, torque=477.0, **rules):
    """The pair at a speed of its pinion [1/min] with a torque on it [N m]."""
    power = torque * speed * math.pi / 30e3
    told = {f"gears.iso6336.{key}": value for key, value in rules.items()}
    return size(edited(parse(PAIR.format(power=power, speed=float(speed))), told))


def cases(light, share=0.5):
    """Cruise as told, and the rest of the life at the rating."""
    return f"[cases.cruise]\n{light}\n[cases.rated]\nshare = {share}\nturbine.rating = 1\n"


def resonance(sizing):
    (found,) = (check for check in sizing.checks if check.mode == "main resonance")
    return found


@pytest.mark.parametrize(("planets", "factor"), [(3, 1.05), (4, 1.15), (5, 1.19), (6, 1.23)])
def test_planets_share_by_level_3_where_nothing_is_said(planets, factor):
    """AGMA 6123-B06, level 3, with 1.05 at least; the other levels and numbers are as written."""
    design = parse(SET.replace(OF_TEETH, "").replace("planets = 3", f"planets = {planets}"))
    assert load_sharing(design, "set") == load_sharing(parse(SET), "set", planets)
    found = load_sharing(design, "set")
    assert (found.factor, found.usual) == (factor, True)
    told = load_sharing(edited(design, {"planetaries.set.load_sharing": "level-1"}), "set")
    assert told.factor > factor and not told.usual
    assert load_sharing(edited(design, {"gears.mesh_load_factor": 1.4}), "set").factor == 1.4


def test_a_method_without_fatigue_has_all_share_alike():
    assert load_sharing(edited(parse(SET), {"gears.rating": "lewis-hertz"}), "set").factor == 1.0


def test_two_paths_share_as_clocked_ones_and_four_as_two_levels_of_them():
    """1.06 (Krantz & Delgado 1996: 53 % in one of two), 1.06² of four."""
    two = train(["in", "a", "b", "out"], ["in"], {"first": ("in", ["a", "b"]), "last": (["a", "b"], "out")})
    assert {name: load_sharing(two, name).factor for name in two.pairs} == {"first": 1.06, "last": 1.06}
    four = train(
        ["in", "a", "b", "c", "d", "e", "f", "out"], ["in"],
        {"first": ("in", ["a", "b"]), "left": ("a", ["c", "d"]), "right": ("b", ["e", "f"]),
         "last": (["c", "d", "e", "f"], "out")},
    )  # fmt: skip
    assert split_levels(four) == pytest.approx({"first": 1.0, "left": 2.0, "right": 2.0, "last": 2.0})
    assert load_sharing(four, "last").factor == pytest.approx(1.06**2)
    assert load_sharing(four, "first").factor == 1.06


@pytest.mark.parametrize(("way", "factor"), [("clocked", 1.06), ("rigid", 1.20), ("quill", 1.03), ("floating", 1.03)])
def test_paths_share_as_they_are_joined(way, factor):
    two = train(["in", "a", "b", "out"], ["in"], {"first": ("in", ["a", "b"]), "last": (["a", "b"], "out")})
    found = load_sharing(edited(two, {"pairs.first.load_sharing": way}), "first")
    assert (found.factor, found.usual) == (factor, False)


def test_two_engines_on_one_bull_gear_carry_what_each_of_them_gives():
    """No loop: the power of neither has a second way."""
    twin = train(["left", "right", "out"], ["left", "right"], {"bull": (["left", "right"], "out")})
    assert split_levels(twin) == {}
    assert load_sharing(twin, "bull").factor == 1.0


def test_a_pair_before_or_behind_a_split_has_one_path():
    """A row of in – first – a/b – last – mid – end – out: the pairs at both ends lie on no loop."""
    row = train(
        ["in", "near", "a", "b", "mid", "out"], ["in"],
        {"start": ("in", "near"), "first": ("near", ["a", "b"]), "last": (["a", "b"], "mid"), "end": ("mid", "out")},
    )  # fmt: skip
    assert {name: load_sharing(row, name).factor for name in row.pairs} == {
        "start": 1.0, "first": 1.06, "last": 1.06, "end": 1.0
    }  # fmt: skip


def test_the_factor_of_sharing_loads_the_teeth_that_are_sized():
    """F_t K_γ: a set of 3 has 1.05 times the force of equal sharing in every stress, as σ_F of one K_V."""
    equal, usual = (
        size(edited(parse(SET), {"gears.iso6336.dynamic_method": "C"} | told))
        for told in ({"gears.mesh_load_factor": 1.0}, {})
    )
    assert {mesh.load_factor for mesh in usual.meshes} == {1.05}
    for own, other in zip(usual.meshes, equal.meshes, strict=True):
        assert float(own.rating.factors.loads.mesh_load) == 1.05
        assert float(own.rating.factors.tangential_force) == pytest.approx(float(other.rating.factors.tangential_force))


@pytest.mark.parametrize(("speed", "passes"), [(4000, True), (6500, False), (7500, False), (8200, False), (9000, True)])
def test_a_mesh_may_run_below_or_above_its_main_resonance_and_not_in_it(speed, passes):
    """N = n/n_E1 of this pair, whose n_E1 is some 7300 rpm; 0.85 and 1.15 are the ends (ISO 6336-1, clause 6.5.3)."""
    check = resonance(pair(speed))
    found = pair(speed).meshes[0].rating.nearest
    assert check.value == pytest.approx(abs(1.0 - found.ratio))
    assert check.limit == pytest.approx(0.15)
    assert (not check.fails) == passes == (found.ratio < 0.85 or found.ratio > 1.15)
    assert ("gearwright close looks for" in check.why) != passes
    slow = pair(1000).meshes[0].rating.nearest
    assert found.ratio / speed == pytest.approx(slow.ratio / 1000.0, rel=1e-9)


def test_under_light_loads_a_mesh_must_stay_further_below_its_main_resonance():
    """25 N/mm on 40 mm and d_1 = 120 mm are 60 N m: N_S = 0.5 + 0.35 √¼ = 0.675, |1 − N| ≥ 0.325."""
    sizing = pair(4800, torque=25e3 * 40e-3 * 60e-3, tolerance_class=5)
    service = sizing.design.service.application_factor
    begins = 0.5 + 0.35 * math.sqrt(0.25 * service)
    found = sizing.meshes[0].rating.nearest
    assert found.begins == pytest.approx(begins, rel=1e-9)
    assert resonance(sizing).limit == pytest.approx(1.0 - begins)
    assert begins < found.ratio < 0.85 and resonance(sizing).fails


def test_a_mesh_that_passes_its_main_resonance_between_two_cases_is_told():
    design = parse(
        PAIR.format(power=300, speed=10000.0) + cases("share = 0.5\nturbine.speed_rpm = 4000\nturbine.power_kw = 120")
    )
    check = resonance(size(design))
    assert not check.fails and "passes N = 1 between cruise" in check.why and "rated" in check.why
    assert "gearwright close" not in check.why


def test_relief_is_made_for_the_case_that_wears_and_the_heaviest_has_its_own_term():
    """Cruise wears most: C_a = ⌊C_eff⌋ of its load; B_k of take-off is |1 − C_a/C_eff| of its own, with ±15 or 3 µm."""
    text = PAIR.format(power=300, speed=6000.0) + cases("share = 0.99\nturbine.rating = 0.8", 0.01)
    rated = size(parse(text)).meshes[0].rating
    relief, load = rated.factors.relief, float(rated.factors.tangential_force) / 40e-3
    load *= float(rated.factors.loads.application)
    assert rated.case == "rated"
    stiffness = float(relief.stiffness)
    assert float(relief.deflection) == pytest.approx(0.8 * load / stiffness, rel=1e-9)
    amount = math.floor(1e6 * 0.8 * load / stiffness) * 1e-6
    assert float(relief.amount) == pytest.approx(amount)
    tolerance = max(3e-6, 0.15 * amount)
    term = abs(1.0 - amount * stiffness / load) + tolerance * stiffness / load
    assert float(rated.factors.dynamic.relief_term) == pytest.approx(term, rel=1e-9)


def test_teeth_have_no_relief_only_where_zero_is_written():
    """Left out it is made for the load, or is what running in leaves, which it never is below."""
    ran_in = running_in_relief((steel_of(rating_of(pair(6000).design, "stage")),) * 2)
    made = {
        name: pair(6000, torque, **rules).meshes[0].rating.made.relief
        for name, torque, rules in (
            ("open", 477.0, {}), ("faint", 1.0, {}), ("run-in", 477.0, {"tip_relief_for": "run-in"}),
            ("none", 477.0, {"tip_relief_um": 0.0}), ("told", 477.0, {"tip_relief_um": 9.0}),
        )
    }  # fmt: skip
    assert made["none"] == 0.0 and made["told"] == pytest.approx(9e-6)
    assert made["faint"] == made["run-in"] == pytest.approx(ran_in)
    assert made["open"] > ran_in > 0.0


@pytest.mark.parametrize(("speed", "own"), [(2000, 6), (2400, 5), (9500, 5), (9600, 4)])
def test_teeth_are_made_to_a_class_by_their_speed(speed, own):
    """d = 120 mm: 15 m/s at 2387 rpm, 60 m/s at 9549 rpm."""
    assert pair(speed).meshes[0].rating.made.grade == own
    assert rating_as_sized(pair(speed), "stage").rules.iso6336.tolerance_class == own
    assert pair(speed, tolerance_class=7).meshes[0].rating.made.grade == 7


def test_the_fastest_case_decides_the_class_and_not_the_heaviest():
    fast = cases("share = 0.5\nturbine.speed_rpm = 9700\nturbine.power_kw = 30")
    rated = size(parse(PAIR.format(power=300, speed=6000.0) + fast)).meshes[0].rating
    assert (rated.case, rated.made.grade) == ("rated", 4)


def test_bores_beyond_the_roots_are_refused_with_path_value_and_what_is_allowed():
    """z 30, m_n 4 mm: d_f = 120 − 10 = 110 mm, less half of 2.25 m_n on both sides 101 mm; z 70: 270 and 261 mm."""
    with pytest.raises(DesignError) as caught:
        size(edited(parse(PAIR.format(power=50, speed=6000.0)), {"pairs.stage.pinion_bore_mm": 107,
                                                                "pairs.stage.wheel_bore_mm": 266}))  # fmt: skip
    pinion, wheel = caught.value.problems
    assert (pinion.path, wheel.path) == ("pairs.stage.pinion_bore_mm", "pairs.stage.wheel_bore_mm")
    for found, given, root, most in ((pinion, 107, 110, 101), (wheel, 266, 270, 261)):
        assert found.message.startswith(f"{given} mm, and {found.path.split('.')[1]}.")
        assert f"has a root circle of {root} mm; allowed: up to {most} mm" in found.message
        assert "give a smaller bore, or the gear more teeth or a larger module" in found.message
    just = {"pairs.stage.pinion_bore_mm": 101, "pairs.stage.wheel_bore_mm": 261}
    assert size(edited(parse(PAIR.format(power=50, speed=6000.0)), just)).gears


def test_bores_of_gears_and_of_shafts_through_them_are_held_to_one_rule_and_told_together():
    told = {"pairs.stage.pinion_bore_mm": 101.5, "layout.fast.bore_mm": 101.5, "layout.slow.bore_mm": 261.5}
    with pytest.raises(DesignError) as caught:
        size(edited(parse(PAIR.format(power=50, speed=6000.0)), told))
    assert sorted(found.path for found in caught.value.problems) == sorted(told)


def test_bores_of_sets_and_compound_sets_are_refused_by_their_own_keys():
    with pytest.raises(DesignError) as caught:
        size(edited(parse(SET), {"planetaries.set.sun_bore_mm": 81, "planetaries.set.planet_bore_mm": 72}))
    assert [found.path for found in caught.value.problems] == [
        "planetaries.set.sun_bore_mm", "planetaries.set.planet_bore_mm"
    ]  # fmt: skip


def test_a_bore_makes_a_gear_lighter_in_its_vibration_and_the_resonance_faster():
    solid, bored = (
        size(edited(parse(PAIR.format(power=50, speed=6000.0)), {"pairs.stage.pinion_bore_mm": bore})).meshes[0]
        for bore in (1, 90)
    )
    masses = [float(mesh.rating.factors.dynamic.reduced_mass) for mesh in (solid, bored)]
    ratios = [float(mesh.rating.factors.dynamic.resonance_ratio) for mesh in (solid, bored)]
    assert masses[1] < masses[0]
    assert ratios[1] / ratios[0] == pytest.approx(math.sqrt(masses[1] / masses[0]), rel=1e-9)


def test_a_sun_moves_with_its_planets_and_planets_alone_in_a_held_ring():
    """m_s m_p/(m_s + 3 m_p), m_p: with n_s − n_c and n_p − n_c in N, and c_γα of either mesh."""
    sizing = size(edited(parse(SET), {"planetaries.set.sun_bore_mm": 20, "planetaries.set.planet_bore_mm": 40}))
    sun, ring = (mesh.rating.factors.dynamic for mesh in sizing.meshes)
    base = 3e-3 * math.cos(math.radians(20.0))
    mean = {"sun": 3e-3 * (30 - 0.25), "planet": 3e-3 * (27 - 0.25)}
    masses = {
        name: math.pi / 8.0 * 7830.0 * (mean[name] ** 4 - bore**4) / (base * teeth) ** 2
        for name, teeth, bore in (("sun", 30, 20e-3), ("planet", 27, 40e-3))
    }
    expected = masses["sun"] * masses["planet"] / (masses["sun"] + 3.0 * masses["planet"])
    assert float(sun.reduced_mass) == pytest.approx(expected, rel=2e-3)
    assert float(ring.reduced_mass) == pytest.approx(masses["planet"], rel=2e-3)


@cache
def related():
    """The set with open relief, with its relief and tolerance written, and without."""
    usual = size(edited(parse(SET), {"gears.iso6336.tolerance_class": 5}))
    made = usual.meshes[0].rating.made
    told = {
        "gears.iso6336.tip_relief_um": 1e6 * made.relief,
        "gears.iso6336.tip_relief_tolerance_um": 1e6 * made.tolerance,
    }
    return tuple(size(edited(usual.design, one)) for one in ({}, told, {"gears.iso6336.tip_relief_um": 0.0}))


def test_dynamic_factor_scuffing_and_drawings_read_one_relief():
    usual, told, bare = related()
    for own, same, none in zip(usual.meshes, told.meshes, bare.meshes, strict=True):
        for pick in (lambda rated: float(rated.factors.dynamic.factor), lambda rated: rated.scuffing.tip_relief,
                     lambda rated: rated.flash.contact):  # fmt: skip
            assert pick(own.rating) == pytest.approx(pick(same.rating), rel=1e-9)
        assert own.rating.scuffing.tip_relief > none.rating.scuffing.tip_relief
        assert float(own.rating.factors.dynamic.factor) < float(none.rating.factors.dynamic.factor)
    for gear in usual.gears:
        relief = gear_relief(usual, gear.name)
        rows = {name: value for name, _, value in tooth_grid(usual, gear, gear.shafts[0]).rows}
        assert relief == pytest.approx(usual.meshes[0].rating.made.relief) and relief > 0.0
        assert rows["Tip relief"] == f"{1e6 * relief:.3g} µm"


def test_both_meshes_of_a_planet_have_the_tips_that_it_has():
    """Its tips are made once, for the stiffer mesh in the ring."""
    sun, ring = (mesh.rating.factors.relief for mesh in related()[0].meshes)
    assert float(sun.amount) == float(ring.amount)
    assert float(sun.stiffness) < float(ring.stiffness)
    assert float(ring.deflection) == pytest.approx(float(sun.deflection), rel=1e-9)


def test_teeth_that_are_sized_keep_relief_and_class_whatever_they_carry_later():
    for mesh in related()[0].meshes:
        made = made_of(mesh)
        assert (made.relief, made.tolerance, made.grade) == (
            float(mesh.rating.factors.relief.amount), float(mesh.rating.factors.relief.tolerance), 5.0
        )  # fmt: skip
    lewis = size(edited(parse(SET), {"gears.rating": "lewis-hertz"}))
    assert made_of(lewis.meshes[0]) is None and gear_relief(lewis, "set.sun") is None


@pytest.mark.parametrize(("key", "value", "words"), [
    ("load_sharing", '"tolerances"', "is required"), ("pin_position_um", "10", "has no effect without load_sharing"),
])  # fmt: skip
def test_tolerances_of_pins_and_their_level_ask_for_each_other(key, value, words):
    found = problem(SET.replace("face_width_mm = 30\n", f"face_width_mm = 30\n{key} = {value}\n"))
    assert found.path == "planetaries.set.pin_position_um" and words in found.message


def test_tolerances_of_pins_give_a_factor_by_the_sizes_they_load():
    """1 + 2.5 √((5 − 3)/5) s k/F_t of the larger of both meshes: more of it with wider tolerances, at least 1.05."""

    def factor(microns):
        told = {"load_sharing": "tolerances", "pin_position_um": microns, "planets": 5, "sun_teeth": 31,
                "planet_teeth": 24, "ring_teeth": 79}  # fmt: skip
        changes = {f"planetaries.set.{key}": value for key, value in told.items()}
        (found,) = {mesh.load_factor for mesh in size(edited(parse(SET), changes)).meshes}
        return found

    assert factor(0.1) == 1.05
    assert factor(4.0) - 1.0 == pytest.approx(2.0 * (factor(2.0) - 1.0), rel=5e-3)


def test_the_split_path_that_is_shipped_takes_what_clocked_paths_share():
    sizing = size(edited(read(shipped_design("off-set")), {"gears.rating": "iso6336"}))
    assert {mesh.load_factor for mesh in sizing.meshes} == {1.06}
