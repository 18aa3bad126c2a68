"""What all rating methods share: their protocol, the rules of a stage, and the search for a module that is safe."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Protocol, TypeVar

import numpy as np

from gearwright.base import Check, Endless, Floats, Origin, PartId, Problem, Quantity, Role, marks_of
from gearwright.catalogue import level_load_factor
from gearwright.parts import Material
from gearwright.parts.gears import FEWEST_TEETH, Numbers, ToothShift, virtual_teeth
from gearwright.parts.iso6336 import GearSteel
from gearwright.spec import Design, Epicyclic, GearRules, Pair, Planetary
from gearwright.spec.design import (
    PAIR_ROLES,
    RATINGS,
    SET_ROLES,
    CompoundShifts,
    Service,
    StageShifts,
    compound_shifts,
    split_levels,
    stage_shifts,
)
from gearwright.spec.missions import GearLifeRules
from gearwright.train import Gear, Mesh, gears_of

# ----------------------------------------------------------------------------------------------------------------------
# K_γ of every stage: as the design states it, or by how well its planets or parallel paths share their load.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_LEVEL = "level-3"
"""How planets share where nothing is said: one member floats, tolerances are close."""
PATHS = {"clocked": 1.06, "rigid": 1.20, "quill": 1.03, "floating": 1.03}
"""How parallel paths share -> K_γ of two of them [-]: 53 % in one of two clocked gearboxes (Krantz & Delgado 1996, NASA
TM-107202); 1 to 4 % over a floating pinion with soft supports (Wang et al. 2023); the others are estimates."""
_EQUAL = "all share alike"


@dataclass(frozen=True)
class LoadSharing:
    """K_γ of a stage, and by what."""

    factor: float
    """K_γ [-]."""
    words: str
    """By what, for people."""
    usual: bool = False
    """True where the design says nothing of it."""
    by_size: bool = False
    """True where it follows from the sizes of gears and their loads, by tolerances or clocking."""


def load_sharing(design: Design, name: str, planets: int | None = None) -> LoadSharing:
    """Return how a stage shares its load among planets or parallel paths, as far as it is known without its sizes.

    A method without fatigue has all share alike, as the thesis on turboprop gearboxes has it.

    Args:
        design: As read.
        name: Of a pair or set.
        planets: Of a set whose number is to be chosen, a number to look at; left out: as the design has it [-].
    """
    rules, stage = design.rules(name), design.stages[name]
    count = stage.planets if isinstance(stage, Planetary) else 1 if isinstance(stage, Pair) else stage.sets
    count = count if planets is None else planets
    if not isinstance(stage, Pair) and rules.planet_load_factors:
        return LoadSharing(rules.load_factor_of(count), f"stated for {count} planets")
    if rules.mesh_load_factor is not None:
        return LoadSharing(rules.mesh_load_factor, "stated")
    if not RATINGS[design.rating(name)].fatigue:
        return LoadSharing(1.0, _EQUAL, usual=True)
    if isinstance(stage, Pair):
        return _of_paths(design, name, stage)
    level = stage.load_sharing or USUAL_LEVEL
    if level == "tolerances":
        factor = level_load_factor(3, count)
        return LoadSharing(factor, "by the tolerances of the pins", by_size=True)
    words = f"AGMA 6123, {level.replace('-', ' ')}, {count} planets"
    return LoadSharing(level_load_factor(int(level[-1]), count), words, usual=stage.load_sharing is None)


def _of_paths(design: Design, name: str, pair: Pair) -> LoadSharing:
    """Return how a pair on a loop of parallel paths shares its load; a pair on none carries what it carries."""
    levels = split_levels(design).get(name, 0.0)
    if not levels:
        return LoadSharing(1.0, "one path")
    way = pair.load_sharing or "clocked"
    words = f"{2.0**levels:g} parallel paths, {way}"
    usual = pair.load_sharing is None
    return LoadSharing(PATHS[way] ** levels, words, usual=usual, by_size=pair.clocking is not None)


# ----------------------------------------------------------------------------------------------------------------------
# The rating rules of one stage, resolved, and what is asked of one mesh.
# ----------------------------------------------------------------------------------------------------------------------


class Proportions(Protocol):
    """How the gears of a stage are proportioned whose strength a standard checks; in the table of every standard."""

    @property
    def widest_diameters(self) -> float:
        """Largest face width over the pinion's pitch diameter [-]."""

    @property
    def widest_modules(self) -> float:
        """Largest face width over the normal module [-]."""

    @property
    def narrowest_modules(self) -> float:
        """Least face width over the normal module that is chosen [-]: 6, as faces of 6 to 12 modules are usual."""

    @property
    def standard_modules(self) -> bool:
        """Modules come from series I and II of ISO 54."""


@dataclass(frozen=True)
class Rating:
    """Gear rules in the numbers that the formulas take."""

    rules: GearRules
    method: str
    """Name of the method that rates the stage, such as ``iso6336``."""
    kind: Literal["cylindrical", "face", "bevel"]
    material: Material
    helix_angle: float
    """β, of bevel gears β_m [rad]."""
    service: Service
    shifts: StageShifts
    """Profile shifts of its gears; where its teeth are not chosen yet, those that its rules state as a number."""
    compound: CompoundShifts | None = None
    """Profile shifts of the gears of a compound set, whose meshes have some of their own; None: of any other stage."""
    load_factor: float = 1.0
    """K_γ [-]."""
    least_area: float = field(default=0.0, compare=False)
    """Face times pitch diameter of all planets of a set together, from which it is sized, as their bearings ask for it
    [m²]; no rating of a mesh reads it."""

    def of_mesh(self, mesh: Mesh) -> Rating:
        """Return the rules with the shifts and the centre distance of one mesh of the stage.

        Args:
            mesh: A row of the train.
        """
        return self if self.compound is None else replace(self, shifts=self.compound.meshes[mesh.own], compound=None)

    def shift_of(self, gear: Gear) -> ToothShift:
        """Return the profile shift of a gear of the stage.

        Args:
            gear: Of the train.
        """
        return self.shifts.of(gear.role) if self.compound is None else self.compound.gears[gear.own]

    @property
    def proportions(self) -> Proportions | None:
        """How gears of this method are proportioned; None where its own closed form says all."""
        table = RATINGS[self.method].table
        rules: Proportions | None = getattr(self.rules, table) if table else None
        return rules

    @property
    def width_is_open(self) -> bool:
        """True where the least face width that meets the safeties is looked for."""
        return self.proportions is not None and self.rules.face_width_ratio is None


def rating_of(design: Design, name: str, teeth: Mapping[str, int] | None = None) -> Rating:
    """Return the resolved rules of a stage; planetary sets are spur.

    Args:
        design: As read.
        name: Of a pair or planetary set.
        teeth: Gear -> tooth number, once they are chosen [-].

    Raises:
        DesignError: Profile shifts and centre distances that contradict each other.
    """
    rules, stage = design.rules(name), design.stages[name]
    pair = stage if isinstance(stage, Pair) else None
    helix = 0.0 if pair is None else pair.spiral_angle if pair.kind == "bevel" else rules.helix_angle
    return Rating(
        rules=rules,
        method=design.rating(name),
        kind="cylindrical" if pair is None else pair.kind,
        material=design.material(rules.material),
        helix_angle=helix,
        service=design.service,
        shifts=_open_shifts(stage, rules) if teeth is None else _shifts(design, name, teeth),
        compound=compound_shifts(design, name) if teeth is not None and name in design.epicyclics else None,
        load_factor=load_sharing(design, name).factor,
    )


def _open_shifts(stage: Pair | Planetary | Epicyclic, rules: GearRules) -> StageShifts:
    """Return the shifts that a stage surely has before its teeth are chosen: those that keep the reference centre."""
    shift: float | None = None
    if isinstance(stage, Planetary):
        shift = stage.sun_shift
    elif isinstance(stage, Pair) and stage.kind != "bevel":
        opposite = None if stage.wheel_shift is None else -stage.wheel_shift
        shift = opposite if stage.pinion_shift is None else stage.pinion_shift
    shift = rules.profile_shift if shift is None else shift
    signs = (1.0, -1.0) if isinstance(stage, Pair) else (1.0, -1.0, 1.0)
    return StageShifts(tuple(ToothShift(sign * shift + 0.0) for sign in signs))


def _shifts(design: Design, name: str, teeth: Mapping[str, int]) -> StageShifts:
    stage = design.simple_stages.get(name)
    if stage is None:
        return StageShifts()
    roles = SET_ROLES if isinstance(stage, Planetary) else PAIR_ROLES
    gears = gears_of(name, stage)
    return stage_shifts(design, name, {role: teeth[gear] for role, gear in zip(roles, gears, strict=True)})


class FarGear(NamedTuple):
    """The gear beyond an idler, as the vibration of a mesh with it takes it."""

    teeth: int
    """z, negative of an internal gear [-]."""
    role: Role
    meshes: float
    """Equal meshes that move it [-]."""
    held: bool
    bore: float | None
    """[m]"""


class Made(NamedTuple):
    """What teeth are made with once they are sized, whatever they carry then."""

    relief: float
    """C_a [m]."""
    tolerance: float
    """By how much it may miss [m]."""
    grade: float
    """Flank tolerance class [-]."""


class Ask(NamedTuple):
    """What is asked of one mesh."""

    per_tooth: Numbers
    """T/z of one mesh, its share of the load included [N m]."""
    teeth: tuple[Numbers, Numbers]
    """Tooth numbers of the two gears, the external (or smaller) one first [-]."""
    width_ratio: Numbers
    """λ = b/m_n [-]."""
    internal: bool = False
    """The second gear is internal."""
    idlers: tuple[bool, bool] = (False, False)
    """Which of the two gears is loaded on both flanks."""
    speed: Numbers = 0.0
    """Of the first gear against the carrier [rad/s]; Lewis and Hertz do not ask for it."""
    passes: tuple[float, float] = (1.0, 1.0)
    """Mates that a tooth of each gear meets in a turn [-]; Lewis and Hertz do not ask for it."""
    roles: tuple[Role, Role] = (Role.PINION, Role.WHEEL)
    """What both gears are in their stage: wheels and rings may be of a steel of their own, and have rims."""
    reverse: tuple[float, float] = (1.0, 1.0)
    """Load of the less loaded flank over that of the other, of gears that are loaded on both [-]."""
    held: tuple[bool, bool] = (False, False)
    """Which of the two gears stands still in the housing: it takes no part in the vibration of the mesh."""
    bores: tuple[float | None, float | None] = (None, None)
    """Bores of both gears, or insides of their rims, as the design gives them [m]."""
    beyond: tuple[FarGear | None, FarGear | None] = (None, None)
    """What each gear meshes with besides, where it is an idler of a pair."""
    relieved: Numbers = 0.0
    """T/z for which open tip reliefs are made: that of the case that does most damage [N m]; 0: this one."""
    fastest: Numbers = 0.0
    """Greatest speed of the first gear against the carrier, for an open flank class [rad/s]; 0: this one."""
    made: Made | None = None
    """Relief and class of teeth that are sized; None: as the rules have them."""


# ----------------------------------------------------------------------------------------------------------------------
# Every quantity of a rating as a row: the fields of its records that say where they come from.
# ----------------------------------------------------------------------------------------------------------------------


CHAPTERS: Mapping[str, str] = MappingProxyType({
    "dynamic": "dynamic factor", "face": "face load factor", "transverse": "transverse load factor",
    "loads": "load factors", "contact_strength": "strength of flanks", "pitting": "pitting",
    "root_strength": "strength of roots", "bending": "tooth root", "geometry": "pitting", "section": "tooth root",
    "tooth_root": "tooth root", "strength": "strength", "gears": "stresses", "wheel_strength": "strength of the wheel",
    "scuffing": "scuffing",
})  # fmt: skip
"""Field that holds records -> chapter of their rows; others stand in the chapter around them."""
_HIDDEN = ("virtual",)
"""Fields whose records are geometry, shown elsewhere."""


@dataclass(frozen=True)
class Factor:
    """A quantity of both gears, or of the mesh."""

    chapter: str
    quantity: str
    """In words."""
    equation: str
    """Symbol, or the equation that makes it."""
    values: tuple[Any, ...]
    """Of first and second gear, or one of the mesh; more are one list [SI]."""
    dimension: str
    clause: str
    limit: str = ""
    """Limit of the standard at which it stands; empty where it stands at none that is known."""


def factor_rows(record: object, chapter: str) -> Iterator[Factor]:
    """Yield a row for every field that says where it comes from, and look inside records and pairs of them.

    Args:
        record: A dataclass.
        chapter: Of its rows.
    """
    marks = marks_of(type(record))
    for part in fields(record):  # type: ignore[arg-type]
        value, mark = getattr(record, part.name), marks[part.name]
        inner = CHAPTERS.get(part.name, chapter)
        if is_dataclass(value):
            yield from factor_rows(value, inner) if part.name not in _HIDDEN else ()
        elif isinstance(value, tuple) and value and is_dataclass(value[0]):
            yield from map(_side_by_side, factor_rows(value[0], inner), factor_rows(value[1], inner))
        elif (origin := mark.origin) is not None and value is not None:
            values = value if isinstance(value, tuple) else (value,)
            words = part.name.replace("_", " ")
            yield Factor(chapter, words, origin.equation, values, mark.dimension or "number", origin.source)


def steel_rows(steel: GearSteel) -> Iterator[Factor]:
    """Yield the strengths of a steel, each with where it comes from: the rows of a table, or who states it.

    Args:
        steel: As it is rated.
    """
    for row in factor_rows(steel, "steel"):
        yield replace(row, clause=steel.source or row.clause)


def _side_by_side(first: Factor, second: Factor) -> Factor:
    """Return one row of the same quantity of both gears."""
    return Factor(
        first.chapter, first.quantity, first.equation, (*first.values, *second.values), first.dimension, first.clause
    )


# ----------------------------------------------------------------------------------------------------------------------
# What a method of rating gears does, and what it is asked: the protocol that every method follows.
#
# A method has a folder of its own beside this file, and yields its own record, whose fields carry its equations and
# sources. Nothing outside the folders knows one by name: who needs a method asks `methods.method_for`.
# ----------------------------------------------------------------------------------------------------------------------


WEAR = 6.6
"""Power of the torque with which flanks are damaged, where cases are told apart by what they do [-]: half of the 13.2
of case-hardened steel (ISO 6336-2:2019, table 2)."""
LEAST_TORQUE = 1e-9
"""Below it a case does no damage [N m]."""


class Load(NamedTuple):
    """One load case as a mesh feels it."""

    case: str
    torque: Any
    """On the first gear, of one mesh, load factor included [N m]."""
    ask: Ask
    life: float
    """How long it lasts [s]."""
    static: bool = False
    """A limit load: it comes once, and static strength bears it."""


class LoadedMesh(NamedTuple):
    """A sized mesh with its loads."""

    rating: Rating
    """Rules of its stage."""
    module: Any
    """m_n, of bevel gears m_mn; a number, or an array where `nearness` is asked [m]."""
    face_width: Any
    """b [m]."""
    heaviest: Load
    """The heaviest case over the whole life."""
    loads: tuple[Load, ...]
    """The cases that make up the life; the heaviest alone where the design gives no shares."""
    asked: tuple[float, float]
    """Modules that bending and contact ask for [m]."""
    others: tuple[Load, ...] = ()
    """Cases that last but of which no share is said: they count for resonance alone."""


class SizesNear(NamedTuple):
    """How near arrays of sizes come to what is asked of a mesh."""

    strength: Floats
    """By what factor the loads could grow, about; 1 and more where strengths are met [-]."""
    rest: Floats
    """Least value over limit of all else [-]."""


class MeshSpectrum(NamedTuple):
    """What flights ask of a mesh, class by class."""

    rating: Rating
    """Rules of its stage; K_A is 1."""
    ask: Ask
    """Teeth, and what kind of mesh it is."""
    module: float
    """m_n, of bevel gears m_mn [m]."""
    face_width: float
    """b [m]."""
    torques: Sequence[float]
    """On the first gear, of one mesh, load factor included [N m]."""
    speeds: Sequence[float]
    """Of the first gear against the carrier [rad/s]."""
    turns: Sequence[float]
    """Revolutions of the first gear [-]."""
    steel: GearLifeRules
    """Of the mission, for methods that know no life."""


class Damage(NamedTuple):
    """What a spectrum does to one gear."""

    pitting: float
    """Miner's sum of the flank [-]."""
    bending: float
    """Miner's sum of the root [-]."""


class ClassDamage(NamedTuple):
    """What each class of a spectrum does to one gear, with the bits that it has alone."""

    pitting: Sequence[float]
    """Miner's parts of the flank, one for each class [-]."""
    bending: Sequence[float]
    """Miner's parts of the root [-]."""

    def within(self, start: int = 0, end: int | None = None) -> Damage:
        """Return what classes do together.

        Args:
            start: The first one.
            end: The one after the last; None: all that follow.
        """
        return Damage(sum(self.pitting[start:end]), sum(self.bending[start:end]))


class Making(NamedTuple):
    """How gears of a stage are made, as a drawing says it."""

    accuracy: str
    """Class and its standard."""
    iso_class: int | None = None
    """Flank tolerance class of ISO 1328-1, where it is one [-]."""
    roughness: tuple[float, float] | None = None
    """R_z of flank and root [m]; None where the method asks for none."""
    steel: tuple[str, str] = ("", "")
    """Whose table names it, and the steel."""
    iso_steel: GearSteel | None = None
    """Its strength by ISO 6336-5, where that is what the method reads."""


class MeshRating(Protocol):
    """A rated mesh: what every record of a method has, each with its own equations and sources.

    A margin that may be infinite is marked `Endless`; sizing refuses any other that is.
    """

    method: ClassVar[str]
    """Name of the method whose record it is; empty where nothing loads the mesh."""

    @property
    def case(self) -> str:
        """Load case that governs."""

    @property
    def module_bending(self) -> float:
        """Module that bending asks for [m]."""

    @property
    def module_contact(self) -> float:
        """Module that contact asks for [m]."""

    @property
    def bending_stress(self) -> float:
        """Of the higher stressed root [Pa]."""

    @property
    def bending_margin(self) -> float:
        """Allowable over actual bending stress, or safety over the asked one [-]; 1 is just enough."""

    @property
    def contact_stress(self) -> float:
        """Of the higher stressed flank [Pa]."""

    @property
    def contact_margin(self) -> float:
        """Allowable over actual contact stress, or safety over the asked one [-]; 1 is just enough."""

    @property
    def peaks(self) -> float:
        """Factor on the tangential force for peaks of the load that the rating has in it [-]."""


R = TypeVar("R", bound=MeshRating)


class Method(Protocol[R]):
    """A method of rating gears."""

    edition: str
    """As tables name it: ``ISO 6336, method B``."""
    peaks: str
    """Symbols of its factors for peaks of the load, such as ``K_A K_V``; empty where it has none."""
    life_source: str
    """By which lives are summed."""
    safeties: Mapping[str, tuple[str, ...]]
    """Mode of failure, ``pitting`` or ``bending`` -> where its asked safety stands under [gears]."""

    def refuse(self, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
        """Yield what it does not cover beyond what files are checked for; paths below the rules, z_2 < 0 for a ring."""

    def width_ratio(self, rating: Rating, small: Floats, large: Floats) -> Floats:
        """Return λ = b/m_n where the design gives none [-]."""

    def module(self, ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
        """Return the modules that bending and contact ask of a mesh, or of arrays of choices [m]."""

    def rate(self, mesh: LoadedMesh) -> R:
        """Return the rating of a mesh."""

    def reserve(self, rated: R) -> float:
        """Return by what factor the loads could grow until one asked safety is no longer met [-]."""

    def reserve_of(self, mesh: LoadedMesh) -> float:
        """Return the same of a mesh whose record nobody reads, as sizes are tried [-]."""

    def of_sizes(self, mesh: LoadedMesh, left_out: Collection[str]) -> SizesNear | None:
        """Return how near arrays of sizes come to what is asked, but for films; None: sizes are taken one by one."""

    def damage(self, spectrum: MeshSpectrum) -> tuple[ClassDamage, ClassDamage]:
        """Return Miner's parts of both gears."""

    def life_slope(self, rating: Rating, mode: str, steel: GearLifeRules) -> float:
        """Return p of N ~ σ^(−p) below the knee of flanks (``pitting``) or roots (``bending``) [-]."""

    def checks(self, rated: R, mesh: PartId, gears: tuple[PartId, PartId]) -> Iterator[Check]:
        """Yield every judgement on the strength of a mesh and its gears."""

    def factors(self, rated: R) -> Iterator[Factor]:
        """Yield every factor with its clause, for tables."""

    def making(self, rating: Rating) -> Making:
        """Return how the gears are made, for drawings."""


@dataclass(frozen=True)
class Unloaded:
    """A mesh that no case loads: no method has anything to say of it."""

    method: ClassVar[str] = ""
    case: str
    module_bending: Annotated[float, Quantity("length"), Origin("0", "no case loads the mesh")] = 0.0
    """[m]"""
    module_contact: Annotated[float, Quantity("length"), Origin("0", "no case loads the mesh")] = 0.0
    """[m]"""
    bending_stress: Annotated[float, Quantity("stress"), Origin("0", "no case loads the mesh")] = 0.0
    """[Pa]"""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("∞", "no case loads the mesh"), Endless()] = float("inf")
    """[-]"""
    contact_stress: Annotated[float, Quantity("stress"), Origin("0", "no case loads the mesh")] = 0.0
    """[Pa]"""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("∞", "no case loads the mesh"), Endless()] = float("inf")
    """[-]"""
    peaks: Annotated[float, Quantity("ratio"), Origin("1", "no case loads the mesh")] = 1.0
    """[-]"""


# ----------------------------------------------------------------------------------------------------------------------
# The module that meets asked safeties, for methods without a closed form.
# ----------------------------------------------------------------------------------------------------------------------


_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""
_LEAST_TORQUE = 1e-9
"""Torque per tooth below which a mesh asks for no module [N m]."""


def untabulated(rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
    """Yield external gears of a mesh with fewer teeth than the table of Lewis form factors, by their virtual number.

    Args:
        rating: Resolved rules, of a method that reads the table.
        teeth: Of both gears, negative for a ring [-].
    """
    for count in dict.fromkeys(count for count in teeth if count > 0):
        virtual = virtual_teeth(count, rating.rules.pressure_angle, rating.helix_angle)
        if virtual < FEWEST_TEETH:
            like = "" if math.isclose(virtual, count) else f", like {virtual:.3g} of a spur gear,"
            table = f"{RATINGS[rating.method].title} reads Lewis form factors, tabulated from {FEWEST_TEETH} teeth on"
            fix = 'give it more, or write rating = "iso6336"'
            yield Problem("gears", f"{table}, and a gear has {count}{like}: {fix}")


def module_for(
    safeties: Callable[[Floats], tuple[Floats, Floats]], torque: Floats, asked: tuple[float, float]
) -> tuple[Floats, Floats]:
    """Return the modules at which the asked safeties are met in bending and contact [m].

    Args:
        safeties: Modules of shape (2, *torque's) -> S_F and S_H of each at given λ [-].
        torque: On the first gear [N m].
        asked: S_F and S_H that are asked [-].

    Source: at given λ, S_F goes with m³ and S_H² with m³ but for the load factors, hence few corrections do.
    """
    if not np.any(torque > _LEAST_TORQUE):
        return np.zeros_like(torque), np.zeros_like(torque)
    wanted = np.array([asked[0], asked[1] ** 2]).reshape(2, *(1,) * torque.ndim)
    module = np.stack([np.cbrt(torque) * 1e-3 * _START] * 2)
    for _ in range(_STEPS):
        bending, contact = (np.broadcast_to(values, module.shape) for values in safeties(module))
        module = np.asarray(module * np.cbrt(wanted / np.stack([bending[0], contact[1] ** 2])))
    return module[0], module[1]


def by_teeth(
    ask: Ask, search: Callable[[tuple[int, int], float, float, float], tuple[float, float]]
) -> tuple[Floats, Floats]:
    """Return the modules of bending and contact by one search for each pair of tooth numbers, scaled to its loads [m].

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        search: Teeth, torque on the first gear [N m], its speed [rad/s] and λ -> modules of bending and contact [m].

    Source: m³ ∝ T at given teeth and λ, but for the load factors.
    """
    torque = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0], dtype=float)
    if not np.any(torque > _LEAST_TORQUE):
        return np.zeros_like(torque), np.zeros_like(torque)
    pinion, wheel, load, speed, ratio = np.broadcast_arrays(*ask.teeth, torque, ask.speed, ask.width_ratio)
    pairs, first, index = np.unique(
        np.stack([pinion.ravel(), wheel.ravel()]).astype(np.int64), axis=1, return_index=True, return_inverse=True
    )
    found = np.array(
        [
            search((int(z_1), int(z_2)), *(float(column.flat[at]) for column in (load, speed, ratio)))
            for z_1, z_2, at in zip(*pairs, first, strict=True)
        ]
    )
    scale = np.cbrt(load.ravel() / load.flat[first][index.ravel()])
    bending, contact = (found[index.ravel(), mode] * scale for mode in (0, 1))
    return bending.reshape(load.shape), contact.reshape(load.shape)
