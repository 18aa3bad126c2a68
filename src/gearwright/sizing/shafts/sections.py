"""Strength of stepped shafts: joints long enough for the torque, and critical sections with notches and undercuts."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import DesignError, Problem, apart, smallest, text
from gearwright.catalogue import LENGTHS, StandardKey, Undercut, key_for_shaft, undercut
from gearwright.machines.propeller_loads import ULTIMATE
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
from gearwright.parts.shafts import (
    LONGEST_BEARING,
    MODULES,
    SHORTEST_RATIO,
    FitPart,
    Spline,
    centrifugal_loss,
    fit_interference,
    fit_pressure,
    fit_torque,
    hub_stress,
    key_length,
    key_pressure,
    shaft_fit_stress,
    spline,
    spline_length,
    spline_pressure,
)
from gearwright.sizing.airscrew_loads import LoadRow
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.result import Sizing
from gearwright.sizing.shaft_results import BuiltShaft, JointSizing, SectionStrength
from gearwright.sizing.shafts.stretches import ShaftStretch, whole_millimetres
from gearwright.spec import Design
from gearwright.spec.design import Joint, ShaftRules

# ----------------------------------------------------------------------------------------------------------------------
# What joins a gear or a machine to its shaft: a key, a spline, a press fit, long enough for the torque.
# ----------------------------------------------------------------------------------------------------------------------


KEY_PRESSURE, SPLINE_PRESSURE = 150e6, 100e6
"""Flank pressure that is allowed where the design says nothing [Pa]."""
SPLINE_TEETH = 25.0
"""Reference diameter over module of a spline, about; DIN 5480 prefers 20 to 50 teeth [-]."""
FIT_ROUGHNESS = 4e-6
"""R_z of ground seats of press fits [m]."""


class JointSeat(NamedTuple):
    """Where a joint sits."""

    part: str
    """Gear or machine."""
    shaft: str
    position: float
    """[m]"""
    hub_length: float
    """Room for the joint [m]; infinite where the design sets no limit."""
    root: float
    """Root diameter of the gear [m]; infinite for a machine."""
    torque: float
    """Largest of all cases, application factor included [N m]."""
    bore: float
    """Of the shaft [m]."""
    tooth: float
    """Height of the gear's teeth [m]."""
    speed: float = 0.0
    """Highest of all cases [rad/s]."""
    hub: Material | None = None
    """Of the gear; None: a machine, whose hub counts as the shaft's."""


def size_joint(joint: Joint, seat: JointSeat, diameter: float, steel: Material) -> JointSizing:
    """Return a joint on a shaft.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        diameter: Of the shaft [m].
        steel: Of the shaft.

    Raises:
        DesignError: If it is longer than its hub, or does not fit on the shaft; with what would do.
    """
    law = {"integral": _integral, "key": _key, "spline": _spline, "press-fit": _press_fit}[joint.kind]
    sized = law(joint, seat, diameter, steel)
    if joint.kind == "integral" or not math.isfinite(seat.root):
        return sized
    return replace(sized, rim=((seat.root - diameter) / 2.0 - keyway_depth(joint, diameter)) / seat.tooth)


def keyway_depth(joint: Joint, diameter: float) -> float:
    """Return how deep a joint cuts into its hub: t_2 of a key, else nothing [m].

    Args:
        joint: As the design gives it.
        diameter: Of the shaft [m].
    """
    return key_for_shaft(diameter).section.hub_depth if joint.kind == "key" else 0.0


def refuse_thick(sized: JointSizing, seat: JointSeat) -> None:
    """Raise where a shaft leaves nothing of its gear.

    Args:
        sized: From `size_joint`.
        seat: Where it sits.

    Raises:
        DesignError: With what would do.
    """
    if sized.rim is not None and sized.rim <= 0.0:
        message = (
            f"a {sized.kind} on {1e3 * sized.diameter:.4g} mm leaves no rim: the root circle of the gear has"
            f' {1e3 * seat.root:.4g} mm; write kind = "integral", or give more teeth or a larger module'
        )
        raise DesignError([Problem(f"joints.{seat.part}", message)])


def joint_fits(joint: Joint, seat: JointSeat, sized: JointSizing) -> bool:
    """Tell whether a thicker shaft would not help: the joint fits its hub and bears its torque.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        sized: From `size_joint`.
    """
    if joint.kind not in ("spline", "press-fit") or joint.length is not None:
        return True
    return sized.length <= seat.hub_length + 1e-9 and sized.pressure <= sized.allowed_pressure * (1.0 + 1e-9)


def refuse_long(joint: Joint, seat: JointSeat, sized: JointSizing) -> None:
    """Raise where a joint is longer than its hub, a key longer than what bears or too short for its round ends.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        sized: From `size_joint`.

    Raises:
        DesignError: With what would do.
    """
    if math.isinf(sized.pressure):
        shortest = 1e3 * key_for_shaft(sized.diameter).section.width
        message = (
            f"{1e3 * sized.length:g} mm leaves no flat flank between round ends; give more than {shortest:g} mm, or"
            ' write form = "B"'
        )
        raise DesignError([Problem(f"joints.{seat.part}.length", message)])
    room, why = seat.hub_length, "its hub has {}"
    if joint.kind == "key" and joint.length is None:
        key = key_for_shaft(sized.diameter)
        ends = key.section.width if joint.form == "A" else 0.0
        useful = min(key.longest, LONGEST_BEARING * sized.diameter + ends)
        if useful < room:
            room, why = useful, f"more than {{}} does not bear on {text(sized.diameter, 'length')}"
    if sized.length > room + 1e-9:
        asked, has = apart(sized.length, room, "length")
        message = (
            f"{sized.torque:.4g} N m ask for {asked} of {sized.designation}, but {why.format(has)};"
            f" {_instead(joint, seat, sized.diameter)}"
        )
        raise DesignError([Problem(f"joints.{seat.part}", message)])


def _sized(joint: Joint, seat: JointSeat, designation: str, diameter: float, *, length: float, pressure: float,
           allowed: float, interference: float = 0.0) -> JointSizing:  # fmt: skip
    return JointSizing(
        part=seat.part,
        shaft=seat.shaft,
        position=seat.position,
        kind=joint.kind,
        designation=designation,
        torque=seat.torque,
        diameter=diameter,
        length=length,
        pressure=pressure,
        allowed_pressure=allowed,
        interference=interference,
    )


def _integral(joint: Joint, seat: JointSeat, diameter: float, steel: Material) -> JointSizing:
    return _sized(joint, seat, "", diameter, length=0.0, pressure=0.0, allowed=0.0)


def _key(joint: Joint, seat: JointSeat, diameter: float, steel: Material) -> JointSizing:
    """Return the shortest standard key that bears the torque, or what it would have to be."""
    key, allowed = key_for_shaft(diameter), joint.pressure or KEY_PRESSURE
    ends = key.section.width if joint.form == "A" else 0.0
    shortest = max(key_length(seat.torque, diameter, key.section, allowable=allowed) + ends, key.shortest)
    length = joint.length or next((size for size in LENGTHS if size >= shortest - 1e-9), whole_millimetres(shortest))
    flank = length - ends
    pressure = key_pressure(seat.torque, diameter, key.section, bearing_length=flank) if flank > 0.0 else math.inf
    name = _key_name(key, joint.form, length)
    sized = _sized(joint, seat, name, diameter, length=length, pressure=pressure, allowed=allowed)
    return replace(sized, form=joint.form)


def _key_name(key: StandardKey, form: str, length: float) -> str:
    width, height = 1e3 * key.section.width, 1e3 * key.section.height
    return f"DIN 6885 - {form} {width:g} x {height:g} x {1e3 * length:.5g}"


def _instead(joint: Joint, seat: JointSeat, diameter: float) -> str:
    """Say what would do where a joint is too long: a spline, one piece, a longer hub."""
    teeth = _teeth(joint, diameter)
    length = _spline_length(teeth, seat, SPLINE_PRESSURE)
    if joint.kind != "spline" and length <= seat.hub_length:
        return f'a spline does with {1e3 * length:.4g} mm, {_spline_name(teeth)}: write kind = "spline"'
    return 'write kind = "integral", or give a longer hub, a wider gear or a thicker shaft by diameter_mm'


def _spline(joint: Joint, seat: JointSeat, diameter: float, steel: Material) -> JointSizing:
    teeth, allowed = _teeth(joint, diameter), joint.pressure or SPLINE_PRESSURE
    length = joint.length or _spline_length(teeth, seat, allowed)
    pressure = spline_pressure(seat.torque, teeth, length) if length else 0.0
    name = _spline_name(teeth)
    sized = _sized(joint, seat, name, diameter, length=length, pressure=pressure, allowed=allowed)
    return replace(sized, module=teeth.module)


def _teeth(joint: Joint, diameter: float) -> Spline:
    """Return the spline on a shaft, of the module that is given or that leaves about 25 teeth."""
    wanted = diameter / SPLINE_TEETH
    module = joint.module if joint.kind == "spline" and joint.module else None
    return spline(diameter, module or max((size for size in MODULES if size <= wanted + 1e-9), default=MODULES[0]))


def _spline_length(teeth: Spline, seat: JointSeat, allowed: float) -> float:
    """Return the length that the torque asks for, and as much of 0.6 d_B, which keeps a hub from rocking, as fits."""
    steady = min(SHORTEST_RATIO * teeth.reference_diameter, seat.hub_length)
    return max(whole_millimetres(spline_length(seat.torque, teeth, allowable=allowed)), steady)


def _spline_name(teeth: Spline) -> str:
    return f"DIN 5480 - W {1e3 * teeth.reference_diameter:g} x {1e3 * teeth.module:g} x {teeth.teeth}"


def spline_root(joint: Joint, diameter: float) -> float:
    """Return the root diameter that a spline leaves of its shaft [m].

    Args:
        joint: As the design gives it.
        diameter: Of the shaft [m].
    """
    return _teeth(joint, diameter).shaft_root


def hub_bore(joint: Joint, diameter: float) -> float:
    """Return what a hub slides over: its seat, of a spline the tip circle of the hub [m].

    Args:
        joint: As the design gives it.
        diameter: Of the seat [m].
    """
    return _teeth(joint, diameter).hub_tip if joint.kind == "spline" else diameter


def _press_fit(joint: Joint, seat: JointSeat, diameter: float, steel: Material) -> JointSizing:
    """Return a press fit as long as its hub that holds at speed; what the weaker of hub and shaft bears is allowed."""
    length = joint.length or (seat.hub_length if math.isfinite(seat.hub_length) else diameter)
    root = seat.root if math.isfinite(seat.root) else 2.0 * diameter
    around = seat.hub or steel
    shaft, hub = _fit_part(seat.bore / diameter, steel), _fit_part(min(diameter / root, 0.99), around)
    needed = joint.safety * seat.torque / fit_torque(1.0, diameter, length, friction=joint.friction)
    own = steel.yield_strength or 0.0
    allowed = min(own / shaft_fit_stress(1.0, shaft), (around.yield_strength or own) / hub_stress(1.0, hub))
    loosened = centrifugal_loss(seat.speed, diameter, shaft, hub)
    interference = joint.interference or fit_interference(needed, diameter, shaft, hub) + loosened
    name = f"DIN 7190 - {1e3 * diameter:.4g} with {1e6 * interference:.0f} µm"
    sized = _sized(joint, seat, name, diameter, length=length, allowed=allowed, interference=interference,
                   pressure=_fit_pressure(interference, diameter, shaft, hub))  # fmt: skip
    running = _fit_pressure(interference - loosened, diameter, shaft, hub)
    return replace(sized, running_pressure=running, needed_pressure=needed, speed=seat.speed)


def _fit_part(ratio: float, steel: Material) -> FitPart:
    return FitPart(ratio, steel.elastic_modulus, steel.poisson_ratio, FIT_ROUGHNESS, steel.density)


def _fit_pressure(interference: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the pressure in a fit, none where its parts do not touch [Pa]."""
    try:
        return fit_pressure(interference, diameter, shaft, hub)
    except DesignError:
        return 0.0


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
    return undercut(thin) if rules.shoulders == "undercut" and thin < BLUNTEST * thick else None


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


class LoadedSection(NamedTuple):
    """How a section bears every load case."""

    loads: tuple[SectionLoad, ...]
    notch: Concentration
    """K_f and K_fs."""
    fatigue: tuple[float, ...]
    """n_f of every case [-]."""
    yielding: float
    """n_y of the greatest load [-]."""
    limit: float
    """Of limit loads: the smaller of R_p0.2 over their stress, and of R_m over 1.5 times that [-]."""


@dataclass(frozen=True)
class Strength:
    """What every section is judged by."""

    shaft: str
    """Name of the shaft."""
    design: Design
    material: Material
    cases: tuple[str, ...]
    """Names of the rows of loads."""
    rows: tuple[LoadRow, ...] = ()
    """What they are; empty where each is a load case."""
    known: dict[tuple[object, ...], LoadedSection] = field(default_factory=dict, compare=False, repr=False)
    """Section, moments, torques and bore -> how it bears them, as far as found: few change as a shaft grows."""
    loads: dict[tuple[float, ...], list[tuple[tuple[float, ...], tuple[float, ...]]]] = field(
        default_factory=dict, compare=False, repr=False
    )
    """Places of sections -> moments and torques of every case at each [N m], as far as found."""


def sections_of(
    stretches: Sequence[ShaftStretch],
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


def _words(stretch: ShaftStretch, position: float, forces: ShaftForces) -> str:
    """Return what is at a section without a notch: the seat of a bearing, or what loads the shaft there."""
    if stretch.kind == "bearing":
        return f"seat of {stretch.name}"
    places = forces.plan.places
    return f"at {smallest(places, lambda part: abs(places[part] - position))}"


def _shoulders(stretches: Sequence[ShaftStretch], rules: ShaftRules, blank: float) -> Iterator[Section]:
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


def borne(
    sections: Sequence[Section], forces: ShaftForces, judge: Strength, *, bore: float
) -> tuple[LoadedSection, ...]:
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
) -> LoadedSection:
    key = (section, moments, torques, inside := _inside(section, bore))
    known = judge.known.get(key)
    if known is None:
        known = judge.known[key] = _borne(section, moments, torques, judge, bore=inside)
    return known


def _borne(
    section: Section, moments: Sequence[float], torques: Sequence[float], judge: Strength, *, bore: float
) -> LoadedSection:
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
    limits = [row.use == "limit" for row in judge.rows] or [False] * len(stresses)
    safe = [yield_safety(stress, strength) for stress in stresses]
    greatest = min((n for n, at_limit in zip(safe, limits, strict=True) if not at_limit), default=NO_LIMIT)
    least = min((n for n, at_limit in zip(safe, limits, strict=True) if at_limit), default=math.inf)
    tired = tuple(
        NO_LIMIT if at_limit else criterion(stress, strength) for stress, at_limit in zip(stresses, limits, strict=True)
    )
    broken = ultimate / (ULTIMATE * yielding) if yielding else 1.0
    return LoadedSection(loads, notch, tired, greatest / service.application_factor, least * min(1.0, broken))


def _strength(
    section: Section, held: LoadedSection, judge: Strength, along: Sequence[float], *, bore: float
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
        limit_safety=None if math.isinf(held.limit) else min(held.limit, NO_LIMIT),
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
