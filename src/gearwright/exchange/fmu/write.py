"""The verb: a drive train as an FMU."""

from __future__ import annotations

import hashlib
import io
import uuid
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from typing import TYPE_CHECKING, get_args

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.assembly import assemble, loaded_bodies
from gearwright.dynamics.model import System, check_finite
from gearwright.dynamics.motion import check_step, default_step, equilibrium
from gearwright.errors import Problem, by_name, near, refuse
from gearwright.exchange.fmu.compiling import FLAGS, Binary, compiled
from gearwright.exchange.fmu.described import Version, build_description, model_description
from gearwright.exchange.fmu.numbers import numbers_text
from gearwright.exchange.fmu.ports import MachinePort, Port, ports_of
from gearwright.showing import Shown
from gearwright.sizing import Sizing, governing_case
from gearwright.verbs import verb

if TYPE_CHECKING:
    from gearwright.mission.windows import BegunWindow

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
