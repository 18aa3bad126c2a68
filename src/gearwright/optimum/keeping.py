"""Designs of which something is kept: the teeth that were chosen, or modules and face widths, too."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from gearwright.errors import GearwrightError
from gearwright.identity import Role
from gearwright.sizing import GearSizing, Sizing, size
from gearwright.spec import Design, Study, edited
from gearwright.spec.design import Pair, Planetary
from gearwright.spec.studies import Value
from gearwright.study.answers import Row
from gearwright.study.cases import split

_TEETH = {
    Role.PINION: "pinion_teeth", Role.WHEEL: "wheel_teeth",
    Role.SUN: "sun_teeth", Role.PLANET: "planet_teeth", Role.RING: "ring_teeth",
}  # fmt: skip
_TABLES: Mapping[type, str] = {Pair: "pairs", Planetary: "planetaries"}
_MM = 1e-3


class Fixed(NamedTuple):
    """A design whose teeth are kept."""

    design: str
    inputs: Mapping[str, Value]
    """Freedoms, and paths of teeth."""


def sizing_of(study: Study, designs: Mapping[str, Design], row: Row) -> Sizing:
    """Return the sizing of a row.

    Args:
        study: With its changes.
        designs: Name -> design.
        row: That could be sized.
    """
    changes, _ = split({**study.changes, **row.inputs})
    return size(edited(designs[row.design], changes))


def with_teeth(study: Study, designs: Mapping[str, Design], row: Row) -> Fixed | None:
    """Return a row with the teeth and numbers of planets that were chosen; nothing where they cannot be kept.

    Args:
        study: With its changes.
        designs: Name -> design.
        row: That could be sized.
    """
    try:
        sizing = sizing_of(study, designs, row)
        return Fixed(row.design, {**row.inputs, **teeth_of(sizing)})
    except GearwrightError:
        return None


def teeth_of(sizing: Sizing) -> dict[str, Value]:
    """Return path -> teeth and planets of every pair and planetary set.

    Args:
        sizing: As sized.
    """
    found: dict[str, Value] = {}
    for path, gear in _gears(sizing):
        if gear.role in _TEETH:
            found[f"{path}.{_TEETH[gear.role]}"] = gear.teeth
        if gear.role is Role.PLANET:
            found[f"{path}.planets"] = gear.bodies
    return found


def sizes_of(sizing: Sizing) -> dict[str, Value]:
    """Return path -> module and face width of every pair and planetary set [mm].

    Args:
        sizing: As sized.
    """
    found: dict[str, Value] = {}
    for path, gear in _gears(sizing):
        found.setdefault(f"{path}.module_mm", gear.module / _MM)
        found.setdefault(f"{path}.face_width_mm", gear.face_width / _MM)
    return found


def _gears(sizing: Sizing) -> Iterator[tuple[str, GearSizing]]:
    """Yield the gears of pairs and planetary sets, each with the path of its stage."""
    for gear in sizing.gears:
        table = _TABLES.get(type(sizing.design.stages[gear.stage]))
        if table is not None:
            yield f"{table}.{gear.stage}", gear
