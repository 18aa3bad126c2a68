"""A mesh rated by its standard under the load cases of the design: ISO 6336, or ISO 10300 for bevel gears."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.parts.bevel import BevelRating, rate_bevel
from gearwright.parts.iso6336 import (
    LifeCurve,
    PairRating,
    StressBin,
    Value,
    life_curves,
    rate_mesh,
    spectrum_damage,
)
from gearwright.parts.losses import OIL_DENSITY, oil_viscosity
from gearwright.parts.scuffing import SPRAY, IntegralTemperature, Oil, ScuffingMesh, integral_temperature
from gearwright.sizing.rating.context import Context, ask_of, worst_case
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.standard_teeth import (
    bevel_duty,
    bevel_pair,
    bevel_surfaces,
    cylindrical_mesh,
    duty_of,
    quality_of,
    steel_of,
)
from gearwright.spec.design import Iso6336Rules
from gearwright.train import Mesh
from gearwright.units import CELSIUS

_RZ_OVER_RA = 6.0
"""R_z over R_a of ground flanks [-] (ISO 6336-2:2019, clause 12)."""
_SQUARE_MM = 1e-6
_LEAST_TORQUE = 1e-9
"""Below it a case does no damage [N m]."""


@dataclass(frozen=True)
class MeshRating:
    """A rated mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    mesh: str
    """Such as ``first.sun-planet``."""
    case: str
    """Heaviest case."""
    factors: PairRating | BevelRating
    """In that case, over the whole life."""
    pitting: tuple[float, float]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: tuple[float, float]
    """S_F of both gears under the cases and their shares of the life [-]."""
    scuffing: IntegralTemperature | None
    """In the heaviest case; None for internal and bevel gears, which the method does not cover."""

    def gap(self, rating: Rating) -> float:
        """Return by what factor the load could grow until one asked safety is no longer met [-].

        Args:
            rating: Rules of the stage.
        """
        rules = rating.rules.iso6336
        contact = (min(self.pitting) / rules.pitting_safety) ** 2
        return min(contact, min(self.bending) / rules.bending_safety)


class _Load(NamedTuple):
    """One case as a mesh feels it."""

    case: str
    torque: Value
    """On the first gear, of one mesh, load factor included [N m]."""
    ask: Ask
    life: float
    """How long it lasts [s]."""


def rate_row(context: Context, mesh: Mesh, module: float, face_width: float) -> MeshRating | None:
    """Return the rating of one mesh of a row, or None where nothing loads it.

    Args:
        context: What sizing reads.
        mesh: A row of the train.
        module: m_n, of bevel gears m_mn [m].
        face_width: b [m].

    Source: ISO 6336-2, -3 and ISO 10300-2, -3; several cases by Miner's sum, ISO 6336-6:2019.

    Raises:
        DesignError: Teeth that the standard does not cover, with the stage.
    """
    rating, (case, per_tooth) = context.ratings[mesh.stage], worst_case(context, mesh)
    if per_tooth * context.teeth[mesh.gears[0]] <= _LEAST_TORQUE:
        return None
    rate = _rate_bevel if rating.kind == "bevel" else _rate_cylindrical
    heaviest = _load(context, mesh, case, rating.service.life)
    try:
        factors = rate(rating, heaviest, module, face_width)
        loads = [load for load in _loads(context, mesh) if load.torque > _LEAST_TORQUE]
        single = len(loads) == 1 and loads[0].case == case and loads[0].life == rating.service.life
        rated = [factors] if single else [rate(rating, load, module, face_width) for load in loads]
    except DesignError as error:
        raise DesignError(
            [Problem(f"pairs.{mesh.stage}.{problem.path}", problem.message) for problem in error.problems]
        ) from None
    pitting, bending = _safeties(rated, rating)
    return MeshRating(
        mesh.name, case, factors, pitting, bending, _scuffing(factors, rating, heaviest, module, face_width)
    )


def stresses_of(factors: PairRating | BevelRating) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the contact and the root stresses of both gears [Pa].

    Args:
        factors: A rated mesh.
    """
    contact, bending = (tuple(float(strain(factors, mode, gear).stress) for gear in (0, 1)) for mode in (0, 1))
    return (contact[0], contact[1]), (bending[0], bending[1])


def _loads(context: Context, mesh: Mesh) -> Iterator[_Load]:
    """Yield the cases that make up the life; where none is said, the heaviest lasts all of it."""
    service = context.design.service
    if not service.shares:
        case, _ = worst_case(context, mesh)
        yield _load(context, mesh, case, service.life)
    for case, share in service.shares.items():
        if share > 0.0:
            yield _load(context, mesh, case, share * service.life)


def _load(context: Context, mesh: Mesh, case: str, life: float) -> _Load:
    multiplier = abs(context.flows[case].meshes[mesh.name].multiplier)
    per_tooth = multiplier / mesh.count * context.ratings[mesh.stage].load_factor
    return _Load(case, per_tooth * context.teeth[mesh.gears[0]], ask_of(context, mesh, case, per_tooth), life)


def _rate_cylindrical(rating: Rating, load: _Load, module: float, face_width: float) -> PairRating:
    ask, steel = load.ask, steel_of(rating)
    mesh = cylindrical_mesh(ask.teeth, module, face_width, rating, internal=ask.internal)
    duty = duty_of(rating, load.torque, ask.speed, life=load.life, passes=ask.passes)
    return rate_mesh(mesh, (steel, steel), duty, quality=quality_of(rating, idlers=ask.idlers))


def _rate_bevel(rating: Rating, load: _Load, module: float, face_width: float) -> BevelRating:
    pinion_teeth, wheel_teeth = (round(float(np.asarray(tooth))) for tooth in load.ask.teeth)
    pair, steel = bevel_pair((pinion_teeth, wheel_teeth), module, face_width, rating), steel_of(rating)
    duty = bevel_duty(rating, pair, float(load.torque), float(np.asarray(load.ask.speed)))
    return rate_bevel(pair, (steel, steel), duty, load.life, surfaces=bevel_surfaces(rating))


def _safeties(rated: Sequence[PairRating | BevelRating], rating: Rating) -> list[tuple[float, float]]:
    """Return S_H and S_F of both gears, each by Miner's sum over the cases where there are several."""
    curves = life_curves(steel_of(rating))
    safeties = []
    for mode, curve in enumerate(curves):
        gears = [_safety([strain(row, mode, gear) for row in rated], curve) for gear in (0, 1)]
        safeties.append((gears[0], gears[1]))
    return safeties


class Strain(NamedTuple):
    """Stress of one gear and what it bears; numbers, or arrays over loads."""

    stress: Value
    """σ_H or σ_F [Pa]."""
    endurance: Value
    """Its limit at a life factor of 1 [Pa]."""
    permissible: Value
    """Its limit after the life of the load [Pa]."""
    cycles: Value
    """Load cycles [-]."""


def strain(rated: PairRating | BevelRating, mode: int, gear: int) -> Strain:
    """Return stress and limits of one gear of a rated mesh.

    Args:
        rated: As rated.
        mode: 0 for the flank, 1 for the root.
        gear: 0 for the first gear, 1 for the second.
    """
    if isinstance(rated, PairRating):
        if mode == 0:
            contact = rated.pitting
            stress, limit, life = contact.stresses[gear], contact.permissible[gear], rated.contact_strength[gear].life
        else:
            root = rated.bending[gear]
            stress, limit, life = root.stress, root.permissible, rated.root_strength[gear].life
    else:
        life = (rated.contact_life, rated.root_life)[mode][gear]
        if mode == 0:
            stress, limit = rated.pitting.stress, rated.pitting.permissible[gear]
        else:
            stress, limit = rated.bending[gear].stress, rated.bending[gear].permissible
    return Strain(stress, limit / life, limit, rated.cycles[gear])


def strains_under(
    rating: Rating, ask: Ask, torques: Sequence[float], *, speeds: Sequence[float], module: float, face_width: float
) -> list[tuple[Strain, Strain]]:
    """Return flank and root strain of both gears of a mesh under several loads of one second each.

    Args:
        rating: Resolved rules.
        ask: Teeth, and what kind of mesh it is.
        torques: On the first gear, of one mesh, load factor included [N m], shape (n,).
        speeds: Of the first gear against the carrier [rad/s], shape (n,).
        module: m_n, of bevel gears m_mn [m].
        face_width: b [m].

    Returns:
        For flank and root, the strains of both gears, each field with shape (n,).

    Raises:
        DesignError: Teeth that the standard does not cover.
    """
    if rating.kind == "bevel":
        singles = [
            _rate_bevel(rating, _Load("", torque, ask._replace(speed=speed), 1.0), module, face_width)
            for torque, speed in zip(torques, speeds, strict=True)
        ]
        return [(_stacked(singles, mode, 0), _stacked(singles, mode, 1)) for mode in (0, 1)]
    many = _Load("", np.asarray(torques), ask._replace(speed=np.asarray(speeds)), 1.0)
    rated = _rate_cylindrical(rating, many, module, face_width)
    return [(strain(rated, mode, 0), strain(rated, mode, 1)) for mode in (0, 1)]


def _stacked(rated: Sequence[BevelRating], mode: int, gear: int) -> Strain:
    return Strain(*(np.array(column) for column in zip(*(strain(row, mode, gear) for row in rated), strict=True)))


def _safety(strains: list[Strain], curve: LifeCurve) -> float:
    if len(strains) == 1:
        return float(strains[0].permissible / strains[0].stress)
    # Every case has its own film and hence its own limit: stresses are counted in parts of it.
    bins = [StressBin(float(load.stress / load.endurance), float(load.cycles)) for load in strains]
    return spectrum_damage(bins, 1.0, curve).safety


def _scuffing(
    factors: PairRating | BevelRating, rating: Rating, load: _Load, module: float, face_width: float
) -> IntegralTemperature | None:
    if isinstance(factors, BevelRating) or load.ask.internal:
        return None
    rules = rating.rules.iso6336
    force = float(factors.tangential_force) / face_width
    mesh = ScuffingMesh(
        cylindrical_mesh(load.ask.teeth, module, face_width, rating),
        specific_load=force * float(factors.loads.contact),
        nominal_load=force * float(factors.loads.application) * float(factors.loads.mesh_load),
        speed=float(factors.speed),
        roughness=rules.flank_roughness / _RZ_OVER_RA,
        grade=rules.tolerance_class,
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
    )
    return integral_temperature(mesh, _oil(rules))


def _oil(rules: Iso6336Rules) -> Oil:
    """The design's oil; its viscosity falls with temperature as that of a turbine oil does."""
    at_40 = rules.oil_viscosity * _SQUARE_MM
    hot = at_40 * oil_viscosity(rules.oil_temperature + CELSIUS) / oil_viscosity(40.0 + CELSIUS)
    return Oil(rules.oil_temperature, hot * OIL_DENSITY, float(rules.scuffing_stage), supply=SPRAY, viscosity_40=at_40)
