"""ISO 6336 as a method of rating."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from gearwright.arrays import Floats
from gearwright.checks import Check
from gearwright.errors import Problem, SolveError
from gearwright.identity import PartId, Role
from gearwright.parts.gears import Numbers
from gearwright.parts.iso6336 import (
    FASTEST,
    DynamicFactorBySpeed,
    GearSteel,
    MeshDuty,
    PairRating,
    life_curves,
    outer_single_contact,
    rate_mesh,
    resonance_begins,
    root_section,
)
from gearwright.sizing.rating.factors import Factor, factor_rows, steel_rows
from gearwright.sizing.rating.iso6336.inputs import EDITIONS, clause_of, duty_of, mesh_quality, steel_of, steels_of
from gearwright.sizing.rating.iso6336.limits import limited
from gearwright.sizing.rating.iso6336.miner import Strain, Strains, damages, of_each, safeties
from gearwright.sizing.rating.iso6336.ranges import Beyond, beyond_ranges, range_checks
from gearwright.sizing.rating.iso6336.record import Iso6336Rating, MeshResonance
from gearwright.sizing.rating.iso6336.resonance import resonance_checks
from gearwright.sizing.rating.iso6336.scuffing import film_checks, oil_film, scuffing_checks
from gearwright.sizing.rating.iso6336.static_cases import static_checks, worst_static
from gearwright.sizing.rating.protocol import WEAR, ClassDamage, Load, LoadedMesh, Making, MeshSpectrum
from gearwright.sizing.rating.rims import ring_problems
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.search import module_for
from gearwright.sizing.rating.standard_teeth import cylindrical_mesh, widest_ratio
from gearwright.spec.missions import GearLifeRules

SAFETIES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {"pitting": ("iso6336", "pitting_safety"), "bending": ("iso6336", "bending_safety")}
)
"""Mode -> rule of its least safety under [gears]."""


_COUNTS = 0.01
"""Part of the damage or of the life from which on a case counts for resonance [-]."""


class Iso6336:
    """Spur and helical gears, external and internal, by one edition of part 3."""

    peaks = "K_A K_V"
    life_source = "Miner, ISO 6336-6"
    safeties = SAFETIES

    def __init__(self, name: str = "iso6336", edition: str = "ISO 6336, method B") -> None:
        """Take the edition.

        Args:
            name: Of the method in files.
            edition: As tables name it.
        """
        self._name, self._part3, self.edition = name, EDITIONS[name], edition

    def refuse(self, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
        """Yield a rim that is too thin, a cutter that does not cut the ring; steels are checked as a file is read."""
        tool = rating.rules.iso6336.ring_cutter
        if teeth[1] < 0:
            yield from ring_problems(rating)
        if tool is None or teeth[1] > 0:
            return
        if tool.teeth >= -teeth[1]:
            message = f"{tool.teeth} given; a ring of {-teeth[1]} teeth is cut by fewer than it has"
            yield Problem("gears.iso6336.ring_cutter.teeth", message)
            return
        try:
            ring = outer_single_contact(cylindrical_mesh((teeth[0], -teeth[1]), 1.0, 1.0, rating, internal=True), 1)
            root_section(ring, self._part3)
        except SolveError as error:
            yield Problem("gears.iso6336.ring_cutter", str(error))

    def width_ratio(self, rating: Rating, small: Floats, large: Floats) -> Floats:
        """Return λ of the widest gears that are allowed; the face width is narrowed later [-]."""
        return widest_ratio(rating, small)

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the modules at which S_F = S_Fmin and S_H = S_Hmin [m]."""
        rules, steels = rating.rules.iso6336, steels_of(rating, ask.roles)
        torque = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0], dtype=float)

        def safeties_at(module: Floats) -> tuple[Floats, Floats]:
            width = module * np.asarray(ask.width_ratio)
            mesh = cylindrical_mesh(ask.teeth, module, width, rating, internal=ask.internal)
            duty = duty_of(rating, torque, ask.speed, life=rating.service.life, ask=ask)
            quality = mesh_quality(rating, ask, module)
            rated = rate_mesh(mesh, steels, duty, quality=quality, edition=self._part3)
            bending = np.minimum(rated.bending[0].safety, rated.bending[1].safety)
            return np.asarray(bending), np.asarray(np.minimum(*rated.pitting.safeties))

        return module_for(safeties_at, torque, (rules.bending_safety, rules.pitting_safety))

    def rate(self, mesh: LoadedMesh) -> Iso6336Rating:
        """Return the factors of the heaviest case, and the safeties under all cases by Miner's sum (ISO 6336-6)."""
        rating, rules = mesh.rating, mesh.rating.rules.iso6336
        factors, steels = self._rated(mesh, mesh.heaviest), steels_of(rating, mesh.heaviest.ask.roles)
        alone = mesh.loads == (mesh.heaviest,)
        every = [strains_of(factors)] if alone else self._strains(mesh)
        pitting, bending = safeties(every, steels)
        flanks, roots = strains_of(factors)
        film = oil_film(mesh, factors)
        return Iso6336Rating(
            method=self._name,
            case=mesh.heaviest.case,
            factors=factors,
            steel=steels[0],
            mate_steel=None if steels[1] == steels[0] else steels[1],
            pitting=pitting,
            bending=bending,
            scuffing=None if film is None else film.integral,
            flash=None if film is None else film.flash,
            micropitting=None if film is None else film.micropitting,
            static=worst_static(mesh, [(load.case, self._once(mesh, load)) for load in mesh.loads if load.static]),
            pitting_asked=rules.pitting_safety,
            bending_asked=rules.bending_safety,
            scuffing_asked=rules.scuffing_safety,
            scuffing_by=rules.scuffing_method,
            micropitting_asked=rules.micropitting_safety,
            static_asked=(rules.static_pitting_safety, rules.static_bending_safety, rules.yielding_safety),
            module_bending=mesh.asked[0],
            module_contact=mesh.asked[1],
            bending_stress=max(float(root.stress) for root in roots),
            bending_margin=min(bending) / rules.bending_safety,
            contact_stress=max(float(flank.stress) for flank in flanks),
            contact_margin=min(pitting) / rules.pitting_safety,
            peaks=float(factors.loads.application * factors.loads.dynamic),
            beyond=tuple(
                replace(entry, clause=clause_of(entry.clause, self._part3)) for entry in _beyond(mesh, factors)
            ),
            resonances=self._resonances(mesh),
        )

    def reserve(self, rated: Iso6336Rating) -> float:
        """Return the factor on the loads; the contact stress grows with its root [-]."""
        return min(rated.bending_margin, rated.contact_margin**2)

    def reserve_of(self, mesh: LoadedMesh) -> float:
        """Return the factor on the loads without films and static strength, which it does not ask for [-]."""
        rules, alone = mesh.rating.rules.iso6336, mesh.loads == (mesh.heaviest,)
        every = [strains_of(self._rated(mesh, mesh.heaviest))] if alone else self._strains(mesh)
        pitting, bending = safeties(every, steels_of(mesh.rating, mesh.heaviest.ask.roles))
        return min(min(bending) / rules.bending_safety, (min(pitting) / rules.pitting_safety) ** 2)

    def damage(self, spectrum: MeshSpectrum) -> tuple[ClassDamage, ClassDamage]:
        """Return Miner's parts by ISO 6336-6, with the stresses of ISO 6336-2 and -3 in each class."""
        speeds = np.asarray(spectrum.speeds)
        duty = duty_of(spectrum.rating, spectrum.torques, speeds, life=1.0, ask=spectrum.ask)
        rated = self._rate(spectrum.rating, spectrum.ask, duty, spectrum.module, spectrum.face_width)
        return damages(strains_of(rated), spectrum, steels_of(spectrum.rating, spectrum.ask.roles))

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return p of the S-N curve of the steel [-]."""
        return life_slope(rating, mode)

    def checks(self, rated: Iso6336Rating, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
        """Yield both safeties of both gears, resonance, films, static strength and what lies beyond ranges."""
        for check in _judgements(rated, mesh, gears):
            yield replace(check, clause=clause_of(check.clause, self._part3))

    def factors(self, rated: Iso6336Rating) -> Iterator[Factor]:
        """Yield steel, loads, flanks, roots and scuffing."""
        yield from steel_rows(rated.steel)
        if rated.mate_steel is not None:
            yield from (replace(row, chapter="steel of the second gear") for row in steel_rows(rated.mate_steel))
        steels = rated.steel, rated.mate_steel or rated.steel
        for row in limited(factor_rows(rated.factors, "mesh"), rated.factors, steels):
            yield replace(row, clause=clause_of(row.clause, self._part3))
        if rated.scuffing is not None:
            yield from factor_rows(rated.scuffing, "scuffing")
        if rated.flash is not None:
            yield from factor_rows(rated.flash, "scuffing, flash temperature")
        if rated.micropitting is not None:
            yield from factor_rows(rated.micropitting, "micropitting")
        if rated.static is not None:
            yield from factor_rows(rated.static, "static strength")

    def making(self, rating: Rating) -> Making:
        """Return flank class, roughness and steel."""
        return iso_making(rating, "ISO 1328-1", rating.rules.iso6336.tolerance_class)

    def _rated(self, mesh: LoadedMesh, load: Load) -> PairRating:
        duty = duty_of(mesh.rating, load.torque, load.ask.speed, life=load.life, ask=load.ask)
        return self._rate(mesh.rating, load.ask, duty, mesh.module, mesh.face_width)

    def _strains(self, mesh: LoadedMesh) -> list[Strains]:
        """Return stresses and limits under every load."""
        return of_each(strains_of(self._together(mesh, mesh.loads)), len(mesh.loads))

    def _together(self, mesh: LoadedMesh, loads: Sequence[Load]) -> PairRating:
        """Rate a mesh under some loads at once; teeth and mates are the same in all."""
        ask = loads[0].ask
        duty = duty_of(
            mesh.rating,
            [float(load.torque) for load in loads],
            [float(np.asarray(load.ask.speed)) for load in loads],
            life=[load.life for load in loads],
            ask=ask,
        )
        return self._rate(mesh.rating, ask, duty, mesh.module, mesh.face_width)

    def _resonances(self, mesh: LoadedMesh) -> tuple[MeshResonance, ...]:
        """Return N in every case with at least one per cent of the damage or of the life; without shares in all."""
        loads = [*mesh.loads, *mesh.others]
        whole = sum(load.life for load in mesh.loads)
        wear = [load.life * float(np.asarray(load.ask.speed)) * load.torque**WEAR for load in loads]
        counting = dict[str, Load]()
        for load, worn in zip(loads, wear, strict=True):
            counts = load in mesh.others or load.life >= _COUNTS * whole or worn >= _COUNTS * sum(wear)
            if counts and not load.static:
                counting.setdefault(load.case, load)
        if not counting or mesh.rating.rules.iso6336.dynamic_method == "C":
            return ()
        rated = self._together(mesh, tuple(counting.values()))
        specific = rated.tangential_force / mesh.face_width * rated.loads.application * rated.loads.mesh_load
        assert not isinstance(rated.dynamic, DynamicFactorBySpeed)
        columns = (rated.dynamic.resonance_ratio, resonance_begins(specific))
        ratios, begins = (np.broadcast_to(column, len(counting)).tolist() for column in columns)
        return tuple(map(MeshResonance, counting, ratios, begins))

    def _rate(self, rating: Rating, ask: Ask, duty: MeshDuty, module: float, face_width: float) -> PairRating:
        steels, quality = steels_of(rating, ask.roles), mesh_quality(rating, ask, module)
        mesh = cylindrical_mesh(ask.teeth, module, face_width, rating, internal=ask.internal)
        return rate_mesh(mesh, steels, duty, quality=quality, edition=self._part3)

    def _once(self, mesh: LoadedMesh, load: Load) -> PairRating:
        """Rate a limit load: it is the peak itself, K_A = 1."""
        duty = duty_of(mesh.rating, load.torque, load.ask.speed, life=load.life, ask=load.ask)
        alone = replace(duty, application_factor=1.0)
        return self._rate(mesh.rating, load.ask, alone, mesh.module, mesh.face_width)


def _judgements(rated: Iso6336Rating, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    for gear, pitting, bending in zip(gears, rated.pitting, rated.bending, strict=True):
        yield Check(gear, "pitting", "ISO 6336-2, 5.3", pitting, rated.pitting_asked, symbol="S_H")
        yield Check(gear, "tooth root", "ISO 6336-3, 5.2", bending, rated.bending_asked, symbol="S_F")
    yield from resonance_checks(rated.resonances, mesh)
    yield from scuffing_checks(rated, mesh)
    yield from film_checks(rated, mesh)
    yield from static_checks(rated, gears)
    yield from range_checks(rated.beyond, mesh)
    if isinstance(dynamic := rated.factors.dynamic, DynamicFactorBySpeed):
        clause, speed = "ISO 6336-1:2006, clause 6: range of method C", float(dynamic.characteristic)
        yield Check(
            mesh,
            "speed of K_V",
            clause,
            speed,
            FASTEST,
            "velocity",
            at_most=True,
            exponent=None,
            symbol="v z_1/100",
        )


def life_slope(rating: Rating, mode: str) -> float:
    """Return p of N ~ σ^(−p) below the knee of the S-N curve of a stage's steel [-].

    Args:
        rating: Resolved rules.
        mode: ``pitting`` or ``bending``.
    """
    return float(life_curves(steel_of(rating))[0 if mode == "pitting" else 1].slope)


def _beyond(mesh: LoadedMesh, factors: PairRating) -> tuple[Beyond, ...]:
    ask = mesh.heaviest.ask
    geometry = cylindrical_mesh(ask.teeth, mesh.module, mesh.face_width, mesh.rating, internal=ask.internal)
    films = mesh.rating.rules.iso6336.micropitting_stage is not None
    return beyond_ranges(geometry, factors, films=films)


def iso_making(rating: Rating, standard: str, iso_class: int | None) -> Making:
    """Return how gears are made that standards of ISO rate.

    Args:
        rating: Resolved rules.
        standard: Of the tolerance class.
        iso_class: The class where it is one of ISO 1328-1 [-].
    """
    rules = rating.rules.iso6336
    steel = steel_of(rating)
    words = _of_steel(steel)
    if rules.wheel is not None and rating.kind == "cylindrical":
        words += f"; wheels and rings {_of_steel(steel_of(rating, Role.WHEEL))}"
    roughness = (rules.flank_roughness, rules.root_roughness)
    accuracy = f"{rules.tolerance_class} {standard}" if rules.tolerance_class else f"by speed, {standard}"
    return Making(accuracy, iso_class, roughness, ("ISO 6336-5", words), steel)


def _of_steel(steel: GearSteel) -> str:
    return f"{steel.name} {steel.grade}, {steel.hardness:g} {steel.treatment.hardness_scale}"


def strains_of(rated: PairRating) -> Strains:
    """Return stress and limits of flanks and roots of both gears.

    Args:
        rated: One load or an array of them.
    """
    pitting = rated.pitting
    flanks = [
        Strain(pitting.stresses[gear], pitting.permissible[gear] / rated.contact_strength[gear].life,
               pitting.permissible[gear], rated.cycles[gear])
        for gear in (0, 1)
    ]  # fmt: skip
    roots = [
        Strain(root.stress, root.permissible / strength.life, root.permissible, cycles)
        for root, strength, cycles in zip(rated.bending, rated.root_strength, rated.cycles, strict=True)
    ]
    return (flanks[0], flanks[1]), (roots[0], roots[1])
