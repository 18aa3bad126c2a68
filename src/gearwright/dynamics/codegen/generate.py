"""Generated right-hand side of the equations of motion with its Runge–Kutta loop, compiled in memory."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Literal, NamedTuple, Protocol

from gearwright.base import Floats
from gearwright.dynamics.codegen.assembler import CHUNK, Emitter, address, machine_code, splat
from gearwright.dynamics.codegen.excitation import KINDS, laws
from gearwright.dynamics.codegen.topology import (
    Layout,
    LineShape,
    Topology,
    Writer,
    drive_width,
    filled,
    record_width,
    slots,
    table_width,
    wave_width,
)
from gearwright.dynamics.equations import WORKS
from gearwright.dynamics.model import HEADER, OUTPUTS

# ----------------------------------------------------------------------------------------------------------------------
# Driven: what propellers, machines and clutches do, as calls of their laws in generated code.
# ----------------------------------------------------------------------------------------------------------------------


Output = Literal["", "record", "statistics"]
"""What a slope keeps of the lines."""
DECLARATIONS = "\n".join(f"declare double @{name}(ptr, ptr, ptr, ptr, ptr, double)" for name in KINDS)
"""Of the laws; an address would be one of this process alone."""


def drive_laws(writer: Writer, code: Emitter, output: Output) -> None:
    """Call the drives' laws: they fill torques, the rates of their states, and what they report.

    Args:
        writer: Of the structure.
        code: Body.
        output: What is kept.
    """
    shape = writer.shape
    rooms = {"torque": shape.size, "rate": filled(shape.drives.states), "unseen": drive_width(shape)}
    code.lines += [f"  %{name} = alloca [{room} x double], align 64" for name, room in rooms.items()]
    factor, states = writer.clock(code, 0), filled(shape.size)
    inputs = 2 * wave_width(shape) + 2 + len(shape.scheduled)
    report = ("%out", 2 * writer.count) if output == "record" else ("%unseen", 0)
    for number in range(shape.drives.states):
        code.store(code.load("%v", states + number), report[0], report[1] + number)
    torque = dict.fromkeys(shape.drives.dofs, code.zero)
    for number, record in enumerate(shape.drives.records):
        place = writer.layout.drives + record.place
        speed = code.add(code.multiply(code.load("%p", place + 3), factor), code.load("%v", record.dof))
        if record.second >= 0:
            other = code.multiply(code.load("%p", place + 5), factor)
            speed = code.subtract(speed, code.add(other, code.load("%v", record.second)))
        seen = report[1] + shape.drives.states + OUTPUTS * number
        places = (("%p", place + HEADER), ("%row", inputs + record.reads), ("%v", states + record.state),
                  ("%rate", record.state), (report[0], seen))  # fmt: skip
        given = ", ".join(f"ptr {code.at(*each)}" for each in places)
        value = code.value(f"call double @{KINDS[record.kind]}({given}, double {speed})")
        torque[record.dof] = code.add(torque[record.dof], value)
        if record.second >= 0:
            torque[record.second] = code.subtract(torque[record.second], value)
    for dof, value in torque.items():
        code.store(value, "%torque", dof)


# ----------------------------------------------------------------------------------------------------------------------
# Generate: the right-hand side of a structure as straight-line LLVM assembly, with the next stage of a step.
#
# `instant` works out beforehand what the clock decides; `march` joins the two to a loop.
# ----------------------------------------------------------------------------------------------------------------------


Pulls = dict[int, dict[tuple[int, int], list[int]]]
"""Lines that pull on each coordinate, by the number and the sign of their weight."""
Frame = Literal["gyroscopic", "centripetal"]
"""Kind of entry."""
PART = 8
"""Lines that share what they have loaded: among more, registers run out."""


class Numbers(Protocol):
    """Values by number."""

    def __getitem__(self, number: int, /) -> str:
        """Return the name of a value."""

    def __setitem__(self, number: int, value: str, /) -> None:
        """Give a number another value."""


def slope(writer: Writer, name: str, output: Output) -> str:
    """Return the function that works out the forces at (q, q̇) and from them the next stage of a step.

    The next stage is (bq + c q̇, bv + c q̈); the works grow by their rates times a share.

    Args:
        writer: Of the structure.
        name: Of the function.
        output: ``"record"`` keeps forces and deflections, ``"statistics"`` least, most and sums of forces.
    """
    code, works = Emitter(writer.lanes), [Emitter(writer.lanes).zero] * WORKS
    if writer.shape.drives.records:
        drive_laws(writer, code, output)
    carried = []
    for j in range(writer.count):
        if j % PART == 0:
            code.part(f"lines{j}")
            position, velocity = (_state(writer, code, name) for name in ("%q", "%v"))
        carried.append(carried_by(writer, code, j, (position, velocity, works), output))
    code.part("next")
    position, velocity = (_state(writer, code, name) for name in ("%q", "%v"))
    factor = writer.clock(code, 0)
    force, everything = [code.zero] * writer.shape.size, range(writer.shape.size)
    loads(writer, code, everything, (velocity, force, works), factor)
    pulled(writer, code, pulls_of(writer.shape.lines), (everything, carried, force))
    frame_forces(writer, code, frames_of(writer), Registers(position, velocity, force, works), factor)
    next_stage(writer, code, force, works)
    pointers = ("p", "own", "row", "now", "bq", "bv", "q", "v", "qn", "vn", "works", "out")
    return writer.function(code, name, pointers)


def _state(writer: Writer, code: Emitter, pointer: str) -> list[str]:
    return [code.load(pointer, i * writer.lanes) for i in range(writer.shape.size)]


def next_stage(writer: Writer, code: Emitter, force: Numbers, works: Numbers) -> None:
    """Store the next stage and let the works grow.

    Args:
        writer: Of the structure.
        code: Body.
        force: On each coordinate.
        works: Rates of the works.
    """
    wide = code.wide
    for number, cell in enumerate(writer.cells(writer.shape.size)):
        place = writer.width * number
        rate = wide.multiply(code.join([force[i] for i in cell]), writer.whole(code, "mobility", cell[0]))
        position = wide.add(wide.load("%bq", place), wide.multiply("%c", wide.load("%v", place)))
        wide.store(position, "%qn", place)
        wide.store(wide.add(wide.load("%bv", place), wide.multiply("%c", rate)), "%vn", place)
    for place in range(0, writer.shape.drives.states, CHUNK):
        gain, there = wide.multiply("%c", wide.load("%rate", place)), filled(writer.shape.size) + place
        wide.store(wide.add(wide.load("%bv", there), gain), "%vn", there)
    for number, cell in enumerate(writer.cells(WORKS) if writer.books else []):
        if any(works[i] != code.zero for i in cell):
            rate, before = code.join([works[i] for i in cell]), wide.load("%works", CHUNK * number)
            wide.store(wide.add(before, wide.multiply("%share", rate)), "%works", CHUNK * number)


def loads(writer: Writer, code: Emitter, dofs: range, parts: tuple[Numbers, Numbers, Numbers], factor: str) -> None:
    """Fill in the external load of some coordinates, and the first two powers.

    Args:
        writer: Of the structure.
        code: Body.
        dofs: Coordinates.
        parts: Velocities; forces and rates of the works, which are filled.
        factor: s.
    """
    shape, (velocity, force, works) = writer.shape, parts
    for i, damped, squared in shape.loaded:
        if i not in dofs:
            continue
        total = code.add(code.multiply(writer.number(code, "speed", i), factor), velocity[i])
        load = writer.number(code, "constant", i)
        for number, dof in enumerate(shape.scheduled):
            if dof == i:
                load = code.add(load, writer.clock(code, 2 + number))
        if damped:
            load = code.subtract(load, code.multiply(writer.number(code, "loss", i), velocity[i]))
        if squared:
            drag = code.multiply(code.multiply(writer.number(code, "quadratic", i), code.size(total)), total)
            load = code.subtract(load, drag)
        if i in shape.drives.dofs:
            load = code.add(load, code.load("%torque", i))
        force[i] = load
        power = code.multiply(load, total)
        works[0] = code.add(works[0], code.larger(code.zero, power))
        works[1] = code.subtract(works[1], code.smaller(code.zero, power))
    for i in shape.turning:
        if i in dofs:
            force[i] = code.subtract(force[i], code.multiply(writer.number(code, "inertia", i), writer.clock(code, 1)))


def carried_by(writer: Writer, code: Emitter, j: int, parts: tuple[Numbers, Numbers, Numbers], output: Output) -> str:
    """Return the force that a line carries.

    Args:
        writer: Of the structure.
        code: Body.
        j: Line.
        parts: Positions, velocities; rates of the works, which are filled.
        output: What is kept.
    """
    position, velocity, works = parts
    line, room = writer.shape.lines[j], filled(writer.count * writer.lanes)
    now = {number: code.load("%now", number * room + j * writer.lanes) for number in _used(writer, line)}
    deflection, rate = _along(writer, code, line, position), _along(writer, code, line, velocity)
    if line.error:
        deflection, rate = code.subtract(deflection, now[2]), code.subtract(rate, now[3])
    if line.slips:
        rate = code.add(rate, code.multiply(writer.number(code, "slip", j), writer.clock(code, 0)))
    contact = deflection
    if line.gap:
        back = code.add(deflection, writer.number(code, "backlash", j))
        contact = code.add(code.larger(code.zero, deflection), code.smaller(code.zero, back))
    carried = code.multiply(now[0] if line.variation else writer.number(code, "stiffness", j), contact)
    if line.damped:
        drag = code.multiply(writer.number(code, "damping", j), rate)
        works[2] = code.add(works[2], code.multiply(drag, rate))
        carried = code.add(carried, drag)
    if 1 in now:
        works[3] = code.add(works[3], code.multiply(now[1], code.multiply(contact, contact)))
    if line.error:
        works[4] = code.subtract(works[4], code.multiply(now[3], carried))
    _output(writer, code, j, (carried, deflection), output)
    return carried


def _along(writer: Writer, code: Emitter, line: LineShape, vector: Numbers) -> str:
    """Return a line's weights times a vector, the terms that most lines share first."""
    entries, total = zip(line.dofs, line.weights, line.signs, strict=True), code.zero
    for dof, weight, sign in sorted(entries, key=lambda entry: (-writer.uses[entry[:2]], entry[0])):
        if sign < 0 and total != code.zero:
            total = code.subtract(total, vector[dof])
        elif sign > 0:
            total = code.add(total, vector[dof])
        else:
            total = code.add(total, code.multiply(writer.number(code, "weight", weight), vector[dof]))
    return total


def pulls_of(lines: Sequence[LineShape]) -> Pulls:
    """Return the lines that pull on each coordinate.

    Args:
        lines: Structure of each.
    """
    pulls: Pulls = {}
    for j, line in enumerate(lines):
        for dof, weight, sign in zip(line.dofs, line.weights, line.signs, strict=True):
            pulls.setdefault(dof, {}).setdefault((weight, sign), []).append(j)
    return pulls


def pulled(writer: Writer, code: Emitter, pulls: Pulls, parts: tuple[range, Numbers, Numbers]) -> None:
    """Subtract the lines' forces from some coordinates; those of one weight are summed before.

    Args:
        writer: Of the structure.
        code: Body.
        pulls: As `pulls_of` finds them.
        parts: Coordinates, forces of the lines; forces on the coordinates, which are changed.
    """
    dofs, carried, force = parts
    for dof in (dof for dof in pulls if dof in dofs):
        for (weight, sign), lines in pulls[dof].items():
            total = code.total([carried[j] for j in lines])
            if sign < 0:
                force[dof] = code.add(force[dof], total)
            else:
                part = total if sign > 0 else code.multiply(writer.number(code, "weight", weight), total)
                force[dof] = code.value(f"fsub contract nsz {code.type} {force[dof]}, {part}")


def _output(writer: Writer, code: Emitter, j: int, values: tuple[str, str], output: Output) -> None:
    carried, deflection = values
    if output == "record":
        code.store(carried, "%out", j)
        code.store(deflection, "%out", writer.count + j)
    elif output == "statistics":
        places = [writer.lanes * (part * writer.count + j) for part in range(4)]
        minimum, maximum, total, square = (code.load("%out", place) for place in places)
        code.store(code.extreme("minnum", carried, minimum), "%out", places[0])
        code.store(code.extreme("maxnum", carried, maximum), "%out", places[1])
        code.store(code.add(carried, total), "%out", places[2])
        code.store(code.add(code.multiply(carried, carried), square), "%out", places[3])


class Registers(NamedTuple):
    """Values of a state by coordinate, and the works that are summed up."""

    position: Numbers
    velocity: Numbers
    force: Numbers
    works: Numbers


def frames_of(writer: Writer) -> list[tuple[Frame, int]]:
    """Return the gyroscopic entries by their numbers, then the centripetal ones.

    Args:
        writer: Of the structure.
    """
    shape = writer.shape
    entries: list[tuple[Frame, int]] = [("gyroscopic", number) for number in range(len(shape.gyroscopic))]
    return entries + [("centripetal", number) for number in range(len(shape.centripetal))]


def frame_forces(
    writer: Writer, code: Emitter, entries: Sequence[tuple[Frame, int]], registers: Registers, factor: str
) -> None:
    """Add what turning frames and rotors do, and the power that holds them at their speed.

    Args:
        writer: Of the structure.
        code: Body.
        entries: Some of `frames_of`.
        registers: The state; forces and rates of the works, which are changed.
        factor: s.
    """
    position, velocity, force, works = registers
    for number in (number for kind, number in entries if kind == "gyroscopic"):
        row, column = writer.shape.gyroscopic[number]
        value = code.multiply(writer.number(code, "gyroscopic", number), factor)
        part = code.multiply(value, velocity[column])
        force[row] = code.value(f"fsub contract nsz {code.type} {force[row]}, {part}")
        works[5] = code.value(f"fsub contract nsz {code.type} {works[5]}, {code.multiply(part, velocity[row])}")
    for number in (number for kind, number in entries if kind == "centripetal"):
        (row, column), square = writer.shape.centripetal[number], code.multiply(factor, factor)
        value = code.multiply(writer.number(code, "centripetal", number), square)
        part = code.multiply(value, position[column])
        force[row] = code.add(force[row], part)
        works[5] = code.add(works[5], code.multiply(part, velocity[row]))


def _used(writer: Writer, line: LineShape) -> list[int]:
    """Return which of stiffness, half its rate, error and its rate the clock decides and something reads."""
    variation = (0, 1) if writer.books else (0,)
    return [*(variation if line.variation else ()), *((2, 3) if line.error else ())]


# ----------------------------------------------------------------------------------------------------------------------
# Instant: stiffness and errors from a row of the clock table, as straight-line LLVM assembly.
# ----------------------------------------------------------------------------------------------------------------------


Kind = Literal["variation", "error"]
"""What the clock decides of a line."""


def instant(writer: Writer) -> str:
    """Return the function that fills stiffness, half its rate, error and its rate from a row of the clock table.

    Args:
        writer: Of the structure.
    """
    code, room = Emitter(writer.width), filled(writer.count * writer.lanes)
    _waves(writer, code)
    factor = writer.clock(code, 0)
    kinds: tuple[tuple[Kind, int, str], ...] = (
        ("variation", 0, code.multiply(factor, splat(0.5, writer.lanes))),
        ("error", 2, factor),
    )
    for cell in writer.cells(writer.count):
        place = cell[0] * writer.lanes
        for kind, part, scale in kinds:
            if any(getattr(writer.shape.lines[j], kind) for j in cell):
                value, rate = _sums(writer, code, cell, kind)
                code.store(value, "%now", part * room + place)
                if writer.books or kind == "error":
                    code.store(code.multiply(scale, rate), "%now", (part + 1) * room + place)
    return writer.function(code, "instant", ("p", "own", "row", "turn", "wave", "now"))


def _waves(writer: Writer, code: Emitter) -> None:
    """Turn the tones of the row; keep cosines, sines, and both times ω."""
    width = writer.waves
    for i in range(0, width, writer.width):
        (cos, sin), (c, s) = ((code.load(name, i), code.load(name, width + i)) for name in ("%row", "%turn"))
        waves = (
            code.subtract(code.multiply(cos, c), code.multiply(sin, s)),
            code.add(code.multiply(cos, s), code.multiply(sin, c)),
        )
        rate = (
            code.load("%p", writer.layout.rate + i)
            if writer.clocks == 1
            else writer.whole(code, "rate", i // writer.width)
        )
        for number, wave in enumerate(waves):
            code.store(wave, "%wave", number * width + i)
            code.store(code.multiply(rate, wave), "%wave", (2 + number) * width + i)


def _sums(writer: Writer, code: Emitter, cell: range, kind: Kind) -> tuple[str, str]:
    """Return the stiffness or error of some lines, and its rate by τ; cosines and sines are summed side by side."""
    width, slot = writer.waves, slots(writer.shape, kind)
    value = [writer.whole(code, "stiffness", cell[0]) if kind == "variation" else code.zero, code.zero]
    rate = [code.zero, code.zero]
    for tone in sorted({tone for j in cell for tone in getattr(writer.shape.lines[j], kind)}):
        place = slot[cell[0] // CHUNK, tone] + cell[0] % CHUNK
        a, b = (writer.whole(code, f"{kind}_{part}", place) for part in ("cos", "sin"))
        cos, sin, cos_rate, sin_rate = (writer.shared(code, "%wave", part * width, tone) for part in range(4))
        value = [code.add(value[0], code.multiply(a, cos)), code.add(value[1], code.multiply(b, sin))]
        rate = [code.add(rate[0], code.multiply(b, cos_rate)), code.add(rate[1], code.multiply(a, sin_rate))]
    return code.add(*value), code.subtract(*rate)


# ----------------------------------------------------------------------------------------------------------------------
# Parts: the right-hand side of a large structure as many small functions, so that compiling it grows with its lines.
#
# Lines, coordinates and frames are taken a few at a time, in the order and with the operations of `generate.slope`;
# what one part leaves to the next (line forces, forces on coordinates, works) goes through memory.
# ----------------------------------------------------------------------------------------------------------------------


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
    steps: list[tuple[_Part, int]] = [(_elastic_lines, first) for first in range(0, writer.count, PART)]
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


def _elastic_lines(writer: Writer, code: Emitter, first: int, sums: Memory, _: Pulls, output: Output) -> None:
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


# ----------------------------------------------------------------------------------------------------------------------
# March: the loop of classical Runge–Kutta steps around a generated right-hand side, as LLVM assembly.
#
# Every stage is (bq + c q̇, bv + c q̈) of the one before; so is the end, with bv = (v₂ + 2 v₃ + v₄ − v₀)/3 and c = h/6.
# ----------------------------------------------------------------------------------------------------------------------


BLOCK = 64
"""Steps of trajectories side by side between two turns of the tones: so short a table stays in the near caches."""
STAGES = ("q", "v", "qa", "qb", "v2", "v3", "v4", "bq", "bv")
"""Work arrays: the state, positions of stages in turn, velocities of stages two to four, what the last begins from."""


def assembly(writer: Writer) -> str:
    """Return the LLVM assembly of a structure.

    Args:
        writer: Of its functions.
    """
    alone = writer.lanes == 1
    written = slope_in_parts if writer.count > SPLIT else slope
    slopes = [written(writer, "look", "record" if alone else "statistics")]
    slopes += [] if _shared(writer) else [written(writer, "slope", "")]
    laws = [DECLARATIONS] if writer.shape.drives.records else []
    parts = [_DECLARATIONS, *laws, instant(writer), *slopes, _loop(writer)]
    return "\n\n".join([*parts, _alone(writer) if alone else _blocks(writer)])


def _shared(writer: Writer) -> bool:
    """Tell whether all stages of a step run the code of the first, so that half as much is compiled and fetched."""
    return writer.lanes == 1 and writer.count > SPLIT


_DECLARATIONS = """declare double @llvm.fabs.f64(double)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>)
declare <16 x float> @llvm.fabs.v16f32(<16 x float>)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>)
declare <8 x double> @llvm.maxnum.v8f64(<8 x double>, <8 x double>)
declare <16 x float> @llvm.minnum.v16f32(<16 x float>, <16 x float>)
declare <16 x float> @llvm.maxnum.v16f32(<16 x float>, <16 x float>)
declare void @llvm.memcpy.inline.p0.p0.i64(ptr, ptr, i64, i1)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)"""


def _loop(writer: Writer) -> str:
    """Return the function that takes the steps."""
    shape, lanes = writer.shape, writer.lanes
    slope_name = "unseen" if _shared(writer) else "slope"
    row, numbers = table_width(shape, writer.clocks, writer.width), shape.size * lanes
    stride = record_width(shape) if lanes == 1 else 0
    keep = (
        [*_moved(writer, "%place", 0, "%q", numbers), *_moved(writer, "%place", numbers, "%v", numbers)]
        if lanes == 1
        else []
    )
    pointers = ", ".join(f"ptr noalias %{name}" for name in ("p", "own", "table", "turn", "state", "out"))
    name = "void @advance" if lanes == 1 else "internal void @march"
    return f"""define {name}(i64 %steps, {pointers}) {{
entry:
{_arrays(writer, STAGES, STAGES)}
{_assembly_lines(*_copies(writer, "%state", ("q", "v", "works"), inwards=True))}
  %one = load {writer.kind}, ptr %p, align 8
  %lone = insertelement {writer.vector} poison, {writer.kind} %one, i64 0
  %h = shufflevector {writer.vector} %lone, {writer.vector} poison, <{writer.width} x i32> zeroinitializer
  %half = fmul {writer.vector} %h, {splat(0.5, lanes)}
  %third = fmul {writer.vector} %h, {splat(1.0 / 3.0, lanes)}
  %sixth = fmul {writer.vector} %h, {splat(1.0 / 6.0, lanes)}
  {_instant("%table")}
  br label %head
head:
  %i = phi i64 [0, %entry], [%next, %head]
  %twice = mul i64 %i, {2 * row}
  %row0 = getelementptr {writer.kind}, ptr %table, i64 %twice
  %row1 = getelementptr {writer.kind}, ptr %row0, i64 {row}
  %row2 = getelementptr {writer.kind}, ptr %row1, i64 {row}
  %offset = mul i64 %i, {stride}
  %place = getelementptr {writer.kind}, ptr %out, i64 %offset
  %seen = getelementptr {writer.kind}, ptr %place, i64 {2 * numbers if lanes == 1 else 0}
{_assembly_lines(*keep)}
  {_stage(writer, "look", "%row0", "q v q v qa v2", c="%half", share="%sixth")}
  {_instant("%row1")}
  {_stage(writer, slope_name, "%row1", "q v qa v2 qb v3", c="%half", share="%third")}
  {_stage(writer, slope_name, "%row1", "q v qb v3 qa v4", c="%h", share="%third")}
{_last_base(writer)}
  {_instant("%row2")}
  {_stage(writer, slope_name, "%row2", "bq bv qa v4 q v", c="%sixth", share="%sixth")}
  %next = add i64 %i, 1
  %more = icmp slt i64 %next, %steps
  br i1 %more, label %head, label %done
done:
{_assembly_lines(*_copies(writer, "%state", ("q", "v", "works"), inwards=False))}
  ret void
}}"""


def _blocks(writer: Writer) -> str:
    """Return the function that takes the steps of trajectories side by side, each block with its turn of the tones."""
    names = ("p", "own", "table", "turn", "state", "out")
    pointers, given = (", ".join(f"{kind} %{name}" for name in names) for kind in ("ptr noalias", "ptr"))
    return f"""define void @advance(i64 %steps, {pointers}) {{
entry:
  br label %head
head:
  %first = phi i64 [0, %entry], [%next, %head]
  %next = add i64 %first, {BLOCK}
  %left = sub i64 %steps, %first
  %short = icmp slt i64 %left, {BLOCK}
  %count = select i1 %short, i64 %left, i64 {BLOCK}
  %number = udiv i64 %first, {BLOCK}
  %far = mul i64 %number, {2 * writer.waves}
  %turned = getelementptr {writer.kind}, ptr %turn, i64 %far
  call void @march(i64 %count, {given.replace("%turn,", "%turned,")})
  %more = icmp slt i64 %next, %steps
  br i1 %more, label %head, label %done
done:
  ret void
}}"""


def _alone(writer: Writer) -> str:
    """Return the function that works out one derivative, for steps of any length: a stage from nothing with c = 1."""
    wave, room = wave_width(writer.shape), _room(writer)
    turn = ", ".join([f"double {1.0 if i < wave else 0.0}" for i in range(2 * wave)])
    pointers = ", ".join(f"ptr noalias %{name}" for name in ("p", "row", "y", "dy", "seen"))
    stage = _stage(writer, "look", "%row", "bq bv q v qa v2", c=splat(1.0), share=splat(1.0))
    body = "\n  ".join([_instant("%row"), stage]).replace("%own", "%p").replace("%turn", "@unturned")
    return f"""@unturned = private constant [{2 * wave} x double] [{turn}], align 64
@nothing = private constant [{room} x double] zeroinitializer, align 64

define void @derivative({pointers}) {{
{_arrays(writer, ("q", "v", "qa", "v2"), ("works",))}
{_assembly_lines(*_copies(writer, "%y", ("q", "v"), inwards=True))}
  {body.replace("%bq", "@nothing").replace("%bv", "@nothing")}
{_assembly_lines(*_copies(writer, "%dy", ("qa", "v2", "works"), inwards=False))}
  ret void
}}"""


def _arrays(writer: Writer, names: tuple[str, ...], cleared: tuple[str, ...]) -> str:
    """Return work arrays, some of them cleared; what fills up the others to whole vectors does not matter."""
    shape, lanes = writer.shape, writer.lanes
    rooms = dict.fromkeys(names, _room(writer))
    rooms |= {"works": filled(WORKS * lanes), "now": 4 * filled(len(shape.lines) * lanes)}
    rooms["wave"] = 4 * writer.waves
    rooms |= {"unwanted": record_width(shape)} if _shared(writer) else {}
    lines = [f"%{name} = alloca [{room} x {writer.kind}], align 64" for name, room in rooms.items()]
    size = 64 // writer.width
    lines += [
        f"call void @llvm.memset.p0.i64(ptr %{name}, i8 0, i64 {size * rooms[name]}, i1 false)" for name in cleared
    ]
    return _assembly_lines(*lines)


def _room(writer: Writer) -> int:
    """Return the numbers of a work array: one for each coordinate, and in velocities the drives' states after them."""
    return filled(writer.shape.size * writer.lanes) + filled(writer.shape.drives.states)


def _copies(writer: Writer, state: str, names: tuple[str, ...], *, inwards: bool) -> list[str]:
    """Return the copies between a state (q, q̇, works, drives) and work arrays; works that are not named stay."""
    shape, numbers, works = writer.shape, writer.shape.size * writer.lanes, WORKS * writer.lanes
    arrays = {f"%{name}": number * numbers for number, name in enumerate(names)}
    x = f"%{'in' if inwards else 'out'}.x"
    lines = [f"{x} = getelementptr {writer.kind}, ptr %{names[1]}, i64 {filled(numbers)}"]
    for name, first in arrays.items():
        lines += _moved(writer, state, first, name, works if name == "%works" else numbers, back=inwards)
    return lines + _moved(writer, state, 2 * numbers + works, x, shape.drives.states, back=inwards)


def _moved(writer: Writer, base: str, first: int, array: str, count: int, *, back: bool = False) -> list[str]:
    """Return the copy of an array to a place in another, or back."""
    place = f"%{'in' if back else 'out'}.{base[1:]}.{array[1:]}"
    pair = (array, place) if back else (place, array)
    return [f"{place} = getelementptr {writer.kind}, ptr {base}, i64 {first}", _copy(*pair, count * 64 // writer.width)]


def _copy(to: str, source: str, size: int) -> str:
    kind = "memcpy.inline" if size <= 512 else "memcpy"
    return f"call void @llvm.{kind}.p0.p0.i64(ptr {to}, ptr {source}, i64 {size}, i1 false)"


def _instant(row: str) -> str:
    return f"call void @instant(ptr %p, ptr %own, ptr {row}, ptr %turn, ptr %wave, ptr %now)"


def _stage(writer: Writer, name: str, row: str, arrays: str, *, c: str, share: str) -> str:
    """Return the call of a slope on arrays, with names as `generate.slope` orders them from ``bq`` on."""
    name, seen = ("look", "%unwanted") if name == "unseen" else (name, "%seen")
    pointers = ", ".join(f"ptr {at}" for at in ("%p", "%own", row, "%now", *(f"%{name}" for name in arrays.split())))
    return f"call void @{name}({pointers}, ptr %works, ptr {seen}, {writer.vector} {c}, {writer.vector} {share})"


def _last_base(writer: Writer) -> str:
    """The last stage begins from: bq = q + h/6 (v + 2 v₂ + 2 v₃), bv = v + (d₂ + 2 d₃ + d₄)/3, dᵢ = vᵢ − v."""
    lines, kind, third = list[str](), writer.vector, splat(1.0 / 3.0, writer.lanes)
    two, flags = splat(2.0, writer.lanes), f"contract {kind}"
    for i in range(0, _room(writer), writer.width):
        for name in ("q", "v", "v2", "v3", "v4", "bq", "bv"):
            lines.append(f"%p{name}.{i} = getelementptr {writer.kind}, ptr %{name}, i64 {i}")
        for name in ("q", "v", "v2", "v3", "v4"):
            lines.append(f"%l{name}.{i} = load {kind}, ptr %p{name}.{i}, align 64")
        lines += [
            f"%twice{i} = fmul contract {kind} %lv3.{i}, {two}",
            f"%inner{i} = fadd contract {kind} %lv2.{i}, %twice{i}",
            f"%middle{i} = fadd {kind} %lv2.{i}, %inner{i}",
            f"%sum{i} = fadd {kind} %lv.{i}, %middle{i}",
            f"%gone{i} = fmul {flags} %sixth, %sum{i}",
            f"%to{i} = fadd {flags} %lq.{i}, %gone{i}",
            f"store {kind} %to{i}, ptr %pbq.{i}, align 64",
            *(f"%d{n}.{i} = fsub {kind} %lv{n}.{i}, %lv.{i}" for n in (2, 3, 4)),  # small, so that rounding is too
            f"%both{i} = fmul contract {kind} %d3.{i}, {two}",
            f"%ends{i} = fadd {kind} %d2.{i}, %d4.{i}",
            f"%all{i} = fadd contract {kind} %both{i}, %ends{i}",
            f"%third{i} = fmul {flags} %all{i}, {third}",
            f"%mean{i} = fadd {flags} %lv.{i}, %third{i}",
            f"store {kind} %mean{i}, ptr %pbv.{i}, align 64",
        ]
    return _assembly_lines(*lines)


def _assembly_lines(*lines: str) -> str:
    return "\n".join(f"  {line}" for line in lines)


# ----------------------------------------------------------------------------------------------------------------------
# Native: generated assembly compiled in memory and called through a pointer.
# ----------------------------------------------------------------------------------------------------------------------


Advance = Callable[[int, Floats, Floats, Floats, Floats, Floats, Floats], None]
"""(steps, parameters, each lane's own, clock table, turn of its tones, state, output): carries the state on in place.

For one trajectory each step fills a row of the output, a record. Lanes keep none; their output is a summary of the line
forces: least, most, sum and sum of squares.
"""


class Compiled(NamedTuple):
    """Machine code of one structure."""

    advance: Advance
    """Runs a block of steps."""
    address: int
    """Of that code."""
    derivative: int
    """Address of the right-hand side alone, (parameters, clock row, state, slope, output); 0 for lanes."""
    engine: Any
    """Keeps the machine code in memory."""
    assembly: str
    """What was compiled, to read."""


@lru_cache(maxsize=64)
def compiled(shape: Topology, layout: Layout, lanes: int = 1, own: frozenset[str] = frozenset()) -> Compiled:
    """Return the machine code for a structure; each structure is compiled once.

    Args:
        shape: Structure.
        layout: Places of the numbers, which follow from the structure.
        lanes: 1 for a single trajectory with every step recorded; 8 for as many side by side with statistics, 16 for
            as many in single precision.
        own: Fields of `Layout`, and ``"clock"``, that each lane has to itself; all others are alike.
    """
    text = assembly(Writer(shape, layout, lanes, own))
    engine = machine_code(text, _called(shape))
    pointer, number = ctypes.c_void_p, ctypes.c_int64
    signature = ctypes.CFUNCTYPE(None, number, *[pointer] * 6)
    place = int(engine.get_function_address("advance"))
    function = signature(place)

    def advance(steps: int, *arrays: Floats) -> None:
        function(steps, *map(address, arrays))

    alone = int(engine.get_function_address("derivative")) if lanes == 1 else 0
    return Compiled(advance, place, alone, engine, text)


def _called(shape: Topology) -> Mapping[str, int]:
    """Return what generated code calls, by name, and where it is in memory."""
    if not shape.drives.records:
        return {}
    return laws()
