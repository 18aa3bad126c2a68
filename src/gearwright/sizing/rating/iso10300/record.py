"""A bevel mesh as ISO 10300 rates it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from gearwright.parts.bevel import BevelRating
from gearwright.parts.iso6336 import GearSteel
from gearwright.parts.scuffing import IntegralTemperature
from gearwright.sizing.rating.iso6336.scuffing import FlashPeak
from gearwright.units import Origin, Quantity, Ratio

_CONTACT, _ROOT = "ISO 10300-2:2023", "ISO 10300-3:2023"


@dataclass(frozen=True)
class Iso10300Rating:
    """A rated bevel mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: ClassVar[str] = "iso10300"
    case: str
    """Heaviest case."""
    factors: BevelRating
    """In that case, over the whole life."""
    steel: GearSteel
    """Of both gears."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H = σ_HP/σ_H; several cases: U(S_H σ_H) = 1", f"{_CONTACT}, eq. 5; ISO 6336-6:2019"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F = σ_FP/σ_F; several cases: U(S_F σ_F) = 1", f"{_ROOT}, eq. 5; ISO 6336-6:2019"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    scuffing: IntegralTemperature | None
    """In the heaviest case, on the virtual cylindrical gears; None where contact lies on one side of the pitch point
    alone."""
    flash: FlashPeak | None
    """In the heaviest case, on the same gears; None where their tips interfere."""
    pitting_asked: Ratio
    """S_Hmin [-]."""
    bending_asked: Ratio
    """S_Fmin [-]."""
    scuffing_asked: Ratio
    """S_Smin [-]."""
    scuffing_by: str
    """Temperature that it is against: ``integral``, ``flash`` or ``both``."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_mn at which S_F = S_Fmin", f"{_ROOT}, eq. 5")]
    """Mean normal module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_mn at which S_H = S_Hmin", f"{_CONTACT}, eq. 5")]
    """Mean normal module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("σ_F = σ_F0 K_A K_V K_Fβ K_Fα, the larger", f"{_ROOT}, eq. 1")
    ]
    """Root stress of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_ROOT}, eq. 5")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H = σ_H0 √(K_A K_V K_Hβ K_Hα)", f"{_CONTACT}, eq. 1")
    ]
    """Contact stress in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_CONTACT}, eq. 5")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_A K_V", "ISO 10300-1:2023")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""
