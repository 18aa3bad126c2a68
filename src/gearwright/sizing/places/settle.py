"""Shafts and carriers sized where everything has room: sized, placed, axes turned where they must, and sized again."""

from __future__ import annotations

from dataclasses import dataclass, replace

from gearwright.sizing.arranged import Arrangement, Turn
from gearwright.sizing.carrying import CarrierSizing, ShaftSizing
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, JointSizing
from gearwright.sizing.places.along import arrange_meshing
from gearwright.sizing.places.bodies import Parts, placed
from gearwright.sizing.places.room import Rules, rules_of
from gearwright.sizing.places.turning import turns_of
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shafts import (
    Built,
    refuse_bores,
    refuse_idle_shafts,
    size_carriers,
    size_shafts,
)

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
