"""Every record that a sizing, a system and the tables of a comparison are made of holds what its fields declare.

Two arguments that are exchanged where a record is made leave a text where a number belongs, or a kind for a name.
"""

import dataclasses
import inspect
import types
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence, Set as AbstractSet
from enum import Enum
from functools import cache
from typing import Annotated, Any, Literal, NamedTuple, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np
import pytest

from designs import HYBRID, PAIR
from gearwright.dynamics.assembly import assemble
from gearwright.identity import Kind, PartId
from gearwright.sizing import insight as aspects, insight as bevel_aspects, size
from gearwright.sizing.mass import GROUPS, complete_mass
from gearwright.sizing.rating import METHODS
from gearwright.spec import parse, read

PACKAGE = "gearwright."
STANDARD = (
    PAIR.replace("power_kw = 100", "power_kw = 100\ninertia_kg_m2 = 0.1")
    + '[gears]\nmaterial = "18CrNiMo7-6"\nrating = "iso6336"\n'
)
NUMBERS = {float: (int, float, np.floating, np.integer), int: (int, np.integer), complex: (int, float, complex)}


@cache
def declared(kind: type) -> Mapping[str, Any]:
    """Return what the fields of a record declare; nothing where it is no record, or says it with names not there."""
    if not (dataclasses.is_dataclass(kind) or hasattr(kind, "_fields")):
        return {}
    try:
        hints = get_type_hints(kind, include_extras=False)
    except NameError:
        return {}
    names = kind._fields if hasattr(kind, "_fields") else [field.name for field in dataclasses.fields(kind)]
    return {name: hints[name] for name in names if name in hints}


def holds(value: Any, hint: Any) -> bool:
    """Tell whether a value is what a hint says, as deep as tuples and mappings go."""
    origin, inner = get_origin(hint), get_args(hint)
    if origin is Annotated:
        return holds(value, inner[0])
    if origin is Literal:
        return value in inner
    if origin in (Union, types.UnionType):
        return any(holds(value, one) for one in inner)
    if origin is tuple:
        if not isinstance(value, tuple):
            return False
        rest = len(inner) == 2 and inner[1] is Ellipsis
        return (rest or len(value) == len(inner)) and all(
            holds(entry, inner[0] if rest else kind)
            for entry, kind in zip(value, [inner[0]] * len(value) if rest else inner, strict=True)
        )
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return isinstance(value, Mapping) and all(holds(k, inner[0]) and holds(v, inner[1]) for k, v in value.items())
    if isinstance(origin, type) and issubclass(origin, (Sequence, AbstractSet, Collection, Iterable)) and inner:
        return not isinstance(value, str) and isinstance(value, origin)
    if origin is Callable or hint is Callable:
        return callable(value)
    hint = origin or hint
    if hint in NUMBERS:
        return isinstance(value, NUMBERS[hint]) and not (isinstance(value, bool) and hint is not int)
    if hint is None or hint is types.NoneType:
        return value is None
    if getattr(hint, "_is_protocol", False):
        return not isinstance(value, (str, int, float, tuple))
    return not inspect.isclass(hint) or hint is Any or isinstance(hint, TypeVar) or isinstance(value, hint)


def wrong_in(value: Any, path: str, seen: set[int]) -> Iterator[str]:
    """Yield the fields that do not hold what they declare, in a value and all that is in it."""
    if isinstance(value, (str, int, float, complex, Enum, np.ndarray)) or value is None or id(value) in seen:
        return
    seen.add(id(value))
    kind = type(value)
    if kind.__module__.startswith(PACKAGE):
        for name, hint in declared(kind).items():
            own = getattr(value, name)
            if not holds(own, hint):
                yield f"{path}.{name} of {kind.__name__}: {own!r:.80} for {hint}"
            yield from wrong_in(own, f"{path}.{name}", seen)
    elif isinstance(value, Mapping):
        for key, entry in value.items():
            yield from wrong_in(key, f"{path} key", seen)
            yield from wrong_in(entry, f"{path}[{key}]", seen)
    elif isinstance(value, (list, tuple, set, frozenset)):
        for entry in value:
            yield from wrong_in(entry, f"{path}[]", seen)


def wrong(value: Any) -> list[str]:
    """Return the first of the fields that do not hold what they declare."""
    return [words for words, _ in zip(wrong_in(value, "", set()), range(20), strict=False)]


class Twisted(NamedTuple):
    """What a record with exchanged arguments looks like."""

    name: str
    part: PartId


Twisted.__module__ = f"{PACKAGE}tests"


def test_exchanged_arguments_are_seen():
    assert not wrong(Twisted("a", PartId(Kind.CLUTCH, "b")))
    assert wrong(Twisted(PartId(Kind.CLUTCH, "b"), "a")) and wrong({"x": [PartId("b", Kind.CLUTCH)]})


@pytest.mark.parametrize("text", [PAIR, HYBRID, STANDARD], ids=["pair", "sets", "a standard"])
def test_every_record_of_a_sizing_holds_what_it_declares(text):
    assert wrong(size(parse(text))) == []


@pytest.mark.parametrize("name", ["off-set-h1", "ec120b"])
def test_so_does_every_record_of_masses_and_of_a_system(name):
    sizing = size(read(name))
    mass = complete_mass(sizing)
    assert wrong(mass) == [] and {item.group for item in mass.parts} <= set(GROUPS)
    assert wrong(assemble(sizing)) == []


def test_so_does_every_row_of_a_comparison_of_methods():
    rows = [value for room in (aspects, bevel_aspects) for value in vars(room).values() if isinstance(value, tuple)]
    assert sum(map(len, rows)) > 40 and wrong(rows) == []
    assert wrong(list(METHODS.values())) == []


def test_methods_are_kept_by_their_own_names_and_name_their_edition():
    for name, method in METHODS.items():
        assert getattr(method, "_name", name) == name and " " in method.edition
