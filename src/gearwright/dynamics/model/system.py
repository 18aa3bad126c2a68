"""System: bodies, lines, tones and loads as flat arrays; names and units travel beside them.

    δ_j = d_j·q − e_j(φ)                     deflection of line j
    f_j = k_j(φ) g(δ_j) + c_j (δ̇_j + s σ_j)  its force
    M q̈ + s G q̇ − s² C q + Σ_j d_j f_j = Q(t, q̇, x) − M Ω ṡ,   ẋ = h(t, q̇, x) of the drives

q is measured from the rigid motion: θ = Ω τ + q with τ = ∫ s dt and s the speed factor (1 at the reference speeds Ω).
σ_j = d_j·Ω is the slip of a damper in that motion, k_j = 0; what has a stiffness has none.
A tone is an angle φ = ω τ that is an integer combination of shaft angles; k_j and e_j are Fourier sums over tones.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.identity import PartId
from gearwright.showing import Shown


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
