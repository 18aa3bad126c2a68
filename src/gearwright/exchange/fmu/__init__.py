"""Functional mock-up units (FMI 2.0 and 3.0): a drive train in C for simulators of others, which needs no Python.

What moves and by which laws is `dynamics`; here it is only written in another language.
"""

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
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Literal, NamedTuple, get_args
from xml.etree import ElementTree

import numpy as np

from gearwright.base import DesignError, Floats, Kind, Problem, Shown, by_name, excerpt, near, refuse, verb
from gearwright.dynamics.assembly import assemble, loaded_bodies
from gearwright.dynamics.model import (
    CLUTCH,
    MACHINE,
    PROPELLER,
    SPEED,
    TORQUE,
    Arrays,
    Drives,
    Entries,
    Schedules,
    Series,
    System,
    check_finite,
)
from gearwright.dynamics.motion import check_step, default_step, equilibrium
from gearwright.files import write_bytes
from gearwright.processes import run_program
from gearwright.sizing import Sizing, governing_case
from gearwright.version import __version__

if TYPE_CHECKING:
    from gearwright.mission.windows import BegunWindow


# ----------------------------------------------------------------------------------------------------------------------
# Ports: the variables of a drive train that a simulator of others sets and reads, each with its reference.
# ----------------------------------------------------------------------------------------------------------------------


BLOCK = 1 << 20
"""References of a block; `instance.h` parts them again."""
INPUTS, SPEEDS, FORCES, TORQUES, DRIVES, SWITCHES = range(1, 7)
"""Blocks; 0 is time."""


class MachinePort(NamedTuple):
    """A machine whose torque or speed is given from outside."""

    name: str
    body: str
    """Rotation that feels its torque."""
    torque: float
    """In the load case, part of the system's loads [N m]."""


class Port(NamedTuple):
    """One variable."""

    name: str
    reference: int
    causality: str
    """``"input"``, ``"output"`` or ``"parameter"``."""
    unit: str
    """Empty for a switch, and for what has none."""
    words: str
    """What it is."""
    start: float | bool | None = None
    """Of inputs and parameters."""


class Read(NamedTuple):
    """What a drive reads against time."""

    name: str
    unit: str
    words: str


_READ = {
    PROPELLER: (
        Read("density", "kg/m3", "Density of the air"),
        Read("airspeed", "m/s", "Airspeed along the axis"),
        Read("set_speed", "rad/s", "Speed that the governor holds"),
        Read("pitch_command", "rad", "Added to the governor's reference"),
    ),
    MACHINE: (Read("command", "N.m", "Torque at the reference speed"),),
    CLUTCH: (Read("capacity", "N.m", "Torque at which it slips"),),
}
"""Kind of drive -> what it reads, in the order of its law."""
UNITS = {"rad": "rad/s", "m": "m/s"}
"""Unit of a coordinate -> of its speed."""
DRIVE_UNITS = {"N m": "N.m", "rad": "rad", "rad/s": "rad/s", "-": ""}
"""Unit of what a drive reports -> as FMI writes it."""


def ports_of(system: System, machines: Sequence[MachinePort] = ()) -> tuple[Port, ...]:
    """Return all variables, inputs first.

    Args:
        system: Bodies, lines, loads, drives.
        machines: Whose torques or speeds are given from outside.

    Raises:
        DesignError: If two variables would have one name, or a machine acts on no body.
    """
    ports = (*_inputs(system, machines), *_switches(system, machines), *_outputs(system, machines))
    twice = [name for name, count in Counter(port.name for port in ports).items() if count > 1]
    if twice:
        message = f"{', '.join(twice)}: names of several variables of the FMU; name bodies, lines and machines apart"
        raise DesignError([Problem("labels", message)])
    return ports


def inputs_start(system: System, machines: Sequence[MachinePort]) -> list[float]:
    """Return the start of each input, in the order of their references.

    Args:
        system: Bodies, lines, loads, drives.
        machines: Whose torques or speeds are given from outside.
    """
    return [float(port.start or 0.0) for port in _inputs(system, machines)]


def body_number(system: System, machine: MachinePort) -> int:
    """Return the coordinate that feels a machine's torque.

    Args:
        system: Bodies.
        machine: Whose it is.

    Raises:
        DesignError: If there is no such rotation.
    """
    names = system.labels.coordinates
    if machine.body not in names or system.labels.coordinate_units[names.index(machine.body)] != "rad":
        raise DesignError([Problem(f"machines.{machine.name}", f"{machine.body} is no rotation of the system")])
    return names.index(machine.body)


def has_factor(system: System) -> bool:
    """Tell whether the speed factor is an input: it is where no profile gives it.

    Args:
        system: With its profile.
    """
    return len(system.arrays.profile.time) == 1


def _inputs(system: System, machines: Sequence[MachinePort]) -> Iterator[Port]:
    names = _numbered(INPUTS)
    for machine in machines:
        words = f"Torque of {machine.name} on its shaft"
        yield Port(f"{machine.name}.torque", next(names), "input", "N.m", words, machine.torque)
    for machine in machines:
        words = f"Speed of {machine.name}, where it is given in place of the torque"
        speed = float(system.arrays.speed[body_number(system, machine)] * system.arrays.profile.factor[0])
        yield Port(f"{machine.name}.given_speed", next(names), "input", "rad/s", words, speed)
    yield from _read(system, names)
    if has_factor(system):
        words = "Speed over that of the load case, with which the phases of teeth run"
        yield Port("speed_factor", next(names), "input", "", words, float(system.arrays.profile.factor[0]))


def _read(system: System, names: Iterator[int]) -> Iterator[Port]:
    """Yield what drives read: itself where it is constant, else what is added to its curve."""
    inputs, places = system.arrays.drives.inputs, iter(range(len(system.arrays.drives.inputs.dof)))
    for name, kind in drives_of(system):
        for read, place in zip(_READ[kind], places, strict=False):
            first, past = inputs.start[place], inputs.start[place + 1]
            if past - first == 1:
                start = float(inputs.value[first])
                yield Port(f"{name}.{read.name}", next(names), "input", read.unit, f"{read.words} of {name}", start)
            else:
                words = f"{read.words} of {name}: added to what it is over time"
                yield Port(f"{name}.added_{read.name}", next(names), "input", read.unit, words, 0.0)


def drives_of(system: System) -> list[tuple[str, int]]:
    """Return name and kind of each drive.

    Args:
        system: With its drives.
    """
    drives, owners = system.arrays.drives, system.labels.drive_owners
    reports = owners[len(drives.start) :: 3]
    named = zip(reports, kinds_of(drives), strict=False)
    return [(owner.part.name if owner.part else f"drive-{n}", kind) for n, (owner, kind) in enumerate(named)]


def kinds_of(drives: Drives) -> list[int]:
    """Return the kind of each drive, in the order of their records.

    Args:
        drives: As encoded.
    """
    kinds, place = list[int](), 2
    while place < len(drives.table):
        kinds.append(int(drives.table[place + 1]))
        place += int(drives.table[place])
    return kinds


def _switches(system: System, machines: Sequence[MachinePort]) -> Iterator[Port]:
    names = _numbered(SWITCHES)
    for machine in machines:
        words = f"Whether the speed of {machine.name} is given, not its torque"
        yield Port(f"{machine.name}.speed_is_given", next(names), "parameter", "", words, start=False)
    if has_factor(system):
        words = "Whether the phases of teeth run with the train's own speed, not with speed_factor"
        yield Port("phases_follow", next(names), "parameter", "", words, start=False)


def _outputs(system: System, machines: Sequence[MachinePort]) -> Iterator[Port]:
    labels = system.labels
    for reference, name, unit in zip(_numbered(SPEEDS), labels.coordinates, labels.coordinate_units, strict=False):
        yield Port(f"{name}.speed", reference, "output", UNITS[unit], f"Speed of {name}")
    for reference, name, unit in zip(_numbered(FORCES), labels.lines, labels.line_units, strict=False):
        what, newton = ("force", "N") if unit == "m" else ("transmitted_torque", "N.m")
        yield Port(f"{name}.{what}", reference, "output", newton, f"What {name} carries")
    for reference, machine in zip(_numbered(TORQUES), machines, strict=False):
        words = f"Torque that acts on the shaft of {machine.name}: given, or what its given speed takes"
        yield Port(f"{machine.name}.acting_torque", reference, "output", "N.m", words)
    for reference, owner, name, unit in zip(
        _numbered(DRIVES), labels.drive_owners, labels.drives, labels.drive_units, strict=False
    ):
        part, what = owner.part.name if owner.part else name, owner.what.replace(" ", "_")
        # Bodies have speeds and machines torques of their own.
        named = f"drive_{what}" if what in (TORQUE, SPEED) and owner.part and owner.part.kind is Kind.MACHINE else what
        yield Port(f"{part}.{named}", reference, "output", DRIVE_UNITS[unit], f"{owner.what} of {part}")


def _numbered(block: int) -> Iterator[int]:
    return iter(range(block * BLOCK, (block + 1) * BLOCK))


# ----------------------------------------------------------------------------------------------------------------------
# Model description: what an FMU is, in XML, for FMI 2.0 and 3.0.
# ----------------------------------------------------------------------------------------------------------------------


Version = Literal["2.0", "3.0"]
"""Of FMI."""
RPM = 60.0 / 6.283185307179586
"""Revolutions per minute in a radian per second [-]."""
_UNITS: dict[str, dict[str, str]] = {
    "s": {"s": "1"},
    "N": {"kg": "1", "m": "1", "s": "-2"},
    "N.m": {"kg": "1", "m": "2", "s": "-2"},
    "rad": {"rad": "1"},
    "rad/s": {"rad": "1", "s": "-1"},
    "m/s": {"m": "1", "s": "-1"},
    "kg/m3": {"kg": "1", "m": "-3"},
}
"""Unit -> its exponents in base units."""


def model_description(
    ports: Sequence[Port], *, name: str, token: str, identifier: str, version: Version, interval: float
) -> bytes:
    """Return ``modelDescription.xml``.

    Args:
        ports: All variables.
        name: Of the model.
        token: By which binary and description know each other.
        identifier: Of the model in C.
        version: Of FMI.
        interval: Communication step that is proposed [s].

    Source: FMI 2.0 and 3.0, Modelica Association, fmi-standard.org.
    """
    newer = version == "3.0"
    root = ElementTree.Element("fmiModelDescription", fmiVersion=version, modelName=name)
    root.attrib["instantiationToken" if newer else "guid"] = token
    root.attrib |= {"generationTool": f"gearwright {__version__}", "variableNamingConvention": "flat"}
    root.attrib |= {} if newer else {"numberOfEventIndicators": "0"}
    root.append(_interface(identifier, newer=newer))
    _add_units(root, {"s", *(port.unit for port in ports if port.unit)})
    categories = ElementTree.SubElement(root, "LogCategories")
    ElementTree.SubElement(categories, "Category", name="logStatusError", description="What was refused, and why")
    ElementTree.SubElement(root, "DefaultExperiment", startTime="0", stopTime="0.1", stepSize=repr(interval))
    variables = ElementTree.SubElement(root, "ModelVariables")
    ElementTree.SubElement(root, "ModelStructure").extend(_structure(ports, newer=newer))
    variables.extend(_variables_3(ports) if newer else _variables_2(ports))
    return _xml(root)


def build_description(identifier: str, source: str) -> bytes:
    """Return ``buildDescription.xml``, by which importers of FMI 3.0 compile the source.

    Args:
        identifier: Of the model in C.
        source: File to compile.
    """
    root = ElementTree.Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = ElementTree.SubElement(root, "BuildConfiguration", modelIdentifier=identifier)
    files = ElementTree.SubElement(configuration, "SourceFileSet", language="C99")
    ElementTree.SubElement(files, "SourceFile", name=source)
    return _xml(root)


def _xml(root: ElementTree.Element) -> bytes:
    ElementTree.indent(root)
    text: bytes = ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True)
    return text


def _interface(identifier: str, *, newer: bool) -> ElementTree.Element:
    state, stored = ("State", "State") if newer else ("state", "state")
    able = ("canHandleVariableCommunicationStepSize", f"canGetAndSetFMU{state}", f"canSerializeFMU{stored}")
    interface = ElementTree.Element("CoSimulation", dict.fromkeys(able, "true"), modelIdentifier=identifier)
    if not newer:
        files = ElementTree.SubElement(interface, "SourceFiles")
        ElementTree.SubElement(files, "File", name="fmi2.c")
    return interface


def _add_units(root: ElementTree.Element, used: set[str]) -> None:
    definitions = ElementTree.SubElement(root, "UnitDefinitions")
    for unit in (unit for unit in _UNITS if unit in used):
        element = ElementTree.SubElement(definitions, "Unit", name=unit)
        ElementTree.SubElement(element, "BaseUnit", _UNITS[unit])
        if unit == "rad/s":
            ElementTree.SubElement(element, "DisplayUnit", name="rpm", factor=repr(RPM))


def _about(port: Port) -> dict[str, str]:
    """Return the attributes that both versions write alike."""
    switch = isinstance(port.start, bool)
    kept = {"variability": "fixed" if switch else "continuous"}
    kept |= {"initial": "exact"} if port.causality == "parameter" else {}
    kept |= {"initial": "calculated"} if port.causality == "output" else {}
    return {
        "name": port.name,
        "valueReference": str(port.reference),
        "causality": port.causality,
        **kept,
        "description": port.words,
    }


def _value(port: Port) -> dict[str, str]:
    if isinstance(port.start, bool):
        return {"start": str(port.start).lower()}
    unit = {"unit": port.unit} if port.unit else {}
    return unit if port.start is None else unit | {"start": repr(port.start)}


def _kind(port: Port, real: str) -> str:
    return "Boolean" if isinstance(port.start, bool) else real


def _variables_2(ports: Sequence[Port]) -> list[ElementTree.Element]:
    clock = {"name": "time", "valueReference": "0", "causality": "independent", "variability": "continuous"}
    variables = [ElementTree.Element("ScalarVariable", clock)]
    ElementTree.SubElement(variables[0], "Real", unit="s")
    for port in ports:
        variable = ElementTree.Element("ScalarVariable", _about(port))
        ElementTree.SubElement(variable, _kind(port, "Real"), _value(port))
        variables.append(variable)
    return variables


def _variables_3(ports: Sequence[Port]) -> list[ElementTree.Element]:
    clock = {"name": "time", "valueReference": "0", "causality": "independent", "variability": "continuous"}
    time = ElementTree.Element("Float64", clock, unit="s")
    return [time, *(ElementTree.Element(_kind(port, "Float64"), _about(port) | _value(port)) for port in ports)]


def _structure(ports: Sequence[Port], *, newer: bool) -> list[ElementTree.Element]:
    """Return outputs and what is calculated at the start, by number in 2.0 and by reference in 3.0."""
    outputs = [(number, port) for number, port in enumerate(ports, start=2) if port.causality == "output"]
    if newer:
        return [
            ElementTree.Element(name, valueReference=str(port.reference))
            for name in ("Output", "InitialUnknown")
            for _, port in outputs
        ]
    lists = [ElementTree.Element(name) for name in ("Outputs", "InitialUnknowns")]
    for element in lists:
        element.extend(ElementTree.Element("Unknown", index=str(number)) for number, _ in outputs)
    return lists


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
    lines += [f"static const char *const INPUT_NAME[] = {{{', '.join(map(_c_text, names)) or '0'}}};"]
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


def _c_text(name: str) -> str:
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


# ----------------------------------------------------------------------------------------------------------------------
# Functional mock-up units (FMI 2.0 and 3.0): a drive train in C for simulators of others, which needs no Python.
# ----------------------------------------------------------------------------------------------------------------------


__all__ = [
    "COMPILERS",
    "Binary",
    "FmuFile",
    "MachinePort",
    "Port",
    "compiled",
    "fmu_of_system",
    "fmu_of_window",
    "ports_of",
    "to_fmu",
]
