"""The reference of the design, mission, mix and study files as Markdown, from the types that read them.

Every table with its keys, units, defaults, bounds and meanings; nothing is written twice, so nothing can disagree.
"""

import inspect
import math
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType, NoneType
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from gearwright.base import SUFFIXES, shown, unit, written
from gearwright.spec import Design, Mission, MixFile, OneOf, Record, Study, quantity_of, range_of, reciprocals_of

_HEAD = """# The design file

One TOML file describes a transmission. A quantity has its unit in its key: `power_kw = 1046`, `power_hp = 1403` and
`power_w = 1046000` say the same, and one of them may stand. What has no default and is not required is a freedom, and
the last column says what happens where it is left out. `gearwright check FILE` says all that is wrong with a file
at once, with line, value, what is allowed and the nearest name; `gearwright schema` prints the JSON Schema for editors.
This page is made from the types that read the file.
"""
_STUDY_HEAD = """# The study file

A study varies designs and a mission along axes over dotted paths of their files, and asks for results by name.
`gearwright study FILE` runs it, as do [these examples](../how-to/studies.md). What stands below `[mission]` is what a
mission file has at its top. This page is made from the types that read the file.
"""
_MISSION_HEAD = """# The mission file

A mission is a file of phases; `gearwright fly DESIGN MISSION` flies it: [flying the gearbox](../theory/flight.md).
This page is made from the types that read the file.
"""
_MIX_HEAD = """# The mix file

A mix says which missions a gearbox flies in its life, and how often; `gearwright mix DESIGN MIX` flies it:
[rate a life as it is lived](../how-to/lives.md). This page is made from the types that read the file.
"""
NO_PICTURES: Mapping[str, str] = MappingProxyType({})
"""A file whose tables are not drawn."""
_COLUMNS = "| key | default | allowed | meaning |\n| --- | --- | --- | --- |\n"


def design_file_markdown(pictures: Mapping[str, str] = NO_PICTURES) -> str:
    """Return the reference of the design file.

    Args:
        pictures: Table, such as ``pairs.NAME`` -> Markdown that shows what its lengths and angles are measured from.
    """
    return _HEAD + _tables(Design, pictures)


def mission_file_markdown() -> str:
    """Return the reference of the mission file."""
    return _MISSION_HEAD + _tables(Mission)


def mix_file_markdown() -> str:
    """Return the reference of the mix file."""
    return _MIX_HEAD + _tables(MixFile)


def study_file_markdown() -> str:
    """Return the reference of the study file."""
    return _STUDY_HEAD + _tables(Study)


def _tables(model: type[Record], pictures: Mapping[str, str] = NO_PICTURES) -> str:
    """Return one section for each table, each record type once."""
    sections = sections_of(model)
    return "".join(
        f"\n## {_title(path) or 'Top of the file'}\n\n{_summary(record)}\n\n{pictures.get('.'.join(path), '')}"
        f"{_COLUMNS}{_rows(record, sections)}"
        for record, path in sections.items()
    )


def sections_of(model: type[Record]) -> dict[type[Record], tuple[str, ...]]:
    """Return record type -> path of its table, the shortest one, in the order of the file.

    Args:
        model: The record of a whole file.
    """
    paths: dict[type[Record], tuple[str, ...]] = {}
    for record, path in _walk(model, ()):
        if record not in paths or len(path) < len(paths[record]):
            paths[record] = path
    return paths


def _walk(model: type[Record], path: tuple[str, ...]) -> Iterator[tuple[type[Record], tuple[str, ...]]]:
    yield model, path
    for name, info in model.model_fields.items():
        inner, depth = _record(info.annotation)
        if inner is not None:
            yield from _walk(inner, (*path, name, *("NAME",) * depth))
    if model.others is not None:
        yield from _walk(model.others, (*path, "MACHINE"))


def _record(annotation: Any) -> tuple[type[Record] | None, int]:
    """Return the record inside an annotation, and how many names stand before it."""
    if isinstance(annotation, type) and issubclass(annotation, Record):
        return annotation, 0
    for part in get_args(annotation):
        inner, depth = _record(part)
        if inner is not None:
            return inner, depth + (get_origin(annotation) is dict)
    return None, 0


def _title(path: tuple[str, ...]) -> str:
    return f"`[{'.'.join(path)}]`" if path else ""


def _summary(record: type[Record]) -> str:
    return " ".join((inspect.getdoc(record) or "").split()).replace("``", "`")


def _rows(record: type[Record], sections: Mapping[type[Record], tuple[str, ...]]) -> str:
    return "".join(f"| {' | '.join(_cells(name, info, sections))} |\n" for name, info in record.model_fields.items())


def _cells(name: str, info: FieldInfo, sections: Mapping[type[Record], tuple[str, ...]]) -> tuple[str, str, str, str]:
    meaning = (info.description or "").replace("|", "\\|")
    inner, _ = _record(info.annotation)
    if inner is not None:
        table = _title(sections[inner])
        return f"`{info.alias or name}`", "–", f"[{table}](#{anchor(sections[inner])})", meaning
    return _key(name, info), _default(info), "; ".join(_allowed(info)), meaning


def anchor(path: Iterable[str]) -> str:
    """Return the anchor that Markdown's table of contents gives the title of a table.

    Args:
        path: Of the table, such as ``("pairs", "NAME")``.
    """
    return "".join(path).lower()


def _key(name: str, info: FieldInfo) -> str:
    quantity = quantity_of(info)
    if quantity is None:
        return f"`{info.alias or name}`"
    first = _suffix(quantity.dimension)
    others = [f"`_{suffix}`" for suffix in SUFFIXES[quantity.dimension] if suffix != first]
    named = "".join(f", or `{mark.key}`" for mark in reciprocals_of(info))
    return f"`{name}_{first}`" + (f" ({', '.join(others)})" if others else "") + named


def _suffix(dimension: str) -> str:
    """Return the suffix of the unit in which a dimension is shown, or its first one."""
    units = SUFFIXES[dimension]
    same = (suffix for suffix, factor in units.items() if math.isclose(factor * shown(1.0, dimension), 1.0))
    return next(same, next(iter(units)))


def _default(info: FieldInfo) -> str:
    if info.is_required():
        return "**required**"
    if info.default is PydanticUndefined:
        empty = info.get_default(call_default_factory=True)
        return f"`{empty}`" if empty else "–"
    if info.default is None:
        return "none"
    if isinstance(info.default, bool):
        return f"`{str(info.default).lower()}`"
    return _value(float(info.default), info) if isinstance(info.default, float) else f"`{info.default!r}`"


def _value(number: float, info: FieldInfo) -> str:
    """Return an SI number in the unit of the first key, without needless zeros."""
    quantity = quantity_of(info)
    if quantity is None:
        return f"{number:.4g}"
    suffix = _suffix(quantity.dimension)
    value = number / SUFFIXES[quantity.dimension][suffix]
    named = unit(quantity.dimension) if math.isclose(value, shown(number, quantity.dimension)) else suffix
    return f"{_plain(value)} {named}"


def _plain(value: float) -> str:
    text = written(value)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def _allowed(info: FieldInfo) -> Iterator[str]:
    choices = [arg for part in _options(info.annotation) if get_origin(part) is Literal for arg in get_args(part)]
    choices += [name for mark in info.metadata if isinstance(mark, OneOf) for name in mark.table]
    if choices:
        yield ", ".join(f"`{choice}`" for choice in choices)
    else:
        yield _kind(info)
    yield from _bounds(info)
    for mark in info.metadata:
        if getattr(mark, "min_length", 0):
            yield f"at least {mark.min_length}"


def _bounds(info: FieldInfo) -> Iterator[str]:
    """Yield the minimum and the maximum of a number; a number without a unit may have none of its own."""
    bounded = any(getattr(mark, name, None) is not None for mark in info.metadata for name in ("ge", "gt", "le", "lt"))
    if bounded or quantity_of(info) is not None:
        allowed = range_of(info)
        yield f"{'>' if allowed.above else '≥'} {_value(allowed.minimum, info)}"
        yield f"{'<' if allowed.below else '≤'} {_value(allowed.maximum, info)}"


def _options(annotation: Any) -> tuple[Any, ...]:
    """Return the parts of a union, without None, or the annotation itself."""
    parts = get_args(annotation)
    if (parts and NoneType in parts) or (parts and get_origin(annotation) not in (Literal, list, dict)):
        return tuple(part for part in parts if part is not NoneType)
    return (annotation,)


def _kind(info: FieldInfo) -> str:
    words = {str: "text", int: "whole number", bool: "`true`, `false`", float: "number"}
    names = []
    for part in _options(info.annotation):
        origin, inner = get_origin(part), get_args(part)
        if origin is list:
            names.append("list")
        elif origin is dict:
            names.append("table")
        else:
            names.append(words.get(inner[0] if inner else part, "number"))
    return " or ".join(dict.fromkeys(names))
