"""Instant: stiffness and errors from a row of the clock table, as straight-line LLVM assembly."""

from __future__ import annotations

from typing import Literal

from gearwright.dynamics.codegen.emit import CHUNK, Emitter, splat
from gearwright.dynamics.codegen.topology import filled, slots
from gearwright.dynamics.codegen.writer import Writer

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
