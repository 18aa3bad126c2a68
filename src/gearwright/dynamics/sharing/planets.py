"""Load sharing against the number of planets: K_γ of many sets with random pin and tooth-thickness errors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.dynamics.equations import line_forces, redundancy
from gearwright.dynamics.model import Model, PlanetarySet, PlanetError, System, add_planetary
from gearwright.identity import Row, mesh_part
from gearwright.parts.planetary import even_positions

UNIT = 1.0
"""Size of the errors whose effect is worked out once [m]: errors act in proportion."""


@dataclass(frozen=True)
class PlanetTolerances:
    """How far planets may differ from the drawing; errors are uniform within."""

    radial: float = 0.0
    """Pin in or out [m]."""
    tangential: float = 0.0
    """Pin ahead or behind [m]."""
    tooth_thickness: float = 0.0
    """Tooth too thick or too thin [m]."""


@dataclass(frozen=True, eq=False)
class PlanetSharing:
    """Mesh load factors of many random sets."""

    planets: tuple[int, ...]
    """Numbers of planets."""
    load_factor: Floats
    """K_γ of each set [-], shape (numbers of planets, sets)."""
    seed: int
    """Of the random numbers."""

    def percentile(self, percent: float) -> dict[int, float]:
        """Return number of planets -> K_γ that so many percent of all sets stay below [-].

        Args:
            percent: 0 to 100.
        """
        rows = zip(self.planets, self.load_factor, strict=True)
        return {count: float(np.percentile(row, percent)) for count, row in rows}


def planet_sharing(
    planetary: PlanetarySet,
    tolerances: PlanetTolerances,
    *,
    force: float,
    planets: Sequence[int] = (3, 4, 5, 6, 7),
    count: int = 5000,
    seed: int = 1,
) -> PlanetSharing:
    """Return the mesh load factor K_γ of random sets for several numbers of evenly spaced planets.

    Args:
        planetary: The set; its places and errors are replaced, its supports say what floats.
        tolerances: Of every planet.
        force: Sum of the tangential forces of all planets on their pins, the same for every number [N].
        planets: Numbers of planets to look at.
        count: Random sets for each.
        seed: Of the random numbers.

    Source: force method on the lines of Lin & Parker's set; K_γ as ISO 6336-1:2006, clause 4.
    """
    factors = [
        _factors(_even(planetary, number), tolerances, force=force, count=count, seed=seed) for number in planets
    ]
    return PlanetSharing(tuple(planets), np.array(factors), seed)


def _even(planetary: PlanetarySet, number: int) -> PlanetarySet:
    linear = replace(planetary, positions=even_positions(number), phases=None, errors={}, backlash=(0.0, 0.0))
    return replace(
        linear,
        sun_mesh=replace(linear.sun_mesh, cosine=(), sine=()),
        ring_mesh=replace(linear.ring_mesh, cosine=(), sine=()),
    )


def _factors(planetary: PlanetarySet, tolerances: PlanetTolerances, *, force: float, count: int, seed: int) -> Floats:
    """Return K_γ of random sets with one number of planets; teeth may part."""
    number = len(planetary.positions)
    system = _system(planetary, force, {})
    # Backlash without end lets the closed form part teeth that the errors pull at.
    free = system.arrays._replace(backlash=np.where(_is_mesh(system), np.inf, 0.0))
    train = redundancy(replace(system, arrays=free))
    basis = np.array([_unit_errors(planetary, force, error) for error in _units(number)])
    size = np.repeat([tolerances.radial, tolerances.tangential, tolerances.tooth_thickness], number)
    draw = np.random.default_rng(seed).uniform(-1.0, 1.0, (count, len(size)))
    suns = np.array(system.labels.places_of(mesh_part("", Row.SUN_PLANET)))
    pressed = line_forces(train, (draw * size) @ basis)[:, suns]
    return np.asarray(number * np.max(pressed, axis=1) / np.sum(pressed, axis=1))


def _is_mesh(system: System) -> Bools:
    return np.array([kind == "mesh" for kind in system.labels.line_kinds])


def _units(number: int) -> list[Mapping[int, PlanetError]]:
    """Return one unit error after the other: radial, tangential, thickness, each of every planet."""
    kinds = (PlanetError(radial=UNIT), PlanetError(tangential=UNIT), PlanetError(tooth_thickness=UNIT))
    return [{planet: kind} for kind in kinds for planet in range(1, number + 1)]


def _unit_errors(planetary: PlanetarySet, force: float, error: Mapping[int, PlanetError]) -> Floats:
    """Return what a unit error puts on every line [m]."""
    arrays = _system(planetary, force, error).arrays
    sums = np.zeros(len(arrays.stiffness))
    lines = np.repeat(np.arange(len(sums)), np.diff(arrays.error.start))
    np.add.at(sums, lines, arrays.error.cosine)
    return sums


def _system(planetary: PlanetarySet, force: float, errors: Mapping[int, PlanetError]) -> System:
    """Return the set under load: sun driven, carrier held back, on the flanks that carry."""
    model = Model()
    add_planetary(model, replace(planetary, errors=errors, flank=1))
    angle = float(np.mean(np.cos(planetary.pressure_angles)))
    model.load("carrier", constant=-force * planetary.carrier.radius)
    model.load("sun", constant=force * planetary.sun.radius / (2.0 * angle))
    return model.build()
