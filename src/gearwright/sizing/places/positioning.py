"""Positioning of shafts and carriers without interference, with rotation of free axes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from gearwright.base import DesignError, smallest
from gearwright.sizing.places.bodies import Parts, placed
from gearwright.sizing.places.frames import arrange_meshing
from gearwright.sizing.places.room import Rules, any_into, entries, meetings, rules_of
from gearwright.sizing.places.solids import axes_among, room_between, stand_into
from gearwright.sizing.rating import Context
from gearwright.sizing.result import Arrangement, Body, GearSizing, Turn
from gearwright.sizing.shaft_results import BearingSizing, BuiltShaft, CarrierSizing, JointSizing, ShaftSizing
from gearwright.sizing.shafts import Built, refuse_bores, refuse_idle_shafts, size_carriers, size_shafts
from gearwright.spec.design import SIDE_ANGLES, Design

# ----------------------------------------------------------------------------------------------------------------------
# Axes that the design leaves open, turned about their mates by the least angle that makes room.
#
# One axis after another, in the order of the shafts: where turning it moves bodies that stand into each other or into
# a keep-out, it stands at the smallest turn that gives all of them room, found on a grid of 5° both ways and refined
# by halving; where no turn does, it stays. Sizes are those that were found before; who calls sizes the shafts anew
# and looks again.
# ----------------------------------------------------------------------------------------------------------------------


STEP = math.radians(5.0)
"""Of the grid [rad]."""
_HALVINGS = 10
"""Of a step of the grid, until the smallest turn is found to 0.005° [-]."""
_PROBE = math.radians(77.0)
"""Turn that shows whether an axis has to do with what stands into each other [rad]."""
CLEAR = 1e-3
"""How far an axis is turned on beyond where it has room, along its circle or less [m]: sizes change as it turns."""
_TOUCH = 1e-9
"""How far bodies may stand into each other by rounding [m]."""
_SAME = 1e-4
"""Change of a gap below which turning an axis has not moved it [m]."""


class Clash(NamedTuple):
    """What stands into each other."""

    gap: float
    """Negative [m]."""
    bodies: tuple[str, ...]
    """Names of both, or of the one in a keep-out."""
    words: str
    """What stands how far into what."""


Clashes = Mapping[str, Clash]
"""Owners of two bodies, or a keep-out -> what stands into each other."""


@dataclass(frozen=True)
class _Task:
    """What is turned."""

    parts: Parts
    rules: Rules
    angles: Mapping[str, float]
    """Turned so far [rad]."""

    def turned(self, shaft: str, angle: float) -> Arrangement | None:
        """Return where everything stands with one axis turned; None where the axes do not close so.

        Args:
            shaft: Of the axis.
            angle: Its direction from its mate [rad].
        """
        try:
            bare = arrange_meshing(self.parts.context, tuple(self.parts.gears.values()), {**self.angles, shaft: angle})
        except DesignError:
            return None
        return placed(replace(self.parts, arrangement=bare))


def clashes(design: Design, arrangement: Arrangement, rules: Rules) -> Clashes:
    """Return owners of two bodies, or a keep-out -> what stands into each other most.

    Args:
        design: With its keep-outs.
        arrangement: With its bodies.
        rules: Which bodies need no room.
    """
    found = {
        f"{one} {other}": Clash(
            meeting.room.gap,
            (meeting.one.name, meeting.other.name),
            f"{meeting.names} stood {-1e3 * meeting.room.gap:.3g} mm into each other",
        )
        for (one, other), meeting in meetings(arrangement.bodies, rules).items()
    }
    for entry in entries(design, arrangement.bodies):
        words = f"{entry.body.name} stood {-1e3 * entry.room.gap:.3g} mm into keep-out {entry.name}"
        found[f"keep-out {entry.name}"] = Clash(entry.room.gap, (entry.body.name,), words)
    return {key: clash for key, clash in found.items() if clash.gap < -_TOUCH}


def turns_of(parts: Parts, rules: Rules, arrangement: Arrangement) -> tuple[Turn, ...]:
    """Return the axes that must be turned to make room, with those turned already; the latter where all have room.

    Args:
        parts: What is sized.
        rules: Which bodies need no room.
        arrangement: Where everything stands, bodies included.
    """
    design, turns = parts.context.design, {turn.shaft: turn for turn in arrangement.turns}
    known = clashes(design, arrangement, rules)
    for shaft in design.shafts[1:]:
        now = _direction(parts, arrangement.axes, shaft) if known else None
        if now is None or (shaft in design.layout and design.layout[shaft].angle is not None):
            continue
        task = _Task(replace(parts, arrangement=arrangement), rules, {name: turn.after for name, turn in turns.items()})
        moved = _moved(task, shaft, now, known)
        into = [known[key] for key in known if key in moved]
        after = _least(task, shaft, now, frozenset(known) - moved, into) if moved else None
        if after is not None:
            why = smallest([clash for key, clash in known.items() if key in moved], lambda clash: clash.gap).words
            turns[shaft] = Turn(shaft, turns[shaft].before if shaft in turns else now, after, why)
            known = {key: clash for key, clash in known.items() if key not in moved}
    return tuple(turns.values())


def _direction(parts: Parts, axes: Mapping[str, complex], shaft: str) -> float | None:
    """Return the direction of a shaft's axis from the first axis that it meshes with [rad]; None where it has none."""
    for mesh in parts.context.train.meshes:
        if mesh.stage in parts.context.design.pairs and shaft in mesh.nodes[:2]:
            mate = mesh.nodes[1 - mesh.nodes.index(shaft)]
            if abs(axes[shaft] - axes[mate]) > 0.0:
                return cmath.phase(axes[shaft] - axes[mate])
    return None


def _moved(task: _Task, shaft: str, now: float, known: Clashes) -> frozenset[str]:
    """Return the clashes whose bodies turning an axis moves against each other, or against a keep-out."""
    here = {body.name: body for body in task.parts.arrangement.bodies}
    for turn in (_PROBE, -_PROBE):
        stands = task.turned(shaft, now + turn)
        if stands is not None:
            there = {body.name: body for body in stands.bodies}
            return frozenset(key for key, clash in known.items() if _is_moved(clash, here, there))
    return frozenset()


def _is_moved(clash: Clash, here: Mapping[str, Body], there: Mapping[str, Body]) -> bool:
    if len(clash.bodies) == 1:
        one, other = here[clash.bodies[0]], there[clash.bodies[0]]
        ends = zip((*one.origin, *one.direction), (*other.origin, *other.direction), strict=True)
        return any(abs(after - before) > _SAME for before, after in ends)
    before, after = (
        room_between(bodies[clash.bodies[0]], bodies[clash.bodies[1]], enough=-math.inf).gap for bodies in (here, there)
    )
    return abs(after - before) > _SAME


def _is_left(arrangement: Arrangement, names: tuple[str, ...]) -> bool:
    """Tell whether two bodies still stand into each other, on axes of their own."""
    one, other = (next(body for body in arrangement.bodies if body.name == name) for name in names)
    first, second = axes_among((one, other))
    return first != second and stand_into(one, other, _TOUCH)


def _least(task: _Task, shaft: str, now: float, left: frozenset[str], moved: Sequence[Clash]) -> float | None:
    """Return the direction nearest to the present one that leaves no clash but those that no turn moves [rad].

    None where there is none.
    """
    design = task.parts.context.design
    pairs = [clash.bodies for clash in moved if len(clash.bodies) == 2]

    def clear(turn: float) -> bool:
        stands = task.turned(shaft, now + turn)
        if stands is None or any(_is_left(stands, pair) for pair in pairs):
            return False
        return not any_into(stands.bodies, task.rules, but=left) and all(
            entry.room.gap >= -_TOUCH or f"keep-out {entry.name}" in left for entry in entries(design, stands.bodies)
        )

    turn = next((turn for turn in _grid(design, shaft, now) if clear(turn)), None)
    if turn is None:
        return None
    low, high = turn - math.copysign(STEP, turn), turn
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        low, high = (low, middle) if clear(middle) else (middle, high)
    arm = max(max(abs(frame.origin.y), abs(frame.origin.z)) for frame in task.parts.arrangement.frames.values())
    more = high + math.copysign(CLEAR / max(arm, CLEAR), high)
    return now + (more if clear(more) else high)


def _grid(design: Design, shaft: str, now: float) -> Iterator[float]:
    """Yield turns both ways, the smallest first, that keep to the side that is asked [rad]."""
    side = design.layout[shaft].side if shaft in design.layout else None
    for k in range(1, round(math.pi / STEP) + 1):
        for turn in (k * STEP, -k * STEP):
            if side is None or math.cos(now + turn - SIDE_ANGLES[side]) > 0.0:
                yield turn


# ----------------------------------------------------------------------------------------------------------------------
# Shafts and carriers sized where everything has room: sized, placed, axes turned where they must, and sized again.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 3
"""How often axes are turned at most: the loads on the shafts turn with them, and with these their diameters [-]."""


@dataclass(frozen=True)
class Settled:
    """What carries gears, and where it stands."""

    arrangement: Arrangement
    shafts: tuple[ShaftSizing, ...]
    built: tuple[Built, ...]
    carriers: tuple[CarrierSizing, ...]
    rules: Rules
    """Which bodies need no room beside each other."""

    @property
    def built_shafts(self) -> tuple[BuiltShaft, ...]:
        """Shafts with bearings."""
        return tuple(shaft.shaft for shaft in self.built)

    @property
    def bearings(self) -> tuple[BearingSizing, ...]:
        """Of those shafts."""
        return tuple(bearing for shaft in self.built for bearing in shaft.bearings)

    @property
    def joints(self) -> tuple[JointSizing, ...]:
        """Of those shafts."""
        return tuple(joint for shaft in self.built for joint in shaft.joints)


def settle(context: Context, gears: tuple[GearSizing, ...], *, still: bool = False) -> Settled:
    """Return shafts and carriers with the arrangement in which they have room, as far as open angles give it.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        still: Whether open axes stay where they stand first.

    Raises:
        DesignError: If axes do not close, or what sits on a shaft, its bore or its strength cannot be had.
    """
    turns: tuple[Turn, ...] = ()
    for _ in range(0 if still else ROUNDS):
        settled = _settled(context, gears, turns)
        parts = _parts(context, gears, settled)
        found = turns_of(parts, settled.rules, settled.arrangement)
        if found == turns:
            return settled
        turns = found
    return _settled(context, gears, turns)


def _settled(context: Context, gears: tuple[GearSizing, ...], turns: tuple[Turn, ...]) -> Settled:
    bare = arrange_meshing(context, gears, {turn.shaft: turn.after for turn in turns})
    shafts, built = size_shafts(context, gears, bare)
    refuse_bores(shafts)
    refuse_idle_shafts(shafts)
    carriers = size_carriers(context, gears, shafts, bare.two_sided)
    by_name = {gear.name: gear for gear in gears}
    joints = [joint for shaft in built for joint in shaft.joints]
    rules = rules_of(context, by_name, [shaft.shaft.name for shaft in built], joints)
    settled = Settled(replace(bare, turns=turns), shafts, tuple(built), carriers, rules)
    return replace(settled, arrangement=placed(_parts(context, gears, settled)))


def _parts(context: Context, gears: tuple[GearSizing, ...], settled: Settled) -> Parts:
    by_name = {gear.name: gear for gear in gears}
    return Parts(
        context, by_name, settled.shafts, settled.built_shafts, settled.bearings, settled.carriers, settled.arrangement
    )
