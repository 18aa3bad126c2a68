"""Published tooth losses, measured efficiency and scuffing."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from gearwright.parts.iso6336 import MeshGeometry, ToothProportions
from gearwright.parts.losses import (
    OIL_DENSITY,
    Friction,
    MeshDuty,
    MeshLaw,
    OilState,
    ToothContact,
    mesh_friction,
    mesh_loss_part,
    ohlendorf_loss_factor,
    oil_viscosity,
    tooth_contact,
)
from gearwright.parts.scuffing import (
    FlashEdition,
    Oil,
    ScuffingMesh,
    flash_temperature,
    integral_temperature,
    lubricant_factor_scuffing,
)
from gearwright.units import RPM
from gearwright.validate.case import Case
from gearwright.validate.gears.ratings import PLANET_RING, SUN_PLANET, WIND

# ----------------------------------------------------------------------------------------------------------------------
# Printed losses of teeth: the planetary stage of `gear_reports`.
# ----------------------------------------------------------------------------------------------------------------------


_OIL = oil_viscosity(348.15, (220e-6, 19e-6)) * 890.0 * (1.0 - 7e-4 * 60.0)
"""η at 75 °C of an oil of 890 kg/m³ at 15 °C [Pa s]."""
_ROUGHNESS = (0.6e-6, 0.5 * (0.6e-6 + 1.05e-6))
_FORCE = 1.25 * 1.1 * 999_650.9 / 3.0
"""K_A K_γ times the sun's torque of a planet [N m]."""
_SPEED = 12.1 * RPM * 56.0 / 19.0 * 0.5 * 0.855
"""At the sun's reference circle, against the carrier [m/s]; the same at all reference circles."""
_PLANET_POWER, _POWER = 5000.0 * 56.0 / 75.0 / 3.0, 5000.0
"""Of the teeth of one planet, and of the stage [kW]."""


def _loss_factor(mesh: MeshGeometry) -> float:
    recess, approach = (float(ratio) for ratio in mesh.addendum_contact_ratios)
    return ohlendorf_loss_factor(_teeth(mesh), 0.0, approach=approach, recess=recess)


def _teeth(mesh: MeshGeometry) -> tuple[float, float]:
    return float(mesh.teeth[0]), float(mesh.teeth[1])


def _friction(mesh: MeshGeometry, roughness: float) -> float:
    small = min(float(diameter) for diameter in mesh.pitch_diameters)
    contact = ToothContact(
        _loss_factor(mesh), float(mesh.relative_curvature), float(mesh.working_angle), 0.0, pinion_diameter=small
    )
    load = _FORCE / (0.5 * float(SUN_PLANET.base_diameters[0])) / float(mesh.face_width)
    friction = mesh_friction(contact, load, _SPEED, viscosity=_OIL, roughness=roughness, law=Friction.NIEMANN_WINTER)
    return float(friction)


def _frictions() -> list[float]:
    return [_friction(mesh, rough) for mesh, rough in zip((SUN_PLANET, PLANET_RING), _ROUGHNESS, strict=True)]


def _losses() -> list[float]:
    meshes = zip((SUN_PLANET, PLANET_RING), _frictions(), strict=True)
    return [_PLANET_POWER * friction * _loss_factor(mesh) for mesh, friction in meshes]


LOSS_CASES = (
    Case("H_V of sun-planet and planet-ring by Ohlendorf's formula", WIND, "", (0.181, 0.161),
         lambda: [_loss_factor(mesh) for mesh in (SUN_PLANET, PLANET_RING)], 5e-4, "half a printed digit",
         is_relative=False),
    Case("μ_m of both meshes by Niemann and Winter", WIND, "", (0.041, 0.045), _frictions, 5e-4,
         "half a printed digit", is_relative=False),
    Case("losses of both meshes of a planet, and of the stage", WIND, "kW", (9.272, 8.986, 54.775),
         lambda: [*_losses(), 3.0 * sum(_losses())], 5e-4, "the report does not print the oil's density at 75 °C"),
    Case("efficiency of the stage's teeth", WIND, "", (0.989,), lambda: [1.0 - 3.0 * sum(_losses()) / _POWER], 5e-4,
         "half a printed digit", is_relative=False),
)  # fmt: skip
"""Printed losses."""


# ----------------------------------------------------------------------------------------------------------------------
# Measured efficiency of a helicopter's main transmission, held against the losses of its teeth.
#
# The planetary set is that of Lin and Parker's model of it: pitch circles of 77.42, 100.35 and 275.03 mm, 24.6°
# between sun and planets, a common base circle of the planets with the ring, and 27, 35 and 99 teeth, of which the
# pitch circles have two modules. The bevel pair has 19 and 71 teeth; its module, its spiral and all face widths are
# assumed.
# ----------------------------------------------------------------------------------------------------------------------


_OH58 = (
    "Coy, Mitchell and Hamrock, 11 lubricants in the OH-58A main transmission (abstract, doi 10.1002/jsl.3000040105)"
)
_INPUT_POWER, _INPUT = 224e3, 6060.0 * RPM
_TEMPERATURES = (355.0, 372.0)
"""Of the oil into the transmission [K]."""
_SUN_MODULE, _RING_MODULE = 77.42e-3 / 27.0, 275.03e-3 / 99.0
_SUN_ANGLE = math.radians(24.6)
_RING_ANGLE = math.acos(_SUN_MODULE * math.cos(_SUN_ANGLE) / _RING_MODULE)
"""Of one base circle of the planets [rad]: 20.2°."""
_WIDTH, _BEVEL_WIDTH = 30e-3, 35e-3
_BEVEL_MODULE, _SPIRAL = 3.9e-3, math.radians(30.0)
_FLANK_ROUGHNESS = 0.4e-6
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
    return float(mesh_loss_part(contact, MeshDuty(load, width, turning * radius), oil, law=law))


def _efficiency(law: MeshLaw, temperature: float) -> float:
    """Return the efficiency of the teeth of both stages."""
    oil = OilState(oil_viscosity(temperature) * OIL_DENSITY, OIL_DENSITY, _FLANK_ROUGHNESS)
    bevel = tooth_contact((19, 71), _BEVEL_MODULE, pressure_angle=math.radians(20.0), helix_angle=_SPIRAL)
    first = _part(bevel, _INPUT_POWER / _INPUT, _INPUT, width=_BEVEL_WIDTH, oil=oil, law=law)
    return 1.0 - first - _planetary_loss(law, oil)


def _planetary_loss(law: MeshLaw, oil: OilState) -> float:
    """Return the part of its power that the planetary set loses in its teeth."""
    sun = tooth_contact((27, 35), _SUN_MODULE, pressure_angle=_SUN_ANGLE)
    ring = tooth_contact((35, -99), _RING_MODULE, pressure_angle=_RING_ANGLE)
    turning = _INPUT * 19.0 / 71.0
    rolling, torque = turning * 99.0 / 126.0, _INPUT_POWER / turning / 3.0
    second = _part(sun, torque, rolling, width=_WIDTH, oil=oil, law=law)
    third = _part(ring, torque * 35.0 / 27.0, rolling * 27.0 / 35.0, width=_WIDTH, oil=oil, law=law)
    return (second + third) * rolling / turning


def _stage(law: MeshLaw) -> Callable[[], list[float]]:
    return lambda: [
        1.0 - _planetary_loss(law, OilState(oil_viscosity(temperature) * OIL_DENSITY, OIL_DENSITY, _FLANK_ROUGHNESS))
        for temperature in _TEMPERATURES
    ]


def _both(law: MeshLaw) -> Callable[[], list[float]]:
    return lambda: [_efficiency(law, temperature) for temperature in _TEMPERATURES]


MEASURED_CASES = tuple(
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


# ----------------------------------------------------------------------------------------------------------------------
# Printed scuffing: the helical pair of the 5 MW gearbox of `gear_reports`, by flash and by integral temperature.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCE = "KISSsoft 03/2017, NREL 5 MW gearbox, stage 3 (report in the repository gfsReboucas/Drivetrain)"
_RACK = ToothProportions(1.25, 0.38)
_PAIR = MeshGeometry(
    (24.0, 95.0), 14e-3, 360e-3, 861e-3, (0.5 * 380.7473e-3, 0.5 * 1395.3754e-3), helix_angle=np.radians(10.0),
    proportions=(replace(_RACK, profile_shift=0.48), replace(_RACK, profile_shift=0.6691)),
)  # fmt: skip
_SCUFFING_OIL = Oil(80.0, 30.09e-3, 14.0, viscosity_40=220e-6)
_LOAD = 40953.0 / (0.5 * float(_PAIR.pitch_diameters[0])) / 0.360
"""F_t/b [N/m]."""
_MESH = ScuffingMesh(
    _PAIR, specific_load=1119.632e3, nominal_load=1.25 * _LOAD,
    speed=1165.9 * RPM * 0.5 * float(_PAIR.pitch_diameters[0]), roughness=0.6e-6,
    stiffness=(13.832e9, 18.632e9), reliefs=(2e-6, 2e-6),
)  # fmt: skip
"""w_Bt with the printed factors."""


def _flash() -> list[float]:
    found = flash_temperature(_MESH, _SCUFFING_OIL, FlashEdition.TR2000)
    return [found.contact, found.scuffing, found.safety]


def _scuffing_friction() -> list[float]:
    friction = flash_temperature(_MESH, _SCUFFING_OIL, FlashEdition.TR2000).friction
    return [friction, lubricant_factor_scuffing(_SCUFFING_OIL)]


def _integral() -> list[float]:
    found = integral_temperature(_MESH, _SCUFFING_OIL)
    return [found.friction, found.geometry, found.approach, found.tip_relief, found.contact_ratio]


def _temperatures() -> list[float]:
    found = integral_temperature(_MESH, replace(_SCUFFING_OIL, test_torque=714.2))
    return [found.flash_mean, found.integral, found.scuffing, found.safety]


SCUFFING_CASES = (
    Case("μ_m and X_L of the flash temperature, ISO/TR 13989-1:2000", _SOURCE, "", (0.041, 0.843),
    _scuffing_friction, 5.1e-4,
         "half a printed digit", is_relative=False),
    Case("ϑ_B, ϑ_S and S_B of the flash temperature, ISO/TR 13989-1:2000", _SOURCE, "°C, –", (169.5, 451.98, 4.156),
         _flash, 7e-3, "the report has X_J = 1 and buttresses otherwise"),
    Case("μ_m, X_BE, X_Q, X_Ca, X_ε of the integral temperature", _SOURCE, "", (0.030, 0.230, 1.0, 1.095, 0.263),
         _integral, 5.1e-4, "half a printed digit", is_relative=False),
    Case("ϑ_flaint, ϑ_int, ϑ_intS, S_intS", _SOURCE, "K, °C, –", (16.25, 115.75, 455.17, 3.932), _temperatures, 5e-4,
         "stage 14 of the oil's test by the report's torque of 714.2 N m"),
)  # fmt: skip
"""Printed scuffing."""
