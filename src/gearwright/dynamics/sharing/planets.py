"""Load sharing over the number of planets: K_γ under random pin position and tooth thickness errors."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.dynamics.assembly import gear_pairs
from gearwright.dynamics.equations import line_forces, redundancy
from gearwright.dynamics.model import Member, Model, PlanetarySet, PlanetError, System, add_planetary
from gearwright.dynamics.sharing.of_design import SharingProblem
from gearwright.identity import Role, Row, gear_part, mesh_part
from gearwright.parts.planetary import even_positions, pin_error_share
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import Sizing, planet_positions

# ----------------------------------------------------------------------------------------------------------------------
# Load sharing against the number of planets: K_γ of many sets with random pin and tooth-thickness errors.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# A design's planetary set with other numbers of planets: K_γ of random errors beside the closed form of one pin.
# ----------------------------------------------------------------------------------------------------------------------


_ANY = 1.0
"""Mass and inertia, on which forces that balance do not depend [kg] and [kg m²]."""


@dataclass(frozen=True, eq=False)
class PlanetCounts:
    """Mesh load factors of one set against the number of its planets."""

    stage: str
    """Planetary set."""
    tolerances: PlanetTolerances
    """The largest error of any planet in the design, of each kind."""
    random: PlanetSharing
    """Of random sets, the sun as the design supports it."""
    floating: Mapping[int, float]
    """Closed form: planets -> K_γ with one pin out of place tangentially, a member floats [-]; while all carry."""
    fixed: Mapping[int, float]
    """The same without a floating member [-]."""


def planet_counts(
    sizing: Sizing, problem: SharingProblem, *, planets: Sequence[int] = (3, 4, 5, 6, 7), seed: int = 1
) -> PlanetCounts | None:
    """Return K_γ against the number of planets; None for a stage without planets, or without errors of them.

    Args:
        sizing: What was sized.
        problem: Its sharing problem, of the stage and load case that count.
        planets: Numbers of planets; torque and gears are kept.
        seed: Of the random numbers.
    """
    tolerances = _tolerances(sizing, problem.stage)
    if problem.stage not in sizing.design.planetaries or tolerances == PlanetTolerances():
        return None
    set_ = _rigid_set(sizing, problem)
    cosine = float(np.mean(np.cos(set_.pressure_angles)))
    force = 2.0 * cosine * abs(float(np.sum(problem.train.perfect[problem.places])))
    random = planet_sharing(set_, tolerances, force=force, planets=planets, seed=seed)
    floating, fixed = (_one_pin(set_, tolerances.tangential, force, planets, floating=way) for way in (True, False))
    return PlanetCounts(problem.stage, tolerances, random, floating, fixed)


def _tolerances(sizing: Sizing, stage: str) -> PlanetTolerances:
    planetary, errors = sizing.design.planetaries.get(stage), sizing.design.errors
    numbers = range(1, (planetary.planets if planetary else 0) + 1)
    planets = [str(gear_part(stage, Role.PLANET, number=number)) for number in numbers]
    rows = [errors[name] for name in planets if name in errors]
    return PlanetTolerances(
        radial=max((abs(row.pin_radial) for row in rows), default=0.0),
        tangential=max((abs(row.pin_tangential) for row in rows), default=0.0),
        tooth_thickness=max((abs(row.tooth_thickness) for row in rows), default=0.0),
    )


def _rigid_set(sizing: Sizing, problem: SharingProblem) -> PlanetarySet:
    """Return the set with its mean stiffnesses, all rigid but for the sun's support; the ring holds the reaction."""
    stage, system = problem.stage, problem.system
    pairs, planetary = gear_pairs(sizing), sizing.design.planetaries[stage]
    rows = [mesh_part(stage, row) for row in (Row.SUN_PLANET, Row.PLANET_RING)]
    inner, outer = (pairs[str(row)] for row in rows)
    lines = [system.labels.places_of(row)[0] for row in rows]
    support = sizing.design.supports.get(planetary.sun)
    return PlanetarySet(
        sun=Member(_ANY, _ANY, inner.driver.base_radius, support=support.radial if support else math.inf),
        ring=Member(_ANY, _ANY, outer.driven.base_radius, torsion=math.inf),
        carrier=Member(_ANY, _ANY, inner.centre_distance),
        planet=Member(_ANY, _ANY, inner.driven.base_radius),
        sun_mesh=StiffnessCurve(float(system.arrays.stiffness[lines[0]])),
        ring_mesh=StiffnessCurve(float(system.arrays.stiffness[lines[1]])),
        pressure_angles=(inner.working_pressure_angle, outer.working_pressure_angle),
        positions=planet_positions(sizing.design, stage, sizing.teeth),
    )


def _one_pin(
    set_: PlanetarySet, error: float, force: float, planets: Sequence[int], *, floating: bool
) -> dict[int, float]:
    """Return planets -> K_γ of the closed form, where every planet keeps its load; without the others."""
    stiffness, angle = (set_.sun_mesh.mean, set_.ring_mesh.mean), float(np.mean(set_.pressure_angles))
    factors = {}
    for count in planets:
        share = pin_error_share(count, error, force, stiffness=stiffness, pressure_angle=angle, floating=floating)
        free = 3 if floating else 1
        if count == free:
            factors[count] = count * share
        elif count > free:
            # A neighbour loses (1 + 2 cos 2π/N) K e/F of an equal share where a member floats, K e/F where none does.
            loss = (count * share - 1.0) / (count - free)
            loss *= 1.0 + 2.0 * math.cos(2.0 * math.pi / count) if floating else 1.0
            if loss <= 1.0:
                factors[count] = count * share
    return factors
