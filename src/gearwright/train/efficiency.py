"""Efficiency of a stage or a train driven from either side, and self-locking."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.arrays import Floats, largest
from gearwright.errors import SolveError
from gearwright.spec import Design
from gearwright.train.algebra import remembered
from gearwright.train.balance import STANDSTILL
from gearwright.train.graph import Train
from gearwright.train.kinematics import rows
from gearwright.train.power_flow import PowerFlow, recirculation
from gearwright.train.torques import Laws, Sharing, balance, lossy, lost, lost_parts, sharing_of, solve_lossy
from gearwright.units import Ratio

# ----------------------------------------------------------------------------------------------------------------------
# What comes out of a set, or of a train, of the power that goes in, driven from either side; self-locking by name.
#
# Speeds stay; the torques of all members turn their sense. A train that gives nothing when it is driven from one side,
# because its teeth lose all that goes in, locks itself against that side.
# ----------------------------------------------------------------------------------------------------------------------


IDLE = 1e-9
"""Part of the largest power of a case below which a shaft passes none [-]."""


@dataclass(frozen=True)
class Efficiency:
    """How a set, or a train, passes power in one load case, and how it would with every torque turned."""

    driving: tuple[str, ...]
    """Shafts that give power to it, the largest first."""
    driven: tuple[str, ...]
    """Shafts that take power from it, the largest first."""
    forwards: Ratio
    """Power out over power in, as it is driven [-]; what is not above zero locks."""
    backwards: Ratio
    """The same where the driven shafts drive [-]; what is not above zero locks."""

    @property
    def locked(self) -> tuple[str, ...]:
        """Shafts that cannot drive it, however large their torque: it locks itself; empty where every shaft can."""
        return (*(self.driving if self.forwards <= 0.0 else ()), *(self.driven if self.backwards <= 0.0 else ()))

    @property
    def locking(self) -> str:
        """Who can drive it and who cannot, in words; empty where every shaft can."""
        free = [shaft for shaft in (*self.driving, *self.driven) if shaft not in self.locked]
        only = f", only {' and '.join(free)} can" if free else ""
        return f"{' and '.join(self.locked)} cannot drive it{only}" if self.locked else ""


def efficiencies(
    design: Design, train: Train, teeth: Mapping[str, float], flow: PowerFlow, efficiency: Mapping[str, float], *,
    parts: Collection[str] | None = None,
) -> dict[str, Efficiency]:  # fmt: skip
    """Return the efficiency of every stage through which power passes in a case, and of the train under its case.

    Args:
        design: With the shares of parallel paths.
        train: Its graph.
        teeth: Tooth number of every gear.
        flow: The case.
        efficiency: Stage, or mesh row -> efficiency of one mesh [-]; 1 where it is left out.
        parts: Stages that are asked for, or an empty name; left out: all.

    Returns:
        Stage -> how it passes power; the whole train is under an empty name.
    """
    joints = [joint for joint in train.joints if joint.name in flow.joints]
    matrix = rows(train, teeth, joints)
    speeds = np.array([flow.speeds[node] for node in train.nodes])
    part = lost_parts(train, len(matrix), efficiency)
    whole = _Rows(matrix, lost(train, matrix, speeds), part, speeds, sharing_of(design, train))
    outside, passing = _outside(train, flow), dict[str, _Passing | None]()
    for name in dict.fromkeys(["", *(mesh.stage for mesh in train.meshes)]) if parts is None else parts:
        its = [k for k, mesh in enumerate(train.meshes) if mesh.stage == name]
        passing[name] = _passing(whole.only(its), _on_stage(train, flow, name)) if name else _passing(whole, outside)
    return {name: _named(train, found) for name, found in passing.items() if found is not None}


@dataclass(frozen=True)
class _Rows:
    """A train, or a stage of it, as it turns in a case."""

    matrix: Floats
    change: Laws
    part: Floats
    speeds: Floats
    sharing: Sequence[Sharing]

    def only(self, rows: list[int]) -> _Rows:
        """Return some of the rows, cut out of the train."""
        change = Laws(*(law[rows] for law in self.change))
        return _Rows(self.matrix[rows], change, self.part[rows], self.speeds, ())

    def without_losses(self) -> _Rows:
        """Return the same rows where nothing is lost."""
        return replace(self, part=np.zeros(len(self.part)))

    def driven(self, torques: Floats, order: Sequence[int]) -> Floats | None:
        """Return the torques from outside where some nodes balance the others; None if there is no one state.

        Args:
            torques: From outside on every node [N m]; those that do not balance keep theirs.
            order: Nodes that may balance, the first first.
        """
        balancing: list[int] = []
        bound, rank, unit = self.matrix, _rank(self.matrix), np.eye(len(torques))
        for node in order:
            more = np.vstack([bound, unit[[node]]])
            if (higher := _rank(more)) > rank:
                balancing, bound, rank = [*balancing, node], more, higher
        outside = torques.copy()
        outside[balancing] = 0.0
        equations = lossy(balance(self.matrix, balancing, self.sharing), self.change)
        solved = solve_lossy(equations, self.part, outside)
        if solved is None or len(solved.found) != 1 or not solved.complete:
            return None
        outside[balancing] = solved.found[0].machines
        return outside


@dataclass(frozen=True)
class _Passing:
    """Nodes in place of shafts."""

    driving: list[int]
    driven: list[int]
    forwards: float
    backwards: float


@remembered
def _rank(matrix: Floats) -> Floats:
    """Return the rank of a matrix [-]."""
    return np.array(np.linalg.matrix_rank(matrix), dtype=float)


def _named(train: Train, passing: _Passing) -> Efficiency:
    driving, driven = (tuple(train.nodes[k] for k in nodes) for nodes in (passing.driving, passing.driven))
    return Efficiency(driving, driven, passing.forwards, passing.backwards)


def _outside(train: Train, flow: PowerFlow) -> Floats:
    """Return the torque of all machines on every node [N m]."""
    torques = np.zeros(len(train.nodes))
    for machine, torque in flow.machine_torques.items():
        torques[train.column[train.machines[machine]]] += torque
    return torques


def _on_stage(train: Train, flow: PowerFlow, stage: str) -> Floats:
    """Return the torque that the rest of the train puts on every node of a stage [N m]."""
    torques = np.zeros(len(train.nodes))
    for mesh in train.meshes:
        if mesh.stage == stage:
            for node, torque in zip(mesh.nodes, flow.meshes[mesh.name].torques, strict=True):
                if node in train.column:
                    torques[train.column[node]] -= torque
    return torques


def _passing(rows: _Rows, torques: Floats) -> _Passing | None:
    """Return how rows pass the power of torques from outside, or None where no power passes."""
    speeds = rows.speeds
    turning = np.abs(speeds) > STANDSTILL * np.abs(speeds).max(initial=0.0)
    held = [int(k) for k in np.flatnonzero(~turning & (np.abs(torques) > 0.0))]
    driving, driven = _ends(np.where(turning, torques * speeds, 0.0))
    if driving and not driven:  # all that goes in is lost: the senses are those without losses
        lossless = rows.without_losses().driven(torques, [*held, *driving[::-1]])
        torques = torques if lossless is None else lossless
        driving, driven = _ends(np.where(turning, torques * speeds, 0.0))
    if not driving or not driven:
        return None
    forwards, backwards = (
        _passed(rows, sense * torques, held, giving=giving, taking=taking)
        for sense, giving, taking in ((1.0, driving, driven), (-1.0, driven, driving))
    )
    return _Passing(driving, driven, forwards, backwards)


def _passed(rows: _Rows, torques: Floats, held: list[int], *, giving: list[int], taking: list[int]) -> float:
    """Return power out over power in; nothing where they can be driven in no state [-]."""
    for first, last in ((taking, giving), (giving, taking)):
        outside = rows.driven(torques, [*held, *first, *last[::-1]])
        if outside is not None:
            powers = outside * rows.speeds
            given = float(powers[giving].sum())
            return -float(powers[taking].sum()) / given if given > 0.0 else 0.0
    return 0.0


def _ends(powers: Floats) -> tuple[list[int], list[int]]:
    """Return the nodes that give power and those that take it, the largest first."""
    rest, passing = list(range(len(powers))), list[int]()
    while rest:
        passing.append(largest(rest, lambda node: abs(powers[node])))
        rest.remove(passing[-1])
    passing = [k for k in passing if abs(powers[k]) > IDLE * abs(powers[passing[0]])]
    return [k for k in passing if powers[k] > 0.0], [k for k in passing if powers[k] < 0.0]


# ----------------------------------------------------------------------------------------------------------------------
# Why losses leave a load case no state in which the train turns, or several: what locks, and what would do.
# ----------------------------------------------------------------------------------------------------------------------


def jammed(
    train: Train, lossless: PowerFlow, found: Sequence[PowerFlow], ways: Mapping[str, Efficiency], *, complete: bool
) -> SolveError:
    """Return the error of a case that losses leave no state, several, or one that may not be the only one.

    Args:
        train: The graph.
        lossless: The case without losses.
        found: The states with losses.
        ways: Stage -> how it passes power in the senses of the lossless case; the train under an empty name.
        complete: Whether there is certainly no other state.
    """
    reasons = "; ".join(_reasons(train, lossless, ways))
    what = _several(found) if found else "with the losses of its teeth no torques balance: the train locks itself"
    if not complete:
        what = f"whether losses leave one state is not decided; {len(found)} found so far"
    fix = "Drive it from the other side, use higher efficiencies, or other teeth"
    if len(found) > 1:
        fix = "Let the machine whose power is stated balance, and state that of the other"
    return SolveError(f"cases.{lossless.case}: {what}{f' ({reasons})' if reasons else ''}. {fix}")


def _several(found: Sequence[PowerFlow]) -> str:
    """Return the states in words: what each machine whose power differs between them gives."""
    differing = [
        machine
        for machine, power in found[0].machine_powers.items()
        if any(abs(flow.machine_powers[machine] - power) > 1e-9 * abs(power) for flow in found[1:])
    ]
    states = ", or ".join(
        " and ".join(f"{machine} {flow.machine_powers[machine] / 1e3:+.4g} kW" for machine in differing)
        for flow in found
    )
    return f"with the losses of its teeth {len(found)} states balance: {states}"


def _reasons(train: Train, lossless: PowerFlow, ways: Mapping[str, Efficiency]) -> Iterator[str]:
    stages = {stage: way for stage, way in ways.items() if stage and way.locked}
    for stage, way in stages.items():
        yield f"{stage} is self-locking: {way.locking}"
    if not stages:
        for loop in recirculation(train, lossless):
            yield f"{loop.power / 1e3:.4g} kW would run in a circle: {', '.join(loop.path)}"
