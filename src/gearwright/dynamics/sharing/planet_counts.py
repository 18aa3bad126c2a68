"""A design's planetary set with other numbers of planets: K_γ of random errors beside the closed form of one pin."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.dynamics.assembly import gear_pairs
from gearwright.dynamics.model import Member, PlanetarySet
from gearwright.dynamics.sharing.of_design import SharingProblem
from gearwright.dynamics.sharing.planets import PlanetSharing, PlanetTolerances, planet_sharing
from gearwright.identity import Role, Row, gear_part, mesh_part
from gearwright.parts.planetary import pin_error_share
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.sizing import Sizing, planet_positions

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
