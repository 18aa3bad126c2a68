"""All published mass estimating relationships, their regression, and their comparison with published masses."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cache, partial
from types import MappingProxyType
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import HORSEPOWER, POUND, Mass, Number, Problem, Ratio, Shown, Speed, refuse, verb
from gearwright.catalogue import (
    Engine,
    Printed,
    engines as printed_engines,
    gearbox_classes,
    nearest,
    select,
    weighed_gearboxes,
)
from gearwright.weights import laws
from gearwright.weights.laws import Coverage, Estimate, Method, Range, Requirement, estimate, from_beta, mass_afdd00

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


# ----------------------------------------------------------------------------------------------------------------------
# The engine tables of the thesis computed again, with a verdict on every printed number.
#
# Each column is computed from the printed inputs of its row, so that an error does not spread: the gearbox mass by
# NASA'15 with the engine speed of the series, the others from power, speed, printed gearbox mass and the engine's mass.
# That mass is not printed; it is the middle of the interval of masses that reproduces every printed density and
# percentage of the row at once. Columns are in the units of the tables.
# ----------------------------------------------------------------------------------------------------------------------


COLUMNS: Mapping[str, tuple[str, str, str]] = MappingProxyType(
    {
        "gearbox_mass_kg": ("m_GB", "kg", "NASA'15 at the engine speed of the series"),
        "torque_nm": ("Q", "N m", "P / ω_prop"),
        "engine_kw_kg": ("Pd_engine", "kW/kg", "P / m_engine"),
        "turbine_kw_kg": ("Pd_GT", "kW/kg", "P / (m_engine − m_GB)"),
        "gearbox_kw_kg": ("Pd_GB", "kW/kg", "P / m_GB"),
        "torque_nm_kg": ("Qd", "N m/kg", "Q / m_engine"),
        "gearbox_percent": ("%GB", "%", "100 m_GB / m_engine"),
    }
)
"""Column of the tables -> symbol, unit, formula."""


class Verdict(StrEnum):
    """How a printed number compares with the computed one."""

    AGREES = "agrees"
    ROUNDED = "agrees within the rounding of its inputs"
    LAST_DIGIT = "last digit"
    DIFFERS = "differs"
    MISPLACED = "misplaced"
    MEANINGLESS = "meaningless"
    BLANK = "not printed"


@dataclass(frozen=True)
class Check:
    """One printed number beside the computed one, in the unit of its column."""

    column: str
    printed: Printed | None
    computed: float | None
    """None where the row does not say enough."""
    verdict: Verdict
    reason: str
    """Why it is flagged; empty where it agrees."""

    @property
    def difference(self) -> float | None:
        """Computed minus printed, where both are there."""
        return None if self.printed is None or self.computed is None else self.computed - self.printed.value


@dataclass(frozen=True, repr=False)
class CheckedEngine(Shown):
    """One row of the tables with the engine's mass that it implies."""

    engine: Engine
    engine_mass: tuple[float, float] | None
    """Least and greatest mass of the engine [kg] that reproduces the printed row; none where no mass does."""
    checks: tuple[Check, ...]

    @property
    def flagged(self) -> tuple[Check, ...]:
        """The numbers that do not agree."""
        return tuple(
            check for check in self.checks if check.verdict not in (Verdict.AGREES, Verdict.ROUNDED, Verdict.BLANK)
        )

    def check(self, column: str) -> Check:
        """Return the check of a column.

        Args:
            column: Key of `COLUMNS`.
        """
        return next(check for check in self.checks if check.column == column)


@cache
def checked_engines() -> tuple[CheckedEngine, ...]:
    """Return the 121 rows with every printed number checked."""
    return tuple(check_engine(engine) for engine in printed_engines())


def check_engine(engine: Engine) -> CheckedEngine:
    """Return a row with its numbers computed again.

    Args:
        engine: A row of the catalogue.
    """
    mass = _engine_mass(engine)
    spans = _spans(engine, mass)
    checks = tuple(_check(engine, column, spans.get(column)) for column in COLUMNS)
    return CheckedEngine(engine, mass, checks)


def gearbox_mass(engine: Engine) -> float:
    """Return the gearbox mass of an engine by the formula of the tables [kg].

    Args:
        engine: A row of the catalogue.

    Source:
        `ndarc.mass_afdd00` with one rotor (Pulvirenti 2023, eq. 1.2 corrected).
    """
    return mass_afdd00(engine.power, engine.engine_speed, engine.propeller_speed)


class _Span(NamedTuple):
    """What a column may be by computation, as the rounding of the printed inputs allows."""

    minimum: float
    nominal: float
    greatest: float


def _spans(engine: Engine, engine_mass: tuple[float, float] | None) -> dict[str, _Span]:
    power, box = engine.as_printed("power_kw"), engine.as_printed("gearbox_mass_kg")
    assert power is not None and box is not None  # every row has both
    speed = engine.propeller_speed
    torque = 1e3 / speed
    (p0, p1), (m0, m1) = power.bounds, box.bounds
    p, m = power.value, box.value
    by_formula = [mass_afdd00(1e3 * kilowatts, engine.engine_speed, speed) for kilowatts in (p0, p, p1)]
    spans: dict[str, _Span] = {
        "gearbox_mass_kg": _Span(*by_formula),
        "torque_nm": _Span(p0 * torque, p * torque, p1 * torque),
        "gearbox_kw_kg": _Span(p0 / m1, p / m, p1 / m0),
    }
    if engine_mass is not None:
        e0, e1 = engine_mass
        e = 0.5 * (e0 + e1)
        spans |= {
            "engine_kw_kg": _Span(p0 / e1, p / e, p1 / e0),
            "turbine_kw_kg": _Span(p0 / (e1 - m0), p / (e - m), p1 / (e0 - m1)),
            "torque_nm_kg": _Span(p0 * torque / e1, p * torque / e, p1 * torque / e0),
            "gearbox_percent": _Span(100.0 * m0 / e1, 100.0 * m / e, 100.0 * m1 / e0),
        }
    return spans


def _engine_mass(engine: Engine) -> tuple[float, float] | None:
    """Return the masses of the engine that reproduce all four columns in which it stands; None where none does."""
    power, box = engine.as_printed("power_kw"), engine.as_printed("gearbox_mass_kg")
    assert power is not None and box is not None
    p, (m0, m1) = power.value, box.bounds
    torque = 1e3 * p / engine.propeller_speed
    lows, highs = [], []
    for column, low, high, offset in (
        ("engine_kw_kg", p, p, (0.0, 0.0)),
        ("torque_nm_kg", torque, torque, (0.0, 0.0)),
        ("turbine_kw_kg", p, p, (m0, m1)),
        ("gearbox_percent", 100.0 * m0, 100.0 * m1, (0.0, 0.0)),
    ):
        printed = engine.as_meant(column)
        if printed is not None:
            lows.append(low / printed.bounds[1] + offset[0])
            highs.append(high / printed.bounds[0] + offset[1])
    return (max(lows), min(highs)) if lows and max(lows) <= min(highs) else None


def _check(engine: Engine, column: str, span: _Span | None) -> Check:
    printed = engine.as_printed(column)
    computed = None if span is None else span.nominal
    note = engine.note(column)
    if note is not None:
        return Check(column, printed, computed, Verdict(note.verdict), note.reason)
    if printed is None:
        return Check(column, None, computed, Verdict.BLANK, "")
    if span is None:
        return Check(
            column, printed, None, Verdict.DIFFERS, "no engine mass reproduces the columns of this row together"
        )
    return Check(column, printed, computed, *_judge(printed, span))


def _judge(printed: Printed, span: _Span) -> tuple[Verdict, str]:
    low, high = printed.bounds
    slack = 1e-9 * printed.value  # halves in binary
    if low - slack <= span.nominal <= high + slack:
        return Verdict.AGREES, ""
    if span.minimum <= high + slack and span.greatest >= low - slack:
        return Verdict.ROUNDED, ""
    return Verdict.DIFFERS, f"computed {span.nominal:.5g} from the printed inputs"


# ----------------------------------------------------------------------------------------------------------------------
# Every mass method beside the others for one requirement, with the band of the real weights and the mass to take.
# ----------------------------------------------------------------------------------------------------------------------


PARTS = "sum of the parts of the sized design"
"""Origin of a bottom-up mass."""


@dataclass(frozen=True)
class StatedMass:
    """A gearbox mass with its origin, to be carried into every result that uses it."""

    mass: Mass
    """[kg]."""
    origin: str
    """Where it comes from: a method, the design's own sizing, or the user's words."""
    overridden: bool = False
    """Whether the user gave it in place of a computed value."""

    def __post_init__(self) -> None:
        problems = []
        if not (math.isfinite(self.mass) and self.mass > 0.0):
            problems.append(Problem("mass_kg", f"{self.mass!r} was given; a finite mass above zero is needed"))
        if not self.origin.strip():
            problems.append(Problem("origin", "a stated mass needs its origin, such as 'weighed, maintenance manual'"))
        refuse(problems)


@dataclass(frozen=True, repr=False)
class Comparison(Shown):
    """What is known about the mass of a gearbox before it is designed, and after if there is a design."""

    requirement: Requirement
    estimates: tuple[Estimate, ...]
    """One per method, in the order of `methods`."""
    bands: tuple[Band, ...]
    """Prediction bands of the refit, the narrow one first; empty outside the range of its weights."""
    engines: tuple[Engine, ...]
    """Engines of the catalogue that are most alike, the nearest first."""
    bottom_up: StatedMass | None
    """Mass of the design's own parts, where there is a design."""
    stated: StatedMass | None
    """The user's own mass."""

    @property
    def taken(self) -> StatedMass | None:
        """The mass for every later result: the user's own, else the refit's median; a sum of parts stands beside it."""
        return self.stated or self._from_refit()

    @property
    def spread(self) -> tuple[float, float]:
        """Least and greatest mass among the methods that apply [kg]."""
        masses = [answer.mass for answer in self.estimates if answer.mass is not None]
        return min(masses), max(masses)

    def _from_refit(self) -> StatedMass | None:
        best = next(answer for answer in self.estimates if answer.method.key == "refit")
        if best.mass is None:
            return None
        return StatedMass(best.mass, f"{best.method.name}: {best.method.formula} ({best.method.source})")


def compare(
    requirement: Requirement,
    *,
    bottom_up: Mass | StatedMass | None = None,
    stated: StatedMass | None = None,
    count: int = 5,
) -> Comparison:
    """Return every method side by side for a requirement.

    Args:
        requirement: Power and speeds.
        bottom_up: Sum of the parts of a sized design, with its origin or alone [kg].
        stated: The user's own mass with its origin.
        count: How many engines to show [-].

    >>> from gearwright.units import RPM
    >>> result = compare(Requirement(2051e3, 20204 * RPM, 1212 * RPM))
    >>> round(result.taken.mass, 1)
    136.5
    """
    estimates = tuple(estimate(method, requirement) for method in methods())
    has_refit = any(answer.method.key == "refit" and answer.mass is not None for answer in estimates)
    return Comparison(
        requirement=requirement,
        estimates=estimates,
        bands=bands(requirement) if has_refit else (),
        engines=nearest(requirement.power, requirement.engine_speed, requirement.propeller_speed, count=count),
        bottom_up=bottom_up if bottom_up is None or isinstance(bottom_up, StatedMass) else StatedMass(bottom_up, PARTS),
        stated=stated,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Every method against the 61 real weights: bias and scatter, and how far both hang on what the weights do not tell.
#
# The weights give β alone. A method needs power and two speeds, so ratio and output speed are assumed, alike for all
# points: the geometric middle of seven classes of gearbox, and their least and greatest values as corners. What follows
# from β without an assumption is exact; how much the rest moves is shown as the span of the bias over the corners.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Assumption:
    """Ratio and output speed that all weighed gearboxes are taken to have."""

    ratio: Ratio
    """Input speed over output speed [-]."""
    propeller_speed: Speed
    """[rad/s]."""


@dataclass(frozen=True)
class Score:
    """How a method does against the real weights."""

    method: Method
    count: int
    """Number of the 61 weights within the range of the method at the middle assumption."""
    bias: Number | None
    """Geometric mean of estimate over weight [-]; none where no weight is in range."""
    scatter: Number | None
    """Factor of one standard deviation of estimate over weight [-]; none with fewer than three weights."""
    bias_span: tuple[float, float] | None
    """Least and greatest bias over the corners of the assumption [-]; none where a corner is out of range."""

    @property
    def needs_only_beta(self) -> bool:
        """Whether the assumption does not matter to the method."""
        return self.bias_span is not None and math.isclose(*self.bias_span, rel_tol=1e-9)


def middle() -> Assumption:
    """Return the geometric middle of the ratios and output speeds of the classes."""
    ratios, speeds = _class_values()
    return Assumption(math.prod(ratios) ** (1.0 / len(ratios)), math.prod(speeds) ** (1.0 / len(speeds)))


def corners() -> tuple[Assumption, ...]:
    """Return the four corners of the ratios and output speeds of the classes."""
    ratios, speeds = _class_values()
    return tuple(Assumption(r, w) for r in (min(ratios), max(ratios)) for w in (min(speeds), max(speeds)))


def _class_values() -> tuple[list[float], list[float]]:
    """Return ratio and output speed of every class."""
    classes = gearbox_classes()
    ratios = [gearbox.engine_speed / gearbox.output_speed for gearbox in classes]
    return ratios, [gearbox.output_speed for gearbox in classes]


def ratios_to_weights(method: Method, assumption: Assumption) -> list[tuple[float, float]]:
    """Return β and estimate over weight for every weighed gearbox within the range of a method.

    Args:
        method: Of `methods`.
        assumption: Ratio and output speed of all gearboxes.
    """
    requirement = partial(from_beta, ratio=assumption.ratio, propeller_speed=assumption.propeller_speed)
    return [
        (weighed.beta, mass / weighed.mass)
        for weighed in weighed_gearboxes()
        if (mass := estimate(method, requirement(weighed.beta)).mass) is not None
    ]


@cache
def scores() -> tuple[Score, ...]:
    """Return the score of every method, in the order of `methods`."""
    return tuple(_score(method) for method in methods())


def left_out_scatter() -> float:
    """Return the scatter of the refit when each weight is predicted from the other sixty [-].

    A factor of one standard deviation. The refit has seen the weights that it is scored on; this is the fair figure
    to hold beside the other methods.

    Source:
        Leave-one-out cross-validation.
    """
    points = weighed_gearboxes()
    errors = []
    for left_out in points:
        others = [point for point in points if point is not left_out]
        line = log_line([point.beta for point in others], [point.mass for point in others])
        errors.append(math.log10(line.at(left_out.beta) / left_out.mass))
    return float(10.0 ** np.std(errors, ddof=1))


def _score(method: Method) -> Score:
    quotients = [quotient for _, quotient in ratios_to_weights(method, middle())]
    spans = [_bias([q for _, q in ratios_to_weights(method, corner)]) for corner in corners()]
    biases = [span for span in spans if span is not None]
    return Score(
        method=method,
        count=len(quotients),
        bias=_bias(quotients),
        scatter=float(10.0 ** np.std(np.log10(quotients), ddof=1)) if len(quotients) > 2 else None,
        bias_span=(min(biases), max(biases)) if len(biases) == len(spans) else None,
    )


def _bias(quotients: list[float]) -> float | None:
    return float(10.0 ** np.mean(np.log10(quotients))) if quotients else None


# ----------------------------------------------------------------------------------------------------------------------
# What users ask of this layer in one call: what a gearbox weighs, and which engines there are.
# ----------------------------------------------------------------------------------------------------------------------


@verb
def mass(
    power: float,
    engine_speed: float,
    propeller_speed: float,
    *,
    bottom_up: float | None = None,
    stated: StatedMass | None = None,
) -> Comparison:
    """Return what a gearbox weighs by every public method, with the band of the real weights.

    Args:
        power: At the rating that sizes the gearbox [W].
        engine_speed: Of the input [rad/s].
        propeller_speed: Of the propeller or rotor [rad/s].
        bottom_up: Sum of the parts of a sized design, as the total of `gw.complete_mass` [kg].
        stated: The user's own mass with its origin; it wins over every estimate.

    Raises:
        DesignError: If power and speeds are no gearbox's.

    >>> from gearwright.units import RPM
    >>> round(mass(2051e3, 20204 * RPM, 1212 * RPM).taken.mass, 1)
    136.5
    """
    return compare(Requirement(power, engine_speed, propeller_speed), bottom_up=bottom_up, stated=stated)


@verb
def engines(
    *,
    series: str = "",
    manufacturer: str = "",
    kind: Literal["turboprop", "turboshaft"] | None = None,
    model: str = "",
    power: tuple[float, float] | None = None,
) -> tuple[CheckedEngine, ...]:
    """Return engines of the catalogue as printed and computed again; names match by any part, in any case of letters.

    Args:
        series: Such as ``PW100``.
        manufacturer: Such as ``pratt``.
        kind: Of engine; left out: both.
        model: Such as ``127``.
        power: Least and greatest power [W].

    Raises:
        DesignError: If no engine answers to all of it.

    >>> len(engines())
    121
    """
    chosen = select(series=series, manufacturer=manufacturer, kind=kind or "", model=model, power=power)
    return tuple(check_engine(engine) for engine in chosen)
