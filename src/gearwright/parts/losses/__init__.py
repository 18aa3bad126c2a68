"""Power lost in meshes and bearings, and what oil costs and carries away.

Temperatures follow from them in `mission`.
"""

from gearwright.parts.losses.bearing import bearing_torque_constant, bearing_torque_palmgren
from gearwright.parts.losses.mesh import (
    HIGHEST_FRICTION,
    Friction,
    ToothContact,
    mesh_efficiency,
    mesh_friction,
    ohlendorf_loss_factor,
    tip_contact_ratio,
    tooth_contact,
    tooth_loss_factor,
)
from gearwright.parts.losses.oil import (
    OIL_DENSITY,
    churning_power,
    cooler_conductance,
    oil_flow,
    oil_viscosity,
    windage_power,
)

__all__ = [
    "HIGHEST_FRICTION",
    "OIL_DENSITY",
    "Friction",
    "ToothContact",
    "bearing_torque_constant",
    "bearing_torque_palmgren",
    "churning_power",
    "cooler_conductance",
    "mesh_efficiency",
    "mesh_friction",
    "ohlendorf_loss_factor",
    "oil_flow",
    "oil_viscosity",
    "tip_contact_ratio",
    "tooth_contact",
    "tooth_loss_factor",
    "windage_power",
]
