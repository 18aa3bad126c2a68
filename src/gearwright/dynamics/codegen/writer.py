"""Writer: what the generated functions of one structure share: widths of arrays, parameters, the clock table."""

from __future__ import annotations

from collections import Counter

from gearwright.dynamics.codegen.emit import CHUNK, Emitter, vector
from gearwright.dynamics.codegen.topology import Layout, Topology, filled
from gearwright.dynamics.model import OUTPUTS


def wave_width(shape: Topology, clocks: int = 1, width: int = CHUNK) -> int:
    """Return the numbers that hold the cosines of all tones, filled up to whole vectors; the sines take as many.

    Args:
        shape: Structure.
        clocks: Clocks side by side: one for all lanes, or one for each.
        width: Numbers in a vector.
    """
    return -(-shape.tones * clocks // width) * width


def table_width(shape: Topology, clocks: int = 1, width: int = CHUNK) -> int:
    """Return the numbers in a row of the clock table: cosines, sines, s, ṡ, scheduled loads, drives' inputs.

    Args:
        shape: Structure.
        clocks: Clocks side by side.
        width: Numbers in a vector.
    """
    return 2 * wave_width(shape, clocks, width) + (2 + len(shape.scheduled) + shape.drives.inputs) * clocks


def record_width(shape: Topology) -> int:
    """Return the numbers in a row of a record, filled up to whole vectors: q, q̇, line forces, deflections, drives.

    Args:
        shape: Structure.
    """
    return filled(2 * (shape.size + len(shape.lines)) + drive_width(shape))


def drive_width(shape: Topology) -> int:
    """Return the numbers that drives add to a row: their states, and what each reports.

    Args:
        shape: Structure.
    """
    return shape.drives.states + OUTPUTS * len(shape.drives.records)


class Writer:
    """Writes the functions of one structure; `own` names the numbers that each lane has to itself."""

    def __init__(self, shape: Topology, layout: Layout, lanes: int, own: frozenset[str]) -> None:
        self.shape, self.layout, self.lanes, self.own = shape, layout, lanes, own
        self.count = len(shape.lines)
        self.clocks = lanes if "clock" in own else 1
        self.width, self.vector, self.kind = max(CHUNK, lanes), vector(lanes), Emitter(lanes).number
        self.books = lanes == 1
        """Whether works are kept: nobody reads those of trajectories side by side."""
        self.uses = Counter(pair for line in shape.lines for pair in zip(line.dofs, line.weights, strict=True))

    @property
    def waves(self) -> int:
        """Numbers that hold the cosines of all tones."""
        return wave_width(self.shape, self.clocks, self.width)

    def cells(self, count: int) -> list[range]:
        """Return which of so many numbers of a trajectory stand together in each vector.

        Args:
            count: Numbers.
        """
        side = self.width // self.lanes
        return [range(first, min(first + side, count)) for first in range(0, count, side)]

    def function(self, code: Emitter, name: str, pointers: tuple[str, ...]) -> str:
        """Return a function.

        Args:
            code: Its body.
            name: Its name.
            pointers: Names of what it is given; with ``"bv"`` it also takes the factors c and share.
        """
        arguments = ", ".join(f"ptr noalias %{pointer}" for pointer in pointers)
        factors = f", {self.vector} %c, {self.vector} %share" if "bv" in pointers else ""
        head = f'define internal void @{name}({arguments}{factors}) noinline nounwind "stackrealign" {{'
        return "\n".join([head, *code.lines, "  ret void", "}"])

    def whole(self, code: Emitter, group: str, index: int) -> str:
        """Load a vector of parameters: of several lines or coordinates, or of all lanes.

        Args:
            code: Body.
            group: Field of `Layout`.
            index: First number.
        """
        place = getattr(self.layout, group) + index
        if self.lanes == 1:
            return code.wide.load("%p", place)
        return code.load("%own", self.lanes * place) if group in self.own else code.spread("%p", place)

    def number(self, code: Emitter, group: str, index: int) -> str:
        """Load a parameter: each lane's own, or one for all.

        Args:
            code: Body.
            group: Field of `Layout`.
            index: Number.
        """
        place = getattr(self.layout, group) + index
        return code.load("%own", self.lanes * place) if group in self.own else code.spread("%p", place)

    def clock(self, code: Emitter, column: int) -> str:
        """Load a column of the clock table after the waves.

        Args:
            code: Body.
            column: 0 for s, 1 for ṡ, then scheduled loads and drives' inputs.
        """
        return self.shared(code, "%row", 2 * self.waves, column)

    def shared(self, code: Emitter, pointer: str, first: int, index: int) -> str:
        """Load what the clock decides: each lane's own, or one for all.

        Args:
            code: Body.
            pointer: Array.
            first: Where in it the numbers begin.
            index: Number.
        """
        place = first + self.clocks * index
        return code.load(pointer, place) if self.clocks > 1 else code.spread(pointer, place)
