"""The laws of drives behind a pointer, for generated code; compiled when the first system with drives is generated."""

from __future__ import annotations

from typing import Any

from numba import carray, types  # type: ignore[attr-defined]

from gearwright.dynamics.code_cache import compiled_callback
from gearwright.dynamics.codegen.emit import CHUNK
from gearwright.dynamics.equations.drive_laws import apply_drives
from gearwright.dynamics.model import OUTPUTS

MOST_INPUTS = 4
"""Inputs of the record that reads most: no law reads beyond its own."""
_POINTER = types.CPointer(types.float64)  # type: ignore[no-untyped-call]
_SIGNATURE = types.void(_POINTER, types.int64, types.int64, _POINTER, types.float64, *[_POINTER] * 4)


@compiled_callback(_SIGNATURE)
def laws(
    table_at: Any, length: int, states: int, inputs_at: Any, factor: float,
    motion_at: Any, torque_at: Any, rate_at: Any, output_at: Any,
) -> None:  # fmt: skip
    """Clear the torques and fill them, the rates of states and what the drives report; pointers to numbers.

    The states stand after the velocities, which are filled up to whole vectors.
    """
    table = carray(table_at, (length,))
    size, drives = int(table[1]), int(table[0])
    past = -(-size // CHUNK) * CHUNK
    motion, torque = carray(motion_at, (past + states,)), carray(torque_at, (size,))
    rate = carray(rate_at, (states,))
    inputs, output = carray(inputs_at, (MOST_INPUTS * drives,)), carray(output_at, (states + OUTPUTS * drives,))
    torque[:] = 0.0
    apply_drives(table, inputs, factor, motion[:size], motion[past:], torque, rate, output)
