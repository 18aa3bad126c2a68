"""Strategies in many intervals at once: the share that a rule gives, and what machines then give."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.errors import DesignError, Problem
from gearwright.lanes import rebound
from gearwright.machines import motor_loss
from gearwright.mission.moments import Stretch
from gearwright.mission.plant import PackState
from gearwright.mission.strategies import AGREED, Demand, driven, electric_share, rules
from gearwright.mission.supply import Supply
from gearwright.spec import StrategyRules

_RULES = rebound(rules)
_CHARGE = "charge"
"""The rule whose share follows from the battery."""


class Strategies(NamedTuple):
    """Which intervals follow which rules."""

    rows: tuple[tuple[StrategyRules, Ints], ...]
    """Rules, and the intervals that follow them."""
    follows: Bools
    """Where there is a rule, shape (n,)."""
    weights: Mapping[str, Floats]
    """Machine -> part of what turbines, or motors, give together, shape (n,) [-]."""
    working: Mapping[str, Bools]
    """Turbine -> where it is not out, shape (n,)."""
    charging: Mapping[int, StrategyRules]
    """Interval -> its rule, of those that look at the battery."""

    def begun(self) -> Floats:
        """Return shares to begin with, shape (n,) [-]."""
        share = np.zeros(len(self.follows))
        for rule, rows in self.rows:
            share[rows] = 1.0 if rule.rule == "electric-taxi" else 0.0
        return share

    def parts(self, deck_parts: Mapping[str, Floats], share: Floats) -> dict[str, Floats]:
        """Return machine -> part of the power of all machines, shape (n,) [-].

        Args:
            deck_parts: Those where there is no strategy.
            share: Of the motors, shape (n,) [-].
        """
        turbines = self.working.keys()
        return {
            name: np.where(self.follows, (1.0 - share if name in turbines else share) * self.weights[name], part)
            for name, part in deck_parts.items()
        }

    def shares(self, demand: Demand) -> Floats:
        """Return motors' part of the machines' power, shape (n,) [-]; 0 where it follows from the battery.

        Args:
            demand: Fields of shape (n,).

        Source: `electric_share`.
        """
        share, columns = np.zeros(len(self.follows)), [np.asarray(column) for column in demand]
        for rule, rows in self.rows:
            if rule.rule != _CHARGE:
                some: Any = [column[rows] for column in columns]
                share[rows] = _RULES.electric_share(rule, Demand(*some), None, 0.0)
        return np.where(np.abs(share) <= AGREED, 0.0, share)

    def charged(self, supply: Supply, demand: Demand, state: PackState, at: Charging) -> None:
        """Set the shares of a flight that follow from its battery, interval after interval.

        Args:
            supply: With battery and motors.
            demand: Fields of shape (n,); its charge is not looked at.
            state: Of the battery at the start of the flight.
            at: The flight; its shares are written.
        """
        pack, share = supply.pack, at.share
        assert pack is not None  # the caller
        columns = [np.asarray(column) for column in (demand.power, demand.available, demand.duration, at.bus, at.air)]
        rows = zip(*(column[at.lanes].tolist() for column in columns), strict=True)
        for k, (power, available, duration, bus, air) in enumerate(rows, start=at.lanes.start):
            if k in self.charging:
                wanted = Demand(power, available, state.charge, duration)
                found = electric_share(self.charging[k], wanted, supply.battery, 0.0)
                share[k] = found if abs(found) > AGREED else 0.0
                bus = sum(self._bus(supply, name, k, power * share[k], at.speeds[name][k]) for name in supply.motors)
            try:
                state = pack.drawn(state, float(bus), duration, air)[1]
            except DesignError:  # cells that are too warm: the flight says so
                return

    def _bus(self, supply: Supply, name: str, k: int, power: float, speed: float) -> float:
        given = power * float(self.weights[name][k])
        return given + motor_loss(supply.motors[name], given / speed, speed) if given else 0.0


class Charging(NamedTuple):
    """A flight whose battery is followed."""

    lanes: slice
    """Its intervals."""
    bus: Floats
    """Power at the bus, shape (n,) [W]; where shares follow from the battery it is found anew."""
    air: Floats
    """Temperature, shape (n,) [K]."""
    speeds: Mapping[str, Floats]
    """Machine -> speed without sign, shape (n,) [rad/s]."""
    share: Floats
    """Motors' part, shape (n,) [-]."""


def strategies_of(supply: Supply, stretches: Sequence[Stretch], counts: Sequence[int]) -> Strategies | None:
    """Return the strategies of all intervals; None where no phase has one.

    Args:
        supply: The machines.
        stretches: The phases of all flights.
        counts: Intervals of each.

    Raises:
        DesignError: A rule needs a machine that there is not, or that is out.
    """
    known: list[tuple[StrategyRules, list[int]]] = []
    for k, stretch in enumerate(stretches):
        if stretch.phase.strategy is None:
            continue
        rule = stretch.mission.strategies[stretch.phase.strategy]
        same = next((places for other, places in known if other is rule or other == rule), None)
        if same is None:
            known.append((rule, [k]))
        else:
            same.append(k)
    if not known:
        return None
    whose = np.repeat(np.arange(len(stretches)), counts)
    followed = tuple((rule, np.flatnonzero(np.isin(whose, places))) for rule, places in known)
    weights = [_weights(supply, stretch) for stretch in stretches]
    names = (*supply.engines, *supply.motors)
    return Strategies(
        followed,
        np.array([stretch.phase.strategy is not None for stretch in stretches])[whose],
        {name: np.array([of.get(name, 0.0) for of in weights])[whose] for name in names},
        {name: np.array([name not in one.phase.inoperative for one in stretches])[whose] for name in supply.engines},
        {k: rule for rule, rows in followed if rule.rule == _CHARGE for k in rows.tolist()},
    )


def _weights(supply: Supply, stretch: Stretch) -> dict[str, float]:
    phase = stretch.phase
    if phase.strategy is None:
        return {}
    if not supply.motors and stretch.mission.strategies[phase.strategy].rule != "turbine-alone":
        raise DesignError([Problem("strategy", "needs a motor")])  # one by one it is told in more words
    share = 0.5 if supply.motors else 0.0
    return {name: part / (1.0 - share) for name, part in supply.parts(driven(phase, share)).items()}
