"""Stages as they would be with another module and width: what their strengths say there, and what they would fill."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from gearwright.checks import Check
from gearwright.sizing.rating import Context, Rating, Unloaded, context_of, method_for, overlap_width, rate_row
from gearwright.sizing.result import Sizing
from gearwright.spec import Design
from gearwright.spec.design import given_values
from gearwright.train import INTERNAL, Mesh


@dataclass(frozen=True)
class Trial:
    """Every stage of a design, its teeth and loads as they were sized."""

    context: Context

    @property
    def design(self) -> Design:
        """With the rules by which it is rated."""
        return self.context.design

    @property
    def given(self) -> Mapping[str, float]:
        """Path -> value that the design gives [SI]."""
        return self.context.given

    def rating(self, stage: str) -> Rating:
        """Return the resolved rules of a stage.

        Args:
            stage: Pair or set.
        """
        return self.context.ratings[stage]

    def rows(self, stage: str) -> list[Mesh]:
        """Return the mesh rows of a stage.

        Args:
            stage: Pair or set.
        """
        return [mesh for mesh in self.context.train.meshes if mesh.stage == stage]

    def widest(self, stage: str, module: float) -> float:
        """Return the widest face that the rules of a stage call usual [m].

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
        """
        rating = self.rating(stage)
        limits, teeth = rating.proportions, self.context.teeth[self.rows(stage)[0].gears[0]]
        if limits is None:
            return math.inf
        diameter = module * teeth / math.cos(rating.helix_angle)
        return min(limits.widest_modules * module, limits.widest_diameters * diameter)

    def least(self, stage: str, module: float) -> float:
        """Return the narrowest face that the rules of a stage allow: that of the overlap ratio [m].

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
        """
        return overlap_width(self.rating(stage), module)

    def checks(self, stage: str, module: float, width: float) -> Iterator[Check]:
        """Yield what the method of a stage says of its meshes at a size, those of strength and of the oil film.

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
            width: b [m].
        """
        train, method = self.context.train, method_for(self.rating(stage))
        for mesh in self.rows(stage):
            rated = rate_row(self.context, mesh, module, width)
            if not isinstance(rated, Unloaded):
                first, second = (train.gear(gear).part for gear in mesh.gears)
                yield from method.checks(rated, mesh.part, (first, second))

    def volume(self, stage: str, module: float, width: float) -> float:
        """Return what the gears of a stage fill as cylinders, rings as their wall [m³].

        Args:
            stage: Of cylindrical gears.
            module: m_n [m].
            width: b [m].
        """
        rating, rows, total = self.rating(stage), self.rows(stage), 0.0
        inner = {mesh.gears[1] for mesh in rows if mesh.sign == INTERNAL}
        for gear in {name for mesh in rows for name in mesh.gears}:
            pitch = module * self.context.teeth[gear] / math.cos(rating.helix_angle)
            wall = pitch + 2.0 * rating.rules.rim_thickness_ratio * module
            area = wall**2 - pitch**2 if gear in inner else pitch**2
            total += self.context.train.gear(gear).bodies * math.pi / 4.0 * area * width
        return total


def trial_of(design: Design, sizing: Sizing) -> Trial:
    """Return the stages of a design to be tried, with the teeth and loads of a sizing.

    Args:
        design: The rules, and what is given.
        sizing: Of it, or of one with the same teeth and cases.
    """
    given = given_values(design).values
    return Trial(context_of(design, sizing.train, sizing.teeth, sizing.flows, given))
