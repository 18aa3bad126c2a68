"""Model description: what an FMU is, in XML, for FMI 2.0 and 3.0."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal
from xml.etree import ElementTree

from gearwright.exchange.fmu.ports import Port
from gearwright.version import __version__

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
