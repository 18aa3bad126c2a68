"""The one form in which every mesh stiffness model hands over its result: a Fourier series in the mesh phase.

The mesh phase φ grows by 2π per tooth in the direction of the drive and is zero when a tooth pair touches at the
pitch point (at mid face for helical teeth). Written in an angle, not in time, it stays right while speeds change.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, refuse


@dataclass(frozen=True)
class StiffnessCurve:
    """A mesh stiffness along the line of action, k(φ) = mean + Σ cosine_n cos nφ + sine_n sin nφ."""

    mean: float
    """Mean stiffness [N/m]."""
    cosine: tuple[float, ...] = ()
    """Cosine coefficients of harmonics 1, 2, … of the mesh phase [N/m]."""
    sine: tuple[float, ...] = ()
    """Sine coefficients of the same harmonics [N/m]."""
    source: str = ""
    """Model and clause that made the curve."""

    def __post_init__(self) -> None:
        if len(self.cosine) != len(self.sine):
            message = f"{len(self.cosine)} cosine and {len(self.sine)} sine coefficients given; give as many of each"
            raise DesignError([Problem("stiffness", message)])
        if not all(math.isfinite(value) for value in (self.mean, *self.cosine, *self.sine)):
            raise DesignError([Problem("stiffness", "a coefficient is not a finite number")])
        lowest, phase = _lowest(self)
        if not lowest > 0.0:
            message = (
                f"{lowest:.4g} N/m at mesh phase {phase:.3f} rad; a stiffness must be positive: lower the harmonics"
            )
            raise DesignError([Problem("stiffness", message)])


def stiffness_at(curve: StiffnessCurve, phase: ArrayLike) -> Floats:
    """Return the stiffness at given mesh phases.

    Args:
        curve: The curve.
        phase: Mesh phases φ [rad], any shape.

    Returns:
        k [N/m], shape of `phase`.

    Source: definition of the Fourier series.
    """
    angle = np.asarray(phase, dtype=np.float64)
    order = np.arange(1, len(curve.cosine) + 1)
    terms = np.multiply.outer(angle, order)
    return np.asarray(curve.mean + np.cos(terms) @ np.array(curve.cosine) + np.sin(terms) @ np.array(curve.sine))


def curve_of(coefficients: NDArray[Any], source: str) -> StiffnessCurve:
    """Return the curve with given complex Fourier coefficients.

    Args:
        coefficients: Coefficients c_n of e^(i n φ), n = 0, 1, … [N/m], shape (harmonics + 1,).
        source: Model that made them.

    Source: k = c_0 + Σ 2 Re c_n cos nφ − 2 Im c_n sin nφ.
    """
    waves = coefficients[1:]
    cosine, sine = (2.0 * waves.real).tolist(), (-2.0 * waves.imag).tolist()
    return StiffnessCurve(float(coefficients[0].real), tuple(cosine), tuple(sine), source)


def sampled_curve(phase: ArrayLike, stiffness: ArrayLike, *, harmonics: int, source: str) -> StiffnessCurve:
    """Return a user's own curve, given as points over one mesh cycle and joined by straight lines.

    Args:
        phase: Mesh phases [rad], shape (n,), increasing; the cycle closes 2π after the first.
        stiffness: Stiffness at them [N/m], shape (n,), positive. A last point one cycle after the first must repeat it.
        harmonics: Harmonics of the mesh phase to keep [-].
        source: Where the points come from.

    Returns:
        The exact Fourier coefficients of the polygon.

    Source: from the jumps of slope, c_n = −Σ Δs_i e^(−i n φ_i) / (2π n²).

    Raises:
        DesignError: for points that do not increase, are not positive or do not close.
    """
    x, y = np.asarray(phase, dtype=np.float64), np.asarray(stiffness, dtype=np.float64)
    refuse(_sample_problems(x, y))
    if not math.isclose(x[-1] - x[0], 2.0 * math.pi, rel_tol=1e-9):
        x, y = np.append(x, x[0] + 2.0 * math.pi), np.append(y, y[0])
    slope = np.diff(y) / np.diff(x)
    jump = slope - np.roll(slope, 1)
    order = np.arange(1, harmonics + 1)
    waves = -(np.exp(-1j * np.outer(order, x[:-1])) @ jump) / (2.0 * np.pi * order**2)
    mean = float(np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(x))) / (2.0 * math.pi)
    return curve_of(np.concatenate(([mean], waves)), source)


def _lowest(curve: StiffnessCurve) -> tuple[float, float]:
    """Lowest stiffness of a fine sampling of one cycle [N/m] and its phase [rad]."""
    phase = np.linspace(0.0, 2.0 * np.pi, 32 * len(curve.cosine) + 1)
    stiffness = stiffness_at(curve, phase)
    lowest = int(np.argmin(stiffness))
    return float(stiffness[lowest]), float(phase[lowest])


def _sample_problems(x: Floats, y: Floats) -> list[Problem]:
    """What is wrong with a user's points."""
    if x.ndim != 1 or x.shape != y.shape or x.size < 3:
        return [
            Problem("phase", f"shapes {x.shape} and {y.shape} given; give at least 3 phases and as many stiffnesses")
        ]
    problems = []
    if not (np.all(np.isfinite(x)) and np.all(np.diff(x) > 0.0)):
        problems.append(Problem("phase", "the phases must be finite and increase from point to point"))
    elif x[-1] - x[0] > 2.0 * math.pi * (1.0 + 1e-9):
        problems.append(Problem("phase", f"the phases cover {x[-1] - x[0]:.4g} rad; one mesh cycle is 2π"))
    elif math.isclose(x[-1] - x[0], 2.0 * math.pi, rel_tol=1e-9) and not math.isclose(y[0], y[-1], rel_tol=1e-6):
        problems.append(
            Problem("stiffness", f"{y[0]:.6g} N/m at the start and {y[-1]:.6g} N/m one cycle later: not periodic")
        )
    if not (np.all(np.isfinite(y)) and np.all(y > 0.0)):
        index = int(np.argmax(~(y > 0.0)))
        problems.append(
            Problem("stiffness", f"point {index}: {y[index]:.6g} N/m given; a stiffness must be positive and finite")
        )
    return problems
