"""A transmission as far as its gears decide it: teeth become modules, widths, meshes, and the checks of the gears.

What carries them comes after; of several choices of teeth only the one that is taken goes on to it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gearwright.checks import Check, accepted
from gearwright.errors import Problem, refuse
from gearwright.sizing.limits import refuse_beyond
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import Context, Demand, Known, context_of, demands_of
from gearwright.sizing.result import GearSizing
from gearwright.sizing.stages.bores import bores_beyond_roots
from gearwright.sizing.stages.compound_sizes import compound_sizes
from gearwright.sizing.stages.gear_checks import gear_checks
from gearwright.sizing.stages.gears import size_gears, size_meshes
from gearwright.sizing.stages.pass_checks import pass_checks
from gearwright.sizing.stages.sharing_by_size import ROUNDS, STILL, sharing_of_sizes
from gearwright.sizing.stages.stage_sizes import StageSize, stage_sizes
from gearwright.sizing.teeth import Chosen, made_share, refuse_contradictions
from gearwright.spec import Design, edited
from gearwright.spec.checks import relief_problem
from gearwright.spec.design import Given
from gearwright.train import Train, Turning, build_train, power_flows


@dataclass(frozen=True)
class Geared:
    """Gears of chosen teeth."""

    context: Context
    gears: tuple[GearSizing, ...]
    """External ones as solid discs."""
    meshes: tuple[MeshSizing, ...]
    checks: tuple[Check, ...]
    """Of roots, flanks, scuffing, contact ratio, undercut, tips, interference, rims and frequencies."""
    sizes: Mapping[str, StageSize]
    demands: Mapping[str, Demand]
    choice: Chosen

    @property
    def heaviness(self) -> dict[str, float]:
        """Stage -> b m_n² of its gears over that of the module and width that its heaviest case asks for [-]."""
        needed = dict[str, float]()
        for mesh in self.context.train.meshes:
            if mesh.sized in self.sizes:
                needed[mesh.sized] = max(needed.get(mesh.sized, 0.0), *self.demands[mesh.name][2:])
        ratios = self.context.width_ratios
        return {
            stage: self.sizes[stage].face_width * self.sizes[stage].module ** 2 / (ratios[stage] * module**3)
            for stage, module in needed.items()
            if stage in ratios
        }

    @property
    def nearness(self) -> dict[str, float]:
        """Stage -> least value over limit of all that is asked of its gears, but for what is waived [-]."""
        least = dict[str, float]()
        for check in accepted(self.checks, self.context.design.waivers):
            if check.ratio is not None and not check.waiver:
                least[check.part.name] = min(least.get(check.part.name, math.inf), check.ratio)
        return least

    @property
    def mass(self) -> float:
        """What the gears weigh with rims, webs and bores by the estimate of the search [kg]."""
        return sum(_mass(self.context, gear) for gear in self.gears)


def _mass(context: Context, gear: GearSizing) -> float:
    solid = gear.name in context.train.internal
    share = 1.0 if solid else made_share(gear.role, gear.teeth, context.ratings[gear.stage].rules)
    return gear.bodies * gear.mass * share


def geared(
    design: Design, train: Train, choice: Chosen, *, given: Mapping[str, Given], known: Known | None = None
) -> Geared:
    """Return the gears of chosen teeth and numbers of planets.

    Args:
        design: As read.
        train: Its graph.
        choice: Teeth, and numbers of planets that the design leaves open.
        given: Path -> value that the user gives instead of the computed one.
        known: What meshes have given with other teeth of the design, and are to give.

    Raises:
        DesignError: If torques contradict each other, machines have too little power, or teeth are not covered.
    """
    teeth = choice.teeth
    if choice.planets:
        design = edited(design, {f"planetaries.{stage}.planets": count for stage, count in choice.planets.items()})
        train = build_train(design)
    flows = power_flows(design, Turning(design, train, teeth), efficiency=design.efficiencies)
    refuse_contradictions(design, flows)
    refuse_beyond(design, flows)
    sharing: Mapping[str, float] = {}
    for _ in range(ROUNDS):
        context = context_of(design, train, teeth, flows, given, known=known, sharing=sharing)
        demands = demands_of(context)
        sizes = stage_sizes(context, demands) | compound_sizes(context, demands)
        gears = size_gears(context, sizes)
        meshes = size_meshes(context, gears, demands)
        before, sharing = sharing, sharing_of_sizes(context, gears, meshes)
        if all(abs(factor - before.get(stage, 0.0)) < STILL for stage, factor in sharing.items()):
            break
    refuse((*bores_beyond_roots(context, gears), *_reliefs(context, gears, meshes)))
    checks = (*gear_checks(context, gears, meshes, sizes), *pass_checks(context))
    return Geared(context, gears, meshes, checks, sizes, demands, choice)


def _reliefs(context: Context, gears: Sequence[GearSizing], meshes: Sequence[MeshSizing]) -> Iterator[Problem]:
    """Yield stated tip reliefs that are too large for the modules that stages have come to.

    By the gears in mesh, since a pair between gears of two other stages has none of its own.
    """
    modules = {gear.name: gear.module for gear in gears}
    for stage in context.design.stages:
        module = min(modules[gear] for mesh in meshes if mesh.stage == stage for gear in mesh.gears)
        if (problem := relief_problem(context.design, stage, module)) is not None:
            yield problem
