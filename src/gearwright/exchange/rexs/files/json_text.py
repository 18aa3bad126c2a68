"""JSON as a REXS document: the same records as of XML, every problem with its line."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from gearwright.errors import Problem, excerpt, refuse
from gearwright.exchange.rexs.files.coded import decoded
from gearwright.exchange.rexs.files.document import Attribute, Component, Document, Relation
from gearwright.exchange.rexs.files.parsing import unread_version

MOST = 300_000
"""Most objects that a file may hold [-]; a wind turbine's gearbox with all results has 13 000."""
_LINE = "#line"
"""Key under which every object has the line where it begins; no key of REXS has the sign."""
_MARKS = re.compile(r'"(?:[^"\\]|\\.)*"|[{}\n]', re.DOTALL)


def document_of_json(text: str, source: str) -> Document:
    """Return what a REXS file says.

    Args:
        text: Of the file.
        source: Its name, for messages.

    Raises:
        DesignError: If it is no JSON, or is no REXS file of a version that is read.
    """
    if text.count("{") > MOST:
        refuse([Problem("", f"it holds more than {MOST:,} objects, the most that are read")], source)
    lines = _lines(text)
    try:
        said = json.loads(text, object_pairs_hook=lambda pairs: {**dict(pairs), _LINE: next(lines)})
    except json.JSONDecodeError as error:
        refuse([Problem("", f"this is no whole JSON file: {error.msg}; export it again", error.lineno)], source)
    except (RecursionError, StopIteration):
        refuse([Problem("", "its values stand too deep in each other; those of REXS stand 9 deep")], source)
    except ValueError as error:  # a number of thousands of digits
        refuse([Problem("", f"it holds what is no number: {excerpt(str(error))}")], source)
    reading = _Reading()
    document = reading.document(said)
    refuse(reading.problems, source)
    return document


def _lines(text: str) -> Iterator[int]:
    """Yield the line where each object begins, in the order in which they end, as they are made."""
    line, begun = 1, list[int]()
    for mark in _MARKS.finditer(text):
        sign = mark.group()
        if sign == "{":
            begun.append(line)
        elif sign == "}" and begun:
            yield begun.pop()
        line += sign.count("\n")


@dataclass
class _Reading:
    """What is wrong with a file."""

    problems: list[Problem] = field(default_factory=list)

    def document(self, said: object) -> Document:
        """Return everything of a file."""
        whole = self._record(said, "", 1)
        if "model" not in whole:
            self.problems.append(Problem("", "the file has no model: it is no REXS file", whole.get(_LINE)))
            return Document("", "", {}, (), ())
        model = self._record(whole["model"], "model", whole[_LINE])
        version = str(model.get("version", ""))
        self.problems += unread_version(version, model.get(_LINE, 1))
        application = " ".join(str(model[key]) for key in ("applicationId", "applicationVersion") if model.get(key))
        components: dict[int, Component] = {}
        for component in self._components(model, "components", {}):
            if component.number in components:
                other = components[component.number].line
                message = f"the id {component.number} stands at line {other}, too; every component has its own"
                self.problems.append(Problem(component.path, message, component.line))
            components[component.number] = component
        spectrum = self._record(model.get("load_spectrum") or {}, "model.load_spectrum", model.get(_LINE, 1))
        cases = tuple({part.number: part for part in self._components(case, "load_spectrum.components", components)}
                      for case in self._records(spectrum, "load_cases"))  # fmt: skip
        sums = sum(bool(place.get("accumulation")) for place in (model, spectrum))
        return Document(version, application, components, tuple(self._relations(model)), cases, sums)

    def _record(self, value: object, path: str, line: int) -> dict[str, Any]:
        if isinstance(value, dict):
            return value
        self.problems.append(Problem(path, f"is {excerpt(repr(value))}; give an object", line))
        return {}

    def _records(self, holder: Mapping[str, Any], key: str) -> list[dict[str, Any]]:
        line, values = holder.get(_LINE, 1), holder.get(key) or []
        if isinstance(values, list):
            return [self._record(value, key, line) for value in values]
        self.problems.append(Problem(key, f"is {excerpt(repr(values))}; give a list of objects", line))
        return []

    def _number(self, record: Mapping[str, Any], path: str) -> int:
        number = record.get("id")
        if isinstance(number, int) and not isinstance(number, bool) and 0 <= number < 10**9:
            return number
        self.problems.append(
            Problem(f"{path}.id", f"is {excerpt(repr(number))}; give a whole number", record.get(_LINE))
        )
        return -1

    def _relations(self, model: Mapping[str, Any]) -> Iterator[Relation]:
        for relation in self._records(model, "relations"):
            kind = str(relation.get("type", ""))
            ends = tuple((str(ref.get("role", "")), self._number(ref, f"relations.{excerpt(kind)}"))
                         for ref in self._records(relation, "refs"))  # fmt: skip
            yield Relation(kind, ends, relation.get(_LINE, 1))

    def _components(self, holder: Mapping[str, Any], path: str, known: Mapping[int, Component]) -> Iterator[Component]:
        for record in self._records(holder, "components"):
            number = self._number(record, path)
            kind = str(record.get("type") or (known[number].kind if number in known else ""))
            attributes = {str(said.get("id", "")): self._attribute(said, f"{path}.{excerpt(kind)}[{number}]")
                          for said in self._records(record, "attributes")}  # fmt: skip
            yield Component(number, kind, str(record.get("name") or ""), record.get(_LINE, 1), attributes)

    def _attribute(self, said: Mapping[str, Any], path: str) -> Attribute:
        """Return an attribute: what is neither its name, its unit nor its line is its value, by its type."""
        unit, line = said.get("unit"), said.get(_LINE, 1)
        value = next((value for key, value in said.items() if key not in ("id", "unit", _LINE)), None)
        cells, text = tuple[str, ...](), ""
        if isinstance(value, dict):
            try:
                cells = decoded(str(value.get("value", "")), str(value.get("code", "")))
            except ValueError as error:
                self.problems.append(Problem(f"{path}.{excerpt(str(said.get('id')))}", str(error), line))
        elif isinstance(value, list):
            cells = tuple(_cells(value))
        elif value is not None:
            text = _text(value)
        return Attribute(text, cells, None if unit is None else str(unit), line)


def _cells(values: list[object]) -> Iterator[str]:
    for value in values:
        if isinstance(value, list):
            yield from map(_text, value)
        else:
            yield _text(value)


def _text(value: object) -> str:
    """Return a value as XML has it."""
    return str(value).lower() if isinstance(value, bool) else str(value)
