"""Safety against micropitting by ISO/TS 6336-22, method B."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.parts.iso6336 import Treatment
from gearwright.parts.micropitting.film import POINTS, FilmMesh, film_thickness
from gearwright.parts.micropitting.lubricant import OilGrade
from gearwright.parts.micropitting.oil_test import permissible_film
from gearwright.units import Origin, Quantity

_SOURCE = "ISO/TS 6336-22:2018"


@dataclass(frozen=True)
class Micropitting:
    """The thinnest film of a mesh beside the one that its oil needs."""

    friction: Annotated[float, Quantity("ratio"), Origin("μ_m", f"{_SOURCE}, method B")]
    """Mean coefficient of friction μ_m [-]."""
    tip_relief: Annotated[
        float, Quantity("ratio"), Origin("X_Ca = 1 + C_a/C_eff (0.24 ε_max + 0.71 ε_max²), class ≤ 6", _SOURCE)
    ]
    """Tip relief factor X_Ca [-]."""
    bulk: Annotated[
        float, Quantity("temperature"), Origin("θ_M = θ_oil + 7400 (P μ_m H_v/(a b))^0.72 X_S/(1.2 X_Ca)", _SOURCE)
    ]
    """Bulk temperature θ_M [°C]."""
    films: Annotated[tuple[float, ...], Quantity("ratio"), Origin("λ_GF,Y at A, AB, B, C, D, DE, E", _SOURCE)]
    """Specific film thickness at the seven points [-]."""
    point: str
    """Where the film is thinnest."""
    pressure: Annotated[float, Quantity("stress"), Origin("p_dyn,Y there", _SOURCE)]
    """Contact pressure there [Pa]."""
    contact: Annotated[float, Quantity("temperature"), Origin("θ_B,Y there", _SOURCE)]
    """Contact temperature there [°C]."""
    thinnest: Annotated[float, Quantity("ratio"), Origin("λ_GF,min = h_Y/R_a", _SOURCE)]
    """Least specific film thickness λ_GF,min [-]."""
    permissible: Annotated[float, Quantity("ratio"), Origin("λ_GFP = 1.4 W_W λ_GFT", f"{_SOURCE}, by FZG C-GF/8.3/90")]
    """Permissible specific film thickness λ_GFP [-]."""
    safety: Annotated[float, Quantity("ratio"), Origin("S_λ = λ_GF,min/λ_GFP", _SOURCE)]
    """Safety against micropitting S_λ [-]."""


def micropitting(
    mesh: FilmMesh, oil: OilGrade, temperature: float, *, stage: float, treatment: Treatment = Treatment.CASE_HARDENED
) -> Micropitting:
    """Return the safety against micropitting.

    Args:
        mesh: The mesh.
        oil: The oil.
        temperature: Of the oil before the mesh [°C].
        stage: Load stage at which the oil fails FZG C-GF/8.3/90 [-].
        treatment: Of the weaker flank.

    Source: ISO/TS 6336-22:2018, method B (ISO/TR 15144-1:2014).
    Valid for: ε_α ≤ 2, teeth that share as unmodified ones do; internal pairs for information, see `film_thickness`.
    """
    film = film_thickness(mesh, oil, temperature)
    relative = film.relative(mesh.roughness)
    worst = int(relative.argmin())
    permissible = permissible_film(oil, stage, treatment)
    thinnest = float(relative[worst])
    return Micropitting(
        friction=film.friction,
        tip_relief=mesh.relief,
        bulk=film.bulk,
        films=tuple(float(thickness) for thickness in relative),
        point=POINTS[worst],
        pressure=float(film.pressure[worst]),
        contact=float(film.contact[worst]),
        thinnest=thinnest,
        permissible=permissible,
        safety=thinnest / permissible,
    )
