"""Pieces of shafts, plates, shells and shells' rooms, each against what is reckoned by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from designs import PAIR
from gearwright.catalogue import bored_mass
from gearwright.errors import DesignError
from gearwright.identity import Kind, PartId
from gearwright.sizing import Body, Direction, Point, Station, size
from gearwright.sizing.arrangement import _moved
from gearwright.sizing.bearing_seats import Fitting
from gearwright.sizing.housing_shell import CLEARANCE, _Round
from gearwright.sizing.losses import seal_losses
from gearwright.sizing.mass import tooth_of
from gearwright.sizing.mass.bodies import cage_of
from gearwright.sizing.places import PLATE_GAP, runs
from gearwright.sizing.places.bodies import _free
from gearwright.sizing.places.frames import _coaxial
from gearwright.sizing.shafts.shafts import _stiffness
from gearwright.spec import parse
from gearwright.train.torques import _inverse, _prepared
from shipped_work import sized

near = pytest.approx
INTERNAL = PAIR + "internal = true\n"


def body(origin, direction, stations, kind=Kind.GEAR):
    return Body(PartId(kind, "a"), "a", "", Point(*origin), Direction(*direction), tuple(Station(*s) for s in stations))


def test_what_is_left_of_a_stretch_lies_beside_what_sits_on_it():
    """From 0 to 10: beside 2 to 3, 5 to 7 and what reaches over the end; nothing that is thinner than a hair."""
    assert list(_free(0.0, 10.0, [(2.0, 3.0), (5.0, 7.0), (9.0, 12.0)])) == [(0.0, 2.0), (3.0, 5.0), (7.0, 9.0)]
    assert list(_free(0.0, 10.0, [])) == [(0.0, 10.0)] and list(_free(0.0, 10.0, [(-1.0, 11.0)])) == []
    assert list(_free(0.0, 10.0, [(12.0, 13.0)])) == [(0.0, 10.0)]
    assert list(_free(0.0, 10.0, [(1.0, 6.0), (2.0, 3.0)])) == [(0.0, 1.0), (6.0, 10.0)]
    assert list(_free(0.0, 10.0, [(0.0, 10.0 - 1e-12)])) == []


@pytest.mark.parametrize("off", [(0.0, 0.01, 0.0), (0.0, 0.0, 0.01), (0.5, 0.01, 0.01), (0.5, 0.01, -0.01)])
def test_bodies_beside_each_other_share_no_axis_and_bodies_in_line_do(off):
    one = body((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), [(0.0, 0.1), (0.2, 0.1)])
    assert not _coaxial(one, body(off, (1.0, 0.0, 0.0), [(0.0, 0.1)]))
    assert _coaxial(one, body((off[0], 0.0, 0.0), (-1.0, 0.0, 0.0), [(0.0, 0.1)]))
    assert not _coaxial(one, body((0.5, 0.0, 0.0), (0.8, 0.6, 0.0), [(0.0, 0.1)]))


def test_a_shell_reaches_around_tilted_discs_as_far_as_their_rims():
    """A disc of 100 mm, 30° from the first axis: its rim reaches r sin 30° before and behind its middle."""
    tilted = (math.cos(math.radians(30.0)), math.sin(math.radians(30.0)), 0.0)
    found = _Round.of(body((0.3, 0.0, 0.0), tilted, [(0.0, 0.1), (0.04, 0.1)]))
    rim = CLEARANCE * 0.1 * 0.5
    assert (found.low, found.high) == (near(0.3 - rim), near(0.3 + 0.04 * tilted[0] + rim))
    straight = _Round.of(body((0.3, 0.0, 0.0), (1.0, 0.0, 0.0), [(0.0, 0.1), (0.04, 0.2)]))
    assert (straight.low, straight.high) == (near(0.3), near(0.34))
    assert straight.reach == near(np.full(len(straight.reach), CLEARANCE * 0.2))


@pytest.mark.parametrize(("given", "spacing", "width"), [(None, 0.02, 0.04), (0.05, 0.05, 0.07)])
def test_bearings_side_by_side_are_a_width_apart_unless_the_design_says_how_far(given, spacing, width):
    step = SimpleNamespace(runs_on=SimpleNamespace(width=0.04, side_by_side=2))
    fitting = Fitting(step, SimpleNamespace(spacing=given, side_by_side=2), "")
    assert (fitting.spacing, fitting.width) == (near(spacing), near(width))


def test_a_carrier_is_two_plates_with_hollow_pins_and_bridges_between_them():
    """By hand: 0.6 π R² of plates, π/4 d² of a pin between them, less its bore of 0.6 d through both plates.

    Bridges: the chord less d_a and 1 mm each side by d_a/2.
    """
    sizing = sized("in-line-h2")
    (carrier,) = (one for one in sizing.carriers if one.stage == "first")
    (planet,) = (gear for gear in sizing.gears if gear.name == "first.planet")
    cage = cage_of(sizing, carrier, runs(sizing)[0])
    apart = planet.face_width + 2.0 * PLATE_GAP
    assert cage.span[1] - cage.span[0] == near(apart)
    reach = carrier.radius + carrier.pin_diameter / 2.0 + carrier.eye_wall
    tip = planet.pitch_diameter + 2.0 * planet.module
    second = carrier.free_plate or sizing.design.carriers.plate_ratio * planet.face_width
    plates = sizing.design.carriers.fill * math.pi * reach**2 * (carrier.plate_thickness + second)
    pins = 3 * math.pi / 4.0 * carrier.pin_diameter**2
    whole = apart + carrier.plate_thickness + second
    assert cage.whole[1] - cage.whole[0] == near(whole)
    bores = 3 * math.pi / 4.0 * (carrier.pin_bore or 0.0) ** 2 * whole
    width = carrier.radius * math.sqrt(3.0) - tip - 2e-3
    sun, ring = (tooth_of(sizing, gear).tip_radius for gear in sizing.gears if gear.name in ("first.sun", "first.ring"))
    inner = max(carrier.radius / 2.0 - tip / 4.0, sun + 1e-3)
    outer = min(carrier.radius / 2.0 + tip / 4.0, math.sqrt((ring - 1e-3) ** 2 - width**2 / 4.0))
    assert width > 0.0 and inner == near(sun + 1e-3)
    assert cage.volume == near(plates + (pins + 3 * width * (outer - inner)) * apart - bores)


def test_bearings_of_one_series_weigh_as_the_cube_of_their_bore():
    assert bored_mass(0.08) == near(8.0 * bored_mass(0.04), rel=1e-12) and bored_mass(0.04) > 0.0


def test_every_machine_has_one_seal_on_its_shaft():
    sizing = size(parse(PAIR))
    oil = SimpleNamespace(seals="iso-tr-14179-1")
    speeds = {"fast": 600.0, "slow": 200.0}
    losses = list(seal_losses(sizing, speeds, oil))
    assert [(loss.part, loss.origin, loss.count) for loss in losses] == [
        ("seal at turbine", "seals", 1), ("seal at propeller", "seals", 1),
    ]  # fmt: skip
    assert all(loss.power > 0.0 for loss in losses)
    twice = list(seal_losses(sizing, {shaft: 2.0 * speed for shaft, speed in speeds.items()}, oil))
    assert [loss.power for loss in twice] == near([2.0 * loss.power for loss in losses])
    assert list(seal_losses(sizing, speeds, SimpleNamespace(seals="none"))) == []


def test_slopes_are_judged_where_the_bearing_has_a_limit_and_critical_speeds_where_there_is_one():
    """Shigley, table 7-2, upper values: 0.003 rad in balls, 0.0012 in cylindrical rollers; others have none."""
    kinds = {"ball": "deep-groove", "roller": "cylindrical", "thrust": "four-point"}
    design = SimpleNamespace(bearings={name: SimpleNamespace(kind=kind) for name, kind in kinds.items()})
    slopes = (("ball", 1e-4), ("roller", 2e-4), ("gear", 3e-4), ("still", 0.0), ("thrust", 1e-4))
    shaft = SimpleNamespace(name="a", slopes=slopes, critical_speed=900.0, highest_speed=300.0)
    checks = {check.place: check for check in _stiffness(shaft, design)}
    assert [checks[place].value for place in ("ball", "roller", "gear")] == [1e-4, 2e-4, 3e-4]
    assert (checks["ball"].limit, checks["roller"].limit) == (3e-3, 1.2e-3) and checks["gear"].limit <= 1.2e-3
    assert not {"still", "thrust"} & checks.keys()
    shaft.critical_speed = None
    assert {check.mode for check in _stiffness(shaft, design)} == {"slope"}


def test_the_tooth_form_of_a_ring_has_its_teeth_inwards():
    """d_f = d + 2 · 1.25 m (less what is shifted): roots outside of the pitch circle, tips inside."""
    sizing = size(parse(INTERNAL))
    ring = next(gear for gear in sizing.gears if gear.name == "stage.wheel")
    teeth = tooth_of(sizing, ring)
    pitch = ring.pitch_diameter / 2.0
    assert teeth.side == -1 and teeth.tip_radius < pitch < teeth.root_radius
    assert teeth.root_radius - teeth.tip_radius == near((1.25 + 1.0 - ring.tip_alteration) * ring.module, rel=1e-6)


def test_the_body_of_a_ring_of_a_pair_is_its_rim_about_its_roots():
    sizing = size(parse(INTERNAL))
    ring = next(gear for gear in sizing.gears if gear.name == "stage.wheel")
    (solid,) = (solid for solid in sizing.arrangement.bodies if str(solid.part) == "stage.wheel")
    assert solid.radius == near(ring.pitch_diameter / 2.0 + ring.rim)
    assert solid.bore == near(ring.pitch_diameter / 2.0 - 1.25 * ring.module)
    assert solid.length == near(ring.face_width)


@pytest.mark.parametrize("shift", [0.0, 0.02, -0.02, 0.15, -0.15])
def test_gears_that_move_along_a_shaft_take_its_ends_along_where_they_would_reach_beyond(shift):
    """Two gears of 40 mm on 300 mm: gaps of 73.3 mm; the ends stay a gap away from what moved past them."""
    places, widths = {"first": 0.0, "a": 0.1, "b": 0.2, "last": 0.3}, {"a": 0.04, "b": 0.04}
    gap = (0.3 - 0.08) / 3.0
    length, moved = _moved("shaft", places, widths, 0.3, {"a": shift, "b": shift})
    start = min(0.1 + shift - 0.02 - gap, 0.0)
    end = max(0.2 + shift + 0.02 + gap, 0.3)
    assert length == near(end - start)
    assert moved == {"first": near(0.0, abs=1e-12), "a": near(0.1 + shift - start), "b": near(0.2 + shift - start),
                     "last": near(end - start)}  # fmt: skip
    with pytest.raises(DesignError, match=r"beside its mate it stands in 'a'"):
        _moved("shaft", places, widths, 0.3, {"a": 0.07})


def test_matrices_far_from_singular_have_an_inverse_and_others_a_pseudo_inverse():
    matrix = np.array([[2.0, 1.0], [0.0, 4.0]])
    assert _inverse(matrix) == near(np.array([[0.5, -0.125], [0.0, 0.25]]))
    assert _inverse(np.ones((2, 3))) is None and _inverse(np.ones((2, 2))) is None
    assert _inverse(np.diag([1.0, 1e-300])) is None
    tall = np.array([[1.0, 0.0], [0.0, 2.0], [1.0, 0.0]])
    for system in (matrix, tall, np.array([[1.0, 1.0], [1.0, 1.0], [2.0, 2.0]])):
        scaled, scale, inverse = _prepared(system)
        assert np.linalg.norm(scaled, axis=0) == near(np.ones(2)) and scaled * scale == near(system)
        assert inverse == near(np.linalg.pinv(scaled), abs=1e-12)
