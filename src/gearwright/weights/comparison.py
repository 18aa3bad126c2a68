"""Comparison of gearbox mass estimates, and their bias and scatter against published masses."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, partial
from typing import Literal

import numpy as np

from gearwright.catalogue import Engine, gearbox_classes, nearest, select, weighed_gearboxes
from gearwright.errors import Problem, refuse
from gearwright.showing import Shown
from gearwright.units import Mass, Number, Ratio, Speed
from gearwright.verbs import verb
from gearwright.weights.engine_check import CheckedEngine, check_engine
from gearwright.weights.laws import Estimate, Method, Requirement, estimate, from_beta
from gearwright.weights.methods import Band, bands, log_line, methods

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
