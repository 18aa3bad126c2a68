"""What the twins of sizing do otherwise for bearings of planets: each lane takes its own of the catalogue."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np

from gearwright.arrays import Ints
from gearwright.catalogue import bearing_friction
from gearwright.lanes import Lanes, Unsupported, chosen, each, lanes_of
from gearwright.parts.bearings import THINNEST, life_modification
from gearwright.sizing.many.twinned import gathered
from gearwright.sizing.planets.rollers import on_rollers


class Names(str):
    """The names of what each lane has; as a text the first of them, as words are for one design alone."""

    __slots__ = ("kinds", "place")
    kinds: tuple[str, ...]
    """Every name that occurs."""
    place: Ints
    """Of every lane, which of them it has."""

    @classmethod
    def of(cls, kinds: Sequence[str], place: Ints) -> Names:
        """Return the names of lanes.

        Args:
            kinds: Every name that occurs.
            place: Of every lane, which of them it has.
        """
        made = cls(kinds[0])
        made.kinds, made.place = tuple(kinds), place
        return made


def each_of(records: Sequence[Any], place: Ints) -> Any:
    """Return a record with the numbers that every lane has of one of some records of a kind.

    Args:
        records: Records, numbers, or texts.
        place: Of every lane, which of them it has.
    """
    first = records[0]
    if all(record == first for record in records):
        return first
    if isinstance(first, str):
        return Names.of(records, place)
    if is_dataclass(first) and not isinstance(first, type):
        own = {part.name: each_of([getattr(record, part.name) for record in records], place) for part in fields(first)}
        return replace(first, **own)
    return gathered(list(records), place.tolist())


def of_catalogue(module: ModuleType) -> None:
    """Try the bearings of the catalogue in all lanes: those that have theirs wait for the others.

    Args:
        module: Twin of the choice of bearings.
    """
    alone: Callable[..., Any] = module._of_catalogue

    def in_lanes(task: Any) -> Any:
        if type(task.room) is not Lanes:
            return alone(task)
        kind, count = task.asked.kind, task.asked.side_by_side
        sizes, best, place = module.cylindrical(), lanes_of(-np.inf), lanes_of(0)
        for k, size in enumerate(sizes):
            fits = lanes_of(best < 1.0) & lanes_of(module.fits(task, size))
            if fits.data.any():
                nearness = lanes_of(module.min_margin(task, on_rollers(kind, size, count)))
                better = fits & (nearness > best)
                best, place = lanes_of(chosen(better, nearness, best)), lanes_of(chosen(better, k, place))
        if bool(best == -np.inf):
            raise Unsupported("planets without room for a bearing")
        taken, own = np.unique(place.data, return_inverse=True)
        return each_of([on_rollers(kind, sizes[k], count) for k in taken.tolist()], own)

    module._of_catalogue = in_lanes  # type: ignore[attr-defined]


def friction(module: ModuleType) -> None:
    """Look the friction of the series of every lane's bearing up.

    Args:
        module: Twin of the oil of bearings.
    """

    def friction_of(bearing: Any) -> Any:
        names = bearing.designation
        if not isinstance(names, Names):
            return bearing_friction(bearing)
        found = [bearing_friction(replace(bearing, designation=name)) for name in names.kinds]
        return gathered(found, names.place.tolist())

    module.bearing_friction = friction_of  # type: ignore[attr-defined]


def lives(module: ModuleType) -> None:
    """Find the modification of the life of every lane by itself: its ranges differ.

    Args:
        module: Twin of modified lives.
    """
    alone: Callable[..., Any] = module.life_modification

    def modified(clean_share: Any, viscosity_ratio: Any, kind: Any) -> Any:
        if type(clean_share) is not Lanes and type(viscosity_ratio) is not Lanes:
            return alone(clean_share, viscosity_ratio, kind)
        thin = lanes_of(viscosity_ratio < THINNEST)
        if bool(thin):  # which has no life
            raise Unsupported("oil that is too thin")
        return Lanes(each(lambda share, ratio: life_modification(share, ratio, kind), clean_share, viscosity_ratio))

    module.life_modification = modified  # type: ignore[attr-defined]
