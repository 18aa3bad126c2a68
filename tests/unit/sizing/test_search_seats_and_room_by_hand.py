"""Small pieces of the search for teeth, of seats, masses and room, each against what is reckoned by hand."""

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest

from designs import HYBRID, PAIR
from gearwright.catalogue import STEEL_DENSITY, STEEL_SHARE, bored_mass, loaded_mass
from gearwright.errors import DesignError, Problem
from gearwright.identity import Kind, PartId, Role
from gearwright.parts.bearings import BearingKind
from gearwright.sizing import Body, Direction, Point, Station, bearings as running, size
from gearwright.sizing.bearing_seats import _rotor, bearing_seats
from gearwright.sizing.mass.bodies import (
    _estimated as bearings_by_load,
    _estimated_bore as planet_on_rollers,
)
from gearwright.sizing.places import solid_of
from gearwright.sizing.places.frames import _inside, coaxial_checks, owner
from gearwright.sizing.places.positioning import sphere_around
from gearwright.sizing.teeth.candidates import Front, _stands_alone, ring_variants
from gearwright.sizing.teeth.criteria import _is_clear, aligned
from gearwright.spec import GROUND, edited, parse, read
from gearwright.spec.design import module_owners
from gearwright.train import build_train, passes, power_flow

near = pytest.approx
TEETH = {"sun": 24, "planet": 36, "ring": 96}
SET = parse(HYBRID).planetaries["first"]


@dataclass(frozen=True)
class Stage:
    """What of a stage of the search these pieces read."""

    stage: object
    deviation: int = 0
    name: str = "first"
    group: str = "first"


def test_rings_are_tried_from_the_nearest_number_of_teeth_outwards():
    """None beside z_s + 2 z_p where none is allowed, for pairs, and where the teeth are known."""
    design = edited(parse(HYBRID), {"teeth.ring_deviation": 2})
    assert [task.deviation for task in ring_variants(Stage(SET), design)] == [0, -1, 1, -2, 2]
    assert ring_variants(Stage(SET), parse(HYBRID)) == (Stage(SET),)
    assert ring_variants(Stage(parse(PAIR).pairs["stage"]), design) == (Stage(parse(PAIR).pairs["stage"]),)
    known = edited(design, {f"planetaries.first.{key}_teeth": teeth for key, teeth in TEETH.items()}).planetaries[
        "first"
    ]
    assert ring_variants(Stage(known), design) == (Stage(known),)


def test_a_set_stands_alone_with_given_planets_and_a_ring_that_they_decide():
    design = parse(HYBRID)
    freed = edited(design, {"teeth.ring_deviation": 1})
    open_set = SET.model_copy(update={"planets_given": None})
    assert SET.planets_given == 3 and open_set.planets_given is None
    judged = [_stands_alone(Stage(stage), rules) for stage in (SET, open_set) for rules in (design, freed)]
    assert judged == [True, False, False, False]


def test_pairs_on_the_same_axes_get_the_larger_centre_distance():
    """Modules grow in proportion to the distance, so m³ (z_1 + z_2)³ of both is that of the larger, lane by lane."""
    design = read("off-set-h1")
    (name, pair), *_ = [(name, pair) for name, pair in design.pairs.items() if pair.coaxial_with is not None]
    helix = design.rules(name).helix_angle or 0.0
    group, stages = module_owners(design), (name, pair.coaxial_with)
    teeth = {f"{stages[0]}.pinion": 20, f"{stages[0]}.wheel": 50, f"{stages[1]}.pinion": 17, f"{stages[1]}.wheel": 71}
    cubes = {group[stages[0]]: np.array([8e-9, 64e-9]), group[stages[1]]: np.array([27e-9, 1e-9])}
    front = Front({gear: np.array([count, count]) for gear, count in teeth.items()}, {}, cubes, {})
    moved = aligned(front, design).cubes
    spans = {stages[0]: 35.0 / math.cos(helix), stages[1]: 44.0 / math.cos(helix)}
    for lane, (first, second) in enumerate(((2e-3, 3e-3), (4e-3, 1e-3))):
        distance = max(first * 35.0, second * 44.0) / math.cos(helix)
        for stage in stages:
            module = moved[group[stage]][lane] ** (1.0 / 3.0)
            assert module * spans[stage] == near(distance, rel=1e-12)


def test_a_train_is_held_against_bands_with_its_own_number_of_planets():
    """Planets pass a tooth of a ring as often as there are planets: a band about 4 of them is left by 3."""
    text = HYBRID + '[teeth.forbidden.floor]\nlowest_hz = LOW\nhighest_hz = HIGH\nof = "planet-pass"\n'
    design = parse(text.replace("LOW", "1").replace("HIGH", "2"))
    teeth = dict(size(parse(HYBRID)).teeth)
    train = build_train(design)
    flow = power_flow(design, train, teeth, "rated")
    three = {mesh.stage: often for mesh, often in passes(design, train, teeth, flow, "planet-pass")}["first"]
    four = three * 4.0 / 3.0
    banned = parse(text.replace("LOW", str(0.999 * four)).replace("HIGH", str(1.001 * four)))
    assert _is_clear(banned, train, {"floor"}, teeth, {})
    assert _is_clear(banned, train, {"floor"}, teeth, {"first": 3})
    assert not _is_clear(banned, train, {"floor"}, teeth, {"first": 4})


def test_the_path_of_a_seat_is_where_the_design_says_what_sits_there():
    stated = {str(seat.part): seat.path for seat in bearing_seats(size(read("ec120b")))}
    assert {path for part, path in stated.items() if path and path != f"bearings.{part}"} <= {
        path for path in stated.values() if path.startswith(("planetaries.", "epicyclics."))
    }
    assert all(stated[name] == f"bearings.{name}" for name in read("ec120b").bearings)
    left_open = [seat.path for seat in bearing_seats(size(parse(PAIR))) if GROUND in seat.nodes]
    assert left_open and not any(left_open)


@pytest.mark.parametrize("place", [0.45, 0.2, 0.8, -0.3])
def test_a_rotor_loads_both_bearings_as_its_mirror_image_does(place):
    """Bearings at 0 and 1 m, force F at x, moment M: |F (1 − x) ± M| and |F x ∓ M|; mirrored, both change places."""
    rotor = SimpleNamespace(shaft="mast", thrust=0.0, in_plane_force=1000.0, hub_moment=70.0)
    design = SimpleNamespace(airscrews={"rotor": rotor}, service=SimpleNamespace(shares={}), cases={})
    plans = [
        SimpleNamespace(places={"rotor": at, "gear": 0.5}, bearings=(0.0, 1.0), seats={}) for at in (place, 1.0 - place)
    ]  # fmt: skip
    (here, side), (there, other) = (_rotor(design, {}, "mast", plan) for plan in plans)
    assert here == near(there[::-1]) and side == -other
    sense = 1.0 if place >= 0.5 else -1.0
    assert sorted(here) in (
        near(sorted(np.abs([1000.0 * (1.0 - place) + s * 70.0, 1000.0 * place - s * 70.0]))) for s in (sense, -sense)
    )
    assert _rotor(design, {}, "tail", plans[0])[1] == 0.0


def test_a_planet_bearing_weighs_what_its_load_asks_as_wide_as_the_planet():
    """d_o² = d_pin² + m/(part of steel · π/4 · b · ρ), held between 8 % of the pin beyond it and the planet's rim."""
    body = SimpleNamespace(
        part=PartId(Kind.BEARING, "first", Role.PLANET), stage="first", width=0.04,
        steps=(SimpleNamespace(pitch_diameter=0.3, module=3e-3, bodies=3),),
    )  # fmt: skip
    steel = STEEL_SHARE[BearingKind.CYLINDRICAL] * math.pi / 4.0 * 0.04 * STEEL_DENSITY
    rating = 250e3
    by_load = planet_on_rollers(body, 0.05, {"first": rating})
    assert by_load.mass == near(loaded_mass(rating), rel=1e-12) and not by_load.crowded
    assert by_load.bearing_diameter == near(math.sqrt(0.05**2 + loaded_mass(rating) / steel), rel=1e-12)
    light = planet_on_rollers(body, 0.05, {})
    assert light.bearing_diameter == near(0.05 * 1.16) and light.mass == near(steel * 0.05**2 * (1.16**2 - 1.0))
    heavy = planet_on_rollers(body, 0.05, {"first": 1e9})
    assert heavy.crowded and heavy.bearing_diameter == near(0.3 - 2.0 * (1.2 * 2.25 + 1.25) * 3e-3)


def test_bearings_by_load_are_those_of_shafts_that_the_design_leaves_open():
    """Neither the bearings of planets, nor those that the design fits, nor those between two shafts."""
    seats = [
        ("open", PartId(Kind.BEARING, "open"), ("shaft", GROUND)),
        ("fitted", PartId(Kind.BEARING, "fitted"), ("shaft", GROUND)),
        ("planet", PartId(Kind.BEARING, "set", Role.PLANET), ("pin", GROUND)),
        ("between", PartId(Kind.BEARING, "between"), ("shaft", "sleeve")),
    ]
    duties = [
        (SimpleNamespace(name=name, part=part, nodes=nodes, count=2, bore=0.06), None, rating)
        for rating in (1e3, 500e3) for name, part, nodes in seats
    ]  # fmt: skip
    sizing = SimpleNamespace(bearings=[SimpleNamespace(name="fitted")])
    items = list(bearings_by_load(sizing, duties))
    assert [item.part for item in items] == ["open", "open"]
    assert [item.each for item in items] == [bored_mass(0.06), loaded_mass(500e3)]
    assert loaded_mass(1e3) < bored_mass(0.06) < loaded_mass(500e3)


def test_a_thin_oil_is_refused_only_where_the_design_asks_for_the_modified_life(monkeypatch):
    def too_thin(*_):
        raise DesignError([Problem("", "the oil is too thin")])

    monkeypatch.setattr(running, "modified_life", too_thin)
    design = read("ec120b")
    basic = SimpleNamespace(bearing_rules=SimpleNamespace(life="basic"), oil=design.oil)
    strict = SimpleNamespace(bearing_rules=SimpleNamespace(life="modified"), oil=design.oil)
    monkeypatch.setattr(running, "oil_of", lambda _: None)
    assert running.oiled_life(basic, None, None, path="bearings.a") is None
    with pytest.raises(DesignError, match=r"bearings\.a: the oil is too thin, in \[oil\]"):
        running.oiled_life(strict, None, None, path="bearings.a")


def rod(part, shaft, at, *, radius=0.03, length=0.1, bore=0.0, direction=(1.0, 0.0, 0.0)):
    """Return a cylinder."""
    ends = (Station(0.0, radius), Station(length, radius))
    return Body(part, shaft, "", Point(*at), Direction(*direction), ends, bore)


def gear(name, role=None):
    """Return a gear's identity."""
    return PartId(Kind.GEAR, name, role)


def test_a_planet_and_what_stands_belong_to_their_set_all_else_to_its_shaft():
    planet, ring = rod(gear("set", Role.PLANET), "carrier", (0, 0, 0)), rod(gear("set", Role.RING), GROUND, (0, 0, 0))
    sun = rod(gear("set", Role.SUN), "input", (0, 0, 0))
    assert [owner(body) for body in (planet, ring)] == [PartId(Kind.STAGE, "set")] * 2
    assert owner(sun) == PartId(Kind.SHAFT, "input")


@pytest.mark.parametrize("built, told", [((), 1), (("a",), 1), (("b",), 1), (("a", "b"), 0)])
def test_bodies_on_one_axis_that_meet_are_told_unless_both_shafts_are_worked_out(built, told):
    """The same with a third shaft beside that is not worked out and that nothing meets."""
    bodies = [rod(gear("x"), "a", (0, 0, 0)), rod(gear("y"), "b", (0.05, 0, 0)), rod(gear("z"), "c", (1.0, 0, 0))]
    checks = list(coaxial_checks(SimpleNamespace(bodies=bodies, within=()), frozenset(), frozenset(built)))
    assert len(checks) == told
    assert all((check.part.name, check.mode) == ("b", "room beside a") for check in checks)


@pytest.mark.parametrize("direction", [(1.0, 0.0, 0.0), (0.6, 0.0, -0.8)])
def test_the_sphere_about_a_body_goes_through_the_edges_of_a_cylinder(direction):
    """Middle half-way along the axis; radius √((l/2)² + r²): no less holds it, and no more is asked."""
    middle, radius = sphere_around(rod(gear("x"), "a", (1.0, 2.0, 3.0), radius=0.3, length=0.8, direction=direction))
    assert radius == near(0.5, rel=1e-12)
    assert middle == near([at + 0.4 * way for at, way in zip((1.0, 2.0, 3.0), direction, strict=True)])


def test_a_leaning_rod_in_a_bore_reaches_as_far_as_its_outermost_circle():
    """20° off the bore's axis and 5 mm beside it: along a × b its circles reach 5 mm + r, square to that z tan + r cos.

    That is a rectangle about the ellipse of each circle: no point of the rod lies beyond its corner.
    """
    lean, beside, radius, length = math.radians(20.0), 5e-3, 4e-3, 0.06
    way = (math.cos(lean), math.sin(lean), 0.0)
    start = [-length / 2.0 * part for part in way]
    inner = rod(gear("in"), "a", (start[0], start[1], beside), radius=radius, length=length, direction=way)
    outer = rod(gear("out"), "b", (-0.2, 0.0, 0.0), radius=0.08, length=0.4, bore=0.05)
    (room,) = _inside(solid_of(outer), solid_of(inner))
    across = length / 2.0 * math.sin(lean) + radius * math.cos(lean)
    assert (room.apart, room.gap) == (near(0.05), near(0.05 - math.hypot(beside + radius, across)))
    angle = np.linspace(0.0, 2.0 * np.pi, 721)
    side, up = np.array([-math.sin(lean), math.cos(lean), 0.0]), np.array([0.0, 0.0, 1.0])
    rim = radius * (np.cos(angle)[:, None] * side + np.sin(angle)[:, None] * up)
    ends = [np.array([*start[:2], beside]) + end * np.array(way) + rim for end in (0.0, length)]
    far = max(np.linalg.norm(points[:, 1:], axis=1).max() for points in ends)
    assert room.gap <= 0.05 - far < room.gap + 2e-3
    parallel = replace(inner, direction=Direction(1.0, 0.0, 0.0), origin=Point(0.0, 0.003, 0.004))
    (room,) = _inside(solid_of(outer), solid_of(parallel))
    assert room.gap == near(0.05 - 0.005 - radius)
