"""An elastic body by its mass and stiffness matrices, written as its own modes, so that the system's mass is diagonal.

With M Φ = K Φ ω⁻² and Φᵀ M Φ = m I its coordinates p have the mass m each and are held by m ω²; points of the body
move by u = Φ p, exactly, if all modes are kept. A shaft is such a body, and so is a housing that was reduced elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model.line import DampingRatio, Line
from gearwright.dynamics.model.model import Model
from gearwright.errors import by_name
from gearwright.spec.bodies import ReducedBody
from gearwright.verbs import verb

RIGID = 1e-11
"""ω² over the largest one of a body below which a mode is rigid [-]."""

Motion = Mapping[str, float]
"""Coordinate -> its weight in a displacement or a rotation."""


Point = Mapping[str, Motion]
"""Direction -> motion of one place: what bearings and meshes join."""


@dataclass(frozen=True)
class Placed:
    """A body in a model: how its places move."""

    name: str
    """As it was added."""
    places: Mapping[str, Point]
    """Station or seat -> its motion in each direction, by coordinates of the model."""

    def at(self, place: int | str) -> Point:
        """Return how a station or a seat moves, by direction: ``x``, ``y``, ``z``, ``tilt x``, ``tilt y``, ``twist``.

        Args:
            place: Station of a shaft, or the name of a seat.

        Raises:
            DesignError: If there is no such place.
        """
        return by_name(str(place), self.places, f"place of {self.name}")


class ModalBasis(NamedTuple):
    """Modes of a body, rigid ones first."""

    square: Floats
    """ω² [1/s²], shape (modes,); zero for rigid ones."""
    shapes: Floats
    """Φ, shape (coordinates, modes), of modal mass m each."""
    mass: float
    """m [kg or kg m²]."""


def modal_basis(
    mass: Floats, stiffness: Floats, *, modal_mass: float, highest: float | None = None, rigid: int | None = None
) -> ModalBasis:
    """Return the modes of a body.

    Args:
        mass: M, symmetric and positive definite [kg …].
        stiffness: K, symmetric and positive semi-definite [N/m …].
        modal_mass: m of every mode [kg or kg m²].
        highest: Modes above are left out [Hz]; None: all are kept.
        rigid: Number of motions without stiffness, where it is known; None: those below `RIGID`.

    Source: Craig & Kurdila 2006, Fundamentals of Structural Dynamics, ch. 10: eigenproblem by M = L Lᵀ.
    """
    inverse = np.linalg.inv(np.linalg.cholesky(mass))
    square, vectors = np.linalg.eigh(inverse @ (0.5 * (stiffness + stiffness.T)) @ inverse.T)
    loose = np.arange(len(square)) < rigid if rigid is not None else square < RIGID * square[-1]
    square = np.where(loose, 0.0, square)
    kept = len(square) if highest is None else int(np.sum(square <= (2.0 * np.pi * highest) ** 2))
    shapes = np.sqrt(modal_mass) * (inverse.T @ vectors[:, :kept])
    return ModalBasis(square[:kept], shapes, modal_mass)


class Spring(NamedTuple):
    """What modal coordinates are called and how they are held."""

    label: str
    """Before the number of the mode, such as ``shaft bending x``."""
    unit: str
    """``"m"`` or ``"rad"``."""
    damping: float
    """ζ of each mode that is not rigid [-]."""


def add_modes(model: Model, basis: ModalBasis, spring: Spring) -> list[str]:
    """Add a body's modal coordinates and what holds them; return their names.

    Args:
        model: That gets them.
        basis: Of the body.
        spring: Names, unit, damping.
    """
    names = [f"{spring.label} {number}" for number in range(1, 1 + len(basis.square))]
    for name, square in zip(names, basis.square.tolist(), strict=True):
        if spring.unit == "rad":
            model.rotation(name, inertia=basis.mass, speed=0.0)
        else:
            model.translation(name, mass=basis.mass)
        if square > 0.0:
            damping = DampingRatio(spring.damping)
            model.add(Line(f"{name} elastic", {name: 1.0}, basis.mass * square, damping, kind="shaft"))
    return names


def motions(names: Sequence[str], shapes: Floats, points: Iterable[tuple[str, str]]) -> dict[str, dict[str, Motion]]:
    """Return how each place moves in each direction.

    Args:
        names: Of the modal coordinates.
        shapes: A row for each point.
        points: Place and direction of each.
    """
    places: dict[str, dict[str, Motion]] = {}
    for (place, direction), row in zip(points, shapes.tolist(), strict=True):
        weights = {name: weight for name, weight in zip(names, row, strict=True) if weight}
        places.setdefault(place, {})[direction] = weights
    return places


def between(first: Motion, second: Motion | None = None) -> dict[str, float]:
    """Return the motion of one point against another's, or against the ground.

    Args:
        first: Of the point.
        second: Of the other; None: the ground.
    """
    weights = dict(first)
    for name, weight in (second or {}).items():
        weights[name] = weights.get(name, 0.0) - weight
    return weights


@verb
@one_blas_thread()
def add_body(
    model: Model, name: str, body: ReducedBody, *, damping_ratio: float = 0.0, highest: float | None = None
) -> Placed:
    """Add a housing or another elastic body by its reduced matrices; return how its places move.

    Args:
        model: That gets it.
        name: Unique name.
        body: From `read_body`.
        damping_ratio: ζ of each of its modes [-].
        highest: Modes above are left out [Hz]; None: all are kept, and the coupling is exact.

    Source: Craig & Bampton 1968, AIAA J. 6, 1313-1319, in the modes of the reduced body.
    """
    basis = modal_basis(body.mass, body.stiffness, modal_mass=1.0, highest=highest)
    names = add_modes(model, basis, Spring(f"{name} mode", "m", damping_ratio))
    return Placed(name, motions(names, basis.shapes, body.places))
