"""A mesh as Lewis and Hertz rate it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from gearwright.units import Origin, Quantity

_THESIS = "Pulvirenti 2023"


@dataclass(frozen=True)
class LewisHertzRating:
    """A mesh at its worst case: the root of the weaker gear, and the flanks at the pitch point."""

    method: ClassVar[str] = "lewis-hertz"
    case: str
    module_bending: Annotated[
        float, Quantity("length"), Origin("m_n³ = 2 (T/z) cos β / (λ Y σ)", f"{_THESIS}, eq. 2.1, cube root")
    ]
    """Module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("from σ_H = 2.5 HB / S", f"{_THESIS}, eq. 2.2, 0.418")]
    """Module that contact asks for [m]."""
    form_factor: Annotated[float, Quantity("ratio"), Origin("Y at z_v", "Shigley, 9th ed., table 14-2")]
    """Lewis form factor of the weaker gear [-]."""
    bending_stress: Annotated[float, Quantity("stress"), Origin("σ = F_t / (b m_n Y)", "Lewis 1892")]
    """Bending stress of the weaker gear [Pa]."""
    bending_allowable: Annotated[
        float, Quantity("stress"), Origin("R_p0.2 over the asked factor", f"{_THESIS}, eq. 2.1")
    ]
    """Share of idlers included [Pa]."""
    bending_margin: Annotated[
        float, Quantity("ratio"), Origin("R_p0.2 / σ over the asked factor", f"{_THESIS}, eq. 2.1")
    ]
    """Allowable over actual bending stress [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H = 0.418 √(F_t E Σ(1/r) cos β / (b cos α sin α))", f"{_THESIS}, eq. 2.2")
    ]
    """Hertz pressure at the pitch point [Pa]."""
    contact_allowable: Annotated[
        float, Quantity("stress"), Origin("2.5 HB over the asked factor", f"{_THESIS}, eq. 2.2")
    ]
    """[Pa]"""
    contact_margin: Annotated[
        float, Quantity("ratio"), Origin("2.5 HB / σ_H over the asked factor", f"{_THESIS}, eq. 2.2")
    ]
    """Allowable over actual contact pressure [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("1: the loads are nominal", f"{_THESIS}, eqs 2.1, 2.2")] = 1.0
    """Factor on the tangential force for peaks of the load [-]."""
