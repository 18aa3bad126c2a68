"""Ribs and mounts of housings: as heavy as weighed, on their walls, in nobody's way."""

import math

import numpy as np
import pytest

from gearwright.shape import MOUNT, RIB, SCREW, casing_masses, scene, short_of
from gearwright.shape.casings import BOLT, CENTRE, DEPTH, LUGS, MOST, Rods, lugs_on, ribs_on
from gearwright.shape.chambers import Chamber, depth_in
from gearwright.shipped import shipped_designs
from gearwright.sizing.casing import Flanges
from shipped_work import sized

OWN = [name for name in shipped_designs() if sized(name).design.housing.own]
FEW = ["ec120b", "face-gear-split-torque", "in-line-h2", "off-set-h3", "twin-engine-helicopter"]
RIBS, WALLS = "housing ribs", "housing inner walls"
CRAMPED = ("differential-hybrid", "in-line-h1-star", "twin-engine-helicopter", "twin-engine-sprag", "wind-turbine-5mw")
SHORT = {"off-set-h2": [RIBS]} | {name: [WALLS] for name in CRAMPED}
"""Whose walls leave too little room for ribs of five walls, or stages for walls between them, as their sheets say."""
NONE = Rods(np.empty((0, 3)), np.empty((0, 3)), np.empty(0), np.empty(0))


@pytest.mark.parametrize("name", OWN)
def test_ribs_and_mounts_weigh_what_is_drawn(name):
    drawn = casing_masses(sized(name), scene(sized(name), detail="coarse"))
    assert {"housing ribs", "housing mounts"} <= drawn.keys()
    short = short_of(sized(name), scene(sized(name), detail="coarse"))
    assert list(short) == SHORT.get(name, [])
    for part, (solid, weighed) in drawn.items():
        assert solid < weighed if part in short else solid == pytest.approx(weighed, rel=5e-4), part


@pytest.mark.parametrize("name", FEW)
def test_nothing_stands_in_ribs_and_they_stand_in_nothing(name):
    """Points of all other bodies against the boxes of ribs; points of ribs and mounts against walls and plates."""
    built = scene(sized(name), detail="coarse")
    standing = [node for node in built.nodes if node.name.startswith((f"housing, {RIB} ", f"housing, {MOUNT} "))]
    walls = [(node, solid) for node in built.nodes
             if isinstance(solid := built.solids.get(node.surface), Chamber)]  # fmt: skip
    others = [node for node in built.nodes if node.surface and (node.look != "housing" or node in standing)]
    assert sum(node.look == SCREW for node in others) > 10
    for node in standing:
        own = built.surfaces[node.surface].points
        half = np.abs(own).max(axis=0)
        for wall, chamber in walls:
            inside = (own - 2e-5 * np.sign(own)) @ node.axes.turned.T + node.axes.origin - wall.axes.origin
            assert depth_in(inside @ wall.axes.turned, chamber, 1e-5) == 0.0, (node.name, wall.name)
        if f"housing, {RIB} " not in node.name:
            continue
        for other in others:
            if other is node or np.linalg.norm(other.axes.origin - node.axes.origin) > 2.0:
                continue
            points = built.surfaces[other.surface].points @ other.axes.turned.T + other.axes.origin
            local = np.abs((points - node.axes.origin) @ node.axes.turned)
            assert not np.any(np.all(local < half - 1e-5, axis=1)), (node.name, other.name)


def tube(radius, wall, length):
    angle = 2.0 * math.pi * (np.arange(48) + 0.5) / 48
    loop = np.stack([np.cos(angle), np.sin(angle)], axis=1) / math.cos(math.pi / 48)
    return Chamber((radius + wall) * loop, radius * loop, (0.0, length))


def test_ribs_on_a_tube_are_as_high_as_their_volume_asks():
    """A tube of 200 mm with a wall of 10 mm, 300 mm long; 100 cm³ on N ribs of 10 x h x 300 mm."""
    flanges = Flanges(2, 6e-3, 40, 1.3)
    found = list(ribs_on([tube(0.2, 0.01, 0.3)], [], flanges, 0.01, 1e-4, rods=NONE, taken=()))
    heights = {round(float(np.ptp(solid.sections[0].points[:, 0])), 9) for _, solid, _ in found}
    assert heights == {round(1e-4 / (len(found) * 0.01 * 0.3), 9)}
    assert all(abs(axes.origin[0] - 0.15) < 1e-9 for _, _, axes in found)


def test_ribs_are_no_higher_than_five_walls_whatever_is_weighed():
    found = list(ribs_on([tube(0.2, 0.01, 0.3)], [], Flanges(2, 6e-3, 40, 1.3), 0.01, 1.0, rods=NONE, taken=()))
    assert max(float(np.ptp(solid.sections[0].points[:, 0])) for _, solid, _ in found) == pytest.approx(MOST * 0.01)


def test_lugs_have_the_volume_that_is_weighed_and_a_hole():
    """By hand, on a wall that is nearly flat: 0.5 b of a rectangle, a half circle and a hole less."""
    lugs = lugs_on([tube(20.0, 0.01, 0.5)], [], 1e-3, NONE)
    assert len(lugs) == LUGS
    width = lugs[0].width
    area = width**2 * (CENTRE + math.pi / 8.0 - math.pi / 4.0 * BOLT**2)
    assert LUGS * DEPTH * width * area == pytest.approx(1e-3, rel=0.02)
    solid, _ = lugs[0].placed
    assert solid.profile[0][1] == pytest.approx(BOLT * width / 2.0)


def test_where_a_rod_leaves_beside_a_wall_no_rib_stands():
    rod = Rods(np.array([[-1.0, 0.23, 0.0]]), np.array([[1.0, 0.0, 0.0]]), np.array([2.0]), np.array([0.015]))
    flanges, chamber = Flanges(2, 6e-3, 40, 1.3), tube(0.2, 0.01, 0.3)
    for rods, least in ((NONE, 0.0), (rod, 0.1)):
        found = list(ribs_on([chamber], [], flanges, 0.01, 2e-4, rods=rods, taken=()))
        angles = [math.atan2(axes.origin[2], axes.origin[1]) for _, _, axes in found]
        assert min(map(abs, angles)) >= least
        assert least or min(map(abs, angles)) < 1e-9  # the first one looks along y
