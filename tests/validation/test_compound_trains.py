"""Compound trains against published and independently computed numbers: ratios, torque ratios, efficiencies."""

import math

import pytest

from gearwright.spec import parse
from gearwright.train import build_train, power_flow, recirculation, teeth_of
from gearwright.validate.automatics import FORD_6R_80, FORD_AOD, GM_8L_90, THM_440_T4
from gearwright.validate.compound_trains import WOLFROM, wolfrom

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
