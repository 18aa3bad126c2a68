"""Design review: every check by reserve factor, items not assessed, and one verdict.

What is judged and how is for the layers below: sizing, dynamics, mission. How it is shown is for `render`.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from gearwright.base import (
    BEYOND_SIZING,
    GEARBOX,
    Check,
    Kind,
    PartId,
    Shown,
    Status,
    accepted,
    not_assessed,
    refuse,
    unknown_waivers,
    unneeded,
    verb,
    worst,
)
from gearwright.dynamics.assembly import untold_orders
from gearwright.dynamics.sharing import sharing_checks
from gearwright.dynamics.vibration import SpeedCase, motion_checks
from gearwright.mission import Durability, Flight, durability, flight_checks, fly
from gearwright.mission.lives import (
    Assumed,
    HousingSection,
    Upkeep,
    housing_assumptions,
    housing_checks,
    known_sections,
    upkeep_checks,
    upkeep_of,
)
from gearwright.sizing import MeshSizing, Named, Sizing, size, tips_in_fillets, total_results
from gearwright.sizing.arrangement import envelope
from gearwright.sizing.bearing_seats import planet_bodies
from gearwright.sizing.losses import largest_heat
from gearwright.sizing.making import built_checks
from gearwright.sizing.mass import CompleteMass, Statistics, complete_mass, oil_flow, statistics_beside
from gearwright.sizing.rating import Unloaded
from gearwright.sizing.shafts import unsealed_exits
from gearwright.spec import Design, Mission
from gearwright.spec.design import RATINGS

# ----------------------------------------------------------------------------------------------------------------------
# What nobody assesses of a design, and why: a verdict reaches as far as what was looked at.
# ----------------------------------------------------------------------------------------------------------------------


_LIVES = "no mission is given; gearwright review DESIGN MISSION flies one"
_NO_BEARING = "the design names none: no life, no room in the rim, and no kilogram of it; gearwright close chooses one"


def open_checks(sizing: Sizing, looked_at: Iterable[Check], *, flown: bool) -> Iterator[Check]:
    """Yield what neither sizing nor motion nor a flight looks at.

    Args:
        sizing: As sized.
        looked_at: The checks of sizing, motion and flight.
        flown: True where a mission is flown.
    """
    if not flown:
        yield not_assessed(GEARBOX, "lives of gears and bearings, heat, charge", "mission", _LIVES)
    built = {shaft.name for shaft in sizing.built_shafts}
    for shaft in sizing.shafts:
        if shaft.name not in built:
            why = "the design gives it no [bearings]: no steps, bearings, joints, seals, slopes, bending modes"
            yield not_assessed(PartId(Kind.SHAFT, shaft.name), "bearings and joints", "ISO 281, ISO 76", why)
    for leaves in (one for one in unsealed_exits(sizing) if one.way or one.elastomer is None):
        yield not_assessed(PartId(Kind.MACHINE, leaves.machine), "shaft seal", "SKF, speeds of lips", leaves.lacking)
    for machine, why in untold_orders(sizing):
        yield not_assessed(PartId(Kind.MACHINE, machine), "electrical and slot orders", "", why)
    for stage in sizing.design.stages:
        yield from _teeth(sizing, stage)
    for one in tips_in_fillets(sizing):
        yield not_assessed(one.mesh.part, "tips in fillets", "ISO 21771", one.sentence)
    bearings = {str(check.part) for check in looked_at if check.part.kind is Kind.BEARING}
    for body in planet_bodies(sizing.design, sizing.gears):
        if str(body.part) not in bearings:
            yield not_assessed(body.part, "bearing of the planets", "ISO 281", _NO_BEARING)
        if len(body.steps) > 1 and not body.supports:
            why = "needs place_mm of every step, and two bearings or more; until then its whole force acts in one place"
            yield not_assessed(body.part, "moment that tilts a stepped planet", "statics", why)
    yield from _shared_axes(sizing, built)
    why = "weighed as a shell with what is on it, and held against fatigue; its stiffness, yield under limit loads,"
    yield not_assessed(GEARBOX, "housing", "", f"{why} and what heat does to clearances, are not assessed")


def _shared_axes(sizing: Sizing, built: set[str]) -> Iterator[Check]:
    """Yield the shafts of one axis of which some have no bearings, nor what is between them a length."""
    on_axis: dict[tuple[float, float], list[str]] = {}
    for name, axis in sizing.arrangement.axes.items():
        on_axis.setdefault((round(axis.real, 9), round(axis.imag, 9)), []).append(name)
    names = [name for shafts in on_axis.values() if len(shafts) > 1 and not built >= set(shafts) for name in shafts]
    if names:
        why = f"without [bearings], machines, clutches and bearings among these have no length: {', '.join(names)}"
        yield not_assessed(GEARBOX, "room of shafts on one axis", "", why)


def _teeth(sizing: Sizing, stage: str) -> Iterator[Check]:
    """Yield what is left open of the teeth of a stage."""
    part, pair = PartId(Kind.STAGE, stage), sizing.design.pairs.get(stage)
    meshes = [mesh for mesh in sizing.meshes if mesh.stage == stage]
    scuffed = {check.part for check in sizing.checks if check.mode == "scuffing"}
    open_meshes = [mesh for mesh in meshes if mesh.part not in scuffed]
    if pair is not None and pair.kind == "face":
        yield not_assessed(part, "rating of face gears", "", "no standard rates them; Lewis and Hertz stand in")
    elif not (method := RATINGS[sizing.design.rules(stage).rating]).fatigue:
        why = f'{method.title}: static strength only; rating = "iso6336" knows life, scuffing, what can be cut'
        yield not_assessed(part, "tooth fatigue and scuffing", "ISO 6336", why)
    elif method.table != "iso6336":
        why = f'{method.title} does not rate it; rating = "iso6336" does'
        yield not_assessed(part, "scuffing", "ISO/TS 6336-21", why)
    else:
        for mesh in open_meshes:
            idle = isinstance(mesh.rating, Unloaded)
            why = "no load case loads these teeth" if idle else "tips interfere, so that nothing rolls"
            yield not_assessed(mesh.part, "scuffing", "ISO/TS 6336-21", why)
        if sizing.design.rules(stage).iso6336.micropitting_stage is not None:
            yield from _without_film(meshes)


def _without_film(meshes: Iterable[MeshSizing]) -> Iterator[Check]:
    """Yield the loaded meshes whose oil was tested for micropitting, and that are not rated against it."""
    for mesh in meshes:
        rated = mesh.rating
        if isinstance(rated, Unloaded) or getattr(rated, "micropitting", None) is not None:
            continue
        if not hasattr(rated, "micropitting"):
            why = "the document is of cylindrical gears"
        elif getattr(rated, "flash", None) is None:
            why = "tips interfere, so that nothing rolls"
        else:
            why = "the document has no W_W of cast irons"
        yield not_assessed(mesh.part, "micropitting", "ISO/TS 6336-22", why)


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a design, and perhaps a mission, become one list of checks, worst first, and one verdict.
# ----------------------------------------------------------------------------------------------------------------------


class Verdict(StrEnum):
    """What a review says of a design as a whole."""

    FAILS = "fails"
    PASSES_SO_FAR = "passes as far as assessed"
    PASSES = "passes"


@dataclass(frozen=True, repr=False)
class Review(Shown):
    """Every check of a design, worst first."""

    design: str
    """Its name."""
    mission: str
    """Name of the mission that was flown; empty without one."""
    checks: tuple[Check, ...]
    """Worst first; what is not assessed comes last."""
    facts: Mapping[str, Named]
    """What the design amounts to, by name: ``mass``, ``power_density`` …"""
    complete: CompleteMass
    """What it weighs with everything in it, part by part, with its band; machines are not in it."""
    statistics: Statistics
    """What real gearboxes of its power and speeds weigh, and how the sum of its parts stands to them."""
    unneeded: tuple[str, ...] = ()
    """Waivers of what passes."""
    housing: tuple[HousingSection, ...] = ()
    """What tires the housing, section by section, the least safe first."""
    housing_assumed: tuple[Assumed, ...] = ()
    """What that rests on."""
    upkeep: tuple[Upkeep, ...] = ()
    """Maintenance, the shortest interval first."""

    @property
    def worst(self) -> Check | None:
        """The entry that every page shows; None where nothing is assessed."""
        return worst(self.checks)

    @property
    def failing(self) -> tuple[Check, ...]:
        """What fails and is not waived, worst first."""
        return tuple(check for check in self.checks if check.fails)

    @property
    def waived(self) -> tuple[Check, ...]:
        """What fails and is accepted, with the reason."""
        return tuple(check for check in self.checks if check.waiver)

    @property
    def open(self) -> tuple[Check, ...]:
        """What is not assessed, with the reason."""
        return tuple(check for check in self.checks if check.status is Status.NOT_ASSESSED)

    @property
    def verdict(self) -> Verdict:
        """One word for all of it."""
        if self.failing:
            return Verdict.FAILS
        return Verdict.PASSES_SO_FAR if self.open else Verdict.PASSES


@verb
def review(design: Design, mission: Mission | None = None, *, folder: Path | None = None) -> Review:
    """Return every check of a design: of its sizing, of its motion in every case, and of a flight if one is given.

    Args:
        design: As `gearwright.read` gives it.
        mission: What it flies; left out: lives under a mission are not assessed.
        folder: Where a propeller map is looked for that is a file.

    Raises:
        DesignError: If the design cannot be sized, the mission cannot be flown by it, or a waiver names no check.
    """
    sizing = size(design)
    if mission is None:
        return review_of(sizing)
    flight = fly(sizing, mission, folder=folder)
    return review_of(sizing, flight, durability(flight))


@verb
def review_of(
    sizing: Sizing, flight: Flight | None = None, lives: Durability | None = None, *, life: float | None = None,
    speeds: Sequence[SpeedCase] | None = None,
) -> Review:  # fmt: skip
    """Return the review of what is sized already, and perhaps flown.

    Args:
        sizing: As sized.
        flight: Of it.
        lives: Of the flight.
        life: Of gears, where another one is asked than the design's [s].
        speeds: Its `critical_speeds`, where they are known already.

    Raises:
        DesignError: If a waiver names no check.
    """
    design = sizing.design
    checks = [*sizing.checks, *built_checks(sizing), *sharing_checks(sizing), *motion_checks(sizing, speeds)]
    if flight is not None:
        lives = lives or durability(flight)
        checks += flight_checks(flight, lives, life=life)
    complete = complete_mass(sizing)
    sections, why = known_sections(sizing, flight, complete.total)
    upkeep = upkeep_of(sizing, flight, lives)
    checks += upkeep_checks(sizing, upkeep)
    checks += housing_checks(sizing, sections, mission="" if flight is None else flight.mission.name, why=why)
    checks += open_checks(sizing, tuple(checks), flown=flight is not None)
    refuse(unknown_waivers(checks, design.waivers, left=BEYOND_SIZING if flight is None else ()))
    return Review(
        design=design.name,
        mission=flight.mission.name if flight is not None else "",
        checks=accepted(checks, design.waivers),
        facts=total_results(sizing) | _masses(complete) | _sides(sizing) | _oil(sizing) | _flown(flight),
        complete=complete,
        statistics=statistics_beside(sizing, complete),
        unneeded=unneeded(checks, design.waivers),
        housing=sections,
        housing_assumed=tuple(housing_assumptions(sizing, flight)) if sections else (),
        upkeep=upkeep,
    )


def _masses(complete: CompleteMass) -> dict[str, Named]:
    """Return the sum of all parts, the limits of its band of 68 % and what the train is of it, by name."""
    low, high = complete.band
    sums = {"complete_mass": complete.total, "complete_mass.low": low, "complete_mass.high": high}
    sums["complete_mass.train"] = complete.train
    return {name: Named(mass, "mass") for name, mass in sums.items()}


def _sides(sizing: Sizing) -> dict[str, Named]:
    """Return the sides of the box around all bodies, by name."""
    box = envelope(sizing)
    return {f"envelope.{side}": Named(getattr(box, side), "length") for side in ("width", "height", "length")}


def _oil(sizing: Sizing) -> dict[str, Named]:
    """Return the heat of the hottest case that lasts, and the oil that carries it away where the gearbox has
    a pump, by name."""
    heat = largest_heat(sizing)
    facts = {"heat": Named(heat, "power")}
    if sizing.design.housing.oil_system == "own":
        facts["oil_flow"] = Named(oil_flow(sizing, heat), "oil_flow")
    return facts


def _flown(flight: Flight | None) -> dict[str, Named]:
    """Return what a flight amounts to, by name."""
    if flight is None:
        return {}
    return {
        "fuel": Named(flight.fuel, "mass"),
        "battery_energy": Named(flight.balance.battery, "electric_energy"),
        "hottest_oil": Named(flight.hottest_oil, "absolute_temperature"),
    }
