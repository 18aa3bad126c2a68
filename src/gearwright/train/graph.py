"""The power train as a graph: shafts and planets are nodes with one speed each, meshes and clutches are rows.

A row of a mesh reads z_a (ω_a − ω_c) − s z_b (ω_b − ω_c) = 0, relative to the carrier c (the ground for fixed axes),
with s = −1 for an external and +1 for an internal mesh. Its multiplier λ is the torque per tooth of all the row's equal
meshes together.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from gearwright.spec import GROUND, Design, Pair, Planetary
from gearwright.spec.checks import as_list

EXTERNAL, INTERNAL = -1, 1


@dataclass(frozen=True)
class Gear:
    """One kind of toothed body; several equal ones count together."""

    name: str
    """Such as ``first.sun``."""
    stage: str
    """Pair or planetary set that owns it."""
    role: Literal["sun", "planet", "ring", "pinion", "wheel"]
    """What it is in its stage."""
    nodes: tuple[str, ...]
    """Shafts that carry it (one body, or one per half, on each), or the planet's own node."""
    bodies: int
    """Number of equal bodies."""


@dataclass(frozen=True)
class Mesh:
    """A row of the graph: one mesh, or several equal ones that share a load."""

    name: str
    """Such as ``first.sun-planet``."""
    stage: str
    """Pair or planetary set that it belongs to."""
    gears: tuple[str, str]
    """Names of gear a and gear b."""
    nodes: tuple[str, str, str]
    """Node of gear a, of gear b, and of the carrier of their axes."""
    sign: int
    """−1 external, +1 internal."""
    count: int
    """Number of equal meshes of the row (planets, halves)."""


@dataclass(frozen=True)
class Joint:
    """A clutch as a row: ω_driving − ω_driven = 0 while it is engaged."""

    name: str
    driving: str
    driven: str
    overrunning: bool


@dataclass(frozen=True)
class Train:
    """The graph of a design, without tooth numbers."""

    nodes: tuple[str, ...]
    """Shafts in the design's order, then one node per planetary set's planets."""
    gears: tuple[Gear, ...]
    """Every kind of gear."""
    meshes: tuple[Mesh, ...]
    """Every mesh row."""
    joints: tuple[Joint, ...]
    """Every clutch that is not open."""
    machines: Mapping[str, str]
    """Machine -> shaft."""

    @cached_property
    def column(self) -> Mapping[str, int]:
        """Node -> its place among the nodes."""
        return {name: k for k, name in enumerate(self.nodes)}

    @cached_property
    def _by_name(self) -> Mapping[str, Gear]:
        return {gear.name: gear for gear in self.gears}

    def gear(self, name: str) -> Gear:
        """Return a gear by its name.

        Args:
            name: Such as ``first.sun``.
        """
        return self._by_name[name]


def build_train(design: Design) -> Train:
    """Return the graph of a design.

    Args:
        design: As read.
    """
    gears: list[Gear] = []
    meshes: list[Mesh] = []
    planets: list[str] = []
    for name, planetary in design.planetaries.items():
        planets.append(f"{name}.planet")
        gears += _planetary_gears(name, planetary)
        meshes += _planetary_meshes(name, planetary)
    for name, pair in design.pairs.items():
        gears += _pair_gears(name, pair)
        meshes += _pair_meshes(name, pair, design)
    joints = tuple(
        Joint(name, clutch.driving, clutch.driven, clutch.kind == "overrunning")
        for name, clutch in design.clutches.items()
        if clutch.kind != "open"
    )
    machines = {name: machine.shaft for name, machine in design.machines.items()}
    return Train((*design.shafts, *planets), tuple(gears), tuple(meshes), joints, machines)


def _planetary_gears(name: str, planetary: Planetary) -> list[Gear]:
    return [
        Gear(f"{name}.sun", name, "sun", (planetary.sun,), 1),
        Gear(f"{name}.planet", name, "planet", (f"{name}.planet",), planetary.planets),
        Gear(f"{name}.ring", name, "ring", (planetary.ring,), 1),
    ]


def _planetary_meshes(name: str, planetary: Planetary) -> list[Mesh]:
    sun, planet, ring = f"{name}.sun", f"{name}.planet", f"{name}.ring"
    count, carrier = planetary.planets, planetary.carrier
    return [
        Mesh(f"{name}.sun-planet", name, (sun, planet), (planetary.sun, planet, carrier), EXTERNAL, count),
        Mesh(f"{name}.planet-ring", name, (planet, ring), (planet, planetary.ring, carrier), INTERNAL, count),
    ]


def gear_of(stage: str, side: str, pair: Pair) -> str:
    """Return the name of the gear on one side of a pair, its own or the one that it shares.

    Args:
        stage: Name of the pair.
        side: ``pinion`` or ``wheel``.
        pair: The pair.
    """
    reference = as_list(getattr(pair, side))[0]
    return reference if "." in reference else f"{stage}.{side}"


def shafts_of(side: str, pair: Pair, design: Design) -> list[str]:
    """Return the shafts on one side of a pair.

    Args:
        side: ``pinion`` or ``wheel``.
        pair: The pair.
        design: Where a shared gear is looked up.
    """
    names = as_list(getattr(pair, side))
    if "." not in names[0]:
        return names
    stage, _, gear = names[0].partition(".")
    return as_list(getattr(design.pairs[stage], gear))


def _pair_gears(name: str, pair: Pair) -> list[Gear]:
    gears: list[Gear] = []
    for side in ("pinion", "wheel"):
        shafts = as_list(getattr(pair, side))
        if "." not in shafts[0]:
            role: Literal["pinion", "wheel"] = "pinion" if side == "pinion" else "wheel"
            gears.append(Gear(f"{name}.{side}", name, role, tuple(shafts), len(shafts) * pair.halves))
    return gears


def _pair_meshes(name: str, pair: Pair, design: Design) -> list[Mesh]:
    pinions, wheels = shafts_of("pinion", pair, design), shafts_of("wheel", pair, design)
    count = max(len(pinions), len(wheels))
    ends = zip(pinions * (count // len(pinions)), wheels * (count // len(wheels)), strict=True)
    gears = (gear_of(name, "pinion", pair), gear_of(name, "wheel", pair))
    sign = INTERNAL if pair.internal else EXTERNAL
    parallel = pinions if len(pinions) > 1 else wheels
    return [
        Mesh(name if count == 1 else f"{name}.{parallel[k]}", name, gears, (pinion, wheel, GROUND), sign, pair.halves)
        for k, (pinion, wheel) in enumerate(ends)
    ]
