"""The verb: a drive train as an FMU, its numbers as constants of C, compiled where there is a compiler."""

from __future__ import annotations

import hashlib
import io
import math
import platform
import shutil
import subprocess
import sys
import tempfile
import uuid
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, get_args

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.assembly import assemble, loaded_bodies
from gearwright.dynamics.model import PROPELLER, Arrays, Entries, Schedules, Series, System, check_finite
from gearwright.dynamics.motion import check_step, default_step, equilibrium
from gearwright.errors import Problem, by_name, excerpt, near, refuse
from gearwright.exchange.fmu.description import (
    MachinePort,
    Port,
    Version,
    body_number,
    build_description,
    has_factor,
    inputs_start,
    kinds_of,
    model_description,
    ports_of,
)
from gearwright.files import write_bytes
from gearwright.processes import run_program
from gearwright.showing import Shown
from gearwright.sizing import Sizing, governing_case
from gearwright.verbs import verb

if TYPE_CHECKING:
    from gearwright.mission.windows import BegunWindow


# ----------------------------------------------------------------------------------------------------------------------
# Numbers of a system as constants of C: hexadecimal, so that none is rounded.
# ----------------------------------------------------------------------------------------------------------------------


WIDTH = 6
"""Numbers in a line of text."""


def numbers_text(
    system: System, machines: Sequence[MachinePort], ports: Sequence[Port], *, start: Floats, step: float
) -> str:
    """Return all that `model.h` reads of a system, but version and token.

    Args:
        system: Bodies, lines, loads, drives.
        machines: Whose torques or speeds are given from outside.
        ports: Its variables.
        start: State at time 0: q, q̇, states of drives.
        step: Of the integration [s].
    """
    arrays, drives = system.arrays, system.arrays.drives
    kinds, names = kinds_of(drives), [port.name for port in ports if port.causality == "input"]
    counts = {
        "COORDINATES": len(arrays.mass),
        "LINE_COUNT": len(arrays.stiffness),
        "TONE_COUNT": len(arrays.tone_rate),
        "MACHINE_COUNT": len(machines),
        "SCHEDULE_COUNT": len(arrays.loads.schedules.dof),
        "GYROSCOPIC_COUNT": len(arrays.gyroscopic.value),
        "CENTRIPETAL_COUNT": len(arrays.centripetal.value),
        "PROFILE_COUNT": len(arrays.profile.time),
        "FACTOR_INPUT": int(has_factor(system)),
        "DRIVE_COUNT": len(kinds),
        "DRIVE_STATES": len(drives.start),
        "DRIVE_INPUT_COUNT": len(drives.inputs.dof),
    }
    lines = [f"#define {name} {count}" for name, count in counts.items()]
    lines += [f"static const double STEP = {_number(step)}; /* {step!r} s */"]
    lines += _system(arrays)
    lines += _doubles("DRIVE", drives.table[2:]) + _doubles("START", start) if kinds else _doubles("START", start)
    lines += _integers("DRIVE_WARNS", [int(kind == PROPELLER) for kind in kinds])
    lines += _schedule("READ", drives.inputs)
    lines += _integers("MACHINE_DOF", [body_number(system, machine) for machine in machines])
    lines += _doubles("INPUT_START", inputs_start(system, machines))
    lines += [f"static const char *const INPUT_NAME[] = {{{', '.join(map(_text, names)) or '0'}}};"]
    return "\n".join(lines) + "\n"


def _system(arrays: Arrays) -> list[str]:
    loads, profile = arrays.loads, arrays.profile
    return [
        *_doubles("MASS", arrays.mass),
        *_doubles("SPEED", arrays.speed),
        *_integers("LINE_START", arrays.line_start),
        *_integers("LINE_DOF", arrays.line_dof),
        *_doubles("LINE_WEIGHT", arrays.line_weight),
        *_doubles("STIFFNESS", arrays.stiffness),
        *_doubles("DAMPING", arrays.damping),
        *_doubles("SLIP", arrays.slip),
        # A line without backlash carries on both sides: its dead zone has no width.
        *_doubles("BACKLASH", arrays.backlash),
        *_doubles("TONE_RATE", arrays.tone_rate),
        *_series("VARIATION", arrays.variation),
        *_series("ERROR", arrays.error),
        *_entries("GYROSCOPIC", arrays.gyroscopic),
        *_entries("CENTRIPETAL", arrays.centripetal),
        *_doubles("LOAD", loads.constant),
        *_doubles("LOAD_DAMPING", loads.damping),
        *_doubles("LOAD_QUADRATIC", loads.quadratic),
        *_integers("SCHEDULE_DOF", loads.schedules.dof),
        *_schedule("SCHEDULE", loads.schedules),
        *_doubles("PROFILE", profile.factor),
        *([] if len(profile.time) == 1 else _doubles("PROFILE_TIME", profile.time)),
        *([] if len(profile.time) == 1 else _doubles("PROFILE_TRAVEL", profile.travel)),
    ]


def _series(name: str, series: Series) -> list[str]:
    return [
        *_integers(f"{name}_START", series.start),
        *_integers(f"{name}_TONE", series.tone),
        *_doubles(f"{name}_COSINE", series.cosine),
        *_doubles(f"{name}_SINE", series.sine),
    ]


def _entries(name: str, entries: Entries) -> list[str]:
    return [
        *_integers(f"{name}_ROW", entries.row),
        *_integers(f"{name}_COLUMN", entries.column),
        *_doubles(name, entries.value),
    ]


def _schedule(name: str, schedules: Schedules) -> list[str]:
    return [
        *_integers(f"{name}_START", schedules.start),
        *_doubles(f"{name}_TIME", schedules.time),
        *_doubles(name, schedules.value),
    ]


def _doubles(name: str, values: Iterable[float] | Floats) -> list[str]:
    return _array("double", name, [_number(float(value)) for value in np.ravel(np.asarray(values))])


def _integers(name: str, values: Iterable[int]) -> list[str]:
    return _array("int", name, [str(int(value)) for value in values])


def _array(kind: str, name: str, values: list[str]) -> list[str]:
    """Return an array; C has none without numbers, so that one stands for them."""
    values = values or ["0"]
    rows = [", ".join(values[first : first + WIDTH]) for first in range(0, len(values), WIDTH)]
    return [f"static const {kind} {name}[{len(values)}] = {{", *(f"    {row}," for row in rows), "};"]


def _number(value: float) -> str:
    if math.isnan(value):
        return "NAN"
    return value.hex() if math.isfinite(value) else "INFINITY" if value > 0.0 else "-INFINITY"


def _text(name: str) -> str:
    """Return a name as a text of C, also of one that a message's format would take for its own."""
    letters = (chr(byte) if 32 <= byte < 127 and chr(byte) not in '"\\%?' else _escaped(byte) for byte in name.encode())
    return f'"{"".join(letters)}"'


def _escaped(byte: int) -> str:
    return "%%" if byte == ord("%") else f"\\{byte:03o}"


# ----------------------------------------------------------------------------------------------------------------------
# Compile the source of an FMU, where there is a C compiler.
# ----------------------------------------------------------------------------------------------------------------------


COMPILERS = ("cc", "gcc", "clang")
"""Names by which they are looked for."""
FLAGS = ("-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-ffp-contract=off")
"""What they are given: numbers agree with those of `simulate` only if products and sums are rounded apart."""
LONGEST = 300
"""Seconds that a compiler may take."""
_SYSTEMS = {"linux": "linux", "darwin": "darwin", "win32": "windows"}
_SHORT = {"linux": "linux64", "darwin": "darwin64", "windows": "win64"}
_SUFFIX = {"linux": ".so", "darwin": ".dylib", "windows": ".dll"}
_MACHINES = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "aarch64", "arm64": "aarch64"}


class Binary(NamedTuple):
    """A shared library for this platform, or why there is none."""

    content: bytes
    """Empty where there is none."""
    place: str
    """In the FMU."""
    platform: str
    """Such as ``x86_64-linux``."""
    missing: str = ""
    """Why there is none."""


def compiled(sources: Mapping[str, bytes], main: str, identifier: str, *, version: str) -> Binary:
    """Return the shared library of a source for this platform.

    Args:
        sources: Name -> file, all in one folder.
        main: File to compile.
        identifier: Of the model, the name of the library.
        version: Of FMI, which names platforms in its own way.
    """
    system, machine = _SYSTEMS.get(sys.platform, ""), _MACHINES.get(platform.machine().lower(), "")
    name = f"{machine}-{system}"
    compiler = next((path for path in map(shutil.which, COMPILERS) if path), None)
    if not system or not machine:
        return Binary(b"", "", name, f"FMI has no name for the platform {sys.platform}, {platform.machine()}")
    if compiler is None:
        return Binary(b"", "", name, f"there is no C compiler ({', '.join(COMPILERS)})")
    folder = name if version == "3.0" else _SHORT[system]
    with tempfile.TemporaryDirectory() as place:
        for file, content in sources.items():
            write_bytes(Path(place, file), content)
        library = Path(place, identifier + _SUFFIX[system])
        try:
            command = [compiler, *FLAGS, main, "-o", library.name, "-lm"]
            run = run_program(command, seconds=LONGEST, folder=Path(place))
        except (OSError, subprocess.TimeoutExpired) as error:
            return Binary(b"", "", name, f"{compiler} failed: {excerpt(str(error))}")
        if run.returncode or not library.is_file():
            return Binary(b"", "", name, f"{compiler} failed: {excerpt(run.stderr or run.stdout)}")
        return Binary(library.read_bytes(), f"binaries/{folder}/{library.name}", name)


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a drive train as an FMU.
# ----------------------------------------------------------------------------------------------------------------------


SHARED = ("model.h", "laws.h", "equations.h", "motion.h", "instance.h")
"""Sources that both versions of FMI use."""
FEW = 10
"""Steps of the integration in a communication step that is proposed, about."""
_DATE = (1980, 1, 1, 0, 0, 0)
"""Of files in the archive: the same model makes the same file."""


@dataclass(frozen=True, repr=False)
class FmuFile(Shown):
    """A drive train as a functional mock-up unit for co-simulation."""

    content: bytes
    """The file."""
    version: Version
    """Of FMI."""
    ports: tuple[Port, ...]
    """Its variables."""
    step: float
    """Of its integration, whatever the simulator's [s]."""
    platform: str
    """For which a binary is inside; empty where only sources are."""
    missing: str
    """Why no binary is inside; empty where one is."""


@verb
def to_fmu(
    sizing: Sizing,
    case: str | None = None,
    *,
    version: Version = "2.0",
    step: float | None = None,
    binary: bool = True,
) -> FmuFile:
    """Return a sized drive train as an FMU for co-simulation: torques or speeds of machines in, speeds and forces out.

    It holds the equations of `assemble` and the steps of `simulate` in C, with all numbers of the system, and begins in
    static equilibrium of the case. A binary for this platform is inside where there is a C compiler, sources always.

    Args:
        sizing: As sized.
        case: Load case; left out: the governing one, which has the least margin.
        version: Of FMI.
        step: Of the integration [s]; left out: that of `simulate`, which the simulator's own steps do not change.
        binary: False leaves out the binary.

    Raises:
        DesignError: No such case, version or step.
        SolveError: What the system has and the FMU has no law for.

    Source: FMI 2.0 and 3.0, Modelica Association, fmi-standard.org.

    >>> import gearwright as gw
    >>> file = gw.to_fmu(gw.size(gw.read("single-planetary")), binary=False)
    >>> file.ports[0].name, file.ports[0].unit
    ('gas-turbine.torque', 'N.m')
    """
    case = case or governing_case(sizing)
    flow, bodies = by_name(case, sizing.flows, "case"), loaded_bodies(sizing, case)
    machines = [MachinePort(name, body, flow.machine_torques.get(name, 0.0)) for name, body in bodies.items()]
    system = assemble(sizing, case)
    return fmu_of_system(
        system, machines, name=f"{sizing.design.name}, {case}", version=version, step=step, binary=binary
    )


def fmu_of_system(
    system: System,
    machines: Sequence[MachinePort] = (),
    *,
    name: str = "drive train",
    version: Version = "2.0",
    step: float | None = None,
    start: tuple[Floats, Floats] | None = None,
    binary: bool = True,
) -> FmuFile:
    """Return any system as an FMU, one built by hand or that of a mission's window with its propeller and machines.

    Args:
        system: Bodies, lines, loads, drives.
        machines: Whose torques or speeds are given from outside; what drives read is an input without them.
        name: Of the model.
        version: Of FMI.
        step: Of the integration [s]; left out: that of `simulate`.
        start: (q, q̇); left out: static equilibrium.
        binary: False leaves out the binary.

    Raises:
        DesignError: No such version, step or start.
        SolveError: What the system has and the FMU has no law for.
    """
    if version not in get_args(Version):
        refuse([Problem("version", f"FMI {version} is not written; {near(str(version), get_args(Version))}")])
    check_finite(system)
    step = default_step(system.arrays) if step is None else step
    check_step(system.arrays, step)
    ports = ports_of(system, machines)
    numbers = numbers_text(system, machines, ports, start=_start(system, start), step=step)
    sources = _sources(numbers, version)
    identifier = _identifier(name)
    token = _token(sources, ports, name)
    header = f'#define FMI_VERSION {version[0]}\n#define TOKEN "{token}"\n{numbers}'
    sources["numbers.h"] = header.encode()
    main = f"fmi{version[0]}.c"
    library = compiled(sources, main, identifier, version=version) if binary else Binary(b"", "", "", "left out")
    sources["README.txt"] = _readme(name, main, identifier).encode()
    if version == "3.0":
        sources["buildDescription.xml"] = build_description(identifier, main)
    described = model_description(
        ports, name=name, token=token, identifier=identifier, version=version, interval=FEW * step
    )
    content = _packed(described, sources, library)
    return FmuFile(content, version, ports, step, library.platform if library.content else "", library.missing)


def fmu_of_window(
    window: BegunWindow, *, version: Version = "2.0", step: float | None = None, binary: bool = True
) -> FmuFile:
    """Return a window of a mission as an FMU that begins as the window does: propeller, governor, machines, clutches.

    Args:
        window: From `begun_window`.
        version: Of FMI.
        step: Of the integration [s]; left out: that of `simulate`.
        binary: False leaves out the binary.

    Raises:
        DesignError: No such version or step.
        SolveError: What the system has and the FMU has no law for.
    """
    return fmu_of_system(window.system, name=window.name, version=version, step=step, start=window.start, binary=binary)


def _start(system: System, start: tuple[Floats, Floats] | None) -> Floats:
    size = len(system.arrays.mass)
    position, velocity = (equilibrium(system), np.zeros(size)) if start is None else start
    state = np.concatenate([np.ravel(position), np.ravel(velocity), system.arrays.drives.start])
    if len(state) != 2 * size + len(system.arrays.drives.start) or not np.all(np.isfinite(state)):
        refuse([Problem("start", f"give (position, velocity), {size} finite numbers each")])
    return state


def _sources(numbers: str, version: Version) -> dict[str, bytes]:
    folder, own = files(__package__) / "c", (f"fmi{version[0]}.h", f"fmi{version[0]}.c")
    return {"numbers.h": numbers.encode()} | {name: (folder / name).read_bytes() for name in (*SHARED, *own)}


def _token(sources: Mapping[str, bytes], ports: Sequence[Port], name: str) -> str:
    digest = hashlib.sha256(repr((sorted(sources.items()), ports, name)).encode())
    return f"{{{uuid.UUID(bytes=digest.digest()[:16])}}}"


def _identifier(name: str) -> str:
    """Return a name for C.

    >>> _identifier("in-line-h2, take-off")
    'model_in_line_h2__take_off'
    """
    letters = (letter if letter.isascii() and letter.isalnum() else "_" for letter in name)
    return f"model_{''.join(letters)}"


def _readme(name: str, main: str, identifier: str) -> str:
    return (
        f"{name}: a drive train in C99, without other files than these. To compile it for another platform:\n\n"
        f"    cc {' '.join(FLAGS)} {main} -o {identifier}.so -lm\n\n"
        "and put the library into the folder of that platform in binaries/, as FMI names it. Leave contraction of\n"
        "products and sums off: with it, results differ from those of gearwright in their last digits.\n"
    )


def _packed(described: bytes, sources: Mapping[str, bytes], library: Binary) -> bytes:
    inside = {"modelDescription.xml": described} | {f"sources/{name}": text for name, text in sources.items()}
    inside |= {library.place: library.content} if library.content else {}
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for path, content in inside.items():
            archive.writestr(zipfile.ZipInfo(path, _DATE), content, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()
