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
from gearwright.spec.design import Given
from gearwright.train import INTERNAL, Gear, Mesh, PowerFlow, Train


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
    return uncovered_teeth(context.ratings[mesh.stage], (first, second), context.design.table(mesh.stage))


def worst_case(context: Context, mesh: Mesh) -> tuple[str, float]:
    """Return the case that loads a mesh most, and its torque per tooth, load factor included [N m].

    Args:
        context: What gear sizing reads.
        mesh: A row of the train.
    """
    loads = {case: abs(flow.meshes[mesh.name].multiplier) for case, flow in context.flows.items()}
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
    speeds = context.flows[case].speeds
    return row_ask(context.train, context.teeth, mesh)._replace(
        per_tooth=per_tooth,
        width_ratio=width_ratio_of(context, mesh.stage),
        speed=abs(speeds[mesh.nodes[0]] - speeds[mesh.nodes[2]]),
    )


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
