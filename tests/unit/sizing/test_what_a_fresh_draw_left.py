"""Pieces that a draw of faults showed to be thinly tested, each against a calculation by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from designs import ONE_SET
from gearwright.catalogue import bearing
from gearwright.identity import Kind, PartId
from gearwright.parts.gears import CylindricalGear, GearPair
from gearwright.parts.gears.gear_pair import passing_tip, tip_halves
from gearwright.parts.gears.tooth_form import TransverseTooth, _cut_by_shaper
from gearwright.sizing import size, size_many
from gearwright.sizing.places.frames import _meet
from gearwright.sizing.result import Body, Station
from gearwright.sizing.shafts import holders_of
from gearwright.sizing.shafts.ends import _is_integral
from gearwright.sizing.teeth import search
from gearwright.sizing.teeth.candidates import Front
from gearwright.spec import edited, parse, read
from shipped_work import sized

HELICAL = """
schema = 1
name = "a helical pair with shifts"
level = "concept"
shafts = ["fast", "slow"]
[motors.drive]
shaft = "fast"
power_kw = 200
speed_rpm = 6000
[propellers.load]
shaft = "slow"
speed_rpm = 2000
diameter_m = 2
[pairs.only]
pinion = "fast"
wheel = "slow"
pinion_teeth = 20
wheel_teeth = 60
module_mm = 4
pinion_shift = 0.4
wheel_shift = -0.4
[gears]
helix_angle_deg = 20
"""


def test_a_tip_is_as_thick_in_the_normal_section_as_on_its_circle_times_the_cosine_of_the_helix():
    """DIN 3960: s_at = d_a (π/(2 z) + 2 x tan α_n/z + inv α_t − inv α_at), s_an ≈ s_at cos β."""
    helix, teeth, shift = math.radians(20.0), 20, 0.4
    transverse = math.atan(math.tan(math.radians(20.0)) / math.cos(helix))
    pitch = teeth / math.cos(helix)
    tip = pitch + 2.0 * (1.0 + shift)
    at_tip = math.acos(pitch * math.cos(transverse) / tip)
    half = (math.pi / 2.0 + 2.0 * shift * math.tan(math.radians(20.0))) / teeth
    thick = tip * (half + math.tan(transverse) - transverse - math.tan(at_tip) + at_tip)
    check = next(check for check in size(parse(HELICAL)).checks if check.mode == "tip thickness")
    assert check.value == pytest.approx(thick * math.cos(helix), rel=1e-9)


@pytest.mark.parametrize(("j", "passes"), [(0, True), (2, True), (3, False), (5, False)])
def test_a_tip_that_stays_within_the_tip_circle_of_its_ring_passes_nothing(j, passes):
    """z 20/−60, m 2: r_a 22 and 58, a 40. Beyond it stands while 40 + 22 cos φ > √(58² − 22² sin² φ): cos φ > 0.725."""
    pair = GearPair(CylindricalGear(20, 2e-3, 0.02), CylindricalGear(-60, 2e-3, 0.02))
    halves = tip_halves(pair)
    angle = 2.0 * math.pi * j / 20 + halves[0]
    assert (math.cos(angle) > (58.0**2 - 40.0**2 - 22.0**2) / (2.0 * 40.0 * 22.0)) is passes
    assert bool(passing_tip(pair, j, halves).reaches) is passes


@pytest.mark.parametrize("along", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.6, 0.0, -0.8)])
@pytest.mark.parametrize(
    ("ahead", "meets"), [(0.0, True), (0.039, True), (0.041, False), (-0.019, True), (-0.021, False)]
)
def test_rods_on_one_axis_meet_where_their_lengths_overlap_whichever_way_it_points(along, ahead, meets):
    """40 mm long the first, 20 mm the second."""

    def rod(name, start, length):
        origin = tuple(0.3 + start * part for part in along)
        stations = (Station(0.0, 0.03), Station(length, 0.03))
        return Body(PartId(Kind.SHAFT, name), name, "", origin, along, stations)

    assert _meet(rod("a", 0.0, 0.04), rod("b", ahead, 0.02)) is meets


def test_covers_lie_on_the_face_of_the_bearing_that_they_hold_and_press_what_it_presses():
    sizing = sized("ec120b")
    bearings = {bearing.name: bearing for bearing in sizing.bearings}
    covers = [holder for holder in holders_of(sizing) if holder.kind == "cover"]
    assert covers
    for holder in covers:
        bearing = bearings[holder.beside]
        faces = {bearing.position + way * bearing.width / 2.0 for way in (-1, 1)}
        apart = min(abs(end - face) for end in (holder.start, holder.end) for face in faces)
        assert min(apart, abs(apart - 1e-3)) < 1e-12  # a millimetre where the outer ring slides
    others = [holder for holder in holders_of(sizing) if holder.kind not in ("cover", "end plate")]
    assert all((holder.force, holder.capacity) == (0.0, 0.0) for holder in others)


def test_a_gear_is_integral_by_its_own_joint_whatever_joins_the_others():
    """Of two gears on shafts one is cut into its shaft and one is keyed; a bearing's ring has no teeth."""
    joints = [SimpleNamespace(part="a", kind="integral"), SimpleNamespace(part="b", kind="key")]
    sizing = SimpleNamespace(joints=joints, gears=[SimpleNamespace(name="a"), SimpleNamespace(name="b")])
    assert [_is_integral(sizing, seat) for seat in ("a", "b", "c")] == [True, False, False]
    assert not _is_integral(SimpleNamespace(joints=joints, gears=[]), "a")


def test_the_fillet_of_a_ring_whose_tips_lie_within_its_base_circle_ends_at_the_base_circle():
    """No involute lies within r_b: z 26, x 0.8, m 1 mm; tips at 13 − 1.8 mm, r_b = 13 cos 20° = 12.2 mm."""
    ring = TransverseTooth(26, 1e-3, profile_shift=0.8, side=-1, shaper=20)
    assert ring.tip_radius < ring.base_radius
    radius, half = _cut_by_shaper(ring)
    assert radius.max() == pytest.approx(ring.root_radius, rel=1e-9)
    assert np.all(radius > ring.base_radius) and np.all(np.isfinite(half))
    assert half[-1] == pytest.approx(float(ring.half_angles(radius[-1:])[0]), abs=2e-3)


def test_rows_of_whose_teeth_some_miss_the_speeds_are_still_searched_together():
    """Within 0.3 % some teeth give the motor its speed and others do not; the few rows of each are not left alone."""
    design = edited(read("in-line-h2"), {"teeth.speed_tolerance": 0.003})
    sizings = size_many(design, {"gears.contact_safety": np.linspace(1.3, 1.5, 60)})
    assert np.all(sizings.together)
    flows = sizings.at(0).flows.values()
    assert all(abs(flow.speeds["intermediate"] / (4500.0 * math.pi / 30.0) - 1.0) <= 0.003 for flow in flows)


def test_of_too_many_choices_those_stay_from_which_the_lightest_trains_may_come(monkeypatch):
    """3, 2 and 1 kg so far, and 0, 0.5 and 5 kg at the least to come: of two, the third cannot be."""
    front = Front(
        {}, {"slow": np.ones(3)}, {"gears": np.array([3.0, 2.0, 1.0])}, {"gears": np.ones(3)},
        tally={"combinations": np.array([1.0, 2.0, 4.0])},
    )  # fmt: skip
    monkeypatch.setattr(search, "branches_of", lambda *_: [])
    monkeypatch.setattr(search, "rest_of", lambda *_: np.array([0.0, 0.5, 5.0]))
    asked = SimpleNamespace(design=None, nominal=None)
    kept = search._narrowed(asked, search._Found(front), ["a stage"], 2)
    assert (kept.front.mass.tolist(), kept.left_out, kept.proven) == ([3.0, 2.0], 4.0, False)
    assert search._narrowed(asked, search._Found(front), ["a stage"], 3).proven
    assert search._narrowed(asked, search._Found(front), [], 2).proven


def test_speeds_of_a_planets_bearing_are_those_against_its_carrier():
    """z 30/45/120 and the carrier at 1200 min⁻¹: 6000 of the sun, so (6000 − 1200) · 30/45 = 3200 of the planet."""
    text = ONE_SET.format(speed=1200) + (
        'sun = "fast"\nring = "ground"\ncarrier = "slow"\nsun_teeth = 30\nplanet_teeth = 45\nplanets = 3\n'
        'module_mm = 3\nface_width_mm = 40\n[planetaries.set.planet_bearing]\nkind = "cylindrical"\n'
        "[bearing_rules]\nlimits = true\n"
    )
    checks = {check.mode: check for check in size(parse(text)).checks if str(check.part) == "set.planet"}
    assert checks["thermal reference speed"].value == pytest.approx(3200.0 * math.pi / 30.0, rel=1e-9)
    fitted = bearing(checks["speed factor"].place)
    middle = 500.0 * (fitted.bore + fitted.outer_diameter)
    assert checks["speed factor"].value == pytest.approx(3200.0 * middle, rel=1e-9)
