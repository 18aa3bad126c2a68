"""Ports of a drive train, each with its reference, and the description of an FMU in XML (FMI 2.0 and 3.0)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Literal, NamedTuple
from xml.etree import ElementTree

from gearwright.dynamics.model import CLUTCH, MACHINE, PROPELLER, SPEED, TORQUE, Drives, System
from gearwright.errors import DesignError, Problem
from gearwright.identity import Kind
from gearwright.version import __version__

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
    return _text(root)


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
    return _text(root)


def _text(root: ElementTree.Element) -> bytes:
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
