"""Mesh stiffness of ISO 6336-1, method B, over arrays of pairs: what the load factors need of it.

For one pair with its web and rim see `mesh_stiffness_iso6336`; a test holds the two together.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, cast

import numpy as np

from gearwright.parts.iso6336.geometry import MeshGeometry, Value
from gearwright.parts.iso6336.steels import GearSteel
from gearwright.parts.stiffness import LINEAR_LOAD, THEORY_TO_MEASUREMENT, modulus_factor, theoretical_stiffness
from gearwright.units import Origin, Quantity

_CLAUSE = "ISO 6336-1:2019, clause 9"


@dataclass(frozen=True)
class MeshSprings:
    """Stiffness of the mesh per face width, in the transverse plane along the line of action."""

    single: Annotated[Value, Quantity("number"), Origin("c′ = c′_th C_M C_R C_B cos β", _CLAUSE)]
    """Of one tooth pair c′ [N/m²]."""
    mesh: Annotated[Value, Quantity("number"), Origin("c_γα = c′ (0.75 ε_α + 0.25)", _CLAUSE)]
    """Mean of the mesh c_γα [N/m²]."""
    face: Annotated[Value, Quantity("number"), Origin("c_γβ = 0.85 c_γα", _CLAUSE)]
    """For the face load factor c_γβ [N/m²]."""


def mesh_springs(
    mesh: MeshGeometry,
    specific_load: Value = LINEAR_LOAD,
    *,
    steels: tuple[GearSteel, GearSteel] | None = None,
    blank: float = 1.0,
) -> MeshSprings:
    """Return c′, c_γα and c_γβ of a mesh.

    Args:
        mesh: The pair.
        specific_load: F_t K_A K_γ / b [N/m]; softens the mesh below 100 N/mm.
        steels: Of both gears, for E/E_St; None: of E_St.
        blank: Gear blank factor C_R [-]; 1 of solid and bored gears.

    Source: ISO 6336-1:2006, clause 9; z_n2 = ∞ for an internal wheel; E = 2 E_1 E_2/(E_1 + E_2).
    Valid for: β ≤ 45°, 1.2 < ε_α < 1.9 (higher is taken as it is), −0.5 ≤ x_1 + x_2 ≤ 2; not checked for arrays.
    """
    first, second = mesh.virtual_teeth
    teeth = (first, np.where(np.asarray(mesh.side) > 0, second, np.inf))
    shifts = (mesh.proportions[0].profile_shift, mesh.proportions[1].profile_shift)
    # The formula is plain arithmetic, so arrays pass through it.
    theory = theoretical_stiffness(cast(tuple[float, float], teeth), cast(tuple[float, float], shifts))
    rack = 1.0 + 0.5 * (1.2 - 0.5 * (mesh.proportions[0].dedendum + mesh.proportions[1].dedendum))
    rack = rack * (1.0 - 0.02 * (20.0 - np.degrees(mesh.pressure_angle)))
    light = np.minimum(1.0, (specific_load / LINEAR_LOAD) ** 0.25)
    single = theory * THEORY_TO_MEASUREMENT * rack * np.cos(mesh.helix_angle) * light * blank
    if steels is not None:
        single = single * modulus_factor((steels[0].elastic_modulus, steels[1].elastic_modulus))
    mean = single * (0.75 * mesh.transverse_contact_ratio + 0.25)
    return MeshSprings(single, mean, 0.85 * mean)
