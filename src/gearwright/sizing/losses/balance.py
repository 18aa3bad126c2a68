"""Where the power of a case goes: a row for every mesh, bearing, gear and seal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import by_name
from gearwright.ranking import largest_first
from gearwright.showing import Shown
from gearwright.sizing.bearings import bearing_seats
from gearwright.sizing.losses.bodies import gear_losses, seal_losses
from gearwright.sizing.losses.oil import Oil, oil_of_design
from gearwright.sizing.losses.seats import bearing_losses
from gearwright.sizing.losses.teeth import mesh_loss_limits, mesh_loss_parts, teeth_of
from gearwright.sizing.result import Sizing
from gearwright.spec import GROUND, case_named
from gearwright.train import PowerFlow
from gearwright.units import Number, Origin, Power, Quantity, Ratio
from gearwright.verbs import verb

ORIGINS = ("meshes", "bearings", "windage", "churning", "seals")
"""Where power is lost, in the order of tables."""
_SOURCE = "[losses] of the design"


@dataclass(frozen=True)
class Loss:
    """What one part of the gearbox loses in a case."""

    case: str
    origin: str
    """meshes, bearings, windage, churning or seals."""
    part: str
    count: Number
    """Equal parts [-]."""
    power: Annotated[float, Quantity("power"), Origin("P_V", _SOURCE)]
    """Of all of them [W]."""
    share: Annotated[float, Quantity("percent"), Origin("P_V/P_in", _SOURCE)]
    """Of the power into the gearbox [-]."""
    method: str
    """Whose formula."""
    limit: str
    """Limits of the formula at which it is taken; empty where it holds."""


@dataclass(frozen=True, repr=False)
class LossBalance(Shown):
    """Where the power of a case goes."""

    case: str
    power: Power
    """Into the gearbox [W]."""
    losses: tuple[Loss, ...]
    """By origin, the largest of each first."""

    @property
    def lost(self) -> Power:
        """By all parts [W]."""
        return sum(loss.power for loss in self.losses)

    @property
    def efficiency(self) -> Annotated[Ratio, Origin("η = 1 − Σ P_V/P_in", _SOURCE)]:
        """Power out over power in [-]; 1 where none goes in."""
        return 1.0 - self.lost / self.power if self.power else 1.0

    def by_origin(self) -> dict[str, float]:
        """Return origin -> power that is lost there [W]."""
        return {
            origin: sum(loss.power for loss in self.losses if loss.origin == origin)
            for origin in ORIGINS
            if any(loss.origin == origin for loss in self.losses)
        }


@verb
def loss_balance(sizing: Sizing, case: str | None = None) -> LossBalance:
    """Return where the power of a case goes, by the formulas of the design's [losses] and with its [oil].

    Args:
        sizing: As sized.
        case: One of its cases; left out: the one that speaks for the design.

    Raises:
        DesignError: There is no such case, or a gear dips that there is not.

    Source: `mesh_loss_parts`, `bearing_losses`, `gear_losses`, `seal_losses`.
    """
    asked = _asked(sizing, case)
    losses = list(_losses(sizing, asked))
    return LossBalance(
        asked.name,
        asked.given,
        tuple(sorted(largest_first(losses, lambda loss: loss.power), key=lambda loss: ORIGINS.index(loss.origin))),
    )


def lost_power(sizing: Sizing) -> float:
    """Return what all parts lose in the case that speaks for the design [W]: the sum of `loss_balance`.

    Args:
        sizing: As sized.
    """
    return sum(loss.power for loss in _losses(sizing, _asked(sizing, None)))


def largest_heat(sizing: Sizing) -> float:
    """Return the most that all parts lose in a case that lasts [W]: what the oil carries away.

    Args:
        sizing: As sized.
    """
    lasting = [case for case in sizing.flows if not case_named(sizing.design, case).static]
    return max(sum(loss.power for loss in _losses(sizing, _asked(sizing, case))) for case in lasting)


def _asked(sizing: Sizing, case: str | None) -> _Case:
    """Return a case, or the one that speaks for the design."""
    flow = sizing.reference if case is None else by_name(case, sizing.flows, "case")
    given = sum(power for power in flow.machine_powers.values() if power > 0.0)
    return _Case(flow.case, given, {**flow.speeds, GROUND: 0.0}, _torques(sizing, flow), oil_of_design(sizing))


def _losses(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    """Yield the loss of every part, in the order of the design."""
    yield from _meshes(sizing, case)
    yield from _bearings(sizing, case)
    yield from _bodies(sizing, case)


class _Case(NamedTuple):
    """What turns and what is borne in a case."""

    name: str
    given: float
    speeds: Mapping[str, float]
    torques: Floats
    oil: Oil

    def loss(self, origin: str, part: str, *, count: int, power: float, method: str, limit: str) -> Loss:
        share = power / self.given if self.given else 0.0
        return Loss(self.name, origin, part, count, power, share, method, limit)


def _torques(sizing: Sizing, flow: PowerFlow) -> Floats:
    """Return the torque on gear a of one single mesh of each row [N m]."""
    return np.array([flow.meshes[mesh.name].torques[0] / mesh.count for mesh in sizing.train.meshes])


def _meshes(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    teeth, method = teeth_of(sizing), case.oil.friction.value
    parts = mesh_loss_parts(sizing, teeth, case.torques, speeds=case.speeds, oil=case.oil)
    limits = mesh_loss_limits(sizing, teeth, case.torques, speeds=case.speeds, oil=case.oil)
    for torque, mesh in zip(case.torques.tolist(), sizing.train.meshes, strict=True):
        rolling = abs(torque * (case.speeds[mesh.nodes[0]] - case.speeds[mesh.nodes[2]]))
        power = mesh.count * parts[mesh.name] * rolling
        limit = limits[mesh.name]
        yield case.loss("meshes", mesh.name, count=mesh.count, power=power, method=method, limit=limit)


def _bearings(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    for seat in bearing_losses(sizing, bearing_seats(sizing), case.torques, speeds=case.speeds, oil=case.oil):
        yield case.loss("bearings", seat.seat, count=seat.count, power=seat.power, method=seat.method, limit=seat.limit)


def _bodies(sizing: Sizing, case: _Case) -> Iterator[Loss]:
    methods = {"windage": case.oil.windage, "churning": "iso-tr-14179-1", "seals": case.oil.seals}
    for body in (*gear_losses(sizing, case.speeds, case.oil), *seal_losses(sizing, case.speeds, case.oil)):
        method = methods[body.origin]
        yield case.loss(body.origin, body.part, count=body.count, power=body.power, method=method, limit=body.limit)
