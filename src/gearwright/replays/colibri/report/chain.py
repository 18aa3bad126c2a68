"""The whole Colibri report computed: its stated inputs, then part after part, each reading what came before."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType

from gearwright.replays.colibri.report.bearings import bearings, keys
from gearwright.replays.colibri.report.gears import (
    bevel_pinion,
    bevel_wheel,
    helical_pinion,
    helical_wheel,
    requirement,
)
from gearwright.replays.colibri.report.shafts import diameters, reactions, rotor_shaft, straight_shafts
from gearwright.replays.colibri.report.steps import Step, Steps, stated_steps

_PARTS: tuple[Callable[[Steps], Mapping[str, Step]], ...] = (
    requirement, helical_pinion, helical_wheel, bevel_pinion, bevel_wheel, straight_shafts, rotor_shaft, reactions,
    diameters, bearings, keys,
)  # fmt: skip


@cache
def executed() -> Steps:
    """Return every number of the report as its own steps give it, in SI."""
    steps = stated_steps()
    for part in _PARTS:
        steps |= part(MappingProxyType(steps))
    return MappingProxyType(steps)
