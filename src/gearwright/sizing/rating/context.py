"""All rating methods by name, the design data that sizing steps share, demands on meshes, and the rating of rows."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.base import Floats, Problem, Role, largest, refuse
from gearwright.memo import Memo, SharedMemo
from gearwright.parts.gears import Numbers
from gearwright.sizing.rating.agma import Agma2001, Agma2003
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.iso10300 import Iso10300
from gearwright.sizing.rating.lewis_hertz import LewisHertz
from gearwright.sizing.rating.protocol import (
    LEAST_TORQUE,
    WEAR,
    Ask,
    FarGear,
    Load,
    LoadedMesh,
    MeshRating,
    Method,
    Rating,
    SizesNear,
    Unloaded,
    rating_of,
)
from gearwright.spec import Design, Epicyclic, levels_of, shares_of
from gearwright.spec.design import GROUND, RATINGS, Given, case_named
from gearwright.train import INTERNAL, Gear, Mesh, PowerFlow, Train

# ----------------------------------------------------------------------------------------------------------------------
# All methods of rating by name: the one place that knows them, and how a stage finds its own.
#
# A new method is a module beside this one, a line here, and its name in `spec.design.RATINGS`.
# ----------------------------------------------------------------------------------------------------------------------


METHODS: dict[str, Method[Any]] = {
    "lewis-hertz": LewisHertz(),
    "iso6336": Iso6336(),
    "iso6336-2006": Iso6336("iso6336-2006", "ISO 6336:2006, method B"),
    "din3990": Iso6336("din3990", "DIN 3990:1987, method B"),
    "iso10300": Iso10300(),
    "agma2001": Agma2001(),
    "agma2003": Agma2003(),
}
"""Name -> method."""


def method_for(rating: Rating) -> Method[Any]:
    """Return the method that rates a stage.

    Args:
        rating: Its resolved rules.
    """
    return METHODS[rating.method]


def modules(ask: Ask, rating: Rating) -> tuple[Numbers, Numbers]:
    """Return the modules that bending and contact ask of a mesh by the method of its stage [m].

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        rating: Resolved rules.
    """
    return method_for(rating).module(ask, rating)


def stage_width_ratio(rating: Rating, small: ArrayLike, large: ArrayLike) -> Floats:
    """Return λ = b/m_n of a stage [-]: given, or what its method takes.

    Args:
        rating: Resolved rules.
        small: Teeth of pinion or sun [-].
        large: Teeth of wheel or planet [-].
    """
    first, second = np.broadcast_arrays(np.asarray(small, dtype=float), np.asarray(large, dtype=float))
    if rating.rules.face_width_ratio is not None:
        return np.full(first.shape, rating.rules.face_width_ratio)
    return method_for(rating).width_ratio(rating, first, second)


def uncovered_teeth(design: Design, stage: str, rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
    """Yield what the method of a stage does not cover, by its place in the file.

    Args:
        design: As read.
        stage: Of it.
        rating: Its resolved rules.
        teeth: Of a mesh of the stage, z_2 < 0 for a ring.
    """
    for problem in method_for(rating).refuse(rating, teeth):
        yield Problem(design.key_of(stage, problem.path), problem.message)


# ----------------------------------------------------------------------------------------------------------------------
# What every step of sizing reads (the design, its train, teeth and flows, resolved rules), and what each mesh asks.
# ----------------------------------------------------------------------------------------------------------------------


_IDLE = 1e-6
"""Part of the largest load below which a case does not load the other flank [-]."""
_ALIKE = 0.9
"""Part of its own load from which on another mesh of a gear on the same flank counts as its equal [-]."""


Known = Memo[tuple[Any, ...], list[tuple[Rating, Any]]]
"""Load, teeth and size of a mesh -> what it gave, by the rules that it gave it for."""
MESHES = SharedMemo[tuple[Any, ...], list[tuple[Rating, Any]]](200_000)
"""What meshes give: equal meshes give the same bits, whichever design they are of, so that sizings may share it."""


class Demand(NamedTuple):
    """What a mesh row asks for at its worst case."""

    case: str
    """That case."""
    per_tooth: float
    """Torque per tooth of one mesh, load factor included [N m]."""
    bending: float
    """Module that bending asks for [m]."""
    contact: float
    """Module that contact asks for [m]."""


@dataclass(frozen=True)
class Context:
    """What every step of gear sizing reads."""

    design: Design
    train: Train
    teeth: Mapping[str, int]
    """Gear -> tooth number [-]."""
    flows: Mapping[str, PowerFlow]
    """Case -> speeds, torques and powers."""
    given: Mapping[str, float]
    """Path -> value that the user gives instead of the computed one [SI]."""
    ratings: Mapping[str, Rating]
    """Stage -> resolved rules."""
    known: Known = field(default_factory=MESHES.now, compare=False, repr=False)
    """What meshes have given so far, also with other teeth of other stages."""

    @cached_property
    def lasting(self) -> dict[str, list[float]]:
        """Mesh row -> what its rows of teeth bear, with its sense, in every case that lasts [N m]."""
        lasting = [flow for case, flow in self.flows.items() if not case_named(self.design, case).static]
        return {mesh.name: [flow.meshes[mesh.name].multiplier for flow in lasting] for mesh in self.train.meshes}

    @cached_property
    def width_ratios(self) -> dict[str, float]:
        """Stage -> λ = b/m_n before its face width is rounded or given [-]; by the teeth of its first mesh."""
        first = {mesh.stage: mesh for mesh in reversed(self.train.meshes)}
        teeth = {stage: [self.teeth[gear] for gear in mesh.gears] for stage, mesh in first.items()}
        return {stage: float(stage_width_ratio(self.ratings[stage], *pair)) for stage, pair in teeth.items()}

    @cached_property
    def asks(self) -> dict[str, Ask]:
        """Mesh row -> teeth, kind and width of its mesh, without load."""
        rows = {
            mesh.name: row_ask(self.train, self.teeth, mesh, self.lasting, self.design) for mesh in self.train.meshes
        }
        return {
            mesh.name: rows[mesh.name]._replace(
                width_ratio=self.width_ratios[mesh.stage], relieved=self._relieved(mesh), fastest=self._fastest(mesh)
            )
            for mesh in self.train.meshes
        }

    def _relieved(self, mesh: Mesh) -> float:
        """Return the torque per tooth of the case that does most damage to a mesh, for which its tips are relieved."""
        loads = {
            case: (abs(flow.meshes[mesh.name].multiplier), self.rolling(mesh, case))
            for case, flow in self.flows.items()
            if not case_named(self.design, case).static
        }
        return worn_torque(self.design, loads) / mesh.count * self.ratings[mesh.stage].load_factor

    def _fastest(self, mesh: Mesh) -> float:
        """Return the greatest speed of the first gear of a mesh against its carrier in all cases that last."""
        cases = (case for case in self.flows if not case_named(self.design, case).static)
        return max((self.rolling(mesh, case) for case in cases), default=0.0)

    def rolling(self, mesh: Mesh, case: str) -> float:
        """Return the speed of the first gear of a mesh against its carrier in a case [rad/s].

        Args:
            mesh: A row of the train.
            case: Of the design.
        """
        speeds = self.flows[case].speeds
        return abs(speeds[mesh.nodes[0]] - speeds[mesh.nodes[2]])

    def rating(self, mesh: Mesh) -> Rating:
        """Return the resolved rules of a mesh, with its own shifts.

        Args:
            mesh: A row of the train.
        """
        return self.ratings[mesh.stage].of_mesh(mesh)

    @property
    def reference(self) -> PowerFlow:
        """The case that speaks for the design: the first one."""
        return next(iter(self.flows.values()))


def worn_torque(design: Design, loads: Mapping[str, tuple[float, float]]) -> float:
    """Return the torque that does most damage to flanks, by the shares of the life; without shares the largest [N m].

    Args:
        design: With the shares of its cases and their levels.
        loads: Case that lasts -> torque [N m] and speed of the mesh.
    """
    rows = [
        (share * part * loads[case][1], level * loads[case][0])
        for case, share in shares_of(design).items()
        if case in loads
        for level, part in levels_of(design, case)
    ]
    if not rows:
        return max((torque for torque, _ in loads.values()), default=0.0)
    return largest(rows, lambda row: row[0] * row[1] ** WEAR)[1]


def context_of(
    design: Design, train: Train, teeth: Mapping[str, int], flows: Mapping[str, PowerFlow], given: Mapping[str, Given],
    *, known: Known | None = None,
) -> Context:  # fmt: skip
    """Return what gear sizing reads, with the rules of every stage resolved.

    Args:
        design: The design.
        train: Its graph.
        teeth: Tooth number of every gear.
        flows: Every load case.
        given: Path -> value that the user gives instead of the computed one.
        known: What meshes of the design have given with other teeth; left out: what sizings share here.
    """
    ratings = {name: rating_of(design, name, teeth) for name in design.stages}
    values = {path: entry.value for path, entry in given.items()}
    return Context(design, train, teeth, flows, values, ratings, MESHES.now() if known is None else known)


def shared(context: Context, sharing: Mapping[str, float]) -> Context:
    """Return what gear sizing reads where stages share their loads otherwise.

    Args:
        context: As it was.
        sharing: Stage -> K_γ by the sizes of its gears [-].
    """
    ratings = {name: replace(context.ratings[name], load_factor=factor) for name, factor in sharing.items()}
    return replace(context, ratings={**context.ratings, **ratings})


def once(context: Context, rating: Rating, key: tuple[Any, ...], computed: Callable[[], Any]) -> Any:
    """Return what a mesh gives, computed once for equal loads, sizes and rules: of branches alike, of several trains.

    Args:
        context: What gear sizing reads.
        rating: Rules of the mesh.
        key: All else that it depends on.
        computed: What gives it.
    """
    if rating.proportions is None:  # closed forms are quicker than a look
        return computed()
    results = context.known.of(key, list)
    for rules, result in results:
        if rules == rating:
            return result
    results.append((rating, computed()))
    return results[-1][1]


def demands_of(context: Context) -> dict[str, Demand]:
    """Return mesh row -> what it asks for at its worst case.

    Args:
        context: What gear sizing reads.

    Raises:
        DesignError: Teeth or steels that the method of a stage does not cover; with every stage.
    """
    refuse(dict.fromkeys(problem for mesh in context.train.meshes for problem in _uncovered(context, mesh)))
    return {mesh.name: _demand(context, mesh) for mesh in context.train.meshes}


def _uncovered(context: Context, mesh: Mesh) -> Iterator[Problem]:
    first, second = (context.teeth[gear] for gear in mesh.gears)
    signed = (first, -second if mesh.sign == INTERNAL else second)
    return uncovered_teeth(context.design, mesh.stage, context.rating(mesh), signed)


def worst_case(context: Context, mesh: Mesh) -> tuple[str, float]:
    """Return the case that loads a mesh most, and its torque per tooth, load factor included [N m].

    Where the method knows fatigue, static cases are none of them: they count no cycles.

    Args:
        context: What gear sizing reads.
        mesh: A row of the train.
    """
    known = RATINGS[context.design.rating(mesh.stage)].fatigue
    loads = {
        case: abs(flow.meshes[mesh.name].multiplier)
        for case, flow in context.flows.items()
        if not (known and case_named(context.design, case).static)
    }
    case = largest(loads, lambda name: loads[name])
    return case, loads[case] / mesh.count * context.ratings[mesh.stage].load_factor


def _demand(context: Context, mesh: Mesh) -> Demand:
    case, per_tooth = worst_case(context, mesh)
    ask, rating = ask_of(context, mesh, case, per_tooth), context.rating(mesh)
    bending, contact = once(context, rating, ("modules", ask), lambda: modules(ask, rating))
    return Demand(case, per_tooth, float(bending), float(contact))


def ask_of(context: Context, mesh: Mesh, case: str, per_tooth: float) -> Ask:
    """Return what a load case asks of a mesh.

    Args:
        context: What gear sizing reads.
        mesh: A row of the train.
        case: Of the design.
        per_tooth: Torque per tooth of one mesh, load factor included [N m].
    """
    speed = context.rolling(mesh, case)
    return context.asks[mesh.name]._replace(per_tooth=per_tooth, speed=speed)


def row_ask(
    train: Train, teeth: Mapping[str, int], mesh: Mesh, loads: Mapping[str, Sequence[float]], design: Design
) -> Ask:
    """Return teeth and kind of a mesh, without load; a tooth meets as many mates in a turn as equal ones pass it.

    Args:
        train: The graph.
        teeth: Tooth number of every gear [-].
        mesh: A row of the train.
        loads: Mesh row -> torque on its first gear in everything that lasts, or in proportion to it, with its sense.
        design: With the bores of its gears.
    """
    first, second = (train.gear(gear) for gear in mesh.gears)
    idlers = bends_both_ways(train, first.name, loads), bends_both_ways(train, second.name, loads)
    return Ask(
        0.0,
        (teeth[first.name], teeth[second.name]),
        1.0,
        internal=mesh.sign == INTERNAL,
        idlers=idlers,
        passes=(_passes(train, mesh, first, loads), _passes(train, mesh, second, loads)),
        roles=(first.role, second.role),
        held=(mesh.nodes[0] == GROUND, mesh.nodes[1] == GROUND),
        bores=(bore_of(design, first), bore_of(design, second)),
        beyond=(
            _beyond(train, teeth, mesh, first, loads, design) if idlers[0] else None,
            _beyond(train, teeth, mesh, second, loads, design) if idlers[1] else None,
        ),
    )


def bore_of(design: Design, gear: Gear) -> float | None:
    """Return the bore that a design gives to a gear, or the inside of its rim [m]; None where it gives none.

    Args:
        design: As read.
        gear: Of its train.
    """
    stage = design.stages[gear.stage]
    record = stage.toothed[gear.own] if isinstance(stage, Epicyclic) else stage
    name = "bore" if isinstance(stage, Epicyclic) else f"{gear.role.value}_bore"
    bore: float | None = getattr(record, name, None)
    return bore


def _passes(train: Train, mesh: Mesh, gear: Gear, loads: Mapping[str, Sequence[float]]) -> float:
    """Return how many equal mates a tooth of a gear meets in a turn on the flank that a mesh loads [-].

    They are the planets on a sun, the branches of a split pinion, and what drives a wheel that several pairs share.
    """
    own = _torque_on(mesh, gear.name, loads)
    rows = [row for row in train.meshes if gear.name in row.gears and row.sized == mesh.sized and row.row is mesh.row]
    rows += [
        row for row in train.meshes
        if gear.name in row.gears and row.stage != mesh.stage and _alike(own, _torque_on(row, gear.name, loads))
    ]  # fmt: skip
    return max(sum(row.count for row in rows) / gear.bodies, 1.0)


def _alike(own: float, other: float) -> bool:
    return own * other > 0.0 and _ALIKE <= abs(other / own) <= 1.0 / _ALIKE


def _torque_on(mesh: Mesh, gear: str, loads: Mapping[str, Sequence[float]]) -> float:
    """Return the torque per tooth of the largest load on a gear of a mesh, with its sense."""
    load = max(loads[mesh.name], key=abs, default=0.0)
    return load if mesh.gears[0] == gear else -mesh.sign * load


def _beyond(
    train: Train, teeth: Mapping[str, int], mesh: Mesh, idler: Gear, loads: Mapping[str, Sequence[float]],
    design: Design,
) -> FarGear | None:  # fmt: skip
    """Return what an idler of pairs meshes with besides; None of planets, whose meshes the standard takes alone."""
    if idler.role is Role.PLANET:
        return None
    own = _torque_on(mesh, idler.name, loads)
    for row in train.meshes:
        if idler.name in row.gears and row.stage != mesh.stage and own * _torque_on(row, idler.name, loads) < 0.0:
            side = 1 - row.gears.index(idler.name)
            far, inner = train.gear(row.gears[side]), row.sign == INTERNAL and side == 1
            return FarGear(
                -teeth[far.name] if inner else teeth[far.name], far.role, _passes(train, row, far, loads),
                row.nodes[side] == GROUND, bore_of(design, far),
            )  # fmt: skip
    return None


def reverse_parts(train: Train, mesh: Mesh, loads: Mapping[str, Sequence[float]]) -> tuple[float, float]:
    """Return how much less the other flank of both gears of a mesh is loaded [-]; 1 for planets and idlers.

    Args:
        train: The graph.
        mesh: A row of it.
        loads: Mesh row -> least and greatest torque on its first gear [N m].
    """
    return _reverse_part(train, mesh.gears[0], loads), _reverse_part(train, mesh.gears[1], loads)


def _reverse_part(train: Train, gear: str, loads: Mapping[str, Sequence[float]]) -> float:
    own = [mesh for mesh in train.meshes if gear in mesh.gears]
    if len(own) > 1 or not bends_both_ways(train, gear, loads):
        return 1.0
    least, greatest = sorted(map(abs, loads[own[0].name]))
    return least / greatest


def bends_both_ways(train: Train, gear: str, loads: Mapping[str, Sequence[float]]) -> bool:
    """Tell whether the teeth of a gear are loaded on both flanks: by one mate and on to another, or in two cases.

    An idler between two pairs and a planet between sun and ring are driven on one flank and drive with the other; a
    pair that drives in one case and is driven in another has both of its gears so. A planet with two mates or more is
    taken for one whatever the cases are.

    Args:
        train: The graph.
        gear: Name of a gear of it.
        loads: Mesh row -> torque on its first gear in everything that lasts, or in proportion to it, with its sense.

    Source: ISO 6336-3:2019, annex B: Y_M of idlers and planets, 0.7.
    """
    own = [(mesh, mesh.gears.index(gear)) for mesh in train.meshes if gear in mesh.gears]
    if train.gear(gear).role is Role.PLANET and len(own) > 1:
        return True
    torques = [0.0, *(load * (-mesh.sign if side else 1) for mesh, side in own for load in loads[mesh.name])]
    idle = _IDLE * max(map(abs, torques))
    return min(torques) < -idle and max(torques) > idle


# ----------------------------------------------------------------------------------------------------------------------
# A row of meshes rated by the method of its stage under the load cases of the design.
# ----------------------------------------------------------------------------------------------------------------------


REST = "all but roots and flanks"
"""Among what is not asked of sizes: all that is no strength against fatigue."""
AT_WAIVERS = ("main resonance",)
"""Modes of checks of meshes that no size is held against where the design waives them."""
_CREEP = 1e-3
"""Speed of gears that a limit load finds at rest [rad/s]."""
_NONE_ASKED = (0.0, 0.0)


def rate_row(
    context: Context, mesh: Mesh, module: float, face_width: float, *, asked: tuple[float, float] = _NONE_ASKED
) -> MeshRating:
    """Return the rating of one mesh of a row.

    Args:
        context: What sizing reads.
        mesh: A row of the train.
        module: m_n, of bevel gears m_mn [m].
        face_width: b [m].
        asked: Modules that bending and contact ask for, for its record [m].
    """
    loaded = _loaded(context, mesh, module, face_width, asked)
    if isinstance(loaded, Unloaded):
        return loaded
    rated: MeshRating = once(
        context, loaded.rating, ("rating", *loaded[1:]), lambda: method_for(loaded.rating).rate(loaded)
    )
    return rated


def row_reserve(context: Context, mesh: Mesh, module: float, face_width: float) -> float | None:
    """Return by what factor the loads of a row could grow [-]; None where nothing loads it.

    Args:
        context: What sizing reads.
        mesh: A row of the train.
        module: m_n, of bevel gears m_mn [m].
        face_width: b [m].
    """
    loaded = _loaded(context, mesh, module, face_width)
    if isinstance(loaded, Unloaded):
        return None
    reserve: float = once(
        context, loaded.rating, ("reserve", *loaded[1:]), lambda: method_for(loaded.rating).reserve_of(loaded)
    )
    return reserve


def sizes_near(
    context: Context, mesh: Mesh, modules: Floats, face_widths: Floats, left_out: Sequence[str] = ()
) -> Floats | None:
    """Return the least value over limit that the method finds for arrays of sizes of a row, but for what films ask [-].

    None where nothing loads it, and where its method takes sizes one by one.

    Args:
        context: What sizing reads.
        mesh: A row of the train.
        modules: m_n, of bevel gears m_mn [m].
        face_widths: b, of the same shape [m].
        left_out: Modes of checks that are not asked for, with those that are waived.
    """
    loaded = _loaded(context, mesh, modules, face_widths)
    if isinstance(loaded, Unloaded):
        return None
    waived = [mode for mode in AT_WAIVERS if f"{mesh.part} {mode}" in context.design.waivers]
    asked = (*waived, *left_out)
    sizes = modules.tobytes(), face_widths.tobytes()
    found: SizesNear | None = once(
        context, loaded.rating, ("sizes", *sizes, asked, *loaded[3:]),
        lambda: method_for(loaded.rating).of_sizes(loaded, asked),
    )  # fmt: skip
    if found is None:
        return None
    return found.strength if REST in left_out else np.asarray(np.minimum(*found))


def _loaded(
    context: Context, mesh: Mesh, module: Numbers, face_width: Numbers, asked: tuple[float, float] = _NONE_ASKED
) -> LoadedMesh | Unloaded:
    """Return one mesh of a row with all that its life consists of."""
    rating, (case, per_tooth) = context.rating(mesh), worst_case(context, mesh)
    if per_tooth * context.teeth[mesh.gears[0]] <= LEAST_TORQUE:
        return Unloaded(case)
    heaviest = _load(context, mesh, case, rating.service.life)
    loads = tuple(load for load in _loads(context, mesh) if load.torque > LEAST_TORQUE)
    others = tuple(load for load in _others(context, mesh) if load.torque > LEAST_TORQUE)
    return LoadedMesh(rating, module, face_width, heaviest, loads, asked, others)


def _others(context: Context, mesh: Mesh) -> Iterator[Load]:
    """Yield the cases that last where no shares of the life are said."""
    if not shares_of(context.design):
        for case in context.flows:
            if not case_named(context.design, case).static:
                yield _load(context, mesh, case, 0.0)


def _loads(context: Context, mesh: Mesh) -> Iterator[Load]:
    """Yield the cases that make up the life; where none is said, the heaviest lasts all of it."""
    life, shares = context.design.service.life, shares_of(context.design)
    for case, share in (shares or {worst_case(context, mesh)[0]: 1.0}).items():
        for level, part in levels_of(context.design, case):
            if share * part > 0.0:
                yield _load(context, mesh, case, share * part * life, level)
    for case in context.flows:
        if case_named(context.design, case).static:
            yield _once(_load(context, mesh, case, 0.0))


def _once(load: Load) -> Load:
    """Return a limit load as one turn of the first gear: static strength bears it, and no cycles are spent."""
    speed = max(float(np.asarray(load.ask.speed)), _CREEP)
    return load._replace(ask=load.ask._replace(speed=speed), life=2.0 * math.pi / speed, static=True)


def _load(context: Context, mesh: Mesh, case: str, life: float, level: float = 1.0) -> Load:
    multiplier = level * abs(context.flows[case].meshes[mesh.name].multiplier)
    per_tooth = multiplier / mesh.count * context.ratings[mesh.stage].load_factor
    return Load(case, per_tooth * context.teeth[mesh.gears[0]], ask_of(context, mesh, case, per_tooth), life)
