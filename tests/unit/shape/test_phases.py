"""Teeth stand in gaps while everything turns, and everything turns as the train says."""

import dataclasses
import math

import numpy as np
import pytest

from gearwright.identity import Role
from gearwright.parts.gears import least_backlash
from gearwright.shape import scene, sized_mesh
from gearwright.shape.scene import approximations
from gearwright.shape.stands import contacts_of, stands_of
from gearwright.shipped import shipped_designs
from overlaps import crossed_depths, deepest, overlaps, planar_contacts
from shipped_work import sized

NAMES = shipped_designs()
DEEP, LINES = 2e-6, 1.5e-4
"""Without backlash flanks only touch: what rounding leaves [m], and of a module what straight lines between 40 points
take from hollow flanks, s²/(8 ρ) with s = 2.25/40 m and ρ > 3 m [-]."""


@pytest.mark.parametrize("name", NAMES)
def test_no_tooth_of_a_shipped_design_stands_in_another_at_fifty_moments(name):
    sizing = sized(name)
    planar = planar_contacts(sizing)
    words = " ".join(approximations(sizing, planar.phases))
    seen = set()
    for contact in planar.contacts:
        pair = f"{contact.first.name} and {contact.second.name}"
        if pair in planar.phases.missed:
            assert pair in words
            continue
        allowed = max(DEEP, LINES * contact.first.gear.module)
        if f"tips of {contact.second.gear.name} reach" in words and contact.mesh.sign > 0:
            # Tips in a fillet that a rack leaves: the backlash that drawings ask for keeps them clear of it.
            distance = sized_mesh(sizing, contact.mesh).centre_distance
            allowed = max(allowed, least_backlash(distance, contact.first.gear.module))
        # All meshes of a row at a few moments, the first of them at fifty over 0.3 s: hundreds of turns.
        count = 50 if contact.mesh.name not in seen else 2
        seen.add(contact.mesh.name)
        moments = np.linspace(0.0, 0.3, count)
        assert deepest(sizing, contact, planar, moments) <= allowed, pair


def test_a_wrong_phase_is_seen():
    sizing = sized("in-line-h2")
    planar = planar_contacts(sizing)
    contact = planar.contacts[0]
    planar.phases.turned[contact.first.name] += 0.02 / contact.first.gear.teeth
    assert deepest(sizing, contact, planar, (0.0,)) > 2.0 * DEEP


CROSSING = ("ec120b", "ec120b-as-reported", "face-gear-split-torque", "twin-engine-helicopter")


@pytest.mark.parametrize("name", CROSSING)
def test_teeth_on_crossing_axes_stand_in_each_other_by_less_than_their_backlash(name):
    """Virtual gears for octoids, racks for the wheels of face gears: what they miss is told in docs/how-to."""
    sizing = sized(name)
    depths = crossed_depths(sizing, scene(sizing, detail="coarse"), np.linspace(0.0, 0.3, 3))
    assert depths
    for pair, depth in depths.items():
        gear = next(gear for gear in sizing.gears if pair.startswith(gear.name))
        assert depth < least_backlash(gear.pitch_diameter / 2.0, gear.module), pair


def test_a_bevel_wheel_that_is_turned_is_seen():
    """A twentieth of a pitch at the outer end, 11 mm π/20 = 1.73 mm, is 1.33 mm square to flanks of 20° and 35°."""
    sizing = sized("ec120b")
    built = scene(sizing, detail="coarse")
    nodes = [dataclasses.replace(node, phase=node.phase + 0.05 * 2.0 * math.pi / 43) if node.part.role is Role.WHEEL
             and node.part.name == "bevel" else node for node in built.nodes]  # fmt: skip
    (depth,) = crossed_depths(sizing, dataclasses.replace(built, nodes=tuple(nodes)), (0.0,)).values()
    assert depth == pytest.approx(1.33e-3, abs=1e-4)


WHOLE = ("ec120b", "in-line-h2", "mixed", "twin-engine-helicopter", "wind-turbine-5mw", "wolfrom-reducer")


@pytest.mark.parametrize(("name", "found"), [*((name, 0) for name in WHOLE), ("ec120b-as-reported", 11)])
def test_no_body_of_a_design_that_is_whole_stands_in_one_that_turns_against_it(name, found):
    """The student's EC120B, whose checks of room fail, has 6, two of them a wheel in bosses, and 5 of two covers
    in walls without room for their holes; `benchmarks/solids.py` tells of all."""
    sizing = sized(name)
    assert len(overlaps(sizing, scene(sizing, detail="coarse"))) == found


@pytest.mark.parametrize("name", NAMES)
def test_every_mesh_of_a_shipped_design_is_met_but_one_loop_that_cannot_close(name):
    """The motor's pinion of Off-Set H2 meshes with both pinions of the second stage, which mesh with one wheel."""
    phases = planar_contacts(sized(name)).phases
    expected = {"motor-stage.pinion and second.pinion.right"} if name == "off-set-h2" else set()
    assert set(phases.missed) == expected
    assert phases.against == ()


@pytest.mark.parametrize("name", NAMES)
def test_bodies_turn_with_the_speeds_of_the_flow(name):
    sizing = sized(name)
    built = scene(sizing, detail="coarse")
    for case, flow in sizing.flows.items():
        for node in built.nodes:
            if node.look not in ("sun", "planet", "ring", "pinion", "wheel"):
                continue
            gear = next(gear for gear in sizing.gears if node.part in [gear.part, *map(gear.body, gear.shafts)])
            own = node.part.branch or gear.shafts[0]
            carried = built.by_name[node.on].spins[case] if node.on else 0.0
            # Half turns about x give bevel and face gears an axis that looks the other way.
            assert abs(node.spins[case] + carried) == pytest.approx(abs(flow.speeds[own]), abs=1e-9)


@pytest.mark.parametrize(("name", "stage"), [("ec120b", "bevel"), ("twin-engine-helicopter", "combining"),
                                             ("twin-engine-helicopter", "tail-take-off"),
                                             ("face-gear-split-torque", "first")])  # fmt: skip
def test_gears_on_crossing_axes_go_the_same_way_where_they_touch(name, stage):
    """ω × r of both gears, each from its own axis to its own side of the touching point."""
    sizing = sized(name)
    built, stands = scene(sizing, detail="coarse"), stands_of(sizing)
    for contact in contacts_of(sizing, stands):
        if contact.mesh.stage != stage:
            continue
        ways = []
        for stand, angle in zip((contact.first, contact.second), contact.angles, strict=True):
            node = built.by_name[stand.name]
            arm = math.cos(angle) * stand.axes.turned[:, 0] + math.sin(angle) * stand.axes.turned[:, 1]
            speed = node.spins[built.cases[0]] * node.axes.along
            ways.append(np.cross(speed, stand.gear.pitch_diameter / 2.0 * arm))
        assert ways[0] == pytest.approx(ways[1], rel=1e-6, abs=1e-6 * np.linalg.norm(ways[0]))
