"""A mesh as AGMA 2001 rates it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from gearwright.parts.agma2001 import AgmaPairRating
from gearwright.sizing.rating.agma2001.yielding import YieldingCase
from gearwright.units import Origin, Quantity, Ratio, Velocity

_SOURCE = "ANSI/AGMA 2001-D04"


@dataclass(frozen=True)
class Agma2001Rating:
    """A rated mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: ClassVar[str] = "agma2001"
    case: str
    """Heaviest case."""
    factors: AgmaPairRating
    """In that case, over the whole life."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H; several cases: Σ n/N(S_H s_c) = 1", f"{_SOURCE}, eq. 4"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F; several cases: Σ n/N(S_F s_t) = 1", f"{_SOURCE}, eq. 13"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    pitting_asked: Ratio
    """Least S_H [-]."""
    bending_asked: Ratio
    """Least S_F [-]."""
    static: YieldingCase | None
    """The static case that comes nearest to yielding; None where none loads the mesh or no yield strength is known."""
    yielding_asked: Ratio
    """Least safety against yielding [-]."""
    velocity_limit: Velocity
    """Up to which the curve of K_v holds [m/s]."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_n with the least S_F", f"{_SOURCE}, eqs 10, 13")]
    """Module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_n with the least S_H", f"{_SOURCE}, eqs 1, 4")]
    """Module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("s_t = W_t K_o K_v K_s K_m K_B/(F m_t J), the larger", f"{_SOURCE}, eq. 10")
    ]
    """Bending stress number of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_SOURCE}, eq. 13")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float,
        Quantity("stress"),
        Origin("s_c = C_p √(W_t K_o K_v K_s K_m C_f/(d F I)), the larger", f"{_SOURCE}, eq. 1"),
    ]
    """Contact stress number of the higher stressed gear in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_SOURCE}, eq. 4")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_o K_v", f"{_SOURCE}, clauses 8 and 9")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""
