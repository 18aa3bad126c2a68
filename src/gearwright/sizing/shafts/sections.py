"""Critical sections of stepped shafts with notches and safety factors, and undercuts of DIN 509."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import DesignError, smallest
from gearwright.catalogue import Undercut, undercut
from gearwright.parts import Material
from gearwright.parts.shaft_fatigue import (
    CRITERIA,
    LEAST_RADIUS,
    NO_NOTCH,
    AxialLoad,
    Concentration,
    FatigueStrength,
    Overload,
    SectionLoad,
    ShaftSection,
    ShaftSteel,
    Shoulder,
    SteelGroup,
    blank_factor,
    din743_safety,
    endurance_limit,
    fatigue_notch_factor,
    felt_concentration,
    groove_concentration,
    keyseat_concentration,
    keyway_factor,
    notch_sensitivity,
    press_fit_factor,
    section_stresses,
    spline_factor,
    stress_concentration,
    yield_safety,
)
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.result import Sizing
from gearwright.sizing.shaft_results import BuiltShaft, SectionStrength
from gearwright.sizing.shafts.stretches import Stretch
from gearwright.spec import Design
from gearwright.spec.design import ShaftRules

# ----------------------------------------------------------------------------------------------------------------------
# Undercuts of DIN 509, form F, at the shoulders that bearings lean on: where they are, if a design asks for them.
#
# Seat and shoulder of a bearing are both ground, which form F is for; the bearing's chamfer lies over it.
# ----------------------------------------------------------------------------------------------------------------------


BLUNTEST = 0.98
"""Thinner over thicker diameter above which a step is no notch [-] (DIN 743-2:2012)."""


class Cut(NamedTuple):
    """An undercut in a shaft."""

    place: float
    """Of the shoulder, from the shaft's first end [m]."""
    edge: float
    """Where it begins in the seat [m]."""
    bottom: float
    """Diameter that is left [m]."""
    standard: Undercut


def foot_of(thin: float, thick: float, rules: ShaftRules) -> Undercut | None:
    """Return the undercut between the seat of a bearing and the next step; None where there is none.

    Args:
        thin: Diameter of the seat [m].
        thick: Of the step [m].
        rules: Of the design.
    """
    asked = rules.shoulders == "undercut" and thin < BLUNTEST * thick
    return undercut(thin) if asked else None


def undercuts_of(sizing: Sizing, shaft: BuiltShaft) -> Iterator[Cut]:
    """Yield the undercuts of a built shaft.

    Args:
        sizing: As sized.
        shaft: One of its built shafts.
    """
    seats = {bearing.name for bearing in sizing.bearings}
    for left, right in pairwise(shaft.steps):
        thin, thick, way = (left, right, -1.0) if left.diameter < right.diameter else (right, left, 1.0)
        cut = foot_of(thin.diameter, thick.diameter, sizing.design.shafting) if thin.seat in seats else None
        if cut is not None:
            edge, bottom = right.start + way * cut.width, thin.diameter - 2.0 * cut.depth
            yield Cut(right.start, edge, bottom, cut)


# ----------------------------------------------------------------------------------------------------------------------
# Where a stepped shaft may break: shoulders, hubs and loads, each with its notch, and the safeties there.
# ----------------------------------------------------------------------------------------------------------------------


THINNEST = 0.97
"""Bore over diameter beyond which a section counts as if it had this wall, until it has grown [-]."""
NO_LIMIT = 99.0
"""Safety that stands for a section without load, for tables [-]."""
_BESIDE = 1e-6
"""Places of a hub that are nearer to each other are one [m]."""
HubNotch = Literal["", "key", "spline", "press-fit", "groove"]


class Section(NamedTuple):
    """A place where a shaft may break."""

    place: str
    """What notches it."""
    owner: str
    """Stretch that must be thicker if it is too weak."""
    position: float
    """[m]"""
    diameter: float
    """[m]"""
    blank: float
    """Thickest diameter of the shaft, at which it was heat treated [m]."""
    shoulder: Shoulder | None = None
    hub: HubNotch = ""
    radius: float = 0.0
    """At the bottom of a groove [m]."""


class Borne(NamedTuple):
    """How a section bears every load case."""

    loads: tuple[SectionLoad, ...]
    notch: Concentration
    """K_f and K_fs."""
    fatigue: tuple[float, ...]
    """n_f of every case [-]."""
    yielding: float
    """n_y of the greatest load [-]."""


@dataclass(frozen=True)
class Strength:
    """What every section is judged by."""

    shaft: str
    """Name of the shaft."""
    design: Design
    material: Material
    cases: tuple[str, ...]
    """Names of the load cases."""
    known: dict[tuple[object, ...], Borne] = field(default_factory=dict, compare=False, repr=False)
    """Section, moments, torques and bore -> how it bears them, as far as found: few change as a shaft grows."""
    loads: dict[tuple[float, ...], list[tuple[tuple[float, ...], tuple[float, ...]]]] = field(
        default_factory=dict, compare=False, repr=False
    )
    """Places of sections -> moments and torques of every case at each [N m], as far as found."""


def sections_of(
    stretches: Sequence[Stretch],
    forces: ShaftForces,
    hubs: Mapping[str, HubNotch],
    roots: Mapping[str, float],
    *,
    stations: Sequence[float],
    rules: ShaftRules,
) -> tuple[Section, ...]:
    """Return every section of a shaft that may break, in order along it.

    Args:
        stretches: From end to end.
        forces: What acts on the shaft.
        hubs: Hub -> how it notches the shaft.
        roots: Hub -> diameter that is left under it, of a spline [m].
        stations: Where anything acts, each once, in order [m].
        rules: Fillets or undercuts at shoulders.
    """
    blank = max(stretch.diameter for stretch in stretches)
    sections = list(_shoulders(stretches, rules, blank))
    for hub in (stretch for stretch in stretches if hubs.get(stretch.name)):
        root, kind = roots.get(hub.name, hub.diameter), hubs[hub.name]
        inside = (at for at in stations if hub.start < at < hub.end)
        sections += [
            Section(f"{kind} at {hub.name}", hub.name, at, root, blank, hub=kind)
            for at in _unlike((hub.start, (hub.start + hub.end) / 2.0, hub.end, *inside))
        ]
    for at in stations:
        on = next((stretch for stretch in stretches if stretch.start <= at <= stretch.end), stretches[-1])
        if on.kind != "integral" and not hubs.get(on.name):
            sections.append(Section(_words(on, at, forces), on.name, at, on.diameter, blank))
    return tuple(sorted(sections, key=lambda section: section.position))


def _unlike(places: Iterable[float]) -> list[float]:
    """Return places without those that are the same but for rounding."""
    apart: list[float] = []
    for place in places:
        if all(abs(place - known) > _BESIDE for known in apart):
            apart.append(place)
    return apart


def _words(stretch: Stretch, position: float, forces: ShaftForces) -> str:
    """Return what is at a section without a notch: the seat of a bearing, or what loads the shaft there."""
    if stretch.kind == "bearing":
        return f"seat of {stretch.name}"
    places = forces.plan.places
    return f"at {smallest(places, lambda part: abs(places[part] - position))}"


def _shoulders(stretches: Sequence[Stretch], rules: ShaftRules, blank: float) -> Iterator[Section]:
    for left, right in pairwise(stretches):
        thin, thick = (left, right) if left.diameter < right.diameter else (right, left)
        cut = foot_of(thin.diameter, thick.diameter, rules) if thin.kind == "bearing" else None
        if cut is not None:
            bottom = thin.diameter - 2.0 * cut.depth
            shoulder = Shoulder(bottom, thick.diameter, cut.radius, cut.depth)
            yield Section(f"undercut at {thin.name}", thin.name, right.start, bottom, blank, shoulder)
        elif thin.diameter < BLUNTEST * thick.diameter:
            sharpest = LEAST_RADIUS * (thick.diameter - thin.diameter) / 2.0
            radius = max(thin.fillet or rules.fillet_ratio * thin.diameter, sharpest)
            named = thin if thin.kind != "between" else thick
            shoulder = Shoulder(thin.diameter, thick.diameter, radius)
            yield Section(f"shoulder at {named.name}", thin.name, right.start, thin.diameter, blank, shoulder)


def borne(sections: Sequence[Section], forces: ShaftForces, judge: Strength, *, bore: float) -> tuple[Borne, ...]:
    """Return the safeties of sections against fatigue and yielding in every case.

    Args:
        sections: From `sections_of`.
        forces: What acts on the shaft.
        judge: Asked safeties and steel.
        bore: Of the shaft [m].
    """
    places = tuple([section.position for section in sections])
    loads = judge.loads.get(places)
    if loads is None:
        moments, torques = forces.moments(np.array(places))
        loads = [
            (tuple(bent), tuple(turned)) for bent, turned in zip(moments.T.tolist(), torques.T.tolist(), strict=True)
        ]
        judge.loads[places] = loads
    every = zip(sections, loads, strict=True)
    return tuple([_looked_up(section, bent, turned, judge, bore=bore) for section, (bent, turned) in every])


def strengths(
    sections: Sequence[Section], forces: ShaftForces, judge: Strength, *, bore: float
) -> tuple[SectionStrength, ...]:
    """Return the safeties of sections, each in the case that tires it most.

    Args:
        sections: From `sections_of`.
        forces: What acts on the shaft.
        judge: Asked safeties and steel.
        bore: Of the shaft [m].
    """
    every = zip(sections, borne(sections, forces, judge, bore=bore), strict=True)
    along = np.abs(forces.axial).tolist()
    return tuple(_strength(section, held, judge, along, bore=_inside(section, bore)) for section, held in every)


def _inside(section: Section, bore: float) -> float:
    """Return the bore of a section, with a wall at least until it has grown [m]."""
    return min(bore, THINNEST * section.diameter)


def _looked_up(
    section: Section, moments: tuple[float, ...], torques: tuple[float, ...], judge: Strength, *, bore: float
) -> Borne:
    key = (section, moments, torques, inside := _inside(section, bore))
    known = judge.known.get(key)
    if known is None:
        known = judge.known[key] = _borne(section, moments, torques, judge, bore=inside)
    return known


def _borne(
    section: Section, moments: Sequence[float], torques: Sequence[float], judge: Strength, *, bore: float
) -> Borne:
    rules, service, steel = judge.design.shafting, judge.design.service, judge.material
    ultimate, yielding = steel.ultimate_strength or 0.0, steel.yield_strength or 0.0
    limit = endurance_limit(ultimate, section.diameter, surface=rules.surface, reliability=rules.reliability)
    strength, notch = FatigueStrength(limit, ultimate, yielding), _felt(section, ultimate)
    criterion = CRITERIA[rules.fatigue]
    loads = tuple(
        SectionLoad(moment, 0.0, service.torque_swing * torque, torque)
        for moment, torque in zip(moments, torques, strict=True)
    )
    stresses = section_stresses(loads, section.diameter, notch, bore=bore)
    greatest = min(yield_safety(stress, strength) for stress in stresses) / service.application_factor
    return Borne(loads, notch, tuple(criterion(stress, strength) for stress in stresses), greatest)


def _strength(
    section: Section, held: Borne, judge: Strength, along: Sequence[float], *, bore: float
) -> SectionStrength:
    worst = int(np.argmin(held.fatigue))
    load = held.loads[worst]
    return SectionStrength(
        shaft=judge.shaft,
        place=section.place,
        case=judge.cases[worst],
        position=section.position,
        diameter=section.diameter,
        bending_moment=load.bending_amplitude,
        torque=load.torque_mean,
        bending_notch=held.notch.bending,
        torsion_notch=held.notch.torsion,
        fatigue_safety=min(held.fatigue[worst], NO_LIMIT),
        yield_safety=min(held.yielding, NO_LIMIT),
        din743_safety=_din743(section, load, judge, axial=along[worst], bore=bore),
        fillet=section.shoulder.radius if section.shoulder is not None else 0.0,
    )


def _felt(section: Section, ultimate: float) -> Concentration:
    """Return K_f and K_fs of a section; of splines and press fits the factors of DIN 743."""
    if section.shoulder is not None:
        sensitivity = notch_sensitivity(section.shoulder.radius, ultimate)
        return felt_concentration(stress_concentration(section.shoulder), sensitivity)
    if section.hub == "key":
        return keyseat_concentration(section.diameter, ultimate)
    return _measured(section, ultimate)


def _measured(section: Section, ultimate: float) -> Concentration:
    if section.hub == "groove":
        return groove_concentration(section.radius, ultimate)
    laws = {"key": keyway_factor, "spline": spline_factor, "press-fit": press_fit_factor}
    return laws[section.hub](section.diameter, ultimate) if section.hub else NO_NOTCH


def _din743(section: Section, load: SectionLoad, judge: Strength, *, axial: float, bore: float) -> float:
    """Return the safety against fatigue by DIN 743, with σ_bW = 0.5 σ_B, τ_tW = 0.3 σ_B and what pushes the shaft."""
    steel, rules = judge.material, judge.design.shafting
    ultimate, group = steel.ultimate_strength or 0.0, SteelGroup[(steel.group or "tempered").upper().replace("-", "_")]
    strengths = ShaftSteel(ultimate, steel.yield_strength or 0.0, 0.5 * ultimate, 0.3 * ultimate, group)
    left = blank_factor(section.blank, group, yielding=False)
    if section.shoulder is not None:
        yielding = strengths.yielding * blank_factor(section.blank, group, yielding=True)
        notch = fatigue_notch_factor(section.shoulder, yielding)
    else:
        notch = _measured(section, left * ultimate)
    cut = ShaftSection(section.diameter, section.blank, notch, bore=bore, hard_surface=rules.hard_surface)
    growth, pull = Overload[rules.overload.upper().replace("-", "_")], AxialLoad(mean=axial)
    try:
        safety = din743_safety(load, cut, strengths, greatest=load, overload=growth, axial=pull).fatigue
    except DesignError:
        return 0.0
    return min(safety, NO_LIMIT) if math.isfinite(safety) else NO_LIMIT
