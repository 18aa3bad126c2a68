"""Generate: a system's structure becomes straight-line LLVM assembly of its right-hand side and Runge–Kutta loop.

Two kinds of functions: `instant` works out what the clock decides from a row of the clock table (cos and sin of every
tone, s, ṡ, scheduled loads); `slope` the derivative, and as `look` the outputs of a step too. `native` joins them.
"""

from __future__ import annotations

from gearwright.dynamics.drives import OUTPUTS
from gearwright.dynamics.emit import Emitter
from gearwright.dynamics.energy import WORKS
from gearwright.dynamics.topology import Layout, LineShape, Topology

Waves = dict[int, str]
"""Cosine or sine of each tone, by its number."""
CHUNK = 8
"""Numbers in one vector when whole states are added."""


def table_width(shape: Topology) -> int:
    """Return the columns of the clock table: cosine and sine of each tone, s, ṡ, scheduled loads, drives' inputs.

    Args:
        shape: Structure.
    """
    columns = 2 * shape.tones + 2 + len(shape.scheduled) + shape.drives.inputs
    return columns + columns % 2  # even, so that a cosine and its sine can be written as one complex number


def record_width(shape: Topology) -> int:
    """Return the numbers in a row of a record, filled up to whole vectors: q, q̇, line forces, deflections, drives.

    Args:
        shape: Structure.
    """
    return -(-(2 * (shape.size + len(shape.lines)) + drive_width(shape)) // CHUNK) * CHUNK


def drive_width(shape: Topology) -> int:
    """Return the numbers that drives add to a row: their states, and what each reports.

    Args:
        shape: Structure.
    """
    return shape.drives.states + OUTPUTS * shape.drives.records


def state_width(shape: Topology, lanes: int) -> int:
    """Return the numbers in a state, filled up to whole vectors.

    Args:
        shape: Structure.
        lanes: Trajectories side by side.
    """
    return -(-state_size(shape) * lanes // CHUNK) * CHUNK


def state_size(shape: Topology) -> int:
    """Return the numbers in a state: q, q̇, works, states of the drives.

    Args:
        shape: Structure.
    """
    return 2 * shape.size + WORKS + shape.drives.states


class Writer:
    """Writes the functions of one structure; `own` names the numbers that each lane has to itself."""

    def __init__(self, shape: Topology, layout: Layout, lanes: int, own: frozenset[str]) -> None:
        self.shape, self.layout, self.lanes, self.own = shape, layout, lanes, own
        self.count = len(shape.lines)
        starts = [0]
        for line in shape.lines:
            starts.append(starts[-1] + len(line.dofs))
        self.weights = starts

    def instant(self) -> str:
        """Return the function that fills stiffness, half its rate, error and its rate from a row of the clock table."""
        code = Emitter(self.lanes)
        shape = self.shape
        used = {tone for line in shape.lines for tone in (*line.variation, *line.error)}
        cos = {tone: self._clock(code, 2 * tone) for tone in sorted(used)}
        sin = {tone: self._clock(code, 2 * tone + 1) for tone in sorted(used)}
        factor = self._clock(code, 2 * shape.tones)
        places = [0, 0]
        for j, line in enumerate(shape.lines):
            if line.variation:
                value, rate = self._sums(code, ("variation", places[0]), line.variation, (cos, sin))
                code.store(code.add(self._number(code, "stiffness", j), value), "%now", j)
                code.store(code.multiply(factor, rate), "%now", self.count + j)
            if line.error:
                value, rate = self._sums(code, ("error", places[1]), line.error, (cos, sin))
                code.store(value, "%now", 2 * self.count + j)
                code.store(code.multiply(factor, rate), "%now", 3 * self.count + j)
            places = [places[0] + len(line.variation), places[1] + len(line.error)]
        return self._function(code, "instant", ("p", "own", "row", "now"))

    def _function(self, code: Emitter, name: str, pointers: tuple[str, ...]) -> str:
        arguments = ", ".join(f"ptr noalias %{pointer}" for pointer in pointers)
        head = f"define internal void @{name}({arguments}) noinline nounwind {{"
        return "\n".join([head, *code.lines, "  ret void", "}"])

    def _number(self, code: Emitter, group: str, index: int) -> str:
        """Load a parameter: each lane's own, or one for all."""
        place = getattr(self.layout, group) + index
        return code.load("%own", place) if group in self.own else code.spread("%p", place)

    def _clock(self, code: Emitter, column: int) -> str:
        """Load a column of the clock table: each lane's own, or one for all."""
        return code.load("%row", column) if "clock" in self.own else code.spread("%row", column)

    def _sums(
        self,
        code: Emitter,
        terms: tuple[str, int],
        tones: tuple[int, ...],
        waves: tuple[dict[int, str], dict[int, str]],
    ) -> tuple[str, str]:
        """Return a Fourier sum and its rate."""
        (group, first), sums = terms, [code.zero, code.zero]
        for number, tone in enumerate(tones):
            for part, ending in enumerate(("", "_rate")):
                for wave, name in zip(waves, (f"{group}_cos{ending}", f"{group}_sin{ending}"), strict=True):
                    coefficient = self._number(code, name, first + number)
                    sums[part] = code.add(sums[part], code.multiply(coefficient, wave[tone]))
        return sums[0], sums[1]

    def slope(self, name: str, output: str) -> str:
        """Return the function that fills the derivative of (q, q̇, works).

        Args:
            name: Of the function.
            output: ``""``, ``"record"`` (forces and deflections) or ``"statistics"`` (least, most, sums of forces).
        """
        code = Emitter(self.lanes)
        size = self.shape.size
        position = [code.load("%y", i) for i in range(size)]
        velocity = [code.load("%y", size + i) for i in range(size)]
        factor, ramp = self._clock(code, 2 * self.shape.tones), self._clock(code, 2 * self.shape.tones + 1)
        if self.shape.drives.records:
            self._drives(code, factor, output)
        force, works = self._loads(code, velocity, factor)
        for i in self.shape.turning:
            force[i] = code.subtract(force[i], code.multiply(self._number(code, "inertia", i), ramp))
        for j in range(self.count):
            self._line(code, j, (position, velocity, force, works), output)
        self._frames(code, (position, velocity, force, works), factor)
        for i in range(size):
            code.store(velocity[i], "%dy", i)
            code.store(code.multiply(force[i], self._number(code, "mobility", i)), "%dy", size + i)
        for number, work in enumerate(works):
            code.store(work, "%dy", 2 * size + number)
        return self._function(code, name, ("p", "own", "row", "now", "y", "dy", "out"))

    def _loads(self, code: Emitter, velocity: list[str], factor: str) -> tuple[list[str], list[str]]:
        """Return the external load of each coordinate, and the powers with the first two filled in."""
        force, works = [code.zero] * self.shape.size, [code.zero] * WORKS
        for i, damped, squared in self.shape.loaded:
            total = code.add(code.multiply(self._number(code, "speed", i), factor), velocity[i])
            load = self._number(code, "constant", i)
            for number, dof in enumerate(self.shape.scheduled):
                if dof == i:
                    load = code.add(load, self._clock(code, 2 * self.shape.tones + 2 + number))
            if damped:
                load = code.subtract(load, code.multiply(self._number(code, "loss", i), velocity[i]))
            if squared:
                drag = code.multiply(code.multiply(self._number(code, "quadratic", i), code.size(total)), total)
                load = code.subtract(load, drag)
            if i in self.shape.drives.dofs:
                load = code.add(load, code.load("%torque", i))
            force[i] = load
            power = code.multiply(load, total)
            works[0] = code.add(works[0], code.larger(power, code.zero))
            works[1] = code.subtract(works[1], code.smaller(power, code.zero))
        return force, works

    def _drives(self, code: Emitter, factor: str, output: str) -> None:
        """Call the drives' laws: they fill torques, the rates of their states, and what they report."""
        # Loaded here because compiling it the first time takes seconds, and most systems do without it.
        from gearwright.dynamics.drive_call import laws

        shape = self.shape
        code.lines.append(f"  %torque = alloca [{shape.size} x double], align 64")
        code.lines.append(f"  %unseen = alloca [{drive_width(shape)} x double], align 64")
        table, inputs = code.at("%p", self.layout.drives), code.at("%row", 2 * shape.tones + 2 + len(shape.scheduled))
        seen = code.at("%out", 2 * self.count) if output == "record" else "%unseen"
        numbers = f"ptr {table}, i64 {shape.drives.length}, i64 {shape.drives.states}, ptr {inputs}, double {factor}"
        pointers = ", ".join(f"ptr {name}" for name in ("%y", "%torque", "%dy", seen))
        code.lines.append(f"  call void inttoptr (i64 {laws.address} to ptr)({numbers}, {pointers})")

    def _line(
        self, code: Emitter, j: int, parts: tuple[list[str], list[str], list[str], list[str]], output: str
    ) -> None:
        position, velocity, force, works = parts
        line = self.shape.lines[j]
        deflection, rate = self._along(code, j, position), self._along(code, j, velocity)
        if line.error:
            deflection = code.subtract(deflection, code.load("%now", 2 * self.count + j))
            wander = code.load("%now", 3 * self.count + j)
            rate = code.subtract(rate, wander)
        contact = deflection
        if line.gap:
            back = code.add(deflection, self._number(code, "backlash", j))
            contact = code.add(code.larger(deflection, code.zero), code.smaller(back, code.zero))
        stiffness = code.load("%now", j) if line.variation else self._number(code, "stiffness", j)
        carried = code.multiply(stiffness, contact)
        if line.damped:
            drag = code.multiply(self._number(code, "damping", j), rate)
            works[2] = code.add(works[2], code.multiply(drag, rate))
            carried = code.add(carried, drag)
        if line.variation:
            swell = code.multiply(code.load("%now", self.count + j), code.multiply(contact, contact))
            works[3] = code.add(works[3], swell)
        if line.error:
            works[4] = code.subtract(works[4], code.multiply(wander, carried))
        self._spread(code, j, line, (carried, force))
        self._output(code, j, (carried, deflection), output)

    def _along(self, code: Emitter, j: int, vector: list[str]) -> str:
        """Return a line's weights times a vector."""
        line, total = self.shape.lines[j], code.zero
        for number, (dof, sign) in enumerate(zip(line.dofs, line.signs, strict=True)):
            if sign < 0 and total != code.zero:
                total = code.subtract(total, vector[dof])
            elif sign > 0:
                total = code.add(total, vector[dof])
            else:
                weight = self._number(code, "weight", self.weights[j] + number)
                total = code.add(total, code.multiply(weight, vector[dof]))
        return total

    def _spread(self, code: Emitter, j: int, line: LineShape, carried: tuple[str, list[str]]) -> None:
        """Subtract a line's force from its coordinates."""
        value, force = carried
        for number, (dof, sign) in enumerate(zip(line.dofs, line.signs, strict=True)):
            if sign < 0:
                force[dof] = code.add(force[dof], value)
            elif sign > 0:
                force[dof] = code.value(f"fsub {code.type} {force[dof]}, {value}")
            else:
                weight = self._number(code, "weight", self.weights[j] + number)
                part = code.multiply(weight, value)
                force[dof] = code.value(f"fsub contract nsz {code.type} {force[dof]}, {part}")

    def _output(self, code: Emitter, j: int, values: tuple[str, str], output: str) -> None:
        carried, deflection = values
        if output == "record":
            code.store(carried, "%out", j)
            code.store(deflection, "%out", self.count + j)
        elif output == "statistics":
            least, most, total, square = (code.load("%out", part * self.count + j) for part in range(4))
            code.store(code.smaller(carried, least), "%out", j)
            code.store(code.larger(carried, most), "%out", self.count + j)
            code.store(code.add(carried, total), "%out", 2 * self.count + j)
            code.store(code.add(code.multiply(carried, carried), square), "%out", 3 * self.count + j)

    def _frames(self, code: Emitter, parts: tuple[list[str], list[str], list[str], list[str]], factor: str) -> None:
        position, velocity, force, works = parts
        for number, (row, column) in enumerate(self.shape.gyroscopic):
            value = code.multiply(self._number(code, "gyroscopic", number), factor)
            part = code.multiply(value, velocity[column])
            force[row] = code.value(f"fsub contract nsz {code.type} {force[row]}, {part}")
            works[5] = code.value(f"fsub contract nsz {code.type} {works[5]}, {code.multiply(part, velocity[row])}")
        square = code.multiply(factor, factor) if self.shape.centripetal else code.zero
        for number, (row, column) in enumerate(self.shape.centripetal):
            value = code.multiply(self._number(code, "centripetal", number), square)
            part = code.multiply(value, position[column])
            force[row] = code.add(force[row], part)
            works[5] = code.add(works[5], code.multiply(part, velocity[row]))
