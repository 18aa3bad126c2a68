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
    TURBINE_OIL,
    churning_power,
    cooler_conductance,
    oil_flow,
    oil_viscosity,
    windage_power,
    windage_power_dawson,
)
from gearwright.parts.losses.seal import NITRILE, VITON, seal_power_14179_1, seal_power_14179_2, seal_power_oil
from gearwright.parts.losses.skf_bearing import OIL_JET, RunningBearing, SeriesFriction, bearing_torque_skf
from gearwright.parts.losses.tooth_power import (
    FASTEST,
    LEAST_INTENSITY,
    MOST_INTENSITY,
    SLOWEST,
    MeshDuty,
    MeshLaw,
    OilState,
    anderson_loewenthal_part,
    iso_tr_14179_1_part,
    load_intensity,
    mesh_loss_part,
)

__all__ = [
    "FASTEST",
    "HIGHEST_FRICTION",
    "LEAST_INTENSITY",
    "MOST_INTENSITY",
    "NITRILE",
    "OIL_DENSITY",
    "OIL_JET",
    "SLOWEST",
    "TURBINE_OIL",
    "VITON",
    "Friction",
    "MeshDuty",
    "MeshLaw",
    "OilState",
    "RunningBearing",
    "SeriesFriction",
    "ToothContact",
    "anderson_loewenthal_part",
    "bearing_torque_constant",
    "bearing_torque_palmgren",
    "bearing_torque_skf",
    "churning_power",
    "cooler_conductance",
    "iso_tr_14179_1_part",
    "load_intensity",
    "mesh_efficiency",
    "mesh_friction",
    "mesh_loss_part",
    "ohlendorf_loss_factor",
    "oil_flow",
    "oil_viscosity",
    "seal_power_14179_1",
    "seal_power_14179_2",
    "seal_power_oil",
    "tip_contact_ratio",
    "tooth_contact",
    "tooth_loss_factor",
    "windage_power",
    "windage_power_dawson",
]
