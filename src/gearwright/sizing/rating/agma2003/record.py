"""A bevel mesh as AGMA 2003 rates it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from gearwright.parts.agma2003 import AgmaBevelRating, BevelEdition
from gearwright.units import Origin, Quantity, Ratio, Velocity

_SOURCE = "ANSI/AGMA 2003-D19"


@dataclass(frozen=True)
class Agma2003Rating:
    """A rated bevel mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: ClassVar[str] = "agma2003"
    case: str
    """Heaviest case."""
    factors: AgmaBevelRating
    """In that case, over the whole life."""
    edition: BevelEdition
    """Whose C_s."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H = s_wc/s_c; several cases: Σ n/N(S_H s_c) = 1", f"{_SOURCE}, eq. 2"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F = s_wt/s_t; several cases: Σ n/N(S_F s_t) = 1", f"{_SOURCE}, eq. 6"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    pitting_asked: Ratio
    """Least S_H [-]."""
    bending_asked: Ratio
    """Least S_F [-]."""
    velocity_limit: Velocity
    """Up to which the curve of K_v holds [m/s]."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_mn with the least S_F", f"{_SOURCE}, eqs 5 and 6")]
    """Mean normal module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_mn with the least S_H", f"{_SOURCE}, eqs 1 and 2")]
    """Mean normal module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("s_t = W_t K_o K_v K_s K_m/(b m_et K_x J), the larger", f"{_SOURCE}, eq. 5")
    ]
    """Bending stress number of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_SOURCE}, eq. 6")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("s_c = C_p √(W_t K_o K_v K_m C_s C_xc/(b d_e1 I))", f"{_SOURCE}, eq. 1")
    ]
    """Contact stress number in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_SOURCE}, eq. 2")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_o K_v", f"{_SOURCE}, clauses 7 and 10")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""
