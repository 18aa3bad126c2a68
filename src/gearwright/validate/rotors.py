"""Printed whirl speeds of rotors in bearings: Friswell, Penny, Garvey & Lees, and lumped stations of another code."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from gearwright.dynamics import Campbell, Model, campbell
from gearwright.dynamics.model import Bearing, Disc, Placed, Rotor, Segment, add_bearing, add_rotor
from gearwright.units import RPM
from gearwright.validate.case import Case

_BOOK = "Friswell, Penny, Garvey & Lees 2010, Dynamics of Rotating Machines, example {} (read in ROSS's tests)"
_STEEL = (211e9, 81.2e9, 7810.0)
"""E, G [Pa] and density [kg/m³] of the book's shafts."""
SMALL = Disc.of_steel(0.07, 0.28, bore=0.05, density=7810.0)
LARGE = Disc.of_steel(0.07, 0.35, bore=0.05, density=7810.0)
SPEED = 4000.0 * RPM
STATIONS = ((1.91697, 0.00059905, 0.010284), (3.83395, 0.0011981, 0.020568), (36.4237, 0.33076, 0.19866))
"""Mass, polar and diametral inertia of the first three stations of a transfer-matrix code [kg, kg m²]."""


def shaft(*, weightless: bool = False, parts: int = 1) -> list[Segment]:
    """Return the book's shaft: 1.5 m of 50 mm in six lengths.

    Args:
        weightless: True: its mass is left to its stations.
        parts: Segments of each length.
    """
    elasticity, shear, density = _STEEL
    poisson = elasticity / (2.0 * shear) - 1.0
    part = Segment(0.25 / parts, 0.05, elasticity=elasticity, poisson=poisson, density=density)
    if weightless:
        part = Segment(0.25 / parts, 0.05, elasticity=elasticity, poisson=poisson, density=1e-6 * density)
    return [part] * (6 * parts)


def in_bearings(rotor: Rotor, bearings: Mapping[int, Bearing], speed: float) -> tuple[Model, Placed]:
    """Return a rotor in bearings, held along its axis at one of them.

    Args:
        rotor: Shaft and discs.
        bearings: Station -> what sits there.
        speed: [rad/s].
    """
    model = Model()
    placed = add_rotor(model, "rotor", rotor, speed=speed)
    for station, bearing in bearings.items():
        add_bearing(model, f"bearing {station}", placed.at(station), bearing)
    return model, placed


def bending(rotor: Rotor, bearings: Mapping[int, Bearing], speed: float) -> tuple[Campbell, np.ndarray]:
    """Return a diagram that ends at a speed, and which of its modes bend the shaft, by frequency.

    Args:
        rotor: Shaft and discs.
        bearings: Station -> what sits there.
        speed: [rad/s]; 0 means next to none.
    """
    model, _ = in_bearings(rotor, bearings, speed or 1e-6)
    diagram = campbell(model.build(), [0.999, 1.0])
    twisting = _torsional(rotor)
    order = np.argsort(diagram.frequency[-1])
    far = [min(abs(diagram.frequency[-1, place] / other - 1.0) for other in twisting) > 1e-6 for place in order]
    return diagram, order[np.array(far)]


def _torsional(rotor: Rotor) -> list[float]:
    """Return the frequencies of torsion and of axial motion, which bearings do not hold [Hz]."""
    model = Model()
    add_rotor(model, "rotor", rotor)
    found = model.build()
    count = len(rotor.segments)
    names = [f"rotor torsion {number}" for number in range(1, count + 1)]
    names += [f"rotor axial {number}" for number in range(2, count + 2)]
    mass = dict(zip(found.labels.coordinates, found.arrays.mass.tolist(), strict=True))
    stiffness = dict(zip(found.labels.lines, found.arrays.stiffness.tolist(), strict=True))
    return [math.sqrt(stiffness[f"{name} elastic"] / mass[name]) / (2.0 * math.pi) for name in names]


def whirl(bearing: Bearing, speed: float, count: int, *, overhung: bool = False, unit: float = 1.0) -> Sequence[float]:
    """Return natural frequencies |λ| of the book's rotor in two equal bearings [rad/s], or in another unit.

    Args:
        bearing: Both.
        speed: [rad/s].
        count: How many.
        overhung: True: one large disc at the end, the second bearing at two thirds.
        unit: [rad/s].
    """
    rotor = Rotor(shaft(), {6: LARGE} if overhung else {2: SMALL, 4: LARGE})
    diagram, order = bending(rotor, {0: bearing, 4 if overhung else 6: bearing}, speed)
    chosen = order[:count]
    damped = 2.0 * math.pi * diagram.frequency[-1, chosen] / np.sqrt(1.0 - diagram.damping[-1, chosen] ** 2)
    return [float(value) / unit for value in np.sort(damped)]


def lumped(count: int) -> Sequence[float]:
    """Return whirl speeds of the stations of a transfer-matrix code at 500 rpm [Hz].

    Args:
        count: How many.
    """
    first, second, loaded = (Disc(mass, across, polar) for mass, polar, across in STATIONS)
    stations = {0: first, 1: second, 2: loaded, 3: second, 4: loaded, 5: second, 6: first}
    rotor, bearing = Rotor(shaft(weightless=True), stations), Bearing((1e6, 0.8e6))
    diagram, order = bending(rotor, {0: bearing, 6: bearing}, 500.0 * RPM)
    return [float(value) for value in diagram.frequency[-1, order[:count]]]


_ISOTROPIC, _STIFF = Bearing((1e6, 1e6)), Bearing((10e6, 10e6))
_OBLONG, _FLAT = Bearing((1e6, 0.8e6)), Bearing((1e6, 0.2e6))
_DAMPED = Bearing((1e6, 1e6), damping=(3e3, 3e3))
_HERTZ = 2.0 * math.pi


def _case(
    name: str, example: str, printed: tuple[float, ...], bearing: Bearing, speed: float, *, overhung: bool = False,
    unit: float = 1.0,
) -> Case:  # fmt: skip
    compute = partial(whirl, bearing, speed, len(printed), overhung=overhung, unit=unit)
    words = "rad/s" if unit == 1.0 else "Hz"
    return Case(f"rotor, {name}", _BOOK.format(example), words, printed, compute, 6e-4, "two decimals; six elements")


CASES = (
    _case("isotropic bearings at rest", "5.9.1", (86.66, 86.66, 274.31, 274.31, 716.78, 716.78), _ISOTROPIC, 0.0),
    _case("isotropic bearings at 4000 rpm", "5.9.1", (85.39, 87.80, 251.78, 294.71, 600.18), _ISOTROPIC, SPEED),
    _case("bearings of unequal stiffness at rest", "5.9.2", (82.65, 86.66, 254.52, 274.31, 679.49), _OBLONG, 0.0),
    _case("bearings of unequal stiffness at 4000 rpm", "5.9.2", (82.33, 86.86, 239.64, 287.25, 583.49), _OBLONG, SPEED),
    _case("mixed modes at 4000 rpm", "5.9.3", (8.545, 13.77, 22.35, 44.06, 78.76), _FLAT, SPEED, unit=_HERTZ),
    _case("damped bearings at rest", "5.9.5", (13.91, 13.91, 48.18, 48.18, 137.06, 137.06), _DAMPED, 0.0, unit=_HERTZ),
    _case("damped bearings at 4000 rpm", "5.9.5", (13.70, 14.09, 43.61, 52.18), _DAMPED, SPEED, unit=_HERTZ),
    _case("overhung disc at rest", "5.9.9", (90.14, 90.14, 630.73, 630.73, 830.43, 830.43), _STIFF, 0.0, overhung=True),
    _case("overhung disc at 4000 rpm", "5.9.9", (76.19, 103.91, 565.99, 634.23), _STIFF, SPEED, overhung=True),
    Case("rotor of lumped stations at 500 rpm", "RAPPID, output printed in ROSS's page on validation", "Hz",
         (14.6152, 15.3284, 43.3459, 46.9251, 105.902, 112.760, 150.907, 155.810), partial(lumped, 8), 1e-3,
         "another transfer-matrix step; 0.08 % at the fourth pair"),
)  # fmt: skip
"""Published rotors."""
