"""Modules and face widths of stages: the lightest of a grid with which every strength of their teeth is met."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import count, pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import ROUNDING, DesignError, Floats, Problem, Role, refuse
from gearwright.catalogue import LEAST_SHARING, bearings
from gearwright.parts.bearings import BearingKind
from gearwright.parts.bevel_geometry import WIDEST, WIDEST_MODULES
from gearwright.parts.iso6336 import mesh_springs
from gearwright.parts.planetary import clocking_load_factor, path_stiffness, planes, tolerance_load_factor
from gearwright.sizing.rating import (
    AROUND,
    REST,
    STANDARD_MODULES,
    Context,
    Demand,
    Unloaded,
    bevel_pair,
    cone_ratio,
    cylindrical_mesh,
    least_bevel_width,
    least_width,
    load_sharing,
    made_share,
    mean_module,
    method_for,
    rate_row,
    row_reserve,
    sizes_near,
    widest_bevel,
)
from gearwright.sizing.rating.iso6336_inputs import steels_of
from gearwright.sizing.result import GearSizing, MeshSizing
from gearwright.sizing.rough_mass import MassBasis, Turned, around_mass, around_stage, oil_mass
from gearwright.spec import Epicyclic, Pair, Planetary, case_named, levels_of, shares_of
from gearwright.spec.design import BUILT, module_owners, relative_modules, split_levels
from gearwright.train import INTERNAL, Gear, Mesh

# ----------------------------------------------------------------------------------------------------------------------
# What is sized together: parts, each of one face width, whose modules are in fixed ratios.
#
# A stage is one part; a stage whose gears other stages share is several, and so are stages on common axes and the
# groups of gears of a compound set.
# ----------------------------------------------------------------------------------------------------------------------


class StageSize(NamedTuple):
    """Size of one stage."""

    module: float
    """m_n, of bevel gears m_mn [m]."""
    face_width: float
    """b, as far as it can carry [m]."""
    asked_width: float
    """b as the user gives it, which may be more than a bevel gear can have [m]."""

    def planes(self, count: int) -> StageSize:
        """Return the size of a gear that lies in several planes of one face width each.

        Args:
            count: Planes [-].
        """
        return self._replace(face_width=count * self.face_width)


class Part(NamedTuple):
    """Meshes of one face width, whose module is in a fixed ratio to that of the others."""

    name: str
    """Stage, or group of gears of a compound set."""
    stage: str
    """Whose rules it has."""
    meshes: tuple[Mesh, ...]
    ratio: float = 1.0
    """Module over the unit that all modules go with, of bevel gears the outer one [-]."""
    width: float | None = None
    """b where it is given [m]."""
    within: str = ""
    """Part whose gears it shares, so that it is no wider; empty: of gears of its own."""


def part_weight(context: Context, part: Part) -> float:
    """Return what the gears of a part weigh over b m_n², as they are made at their level [kg/m³].

    Args:
        context: What gear sizing reads.
        part: The part.
    """
    return sum(_weight(context, gear) for gear in context.train.gears if gear.sized == part.name)


def _around(context: Context, part: Part, modules: Floats, widths: Floats) -> tuple[Floats, Floats]:
    """Return about what carries and encloses the gears of a part with sizes, and what cools them [kg]."""
    stage, rating = context.design.stages[part.stage], context.ratings[part.stage]
    around = around_stage(part.stage, context.design, context.train, context.flows, rating.helix_angle)
    teeth = [np.asarray(context.teeth[gear]) for gear in around.gears]
    if isinstance(stage, Epicyclic):
        return _around_compound(context, part, around, modules, widths)
    planet = np.zeros(1)
    if isinstance(stage, Planetary):
        gear = context.train.gear(part.meshes[0].gears[1])
        planet = _weight(context, gear) / gear.bodies * widths * modules**2
    planets = stage.planets if isinstance(stage, Planetary) else 1
    mass = around_mass(around, teeth, modules, widths, planet=planet, planets=planets, factor=rating.load_factor)
    return mass, oil_mass(around, teeth, modules, widths)


def _masses(context: Context, part: Part, modules: Floats, widths: Floats) -> tuple[Floats, Floats]:
    """Return what gears of a part weigh with sizes and the oil that cools them, and about what is around them [kg]."""
    around, oil = _around(context, part, modules, widths)
    return part_weight(context, part) * widths * modules**2 + oil, around


def _around_compound(
    context: Context, part: Part, around: MassBasis, modules: Floats, widths: Floats
) -> tuple[Floats, Floats]:
    """Return the same of a group of gears of a compound set."""
    own = [place for place, gear in enumerate(around.gears) if context.train.gear(gear).sized == part.name]
    names = [mesh.name for mesh in context.train.meshes if mesh.stage == part.stage]
    rows = [
        (names.index(mesh.name), (around.gears.index(mesh.gears[0]), around.gears.index(mesh.gears[1]), mesh.sign))
        for mesh in part.meshes
    ]
    cases = tuple(
        Turned(
            tuple(case.powers[row[0]] for row in rows),
            tuple(case.speeds[place] if place in own else 0.0 for place in range(len(around.gears))),
        )
        for case in around.cases
    )
    around = around._replace(rows=tuple(row for _, row in rows), cases=cases)
    teeth = [np.asarray(context.teeth[gear]) for gear in around.gears]
    mass = around_mass(around, teeth, modules, widths, planet=np.zeros(1), planets=1, factor=1.0)
    first, second = (context.teeth[gear] for gear in part.meshes[0].gears)
    rings = [context.teeth[gear] for mesh in part.meshes for gear in mesh.gears if gear in context.train.internal]
    mass = mass + AROUND * (max(rings, default=first + 2 * second) * modules) ** 3
    return mass, oil_mass(around, teeth, modules, widths)


def _weight(context: Context, gear: Gear) -> float:
    rating, teeth = context.ratings[gear.stage], context.teeth[gear.name]
    rules, shift = rating.rules, rating.shift_of(gear).profile_shift if rating.kind == "cylindrical" else 0.0
    stage, pitch = context.design.stages[gear.stage], teeth / math.cos(rating.helix_angle)
    if gear.name in context.train.internal:
        square = (pitch - 2.0 * shift + 2.0 * rules.rim_thickness_ratio) ** 2 - (pitch - 2.0 * shift) ** 2
    else:
        square = (pitch + 2.0 * shift) ** 2 * (rules.web_ratio if gear.role is Role.WHEEL else 1.0)
        square *= made_share(gear.role, teeth, rules)
    deep = len(planes(stage.compound)[gear.own]) if isinstance(stage, Epicyclic) else 1
    return gear.bodies * deep * rating.material.density * math.pi / 4.0 * square


# ----------------------------------------------------------------------------------------------------------------------
# The grid: modules of ISO 54, or fine steps where they need not be standard or share a centre distance, and whole
# millimetres of face width.
# ----------------------------------------------------------------------------------------------------------------------


_MM = 1e-3
LEAST = 0.6
"""Least module that is tried over that which the heaviest case asks for at the widest face, all life long [-]."""
MOST = 3.0
"""Largest module that is tried over the same [-]."""
STEPS = (0.02, 1e-3, 5e-5)
"""Steps of modules that need not be standard, as parts of them: over all, then beside the best of each round [-]."""
BEYOND = 1.1
"""Step of modules beyond those of ISO 54 [-]."""


def standard_grid(needed: float) -> list[float]:
    """Return the standard modules around one, one at least; beyond the last of them in steps [m].

    Args:
        needed: That the heaviest case asks for at the widest face [m].
    """
    low, high = LEAST * needed, MOST * needed
    series = [module * _MM for module in STANDARD_MODULES]
    while series[-1] < high:
        series.append(series[-1] * BEYOND)
    return [module for module in series if low <= module <= high] or [next(m for m in series if m >= low)]


def fine_grid(middle: float, around: tuple[float, float], step: float) -> list[float]:
    """Return units in even steps of their logarithm, over a range around one of them [m].

    Args:
        middle: That one [m].
        around: Where to begin and end, over it [-].
        step: Part of a unit by which the next one is larger [-].
    """
    first, last = (round(math.log(end) / step) for end in around)
    return [middle * math.exp(step * place) for place in range(first, last + 1)]


def widths_at(context: Context, part: Part, module: float) -> tuple[Floats, Floats]:
    """Return face widths that a part may have with a module, and the module by which each is rated [m].

    Args:
        context: What gear sizing reads.
        part: The part.
        module: m_n, of bevel gears m_et [m].
    """
    rating, ratio = context.ratings[part.stage], context.width_ratios[part.stage]
    bevel = rating.kind == "bevel"
    teeth = _teeth(context, part)
    widest = min(WIDEST * float(cone_ratio(*teeth)), WIDEST_MODULES) * module if bevel else ratio * module
    if part.width is not None:
        widths = np.array([min(part.width, widest) if bevel else part.width])
    elif not rating.width_is_open:
        widths = np.array([widest_bevel(teeth, module, ratio, rating) if bevel else widest])
    else:
        usual = least_bevel_width(teeth, module, rating) if bevel else least_width(rating, module)
        least = min(max(usual, _bearing_width(context, part), _asked_face(context, part, module)), widest)
        low, high = math.ceil(least / _MM - 1e-9), max(math.floor(widest / _MM + 1e-9), 1)
        widths = np.arange(min(low, high), high + 1) * _MM
    return widths, np.asarray(mean_module(teeth, module, widths, rating)) if bevel else np.full(len(widths), module)


def _bearing_width(context: Context, part: Part) -> float:
    """Return the narrowest planet in which a bearing of the catalogue has room, where the design asks for one [m]."""
    stage = context.design.stages[part.stage]
    asked = stage.planet_bearing if isinstance(stage, Planetary) else None
    if asked is None or not asked.is_fitted or asked.width is not None or asked.designation is not None:
        return 0.0
    return asked.side_by_side * _narrowest_roller()


def _asked_face(context: Context, part: Part, module: float) -> float:
    """Return the face from which bearings of planets may serve: all bear about with face times diameter [m]."""
    rating = context.ratings[part.stage]
    planets = (gear for mesh in part.meshes for gear in mesh.gears if context.train.gear(gear).role is Role.PLANET)
    planet = next(planets, None) if rating.least_area else None
    if planet is None:
        return 0.0
    bodies = context.train.gear(planet).bodies
    return rating.least_area * math.cos(rating.helix_angle) / (bodies * module * context.teeth[planet])


@cache
def _narrowest_roller() -> float:
    """Return the width of the narrowest cylindrical roller bearing of the catalogue [m]."""
    return min(size.width for size in bearings().values() if size.kind is BearingKind.CYLINDRICAL)


def _teeth(context: Context, part: Part) -> tuple[int, int]:
    first, second = part.meshes[0].gears
    return context.teeth[first], context.teeth[second]


# ----------------------------------------------------------------------------------------------------------------------
# The lightest of the grid that passes: by arrays what they can tell, then in full, the lightest first.
# ----------------------------------------------------------------------------------------------------------------------


_SPEEDS = ("main resonance", "speed of K_V")
LENIENT: Sequence[tuple[str, ...]] = ((), _SPEEDS, (*_SPEEDS, "scuffing", "micropitting"), (REST,))
"""What is left out of what is asked, where nothing that is tried meets all of it; at last all but roots and flanks."""
NEAR = 1.25
"""Gears that fall short over the lightest of their kind, up to which the nearest of them is taken [-]."""
STRENGTHS = ("pitting", "tooth root")
"""Modes of the checks of flanks and roots against fatigue."""
WIDER = 1.15
"""Face over the one before that is tried for keys in hubs of built gearboxes [-]."""
STEEP = 0.3
"""Power of the face width with which safeties of films are taken to rise, above the usual 0.15 [-]."""
LARGEST_OVER = 2.0
"""Largest module over the own that is tried where bearings of planets ask for more than its widest face [-]."""
AS_NEAR = 0.01
"""Difference of two values over their limits that counts as none, so that the lighter is taken [-]."""


class Option(NamedTuple):
    """A size of every part."""

    sizes: tuple[StageSize, ...]
    """Of every part."""
    mass: float
    """Of their gears by the estimate [kg]."""
    nearness: float
    """Least value over limit of all that is asked of them [-]."""


@dataclass
class _Widths:
    """Widths of a part at one unit, of which one is looked at."""

    part: Part
    widths: Floats
    modules: Floats
    near: Floats
    """Least value over limit of each as far as arrays tell [-]."""
    masses: Floats
    """Of its gears [kg]."""
    around: Floats
    """Of what carries them, by an estimate [kg]."""
    is_array: bool
    """Whether arrays tell anything."""
    at: int = 0

    @property
    def size(self) -> StageSize:
        """The one that is looked at."""
        width = float(self.widths[self.at])
        return StageSize(float(self.modules[self.at]), width, width if self.part.width is None else self.part.width)

    def passing(self, least: float = 0.0) -> list[int]:
        """Return the places, from that which is looked at, that pass and are no narrower than something.

        Args:
            least: That width [m].
        """
        good = (self.near >= 1.0 - ROUNDING) & (self.widths >= least * (1.0 - ROUNDING))
        return [int(place) for place in np.flatnonzero(good) if place >= self.at]


_Row = tuple[_Widths, ...]


def options(
    context: Context, parts: Sequence[Part], unit: float, demands: Mapping[str, Demand], *, is_open: bool
) -> Iterator[Option]:
    """Yield the lightest sizes of all parts with every unit that pass, the lightest first; the nearest if none does.

    Args:
        context: What gear sizing reads.
        parts: What is sized together; those that share gears of another one before it.
        unit: That is given, or that the heaviest case asks for at the widest face [m].
        demands: Mesh row -> what it asks for.
        is_open: Whether the unit is looked for.
    """
    rules = context.ratings[parts[0].stage].proportions
    if not is_open and all(part.width is not None for part in parts):
        yield _as_given(context, parts, unit)
    elif not is_open or rules is None:
        yield from _best(context, parts, (unit,), demands)
    elif rules.standard_modules and len({part.stage for part in parts if not part.within}) == 1:
        yield from _best(context, parts, standard_grid(unit), demands)
    else:
        coarse = _best(context, parts, fine_grid(unit, (LEAST, MOST), STEPS[0]), demands)
        found = next(coarse)
        for before, step in pairwise(STEPS):
            middle = _unit_of(context, parts[-1], found.sizes[-1])
            found = next(_best(context, parts, fine_grid(middle, (1.0 - before, 1.0 + before), step), demands))
        yield found
        yield from (option for option in coarse if option.nearness >= 1.0 - ROUNDING)


def _as_given(context: Context, parts: Sequence[Part], unit: float) -> Option:
    """Return the sizes that a design gives: there is nothing to choose, and what they lack their checks tell."""
    row = list[_Widths]()
    for part in parts:
        widths, modules = widths_at(context, part, unit * part.ratio)
        row.append(_Widths(part, widths, modules, np.ones(1), *_masses(context, part, modules, widths), is_array=False))
    return Option(tuple(own.size for own in row), _mass(tuple(row)), 1.0)


def _unit_of(context: Context, part: Part, size: StageSize) -> float:
    """Return the unit of a size of a part [m]."""
    rating = context.ratings[part.stage]
    if rating.kind != "bevel":
        return size.module / part.ratio
    return size.module / math.cos(rating.helix_angle) + size.face_width / (
        2.0 * float(cone_ratio(*_teeth(context, part)))
    )


def _best(
    context: Context, parts: Sequence[Part], units: Sequence[float], demands: Mapping[str, Demand]
) -> Iterator[Option]:
    """Yield the options that pass, the lightest first; where none does, the nearest to it."""
    for left_out in LENIENT:
        found = list[Option]()
        for option in _options(context, parts, units, demands, left_out=left_out):
            if left_out and found and option.mass > NEAR * found[0].mass:
                break
            found.append(option)
            if not left_out:
                yield option
        if found:
            if left_out:
                best = max(option.nearness for option in found)
                yield next(option for option in found if option.nearness >= best - AS_NEAR)
            return
    yield _strongest(context, parts, units, demands)


def _options(
    context: Context, parts: Sequence[Part], units: Sequence[float], demands: Mapping[str, Demand],
    *, left_out: tuple[str, ...],
) -> Iterator[Option]:  # fmt: skip
    """Yield the lightest size of all parts with every unit, the lightest of them first."""
    order, heap = count(), list[tuple[float, int, _Row]]()
    for row in zip(*(_tried(context, part, units, left_out) for part in parts), strict=True):
        _put(heap, order, row)
    while heap:
        mass, _, row = heapq.heappop(heap)
        nearness = 1.0
        for own in row:
            all_of_it, asked = _near(context, own, demands, left_out)
            if asked < 1.0 - ROUNDING:
                if _widen(context, own, demands, left_out, ratio=asked):
                    _put(heap, order, row)
                break
            nearness = min(nearness, all_of_it)
        else:
            yield Option(tuple(own.size for own in row), mass, nearness)
            if context.design.level == BUILT:
                _put(heap, order, tuple(_wider(own) for own in row))


def _mass(row: _Row) -> float:
    """Return what parts weigh with what carries the gears of each stage, to rank them [kg]."""
    around = dict[str, float]()
    for own in row:
        around[own.part.stage] = max(around.get(own.part.stage, 0.0), float(own.around[own.at]))
    return sum(float(own.masses[own.at]) for own in row) + sum(around.values())


def _put(heap: list[tuple[float, int, _Row]], order: Iterator[int], row: _Row) -> None:
    """Add parts at their least widths that may pass, those that share gears before those whose gears they share."""
    for own in row:
        shared = max((other.size.face_width for other in row if other.part.within == own.part.name), default=0.0)
        places = own.passing(shared)
        if not places:
            return
        own.at = places[0]
    heapq.heappush(heap, (_mass(row), next(order), row))


def _wider(own: _Widths) -> _Widths:
    """Return a part at a wider face, for keys in hubs, which no strength of teeth asks for."""
    return replace(own, at=int(np.searchsorted(own.widths, WIDER * own.widths[own.at])))


def _widen(
    context: Context, own: _Widths, demands: Mapping[str, Demand], left_out: tuple[str, ...], *, ratio: float
) -> bool:
    """Go on to a wider face that passes in full; tell whether there is one.

    Where arrays tell the strengths, films ask for it: in steps that are too short, as their safeties rise slowly and
    not evenly with the width, by the micrometres of tip relief. Else by halves, as strengths rise with it.
    """

    def passes(place: int) -> bool:
        nonlocal ratio
        own.at = place
        ratio = _near(context, own, demands, left_out)[1]
        return ratio >= 1.0 - ROUNDING

    places = own.passing()[1:]
    if own.is_array:
        while places:
            wanted = own.widths[own.at] * max(ratio, 1e-3) ** (-1.0 / STEEP)
            place = next((place for place in places if own.widths[place] >= wanted), places[-1])
            if passes(place):
                own.at = next((between for between in places if between == place or passes(between)), place)
                return True
            places = [later for later in places if later > place]
        return False
    if not places or not passes(places[-1]):
        return False
    low, high = 0, len(places) - 1
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if passes(places[middle]) else (middle + 1, high)
    own.at = places[high]
    return True


def _tried(context: Context, part: Part, units: Sequence[float], left_out: tuple[str, ...]) -> list[_Widths]:
    """Return the widths of a part at every unit, with what arrays tell of them."""
    grids = [widths_at(context, part, unit * part.ratio) for unit in units]
    widths, modules = (np.concatenate(columns) for columns in zip(*grids, strict=True))
    near = [
        values for mesh in part.meshes if (values := sizes_near(context, mesh, modules, widths, left_out)) is not None
    ]
    least = np.minimum.reduce([np.full(len(widths), math.inf), *near])
    masses, around = _masses(context, part, modules, widths)
    ends = np.cumsum([len(own) for own, _ in grids])[:-1]
    columns = [np.split(values, ends) for values in (widths, modules, least, masses, around)]
    return [
        _Widths(part, own, size, rated, mass, carried, bool(near))
        for own, size, rated, mass, carried in zip(*columns, strict=True)
    ]


def _near(
    context: Context, own: _Widths, demands: Mapping[str, Demand], left_out: tuple[str, ...]
) -> tuple[float, float]:
    """Return the least value over limit of a part at the width that is looked at: of all, and of what is asked [-]."""
    size, every, asked = own.size, math.inf, math.inf
    method = method_for(context.ratings[own.part.stage])
    for mesh in own.part.meshes:
        if not own.is_array:  # which is quicker to tell than a whole rating
            reserve = row_reserve(context, mesh, size.module, size.face_width)
            if reserve is not None and reserve < 1.0 - ROUNDING:
                return reserve, reserve
        rated = rate_row(context, mesh, size.module, size.face_width, asked=demands[mesh.name][2:])
        if isinstance(rated, Unloaded):
            continue
        gears = context.train.gear(mesh.gears[0]).part, context.train.gear(mesh.gears[1]).part
        for check in method.checks(rated, mesh.part, gears):
            if check.ratio is not None and check.name not in context.design.waivers:
                every = min(every, check.ratio)
                counts = check.mode in STRENGTHS if REST in left_out else check.mode not in left_out
                asked = min(asked, check.ratio) if counts else asked
    return every, asked


def _strongest(
    context: Context, parts: Sequence[Part], units: Sequence[float], demands: Mapping[str, Demand]
) -> Option:
    """Return the sizes at which the weakest part comes nearest to its strengths; without arrays, the widest."""
    rows = list(zip(*(_tried(context, part, units, LENIENT[-1]) for part in parts), strict=True))
    near = list[float]()
    for row in rows:
        for own in row:
            own.at = int(np.argmax(own.near)) if own.is_array else len(own.near) - 1
        near.append(min(_near(context, own, demands, LENIENT[-1])[1] for own in row))
    best = rows[int(np.argmax(near))]
    return Option(tuple(own.size for own in best), _mass(best), max(near))


# ----------------------------------------------------------------------------------------------------------------------
# Other faces of planetary sets, as bearings of their planets may ask for them.
# ----------------------------------------------------------------------------------------------------------------------


class Face(NamedTuple):
    """Another face of a planetary set."""

    width: float
    """[m]"""
    heavier: float
    """By how much gears and what is around them weigh more with it [kg]."""
    passes: bool
    """Whether it does, as far as arrays tell."""


def other_faces(context: Context, stage: str, size: StageSize, module: float | None = None) -> list[Face]:
    """Return the faces that a planetary set may have beside its own, the narrowest first.

    Args:
        context: What gear sizing reads.
        stage: The set.
        size: Its size, as it is chosen.
        module: With which they are; None: its own [m].
    """
    (part,) = _parts(context, stage, 1.0)
    if part.width is not None or context.ratings[stage].proportions is None:
        return []
    widths, _ = widths_at(context, part, size.module if module is None else module)
    if module is None:
        widths = widths[np.abs(widths - size.face_width) > ROUNDING * size.face_width]
    modules = np.full(len(widths) + 1, size.module if module is None else module)
    modules[0] = size.module
    mass = np.add(*_masses(context, part, modules, np.array([size.face_width, *widths])))
    near = (sizes_near(context, mesh, modules[1:], widths, ()) for mesh in part.meshes)
    rated = [] if context.design.waivers else [values for values in near if values is not None]
    passes = np.minimum.reduce([np.ones(len(widths)), *rated]) >= 1.0 - ROUNDING
    return [Face(*row) for row in zip(widths.tolist(), (mass[1:] - mass[0]).tolist(), passes.tolist(), strict=True)]


def larger_modules(context: Context, stage: str, module: float) -> list[float]:
    """Return the standard modules above one that a planetary set may have, where it is open and stands alone [m].

    Args:
        context: What gear sizing reads.
        stage: The set.
        module: Its own [m].
    """
    rules = context.ratings[stage].proportions
    alone = list(module_owners(context.design).values()).count(stage) == 1
    if rules is None or not rules.standard_modules or not alone or _module_given(context, stage) is not None:
        return []
    low, high = module * (1.0 + ROUNDING), LARGEST_OVER * module
    return [value * _MM for value in STANDARD_MODULES if low < value * _MM <= high]


# ----------------------------------------------------------------------------------------------------------------------
# Gears that no load case loads: strength asks nothing of them, so that they have no size but a given one.
# ----------------------------------------------------------------------------------------------------------------------


NOTHING = 1e-9
"""Torque over the largest of its kind below which it is rounding [-]."""


def refuse_idle_stages(context: Context, needed: Mapping[str, float]) -> None:
    """Raise where nothing loads the gears of a stage whose module is not given.

    Args:
        context: What gear sizing reads.
        needed: Stage -> module that its meshes, or a stage on the same axes, ask for [m].

    Raises:
        DesignError: For every such stage, with what to give.
    """
    largest = max(needed.values(), default=0.0)
    if not math.isfinite(largest):
        return
    problems = []
    for stage, module in needed.items():
        is_given = f"{stage}.module" in context.given or f"{stage}.outer_module" in context.given
        if module > math.cbrt(NOTHING) * largest or is_given:
            continue
        table = "pairs" if stage in context.design.pairs else "planetaries"
        key = "outer_module_mm" if context.ratings[stage].kind == "bevel" else "module_mm"
        message = (
            "no load case sends power through these gears, so that strength asks for no module; write one here, such as"
            f" {key} = 2, or a case that loads them"
        )
        problems.append(Problem(f"{table}.{stage}", message))
    refuse(problems)


# ----------------------------------------------------------------------------------------------------------------------
# Module and face width of every stage: the lightest that pass, or as the user gives them.
# ----------------------------------------------------------------------------------------------------------------------


class _Open(NamedTuple):
    """Parts that are sized together by a standard."""

    parts: tuple[Part, ...]
    unit: float
    """Given, or what the heaviest case asks for at the widest face [m]."""
    is_open: bool

    def kind(self, context: Context, demands: Mapping[str, Demand]) -> object:
        """Return what is the same of parts that do the same, such as the stages of equal engines, each in its case."""
        rules = [(context.ratings[part.stage], part.width) for part in self.parts]
        numbers = [
            (
                part.ratio,
                [(context.asks[mesh.name], demands[mesh.name][1:], _loads(context, mesh)) for mesh in part.meshes],
            )
            for part in self.parts
        ]
        return repr((rules, self.is_open, _but_for_rounding((self.unit, numbers))))


def _but_for_rounding(value: Any) -> Any:
    """Return rows of numbers without the digits by which those of parts that do the same may differ."""
    if isinstance(value, float):
        return float(f"{value:.9g}")
    return [_but_for_rounding(one) for one in value] if isinstance(value, (tuple, list)) else value


def _loads(context: Context, mesh: Mesh) -> list[tuple[float, float, float, bool, tuple[tuple[float, float], ...]]]:
    """Return the loads of a row in order, without names of cases; of limit loads those that exceed the others."""
    design, shares = context.design, shares_of(context.design)
    torques = {case: abs(flow.meshes[mesh.name].multiplier) for case, flow in context.flows.items()}
    limits = {case: case_named(design, case).static for case in torques}
    most = max((torque for case, torque in torques.items() if not limits[case]), default=0.0)
    return sorted(
        (_but_for_rounding(torque), _but_for_rounding(abs(context.rolling(mesh, case))), shares.get(case, 0.0),
         limits[case], tuple(levels_of(design, case)))
        for case, torque in torques.items() if torque > (most if limits[case] else 0.0)
    )  # fmt: skip


def all_sizes(context: Context, demands: Mapping[str, Demand]) -> dict[str, StageSize]:
    """Return module and face width of every stage and group of a compound set: the lightest that pass.

    Args:
        context: What gear sizing reads.
        demands: Mesh row -> what it asks for.

    Raises:
        DesignError: If nothing loads a stage, or its standard does not cover it.
    """
    closed, open_ = _divided(context, demands)
    found = _lightest(context, tuple(open_), demands) if open_ else ()
    for one, sizes in zip(open_, found, strict=True):
        closed |= {part.name: size for part, size in zip(one.parts, sizes, strict=True)}
    return closed


def combinations(
    context: Context, demands: Mapping[str, Demand]
) -> Iterator[tuple[dict[str, StageSize], dict[frozenset[str], float]]]:
    """Yield the same in combinations of sizes that pass, the lightest first.

    With each the stages that are sized together, and what they weigh by an estimate [kg]; what follows in closed form
    is not in it.

    Args:
        context: What gear sizing reads.
        demands: Mesh row -> what it asks for.
    """
    closed, open_ = _divided(context, demands)
    alike = dict[object, list[_Open]]()
    for one in open_:
        alike.setdefault(one.kind(context, demands), []).append(one)
    courses = [
        _OptionStream(options(context, *ones[0][:2], demands, is_open=ones[0].is_open), []) for ones in alike.values()
    ]
    start = (0,) * len(courses)
    heap, seen = [(0.0, start)], {start}
    while heap:
        _, places = heapq.heappop(heap)
        taken = [course.at(place) for course, place in zip(courses, places, strict=True)]
        sizes, masses = dict(closed), dict[frozenset[str], float]()
        for ones, option in zip(alike.values(), taken, strict=True):
            assert option is not None
            for one in ones:
                masses[frozenset(part.stage for part in one.parts)] = option.mass
                sizes |= {part.name: size for part, size in zip(one.parts, option.sizes, strict=True)}
        yield sizes, masses
        for k, course in enumerate(courses):
            after = (*places[:k], places[k] + 1, *places[k + 1 :])
            if after not in seen and course.at(after[k]) is not None:
                seen.add(after)
                found = zip(alike.values(), courses, after, strict=True)
                heavier = sum(len(ones) * own.mass_at(place) for ones, own, place in found)
                heapq.heappush(heap, (heavier, after))


class _OptionStream(NamedTuple):
    """Options as far as they are looked at."""

    left: Iterator[Option]
    found: list[Option]

    def at(self, place: int) -> Option | None:
        """Return an option; None where there are not so many."""
        while len(self.found) <= place:
            if (option := next(self.left, None)) is None:
                return None
            self.found.append(option)
        return self.found[place]

    def mass_at(self, place: int) -> float:
        """Return what an option weighs that there is [kg]."""
        return self.found[place].mass


def _lightest(
    context: Context, open_: tuple[_Open, ...], demands: Mapping[str, Demand]
) -> tuple[tuple[StageSize, ...], ...]:
    """Return the lightest size of all that is open."""
    return tuple(next(options(context, *one[:2], demands, is_open=one.is_open)).sizes for one in open_)


def _divided(context: Context, demands: Mapping[str, Demand]) -> tuple[dict[str, StageSize], list[_Open]]:
    """Return the sizes that follow in closed form, and what a standard sizes, with all that is tied to it."""
    group = module_owners(context.design)
    needed: dict[str, float] = {}
    for mesh in context.train.meshes:
        if mesh.stage not in group:
            continue
        owner = group[mesh.stage]
        needed[owner] = max(needed.get(owner, 0.0), *demands[mesh.name][2:])
    _align(context, needed, group)
    refuse_idle_stages(context, needed)
    tied = _tied(context, group)
    closed, open_ = dict[str, StageSize](), list[_Open]()
    for owners in (*({owner} for owner in needed if not any(owner in owners for owners in tied)), *tied):
        modules = {owner: _module_given(context, owner) for owner in owners}
        plain = [owner for owner in owners if context.ratings[owner].proportions is None]
        apart = len(owners) > 1 and (plain or any(module is not None for module in modules.values()))
        for some in [{owner} for owner in sorted(owners)] if apart else [owners]:
            first = min(some)
            given = needed[first] if apart and modules[first] is None else modules[first]
            if first in plain:
                closed |= _closed_form(context, first, needed[first] if given is None else given)
                continue
            ratios = {owner: 1.0 if owner == first else needed[owner] / needed[first] for owner in sorted(some)}
            parts = [part for owner, ratio in ratios.items() for part in _parts(context, owner, ratio)]
            unit = _unit(context, first, needed[first]) if given is None else given
            open_.append(_Open(tuple(parts), unit, given is None))
    for name in context.design.epicyclics:
        own = _set(context, name, demands)
        if isinstance(own, _Open):
            open_.append(own)
        else:
            closed |= own
    return closed, open_


def _unit(context: Context, owner: str, needed: float) -> float:
    """Return the module that a stage asks for, of bevel gears the outer one [m]."""
    rating = context.ratings[owner]
    if rating.kind != "bevel":
        return needed
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == owner)
    teeth = context.teeth[mesh.gears[0]], context.teeth[mesh.gears[1]]
    return float(bevel_pair(teeth, needed, context.width_ratios[owner] * needed, rating).outer_module)


def _module_given(context: Context, owner: str) -> float | None:
    """Return the module that a stage is given, of bevel gears the outer one [m]; None where it is open."""
    return context.given.get(f"{owner}.module", context.given.get(f"{owner}.outer_module"))


def _closed_form(context: Context, owner: str, module: float) -> dict[str, StageSize]:
    """Return the sizes of stages of one module whose method has a closed form: faces of λ modules."""
    sizes = dict[str, StageSize]()
    for stage, own in module_owners(context.design).items():
        if own == owner:
            width = context.given.get(f"{stage}.face_width", context.width_ratios[stage] * module)
            sizes[stage] = StageSize(module, width, width)
    return sizes


def _parts(context: Context, owner: str, ratio: float) -> list[Part]:
    """Return a stage and those that have its module, whose gears mesh with its own and are no wider."""
    stages = [stage for stage, own in module_owners(context.design).items() if own == owner != stage]
    rows = {stage: tuple(mesh for mesh in context.train.meshes if mesh.stage == stage) for stage in (*stages, owner)}
    return [
        Part(stage, stage, meshes, ratio, context.given.get(f"{stage}.face_width"), "" if stage == owner else owner)
        for stage, meshes in rows.items()
    ]


def _align(context: Context, needed: dict[str, float], group: Mapping[str, str]) -> None:
    """Raise modules until pairs on the same axes have the larger one's centre distance."""
    for links in _links(context):
        spans = {tied: _span(context, tied) for tied in links}
        distance = max(_asked(context, needed, group[tied]) * span for tied, span in spans.items())
        for tied, span in spans.items():
            needed[group[tied]] = distance / span


def _links(context: Context) -> list[tuple[str, str]]:
    """Return every pair that stands on the axes of another one, with that one."""
    pairs = context.design.pairs.items()
    return [(name, pair.coaxial_with) for name, pair in pairs if pair.coaxial_with is not None]


def _asked(context: Context, needed: Mapping[str, float], stage: str) -> float:
    return context.given.get(f"{stage}.module", needed[stage])


def _tied(context: Context, group: Mapping[str, str]) -> list[set[str]]:
    """Return the stages whose modules are in a fixed ratio, as they stand on common axes; those that share one once."""
    found = list[set[str]]()
    for links in _links(context):
        own = {group[tied] for tied in links}
        apart = [tied for tied in found if not tied & own]
        found = [*apart, own.union(*(tied for tied in found if tied & own))]
    return found


def _span(context: Context, stage: str) -> float:
    """Return a pair's working centre distance over its normal module, (z_1 ± z_2) / (2 cos β) without shift [-]."""
    if (centre := context.ratings[stage].shifts.centre) is not None:
        return centre
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    pinion, wheel = (context.teeth[gear] for gear in mesh.gears)
    return abs(pinion - mesh.sign * wheel) / (2.0 * math.cos(context.ratings[stage].helix_angle))


# ----------------------------------------------------------------------------------------------------------------------
# Modules and face widths of compound sets: one module for gears that mesh, related to the others by common pins.
# ----------------------------------------------------------------------------------------------------------------------


def _set(context: Context, name: str, demands: Mapping[str, Demand]) -> dict[str, StageSize] | _Open:
    """Return the sizes of the groups of a compound set, or what of them is open."""
    epicyclic = context.design.epicyclics[name]
    ratios = relative_modules(epicyclic)
    rows: dict[str, list[Mesh]] = {}
    for mesh in context.train.meshes:
        if mesh.stage == name:
            rows.setdefault(mesh.group, []).append(mesh)
    given = {
        epicyclic.group(gear): context.given[f"{name}.{gear}.module"]
        for gear in epicyclic.toothed
        if f"{name}.{gear}.module" in context.given
    }
    unit = next((module / ratios[group] for group, module in given.items()), None)
    needed = max(max(demands[mesh.name][2:]) / ratios[group] for group, meshes in rows.items() for mesh in meshes)
    if unit is None and needed <= 0.0:
        path = next(iter(epicyclic.planets))
        message = "no load case sends power through this set, so that strength asks for no module; write module_mm = 2"
        raise DesignError([Problem(f"{context.design.table(name)}.planets.{path}", message)])
    if context.ratings[name].proportions is None:
        unit, ratio = needed if unit is None else unit, context.width_ratios[name]
        modules = {group: given.get(group, unit * own) for group, own in ratios.items()}
        widths = {group: _width_given(context, meshes) or ratio * modules[group] for group, meshes in rows.items()}
        return {
            meshes[0].sized: StageSize(modules[group], widths[group], widths[group]) for group, meshes in rows.items()
        }
    parts = [
        Part(meshes[0].sized, name, tuple(meshes), given[group] / unit if unit and group in given else ratios[group],
             _width_given(context, meshes))
        for group, meshes in rows.items()
    ]  # fmt: skip
    return _Open(tuple(parts), needed if unit is None else unit, unit is None)


def _width_given(context: Context, meshes: Sequence[Mesh]) -> float | None:
    """Return the least face width that gears of some meshes are given [m]."""
    names = {gear for mesh in meshes for gear in mesh.gears}
    given = [context.given[f"{gear}.face_width"] for gear in names if f"{gear}.face_width" in context.given]
    return min(given, default=None)


# ----------------------------------------------------------------------------------------------------------------------
# K_γ that follows from the sizes of gears and their loads: by tolerances of pins, by the clocking of two paths.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 8
"""Times that gears are sized anew with the K_γ of their sizes, at most [-]."""
STILL = 1e-3
"""Change of K_γ that counts as none [-]."""
BEARING = 1e9
"""Radial stiffness of a planet's bearing on its pin where none is given [N/m], an estimate."""
LARGEST = 3.0
"""K_γ at most, as where it is given [-]: beyond, planets do not all carry."""


def sharing_of_sizes(
    context: Context, gears: Sequence[GearSizing], meshes: Sequence[MeshSizing]
) -> Mapping[str, float]:
    """Return stage -> K_γ by the sizes of its gears, where the design asks for that [-].

    Args:
        context: What gear sizing reads.
        gears: As sized.
        meshes: As sized.
    """
    found = dict[str, float]()
    for name, stage in context.design.stages.items():
        if load_sharing(context.design, name).by_size:
            own = [mesh for mesh in meshes if mesh.stage == name]
            if isinstance(stage, Pair):
                factor = _by_clocking(context, name, stage, own)
            else:
                factor = max(_by_tolerances(context, stage, gears, mesh) for mesh in own)
            found[name] = min(max(factor, 1.0), LARGEST)
    return found


def _by_clocking(context: Context, name: str, pair: Pair, meshes: Sequence[MeshSizing]) -> float:
    """Return K_γ of clocked paths by the torque that comes in where they part, in the case that loads them most."""
    case = meshes[0].case
    rows = [row for row in context.train.meshes if row.stage == name]
    multiplier = sum(abs(context.flows[case].meshes[row.name].multiplier) for row in rows)
    split = 0 if len(pair.named(Role.WHEEL)) >= len(pair.named(Role.PINION)) else 1
    torque = multiplier * context.teeth[rows[0].gears[split]]
    assert pair.clocking is not None
    return float(clocking_load_factor(pair.clocking, torque) ** split_levels(context.design)[name])


def _by_tolerances(
    context: Context, stage: Planetary | Epicyclic, gears: Sequence[GearSizing], mesh: MeshSizing
) -> float:
    """Return K_γ of a set by the places of its pins, in the case that loads a mesh most."""
    rating = context.ratings[mesh.stage]
    first, second = (next(gear for gear in gears if gear.name == name) for name in mesh.gears)
    row = next(row for row in context.train.meshes if row.name == mesh.name)
    width = min(first.face_width, second.face_width)
    pair = cylindrical_mesh(
        (first.teeth, second.teeth), first.module, width, context.rating(row), internal=row.sign == INTERNAL
    )
    springs = mesh_springs(pair, steels=steels_of(rating, (first.role, second.role)))
    pin = stage.bearings.pin if isinstance(stage, Planetary) else None
    stiffness = path_stiffness(
        float(springs.mesh), width, bearing=pin or BEARING, pressure_angle=mesh.working_pressure_angle
    )
    planets = stage.planets if isinstance(stage, Planetary) else stage.sets
    assert stage.pin_position is not None
    force = mesh.tangential_force / mesh.load_factor
    factor = tolerance_load_factor(planets, stage.pin_position, force, stiffness=stiffness, floating=True)
    return max(factor, LEAST_SHARING)
