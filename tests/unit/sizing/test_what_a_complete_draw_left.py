"""What a draw of all rooms had left: the heaviest case, the other flank's part, volumes, parts of lanes, fillets."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import pytest

from designs import HYBRID, PAIR
from gearwright.dynamics.assembly import loaded_bodies
from gearwright.lanes import Lanes
from gearwright.parts.gears.tooth_form import _spread as spread  # outlines show it within a step only
from gearwright.sizing import size
from gearwright.sizing.insight import Trial
from gearwright.sizing.many.by_lane import of_lane
from gearwright.sizing.rating import context_of, reverse_parts
from gearwright.sizing.rating.context import worst_case  # of which records keep the case and the larger module only
from gearwright.spec import parse
from gearwright.train import gears_of

RPM = math.pi / 30.0
CASES = """\
[cases.climb]
share = 0.3
turbine.power_kw = 120
[cases.cruise]
share = 0.7
turbine.power_kw = 100
[cases.jam]
static = true
turbine.power_kw = 300
"""
TEETH = "pinion_teeth = 24\nwheel_teeth = 71\nmodule_mm = 3\nface_width_mm = 30\n"


def context(text):
    """Return what gear sizing reads of a design, its teeth known."""
    sizing = size(parse(text))
    return context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, {})


@pytest.mark.parametrize(("rating", "case", "power"), [("iso6336", "climb", 120e3), ("lewis-hertz", "jam", 300e3)])
def test_the_heaviest_case_is_a_static_one_only_where_the_method_knows_no_fatigue(rating, case, power):
    """T = P/ω = 191.0 N m at 120 kW and 477.5 N m at 300 kW, both at 6000 rpm, for each of 24 teeth."""
    known = context(
        PAIR.replace("power_kw = 100", "power_kw = 400") + TEETH + f'[gears]\nrating = "{rating}"\n' + CASES
    )
    ((mesh,), factor) = known.train.meshes, known.ratings["stage"].load_factor
    assert worst_case(known, mesh) == (case, pytest.approx(power / (6000.0 * RPM) / 24.0 * factor, rel=1e-12))


def test_planets_share_the_torque_of_their_sun():
    """1046 kW at 20000 rpm are 499.4 N m on the sun, a third of them at each of three planets, for each tooth."""
    known = context(HYBRID)
    mesh = next(row for row in known.train.meshes if row.stage == "first" and row.gears[0] == "first.sun")
    torque = 1046e3 / (20000.0 * RPM) / 3.0 / known.teeth["first.sun"] * known.ratings["first"].load_factor
    assert worst_case(known, mesh)[1] == pytest.approx(torque, rel=1e-12)


@pytest.mark.parametrize(
    ("loads", "part"),
    [((-30.0, 100.0), 0.3), ((-100.0, 30.0), 0.3), ((30.0, 100.0), 1.0), ((-100.0, -30.0), 1.0), ((0.0, 100.0), 1.0)],
)
def test_the_other_flank_of_a_pair_bears_the_part_of_the_torque_against_it(loads, part):
    """30 N m against 100 N m are 0.3 of them; a pair that is loaded in one sense has no other flank."""
    train = context(PAIR + TEETH).train
    assert reverse_parts(train, train.meshes[0], {train.meshes[0].name: loads}) == pytest.approx((part, part))


def test_gears_of_a_set_between_two_mates_have_no_part():
    train = context(HYBRID).train
    mesh = next(row for row in train.meshes if row.gears == ("first.sun", "first.planet"))
    loads = {row.name: (-30.0, 100.0) for row in train.meshes}
    assert reverse_parts(train, mesh, loads) == pytest.approx((0.3, 1.0))


def test_gears_are_named_in_the_order_sun_planet_ring_and_pinion_wheel():
    hybrid, pair = parse(HYBRID), parse(PAIR)
    assert gears_of("first", hybrid.planetaries["first"]) == ("first.sun", "first.planet", "first.ring")
    assert gears_of("stage", pair.pairs["stage"]) == ("stage.pinion", "stage.wheel")


def test_a_pair_fills_two_cylinders():
    """π/4 · 30 mm · (3 mm/cos 20°)² · (24² + 71²)."""
    trial = Trial(context(PAIR + TEETH + "[gears]\nhelix_angle_deg = 20\n"))
    volume = math.pi / 4.0 * 0.03 * (3e-3 / math.cos(math.radians(20.0))) ** 2 * (24**2 + 71**2)
    assert trial.volume("stage", 3e-3, 0.03) == pytest.approx(volume, rel=1e-12)


def test_a_set_fills_its_sun_all_of_its_planets_and_the_wall_of_its_ring():
    trial = Trial(context(HYBRID))
    sun, planet, ring = (trial.context.teeth[f"first.{role}"] for role in ("sun", "planet", "ring"))
    rim = trial.rating("first").rules.rim_thickness_ratio
    assert trial.rating("first").helix_angle == 0.0
    areas = sun**2 + 3.0 * planet**2 + (ring + 2.0 * rim) ** 2 - ring**2
    assert trial.volume("first", 2e-3, 0.04) == pytest.approx(math.pi / 4.0 * 4e-6 * 0.04 * areas, rel=1e-12)


class Pairing(NamedTuple):
    """Two values by name."""

    first: object
    second: object


@dataclass(frozen=True)
class Holder:
    """One value by name, and one that is the same in every lane."""

    own: object
    same: str = "kept"


def test_one_lane_of_anything_is_what_it_holds_there():
    """Lanes of which one entry is kept have it in every lane; nothing else changes its kind or its parts."""
    several, alike = Lanes(np.array([1.0, 2.0, 3.0])), Lanes(np.array([7.0]))
    assert [of_lane(several, k) for k in range(3)] == [1.0, 2.0, 3.0]
    assert [of_lane(alike, k) for k in range(3)] == [7.0] * 3
    assert of_lane(Pairing(several, "word"), 2) == Pairing(3.0, "word")
    assert of_lane([several, (alike, 4)], 1) == [2.0, (7.0, 4)]
    assert of_lane({"a": Holder(several)}, 0) == {"a": Holder(1.0)}
    assert of_lane(Lanes(np.array([1.0, 2.0])), 1) == 2.0
    untouched = Holder(5.0)
    assert of_lane(untouched, 1) is untouched


def test_an_array_of_one_lane_is_a_copy():
    lanes = Lanes(np.array([[1.0, 2.0], [3.0, 4.0]]))
    row = of_lane(lanes, 1)
    row[0] = 9.0
    assert lanes.data[1, 0] == 3.0


@pytest.mark.parametrize(
    ("radius", "angle", "chosen"),
    [
        ([2.0] * 5, [0.0, 0.125, 0.25, 0.5, 1.0], [0, 3, 4]),  # r Δθ: 0.25, 0.25, 0.5, 1; half of 2 is the fourth
        ([1.0, 2.0, 3.0, 5.0], [0.5] * 4, [0, 2, 3]),  # along a radius: 1, 1, 2; half of 4 is the third
        ([4.0, 1.0, 1.0, 1.0], [0.0, 4.0, 12.0, 15.0], [0, 2, 3]),  # (3, 1 · 4) is 5, then 8 and 3: half is 8
    ],
)
def test_points_of_a_fillet_are_chosen_evenly_along_it(radius, angle, chosen):
    assert spread(np.array(radius), np.array(angle), 3).tolist() == chosen


def test_a_machine_without_inertia_loads_the_gear_of_its_shaft_and_any_other_itself():
    sizing = size(parse(PAIR.replace("propellers.", "loads.").replace("diameter_m = 2\n", "") + TEETH))
    assert [bool(machine.inertia) for machine in sizing.machines] == [True, False]
    assert loaded_bodies(sizing) == {"turbine": "turbine", "propeller": "stage.wheel"}
