"""Torque balance of the gear train with its tooth losses, and the power flow: branches and recirculating power."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, Kind, PartId, Power, Role, Row, Speed, Torque, carrier_part, largest_first
from gearwright.spec import GROUND, Design, Pair, Planetary
from gearwright.train.graph import INTERNAL, Mesh, Train, null_space, remembered, row_and_null_space
from gearwright.train.kinematics import Yielded

# ----------------------------------------------------------------------------------------------------------------------
# How parallel paths share what equilibrium leaves open, as equations that complete it.
#
# What may circulate without losses is the null space of the equations. Shares that the design states hold first, then
# equal ones; where they cannot be had, what is left of them has no part along what may circulate. Since that is said
# before any losses, the completion is the same whichever side of a mesh drives, and losses change the torques steadily.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Sharing:
    """Rows that run in parallel and the share of each; `stated` if the design says so."""

    rows: tuple[int, ...]
    """Rows of the graph."""
    share: tuple[float, ...]
    """Part of the group's load on each row [-]; the sum is one."""
    stated: bool
    """True if the design gives the shares, so that they hold before any other."""


def completing(free: Floats, scale: Floats, sharing: Sequence[Sharing]) -> Floats:
    """Return the equations that fix what equilibrium leaves open, shape (freedoms, unknowns); each is to give zero.

    Args:
        free: (unknowns, freedoms) basis of what balances by itself, without losses.
        scale: (unknowns,) length of each unknown's column; what no share fixes is as small as can be in units of it.
        sharing: Groups of parallel rows.

    Source: normal equations of the least squares of the deviations from the shares, within the null space.
    """
    written: list[Floats] = []
    for stated in (True, False):
        shares = [row for group in sharing if group.stated is stated for row in _shared(group, len(scale))]
        if shares and free.shape[1]:
            deviation = np.array(shares)
            felt, unfelt = row_and_null_space(deviation @ free)
            written.append((deviation @ free @ felt).T @ deviation)
            free = free @ unfelt
    written.append((free * scale[:, None] ** 2).T)
    equations = np.vstack(written) / scale
    return np.asarray(equations / np.linalg.norm(equations, axis=1, keepdims=True) * scale, dtype=np.float64)


def _shared(group: Sharing, size: int) -> list[Floats]:
    """Return the equations λ_i / share_i = λ_0 / share_0 of a group."""
    equations = []
    for row, share in zip(group.rows[1:], group.share[1:], strict=True):
        equation = np.zeros(size)
        equation[group.rows[0]], equation[row] = share, -group.share[0]
        equations.append(equation)
    return equations


def sharing_of(design: Design, train: Train) -> list[Sharing]:
    """Return the parallel rows of a train with the share of each.

    Args:
        design: With the shares that it states.
        train: Its graph.
    """
    groups = []
    for stage, pair in design.pairs.items():
        rows = tuple(k for k, mesh in enumerate(train.meshes) if mesh.stage == stage)
        if len(rows) > 1:
            groups.append(Sharing(rows, _shares(pair, len(rows)), stated=pair.share is not None))
    return groups


def _shares(pair: Pair, count: int) -> tuple[float, ...]:
    return tuple(pair.share) if pair.share is not None else (1.0 / count,) * count


# ----------------------------------------------------------------------------------------------------------------------
# Torques of every mesh and of the machines that balance: T + Aᵀ λ = 0, with losses that follow the power.
#
# Parallel paths leave λ undetermined: a share that the design states holds, and what is left is shared as equally as
# equilibrium allows (`sharing.py`). The elastic answer comes from the System.
# ----------------------------------------------------------------------------------------------------------------------


BALANCE_TOLERANCE = 1e-9
"""Largest torque left over, as a part of the largest applied, in a train that can balance."""
LARGEST_INVERSE = 1e6
"""Largest element of the inverse of a matrix of unit columns that is far from singular."""
UNDECIDED = 1e-9
"""Torque of a machine in a unit of what balances by itself, above which equilibrium does not decide it [-]."""


class Balance(NamedTuple):
    """The equations of a train's torques, ready to be solved for one load after the other."""

    matrix: Floats
    """(rows, nodes) Torque on each node per unit multiplier of each row."""
    balancing: tuple[int, ...]
    """Nodes of the machines whose torque balances."""
    completion: Floats
    """(freedoms, unknowns): what is zero besides the torques on the nodes, so that parallel paths share."""
    free: Floats
    """(unknowns, freedoms) Basis of what balances by itself without losses."""
    system: Floats
    """(nodes and freedoms, unknowns): torque on each node per unit of each unknown, then the completion."""
    scaled: Floats
    """The same with columns of unit length, which lets powers close to rounding."""
    scale: Floats
    """(unknowns,) Lengths of the columns."""
    inverse: Floats
    """(unknowns, nodes and freedoms) Of `scaled`, in the least-squares sense."""

    def with_losses(self, matrix: Floats) -> Balance:
        """Return the same equations where the rows' torques have losses.

        Args:
            matrix: (rows, nodes) torque on each node per unit multiplier of each row.
        """
        system = np.vstack([_written(matrix, self.balancing), self.completion])
        return Balance(matrix, self.balancing, self.completion, self.free, system, *_prepared(system))


def balance(matrix: Floats, balancing: Sequence[int], sharing: Sequence[Sharing] = ()) -> Balance:
    """Return the equations T + Aᵀ λ = 0 without losses, and what makes their solution one where paths are parallel.

    Args:
        matrix: (rows, nodes) A: torque on each node per unit multiplier of each row.
        balancing: Nodes of the machines whose torque balances.
        sharing: Groups of parallel rows.
    """
    system = _written(matrix, balancing)
    free = _free(system)
    scale = np.maximum(np.linalg.norm(system, axis=0), 1e-300)
    completion = completing(free, scale, sharing) if free.shape[1] else free.T
    completed = np.vstack([system, completion])
    return Balance(matrix, tuple(balancing), completion, free, completed, *_prepared(completed))


def solve_torques(known: Balance, applied: Floats) -> Floats | None:
    """Return the multipliers of the rows, then the torques of the balancing machines.

    Args:
        known: The equations.
        applied: (nodes,) torques that are given [N m].

    Returns:
        λ of every row [N m per tooth] and torque of every machine [N m], or None where no torques balance.
    """
    asked = np.concatenate([applied, np.zeros(len(known.completion))])
    first = known.inverse @ asked
    solution: Floats = (known.inverse @ (known.scaled @ first - asked) - first) / known.scale
    left = abs(known.system @ solution + asked).max(initial=0.0)
    return None if left > BALANCE_TOLERANCE * max(abs(applied).max(initial=0.0), 1e-30) else solution


def undecided(known: Balance, rows: int) -> Bools:
    """Tell of each balancing machine whether its torque may change without any node noticing, shape (machines,).

    Args:
        known: The equations without losses, in which what circulates inside the train does not touch the machines.
        rows: Number of rows, before the machines' unknowns.

    Source: the null space of the equations, restricted to the machines; empty where the torques are unique.
    """
    swing: Bools = np.abs(known.free[rows:]).max(axis=1, initial=0.0) > UNDECIDED
    return swing


def _written(matrix: Floats, balancing: Sequence[int]) -> Floats:
    """Return the torque on each node per unit multiplier of each row, then per unit torque of each machine."""
    rows, nodes = matrix.shape
    system = np.zeros((nodes, rows + len(balancing)))
    system[:, :rows] = matrix.T
    for k, node in enumerate(balancing, start=rows):
        system[node, k] = 1.0
    return system


@remembered
def _free(system: Floats) -> Floats:
    """Return what balances by itself, (unknowns, freedoms)."""
    scaled = system / np.maximum(np.linalg.norm(system, axis=0), 1e-300)
    none = np.zeros((system.shape[1], 0))
    if _inverse(scaled) is not None:
        return none
    values = np.linalg.svd(scaled, compute_uv=False)
    determined = len(values) == system.shape[1] and bool(np.all(values > 1e-10 * values.max(initial=0.0)))
    return none if determined else null_space(system)


@remembered
def _prepared(system: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the columns of a system scaled to unit length, their lengths, and the inverse."""
    scale = np.maximum(np.linalg.norm(system, axis=0), 1e-300)
    scaled = system / scale
    direct = _inverse(scaled)
    if direct is not None:
        return scaled, scale, direct
    left, values, right = np.linalg.svd(scaled, full_matrices=False)
    inverse = (right.T / np.where(values > 1e-12 * values.max(initial=0.0), values, np.inf)) @ left.T
    return scaled, scale, inverse


def _inverse(matrix: Floats) -> Floats | None:
    """Return the inverse of a square matrix that is far from singular, or None."""
    if matrix.shape[0] != matrix.shape[1]:
        return None
    try:
        inverse = np.asarray(np.linalg.inv(matrix), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    return inverse if abs(inverse).max() < LARGEST_INVERSE else None


# ----------------------------------------------------------------------------------------------------------------------
# Which side of every mesh drives: all states in which the sense of each tooth power agrees with its losses.
#
# With x the multipliers in balance and x₀ those without losses, x + Δ(sign x) x = x₀: a piecewise-linear problem, one
# piece for each combination of senses. With M the mean of both signs' Δ and S half their difference it is the
# absolute value equation (I + M) x + S |x| = x₀, which has one solution whatever x₀ is if the spectral radius of |(I
# + M)⁻¹ S| is below one. Where it is not, the sense of one row is fixed, both ways, until the rest has one solution:
# so every state is found, and that there is none, or more than one, is known and not merely met.
#
# Source: Rohn 2009, On unique solvability of the absolute value equation, Optimization Letters 3; the rounds within a
# piece: Mangasarian 2009, A generalized Newton method for absolute value equations, Optimization Letters 3.
# ----------------------------------------------------------------------------------------------------------------------


NOISE = 1e-10
"""Part of the largest unknown below which an unknown agrees with either sign [-]."""
ROUNDS = 40
"""Rounds in which senses may change within one piece; where they do not settle, the piece is cut [-]."""
MOST_PIECES = 4096
"""Pieces looked at before the question is left open [-]."""


class Losing(NamedTuple):
    """x + Δ(sign x) x = x₀, in unknowns of like size."""

    lossless: Floats
    """(rows,) x₀."""
    positive: Floats
    """(rows, rows) What a unit of each unknown adds to all of them while it is positive, by columns."""
    negative: Floats
    """(rows, rows) The same while it is negative."""


class States(NamedTuple):
    """What solves it."""

    found: list[Floats]
    """Every x, each (rows,)."""
    complete: bool
    """Whether there is certainly no other."""


def states(losing: Losing) -> States:
    """Return every state in which the signs agree with the losses.

    Args:
        losing: The equations.
    """
    if _is_slight(losing) and (state := _settled(losing, np.zeros(len(losing.lossless)))) is not None:
        return States([state], complete=True)
    found: list[Floats] = []
    pieces = [np.zeros(len(losing.lossless))]
    for _ in range(MOST_PIECES):
        if not pieces:
            return States(found, complete=True)
        fixed = pieces.pop()
        inverse, swing = _piece(losing, fixed)
        shift = swing if inverse is None else np.abs(inverse @ swing)
        state = _settled(losing, fixed) if inverse is not None and _contracts(shift) else None
        if state is None:
            pieces += _halves(fixed, shift)
        elif bool(np.all(state * fixed >= 0.0)) and not any(_alike(state, other) for other in found):
            found.append(state)
    return States(found, complete=False)


def _is_slight(losing: Losing) -> bool:
    """Tell whether all row sums of Δ are below a half, so that those of |(I + M)⁻¹ S| are below one."""
    row_sums = np.maximum(np.abs(losing.positive), np.abs(losing.negative)).sum(axis=1)
    return bool(row_sums.max(initial=0.0) < 0.5)


def _piece(losing: Losing, fixed: Floats) -> tuple[Floats | None, Floats]:
    """Return (I + M)⁻¹, or None where there is none, and S, where the signs of some unknowns are fixed."""
    mean = 0.5 * (losing.positive + losing.negative)
    mean = np.where(fixed > 0.0, losing.positive, np.where(fixed < 0.0, losing.negative, mean))
    swing: Floats = np.where(fixed == 0.0, 0.5 * (losing.positive - losing.negative), 0.0)
    try:
        inverse = np.asarray(np.linalg.inv(np.eye(len(mean)) + mean), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None, swing
    return (inverse if np.isfinite(inverse).all() else None), swing


def _contracts(shift: Floats) -> bool:
    """Tell whether the spectral radius is below one; row sums are a quick bound of it."""
    if shift.sum(axis=1).max(initial=0.0) < 1.0:
        return True
    return bool(np.abs(np.linalg.eigvals(shift)).max(initial=0.0) < 1.0)


def _settled(losing: Losing, fixed: Floats) -> Floats | None:
    """Return the state that the rounds end in, or None where they do not."""
    state, unit = losing.lossless, np.eye(len(fixed))
    before: Bools | None = None
    for _ in range(ROUNDS):
        negative: Bools = np.where(fixed == 0.0, state, fixed) < 0.0
        if before is not None and np.array_equal(before, negative):
            return state
        before = negative
        state = _linear(unit + np.where(negative, losing.negative, losing.positive), losing.lossless)
        if not np.isfinite(state).all():
            return None
        state = np.where(np.abs(state) <= NOISE * np.abs(state).max(initial=0.0), 0.0, state)
    return None


def _linear(matrix: Floats, right: Floats) -> Floats:
    """Return the solution of linear equations, infinite where there is none."""
    try:
        return np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
    except np.linalg.LinAlgError:
        return np.full(len(right), np.inf)


def _halves(fixed: Floats, shift: Floats) -> list[Floats]:
    """Return a piece with the sign of the unknown that shifts the others most fixed both ways; none where all are."""
    felt = np.where(fixed == 0.0, shift.sum(axis=0), 0.0)
    if not felt.max(initial=0.0) > 0.0:
        return []
    halves = np.tile(fixed, (2, 1))
    halves[:, int(np.argmax(felt))] = (-1.0, 1.0)
    return list(halves)


def _alike(one: Floats, other: Floats) -> bool:
    scale = max(np.abs(one).max(initial=0.0), np.abs(other).max(initial=0.0))
    return bool(np.abs(one - other).max(initial=0.0) <= np.sqrt(NOISE) * scale)


# ----------------------------------------------------------------------------------------------------------------------
# Losses of the teeth: what torques change by the side of a mesh that drives, since the driven one receives less.
# ----------------------------------------------------------------------------------------------------------------------


ROLLS = 1e-10
"""Part of their speed from the ground below which teeth do not roll on each other: their set turns as a block [-]."""


class Laws(NamedTuple):
    """What holds per unit multiplier of every row, by the sign of the multiplier; each (rows, …)."""

    positive: Floats
    negative: Floats

    def of(self, multipliers: Floats) -> Floats:
        """Return what holds with multipliers of given signs, shape (rows, …).

        Args:
            multipliers: Of every row [N m], shape (rows,).
        """
        return np.where(multipliers[:, None] < 0.0, self.negative, self.positive)


def lost(train: Train, matrix: Floats, speeds: Floats) -> Laws:
    """Return what the torques change where a row loses all that it carries, by the sign of the multiplier.

    The driven gear receives less and the carrier bears it. What does not roll loses nothing, whatever it carries.

    Args:
        train: The graph.
        matrix: Rows of meshes and clutches over the nodes, shape (rows, nodes).
        speeds: Of the nodes [rad/s], shape (nodes,).
    """
    rolls = rolling(train, matrix, speeds)
    fastest = np.abs(matrix).max(axis=1, initial=0.0) * np.abs(speeds).max(initial=0.0)
    still = (np.abs(rolls) <= ROLLS * fastest)[:, None]
    first, second = (np.where(still, 0.0, _change(train, matrix, driven)) for driven in (0, 1))
    forwards = rolls[:, None] > 0.0
    return Laws(np.where(forwards, second, first), np.where(forwards, first, second))


def lost_parts(train: Train, rows: int, efficiency: Mapping[str, float]) -> Floats:
    """Return the part 1 − η of what it carries that each row loses [-], shape (rows,); none of clutches.

    Args:
        train: The graph.
        rows: Number of meshes and clutches.
        efficiency: Stage, or mesh row -> efficiency of one mesh [-]; 1 where it is left out.
    """
    part = np.zeros(rows)
    part[: len(train.meshes)] = [
        1.0 - efficiency.get(mesh.name, efficiency.get(mesh.stage, 1.0)) for mesh in train.meshes
    ]
    return part


def rolling(train: Train, matrix: Floats, speeds: Floats) -> Floats:
    """Return z_a (ω_a − ω_c) of every mesh row [rad/s], shape (rows,); zero for clutches.

    Args:
        train: The graph.
        matrix: Rows of meshes and clutches over the nodes, shape (rows, nodes).
        speeds: Of the nodes [rad/s], shape (nodes,).
    """
    value = {**dict(zip(train.nodes, speeds, strict=True)), GROUND: 0.0}
    relative = np.zeros(len(matrix))
    for k, mesh in enumerate(train.meshes):
        first, _, carrier = mesh.nodes
        relative[k] = _teeth_of(train, matrix, k) * (value[first] - value[carrier])
    return -relative


def _teeth_of(train: Train, matrix: Floats, row: int) -> float:
    """Return z_a of a mesh row from the matrix, also where gear a is on the ground."""
    first, second, carrier = train.meshes[row].nodes
    entry = {node: matrix[row, train.column[node]] for node in (first, second, carrier) if node != GROUND}
    return float(entry[first] if first in entry else -entry[second] - entry[carrier])


def _change(train: Train, matrix: Floats, driven: int) -> Floats:
    """Return what the torques change where the first (0) or second (1) gear of every row receives nothing."""
    # The ground gets a column here: a ring that stands still is driven too, and its losses load the carrier.
    grounded = np.hstack([matrix, -matrix.sum(axis=1, keepdims=True)])
    column = {node: k for k, node in enumerate((*train.nodes, GROUND))}
    change = np.zeros_like(grounded)
    for k, mesh in enumerate(train.meshes):
        gear, carrier = column[mesh.nodes[driven]], column[mesh.nodes[2]]
        change[k, gear] -= grounded[k, gear]
        change[k, carrier] += grounded[k, gear]
    return change[:, :-1]


# ----------------------------------------------------------------------------------------------------------------------
# The torques of a train with losses: the lossless ones, then every state whose senses agree with the losses.
# ----------------------------------------------------------------------------------------------------------------------


class State(NamedTuple):
    """Torques in balance."""

    multipliers: Floats
    """Torque per tooth of every mesh row, then torque of every engaged clutch [N m]."""
    machines: Floats
    """Torque of every machine that balances [N m]."""
    effective: Floats
    """(rows, nodes): torque on a node per multiplier [-], losses included."""


class Solved(NamedTuple):
    """All states of a load."""

    lossless: State
    found: list[State]
    """With losses."""
    complete: bool
    """Whether there is certainly no other."""


class Lossy(NamedTuple):
    """Equations of torques that may lose, ready to be solved for one load and one set of efficiencies after another."""

    known: Balance
    """Without losses."""
    change: Laws
    """What the torques change where a row loses all that it carries."""
    felt: Laws
    """What a unit of each multiplier that loses all takes from every one, in units of their columns; (rows, rows)."""


def lossy(known: Balance, change: Laws) -> Lossy:
    """Return the equations of torques with losses.

    Args:
        known: The equations without losses.
        change: What the torques change where a row loses all that it carries.
    """
    rows, nodes = known.matrix.shape
    inverse, scale = known.inverse[:rows, :nodes], known.scale[:rows]
    return Lossy(known, change, Laws(*(inverse @ (law.T / scale) for law in change)))


def solve_lossless(known: Balance, applied: Floats) -> Solved | None:
    """Return the one state of balance under a load where no teeth lose anything, or None where no torques balance.

    Args:
        known: The equations without losses.
        applied: (nodes,) torques that are given [N m].
    """
    solution, rows = solve_torques(known, applied), len(known.matrix)
    if solution is None:
        return None
    state = State(solution[:rows], solution[rows:], known.matrix)
    return Solved(state, [state], complete=True)


def solve_lossy(equations: Lossy, part: Floats, applied: Floats) -> Solved | None:
    """Return every state of balance under a load, or None where no torques balance.

    Args:
        equations: From `lossy`.
        part: Part 1 − η that each row loses [-], shape (rows,).
        applied: (nodes,) torques that are given [N m].
    """
    known, rows = equations.known, len(part)
    lossless = solve_torques(known, applied)
    if lossless is None:
        return None
    senses = states(Losing(known.scale[:rows] * lossless[:rows], *(law * part for law in equations.felt)))
    found = []
    for multipliers in senses.found:
        effective = known.matrix + part[:, None] * equations.change.of(multipliers)
        solution = solve_torques(known.with_losses(effective), applied)
        if solution is None:
            return None
        found.append(State(solution[:rows], solution[rows:], effective))
    return Solved(State(lossless[:rows], lossless[rows:], known.matrix), found, senses.complete)


# ----------------------------------------------------------------------------------------------------------------------
# What a balanced load case carries: in its meshes, clutches, dampers and machines.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDING = 1e-12
"""Of the largest power of a machine: what is lost below this are sums that nearly close [-]. Trains without losses
leave up to 5e-14."""


@dataclass(frozen=True)
class MeshFlow:
    """What one row of equal meshes carries."""

    name: str
    multiplier: float
    """Torque per tooth of all equal meshes together, λ [N m]."""
    torques: tuple[float, float, float]
    """Torque on the nodes of gear a, gear b and carrier, all equal meshes together [N m]."""
    tooth_power: float
    """Power through the teeth relative to the carrier, positive from a to b [W]."""
    loss: float
    """Power lost in the teeth [W]."""


@dataclass(frozen=True)
class Dragged:
    """What a damper carries."""

    torque: float
    """That it gives to its driven shaft [N m]."""
    slip: float
    """Speed of its driving shaft over the driven one [rad/s]."""

    @property
    def loss(self) -> float:
        """Heat [W]."""
        return self.torque * self.slip


@dataclass(frozen=True)
class PowerFlow:
    """A balanced load case."""

    case: str
    speeds: Mapping[str, float]
    """Node -> speed [rad/s]; the ground is in it with zero."""
    machine_torques: Mapping[str, float]
    """Machine -> torque on its shaft [N m]."""
    machine_powers: Mapping[str, float]
    """Machine -> power into the train [W]; negative takes power out."""
    meshes: Mapping[str, MeshFlow]
    """Mesh row -> what it carries."""
    joints: Mapping[str, float] = field(default_factory=dict)
    """Engaged clutch -> torque that it gives to its driven shaft [N m]; an open one is not in it."""
    dampers: Mapping[str, Dragged] = field(default_factory=dict)
    """Damper -> what it carries."""
    yielded: tuple[Yielded, ...] = ()
    """Machines whose asked speed the teeth give only nearly."""

    @property
    def loss(self) -> float:
        """Power lost in all meshes and dampers [W]; none where it is rounding beside the powers of the machines."""
        lost = sum(mesh.loss for mesh in self.meshes.values()) + sum(damper.loss for damper in self.dampers.values())
        return lost if abs(lost) > ROUNDING * max(map(abs, self.machine_powers.values()), default=0.0) else 0.0

    def given(self, link: str) -> float:
        """Return the torque that a clutch or damper gives to its driven shaft [N m]; zero of an open clutch.

        Args:
            link: Its name.
        """
        return self.dampers[link].torque if link in self.dampers else self.joints.get(link, 0.0)

    @property
    def residual(self) -> float:
        """Power in minus power out minus losses, as a part of the power in [-]."""
        powers = self.machine_powers.values()
        supplied = sum(power for power in powers if power > 0.0)
        return abs(sum(powers) - self.loss) / supplied if supplied else 0.0


def shaft_powers(train: Train, flow: PowerFlow) -> dict[tuple[str, str], float]:
    """Return what every stage gives to each shaft that it meshes with [W]; negative where it takes.

    Args:
        train: The graph.
        flow: A load case.

    Returns:
        (stage, shaft) -> power; planets are within their stage.
    """
    powers: dict[tuple[str, str], float] = {}
    for mesh in train.meshes:
        for node, torque in zip(mesh.nodes, flow.meshes[mesh.name].torques, strict=True):
            if node != GROUND and node not in train.planet_nodes:
                key = (mesh.stage, node)
                powers[key] = powers.get(key, 0.0) + torque * flow.speeds[node]
    return powers


# ----------------------------------------------------------------------------------------------------------------------
# Branches of the power flow: what each machine, gear, carrier, clutch and damper gives to its shaft.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Branch:
    """One part on one shaft; a part that takes power out of the shaft has a negative power."""

    shaft: str
    """Shaft, or ``ground``."""
    part: PartId
    """Machine, clutch, damper, or member of a stage such as ``first.sun``, ``first.carrier``."""
    stage: str
    """Pair or planetary set; empty for what is in no stage."""
    speed: Speed
    """Of the shaft [rad/s]."""
    torque: Torque
    """On the shaft [N m]."""

    @property
    def power(self) -> Power:
        """Into the shaft [W]."""
        return self.torque * self.speed


@dataclass(frozen=True)
class Attachment:
    """Where a part of the train sits on a shaft."""

    shaft: str
    part: PartId
    stage: str
    """Of which it is a member there, also of a gear that another pair owns; empty for what is in no stage."""

    @property
    def member(self) -> Role | Kind:
        """What it is there: role of a gear, or carrier, machine, clutch, damper."""
        return self.part.role if isinstance(self.part.role, Role) else self.part.kind


def attachments(train: Train) -> tuple[Attachment, ...]:
    """Return every part of a train with the shaft, or the ground, that it sits on.

    Args:
        train: The graph.
    """
    machines = [Attachment(shaft, PartId(Kind.MACHINE, name), "") for name, shaft in train.machines.items()]
    gears = [
        Attachment(shaft, gear.part, gear.stage)
        for gear in train.gears
        for shaft in gear.nodes
        if gear.role is not Role.PLANET
    ]
    shared = [
        Attachment(node, train.gear(gear).part, mesh.stage)
        for mesh in train.meshes
        for gear, node in zip(mesh.gears, mesh.nodes, strict=False)
        if train.gear(gear).stage != mesh.stage
    ]
    carriers = [
        Attachment(mesh.nodes[2], carrier_part(mesh.stage), mesh.stage)
        for mesh in train.meshes
        if mesh.row is not Row.PAIR
    ]
    links = [
        Attachment(shaft, PartId(kind, link.name), "")
        for kind, group in ((Kind.CLUTCH, train.joints), (Kind.DAMPER, train.dampers))
        for link in group
        for shaft in (link.driving, link.driven)
    ]
    return tuple(dict.fromkeys([*machines, *gears, *shared, *carriers, *links]))


def branches(train: Train, flow: PowerFlow) -> tuple[Branch, ...]:
    """Return what every part gives to its shaft in one load case.

    Args:
        train: The graph.
        flow: The case.
    """
    return tuple(
        Branch(
            attachment.shaft,
            attachment.part,
            attachment.stage,
            flow.speeds[attachment.shaft],
            _torque(attachment, train, flow),
        )
        for attachment in attachments(train)
    )


def _torque(attachment: Attachment, train: Train, flow: PowerFlow) -> float:
    part = attachment.part
    if part.kind is Kind.MACHINE:
        return flow.machine_torques[part.name]
    if part.kind in (Kind.CLUTCH, Kind.DAMPER):
        link = next(link for link in train.links if link.name == part.name)
        torque = flow.given(part.name)
        return torque if attachment.shaft == link.driven else -torque
    return sum(_on_member(attachment, mesh, flow) for mesh in train.meshes if mesh.stage == attachment.stage)


def _on_member(attachment: Attachment, mesh: Mesh, flow: PowerFlow) -> float:
    torques, name = flow.meshes[mesh.name].torques, str(attachment.part)
    if attachment.part.kind is Kind.CARRIER:
        return torques[2]
    ends = zip(mesh.gears, mesh.nodes[:2], torques[:2], strict=True)
    return sum(torque for gear, node, torque in ends if gear == name and node == attachment.shaft)


# ----------------------------------------------------------------------------------------------------------------------
# Power that runs in a circle: out of a stage on one shaft, through other stages, and back into it on another.
# ----------------------------------------------------------------------------------------------------------------------


SMALLEST_SHARE = 1e-9
"""Circulating power below this part of the power supplied is rounding."""


@dataclass(frozen=True)
class Loop:
    """One circle of power."""

    path: tuple[str, ...]
    """Stages and shafts in the direction of the power; the first one follows the last."""
    power: float
    """What circulates [W]."""


def recirculation(train: Train, flow: PowerFlow) -> tuple[Loop, ...]:
    """Return every circle in which power runs, the largest first; none is the usual case.

    Args:
        train: The graph.
        flow: A load case.
    """
    edges = _edges(train, flow)
    supplied = sum(power for power in flow.machine_powers.values() if power > 0.0)
    loops = []
    while (path := _circle(edges)) is not None:
        steps = list(zip(path, (*path[1:], path[0]), strict=True))
        power = min(edges[start][end] for start, end in steps)
        loops.append(Loop(tuple(path), power))
        for start, end in steps:
            edges[start][end] -= power
            if edges[start][end] <= SMALLEST_SHARE * supplied:
                del edges[start][end]
    return tuple(largest_first(loops, lambda loop: loop.power))


def _edges(train: Train, flow: PowerFlow) -> dict[str, dict[str, float]]:
    """Return the power from every stage to the shafts that it drives, and to it from those that drive it [W]."""
    powers = {(f"stage {stage}", shaft): power for (stage, shaft), power in shaft_powers(train, flow).items()}
    for link in train.links:
        torque = flow.given(link.name)
        powers[(f"link {link.name}", link.driven)] = torque * flow.speeds[link.driven]
        powers[(f"link {link.name}", link.driving)] = -torque * flow.speeds[link.driving]
    supplied = sum(power for power in flow.machine_powers.values() if power > 0.0)
    edges: dict[str, dict[str, float]] = {}
    for (stage, shaft), power in powers.items():
        if abs(power) > SMALLEST_SHARE * supplied:
            start, end = (stage, shaft) if power > 0.0 else (shaft, stage)
            edges.setdefault(start, {})[end] = abs(power)
    return edges


def _circle(edges: Mapping[str, Mapping[str, float]]) -> list[str] | None:
    """Return one directed circle, or None."""
    done: set[str] = set()
    for start in edges:
        path: list[str] = []
        circle = _walk(start, edges, path, done)
        if circle is not None:
            return circle
    return None


def _walk(node: str, edges: Mapping[str, Mapping[str, float]], path: list[str], done: set[str]) -> list[str] | None:
    """Follow the power from a node until a node of the path comes again."""
    if node in path:
        return path[path.index(node) :]
    if node in done:
        return None
    path.append(node)
    for following in edges.get(node, {}):
        circle = _walk(following, edges, path, done)
        if circle is not None:
            return circle
    path.pop()
    done.add(node)
    return None


# ----------------------------------------------------------------------------------------------------------------------
# How often teeth mesh and planets pass: the frequencies that a turning train shakes its housing with.
# ----------------------------------------------------------------------------------------------------------------------


Pass = Literal["mesh", "planet-pass"]


def passes(
    design: Design, train: Train, teeth: Mapping[str, float], flow: PowerFlow, of: Pass
) -> Iterator[tuple[Mesh, float]]:
    """Yield the rows of a train whose teeth mesh, or whose planets pass a tooth of their ring, and how often [Hz].

    Both rows of a planetary set mesh as often: the one with the sun speaks for it. What stands still passes nothing.

    Args:
        design: With its stages.
        train: Its graph.
        teeth: Tooth number of every gear.
        flow: A load case.
        of: Teeth (mesh) or planets (planet-pass).

    Source: counting: z |ω − ω_c|/2π and N |ω_c − ω_r|/2π; McFadden & Smith 1985, Proc. Inst. Mech. Eng. C 199, 65-70.
    """
    for mesh in train.meshes:
        first, second, carrier = (flow.speeds[node] for node in mesh.nodes)
        in_ring = mesh.sign == INTERNAL
        if of == "mesh" and not (in_ring and isinstance(design.stages[mesh.stage], Planetary)):
            frequency = teeth[mesh.gears[0]] * abs(first - carrier) / (2.0 * math.pi)
        elif of == "planet-pass" and in_ring and mesh.stage in design.sets:
            frequency = mesh.count * abs(carrier - second) / (2.0 * math.pi)
        else:
            continue
        if frequency:
            yield mesh, frequency
