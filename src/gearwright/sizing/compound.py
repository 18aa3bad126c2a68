"""Where the pins of compound sets stand, and in which planes their gears lie, with the modules that were found."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import replace
from typing import Protocol

from gearwright.parts.planetary import pin_angles, pin_radii, planes
from gearwright.spec import Epicyclic


class Sized(Protocol):
    """A gear that has its module."""

    @property
    def stage(self) -> str:
        """Stage that owns it."""

    @property
    def own(self) -> str:
        """What the design calls it."""

    @property
    def module(self) -> float:
        """m_n [m]."""


def pins_of(
    epicyclic: Epicyclic, gears: Mapping[str, Sized], centres: Mapping[str, float]
) -> dict[str, complex]:  # fmt: skip
    """Return planet body -> place of its pin in the first set, from the axis, y + i z [m].

    Args:
        epicyclic: As in the design.
        gears: Its gears by the design's names.
        centres: Mesh by the design's names, such as ``sun-planet`` -> working centre distance [m].
    """
    modules = {epicyclic.group(name): gear.module for name, gear in gears.items()}
    distances = {pair: centres["-".join(pair)] / gears[pair[0]].module for pair in epicyclic.mesh_pairs}
    compound = replace(epicyclic.compound, centres=distances)
    angles = pin_angles(compound, modules)
    return {body: cmath.rect(radius, angles[body]) for body, radius in pin_radii(compound, modules).items()}


def towards(epicyclic: Epicyclic, pins: Mapping[str, complex], gear: str, mate: str) -> complex:
    """Return the direction from a gear's axis to the point at which it meshes with a mate in the first set [-].

    Args:
        epicyclic: As in the design.
        pins: Planet body -> place of its pin [m].
        gear: In the design's words.
        mate: In the design's words.
    """
    here, there = (pins[epicyclic.body(name)] if name in epicyclic.planets else 0j for name in (gear, mate))
    between = here + there if {gear, mate} & epicyclic.rings.keys() else there - here  # a ring meshes beyond the pin
    return between / abs(between)


def plane_counts(epicyclic: Epicyclic) -> dict[str, int]:
    """Return gear -> how many face widths long it is: a long planet lies in several planes [-].

    Args:
        epicyclic: As in the design.
    """
    return {gear: len(keys) for gear, keys in planes(epicyclic.compound).items()}
