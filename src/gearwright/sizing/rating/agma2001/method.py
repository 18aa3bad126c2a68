"""AGMA 2001 as a method of rating."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from gearwright.arrays import Floats
from gearwright.checks import Check
from gearwright.errors import Problem
from gearwright.identity import PartId
from gearwright.parts.agma2001 import (
    AgmaDuty,
    AgmaMaking,
    AgmaPairRating,
    greatest_velocity,
    rate_agma,
)
from gearwright.parts.gears import Numbers
from gearwright.parts.iso6336 import StressBin, damage_part, spectrum_damage
from gearwright.sizing.rating.agma2001.inputs import hobbed_pair, making_of
from gearwright.sizing.rating.agma2001.record import Agma2001Rating
from gearwright.sizing.rating.agma2001.yielding import worst_yielding, yielding_checks
from gearwright.sizing.rating.factors import Factor, factor_rows
from gearwright.sizing.rating.protocol import ClassDamage, Load, LoadedMesh, Making, MeshSpectrum
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.search import module_for, untabulated
from gearwright.sizing.rating.standard_teeth import widest_ratio
from gearwright.spec.missions import GearLifeRules


class Agma2001:
    """External spur and helical gears."""

    edition = "ANSI/AGMA 2001-D04"
    peaks = "K_o K_v"
    life_source = "Miner, AGMA 2001-D04, clause 17"
    safeties: Mapping[str, tuple[str, ...]] = MappingProxyType(
        {"pitting": ("agma2001", "pitting_safety"), "bending": ("agma2001", "bending_safety")}
    )

    def refuse(self, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
        """Yield pinions with more teeth than their wheels, and fewer teeth than the table of its size factor has."""
        yield from untabulated(rating, teeth)
        if teeth[0] > teeth[1]:
            message = f"{teeth[0]} teeth drive or meet {teeth[1]}; AGMA 2001 calls the smaller gear pinion, name it so"
            yield Problem("pinion", message)

    def width_ratio(self, rating: Rating, small: Floats, large: Floats) -> Floats:
        """Return λ of the widest gears that are allowed; the face width is narrowed later [-]."""
        return widest_ratio(rating, small)

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the modules at which S_F and S_H are the asked ones [m]."""
        rules, making = rating.rules.agma2001, making_of(rating, ask.roles)
        torque = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0], dtype=float)
        pair = hobbed_pair(ask, ask.width_ratio, rating)
        duty = _duty(rating, ask, torque, ask.speed, rating.service.life)

        def safeties_at(module: Floats) -> tuple[Floats, Floats]:
            one, other = rate_agma(pair, module, duty, making).gears
            bending = np.minimum(one.bending_safety, other.bending_safety)
            return np.asarray(bending), np.asarray(np.minimum(one.contact_safety, other.contact_safety))

        return module_for(safeties_at, torque, (rules.bending_safety, rules.pitting_safety))

    def rate(self, mesh: LoadedMesh) -> Agma2001Rating:
        """Return the factors of the heaviest case, and the safeties under all cases by Miner's sum."""
        rules, making = mesh.rating.rules.agma2001, making_of(mesh.rating, mesh.heaviest.ask.roles)
        factors = _rated(mesh, mesh.heaviest, making)
        every = [factors] if mesh.loads == (mesh.heaviest,) else [_rated(mesh, load, making) for load in mesh.loads]
        pitting = _both([_safety(every, gear, making, contact=True) for gear in (0, 1)])
        bending = _both([_safety(every, gear, making, contact=False) for gear in (0, 1)])
        return Agma2001Rating(
            case=mesh.heaviest.case,
            factors=factors,
            pitting=pitting,
            bending=bending,
            pitting_asked=rules.pitting_safety,
            bending_asked=rules.bending_safety,
            static=worst_yielding(mesh),
            yielding_asked=rules.yielding_safety,
            velocity_limit=greatest_velocity(rules.quality_number),
            module_bending=mesh.asked[0],
            module_contact=mesh.asked[1],
            bending_stress=max(float(gear.bending_stress) for gear in factors.gears),
            bending_margin=min(bending) / rules.bending_safety,
            contact_stress=max(float(gear.contact_stress) for gear in factors.gears),
            contact_margin=min(pitting) / rules.pitting_safety,
            peaks=float(factors.overload * factors.dynamic),
        )

    def reserve(self, rated: Agma2001Rating) -> float:
        """Return the factor on the loads; the contact stress grows with its root [-]."""
        return min(rated.bending_margin, rated.contact_margin**2)

    def reserve_of(self, mesh: LoadedMesh) -> float:
        """Return the same of a mesh whose record nobody reads [-]."""
        return self.reserve(self.rate(mesh))

    def damage(self, spectrum: MeshSpectrum) -> tuple[ClassDamage, ClassDamage]:
        """Return Miner's parts, with the stresses and the stress cycle factors of AGMA 2001 in each class."""
        rating, making = spectrum.rating, making_of(spectrum.rating, spectrum.ask.roles)
        pair = hobbed_pair(spectrum.ask, spectrum.face_width / spectrum.module, rating)
        duty = _duty(rating, spectrum.ask, np.asarray(spectrum.torques), np.asarray(spectrum.speeds), 1.0)
        rated = rate_agma(pair, spectrum.module, duty, making)
        first, second = (float(np.asarray(teeth)) for teeth in spectrum.ask.teeth)
        both = []
        for gear, relative in enumerate((1.0, first / second)):
            cycles = [turns * relative * spectrum.ask.passes[gear] for turns in spectrum.turns]
            modes = zip((True, False), making.curves_of(gear), strict=True)
            both.append(ClassDamage(*(
                [damage_part(turns, ratio, curve)
                 for turns, ratio in zip(cycles, _over(rated, gear, contact=mode).tolist(), strict=True)]
                for mode, curve in modes
            )))  # fmt: skip
        return both[0], both[1]

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return 1/e of the stress cycle factor below its corner [-]."""
        making = making_of(rating)
        return (making.contact_curve if mode == "pitting" else making.bending_curve).slope

    def checks(self, rated: Agma2001Rating, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
        """Yield both safeties of both gears, and whether the curve of K_v holds at this velocity."""
        for gear, pitting, bending in zip(gears, rated.pitting, rated.bending, strict=True):
            yield Check(gear, "pitting", "AGMA 2001-D04, eq. 4", pitting, rated.pitting_asked, symbol="S_H")
            yield Check(gear, "tooth root", "AGMA 2001-D04, eq. 13", bending, rated.bending_asked, symbol="S_F")
        yield from yielding_checks(rated, gears)
        speed, clause = float(rated.factors.speed), "AGMA 2001-D04, clause 8: range of K_v"
        limit = rated.velocity_limit
        yield Check(mesh, "velocity", clause, speed, limit, "velocity", at_most=True, exponent=None, symbol="v_t")

    def factors(self, rated: Agma2001Rating) -> Iterator[Factor]:
        """Yield loads, geometry factors, stresses and strengths."""
        yield from factor_rows(rated.factors, "mesh")
        if rated.static is not None:
            yield from factor_rows(rated.static, "static strength")

    def making(self, rating: Rating) -> Making:
        """Return accuracy and steel."""
        rules = rating.rules.agma2001
        hardness = "" if rules.steel == "carburised" else f", {rules.hardness_hb:g} HB"
        steel = f"{rules.steel}, grade {rules.grade}{hardness}"
        if (own := rules.wheel) is not None:
            steel += f"; wheels {own.steel}, grade {own.grade}, {own.hardness_hb:g} HB"
        return Making(f"Q_v {rules.quality_number} AGMA 2000", steel=("AGMA 2001-D04", steel))


def _duty(rating: Rating, ask: Ask, torque: Numbers, speed: Numbers, life: float) -> AgmaDuty:
    return AgmaDuty(torque, speed, life, overload=rating.service.application_factor, meshes_per_turn=ask.passes)


def _rated(mesh: LoadedMesh, load: Load, making: AgmaMaking) -> AgmaPairRating:
    pair = hobbed_pair(load.ask, mesh.face_width / mesh.module, mesh.rating)
    return rate_agma(pair, mesh.module, _duty(mesh.rating, load.ask, load.torque, load.ask.speed, load.life), making)


def _over(rated: AgmaPairRating, gear: int, *, contact: bool) -> Floats:
    """Return the stresses of one gear over their limit at a stress cycle factor of 1 [-]."""
    one = rated.gears[gear]
    if contact:
        return np.asarray(one.contact_stress * rated.contact_cycles[gear] / one.contact_limit)
    return np.asarray(one.bending_stress * rated.bending_cycles[gear] / one.bending_limit)


def _safety(every: Sequence[AgmaPairRating], gear: int, making: AgmaMaking, *, contact: bool) -> float:
    if len(every) == 1:
        one = every[0].gears[gear]
        return float(one.contact_safety if contact else one.bending_safety)
    curve = making.curves_of(gear)[0 if contact else 1]
    bins = [StressBin(float(_over(rated, gear, contact=contact)), float(rated.cycles[gear])) for rated in every]
    return spectrum_damage(bins, 1.0, curve).safety


def _both(values: Sequence[float]) -> tuple[float, float]:
    return values[0], values[1]
