"""Rating of cylindrical gear meshes by ISO 6336, method B, with Miner sum, static cases and resonance."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Annotated, NamedTuple, Protocol

import numpy as np

from gearwright.base import Check, Floats, Origin, PartId, Problem, Quantity, Ratio, Role, SolveError, smallest
from gearwright.parts.gears import Numbers
from gearwright.parts.iso6336 import (
    FASTEST,
    RESONANCE_ENDS,
    DynamicFactorBySpeed,
    GearSteel,
    LifeCurve,
    MeshDuty,
    PairRating,
    StaticStrength,
    Steels,
    StressBin,
    Value,
    damage_part,
    endured_cycles,
    life_curves,
    outer_single_contact,
    rate_mesh,
    resonance_begins,
    root_section,
    spectrum_damage,
    static_strength,
)
from gearwright.parts.micropitting import Micropitting
from gearwright.parts.scuffing import IntegralTemperature
from gearwright.sizing.rating.geometry import cylindrical_mesh, cylindrical_teeth, ring_problems, widest_ratio
from gearwright.sizing.rating.iso6336_inputs import (
    EDITIONS,
    Beyond,
    beyond_ranges,
    clause_of,
    duty_of,
    mesh_quality,
    range_checks,
    steel_of,
    steels_of,
)
from gearwright.sizing.rating.iso6336_scuffing import (
    FlashPeak,
    film_checks,
    oil_film,
    scuffing_checks,
)
from gearwright.sizing.rating.protocol import (
    WEAR,
    Ask,
    ClassDamage,
    Factor,
    Load,
    LoadedMesh,
    Made,
    Making,
    MeshSpectrum,
    Rating,
    SizesNear,
    factor_rows,
    module_for,
    steel_rows,
)
from gearwright.spec.missions import GearLifeRules

# ----------------------------------------------------------------------------------------------------------------------
# Stresses of rated gears under many loads, their safeties over a life, and Miner's parts by ISO 6336-6.
# ----------------------------------------------------------------------------------------------------------------------


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


Strains = tuple[tuple[Strain, Strain], tuple[Strain, Strain]]
"""Of the flanks and of the roots, each of both gears."""
Both = tuple[float, float]


def of_each(strains: Strains, count: int) -> list[Strains]:
    """Return the strains of every load.

    Args:
        strains: Arrays over loads, or numbers that are the same in all.
        count: Number of loads [-].
    """
    (flank_1, flank_2), (root_1, root_2) = (tuple(_rows(strain, count) for strain in both) for both in strains)
    return [
        ((first, second), (third, fourth))
        for first, second, third, fourth in zip(flank_1, flank_2, root_1, root_2, strict=True)
    ]


def _rows(strain: Strain, count: int) -> list[Strain]:
    columns = (np.broadcast_to(values, count).tolist() for values in strain)
    return [Strain(*row) for row in zip(*columns, strict=True)]


def safeties(rated: Sequence[Strains], steels: Steels) -> tuple[Both, Both]:
    """Return S_H and S_F of both gears, each by Miner's sum over the loads where there are several [-].

    Args:
        rated: Of every load.
        steels: Of both gears.
    """
    curves = [life_curves(steel) for steel in steels]
    (flank, root) = (
        tuple(_safety([row[mode][gear] for row in rated], curves[gear][mode]) for gear in (0, 1)) for mode in (0, 1)
    )
    return (flank[0], flank[1]), (root[0], root[1])


def damages(strains: Strains, spectrum: MeshSpectrum, steels: Steels) -> tuple[ClassDamage, ClassDamage]:
    """Return Miner's parts of both gears.

    Args:
        strains: Under the loads of the spectrum, arrays over its classes.
        spectrum: With the turns of its classes.
        steels: Of both gears.
    """
    first, second = (float(np.asarray(teeth)) for teeth in spectrum.ask.teeth)
    both = []
    for gear, relative in enumerate((1.0, first / second)):
        cycles = [turns * relative * spectrum.ask.passes[gear] for turns in spectrum.turns]
        parts = zip(strains, life_curves(steels[gear]), strict=True)
        both.append(ClassDamage(*(_parts(cycles, pair[gear], curve) for pair, curve in parts)))
    return both[0], both[1]


def _safety(strains: list[Strain], curve: LifeCurve) -> float:
    if len(strains) == 1:
        return float(strains[0].permissible / strains[0].stress)
    # Every case has its own film and hence its own limit: stresses are counted in parts of it.
    bins = [StressBin(float(load.stress / load.endurance), float(load.cycles)) for load in strains]
    return spectrum_damage(bins, 1.0, curve).safety


_BESIDE = 1.01
"""Stresses over those of a size by which it is told how steeply Miner's sum grows with them [-]."""
_NONE = 1e-100
"""Cycles for none, so that what is divided by them is finite [-]."""
_FLAT = 3.0
"""Least power of the stress with which it is taken to grow [-]."""


def _room_of_sizes(factor: Floats, cycles: Floats, curve: LifeCurve) -> Floats:
    """Return about by how much stresses could grow, 1 and more where Miner's sum of a size is at most 1 [-].

    Args:
        factor: Stress over its limit at a life factor of 1, shape (loads, sizes) [-].
        cycles: Of the same shape [-].
        curve: S-N curve.
    """
    total, beside = (
        np.clip(np.sum(cycles / np.maximum(endured_cycles(curve, part * factor), _NONE), axis=0), 1e-30, 1e30)
        for part in (1.0, _BESIDE)
    )
    slope = np.maximum(np.log(beside / total) / math.log(_BESIDE), _FLAT)
    return np.asarray(total ** (-1.0 / slope))


def _parts(cycles: Sequence[float], strain: Strain, curve: LifeCurve) -> list[float]:
    """Miner's part of every class; the limits differ from class to class by the film factors."""
    stresses, limits = (np.broadcast_to(values, len(cycles)).tolist() for values in strain[:2])
    rows = zip(cycles, stresses, limits, strict=True)
    return [damage_part(turns, stress / limit, curve) for turns, stress, limit in rows]


# ----------------------------------------------------------------------------------------------------------------------
# Static cases of a mesh: limit loads that come once, held against the static strength of flanks and roots.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class StaticCase:
    """What both gears of a mesh bear in a static case."""

    case: str
    """Its name."""
    strengths: tuple[StaticStrength, StaticStrength]
    """Of both gears."""


class _StaticJudgement(NamedTuple):
    """A judgement on static strength."""

    mode: str
    clause: str
    symbol: str
    safety: float | None
    least: float


class StaticMesh(Protocol):
    """A mesh with its worst static case."""

    @property
    def static(self) -> StaticCase | None:
        """That case."""

    @property
    def static_asked(self) -> tuple[float, float, float]:
        """Least safeties [-]."""


def worst_static(mesh: LoadedMesh, rated: Sequence[tuple[str, PairRating]]) -> StaticCase | None:
    """Return the static case that comes nearest to what is asked; None where there is none.

    Args:
        mesh: As loaded.
        rated: Every static case and the mesh under it, K_A = 1.
    """
    steels = steels_of(mesh.rating, mesh.heaviest.ask.roles)
    asked = _static_asked(mesh.rating)
    cases = []
    for case, pair in rated:
        first, second = (static_strength(pair.pitting, pair.bending, steels, gear) for gear in (0, 1))
        cases.append(StaticCase(case, (first, second)))
    return smallest(cases, lambda case: _margin(case, asked)) if cases else None


def _static_asked(rating: Rating) -> tuple[float, float, float]:
    """Return the least S_H, S_F and S_y against static cases [-]."""
    rules = rating.rules.iso6336
    return rules.static_pitting_safety, rules.static_bending_safety, rules.yielding_safety


def static_checks(rated: StaticMesh, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    """Yield every judgement on static strength.

    Args:
        rated: The mesh.
        gears: Both gears.
    """
    if rated.static is None:
        return
    for gear, strength in zip(gears, rated.static.strengths, strict=True):
        for row in _judged(strength, rated.static_asked):
            yield Check(
                gear, row.mode, row.clause, row.safety, row.least, symbol=row.symbol, case=rated.static.case,
                exponent=0.5 if row.symbol == "S_H" else 1.0,
            )  # fmt: skip


def _judged(strength: StaticStrength, asked: tuple[float, float, float]) -> Iterator[_StaticJudgement]:
    flank, root = float(strength.contact_safety), float(strength.bending_safety)
    yield _StaticJudgement("static pitting", "ISO 6336-2, clauses 5 and 11", "S_H", flank, asked[0])
    yield _StaticJudgement("static tooth root", "ISO 6336-3, clauses 5 and 11", "S_F", root, asked[1])
    if strength.yielding_safety is not None:
        yielding = float(strength.yielding_safety)
        yield _StaticJudgement(
            "yielding root", "nominal stress of the critical section, R_p0.2", "S_y", yielding, asked[2]
        )


def _margin(case: StaticCase, asked: tuple[float, float, float]) -> float:
    judged = (row for strength in case.strengths for row in _judged(strength, asked))
    return min(row.safety / row.least for row in judged if row.safety is not None)


# ----------------------------------------------------------------------------------------------------------------------
# A mesh as ISO 6336 rates it.
# ----------------------------------------------------------------------------------------------------------------------


_CONTACT, _ROOT = "ISO 6336-2:2019", "ISO 6336-3:2019"


@dataclass(frozen=True)
class MeshResonance:
    """How near a mesh runs to its main resonance in a load case."""

    case: str
    """Load case."""
    ratio: Annotated[float, Quantity("ratio"), Origin("N = n_1/n_E1", "ISO 6336-1:2019, 6.5.3")]
    """Reference speed N [-]."""
    begins: Annotated[
        float, Quantity("ratio"), Origin("N_S = 0.5 + 0.35 √(F_t K_A/(100 b)) ≤ 0.85", "ISO 6336-1:2019, 6.5.3")
    ]
    """N_S at which the main resonance range begins [-]; it ends at 1.15."""

    @property
    def separation(self) -> float:
        """Distance from the main resonance |1 − N| [-]."""
        return abs(1.0 - self.ratio)

    @property
    def least(self) -> float:
        """Distance outside the main resonance range, on this side of it [-]."""
        return 1.0 - self.begins if self.ratio < 1.0 else RESONANCE_ENDS - 1.0


@dataclass(frozen=True)
class Iso6336Rating:
    """A rated mesh: the factors of its heaviest case over the whole life, and the safeties under all cases."""

    method: str
    """Name of the edition's method."""
    case: str
    """Heaviest case."""
    factors: PairRating
    """In that case, over the whole life."""
    steel: GearSteel
    """Of both gears, or of the first one."""
    mate_steel: GearSteel | None
    """Of the second gear where it is another."""
    pitting: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_H = σ_HG/σ_H; several cases: U(S_H σ_H) = 1", f"{_CONTACT}, 5.3; ISO 6336-6:2019"),
    ]
    """S_H of both gears under the cases and their shares of the life [-]."""
    bending: Annotated[
        tuple[float, float],
        Quantity("ratio"),
        Origin("S_F = σ_FG/σ_F; several cases: U(S_F σ_F) = 1", f"{_ROOT}, 5.2; ISO 6336-6:2019"),
    ]
    """S_F of both gears under the cases and their shares of the life [-]."""
    scuffing: IntegralTemperature | None
    """In the heaviest case; None for internal gears, which the method does not cover."""
    flash: FlashPeak | None
    """Scuffing by the flash temperature in the heaviest case; None for internal gears."""
    micropitting: Micropitting | None
    """In the heaviest case; None for internal gears, and where the oil's load stage is not given."""
    static: StaticCase | None
    """The static case that comes nearest to the static strength; None where no static case loads the mesh."""
    pitting_asked: Ratio
    """S_Hmin [-]."""
    bending_asked: Ratio
    """S_Fmin [-]."""
    scuffing_asked: Ratio
    """S_Smin [-]."""
    scuffing_by: str
    """Temperature that S_Smin is against: ``integral``, ``flash`` or ``both``."""
    micropitting_asked: Ratio
    """Least S_λ [-]."""
    static_asked: tuple[Ratio, Ratio, Ratio]
    """Least S_H, S_F and S_y against static cases [-]."""
    module_bending: Annotated[float, Quantity("length"), Origin("m_n at which S_F = S_Fmin", f"{_ROOT}, 5.2")]
    """Module that bending asks for [m]."""
    module_contact: Annotated[float, Quantity("length"), Origin("m_n at which S_H = S_Hmin", f"{_CONTACT}, 5.3")]
    """Module that contact asks for [m]."""
    bending_stress: Annotated[
        float, Quantity("stress"), Origin("σ_F = σ_F0 K_A K_γ K_V K_Fβ K_Fα, the larger", f"{_ROOT}, 5.2")
    ]
    """Root stress of the higher stressed gear in the heaviest case [Pa]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("S_F/S_Fmin, the smaller", f"{_ROOT}, 5.2")]
    """Safety over the asked one [-]; 1 is just enough."""
    contact_stress: Annotated[
        float, Quantity("stress"), Origin("σ_H = Z_B,D σ_H0 √(K_A K_γ K_V K_Hβ K_Hα), the larger", f"{_CONTACT}, 5.3")
    ]
    """Contact stress of the higher stressed gear in the heaviest case [Pa]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("S_H/S_Hmin, the smaller", f"{_CONTACT}, 5.3")]
    """Safety over the asked one [-]; 1 is just enough."""
    peaks: Annotated[float, Quantity("ratio"), Origin("K_A K_V", "ISO 6336-1:2019, clauses 5 and 6")]
    """Factor on the nominal force for peaks of the load in the heaviest case [-]."""
    beyond: tuple[Beyond, ...] = ()
    """What of the mesh lies beyond the ranges of the formulas."""
    resonances: tuple[MeshResonance, ...] = ()
    """N in every case that matters; empty where K_V knows no resonance (method C)."""

    @property
    def made(self) -> Made:
        """Relief and class of the teeth, whatever they carry later."""
        relief = self.factors.relief
        return Made(float(relief.amount), float(relief.tolerance), float(self.factors.grade))

    @property
    def nearest(self) -> MeshResonance | None:
        """Case in which the mesh runs nearest to its main resonance, for the range there."""
        return _nearest(self.resonances)


# ----------------------------------------------------------------------------------------------------------------------
# Whether a mesh runs in its main resonance: N of ISO 6336-1 at the speed of every case that matters.
# ----------------------------------------------------------------------------------------------------------------------


CLAUSE = "ISO 6336-1, 6.5.3: N below N_S or above 1.15"
MODE, SPEED = "main resonance", "speed of K_V"
HELPS = "other teeth, modules or speeds lie beside it; gearwright close looks for the lightest where they are open"
"""What to do about a mesh in its main resonance."""


def _nearest(found: Sequence[MeshResonance]) -> MeshResonance | None:
    """Return the case that runs nearest to the main resonance, the first of equals; None where there is none."""
    return smallest(found, lambda one: one.separation / one.least) if found else None


def resonance_checks(found: Sequence[MeshResonance], mesh: PartId) -> Iterator[Check]:
    """Yield the case in which a mesh runs nearest to its main resonance, with what it passes on the way to others.

    Args:
        found: N in every case that matters.
        mesh: The mesh.
    """
    nearest = _nearest(found)
    if nearest is None:
        return
    slow, fast = (pick(found, key=lambda one: one.ratio) for pick in (min, max))
    why = list[str]()
    if nearest.separation < nearest.least:
        why.append(HELPS)
    if slow.ratio < 1.0 < fast.ratio:
        why.append(f"passes N = 1 between {slow.case} (N {slow.ratio:.2f}) and {fast.case} (N {fast.ratio:.2f})")
    yield Check(
        mesh, MODE, CLAUSE, nearest.separation, nearest.least, "ratio", exponent=None, symbol="|1 − N|",
        place=f"N {nearest.ratio:.3f}", case=nearest.case, why="; ".join(why),
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# At which limit of the standard a factor stands: there it no longer answers to what it depends on.
# ----------------------------------------------------------------------------------------------------------------------


_WORN, _SOFT = 1200e6, 850e6
"""σ_Hlim between which the film's constants run [Pa] (ISO 6336-2, clause 12.3)."""
_FIXED: Mapping[tuple[str, str], tuple[tuple[float, str], ...]] = {
    ("dynamic factor", "slope"): ((1.0, "least: from 3 m/s"), (2.0, "greatest: up to 0.2 m/s")),
    ("load factors", "transverse contact"): ((1.0, "least"),),
    ("load factors", "transverse bending"): ((1.0, "least"),),
    ("pitting", "single contact"): ((1.0, "least: pitch point"),),
    ("strength of flanks", "work hardening"): ((1.0, "least"), (1.2, "greatest: 130 HB")),
    ("strength of flanks", "size"): ((1.0, "greatest"),),
    ("strength of roots", "size"): ((1.0, "greatest"), (0.7, "least"), (0.8, "least"), (0.85, "least")),
    ("tooth root", "rim"): ((1.0, "least: thick rim"),),
    ("tooth root", "deep tooth"): ((1.0, "greatest"), (0.7, "least")),
}
"""Chapter and quantity -> values at which it is held, and which limit each is."""
_FILM = ("lubricant", "speed", "roughness")


def limited(rows: Iterable[Factor], rated: PairRating, steels: Steels) -> Iterator[Factor]:
    """Yield the rows of a rating, each with the limit at which it stands.

    Args:
        rows: Of the rating.
        rated: That they show.
        steels: Of both gears.
    """
    own = _own_limits(rated, steels)
    for row in rows:
        known = (*_FIXED.get((row.chapter, row.quantity), ()), *own.get((row.chapter, row.quantity), ()))
        words = dict.fromkeys(
            word for value in row.values for bound, word in known if math.isclose(float(value), bound, rel_tol=1e-12)
        )
        yield replace(row, limit=", ".join(words))


def life_limits(curve: LifeCurve, cycles: float, factor: float) -> Iterator[tuple[float, str]]:
    """Yield life factors at which an S-N curve ends, and which end each is.

    Args:
        curve: Of a flank or a root.
        cycles: That it bears [-].
        factor: Its life factor there [-].
    """
    yield curve.factors[0], "greatest: static"
    if curve.fall == 0.0:
        yield curve.factors[-1], "least: borne without end"
    elif cycles > curve.cycles[-1]:
        yield factor, "beyond 1e10 cycles"


def _own_limits(rated: PairRating, steels: Steels) -> dict[tuple[str, str], tuple[tuple[float, str], ...]]:
    """Return the limits that depend on the steel."""
    limits: dict[tuple[str, str], tuple[tuple[float, str], ...]] = {}
    for mode, chapter in enumerate(("strength of flanks", "strength of roots")):
        both = rated.root_strength if mode else rated.contact_strength
        limits[chapter, "life"] = tuple(
            bound
            for steel, life, cycles in zip(steels, [strength.life for strength in both], rated.cycles, strict=True)
            for bound in life_limits(life_curves(steel)[mode], float(cycles), float(life))
        )
    softer = min(steel.contact_strength for steel in steels)
    if not _SOFT < softer < _WORN:
        end = "σ_Hlim counts as 1200" if softer >= _WORN else "σ_Hlim counts as 850"
        film = rated.contact_strength[0]
        for name in _FILM:
            limits["strength of flanks", name] = ((float(getattr(film, name)), end),)
    return limits


# ----------------------------------------------------------------------------------------------------------------------
# ISO 6336 as a method of rating.
# ----------------------------------------------------------------------------------------------------------------------


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
        teeth = cylindrical_teeth(ask.teeth, rating, internal=ask.internal)

        def safeties_at(module: Floats) -> tuple[Floats, Floats]:
            mesh, quality = (
                teeth.of_size(module, module * np.asarray(ask.width_ratio)),
                mesh_quality(rating, ask, module),
            )
            duty = duty_of(rating, torque, ask.speed, life=rating.service.life, ask=ask)
            rated = rate_mesh(mesh, steels, duty, quality=quality, edition=self._part3)
            bending = np.minimum(rated.bending[0].safety, rated.bending[1].safety)
            return np.asarray(bending), np.asarray(np.minimum(*rated.pitting.safeties))

        return module_for(safeties_at, torque, (rules.bending_safety, rules.pitting_safety))

    def rate(self, mesh: LoadedMesh) -> Iso6336Rating:
        """Return the factors of the heaviest case, and the safeties under all cases by Miner's sum (ISO 6336-6)."""
        rating, rules = mesh.rating, mesh.rating.rules.iso6336
        factors, steels = self._rated(mesh, mesh.heaviest), steels_of(rating, mesh.heaviest.ask.roles)
        alone = mesh.loads == (mesh.heaviest,)
        together = factors if alone else self._together(mesh, mesh.loads)
        pitting, bending = safeties(of_each(strains_of(together), len(mesh.loads)), steels)
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
            static_asked=_static_asked(rating),
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
            resonances=self._resonances(mesh, together),
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

    def of_sizes(self, mesh: LoadedMesh, left_out: Collection[str] = ()) -> SizesNear:
        """Return how near every size comes to what roots, flanks, resonance and static strength ask."""
        life = mesh.loads[0].life  # cases without a share count for resonance alone
        loads = (*mesh.loads, *(load._replace(life=life) for load in mesh.others))
        rules = mesh.rating.rules.iso6336
        rated, rest = self._of_sizes(mesh, loads), [np.asarray(math.inf)]
        if isinstance(rated.dynamic, DynamicFactorBySpeed):
            if SPEED not in left_out:
                rest.append(np.asarray(FASTEST / rated.dynamic.characteristic)[0])
        elif MODE not in left_out and rules.dynamic_method != "C":
            rest.append(self._apart_of_sizes(mesh, rated))
        if static := [load for load in loads if load.static]:
            rest.append(self._static_of_sizes(mesh, static))
        strength = self._strength_of_sizes(mesh, rated)
        return SizesNear(strength, np.asarray(np.minimum.reduce(np.broadcast_arrays(strength, *rest)[1:])))

    def _of_sizes(self, mesh: LoadedMesh, loads: Sequence[Load], *, once: bool = False) -> PairRating:
        """Rate every size of a mesh under some loads, in arrays of shape (loads, sizes); K_A = 1 of those that come
        once."""
        torques, speeds, lives = (
            np.stack([np.atleast_1d(np.asarray(number, dtype=float)) for number in column])
            for column in zip(*((load.torque, load.ask.speed, load.life) for load in loads), strict=True)
        )
        ask = loads[0].ask
        duty = duty_of(mesh.rating, torques, speeds, life=lives, ask=ask)
        duty = replace(duty, application_factor=1.0) if once else duty
        return self._rate(mesh.rating, ask, duty, mesh.module, mesh.face_width)

    def _strength_of_sizes(self, mesh: LoadedMesh, rated: PairRating) -> Floats:
        """Return about by what factor the loads could grow, 1 and more where Miner's sum is met [-]."""
        rules, steels = mesh.rating.rules.iso6336, steels_of(mesh.rating, mesh.heaviest.ask.roles)
        asked, count, near = (rules.pitting_safety, rules.bending_safety), len(mesh.loads), list[Floats]()
        for mode, both in enumerate(strains_of(rated)):
            for strain, steel in zip(both, steels, strict=True):
                stress, endurance, permissible, cycles = (column[:count] for column in np.broadcast_arrays(*strain))
                if count == 1:
                    room = permissible[0] / (asked[mode] * stress[0])
                else:
                    room = _room_of_sizes(asked[mode] * stress / endurance, cycles, life_curves(steel)[mode])
                near.append(room if mode else room**2)  # the contact stress grows with the root of the load
        return np.asarray(np.minimum.reduce(near))

    def _apart_of_sizes(self, mesh: LoadedMesh, rated: PairRating) -> Floats:
        """Return how far off its main resonance every size runs, over the least distance, in the nearest case [-]."""
        counting = self._resonating(mesh)
        if not counting:
            return np.array(math.inf)
        specific = rated.tangential_force / mesh.face_width * rated.loads.application * rated.loads.mesh_load
        assert not isinstance(rated.dynamic, DynamicFactorBySpeed)
        ratio, begins = np.broadcast_arrays(rated.dynamic.resonance_ratio, resonance_begins(specific))
        least = np.where(ratio < 1.0, 1.0 - begins, RESONANCE_ENDS - 1.0)
        return np.asarray(np.min((np.abs(1.0 - ratio) / least)[counting], axis=0))

    def _static_of_sizes(self, mesh: LoadedMesh, loads: Sequence[Load]) -> Floats:
        """Return the least static safety over the asked one of every size [-]."""
        rated, steels = self._of_sizes(mesh, loads, once=True), steels_of(mesh.rating, mesh.heaviest.ask.roles)
        asked = _static_asked(mesh.rating)
        strengths = [static_strength(rated.pitting, rated.bending, steels, gear) for gear in (0, 1)]
        near = [
            np.min(np.asarray(safety) / least, axis=0)
            for found in strengths
            for safety, least in zip(
                (found.contact_safety, found.bending_safety, found.yielding_safety), asked, strict=True
            )
            if safety is not None
        ]
        return np.asarray(np.minimum.reduce(near))

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
            clause = clause_of(check.clause, self._part3)
            yield check if clause is check.clause else replace(check, clause=clause)

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

    def _resonances(self, mesh: LoadedMesh, together: PairRating) -> tuple[MeshResonance, ...]:
        """Return N in every case with at least one per cent of the damage or of the life; without shares in all."""
        loads, places = [*mesh.loads, *mesh.others], self._resonating(mesh)
        if not places or mesh.rating.rules.iso6336.dynamic_method == "C":
            return ()
        if max(places) < len(mesh.loads):
            rated, rows, count = together, places, len(mesh.loads)
        else:
            rated, count = self._together(mesh, [loads[place] for place in places]), len(places)
            rows = list(range(count))
        specific = rated.tangential_force / mesh.face_width * rated.loads.application * rated.loads.mesh_load
        assert not isinstance(rated.dynamic, DynamicFactorBySpeed)
        columns = (rated.dynamic.resonance_ratio, resonance_begins(specific))
        ratios, begins = (np.broadcast_to(column, count)[rows].tolist() for column in columns)
        return tuple(map(MeshResonance, [loads[place].case for place in places], ratios, begins))

    def _resonating(self, mesh: LoadedMesh) -> list[int]:
        """Return the places of loads, one of each case, with one per cent of damage or life; all without shares."""
        loads = [*mesh.loads, *mesh.others]
        if len(loads) == 1:
            return [] if loads[0].static else [0]
        whole = sum(load.life for load in mesh.loads)
        wear = [load.life * _mean(load.ask.speed) * _mean(load.torque) ** WEAR for load in loads]
        counting = dict[str, int]()
        for place, (load, worn) in enumerate(zip(loads, wear, strict=True)):
            counts = place >= len(mesh.loads) or load.life >= _COUNTS * whole or worn >= _COUNTS * sum(wear)
            if counts and not load.static:
                counting.setdefault(load.case, place)
        return list(counting.values())

    def _rate(self, rating: Rating, ask: Ask, duty: MeshDuty, module: float, face_width: float) -> PairRating:
        steels, quality = steels_of(rating, ask.roles), mesh_quality(rating, ask, module)
        mesh = cylindrical_mesh(ask.teeth, module, face_width, rating, internal=ask.internal)
        return rate_mesh(mesh, steels, duty, quality=quality, edition=self._part3)

    def _once(self, mesh: LoadedMesh, load: Load) -> PairRating:
        """Rate a limit load: it is the peak itself, K_A = 1."""
        duty = duty_of(mesh.rating, load.torque, load.ask.speed, life=load.life, ask=load.ask)
        alone = replace(duty, application_factor=1.0)
        return self._rate(mesh.rating, load.ask, alone, mesh.module, mesh.face_width)


def _mean(values: Value) -> float:
    return float(values) if isinstance(values, float) else float(np.mean(values))


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
            SPEED,
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
