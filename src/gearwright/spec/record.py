"""Records with units in their keys and values in SI, unknown keys, and aliases of earlier versions."""

from __future__ import annotations

import math
import reprlib
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from types import MappingProxyType, UnionType
from typing import Annotated, Any, ClassVar, NamedTuple, Union, get_args, get_origin

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ValidationError,
    ValidationInfo,
    field_validator,
)
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from gearwright.base import SUFFIXES, Problem, Quantity, Reciprocal, excerpt, near, suffix_unit

# ----------------------------------------------------------------------------------------------------------------------
# What a number, a text or a list in a file may be: bounds of each kind of quantity, which fields narrow.
#
# Bounds are generous: they keep out what no machine has (a diameter of 1e-300 m, a power of 1e300 W), where formulas
# give zeros, infinities and numbers that are none. What is sensible for one field stands with the field.
# ----------------------------------------------------------------------------------------------------------------------


SIZES: Mapping[str, tuple[float, float, float]] = MappingProxyType({
    "angle": (1e-9, 1e-6, 1e2),
    "area": (1e-9, 1e-6, 1e6),
    "density": (1e-3, 1.0, 1e5),
    "energy": (1e-3, 1.0, 1e13),
    "force": (1e-6, 1.0, 1e9),
    "frequency": (1e-6, 1e-3, 1e9),
    "inertia": (1e-12, 1e-9, 1e9),
    "length": (1e-9, 1e-4, 3e2),
    "life": (1e-3, 1.0, 1e11),
    "mass": (1e-9, 1e-3, 1e6),
    "power": (1e-3, 1e-1, 1e9),
    "slope": (1e-9, 1e-6, 1e2),
    "speed": (1e-6, 1e-6, 2e4),
    "stiffness": (1e-3, 1e3, 1e13),
    "stress": (1.0, 1e4, 1e11),
    "time": (1e-9, 1e-6, 1e11),
    "torque": (1e-6, 1e-3, 1e9),
    "torsional_damping": (1e-9, 1e-6, 1e9),
    "torsional_stiffness": (1e-3, 1e-2, 1e13),
    "velocity": (1e-6, 1e-6, 1e3),
    "volume": (1e-12, 1e-9, 1e6),
    "ratio": (1e-9, 1e-6, 1e3),
})  # fmt: skip
"""Dimension -> smallest size of what is not 0, smallest of what must be greater than 0, largest size [SI]."""
ANY_SIZE = (1e-15, 1e-15, 1e15)
"""The same of a number without a dimension [-]."""
MOST_ENTRIES = 1_000
"""Entries of a table or list, but for lists of numbers [-]."""
MOST_NUMBERS = 100_000
"""Numbers of a list [-]."""
LONGEST_NAME, LONGEST_LINE = 60, 140
"""Characters of a name, and of a text such as one that refers to two names [-]."""
_FILE = 4096
_LONGEST = {
    "description": 10_000, "name": 200, "origins": 500, "source": 500, "sources": 500,
    "estimated": 500, "waivers": 500,
    "file": _FILE, "propeller_map": _FILE, "mission": _FILE, "changes": _FILE, "values": _FILE, "deck": _FILE,
}  # fmt: skip
"""Characters of other texts, by their field [-]."""
NAME_RULE = (
    f"cannot be a name: use up to {LONGEST_NAME} letters, digits, hyphens, underscores or single spaces, a letter or"
    " digit first and last"
)


@dataclass(frozen=True)
class Range:
    """Numbers that a field takes, in SI."""

    minimum: float
    maximum: float
    above: bool = False
    """True: `minimum` itself is not taken."""
    below: bool = False
    """True: `maximum` itself is not taken."""
    smallest: float = 0.0
    """What is not 0 is no nearer to it than this."""

    def holds(self, value: float) -> bool:
        """Tell whether a number is taken.

        Args:
            value: In SI.
        """
        low = value > self.minimum if self.above else value >= self.minimum
        high = value < self.maximum if self.below else value <= self.maximum
        return low and high and (value == 0.0 or abs(value) >= self.smallest)

    def over(self, scale: float) -> Range:
        """Return the numbers that are taken of what a quantity is the reciprocal of.

        Args:
            scale: Over the one is the other.

        >>> Range(1e-6, 0.0254).over(0.0254)
        Range(minimum=1.0, maximum=25400.0, above=False, below=False, smallest=0.0)
        """
        low, high = (scale / bound if bound > 0.0 else math.inf for bound in (self.maximum, self.minimum))
        return Range(low, high, above=self.below, below=self.above)

    def words(self, factor: float = 1.0, unit: str = "") -> str:
        """Return the numbers that are taken, as a message says it.

        Args:
            factor: SI value of the unit.
            unit: As users write it.

        >>> Range(0.0, 0.1, smallest=1e-6).words(1e-3, "mm")
        '0 or a value from 0.001 to 100 mm'
        >>> Range(-0.6, 0.3, smallest=1e-9).words()
        'a value from -0.6 to 0.3, 0 or at least 1e-09 in size'
        """
        minimum, maximum, smallest = (f"{bound / factor:.6g}" for bound in (self.minimum, self.maximum, self.smallest))
        end = f" {unit}" if unit else ""
        if self.minimum <= 0.0 <= self.maximum and self.smallest and not self.above:
            if self.minimum == 0.0:
                return f"0 or a value from {smallest} to {maximum}{end}"
            return f"a value from {minimum} to {maximum}{end}, 0 or at least {smallest}{end} in size"
        if not self.above and not self.below:
            return f"a value from {minimum} to {maximum}{end}"
        low, high = "above" if self.above else "from", "below" if self.below else "up to"
        return f"a value {low} {minimum} and {high} {maximum}{end}"


def quantity_of(info: FieldInfo) -> Quantity | None:
    """Return the quantity with a unit that marks a field, if any.

    Args:
        info: Field of a record.
    """
    mark = _mark(info)
    return mark if mark is not None and mark.dimension in SUFFIXES else None


def reciprocals_of(info: FieldInfo) -> tuple[Reciprocal, ...]:
    """Return the names under which a quantity may be written as its reciprocal.

    Args:
        info: Field of a record.
    """
    return tuple(mark for mark in info.metadata if isinstance(mark, Reciprocal))


def range_of(info: FieldInfo) -> Range:
    """Return the numbers that a field takes: its own bounds, or those of its kind where it has none.

    Args:
        info: Field of a record.
    """
    mark = _mark(info)
    smallest, positive, largest = ANY_SIZE if mark is None else SIZES.get(mark.dimension, ANY_SIZE)
    bounds = {name: float(bound) for name in ("ge", "gt", "le", "lt") for bound in _bounds(info, name)}
    minimum, maximum = bounds.get("gt", bounds.get("ge", -largest)), bounds.get("lt", bounds.get("le", largest))
    if bounds.get("gt") == 0.0:  # what is greater than 0 has a size
        return Range(min(positive, maximum), maximum, below="lt" in bounds)
    return Range(minimum, maximum, above="gt" in bounds, below="lt" in bounds, smallest=smallest)


class FieldRange(NamedTuple):
    """What a field takes, looked up once for every field of a record."""

    numbers: Range
    unit: str
    """Its SI unit; empty for what has none."""


@cache
def allowed_in(model: type[BaseModel], name: str) -> FieldRange:
    """Return what a field of a record takes.

    Args:
        model: The record's type.
        name: Of the field.
    """
    info = model.model_fields[name]
    mark = quantity_of(info)
    suffix = mark and next(suffix for suffix, factor in SUFFIXES[mark.dimension].items() if factor == 1.0)
    return FieldRange(range_of(info), suffix_unit(suffix) if suffix else "")


def checked(value: Any, allowed: FieldRange, name: str) -> Any:
    """Return a value of a field as it is.

    Args:
        value: In SI.
        allowed: What the field takes.
        name: Of the field.

    Raises:
        PydanticCustomError: If it is beyond what a file may hold.
    """
    if isinstance(value, int | float) and not isinstance(value, bool):
        _refuse_beyond(value, allowed)
    elif isinstance(value, str):
        _refuse_text(value, _LONGEST.get(name, LONGEST_LINE), lines=name == "description")
    elif isinstance(value, list | dict):
        _refuse_many(value, name)
    return value


def is_name(name: str) -> bool:
    """Tell whether a text is a name, from which paths, files, figures and tables can be made.

    Args:
        name: As written.

    >>> is_name("gas-turbine 1"), is_name("a/b"), is_name("-x"), is_name("$x$")
    (True, False, False, False)
    """
    plain = name.replace("-", "x").replace("_", "x").replace(" ", "x")
    ends = name[:1].isalnum() and name[-1:].isalnum()
    return ends and plain.isalnum() and "  " not in name and len(name) <= LONGEST_NAME


def is_path(path: str) -> bool:
    """Tell whether a text is a name, or names joined by dots, as `first.pinion` is.

    Args:
        path: As written.
    """
    return all(map(is_name, path.split(".")))


def a_name(name: str) -> str:
    """Return a name as it is.

    Args:
        name: As written.

    Raises:
        PydanticCustomError: If it is none.
    """
    if not is_name(name):
        raise PydanticCustomError("name", "{rule}", {"rule": NAME_RULE, "shown": excerpt(name)})
    return name


Name = Annotated[str, AfterValidator(a_name)]
"""Type of what is called by a name."""


@dataclass(frozen=True, eq=False)
class OneOf:
    """Marks a text that is a key of a table, as a ``Literal`` would with the keys written once more."""

    table: Mapping[str, object]
    """What may be named."""
    words: str = ""
    """What it is, of a table too long to be listed."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Refuse what the table does not have."""
        return core_schema.no_info_after_validator_function(self._of_table, handler(source))

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """Return what JSON Schema says of it."""
        return {**handler(core), "enum": list(self.table)}

    def _of_table(self, name: str) -> str:
        if name not in self.table:
            *first, last = map(repr, self.table)
            expected = self.words or f"{', '.join(first)} or {last}"
            raise PydanticCustomError("literal_error", "Input should be {expected}", {"expected": expected})
        return name


def _refuse_beyond(value: float, allowed: FieldRange) -> None:
    if not allowed.numbers.holds(value):
        raise PydanticCustomError("beyond", "give {words}", {"words": allowed.numbers.words(1.0, allowed.unit)})


def _refuse_text(text: str, longest: int, *, lines: bool) -> None:
    if len(text) > longest:
        raise PydanticCustomError("long", "give at most {longest} characters", {"longest": longest})
    if not (text.replace("\n", "").replace("\t", "") if lines else text).isprintable():
        raise PydanticCustomError("control", "control characters have no place in it; leave them out")


def _refuse_many(entries: list[Any] | dict[str, Any], name: str) -> None:
    """Check the entries of a list or table, but for records, which check themselves."""
    inner = list(entries.values()) if isinstance(entries, dict) else entries
    numbers = all(isinstance(entry, int | float) for entry in inner)
    maximum = MOST_NUMBERS if numbers else MOST_ENTRIES
    if len(inner) > maximum:
        raise PydanticCustomError(
            "many", "{count} entries; give at most {maximum}", {"count": len(inner), "maximum": maximum}
        )
    for entry in inner:
        checked(entry, _PLAIN, name)


def _mark(info: FieldInfo) -> Quantity | None:
    marks = [*info.metadata, *(mark for part in parts(info.annotation) for mark in getattr(part, "__metadata__", ()))]
    return next((mark for mark in marks if isinstance(mark, Quantity)), None)


def parts(annotation: Any) -> Iterator[Any]:
    """Yield the parts of a union, or the annotation itself.

    Args:
        annotation: Of a field.
    """
    if get_origin(annotation) in (Union, UnionType):
        yield from get_args(annotation)
    else:
        yield annotation


def _bounds(info: FieldInfo, name: str) -> Iterator[float]:
    return (bound for mark in info.metadata if (bound := getattr(mark, name, None)) is not None)


_PLAIN = FieldRange(range_of(FieldInfo()), "")


# ----------------------------------------------------------------------------------------------------------------------
# Words of earlier versions, and what is written now: they are still read, each with a sentence that says so.
# ----------------------------------------------------------------------------------------------------------------------


FORMER: Mapping[str, str] = MappingProxyType({
    "least": "minimum", "most": "maximum", "least_charge": "minimum_charge",
    "fly.least_charge": "fly.minimum_charge", "mission.battery.least_charge": "mission.battery.minimum_charge",
})  # fmt: skip
"""Key, value or dotted path of an earlier version -> what is written now."""


class FormerWord(FutureWarning):
    """A file says something in a word of an earlier version."""


def today(word: str, place: str = "") -> str:
    """Return what is written now for a word, and say it where that is another one.

    Args:
        word: Key, value or dotted path.
        place: Where it stands, for the sentence.

    >>> today("minimum")
    'minimum'
    """
    now = FORMER.get(word, word)
    if now != word:
        at = f"{place}: " if place else ""
        warnings.warn(f"{at}{word!r} is a word of an earlier version; write {now!r}", FormerWord, stacklevel=2)
    return now


# ----------------------------------------------------------------------------------------------------------------------
# Keys of a table, with the units in which a quantity may be written, and what to do about a key that is none.
# ----------------------------------------------------------------------------------------------------------------------


class Key(NamedTuple):
    """What a key of a table stands for."""

    field: str
    """Name in the record."""
    factor: float
    """To SI [-]."""
    suffix: str
    """Of the unit; empty for what has none."""
    inverse: bool = False
    """True where the quantity is the factor over what is written, as a module over its diametral pitch."""

    def si(self, value: float) -> float:
        """Return what is written in SI; what no reciprocal has, 0 and below, as it is.

        Args:
            value: As written.
        """
        if self.inverse:
            return self.factor / value if value > 0.0 else value
        return value * self.factor

    def written(self, value: float) -> float:
        """Return a value as it would be written.

        Args:
            value: In SI.
        """
        return self.factor / value if self.inverse else value / self.factor

    def words(self, allowed: Range) -> str:
        """Return the numbers that a field takes, in the unit of this key.

        Args:
            allowed: In SI.
        """
        symbol = suffix_unit(self.suffix) if self.suffix else ""
        return allowed.over(self.factor).words(1.0, symbol) if self.inverse else allowed.words(self.factor, symbol)


Keys = Mapping[str, Key]


@cache
def keys_of(model: type[BaseModel]) -> Keys:
    """Return the keys that a table of this record may have.

    Args:
        model: The record's type.

    Returns:
        As written -> what it stands for.
    """
    keys: dict[str, Key] = {}
    for name, info in model.model_fields.items():
        quantity = quantity_of(info)
        if quantity is None:
            keys[info.alias or name] = Key(info.alias or name, 1.0, "")
            continue
        for suffix, factor in SUFFIXES[quantity.dimension].items():
            keys[f"{name}_{suffix}"] = Key(name, factor, suffix)
        for mark in reciprocals_of(info):
            keys[mark.key] = Key(name, mark.scale, mark.suffix, inverse=True)
    return MappingProxyType(keys)


def longer_keys(key: str, keys: Keys) -> str:
    """Return which keys a word may mean that they end with; empty where none does.

    Args:
        key: As written.
        keys: Of the table.
    """
    longer = [name for name in keys if name.endswith(f"_{key}")]
    return f"write {' or '.join(longer)}" if longer else ""


def unknown_key(key: str, model: type[BaseModel]) -> str:
    """Return what to do about a key that a table does not have.

    Args:
        key: As written.
        model: The record's type.
    """
    keys = keys_of(model)
    if key in model.model_fields and quantity_of(model.model_fields[key]) is not None:
        units = ", ".join(sorted(name for name in keys if name.startswith(f"{key}_")))
        return f"the unit is missing; write one of {units}"
    lower = {name.lower(): name for name in keys}
    if key.lower() in lower:
        return f"no such field; did you mean {lower[key.lower()]}?"
    foreign = _foreign(key, model, keys)
    if foreign:
        return foreign
    if longer := longer_keys(key, keys):
        return f"no such field; {longer}"
    usual = {meant.field: name for name, meant in reversed(list(keys.items()))}
    return f"no such field; {near(key, keys, usual.values())}"


_FOREIGN: Mapping[str, str] = MappingProxyType({
    "ps": "1 PS (metric horsepower) = 0.7355 kW", "cv": "1 CV (metric horsepower) = 0.7355 kW", "cm": "1 cm = 10 mm",
    "bar": "1 bar = 0.1 MPa", "ksi": "1 ksi = 6.895 MPa", "kgf": "1 kgf = 9.807 N", "dan": "1 daN = 10 N",
    "kgfm": "1 kgf m = 9.807 N m", "mph": "1 mph = 1.609 km/h", "rps": "1 rps = 60 rpm",
})  # fmt: skip
"""Suffix of a unit that no key has -> what it is in one that keys have."""


def _foreign(key: str, model: type[BaseModel], keys: Keys) -> str:
    """Return what to do about a unit that is known to people alone; empty where the key is no such quantity."""
    name, _, suffix = key.rpartition("_")
    info = model.model_fields.get(name)
    if suffix.lower() not in _FOREIGN or info is None or quantity_of(info) is None:
        return ""
    units = ", ".join(written for written, meant in keys.items() if meant.field == name)
    return f"this unit is not known: {_FOREIGN[suffix.lower()]}; write one of {units}"


# ----------------------------------------------------------------------------------------------------------------------
# Frozen records whose physical fields are written with the unit in the key and kept in SI.
#
# `convert` turns a raw table (``{"power_kw": 1046}``) into what the record takes (``{"power": 1046000.0}``) and
# collects every problem on the way; the record's own types then check what is left. Both speak of the keys that the
# user wrote.
# ----------------------------------------------------------------------------------------------------------------------


class Record(BaseModel):
    """What all records of a file share: frozen, and no field that is not declared."""

    model_config: ClassVar[ConfigDict] = ConfigDict(
        frozen=True, extra="forbid", strict=True, allow_inf_nan=False, defer_build=True
    )
    others: ClassVar[type[Record] | None] = None
    """Type of the tables that stand under names of the user's beside the declared keys, if there may be any."""

    @field_validator("*")
    @classmethod
    def _sensible(cls, value: Any, info: ValidationInfo) -> Any:
        """Refuse what no file may hold: numbers that no machine has, texts and lists without end."""
        name = info.field_name or ""
        return checked(value, allowed_in(cls, name), name)


Location = tuple[str, ...]


STAND_INS = (1.0, 1.25)
"""Quantities that most fields allow [SI]."""


@dataclass
class Written:
    """What the user wrote, by the place of the field in the record."""

    keys: dict[Location, str] = field(default_factory=dict)
    """Location of the field -> dotted path as written."""
    values: dict[Location, object] = field(default_factory=dict)
    """Location of the field -> value as written."""
    units: dict[Location, Key] = field(default_factory=dict)
    """Location of a quantity -> the key by which it is written."""
    fields: dict[Location, FieldInfo] = field(default_factory=dict)
    """Location of the field -> what it takes."""
    problems: list[Problem] = field(default_factory=list)
    """What was found so far."""
    incomplete: bool = False
    """True where a whole table is unreadable or misnamed: what refers to it is no mistake of its own."""
    stand_in: float = STAND_INS[0]
    """What stands for a faulty or missing quantity, where its field allows it [SI]."""

    def note(self, location: Location, path: str, value: object, *, model: type[Record], unit: Key) -> None:
        """Note what is written at a location, whose last part is a field of the model."""
        self.keys[location], self.values[location] = path, value
        self.fields[location] = _field(model, location[-1])
        if unit.suffix:
            self.units[location] = unit

    def report(self, location: Location, message: str) -> None:
        """Add a problem at a location."""
        self.problems.append(Problem(self.keys.get(location, ".".join(location)), message))


def convert(raw: Mapping[str, object], model: type[Record], written: Written, at: Location = ()) -> dict[str, object]:
    """Return a table in the record's own field names and SI, noting every problem.

    Args:
        raw: As parsed from the file.
        model: The record's type.
        written: Collects keys, values and problems.
        at: Location of the table.
    """
    keys = keys_of(model)
    result: dict[str, object] = {}
    prefix, before = written.keys.get(at, ""), len(written.problems)
    for key, value in raw.items():
        path = f"{prefix}.{key}" if prefix else key or '""'
        if key not in keys and FORMER.get(key) in keys:
            key = today(key, path)
        if key not in keys and model.others is not None and isinstance(value, Mapping):
            written.keys[(*at, key)] = path
            if _is_named(key, written, (*at, key)):
                result[key] = convert(value, model.others, written, (*at, key))
            continue
        if key not in keys:
            written.problems.append(Problem(path, unknown_key(key, model)))
            written.incomplete |= isinstance(value, Mapping)
            continue
        meant = keys[key]
        name, location = meant.field, (*at, meant.field)
        if name in result:
            written.problems.append(
                Problem(path, f"{name} is given twice; keep one of {written.keys[location]} and {path}")
            )
            continue
        written.note(location, path, value, model=model, unit=meant)
        if meant.suffix:
            result[name] = _number(value, meant, written, location)
        else:
            result[name] = _nested(value, _field(model, name).annotation, written, location)
    _require(model, keys, result, written, prefix, before)
    return result


def _require(model: type[Record], keys: Keys, result: dict[str, object],
             written: Written, prefix: str, before: int) -> None:  # fmt: skip
    """Note every required field that the table lacks; ``before`` problems are of other tables."""
    for name, info in model.model_fields.items():
        if info.is_required() and (info.alias or name) not in result:
            options = [key for key, meant in keys.items() if meant.field in (name, info.alias)]
            path = f"{prefix}.{options[0]}" if prefix else options[0]
            if info.annotation is float:
                result[name] = _stand_in_of(info, written.stand_in)
            start = f"{prefix}.{name}" if prefix else name
            misspelt = tuple(f"did you mean {option}?" for option in options)
            if not any(
                problem.path.lower().startswith(start.lower())
                or (problem.path.startswith(prefix) and problem.message.endswith(misspelt))
                for problem in written.problems[before:]
            ):
                example = _EXAMPLES.get(str(info.annotation), "")
                written.problems.append(Problem(path, f"is required; write {' or '.join(options)}{example}"))


_EXAMPLES = {str(str): ' = "…", a text in quotes', str(int): " = 3, a whole number"}
"""Annotation of a required field -> what is written behind its key."""


@cache
def _field(model: type[Record], key: str) -> FieldInfo:
    return next(info for name, info in model.model_fields.items() if key in (name, info.alias))


def _number(value: object, meant: Key, written: Written, location: Location) -> object:
    if isinstance(value, bool) or not isinstance(value, int | float):
        written.report(location, f"{brief(value)} is not a number; give a number in {suffix_unit(meant.suffix)}")
        return _stand_in_of(written.fields[location], written.stand_in)
    try:
        converted = meant.si(float(value))
    except OverflowError:
        converted = math.inf
    if not math.isfinite(converted):
        written.report(
            location, f"{brief(value)} is not a finite number; give a finite number in {suffix_unit(meant.suffix)}"
        )
        return _stand_in_of(written.fields[location], written.stand_in)
    return converted


_BRIEF = reprlib.Repr()
_BRIEF.maxstring = _BRIEF.maxother = 60


def brief(value: object) -> str:
    """Return a value as written, cut where it is long or deep.

    Args:
        value: Of an entry.
    """
    try:
        return _BRIEF.repr(value)
    except ValueError:  # Python refuses to print whole numbers of thousands of digits
        return "a number of thousands of digits"


def _nested(value: object, annotation: Any, written: Written, location: Location) -> object:
    """Convert a record, or a table of records (of any depth), inside a table."""
    for part in parts(annotation):
        if isinstance(part, type) and issubclass(part, Record):
            if isinstance(value, Mapping):
                return convert(value, part, written, location)
            written.report(
                location, f"{brief(value)} is not a table; write [{written.keys[location]}] and its fields below"
            )
            written.incomplete = True
            return None
        if get_origin(part) is dict and _holds_records(get_args(part)[1]):
            return _table(value, get_args(part)[1], written, location)
        if get_origin(part) is dict and isinstance(value, Mapping):
            return _flat(value, written, location)
    return value


def _flat(value: Mapping[str, object], written: Written, location: Location) -> dict[str, object]:
    """Return a table of plain values by dotted path: a path may stand in quotes or be written as TOML's dotted keys."""
    flat: dict[str, object] = {}
    waiting = list(value.items())
    while waiting:
        path, inner = waiting.pop(0)
        if isinstance(inner, Mapping):
            waiting += [(f"{path}.{key}", content) for key, content in inner.items()]
            continue
        place = (*location, path)
        if not is_path(path):
            written.keys[place] = f"{written.keys[location]}.{path}"
            written.report(place, f"{brief(path)} {NAME_RULE}")
            continue
        if path in flat:
            written.report(place, "is given twice; keep one")
        flat[path], written.values[place] = inner, inner
        written.keys[place] = f"{written.keys[location]}.{path}"
    return flat


def _holds_records(annotation: Any) -> bool:
    if get_origin(annotation) is dict:
        return _holds_records(get_args(annotation)[1])
    return isinstance(annotation, type) and issubclass(annotation, Record)


def _table(value: object, annotation: Any, written: Written, location: Location) -> object:
    path = written.keys[location]
    if not isinstance(value, Mapping):
        written.report(location, f"{brief(value)} is not a table; write [{path}.NAME] and its fields below")
        written.incomplete = True
        return None
    rows: dict[str, object] = {}
    for name, row in value.items():
        inner = (*location, name)
        written.keys[inner] = f"{path}.{name}"
        if _is_named(name, written, inner):
            rows[name] = _nested(row, annotation, written, inner)
    return rows


def _is_named(name: str, written: Written, location: Location) -> bool:
    """Tell whether a text can be a name, of an axis of a study several paths, and note it where it cannot."""
    paths = [path.strip() for path in name.split(",")] if location[:-1] == ("axes",) else [name]
    good = all(map(is_path, paths))
    if not good:
        written.report(location, f"{brief(name)} {NAME_RULE}")
    return good


def build(
    model: type[Record], raw: Mapping[str, object], *, stand_in: float = STAND_INS[0]
) -> tuple[Record | None, Written]:
    """Return the record with everything that is wrong with the table.

    Where the table has problems, the record holds stand-ins in their place, so that what else is wrong can still be
    looked for; it is None where not even that can be had, or where whole tables are missing from it.

    Args:
        model: The record's type.
        raw: As parsed from the file.
        stand_in: What stands for a faulty or missing quantity; what is wrong with one of `STAND_INS` alone is no
            mistake of the user's [SI].
    """
    written = Written(stand_in=stand_in)
    table = convert(raw, model, written)
    try:
        record = model.model_validate(table)
        return (None if written.incomplete else record), written
    except ValidationError as error:
        faults = error.errors(include_url=False)
    for details in faults:
        _add(written, details)
        _stand_in(table, details["loc"], written)
    if written.incomplete:
        return None, written
    try:
        return model.model_validate(table), written
    except ValidationError:
        return None, written


def _stand_in_of(info: FieldInfo, wanted: float) -> float:
    """Return a quantity that a field allows; it never leaves the search for problems."""
    allowed = range_of(info)
    if allowed.holds(wanted):
        return wanted
    share = 0.5 / wanted
    return share * allowed.minimum + (1.0 - share) * allowed.maximum


def _stand_in(entries: dict[str, Any], location: tuple[int | str, ...], written: Written) -> None:
    """Take the faulty entry out of a table, or put a stand-in where a quantity is required."""
    info = written.fields.get(tuple(str(part) for part in location))
    for part in location[:-1]:
        inner = entries.get(str(part))
        if not isinstance(inner, dict):
            break
        entries, location = inner, location[1:]
    key = str(location[0])
    value = entries.pop(key, None)
    if isinstance(value, float) or (info is not None and info.annotation is float):
        entries[key] = written.stand_in if info is None else _stand_in_of(info, written.stand_in)


def _add(written: Written, details: Any) -> None:
    """Add what pydantic found, in the user's own key and unit, unless the place is reported already."""
    location = tuple(str(part) for part in details["loc"])
    while location and location not in written.keys:
        location = location[:-1]
    if details["type"] == "missing":
        return  # `convert` has named it with its keys
    path, message = written.keys.get(location, ""), message_of(details, written, location)
    if not any(problem.path == path for problem in written.problems):
        written.problems.append(Problem(path, message))


_BOUNDS = ("beyond", "greater_than", "greater_than_equal", "less_than", "less_than_equal")
_WANTED = {"bool_type": "true or false", "dict_type": "a table", "finite_number": "a finite number",
           "float_type": "a number", "int_type": "a whole number", "list_type": 'a list such as ["one", "two"]',
           "string_type": "a text in quotes", "too_short": "at least one"}  # fmt: skip


def message_of(details: Any, written: Written, location: Location) -> str:
    """Return what is wrong with a value, what is allowed and its unit.

    Args:
        details: As pydantic found it.
        written: With what is known of the place.
        location: Of the value, or of the table that holds it.
    """
    inside = len(location) < len(details["loc"])
    shown = brief(details["input"] if inside else written.values.get(location, details["input"]))
    if details["type"] == "name":
        return f"{shown} {details['msg']}"
    if details["type"] in _BOUNDS and location in written.fields and not inside:
        meant = written.units.get(location, Key("", 1.0, ""))
        symbol = suffix_unit(meant.suffix) if meant.suffix else ""
        words = meant.words(range_of(written.fields[location]))
        return f"{shown}{f' {symbol}' if symbol else ''} is not allowed; give {words}"
    if details["type"] == "literal_error":
        return f"{shown} is not known; allowed: {details['ctx']['expected']}"
    if details["type"] in _WANTED:
        return f"{shown} is not allowed; give {_WANTED[details['type']]}"
    return f"{shown} is not allowed: {details['msg']}"
