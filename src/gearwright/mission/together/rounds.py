"""Rounds over all intervals at once, in which loads and what teeth lose under the loads of the one before agree."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.mission.gearbox import Drag, Point
from gearwright.mission.loading import TRIAL_POWER
from gearwright.mission.together.gearbox import (
    Box,
    Idle,
    balanced,
    drag_of,
    idle_of,
    machine_powers,
    mesh_loss_of,
    point_of,
    stage_losses,
)
from gearwright.mission.together.runs import runs_of, spread
from gearwright.train import Loads

_SETTLED = 1e-13
"""Change of a part that is lost below which rounds have settled [-]."""
ROUNDS = 5
"""Every one leaves some 0.002 of the error of the one before, which begins with all losses, about 0.01."""


class Asked(NamedTuple):
    """What intervals ask of the gearbox; arrays have a first axis of n."""

    first: Bools
    """Where a flight begins."""
    again: Bools
    """Where a phase begins: losses are found twice."""
    wanted: Floats
    """Power of the propeller's shaft; NaN: of the machines [W]."""
    given: Floats
    """Power of the machines [W]."""
    speed: Floats
    """Of the propeller [rad/s]."""
    spin_up: Floats
    dragged: Floats
    """By shafts that turn motors without current [W]."""
    parts: Floats
    """Of the machines, in the order of a point's powers, shape (n, machines) [-]."""

    def at(self, lanes: Any) -> Asked:
        """Return what some intervals ask.

        Args:
            lanes: Which.
        """
        return Asked(*(column[lanes] for column in self))


class Balanced(NamedTuple):
    """A gearbox in balance."""

    point: Point
    friction: Drag
    short: Bools
    """Where the machines' power only spins the train up."""
    lost: Floats
    """Part that teeth of each stage lose, shape (n, stages) [-]."""
    change: Floats
    """Of that part in the last round, shape (n,) [-]."""

    @property
    def settled(self) -> Bools:
        """Where another round would change nothing."""
        return np.asarray(self.change <= _SETTLED)


def balanced_rounds(box: Box, asked: Asked, lost: Floats | None = None) -> Balanced | None:
    """Return the gearbox in balance after a few rounds; None where it loses too much to be solved so.

    Args:
        box: The gearbox.
        asked: Of it.
        lost: Part that teeth of each stage are thought to lose, shape (n, stages) [-]: the result of the round before,
            for one more; left out: nothing is known, and there are as many rounds as it takes.

    Source: the losses of an interval are those of the loads of the one before; where a phase starts they are found
        twice. Rounds over all intervals end where nothing changes, which is where one after the other leads. Of
        intervals that ask what the one before asks, as many are computed as there are rounds.
    """
    if lost is not None:
        return _rounds(box, asked, lost, 1)
    kept, source = runs_of((*asked[2:-1], *asked.parts.T.copy()), asked.first | asked.again, ROUNDS)
    found: Balanced | None = spread(_rounds(box, asked.at(kept), no_losses(box, len(kept)), ROUNDS), source)
    return found


def given_powers(machines: Sequence[str], asked: Asked, found: Balanced) -> dict[str, Floats]:
    """Return machine -> power into the train, with drag and spin-up, shape (n,) [W].

    Args:
        machines: Without the propeller, in the order of a point's powers.
        asked: Of the gearbox.
        found: What it carries.
    """
    carried, point = sum(found.friction) + asked.dragged + asked.spin_up, found.point
    return {name: point.machine_powers[:, k] + asked.parts[:, k] * carried for k, name in enumerate(machines)}


def no_losses(box: Box, count: int) -> Floats:
    """Return losses that are none, shape (n, stages) [-].

    Args:
        box: The gearbox.
        count: Intervals [-].
    """
    return np.zeros((count, len(box.stages)))


def _rounds(box: Box, asked: Asked, lost: Floats, count: int) -> Balanced | None:
    idle, first, again = idle_of(box, asked.speed), asked.first[:, None], np.flatnonzero(asked.again | asked.first)
    starting, idle_starts = asked.at(again), Idle(*(column[again] for column in idle))
    met: _Met | None = None
    change = lost[:, 0]
    for _ in range(count):  # always as many: a flight is the same whatever others it is found with
        met = _met(box, asked, idle, np.where(first, 0.0, np.roll(lost, 1, axis=0)))
        if met is None:
            return None
        twice = _met(box, starting, idle_starts, _losses(box, met.loads.first[again], starting.speed))
        if twice is None:
            return None
        _replace(met, twice, again)
        anew = _losses(box, met.loads.first, asked.speed)
        change, lost = np.abs(anew - lost).max(axis=1), anew
    assert met is not None  # there are rounds
    point = point_of(box, met.loads, met.speeds, met.powers)
    friction = drag_of(box, point.mesh_torques, asked.speed, idle)
    return Balanced(point, friction, met.short, lost, change)


class _Met(NamedTuple):
    """Loads in balance."""

    loads: Loads
    speeds: Floats
    powers: Floats
    short: Bools
    """Where power only spins the train up."""


def _replace(met: _Met, other: _Met, places: Any) -> None:
    """Put loads in the place of others."""
    for column, values in zip((*met.loads, *met[1:]), (*other.loads, *other[1:]), strict=True):
        column[places] = values


def _met(box: Box, asked: Asked, idle: Idle, lost: Floats) -> _Met | None:
    """Return the loads under which propeller or machines have their power."""
    wanted, given = asked.wanted, asked.given
    trial = np.where(wanted < 0.0, -TRIAL_POWER, TRIAL_POWER)
    powers = machine_powers(box, asked.parts, trial)
    found = balanced(box, powers, asked.speed, lost)
    if found is None:
        return None
    loads, speeds = found
    work = powers.sum(axis=1) - mesh_loss_of(box, loads, speeds).sum(axis=1)
    by_work = ~np.isnan(wanted)
    factor = np.where(by_work, wanted / np.where(work == 0.0, 1.0, work), 0.0)
    short = np.zeros(len(wanted), bool)
    if not by_work.all():
        full = given / TRIAL_POWER
        torques = np.where(by_work, 0.0, full)[:, None] * loads.first / _counts(box)
        left = given - asked.spin_up - sum(drag_of(box, torques, asked.speed, idle)) - asked.dragged
        short = ~by_work & (left <= 0.0)
        factor = np.where(by_work, factor, left / TRIAL_POWER)
    scaled = Loads(*(column * (factor[:, None] if column.ndim == 2 else factor) for column in loads))
    return _Met(scaled, speeds, powers * factor[:, None], short)


def _counts(box: Box) -> Floats:
    return np.array([float(row.count) for row in box.gearbox.sizing.train.meshes])


def _losses(box: Box, torques: Floats, speed: Floats) -> Floats:
    """Return what the teeth of each stage lose under the torques of all equal meshes [-]."""
    return stage_losses(box, torques / _counts(box), speed)
