"""The steel of a gear as ISO 6336-5 grades it: heat treatment, quality, hardness, and the two strengths."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from itertools import pairwise
from typing import Annotated

from gearwright.errors import DesignError, Problem
from gearwright.parts.material import STEEL_DENSITY, STEEL_MODULUS, STEEL_POISSON
from gearwright.units import Origin, Quantity

STRESS_CORRECTION_TEST_GEAR = 2.0
"""Stress correction factor of the reference test gears Y_ST [-] (ISO 6336-3:2019)."""


class Treatment(Enum):
    """Material groups of ISO 6336-5 that gearwright rates."""

    STRUCTURAL = "St"
    """Normalised low-carbon steel."""
    THROUGH_HARDENED = "V"
    """Through-hardened wrought steel."""
    CASE_HARDENED = "Eh"
    """Case-hardened (carburised) wrought steel."""
    INDUCTION_HARDENED = "IF"
    """Flame- or induction-hardened steel."""
    NITRIDED = "NT"
    """Nitrided nitriding steel."""
    NITRIDED_THROUGH_HARDENED = "NV"
    """Nitrided through-hardening steel."""
    NITROCARBURISED = "NVc"
    """Nitrocarburised steel."""
    MALLEABLE_IRON = "GTS"
    """Black malleable cast iron, perlitic."""
    NODULAR_IRON = "GGG"
    """Nodular cast iron, perlitic or bainitic."""
    FERRITIC_NODULAR_IRON = "GGGf"
    """Nodular cast iron, ferritic."""
    GREY_IRON = "GG"
    """Grey cast iron."""

    @property
    def is_surface_hardened(self) -> bool:
        """Whether the flank is harder than the core."""
        return self in (Treatment.CASE_HARDENED, Treatment.INDUCTION_HARDENED) or self.is_nitrided

    @property
    def hardness_scale(self) -> str:
        """In which ISO 6336-5 states hardness: HBW of structural steel and cast irons, HV of others."""
        return "HBW" if self is Treatment.STRUCTURAL or self.is_cast_iron else "HV"

    @property
    def is_cast_iron(self) -> bool:
        """Whether it is cast iron."""
        return self in (Treatment.MALLEABLE_IRON, Treatment.NODULAR_IRON) or self.is_brittle_iron

    @property
    def is_brittle_iron(self) -> bool:
        """Whether it is grey or ferritic nodular iron, which the standard sets beside nitrided steel."""
        return self in (Treatment.GREY_IRON, Treatment.FERRITIC_NODULAR_IRON)

    @property
    def is_nitrided(self) -> bool:
        """Whether nitrogen hardens the flank."""
        return self in (Treatment.NITRIDED, Treatment.NITRIDED_THROUGH_HARDENED, Treatment.NITROCARBURISED)


@dataclass(frozen=True)
class StrengthLine:
    """One row of ISO 6336-5, table 1: σ_lim = A x + B over a range of hardness."""

    slope: float
    """A [Pa per unit of hardness]."""
    intercept: float
    """B [Pa]."""
    hardness: tuple[float, float]
    """Least and greatest surface hardness [HV, or HBW for St and cast irons]."""
    scale: str = "HV"
    """Of the hardness."""


@dataclass(frozen=True)
class LifeCurve:
    """An S-N curve: straight lines in double logarithmic scale between corners, the last of which goes on."""

    cycles: tuple[float, ...]
    """Corners N_L [-], increasing."""
    factors: tuple[float, ...]
    """Life factors there [-], decreasing; the last two alike where what lies below them is borne without end."""

    @cached_property
    def lines(self) -> tuple[tuple[float, float, float, float, float], ...]:
        """Of every falling line N and its life factor at the start, the factor at its end, above which it holds,
        ln N_2/N_1 and ln f_1/f_2 [-]; the last line of the curve goes on."""
        ends = pairwise(zip(self.cycles, self.factors, strict=True))
        return tuple(
            (n_1, f_1, -math.inf if n_2 == self.cycles[-1] else f_2, math.log(n_2 / n_1), math.log(f_1 / f_2))
            for (n_1, f_1), (n_2, f_2) in ends
            if f_1 > f_2
        )

    @cached_property
    def fall(self) -> float:
        """Part ln f_1/f_2 over ln N_2/N_1 by which the last line falls, within its corners and beyond [-]."""
        return math.log(self.factors[-2] / self.factors[-1]) / math.log(self.cycles[-1] / self.cycles[-2])

    @property
    def slope(self) -> float:
        """Power p of the stress with which a limited life falls [-]: that of the first line of the curve.

        >>> round(LifeCurve((1e5, 5e7), (1.6, 1.0)).slope, 1)  # flanks of case-hardened steel
        13.2
        """
        return math.log(self.cycles[1] / self.cycles[0]) / math.log(self.factors[0] / self.factors[1])


@dataclass(frozen=True)
class GearSteel:
    """A gear steel ready to be rated."""

    name: str
    """Name in the catalogue."""
    treatment: Treatment
    """Heat treatment."""
    grade: str
    """Material quality ML, MQ or ME."""
    hardness: float
    """Surface hardness [HV, or HBW for St and cast irons]."""
    contact_strength: Annotated[float, Quantity("stress"), Origin("σ_Hlim", "as stated, or ISO 6336-5:2016, table 1")]
    """Allowable stress number for contact σ_Hlim [Pa]."""
    bending_strength: Annotated[float, Quantity("stress"), Origin("σ_Flim", "as stated, or ISO 6336-5:2016, table 1")]
    """Nominal stress number for bending σ_Flim of the standard reference test gears [Pa]."""
    elastic_modulus: Annotated[float, Quantity("stress")] = STEEL_MODULUS
    """E [Pa]."""
    poisson_ratio: Annotated[float, Quantity("ratio")] = STEEL_POISSON
    """ν [-]."""
    density: Annotated[float, Quantity("density")] = STEEL_DENSITY
    """ρ [kg/m³]."""
    yield_strength: Annotated[float | None, Quantity("stress")] = None
    """σ_S or R_p0.2 [Pa]; needed for the notch sensitivity of through-hardened steels only."""
    source: str = ""
    """Where the values come from."""
    contact_life: LifeCurve | None = None
    """S-N curve of the flank; None: that of the treatment."""
    bending_life: LifeCurve | None = None
    """S-N curve of the root; None: that of the treatment."""
    survival: Annotated[float, Quantity("ratio")] = 1.0
    """What the strengths are divided by, so that another part of the gears survives [-]."""

    @property
    def tabulated_strength(self) -> float:
        """σ_Hlim of the material, whatever part survives: film and running in follow it [Pa]."""
        return self.contact_strength * self.survival


def allowable_stress(line: StrengthLine, hardness: float) -> float:
    """Return σ_lim of one row of the table.

    Args:
        line: The row.
        hardness: Surface hardness x [HV, or HBW for St and cast irons].

    Returns:
        σ_Hlim or σ_Flim [Pa].

    Source: ISO 6336-5:2016, clause 5.5, σ_lim = A x + B.
    Valid for: the row's range of hardness.

    Raises:
        DesignError: hardness outside the range.

    >>> allowable_stress(StrengthLine(1.313e6, 373e6, (200.0, 360.0)), 300.0) / 1e6
    766.9
    """
    low, high = line.hardness
    if not low <= hardness <= high:
        allowed = f"ISO 6336-5 covers {low:g} to {high:g} {line.scale} for this class and grade"
        nearest = min(max(hardness, low), high)
        raise DesignError(
            [Problem("hardness", f"{hardness:.4g} {line.scale} given; {allowed}; nearest is {nearest:g}")]
        )
    return line.slope * hardness + line.intercept
