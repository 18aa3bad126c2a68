"""Native: generated assembly compiled in memory and called through a pointer."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.assembler import address, machine_code
from gearwright.dynamics.codegen.laws import laws
from gearwright.dynamics.codegen.march import assembly
from gearwright.dynamics.codegen.topology import Layout, Topology
from gearwright.dynamics.codegen.writer import Writer

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
