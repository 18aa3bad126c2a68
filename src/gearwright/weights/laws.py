"""Mass estimating relationships for gearboxes from power and speeds, and the gear volume by Willis."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from gearwright.base import (
    FOOT,
    HORSEPOWER,
    INCH,
    POUND,
    POUND_FORCE,
    RPM,
    DesignError,
    Mass,
    Number,
    Power,
    Problem,
    Ratio,
    Speed,
    Torque,
    refuse,
    text,
)

# ----------------------------------------------------------------------------------------------------------------------
# What a designer knows before anything is sized: power and two speeds.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Requirement:
    """Power and speeds of a reduction gearbox, from which every statistical method starts."""

    power: Power
    """Power at the rating that sizes the gearbox [W]."""
    engine_speed: Speed
    """Speed of the input [rad/s]."""
    propeller_speed: Speed
    """Speed of the output [rad/s]."""

    def __post_init__(self) -> None:
        problems = [
            Problem(name, f"{value!r} was given; a finite number above zero is needed")
            for name, value in vars(self).items()
            if not (math.isfinite(value) and value > 0.0)
        ]
        if not problems and self.engine_speed <= self.propeller_speed:
            speeds = (
                f"{text(self.engine_speed, 'speed')} at the engine, {text(self.propeller_speed, 'speed')} at the output"
            )
            problems.append(
                Problem("engine_speed", f"{speeds}; the methods are for reduction gearboxes: swap the speeds")
            )
        refuse(problems)

    @property
    def ratio(self) -> Ratio:
        """Input speed over output speed [-]."""
        return self.engine_speed / self.propeller_speed

    @property
    def input_torque(self) -> Torque:
        """Torque at the input [N m]."""
        return self.power / self.engine_speed

    @property
    def output_torque(self) -> Torque:
        """Torque at the output without losses [N m]."""
        return self.power / self.propeller_speed

    @property
    def beta(self) -> Number:
        """Weight parameter β of NASA/TM-2009-215680, in the units of the report."""
        return beta(self.power, self.engine_speed, self.propeller_speed)


def beta(power: float, engine_speed: float, propeller_speed: float) -> float:
    """Return the weight parameter β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15.

    Args:
        power: [W].
        engine_speed: Speed of the input [rad/s].
        propeller_speed: Speed of the output [rad/s].

    Source:
        NASA/TM-2009-215680, figure of gearbox weights.
    """
    torque = (power / HORSEPOWER) / (propeller_speed / RPM)
    return float(torque**0.75 * (engine_speed / propeller_speed) ** 0.15)


def from_beta(value: float, *, ratio: float, propeller_speed: float) -> Requirement:
    """Return the requirement that has a given β at an assumed ratio and output speed.

    Args:
        value: β, in the units of the report.
        ratio: Input speed over output speed [-].
        propeller_speed: Speed of the output [rad/s].

    Source:
        Inverse of `beta`.
    """
    torque = (value / ratio**0.15) ** (1.0 / 0.75)
    power = torque * (propeller_speed / RPM) * HORSEPOWER
    return Requirement(power, ratio * propeller_speed, propeller_speed)


# ----------------------------------------------------------------------------------------------------------------------
# A mass method as data (formula, source, what it includes, where it holds) and what it says of a requirement.
# ----------------------------------------------------------------------------------------------------------------------


_ROUNDING = 1e-9
"""A limit itself is inside, however its value was computed [-]."""
Covered = Literal["included", "left out", "not stated"]


@dataclass(frozen=True)
class Coverage:
    """What the mass of a method contains besides its gears."""

    lubrication: Covered
    """Lubrication system."""
    rotor_shaft: Covered
    """Shaft of the rotor or propeller."""
    accessories: Covered
    """Accessory drives."""
    housing: Covered = "included"
    """Case, shafts and bearings."""


@dataclass(frozen=True)
class Range:
    """Where a method holds in one quantity."""

    quantity: Literal["power", "ratio", "beta"]
    """A property of `Requirement`."""
    low: float
    """Least value, SI."""
    high: float
    """Greatest value, SI."""
    reason: str
    """Source of the range, or the geometry that sets it."""
    shows_beyond: bool = False
    """Whether the bare formula outside may be shown to the reader: it still means a gearbox there."""

    def complaint(self, requirement: Requirement) -> str:
        """Return why a requirement lies outside, or an empty string.

        Args:
            requirement: Power and speeds.
        """
        value = getattr(requirement, self.quantity)
        if self.low * (1.0 - _ROUNDING) <= value <= self.high * (1.0 + _ROUNDING):
            return ""
        dimension = "power" if self.quantity == "power" else "number"
        shown, low, high = (text(number, dimension) for number in (value, self.low, self.high))
        return f"{self.quantity} {shown} is outside {low} to {high} ({self.reason})"


@dataclass(frozen=True)
class Method:
    """A published way from power and speeds to a mass."""

    key: str
    """Short name for files and links."""
    name: str
    formula: str
    """The formula in the symbols and units of its source."""
    source: str
    """Author, year, report."""
    basis: str
    """What it was drawn from, and the error that its authors state."""
    includes: Coverage
    mass: Callable[[Requirement], float]
    """Bare formula: mass [kg] of a requirement."""
    ranges: tuple[Range, ...] = ()
    """Where it holds; empty where its source states no numbers."""
    assumes: str = ""
    """Inputs that a requirement does not give, and the values taken."""


@dataclass(frozen=True)
class Estimate:
    """What a method says of a requirement: a mass, or why it gives none."""

    method: Method
    mass: Mass | None
    """[kg]; none outside the range of the method."""
    reason: str = ""
    """Why there is no mass."""
    beyond: Mass | None = None
    """Bare formula outside its range [kg]: for the reader only, used nowhere."""


def estimate(method: Method, requirement: Requirement) -> Estimate:
    """Return the mass by a method, or the reason why it does not apply.

    Args:
        method: Of `methods`.
        requirement: Power and speeds.
    """
    broken = [range_ for range_ in method.ranges if range_.complaint(requirement)]
    if not broken:
        return Estimate(method, method.mass(requirement))
    reason = "; ".join(range_.complaint(requirement) for range_ in broken)
    beyond = method.mass(requirement) if all(range_.shows_beyond for range_ in broken) else None
    return Estimate(method, None, reason, beyond)


# ----------------------------------------------------------------------------------------------------------------------
# Published laws from power and speeds to the mass of a gearbox, each as its report prints it.
# ----------------------------------------------------------------------------------------------------------------------


TM215680_INTERCEPT = -37.4262
"""Weight at β = 0 [lb] (NASA/TM-2009-215680)."""
TM215680_SLOPE = 116.3297
"""Weight per unit of β [lb] (same source)."""
LEAST_BETA = 0.627
"""β of the lightest gearbox of the figure of NASA/TM-2009-215680; the line is negative below β = 0.322."""
GREATEST_BETA = 65.9
"""β of the heaviest gearbox of that figure."""
STUDY_CONSTANT = 72.0
"""Constant K [lb] of the study of electric propulsion (Brown et al. 2005)."""
EXISTING_GEARBOXES = 94.0
"""Constant K [lb] for gearboxes in service (from general knowledge; the original was not read)."""


def mass_afdd00(power: float, engine_speed: float, propeller_speed: float, *, rotors: float = 1.0) -> float:
    """Return the mass of gear boxes and rotor shafts by AFDD00 of NASA's rotorcraft code NDARC (in the thesis NASA'15).

    W = 95.7634 N^0.38553 P^0.78137 ω_e^0.09899 / ω_r^0.80686 lb.
    The gear box alone is 1 - f_RS of it, with f_RS about 0.10 to 0.13.

    Args:
        power: Limit of the drive system [W].
        engine_speed: Speed of the engine's output [rad/s].
        propeller_speed: Speed of the rotor or propeller [rad/s].
        rotors: Number of main rotors N [-].

    Source:
        Johnson 2015, NASA/TP-2015-218751, AFDD00 (from 52 rotorcraft, mean error 8.6 %); Pulvirenti 2023, eq. 1.1,
        with the propeller's speed below the line, where its eq. 1.2 prints the engine's.

    Valid for:
        Rotorcraft drive systems; numeric limits are not published with the law.

    >>> round(mass_afdd00(2051e3, 20204 * RPM, 1212 * RPM), 1)
    183.5
    """
    horsepower = power / HORSEPOWER
    speeds = (engine_speed / RPM) ** 0.09899 / (propeller_speed / RPM) ** 0.80686
    return float(95.7634 * rotors**0.38553 * horsepower**0.78137 * speeds * POUND)


def mass_afdd83(
    power: float, engine_speed: float, propeller_speed: float, *, second_torque: float = 3.0, gearboxes: float = 1.0
) -> float:
    """Return the mass of gear boxes and rotor shafts by AFDD83 of NDARC.

    W = 57.72 P^0.8195 f_Q^0.068 N_gb^0.0663 (ω_e/1000)^0.0369 / ω_r^0.6379 lb.

    Args:
        power: Limit of the drive system [W].
        engine_speed: Speed of the engine's output [rad/s].
        propeller_speed: Speed of the rotor or propeller [rad/s].
        second_torque: Torque of the second rotor f_Q, in per cent of the total [%].
        gearboxes: Number of gear boxes N_gb [-].

    Source:
        Johnson 2015, NASA/TP-2015-218751, AFDD83 (from 30 aircraft, mean error 7.7 %).

    Valid for:
        Rotorcraft drive systems; numeric limits are not published with the law.

    >>> round(mass_afdd83(2051e3, 20204 * RPM, 1212 * RPM))
    224
    """
    horsepower = power / HORSEPOWER
    counts = second_torque**0.068 * gearboxes**0.0663
    speeds = (engine_speed / RPM / 1000.0) ** 0.0369 / (propeller_speed / RPM) ** 0.6379
    return float(57.72 * horsepower**0.8195 * counts * speeds * POUND)


def mass_tm215680(beta: float) -> float:
    """Return the mass of a gearbox with its lubrication by a line in β, -37.4262 + 116.3297 β lb.

    Args:
        beta: Weight parameter (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15, in the units of the report.

    Source:
        NASA/TM-2009-215680, figure of gearbox weights; constants as read from the figure in AeroSandbox.

    Valid for:
        0.627 ≤ β ≤ 65.9, the weights of the figure.

    Raises:
        DesignError: The line is not positive there.

    >>> from gearwright.weights import beta
    >>> from gearwright.units import RPM
    >>> round(mass_tm215680(beta(2051e3, 20204 * RPM, 1212 * RPM)), 1)
    131.8
    """
    weight = TM215680_INTERCEPT + TM215680_SLOPE * beta
    if weight <= 0.0:
        message = (
            f"{beta:.3g} makes the line negative; allowed {LEAST_BETA} to {GREATEST_BETA}: use the power-law refit"
        )
        raise DesignError([Problem("beta", message)])
    return weight * POUND


def mass_wate2(power: float, engine_speed: float, propeller_speed: float) -> float:
    """Return the mass of an in-line propeller gearbox, (0.0174 Q_out[lbf ft] + 45) √(0.118 GR) lb.

    Args:
        power: [W].
        engine_speed: [rad/s].
        propeller_speed: [rad/s].

    Source:
        Plencner, Senty and Wickenheiser 1983, NASA TM-83458, as given by Pulvirenti 2023, eq. 1.3. Q is the output
        torque; with the input torque, which the thesis names, a PW127 gearbox would weigh 36 kg.

    Valid for:
        In-line gearboxes of 1000 to 2500 hp (Pulvirenti 2023, section 1.3).

    >>> from gearwright.units import RPM
    >>> round(mass_wate2(2051e3, 20204 * RPM, 1212 * RPM), 1)
    160.6
    """
    torque = power / propeller_speed / (POUND_FORCE * FOOT)
    return (0.0174 * torque + 45.0) * math.sqrt(0.118 * engine_speed / propeller_speed) * POUND


def mass_brown(power: float, engine_speed: float, propeller_speed: float, *, constant: float = STUDY_CONSTANT) -> float:
    """Return the mass of a gearbox, K hp^0.76 rpm_in^0.13 / rpm_out^0.89 lb.

    The exponents of the three add up to zero in speed: the law is one of output torque and ratio alone.

    Args:
        power: [W].
        engine_speed: Speed of the input [rad/s].
        propeller_speed: Speed of the output [rad/s].
        constant: State of the art K [lb].

    Source:
        Brown, Kascak, Ebihara et al. 2005, NASA/TM-2005-213800. Pulvirenti 2023, section 1.3, takes it for a law of
        combustion engines; it is one of gearboxes.

    Valid for:
        Aircraft gearboxes; numeric limits are not published in what was read.

    >>> round(mass_brown(2051e3, 20204 * RPM, 1212 * RPM), 1)
    87.8
    """
    horsepower = power / HORSEPOWER
    speeds = (engine_speed / RPM) ** 0.13 / (propeller_speed / RPM) ** 0.89
    return float(constant * horsepower**0.76 * speeds * POUND)


# ----------------------------------------------------------------------------------------------------------------------
# Willis's gear volume: what the gears of an arrangement add up to, as a multiple of 2 T / K.
#
# The surface-durability factor K = F_t/(F d) · (m + 1)/m of a mesh (m ≥ 1, the pinion has d) gives the pinion F d² =
# (2 T/K)(1 + 1/m). Adding F d² over every gear, each with K alike, leaves a bracket that depends on ratios alone. The
# brackets were derived again from this definition; two public implementations agree with them.
# ----------------------------------------------------------------------------------------------------------------------


AIRCRAFT_DENSITY = 0.25 * POUND / INCH**3
"""Mass per Σ F d² of an aircraft gear drive [kg/m³]: 0.25 lb/in³; Willis gives 0.25 to 0.30."""
DEFAULT_K = 600.0 * POUND_FORCE / INCH**2
"""K factor at which drives are compared here [Pa]: 600 psi, an assumption within the span of aircraft gears."""
RING_FACTOR = 0.4
"""Share of a solid disc that a ring gear weighs (Willis 1963)."""


def bracket_double_reduction(first: float, overall: float) -> float:
    """Return Σ F d² K/(2 T) of two pairs in series.

    Args:
        first: Ratio m of the first pair [-].
        overall: Ratio of both M_0 [-].

    Source:
        Willis 1963; derived again: 1 + 1/m + 2m + m² + m²/M_0 + M_0 + M_0²/m.
    """
    m = first
    return 1.0 + 1.0 / m + 2.0 * m + m**2 + m**2 / overall + overall + overall**2 / m


def bracket_double_branch(first: float, overall: float) -> float:
    """Return Σ F d² K/(2 T) of two parallel paths of two pairs each, as in the PW100.

    Args:
        first: Ratio m of the first pairs [-].
        overall: Overall ratio M_0 [-].

    Source:
        Willis 1963; derived again: 1/2 + 1/(2m) + 2m + m² + m²/M_0 + M_0/2 + M_0²/(2m).
    """
    m = first
    return 0.5 + 0.5 / m + 2.0 * m + m**2 + m**2 / overall + 0.5 * overall + 0.5 * overall**2 / m


def bracket_epicyclic(planet: float, ring: float, planets: int) -> float:
    """Return Σ F d² K/(2 T) of a sun, its planets and their ring, with both ratios free.

    Args:
        planet: Planet diameter over sun diameter m_s [-].
        ring: Ring diameter over sun diameter M_r [-].
        planets: Number of planets b [-].

    Source:
        Willis 1963; derived again: 1/b + 1/(b m_s) + m_s + m_s² + 0.4 M_r²/b + 0.4 M_r²/(b m_s). Pulvirenti 2023,
        eq. 1.6, leaves the term 0.4 M_r²/b out.
    """
    rim = RING_FACTOR * ring**2
    return (1.0 + rim) / planets * (1.0 + 1.0 / planet) + planet + planet**2


def bracket_planetary(ratio: float, planets: int) -> float:
    """Return Σ F d² K/(2 T) of a planetary stage with a fixed ring: M_r = GR - 1 and m_s = (GR - 2)/2 by geometry.

    Args:
        ratio: Sun speed over carrier speed GR, above 2 [-].
        planets: Number of planets [-].

    Source:
        Willis 1963, with the planet's diameter from coaxiality.
    """
    return bracket_epicyclic((ratio - 2.0) / 2.0, ratio - 1.0, planets)


def lightest_planet(ring: float, planets: int) -> float:
    """Return the planet-to-sun ratio m_s that would be lightest were it free, 2 m_s³ + m_s² = (0.4 M_r² + 1)/b.

    Coaxial sun, planets and ring fix m_s; the optimum says which ratio suits that geometry.

    Args:
        ring: Ring diameter over sun diameter M_r [-].
        planets: Number of planets b [-].

    Source:
        Willis 1963; Pulvirenti 2023, eq. 1.5, is this for a star.
    """
    from scipy.optimize import brentq

    target = (RING_FACTOR * ring**2 + 1.0) / planets
    return float(brentq(lambda m: 2.0 * m**3 + m**2 - target, 0.0, 1.0 + math.sqrt(target)))


def mass_willis(
    torque: float, bracket: float, *, k_factor: float = DEFAULT_K, density: float = AIRCRAFT_DENSITY
) -> float:
    """Return the mass of a gear drive, a (2 T/K) times its bracket.

    Args:
        torque: Torque of the first pinion or sun T [N m].
        bracket: Of the arrangement [-].
        k_factor: Surface-durability factor K [Pa].
        density: Mass per Σ F d² a [kg/m³].

    Source:
        Willis 1963; in kg 0.2268 T[lb in]/K[psi] for a = 0.25 lb/in³ (Pulvirenti 2023, eq. 1.6).
    """
    return density * 2.0 * torque / k_factor * bracket
