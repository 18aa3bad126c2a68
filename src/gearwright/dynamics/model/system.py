"""The dynamic system as flat arrays, systems of one structure as a batch, and checks for finite numbers."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial, wraps
from hashlib import blake2b
from operator import attrgetter
from typing import Any, Concatenate, NamedTuple, ParamSpec, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Bools, DesignError, Floats, Ints, PartId, Problem, Shown, SolveError
from gearwright.memo import Memo

# ----------------------------------------------------------------------------------------------------------------------
# System: bodies, lines, tones and loads as flat arrays; names and units travel beside them.
#
#     δ_j = d_j·q − e_j(φ)                     deflection of line j
#     f_j = k_j(φ) g(δ_j) + c_j (δ̇_j + s σ_j)  its force
#     M q̈ + s G q̇ − s² C q + Σ_j d_j f_j = Q(t, q̇, x) − M Ω ṡ,   ẋ = h(t, q̇, x) of the drives
#
# q is measured from the rigid motion: θ = Ω τ + q with τ = ∫ s dt and s the speed factor (1 at the reference speeds Ω).
# σ_j = d_j·Ω is the slip of a damper in that motion, k_j = 0; what has a stiffness has none.
# A tone is an angle φ = ω τ that is an integer combination of shaft angles; k_j and e_j are Fourier sums over tones.
# ----------------------------------------------------------------------------------------------------------------------


class Series(NamedTuple):
    """Fourier sums, one for each line, in compressed rows: Σ a cos φ + b sin φ."""

    start: Ints
    """First term of each line and one past the last, shape (lines + 1,)."""
    tone: Ints
    """Tone of each term, shape (terms,)."""
    cosine: Floats
    """Coefficient a, shape (terms,): [-] relative to the mean for stiffness, [m or rad] for errors."""
    sine: Floats
    """Coefficient b, shape (terms,), in the unit of a."""


class Entries(NamedTuple):
    """Entries of a sparse matrix."""

    row: Ints
    """Coordinate that feels the force, shape (entries,)."""
    column: Ints
    """Coordinate that causes it, shape (entries,)."""
    value: Floats
    """Value at the reference speeds, shape (entries,)."""


NOTHING = Entries(np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64), np.zeros(0))
"""No entry."""


class Films(NamedTuple):
    """Unsymmetric terms of bearings, as of a turning oil film: force = −K q − C q̇, whatever the speed."""

    stiffness: Entries = NOTHING
    """K [N/m]."""
    damping: Entries = NOTHING
    """C [N s/m]."""


class Schedules(NamedTuple):
    """Loads that are piecewise linear in time, in compressed rows; held before the first and after the last point."""

    dof: Ints
    """Coordinate of each schedule, shape (schedules,)."""
    start: Ints
    """First point of each schedule and one past the last, shape (schedules + 1,)."""
    time: Floats
    """Time of each point [s], shape (points,)."""
    value: Floats
    """Load at each point [N or N m], shape (points,)."""


class Loads(NamedTuple):
    """What acts on the coordinates from outside: Q = constant + schedule − a q̇ − b |θ̇| θ̇."""

    constant: Floats
    """[N or N m], shape (coordinates,)."""
    damping: Floats
    """a: load lost per speed above the reference [N s/m or N m s/rad], shape (coordinates,)."""
    quadratic: Floats
    """b: propeller-like resistance [N m s²/rad²], shape (coordinates,)."""
    schedules: Schedules
    """Loads given against time."""


class Drives(NamedTuple):
    """Propellers, machines and slipping clutches: torques by laws of speed, some with states x of first order."""

    table: Floats
    """Records one after another, as `drives.encoded` writes them, shape (numbers,); empty without drives."""
    start: Floats
    """States at time 0, shape (states,)."""
    inputs: Schedules
    """What a record reads against time: densities, airspeeds, set speeds, commands; its ``dof`` is the record."""


class Profile(NamedTuple):
    """Speed factor s(t), piecewise linear; held before the first and after the last point."""

    time: Floats
    """[s], shape (points,)."""
    factor: Floats
    """s: speed over reference speed [-], shape (points,)."""
    travel: Floats
    """τ = ∫ s dt from time 0 to each point [s], shape (points,)."""


class Arrays(NamedTuple):
    """The only thing that the compiled kernel sees."""

    mass: Floats
    """Mass or inertia of each coordinate [kg or kg m²], shape (coordinates,)."""
    speed: Floats
    """Ω: reference speed of the rigid motion [rad/s or m/s], shape (coordinates,)."""
    line_start: Ints
    """First weight of each line and one past the last, shape (lines + 1,)."""
    line_dof: Ints
    """Coordinate of each weight, shape (weights,)."""
    line_weight: Floats
    """d: deflection per coordinate [m/rad for a mesh, - for a shaft or support], shape (weights,)."""
    stiffness: Floats
    """Mean stiffness [N/m or N m/rad], shape (lines,): 0 for a damper."""
    damping: Floats
    """c [N s/m or N m s/rad], shape (lines,)."""
    slip: Floats
    """σ: rate of the deflection in the rigid motion at the reference speeds, of dampers [rad/s], shape (lines,)."""
    backlash: Floats
    """B [m or rad], shape (lines,): 0 is a linear line, infinity one that never touches on its back."""
    tone_rate: Floats
    """dφ/dτ of each tone: its circular frequency at the reference speeds [rad/s], shape (tones,)."""
    variation: Series
    """Stiffness over its mean, less 1."""
    error: Series
    """e: manufacturing, assembly and transmission error of each line."""
    gyroscopic: Entries
    """Ω G [N s/m]."""
    centripetal: Entries
    """Ω² C [N/m]."""
    loads: Loads
    """External loads."""
    profile: Profile
    """Speed factor against time."""
    drives: Drives
    """Propellers, machines and slipping clutches."""
    following: Films = Films()
    """Unsymmetric terms of bearings."""


class Tone(NamedTuple):
    """An angle that is an integer combination of shaft angles."""

    counts: tuple[tuple[str, int], ...]
    """Coordinate and its integer, such as (("sun", 28), ("carrier", -28)); empty for a constant."""

    def __str__(self) -> str:
        return " + ".join(f"{count} {name}" for name, count in self.counts).replace("+ -", "− ") or "constant"


class Owner(NamedTuple):
    """Whose a coordinate, a line or a recorded number is, and which of its several it is."""

    part: PartId | None = None
    """Part of a transmission; None in a model that was written by hand."""
    what: str = ""
    """Direction or quantity: ``x``, ``pin.radial``, ``torque``; empty for a rotation and for what a part has once."""


NOBODY = Owner()
"""Of what was written by hand."""


class Excitation(NamedTuple):
    """An order that no line of the system makes: what a machine or teeth do so often in a turn of their shafts."""

    name: str
    """What it is called, such as ``propeller blade pass``."""
    turns: tuple[tuple[str, float], ...]
    """Rotation and how often it acts in a turn of it, such as (("propeller", 6.0),); they add up."""
    on: tuple[str, ...]
    """Coordinates or lines that it shakes."""
    why: str
    """Where the multiple is from, such as ``6 blades``."""
    rate: float
    """Circular frequency at the reference speeds [rad/s]."""
    owner: Owner
    """Whose it is."""


@dataclass(frozen=True)
class Labels:
    """Names and units of coordinates, lines and tones, and whose they are."""

    coordinates: tuple[str, ...]
    """Names, in the order of the arrays."""
    coordinate_units: tuple[str, ...]
    """``"rad"`` for a rotation, ``"m"`` for a translation."""
    lines: tuple[str, ...]
    """Names, in the order of the arrays."""
    line_units: tuple[str, ...]
    """Unit of the deflection: ``"m"`` (force in N) or ``"rad"`` (torque in N m)."""
    line_kinds: tuple[str, ...]
    """``"mesh"``, ``"shaft"``, ``"support"``, ``"damper"`` or ``"line"``."""
    tones: tuple[Tone, ...]
    """Which angle each tone is."""
    coordinate_owners: tuple[Owner, ...]
    """Whose each coordinate is."""
    line_owners: tuple[Owner, ...]
    """Whose each line is."""
    drives: tuple[str, ...] = ()
    """What is recorded of the drives: states, then torque, speed and flag of each."""
    drive_units: tuple[str, ...] = ()
    """Their units."""
    drive_owners: tuple[Owner, ...] = ()
    """Which machine or clutch each number is of, and what it is."""
    orders: tuple[Excitation, ...] = ()
    """Orders of machines and teeth that no line makes: blades, poles, slots, planets that pass."""

    def places_of(self, part: PartId) -> tuple[int, ...]:
        """Return the places of a mesh row's lines, one for each planet, or of any other part's lines.

        Args:
            part: Without number for all of its planets.
        """
        owners = enumerate(self.line_owners)
        return tuple(place for place, owner in owners if owner.part is not None and owner.part.is_of(part))

    def lines_of(self, part: PartId) -> tuple[str, ...]:
        """Return the names of a mesh row's lines, one for each planet, or of any other part's lines.

        Args:
            part: Without number for all of its planets.
        """
        return tuple(self.lines[place] for place in self.places_of(part))


@dataclass(frozen=True, eq=False, repr=False)
class System(Shown):
    """A drive train as the solvers see it."""

    arrays: Arrays
    """The numbers."""
    labels: Labels
    """Their names and units."""

    def __str__(self) -> str:
        labels = self.labels
        return f"System: {len(labels.coordinates)} coordinates, {len(labels.lines)} lines, {len(labels.tones)} tones"


def line_matrix(arrays: Arrays) -> Floats:
    """Return the lines' weights as a dense matrix D with δ = D q − e.

    Args:
        arrays: The system's numbers.

    Returns:
        Shape (lines, coordinates).
    """
    lines, size = len(arrays.stiffness), len(arrays.mass)
    place = np.arange(lines).repeat(arrays.line_start[1:] - arrays.line_start[:-1]) * size + arrays.line_dof
    return np.bincount(place, arrays.line_weight, lines * size).astype(float, copy=False).reshape(lines, size)


LARGE = 250
"""Coordinates beyond which runs do without dense matrices, whose decomposition takes the third power of them."""


def along_lines(arrays: Arrays, motion: Floats) -> Floats:
    """Return D q, how far a motion stretches each line, shape (lines,).

    Args:
        arrays: The system's numbers.
        motion: q, shape (coordinates,).
    """
    if len(arrays.mass) <= LARGE:
        return np.asarray(line_matrix(arrays) @ motion)
    lines = len(arrays.stiffness)
    row = np.repeat(np.arange(lines), np.diff(arrays.line_start))
    return np.asarray(np.bincount(row, arrays.line_weight * motion[arrays.line_dof], minlength=lines), float)


def onto_coordinates(arrays: Arrays, force: Floats) -> Floats:
    """Return Dᵀ f, what forces of the lines do to each coordinate, shape (coordinates,).

    Args:
        arrays: The system's numbers.
        force: Of each line, shape (lines,).
    """
    if len(arrays.mass) <= LARGE:
        return np.asarray(line_matrix(arrays).T @ force)
    pulls = np.repeat(force, np.diff(arrays.line_start))
    return np.asarray(np.bincount(arrays.line_dof, arrays.line_weight * pulls, minlength=len(arrays.mass)), float)


def holding(arrays: Arrays) -> Bools:
    """Return which lines hold their bodies together, shape (lines,): all but dampers.

    Args:
        arrays: The system's numbers.
    """
    return np.asarray(arrays.stiffness > 0.0)


def entry_matrix(entries: Entries, size: int) -> Floats:
    """Return sparse entries as a dense matrix.

    Args:
        entries: Gyroscopic or centripetal terms.
        size: Number of coordinates.

    Returns:
        Shape (size, size).
    """
    matrix = np.zeros((size, size))
    np.add.at(matrix, (entries.row, entries.column), entries.value)
    return matrix


def top_rate(arrays: Arrays) -> float:
    """Return the highest circular frequency [rad/s] with which stiffness or errors excite the system.

    Args:
        arrays: The system's numbers.
    """
    used = np.concatenate([arrays.variation.tone, arrays.error.tone])
    fastest = float(np.max(np.abs(arrays.tone_rate[used]), initial=0.0))
    return fastest * float(np.max(np.abs(arrays.profile.factor)))


# ----------------------------------------------------------------------------------------------------------------------
# Family: systems side by side as one record of arrays with a leading axis; what they share stands there once.
# ----------------------------------------------------------------------------------------------------------------------


DIFFERS = "its structure differs from the first one's: lines, backlash or none, tones, kinds of loads"


def stacked(members: Sequence[Arrays]) -> Arrays:
    """Return arrays whose leading axis counts the systems; it has length one where all share one array.

    Args:
        members: Numbers of each system.

    Raises:
        DesignError: With the first system whose arrays have other shapes.
    """
    return cast("Arrays", _stack(members))


def _stack(parts: Sequence[object]) -> object:
    first = parts[0]
    if all(part is first for part in parts):
        parts = parts[:1]
    if isinstance(first, np.ndarray):
        for number, part in enumerate(parts):
            if cast("Floats", part).shape != first.shape:
                raise DesignError([Problem(f"systems.{number}", DIFFERS)])
        return np.array(parts)
    fields = cast("Sequence[Sequence[object]]", parts)
    return type(first)(*(_stack([part[place] for part in fields]) for place in range(len(fields[0]))))


def check_structure(family: Arrays) -> None:
    """Refuse systems that one code cannot run.

    Args:
        family: Systems, `stacked`.

    Raises:
        DesignError: With the first system whose structure differs from the first one's.
    """
    for rows in _structure(family):
        different = np.flatnonzero(np.any(rows != rows[0], axis=1))
        if len(different):
            raise DesignError([Problem(f"systems.{different[0]}", DIFFERS)])


def _structure(family: Arrays) -> Iterator[np.ndarray]:
    """Return what decides the structure, a row for each system."""
    loads, weights = family.loads, family.line_weight
    yield from (family.line_start, family.line_dof, np.where(np.abs(weights) == 1.0, weights, 0.0))
    yield np.array([weight_numbers(row)[0] for row in weights])
    yield from (family.backlash > 0.0, family.damping > 0.0, family.slip != 0.0)
    ramps = np.any(family.profile.factor != family.profile.factor[:, :1], axis=1, keepdims=True)
    yield from (ramps, ramps & (family.speed != 0.0))
    yield from (loads.constant != 0.0, loads.damping != 0.0, loads.quadratic != 0.0, loads.schedules.dof)
    yield from (family.variation.start, family.variation.tone, family.error.start, family.error.tone)
    yield from (family.gyroscopic.row, family.gyroscopic.column, family.centripetal.row, family.centripetal.column)


def weight_numbers(weights: Floats) -> tuple[Ints, Floats]:
    """Return the number of each weight, equal ones alike, in the order in which they first occur, and their values.

    Args:
        weights: Of all lines.
    """
    values, first, inverse = np.unique(weights, return_index=True, return_inverse=True)
    order = np.argsort(first)
    return np.argsort(order)[inverse], values[order]


def own_groups(family: Arrays, layout: tuple[int, ...], names: Sequence[str], rows: Floats) -> frozenset[str]:
    """Return which groups of numbers differ from system to system, and ``"clock"`` if their tones do.

    Args:
        family: Systems, `stacked`.
        layout: First place of each group of numbers.
        names: Of the groups.
        rows: Numbers of each system.
    """
    differs = np.any(rows != rows[0], axis=0)
    ends = [*layout[1:], len(differs)]
    varying = {name for name, start, end in zip(names, layout, ends, strict=True) if np.any(differs[start:end])}
    clocks = (family.profile.factor[:, :1], family.tone_rate)
    return frozenset(varying | {"clock"} if any(np.any(clock != clock[0]) for clock in clocks) else varying)


def envelope(first: Arrays, family: Arrays) -> Arrays:
    """Return the first system with the largest stiffness, swing and damping of each line.

    Args:
        first: System.
        family: Systems, `stacked`.
    """
    swing = np.max(np.hypot(family.variation.cosine, family.variation.sine), axis=0)
    return first._replace(
        stiffness=np.max(family.stiffness, axis=0),
        damping=np.max(family.damping, axis=0),
        variation=first.variation._replace(cosine=swing, sine=np.zeros_like(swing)),
    )


# ----------------------------------------------------------------------------------------------------------------------
# Plan: the numbers of a system with all that was made of them, so that one system is worked out once for all its runs.
#
# What a function makes of the numbers alone is kept beside them: topology, code, clock tables, rates, equilibrium.
# Plans are found again by a digest of the numbers, which no one else can change.
# ----------------------------------------------------------------------------------------------------------------------


PLANS = 16
"""Plans that are kept: the latest."""
ANSWERS = 4
"""Answers of one function that a plan keeps, the latest: a run and the one beside it take two steps' tables."""

Given = ParamSpec("Given")
Result = TypeVar("Result")


class Plan(NamedTuple):
    """Numbers that cannot change, with what was made of them."""

    arrays: Arrays
    """The numbers, in arrays that no one else has."""
    answers: defaultdict[Hashable, Memo[Hashable, Any]]
    """By function, and by what else it was given."""


_PLANS = Memo[bytes, Plan](PLANS)
_KNOWN = Memo[int, Plan](PLANS)
"""The same plans, by which object their numbers are."""


def plan_of(arrays: Arrays) -> Arrays:
    """Return the same numbers as their plan has them: what is made of these is kept.

    Args:
        arrays: The system's numbers.
    """
    if _known(arrays):
        return arrays
    plan = _PLANS.of(_digest(arrays), lambda: Plan(_own(arrays), defaultdict(partial(Memo, ANSWERS))))
    return _KNOWN.keep(id(plan.arrays), plan).arrays


def _known(arrays: Arrays) -> Plan | None:
    plan = _KNOWN.get(id(arrays))
    return plan if plan and plan.arrays is arrays else None


def kept(arrays: Arrays, key: tuple[Hashable, ...], make: Callable[[], Result]) -> Result:
    """Return what a function makes of numbers; of a plan's it is made once.

    Args:
        arrays: The system's numbers.
        key: The function, and what else it is given.
        make: Makes it; it must not be changed afterwards.
    """
    plan = _known(arrays)
    if plan is None:
        return make()
    answers: Memo[Hashable, Result] = plan.answers[key[0]]
    return answers.of(key, make)


def planned(
    function: Callable[Concatenate[Arrays, Given], Result],
) -> Callable[Concatenate[Arrays, Given], Result]:
    """Return a function of numbers that is computed once for each plan.

    Args:
        function: Of the numbers, and of what can be a key.
    """

    @wraps(function)
    def once(arrays: Arrays, *args: Given.args, **kwargs: Given.kwargs) -> Result:
        return kept(arrays, (function, *args, *kwargs.items()), lambda: function(arrays, *args, **kwargs))

    return cast("Callable[Concatenate[Arrays, Given], Result]", once)


def _digest(arrays: Arrays) -> bytes:
    """Return a digest of all numbers: kinds, shapes, values."""
    leaves = _leaves(arrays)
    kinds = "".join([leaf.dtype.char for leaf in leaves]).encode()
    sizes = np.array([leaf.size for leaf in leaves]).tobytes()  # all have one axis
    return blake2b(b"".join([kinds, sizes, *[leaf.tobytes() for leaf in leaves]]), digest_size=16).digest()


def _names(part: object, before: str = "") -> Iterator[str]:
    """Return the names of all arrays in a record of records."""
    for name, field in part._asdict().items():  # type: ignore[attr-defined]
        yield from _names(field, f"{before}{name}.") if isinstance(field, tuple) else [f"{before}{name}"]


def _leaves(arrays: Arrays) -> tuple[np.ndarray, ...]:
    """Return all arrays in a record of records, whose kinds of parts never change."""
    if not _GETTERS:
        _GETTERS.append(attrgetter(*_names(arrays)))
    return _GETTERS[0](arrays)  # type: ignore[no-any-return]


_GETTERS = list[Callable[[Arrays], Any]]()


def _own(part: Any) -> Any:
    """Return the same numbers in arrays that no one else has."""
    return type(part)(*map(_own, part)) if isinstance(part, tuple) else np.array(part)


# ----------------------------------------------------------------------------------------------------------------------
# One gate for the numbers of the dynamics: what is not finite neither enters a verb nor leaves it.
# ----------------------------------------------------------------------------------------------------------------------


def refuse_not_finite(values: ArrayLike, parts: Sequence[str], what: str) -> None:
    """Refuse results that are no numbers.

    Args:
        values: Shape (…, parts).
        parts: What the last axis counts.
        what: That they are, for the message.

    Raises:
        SolveError: With the first part whose value is infinite or no number.
    """
    if np.isfinite(values).all():
        return
    table = np.asarray(values).reshape(-1, len(parts))
    wrong = np.argwhere(~np.isfinite(table))
    if len(wrong):
        row, column = wrong[0]
        message = f"{what} of {parts[column]} is {table[row, column]}, no finite number"
        raise SolveError(f"{message}; look for an extreme mass, stiffness, speed or load there")


def check_finite(system: System) -> None:
    """Refuse a system that cannot be run: with numbers that are not finite, or with forces that have no potential.

    Args:
        system: As assembled, or built by hand.

    Raises:
        SolveError: With the part whose number it is.
    """
    refuse_following(system)
    _check_numbers(system)


def refuse_following(system: System) -> None:
    """Refuse unequal cross terms of bearings, which the linear verbs alone know.

    Args:
        system: As built.

    Raises:
        SolveError: If there are such terms.
    """
    if any(len(entries.value) for entries in system.arrays.following):
        message = "bearings have unequal cross terms (k_xy and k_yx): campbell and frequency_response know them"
        raise SolveError(f"{message}; give equal ones for statics and runs")


def _check_numbers(system: System) -> None:
    arrays, labels = system.arrays, system.labels
    for what, values, parts in (
        ("mass or inertia", np.where(arrays.mass > 0.0, arrays.mass, np.nan), labels.coordinates),
        ("speed", arrays.speed, labels.coordinates),
        ("load", arrays.loads.constant, labels.coordinates),
        ("stiffness", arrays.stiffness, labels.lines),
        ("damping", arrays.damping, labels.lines),
        ("slip", arrays.slip, labels.lines),
    ):
        refuse_not_finite(values, parts, what)


@contextmanager
def finite_numbers(system: System) -> Iterator[None]:
    """Refuse a system with numbers that are not finite, and say so where its equations cannot be solved.

    Args:
        system: That is solved inside.

    Raises:
        SolveError: If a number is not finite, with its part; if the equations have no solution.
    """
    _check_numbers(system)
    try:
        # What overflows is refused with its part when it comes out.
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            yield
    except (ValueError, ArithmeticError) as error:  # LinAlgError is a ValueError
        raise SolveError(f"the equations of motion have no solution in floating point: {error}") from error
