"""Shafts in bending against the closed forms of Timoshenko's beam."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gearwright.dynamics import Model, System, campbell, modes, statics
from gearwright.dynamics.model import Segment, bending_shaft
from gearwright.validate.case import Case

LENGTH = 0.25
"""[m]; five diameters."""
DIAMETER = 0.05
"""[m]."""
COUNT = 40
"""Segments of the shaft at rest."""
SPUN = 16
"""Segments of the spinning one: its modes cost the cube of their number."""
SPIN = 20000.0
"""[rad/s], far above any shaft, so that the gyroscopic effect is large."""
TIP = 1000.0
"""Force on the cantilever [N]."""
_ARM = Segment(0.1, 0.03, bore=0.01)
_PART = Segment(LENGTH / COUNT, DIAMETER)


def simply_supported(count: int, part: Segment, speed: float = 0.0) -> System:
    """Return a shaft of equal segments that is held across at both ends, and along and in twist at one.

    Args:
        count: Number of segments [-].
        part: One of them.
        speed: Rotational speed [rad/s].
    """
    model = Model()
    stations = bending_shaft(model, "shaft", [part] * count, speed=speed)
    for station in (stations[0], stations[-1]):
        for direction in ("x", "y"):
            model.support(f"{station} {direction} bearing", f"{station} {direction}", stiffness=1e13)
    model.support("thrust", f"{stations[0]} z", stiffness=1e10)
    if not speed:
        model.support("anchor", f"{stations[0]} twist", stiffness=1e8)
    return model.build()


def timoshenko_frequency(part: Segment, length: float, number: int) -> float:
    """Return a natural frequency of a simply supported Timoshenko beam [Hz]: the lower root of its exact quartic.

    Args:
        part: Section and material.
        length: [m].
        number: Half waves [-].

    Source: Timoshenko 1921, Phil. Mag. 41, 744: with rotary inertia and shear, sin nπx/L satisfies all conditions.
    """
    wave = number * math.pi / length
    bending, section = part.elasticity * part.second_moment, part.density * part.area
    shear = part.shear_coefficient * part.area * part.shear_modulus
    rotary = part.density * part.second_moment
    a = section * rotary / shear
    b = -(section + wave**2 * (rotary + section * bending / shear))
    return math.sqrt((-b - math.sqrt(b * b - 4.0 * a * bending * wave**4)) / (2.0 * a)) / (2.0 * math.pi)


def whirl(part: Segment, length: float, speed: float) -> tuple[float, float]:
    """Return backward and forward whirl of the first bending mode [Hz], from the two-variable problem of one wave.

    With w = W sin kx e^(iωt) and tilt Ψ cos kx e^(iωt), both complex across the planes, the equations give
    (κGA k² − ρA ω²)(κGA + E I k² − ρI ω² + 2 ρI Ω ω) = (κGA k)².

    Args:
        part: Section and material.
        length: [m].
        speed: Ω [rad/s].

    Source: Timoshenko 1921 with the gyroscopic term.
    """
    wave = math.pi / length
    shear = part.shear_coefficient * part.area * part.shear_modulus
    section, rotary = part.density * part.area, part.density * part.second_moment
    bending = part.elasticity * part.second_moment
    first = np.poly1d([-section, 0.0, shear * wave**2])
    second = np.poly1d([-rotary, 2.0 * rotary * speed, shear + bending * wave**2])
    roots = np.sort(np.abs((first * second - shear**2 * wave**2).roots.real)) / (2.0 * math.pi)
    return float(roots[0]), float(roots[1])


def tip_deflection(part: Segment, length: float, force: float) -> float:
    """Return the deflection of a cantilever under a force at its tip, w = F L³/(3 E I) + F L/(κ G A) [m].

    Args:
        part: Section and material.
        length: [m].
        force: [N].

    Source: Timoshenko 1921.
    """
    bending = force * length**3 / (3.0 * part.elasticity * part.second_moment)
    return bending + force * length / (part.shear_coefficient * part.area * part.shear_modulus)


def _bending() -> Sequence[float]:
    beam = modes(simply_supported(COUNT, _PART))
    return [frequency for frequency, many in beam.groups() if many == 2][:3]


def _cantilever() -> Sequence[float]:
    model = Model()
    stations = bending_shaft(model, "arm", [_ARM] * 3)
    for direction in ("x", "y", "z", "tilt x", "tilt y", "twist"):
        model.support(f"wall {direction}", f"{stations[0]} {direction}", stiffness=1e16)
    model.load(f"{stations[-1]} y", constant=TIP)
    system = model.build()
    return [float(statics(system).position[system.labels.coordinates.index(f"{stations[-1]} y")])]


def _whirling() -> Sequence[float]:
    system = simply_supported(SPUN, Segment(LENGTH / SPUN, DIAMETER), SPIN)
    diagram = campbell(system, [float(factor) for factor in np.linspace(0.0, 1.0, 6)])
    first = np.argsort(diagram.frequency[0])[:2]
    return sorted(diagram.frequency[-1, first].tolist())


CASES = (
    Case("simply supported shaft, bending", "Timoshenko 1921, closed form", "Hz",
         tuple(timoshenko_frequency(_PART, LENGTH, number) for number in (1, 2, 3)), _bending, 2e-3,
         "the masses of 40 segments are lumped"),
    Case("cantilever, tip force", "Timoshenko 1921, closed form", "m", (tip_deflection(_ARM, 0.3, TIP),), _cantilever,
         1e-8, "a wall of 1e16 N m/rad gives way by 3e-14 rad"),
    Case("spinning shaft, backward and forward whirl", "Timoshenko 1921 with gyroscopic term", "Hz",
         whirl(_PART, LENGTH, SPIN), _whirling, 3e-4, "the masses of 16 segments are lumped"),
)  # fmt: skip
"""Closed forms of bending shafts."""
