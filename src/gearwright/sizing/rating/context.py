"""What every step of sizing reads (the design, its train, teeth and flows, resolved rules), and what each mesh asks."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

from gearwright.errors import Problem, refuse
from gearwright.identity import Role
from gearwright.ranking import largest
from gearwright.sizing.rating.methods import modules, stage_width_ratio, uncovered_teeth
from gearwright.sizing.rating.rules import Ask, Rating, rating_of
from gearwright.spec import Design
from gearwright.spec.design import RATINGS, Given, case_named
from gearwright.train import INTERNAL, Mesh, PowerFlow, Train

_IDLE = 1e-6
"""Part of the largest load below which a case does not load the other flank [-]."""


Known = dict[tuple[Any, ...], list[tuple[Rating, Any]]]
"""Load, teeth and size of a mesh -> what it gave, by the rules that it gave it for."""

_REMEMBERED: ContextVar[Known | None] = ContextVar("remembered", default=None)


@contextmanager
def remembering() -> Iterator[None]:
    """Let all sizings within share what meshes give: equal meshes give the same bits, whichever design they are of."""
    token = _REMEMBERED.set(remembered())
    try:
        yield
    finally:
        _REMEMBERED.reset(token)


def remembered() -> Known:
    """Return what meshes have given so far where sizings share it; else nothing."""
    shared = _REMEMBERED.get()
    return {} if shared is None else shared


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
    known: Known = field(default_factory=dict, compare=False, repr=False)
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
        rows = {mesh.name: row_ask(self.train, self.teeth, mesh, self.lasting) for mesh in self.train.meshes}
        return {
            mesh.name: rows[mesh.name]._replace(width_ratio=self.width_ratios[mesh.stage]) for mesh in self.train.meshes
        }

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
        known: What meshes of the design have given with other teeth; left out: what is remembered.
    """
    ratings = {name: rating_of(design, name, teeth) for name in design.stages}
    values = {path: entry.value for path, entry in given.items()}
    return Context(design, train, teeth, flows, values, ratings, remembered() if known is None else known)


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
    results = context.known.setdefault(key, [])
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
    speeds = context.flows[case].speeds
    speed = abs(speeds[mesh.nodes[0]] - speeds[mesh.nodes[2]])
    return context.asks[mesh.name]._replace(per_tooth=per_tooth, speed=speed)


def row_ask(train: Train, teeth: Mapping[str, int], mesh: Mesh, loads: Mapping[str, Sequence[float]]) -> Ask:
    """Return teeth and kind of a mesh, without load; a tooth meets as many mates in a turn as equal ones pass it.

    Args:
        train: The graph.
        teeth: Tooth number of every gear [-].
        mesh: A row of the train.
        loads: Mesh row -> torque on its first gear in everything that lasts, or in proportion to it, with its sense.
    """
    first, second = (train.gear(gear) for gear in mesh.gears)
    return Ask(
        0.0,
        (teeth[first.name], teeth[second.name]),
        1.0,
        internal=mesh.sign == INTERNAL,
        idlers=(bends_both_ways(train, first.name, loads), bends_both_ways(train, second.name, loads)),
        passes=(max(mesh.count / first.bodies, 1.0), max(mesh.count / second.bodies, 1.0)),
        roles=(first.role, second.role),
    )


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
