"""A life of several missions: how often each is flown, and when the first part fails."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from gearwright.errors import Problem, refuse
from gearwright.mission.lives.verdict import Durability, PartLife
from gearwright.ranking import largest_first
from gearwright.units import Ratio
from gearwright.verbs import verb

_WHOLE = 1e-9
"""By how much shares may miss 1: rounding [-]."""


@dataclass(frozen=True)
class MixedLife:
    """What a mix of missions does to the parts that are rated in all of them."""

    parts: tuple[PartLife, ...]
    """Of a mean flight, the one that governs first."""
    hours: float
    """Of a mean flight [h]."""
    unrated: tuple[str, ...]
    """Parts that some missions rate and others do not: with ways to fail, and where they are missing."""

    def damage_after(self, flights: float) -> Ratio:
        """Return the largest Miner's sum of any part after a number of flights [-]; it fails at 1.

        Args:
            flights: Of the mix [-].
        """
        return max((part.damage for part in self.parts), default=0.0) * flights


@verb
def mixed_life(lives: Mapping[str, Durability], shares: Mapping[str, float]) -> MixedLife:
    """Return the lives of parts over a mix of missions.

    Args:
        lives: Mission -> what one flight of it does, from `durability`, of one and the same design.
        shares: Mission -> part of all flights that are of this kind, with sum 1 [-].

    Source: Palmgren 1924, Miner 1945: Σ n/N over all flights, whatever their order.

    Raises:
        DesignError: Shares that are negative, do not add up to 1 or name other missions; a seat whose bearing differs.
    """
    refuse(_problems(lives, shares), "mix")
    sums: dict[tuple[str, str], dict[str, float]] = {}
    for mission, lived in lives.items():
        for part in lived.parts:
            sums.setdefault((part.part, part.mode), {})[mission] = part.damage
    hours = sum(shares[mission] * _hours(lived) for mission, lived in lives.items())
    whole = {key: found for key, found in sums.items() if len(found) == len(lives)}
    rows = []
    for (name, mode), found in whole.items():
        damage = sum(shares[mission] * value for mission, value in found.items() if shares[mission])
        flights = 1.0 / damage if damage > 0.0 else math.inf
        rows.append(PartLife(name, mode, damage, flights, flights * hours))
    left = [
        f"{name}, {mode}: not rated in {', '.join(mission for mission in lives if mission not in found)}"
        for (name, mode), found in sums.items()
        if len(found) < len(lives)
    ]
    return MixedLife(tuple(largest_first(rows, lambda row: row.damage)), hours, tuple(left))


def _hours(lived: Durability) -> float:
    """Return how long a flight lasts [h]."""
    hours = [row.hours for row in lived.gears] + [row.hours for row in lived.bearings.rows]
    return hours[0] if hours else 0.0


def _problems(lives: Mapping[str, Durability], shares: Mapping[str, float]) -> list[Problem]:
    problems = [
        Problem(name, "has a share and is not flown; leave it out, or fly it") for name in shares.keys() - lives
    ]
    problems += [Problem(name, "is flown and has no share; give it one") for name in lives if name not in shares]
    problems += [
        Problem(name, f"{share:g}; a share is a part of all flights, from 0 to 1")
        for name, share in shares.items()
        if not 0.0 <= share <= 1.0
    ]
    total = sum(shares.values())
    if not problems and abs(total - 1.0) > _WHOLE:
        problems.append(Problem("shares", f"{total:g}; they have to add up to 1"))
    chosen: dict[str, set[str]] = {}
    for lived in lives.values():
        for row in lived.bearings.rows:
            chosen.setdefault(row.seat, set()).add(row.bearing.designation)
    problems += [
        Problem(seat, f"{' or '.join(sorted(names))}: missions choose other bearings; name one in the design")
        for seat, names in chosen.items()
        if len(names) > 1
    ]
    return problems
