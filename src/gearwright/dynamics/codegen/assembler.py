"""Assembler: LLVM assembly to machine code in memory, and arrays that begin where vectors like it."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.codegen.emit import CHUNK


def aligned(*shape: int) -> Floats:
    """Return zeros that begin at a whole vector of memory, so that no load straddles two cache lines.

    Args:
        shape: Of the array.
    """
    count = int(np.prod(shape))
    room = np.zeros(count + CHUNK)
    first = -(room.ctypes.data // 8) % CHUNK
    return room[first : first + count].reshape(shape)


_NOTHING = ctypes.c_char * 0


def address(array: Floats) -> int:
    """Return where an array begins in memory; much quicker than its own `ctypes`.

    Args:
        array: Writable, rows one after the other.
    """
    return ctypes.addressof(_NOTHING.from_buffer(array))  # type: ignore[arg-type]


def machine_code(text: str) -> Any:
    """Return the engine that holds the machine code of an assembly.

    Args:
        text: LLVM assembly.
    """
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    triple, features = llvm.Target.from_default_triple(), llvm.get_host_cpu_features().flatten()
    # The assembly is straight-line code without redundancy: optimising passes before code generation gain nothing.
    target = triple.create_target_machine(cpu=llvm.get_host_cpu_name(), features=features, opt=3)
    module = llvm.parse_assembly(text)
    module.verify()
    engine = llvm.create_mcjit_compiler(module, target)
    engine.finalize_object()
    return engine
