"""What a method is asked, and what it answers: modules that just meet the safeties, cycles, damages, checks."""

import math
from dataclasses import replace

import numpy as np
import pytest

from designs import PAIR
from gearwright.identity import Role
from gearwright.parts.iso6336 import damage_part
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.sizing.rating import METHODS, Ask, modules, rating_of, row_ask
from gearwright.sizing.rating.agma import making_of
from gearwright.sizing.rating.geometry import bevel_pair, cone_ratio, fewest_virtual_teeth, mean_module
from gearwright.sizing.rating.iso6336_inputs import duty_of, quality_of
from gearwright.sizing.rating.protocol import Load, LoadedMesh, MeshSpectrum
from gearwright.spec import edited, parse, read, read_mission
from mounted_designs import HELICOPTER

OFF_SET = read(shipped_design("off-set"))
BY_METHOD = {
    "lewis-hertz": rating_of(edited(OFF_SET, {"gears.rating": "lewis-hertz"}), "first"),
    "iso6336": rating_of(edited(OFF_SET, {"gears.rating": "iso6336"}), "first"),
    "agma2001": rating_of(edited(OFF_SET, {"gears.rating": "agma2001"}), "first"),
    "iso10300": rating_of(parse(HELICOPTER), "bevel"),
}


def answer(rating, ask, module):
    """Return the rating of one mesh of a module under what is asked, all its life."""
    load = Load("rated", float(ask.per_tooth * ask.teeth[0]), ask, rating.service.life)
    return METHODS[rating.method].rate(LoadedMesh(rating, module, ask.width_ratio * module, load, (load,), (0.0, 0.0)))


@pytest.mark.parametrize("method", BY_METHOD)
def test_the_module_that_is_asked_for_just_bears_the_load(method):
    """Rated with it, the margin of its mode is 1: 1e-3 for what is searched, rounding for the closed form."""
    rating = BY_METHOD[method]
    ask = Ask(13.0, (23, 59), 8.0, speed=500.0)
    for module, margin in zip(modules(ask, rating), ("bending_margin", "contact_margin"), strict=True):
        assert getattr(answer(rating, ask, float(module)), margin) == pytest.approx(1.0, abs=2e-3)


@pytest.mark.parametrize("method", BY_METHOD)
def test_meshes_asked_at_once_get_what_each_alone_gets(method):
    """Choices of teeth with their loads as arrays; one that bears nothing asks for nothing."""
    rating, (small, large) = BY_METHOD[method], (np.array([21, 23, 23]), np.array([80, 59, 59]))
    loads, speed = np.array([11.0, 13.0, 26.0]), np.array([300.0, 500.0, 500.0])
    together = modules(Ask(loads, (small, large), 8.0, speed=speed), rating)
    for k in range(3):
        alone = modules(Ask(loads[k], (int(small[k]), int(large[k])), 8.0, speed=speed[k]), rating)
        tolerance = 2e-2 if method == "iso10300" and k == 2 else 1e-9
        for mode in (0, 1):
            assert float(together[mode][k]) == pytest.approx(float(alone[mode]), rel=tolerance)
    idle = modules(Ask(np.zeros(3), (small, large), 8.0, speed=speed), rating)
    assert not np.any(idle[0]) and not np.any(idle[1])


def test_an_ask_is_of_two_external_gears_loaded_on_one_flank():
    """A ring is the softer partner, an idler bends both ways: neither is meant where nothing is said."""
    rating, plain = BY_METHOD["lewis-hertz"], Ask(13.0, (23, 59), 8.0)
    told = Ask(13.0, (23, 59), 8.0, internal=False, idlers=(False, False), speed=0.0, passes=(1.0, 1.0))
    assert plain == told
    assert float(modules(plain, rating)[1]) > float(modules(plain._replace(internal=True), rating)[1])
    idle = replace(rating, rules=rating.rules.model_copy(update={"idler_factor": 0.7}))
    for idlers in ((True, False), (False, True)):
        more = float(modules(plain._replace(idlers=idlers), idle)[0]) / float(modules(plain, idle)[0])
        assert more == pytest.approx(0.7 ** (-1.0 / 3.0))


@pytest.mark.parametrize("name", ["in-line-h2", "off-set", "star"])
def test_a_tooth_meets_as_many_mates_in_a_turn_as_pass_it(name):
    """Of a sun and a ring every planet, of a planet one of each, of the single gear of a pair all on the other side."""
    sizing = size(read(shipped_design(name)))
    loads = {row: [mesh.torques[0]] for row, mesh in sizing.flows["rated"].meshes.items()}
    for mesh in sizing.train.meshes:
        ask = row_ask(sizing.train, sizing.teeth, mesh, loads, sizing.design)
        stage = sizing.design.stages[mesh.stage]
        planets = getattr(stage, "planets", 0)
        mates = () if planets else (len(stage.named(Role.WHEEL)), len(stage.named(Role.PINION)))
        for gear, idler, passes in zip(mesh.gears, ask.idlers, ask.passes, strict=True):
            assert idler == gear.endswith(".planet")
            if planets:
                assert passes == (1.0 if idler else planets)
            else:
                assert passes == mates[mesh.gears.index(gear)]
        assert ask.internal == any(gear.endswith(".ring") for gear in mesh.gears)
        assert ask.teeth == tuple(sizing.teeth[gear] for gear in mesh.gears)


def test_cycles_are_turns_times_mates():
    """n = ω L q/(2 π), with the speed against the carrier."""
    sizing = size(edited(read(shipped_design("single-planetary")), {"gears.rating": "iso6336"}))
    (stage,) = sizing.design.planetaries.values()
    life, speeds = sizing.design.service.life, sizing.flows["rated"].speeds
    relative = abs(speeds[stage.sun] - speeds[stage.carrier])
    for mesh in sizing.meshes:
        sun = next(name for name in sizing.teeth if name.endswith(".sun"))
        own = [sizing.teeth[sun] / sizing.teeth[gear] for gear in mesh.gears]
        mates = [1 if gear.endswith(".planet") else stage.planets for gear in mesh.gears]
        for cycles, ratio, count in zip(mesh.rating.factors.cycles, own, mates, strict=True):
            assert float(cycles) == pytest.approx(relative * life / (2.0 * math.pi) * ratio * count, rel=1e-9)


def test_quality_and_duty_are_what_the_design_says():
    rating = BY_METHOD["iso6336"]
    quality = quality_of(rating, idlers=(False, True))
    rules = rating.rules.iso6336
    assert quality.mean_stresses == (1.0, 0.7) and quality.grade == rules.tolerance_class
    assert quality.viscosity == pytest.approx(1e-6 * rules.oil_viscosity)
    assert (quality.flank_roughness, quality.root_roughness) == (rules.flank_roughness, rules.root_roughness)
    ask = Ask(0.0, (20, 60), 10.0, passes=(2.0, 1.0), relieved=3.0, fastest=70.0)
    duty = duty_of(replace(rating, load_factor=1.25), 100.0, 50.0, life=7.0, ask=ask)
    assert (float(duty.relief_torque), float(duty.fastest)) == (pytest.approx(3.0 * 20 / 1.25), 70.0)
    bare = duty_of(rating, 100.0, 50.0, life=7.0, ask=Ask(0.0, (20, 60), 10.0))
    assert (bare.relief_torque, bare.fastest) == (None, None)
    assert float(duty.pinion_torque) == pytest.approx(80.0) and duty.mesh_load_factor == 1.25
    assert (float(duty.pinion_speed), float(duty.life), duty.meshes_per_turn) == (50.0, 7.0, (2.0, 1.0))
    assert duty.application_factor == rating.service.application_factor


def test_tip_relief_takes_its_part_of_the_deflection_out_of_the_dynamic_factor_and_cools_the_flank():
    """By hand: B_k = |1 − c′ C_a b/(F_t K_A K_γ)| with c′ near 14 N/(mm µm); X_Ca of ISO/TS 6336-21 grows with C_a."""
    told = {"gears.rating": "iso6336", "gears.iso6336.tolerance_class": 5}
    told |= {"pairs.first.module_mm": 4.0, "pairs.first.face_width_mm": 50.0}
    plain, half, relieved = (
        size(edited(OFF_SET, told | {"gears.iso6336.tip_relief_um": relief})).meshes[0].rating
        for relief in (0.0, 2.0, 4.0)
    )
    terms = [float(rated.factors.dynamic.relief_term) for rated in (plain, half, relieved)]
    loads = plain.factors.loads
    load = float(plain.factors.tangential_force) * float(loads.application) * float(loads.mesh_load) / 0.050
    assert terms[0] == 1.0
    assert 1.0 - terms[2] == pytest.approx(2.0 * (1.0 - terms[1]), rel=1e-9)
    assert 10e9 < (1.0 - terms[1]) * load / 2e-6 < 18e9
    assert relieved.factors.dynamic.factor < plain.factors.dynamic.factor
    assert relieved.scuffing.tip_relief > plain.scuffing.tip_relief


@pytest.mark.parametrize(("crowned", "adjusted"), [(False, False), (True, False), (False, True), (True, True)])
def test_crowned_and_adjusted_gears_of_agma_have_four_fifths(crowned, adjusted):
    rules = {"gears.rating": "agma2001", "gears.agma2001.crowned": crowned, "gears.agma2001.adjusted": adjusted}
    making = making_of(rating_of(edited(OFF_SET, rules), "first"))
    assert making.crowning == (0.8 if crowned else 1.0) and making.adjustment == (0.8 if adjusted else 1.0)


@pytest.mark.parametrize(
    ("steel", "hardness", "start"),
    [
        ("carburised", None, 2.7), ("through-hardened", 180.0, 1.6), ("through-hardened", 240.0, 2.4),
        ("through-hardened", 340.0, 3.4), ("nitrided-4140", 300.0, 2.0),
    ],
)  # fmt: skip
def test_the_curve_of_a_steel_is_that_of_its_hardness(steel, hardness, start):
    """Y_N at 1000 cycles, AGMA 2001-D04, figure 17."""
    fitting = {"carburised": "18CrNiMo7-6", "through-hardened": "structural-steel"}
    rules = {"gears.rating": "agma2001", "gears.agma2001.steel": steel, "gears.agma2001.grade": 1}
    rules["gears.material"] = fitting.get(steel, "nitriding-steel-785")
    if hardness is not None:
        rules["gears.agma2001.hardness_hb"] = hardness
    making = making_of(rating_of(edited(OFF_SET, rules), "first"))
    assert making.bending_curve.factors[0] == pytest.approx(start, rel=1e-3)
    assert 1.0 / making.contact_curve.slope == pytest.approx(0.0138 if steel == "nitrided-4140" else 0.056)


def spectrum(rating, torques, *, module=0.003, width=0.03):
    """Return a flight's classes of one mesh."""
    steel = read_mission(shipped_mission("regional-250nm")).gears
    ask = Ask(0.0, (23, 59), width / module, passes=(2.0, 1.0))
    speeds = (500.0, 450.0)[: len(torques)]
    turns = (3e6, 2e7)[: len(torques)]
    return MeshSpectrum(rating, ask, module, width, steel=steel, torques=torques, speeds=speeds, turns=turns)


def damages_by(method, asked):
    """Return Miner's sums of both gears."""
    return [parts.within() for parts in METHODS[method].damage(asked)]


@pytest.mark.parametrize("method", ["agma2001", "iso6336", "iso10300"])
def test_damages_of_classes_add_up_and_a_wheel_turns_less(method):
    """Miner: two classes take what each alone takes; cycles of the wheel are 23/59 of the pinion's, half as many."""
    rating = BY_METHOD[method]
    whole = damages_by(method, spectrum(rating, (600.0, 500.0)))
    first = damages_by(method, spectrum(rating, (600.0,)))
    both = spectrum(rating, (600.0, 500.0))
    second = damages_by(method, both._replace(torques=both.torques[1:], speeds=both.speeds[1:], turns=both.turns[1:]))
    for gear in (0, 1):
        for mode in ("pitting", "bending"):
            parts = getattr(first[gear], mode) + getattr(second[gear], mode)
            assert getattr(whole[gear], mode) == pytest.approx(parts, rel=1e-9)
    assert whole[0].pitting / whole[1].pitting == pytest.approx(
        2.0 * 59.0 / 23.0, rel=1e-6 if "iso" in method else 0.15
    )


def test_damage_by_agma_is_stress_over_its_limit_on_the_curve():
    """n/N with N where Z_N and Y_N equal the stress over its limit; stresses of the same mesh rated for that torque."""
    rating, module, width = BY_METHOD["agma2001"], 0.003, 0.03
    (pinion, wheel) = damages_by("agma2001", spectrum(rating, (900.0,)))
    making = making_of(rating)
    ask = Ask(900.0 / 23, (23, 59), width / module, speed=500.0, passes=(2.0, 1.0))
    load = Load("", 900.0, ask, 1.0)
    factors = METHODS["agma2001"].rate(LoadedMesh(rating, module, width, load, (load,), (0.0, 0.0))).factors
    for gear, (damage, turns) in enumerate(((pinion, 2.0 * 3e6), (wheel, 3e6 * 23 / 59))):
        one = factors.gears[gear]
        flank = float(one.contact_stress * factors.contact_cycles[gear] / one.contact_limit)
        root = float(one.bending_stress * factors.bending_cycles[gear] / one.bending_limit)
        assert damage.pitting == pytest.approx(damage_part(turns, flank, making.contact_curve), rel=1e-9)
        assert damage.bending == pytest.approx(damage_part(turns, root, making.bending_curve), rel=1e-9)
        below, above = (2.466 / flank) ** (1.0 / 0.056), (1.4488 / flank) ** (1.0 / 0.023)
        allowed = below if below <= 1e7 else above
        assert damage.pitting == pytest.approx(turns / allowed, rel=1e-6)


@pytest.mark.parametrize("method", ["iso6336", "iso10300"])
def test_damage_by_iso_grows_with_the_slope_of_its_curves(method):
    """Stress goes with the root of the load in contact and with the load in bending, but for the load factors."""
    rating = BY_METHOD[method]
    for mode, share, load in (("pitting", 0.5, 450.0), ("bending", 1.0, 1200.0)):
        load *= 2.0 if (method, mode) == ("iso10300", "pitting") else 1.0
        damages, more = (damages_by(method, spectrum(rating, (torque,))) for torque in (load, 1.05 * load))
        slope = METHODS[method].life_slope(rating, mode, None)
        for lighter, heavier in zip(damages, more, strict=True):
            grown = math.log(getattr(heavier, mode) / getattr(lighter, mode)) / math.log(1.05)
            assert grown == pytest.approx(share * slope, rel=0.15)


@pytest.mark.parametrize(("shift", "fewest"), [(-0.2, 21), (0.0, 18), (0.3, 12)])
def test_undercut_is_checked_with_the_profile_shift(shift, fewest):
    """z_min = 2 (1 − x)/sin² 20°: 20.5, 17.1 and 12.0 (ISO 21771)."""
    text = PAIR + f'pinion_teeth = 23\nwheel_teeth = 69\n[gears]\nrating = "iso6336"\nprofile_shift = {shift}\n'
    check = next(check for check in size(parse(text)).checks if check.name == "stage.pinion undercut")
    assert (check.value, check.limit) == (23, fewest)


def test_forces_of_a_bevel_mesh_are_those_of_its_cones():
    """F_a = F_t (tan α sin δ + sin β cos δ)/cos β of the driving pinion, F_r with cos δ and − sin δ (Niemann)."""
    sizing = size(parse(HELICOPTER))
    mesh = next(mesh for mesh in sizing.meshes if mesh.stage == "bevel")
    gear = next(gear for gear in sizing.gears if gear.name == "bevel.pinion")
    alpha, beta = sizing.design.rules("bevel").pressure_angle, math.radians(35.0)
    cone, force = math.atan(17 / 43), mesh.tangential_force
    torque = abs(sizing.flows["rated"].meshes["bevel"].torques[0])
    assert force == pytest.approx(2.0 * torque / gear.pitch_diameter * mesh.load_factor)
    axial = force / math.cos(beta) * (math.tan(alpha) * math.sin(cone) + math.sin(beta) * math.cos(cone))
    radial = force / math.cos(beta) * (math.tan(alpha) * math.cos(cone) - math.sin(beta) * math.sin(cone))
    assert mesh.axial_force == pytest.approx(axial) and mesh.radial_force == pytest.approx(radial)


def test_bevel_teeth_in_numbers_of_iso_23509():
    """R_e/m_et = √(z_1² + z_2²)/2; m_mn = cos β_m (m_et − b/(2 R_e/m_et)); z_v,min = 2 h* cos β/sin² α_t."""
    rating = BY_METHOD["iso10300"]
    assert float(cone_ratio(17, 43)) == pytest.approx(math.sqrt(17**2 + 43**2) / 2.0)
    pair = bevel_pair((17, 43), 0.005, 0.04, rating)
    assert mean_module((17, 43), pair.outer_module, 0.04, rating) == pytest.approx(0.005)
    assert pair.outer_module == pytest.approx(0.005 / math.cos(math.radians(35.0)) + 0.04 / math.hypot(17, 43))
    angle = rating.rules.pressure_angle
    transverse = math.atan(math.tan(angle) / math.cos(math.radians(35.0)))
    straight = 1.25 - 0.3 * (1.0 - math.sin(angle))
    fewest = 2.0 * straight * math.cos(math.radians(35.0)) / math.sin(transverse) ** 2
    assert fewest_virtual_teeth(rating) == pytest.approx(fewest)


def test_width_of_bevel_gears_is_three_tenths_of_the_cone():
    """b = 0.30 R_e, at most 10 m_et; λ = b/m_mn with m_mn at the middle of the face."""
    rating = BY_METHOD["iso10300"]
    for small, large in ((17, 43), (30, 90)):
        cone = math.hypot(small, large) / 2.0
        width = min(0.3 * cone, 10.0)
        mean = math.cos(math.radians(35.0)) * (1.0 - width / (2.0 * cone))
        found = METHODS["iso10300"].width_ratio(rating, np.array([small]), np.array([large]))
        assert float(found[0]) == pytest.approx(width / mean)


def test_a_case_of_no_share_takes_no_life():
    """The safeties are those of the design without that case, even where it is the heaviest but one."""
    cases = "[cases.full.turbine]\npower_kw = 100\n[cases.low.turbine]\npower_kw = 60\n"
    cases += "[cases.half.turbine]\npower_kw = 95\n"
    text = PAIR + "pinion_teeth = 23\nwheel_teeth = 69\nmodule_mm = 3\nface_width_mm = 30\n"
    text += '[gears]\nrating = "iso6336"\n'
    shares = "[service]\nshares = {{ full = 0.3, low = {}, half = {} }}\n"
    (none,), (half,) = (size(parse(text + cases + shares.format(*parts))).meshes for parts in ((0.7, 0.0), (0.3, 0.4)))
    without = cases.partition("[cases.half")[0] + "[service]\nshares = { full = 0.3, low = 0.7 }\n"
    (alone,) = size(parse(text + without)).meshes
    assert none.rating.pitting == pytest.approx(alone.rating.pitting, rel=1e-12)
    assert none.rating.bending == pytest.approx(alone.rating.bending, rel=1e-12)
    assert half.rating.pitting[0] < none.rating.pitting[0]
