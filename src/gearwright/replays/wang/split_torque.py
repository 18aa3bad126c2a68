"""The face-gear split torque of Wang, Zhao, Tao, Jia & Guo, known by its train and its data, whatever its names are.

A pinion between two face gears drives two layshafts, whose pinions drive one wheel.
"""

from __future__ import annotations

from typing import NamedTuple

from gearwright.identity import Role, gear_part
from gearwright.spec import Design, Pair
from gearwright.verbs import verb

FIRST_FIGURE = 8
"""Number of the paper's first figure on one error alone."""


class SplitTorque(NamedTuple):
    """Names of its parts."""

    face: str
    """Pair of the pinion with the two face gears."""
    joining: str
    """Pair at which the paths join."""
    pinion: str
    """Shaft 1, which floats."""
    paths: tuple[str, str]
    """Shafts 2 and 3."""
    output: str
    """Shaft 4."""

    @property
    def gears(self) -> tuple[str, ...]:
        """Bodies of gears 1 to 6."""
        left, right = self.paths
        gears = (
            gear_part(self.face, Role.PINION),
            gear_part(self.face, Role.WHEEL, left),
            gear_part(self.face, Role.WHEEL, right),
            gear_part(self.joining, Role.PINION, left),
            gear_part(self.joining, Role.PINION, right),
            gear_part(self.joining, Role.WHEEL),
        )
        return tuple(map(str, gears))

    @property
    def shafts(self) -> tuple[str, ...]:
        """Shafts 1 to 4."""
        return (self.pinion, *self.paths, self.output)

    @property
    def single_errors(self) -> dict[str, str]:
        """Error -> the paper's figure on it alone."""
        eccentric = [f"{part} eccentricity" for part in (*self.gears, self.pinion, *self.paths)]
        axial = [f"{shaft} axial" for shaft in self.paths]
        return {error: f"Fig. {number}" for number, error in enumerate([*eccentric, *axial], start=FIRST_FIGURE)}


@verb
def split_torque(design: Design) -> SplitTorque | None:
    """Return the parts of a face-gear split torque that has the support and the errors of the paper's figures.

    Args:
        design: Any.

    Returns:
        None if the train is another one, or if shaft 1 has no support or a part not the error that a figure shows.

    Source: Wang, Zhao, Tao, Jia & Guo, "Floating shaft load sharing method for face gear split torque transmission
        system".
    """
    parts = _parts(design)
    return parts if parts is not None and parts.pinion in design.supports and _has_errors(design, parts) else None


def _parts(design: Design) -> SplitTorque | None:
    if len(design.stages) != 2 or len(design.pairs) != 2:
        return None
    for face, joining in (tuple(design.pairs), tuple(design.pairs)[::-1]):
        first, second = design.pairs[face], design.pairs[joining]
        if first.kind == "face" and second.kind == "cylindrical" and not second.internal:
            return _joined(face, joining, first, second)
    return None


def _joined(face: str, joining: str, first: Pair, second: Pair) -> SplitTorque | None:
    if not (isinstance(first.pinion, str) and isinstance(second.wheel, str)):
        return None
    if isinstance(first.wheel, str) or len(first.wheel) != 2 or sorted(first.wheel) != sorted(second.pinion):
        return None
    left, right = first.wheel
    return SplitTorque(face, joining, first.pinion, (left, right), second.wheel)


def _has_errors(design: Design, parts: SplitTorque) -> bool:
    eccentric = all(
        part in design.errors and design.errors[part].eccentricity for part in (*parts.gears, *parts.shafts)
    )
    return eccentric and all(design.errors[shaft].axial for shaft in parts.paths)
