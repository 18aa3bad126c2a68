"""Speeds of a read train: what a file states of some shafts, led on through its teeth to all others."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from gearwright.exchange.rexs.reading.gearing import Gearing
from gearwright.spec import GROUND

Relation = tuple[tuple[str, float], ...]
"""Speeds that add up to zero: shaft and factor [-]."""


def led_on(gearing: Gearing, known: Mapping[str, float], held: Iterable[str] = ()) -> dict[str, float]:
    """Return the speeds of all shafts that follow from those of some [rad/s].

    Args:
        gearing: Pairs, sets and clutches.
        known: Shaft -> its speed [rad/s].
        held: Clutches that hold.

    Source: z_1 ω_1 ∓ z_2 ω_2 = 0; z_s ω_s + z_r ω_r = (z_s + z_r) ω_c (Willis).
    """
    speeds = {GROUND: 0.0, **known}
    relations = _relations(gearing, held)
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


def free_speeds(gearing: Gearing, held: Iterable[str] = ()) -> int:
    """Return how many speeds of a train are free, and so how many torques of its machines follow from all others [-].

    Args:
        gearing: Pairs, sets and clutches.
        held: Clutches that hold.
    """
    places = {shaft: place for place, shaft in enumerate(gearing.shafts)}
    relations = _relations(gearing, held)
    matrix = np.zeros((len(relations), len(places)))
    for row, relation in zip(matrix, relations, strict=True):
        for shaft, factor in relation:
            if shaft in places:
                row[places[shaft]] += factor
    return len(places) - (int(np.linalg.matrix_rank(matrix)) if relations else 0)


def _relations(gearing: Gearing, held: Iterable[str]) -> list[Relation]:
    owners = {gear: gearing.shaft(gear) for gear in gearing.owners.values()}
    joints = [gearing.clutches[name] for name in held]
    return [
        *_of_pairs(gearing.pairs, owners), *_of_sets(gearing.planetaries), *_of_compounds(gearing.compounds),
        *(((joint["driving"], 1.0), (joint["driven"], -1.0)) for joint in joints),
    ]  # fmt: skip


def _of_pairs(pairs: Mapping[str, Mapping[str, Any]], owners: Mapping[str, str]) -> Iterator[Relation]:
    for pair in pairs.values():
        sign = -1.0 if pair.get("internal") else 1.0
        pinion, wheel = (owners.get(pair[role], pair[role]) for role in ("pinion", "wheel"))
        yield (pinion, float(pair["pinion_teeth"])), (wheel, sign * pair["wheel_teeth"])


def _of_sets(sets: Mapping[str, Mapping[str, Any]]) -> Iterator[Relation]:
    for members in sets.values():
        sun, ring = float(members["sun_teeth"]), float(members["ring_teeth"])
        yield (members["sun"], sun), (members["ring"], ring), (members["carrier"], -sun - ring)


def _of_compounds(compounds: Mapping[str, Mapping[str, Any]]) -> Iterator[Relation]:
    """Yield, of every compound set, how each sun and ring turns against the first one, seen from the carrier."""
    for table in compounds.values():
        centrals = {**table.get("suns", {}), **table.get("rings", {})}
        turns = _turns(table)
        first, *others = [name for name in centrals if name in turns]
        for other in others:
            ratio = turns[other] / turns[first]
            yield (centrals[other]["shaft"], 1.0), (centrals[first]["shaft"], -ratio), (table["carrier"], ratio - 1.0)


def _turns(table: Mapping[str, Any]) -> dict[str, float]:
    """Return gear -> its speed against the carrier, of all that the first planet turns, whose is 1 [-]."""
    planets, rings = table["planets"], table.get("rings", {})
    teeth = {
        name: gear["teeth"] for group in ("suns", "rings", "planets") for name, gear in table.get(group, {}).items()
    }
    turns, grown = {next(iter(planets)): 1.0}, True
    while grown:
        known = len(turns)
        for name, gear in planets.items():
            piece = gear.get("in_one_piece_with")
            links = [(mate, (1.0 if mate in rings else -1.0) * teeth[name] / teeth[mate]) for mate in gear["meshes"]]
            for other, ratio in [*links, *([(piece, 1.0)] if piece else [])]:
                if name in turns:
                    turns.setdefault(other, turns[name] * ratio)
                elif other in turns:
                    turns[name] = turns[other] / ratio
        grown = len(turns) > known
    return turns
