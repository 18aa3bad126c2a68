"""A mesh as ISO 6336 rates it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.parts.iso6336 import RESONANCE_ENDS, GearSteel, PairRating
from gearwright.parts.micropitting import Micropitting
from gearwright.parts.scuffing import IntegralTemperature
from gearwright.sizing.rating.iso6336.ranges import Beyond
from gearwright.sizing.rating.iso6336.scuffing import FlashPeak
from gearwright.sizing.rating.iso6336.static_cases import StaticCase
from gearwright.sizing.rating.rules import Made
from gearwright.units import Origin, Quantity, Ratio

_CONTACT, _ROOT = "ISO 6336-2:2019", "ISO 6336-3:2019"


@dataclass(frozen=True)
class MeshResonance:
    """How near a mesh runs to its main resonance in a load case."""

    case: str
    """Load case."""
    ratio: Annotated[float, Quantity("ratio"), Origin("N = n_1/n_E1", "ISO 6336-1:2019, 6.5.3")]
    """Reference speed N [-]."""
    begins: Annotated[
        float, Quantity("ratio"), Origin("N_S = 0.5 + 0.35 √(F_t K_A/(100 b)) ≤ 0.85", "ISO 6336-1:2019, 6.5.3")
    ]
    """N_S at which the main resonance range begins [-]; it ends at 1.15."""

    @property
    def separation(self) -> float:
        """Distance from the main resonance |1 − N| [-]."""
        return abs(1.0 - self.ratio)

    @property
    def least(self) -> float:
        """Distance outside the main resonance range, on this side of it [-]."""
        return 1.0 - self.begins if self.ratio < 1.0 else RESONANCE_ENDS - 1.0


@dataclass(frozen=True)
class Iso6336Rating:
    """A rated mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: str
    """Name of the edition's method."""
    case: str
    """Heaviest case."""
    factors: PairRating
    """In that case, over the whole life."""
    steel: GearSteel
    """Of both gears, or of the first one."""
    mate_steel: GearSteel | None
    """Of the second gear where it is another."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H = σ_HG/σ_H; several cases: U(S_H σ_H) = 1", f"{_CONTACT}, 5.3; ISO 6336-6:2019"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F = σ_FG/σ_F; several cases: U(S_F σ_F) = 1", f"{_ROOT}, 5.2; ISO 6336-6:2019"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    scuffing: IntegralTemperature | None
    """In the heaviest case; None for internal gears, which the method does not cover."""
    flash: FlashPeak | None
    """Scuffing by the flash temperature in the heaviest case; None for internal gears."""
    micropitting: Micropitting | None
    """In the heaviest case; None for internal gears, and where the oil's load stage is not given."""
    static: StaticCase | None
    """The static case that comes nearest to the static strength; None where no static case loads the mesh."""
    pitting_asked: Ratio
    """S_Hmin [-]."""
    bending_asked: Ratio
    """S_Fmin [-]."""
    scuffing_asked: Ratio
    """S_Smin [-]."""
    scuffing_by: str
    """Temperature that S_Smin is against: ``integral``, ``flash`` or ``both``."""
    micropitting_asked: Ratio
    """Least S_λ [-]."""
    static_asked: tuple[Ratio, Ratio, Ratio]
    """Least S_H, S_F and S_y against static cases [-]."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_n at which S_F = S_Fmin", f"{_ROOT}, 5.2")]
    """Module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_n at which S_H = S_Hmin", f"{_CONTACT}, 5.3")]
    """Module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("σ_F = σ_F0 K_A K_γ K_V K_Fβ K_Fα, the larger", f"{_ROOT}, 5.2")
    ]
    """Root stress of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_ROOT}, 5.2")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H = Z_B,D σ_H0 √(K_A K_γ K_V K_Hβ K_Hα), the larger", f"{_CONTACT}, 5.3")
    ]
    """Contact stress of the higher stressed gear in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_CONTACT}, 5.3")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_A K_V", "ISO 6336-1:2019, clauses 5 and 6")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""
    beyond: tuple[Beyond, ...] = ()
    """What of the mesh lies beyond the ranges of the formulas."""
    resonances: tuple[MeshResonance, ...] = ()
    """N in every case that matters; empty where K_V knows no resonance (method C)."""

    @property
    def made(self) -> Made:
        """Relief and class of the teeth, whatever they carry later."""
        relief = self.factors.relief
        return Made(float(relief.amount), float(relief.tolerance), float(self.factors.grade))

    @property
    def nearest(self) -> MeshResonance | None:
        """Case in which the mesh runs nearest to its main resonance, for the range there."""
        return min(self.resonances, key=lambda found: found.separation / found.least, default=None)
