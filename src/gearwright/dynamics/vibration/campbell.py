"""Campbell diagram: natural frequencies and excitation orders over speed, and modes of planetary stages."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from gearwright.arrays import Floats, place_of_largest, place_of_smallest, smallest_first
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations import DampedModes, Modes, damped_modes
from gearwright.dynamics.model import (
    PIN,
    Excitation,
    Labels,
    Owner,
    System,
    Tone,
    entry_matrix,
    finite_numbers,
    refuse_not_finite,
)
from gearwright.dynamics.vibration.response import numbers
from gearwright.errors import DesignError, Problem, near
from gearwright.identity import MEMBERS, Role, Row, gear_part, member_part, mesh_part
from gearwright.showing import Shown, frame
from gearwright.verbs import verb

# ----------------------------------------------------------------------------------------------------------------------
# Campbell diagram: damped natural frequencies against speed, the orders that excite, and where the two meet.
# ----------------------------------------------------------------------------------------------------------------------


FACTORS = tuple(np.linspace(0.1, 1.5, 29))
"""Speeds over the operating speed that are looked at [-]."""


@dataclass(frozen=True)
class Order:
    """An excitation whose frequency is proportional to speed."""

    tone: Tone
    """Which shafts' angles it is made of; empty for one of a machine or of teeth that no line makes."""
    frequency: float
    """At the reference speeds [Hz]."""
    excitation: Excitation | None = None
    """What makes it, where no line does: blades, poles, slots, planets that pass."""

    def __str__(self) -> str:
        return str(self.tone) if self.excitation is None else self.excitation.name


@dataclass(frozen=True)
class Crossing:
    """A speed at which an order meets a natural frequency."""

    order: Order
    """What excites."""
    mode: int
    """Which mode, counted along the diagram's columns."""
    factor: float
    """Speed over reference speed [-]."""
    frequency: float
    """[Hz]."""


@dataclass(frozen=True, eq=False, repr=False)
class Campbell(Shown):
    """Natural frequencies followed over speed by their shapes."""

    factor: Floats
    """Speed over reference speed [-], shape (speeds,)."""
    frequency: Floats
    """Damped natural frequencies [Hz], shape (speeds, modes)."""
    damping: Floats
    """Damping ratios [-], shape (speeds, modes)."""
    whirl: Floats
    """How far gyroscopic terms raise each frequency, dω/ω over dΩ/Ω [-], shape (speeds, modes): positive for forward
    whirl, negative for backward whirl, zero for modes that do not turn."""
    orders: tuple[Order, ...]
    """What excites."""
    crossings: tuple[Crossing, ...]
    """Every meeting within the range of speeds, by rising speed."""

    def to_dataframe(self) -> Any:
        """Return a pandas ``DataFrame``: natural frequencies [Hz] over the speed factor [-], a column for each mode."""
        modes = {f"mode {number}": (column, "Hz") for number, column in enumerate(self.frequency.T, start=1)}
        return frame({"factor": (self.factor, "1"), **modes}, "factor")

    def margins(self, factor: float = 1.0) -> list[tuple[float, Order, int]]:
        """Return for each mode its nearest order at one speed: (relative distance, order, mode), nearest first.

        Args:
            factor: Speed over reference speed [-].
        """
        margins = []
        for mode, column in enumerate(self.frequency.T):
            frequency = float(np.interp(factor, self.factor, column))
            distances = [order.frequency * factor / frequency - 1.0 for order in self.orders]
            if distances:
                nearest = place_of_smallest(np.abs(distances))
                margins.append((float(distances[nearest]), self.orders[nearest], mode))
        return smallest_first(margins, lambda margin: abs(margin[0]))


@verb
@one_blas_thread()
def campbell(system: System, factors: Sequence[float] | Floats = FACTORS) -> Campbell:
    """Return natural frequencies at each speed, followed by their shapes, with all tones and shaft speeds as orders.

    Args:
        system: With reference speeds, from `assemble`.
        factors: Rising speeds over the reference speeds [-]; left out: 0.1 to 1.5. `figure` draws the diagram.

    Raises:
        DesignError: For speeds that do not rise.
        SolveError: If a number of the system or a frequency is not finite; with the part.

    Source:
        Shapes are paired from speed to speed by the assignment of largest total modal assurance criterion,
        Allemang 2003, Sound and Vibration 37(8).
    """
    speeds = numbers(factors, "factors")
    if len(speeds) < 2 or np.any(np.diff(speeds) <= 0.0):
        raise DesignError([Problem("factors", f"give at least two rising speeds; given {speeds.tolist()}")])
    with finite_numbers(system):
        tracked = _tracked(system, speeds)
        table = np.array([modes.rate for modes in tracked], dtype=np.complex128)
    modes = [f"mode {number}" for number in range(1, 1 + table.shape[1])]
    refuse_not_finite(table, modes, "frequency")
    frequency, orders = table.imag / (2.0 * np.pi), tuple(_orders(system))
    damping = -table.real / np.abs(table)
    whirl = np.array([_whirl(system, at, factor) for at, factor in zip(tracked, speeds.tolist(), strict=True)])
    crossings = smallest_first(_crossings(speeds, frequency, orders), lambda crossing: crossing.factor)
    return Campbell(speeds, frequency, damping, whirl, orders, tuple(crossings))


def _tracked(system: System, speeds: Floats) -> list[DampedModes]:
    """Return the modes at each speed, each in its own place."""
    rows = [damped_modes(system.arrays, float(speeds[0]))]
    for factor in speeds[1:].tolist():
        later = damped_modes(system.arrays, factor)
        order = _pairing(system.arrays.mass, rows[-1], later)
        rows.append(DampedModes(later.rate[order], later.shape[:, order]))
    return rows


def _whirl(system: System, modes: DampedModes, factor: float) -> Floats:
    """Return how far gyroscopic terms raise each frequency at one speed [-].

    Source: derivative of φᴴ (λ² M + λ s G + K) φ = 0 by s at a mode of unit length in M, exact without damping:
        λ'/λ = −φᴴ G φ/(2 λ + s φᴴ G φ).
    """
    turning = entry_matrix(system.arrays.gyroscopic, len(system.arrays.mass))
    shares = np.einsum("am,ab,bm->m", modes.shape.conj(), turning, modes.shape, optimize=True)
    return np.asarray((-factor * shares / (2.0 * modes.rate + factor * shares)).real)


def _pairing(mass: Floats, before: DampedModes, after: DampedModes) -> list[int]:
    """Return which mode after belongs to each one before."""
    if len(before.rate) != len(after.rate):
        raise DesignError(
            [Problem("factors", "a mode stops oscillating in this range of speeds; choose a smaller one")]
        )
    assurance = np.abs(before.shape.conj().T @ (mass[:, None] * after.shape)) ** 2
    # Of repeated modes any pairing of shapes is as good: the nearest frequency decides.
    first = before.rate[:, None]
    apart = np.abs(first - after.rate) / np.maximum(np.abs(first), np.abs(after.rate))
    likeness = assurance - apart
    best = np.argmax(likeness, axis=1)
    if len(set(best.tolist())) < len(best):  # two modes want the same one
        from scipy.optimize import linear_sum_assignment  # takes longer to load than this layer, and is seldom needed

        best = linear_sum_assignment(likeness, maximize=True)[1]
    return [int(place) for place in best]


def _orders(system: System) -> Iterator[Order]:
    """Yield every tone that turns, every order of machines and teeth, and the speeds of shafts that neither has."""
    arrays, labels, seen = system.arrays, system.labels, list[float]()
    used = np.unique(np.concatenate([arrays.variation.tone, arrays.error.tone])).astype(int)
    for tone, rate in ((labels.tones[place], float(arrays.tone_rate[place])) for place in used):
        yield from _new(Order(tone, abs(rate) / (2.0 * np.pi)), seen)
    stated = [Order(Tone(()), order.rate / (2.0 * np.pi), order) for order in labels.orders if order.rate > 0.0]
    yield from stated
    seen += [order.frequency for order in stated]
    for name, speed in zip(labels.coordinates, arrays.speed, strict=True):
        yield from _new(Order(Tone(((name, 1),)), abs(float(speed)) / (2.0 * np.pi)), seen)


def _new(order: Order, seen: list[float]) -> Iterator[Order]:
    """Yield an order that turns, unless one of its frequency was seen before."""
    if order.frequency > 0.0 and not any(abs(order.frequency - known) < 1e-9 * order.frequency for known in seen):
        seen.append(order.frequency)
        yield order


def _crossings(factor: Floats, frequency: Floats, orders: Sequence[Order]) -> Iterator[Crossing]:
    for order in orders:
        gap = order.frequency * factor - frequency.T
        for mode, i in np.argwhere(np.sign(gap[:, :-1]) * np.sign(gap[:, 1:]) < 0.0).tolist():
            before, after = gap[mode, i : i + 2].tolist()
            place = float(factor[i] + (factor[i + 1] - factor[i]) * before / (before - after))
            yield Crossing(order, mode, place, order.frequency * place)


# ----------------------------------------------------------------------------------------------------------------------
# What modes and forces say about a planetary set: the family of each mode, the share of each planet.
# ----------------------------------------------------------------------------------------------------------------------


Family = Literal["rigid", "rotational", "translational", "planet", "mixed"]
PURE = 0.99
"""Share of a mode's kinetic energy from which it counts as one of a family [-]."""


def family_shares(system: System, modes: Modes, positions: Sequence[float], *, name: str = "") -> Floats:
    """Return how much of each mode's kinetic energy is rotational, translational and of the planets alone.

    Args:
        system: A system with one planetary set of equal planets.
        modes: Its modes.
        positions: Angles of the planets ψ_n [rad].
        name: Name of the set.

    Returns:
        Shares [-], shape (3, modes): central rotations and what all planets do alike; central translations and what the
        planets do as cos ψ_n and sin ψ_n; the rest of the planets' motion. What is not of the set is in none.

    Source: Lin & Parker 1999, J. Vib. Acoust. 121, 316-321, section on the structure of the modes.
    """
    motion = modes.shapes * np.sqrt(system.arrays.mass)[:, None]
    place = {owner: number for number, owner in enumerate(system.labels.coordinate_owners)}
    shares = np.zeros((3, motion.shape[1]))
    for member in MEMBERS:
        for family, directions in ((0, ("",)), (1, ("x", "y"))):
            owners = [Owner(member_part(name, member), direction) for direction in directions]
            rows = [place[owner] for owner in owners if owner in place]
            shares[family] += np.sum(motion[rows] ** 2, axis=0)
    alike, waves = _planet_patterns(positions)
    numbers = range(1, len(positions) + 1)
    for direction in ("", *PIN):
        owners = [Owner(gear_part(name, Role.PLANET, number=number), direction) for number in numbers]
        if owners[0] not in place:
            continue
        planets = motion[[place[owner] for owner in owners]]
        parts = [np.sum((basis.T @ planets) ** 2, axis=0) for basis in (alike, waves)]
        shares += np.array([*parts, np.sum(planets**2, axis=0) - parts[0] - parts[1]])
    return shares


def mode_families(system: System, modes: Modes, positions: Sequence[float], *, name: str = "") -> tuple[Family, ...]:
    """Return the family of each mode of a planetary set.

    Args:
        system: A system with one planetary set of equal planets.
        modes: Its modes.
        positions: Angles of the planets ψ_n [rad].
        name: Name of the set.

    Returns:
        ``"rigid"``, ``"rotational"``, ``"translational"``, ``"planet"``, or ``"mixed"`` where the planets' places are
        not even, or where other parts of the train move along.

    Source: Lin & Parker 1999: 6 rotational modes, 6 pairs of translational ones, 3 planet modes of multiplicity N − 3.
    """
    shares = family_shares(system, modes, positions, name=name)
    names: tuple[Family, ...] = ("rotational", "translational", "planet")
    families: list[Family] = []
    for mode in range(shares.shape[1]):
        largest = place_of_largest(shares[:, mode])
        family: Family = names[largest] if shares[largest, mode] >= PURE else "mixed"
        families.append("rigid" if mode < modes.rigid else family)
    return tuple(families)


def load_shares(force: Floats, labels: Labels, *, name: str = "") -> Floats:
    """Return the share of each planet in the torque of the sun.

    Args:
        force: Line forces [N], shape (lines,) or (lines, instants).
        labels: Names of the lines.
        name: Name of the set.

    Returns:
        Shares [-], shape (planets,) or (planets, instants); N times the largest is the mesh load factor K_γ.

    Source: definition of K_γ, ISO 6336-1:2006, clause 4.
    """
    row = mesh_part(name, Row.SUN_PLANET)
    rows = list(labels.places_of(row))
    if not rows:
        raise DesignError([Problem(str(row), f"there is no such mesh; {near(str(row), labels.lines)}")])
    return np.asarray(force[rows] / np.sum(force[rows], axis=0))


def _planet_patterns(positions: Sequence[float]) -> tuple[Floats, Floats]:
    """Orthonormal patterns over the planets: all alike, and the two waves once around."""
    angles = np.asarray(positions)
    alike = np.ones((len(angles), 1)) / np.sqrt(len(angles))
    waves = np.column_stack([np.cos(angles), np.sin(angles)])
    waves = waves - alike @ (alike.T @ waves)
    vectors, singular, _ = np.linalg.svd(waves, full_matrices=False)
    return alike, vectors[:, singular > 1e-9]
