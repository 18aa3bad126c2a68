"""Bending shafts against closed forms."""

import math

import numpy as np
import pytest

from gearwright.dynamics import Model, campbell, modes, statics
from gearwright.dynamics.beam import Segment, bending_shaft


def simply_supported(count: int, part: Segment, speed: float = 0.0):
    """Return a shaft of `count` equal segments that is held across at both ends, and along and in twist at one."""
    model = Model()
    stations = bending_shaft(model, "shaft", [part] * count, speed=speed)
    for station in (stations[0], stations[-1]):
        for direction in ("x", "y"):
            model.support(f"{station} {direction} bearing", f"{station} {direction}", stiffness=1e13)
    model.support("thrust", f"{stations[0]} z", stiffness=1e10)
    if not speed:
        model.support("anchor", f"{stations[0]} twist", stiffness=1e8)
    return model


def timoshenko_frequency(part: Segment, length: float, number: int) -> float:
    """Return a natural frequency of a simply supported Timoshenko beam [Hz]: the lower root of its exact quartic.

    Source: Timoshenko 1921, Phil. Mag. 41, 744: with rotary inertia and shear, sin nπx/L satisfies all conditions.
    """
    wave = number * math.pi / length
    bending, section = part.elasticity * part.second_moment, part.density * part.area
    shear = part.shear_coefficient * part.area * part.shear_modulus
    rotary = part.density * part.second_moment
    a = section * rotary / shear
    b = -(section + wave**2 * (rotary + section * bending / shear))
    return math.sqrt((-b - math.sqrt(b * b - 4.0 * a * bending * wave**4)) / (2.0 * a)) / (2.0 * math.pi)


def test_a_stocky_simply_supported_shaft_has_timoshenkos_frequencies():
    """Length five diameters, 40 segments of lumped mass: first three within 0.2 %."""
    count, length = 40, 0.25
    part = Segment(length / count, 0.05)
    found = modes(simply_supported(count, part).build())
    bending = [f for f, many in found.groups() if many == 2]
    wanted = [timoshenko_frequency(part, length, number) for number in (1, 2, 3)]
    assert bending[:3] == pytest.approx(wanted, rel=2e-3)


def test_frequencies_converge_with_the_square_of_the_segment_length():
    """Lumped masses: error falls by about four with each halving."""
    wanted = timoshenko_frequency(Segment(0.25, 0.05), 0.25, 1)
    errors = []
    for count in (5, 10, 20):
        found = modes(simply_supported(count, Segment(0.25 / count, 0.05)).build())
        errors.append(abs(next(f for f, many in found.groups() if many == 2) - wanted))
    assert 3.0 < errors[0] / errors[1] < 5.0
    assert 3.0 < errors[1] / errors[2] < 5.0


def test_a_cantilever_bends_and_shears_exactly_under_a_tip_force():
    """w = F L³/(3 E I) + F L/(κ G A), to rounding, with any number of segments."""
    part = Segment(0.1, 0.03, bore=0.01)
    model = Model()
    stations = bending_shaft(model, "arm", [part] * 3)
    for direction in ("x", "y", "z", "tilt x", "tilt y", "twist"):
        model.support(f"wall {direction}", f"{stations[0]} {direction}", stiffness=1e16)
    model.load(f"{stations[-1]} y", constant=1000.0)
    system = model.build()
    place = system.labels.coordinates.index(f"{stations[-1]} y")
    bending = 1000.0 * 0.3**3 / (3.0 * part.elasticity * part.second_moment)
    shear = 1000.0 * 0.3 / (part.shear_coefficient * part.area * part.shear_modulus)
    # The wall of 1e16 N m/rad gives way by 3e-14 rad.
    assert statics(system).position[place] == pytest.approx(bending + shear, rel=1e-8)


def test_a_spinning_shaft_splits_into_backward_and_forward_whirl():
    """Forward and backward whirl of the first bending pair, from the exact quartic with its gyroscopic term.

    Lumped masses of 12 segments leave 0.02 %; the two lie 9 % apart.
    """
    count, length, speed = 12, 0.25, 20000.0
    part = Segment(length / count, 0.05)
    diagram = campbell(simply_supported(count, part, speed).build(), np.linspace(0.0, 1.0, 5))
    backward, forward = sorted(diagram.frequency[-1, np.argsort(diagram.frequency[0])[:2]])
    assert [backward, forward] == pytest.approx(whirl(part, length, speed), rel=1e-3)
    assert diagram.frequency[0, 0] == pytest.approx(diagram.frequency[0, 1], rel=1e-6)


def whirl(part: Segment, length: float, speed: float) -> list[float]:
    """Return backward and forward whirl of the first bending mode [Hz], from the two-variable problem of one wave.

    With w = W sin kx e^(iωt) and tilt Ψ cos kx e^(iωt), both complex across the planes, the equations give
    (κGA k² − ρA ω²)(κGA + E I k² − ρI ω² + 2 ρI Ω ω) = (κGA k)².
    """
    wave = math.pi / length
    shear = part.shear_coefficient * part.area * part.shear_modulus
    section, rotary = part.density * part.area, part.density * part.second_moment
    bending = part.elasticity * part.second_moment
    first = np.poly1d([-section, 0.0, shear * wave**2])
    second = np.poly1d([-rotary, 2.0 * rotary * speed, shear + bending * wave**2])
    roots = np.sort(np.abs((first * second - shear**2 * wave**2).roots.real))
    return sorted(roots[:2] / (2.0 * math.pi))
