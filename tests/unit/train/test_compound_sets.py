"""Compound sets: a simple one written as such gives the same numbers; what cannot be put in is refused."""

import pytest
from hypothesis import given, settings, strategies as st

from designs import problems
from gearwright.parts.planetary import CompoundSet, assembles, can_assemble
from gearwright.spec import parse
from gearwright.train import build_train, power_flow

HEAD = """\
schema = 1
name = "one set"
level = "concept"
shafts = ["sun", "out"]
turbines.engine = {{ shaft = "sun", power_kw = 50, speed_rpm = 3000 }}
propellers.load = {{ shaft = "out", speed_rpm = 700, diameter_m = 2 }}
gears.mesh_efficiency = 0.98
"""
COMPOUND = """\
[epicyclics.set]
carrier = "{carrier}"
sets = 1
suns.sun = {{ shaft = "sun", teeth = {sun} }}
rings.ring = {{ shaft = "{ring}", teeth = {large} }}
planets.planet = {{ teeth = {planet}, meshes = ["sun", "ring"] }}
"""
SIMPLE = """\
[planetaries.set]
sun = "sun"
ring = "{ring}"
carrier = "{carrier}"
planets = 1
sun_teeth = {sun}
planet_teeth = {planet}
"""


@settings(deadline=None, max_examples=25)
@given(sun=st.integers(13, 60), planet=st.integers(13, 60), star=st.booleans())
def test_a_simple_set_written_as_a_compound_one_gives_the_same_numbers(sun, planet, star):
    """Willis's equation, twice; torques of every mesh add up to nothing, and the power closes, to rounding."""
    ends = {"ring": "out", "carrier": "ground"} if star else {"ring": "ground", "carrier": "out"}
    teeth = {"set.sun": sun, "set.planet": planet, "set.ring": sun + 2 * planet}
    flows = []
    for text in (SIMPLE, COMPOUND):
        design = parse((HEAD + text).format(sun=sun, planet=planet, large=sun + 2 * planet, **ends))
        flows.append(power_flow(design, build_train(design), teeth, efficiency=design.efficiencies))
    simple, compound = flows
    assert compound.speeds["out"] == pytest.approx(simple.speeds["out"], rel=1e-12)
    assert compound.machine_torques == pytest.approx(simple.machine_torques, rel=1e-12)
    for name, mesh in simple.meshes.items():
        assert compound.meshes[name].torques == pytest.approx(mesh.torques, rel=1e-9, abs=1e-9)
        assert sum(compound.meshes[name].torques) == pytest.approx(0.0, abs=1e-9 * max(map(abs, mesh.torques)))
    assert compound.residual < 1e-12


@given(sun=st.integers(12, 90), planet=st.integers(12, 90), sets=st.integers(1, 8))
def test_a_compound_set_of_one_planet_is_assembled_where_the_simple_one_is(sun, planet, sets):
    """(z_s + z_r)/N whole; VDI 2157."""
    ring = sun + 2 * planet
    compound = CompoundSet(sets, {"s": sun, "r": -ring}, {"p": planet}, {"p": "p"}, (("s", "p"), ("p", "r")))
    assert can_assemble(compound) == bool(assembles(sun, ring, sets))


@pytest.mark.parametrize(
    "old, new, words",
    [
        ("sets = 1", "sets = 4", "cannot be assembled"),
        ('meshes = ["sun", "ring"]', 'meshes = ["sun"]', "no planet meshes with it"),
        ('meshes = ["sun", "ring"]', 'meshes = ["sun", "rim"]', "there is no other gear 'rim'"),
        ('shaft = "ground"', 'shaft = "out"', "is the carrier already"),
        ("teeth = 54", "teeth = 64", "different distances from the axis"),
        (
            'meshes = ["sun", "ring"] }',
            'meshes = ["sun", "ring", "idler"] }\nplanets.idler = { teeth = 18, meshes = ["sun"] }',
            "closes a circle of meshes",
        ),
    ],
)
def test_what_cannot_be_put_in_is_refused_with_its_reason(old, new, words):
    """The set is 20 - 17 - 54: 74 is no multiple of 4."""
    text = (HEAD + COMPOUND).format(sun=20, planet=17, large=54, ring="ground", carrier="out")
    assert old in text
    assert any(words in problem.message for problem in problems(text.replace(old, new)))


def test_the_nearest_teeth_that_can_be_assembled_are_named():
    """A Ravigneaux set of 35, 42, 84 and three sets: a small sun of 36 is the next that fits."""
    text = (
        HEAD.format()
        + """\
[epicyclics.set]
carrier = "ground"
suns.small = { shaft = "sun", teeth = 35 }
suns.large = { shaft = "ground", teeth = 42 }
rings.ring = { shaft = "out", teeth = 84 }
planets.short = { teeth = 21, meshes = ["small", "long"] }
planets.long = { teeth = 21, meshes = ["large", "ring"] }
"""
    )
    text = text.replace('suns.large = { shaft = "ground"', 'suns.large = { shaft = "idle"')
    text = text.replace('["sun", "out"]', '["sun", "out", "idle"]')
    assert any("give small 36 teeth" in problem.message for problem in problems(text))
