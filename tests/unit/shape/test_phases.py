"""Teeth stand in gaps while everything turns, and everything turns as the train says."""

import math

import numpy as np
import pytest
from gearwright.shape.meshing import deepest, planar_contacts

from gearwright.parts.gears import least_backlash
from gearwright.shape import scene, sized_mesh
from gearwright.shape.contacts import contacts_of
from gearwright.shape.stands import stands_of
from gearwright.shape.words import approximations
from gearwright.shipped import shipped_designs
from shipped_work import sized

NAMES = shipped_designs()
DEEP, LINES = 2e-6, 1.5e-4
"""Without backlash flanks only touch: what rounding leaves [m], and of a module what straight lines between 40 points
take from hollow flanks, s²/(8 ρ) with s = 2.25/40 m and ρ > 3 m [-]."""


@pytest.mark.parametrize("name", NAMES)
def test_no_tooth_of_a_shipped_design_stands_in_another_at_fifty_moments(name):
    sizing = sized(name)
    planar, phases, leaning = planar_contacts(sizing)
    words = " ".join(approximations(sizing, phases))
    seen = set()
    for contact in planar:
        pair = f"{contact.first.name} and {contact.second.name}"
        if pair in phases.missed:
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
        assert deepest(sizing, contact, phases, leaning, moments=moments) <= allowed, pair


def test_a_wrong_phase_is_seen():
    sizing = sized("in-line-h2")
    planar, phases, leaning = planar_contacts(sizing)
    contact = planar[0]
    phases.turned[contact.first.name] += 0.02 / contact.first.gear.teeth
    assert deepest(sizing, contact, phases, leaning, moments=(0.0,)) > 2.0 * DEEP


@pytest.mark.parametrize("name", NAMES)
def test_every_mesh_of_a_shipped_design_is_met_but_one_loop_that_cannot_close(name):
    """The motor's pinion of Off-Set H2 meshes with both pinions of the second stage, which mesh with one wheel."""
    _, phases, _ = planar_contacts(sized(name))
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
