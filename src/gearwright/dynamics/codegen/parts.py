"""Parts: the right-hand side of a large structure as many small functions, so that compiling it grows with its lines.

Lines, coordinates and frames are taken a few at a time, in the order and with the operations of `generate.slope`; what
one part leaves to the next (line forces, forces on coordinates, works) goes through memory.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from gearwright.dynamics.codegen.driven import Output, drive_laws
from gearwright.dynamics.codegen.emit import Emitter
from gearwright.dynamics.codegen.generate import (
    PART,
    Pulls,
    Registers,
    carried_by,
    frame_forces,
    frames_of,
    loads,
    next_stage,
    pulled,
    pulls_of,
)
from gearwright.dynamics.codegen.topology import filled
from gearwright.dynamics.codegen.writer import Writer
from gearwright.dynamics.equations import WORKS

SPLIT = 120
"""Lines above which a right-hand side is written in parts: below, registers carry more and compiling is quick."""
COORDINATES = 16
"""Coordinates of a part, whole vectors."""
ENTRIES = 64
"""Gyroscopic or centripetal entries of a part."""
_STAGE = ("p", "own", "row", "now", "bq", "bv", "q", "v", "qn", "vn", "works", "out")
_INSIDE = ("p", "own", "row", "now", "q", "v", "out", "pull", "force", "sums", "torque")


@dataclass
class Memory:
    """Numbers in memory that are loaded when they are asked for, and stored at the end if they were changed."""

    code: Emitter
    """Body."""
    pointer: str
    """Where the numbers begin."""
    changed: dict[int, str] = field(default_factory=dict)
    """Names of the values that are to be stored."""

    def __getitem__(self, number: int) -> str:
        if number in self.changed:
            return self.changed[number]
        return self.code.load(self.pointer, number * self.code.lanes)

    def __setitem__(self, number: int, value: str) -> None:
        self.changed[number] = value

    def store(self) -> None:
        """Store what was changed."""
        for number, value in self.changed.items():
            self.code.store(value, self.pointer, number * self.code.lanes)


_Part = Callable[[Writer, Emitter, int, Memory, Pulls, Output], None]


def slope_in_parts(writer: Writer, name: str, output: Output) -> str:
    """Return the functions that work out what `generate.slope` does, the one of that name last.

    Args:
        writer: Of the structure.
        name: Of the function that calls the others.
        output: As there.
    """
    shape, functions, calls = writer.shape, list[str](), list[str]()
    pulls = pulls_of(shape.lines)
    steps: list[tuple[_Part, int]] = [(_lines, first) for first in range(0, writer.count, PART)]
    steps += [(_coordinates, first) for first in range(0, shape.size, COORDINATES)]
    steps += [(_frames, first) for first in range(0, len(frames_of(writer)), ENTRIES)]
    for number, (part, first) in enumerate(steps):
        code = Emitter(writer.lanes)
        sums = Memory(code, "%sums")
        part(writer, code, first, sums, pulls, output)
        if writer.books:
            sums.store()
        functions.append(writer.function(code, f"{name}{number}", _INSIDE))
        calls.append(f"  call void @{name}{number}({', '.join(f'ptr %{pointer}' for pointer in _INSIDE)})")
    whole, lanes = Emitter(writer.lanes), writer.lanes
    rooms = {"pull": writer.count * lanes, "force": filled(shape.size * lanes), "sums": filled(WORKS * lanes)}
    whole.lines += [f"  %{room} = alloca [{numbers} x {whole.number}], align 64" for room, numbers in rooms.items()]
    if shape.drives.records:
        drive_laws(writer, whole, output)
    else:
        whole.lines.append("  %torque = alloca [1 x double], align 64")
    for number in range(WORKS):
        whole.store(whole.zero, "%sums", number * lanes)
    whole.lines += calls
    force, works = Memory(whole, "%force"), Memory(whole, "%sums")
    next_stage(writer, whole, force, [works[number] for number in range(WORKS)])
    return "\n\n".join([*functions, writer.function(whole, name, _STAGE)])


def _lines(writer: Writer, code: Emitter, first: int, sums: Memory, _: Pulls, output: Output) -> None:
    """Write the forces of some lines."""
    position, velocity, pull = Memory(code, "%q"), Memory(code, "%v"), Memory(code, "%pull")
    for j in range(first, min(first + PART, writer.count)):
        pull[j] = carried_by(writer, code, j, (position, velocity, sums), output)
    pull.store()


def _coordinates(writer: Writer, code: Emitter, first: int, sums: Memory, pulls: Pulls, _: Output) -> None:
    """Write the forces on some coordinates, but for those of frames."""
    dofs = range(first, min(first + COORDINATES, writer.shape.size))
    force, here = Memory(code, "%force"), {dof: pulls[dof] for dof in dofs if dof in pulls}
    for dof in dofs:
        force[dof] = code.zero
    loads(writer, code, dofs, (Memory(code, "%v"), force, sums), writer.clock(code, 0))
    pulled(writer, code, here, (dofs, Memory(code, "%pull"), force))
    force.store()


def _frames(writer: Writer, code: Emitter, first: int, sums: Memory, _: Pulls, __: Output) -> None:
    """Write the forces of some entries of frames."""
    force = Memory(code, "%force")
    state = Registers(Memory(code, "%q"), Memory(code, "%v"), force, sums)
    frame_forces(writer, code, frames_of(writer)[first : first + ENTRIES], state, writer.clock(code, 0))
    force.store()
