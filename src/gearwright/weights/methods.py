"""All published mass estimating relationships, and a regression of published gearbox masses."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial

import numpy as np
from numpy.typing import ArrayLike

from gearwright.catalogue import weighed_gearboxes
from gearwright.units import HORSEPOWER, POUND, Mass, Number
from gearwright.weights import laws
from gearwright.weights.laws import Coverage, Method, Range, Requirement

# ----------------------------------------------------------------------------------------------------------------------
# A straight line through logarithms, the band in which the next gearbox will lie, and the refit of the 61 weights.
# ----------------------------------------------------------------------------------------------------------------------


_BISECTIONS = 60
"""Halvings of a right angle: below its rounding [-]."""


@dataclass(frozen=True)
class LogLine:
    """Least-squares line log10 y = slope log10 x + intercept, with what a prediction from it needs."""

    slope: Number
    """Exponent of x [-]."""
    intercept: Number
    """log10 of y at x = 1."""
    r_squared: Number
    """Share of the variance of log10 y that the line explains [-]."""
    spread: Number
    """Residual standard deviation of log10 y, with n - 2 degrees of freedom."""
    count: int
    """Number of points n."""
    mean: float
    """Mean of log10 x."""
    sum_of_squares: float
    """Sum of squared deviations of log10 x from its mean."""

    def at(self, x: float) -> float:
        """Return y on the line.

        Args:
            x: In the unit of the points.
        """
        return float(10.0 ** (self.slope * math.log10(x) + self.intercept))

    def band(self, x: float, level: float) -> tuple[float, float]:
        """Return the limits between which one new point lies with a given probability.

        Args:
            x: In the unit of the points.
            level: Probability, such as 0.95 [-].

        Source:
            Prediction interval of simple linear regression, Student's t with n - 2 degrees of freedom.
        """
        quantile = student_quantile(self.count - 2, level)
        offset = (math.log10(x) - self.mean) ** 2 / self.sum_of_squares
        width = quantile * self.spread * math.sqrt(1.0 + 1.0 / self.count + offset)
        return self.at(x) * 10.0**-width, self.at(x) * 10.0**width


def student_quantile(freedoms: int, level: float) -> float:
    """Return the t within which Student's distribution lies with a probability, either side of zero [-].

    A library would do, but loads for longer than a design takes to be sized.

    Args:
        freedoms: Degrees of freedom ν, 1 or more [-].
        level: Probability, 0 to 1 [-].

    Source: Abramowitz & Stegun, 26.7.3 and 26.7.4: finite sums in θ = atan(t/√ν), bisected.

    >>> round(student_quantile(10, 0.95), 3)
    2.228
    """
    low, high = 0.0, 0.5 * math.pi
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _within(freedoms, middle) < level else (low, middle)
    return math.sqrt(freedoms) * math.tan(0.5 * (low + high))


def _within(freedoms: int, angle: float) -> float:
    """Return A(t|ν) for t = √ν tan θ."""
    odd, cosine = freedoms % 2, math.cos(angle)
    term, total = (cosine, 0.0) if odd else (1.0, 0.0)
    for order in range(odd, freedoms - 1, 2):
        total += term
        term *= (order + 1) / (order + 2) * cosine**2
    total *= math.sin(angle)
    return 2.0 / math.pi * (angle + total) if odd else total


@dataclass(frozen=True)
class Band:
    """A mass with the limits in which it lies."""

    level: Number
    """Probability that the next gearbox of this kind lies within [-]."""
    low: Mass
    """[kg]."""
    high: Mass
    """[kg]."""


def log_line(x: ArrayLike, y: ArrayLike) -> LogLine:
    """Return the least-squares line through log10 of the points.

    Args:
        x: Positive, shape (n,).
        y: Positive, shape (n,).
    """
    u, v = np.log10(np.asarray(x, dtype=float)), np.log10(np.asarray(y, dtype=float))
    du, dv = u - u.mean(), v - v.mean()
    square = float(du @ du)
    slope = float(du @ dv) / square
    residual = dv - slope * du
    return LogLine(
        slope=slope,
        intercept=float(v.mean() - slope * u.mean()),
        r_squared=1.0 - float(residual @ residual) / float(dv @ dv),
        spread=math.sqrt(float(residual @ residual) / (u.size - 2)),
        count=u.size,
        mean=float(u.mean()),
        sum_of_squares=square,
    )


@cache
def refit() -> LogLine:
    """Return the power law in β through the 61 real gearbox weights, in lb.

    Source:
        Weights of NASA/TM-2009-215680, fitted here by least squares in log10.
    """
    points = weighed_gearboxes()
    return log_line([point.beta for point in points], [point.mass / POUND for point in points])


def mass_refit(requirement: Requirement) -> float:
    """Return the mass of a gearbox by the refit: the median of its kind [kg].

    Args:
        requirement: Power and speeds.

    Source:
        `refit`.
    """
    return refit().at(requirement.beta) * POUND


def bands(requirement: Requirement, levels: tuple[float, ...] = (0.68, 0.95)) -> tuple[Band, ...]:
    """Return the prediction bands of the refit.

    Args:
        requirement: Power and speeds.
        levels: Probabilities [-].
    """
    limits = ((level, refit().band(requirement.beta, level)) for level in levels)
    return tuple(Band(level, low * POUND, high * POUND) for level, (low, high) in limits)


def refit_range() -> Range:
    """Return the β of the 61 weights."""
    betas = [gearbox.beta for gearbox in weighed_gearboxes()]
    return Range("beta", min(betas), max(betas), "weights of NASA/TM-2009-215680")


# ----------------------------------------------------------------------------------------------------------------------
# Every public mass method that gearwright knows, in the order in which it shows them.
# ----------------------------------------------------------------------------------------------------------------------


_AFDD00 = Coverage(lubrication="not stated", rotor_shaft="included", accessories="included")
_AFDD83 = Coverage(lubrication="not stated", rotor_shaft="included", accessories="not stated")
_UNSTATED = Coverage(lubrication="not stated", rotor_shaft="not stated", accessories="not stated")
_WITH_LUBRICATION = Coverage(lubrication="included", rotor_shaft="not stated", accessories="not stated")
_NOTHING_SAID = Coverage("not stated", "not stated", "not stated", housing="not stated")
_WILLIS = "Willis 1963, Product Engineering, pp. 64-75; brackets derived again from the definition of K"
_WILLIS_BASIS = "gear volumes times 0.25 lb/in³, Willis's factor for aircraft drives"
_K = "K = 600 psi"
_LEAST_PLANET = 0.25
"""Planet over sun diameter below which a planetary stage is not proposed [-]: an assumption, not Willis's."""
_EPICYCLIC = "1/b + 1/(b m_s) + m_s + m_s² + 0.4 M_r²/b + 0.4 M_r²/(b m_s)"
_WILLIS_FORMULAS = {
    "willis-two-planetary": f"Σ F d² = (2T/K) [{_EPICYCLIC}] for each stage, M_r = GR − 1, m_s = (GR − 2)/2",
    "willis-planetary": f"Σ F d² = (2T/K) [{_EPICYCLIC}], M_r = GR − 1, m_s = (GR − 2)/2",
    "willis-double-branch": "Σ F d² = (2T/K) [1/2 + 1/(2m) + 2m + m² + m²/M_0 + M_0/2 + M_0²/(2m)]",
    "willis-double-reduction": "Σ F d² = (2T/K) [1 + 1/m + 2m + m² + m²/M_0 + M_0 + M_0²/m]",
}


@cache
def methods() -> tuple[Method, ...]:
    """Return every method, the refit of the real weights first."""
    return (_refit(), _tm215680(), *_ndarc(), _wate2(), *_brown(), *_willis())


def _refit() -> Method:
    line = refit()
    return Method(
        key="refit",
        name="Refit of 61 weights",
        formula=f"W[lb] = 10^{line.intercept:.4f} β^{line.slope:.4f}, β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15",
        source="weights of NASA/TM-2009-215680, fitted by gearwright",
        basis=f"61 gearboxes of rotorcraft, tiltrotors and turboprops; R² = {line.r_squared:.3f} in log10",
        includes=_WITH_LUBRICATION,
        mass=mass_refit,
        ranges=(refit_range(),),
    )


def _tm215680() -> Method:
    return Method(
        key="tm215680",
        name="TM-2009-215680",
        formula="W[lb] = −37.4262 + 116.3297 β, β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15",
        source="NASA/TM-2009-215680, figure of gearbox weights",
        basis="the same weights of more than fifty gearboxes, fitted by a line in β",
        includes=_WITH_LUBRICATION,
        mass=lambda need: laws.mass_tm215680(need.beta),
        ranges=(Range("beta", laws.LEAST_BETA, laws.GREATEST_BETA, "weights of the figure"),),
    )


def _ndarc() -> tuple[Method, Method]:
    return (
        Method(
            key="afdd00",
            name="NASA'15 = AFDD00",
            formula="W[lb] = 95.7634 N^0.38553 hp^0.78137 rpm_in^0.09899 / rpm_out^0.80686",
            source="Johnson 2015, NASA/TP-2015-218751; Pulvirenti 2023, eq. 1.1",
            basis="52 rotorcraft, mean error 8.6 %",
            includes=_AFDD00,
            mass=_by_speeds(laws.mass_afdd00),
            assumes="N = 1 rotor",
        ),
        Method(
            key="afdd83",
            name="AFDD83",
            formula="W[lb] = 57.72 hp^0.8195 f_Q^0.068 N_gb^0.0663 (rpm_in/1000)^0.0369 / rpm_out^0.6379",
            source="Johnson 2015, NASA/TP-2015-218751",
            basis="30 aircraft, mean error 7.7 %",
            includes=_AFDD83,
            mass=_by_speeds(laws.mass_afdd83),
            assumes="f_Q = 3 %, N_gb = 1",
        ),
    )


def _wate2() -> Method:
    return Method(
        key="wate2",
        name="WATE-2",
        formula="W[lb] = (0.0174 Q_out[lbf ft] + 45) (0.118 rpm_in/rpm_out)^0.5",
        source="Plencner, Senty and Wickenheiser 1983, NASA TM-83458; Pulvirenti 2023, eq. 1.3",
        basis="in-line propeller gearboxes, data not published",
        includes=_UNSTATED,
        mass=_by_speeds(laws.mass_wate2),
        ranges=(
            Range(
                "power", 1000.0 * HORSEPOWER, 2500.0 * HORSEPOWER, "1000 to 2500 hp, Pulvirenti 2023", shows_beyond=True
            ),
        ),
    )


def _brown() -> tuple[Method, ...]:
    cases = (
        ("brown94", laws.EXISTING_GEARBOXES, "existing gearboxes"),
        ("brown72", laws.STUDY_CONSTANT, "gearboxes of the study"),
    )
    return tuple(
        Method(
            key=key,
            name=f"Brown 2005, K = {constant:g}",
            formula=f"W[lb] = {constant:g} hp^0.76 rpm_in^0.13 / rpm_out^0.89",
            source="Brown, Kascak, Ebihara et al. 2005, NASA/TM-2005-213800",
            basis="aircraft gearboxes, data not published with the law",
            includes=_UNSTATED,
            mass=_by_speeds(partial(laws.mass_brown, constant=constant)),
            assumes=f"K = {constant:g} lb, {kind}",
        )
        for key, constant, kind in cases
    )


def _by_speeds(law: Callable[[float, float, float], float]) -> Callable[[Requirement], float]:
    """Return a law of power, engine and propeller speed as one of a requirement."""
    return lambda need: law(need.power, need.engine_speed, need.propeller_speed)


def _willis() -> tuple[Method, ...]:
    return (
        _arrangement(
            "willis-two-planetary",
            "Willis, two planetary stages",
            _two_planetary,
            assumes=f"{_K}; stages of equal ratio, 3 and 5 planets",
            ranges=(_planetary_range(5, 2),),
        ),
        _arrangement(
            "willis-planetary",
            "Willis, one planetary stage",
            lambda need: laws.mass_willis(need.input_torque, laws.bracket_planetary(need.ratio, 3)),
            assumes=f"{_K}; 3 planets",
            ranges=(_planetary_range(3, 1),),
        ),
        _arrangement(
            "willis-double-branch",
            "Willis, double branch",
            lambda need: laws.mass_willis(
                need.input_torque, laws.bracket_double_branch(math.sqrt(need.ratio), need.ratio)
            ),
            assumes=f"{_K}; pairs of equal ratio",
        ),
        _arrangement(
            "willis-double-reduction",
            "Willis, double reduction",
            lambda need: laws.mass_willis(
                need.input_torque, laws.bracket_double_reduction(math.sqrt(need.ratio), need.ratio)
            ),
            assumes=f"{_K}; pairs of equal ratio",
        ),
    )


def _arrangement(
    key: str, name: str, mass: Callable[[Requirement], float], *, assumes: str, ranges: tuple[Range, ...] = ()
) -> Method:
    return Method(
        key=key,
        name=name,
        formula=_WILLIS_FORMULAS[key],
        source=_WILLIS,
        basis=_WILLIS_BASIS,
        includes=_NOTHING_SAID,
        mass=mass,
        ranges=ranges,
        assumes=assumes,
    )


def _two_planetary(need: Requirement) -> float:
    stage = math.sqrt(need.ratio)
    first = laws.mass_willis(need.input_torque, laws.bracket_planetary(stage, 3))
    return first + laws.mass_willis(need.input_torque * stage, laws.bracket_planetary(stage, 5))


def _planetary_range(planets: int, stages: int) -> Range:
    """Return the ratios between planets of a quarter of the sun and planets that touch each other."""
    sine = math.sin(math.pi / planets)
    greatest = 2.0 + 2.0 * sine / (1.0 - sine)
    minimum = 2.0 + 2.0 * _LEAST_PLANET
    return Range("ratio", minimum**stages, greatest**stages, f"{planets} planets, large enough and clear of each other")
