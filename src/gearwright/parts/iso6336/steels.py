"""Gear steels by ISO 6336-5, their S-N curves, and the Miner sum of a load spectrum by ISO 6336-6."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cache, cached_property, partial
from itertools import pairwise
from typing import Annotated

import numpy as np

from gearwright.base import DesignError, Floats, Origin, Problem, Quantity
from gearwright.parts.iso6336.geometry import Value, as_value
from gearwright.parts.material import STEEL_DENSITY, STEEL_MODULUS, STEEL_POISSON

# ----------------------------------------------------------------------------------------------------------------------
# The steel of a gear as ISO 6336-5 grades it: heat treatment, quality, hardness, and the two strengths.
# ----------------------------------------------------------------------------------------------------------------------


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
    def logarithms(self) -> tuple[Floats, Floats]:
        """Natural logarithms of the corners' cycles and life factors [-]."""
        return np.log(self.cycles), np.log(self.factors)

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


# ----------------------------------------------------------------------------------------------------------------------
# Life factors Z_NT and Y_NT: the S-N curves of ISO 6336-2 and -3 by group of material, and their inverse.
#
# One rule for every standard of gears: below the first corner a curve is flat, the static limit; its last line goes
# on, beyond 1e10 cycles too, so that damage and life factor say the same. A load is borne without end only where that
# line is flat, as with a life factor of 1 at 1e10 cycles and in DIN 3990.
# ----------------------------------------------------------------------------------------------------------------------


LIFE_AT_1E10 = 0.85
"""Life factor at 1e10 cycles otherwise [-]."""
ENDLESS = 600.0
"""Natural logarithm of a number of cycles that counts as endless [-]: 1e260."""


def _contact_corners(treatment: Treatment, *, some_pitting: bool) -> LifeCurve:
    """Corners of Z_NT up to the reference, ISO 6336-2:2019, table 2."""
    if treatment is Treatment.NITROCARBURISED:
        return LifeCurve((1e5, 2e6), (1.1, 1.0))
    if treatment.is_nitrided or treatment.is_brittle_iron:
        return LifeCurve((1e5, 2e6), (1.3, 1.0))
    if some_pitting:
        return LifeCurve((6e5, 1e7, 1e9), (1.6, 1.3, 1.0))
    return LifeCurve((1e5, 5e7), (1.6, 1.0))


@cache
def contact_life_curve(treatment: Treatment, *, some_pitting: bool = False, at_1e10: float = LIFE_AT_1E10) -> LifeCurve:
    """Return the S-N curve of the flank.

    Args:
        treatment: Material group.
        some_pitting: A little pitting may be left on the flanks, which moves the corner from 5e7 to 1e9 cycles.
        at_1e10: Z_NT at 1e10 cycles, 0.85 to 1 [-].

    Source: ISO 6336-2:2019, clause 11, table 2.
    """
    corners = _contact_corners(treatment, some_pitting=some_pitting)
    return LifeCurve((*corners.cycles, 1e10), (*corners.factors, at_1e10))


@cache
def bending_life_curve(treatment: Treatment, *, at_1e10: float = LIFE_AT_1E10) -> LifeCurve:
    """Return the S-N curve of the tooth root.

    Args:
        treatment: Material group.
        at_1e10: Y_NT at 1e10 cycles, 0.85 to 1 [-].

    Source: ISO 6336-3:2019, clause 11, table 1.
    """
    first_corner, greatest = {
        Treatment.STRUCTURAL: (1e4, 2.5),
        Treatment.THROUGH_HARDENED: (1e4, 2.5),
        Treatment.CASE_HARDENED: (1e3, 2.5),
        Treatment.INDUCTION_HARDENED: (1e3, 2.5),
        Treatment.NITRIDED: (1e3, 1.6),
        Treatment.NITRIDED_THROUGH_HARDENED: (1e3, 1.6),
        Treatment.NITROCARBURISED: (1e3, 1.1),
        Treatment.MALLEABLE_IRON: (1e4, 2.5),
        Treatment.NODULAR_IRON: (1e4, 2.5),
        Treatment.FERRITIC_NODULAR_IRON: (1e3, 1.6),
        Treatment.GREY_IRON: (1e3, 1.6),
    }[treatment]
    return LifeCurve((first_corner, 3e6, 1e10), (greatest, 1.0, at_1e10))


def life_curves(steel: GearSteel) -> tuple[LifeCurve, LifeCurve]:
    """Return the S-N curves of flank and root: the steel's own, or those of its treatment.

    Args:
        steel: Of the gear.

    Source: ISO 6336-2:2019, table 2; ISO 6336-3:2019, table 1; or the steel's own.
    """
    contact = contact_life_curve(steel.treatment) if steel.contact_life is None else steel.contact_life
    return contact, bending_life_curve(steel.treatment) if steel.bending_life is None else steel.bending_life


def knee_curve(knee: float, exponent: float, *, greatest: float, at_1e10: float = LIFE_AT_1E10) -> LifeCurve:
    """Return the S-N curve of a line that is stated by its knee and slope.

    Args:
        knee: Cycles at which the life factor is 1 [-].
        exponent: p of N ~ σ^(−p) below the knee [-].
        greatest: Static life factor [-].
        at_1e10: Life factor at 1e10 cycles [-].

    Source: ISO 6336-6:2019, clause 5: lines in double logarithmic scale.

    >>> round(knee_curve(5e7, 13.222, greatest=1.6).cycles[0], -3)
    100000.0
    """
    return LifeCurve((knee * greatest**-exponent, knee, 1e10), (greatest, 1.0, at_1e10))


def life_factor(curve: LifeCurve, cycles: Value) -> Value:
    """Return Z_NT or Y_NT at a number of load cycles.

    Args:
        curve: S-N curve.
        cycles: N_L [-].

    Returns:
        Life factor [-]; the static value below the first corner, that of the last line, prolonged, beyond the last.

    Source: ISO 6336-2:2019, clause 11; ISO 6336-3:2019, clause 11; beyond 1e10 cycles, where their tables end, the
        slope with which damage is summed (ISO 6336-6:2019, clause 5).

    >>> round(float(life_factor(contact_life_curve(Treatment.CASE_HARDENED), 1.08e9)), 3)
    0.91
    """
    ends, factors = curve.logarithms
    logarithm = np.log(np.maximum(cycles, curve.cycles[0]))
    beyond = np.maximum(logarithm - ends[-1], 0.0)
    return as_value(np.exp(np.interp(logarithm, ends, factors) - curve.fall * beyond))


def endurable_cycles(curve: LifeCurve, factor: float) -> float:
    """Return the most cycles whose life factor is not below one, the inverse of `life_factor`.

    Args:
        curve: S-N curve.
        factor: Life factor that the stress asks for [-].

    Returns:
        N [-]; 0 above the static value; ∞ where the curve ends flat and the stress is not above its end.

    Source: ISO 6336-6:2019, clause 5.
    """
    if factor > curve.factors[0]:
        return 0.0
    for start, greatest, least, longer, weaker in curve.lines:
        if factor > least:
            exponent = longer * math.log(greatest / factor) / weaker
            return start * math.exp(exponent) if exponent < ENDLESS else math.inf
    return math.inf


def endured_cycles(curve: LifeCurve, factor: Floats) -> Floats:
    """Return the same as `endurable_cycles` of an array of life factors, to rounding [-].

    Args:
        curve: S-N curve.
        factor: Life factors that stresses ask for [-].

    Source: ISO 6336-6:2019, clause 5.
    """
    left, cycles = factor <= curve.factors[0], np.where(factor > curve.factors[0], 0.0, np.inf)
    for start, greatest, least, longer, weaker in curve.lines:
        own = left & (factor > least)
        cycles = np.where(own, start * np.exp(longer * np.log(greatest / factor) / weaker), cycles)
        left = left & ~own
    return cycles


# ----------------------------------------------------------------------------------------------------------------------
# Damage of a gear under a load spectrum by ISO 6336-6: Miner's sum over the S-N curves of flank and root.
# ----------------------------------------------------------------------------------------------------------------------


_PART6 = "ISO 6336-6:2019"
STEPS = 12
"""Secants after which the root is looked for by bisection alone [-]."""
_CLOSE = 1e-11
"""How near to the root secants come, as a part of it [-]."""
_FARTHEST = 4.0
"""Natural logarithm of a step beyond which no secant goes [-]."""


@dataclass(frozen=True)
class StressBin:
    """One level of a spectrum as the gear feels it."""

    stress: Annotated[
        float, Quantity("stress"), Origin("σ_H or σ_F with the K factors of the bin", f"{_PART6}, clause 4")
    ]
    """Contact or root stress with K_V, K_Hβ, K_Hα of the bin and K_A = 1 [Pa]."""
    cycles: Annotated[float, Quantity("number"), Origin("n_i", f"{_PART6}, clause 4")]
    """Load cycles at this level n_i [-]."""


@dataclass(frozen=True)
class Damage:
    """What a spectrum does to one gear."""

    parts: tuple[float, ...]
    """Damage n_i/N_i of each bin [-]."""
    total: Annotated[float, Quantity("ratio"), Origin("U = Σ n_i/N_i", f"{_PART6}, clause 5")]
    """Miner's sum U [-]; 1 is failure at the safety of the curve."""
    safety: Annotated[float, Quantity("ratio"), Origin("S: U(S σ) = 1", f"{_PART6}, clause 6")]
    """Factor on all stresses at which the sum becomes 1, S_H or S_F [-]."""


def damage_parts(bins: Sequence[StressBin], reference: float, curve: LifeCurve) -> tuple[float, ...]:
    """Return the damage of every bin.

    Args:
        bins: The spectrum.
        reference: Stress limit at a life factor of 1, σ_HG or σ_FG with Z_NT = 1 or Y_NT = 1 [Pa].
        curve: S-N curve of the flank or the root.

    Returns:
        n_i/N_i [-], shape (bins,); ∞ above the static limit.

    Source: ISO 6336-6:2019, clause 5. Stresses below the endurance corner damage along the last slope of the curve
        (Z_NT or Y_NT = 0.85 at 1e10), and not at all where it is flat.
    """
    return tuple([damage_part(level.cycles, level.stress / reference, curve) for level in bins])


def damage_part(cycles: float, factor: float, curve: LifeCurve) -> float:
    """Return the damage of load cycles under one stress, n/N; ∞ above the static limit [-].

    Args:
        cycles: n [-].
        factor: Stress over its limit at a life factor of 1 [-].
        curve: S-N curve of the flank or the root.

    Source: ISO 6336-6:2019, clause 5.
    """
    endured = endurable_cycles(curve, factor) if factor > 0.0 else math.inf
    return cycles / endured if endured > 0.0 else math.inf


def spectrum_damage(bins: Sequence[StressBin], reference: float, curve: LifeCurve) -> Damage:
    """Return Miner's sum of a spectrum and the safety that it leaves.

    The safety lies between that of all cycles under the greatest stress and that of the greatest stress once.

    Args:
        bins: The spectrum, at least one bin with cycles and stress.
        reference: Stress limit at a life factor of 1 [Pa].
        curve: S-N curve.

    Source: ISO 6336-6:2019, clauses 5 and 6: the safety scales all stresses until U = 1.

    Raises:
        DesignError: an empty spectrum.

    >>> from gearwright.parts.iso6336 import contact_life_curve
    >>> from gearwright.parts.iso6336 import Treatment
    >>> curve = contact_life_curve(Treatment.CASE_HARDENED)
    >>> round(spectrum_damage([StressBin(1000e6, 5e7)], 1500e6, curve).safety, 6)
    1.5
    """
    loads = [(level.stress, level.cycles) for level in bins if level.cycles > 0.0 and level.stress > 0.0]
    if not loads:
        raise DesignError([Problem("spectrum", "no bin has both stress and cycles; give at least one")])
    parts = damage_parts(bins, reference, curve)

    unit = reference / max([stress for stress, _ in loads])
    low, high = unit * float(life_factor(curve, sum([cycles for _, cycles in loads]))), unit * curve.factors[0]
    near = partial(_near, loads, reference, curve, low)
    safety = _unit_root(lambda factor: _lasts(loads, reference / factor, curve), near, low, high)
    return Damage(parts, sum(parts), safety)


def _lasts(loads: Sequence[tuple[float, float]], reference: float, curve: LifeCurve) -> bool:
    """Tell whether stresses and their cycles damage by 1 or less; no further than the sum is above it."""
    total = 0.0
    for stress, cycles in loads:
        endured = endurable_cycles(curve, stress / reference)
        total += cycles / endured if endured > 0.0 else math.inf
        if total > 1.0:
            return False
    return True


def _near(loads: Sequence[tuple[float, float]], reference: float, curve: LifeCurve, start: float) -> float:
    """Return about the factor at which the sum is 1, by secants in double logarithmic scale; the start if they fail."""
    at, value, moved = math.log(start), 0.0, 0.0
    slope = max([longer / weaker for _, _, _, longer, weaker in curve.lines], default=1.0)
    for step in range(STEPS):
        factor = math.exp(at)
        total = sum([damage_part(cycles, factor * stress / reference, curve) for stress, cycles in loads])
        if not 0.0 < total < math.inf:
            return start
        before, value = value, math.log(total)
        if step and value != before:
            slope = (value - before) / moved
        moved = -value / slope
        if abs(value) < _CLOSE or not abs(moved) < _FARTHEST:
            return factor
        at += moved
    return factor


def _unit_root(lasts: Callable[[float], bool], near: Callable[[], float], low: float, high: float) -> float:
    """Factor at which a growing sum passes 1, between two; bisection, as the sum jumps at the static limit.

    Where the sum passes 1 close to `near`, only what lies there is tried, which leaves the root as it is.
    """
    guess = near()
    holds, fails = guess * (1.0 - _CLOSE), guess * (1.0 + _CLOSE)
    holds, fails = holds if lasts(holds) else low, fails if not lasts(fails) else high
    while high / low > 1.0 + 1e-12:
        middle = (low * high) ** 0.5
        within = middle <= holds or (middle < fails and lasts(middle))
        low, high = (middle, high) if within else (low, middle)
    return low
