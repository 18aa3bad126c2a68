"""A REXS file as it is put together: numbered components with attributes in REXS's units, relations, load cases."""

from __future__ import annotations

import codecs
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from xml.etree import ElementTree

from gearwright.exchange.rexs.words import OWN, UNITS, VERSIONS, Version, words
from gearwright.version import __version__

Value = float | int | str | bool | Sequence[float] | None
"""What an attribute may be, in SI; None is not written."""
BEGIN = codecs.BOM_UTF8 + b'<?xml version="1.0" encoding="UTF-8"?>\n'
"""How a file begins."""
DIGITS = 15
"""Digits with which numbers are written [-]."""


@dataclass
class Sheet:
    """A file in the making."""

    version: Version
    components: list[ElementTree.Element] = field(default_factory=list)
    relations: list[ElementTree.Element] = field(default_factory=list)
    cases: list[Mapping[int, Mapping[str, Value]]] = field(default_factory=list)
    kinds: dict[int, str] = field(default_factory=dict)
    left_out: list[str] = field(default_factory=list)
    """What REXS cannot hold, or this version of it."""
    newer: set[str] = field(default_factory=set)
    """Attributes that this version does not have."""

    def add(self, kind: str, name: str, attributes: Mapping[str, Value]) -> int:
        """Add a component and return its number.

        Args:
            kind: Type of the component.
            name: As people read it.
            attributes: In SI.
        """
        number = len(self.components) + 1
        element = ElementTree.Element("component", id=str(number), type=kind, name=_fit(name))
        self._fill(element, attributes)
        self.components.append(element)
        self.kinds[number] = kind
        return number

    def relate(self, kind: str, roles: Mapping[str, int]) -> None:
        """Add a relation.

        Args:
            kind: Type of the relation.
            roles: Component by role.
        """
        element = ElementTree.Element("relation", id=str(len(self.relations) + 1), type=kind)
        for role, number in roles.items():
            ElementTree.SubElement(element, "ref", id=str(number), role=role, hint=self.kinds[number])
        self.relations.append(element)

    def text(self) -> bytes:
        """Return the file, UTF-8 with the mark that REXS files begin with."""
        root = ElementTree.Element(
            "model", version=self.version, applicationId="gearwright", applicationVersion=__version__,
            date=datetime.now(UTC).isoformat(timespec="seconds"), applicationLanguage="en",
        )  # fmt: skip
        ElementTree.SubElement(root, "relations").extend(self.relations)
        ElementTree.SubElement(root, "components").extend(self.components)
        spectrum = ElementTree.SubElement(root, "load_spectrum", id="1")
        for place, case in enumerate(self.cases, start=1):
            element = ElementTree.SubElement(spectrum, "load_case", id=str(place))
            for number, attributes in case.items():
                child = ElementTree.SubElement(element, "component", id=str(number), type=self.kinds[number])
                self._fill(child, attributes)
        ElementTree.indent(root)
        return BEGIN + ElementTree.tostring(root, encoding="unicode").encode()

    def _fill(self, element: ElementTree.Element, attributes: Mapping[str, Value]) -> None:
        for name, value in attributes.items():
            if value is None or (isinstance(value, float) and not math.isfinite(value)):
                continue
            if name in OWN:
                ElementTree.SubElement(element, "attribute", id=name, unit="none").text = _fit(str(value))
                continue
            word = words()[name]
            if VERSIONS.index(word.since) < VERSIONS.index(self.version):
                self.newer.add(name)
                continue
            child = ElementTree.SubElement(element, "attribute", id=name, unit=word.unit)
            factor = UNITS[word.unit].factor
            if isinstance(value, str) or not isinstance(value, Iterable):
                child.text = _written(value, factor)
                continue
            array = ElementTree.SubElement(child, "array")
            for entry in value:
                ElementTree.SubElement(array, "c").text = _written(entry, factor)


def _written(value: object, factor: float) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return _fit(value)
    return f"{value / factor + 0.0:.{DIGITS}g}" if isinstance(value, float) else str(value)


def _fit(text: str) -> str:
    """Return a text without what XML cannot hold."""
    return "".join(mark if _fits(mark) else "\N{REPLACEMENT CHARACTER}" for mark in text)


def _fits(mark: str) -> bool:
    return mark in "\t\n\r" or " " <= mark <= "\ud7ff" or "\ue000" <= mark <= "\ufffd" or mark >= "\U00010000"
