"""Webs and collars that carry bosses: forces by hand, ways to walls, what stands in their way."""

from __future__ import annotations

import math

import numpy as np
import pytest

import gearwright as gw
from gearwright.shape import COLLAR, WEB, scene as scene_of
from gearwright.shape.chambers import Chamber, depth_in
from gearwright.shape.stands import Axes, triangles_of
from gearwright.sizing import Sizing, casing as webs
from gearwright.sizing.casing import Web, carried_bosses
from gearwright.sizing.housing_shell import Around, Stretch
from gearwright.sizing.making import boss_checks, web_checks
from gearwright.sizing.mass import complete_mass, weighed_wall
from overlaps import overlaps

BUILT = ("ec120b", "ec120b-as-reported")
X, Y, Z = np.eye(3)


@pytest.fixture(scope="module", params=BUILT)
def built(request: pytest.FixtureRequest) -> Sizing:
    return gw.size(gw.read(request.param))


def wall(sizing: Sizing) -> float:
    return weighed_wall(sizing).thickness


def web(way: np.ndarray, length: float, width: float = 0.03) -> Web:
    return Web("b", np.zeros(3), way, X, length, width, 0.01)


def test_two_square_webs_bear_each_all_of_a_radial_force_along_it() -> None:
    found = webs._thickness([web(Y, 0.1), web(Z, 0.1)], (9e3, 0.0), 50e6, 1e-3)
    assert found == pytest.approx(9e3 / (0.03 * 50e6))


def test_a_cross_bears_half_in_each_web_and_bends_by_a_quarter_of_the_thrust() -> None:
    cross = [web(way, 0.1) for way in (Y, Z, -Y, -Z)]
    assert webs._thickness(cross, (9e3, 0.0), 50e6, 1e-3) == pytest.approx(9e3 / 2.0 / (0.03 * 50e6))
    moment = 4e3 / 4.0 * 0.1 / 2.0
    assert webs._thickness(cross, (0.0, 4e3), 50e6, 1e-3) == pytest.approx(6.0 * moment / (0.03**2 * 50e6))


def test_three_even_webs_are_as_stiff_whichever_way_they_are_turned() -> None:
    def thick(turned: float) -> float:
        angles = turned + np.array([0.0, 2.0, 4.0]) * math.pi / 3.0
        even = [web(np.cos(angle) * Y + np.sin(angle) * Z, 0.1) for angle in angles]
        return webs._thickness(even, (9e3, 0.0), 50e6, 1e-3)

    assert thick(0.0) == pytest.approx(9e3 * 2.0 / 3.0 / (0.03 * 50e6))
    assert thick(0.4) == pytest.approx(thick(0.0))


@pytest.mark.parametrize("ways", [[Y], [Y, -Y]])
def test_webs_on_one_line_hold_one_way_only(ways: list[np.ndarray]) -> None:
    assert webs._thickness([web(way, 0.1) for way in ways], (9e3, 0.0), 50e6, 1e-3) == math.inf


def test_the_way_to_a_wall_goes_through_rooms_up_to_their_plates() -> None:
    wide, narrow = np.full(48, 0.1), np.full(48, 0.05)
    rooms = [Stretch(0.0, 0.2, wide, wide, 0.0, 0.0), Stretch(0.2, 0.3, narrow, narrow, 0.0, 0.0)]
    place = Around(rooms, (), np.empty((0, 4)), 0.01, None)  # type: ignore[arg-type]
    assert place.reach(np.array([0.1, 0.0, 0.0]), Y) == pytest.approx(0.101)
    assert place.reach(np.array([0.1, 0.02, 0.0]), -Y) == pytest.approx(0.121)
    assert place.reach(np.array([0.1, 0.0, 0.0]), X) == pytest.approx(0.201), "through the narrow room to its end"
    assert place.reach(np.array([0.1, 0.07, 0.0]), X) == pytest.approx(0.101), "to the plate between both"
    assert place.reach(np.array([0.1, 0.07, 0.0]), -X) == pytest.approx(0.101)
    assert place.reach(np.array([0.1, 0.2, 0.0]), Y) == 0.0, "outside"


def test_every_boss_of_shipped_gearboxes_is_carried_and_webs_end_in_walls(built: Sizing) -> None:
    found = carried_bosses(built, wall(built))
    assert {name for one in found for name in one.bearings} == {bearing.name for bearing in built.bearings}
    assert all(one.found for one in found)
    scene = scene_of(built, detail="coarse")
    shell = [(node.axes, solid) for node in scene.nodes
             if node.look == "housing" and isinstance(solid := scene.solids[node.surface], Chamber)]  # fmt: skip

    def depth(point: np.ndarray, axes: Axes, chamber: Chamber) -> float:
        return depth_in(((point - axes.origin) @ axes.turned)[None], chamber)

    for one in (one for each in found for one in each.webs):
        end = one.start + one.length * one.way
        assert max(depth(end, *piece) for piece in shell) > 0.0, f"a web of {one.bearing} ends in no wall"
    assert any(each.webs for each in found)


def test_nothing_that_turns_stands_in_a_boss_or_web_of_the_drawn_ec120b() -> None:
    sizing = gw.size(gw.read("ec120b"))
    assert overlaps(sizing, scene_of(sizing, detail="coarse")) == ()


def test_webs_weigh_what_their_solids_do(built: Sizing) -> None:
    (item,) = [item for item in complete_mass(built).parts if item.part == "housing webs"]
    scene = scene_of(built, detail="coarse")
    pieces = [triangles_of(scene.solids[node.surface], 720).volume
              for node in scene.nodes if f", {WEB} " in node.name or f", {COLLAR} " in node.name]  # fmt: skip
    assert item.each == pytest.approx(2680.0 * sum(pieces), rel=1e-4), "aluminium"


def test_the_review_names_bosses_to_which_nothing_finds_a_way(monkeypatch: pytest.MonkeyPatch) -> None:
    sizing = gw.size(gw.read("ec120b"))
    (check,) = web_checks(sizing)
    assert not check.fails and check.value == 10.0
    monkeypatch.setattr(Around, "is_free", lambda *_: False)
    (check,) = web_checks(gw.size(sizing.design))
    assert check.fails and "intermediate-nose" in check.why and "mast-upper" not in check.why


def test_the_review_objects_to_a_cover_in_a_boss_of_another_shaft() -> None:
    text = gw.shipped_design("ec120b").read_text()
    (check,) = boss_checks(gw.size(gw.read("ec120b")))
    assert not check.fails
    near = text.replace("position_mm = 125", "position_mm = 95")
    assert near != text
    (check,) = boss_checks(gw.size(gw.parse(near)))
    assert check.fails and "the cover of tail-rear" in check.why
