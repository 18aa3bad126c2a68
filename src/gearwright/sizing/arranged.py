"""Where everything in a sized transmission stands, as records: axes in the cross-section, places along every shaft.

Found once, by `arrangement`; loads, shafts, bearings, flights and drawings read it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gearwright.spec.design import BearingSeat
from gearwright.units import Length


@dataclass(frozen=True)
class ShaftPlan:
    """A shaft from its first end on."""

    length: Length
    """[m]"""
    bearings: tuple[Length, Length]
    """Middles of its two radial bearings, from the first end [m]."""
    places: Mapping[str, Length]
    """Gear, carrier, machine or clutch -> middle of its width, from the first end [m], in order."""
    seats: Mapping[str, BearingSeat] = field(default_factory=dict)
    """Bearings that the design gives the shaft, by name, in order along it; none where it leaves them open."""


@dataclass(frozen=True)
class Arrangement:
    """Axes and shafts of a transmission."""

    axes: Mapping[str, complex]
    """Shaft -> where its axis stands in the cross-section, y + i z [m], seen along x."""
    plans: Mapping[str, ShaftPlan]
    """Shaft -> where everything sits along it."""
