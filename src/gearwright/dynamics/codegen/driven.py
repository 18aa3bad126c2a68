"""Driven: what propellers, machines and clutches do, as calls of their laws in generated code."""

from __future__ import annotations

from typing import Literal

from gearwright.dynamics.codegen.emit import Emitter
from gearwright.dynamics.codegen.laws import KINDS
from gearwright.dynamics.codegen.topology import filled
from gearwright.dynamics.codegen.writer import Writer, drive_width, wave_width
from gearwright.dynamics.model import HEADER, OUTPUTS

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
