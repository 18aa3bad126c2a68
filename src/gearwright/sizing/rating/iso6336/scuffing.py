"""Scuffing of a rated mesh by the integral temperature."""

from __future__ import annotations

from gearwright.parts.iso6336 import PairRating
from gearwright.parts.losses import OIL_DENSITY, oil_viscosity
from gearwright.parts.scuffing import SPRAY, IntegralTemperature, Oil, ScuffingMesh, integral_temperature
from gearwright.sizing.rating.iso6336.inputs import SQUARE_MM
from gearwright.sizing.rating.protocol import LoadedMesh
from gearwright.sizing.rating.standard_teeth import cylindrical_mesh
from gearwright.spec.design import Iso6336Rules
from gearwright.units import CELSIUS

_RZ_OVER_RA = 6.0
"""R_z over R_a of ground flanks [-] (ISO 6336-2:2019, clause 12)."""


def scuffing_of(mesh: LoadedMesh, factors: PairRating) -> IntegralTemperature | None:
    """Return the integral temperature of a mesh and its safety; None for internal gears, which are not covered.

    Args:
        mesh: With its heaviest load.
        factors: As rated in it.
    """
    if mesh.heaviest.ask.internal:
        return None
    rating, rules = mesh.rating, mesh.rating.rules.iso6336
    force = float(factors.tangential_force) / mesh.face_width
    scuffed = ScuffingMesh(
        cylindrical_mesh(mesh.heaviest.ask.teeth, mesh.module, mesh.face_width, rating),
        specific_load=force * float(factors.loads.contact),
        nominal_load=force * float(factors.loads.application) * float(factors.loads.mesh_load),
        speed=float(factors.speed),
        roughness=rules.flank_roughness / _RZ_OVER_RA,
        grade=rules.tolerance_class,
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
        reliefs=(rules.tip_relief, rules.tip_relief),
    )
    return integral_temperature(scuffed, _oil(rules))


def _oil(rules: Iso6336Rules) -> Oil:
    """The design's oil; its viscosity falls with temperature as that of a turbine oil does."""
    at_40 = rules.oil_viscosity * SQUARE_MM
    hot = at_40 * oil_viscosity(rules.oil_temperature + CELSIUS) / oil_viscosity(40.0 + CELSIUS)
    return Oil(rules.oil_temperature, hot * OIL_DENSITY, float(rules.scuffing_stage), supply=SPRAY, viscosity_40=at_40)
