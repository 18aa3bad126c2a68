"""Mesh phases of meshed and stepped planets are where teeth touch that are put in and turned, flank point by point.

Nothing of the closed form is used: gears are involutes at angles; a mate is turned until its flank touches that of the
gear beside it; planets of the other sets are turned until they fit suns and rings as they stand.
"""

import cmath
import math
from functools import cached_property

import numpy as np
import pytest

from gearwright.dynamics.assembly.meshes import compound_phases
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.gear_geometry import pins_of
from gearwright.spec import edited, parse, read

POINTS = 4001
"""Of a flank; between two of them a touch is missed by a part of a cycle of 1e-7."""
TOUCH = 1e-5
"""What is compared to [cycles]."""


class Teeth:
    """An involute gear; of a ring the spaces, which have the shape of teeth."""

    def __init__(self, sizing, own):
        gear = next(gear for gear in sizing.gears if gear.own == own)
        epicyclic = sizing.design.epicyclics[gear.stage]
        self.angle = sizing.design.rules(gear.stage).pressure_angle
        self.ring, self.teeth, self.radius = own in epicyclic.rings, gear.teeth, gear.pitch_diameter / 2.0
        self.base, depth = self.radius * math.cos(self.angle), gear.module
        self.shift = -gear.profile_shift if self.ring else gear.profile_shift
        tip, root = self.radius + (1.0 + self.shift) * depth, self.radius - (1.1 - self.shift) * depth
        if self.ring:
            tip, root = self.radius + (1.1 + self.shift) * depth, self.radius - (1.0 - self.shift) * depth
        self.reach = max(root, self.base), tip

    @cached_property
    def pitch(self):
        """Angle from a tooth to the next [rad]."""
        return 2.0 * math.pi / self.teeth

    def half(self, radius):
        """Return half the angle of a tooth at a radius: (π/2 + 2 x tan α)/z + inv α − inv α_r [rad]."""
        angle, thicker = np.arccos(np.clip(self.base / radius, -1.0, 1.0)), 2.0 * self.shift * math.tan(self.angle)
        return self.pitch / 4.0 + thicker / self.teeth + math.tan(self.angle) - self.angle - (np.tan(angle) - angle)


def near(angle, reference, pitch):
    """Return the angle less whole pitches that is nearest to a reference [rad]."""
    return angle - pitch * np.round((angle - reference) / pitch)


def touched(gear, middle, centre, mate, away, side):
    """Return the angle of a tooth of the mate (or of a space of a ring) whose flank touches the gear's [rad].

    Args: the gear, the angle of one of its teeth, its centre; the mate and its centre; side +1: flanks that look
    counter-clockwise bear, −1: the others.
    """
    towards = cmath.phase(away - centre) if not mate.ring else cmath.phase(centre - away)
    radius = np.linspace(*gear.reach, POINTS)
    tooth = near(middle, towards - side * gear.pitch / 4.0, gear.pitch)
    points = centre + radius * np.exp(1j * (tooth + side * gear.half(radius))) - away
    inside = (np.abs(points) >= mate.reach[0]) & (np.abs(points) <= mate.reach[1])
    ahead = cmath.phase(centre - away)
    angles = ahead + np.angle(points[inside] * cmath.exp(-1j * ahead))
    turned = angles - side * mate.half(np.abs(points[inside]))
    outer = side if mate.ring else -side  # the mate is turned back until nothing of it stands in the gear's tooth
    return turned.max() if outer > 0 else turned.min()


class Train:
    """All gears of a compound set, put in set by set."""

    def __init__(self, sizing, flow):
        (self.stage, self.epicyclic), *_ = sizing.design.epicyclics.items()
        self.rows = [mesh for mesh in sizing.train.meshes if mesh.stage == self.stage]
        self.parts = {gear.name: gear.own for gear in sizing.gears}
        own = {gear.own: gear for gear in sizing.gears if gear.stage == self.stage}
        self.gears = {name: Teeth(sizing, name) for name in own}
        centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes if mesh.stage == self.stage}
        self.pins = pins_of(self.epicyclic, own, centres)
        self.flow = flow

    def sense(self, mesh, end):
        """Return the sense in which a gear turns beside the carrier."""
        return 1.0 if self.flow.speeds[mesh.nodes[end]] >= self.flow.speeds[mesh.nodes[2]] else -1.0

    def side(self, mesh):
        """Return the side of the flanks that bear: the leading ones of the gear that drives within the carrier."""
        drives = self.flow.meshes[mesh.name].torques[0] * self.sense(mesh, 0) < 0.0
        return self.sense(mesh, 0) * (1.0 if drives else -1.0)

    def centre(self, own, turn):
        """Return where the axis of a gear stands in a set."""
        return self.pins[self.epicyclic.body(own)] * turn if own in self.epicyclic.planets else 0j

    def put_in(self, turn, angles, other=0):
        """Turn every gear that touches one whose angle is known, never from a ring to its planet.

        The other steps of a planet turn with it, by some of its own teeth more. Return all angles, and by what part of
        a tooth the worst mesh of two gears that have an angle already fails to touch.
        """
        angles, worst = dict(angles), 0.0
        for _ in self.rows:
            for mesh in self.rows:
                first, mate = (self.parts[name] for name in mesh.gears)
                if first not in angles and mate in angles and not self.gears[mate].ring:
                    first, mate = mate, first
                if first not in angles:
                    continue
                args = self.gears[first], angles[first], self.centre(first, turn), self.gears[mate]
                found, pitch = touched(*args, self.centre(mate, turn), self.side(mesh)), self.gears[mate].pitch
                if mate in angles:
                    worst = max(worst, abs(near(found, angles[mate], pitch) - angles[mate]) / pitch)
                    continue
                angles[mate] = found
                for step in self.epicyclic.planets:
                    if mate in self.epicyclic.planets and self.epicyclic.body(step) == self.epicyclic.body(mate):
                        angles.setdefault(step, found + other * pitch)
        return angles, worst

    def progress(self, mesh, turn, angles):
        """Return how far the flank that bears has gone past the pitch point [cycles]."""
        own, mate = (self.parts[name] for name in mesh.gears)
        gear, other, between = self.gears[own], self.gears[mate], self.towards(own, mate, turn)
        working = abs(between) * gear.teeth / abs(other.teeth + (-gear.teeth if other.ring else gear.teeth))
        flank = angles[own] + self.side(mesh) * gear.half(working)
        return self.sense(mesh, 0) * (flank - cmath.phase(between)) / gear.pitch

    def towards(self, own, mate, turn):
        """Return the direction from a gear's axis to its pitch point with a mate."""
        between = self.centre(mate, turn) - self.centre(own, turn)
        return -between if self.gears[mate].ring else between


def by_brute_force(sizing, flow):
    """Return mesh row -> its phases in every set, ahead of the first mesh of its module [cycles], and the worst gap.

    A body goes in by each of its teeth until all of its steps fit: tried, not reckoned.
    """
    train = Train(sizing, flow)
    start, worst = train.put_in(1.0, {train.parts[train.rows[0].gears[0]]: 0.3})
    phases = {mesh.name: [] for mesh in train.rows}
    standing = {own: angle for own, angle in start.items() if own not in train.epicyclic.planets}
    tries = range(max(gear.teeth for own, gear in train.gears.items() if own in train.epicyclic.planets))
    for number in range(train.epicyclic.sets):
        turn = cmath.rect(1.0, 2.0 * math.pi * number / train.epicyclic.sets)
        stepped = len(train.pins) < len(train.epicyclic.planets) and number > 0
        angles, gap = min((train.put_in(turn, standing, k) for k in (tries if stepped else (0,))), key=lambda it: it[1])
        worst = max(worst, gap)
        for mesh in train.rows:
            phases[mesh.name].append(train.progress(mesh, turn, angles))
    firsts = {}
    for mesh in train.rows:
        firsts.setdefault(mesh.group, phases[mesh.name][0])
    return {mesh.name: [phase - firsts[mesh.group] for phase in phases[mesh.name]] for mesh in train.rows}, worst


def agree(sizing, flow, stage):
    """Hold every phase against that of teeth that touch; gears of all sets touch at once."""
    found, gap = by_brute_force(sizing, flow)
    assert gap < TOUCH
    for name, phases in compound_phases(sizing, flow, stage).items():
        for wanted, phase in zip(found[name], phases, strict=True):
            assert abs((phase - wanted + 0.5) % 1.0 - 0.5) < TOUCH, name


def ravigneaux(teeth):
    """Return the shipped automatic with other teeth."""
    names = ("suns.small", "suns.large", "rings.ring", "planets.short", "planets.long")
    keys = {f"epicyclics.gear.{name}.teeth": count for name, count in zip(names, teeth, strict=True)}
    return edited(read(shipped_design("ravigneaux-automatic")), keys)


@pytest.mark.parametrize("teeth", [(45, 54, 108, 27, 27), (28, 41, 79, 18, 19), (25, 44, 82, 18, 19)])
@pytest.mark.parametrize("case", ["first", "second", "fourth", "reverse"])
def test_phases_of_meshed_planets_are_those_of_teeth_that_touch(teeth, case):
    """Small sun, short and long planet, large sun, ring: every mesh of every set, in gears that turn either way."""
    sizing = size(ravigneaux(teeth))
    agree(sizing, sizing.flows[case], "gear")


@pytest.mark.parametrize("teeth", [(12, 84, 81, 36, 33), (13, 83, 79, 35, 31), (14, 82, 79, 34, 31)])
def test_phases_of_stepped_planets_are_those_of_teeth_that_touch(teeth):
    """Sun, held ring and turned ring of a Wolfrom set: the steps of a body go in together, by some tooth."""
    names = ("suns.sun", "rings.held", "rings.turned", "planets.wide", "planets.narrow")
    keys = {f"epicyclics.wolfrom.{name}.teeth": count for name, count in zip(names, teeth, strict=True)}
    free = parse(shipped_design("wolfrom-reducer").read_text(encoding="utf-8").replace("speed_rpm = 20\n", ""))
    sizing = size(edited(free, keys))
    agree(sizing, sizing.reference, "wolfrom")


@pytest.mark.parametrize(
    "keys",
    [
        {"planets.short.shift": 0.13},
        {"planets.long.teeth": 26},
        {"planets.long.shift": -0.2, "suns.large.shift": 0.35},
        {"suns.large.module_mm": 2.3, "planets.long.centre_distance_mm": 93.5},
    ],
)
@pytest.mark.parametrize("case", ["second", "reverse"])
def test_phases_of_shifted_planets_are_those_of_teeth_that_touch(keys, case):
    """Pins, working pitch points and thick teeth move with the shifts; the flanks that bear touch all the same."""
    design = read(shipped_design("ravigneaux-automatic"))
    sizing = size(edited(design, {f"epicyclics.gear.{key}": value for key, value in keys.items()}))
    assert any(gear.profile_shift for gear in sizing.gears)
    agree(sizing, sizing.flows[case], "gear")


def test_a_touch_that_is_half_a_tooth_off_is_seen():
    """The test can fail: with the other flanks bearing, half a cycle is gained where a planet is driven and drives."""
    sizing = size(ravigneaux((45, 54, 108, 27, 27)))
    flow = sizing.flows["second"]
    found, _ = by_brute_force(sizing, flow)
    phases = compound_phases(sizing, flow, "gear")
    assert abs((phases["gear.large-long"][0] - found["gear.long-ring"][0] + 0.5) % 1.0 - 0.5) > 0.4
