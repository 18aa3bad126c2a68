"""Call: generated code from compiled loops, by its address."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic


def _call(_: Any, address: Any, p: Any, row: Any, y: Any, dy: Any, out: Any) -> Any:
    """Return how numba is to call code at an address."""
    signature = types.void(address, p, row, y, dy, out)

    def build(context: Any, builder: Any, _: Any, arguments: Any) -> Any:
        pointer = ir.IntType(8).as_pointer()
        function = ir.FunctionType(ir.VoidType(), [pointer] * 5).as_pointer()
        places = [builder.inttoptr(argument, pointer) for argument in arguments[1:]]
        builder.call(builder.inttoptr(arguments[0], function), places)
        return context.get_dummy_value()

    return signature, build


call_generated: Any = intrinsic(_call)
"""(address, parameters, clock row, state, slope, output), all addresses: calls a right-hand side of `Compiled`."""
