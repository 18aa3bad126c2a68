"""What every mesh rated by ISO 6336 bears beyond its nominal load, with what its teeth are made to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from gearwright.parts.iso6336 import DynamicFactorBySpeed
from gearwright.sizing.rating import load_sharing
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.result import Sizing
from gearwright.units import Origin, Quantity

_PART1 = "ISO 6336-1:2019"


@dataclass(frozen=True)
class MeshFactors:
    """One mesh."""

    name: str
    load_factor: Annotated[float, Quantity("ratio"), Origin("K_γ", f"{_PART1}, clause 4")]
    """[-]"""
    shared: str
    """By what K_γ is had."""
    case: str
    """Case in which the mesh runs nearest to its main resonance."""
    resonance_ratio: Annotated[float | None, Quantity("ratio"), Origin("N = n_1/n_E1", f"{_PART1}, 6.5.3")]
    """In that case [-]; None by method C."""
    dynamic_factor: Annotated[float, Quantity("ratio"), Origin("K_V", f"{_PART1}, 6.5")]
    """In the heaviest case [-]."""
    relief_term: Annotated[float | None, Quantity("ratio"), Origin("B_k", f"{_PART1}, 6.5.5")]
    """In the heaviest case [-]; None by method C."""
    tip_relief: Annotated[float, Quantity("film_thickness"), Origin("C_a", f"{_PART1}, 6.5.5")]
    """[m]"""
    tolerance_class: int
    """Of ISO 1328-1 [-]."""


def mesh_factors(sizing: Sizing) -> Iterator[MeshFactors]:
    """Yield every mesh that ISO 6336 rates.

    Args:
        sizing: As sized.
    """
    for mesh in sizing.meshes:
        rated = mesh.rating
        if not isinstance(rated, Iso6336Rating):
            continue
        factors, nearest = rated.factors, rated.nearest
        dynamic = factors.dynamic
        term = None if isinstance(dynamic, DynamicFactorBySpeed) else float(dynamic.relief_term)
        yield MeshFactors(
            mesh.name, mesh.load_factor, load_sharing(sizing.design, mesh.stage).words,
            rated.case if nearest is None else nearest.case, None if nearest is None else nearest.ratio,
            float(factors.loads.dynamic), term, rated.made.relief, int(rated.made.grade),
        )  # fmt: skip
