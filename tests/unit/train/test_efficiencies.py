"""How sets and trains pass power, driven from either side, against closed forms; self-locking by name."""

import pytest

from gearwright.errors import SolveError
from gearwright.spec import parse
from gearwright.train import build_train, efficiencies, power_flow, teeth_of
from gearwright.validate.trains import WOLFROM

RINGS = """\
schema = 1
name = "two rings and a stepped planet, the carrier drives"
level = "concept"
shafts = ["cage", "slow"]
turbines.driver = {{ shaft = "{driver}", power_kw = 1, speed_rpm = 100 }}
propellers.load = {{ shaft = "{load}", speed_rpm = 100, diameter_m = 1 }}
gears.mesh_efficiency = {mesh}
[epicyclics.rings]
carrier = "cage"
sets = 1
rings.held = {{ shaft = "ground", teeth = {first} }}
rings.turned = {{ shaft = "slow", teeth = {second} }}
planets.wide = {{ teeth = 30, meshes = ["held"] }}
planets.narrow = {{ teeth = {narrow}, meshes = ["turned"], in_one_piece_with = "wide" }}
"""


def flow_of(text, name, case="rated"):
    """Return the flow of a case and how its stages pass power."""
    design = parse(text)
    train, teeth = build_train(design), teeth_of(design, name)
    flow = power_flow(design, train, teeth, case, efficiency=design.efficiencies)
    assert flow.residual < 1e-12
    return flow, efficiencies(design, train, teeth, flow, design.efficiencies)


@pytest.mark.parametrize("driver, load", [("fast", "slow"), ("slow", "fast")])
def test_a_wolfrom_train_has_both_efficiencies_in_one_case(driver, load):
    """0.710437 and 0.598514 at 0.99 a mesh, by an independent program (Müller's tooth power in the carrier)."""
    _, ways = flow_of(WOLFROM.format(driver=driver, load=load), "wolfrom")
    for way in ways.values():
        both = {way.driving: way.forwards, way.driven: way.backwards}
        assert both == pytest.approx({("fast",): 0.710437, ("slow",): 0.598514}, rel=1e-6)
        assert way.locked == () and way.locking == ""


@pytest.mark.parametrize("mesh", [0.999, 0.99, 0.98, 0.97, 0.95])
@pytest.mark.parametrize("first, narrow", [(90, 27), (80, 35), (100, 25)])
def test_a_set_is_self_locking_by_muellers_condition(mesh, first, narrow):
    """With i_0 = n_1/n_2 relative to the carrier and η_0 = η² it locks where η_0 is below i_0, or below 1/i_0.

    Above one η_c2 = (i_0 − 1)/(i_0 − η_0) and η_2c = (i_0 η_0 − 1)/(η_0 (i_0 − 1)); below one η_c2 = η_0 (1 − i_0)/
    (1 − i_0 η_0) and η_2c = (η_0 − i_0)/(1 − i_0): T_2 = −i_0 η_0^±1 T_1. Müller 1998, Die Umlaufgetriebe, section 20.
    """
    second = first - 30 + narrow
    fixed = 30.0 * second / (first * narrow)
    lost = mesh**2
    if fixed > 1.0:
        carrier_drives, ring_drives = (fixed - 1.0) / (fixed - lost), (fixed * lost - 1.0) / (lost * (fixed - 1.0))
    else:
        carrier_drives, ring_drives = lost * (1.0 - fixed) / (1.0 - fixed * lost), (lost - fixed) / (1.0 - fixed)
    _, ways = flow_of(
        RINGS.format(driver="cage", load="slow", mesh=mesh, first=first, second=second, narrow=narrow), "rings"
    )
    way = ways["rings"]
    assert way.forwards == pytest.approx(carrier_drives, rel=1e-9)
    assert way.backwards == pytest.approx(ring_drives, rel=1e-9, abs=1e-12)
    locks = lost <= min(fixed, 1.0 / fixed)
    assert way.locked == (("slow",) if locks else ())
    assert way.locking == ("slow cannot drive it, only cage can" if locks else "")


def test_a_load_that_a_self_locking_train_cannot_move_is_refused_by_name():
    """The fast shaft is to take 1 kW that the slow one would have to drive through teeth that lose all of it."""
    text = WOLFROM.replace("0.99", "0.97").format(driver="slow", load="fast")
    text += "[cases.lifting]\ndriver = { balances = true, speed_rpm = 100 }\nload = { power_kw = -1 }\n"
    with pytest.raises(SolveError, match="wolfrom is self-locking: slow cannot drive it, only fast can"):
        flow_of(text, "wolfrom", "lifting")


def test_of_two_states_of_a_self_locking_train_the_one_is_meant_in_which_the_load_takes():
    """With 1 kW at the fast shaft the load may take 0.44 kW, or come down with 4.78 kW that the teeth lose too."""
    flow, ways = flow_of(WOLFROM.replace("0.99", "0.97").format(driver="fast", load="slow"), "wolfrom")
    assert flow.machine_powers["load"] == pytest.approx(-443.607, rel=1e-5)
    assert ways["wolfrom"].backwards == pytest.approx(-0.209135, rel=1e-5)
    assert ways[""].locking == "slow cannot drive it, only fast can"


def test_a_set_that_turns_as_a_block_loses_nothing_and_its_torques_are_those_without_losses():
    """Sun and carrier drive with one speed: no tooth rolls, so that the ring's torque is z_r/z_s of the sun's."""
    text = """\
schema = 1
name = "block"
level = "concept"
shafts = ["in", "out"]
turbines.engine = { shaft = "in", power_kw = 1, speed_rpm = 100 }
propellers.load = { shaft = "out", speed_rpm = 100, diameter_m = 1 }
gears.mesh_efficiency = 0.9
[planetaries.block]
sun = "in"
carrier = "in"
ring = "out"
planets = 3
sun_teeth = 30
planet_teeth = 30
"""
    design = parse(text.replace('carrier = "in"', 'carrier = "cage"').replace('["in", "out"]', '["in", "cage", "out"]')
                   + '[clutches.direct]\ndriving = "in"\ndriven = "cage"\nkind = "engaged"\n')  # fmt: skip
    train, teeth = build_train(design), {"block.sun": 30, "block.planet": 30, "block.ring": 90}
    flow = power_flow(design, train, teeth, efficiency=design.efficiencies)
    on_sun, on_ring = flow.meshes["block.sun-planet"].torques[0], flow.meshes["block.planet-ring"].torques[1]
    assert on_ring / on_sun == pytest.approx(3.0, rel=1e-12)
    assert flow.loss == pytest.approx(0.0, abs=1e-9)
    ways = efficiencies(design, train, teeth, flow, design.efficiencies)
    assert [way.forwards for way in ways.values()] == pytest.approx([1.0, 1.0], rel=1e-12)


LAYSHAFTS = """\
schema = 1
name = "a load beside one of two layshafts, and layshafts behind it"
level = "concept"
shafts = ["in", "first", "left", "right", "out", "beside", "behind", "left-behind", "right-behind"]
turbines.engine = { shaft = "in", power_kw = 1, speed_rpm = 3000 }
motors.taken = { shaft = "beside", power_kw = 1000, speed_rpm = 1000, balances = false }
propellers.propeller = { shaft = "right-behind", speed_rpm = 1000, diameter_m = 2 }
gears.mesh_efficiency = 0.984375
pairs.a = { pinion = "first", wheel = ["left", "right"] }
pairs.b = { pinion = ["left", "right"], wheel = "out" }
pairs.c = { pinion = "left", wheel = "beside" }
pairs.d = { pinion = "left", wheel = ["left-behind", "right-behind"] }
pairs.e = { pinion = ["left-behind", "right-behind"], wheel = "behind" }
pairs.f = { pinion = "in", wheel = "first" }
[cases.case]
engine = { power_kw = 0.001 }
taken = { power_kw = -615 }
propeller = { balances = true, speed_rpm = 300 }
"""


@pytest.mark.parametrize("engine", ["0.001", "1", "10", "100"])
def test_layshafts_of_unequal_loads_have_one_state(engine):
    """Equal shares cannot be had in all pairs; rounds of senses went in a circle, and the train was said to lock."""
    design = parse(LAYSHAFTS.replace("power_kw = 0.001", f"power_kw = {engine}"))
    sizes = {"a": (31, 49), "b": (49, 80), "c": (51, 113), "d": (43, 47), "e": (47, 90), "f": (36, 75)}
    teeth = {
        f"{pair}.{gear}": z for pair, ends in sizes.items() for gear, z in zip(("pinion", "wheel"), ends, strict=True)
    }
    flow = power_flow(design, build_train(design), teeth, "case", efficiency=design.efficiencies)
    assert flow.residual < 1e-12
    assert all(mesh.loss >= -1e-9 for mesh in flow.meshes.values())
