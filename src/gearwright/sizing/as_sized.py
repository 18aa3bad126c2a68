"""The rules of a stage as its gears are sized: with its K_γ, and the flank class that its speed gave."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.rating import Made, Rating, rating_of
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.result import Sizing


def rating_as_sized(sizing: Sizing, stage: str) -> Rating:
    """Return the resolved rules of a stage with K_γ and flank class as its gears are sized.

    Args:
        sizing: As sized.
        stage: Pair or set.
    """
    rating = rating_of(sizing.design, stage, sizing.teeth)
    meshes = [mesh for mesh in sizing.meshes if mesh.stage == stage]
    rating = replace(rating, load_factor=max((mesh.load_factor for mesh in meshes), default=rating.load_factor))
    classes = [made.grade for made in _made(meshes)]
    if rating.rules.iso6336.tolerance_class is not None or not classes:
        return rating
    table = rating.rules.iso6336.model_copy(update={"tolerance_class": int(min(classes))})
    return replace(rating, rules=rating.rules.model_copy(update={"iso6336": table}))


def made_of(mesh: MeshSizing) -> Made | None:
    """Return relief and class of the teeth of a mesh; None where its method knows none.

    Args:
        mesh: As sized.
    """
    return mesh.rating.made if isinstance(mesh.rating, Iso6336Rating) else None


def gear_relief(sizing: Sizing, gear: str) -> float | None:
    """Return the tip relief of a gear, the least of those of its meshes [m]; None where its method knows none.

    Args:
        sizing: As sized.
        gear: Its name.
    """
    reliefs = [made.relief for made in _made(mesh for mesh in sizing.meshes if gear in mesh.gears)]
    return min(reliefs, default=None)


def _made(meshes: Iterator[MeshSizing] | list[MeshSizing]) -> Iterator[Made]:
    return (made for mesh in meshes if (made := made_of(mesh)) is not None)
