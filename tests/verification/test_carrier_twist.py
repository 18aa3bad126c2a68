"""Lag of a carrier's free plate: the closed form against frames of Timoshenko beams in space, and its limits.

The frame knows nothing of the closed form: two rings of beams along the true circle, bridges between them, forces on
the free ring half-way between bridges, the other ring held where bridges stand on it.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from gearwright.parts.carriers import (
    ROUND_SHEAR,
    SHEAR,
    Asked,
    Elastic,
    Frame,
    Window,
    cantilever_tilt,
    lag_tilt,
    plate_band,
    plate_lag,
    plate_stiffness,
    stiff_frame,
    torsion_section,
)

STEEL = Elastic(206e9, 79.2e9)
RIGID = 1e4
"""Stiffness of what is taken as rigid over that of its neighbours [-]."""
PIECES = 12
"""Beams of a ring from bridge to bridge, and of a bridge [-]."""


def beam(ends, up, section, moduli):
    """Return the stiffness of a beam in space, its local y along `up`; section: area, I_y, I_z, J."""
    along = ends[1] - ends[0]
    length = float(np.linalg.norm(along))
    along = along / length
    second = up - (up @ along) * along
    second = second / np.linalg.norm(second)
    turn = np.array([along, second, np.cross(along, second)])
    area, i_y, i_z, j = section
    stiff = np.zeros((12, 12))
    for k, value in ((0, moduli.young * area / length), (3, moduli.shear * j / length)):
        stiff[np.ix_([k, k + 6], [k, k + 6])] += value * np.array([[1, -1], [-1, 1]])
    for place, inertia, sign in (((1, 5, 7, 11), i_z, 1.0), ((2, 4, 8, 10), i_y, -1.0)):
        phi = 12.0 * moduli.young * inertia / (SHEAR * moduli.shear * area * length**2)
        c = moduli.young * inertia / (length**3 * (1.0 + phi))
        a, b, d = 6.0 * length * sign, (4.0 + phi) * length**2, (2.0 - phi) * length**2
        stiff[np.ix_(place, place)] += c * np.array(
            [[12, a, -12, a], [a, b, -a, d], [-12, -a, 12, -a], [a, d, -a, b]]
        )  # fmt: skip
    whole = np.kron(np.eye(4), turn)
    return whole.T @ stiff @ whole


def frame_lag(force, frame, moduli):
    """Return the lag of the free plate on the circle of pins [m], by a frame of beams."""
    count, steps = frame.planets, frame.planets * PIECES
    angles = 2.0 * math.pi * np.arange(steps) / steps
    ring = np.array([[frame.radius * math.cos(a), frame.radius * math.sin(a), 0.0] for a in angles])
    far = ring + np.array([0.0, 0.0, frame.length])
    nodes = [*ring, *far]
    t, c = frame.plate, frame.band
    plate = np.array([c * t, c * t**3 / 12.0, t * c**3 / 12.0, float(torsion_section(c, t))])  # y away from the axis
    w, h = frame.width, frame.depth
    bridge = np.array([w * h, h * w**3 / 12.0, w * h**3 / 12.0, float(torsion_section(w, h))])
    beams = []
    half = math.asin(frame.width / 2.0 / frame.radius)
    for base in (0, steps):
        for k in range(steps):
            one, other = base + k, base + (k + 1) % steps
            middle = (angles[k] + math.pi / steps) % (2.0 * math.pi / count)
            inside = min(middle, 2.0 * math.pi / count - middle) < half
            up = (nodes[one] + nodes[other]) * np.array([0.5, 0.5, 0.0])
            beams.append((one, other, up, (RIGID if inside else 1.0) * plate))
    for k in range(count):
        foot = k * PIECES
        places = [foot]
        for part in range(1, PIECES):
            nodes.append(nodes[foot] + np.array([0.0, 0.0, frame.length * part / PIECES]))
            places.append(len(nodes) - 1)
        places.append(steps + foot)
        beams += [(one, other, nodes[foot], bridge) for one, other in pairwise(places)]
    stiff = np.zeros((6 * len(nodes), 6 * len(nodes)))
    for one, other, up, section in beams:
        rows = [*range(6 * one, 6 * one + 6), *range(6 * other, 6 * other + 6)]
        stiff[np.ix_(rows, rows)] += beam((nodes[one], nodes[other]), up, section, moduli)
    loads = np.zeros(len(stiff))
    for k in range(count):
        node = steps + k * PIECES + PIECES // 2
        angle = angles[node - steps]
        push = force / 2.0 * frame.pins / frame.radius
        loads[6 * node : 6 * node + 2] = push * np.array([-math.sin(angle), math.cos(angle)])
    held = {6 * k * PIECES + axis for k in range(count) for axis in range(3)}
    free = [k for k in range(len(stiff)) if k not in held]
    moved = np.zeros(len(stiff))
    moved[free] = np.linalg.solve(stiff[np.ix_(free, free)], loads[free])
    return moved[6 * steps + 1] * frame.pins / frame.radius  # of the bridge at angle 0, around the axis


FRAMES = {
    "fan drive, five thin bridges": Frame(5, 0.2, 0.09, 0.028, 0.11, 0.17, 0.012, 0.10),
    "aircraft, three bridges": Frame(3, 0.12, 0.045, 0.04, 0.05, 0.075, 0.008, 0.055),
    "wind, four bridges far out": Frame(4, 0.725, 0.52, 0.33, 0.27, 0.93, 0.20, 0.40),
    "wind, three bridges far out": Frame(3, 0.526, 0.39, 0.30, 0.2, 0.60, 0.12, 0.25),
}


@pytest.mark.parametrize("name", FRAMES)
def test_the_free_plate_lags_as_in_a_frame_of_beams(name):
    """Plates as straight beams, and no play of in-plane bending: within 15 % of a ring along the true circle."""
    frame = FRAMES[name]
    assert float(plate_lag(1e5, frame, STEEL)) == pytest.approx(frame_lag(1e5, frame, STEEL), rel=0.15)


@pytest.mark.parametrize(("count", "plate"), [(3, 0.012), (4, 0.03), (5, 0.012)])
def test_a_plate_turns_under_moments_as_a_ring_of_beams(count, plate):
    """A moment about the radius at each place, which does not move: a ring along the true circle is up to 20 % stiffer.

    Straight beams from place to place are the softer for that, the fewer there are.
    """
    radius, band, steps = 0.15, 0.05, count * PIECES
    angles = 2.0 * math.pi * np.arange(steps) / steps
    nodes = np.array([[radius * math.cos(a), radius * math.sin(a), 0.0] for a in angles])
    section = (band * plate, band * plate**3 / 12.0, plate * band**3 / 12.0, float(torsion_section(band, plate)))
    stiff = np.zeros((6 * steps, 6 * steps))
    for one in range(steps):
        other = (one + 1) % steps
        rows = [*range(6 * one, 6 * one + 6), *range(6 * other, 6 * other + 6)]
        stiff[np.ix_(rows, rows)] += beam((nodes[one], nodes[other]), nodes[one] + nodes[other], section, STEEL)
    loads, held = np.zeros(6 * steps), set()
    for k in range(0, steps, PIECES):
        loads[6 * k + 3 : 6 * k + 5] = math.cos(angles[k]), math.sin(angles[k])
        held |= {6 * k + axis for axis in range(3)}
    free = [k for k in range(6 * steps) if k not in held]
    turned = np.zeros(6 * steps)
    turned[free] = np.linalg.solve(stiff[np.ix_(free, free)], loads[free])
    found = float(plate_stiffness(count, radius, 0.0, plate=plate, band=band, moduli=STEEL))
    assert 0.8 < found * turned[3] < 1.02


def test_between_rigid_plates_only_bridges_bend_shear_and_twist():
    """12 E I/L³ and κ G A/L in series, G J/L beside them: 30 × 60 mm, 100 mm long, four on the circle of pins.

    J = 0.2287 h w³ for sides as 1 and 2 (Saint-Venant).
    """
    frame = Frame(4, 0.1, 0.1, 0.03, 0.06, 0.1, 100.0, 1.0)
    bent = 0.1**3 / (12.0 * 206e9 * 0.06 * 0.03**3 / 12.0)
    sheared = 0.1 / (5.0 / 6.0 * 79.2e9 * 0.06 * 0.03)
    twisted = 79.2e9 * 0.2287 * 0.06 * 0.03**3 / 0.1
    stiffness = 1.0 / (bent + sheared) + twisted / 0.1**2
    assert float(plate_lag(2e4, frame, STEEL)) == pytest.approx(1e4 / stiffness, rel=2e-3)


def test_the_frame_of_beams_bends_as_one_beam_does():
    """A cantilever of one beam in space: F L³/(3 E I) + F L/(κ G A)."""
    section, length = (2e-3, 3e-7, 5e-7, 4e-7), 0.7
    stiff = beam((np.zeros(3), np.array([0.0, 0.0, length])), np.array([1.0, 0.0, 0.0]), section, STEEL)[6:, 6:]
    moved = np.linalg.solve(stiff, [1e3, 0.0, 0.0, 0.0, 0.0, 0.0])
    expected = 1e3 * (length**3 / (3.0 * STEEL.young * 5e-7) + length / (SHEAR * STEEL.shear * 2e-3))
    assert moved[0] == pytest.approx(expected, rel=1e-9)


def test_a_planet_on_a_cantilever_pin_leans_by_the_deflection_of_its_end_over_its_width():
    """Integrated numerically: w″ = M/(E I) with M = q (b − x)²/2, and shear q (b − x)/(κ G A)."""
    force, b, d, bore = 3e4, 0.06, 0.04, 0.02
    inertia, area = math.pi / 64.0 * (d**4 - bore**4), math.pi / 4.0 * (d**2 - bore**2)
    x = np.linspace(0.0, b, 4001)
    bend, shear = force / b * (b - x) ** 2 / 2.0 / (STEEL.young * inertia), force / b * (b - x)
    slope = np.concatenate([[0.0], np.cumsum((bend[1:] + bend[:-1]) / 2.0 * np.diff(x))])
    slope = slope + shear / (ROUND_SHEAR * STEEL.shear * area)
    mean = float(np.sum((slope[1:] + slope[:-1]) / 2.0 * np.diff(x)) / b)
    assert cantilever_tilt(force, b, d, STEEL, bore=bore) == pytest.approx(mean, rel=1e-5)


def test_torsion_constants_of_rectangles_are_saint_venant_s():
    """Sides as 1 and 2: 0.2287 a³ b in the smaller; thin: a b³/3."""
    assert float(torsion_section(2.0, 1.0)) == pytest.approx(0.2287 * 2.0, rel=0.01)
    assert float(torsion_section(1.0, 1.0)) == pytest.approx(0.1406, rel=0.01)
    assert float(torsion_section(1e3, 1.0)) == pytest.approx(1e3 / 3.0, rel=1e-3)


WIND = Window(4, 0.725, 0.451, 0.32, 1.13, 0.52)
ASKED = Asked(1.361e6, 140e-6, (0.065, 0.065), 0.88, 300e6, 0.6)


def test_plates_and_bridges_are_the_least_that_keep_planets_straight():
    found = stiff_frame(WIND, ASKED, STEEL)
    assert found.tilt <= ASKED.tilt * 1.001
    frame = Frame(4, 0.725, 0.52, found.width, found.depth, found.radius, found.plates[1], plate_band(found.reach, 0.6))
    thinner = frame._replace(plate=0.97 * found.plates[1])
    assert float(lag_tilt(plate_lag(ASKED.force, frame, STEEL), 0.52, found.plates[1])) == pytest.approx(found.tilt)
    assert float(lag_tilt(plate_lag(ASKED.force, thinner, STEEL), 0.52, thinner.plate)) > ASKED.tilt


@pytest.mark.parametrize("tilt", [70e-6, 280e-6, 1.0])
def test_a_stiffer_carrier_weighs_more(tilt):
    one, other = (stiff_frame(WIND, ASKED._replace(tilt=asked), STEEL) for asked in (tilt, 1.2 * tilt))
    assert one.volume >= other.volume and (tilt == 1.0 or one.volume > other.volume)


def test_bridges_stand_clear_of_planets_and_within_sun_and_ring():
    found = stiff_frame(WIND, ASKED, STEEL)
    x = np.linspace(found.radius - found.depth / 2.0, found.radius + found.depth / 2.0, 101)
    angle = math.pi / WIND.planets
    away = np.hypot(x - WIND.pins * math.cos(angle), WIND.pins * math.sin(angle) - found.width / 2.0)
    assert away.min() >= WIND.tip * (1.0 - 1e-9)
    assert math.hypot(x[-1], found.width / 2.0) <= found.reach * (1.0 + 1e-9) <= WIND.outer * (1.0 + 2e-9)
    assert x[0] >= WIND.inner


def test_where_only_strength_asks_plates_are_as_thick_as_it_asks():
    found = stiff_frame(WIND, ASKED._replace(tilt=1.0), STEEL)
    assert found is not None and found.plates == pytest.approx(ASKED.plates)


def test_planets_that_leave_no_room_leave_no_bridges():
    assert stiff_frame(WIND._replace(tip=0.6, outer=0.75), ASKED, STEEL).width == 0.0
