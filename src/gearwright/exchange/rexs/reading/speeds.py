"""Speeds of a read train: what a file states of some shafts, led on through its teeth to all others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from gearwright.spec import GROUND

Relation = tuple[tuple[str, float], ...]
"""Speeds that add up to zero: shaft and factor [-]."""


def led_on(pairs: Mapping[str, Mapping[str, Any]], sets: Mapping[str, Mapping[str, Any]],
           known: Mapping[str, float], owners: Mapping[str, str]) -> dict[str, float]:  # fmt: skip
    """Return the speeds of all shafts that follow from those of some [rad/s].

    Args:
        pairs: Tables of pairs.
        sets: Tables of planetary sets.
        known: Shaft -> its speed [rad/s].
        owners: Shared gear, such as ``first.wheel`` -> its shaft.

    Source: z_1 ω_1 ∓ z_2 ω_2 = 0; z_s ω_s + z_r ω_r = (z_s + z_r) ω_c (Willis).
    """
    speeds = {GROUND: 0.0, **known}
    relations = [*_of_pairs(pairs, owners), *_of_sets(sets)]
    grown = True
    while grown:
        grown = False
        for relation in relations:
            unknown = {shaft for shaft, _ in relation if shaft not in speeds}
            if len(unknown) == 1:
                (shaft,) = unknown
                rest = sum(factor * speeds[name] for name, factor in relation if name != shaft)
                own = sum(factor for name, factor in relation if name == shaft)
                if own:  # else its gears mesh with each other, of which the design will be refused
                    speeds[shaft] = -rest / own
                    grown = True
    return speeds


def _of_pairs(pairs: Mapping[str, Mapping[str, Any]], owners: Mapping[str, str]) -> Iterator[Relation]:
    for pair in pairs.values():
        sign = -1.0 if pair.get("internal") else 1.0
        pinion, wheel = (owners.get(pair[role], pair[role]) for role in ("pinion", "wheel"))
        yield (pinion, float(pair["pinion_teeth"])), (wheel, sign * pair["wheel_teeth"])


def _of_sets(sets: Mapping[str, Mapping[str, Any]]) -> Iterator[Relation]:
    for members in sets.values():
        sun, ring = float(members["sun_teeth"]), float(members["ring_teeth"])
        yield (members["sun"], sun), (members["ring"], ring), (members["carrier"], -sun - ring)
