"""Which flank of a tooth is loaded where rings take part, whose curve a gear has, and what asks for no time."""

import math
from types import SimpleNamespace

import pytest

from designs import PAIR
from gearwright.identity import Role
from gearwright.parts.agma2001 import (
    BENDING_CARBURISED,
    BENDING_HB250,
    PITTING,
    PITTING_NITRIDED,
    AgmaMaking,
    AgmaSteel,
    AgmaWheel,
    Hardnesses,
    agma_strength,
)
from gearwright.parts.gears import CylindricalGear, GearPair
from gearwright.parts.iso6336 import FASTEST, mesh_geometry
from gearwright.sizing import size
from gearwright.sizing.rating.context import bends_both_ways
from gearwright.spec import parse
from gearwright.train import EXTERNAL, INTERNAL


@pytest.mark.parametrize(
    ("first", "second", "loads", "both"),
    [
        # T_2 = −sign … T_1: an external mate turns the torque's sense on the flank, a ring does not.
        (EXTERNAL, EXTERNAL, (5.0, -5.0), True), (EXTERNAL, EXTERNAL, (5.0, 5.0), False),
        (INTERNAL, EXTERNAL, (5.0, -5.0), False), (INTERNAL, EXTERNAL, (5.0, 5.0), True),
    ],
)  # fmt: skip
def test_a_gear_between_a_ring_and_a_wheel_bends_both_ways_by_the_signs_of_its_meshes(first, second, loads, both):
    """Second gear of one mesh, first of the other: what it gets over z_1 of the first is −sign times that torque."""
    meshes = [
        SimpleNamespace(name="a", gears=("one", "middle"), sign=first),
        SimpleNamespace(name="b", gears=("middle", "last"), sign=second),
    ]
    train = SimpleNamespace(meshes=meshes, gear=lambda name: SimpleNamespace(role=Role.WHEEL))
    found = bends_both_ways(train, "middle", {"a": [loads[0]], "b": [loads[1]]})  # type: ignore[arg-type]
    assert found is both


def test_each_gear_of_agma_2001_has_the_curves_of_its_own_steel():
    strengths = [agma_strength(steel, 1, 300.0) for steel in (AgmaSteel.CARBURISED, AgmaSteel.THROUGH_HARDENED)]
    wheel = AgmaWheel(strengths[1], BENDING_HB250, PITTING_NITRIDED, Hardnesses(600.0, 300.0))
    making = AgmaMaking(strengths[0], BENDING_CARBURISED, PITTING, 206e9, 0.3, wheel=wheel)
    assert making.curves_of(0) == (PITTING, BENDING_CARBURISED)
    assert making.curves_of(1) == (PITTING_NITRIDED, BENDING_HB250)
    assert (making.strength_of(0), making.strength_of(1)) == tuple(strengths)
    alone = AgmaMaking(strengths[0], BENDING_CARBURISED, PITTING, 206e9, 0.3)
    assert alone.curves_of(1) == (PITTING, BENDING_CARBURISED)
    assert alone.strength_of(1) == strengths[0]


def test_tips_of_a_ring_may_reach_the_tangent_point_and_no_further():
    """r_a2 = √(r_b2² + (a sin α)²): a ring of 60 teeth of 2 mm about 20, a = 40 mm."""
    sine, cosine = math.sin(math.radians(20.0)), math.cos(math.radians(20.0))
    pinion = CylindricalGear(20, 2e-3, 20e-3)
    for part, refused in ((0.0, False), (1e-9, False), (-1e-9, True)):
        tip = math.hypot(60e-3 * cosine, 40e-3 * sine) + part
        ring = CylindricalGear(-60, 2e-3, 20e-3)
        ring = CylindricalGear(-60, 2e-3, 20e-3, tip_alteration=(ring.tip_radius - tip) / 2e-3)
        assert ring.tip_radius == pytest.approx(tip, rel=1e-12)
        if refused:
            with pytest.raises(Exception, match=r"driven.tip_radius"):
                mesh_geometry(GearPair(pinion, ring))
        else:
            mesh_geometry(GearPair(pinion, ring))


def test_method_c_is_meant_up_to_three_metres_a_second():
    """ISO 6336-1:2006, clause 6: v z_1/100 √(u²/(1 + u²)) < 3 m/s."""
    assert FASTEST == 3.0


def test_a_level_of_no_time_takes_no_life():
    """A spectrum whose first level lasts for nothing rates as the spectrum without it."""
    text = PAIR + "pinion_teeth = 24\nwheel_teeth = 71\nmodule_mm = 3\nface_width_mm = 30\n"
    text += '[gears]\nrating = "iso6336"\n'
    spectrum = '[service]\nspectrum = "own"\n[spectra.own]\nload = {}\nshare = {}\n'
    (none,) = size(parse(text + spectrum.format("[1.0, 0.9, 0.8]", "[0.0, 0.4, 0.6]"))).meshes
    (alone,) = size(parse(text + spectrum.format("[0.9, 0.8]", "[0.4, 0.6]"))).meshes
    assert none.rating.pitting == pytest.approx(alone.rating.pitting, rel=1e-12)
    assert none.rating.bending == pytest.approx(alone.rating.bending, rel=1e-12)
