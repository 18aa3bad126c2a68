"""Load sharing of parallel load paths: load-sharing coefficients and four methods of solution."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations import (
    dead_zone,
    errors_at,
    line_forces,
    redundancy,
    slow_position,
    steady_forces,
    stiffness_at,
)
from gearwright.dynamics.model import System, top_rate
from gearwright.dynamics.motion import Outputs, Samples, check_shared_load, default_step, line_numbers, simulate
from gearwright.errors import DesignError, Problem
from gearwright.verbs import verb

# ----------------------------------------------------------------------------------------------------------------------
# Load-sharing coefficients: which share of the load each parallel line carries, at an instant, over a tooth cycle.
# ----------------------------------------------------------------------------------------------------------------------


def share_coefficients(force: Floats) -> Floats:
    """Return the load-sharing coefficients of parallel lines, b = n F / Σ F; 1 is an equal share [-].

    Args:
        force: Of the n lines [N], shape (..., n).

    Source: Wang, Zhao, Tao, Jia & Guo, eq. 13, for any number of paths.
    """
    return np.asarray(force.shape[-1] * force / np.sum(force, axis=-1, keepdims=True))


def mesh_load_factor(force: Floats) -> float:
    """Return K_γ: the largest force of parallel meshes over their mean [-].

    Args:
        force: Of the n lines [N], shape (..., n).

    Source: ISO 6336-1:2006, clause 4, mesh load factor.
    """
    return float(np.max(share_coefficients(force)))


def tooth_cycle_means(time: Floats, force: Floats, period: float) -> Floats:
    """Return the forces over each tooth cycle: their means in a window of one mesh period [N].

    Args:
        time: Evenly spaced [s], shape (instants,).
        force: Of the n lines [N], shape (instants, n).
        period: Of the mesh [s].

    Returns:
        Shape (instants − window + 1, n); the window is moved on by one instant at a time.

    Raises:
        DesignError: If the period does not fit the instants.
    """
    spacing = (time[-1] - time[0]) / (len(time) - 1)
    window = round(period / spacing)
    if not 1 < window < len(time):
        message = f"a mesh period of {period:.3g} s does not fit {len(time)} instants {spacing:.3g} s apart"
        raise DesignError([Problem("period", message)])
    total = np.cumsum(np.vstack([np.zeros(force.shape[1]), force]), axis=0)
    return np.asarray((total[window:] - total[:-window]) / window)


def tooth_cycle_shares(time: Floats, force: Floats, period: float) -> Floats:
    """Return the coefficients over each tooth cycle: of the means of the forces in a window of one mesh period.

    Args:
        time: Evenly spaced [s], shape (instants,).
        force: Of the n lines [N], shape (instants, n).
        period: Of the mesh [s].

    Returns:
        [-], shape (instants − window + 1, n).

    Source: Wang, Zhao, Tao, Jia & Guo, eq. 13, "for each tooth frequency cycle", read as the mean.
    """
    return share_coefficients(tooth_cycle_means(time, force, period))


def elastic_forces(system: System, samples: Samples) -> Floats:
    """Return the elastic part of the line forces, k(φ) g(δ) [N or N m], shape (instants, lines).

    Args:
        system: Whose motion it is.
        samples: Instants of a trace.
    """
    stiffness = stiffness_at(system, samples.time)
    return np.asarray(stiffness * dead_zone(samples.line_deflection, system.arrays.backlash))


# ----------------------------------------------------------------------------------------------------------------------
# Load sharing of any train with parallel paths, by four solutions of rising cost that agree where they must.
#
# ===================  ==================================================================================
# quasi-static         closed form from the redundancy: slow errors, teeth may part
# frequency response   mean stiffness, inertia and damping: errors near a natural frequency
# sidebands            varying stiffness as well: tooth ripple, as long as teeth stay in contact
# dynamics             time integration: contact loss and impacts too
# ===================  ==================================================================================
# ----------------------------------------------------------------------------------------------------------------------


Method = Literal["auto", "quasi-static", "frequency response", "sidebands", "dynamics"]
SIDEBANDS = 2
"""Order of the sidebands: sharing coefficients within 2e-3 of the integration (docs/theory/load-sharing.md)."""
AGREE = 0.005
"""Largest difference of a sharing coefficient over a tooth cycle at which the cheaper solution is as good [-]."""
INSTANTS = 24
"""Instants in a period of the fastest harmonic that excites the train."""
LEAST = 16
"""Instants in a mesh period, at least."""
FINE = 3.0
"""Default steps of the integration over the one that is taken: shares near the parting of teeth within 1e-3."""
TRANSIENT = 0.25
"""Time that the integration leaves for its start to die away [s]."""


@dataclass(frozen=True, eq=False)
class LoadSharing:
    """How parallel lines share their load over a stretch of time."""

    lines: tuple[str, ...]
    """Names of the parallel lines."""
    method: str
    """Which solution it is."""
    reason: str
    """Why that one."""
    time: Floats
    """[s], shape (instants,)."""
    force: Floats
    """Elastic forces [N], shape (instants, lines)."""
    period: float
    """Mesh period [s]."""

    @property
    def instantaneous(self) -> Floats:
        """Sharing coefficients b at every instant [-], shape (instants, lines)."""
        return share_coefficients(self.force)

    @property
    def tooth_cycle(self) -> Floats:
        """Sharing coefficients b over each tooth cycle [-], shape (cycles, lines)."""
        return tooth_cycle_shares(self.time, self.force, self.period)

    @property
    def load_factor(self) -> float:
        """K_γ: largest tooth-cycle share over the equal one [-]."""
        return float(np.max(self.tooth_cycle))


@verb
@one_blas_thread()
def load_sharing(
    system: System, lines: Sequence[str], *, method: Method = "auto", span: tuple[float, float] | None = None
) -> LoadSharing:
    """Return how parallel lines share their load.

    Args:
        system: With loads that balance and with its errors.
        lines: Names of the parallel meshes.
        method: ``"auto"`` takes the cheapest solution that is good enough, and says why.
        span: (from, to) [s]; left out: one turn of the slowest error, after the transient.

    Raises:
        DesignError: For names that do not exist, a method that does not, or lines that carry nothing at the start.
    """
    solutions: Mapping[str, Callable[[_Task], LoadSharing]] = {
        "quasi-static": _quasi_static,
        "frequency response": lambda task: _steady(task, 0),
        "sidebands": lambda task: _steady(task, SIDEBANDS),
        "dynamics": _dynamics,
        "auto": _auto,
    }
    check_shared_load(system, lines)
    return solutions[method](_Task(system, tuple(lines), span or _span(system), _period(system, lines)))


@dataclass(frozen=True)
class _Task:
    """What every solution reads."""

    system: System
    lines: tuple[str, ...]
    span: tuple[float, float]
    period: float

    def times(self, longest: float = np.inf) -> Floats:
        """Return evenly spaced instants of the span, a whole number of them in a mesh period."""
        fastest = top_rate(self.system.arrays)
        spacing = min(2.0 * np.pi / (INSTANTS * fastest) if fastest else np.inf, longest, self.period / LEAST)
        step = self.period / np.ceil(self.period / spacing)
        count = round((self.span[1] - self.span[0]) / step) + 1
        return np.asarray(self.span[0] + step * np.arange(count), dtype=np.float64)


def _span(system: System) -> tuple[float, float]:
    """Return one turn of the slowest error after the transient."""
    arrays = system.arrays
    rates = np.abs(arrays.tone_rate[np.unique(arrays.error.tone)])
    slowest = float(np.min(rates[rates > 0.0], initial=np.inf))
    return TRANSIENT, TRANSIENT + (2.0 * np.pi / slowest if np.isfinite(slowest) else TRANSIENT)


def _period(system: System, lines: Sequence[str]) -> float:
    """Return the mesh period of the lines: of the slowest harmonic of their stiffness [s]."""
    arrays = system.arrays
    places = line_numbers(system, lines)
    tones = np.concatenate(
        [arrays.variation.tone[arrays.variation.start[j] : arrays.variation.start[j + 1]] for j in places]
    )
    rates = np.abs(arrays.tone_rate[tones])
    slowest = float(np.min(rates[rates > 0.0], initial=np.inf))
    # Without a varying stiffness there is no ripple to average over, and a thousandth of a second resolves all errors.
    return 2.0 * np.pi / slowest if np.isfinite(slowest) else 1e-3


def _quasi_static(task: _Task) -> LoadSharing:
    time = task.times()
    force = line_forces(redundancy(task.system), errors_at(task.system, time))
    return _result(task, "quasi-static", time, force)


def _steady(task: _Task, sidebands: int) -> LoadSharing:
    time = task.times()
    force = steady_forces(task.system, sidebands=sidebands).at(time)
    return _result(task, "sidebands" if sidebands else "frequency response", time, force)


def _dynamics(task: _Task) -> LoadSharing:
    step = float(task.times(default_step(task.system.arrays) / FINE)[1] - task.span[0])
    spans = (task.span,)
    outputs = Outputs(samples=2, windows=spans)
    start = (slow_position(task.system), np.zeros(len(task.system.arrays.mass)))
    trace = simulate(task.system, task.span[1] + step, step=step, start=start, outputs=outputs, method="runge-kutta")
    samples = trace.whole().windows[0]
    return _result(task, "dynamics", samples.time, elastic_forces(task.system, samples))


def _result(task: _Task, method: str, time: Floats, force: Floats) -> LoadSharing:
    shared = force[:, line_numbers(task.system, task.lines)]
    return LoadSharing(task.lines, method, "asked for", time, shared, task.period)


def _auto(task: _Task) -> LoadSharing:
    """Return the cheapest solution that the next better one confirms."""
    closed = _quasi_static(task)
    if np.min(closed.force) <= 0.0:
        return replace(_dynamics(task), reason="teeth part already when the errors are slow")
    ripple = _steady(task, SIDEBANDS)
    if np.min(ripple.force) <= 0.0:
        return replace(_dynamics(task), reason="teeth part under the tooth ripple: integration with contact loss")
    differ = float(np.max(np.abs(_range(closed) - _range(ripple))))
    if differ <= AGREE:
        return replace(closed, reason=f"closed form: sidebands change no tooth-cycle range by more than {differ:.2%}")
    return replace(ripple, reason=f"sidebands: the closed form is {differ:.2%} off and teeth stay in contact")


def _range(sharing: LoadSharing) -> Floats:
    cycle = sharing.tooth_cycle
    return np.array([np.min(cycle, axis=0), np.max(cycle, axis=0)])
