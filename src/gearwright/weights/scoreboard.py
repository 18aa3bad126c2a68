"""Every method against the 61 real weights: bias and scatter, and how far both hang on what the weights do not tell.

The weights give β alone. A method needs power and two speeds, so ratio and output speed are assumed, alike for all
points: the geometric middle of seven classes of gearbox, and their least and greatest values as corners. What follows
from β without an assumption is exact; how much the rest moves is shown as the span of the bias over the corners.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, partial

import numpy as np

from gearwright.catalogue import gearbox_classes, weighed_gearboxes
from gearwright.units import Number, Ratio, Speed
from gearwright.weights.method import Method, estimate
from gearwright.weights.methods import methods
from gearwright.weights.refit import log_line
from gearwright.weights.requirement import from_beta


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
