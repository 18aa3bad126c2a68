"""REXS files in each form (XML, JSON, archives) as records, the words of REXS, and asking them for numbers.

What the records mean for a design is not known here.
"""

import base64
import binascii
import csv
import io
import json
import math
import re
import struct
import zipfile
import zlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib.resources import files
from pathlib import Path, PurePosixPath
from typing import Any, Literal, NamedTuple
from xml.parsers import expat

from gearwright.base import Problem, excerpt, refuse
from gearwright.files import bytes_of

# ----------------------------------------------------------------------------------------------------------------------
# The words of REXS that gearwright writes and reads: attributes with their units, and what units mean in SI.
# ----------------------------------------------------------------------------------------------------------------------


Version = Literal["1.7", "1.6"]
VERSIONS: tuple[Version, ...] = ("1.7", "1.6")
"""Versions of REXS that are written, the usual one first."""
OWN = ("custom_gearwright_design", "custom_gearwright_gear", "custom_gearwright_mesh")
"""Attributes of gearwright's own, as REXS lets applications have them: the design as TOML, and the gear and the mesh
row of it that a component is."""
DESIGN, GEAR, MESH = OWN
BEARING_TYPES = {
    "deep-groove": "radial_grooved_ball_bearing",
    "cylindrical": "radial_roller_bearing",
    "taper": "radial_tapered_roller_bearing",
    "four-point": "four_point_contact_ball_bearing",
}
"""Kind of a bearing in a design -> in REXS."""
ABSORBS = {"none": "no_direction", "both": "both_directions", "first": "negative", "second": "positive"}
"""Where a bearing holds its shaft in a design -> in REXS."""


class Unit(NamedTuple):
    """A unit as REXS spells it."""

    dimension: str
    """What is measured in it."""
    factor: float
    """Of it in the unit that gearwright counts in: SI, but °C, mm²/s and HV [-]."""


_PER_MINUTE, _DEGREE, _HOUR = math.pi / 30.0, math.pi / 180.0, 3600.0
UNITS: Mapping[str, Unit] = {
    "none": Unit("number", 1.0), "": Unit("number", 1.0), "%": Unit("number", 0.01),
    "mm": Unit("length", 1e-3), "m": Unit("length", 1.0), "mum": Unit("length", 1e-6),
    "deg": Unit("angle", _DEGREE), "°": Unit("angle", _DEGREE), "rad": Unit("angle", 1.0),
    "1 / min": Unit("speed", _PER_MINUTE), "rad / s": Unit("speed", 1.0), "1 / s": Unit("speed", 2.0 * math.pi),
    "N m": Unit("torque", 1.0), "N": Unit("force", 1.0), "kN": Unit("force", 1e3),
    "kW": Unit("power", 1e3), "W": Unit("power", 1.0),
    "N / mm^2": Unit("stress", 1e6), "MPa": Unit("stress", 1e6), "Pa": Unit("stress", 1.0),
    "kg": Unit("mass", 1.0), "kg / dm^3": Unit("density", 1e3),
    "h": Unit("time", _HOUR), "s": Unit("time", 1.0),
    "C": Unit("temperature", 1.0), "mm^2 / s": Unit("viscosity", 1.0), "HV": Unit("hardness", 1.0),
}  # fmt: skip
"""Unit as files write it -> what it measures."""


class Word(NamedTuple):
    """An attribute of REXS."""

    unit: str
    """In which the database gives it."""
    kind: str
    """Such as ``floating_point``."""
    since: Version
    """First version that is written and has it."""


@cache
def words() -> Mapping[str, Word]:
    """Return attribute -> its unit and kind, of all that gearwright writes or reads."""
    text = files("gearwright.exchange.rexs").joinpath("attributes.csv").read_text(encoding="utf-8")
    rows = csv.DictReader(text.splitlines())
    return {row["attribute"]: Word(row["unit"], row["kind"], _version(row["since"])) for row in rows}


def _version(text: str) -> Version:
    return next(version for version in VERSIONS if version == text)


def spellings(dimension: str) -> list[str]:
    """Return the units in which a dimension may be written.

    Args:
        dimension: Such as ``length``.
    """
    return [name for name, unit in UNITS.items() if unit.dimension == dimension and name]


# ----------------------------------------------------------------------------------------------------------------------
# What stands in a REXS file, as records: components, their attributes, relations, load cases, with their lines.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Attribute:
    """An attribute as written."""

    text: str
    """Of a plain one; empty where it holds several."""
    cells: tuple[str, ...]
    """Of an array or a matrix, one after the other."""
    unit: str | None
    """None where none is written."""
    line: int
    """Counted from 1 [-]."""


@dataclass(frozen=True)
class Component:
    """A component, or what a load case says of it."""

    number: int
    """Its id [-]."""
    kind: str
    """Its type, such as ``shaft``."""
    name: str
    line: int
    """Counted from 1 [-]."""
    attributes: Mapping[str, Attribute] = field(default_factory=dict)

    @property
    def path(self) -> str:
        """Where it stands, for messages."""
        return f"components.{self.kind}[{self.number}]"


@dataclass(frozen=True)
class Relation:
    """What belongs together."""

    kind: str
    """Its type, such as ``assembly``."""
    ends: tuple[tuple[str, int], ...]
    """Roles, and the ids of what plays them, as written."""
    line: int
    """Counted from 1 [-]."""

    @property
    def roles(self) -> dict[str, int]:
        """Role -> id."""
        return dict(self.ends)


@dataclass(frozen=True)
class Document:
    """A REXS file."""

    version: str
    application: str
    """Name and version of what wrote it."""
    components: Mapping[int, Component]
    """By id."""
    relations: tuple[Relation, ...]
    cases: tuple[Mapping[int, Component], ...]
    """Load cases of all spectra: what each says, by the id of the component."""
    accumulations: int = 0
    """Results over whole spectra, which are not read [-]."""

    def of_kind(self, *kinds: str) -> list[Component]:
        """Return all components of some types.

        Args:
            kinds: Such as ``shaft``.
        """
        return [component for component in self.components.values() if component.kind in kinds]

    def related(self, kind: str, role: str, number: int, other: str) -> list[int]:
        """Return what stands opposite a component in all relations of a type.

        Args:
            kind: Type of the relations.
            role: That the component plays.
            number: Id of the component.
            other: Role of what is returned.
        """
        return [roles[other] for roles in self._related.get((kind, role, number), ()) if other in roles]

    @cached_property
    def _related(self) -> dict[tuple[str, str, int], list[dict[str, int]]]:
        """Type of relation, role and component -> the relations in which it plays that role."""
        found: dict[tuple[str, str, int], list[dict[str, int]]] = {}
        for relation in self.relations:
            for role, number in relation.roles.items():
                found.setdefault((relation.kind, role, number), []).append(relation.roles)
        return found


# ----------------------------------------------------------------------------------------------------------------------
# Whether the parts of a document hold together: relations name what is there, and nothing is a part of itself.
# ----------------------------------------------------------------------------------------------------------------------


_WHOLES = {"assembly": ("assembly", "part"), "ordered_assembly": ("assembly", "part")}
"""Relation -> roles of the whole and of its part."""


def unsound(document: Document) -> list[Problem]:
    """Return what of a document refers to nothing, or to itself.

    Args:
        document: As read.
    """
    return [*_missing(document), *_cycles(document)]


def _missing(document: Document) -> Iterator[Problem]:
    """Yield references to components that are not there."""
    said = "there is no component with the id"
    for relation in document.relations:
        for role, number in relation.ends:
            if number not in document.components and number >= 0:
                path = f"relations.{excerpt(relation.kind)}.{excerpt(role)}"
                yield Problem(
                    path, f"{said} {number}; refer to one that is there, or remove the relation", relation.line
                )
    for case in document.cases:
        for number, component in case.items():
            if number not in document.components:
                yield Problem(
                    f"load_spectrum.{component.path}", f"{said} {number}; refer to one that is there", component.line
                )


def _cycles(document: Document) -> Iterator[Problem]:
    """Yield what is a part of itself, once for each circle."""
    parts: dict[int, list[int]] = {}
    lines: dict[tuple[int, int], int] = {}
    for relation in document.relations:
        roles = _WHOLES.get(relation.kind)
        if roles and all(role in relation.roles for role in roles):
            whole, part = (relation.roles[role] for role in roles)
            parts.setdefault(whole, []).append(part)
            lines.setdefault((whole, part), relation.line)
    done: set[int] = set()
    for start in parts:
        trail: list[int] = []
        stack = [(start, 0)]
        while stack:
            number, depth = stack.pop()
            del trail[depth:]
            if number in trail:
                circle = [*trail[trail.index(number) :], number]
                listed = " > ".join(map(str, circle))
                said = f"the components {listed} are parts of each other in a circle; remove one of the relations"
                yield Problem("relations.assembly", said, lines[circle[-2], number])
                continue
            if number in done:
                continue
            done.add(number)
            trail.append(number)
            stack += [(part, depth + 1) for part in parts.get(number, ())]


# ----------------------------------------------------------------------------------------------------------------------
# Arrays that a REXS file holds as base64, number by number.
# ----------------------------------------------------------------------------------------------------------------------


CODES = {"int32": "i", "float32": "f", "float64": "d"}
"""How an array is coded -> a number of it, as `struct` has it; the least byte comes first."""


def decoded(text: str, code: str) -> tuple[str, ...]:
    """Return the numbers of a coded array, as texts.

    Args:
        text: In base64.
        code: Of its numbers, a key of `CODES`.

    Raises:
        ValueError: If there is no such code, or the text is no base64 of whole numbers of it.

    Source: REXS API, FVA GmbH, Base64Utils: the least byte first.

    >>> decoded("AAAAAAAA+D8=", "float64")
    ('1.5',)
    """
    if code not in CODES:
        raise ValueError(f"the code is {code!r}; allowed: {', '.join(CODES)}")
    try:
        numbers = struct.iter_unpack(f"<{CODES[code]}", base64.b64decode(text, validate=True))
        return tuple(repr(number) for (number,) in numbers)
    except (binascii.Error, struct.error):
        raise ValueError(f"its array is no base64 of {code}") from None


# ----------------------------------------------------------------------------------------------------------------------
# XML as a REXS document: no document types, no entities, nothing from elsewhere, every problem with its line.
# ----------------------------------------------------------------------------------------------------------------------


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
    reading = _ReadingXml()
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
class _ReadingXml:
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


# ----------------------------------------------------------------------------------------------------------------------
# JSON as a REXS document: the same records as of XML, every problem with its line.
# ----------------------------------------------------------------------------------------------------------------------


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
    reading = _ReadingJson()
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
class _ReadingJson:
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


# ----------------------------------------------------------------------------------------------------------------------
# A REXS file in any of its forms: XML (.rexs), JSON (.rexsj), and either of them in an archive (.rexsz).
# ----------------------------------------------------------------------------------------------------------------------


LARGEST = 10_000_000
"""Largest REXS file that is read, unpacked [bytes]; a wind turbine's gearbox with all results has 0.9 MB."""
FORMS = (".rexs", ".rexsj")
"""How the names of models end, in archives, too."""
_ARCHIVE, _BOM = b"PK\x03\x04", "\ufeff"


def opened(path: str | Path) -> Document:
    """Return what a REXS file says, whatever its name ends with.

    Args:
        path: Of the file.

    Raises:
        DesignError: If it is no REXS file, damaged, too large, or of a version that is not read.
    """
    source, content = str(path), bytes_of(path, largest=LARGEST)
    if content.startswith(_ARCHIVE):
        content = _unpacked(content, source)
    try:
        text = content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError:
        refuse([Problem("", "this is not a text file in UTF-8; export it again")], source)
    plain = text.lstrip(f"{_BOM} \n\r\t")
    return document_of_json(plain, source) if plain.startswith(("{", "[")) else document_of(plain, source)


def _unpacked(content: bytes, source: str) -> bytes:
    """Return the one model of an archive; nothing is written anywhere, and no more than the limit unpacked."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            names = [entry.filename for entry in archive.infolist() if _is_model(entry.filename)]
            if len(names) != 1:
                held = ", ".join(excerpt(name) for name in names[:3]) or "none"
                refuse([Problem("", f"the archive must hold one .rexs or .rexsj; it holds {held}")], source)
            with archive.open(names[0]) as file:
                unpacked = file.read(LARGEST + 1)
    except (
        zipfile.BadZipFile,
        zlib.error,
        EOFError,
        NotImplementedError,
        RuntimeError,
    ) as error:  # locked: RuntimeError
        refuse([Problem("", f"the archive cannot be unpacked: {excerpt(str(error))}; pack it again")], source)
    if len(unpacked) > LARGEST:
        refuse([Problem("", f"the model in it has more than {LARGEST:,} bytes, the most that is read")], source)
    return unpacked


def _is_model(name: str) -> bool:
    path = PurePosixPath(name)
    return path.suffix.lower() in FORMS and not path.name.startswith("._")  # which is what macOS packs beside files


# ----------------------------------------------------------------------------------------------------------------------
# Asking a document for numbers and texts: units are held against REXS, and what nobody asked for is listed.
# ----------------------------------------------------------------------------------------------------------------------


FORMER = {
    "radial_dynamic_load_rating": ("dynamic_capacity",),
    "operating_time_fraction": ("load_duration_fraction",),
    "application_factor_iso_6336_2019": ("application_factor_iso_6336_2006",),
    "mesh_load_factor_iso_6336_2019": ("mesh_load_factor_iso_6336_2006",),
    "allowable_stress_number_contact_iso_6336_2016": ("endurance_limit_flank",),
    "nominal_stress_number_tooth_root_iso_6336_2016": ("endurance_limit_root",),
    "catalogue_designation": ("name",),
    "radial_static_load_rating": ("static_capacity",),
}
"""Attribute -> names that it had in former versions, or that others write for it."""
GEOMETRY = {"reference_component_for_position", "w_axis_vector"}
"""Attributes that say where a component stands, which other attributes say, too."""


@dataclass
class Asking:
    """A document, what of it was read, and what is wrong with it."""

    document: Document
    problems: list[Problem] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    """What was assumed."""
    asked: set[int] = field(default_factory=set)
    """Identities of the attributes that were read."""
    used: set[int] = field(default_factory=set)
    """Ids of the components that were understood."""

    def number(self, component: Component, name: str) -> float | None:
        """Return a number in SI, or None where it is not written.

        Args:
            component: That has it, or what a load case says of it.
            name: Of the attribute.
        """
        found = self.attribute(component, name)
        if found is None or (not found.text and not found.cells):
            return None
        factor = self._factor(component, name, found)
        return None if factor is None else self._parsed(component, name, found, found.text, factor)

    def needed(self, component: Component, name: str) -> float:
        """Return a number in SI; where it is missing that is a problem, and 1 stands for it.

        Args:
            component: That must have it.
            name: Of the attribute.
        """
        known = len(self.problems)
        value = self.number(component, name)
        if value is None:
            if len(self.problems) == known:
                said = f"is missing; give it in {words()[name].unit}"
                self.problems.append(Problem(f"{component.path}.{name}", said, component.line))
            return 1.0
        return value

    def vector(self, component: Component, name: str) -> tuple[float, ...] | None:
        """Return numbers in SI, or None where they are not written.

        Args:
            component: That has them.
            name: Of the attribute.
        """
        found = self.attribute(component, name)
        factor = None if found is None else self._factor(component, name, found)
        if found is None or factor is None:
            return None
        numbers = [self._parsed(component, name, found, cell, factor) for cell in found.cells]
        return tuple(number for number in numbers if number is not None)

    def text(self, component: Component, name: str) -> str:
        """Return a text, empty where it is not written; of an array its first entry.

        Args:
            component: That has it.
            name: Of the attribute.
        """
        found = self.attribute(component, name)
        return "" if found is None else found.text or next(iter(found.cells), "")

    def attribute(self, component: Component, name: str) -> Attribute | None:
        """Return an attribute by its name or a former one, and count it as read.

        Args:
            component: That may have it.
            name: Of the attribute.
        """
        for spelling in (name, *FORMER.get(name, ())):
            if spelling in component.attributes:
                found = component.attributes[spelling]
                self.asked.add(id(found))
                return found
        return None

    def _factor(self, component: Component, name: str, found: Attribute) -> float | None:
        """Return what a unit is in SI; None where it is missing or measures something else."""
        wanted = UNITS[words()[name].unit].dimension
        if wanted == "number" and (found.unit or "") in ("", "none"):
            return 1.0
        unit = UNITS.get(found.unit or "")
        if unit is not None and unit.dimension == wanted and found.unit:
            return unit.factor
        said = f"is in {excerpt(found.unit)!r}" if found.unit else "has no unit"
        allowed = " or ".join(spellings(wanted)) if wanted != "number" else "none or %"
        self.problems.append(Problem(f"{component.path}.{name}", f"{said}; allowed: {allowed}", found.line))
        return None

    def _parsed(self, component: Component, name: str, found: Attribute, text: str, factor: float) -> float | None:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if math.isfinite(value):
            return value * factor
        said = f"is {excerpt(text)!r}; give a number"
        self.problems.append(Problem(f"{component.path}.{name}", said, found.line))
        return None

    def refuse(self, component: Component, said: str) -> None:
        """Note that a component cannot be read.

        Args:
            component: What is wrong.
            said: Why, and what to do.
        """
        self.problems.append(Problem(component.path, said, component.line))

    def unread(self) -> tuple[str, ...]:
        """Return every kind of attribute and component that nobody asked for, with its first place and its count."""
        places: dict[str, list[tuple[str, int]]] = {}
        spoken = [*self.document.components.values(), *(said for case in self.document.cases for said in case.values())]
        for component in spoken:
            if component.number not in self.used:
                places.setdefault(component.kind, []).append((component.path, component.line))
                continue
            for name, attribute in component.attributes.items():
                if id(attribute) not in self.asked and name not in GEOMETRY:
                    key = f"{component.kind}.{name}"
                    places.setdefault(key, []).append((f"{component.path}.{name}", attribute.line))
        return tuple(_listed(found) for found in places.values())


def _listed(places: Iterable[tuple[str, int]]) -> str:
    (path, line), *others = places
    return f"line {line}: {path}" + (f" and {len(others)} more of its kind" if others else "")
