"""Temperatures of oil, gears, bearings and housing in flight, and minutes without oil."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem
from gearwright.machines.power import Network, Warmed, warmed
from gearwright.ranking import smallest
from gearwright.spec import OilNetworkRules
from gearwright.units import CELSIUS

OIL, GEARS, BEARINGS, HOUSING = range(4)
"""Bodies of the network."""
_STEP = 10.0
"""Longest step of running dry [s]."""
_LONGEST = 6.0 * 3600.0
"""Running dry that is looked at [s]."""


class GearHeat(NamedTuple):
    """What heats a gearbox."""

    meshes: float
    """[W]"""
    bearings: float
    """And seals [W]."""
    windage: float
    """[W]"""
    churning: float
    """[W]"""


class Warm(NamedTuple):
    """Temperatures in a gearbox."""

    oil: float
    """[K]"""
    gears: float
    """[K]"""
    bearings: float
    """[K]"""
    housing: float
    """[K]"""


class DryRun(NamedTuple):
    """A gearbox that has lost its oil."""

    lasts: float
    """Until the first limit [s]; infinite where none is reached within six hours."""
    part: str
    """What reaches its limit first; empty: nothing."""
    gears: float
    """Temperature at the end [K]."""
    bearings: float
    """Temperature at the end [K]."""


def oil_start(rules: OilNetworkRules, inlet: float) -> Warm:
    """Return the temperatures with which a gearbox starts.

    Args:
        rules: Of the mission.
        inlet: Temperature of the oil that the mission states [K].
    """
    return Warm(*[rules.start_temperature_k or inlet] * 4)


def _network(rules: OilNetworkRules, gear_mass: float, opened: float, *, wet: bool) -> Network:
    """Return the network with its cooler's valve opened by a part."""
    steel = rules.steel_heat_j_kg_k
    capacity = np.array(
        [
            rules.oil_mass * rules.oil_heat_j_kg_k,
            gear_mass * steel,
            rules.bearing_mass * steel,
            rules.housing_mass * rules.housing_heat_j_kg_k,
        ]
    )
    links = np.zeros((4, 4))
    if wet:
        links[OIL, [GEARS, BEARINGS, HOUSING]] = (
            rules.gears_to_oil_w_k, rules.bearings_to_oil_w_k, rules.oil_to_housing_w_k,
        )  # fmt: skip
    links[GEARS, HOUSING], links[BEARINGS, HOUSING] = rules.gears_to_housing_w_k, rules.bearings_to_housing_w_k
    outside = np.array([[rules.cooler_w_k * opened if wet else 0.0], [0.0], [0.0], [rules.housing_to_air_w_k]])
    return Network(capacity, links + links.T, outside)


def _asked(rules: OilNetworkRules, oil: float) -> float:
    """Return the part to which oil of a temperature [K] opens the cooler's valve."""
    return min(max((oil - rules.cooler_opens_k) / rules.cooler_range_k, 0.0), 1.0)


def _heat(rules: OilNetworkRules, heat: GearHeat, *, wet: bool) -> Floats:
    share, more = (rules.oil_share, 1.0) if wet else (0.0, rules.dry_friction)
    meshes, bearings = more * heat.meshes, more * heat.bearings
    return np.array(
        [
            share * (meshes + bearings) + (heat.churning if wet else 0.0),
            (1.0 - share) * meshes + heat.windage,
            (1.0 - share) * bearings,
            0.0,
        ]
    )


def oil_step(
    rules: OilNetworkRules, gear_mass: float, warm: Warm, *, heat: GearHeat, air: float, duration: float
) -> tuple[Warm, Warmed]:
    """Return the temperatures of a gearbox after an interval, and what its network stored and rejected.

    Args:
        rules: Of the mission.
        gear_mass: Of gears and shafts [kg].
        warm: Temperatures at the start.
        heat: What heats it.
        air: Temperature of the air [K].
        duration: [s].

    Raises:
        DesignError: Oil, gears or bearings become too warm.

    Source: the cooler's valve stands as the oil at the interval's end asks, so that no interval is too long for it.
    """
    from scipy.optimize import brentq  # a third of the time that flights take to load

    hot, around = _heat(rules, heat, wet=True), np.array([air])

    def by(opened: float) -> Warmed:
        network = _network(rules, gear_mass, opened, wet=True)
        return warmed(network, np.array(warm), hot, surroundings=around, duration=duration)

    def left(opened: float) -> float:
        return _asked(rules, float(by(opened).temperature[OIL])) - opened

    opened = 0.0 if left(0.0) <= 0.0 else 1.0 if left(1.0) >= 0.0 else float(brentq(left, 0.0, 1.0, xtol=1e-10))
    after = by(opened)
    end = Warm(*after.temperature.tolist())
    for part in ("oil", "gears", "bearings"):
        limit, found = getattr(rules, f"highest_{part}_k"), getattr(end, part)
        if found > limit * (1.0 + 1e-12):
            said = f"{part} reach {found - CELSIUS:.1f} °C in air of {air - CELSIUS:.1f} °C, the highest is"
            fix = "give a larger cooler_w_k or gears_to_oil_w_k, ask for less power, or raise the limit"
            raise DesignError([Problem(f"oil.network.highest_{part}_k", f"{said} {limit - CELSIUS:.1f} °C; {fix}")])
    return end, after


def dry_run(rules: OilNetworkRules, gear_mass: float, warm: Warm, *, heat: GearHeat, air: float) -> DryRun:
    """Return how long a gearbox runs without oil until gears or bearings reach their limit.

    Args:
        rules: Of the mission.
        gear_mass: Of gears and shafts [kg].
        warm: Temperatures when the oil is lost.
        heat: What heated it with oil; meshes and bearings then lose `dry_friction` times as much.
        air: Temperature of the air [K].

    Source: the network without oil; the step in which the limit is passed is cut at a straight line.

    Valid for: a stated limit and a stated friction; real gearboxes end by softening, lost clearances and cages.
    """
    network, hot = _network(rules, gear_mass, 0.0, wet=False), _heat(rules, heat, wet=False)
    limits = {"gears": rules.highest_gears_k, "bearings": rules.highest_bearings_k}
    now, clock = warm, 0.0
    while clock < _LONGEST:
        after = warmed(network, np.array(now), hot, surroundings=np.array([air]), duration=_STEP)
        end = Warm(*after.temperature.tolist())
        cuts = {
            part: (limit - getattr(now, part)) / (getattr(end, part) - getattr(now, part))
            for part, limit in limits.items()
            if getattr(end, part) > limit
        }
        if cuts:
            part = smallest(cuts, cuts.__getitem__)
            cut = max(cuts[part], 0.0)
            at = [a + cut * (b - a) for a, b in zip(now, end, strict=True)]
            return DryRun(clock + cut * _STEP, part, at[GEARS], at[BEARINGS])
        now, clock = end, clock + _STEP
    return DryRun(float("inf"), "", now.gears, now.bearings)
