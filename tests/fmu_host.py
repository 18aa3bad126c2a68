"""A plain host of FMUs for tests: it unpacks one, loads its library and calls it, as a simulator of FMI 2.0 does."""

from __future__ import annotations

import ctypes
import io
import shutil
import subprocess
import zipfile
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from gearwright.exchange.fmu import COMPILERS

OK, WARNING, DISCARD, ERROR = range(4)
_LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)


class _Callbacks(ctypes.Structure):
    _fields_ = (
        ("logger", _LOGGER),
        ("allocate", ctypes.c_void_p),
        ("free", ctypes.c_void_p),
        ("finished", ctypes.c_void_p),
        ("environment", ctypes.c_void_p),
    )


class Unpacked:
    """An FMU in a folder."""

    def __init__(self, content: bytes, folder: Path) -> None:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            archive.extractall(folder)
        self.folder = folder
        self.description = ElementTree.parse(folder / "modelDescription.xml").getroot()
        variables = self.description.find("ModelVariables")
        self.references = {variable.get("name"): int(variable.get("valueReference")) for variable in variables}

    @property
    def library(self) -> Path:
        """The binary that was packed."""
        return next(self.folder.glob("binaries/*/*"))


class Instance:
    """One instance by FMI 2.0."""

    def __init__(self, fmu: Unpacked, library: Path | None = None, name: str = "one") -> None:
        self.fmu, self.said = fmu, list[str]()
        self.code = ctypes.CDLL(str(library or fmu.library))
        self.code.fmi2Instantiate.restype = ctypes.c_void_p
        self._callbacks = _Callbacks(
            _LOGGER(lambda *words: self.said.append(words[4].decode())), None, None, None, None
        )
        token = fmu.description.get("guid").encode()
        self.handle = ctypes.c_void_p(
            self.code.fmi2Instantiate(name.encode(), 1, token, None, ctypes.byref(self._callbacks), 0, 1)
        )
        assert self.handle

    def call(self, name: str, *arguments: object) -> int:
        """Call a function of the interface; return its status."""
        return int(getattr(self.code, f"fmi2{name}")(self.handle, *arguments))

    def begin(self, start: float = 0.0, **given: float | bool) -> Instance:
        """Set what is given and get ready to step."""
        assert self.call("SetupExperiment", 0, ctypes.c_double(0), ctypes.c_double(start), 0, ctypes.c_double(0)) == OK
        self.put(given)
        assert self.call("EnterInitializationMode") == OK
        assert self.call("ExitInitializationMode") == OK
        return self

    def put(self, given: dict[str, float | bool]) -> int:
        """Set variables; return the worst status."""
        return max((self._put(name, value) for name, value in given.items()), default=OK)

    def _put(self, name: str, value: float | bool) -> int:
        reference = (ctypes.c_uint * 1)(self.fmu.references[name])
        if isinstance(value, bool):
            return self.call("SetBoolean", reference, ctypes.c_size_t(1), (ctypes.c_int * 1)(value))
        return self.call("SetReal", reference, ctypes.c_size_t(1), (ctypes.c_double * 1)(value))

    def values(self, names: list[str]) -> np.ndarray:
        """Read variables."""
        references = (ctypes.c_uint * len(names))(*(self.fmu.references[name] for name in names))
        numbers = (ctypes.c_double * len(names))()
        assert self.call("GetReal", references, ctypes.c_size_t(len(names)), numbers) == OK
        return np.array(numbers)

    def value(self, name: str) -> float:
        """Read one variable."""
        return float(self.values([name])[0])

    def step(self, time: float, length: float) -> int:
        """Step; return the status."""
        return self.call("DoStep", ctypes.c_double(time), ctypes.c_double(length), 1)

    def run(self, times: np.ndarray, names: list[str]) -> np.ndarray:
        """Step from one time to the next; return the variables at each, shape (times, names)."""
        rows = [self.values(names)]
        for time, later in pairwise(times):
            assert self.step(float(time), float(later) - float(time)) == OK, self.said
            rows.append(self.values(names))
        return np.array(rows)

    def free(self) -> None:
        """End it."""
        self.code.fmi2FreeInstance(self.handle)


COMPILER = next(filter(None, map(shutil.which, COMPILERS)), None)
COMPILES = pytest.mark.skipif(COMPILER is None, reason=f"there is no C compiler ({', '.join(COMPILERS)})")
"""Mark of tests that compile."""


def compile_in(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Compile in a folder; return what the compiler said."""
    command = [COMPILER, "-std=c99", *words, "-lm"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
