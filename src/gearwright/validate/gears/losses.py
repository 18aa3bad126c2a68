"""Printed losses of teeth: the planetary stage of `gear_reports`."""

from __future__ import annotations

from gearwright.parts.iso6336 import MeshGeometry
from gearwright.parts.losses import (
    Friction,
    ToothContact,
    mesh_friction,
    ohlendorf_loss_factor,
    oil_viscosity,
)
from gearwright.units import RPM
from gearwright.validate.case import Case
from gearwright.validate.gears.reports import PLANET_RING, SUN_PLANET, WIND

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
    return mesh_friction(contact, load, _SPEED, viscosity=_OIL, roughness=roughness, law=Friction.NIEMANN_WINTER)


def _frictions() -> list[float]:
    return [_friction(mesh, rough) for mesh, rough in zip((SUN_PLANET, PLANET_RING), _ROUGHNESS, strict=True)]


def _losses() -> list[float]:
    meshes = zip((SUN_PLANET, PLANET_RING), _frictions(), strict=True)
    return [_PLANET_POWER * friction * _loss_factor(mesh) for mesh, friction in meshes]


CASES = (
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
