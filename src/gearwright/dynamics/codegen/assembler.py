"""Assembler: LLVM assembly to machine code in memory, and arrays that begin where vectors like it."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.codegen.emit import CHUNK, SINGLE
from gearwright.dynamics.kept_code import COMPILING, keep_code, kept_code
from gearwright.notices import notice

LONG = 2_500_000
"""Characters of assembly from which compiling takes more than a second, of some thousand lines of a model."""


def aligned(*shape: int, single: bool = False) -> Floats:
    """Return zeros that begin at a whole vector of memory, so that no load straddles two cache lines.

    Args:
        shape: Of the array.
        single: Whether its numbers are of single precision.
    """
    count, side = int(np.prod(shape)), SINGLE if single else CHUNK
    room: Any = np.zeros(count + side, dtype=np.float32 if single else np.float64)
    first = -(room.ctypes.data // room.itemsize) % side
    return room[first : first + count].reshape(shape)  # type: ignore[no-any-return]


_NOTHING = ctypes.c_char * 0
_NO_CALLS: Mapping[str, int] = MappingProxyType({})


def address(array: Floats | Ints) -> int:
    """Return where an array begins in memory; much quicker than its own `ctypes`.

    Args:
        array: Writable, rows one after the other.
    """
    return ctypes.addressof(_NOTHING.from_buffer(array))  # type: ignore[arg-type]


def machine_code(text: str, called: Mapping[str, int] = _NO_CALLS, *, optimised: bool = False) -> Any:
    """Return the engine that holds the machine code of an assembly, compiled or as it was kept.

    Args:
        text: LLVM assembly.
        called: Where in memory the functions are that it only declares, by name.
        optimised: Whether LLVM's passes go over it: not over code without redundancy, where they gain nothing.
    """
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    for name, place in called.items():
        llvm.add_symbol(name, place)
    triple, features = llvm.Target.from_default_triple(), llvm.get_host_cpu_features().flatten()
    cpu = llvm.get_host_cpu_name()
    target = triple.create_target_machine(cpu=cpu, features=features, opt=3)
    key = "\n".join([str(triple), cpu, features, text])
    kept = kept_code(key)
    if not kept and len(text) > LONG:
        notice(COMPILING)
    module = llvm.parse_assembly("" if kept else text)
    engine = llvm.create_mcjit_compiler(module, target)
    if kept:
        engine.add_object_file(llvm.ObjectFileRef.from_data(kept))
    else:
        module.verify()
        if optimised:
            tuning = llvm.create_pipeline_tuning_options(speed_level=2)
            llvm.create_pass_builder(target, tuning).getModulePassManager().run(
                module, llvm.create_pass_builder(target, tuning)
            )
        engine.set_object_cache(notify_func=lambda _, code: keep_code(key, code))
    engine.finalize_object()
    return engine
