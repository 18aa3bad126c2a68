"""Measured efficiency of a helicopter's main transmission, held against the losses of its teeth.

The planetary set is that of Lin and Parker's model of it: pitch circles of 77.42, 100.35 and 275.03 mm, 24.6° between
sun and planets, a common base circle of the planets with the ring, and 27, 35 and 99 teeth, of which the pitch circles
have two modules. The bevel pair has 19 and 71 teeth; its module, its spiral and all face widths are assumed.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from gearwright.parts.losses import (
    OIL_DENSITY,
    MeshDuty,
    MeshLaw,
    OilState,
    ToothContact,
    mesh_loss_part,
    oil_viscosity,
    tooth_contact,
)
from gearwright.units import RPM
from gearwright.validate.case import Case

_OH58 = (
    "Coy, Mitchell and Hamrock, 11 lubricants in the OH-58A main transmission (abstract, doi 10.1002/jsl.3000040105)"
)
_POWER, _INPUT = 224e3, 6060.0 * RPM
_TEMPERATURES = (355.0, 372.0)
"""Of the oil into the transmission [K]."""
_SUN_MODULE, _RING_MODULE = 77.42e-3 / 27.0, 275.03e-3 / 99.0
_SUN_ANGLE = math.radians(24.6)
_RING_ANGLE = math.acos(_SUN_MODULE * math.cos(_SUN_ANGLE) / _RING_MODULE)
"""Of one base circle of the planets [rad]: 20.2°."""
_WIDTH, _BEVEL_WIDTH = 30e-3, 35e-3
_BEVEL_MODULE, _SPIRAL = 3.9e-3, math.radians(30.0)
_ROUGHNESS = 0.4e-6
_STAGE = (
    "Experimental and analytical evaluation of efficiency of helicopter planetary stage, NASA Lewis, November 1990"
    " (abstract, DTIC ADA231724)"
)
_EXTREMES = (
    "124 conditions from 98.64 to 99.83 %; which stage is not told, that of the OH-58A is assumed, at 224 kW; planet"
    " bearings, windage and trapped oil are not in it"
)
_RANGE = "the eleven lubricants lie 0.25 % to both sides; widths and bevel module are assumed; bearings are not in it"


def _part(contact: ToothContact, torque: float, turning: float, *, width: float, oil: OilState, law: MeshLaw) -> float:
    """Return the part of its power that a mesh loses, from torque and speed of its first gear."""
    radius = contact.radii[0]
    load = torque / radius / math.cos(contact.pressure_angle) / width
    return mesh_loss_part(contact, MeshDuty(load, width, turning * radius), oil, law=law)


def _efficiency(law: MeshLaw, temperature: float) -> float:
    """Return the efficiency of the teeth of both stages."""
    oil = OilState(oil_viscosity(temperature) * OIL_DENSITY, OIL_DENSITY, _ROUGHNESS)
    bevel = tooth_contact((19, 71), _BEVEL_MODULE, pressure_angle=math.radians(20.0), helix_angle=_SPIRAL)
    first = _part(bevel, _POWER / _INPUT, _INPUT, width=_BEVEL_WIDTH, oil=oil, law=law)
    return 1.0 - first - _planetary_loss(law, oil)


def _planetary_loss(law: MeshLaw, oil: OilState) -> float:
    """Return the part of its power that the planetary set loses in its teeth."""
    sun = tooth_contact((27, 35), _SUN_MODULE, pressure_angle=_SUN_ANGLE)
    ring = tooth_contact((35, -99), _RING_MODULE, pressure_angle=_RING_ANGLE)
    turning = _INPUT * 19.0 / 71.0
    rolling, torque = turning * 99.0 / 126.0, _POWER / turning / 3.0
    second = _part(sun, torque, rolling, width=_WIDTH, oil=oil, law=law)
    third = _part(ring, torque * 35.0 / 27.0, rolling * 27.0 / 35.0, width=_WIDTH, oil=oil, law=law)
    return (second + third) * rolling / turning


def _stage(law: MeshLaw) -> Callable[[], list[float]]:
    return lambda: [
        1.0 - _planetary_loss(law, OilState(oil_viscosity(temperature) * OIL_DENSITY, OIL_DENSITY, _ROUGHNESS))
        for temperature in _TEMPERATURES
    ]


def _both(law: MeshLaw) -> Callable[[], list[float]]:
    return lambda: [_efficiency(law, temperature) for temperature in _TEMPERATURES]


CASES = tuple(
    Case(f"OH-58A, 224 kW, oil of 355 and 372 K: efficiency by {name}", _OH58, "", (0.9855, 0.9855), _both(law), 2.5e-3,
         _RANGE, is_relative=False)
    for name, law in (("Schlenk", MeshLaw.SCHLENK), ("Niemann and Winter", MeshLaw.NIEMANN_WINTER),
                      ("Anderson and Loewenthal", MeshLaw.ANDERSON_LOEWENTHAL))
) + tuple(
    Case(f"helicopter planetary stage, oil of 355 and 372 K: efficiency of the teeth by {name}", _STAGE, "",
         (0.99235, 0.99235), _stage(law), 5.95e-3, _EXTREMES, is_relative=False)
    for name, law in (("Schlenk", MeshLaw.SCHLENK), ("Niemann and Winter", MeshLaw.NIEMANN_WINTER),
                      ("Anderson and Loewenthal", MeshLaw.ANDERSON_LOEWENTHAL))
)  # fmt: skip
"""Measured losses."""
