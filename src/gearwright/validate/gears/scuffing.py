"""Printed scuffing: the helical pair of the 5 MW gearbox of `gear_reports`, by flash and by integral temperature."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gearwright.parts.iso6336 import MeshGeometry, ToothProportions
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

_SOURCE = "KISSsoft 03/2017, NREL 5 MW gearbox, stage 3 (report in the repository gfsReboucas/Drivetrain)"
_RACK = ToothProportions(1.25, 0.38)
_PAIR = MeshGeometry(
    (24.0, 95.0), 14e-3, 360e-3, 861e-3, (0.5 * 380.7473e-3, 0.5 * 1395.3754e-3), helix_angle=np.radians(10.0),
    proportions=(replace(_RACK, profile_shift=0.48), replace(_RACK, profile_shift=0.6691)),
)  # fmt: skip
_OIL = Oil(80.0, 30.09e-3, 14.0, viscosity_40=220e-6)
_LOAD = 40953.0 / (0.5 * float(_PAIR.pitch_diameters[0])) / 0.360
"""F_t/b [N/m]."""
_MESH = ScuffingMesh(
    _PAIR, specific_load=1119.632e3, nominal_load=1.25 * _LOAD,
    speed=1165.9 * RPM * 0.5 * float(_PAIR.pitch_diameters[0]), roughness=0.6e-6,
    stiffness=(13.832e9, 18.632e9), reliefs=(2e-6, 2e-6),
)  # fmt: skip
"""w_Bt with the printed factors."""


def _flash() -> list[float]:
    found = flash_temperature(_MESH, _OIL, FlashEdition.TR2000)
    return [found.contact, found.scuffing, found.safety]


def _friction() -> list[float]:
    friction = flash_temperature(_MESH, _OIL, FlashEdition.TR2000).friction
    return [friction, lubricant_factor_scuffing(_OIL)]


def _integral() -> list[float]:
    found = integral_temperature(_MESH, _OIL)
    return [found.friction, found.geometry, found.approach, found.tip_relief, found.contact_ratio]


def _temperatures() -> list[float]:
    found = integral_temperature(_MESH, replace(_OIL, test_torque=714.2))
    return [found.flash_mean, found.integral, found.scuffing, found.safety]


CASES = (
    Case("μ_m and X_L of the flash temperature, ISO/TR 13989-1:2000", _SOURCE, "", (0.041, 0.843), _friction, 5.1e-4,
         "half a printed digit", is_relative=False),
    Case("ϑ_B, ϑ_S and S_B of the flash temperature, ISO/TR 13989-1:2000", _SOURCE, "°C, –", (169.5, 451.98, 4.156),
         _flash, 7e-3, "the report has X_J = 1 and buttresses otherwise"),
    Case("μ_m, X_BE, X_Q, X_Ca, X_ε of the integral temperature", _SOURCE, "", (0.030, 0.230, 1.0, 1.095, 0.263),
         _integral, 5.1e-4, "half a printed digit", is_relative=False),
    Case("ϑ_flaint, ϑ_int, ϑ_intS, S_intS", _SOURCE, "K, °C, –", (16.25, 115.75, 455.17, 3.932), _temperatures, 5e-4,
         "stage 14 of the oil's test by the report's torque of 714.2 N m"),
)  # fmt: skip
"""Printed scuffing."""
