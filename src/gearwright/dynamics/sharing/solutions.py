"""Load sharing among parallel paths: its solutions, the errors of manufacture and what tolerances give."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import (
    Complexes,
    DesignError,
    Floats,
    Ints,
    Problem,
    SolveError,
    largest_first,
    one_blas_thread,
    verb,
)
from gearwright.dynamics.equations import (
    Redundancy,
    dead_zone,
    errors_at,
    line_forces,
    redundancy,
    slow_position,
    steady_forces,
    stiffness_at,
)
from gearwright.dynamics.model import Contact, Series, System, contact_errors, top_rate
from gearwright.dynamics.motion import (
    Outputs,
    Samples,
    check_shared_load,
    default_step,
    index_of,
    line_numbers,
    simulate,
)
from gearwright.spec.design import PartErrors

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


# ----------------------------------------------------------------------------------------------------------------------
# Error sources: every single error of a design as what it does to each line, so that thousands of sets cost nothing.
#
# Errors act in proportion. A source is one kind of error of one part; per metre (or radian) of it each line gets a part
# that stands and a part that turns. A set of errors is then a sum, and a random set a sum with random sizes and phases.
# ----------------------------------------------------------------------------------------------------------------------


VECTORS = {"eccentricity": "phase", "radial": "radial_angle"}
"""Errors that point somewhere across the shaft, and the field that says where."""
SIGNED = ("axial", "tooth_thickness", "clocking", "pin_radial", "pin_tangential")
"""Errors that have a sign only."""
QUARTER = 0.5 * np.pi
SAME = 1e-9
"""Relative distance under which two frequencies are one [-]."""


@dataclass(frozen=True, eq=False)
class ErrorSource:
    """One kind of error of one part."""

    part: str
    """Gear body, shaft or planet."""
    kind: str
    """``"eccentricity"``, ``"radial"``, ``"axial"``, ``"tooth_thickness"``, ``"clocking"`` or one of a pin."""
    size: float
    """As the design gives it, its tolerance [m or rad]."""
    angle: float
    """Where it points as the design gives it [rad]."""
    still: Floats
    """Error of each line for each unit along two directions across [m/m or m/rad], shape (2, lines)."""
    turning: Complexes
    """Amplitude of each line for each unit, to e^(i|rate|t), shape (lines,); nothing for what stands."""
    rate: float
    """Circular frequency with which it turns [rad/s], negative if backwards; 0 for what stands."""

    @property
    def name(self) -> str:
        """Part and kind, as tables show it."""
        return f"{self.part} {self.kind.replace('_', ' ')}"


@dataclass(frozen=True, eq=False)
class ErrorSets:
    """Many sets of errors, or of the forces that they cause."""

    still: Floats
    """What stands on each line [m or N], shape (sets, lines)."""
    rate: Floats
    """Circular frequencies of what turns [rad/s], shape (rates,)."""
    turning: Complexes
    """Amplitudes on each line [m or N], shape (rates, sets, lines)."""


def error_sources(
    system: System, contacts: Sequence[Contact], parts: Mapping[str, PartErrors]
) -> tuple[ErrorSource, ...]:
    """Return every error that the parts have as a source of its own.

    Args:
        system: Whose lines and speeds they act on.
        contacts: Its meshes in space.
        parts: Gear body, shaft or planet -> errors; their sizes are kept as tolerances.
    """
    sources = []
    for part, errors in parts.items():
        for kind in (*VECTORS, *SIGNED):
            if size := getattr(errors, kind):
                angle = getattr(errors, VECTORS[kind]) if kind in VECTORS else 0.0
                sources.append(replace(unit_source(system, contacts, part, kind), size=size, angle=angle))
    return tuple(sources)


def unit_source(system: System, contacts: Sequence[Contact], part: str, kind: str) -> ErrorSource:
    """Return one error of size 1, such as a clocking angle that is looked for.

    Args:
        system: Whose lines and speeds it acts on.
        contacts: Its meshes in space.
        part: Gear body, shaft or planet.
        kind: Field of `PartErrors`.
    """
    lines = len(system.labels.lines)
    still, turning, rate = np.zeros((2, lines)), np.zeros(lines, dtype=np.complex128), 0.0
    speed = dict(zip(system.labels.coordinates, system.arrays.speed, strict=True))
    for contact in contacts:
        line = index_of(contact.line, system.labels.lines, "line")
        for direction in range(2 if kind in VECTORS else 1):
            fields = {kind: 1.0} | ({VECTORS[kind]: direction * QUARTER} if kind in VECTORS else {})
            unit = PartErrors.model_construct(None, **fields)  # an influence of size 1, beyond what a file may ask for
            for error in contact_errors(contact, {part: unit}):
                still[direction, line] += error.constant
                if error.phase and direction == 0:
                    signed = float(sum(count * speed[name] for name, count in error.phase.items()))
                    amplitude = complex(error.cosine[0], -error.sine[0])
                    turning[line] += amplitude if signed > 0.0 else amplitude.conjugate()
                    rate = signed
    return ErrorSource(part, kind, 1.0, 0.0, still, turning, rate)


def as_forces(train: Redundancy, sources: Sequence[ErrorSource], lines: Ints) -> tuple[ErrorSource, ...]:
    """Return the sources with the forces on parallel lines that they cause in place of their errors.

    Args:
        train: From `redundancy`.
        sources: From `error_sources`.
        lines: Places of the n parallel lines.

    Returns:
        Sources with ``still`` (2, n) and ``turning`` (n,) [N/m or N/rad].
    """
    gain = train.gain[:, lines]
    return tuple(replace(source, still=source.still @ gain, turning=source.turning @ gain) for source in sources)


def drawn_set(sources: Sequence[ErrorSource]) -> ErrorSets:
    """Return the errors as the design gives them, one set.

    Args:
        sources: From `error_sources`, or `as_forces`.
    """
    size, angle = (np.array([getattr(source, name) for source in sources]) for name in ("size", "angle"))
    return _combine(sources, np.stack([size * np.cos(angle), size * np.sin(angle)], axis=1)[:, :, None])


def random_sets(sources: Sequence[ErrorSource], count: int, *, seed: int, sizes: Floats | None = None) -> ErrorSets:
    """Return sets of errors at their full size with random phases; what has only a sign is uniform within its size.

    Args:
        sources: From `error_sources`, or `as_forces`.
        count: Number of sets.
        seed: Of the random numbers: the same seed gives the same sets.
        sizes: Tolerance of each source [m or rad]; left out: as given.
    """
    draw = np.random.default_rng(seed)
    angle = draw.uniform(0.0, 2.0 * np.pi, (len(sources), count))
    share = draw.uniform(-1.0, 1.0, (len(sources), count))
    size = np.array([abs(source.size) for source in sources]) if sizes is None else sizes
    vector = np.array([source.kind in VECTORS for source in sources])[:, None]
    across = np.stack([np.where(vector, np.cos(angle), share), np.where(vector, np.sin(angle), 0.0)], axis=1)
    return _combine(sources, size[:, None, None] * across)


def _combine(sources: Sequence[ErrorSource], weights: Floats) -> ErrorSets:
    """Sum the sources with weights (sources, 2, sets) across; of what turns they are real and imaginary part."""
    lines, count = len(sources[0].turning) if sources else 0, weights.shape[2]
    basis = np.array([source.still for source in sources]).reshape(-1, lines)
    still = weights.reshape(-1, count).T @ basis
    # Where a part turns backwards, so does the angle from which it starts.
    sense = np.array([1.0 if source.rate >= 0.0 else -1.0 for source in sources])
    phasor = weights[:, 0] + 1j * sense[:, None] * weights[:, 1]
    groups = _groups(sources)
    turning = np.zeros((len(groups), count, lines), dtype=np.complex128)
    for number, members in enumerate(groups.values()):
        turning[number] = phasor[members].T @ np.array([sources[k].turning for k in members])
    return ErrorSets(still, np.array(list(groups), dtype=np.float64), turning)


def _groups(sources: Sequence[ErrorSource]) -> dict[float, list[int]]:
    """Return the distinct rates of what turns, and the sources that turn with each."""
    groups: dict[float, list[int]] = {}
    for number, source in enumerate(sources):
        if rate := abs(source.rate):
            group = next((known for known in groups if abs(known / rate - 1.0) < SAME), rate)
            groups.setdefault(group, []).append(number)
    return groups


def peak_shares(perfect: Floats, forces: ErrorSets) -> Floats:
    """Return the largest sharing coefficient of each line over time, when all that turns has come together once.

    Args:
        perfect: Forces of the n parallel lines without errors [N], shape (n,).
        forces: What the errors add, from sources `as_forces`.

    Returns:
        b [-], shape (sets, n), at most n: then the line carries all.

    Valid for: slow errors with frequencies that have no common multiple, and a total force that does not change. Where
        other lines part it is an upper bound, as they can take no less than nothing.
    """
    still = perfect + forces.still
    swing = np.sum(np.abs(forces.turning), axis=0)
    count = len(perfect)
    return np.asarray(np.clip(count * (still + swing) / np.sum(still, axis=1, keepdims=True), 0.0, count))


def with_errors(system: System, sets: ErrorSets) -> list[System]:
    """Return a system for each set, of one structure, so that they can be simulated side by side.

    Args:
        system: Whose own errors are replaced; it has all tones that the sets need.
        sets: Sets of errors.

    Raises:
        SolveError: If no tone of the system turns as fast as an error.
    """
    arrays, lines = system.arrays, len(system.labels.lines)
    rates = np.concatenate([[0.0], sets.rate])
    tones = np.array([int(np.argmin(np.abs(np.abs(arrays.tone_rate) - rate))) for rate in rates], dtype=np.int64)
    missing = rates[np.abs(np.abs(arrays.tone_rate[tones]) - rates) > SAME * rates]
    if np.any(missing) or (len(missing) and np.any(sets.still)):
        fastest = float(np.max(missing))
        raise SolveError(f"no tone of the system turns at {fastest:.6g} rad/s; build it with errors of these parts")
    sense = np.where(arrays.tone_rate[tones] < 0.0, -1.0, 1.0)[:, None]
    used = np.flatnonzero(np.any(sets.still != 0.0, axis=0) | np.any(sets.turning != 0.0, axis=(0, 1)))
    start = np.zeros(lines + 1, dtype=np.int64)
    start[used + 1] = len(rates)
    start = np.cumsum(start)
    repeated = np.tile(tones, len(used))
    systems = []
    for number, still in enumerate(sets.still):
        phasor = np.vstack([still[used], sets.turning[:, number, used]])
        series = Series(start, repeated, phasor.real.T.ravel(), (-sense * phasor.imag).T.ravel())
        systems.append(replace(system, arrays=arrays._replace(error=series)))
    return systems


# ----------------------------------------------------------------------------------------------------------------------
# Studies of load sharing by its closed form: which error matters, what chance makes of them all, how to clock.
#
# Shares are those of the most loaded of n parallel lines, as a fraction of the load: 0.52 of two paths is 52/48.
# ----------------------------------------------------------------------------------------------------------------------


SETS = 5000
"""Random sets of a study."""


@dataclass(frozen=True)
class Influence:
    """What one error alone does to the sharing."""

    source: str
    """Part and kind."""
    kind: str
    """Of the error."""
    size: float
    """Of the error [m or rad]."""
    turns: bool
    """True if its effect comes and goes with a shaft, False if it stays."""
    effect: float
    """Largest change of a sharing coefficient b that it causes [-]."""
    gain: float
    """The same for each unit of error [1/m or 1/rad]."""


def influences(train: Redundancy, sources: Sequence[ErrorSource], lines: Ints) -> tuple[Influence, ...]:
    """Return what every error does alone, the largest first.

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.
    """
    gains = effect_gains(train, sources, lines)
    effects = [
        Influence(
            source.name, source.kind, abs(source.size), source.rate != 0.0, float(gain * abs(source.size)), float(gain)
        )
        for source, gain in zip(sources, gains, strict=True)
    ]
    return tuple(largest_first(effects, lambda influence: influence.effect))


def effect_gains(train: Redundancy, sources: Sequence[ErrorSource], lines: Ints) -> Floats:
    """Return the change of the most affected b for each unit of every error, in its worst direction [1/m or 1/rad].

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.

    Returns:
        Shape (sources,).
    """
    forces = as_forces(train, sources, lines)
    still = np.array([force.still for force in forces]).reshape(-1, 2, len(lines))
    turning = np.array([force.turning for force in forces]).reshape(-1, len(lines))
    scale = len(lines) / float(np.sum(train.perfect[lines]))
    return np.asarray(scale * np.max(np.linalg.norm(still, axis=1) + np.abs(turning), axis=1, initial=0.0))


@dataclass(frozen=True, eq=False)
class Distribution:
    """What chance makes of all errors together."""

    peak: Floats
    """Share of the most loaded line, at its worst moment, of each set [-], shape (sets,)."""
    seed: int
    """Of the random numbers."""

    def percentile(self, percent: float) -> float:
        """Return the share that so many percent of all gearboxes stay below [-].

        Args:
            percent: 0 to 100.
        """
        return float(np.percentile(self.peak, percent))


def monte_carlo(
    train: Redundancy, sources: Sequence[ErrorSource], lines: Ints, *, count: int = SETS, seed: int = 1
) -> Distribution:
    """Return the peak shares of many gearboxes whose errors have full size and random phases.

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.
        count: Number of gearboxes.
        seed: Of the random numbers.
    """
    return Distribution(random_peaks(train, sources, lines, count=count, seed=seed), seed)


def random_peaks(
    train: Redundancy, sources: Sequence[ErrorSource], lines: Ints, *, count: int, seed: int,
    sizes: Floats | None = None,
) -> Floats:  # fmt: skip
    """Return the share of the most loaded line, at its worst moment, of many random gearboxes [-], shape (count,).

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.
        count: Number of gearboxes.
        seed: Of the random numbers.
        sizes: Of each error [m or rad]; left out: as given.
    """
    forces = random_sets(as_forces(train, sources, lines), count, seed=seed, sizes=sizes)
    return np.asarray(np.max(peak_shares(train.perfect[lines], forces), axis=1) / len(lines))


@dataclass(frozen=True)
class Clocking:
    """Angles between gears of one shaft that make the paths share equally."""

    angles: tuple[tuple[str, float], ...]
    """Gear -> angle on its shaft [rad], positive as it turns positively."""
    window: float
    """Half width of the angles that keep the target, all paths but one at their best [rad]."""
    target: float
    """Share that the window keeps [-]."""


def clocking_optimum(
    system: System, contacts: Sequence[Contact], train: Redundancy, lines: Ints, *, target: float = 0.53
) -> Clocking:
    """Return the clocking angles at which parallel paths share equally, and the window that keeps a share.

    Args:
        system: Whose paths they are.
        contacts: Its meshes in space.
        train: From `redundancy`, with the loads and the errors that stand left out.
        lines: Places of the n parallel lines.
        target: Largest share that is allowed [-].

    Source: clocking of split-path transmissions after Krantz & Delgado 1996, NASA TM-107202; here in closed form.
    """
    gears = _clocked(system, contacts, lines)
    units = [unit_source(system, contacts, gear, "clocking") for gear in gears]
    slopes = np.array([unit.still[0] @ train.gain[:, lines] for unit in units])
    total = float(np.sum(train.perfect[lines]))
    miss = total / len(lines) - train.perfect[lines]
    angles = np.linalg.lstsq(slopes.T, miss, rcond=None)[0]
    steepest = float(np.max(np.abs(slopes[-1]))) / total
    pairs = tuple((gear, float(angle)) for gear, angle in zip(gears, angles, strict=True))
    return Clocking(pairs, (target - 1.0 / len(lines)) / steepest, target)


def _clocked(system: System, contacts: Sequence[Contact], lines: Ints) -> list[str]:
    """Return the gear that each path but the first has of its own, so that turning it shifts the load."""
    names = [system.labels.lines[line] for line in lines]
    rows = [contact for contact in contacts if contact.line in names]
    common = set.intersection(*({side.gear for side in contact.sides} for contact in rows)) if rows else set()
    gears = [next(side.gear for side in contact.sides if side.gear not in common) for contact in rows]
    if len(gears) < 2:
        raise DesignError([Problem("lines", f"{names} are no parallel paths; name the meshes of one stage")])
    return gears[1:]


# ----------------------------------------------------------------------------------------------------------------------
# Tolerance allocation: which tolerance to tighten, and how far, so that paths share as asked at least cost.
# ----------------------------------------------------------------------------------------------------------------------


JUDGING_SETS = 2000
"""Random gearboxes that judge an allocation."""
HALVINGS = 40
"""Halvings of the search: sizes within a billionth."""
WIDEST = 1e16
"""Range of the multiplier that is searched [-]: sizes down to a hundred-millionth of the given ones."""


class Tightened(NamedTuple):
    """One tolerance."""

    error: str
    """Part and kind."""
    kind: str
    """Of the error."""
    given: float
    """Its size as given [m or rad]."""
    allowed: float
    """What is allowed of it [m or rad]."""


@dataclass(frozen=True)
class Allocation:
    """How tight every tolerance must be for a share, at least cost."""

    target: float
    """Share of the most loaded line [-]."""
    percent: float
    """Percentage of gearboxes that keep it."""
    sizes: tuple[Tightened, ...]
    """Every tolerance."""
    reached: float
    """Share that the allowed sizes keep for that percentage [-]."""
    cost: float
    """Σ given/allowed over all errors, less their number: 0 if nothing must be tightened [-]."""


def allocate(
    train: Redundancy, sources: Sequence[ErrorSource], lines: Ints, *, target: float, percent: float = 95.0,
    seed: int = 1,
) -> Allocation:  # fmt: skip
    """Return the tolerances that keep a share in most gearboxes at least cost.

    The cost of a tolerance is taken to grow as its reciprocal, and the peak as the sum of effects: then the cheapest
    sizes are t = min(t₀, √(t₀/(λ g))), g the influence of a unit. One number λ is left, and chance decides it.

    Args:
        train: From `redundancy`.
        sources: Every single error, with the sizes from which to tighten.
        lines: Places of the n parallel lines.
        target: Largest share that is allowed [-], such as 0.52.
        percent: Percentage of gearboxes that must keep it.
        seed: Of the random numbers.

    Raises:
        DesignError: If the target is no share, or below what the train gives without any error.

    Source: reciprocal cost model and its Lagrange multiplier, Chase & Greenwood 1988, Manufacturing Review 1(1).
    """
    drawn = np.array([abs(source.size) for source in sources])
    gain = effect_gains(train, sources, lines)
    perfect = float(np.max(train.perfect[lines]) / np.sum(train.perfect[lines]))
    if not perfect < target < 1.0:
        message = (
            f"{target:.4g} cannot be kept: without any error the most loaded path has {perfect:.4g}; "
            "give more, or clock the gears so that the paths share equally"
        )
        raise DesignError([Problem("target", message)])

    def share(sizes: Floats) -> float:
        peaks = random_peaks(train, sources, lines, count=JUDGING_SETS, seed=seed, sizes=sizes)
        return float(np.percentile(peaks, percent))

    sizes = drawn if share(drawn) <= target else _tightened(drawn, gain, share, target=target)
    rows = tuple(
        Tightened(source.name, source.kind, float(given), float(allowed))
        for source, given, allowed in zip(sources, drawn, sizes, strict=True)
    )
    return Allocation(target, percent, rows, share(sizes), float(np.sum(drawn / sizes) - len(drawn)))


def _tightened(drawn: Floats, gain: Floats, share: Callable[[Floats], float], *, target: float) -> Floats:
    """Return the largest sizes of the family t(λ) that keep the target, by bisection in the logarithm of λ."""

    def sizes(multiplier: float) -> Floats:
        with np.errstate(divide="ignore"):
            return np.asarray(np.minimum(drawn, np.sqrt(drawn / (multiplier * gain))))

    low = 1.0 / float(np.max(gain * drawn))
    high = low * WIDEST
    for _ in range(HALVINGS):
        middle = float(np.sqrt(low * high))
        low, high = (low, middle) if share(sizes(middle)) <= target else (middle, high)
    return sizes(high)
