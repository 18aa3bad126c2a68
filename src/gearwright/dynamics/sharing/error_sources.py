"""Error sources: every single error of a design as what it does to each line, so that thousands of sets cost nothing.

Errors act in proportion. A source is one kind of error of one part; per metre (or radian) of it each line gets a part
that stands and a part that turns. A set of errors is then a sum, and a random set a sum with random sizes and phases.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.arrays import Complexes, Floats, Ints
from gearwright.dynamics.equations import Redundancy
from gearwright.dynamics.model import Contact, Series, System, contact_errors
from gearwright.dynamics.motion import index_of
from gearwright.errors import SolveError
from gearwright.spec.design import PartErrors

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
