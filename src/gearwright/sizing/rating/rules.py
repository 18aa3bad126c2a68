"""Rating rules of a stage, and the mesh load factor K_γ of its planets or parallel load paths."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple, Protocol

from gearwright.base import Role
from gearwright.catalogue import level_load_factor
from gearwright.parts import Material
from gearwright.parts.gears import Numbers, ToothShift
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
