"""Generate: the right-hand side of a structure as straight-line LLVM assembly, with the next stage of a step.

`instant` works out beforehand what the clock decides; `march` joins the two to a loop.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from gearwright.dynamics.codegen.emit import CHUNK, Emitter
from gearwright.dynamics.codegen.topology import LineShape, filled
from gearwright.dynamics.codegen.writer import Writer, drive_width, wave_width
from gearwright.dynamics.equations import WORKS

PART = 8
"""Lines that share what they have loaded: among more, registers run out."""


def slope(writer: Writer, name: str, output: Literal["", "record", "statistics"]) -> str:
    """Return the function that works out the forces at (q, q̇) and from them the next stage of a step.

    The next stage is (bq + c q̇, bv + c q̈); the works grow by their rates times a share.

    Args:
        writer: Of the structure.
        name: Of the function.
        output: ``"record"`` keeps forces and deflections, ``"statistics"`` least, most and sums of forces.
    """
    code, works = Emitter(writer.lanes), [Emitter(writer.lanes).zero] * WORKS
    if writer.shape.drives.records:
        _drives(writer, code, output)
    carried = []
    for j in range(writer.count):
        if j % PART == 0:
            code.part(f"lines{j}")
            position, velocity = (_state(writer, code, name) for name in ("%q", "%v"))
        carried.append(_line(writer, code, j, (position, velocity, works), output))
    code.part("next")
    position, velocity = (_state(writer, code, name) for name in ("%q", "%v"))
    factor = writer.clock(code, 0)
    force = _loads(writer, code, velocity, factor, works)
    _spread(writer, code, carried, force)
    _frames(writer, code, Registers(position, velocity, force, works), factor)
    _next(writer, code, force, works)
    pointers = ("p", "own", "row", "now", "bq", "bv", "q", "v", "qn", "vn", "works", "out")
    return writer.function(code, name, pointers)


def _state(writer: Writer, code: Emitter, pointer: str) -> list[str]:
    return [code.load(pointer, i * writer.lanes) for i in range(writer.shape.size)]


def _next(writer: Writer, code: Emitter, force: list[str], works: list[str]) -> None:
    """Store the next stage and let the works grow."""
    wide = code.wide
    for number, cell in enumerate(writer.cells(writer.shape.size)):
        place = CHUNK * number
        rate = wide.multiply(code.join([force[i] for i in cell]), writer.whole(code, "mobility", cell[0]))
        position = wide.add(wide.load("%bq", place), wide.multiply("%c", wide.load("%v", place)))
        wide.store(position, "%qn", place)
        wide.store(wide.add(wide.load("%bv", place), wide.multiply("%c", rate)), "%vn", place)
    for place in range(0, writer.shape.drives.states, CHUNK):
        gain, there = wide.multiply("%c", wide.load("%rate", place)), filled(writer.shape.size) + place
        wide.store(wide.add(wide.load("%bv", there), gain), "%vn", there)
    for number, cell in enumerate(writer.cells(WORKS)):
        if any(works[i] != code.zero for i in cell):
            rate, before = code.join([works[i] for i in cell]), wide.load("%works", CHUNK * number)
            wide.store(wide.add(before, wide.multiply("%share", rate)), "%works", CHUNK * number)


def _loads(writer: Writer, code: Emitter, velocity: list[str], factor: str, works: list[str]) -> list[str]:
    """Return the external load of each coordinate, and fill in the first two powers."""
    shape, force = writer.shape, [code.zero] * writer.shape.size
    for i, damped, squared in shape.loaded:
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
        force[i] = code.subtract(force[i], code.multiply(writer.number(code, "inertia", i), writer.clock(code, 1)))
    return force


def _drives(writer: Writer, code: Emitter, output: str) -> None:
    """Call the drives' laws: they fill torques, the rates of their states, and what they report."""
    # Loaded here because compiling it the first time takes seconds, and most systems do without it.
    from gearwright.dynamics.codegen.drive_call import laws

    shape = writer.shape
    rooms = {"torque": shape.size, "rate": filled(shape.drives.states), "unseen": drive_width(shape)}
    code.lines += [f"  %{name} = alloca [{room} x double], align 64" for name, room in rooms.items()]
    table, factor = code.at("%p", writer.layout.drives), writer.clock(code, 0)
    inputs = code.at("%row", 2 * wave_width(shape) + 2 + len(shape.scheduled))
    seen = code.at("%out", 2 * writer.count) if output == "record" else "%unseen"
    numbers = f"ptr {table}, i64 {shape.drives.length}, i64 {shape.drives.states}, ptr {inputs}, double {factor}"
    pointers = ", ".join(f"ptr {name}" for name in ("%v", "%torque", "%rate", seen))
    code.lines.append(f"  call void inttoptr (i64 {laws.address} to ptr)({numbers}, {pointers})")


def _line(writer: Writer, code: Emitter, j: int, parts: tuple[list[str], ...], output: str) -> str:
    """Return the force that a line carries."""
    position, velocity, works = parts
    line, room = writer.shape.lines[j], filled(writer.count * writer.lanes)
    now = {number: code.load("%now", number * room + j * writer.lanes) for number in _used(line)}
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
    if line.variation:
        works[3] = code.add(works[3], code.multiply(now[1], code.multiply(contact, contact)))
    if line.error:
        works[4] = code.subtract(works[4], code.multiply(now[3], carried))
    _output(writer, code, j, (carried, deflection), output)
    return carried


def _along(writer: Writer, code: Emitter, line: LineShape, vector: list[str]) -> str:
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


def _spread(writer: Writer, code: Emitter, carried: list[str], force: list[str]) -> None:
    """Subtract the lines' forces from their coordinates; those of one weight are summed before."""
    pulls: dict[tuple[int, int, int], list[str]] = {}
    for line, value in zip(writer.shape.lines, carried, strict=True):
        for entry in zip(line.dofs, line.weights, line.signs, strict=True):
            pulls.setdefault(entry, []).append(value)
    for (dof, weight, sign), values in pulls.items():
        total = code.total(values)
        if sign < 0:
            force[dof] = code.add(force[dof], total)
        else:
            part = total if sign > 0 else code.multiply(writer.number(code, "weight", weight), total)
            force[dof] = code.value(f"fsub contract nsz {code.type} {force[dof]}, {part}")


def _output(writer: Writer, code: Emitter, j: int, values: tuple[str, str], output: str) -> None:
    carried, deflection = values
    if output == "record":
        code.store(carried, "%out", j)
        code.store(deflection, "%out", writer.count + j)
    elif output == "statistics":
        places = [CHUNK * (part * writer.count + j) for part in range(4)]
        minimum, maximum, total, square = (code.load("%out", place) for place in places)
        code.store(code.extreme("minnum", carried, minimum), "%out", places[0])
        code.store(code.extreme("maxnum", carried, maximum), "%out", places[1])
        code.store(code.add(carried, total), "%out", places[2])
        code.store(code.add(code.multiply(carried, carried), square), "%out", places[3])


class Registers(NamedTuple):
    """Values of a state by coordinate, and the works that are summed up."""

    position: list[str]
    velocity: list[str]
    force: list[str]
    works: list[str]


def _frames(writer: Writer, code: Emitter, registers: Registers, factor: str) -> None:
    position, velocity, force, works = registers
    for number, (row, column) in enumerate(writer.shape.gyroscopic):
        value = code.multiply(writer.number(code, "gyroscopic", number), factor)
        part = code.multiply(value, velocity[column])
        force[row] = code.value(f"fsub contract nsz {code.type} {force[row]}, {part}")
        works[5] = code.value(f"fsub contract nsz {code.type} {works[5]}, {code.multiply(part, velocity[row])}")
    square = code.multiply(factor, factor) if writer.shape.centripetal else code.zero
    for number, (row, column) in enumerate(writer.shape.centripetal):
        value = code.multiply(writer.number(code, "centripetal", number), square)
        part = code.multiply(value, position[column])
        force[row] = code.add(force[row], part)
        works[5] = code.add(works[5], code.multiply(part, velocity[row]))


def _used(line: LineShape) -> list[int]:
    """Return which of stiffness, half its rate, error and its rate the clock decides."""
    return [*((0, 1) if line.variation else ()), *((2, 3) if line.error else ())]
