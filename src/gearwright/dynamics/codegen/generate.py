"""Generate: the right-hand side of a structure as straight-line LLVM assembly, with the next stage of a step.

`instant` works out beforehand what the clock decides; `march` joins the two to a loop.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple, Protocol

from gearwright.dynamics.codegen.driven import Output, drive_laws
from gearwright.dynamics.codegen.emit import CHUNK, Emitter
from gearwright.dynamics.codegen.topology import LineShape, filled
from gearwright.dynamics.codegen.writer import Writer
from gearwright.dynamics.equations import WORKS

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
