"""Speeds that a compound set ties to each other: its teeth are given, so that a held member leaves known ratios."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from gearwright.arrays import Floats
from gearwright.spec import GROUND, Design
from gearwright.train.algebra import null_space
from gearwright.train.graph import Train, epicyclic_gears, epicyclic_meshes
from gearwright.train.kinematics.speeds import rows

Speed = TypeVar("Speed", float, Floats)
STANDS = 1e-9
"""Part of the motion below which a shaft stands still [-]."""


def ties_of(design: Design, name: str) -> dict[str, float]:
    """Return shaft -> speed, signed and relative to each other, of a compound set with one freedom; else nothing.

    Args:
        design: As typed.
        name: Of one of its compound sets.
    """
    epicyclic = design.epicyclics[name]
    gears, meshes = tuple(epicyclic_gears(name, epicyclic)), tuple(epicyclic_meshes(name, epicyclic))
    shafts = [shaft for shaft in dict.fromkeys(epicyclic.members) if shaft != GROUND]
    planets = dict.fromkeys(node for gear in gears for node in gear.nodes if node not in (*shafts, GROUND))
    train = Train((*shafts, *planets), gears, meshes, (), (), {})
    motions = null_space(rows(train, teeth_of(design, name), ()))
    if motions.shape[1] != 1:
        return {}
    speeds = {shaft: float(motions[train.column[shaft], 0]) for shaft in shafts}
    return {shaft: speed for shaft, speed in speeds.items() if abs(speed) > STANDS}


def handed_on(ties: Mapping[str, float], known: Mapping[str, Speed]) -> dict[str, Speed]:
    """Return the speeds that a compound set adds to those that are known, without their sense.

    Args:
        ties: From `ties_of`.
        known: Shaft -> speed [rad/s].
    """
    source = next((shaft for shaft in ties if shaft in known), "")
    if not source:
        return {}
    return {shaft: known[source] * abs(tied / ties[source]) for shaft, tied in ties.items() if shaft not in known}


def teeth_of(design: Design, name: str) -> dict[str, int]:
    """Return the tooth number of every gear of a compound set.

    Args:
        design: As typed.
        name: Of the set.
    """
    epicyclic = design.epicyclics[name]
    return {gear.name: epicyclic.toothed[gear.own].teeth for gear in epicyclic_gears(name, epicyclic)}
