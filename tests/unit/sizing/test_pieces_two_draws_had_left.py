"""Pieces that faults of two draws had passed: solids' directions, walls and bosses, gears at rest, cases, senses."""

import cmath
import importlib
import math
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from designs import HYBRID, ONE_SET, PAIR
from gearwright.catalogue import STEEL_DENSITY, STEEL_SHARE, housing_materials
from gearwright.dynamics.assembly.meshes import _first_body
from gearwright.dynamics.model.elements import Carried
from gearwright.errors import DesignError, Problem
from gearwright.parts.bearings import BearingKind
from gearwright.sizing import TeethSearch, size
from gearwright.sizing.housing_shell import shell_around
from gearwright.sizing.losses import gear_losses
from gearwright.sizing.mass import Wall, wall_of
from gearwright.sizing.mass.complete import _boss
from gearwright.sizing.places.frames import Solid, _likely, _sphere
from gearwright.spec import parse
from gearwright.train.torques import _halves

near = pytest.approx


def test_directions_over_a_sphere_have_unit_length_and_fill_it_evenly():
    """Heights in steps of 2/N, each turned by the golden angle from the one below; their sum is as good as nothing."""
    ways = _sphere()
    count = len(ways)
    assert np.linalg.norm(ways, axis=1) == near(np.ones(count), rel=1e-12)
    assert np.diff(ways[:, 0]) == near(np.full(count - 1, -2.0 / count), rel=1e-9)
    assert ways[0, 0] == near(1.0 - 1.0 / count) and abs(ways[:, 0].sum()) < 1e-9
    turned = np.angle((ways[1:, 1] + 1j * ways[1:, 2]) / (ways[:-1, 1] + 1j * ways[:-1, 2]))
    assert np.exp(1j * turned) == near(np.full(count - 1, cmath.exp(1j * math.pi * (3.0 - math.sqrt(5.0)))), abs=1e-9)
    assert np.abs(ways.sum(axis=0)).max() < 0.02 * count


def test_directions_that_two_bodies_suggest_are_square_to_each_axis_towards_the_other():
    """Of what leads from one middle to the other the part square to an axis: a right angle with it."""
    axes = [np.array([1.0, 0.0, 0.0]), np.array([0.6, 0.8, 0.0])]
    middles = [np.zeros(3), np.array([0.3, 0.1, 0.5])]
    one, other = (
        Solid(axis, np.array([middle - 0.1 * axis, middle + 0.1 * axis]), np.array([0.05, 0.05]), 0.0)
        for axis, middle in zip(axes, middles, strict=True)
    )
    ways = _likely(one, other)
    assert np.linalg.norm(ways, axis=1) == near(np.ones(len(ways)), rel=1e-12)
    between = middles[1] - middles[0]
    for axis in axes:
        flat = between - float(between @ axis) * axis
        wanted = flat / np.linalg.norm(flat)
        assert abs(wanted @ axis) < 1e-12
        assert np.abs(ways - wanted).max(axis=1).min() < 1e-12 and np.abs(ways + wanted).max(axis=1).min() < 1e-12
    square = np.cross(*axes) / np.linalg.norm(np.cross(*axes))
    for wanted in (between / np.linalg.norm(between), square, *axes, *np.eye(3)):
        assert np.abs(ways - wanted).max(axis=1).min() < 1e-12


@pytest.mark.parametrize(("axis", "across"), [("x", (1, 2)), ("y", (2, 0)), ("z", (0, 1))])
def test_the_axes_across_a_shaft_follow_its_own_in_the_order_x_y_z(axis, across):
    assert Carried("gear", "shaft", 0.1, None, None, None, axis).across == across


def test_a_piece_is_halved_at_the_open_unknown_that_the_others_feel_most():
    """Columns sum to 0.3, 0.6 and 0.9; the third is fixed already."""
    fixed, shift = np.array([0.0, 0.0, 1.0]), np.array([[0.1, 0.2, 0.3], [0.1, 0.2, 0.3], [0.1, 0.2, 0.3]])
    low, high = _halves(fixed, shift)
    assert low.tolist() == [0.0, -1.0, 1.0] and high.tolist() == [0.0, 1.0, 1.0]
    assert fixed.tolist() == [0.0, 0.0, 1.0]
    assert [piece.tolist() for piece in _halves(np.array([0.0, -1.0, 1.0]), shift)] == [[-1, -1, 1], [1, -1, 1]]
    assert _halves(np.array([1.0, -1.0, 1.0]), shift) == [] and _halves(np.zeros(3), np.zeros((3, 3))) == []


def test_the_boss_of_a_bearing_is_as_large_as_a_light_bearing_of_its_mass():
    """Of a bearing of D = 100 mm, d = D/1.6 and B = 0.2 D, of which steel fills its share."""
    outside, cast = 0.1, housing_materials()["aluminium"]
    steel = STEEL_SHARE[BearingKind.CYLINDRICAL] * STEEL_DENSITY
    mass = steel * math.pi / 4.0 * (outside**2 - (outside / 1.6) ** 2) * 0.2 * outside
    one = SimpleNamespace(each=mass, count=1)
    wall = math.pi / 4.0 * ((1.24 * outside) ** 2 - outside**2) * 0.25 * outside * cast.density
    assert _boss(one, cast) == near(wall, rel=1e-12)
    assert _boss(SimpleNamespace(each=mass, count=6), cast) == near(6.0 * wall, rel=1e-12)
    assert _boss(SimpleNamespace(each=8.0 * mass, count=1), cast) == near(8.0 * wall, rel=1e-12)


def test_a_given_wall_is_taken_from_the_design_and_thickens_what_torque_asks():
    sizing = size(parse(PAIR + '[housing]\nmaterial = "aluminium"\n'))
    asked = wall_of(sizing, shell_around(sizing.arrangement.bodies))
    assert asked.thickness > 0.0 and asked.why in ("casting", "its torque")
    given = size(parse(PAIR + '[housing]\nmaterial = "aluminium"\nwall_mm = 9\n'))
    assert wall_of(given, shell_around(given.arrangement.bodies)) == Wall(near(9e-3), "the design")


def test_gears_that_stand_lose_nothing_and_none_churns_that_does_not_dip():
    """A ring on the ground has no speed among those of shafts; mist about a gear at rest takes no power."""
    sizing = size(parse(HYBRID))
    oil = SimpleNamespace(dip={}, windage="anderson-loewenthal", viscosity=20e-6, density=900.0, lubricant_factor=1.0)
    speeds = dict.fromkeys(sizing.design.shafts, 500.0)
    losses = {loss.part: loss for loss in gear_losses(sizing, speeds, oil)}
    assert losses["first.ring"].power == 0.0 == losses["second.ring"].power
    assert losses["first.sun"].power > 0.0 and {loss.origin for loss in losses.values()} == {"windage"}
    assert all(loss.power == 0.0 for loss in gear_losses(sizing, {}, oil))


def test_a_shaft_is_known_by_the_first_gear_on_it_or_the_carrier_that_it_turns():
    sizing = size(parse(HYBRID))
    named = {shaft: _first_body(sizing, shaft) for shaft in (*sizing.design.shafts, "nowhere")}
    assert named == {"input": "first.sun", "middle": "first.carrier", "output": "second.carrier", "nowhere": ""}


@pytest.mark.parametrize("planets", [2, 3, 4])
def test_tips_of_neighbours_are_apart_by_the_chord_of_the_planet_circle(planets):
    """2 a sin(π/N) with a = m (z_s + z_p)/2 = 112.5 mm, against both tip radii, m (z_p + 2) = 141 mm."""
    text = ONE_SET.format(speed=1200) + (
        'sun = "fast"\nring = "ground"\ncarrier = "slow"\nsun_teeth = 28\nplanet_teeth = 44\nring_teeth = 116\n'
        f"module_mm = 3\nface_width_mm = 40\nplanets = {planets}\n"
    )
    sizing = size(parse(text))
    check = next(check for check in sizing.checks if check.mode == "planets apart")
    assert check.value == near(2.0 * 0.108 * math.sin(math.pi / planets), rel=1e-12)
    assert check.limit == near(3e-3 * 46, rel=1e-6)


def test_one_planet_has_no_neighbour():
    text = ONE_SET.format(speed=1200) + (
        'sun = "fast"\nring = "ground"\ncarrier = "slow"\nsun_teeth = 28\nplanet_teeth = 44\nring_teeth = 116\n'
        "module_mm = 3\nface_width_mm = 40\nplanets = 1\n"
    )
    assert not [check for check in size(parse(text)).checks if check.mode == "planets apart"]


def test_strength_is_judged_of_both_gears_of_every_mesh_and_width_of_the_first():
    sizing = size(parse(HYBRID + '[gears]\nmaterial = "18CrNiMo7-6"\nrating = "iso6336"\n'))
    judged = {str(check.part) for check in sizing.checks if check.symbol == "S_F"}
    assert judged == {gear for mesh in sizing.meshes for gear in mesh.gears}
    widths = {str(check.part) for check in sizing.checks if check.mode == "face width"}
    assert widths == {"first.sun", "second.sun"}


@dataclass(frozen=True)
class Weighed:
    """What of a sizing the choice among several reads."""

    mass: float
    fails: int
    search: TeethSearch


def test_the_lightest_of_several_sizings_that_pass_is_taken_and_the_next_is_told(monkeypatch):
    """Complete masses 5, 3 and 4 that pass, 1 that does not, and one that cannot be sized: 3, then 4."""
    search, module = size(parse(PAIR)).search, importlib.import_module("gearwright.sizing.size")
    outcomes = [(5.0, 0), (3.0, 0), (1.0, 1), None, (4.0, 0)]

    def geared(design, train, choice, **_):
        if choice is None:
            raise DesignError([Problem("teeth", "none")])
        return choice

    monkeypatch.setattr(module, "choose_teeth", lambda *_: iter(outcomes))
    monkeypatch.setattr(module, "geared", geared)
    monkeypatch.setattr(module.Fitted, "of", staticmethod(lambda choice, _: choice))
    monkeypatch.setattr(module, "completed", lambda choice, given, **_: Weighed(*choice, search))
    lacking = SimpleNamespace(margin=0.5)
    monkeypatch.setattr(module, "_failing", lambda sizing: sizing.fails)
    monkeypatch.setattr(module._Looked, "failing", lambda _, sizing: [lacking] * sizing.fails)
    monkeypatch.setattr(module, "complete_mass", lambda sizing: SimpleNamespace(total=sizing.mass))
    taken = size(parse(PAIR))
    assert taken.mass == 3.0 and taken.search.next_sized_mass == 4.0
    assert (taken.search.sized, taken.search.failing, taken.search.refused) == (4, 1, 1)
    outcomes[:] = [(5.0, 1), (3.0, 1), (2.0, 2)]
    assert size(parse(PAIR)).mass == 3.0 and size(parse(PAIR)).search.next_sized_mass == 5.0
