"""Graph of the gear train: shafts, planets, meshes, clutches and compound planetary stages."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, wraps
from typing import TypeVar

import numpy as np

from gearwright.base import SIDES, Floats, Kind, PartId, Role, Row, TorsionalDamping, gear_part, mesh_part
from gearwright.memo import Memo
from gearwright.spec import GROUND, Design, Epicyclic, Pair, Planetary

# ----------------------------------------------------------------------------------------------------------------------
# Remember what a matrix gave: the trains of a study repeat their matrices from load case to load case and design.
# ----------------------------------------------------------------------------------------------------------------------


Result = TypeVar("Result", Floats, tuple[Floats, Floats, Floats])
KEPT = 1024
"""Latest matrices of which the result is kept: some 1 MB."""


def remembered(function: Callable[[Floats], Result]) -> Callable[[Floats], Result]:
    """Return a function of one matrix that keeps its latest results, which are not to be written to.

    Args:
        function: Its result, one array or several, depends on the matrix alone.
    """

    memo = Memo[tuple[bytes, tuple[int, ...]], Result](KEPT)

    def made(content: bytes, shape: tuple[int, ...]) -> Result:
        result = function(np.frombuffer(content).reshape(shape))
        for array in (result,) if isinstance(result, np.ndarray) else result:
            array.flags.writeable = False
        return result

    @wraps(function)
    def looked_up(matrix: Floats) -> Result:
        key = (matrix.tobytes(), matrix.shape)
        return memo.of(key, lambda: made(*key))

    return looked_up


# ----------------------------------------------------------------------------------------------------------------------
# Null space: what the rows of a matrix take to zero, by one tolerance for every question about rank.
# ----------------------------------------------------------------------------------------------------------------------


RANK_TOLERANCE = 1e-10
"""Singular value over the largest below which a direction counts as free [-]."""


def null_space(matrix: Floats) -> Floats:
    """Return an orthonormal basis (columns, dimensions) of what the rows take to zero.

    Args:
        matrix: (rows, columns), its rows of like length.

    Source: Golub & Van Loan 2013, Matrix Computations, section 5.4: the right singular vectors beyond the rank.
    """
    return row_and_null_space(matrix)[1]


def row_and_null_space(matrix: Floats) -> tuple[Floats, Floats]:
    """Return orthonormal bases (columns, dimensions) of what the rows feel, and of what they take to zero.

    Args:
        matrix: (rows, columns), its rows of like length.

    Source: Golub & Van Loan 2013, Matrix Computations, section 5.4: the right singular vectors, cut at the rank.
    """
    if not len(matrix):
        return np.zeros((matrix.shape[1], 0)), np.eye(matrix.shape[1])
    _, values, right = np.linalg.svd(matrix)
    rank = int(np.count_nonzero(values > RANK_TOLERANCE * np.max(values, initial=1e-300)))
    return right[:rank].T, right[rank:].T


# ----------------------------------------------------------------------------------------------------------------------
# What has teeth: a kind of gear body, and a row of equal meshes.
# ----------------------------------------------------------------------------------------------------------------------


EXTERNAL, INTERNAL = -1, 1


@dataclass(frozen=True)
class Gear:
    """One kind of toothed body; several equal ones count together."""

    stage: str
    """Pair or planetary set that owns it."""
    role: Role
    """What it is in its stage."""
    nodes: tuple[str, ...]
    """Shafts that carry it (one body, or one per half, on each), or the planet's own node."""
    bodies: int
    """Number of equal bodies."""
    own: str = ""
    """What the design calls it, in a compound set."""
    group: str = ""
    """Gears of its stage that have one module, in a compound set: the first of them; empty where all have one."""

    @cached_property
    def part(self) -> PartId:
        """Who it is."""
        return gear_part(self.stage, self.role, own=self.own)

    @cached_property
    def name(self) -> str:
        """Its label, such as ``first.sun``."""
        return str(self.part)

    @property
    def sized(self) -> str:
        """What has one module with it: its stage, or a group of gears of a compound set."""
        return _sized(self.stage, self.group)


@dataclass(frozen=True)
class Mesh:
    """A row of the graph: one mesh, or several equal ones that share a load."""

    stage: str
    """Pair or planetary set that it belongs to."""
    row: Row
    """Which meshes of the stage it holds."""
    gears: tuple[str, str]
    """Names of gear a and gear b."""
    nodes: tuple[str, str, str]
    """Node of gear a, of gear b, and of the carrier of their axes."""
    sign: int
    """−1 external, +1 internal."""
    count: int
    """Number of equal meshes of the row (planets, halves)."""
    branch: str = ""
    """Shaft that tells it from the other rows of a pair; empty where the pair has one."""
    own: str = ""
    """What the design calls its two gears, in a compound set."""
    group: str = ""
    """As of its gears."""

    @cached_property
    def part(self) -> PartId:
        """Who it is."""
        return mesh_part(self.stage, self.row, self.branch, own=self.own)

    @cached_property
    def name(self) -> str:
        """Its label, such as ``first.sun-planet``."""
        return str(self.part)

    @property
    def sized(self) -> str:
        """What has one module with it: its stage, or a group of gears of a compound set."""
        return _sized(self.stage, self.group)


def _sized(stage: str, group: str) -> str:
    return str(PartId(Kind.GEAR, stage, own=group)) if group else stage


# ----------------------------------------------------------------------------------------------------------------------
# Compound epicyclic sets in the graph: a node per planet body, a row per mesh, all relative to the one carrier.
# ----------------------------------------------------------------------------------------------------------------------


def epicyclic_gears(stage: str, epicyclic: Epicyclic) -> Iterator[Gear]:
    """Yield every gear of a compound set; the steps of a stepped planet share a node.

    Args:
        stage: Its name.
        epicyclic: As in the design.
    """
    for name in epicyclic.toothed:
        central, role = epicyclic.centrals.get(name), _role(epicyclic, name)
        bodies = epicyclic.sets if central is None else 1
        yield Gear(stage, role, (_node(stage, epicyclic, name),), bodies, name, epicyclic.group(name))


def epicyclic_meshes(stage: str, epicyclic: Epicyclic) -> Iterator[Mesh]:
    """Yield every mesh row of a compound set.

    Args:
        stage: Its name.
        epicyclic: As in the design.
    """
    for first, second in epicyclic.mesh_pairs:
        yield Mesh(
            stage,
            _row(epicyclic, first, second),
            (_name(stage, epicyclic, first), _name(stage, epicyclic, second)),
            (_node(stage, epicyclic, first), _node(stage, epicyclic, second), epicyclic.carrier),
            INTERNAL if second in epicyclic.rings else EXTERNAL,
            epicyclic.sets,
            own=f"{first}-{second}",
            group=epicyclic.group(first),
        )


def _role(epicyclic: Epicyclic, name: str) -> Role:
    return Role.SUN if name in epicyclic.suns else Role.RING if name in epicyclic.rings else Role.PLANET


def _row(epicyclic: Epicyclic, first: str, second: str) -> Row:
    if second in epicyclic.rings:
        return Row.PLANET_RING
    return Row.SUN_PLANET if first in epicyclic.suns else Row.PLANET_PLANET


def _name(stage: str, epicyclic: Epicyclic, gear: str) -> str:
    return str(gear_part(stage, _role(epicyclic, gear), own=gear))


def _node(stage: str, epicyclic: Epicyclic, gear: str) -> str:
    """Return the shaft of a sun or ring, or the node of a planet's body, called as the first of its steps."""
    central = epicyclic.centrals.get(gear)
    return _name(stage, epicyclic, epicyclic.body(gear)) if central is None else central.shaft


# ----------------------------------------------------------------------------------------------------------------------
# The power train as a graph: shafts and planets are nodes with one speed each, meshes and clutches are rows.
#
# A row of a mesh reads z_a (ω_a − ω_c) − s z_b (ω_b − ω_c) = 0, relative to the carrier c (the ground for fixed
# axes), with s = −1 for an external and +1 for an internal mesh. Its multiplier λ is the torque per tooth of all the
# row's equal meshes together.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Joint:
    """A clutch as a row: ω_driving − ω_driven = 0 while it is engaged."""

    name: str
    driving: str
    driven: str
    overrunning: bool
    is_open: bool = False
    """True where it holds only in cases that engage it."""

    @property
    def is_brake(self) -> bool:
        """Whether it holds a shaft to the ground."""
        return GROUND in (self.driving, self.driven)


@dataclass(frozen=True)
class Damper:
    """A viscous damper between two shafts: it binds no speed, and gives its driven shaft c (ω_driving − ω_driven)."""

    name: str
    driving: str
    driven: str
    damping: TorsionalDamping
    """c [N m s/rad]."""


@dataclass(frozen=True)
class Train:
    """The graph of a design, without tooth numbers."""

    nodes: tuple[str, ...]
    """Shafts in the design's order, then one node per planetary set's planets, or per planet of a compound set."""
    gears: tuple[Gear, ...]
    """Every kind of gear."""
    meshes: tuple[Mesh, ...]
    """Every mesh row."""
    joints: tuple[Joint, ...]
    """Every clutch and brake that holds in some case; a brake joins a shaft and the ground."""
    dampers: tuple[Damper, ...]
    """Every viscous damper."""
    machines: Mapping[str, str]
    """Machine -> shaft."""

    @property
    def links(self) -> tuple[Joint | Damper, ...]:
        """Everything that joins two shafts of one axis."""
        return (*self.joints, *self.dampers)

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

    def gear_of(self, stage: str, role: Role) -> Gear:
        """Return what plays a role in a stage.

        Args:
            stage: That owns the gear.
            role: Such as the sun.
        """
        return self._by_name[str(gear_part(stage, role))]

    @cached_property
    def internal(self) -> frozenset[str]:
        """Gears with their teeth inside: rings, and wheels of internal pairs."""
        return frozenset(mesh.gears[1] for mesh in self.meshes if mesh.sign == INTERNAL)

    @cached_property
    def planet_nodes(self) -> frozenset[str]:
        """Nodes that are no shafts: those of planets, each shared by all equal ones of its set."""
        return frozenset(node for gear in self.gears if gear.role is Role.PLANET for node in gear.nodes)


def build_train(design: Design) -> Train:
    """Return the graph of a design.

    Args:
        design: As read.
    """
    gears: list[Gear] = []
    meshes: list[Mesh] = []
    planets: list[str] = []
    for name, planetary in design.planetaries.items():
        planets.append(str(gear_part(name, Role.PLANET)))
        gears += _planetary_gears(name, planetary)
        meshes += _planetary_meshes(name, planetary)
    for name, epicyclic in design.epicyclics.items():
        gears += epicyclic_gears(name, epicyclic)
        meshes += epicyclic_meshes(name, epicyclic)
    planets += dict.fromkeys(
        node for gear in gears if gear.role is Role.PLANET for node in gear.nodes if node not in planets
    )
    for name, pair in design.pairs.items():
        gears += _pair_gears(name, pair)
        meshes += _pair_meshes(name, pair, design)
    engaged = {name for case in design.cases.values() for name in case.engaged or []}
    joints = tuple(
        Joint(name, clutch.driving, clutch.driven, clutch.kind == "overrunning", clutch.kind == "open")
        for name, clutch in design.clutches.items()
        if clutch.kind != "open" or name in engaged
    )
    machines = {name: machine.shaft for name, machine in design.machines.items()}
    dampers = tuple(
        Damper(name, damper.driving, damper.driven, damper.damping) for name, damper in design.dampers.items()
    )
    return Train((*design.shafts, *planets), tuple(gears), tuple(meshes), joints, dampers, machines)


def _planetary_gears(stage: str, planetary: Planetary) -> list[Gear]:
    return [
        Gear(stage, Role.SUN, (planetary.sun,), 1),
        Gear(stage, Role.PLANET, (str(gear_part(stage, Role.PLANET)),), planetary.planets),
        Gear(stage, Role.RING, (planetary.ring,), 1),
    ]


def _planetary_meshes(stage: str, planetary: Planetary) -> list[Mesh]:
    sun, planet, ring = gears_of(stage, planetary)
    count, carrier = planetary.planets, planetary.carrier
    return [
        Mesh(stage, Row.SUN_PLANET, (sun, planet), (planetary.sun, planet, carrier), EXTERNAL, count),
        Mesh(stage, Row.PLANET_RING, (planet, ring), (planet, planetary.ring, carrier), INTERNAL, count),
    ]


def gear_of(stage: str, side: Role, pair: Pair) -> PartId:
    """Return the gear on one side of a pair, its own or the one that it shares.

    Args:
        stage: Name of the pair.
        side: Pinion or wheel.
        pair: The pair.
    """
    return gear_part(*(pair.shared(side) or (stage, side)))


def gears_of(name: str, stage: Pair | Planetary | Epicyclic) -> tuple[str, ...]:
    """Return the names of a stage's gears: sun, planet and ring, or pinion and wheel, its own or shared; or all.

    Args:
        name: Of the stage.
        stage: As in the design.
    """
    if isinstance(stage, Epicyclic):
        return tuple(gear.name for gear in epicyclic_gears(name, stage))
    if isinstance(stage, Planetary):
        return tuple(str(gear_part(name, role)) for role in (Role.SUN, Role.PLANET, Role.RING))
    return tuple(str(gear_of(name, side, stage)) for side in SIDES)


def shafts_of(side: Role, pair: Pair, design: Design) -> list[str]:
    """Return the shafts on one side of a pair.

    Args:
        side: Pinion or wheel.
        pair: The pair.
        design: Where a shared gear is looked up.
    """
    shared = pair.shared(side)
    return pair.named(side) if shared is None else design.pairs[shared[0]].named(shared[1])


def _pair_gears(stage: str, pair: Pair) -> list[Gear]:
    return [
        Gear(stage, side, tuple(pair.named(side)), len(pair.named(side)) * pair.halves)
        for side in SIDES
        if pair.shared(side) is None
    ]


def _pair_meshes(stage: str, pair: Pair, design: Design) -> list[Mesh]:
    pinions, wheels = (shafts_of(side, pair, design) for side in SIDES)
    count = max(len(pinions), len(wheels))
    ends = zip(pinions * (count // len(pinions)), wheels * (count // len(wheels)), strict=True)
    pinion, wheel = gears_of(stage, pair)
    sign = INTERNAL if pair.internal else EXTERNAL
    parallel = pinions if len(pinions) > 1 else wheels
    return [
        Mesh(stage, Row.PAIR, (pinion, wheel), (*shafts, GROUND), sign, pair.halves, "" if count == 1 else parallel[k])
        for k, shafts in enumerate(ends)
    ]
