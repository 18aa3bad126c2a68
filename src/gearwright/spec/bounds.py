"""What a number, a text or a list in a file may be: bounds of each kind of quantity, which fields narrow.

Bounds are generous: they keep out what no machine has (a diameter of 1e-300 m, a power of 1e300 W), where formulas
give zeros, infinities and numbers that are none. What is sensible for one field stands with the field.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType, UnionType
from typing import Annotated, Any, NamedTuple, Union, get_args, get_origin

from pydantic import AfterValidator, BaseModel, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from gearwright.errors import excerpt
from gearwright.units import SUFFIXES, Quantity, Reciprocal, suffix_unit

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


class Allowed(NamedTuple):
    """What a field takes, looked up once for every field of a record."""

    numbers: Range
    unit: str
    """Its SI unit; empty for what has none."""


@cache
def allowed_in(model: type[BaseModel], name: str) -> Allowed:
    """Return what a field of a record takes.

    Args:
        model: The record's type.
        name: Of the field.
    """
    info = model.model_fields[name]
    mark = quantity_of(info)
    suffix = mark and next(suffix for suffix, factor in SUFFIXES[mark.dimension].items() if factor == 1.0)
    return Allowed(range_of(info), suffix_unit(suffix) if suffix else "")


def checked(value: Any, allowed: Allowed, name: str) -> Any:
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


def _refuse_beyond(value: float, allowed: Allowed) -> None:
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


_PLAIN = Allowed(range_of(FieldInfo()), "")
