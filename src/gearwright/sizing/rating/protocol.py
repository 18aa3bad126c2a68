"""Protocol of gear rating methods, and the quantities of a rating with their sources."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, NamedTuple, Protocol, TypeVar

from gearwright.base import Check, Endless, Floats, Origin, PartId, Problem, Quantity, marks_of
from gearwright.parts.gears import Numbers
from gearwright.parts.iso6336 import GearSteel
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.spec.missions import GearLifeRules

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
    for field in fields(record):  # type: ignore[arg-type]
        value, mark = getattr(record, field.name), marks[field.name]
        inner = CHAPTERS.get(field.name, chapter)
        if is_dataclass(value):
            yield from factor_rows(value, inner) if field.name not in _HIDDEN else ()
        elif isinstance(value, tuple) and value and is_dataclass(value[0]):
            yield from map(_side_by_side, factor_rows(value[0], inner), factor_rows(value[1], inner))
        elif (origin := mark.origin) is not None and value is not None:
            values = value if isinstance(value, tuple) else (value,)
            words = field.name.replace("_", " ")
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
