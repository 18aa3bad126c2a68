"""XML as a REXS document: no document types, no entities, nothing from elsewhere, every problem with its line."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from xml.parsers import expat

from gearwright.errors import Problem, excerpt, refuse
from gearwright.exchange.rexs.files.coded import decoded
from gearwright.exchange.rexs.files.document import Attribute, Component, Document, Relation

READ = ("1.0", "1.1", "1.2", "1.3", "1.4", "1.5", "1.6", "1.7")
"""Versions that are read."""
DEEPEST = 20
"""How deep elements may stand in each other [-]; REXS's own need 7."""


def document_of(text: str, source: str) -> Document:
    """Return what a REXS file says.

    Args:
        text: Of the file.
        source: Its name, for messages.

    Raises:
        DesignError: If it is no XML, declares a document type, or is no REXS file of a version that is read.
    """
    reading = _Reading()
    parser = expat.ParserCreate()
    reading.parser = parser
    parser.buffer_text = True
    parser.StartDoctypeDeclHandler = _refuse_doctype
    parser.StartElementHandler, parser.EndElementHandler = reading.start, reading.end
    parser.CharacterDataHandler = reading.characters
    try:
        parser.Parse(text)
        parser.Parse("", True)  # noqa: FBT003 - the end, as expat has it
    except expat.ExpatError as error:
        said = f"this is no whole XML file: {expat.ErrorString(error.code)}; export it again"
        refuse([*reading.problems, Problem("", said, error.lineno)], source)
    except _Forbidden as error:
        refuse([Problem("", str(error), parser.CurrentLineNumber)], source)
    refuse(reading.problems, source)
    return reading.document()


def unread_version(version: str, line: int) -> list[Problem]:
    """Return what is said of a version that is not read; nothing of others.

    Args:
        version: As the file says.
        line: Where it says so [-].
    """
    said = f"is {excerpt(version)!r}; REXS {READ[0]} to {READ[-1]} is read: export it in one of them"
    return [] if version in READ else [Problem("model.version", said, line)]


class _Forbidden(Exception):
    """What a REXS file may not hold."""


def _refuse_doctype(*_: object) -> None:
    raise _Forbidden("the file declares a document type, which could define entities; REXS files have none: remove it")


@dataclass
class _Reading:
    """The parts of a file, as they come."""

    problems: list[Problem] = field(default_factory=list)
    stack: list[str] = field(default_factory=list)
    model: Mapping[str, str] = field(default_factory=dict)
    components: dict[int, Component] = field(default_factory=dict)
    relations: list[Relation] = field(default_factory=list)
    cases: list[dict[int, Component]] = field(default_factory=list)
    accumulations: int = 0
    ends: list[tuple[str, int]] = field(default_factory=list)
    attributes: dict[str, Attribute] = field(default_factory=dict)
    opened: list[tuple[Mapping[str, str], int]] = field(default_factory=list)
    cells: list[str] = field(default_factory=list)
    words: list[str] = field(default_factory=list)
    parser: expat.XMLParserType | None = None

    @property
    def line(self) -> int:
        """Where the parser is [-]."""
        return self.parser.CurrentLineNumber if self.parser else 0

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Take the beginning of an element."""
        if not self.stack:
            self._root(tag, attributes)
        if len(self.stack) >= DEEPEST:
            raise _Forbidden(f"elements stand more than {DEEPEST} deep in each other; those of REXS stand 7 deep")
        self.stack.append(tag)
        self.opened.append((attributes, self.line))
        self.words = []
        if tag == "load_case":
            self.cases.append({})
        elif tag == "accumulation":
            self.accumulations += 1
        elif tag == "component":
            self.attributes = {}
        elif tag == "relation":
            self.ends = []
        elif tag == "attribute":
            self.cells = []

    def _root(self, tag: str, attributes: dict[str, str]) -> None:
        if tag != "model":
            raise _Forbidden(f"the file begins with <{excerpt(tag)}>, not with <model>: it is no REXS file")
        self.model = attributes
        self.problems += unread_version(attributes.get("version", ""), self.line)

    def characters(self, text: str) -> None:
        """Take text between elements."""
        self.words.append(text)

    def end(self, tag: str) -> None:
        """Take the end of an element."""
        self.stack.pop()
        attributes, line = self.opened.pop()
        said = "".join(self.words).strip()
        self.words = []
        if tag == "c":
            self.cells.append(said)
        elif tag in ("array", "matrix") and "code" in attributes:
            self._coded(said, attributes["code"], line)
        elif tag == "attribute":
            written = Attribute("" if self.cells else said, tuple(self.cells), attributes.get("unit"), line)
            self.attributes[attributes.get("id", "")] = written
        elif tag == "ref":
            number = self._number(attributes, "id", f"relations.ref[{attributes.get('role', '')}]", line)
            self.ends.append((attributes.get("role", ""), number))
        elif tag == "relation":
            self.relations.append(Relation(attributes.get("type", ""), tuple(self.ends), line))
        elif tag == "component":
            self._component(attributes, line)

    def _coded(self, text: str, code: str, line: int) -> None:
        try:
            self.cells += decoded(text, code)
        except ValueError as error:
            self.problems.append(Problem("components.attribute", str(error), line))

    def _component(self, attributes: Mapping[str, str], line: int) -> None:
        kind = attributes.get("type", "")
        number = self._number(attributes, "id", f"components.{excerpt(kind)}", line)
        component = Component(number, kind, attributes.get("name", ""), line, self.attributes)
        if self.stack[-1:] == ["load_case"]:
            self.cases[-1][number] = component
        elif self.stack[-1:] == ["components"]:
            if number in self.components:
                said = (
                    f"the id {number} stands at line {self.components[number].line}, too; every component has its own"
                )
                self.problems.append(Problem(component.path, said, line))
            self.components[number] = component

    def _number(self, attributes: Mapping[str, str], key: str, path: str, line: int) -> int:
        text = attributes.get(key, "")
        if text.isascii() and text.isdigit() and len(text) < 10:
            return int(text)
        self.problems.append(Problem(f"{path}.{key}", f"is {excerpt(text)!r}; give a whole number", line))
        return -1

    def document(self) -> Document:
        """Return everything that was read."""
        application = " ".join(filter(None, map(self.model.get, ("applicationId", "applicationVersion"))))
        return Document(
            self.model["version"], application, self.components, tuple(self.relations), tuple(self.cases),
            self.accumulations,
        )  # fmt: skip
