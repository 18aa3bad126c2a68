"""Critical speeds with separation margins, and dynamic load factors of simulated peaks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np

from gearwright.base import (
    GEARBOX,
    MEMBERS,
    ROUNDING,
    Check,
    Complexes,
    DesignError,
    Floats,
    Frequency,
    GearwrightError,
    Kind,
    Origin,
    PartId,
    Problem,
    Quantity,
    Ratio,
    Role,
    Row,
    Shown,
    Speed,
    by_name,
    frame,
    gear_part,
    member_part,
    mesh_part,
    near,
    not_assessed,
    one_blas_thread,
    place_of_largest,
    place_of_smallest,
    refuse,
    smallest_first,
    verb,
)
from gearwright.dynamics.assembly import assemble, bodies_of
from gearwright.dynamics.equations import DampedModes, Linear, Modes, damped_modes, linear, statics
from gearwright.dynamics.model import (
    PIN,
    Excitation,
    Labels,
    Owner,
    System,
    Tone,
    entry_matrix,
    finite_numbers,
    line_matrix,
    plan_of,
    refuse_not_finite,
)
from gearwright.dynamics.motion import Outputs, Trace, simulate
from gearwright.dynamics.vibration.response import UNLOADED, numbers, series_terms
from gearwright.sizing import MeshSizing, Sizing

# ----------------------------------------------------------------------------------------------------------------------
# Campbell diagram: damped natural frequencies against speed, the orders that excite, and where the two meet.
# ----------------------------------------------------------------------------------------------------------------------


FACTORS = tuple(np.linspace(0.1, 1.5, 29))
"""Speeds over the operating speed that are looked at [-]."""


@dataclass(frozen=True)
class OrderLine:
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

    order: OrderLine
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
    orders: tuple[OrderLine, ...]
    """What excites."""
    crossings: tuple[Crossing, ...]
    """Every meeting within the range of speeds, by rising speed."""

    def to_dataframe(self) -> Any:
        """Return a pandas ``DataFrame``: natural frequencies [Hz] over the speed factor [-], a column for each mode."""
        modes = {f"mode {number}": (column, "Hz") for number, column in enumerate(self.frequency.T, start=1)}
        return frame({"factor": (self.factor, "1"), **modes}, "factor")

    def margins(self, factor: float = 1.0) -> list[tuple[float, OrderLine, int]]:
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
    arrays = plan_of(system.arrays)  # whose natural modes are found once for all speeds
    rows = [damped_modes(arrays, float(speeds[0]))]
    for factor in speeds[1:].tolist():
        later = damped_modes(arrays, factor)
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


def _orders(system: System) -> Iterator[OrderLine]:
    """Yield every tone that turns, every order of machines and teeth, and the speeds of shafts that neither has."""
    arrays, labels, seen = system.arrays, system.labels, list[float]()
    used = np.unique(np.concatenate([arrays.variation.tone, arrays.error.tone])).astype(int)
    for tone, rate in ((labels.tones[place], float(arrays.tone_rate[place])) for place in used):
        yield from _new(OrderLine(tone, abs(rate) / (2.0 * np.pi)), seen)
    stated = [OrderLine(Tone(()), order.rate / (2.0 * np.pi), order) for order in labels.orders if order.rate > 0.0]
    yield from stated
    seen += [order.frequency for order in stated]
    for name, speed in zip(labels.coordinates, arrays.speed, strict=True):
        yield from _new(OrderLine(Tone(((name, 1),)), abs(float(speed)) / (2.0 * np.pi)), seen)


def _new(order: OrderLine, seen: list[float]) -> Iterator[OrderLine]:
    """Yield an order that turns, unless one of its frequency was seen before."""
    if order.frequency > 0.0 and not any(abs(order.frequency - known) < 1e-9 * order.frequency for known in seen):
        seen.append(order.frequency)
        yield order


def _crossings(factor: Floats, frequency: Floats, orders: Sequence[OrderLine]) -> Iterator[Crossing]:
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


# ----------------------------------------------------------------------------------------------------------------------
# Critical speeds of a sized train: where an order meets a natural frequency, how far from the operating speeds.
#
# And how hard the order shakes the mode there: estimated to first order, so that cancelled ones can be told apart.
# ----------------------------------------------------------------------------------------------------------------------


class Criterion(NamedTuple):
    """How far a machine keeps from a critical speed, and who asks for it."""

    clause: str
    """Standard and what it asks for."""
    limit: Ratio
    """Least separation margin, above the critical speed as below it [-]."""

    def around(self, speed: float) -> tuple[float, float]:
        """Return the lowest and the highest critical speed that lie too near to an operating speed [as it is].

        Args:
            speed: Operating speed, in any unit.
        """
        return speed / (1.0 + self.limit), speed / (1.0 - self.limit)


RESONANCE = Criterion("modes of the train: 15 % from meshes", 0.15)
"""Of the mesh frequency and its multiples, from natural frequencies of the whole train: as far as ISO 6336-1 keeps one
mesh alone from its own main resonance, whose N the rating of gears judges.

Source: ISO 6336-1:2006, clause 6, the width of the main resonance range, 0.85 to 1.15; method A asks for the train.
"""
SEPARATION = Criterion("API 617: 10 %", 0.1)
"""Of what comes once or several times in a turn of a shaft, and of what it modulates.

Source: API 617, 10 %, in Wang, Feese & Pettinato 2012, Proc. 41st Turbomachinery Symposium, table 1; taken of the
    critical speed, as ISO 6336-1 has it, where API 617 takes it of the exciting frequency: 1 % apart at most.
"""
SWING = 0.01
"""Share of its mean torque or force by which an order is taken to swing whose strength nobody states [-]."""
SILENT = 0.01
"""Force at resonance over the mean force below which a mode counts as not excited [-]."""
SAME = 1e-3
"""Relative distance of frequencies under which modes resonate together [-]."""


@dataclass(frozen=True)
class CriticalSpeed:
    """One meeting of an order and a natural frequency."""

    cases: str
    """Load cases that run at the same speeds."""
    order: str
    """What excites: mesh and multiple of its frequency, or a shaft's turning."""
    modes: tuple[int, int]
    """First and last of the natural frequencies, counted from 1 with the rigid ones first, by frequency at the lowest
    speed."""
    frequency: Frequency
    """[Hz]"""
    speed: Speed
    """Of the shaft of the first machine [rad/s]."""
    separation_margin: Ratio
    """Operating over critical speed, less 1 [-]: n/n_crit − 1; positive where the machine runs above it."""
    dynamic_force: Ratio
    """Estimated amplitude of the worst mesh force at this resonance over its mean [-], from stiffness and errors."""
    criterion: Criterion | None
    """What its separation margin is held against; None of an order for which no standard asks for one."""
    why: str = ""
    """What makes an order that no line makes, such as ``6 blades``; its strength is `SWING`, by assumption."""

    @property
    def mode(self) -> str:
        """Which natural frequencies: ``7``, or ``7–9`` where they are one."""
        return "–".join(dict.fromkeys(map(str, self.modes)))

    @property
    def excited(self) -> bool:
        """Whether the order shakes this mode: phases of planets may cancel it, and a shaft order needs an error."""
        return self.dynamic_force >= SILENT

    @property
    def over_limit(self) -> float:
        """Amount of the separation margin over its limit [-]: 1 is just enough; infinite where no criterion is made."""
        return math.inf if self.criterion is None else abs(self.separation_margin) / self.criterion.limit

    @property
    def in_resonance(self) -> bool:
        """Whether the operating speed lies nearer than the criterion allows; how hard the order shakes aside."""
        return self.over_limit < 1.0 - ROUNDING


@dataclass(frozen=True, eq=False, repr=False)
class SpeedCase(Shown):
    """Load cases of one set of speeds, their Campbell diagram and their critical speeds, worst first."""

    cases: str
    """Names."""
    first: str
    """Name of the first of them."""
    system: System
    """Of the first of them."""
    campbell: Campbell
    """Against speed over operating speed."""
    critical: tuple[CriticalSpeed, ...]
    """Excited ones first, then by their separation margins over their limits."""
    assumed: tuple[CriticalSpeed, ...]
    """Those of orders whose strength nobody states, sorted alike: blades, poles, slots, teeth and planets that pass."""

    @property
    def nearest(self) -> tuple[CriticalSpeed, ...]:
        """Of every order that excites and has a criterion its nearest critical speed, the worst first."""
        nearest = dict[str, CriticalSpeed]()
        for critical in sorted((*self.critical, *self.assumed), key=lambda critical: critical.over_limit):
            if critical.excited and critical.criterion is not None:
                nearest.setdefault(critical.order, critical)
        return tuple(nearest.values())


@verb
@one_blas_thread()
def critical_speeds(
    sizing: Sizing, *, cases: Sequence[str] | None = None, factors: Sequence[float] = FACTORS
) -> tuple[SpeedCase, ...]:
    """Return the Campbell diagrams and the critical speeds of every load case, cases of equal speeds together.

    A case in which a brake holds every machine has none.

    Args:
        sizing: What was sized.
        cases: Load cases; left out: all.
        factors: Rising speeds over the operating speed [-].

    Raises:
        DesignError: If there is no such case, or nothing turns in it.

    Source: parametric excitation to first order: the mesh force amplitude k_n δ_0 of a stiffness harmonic at the static
        deflection, on a mode of damping ratio ζ: q = φᵀ f/(2 ζ ω²).
    """
    groups: dict[tuple[float, ...], list[str]] = {}
    for case in cases or sizing.flows:
        flow = by_name(case, sizing.flows, "case")
        if turning_shaft(sizing, case) is not None:
            groups.setdefault(tuple(round(speed, 6) for speed in flow.speeds.values()), []).append(case)
    if not groups:
        refuse([Problem("case", f"nothing turns in {', '.join(cases or sizing.flows)}; name a case in which it does")])
    return tuple(_speed_case(sizing, together, factors) for together in groups.values())


def turning_shaft(sizing: Sizing, case: str) -> str | None:
    """Return the shaft of the first machine that turns in a case, whose speed stands for all; None where none does.

    Args:
        sizing: What was sized.
        case: Load case.
    """
    speeds = sizing.flows[case].speeds
    return next((machine.shaft for machine in sizing.machines if speeds[machine.shaft]), None)


def _speed_case(sizing: Sizing, cases: list[str], factors: Sequence[float]) -> SpeedCase:
    systems = [assemble(sizing, case) for case in cases]
    diagram = campbell(systems[0], factors)
    flow, shaft = sizing.flows[cases[0]], turning_shaft(sizing, cases[0])
    speed = abs(flow.speeds[shaft]) if shaft is not None else 0.0
    # Cases of equal speeds differ in their loads alone, so they share their modes.
    shared: dict[float, DampedModes] = {}
    shakers = [Shaker(system, shared) for system in systems]
    before = 1 + len(systems[0].labels.coordinates) - diagram.frequency.shape[1]
    critical = [
        CriticalSpeed(
            ", ".join(cases),
            _words(sizing, first.order),
            (first.mode + before, last.mode + before),
            first.frequency,
            first.factor * speed,
            1.0 / first.factor - 1.0,
            max(shaker.force(first) for shaker in shakers),
            _criterion(sizing, first.order),
            first.order.excitation.why if first.order.excitation else "",
        )
        for first, last in _together(diagram.crossings)
    ]
    critical = sorted(smallest_first(critical, lambda speed: speed.over_limit), key=lambda speed: not speed.excited)
    stated, assumed = (tuple(row for row in critical if bool(row.why) is told) for told in (False, True))
    return SpeedCase(", ".join(cases), cases[0], systems[0], diagram, stated, assumed)


def _criterion(sizing: Sizing, order: OrderLine) -> Criterion | None:
    """Return what an order is held against; one that comes less than once in a turn of its shafts has nothing."""
    if order.excitation is None:
        return RESONANCE if order_name(sizing, order.tone).stage else SEPARATION
    return SEPARATION if all(times == round(times) for _, times in order.excitation.turns) else None


def _words(sizing: Sizing, order: OrderLine) -> str:
    return str(order_name(sizing, order.tone)) if order.excitation is None else order.excitation.name


def _together(crossings: Sequence[Crossing]) -> Iterator[tuple[Crossing, Crossing]]:
    """Yield first and last crossing of an order with modes of one frequency that follow each other."""
    rows = sorted(crossings, key=lambda crossing: (crossing.order.frequency, str(crossing.order), crossing.mode))
    first = 0
    for place in range(1, len(rows) + 1):
        begin, before = rows[first], rows[place - 1]
        joins = place < len(rows) and rows[place].order is begin.order and rows[place].mode == before.mode + 1
        if not (joins and abs(rows[place].frequency / begin.frequency - 1.0) < SAME):
            yield begin, before
            first = place


class OrderName(NamedTuple):
    """What an order is."""

    stage: str
    """Whose teeth meet; empty where shafts turn."""
    turning: tuple[str, ...]
    """Bodies that turn."""
    multiple: int
    """Of the mesh frequency or of the turning [-]."""

    @property
    def short(self) -> str:
        """A mesh by its stage alone, for marks in a figure."""
        words = self.stage or f"{' and '.join(self.turning)} turning"
        return words if self.multiple == 1 else f"{words} × {self.multiple}"

    def __str__(self) -> str:
        """Return the words: ``first mesh × 2`` or ``gas-turbine turning``."""
        return self._replace(stage=f"{self.stage} mesh").short if self.stage else self.short


def order_name(sizing: Sizing, tone: Tone) -> OrderName:
    """Return what an order is: ``first mesh × 2`` or ``gas-turbine turning``.

    Args:
        sizing: What was sized.
        tone: Integers of rotations.
    """
    name, count = max(tone.counts, key=lambda turns: abs(turns[1]))
    part = bodies_of(sizing).get(name)
    for teeth in _teeth(sizing, part) if part is not None else ():
        if part is not None and abs(count) >= teeth and count % teeth == 0:
            return OrderName(part.name, (), abs(count) // teeth)
    return OrderName("", tuple(name for name, _ in tone.counts), abs(count))


def _teeth(sizing: Sizing, part: PartId) -> tuple[int, ...]:
    """Return how often the meshes of a body sound in a turn: of planetary sets against the carrier."""
    if part.name in sizing.design.epicyclics:
        own = [gear for gear in sizing.train.gears if gear.stage == part.name]
        nodes = {node for gear in own if gear.own == part.own for node in gear.nodes}
        here = [gear.name for gear in own if not part.own or nodes & set(gear.nodes)]
        return tuple(sizing.teeth[name] for name in here)
    whole = part if part.name in sizing.design.pairs else gear_part(part.name, Role.SUN)
    return (sizing.teeth[str(whole._replace(branch=""))],)


class _Resonance(NamedTuple):
    """How modes of one frequency answer what pushes coordinates."""

    shares: Complexes
    """Of each mode in what pushes [-], shape (modes, coordinates)."""
    forces: Complexes
    """Of meshes over their mean, by the shares, shape (carrying meshes, modes)."""


class Shaker:
    """What each order does at its resonances in one load case."""

    def __init__(self, system: System, modes: dict[float, DampedModes]) -> None:
        self.system, self.matrix, self.modes = system, line_matrix(system.arrays), modes
        self.mean = statics(system, balance="accelerate").force
        arrays, mean = system.arrays, np.abs(self.mean)
        meshes = np.array([kind == "mesh" for kind in system.labels.line_kinds])
        self.carrying = meshes & (mean > UNLOADED * np.max(mean[meshes], initial=0.0))
        stretched = (arrays.stiffness[:, None] * self.matrix)[self.carrying]
        self.forces = stretched / mean[self.carrying][:, None]  # of meshes that carry over their mean, by motions
        self.pushes: dict[OrderLine, Complexes] = {}
        self.resonances: dict[tuple[float, float], _Resonance] = {}
        self.matrices: dict[float, Linear] = {}
        self.changes = bool(len(arrays.gyroscopic.value) or np.any(arrays.loads.quadratic))
        self.stiffens = self.changes or bool(len(arrays.centripetal.value))

    def force(self, crossing: Crossing) -> float:
        """Return the estimated amplitude of the worst mesh force at a resonance over its mean force [-].

        Args:
            crossing: Order and natural frequency that meet.

        Source: see `critical_speeds`.
        """
        if crossing.order not in self.pushes:
            self.pushes[crossing.order] = self._push(crossing.order)
        exciting = self.pushes[crossing.order]
        if not exciting.any():
            return 0.0
        resonance = self._resonance(crossing)
        alone = float(np.abs(resonance.forces @ (resonance.shares @ exciting)).max(initial=0.0))
        # The mode decides whether the order excites it at all; how large the force is, all modes say together.
        return self._answer(exciting, crossing) if alone > SILENT else alone

    def _resonance(self, crossing: Crossing) -> _Resonance:
        """Return how the modes of a crossing answer, once for all orders that cross them at one speed."""
        key = crossing.factor if self.changes else 1.0, crossing.frequency
        if key not in self.resonances:
            self.resonances[key] = self._resonant(self._modes(crossing.factor), 2.0 * math.pi * crossing.frequency)
        return self.resonances[key]

    def _resonant(self, modes: DampedModes, rate: float) -> _Resonance:
        apart = np.abs(modes.rate.imag / rate - 1.0)
        near = apart < max(SAME, 1.01 * float(np.min(apart)))
        resonant = modes.shape[:, near]
        # At its peak a mode moves by 1/(2 ζ ω²) = 1/(2 |Re λ| ω) of what pushes it. The shapes of a repeated frequency
        # are any basis of their space: its mass matrix makes the answer independent of which one the solver gave.
        together = resonant.conj().T @ (self.system.arrays.mass[:, None] * resonant)
        push = resonant.conj().T
        shares = push / together[0] if len(push) == 1 else np.linalg.pinv(together) @ push
        moved = resonant / (2.0 * np.mean(np.abs(modes.rate[near].real)) * rate)
        return _Resonance(shares, self.forces @ moved)

    def _push(self, order: OrderLine) -> Complexes:
        """Return the complex amplitude with which an order pushes each coordinate [N or N m]."""
        if order.excitation is None:
            return np.asarray(self.matrix.T @ _exciting(self.system, order.tone, self.mean))
        return SWING * self._swinging(order.excitation).astype(np.complex128)

    def _swinging(self, order: Excitation) -> Floats:
        """Return what an order shakes, at its mean: torques of coordinates, forces of lines [N or N m]."""
        labels = self.system.labels
        lines = np.array([name in order.on for name in labels.lines])
        bodies = np.array([name in order.on for name in labels.coordinates])
        return np.asarray(bodies * self.system.arrays.loads.constant + self.matrix.T @ (lines * self.mean))

    def _answer(self, exciting: Complexes, crossing: Crossing) -> float:
        """Return the worst mesh force over its mean when all modes answer an excitation [-]."""
        key, rate = crossing.factor if self.stiffens else 1.0, 2.0 * math.pi * crossing.frequency
        if key not in self.matrices:
            self.matrices[key] = linear(self.system.arrays, key)
        system = self.matrices[key]
        dynamic = np.diag(-(rate**2) * system.mass) + 1j * rate * system.damping + system.stiffness
        return float(np.abs(self.forces @ np.linalg.solve(dynamic, exciting)).max(initial=0.0))

    def _modes(self, factor: float) -> DampedModes:
        key = factor if self.changes else 1.0
        if key not in self.modes:
            self.modes[key] = damped_modes(plan_of(self.system.arrays), key)
        return self.modes[key]


def _exciting(system: System, tone: Tone, force: Floats) -> Complexes:
    """Return the complex force amplitude that a tone puts on each line [N or N m]."""
    arrays, exciting = system.arrays, np.zeros(len(force), dtype=np.complex128)
    for series, scale in ((arrays.variation, force), (arrays.error, -arrays.stiffness)):
        for row, place in series_terms(series.start):
            if system.labels.tones[series.tone[place]] == tone:
                exciting[row] += scale[row] * complex(series.cosine[place], -series.sine[place])
    return exciting


# ----------------------------------------------------------------------------------------------------------------------
# Simulated peaks beside the rated loads: what is left of the margins when the peak of a run counts.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DynamicLoad:
    """One mesh row in a run."""

    mesh: str
    peak_over_mean: Annotated[float, Quantity("ratio"), Origin("F_max / F_mean", "run")]
    """Dynamic factor of the run [-]."""
    peak_force: Annotated[float, Quantity("force"), Origin("F_t = F cos α_t", "run")]
    """Largest tangential force of one mesh [N]."""
    rated_force: Annotated[
        float, Quantity("force"), Origin("F_t of the worst case, times the factors for peaks in its rating", "sizing")
    ]
    """Tangential force that the mesh is sized for [N]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("margin · F_t / F_t,max", "root stress ∝ force")]
    """Bending margin at the peak [-]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("margin · √(F_t / F_t,max)", "flank stress ∝ √force")]
    """Contact margin at the peak [-]."""


@dataclass(frozen=True)
class ShaftLoad:
    """One shaft in a run."""

    shaft: str
    peak_torque: Annotated[float, Quantity("torque"), Origin("T_max", "run")]
    """Largest torque of its lines, without sign [N m]."""
    rated_torque: Annotated[float, Quantity("torque"), Origin("T at the section that governs", "sizing")]
    """Torque that it is sized for [N m]."""
    margin: Annotated[float, Quantity("ratio"), Origin("margin · T / T_max", "stress ∝ torque")]
    """Against yield at the peak, with the bending moment that grows with the torque [-]."""


def shaft_loads(sizing: Sizing, trace: Trace) -> tuple[ShaftLoad, ...]:
    """Return the peak of every shaft beside what it is sized for, the worst first.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    loads = list[ShaftLoad]()
    for shaft in sizing.shafts if trace.force.bins else ():
        lines = trace.labels.lines_of(PartId(Kind.SHAFT, shaft.name))
        peak = max((_peak_of_line(trace, line) for line in lines), default=0.0)
        if peak and shaft.torque:
            rated = abs(shaft.torque)
            loads.append(ShaftLoad(shaft.name, peak, rated, shaft.margin * rated / peak))
    return tuple(smallest_first(loads, lambda load: load.margin))


def _peak_of_line(trace: Trace, line: str) -> float:
    history = trace.force.of(line)
    return max(abs(float(history["maximum"].max())), abs(float(history["minimum"].min())))


def dynamic_loads(sizing: Sizing, trace: Trace) -> tuple[DynamicLoad, ...]:
    """Return the peak of every mesh row beside what it is sized for, the worst first.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    meshes = sizing.meshes if trace.force.bins else ()
    loads = [load for mesh in meshes if (load := _load(sizing, mesh, trace)) is not None]
    return tuple(smallest_first(loads, lambda load: min(load.bending_margin, load.contact_margin)))


def _load(sizing: Sizing, mesh: MeshSizing, trace: Trace) -> DynamicLoad | None:
    lines = trace.labels.lines_of(mesh.part)
    if not lines or not mesh.tangential_force:
        return None
    # The halves of a double-helical gear are one line; planets have a line each.
    together = mesh.count if mesh.row is Row.PAIR else 1
    statistics = [trace.force.of(name) for name in lines]
    peak = max(_peak_of_line(trace, name) for name in lines)
    mean = max(abs(float(line["mean"].mean())) for line in statistics)
    force, sized_for = (
        peak * math.cos(mesh.working_pressure_angle) / together,
        mesh.tangential_force * mesh.rating.peaks,
    )
    return DynamicLoad(
        mesh=mesh.name,
        peak_over_mean=peak / mean if mean else math.inf,
        peak_force=force,
        rated_force=sized_for,
        bending_margin=mesh.bending_margin * sized_for / force,
        contact_margin=mesh.contact_margin * math.sqrt(sized_for / force),
    )


# ----------------------------------------------------------------------------------------------------------------------
# What shakes a sized gearbox: peaks of a short run at the loads of every case, and resonances near its speeds.
# ----------------------------------------------------------------------------------------------------------------------


DURATION = 0.2
"""Of the run whose peaks are looked at [s]: that of ``gearwright run``."""
START = 0.25
"""Share of it that is left to the start [-]."""


def motion_checks(sizing: Sizing, speeds: Sequence[SpeedCase] | None = None) -> Iterator[Check]:
    """Yield every mesh at the worst peak of all cases, and of every order that excites one the nearest resonance.

    Args:
        sizing: As sized.
        speeds: Its `critical_speeds`; left out: found here.
    """
    yield from peak_checks(sizing)
    yield from resonance_checks(sizing, speeds)


def peak_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield every mesh at the worst peak of all cases, each run for a while.

    Args:
        sizing: As sized.
    """
    peaks: dict[tuple[PartId, str], Check] = {}
    for case in sizing.flows:
        try:
            checks = [*_peaks(sizing, case)]
        except GearwrightError as error:  # the design is good without a run of this case; say why there is none
            yield not_assessed(GEARBOX, f"peaks in case {case}", "run", " ".join(str(error).split()))
            continue
        for check in checks:
            known = peaks.get((check.part, check.mode))
            if known is None or (check.margin or 0.0) < (known.margin or 0.0):
                peaks[check.part, check.mode] = check
    yield from peaks.values()


def _peaks(sizing: Sizing, case: str) -> Iterator[Check]:
    """Yield what the peaks of a run leave of the margins of every mesh."""
    trace = simulate(assemble(sizing, case), DURATION, outputs=Outputs(start=START * DURATION))
    parts = {mesh.name: mesh.part for mesh in sizing.meshes}
    for load in dynamic_loads(sizing, trace):
        yield _peak(parts[load.mesh], "peak bending", load, load.bending_margin, 1.0, case)
        yield _peak(parts[load.mesh], "peak contact", load, load.contact_margin, 2.0, case)


def _peak(part: PartId, mode: str, load: DynamicLoad, margin: float, power: float, case: str) -> Check:
    """Return the peak force beside the one that leaves just enough; contact stress grows with the root of the force."""
    allowed, clause = load.peak_force * margin**power, f"run of {DURATION:g} s"
    return Check(part, mode, clause, load.peak_force, allowed, "force", at_most=True, exponent=power, case=case)


def resonance_checks(sizing: Sizing, speeds: Sequence[SpeedCase] | None = None) -> Iterator[Check]:
    """Yield for every excited order its critical speed nearest to the operating speed.

    Args:
        sizing: As sized.
        speeds: Its `critical_speeds`; left out: found here.
    """
    try:
        cases = critical_speeds(sizing) if speeds is None else speeds
    except GearwrightError as error:
        yield not_assessed(GEARBOX, "resonances", "ISO 6336-1, clause 6", " ".join(str(error).split()))
        return
    for case in cases:
        for critical in case.nearest:
            if critical.criterion is not None:
                yield _resonance(case.cases, critical, critical.criterion)
    for case in cases:
        yield from _far_orders(case)


def _far_orders(speeds: SpeedCase) -> Iterator[Check]:
    """Yield the orders of machines that meet no natural frequency at any speed that is looked at."""
    met = {critical.order for critical in speeds.assumed}
    slowest, fastest = FACTORS[0], FACTORS[-1]
    for excitation in speeds.system.labels.orders:
        part = excitation.owner.part
        if part is not None and part.kind is Kind.MACHINE and excitation.name not in met:
            place = f"no natural frequency from {slowest:.1f} to {fastest:.1f} of its speed"
            yield Check(
                GEARBOX, f"resonance of {excitation.name}", SEPARATION.clause, 1.0 - 1.0 / fastest, SEPARATION.limit,
                "percent", exponent=None, place=place, case=speeds.cases,
            )  # fmt: skip


def _resonance(names: str, critical: CriticalSpeed, criterion: Criterion) -> Check:
    mode = f"resonance of {critical.order.replace('×', 'x')}"  # what a waiver calls it is typed on any keyboard
    return Check(
        GEARBOX, mode, criterion.clause, abs(critical.separation_margin), criterion.limit,
        "percent", exponent=None, place=f"mode {critical.mode}", case=names,
    )  # fmt: skip
