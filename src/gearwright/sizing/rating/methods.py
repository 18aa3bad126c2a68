"""All methods of rating by name: the one place that knows them, and how a stage finds its own.

A new method is a module beside this one, a line here, and its name in `spec.design.RATINGS`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Floats, Problem
from gearwright.parts.gears import Numbers
from gearwright.sizing.rating.agma2001 import Agma2001
from gearwright.sizing.rating.agma2003 import Agma2003
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.iso10300 import Iso10300
from gearwright.sizing.rating.lewis_hertz import LewisHertz
from gearwright.sizing.rating.protocol import Method
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.spec import Design

METHODS: dict[str, Method[Any]] = {
    "lewis-hertz": LewisHertz(),
    "iso6336": Iso6336(),
    "iso6336-2006": Iso6336("iso6336-2006", "ISO 6336:2006, method B"),
    "din3990": Iso6336("din3990", "DIN 3990:1987, method B"),
    "iso10300": Iso10300(),
    "agma2001": Agma2001(),
    "agma2003": Agma2003(),
}
"""Name -> method."""


def method_for(rating: Rating) -> Method[Any]:
    """Return the method that rates a stage.

    Args:
        rating: Its resolved rules.
    """
    return METHODS[rating.method]


def modules(ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
    """Return the modules that bending and contact ask of a mesh by the method of its stage [m].

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        rating: Resolved rules.
    """
    return method_for(rating).module(ask, rating)


def stage_width_ratio(rating: Rating, small: ArrayLike, large: ArrayLike) -> Floats:
    """Return λ = b/m_n of a stage [-]: given, or what its method takes.

    Args:
        rating: Resolved rules.
        small: Teeth of pinion or sun [-].
        large: Teeth of wheel or planet [-].
    """
    first, second = np.broadcast_arrays(np.asarray(small, dtype=float), np.asarray(large, dtype=float))
    if rating.rules.face_width_ratio is not None:
        return np.full(first.shape, rating.rules.face_width_ratio)
    return method_for(rating).width_ratio(rating, first, second)


def uncovered_teeth(design: Design, stage: str, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
    """Yield what the method of a stage does not cover, by its place in the file.

    Args:
        design: As read.
        stage: Of it.
        rating: Its resolved rules.
        teeth: Of a mesh of the stage, z_2 < 0 for a ring.
    """
    for problem in method_for(rating).refuse(rating, teeth):
        yield Problem(design.key_of(stage, problem.path), problem.message)
