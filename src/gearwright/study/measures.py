"""What tells gearboxes apart besides their mass: room, parts, heat, efficiency, life of all bearings together."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.base import Area, Length, Life, Power, Ratio
from gearwright.sizing import Sizing
from gearwright.sizing.installation import chance_to_fit, installation_of
from gearwright.sizing.losses import largest_heat, loss_balance
from gearwright.spec import shares_of

FRONTAL = 1.15
"""Of two frontal diameters, from which mass alone does not decide: a wider nacelle has more drag [-], an estimate."""


@dataclass(frozen=True)
class Measures:
    """What a gearbox takes, has and loses."""

    frontal_diameter: Length
    """Of the smallest circle across the first shaft that holds its housing [m]."""
    frontal_area: Area
    """Of that circle [m²]."""
    overall_length: Length
    """Along the first shaft, with the ends of shafts that leave the housing [m]."""
    offset: Length
    """Of the axis of what is driven most from that of what drives most [m]."""
    fits: Ratio
    """Probability that it keeps to the circle and length of its installation envelope; 1 where there is none [-]."""
    gears: int
    """Bodies with teeth [-]."""
    bearings: int
    """Of shafts and planets [-]."""
    efficiency: Ratio
    """Energy out over energy in, all cases that last by their shares [-]."""
    heat: Power
    """Most that it loses in a case that lasts [W]."""
    system_life: Life | None
    """That 90 % reach with no bearing of a shaft failed [s]; None where none is sized."""


def measures_of(sizing: Sizing) -> Measures:
    """Return what a gearbox takes, has and loses.

    Args:
        sizing: As sized.
    """
    taken = installation_of(sizing)
    planets = sum(gear.bodies * gear.runs_on.side_by_side for gear in sizing.gears if gear.runs_on)
    return Measures(
        frontal_diameter=taken.diameter,
        frontal_area=taken.frontal_area,
        overall_length=taken.length,
        offset=taken.offset,
        fits=chance_to_fit(sizing),
        gears=sum(gear.bodies for gear in sizing.gears),
        bearings=len(sizing.bearings) + planets,
        efficiency=_efficiency(sizing),
        heat=largest_heat(sizing),
        system_life=sizing.system_life,
    )


def _efficiency(sizing: Sizing) -> float:
    """Return energy out over energy in of all cases by their shares of the life; of the first where none has any."""
    shares = {case: share for case, share in shares_of(sizing.design).items() if case in sizing.flows and share > 0.0}
    balances = [(loss_balance(sizing, case), share) for case, share in (shares or {sizing.reference.case: 1.0}).items()]
    given = sum(balance.power * share for balance, share in balances)
    return 1.0 - sum(balance.lost * share for balance, share in balances) / given if given else 1.0
