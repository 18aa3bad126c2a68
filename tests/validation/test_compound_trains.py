"""Compound trains against published and independently computed numbers: ratios, torque ratios, efficiencies."""

import math

import pytest

from designs import problems
from gearwright.parts.planetary import CompoundSet, assembles, can_assemble
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.train import build_train, efficiencies, power_flow, recirculation, teeth_of
from gearwright.validate.trains import FORD_6R_80, FORD_AOD, GM_8L_90, THM_440_T4, WOLFROM, ZF_8HP_70, wolfrom

EACH = {"sun-planet": math.sqrt(0.98), "planet-ring": math.sqrt(0.98)}
LESS = {"sun-planet": math.sqrt(0.97), "planet-ring": math.sqrt(0.97)}


@pytest.mark.parametrize(
    "gear, ratio, upper, lower",
    [
        ("R", -3.817561, -3.614877, -3.515548),
        ("1", 4.56, 4.4888, 4.4532),
        ("2", 2.970909, 2.903869, 2.870391),
        ("3", 2.075128, 2.050345, 2.037961),
        ("4", 1.687551, 1.664959, 1.653752),
        ("5", 1.270011, 1.257822, 1.251821),
        ("6", 1.0, 1.0, 1.0),
        ("7", 0.845486, 0.841064, 0.838785),
        ("8", 0.651515, 0.646914, 0.644568),
    ],
)
def test_every_gear_of_the_gm_8l_90_has_the_ratio_and_torque_ratios_of_equilibrium(gear, ratio, upper, lower):
    """Independent program: one Willis row and one torque law a set; six digits."""
    assert GM_8L_90.ratio(gear) == pytest.approx(ratio, rel=1e-6)
    assert GM_8L_90.torque_ratio(gear, EACH) == pytest.approx(upper, rel=1e-6)
    assert GM_8L_90.torque_ratio(gear, LESS) == pytest.approx(lower, rel=1e-6)


@pytest.mark.parametrize(
    "gear, ratio, efficiency",
    [
        ("R", -3.40252, 0.973285),
        ("1", 4.17083, 0.973285),
        ("2", 2.33973, 0.977529),
        ("3", 1.52113, 0.993148),
        ("4", 1.14279, 0.995314),
        ("5", 0.86718, 0.995504),
        ("6", 0.69106, 0.993735),
    ],
)
def test_every_gear_of_lepelletiers_train_has_its_ratio_and_efficiency(gear, ratio, efficiency):
    """Independent program, 0.98 from each sun to its ring with the carrier held: all of it at the suns' meshes."""
    lost = {"sun-planet": 0.98, "small-short": 0.98, "large-long": 0.98}
    found = FORD_6R_80.ratio(gear)
    assert found == pytest.approx(ratio, rel=1e-5)
    assert FORD_6R_80.torque_ratio(gear, lost) / found == pytest.approx(efficiency, abs=2e-5)


def test_the_ravigneaux_set_of_the_aod_has_its_closed_forms():
    """i = z_r/z_s1; (z_s1 + z_s2)/z_s1 z_r/(z_r + z_s2); 1; z_r/(z_r + z_s2); −z_r/z_s2."""
    ratios = [FORD_AOD.ratio(gear) for gear in FORD_AOD.gears]
    assert ratios == pytest.approx([72 / 30, 66 / 30 * 72 / 108, 1.0, 72 / 108, -72 / 36], rel=1e-12)


def test_the_cross_joined_sets_of_the_440_t4_have_their_closed_forms():
    """The bulletin prints its fourth gear as 0.74; its own formula z_r/(z_s + z_r) = 62/88 is 0.7045."""
    ratios = [THM_440_T4.ratio(gear) for gear in THM_440_T4.gears]
    assert ratios == pytest.approx([(62 / 26 * 42 + 42 + 74) / 74, (42 + 74) / 74, 1.0, 62 / 88], rel=1e-12)


def test_the_wolfrom_train_has_the_ratio_and_efficiencies_of_its_closed_form():
    """i = (1 + z_r1/z_s)/(1 − z_r1 z_p2/(z_p1 z_r2)) = 162; efficiencies by an independent program."""
    assert wolfrom("fast", "slow") == pytest.approx((162.0, 0.710437), rel=1e-6)
    assert wolfrom("slow", "fast") == pytest.approx((162.0, 0.598514), rel=1e-6)


SIMPSON = """\
schema = 1
name = "Simpson"
level = "concept"
shafts = [{shafts}]
turbines.engine = {{ shaft = "{engine}", power_kw = 1, speed_rpm = 100 }}
propellers.load = {{ shaft = "out", speed_rpm = 100, diameter_m = 1 }}
[epicyclics.front]
carrier = "out"
suns.sun = {{ shaft = "{sun}", teeth = {z_s} }}
rings.ring = {{ shaft = "first", teeth = {z_r} }}
planets.planet = {{ teeth = {z_p}, meshes = ["sun", "ring"] }}
[epicyclics.rear]
carrier = "{held}"
suns.sun = {{ shaft = "{sun}", teeth = {z_s} }}
rings.ring = {{ shaft = "out", teeth = {z_r} }}
planets.planet = {{ teeth = {z_p}, meshes = ["sun", "ring"] }}
"""


@pytest.mark.parametrize("z_s, z_r", [(36, 80), (46, 100)])
def test_simpsons_set_has_its_relations(z_s, z_r):
    """i_1 = 2 + 1/ρ, i_2 = 1 + 1/ρ, i_R = −ρ; two equal sets on a common sun (Chrysler A-727, Ford C6)."""
    rho = z_r / z_s
    for engine, sun, held, expected in (
        ("first", "sun", "ground", 2.0 + 1.0 / rho),
        ("first", "ground", "cage", 1.0 + 1.0 / rho),
        ("sun", "sun", "ground", -rho),
    ):
        shafts = ", ".join(f'"{name}"' for name in dict.fromkeys(("first", "out", sun, held)) if name != "ground")
        text = SIMPSON.format(shafts=shafts, engine=engine, sun=sun, held=held, z_s=z_s, z_r=z_r, z_p=(z_r - z_s) // 2)
        design = parse(text.replace('meshes = ["sun", "ring"] }', 'meshes = ["sun", "ring"] }\nsets = 2'))
        teeth = {**teeth_of(design, "front"), **teeth_of(design, "rear")}
        flow = power_flow(design, build_train(design), teeth)
        assert flow.speeds[engine] / flow.speeds["out"] == pytest.approx(expected, rel=1e-9)


def test_the_differential_and_star_in_parallel_split_the_power_without_circulation():
    """i = 1 + ρ_A + ρ_A ρ_B = 11.5 and T = 1 + ρ_A η + ρ_A ρ_B η²: 11.143, by hand."""
    design = parse("""\
schema = 1
name = "split star"
level = "concept"
shafts = ["in", "across", "out"]
turbines.engine = { shaft = "in", power_kw = 1, speed_rpm = 1150 }
propellers.load = { shaft = "out", speed_rpm = 100, diameter_m = 1 }
gears.mesh_efficiency = 0.9899494936611665
epicyclics.a = { carrier = "out", suns.s = { shaft = "in", teeth = 30 }, rings.r = { shaft = "across", teeth = 90 }, \
planets.p = { teeth = 30, meshes = ["s", "r"] } }
epicyclics.b = { carrier = "ground", sets = 2, suns.s = { shaft = "across", teeth = 40 }, \
rings.r = { shaft = "out", teeth = 100 }, planets.p = { teeth = 30, meshes = ["s", "r"] } }
""")
    teeth = {**teeth_of(design, "a"), **teeth_of(design, "b")}
    train = build_train(design)
    flow = power_flow(design, train, teeth, efficiency=design.efficiencies)
    ratio = flow.speeds["in"] / flow.speeds["out"]
    torque_ratio = -flow.machine_torques["load"] / flow.machine_torques["engine"]
    lossless = power_flow(design, train, teeth)
    through_carrier = sum(lossless.meshes[name].torques[2] for name in ("a.s-p", "a.p-r")) * lossless.speeds["out"]
    assert ratio == pytest.approx(-11.5 if ratio < 0 else 11.5, rel=1e-9)
    assert abs(torque_ratio) == pytest.approx(abs(ratio) * 0.968957, rel=1e-6)
    assert through_carrier / 1e3 == pytest.approx(0.347826, rel=1e-5)
    assert not recirculation(train, lossless)


def test_a_wolfrom_train_of_poor_meshes_needs_power_at_both_ends_to_be_turned_backwards():
    """Self-locking: by its closed form the efficiency backwards passes zero at 0.975 a mesh; forwards it has 0.4436."""
    poor = WOLFROM.replace("0.99", "0.97")
    powers = {}
    for driver, load in (("fast", "slow"), ("slow", "fast")):
        design = parse(poor.format(driver=driver, load=load))
        flow = power_flow(design, build_train(design), teeth_of(design, "wolfrom"), efficiency=design.efficiencies)
        powers[driver] = flow.machine_powers["load"]
    assert powers["fast"] == pytest.approx(-443.607, rel=1e-5)
    assert powers["slow"] > 0.0


CH_47 = """\
schema = 1
name = "CH-47, forward transmission"
level = "concept"
shafts = ["input", "first-sun", "between", "mast"]
turbines.engine = { shaft = "input", power_kw = 2500, speed_rpm = 7000 }
rotors.rotor = { shaft = "mast", speed_rpm = 228, diameter_m = 18.3 }
gears.rating = "iso6336"
pairs.bevel = { kind = "bevel", pinion = "input", wheel = "first-sun", pinion_teeth = 29, wheel_teeth = 51, \
axis_angle_deg = 90 }
[planetaries.first]
sun = "first-sun"
carrier = "between"
ring = "ground"
planets = 4
sun_teeth = 28
planet_teeth = 39
unequal_places = true
[planetaries.second]
sun = "between"
carrier = "mast"
ring = "ground"
planets = 6
sun_teeth = 40
planet_teeth = 33
unequal_places = true
"""


def test_the_forward_transmission_of_the_ch_47_has_its_printed_ratio():
    """51/29 (1 + 106/28)(1 + 106/40) = 30.7193, printed as 30.72; with square bevel axes, on which no ratio depends."""
    sizing = size(parse(CH_47))
    speeds = sizing.reference.speeds
    assert abs(speeds["input"] / speeds["mast"]) == pytest.approx(30.719335, rel=1e-7)
    assert sizing.reference.residual < 1e-12
    assert {gear.name: gear.teeth for gear in sizing.gears if gear.role == "ring"} == {
        "first.ring": 106, "second.ring": 106
    }  # fmt: skip


def test_no_set_of_the_ch_47_takes_its_planets_at_equal_places():
    """28 + 106 is no multiple of 4, and 40 + 106 none of 6."""
    messages = {problem.path: problem.message for problem in problems(CH_47.replace("unequal_places = true\n", ""))}
    assert "z_s + z_r = 28 + 106 = 134 is no multiple of 4" in messages["planetaries.first.planets"]
    assert "z_s + z_r = 40 + 106 = 146 is no multiple of 6" in messages["planetaries.second.planets"]


@pytest.mark.parametrize(
    "sun, ring, planets, even",
    [
        (27, 99, 3, True),  # OH-58A
        (62, 228, 5, True),  # UH-60A
        (21, 99, 3, True),  # NREL GRC
        (19, 56, 3, True),  # NREL 5 MW, first
        (16, 74, 3, True),  # AGMA 6123, annex C
        (28, 106, 4, False),  # CH-47, first
        (40, 106, 6, False),  # CH-47, second
    ],
)
def test_published_sets_have_equal_places_where_the_sum_of_teeth_is_a_multiple_of_the_planets(sun, ring, planets, even):
    """(z_s + z_r)/N whole; the compound set's condition, written for any planets, says the same."""
    planet = (ring - sun) // 2
    compound = CompoundSet(planets, {"s": sun, "r": -ring}, {"p": planet}, {"p": "p"}, (("s", "p"), ("p", "r")))
    assert bool(assembles(sun, ring, planets)) is even
    assert can_assemble(compound) is even


@pytest.mark.parametrize("automatic", [GM_8L_90, ZF_8HP_70, FORD_6R_80, FORD_AOD, THM_440_T4], ids=lambda a: a.name)
def test_every_gear_of_an_automatic_passes_backwards_what_its_output_drives(automatic):
    """Efficiency backwards is that of a flow in which the wheels drive and the engine takes what is left."""
    for gear in automatic.gears:
        design = automatic.design(gear)
        teeth = {name: value for stage in design.epicyclics for name, value in teeth_of(design, stage).items()}
        train = build_train(design)
        lost = {mesh.name: math.sqrt(0.98) for mesh in train.meshes}
        flow = power_flow(design, train, teeth, efficiency=lost)
        way = efficiencies(design, train, teeth, flow, lost)[""]
        assert flow.residual < 1e-12
        assert way.forwards == pytest.approx(1.0 - flow.loss / flow.machine_powers["engine"], rel=1e-12)
        engine, load = design.turbines["engine"], design.propellers["load"]
        turned = design.model_copy(
            update={
                "turbines": {"engine": engine.model_copy(update={"shaft": load.shaft})},
                "propellers": {"load": load.model_copy(update={"shaft": engine.shaft})},
            }
        )
        driven = power_flow(turned, build_train(turned), teeth, efficiency=lost)
        assert way.backwards == pytest.approx(1.0 - driven.loss / driven.machine_powers["engine"], rel=1e-12)
