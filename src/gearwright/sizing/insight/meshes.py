"""The sized meshes of a design as their methods rated them, to be rated again with something changed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from gearwright.sizing.rating import Context, MeshRating, Rating, context_of, rate_row
from gearwright.sizing.result import Sizing
from gearwright.train import Mesh


class SizedMesh(NamedTuple):
    """A row of meshes with what rates it."""

    context: Context
    """What sizing read."""
    row: Mesh
    """Of the train."""
    module: float
    """m_n, of bevel gears m_mn [m]."""
    face_width: float
    """b [m]."""

    @property
    def rating(self) -> Rating:
        """Rules of its stage."""
        return self.context.rating(self.row)

    def rated(self, rating: Rating | None = None) -> MeshRating:
        """Return the rating, by other rules if they are given.

        Args:
            rating: Instead of the design's rules.
        """
        rules = self.rating if rating is None else rating
        context = replace(self.context, ratings={**self.context.ratings, self.row.stage: rules})
        return rate_row(context, self.row, self.module, self.face_width)


def sized_meshes(sizing: Sizing) -> Iterator[SizedMesh]:
    """Yield every row of meshes of a sized design that a load case loads.

    Args:
        sizing: As sized.
    """
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    sizes = {gear.name: (gear.module, gear.face_width) for gear in sizing.gears}
    rows = {mesh.name: mesh for mesh in sizing.train.meshes}
    for mesh in sizing.meshes:
        if mesh.rating.method:
            yield SizedMesh(context, rows[mesh.name], *sizes[mesh.gears[0]])
