"""What every step of sizing reads (the design, its train, teeth and flows, resolved rules), and what each mesh asks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.errors import Problem, refuse
from gearwright.identity import Role
from gearwright.sizing.rating.methods import modules, stage_width_ratio, uncovered_teeth
from gearwright.sizing.rating.rules import Ask, Rating, rating_of
from gearwright.spec import Design
from gearwright.spec.design import RATINGS, Given, case_named
from gearwright.train import INTERNAL, Gear, Mesh, PowerFlow, Train

_IDLE = 1e-6
"""Part of the largest load below which a case does not load the other flank [-]."""


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

    @property
    def reference(self) -> PowerFlow:
        """The case that speaks for the design: the first one."""
        return next(iter(self.flows.values()))


def context_of(
    design: Design, train: Train, teeth: Mapping[str, int], flows: Mapping[str, PowerFlow], given: Mapping[str, Given]
) -> Context:
    """Return what gear sizing reads, with the rules of every stage resolved.

    Args:
        design: The design.
        train: Its graph.
        teeth: Tooth number of every gear.
        flows: Every load case.
        given: Path -> value that the user gives instead of the computed one.
    """
    ratings = {name: rating_of(design, name, teeth) for name in design.stages}
    return Context(design, train, teeth, flows, {path: entry.value for path, entry in given.items()}, ratings)


def demands_of(context: Context) -> dict[str, Demand]:
    """Return mesh row -> what it asks for at its worst case.

    Args:
        context: What gear sizing reads.

    Raises:
        DesignError: Teeth or steels that the method of a stage does not cover; with every stage.
    """
    refuse(problem for mesh in context.train.meshes for problem in _uncovered(context, mesh))
    return {mesh.name: _demand(context, mesh) for mesh in context.train.meshes}


def _uncovered(context: Context, mesh: Mesh) -> Iterator[Problem]:
    first, second = (context.teeth[gear] for gear in mesh.gears)
    signed = (first, -second if mesh.sign == INTERNAL else second)
    return uncovered_teeth(context.ratings[mesh.stage], signed, context.design.table(mesh.stage))


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
    case = max(loads, key=lambda case_name: loads[case_name])
    return case, loads[case] / mesh.count * context.ratings[mesh.stage].load_factor


def _demand(context: Context, mesh: Mesh) -> Demand:
    case, per_tooth = worst_case(context, mesh)
    bending, contact = modules(ask_of(context, mesh, case, per_tooth), context.ratings[mesh.stage])
    return Demand(case, per_tooth, float(bending), float(contact))


def ask_of(context: Context, mesh: Mesh, case: str, per_tooth: float) -> Ask:
    """Return what a load case asks of a mesh.

    Args:
        context: What gear sizing reads.
        mesh: A row of the train.
        case: Of the design.
        per_tooth: Torque per tooth of one mesh, load factor included [N m].
    """
    speeds, ask = context.flows[case].speeds, row_ask(context.train, context.teeth, mesh)
    return ask._replace(
        idlers=(True, True) if reverses(context, mesh) else ask.idlers,
        per_tooth=per_tooth,
        width_ratio=width_ratio_of(context, mesh.stage),
        speed=abs(speeds[mesh.nodes[0]] - speeds[mesh.nodes[2]]),
    )


def reverses(context: Context, mesh: Mesh) -> bool:
    """Tell whether the teeth of a row are loaded on both flanks, in one case on one and in another on the other.

    Their roots then bear alternating bending, as those of idlers (ISO 6336-3:2019, annex B).

    Args:
        context: What gear sizing reads.
        mesh: A row of the train.
    """
    lasting = [flow for case, flow in context.flows.items() if not case_named(context.design, case).static]
    loads = [flow.meshes[mesh.name].multiplier for flow in lasting]
    idle = _IDLE * max(map(abs, loads), default=0.0)
    return min(loads, default=0.0) < -idle and max(loads, default=0.0) > idle


def row_ask(train: Train, teeth: Mapping[str, int], mesh: Mesh) -> Ask:
    """Return teeth and kind of a mesh, without load; a tooth meets as many mates in a turn as equal ones pass it.

    Args:
        train: The graph.
        teeth: Tooth number of every gear [-].
        mesh: A row of the train.
    """
    first, second = (train.gear(gear) for gear in mesh.gears)
    return Ask(
        0.0,
        (teeth[first.name], teeth[second.name]),
        1.0,
        internal=mesh.sign == INTERNAL,
        idlers=(_is_idler(train, first), _is_idler(train, second)),
        passes=(max(mesh.count / first.bodies, 1.0), max(mesh.count / second.bodies, 1.0)),
    )


def _is_idler(train: Train, gear: Gear) -> bool:
    """Tell whether a gear is loaded on both flanks: a planet with two mates or more, not a step with one."""
    return gear.role is Role.PLANET and sum(gear.name in mesh.gears for mesh in train.meshes) > 1


def width_ratio_of(context: Context, stage: str) -> float:
    """Return λ = b/m_n of a stage before its face width is rounded or given [-].

    Args:
        context: What gear sizing reads.
        stage: Pair or planetary set.
    """
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    small, large = (context.teeth[gear] for gear in mesh.gears)
    return float(stage_width_ratio(context.ratings[stage], small, large))
