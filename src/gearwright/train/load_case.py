"""Load cases of a gear train with losses, efficiency of a stage or a train from either side, and self-locking."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Problem, Ratio, SolveError, largest, refuse
from gearwright.elementwise import Values
from gearwright.spec import GROUND, RATED, Design, Drive, case_named, cases_of, drives_of
from gearwright.train.graph import RANK_TOLERANCE, Damper, Joint, Mesh, Train, remembered
from gearwright.train.kinematics import Yielded, motions_of, rows, solve_speeds
from gearwright.train.torques import (
    Balance,
    Dragged,
    Laws,
    Lossy,
    MeshFlow,
    PowerFlow,
    Sharing,
    State,
    balance,
    lossy,
    lost,
    lost_parts,
    recirculation,
    sharing_of,
    solve_lossless,
    solve_lossy,
    undecided,
)

# ----------------------------------------------------------------------------------------------------------------------
# How a train turns: the speeds that a load case asks for, and those that the teeth give.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Turn:
    """One way in which a train turns."""

    matrix: Floats
    """From `rows`."""
    speeds: Floats
    """Of every node [rad/s]."""
    yielded: tuple[Yielded, ...]
    """Machines whose asked speed the teeth give only nearly."""
    train: Train
    """What turns."""
    sharing: Sequence[Sharing]
    """Parallel rows."""
    balances: dict[tuple[int, ...], Balance] = field(default_factory=dict)
    """Nodes of balancing machines -> equations of the torques without losses."""
    equations: dict[tuple[int, ...], Lossy] = field(default_factory=dict)
    """The same with losses."""

    @cached_property
    def lost(self) -> Laws:
        """What the torques change where teeth lose all that they carry."""
        return lost(self.train, self.matrix, self.speeds)

    def balance(self, balancing: Sequence[int]) -> Balance:
        """Return the equations of the torques without losses, made once.

        Args:
            balancing: Nodes of the machines whose torque balances.
        """
        key = tuple(balancing)
        if key not in self.balances:
            self.balances[key] = balance(self.matrix, balancing, self.sharing)
        return self.balances[key]

    def lossy(self, balancing: Sequence[int]) -> Lossy:
        """Return the equations of the torques, made once.

        Args:
            balancing: Nodes of the machines whose torque balances.
        """
        key = tuple(balancing)
        if key not in self.equations:
            self.equations[key] = lossy(self.balance(balancing), self.lost)
        return self.equations[key]


class Turning:
    """The speeds of a train with its teeth. Load cases often turn alike: each way is solved once."""

    def __init__(self, design: Design, train: Train, teeth: Mapping[str, float]) -> None:
        self.train, self.teeth = train, teeth
        self._known: dict[tuple[object, ...], Turn] = {}
        self.sharing = sharing_of(design, train)
        """Parallel rows, and the share of each that the design states."""
        self.asked = asked_speeds(design, {})
        """Machine -> rated speed [rad/s], the one to be kept first."""
        rated = self.turn(self.asked, holding(design, train, cases_of(design)[0]))
        self.yielded = rated.yielded
        """Machines whose rated speed the teeth give only nearly."""
        self.senses = {
            node: -1.0 if speed < 0.0 else 1.0 for node, speed in zip(train.nodes, rated.speeds.tolist(), strict=True)
        }
        """Node -> sense in which it turns, ±1: that of the rated speeds, whatever drives in a case."""

    def turn(self, asked: Mapping[str, float], joints: Sequence[Joint]) -> Turn:
        """Return how the train turns at asked speeds.

        Args:
            asked: Machine -> speed [rad/s], the one to be kept first.
            joints: The clutches that are engaged.

        Raises:
            DesignError: If a shaft is locked, or speeds stay free.
        """
        key = (*joints, *asked.items())
        if key not in self._known:
            matrix = rows(self.train, self.teeth, joints)
            speeds, yielded = solve_speeds(self.train, matrix, asked, joints=joints)
            self._known[key] = Turn(matrix, speeds, tuple(yielded), self.train, self.sharing)
        return self._known[key]

    def locked(self, joints: Sequence[Joint]) -> frozenset[str]:
        """Return the machines whose shafts the brakes that hold keep from turning.

        Args:
            joints: The clutches and brakes that hold.
        """
        if not any(joint.is_brake for joint in joints):
            return frozenset()
        motions = motions_of(rows(self.train, self.teeth, joints))
        still = np.linalg.norm(motions, axis=1) < RANK_TOLERANCE
        return frozenset(name for name, shaft in self.train.machines.items() if still[self.train.column[shaft]])


def holding(design: Design, train: Train, case: str) -> tuple[Joint, ...]:
    """Return the clutches and brakes that hold in a case; an overrunning one may open by itself.

    Args:
        design: With its cases.
        train: The graph.
        case: Name of the case.
    """
    engaged = case_named(design, case).engaged
    return tuple(
        joint
        for joint in train.joints
        if joint.overrunning or (not joint.is_open if engaged is None else joint.name in engaged)
    )


def asked_speeds(design: Design, drives: Mapping[str, Drive]) -> dict[str, float]:
    """Return machine -> asked speed [rad/s] in the order in which they are kept.

    Args:
        design: With the machines' rated speeds and the order of keeping.
        drives: The case; a speed given there comes first and replaces the rated one.
    """
    machines = design.machines
    order = dict.fromkeys([*(design.speeds.keep or []), *machines])
    speeds = {name: drives[name].speed for name in order if name in drives}
    if all(speed is None for speed in speeds.values()):
        speeds = {name: machines[name].asked_speed for name in order}
    asked = {name: speed for name, speed in speeds.items() if speed is not None}
    reversed_ = {name for name, motor in design.motors.items() if motor.reverse}
    return {name: -speed if name in reversed_ else speed for name, speed in asked.items()}


# ----------------------------------------------------------------------------------------------------------------------
# Why a load case has no torques, or more than one set of them, and what would do.
# ----------------------------------------------------------------------------------------------------------------------


def ambiguous(design: Design, case: str, undecided: Sequence[str]) -> DesignError:
    """Return the error of a case in which equilibrium leaves open how machines divide what the others leave.

    Args:
        design: With its cases.
        case: Name of the case.
        undecided: The machines that balance and whose torque equilibrium does not decide.
    """
    names = " and ".join(undecided)
    write, many = f"[cases.{case}.{undecided[-1]}] power_kw = -100", "both" if len(undecided) == 2 else "all"
    missing = ""
    if case not in design.cases:
        missing = f"; {case!r}, every machine at its rating, is the case of a design without cases"
        drives = " and ".join(f"[cases.take-off.{name}] rating = 1" for name in (*design.turbines, *design.motors))
        write = f"{drives} with [cases.take-off.{undecided[-1]}] power_kw = -100"
    return DesignError([
        Problem(
            f"cases.{case}",
            f"{names} {many} balance one branch, and nothing says how they divide its power{missing}; give the"
            f" power or torque of all but one, such as {write} (negative takes power), or 0 for one that idles",
        )
    ])  # fmt: skip


def unbalanced(train: Train, balancing: Sequence[str], case: str) -> DesignError:
    """Return the error of a case in which no torques balance.

    Args:
        train: The graph.
        balancing: The machines that are free to balance.
        case: Name of the case.
    """
    takers = ", ".join(balancing) or "no machine"
    held = {mesh.stage for mesh in train.meshes if GROUND in mesh.nodes}
    loose = ", ".join(dict.fromkeys(mesh.stage for mesh in train.meshes if mesh.stage not in held))
    fix = (
        f"All three members of {loose} turn: ground one, or put a machine that balances on each"
        if loose
        else "Join the shafts, engage a clutch, or leave out the power of one more machine so that it balances"
    )
    return DesignError([
        Problem(
            f"cases.{case}",
            f"no torques balance: {takers} is free to balance, and the power of some machine has no path to it. {fix}",
        )
    ])  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# The torques of one load case in balance, with losses in the direction of the power.
# ----------------------------------------------------------------------------------------------------------------------


STANDSTILL = 1e-12
"""Speed below this part of the largest one is rounding of a shaft that stands still."""


class Balanced(NamedTuple):
    """The torques of a case in balance."""

    machine_torques: dict[str, float]
    """Machine -> torque on its shaft [N m]."""
    multipliers: Floats
    """Torque per tooth of every mesh row, then torque of every engaged clutch [N m]."""
    effective: Floats
    """(rows, nodes): torque on a node per multiplier [-], losses included."""


class Torques(NamedTuple):
    """All states in which a case is in balance."""

    lossless: Balanced
    """Without losses."""
    found: list[Balanced]
    """With losses, each with tooth powers whose senses agree with them."""
    complete: bool
    """Whether there is certainly no other."""


def balanced(
    design: Design, train: Train, turn: Turn, efficiency: Mapping[str, float], stated: Mapping[str, float], *,
    balancing: Sequence[str], case: str,
) -> Torques:  # fmt: skip
    """Return the torques that balance a case, with losses in the direction of the power.

    Args:
        design: With machines and cases.
        train: Its graph.
        turn: How it turns.
        efficiency: Stage, or mesh row -> efficiency of one mesh [-]; 1 where it is left out.
        stated: Machine -> torque that the case gives [N m].
        balancing: Machines that balance the rest.
        case: Name of the case.

    Raises:
        DesignError: If no torques balance, or equilibrium leaves open what a machine gives.
    """
    applied = _applied(train, turn.speeds, stated)
    nodes = [train.column[train.machines[name]] for name in balancing]
    known, part = turn.balance(nodes), lost_parts(train, len(turn.matrix), efficiency)
    open_ = undecided(known, len(turn.matrix))
    if open_.any():
        raise ambiguous(design, case, [name for name, free in zip(balancing, open_, strict=True) if free])
    solved = solve_lossy(turn.lossy(nodes), part, applied) if part.any() else solve_lossless(known, applied)
    if solved is None:
        raise unbalanced(train, balancing, case)

    def named(state: State) -> Balanced:
        torques = {**stated, **dict(zip(balancing, state.machines.tolist(), strict=True))}
        return Balanced(torques, state.multipliers, state.effective)

    return Torques(named(solved.lossless), [named(state) for state in solved.found], solved.complete)


def _applied(train: Train, speeds: Floats, stated: Mapping[str, float]) -> Floats:
    """Return the torques on every node that are given: of machines and dampers [N m]."""
    applied = np.zeros(len(train.nodes))
    for name, torque in stated.items():
        applied[train.column[train.machines[name]]] += torque
    for damper in train.dampers:
        torque = dragged(train, damper, speeds).torque
        applied[train.column[damper.driven]] += torque
        applied[train.column[damper.driving]] -= torque
    return applied


def dragged(train: Train, damper: Damper, speeds: Floats) -> Dragged:
    """Return what a damper carries; a slip that is rounding of the speeds is none.

    Args:
        train: The graph.
        damper: One of its dampers.
        speeds: Of the nodes [rad/s], shape (nodes,).
    """
    slip = float(speeds[train.column[damper.driving]] - speeds[train.column[damper.driven]])
    slip = slip if abs(slip) > STANDSTILL * float(np.abs(speeds).max(initial=0.0)) else 0.0
    return Dragged(damper.damping * slip, slip)


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


# ----------------------------------------------------------------------------------------------------------------------
# One load case of a train: every speed, every torque, every power, closed to rounding.
# ----------------------------------------------------------------------------------------------------------------------


def power_flow(
    design: Design, train: Train, teeth: Mapping[str, float], case: str = RATED, *,
    efficiency: Mapping[str, float] | None = None, turning: Turning | None = None,
) -> PowerFlow:  # fmt: skip
    """Return the speeds, torques and powers of a case.

    Args:
        design: With machines and cases.
        train: Its graph.
        teeth: Tooth number of every gear.
        case: Name of the case.
        efficiency: Stage -> efficiency of each of its meshes [-]; left out: lossless.
        turning: Of this train and teeth, where many cases are solved; left out: made anew.

    Raises:
        DesignError: If shafts are locked or free, or no torques balance.
        SolveError: If losses leave no state in which the train turns, or several.
    """
    return _flow(design, turning or Turning(design, train, teeth), case, efficiency or {})


def power_flows(
    design: Design, turning: Turning, *, efficiency: Mapping[str, float] | None = None
) -> dict[str, PowerFlow]:
    """Return the speeds, torques and powers of every case, the one first that speaks for the design.

    Args:
        design: With machines and cases.
        turning: Its graph with the teeth.
        efficiency: Stage -> efficiency of each of its meshes [-]; left out: lossless.

    Raises:
        DesignError: As `power_flow`.
        SolveError: As `power_flow`.
    """
    return {case: _flow(design, turning, case, efficiency or {}) for case in cases_of(design)}


def _flow(design: Design, turning: Turning, case: str, efficiency: Mapping[str, float]) -> PowerFlow:
    train, drives, said = turning.train, drives_of(design, case), case_named(design, case).machines
    joints = list(holding(design, train, case))
    while True:
        locked = turning.locked(joints)
        still = locked | left_alone(train, {name for name in drives if _may_drive(drives[name])}, joints)
        asked = _asked(design, turning, case, still)
        signed = {name: abs(speed) * turning.senses[train.machines[name]] for name, speed in asked.items()}
        turn = turning.turn(signed, joints)
        stated, balancing = _machine_torques(said, turning, turn, case=case, locked=locked, drives=drives)
        torques = balanced(design, train, turn, efficiency, stated, balancing=balancing, case=case)
        state = torques.found[0] if torques.found else torques.lossless
        slipping = [
            joint
            for k, joint in enumerate(joints)
            if overruns(joint, state.multipliers[len(train.meshes) + k], train, turn.speeds)
        ]
        if not slipping:
            break
        joints.remove(slipping[0])
    turn = replace(turn, yielded=_blamed(design, train, case, turn.yielded))
    found = [_collect(train, case, turn, state, joints) for state in torques.found]
    if len(found) == 1 and torques.complete:
        return found[0]
    lossless = _collect(train, case, turn, torques.lossless, joints)
    alike = [flow for flow in found if _gives_alike(flow, lossless)]
    if len(alike) == 1 and torques.complete:
        return alike[0]
    ways = efficiencies(design, train, turning.teeth, lossless, efficiency)
    raise jammed(train, lossless, found, ways, complete=torques.complete)


def _gives_alike(flow: PowerFlow, lossless: PowerFlow) -> bool:
    """Tell whether every machine gives or takes as it does without losses: so a train of several states is meant."""
    pairs = [(flow.machine_powers[machine], power) for machine, power in lossless.machine_powers.items()]
    return all(one * other >= 0.0 for one, other in pairs)


def _blamed(design: Design, train: Train, case: str, yielded: tuple[Yielded, ...]) -> tuple[Yielded, ...]:
    """Return the asked speeds that count in a case: rated ones are those of the gear of the first case."""
    if holding(design, train, case) == holding(design, train, cases_of(design)[0]):
        return yielded
    said = case_named(design, case).machines
    return tuple(speed for speed in yielded if speed.machine in said and said[speed.machine].speed is not None)


def _asked(design: Design, turning: Turning, case: str, still: frozenset[str]) -> Mapping[str, float]:
    """Return the asked speeds, zero for the machines that stand still unless the case gives them a speed."""
    said = case_named(design, case).machines
    stated = any(drive.speed is not None for drive in said.values())
    asked = asked_speeds(design, said) if stated else turning.asked
    standing = [name for name in still if name not in said or said[name].speed is None]
    return {**asked, **dict.fromkeys(standing, 0.0)}


def left_alone(train: Train, driving: Set[str], joints: Sequence[Joint]) -> frozenset[str]:
    """Return the machines on shafts that open clutches part from everything that may drive them.

    Args:
        train: The graph.
        driving: Machines that may drive: those that balance, and those that give power or torque.
        joints: The clutches that are engaged.
    """
    if len(joints) == len(train.joints):
        return frozenset()
    part = {node: node for node in (*train.nodes, GROUND)}

    def root(node: str) -> str:
        while part[node] != node:
            node = part[node]
        return node

    ends = [mesh.nodes for mesh in train.meshes] + [(joint.driving, joint.driven) for joint in joints]
    for nodes in ends:
        first, *others = (node for node in nodes if node != GROUND)
        for other in others:
            part[root(other)] = root(first)
    driven = {root(shaft) for name, shaft in train.machines.items() if name in driving}
    return frozenset(name for name, shaft in train.machines.items() if root(shaft) not in driven)


def _may_drive(drive: Drive) -> bool:
    return not drive.stated or (drive.power or 0.0) > 0.0 or (drive.torque or 0.0) > 0.0


def overruns(joint: Joint, multiplier: Values, train: Train, speeds: Floats) -> Values:
    """Tell whether an overrunning clutch has nothing to transmit, or would have to pull its driving shaft.

    Args:
        joint: The clutch.
        multiplier: That it carries, one or shape (n,) [N m].
        train: The graph.
        speeds: Of its nodes, shape (nodes,) [rad/s].
    """
    if not joint.overrunning:
        return False
    turning = 0.0 if joint.driven == GROUND else speeds[train.column[joint.driven]]
    return -multiplier * np.sign(turning or 1.0) <= 1e-9


def _machine_torques(
    said: Mapping[str, Drive],
    turning: Turning,
    turn: Turn,
    *,
    case: str,
    locked: frozenset[str],
    drives: Mapping[str, Drive],
) -> tuple[dict[str, float], list[str]]:
    """Return the torques that the case states, and the machines that balance the rest."""
    train = turning.train
    stated: dict[str, float] = {}
    balancing: list[str] = []
    problems: list[Problem] = []
    for name, shaft in train.machines.items():
        drive, speed = drives[name], float(turn.speeds[train.column[shaft]])
        if not drive.stated and name in locked and name not in said:
            stated[name] = 0.0  # a brake balances it
        elif not drive.stated:
            balancing.append(name)
        elif drive.torque is not None:
            stated[name] = drive.torque * (np.sign(speed) or turning.senses[shaft])
        elif not drive.power or (speed == 0.0 and name not in said and drive.power < 0.0):
            stated[name] = 0.0  # what takes power of its own takes none from a shaft that stands still
        elif speed == 0.0:
            message = f"{drive.power / 1e3:g} kW at standstill: its shaft {shaft!r} does not turn; give its torque"
            problems.append(Problem(f"cases.{case}.{name}", message))
        else:
            stated[name] = drive.power / speed
    refuse(problems)
    return stated, balancing


def _collect(train: Train, case: str, turn: Turn, state: Balanced, joints: list[Joint]) -> PowerFlow:
    torques, by_node, start = state.machine_torques, state.effective.tolist(), len(train.meshes)
    speed = dict(zip(train.nodes, _told_from_zero(turn.speeds.tolist()), strict=True))
    speed[GROUND] = 0.0
    carried = _told_from_zero(state.multipliers[:start].tolist()) + state.multipliers[start:].tolist()
    meshes = {mesh.name: _mesh_flow(train, mesh, speed, carried[k], by_node[k]) for k, mesh in enumerate(train.meshes)}
    return PowerFlow(
        case=case,
        speeds=speed,
        machine_torques=torques,
        machine_powers={name: torque * speed[train.machines[name]] for name, torque in torques.items()},
        meshes=meshes,
        joints={joint.name: -carried[start + k] for k, joint in enumerate(joints)},
        dampers={damper.name: dragged(train, damper, turn.speeds) for damper in train.dampers},
        yielded=turn.yielded,
    )


def _told_from_zero(values: list[float]) -> list[float]:
    """Return values of which those that are rounding beside the largest are zero: an idle mesh pushes neither way."""
    noise = STANDSTILL * max(map(abs, values), default=0.0)
    return [value if abs(value) > noise else 0.0 for value in values]


def _mesh_flow(
    train: Train, mesh: Mesh, speed: Mapping[str, float], multiplier: float, effective: list[float]
) -> MeshFlow:
    """Return what a row carries; a member on the ground takes what the other two leave."""
    torque = {node: multiplier * effective[train.column[node]] for node in mesh.nodes if node != GROUND}
    if len(torque) < len(mesh.nodes):
        torque[GROUND] = -sum(torque.values())
    first, second, third = mesh.nodes
    on_first, on_second = torque[first], torque[second]
    inward = -on_first * (speed[first] - speed[third])
    outward = on_second * (speed[second] - speed[third])
    return MeshFlow(mesh.name, multiplier, (on_first, on_second, torque[third]), inward, inward - outward)


# ----------------------------------------------------------------------------------------------------------------------
# The torques of many loads of a train that turns one way: one linear system a load, all solved together.
# ----------------------------------------------------------------------------------------------------------------------


_SLIGHT = 0.5
"""Losses whose row sums stay below this leave one state, as in `senses` [-]."""
_ROUNDS = 8
"""Rounds in which the sides that drive settle; two do."""


class Loads(NamedTuple):
    """What a train carries under many loads."""

    multipliers: Floats
    """Torque per tooth of every mesh row, then torque of every engaged clutch, shape (n, rows) [N m]."""
    first: Floats
    """Torque on gear a of every mesh row, all equal meshes together, shape (n, meshes) [N m]."""
    second: Floats
    """Torque on gear b, likewise [N m]."""
    third: Floats
    """Torque on the carrier, likewise [N m]."""
    balancing: Floats
    """Torque of the machine that balances, shape (n,) [N m]."""


def can_be_along(turn: Turn, balancing: int) -> bool:
    """Tell whether `along` solves a train: equilibrium has one solution for every load.

    Args:
        turn: How it turns.
        balancing: Node of the machine that balances.
    """
    known = turn.balance((balancing,))
    rows, columns = known.system.shape
    return rows == columns and not undecided(known, len(turn.matrix)).any()


def is_slight(turn: Turn, balancing: int, part: Floats) -> Bools:
    """Tell under which loads losses are so slight that there is one state, shape (n,).

    Args:
        turn: How the train turns.
        balancing: Node of the machine that balances.
        part: Part 1 − η that each mesh row loses under each load, shape (n, meshes) [-].
    """
    equations = turn.lossy((balancing,))
    felt = np.maximum(np.abs(equations.felt.positive), np.abs(equations.felt.negative)).sum(axis=1)
    return np.asarray(part.max(axis=1, initial=0.0) * felt.max(initial=0.0) < _SLIGHT)


def along(turn: Turn, balancing: int, part: Floats, applied: Floats) -> Loads | None:
    """Return the torques under many loads; None where the sides that drive do not settle.

    Args:
        turn: How the train turns; the sense is the same for all loads.
        balancing: Node of the machine that balances.
        part: Part 1 − η that each mesh row loses under each load, shape (n, meshes) [-], slight (`is_slight`);
            clutches lose nothing.
        applied: Torques that are given on the nodes, shape (n, nodes) [N m].

    Source: `power_flow`: T + Aᵀ λ = 0 with losses in the direction of the power.
    """
    known, equations = turn.balance((balancing,)), turn.lossy((balancing,))
    rows, nodes = known.matrix.shape
    if part.shape[1] < rows:
        part = np.concatenate([part, np.zeros((len(part), rows - part.shape[1]))], axis=1)
    asked = np.concatenate([applied, np.zeros((len(applied), len(known.completion)))], axis=1)
    x = -np.einsum("ij,lj->li", known.inverse, asked)
    before: Bools = x[:, :rows] < 0.0
    system = np.broadcast_to(known.scaled, (len(applied), *known.scaled.shape)).copy()
    for _ in range(_ROUNDS):
        alike = before[:1] if (before == before[0]).all() else before  # few trains have loads of both senses
        change = np.where(alike[:, :, None], equations.change.negative, equations.change.positive)
        effective = known.matrix + part[:, :, None] * change
        system[:, :nodes, :rows] = effective.transpose(0, 2, 1) / known.scale[:rows]
        x = np.linalg.solve(system, -asked[:, :, None])[:, :, 0]
        noise = STANDSTILL * np.abs(x).max(axis=1, keepdims=True)
        negative: Bools = np.where(np.abs(x[:, :rows]) <= noise, before, x[:, :rows] < 0.0)
        if np.array_equal(negative, before):
            break
        before = negative
    else:
        return None
    return _collected(turn, x / known.scale, effective)


def _collected(turn: Turn, solution: Floats, effective: Floats) -> Loads:
    train, rows = turn.train, effective.shape[1]
    meshes = len(train.meshes)
    noise = STANDSTILL * np.abs(solution[:, :meshes]).max(axis=1, keepdims=True)
    multipliers = solution[:, :rows].copy()
    multipliers[:, :meshes] = np.where(np.abs(solution[:, :meshes]) > noise, solution[:, :meshes], 0.0)
    torques = np.zeros((3, len(solution), meshes))
    for k, mesh in enumerate(train.meshes):
        for place, node in enumerate(mesh.nodes):
            if node != GROUND:
                torques[place, :, k] = multipliers[:, k] * effective[:, k, train.column[node]]
        for place, node in enumerate(mesh.nodes):
            if node == GROUND:
                torques[place, :, k] = -torques[:, :, k].sum(axis=0)
    return Loads(multipliers, torques[0], torques[1], torques[2], solution[:, rows])
