"""Public verbs and the values that they return.

``verb`` holds what is given against the verb's own annotations, before the verb runs: who gives something else than it
asks for is told by a sentence which call makes the right thing. ``Shown`` values show themselves at a prompt and in a
notebook; only `render` words and draws, and it is found by name when it is asked, so that no layer depends on it.
"""

import functools
import inspect
import sys
import types
import typing
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from importlib import import_module
from numbers import Integral, Number, Real
from pathlib import Path
from typing import Annotated, Any, Literal, ParamSpec, TypeVar, Union, get_args, get_origin

from gearwright.errors import DesignError, Problem, install, near, refuse

# ----------------------------------------------------------------------------------------------------------------------
# Public verbs: who gives one something else than it asks for is told by a sentence which call makes the right thing.
#
# ``verb`` holds what is given against the verb's own annotations, before the verb runs.
# ----------------------------------------------------------------------------------------------------------------------


_P = ParamSpec("_P")
_R = TypeVar("_R")

MAKES: Mapping[str, str] = types.MappingProxyType(
    {
        "Arranged": "gw.arrange(design)",
        "Campbell": "gw.campbell(system)",
        "Checked": "gw.validate()",
        "Closed": "gw.close(design)",
        "ClosedArrangement": "gw.close_arranged(design)",
        "Comparison": "gw.mass(power, engine_speed, propeller_speed)",
        "Design": "gw.read(path or shipped name)",
        "Durability": "gw.durability(flight)",
        "DynamicWindow": "gw.window(flight, name)",
        "Flight": "gw.fly(sizing, mission)",
        "MeasuredDuty": "gw.read_duty(path)",
        "Blades": "gearwright.machines.Blades(number, activity_factor, design_lift)",
        "BladeShape": "gw.read_blades(path, number)",
        "MadePropeller": "gw.propeller(blades)",
        "Mission": "gw.read_mission(path or shipped name)",
        "Mix": "gw.read_mix(path or shipped name)",
        "Model": "gw.Model()",
        "Modes": "gw.modes(system)",
        "Outputs": "gw.Outputs(...)",
        "Particulars": "gearwright.particulars.particulars(sizing)",
        "Review": "gw.review(design)",
        "Response": "gw.frequency_response(system, frequency)",
        "RunUp": "gw.runup(sizing, system, factors)",
        "Samples": "trace.samples, of a trace from gw.simulate(system, duration)",
        "Scene": "gw.scene(sizing)",
        "SharingProblem": "gearwright.dynamics.sharing.sharing_problem(sizing, stage)",
        "SharingStudy": "gw.sharing(sizing, stage)",
        "Search": "gw.search(study)",
        "Sizing": "gw.size(design)",
        "Sizings": "gw.size_many(design, axes)",
        "SpeedMap": "gw.speed_map(system, factors, settle=..., duration=...)",
        "Study": "gw.read_study(path or shipped name)",
        "System": "gw.assemble(sizing, case)",
        "Table": "gw.study(study)",
        "Trace": "gw.simulate(system, duration)",
        "Wishes": "gw.Wishes(life=...)",
    }
)
"""Type -> call that makes one."""
_WORDS = {float: "a number", int: "a whole number", complex: "a number", str: "a text", bool: "True or False"}
_PLAIN = {float: Real, int: Integral, complex: Number}
LONGEST = 40
"""Characters of what was given that a message repeats."""


def verb(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Return a function that refuses what is not of its annotated type.

    Args:
        function: A public verb.

    Raises:
        DesignError: With every argument of a wrong type, and the call that makes the right one.
    """

    @functools.wraps(function)
    def checked(*args: _P.args, **kwargs: _P.kwargs) -> _R:
        arguments = dict(zip(_names(function), args, strict=False)) | kwargs
        problems = [
            Problem(name, _sentence(value, hint))
            for name, hint in _hints(function).items()
            if name in arguments and not _fits(value := arguments[name], hint)
        ]
        refuse(problems, function.__name__)
        return function(*args, **kwargs)

    return checked


def check_fields(record: object) -> None:
    """Refuse a record whose fields are not of their annotated types.

    Args:
        record: A dataclass that users make.

    Raises:
        DesignError: With every field of a wrong type.
    """
    kind: Any = type(record)
    hints = _hints(kind).items()
    problems = [
        Problem(name, _sentence(value, hint)) for name, hint in hints if not _fits(value := getattr(record, name), hint)
    ]
    refuse(problems, type(record).__name__)


def callable_layer(name: str, called: Callable[..., object]) -> None:
    """Let a layer be called as the verb that has its name: ``gw.study(study)`` beside ``gw.study.Table``.

    Args:
        name: Of the layer's module.
        called: The verb.
    """
    module: Any = sys.modules[name]
    module.__class__ = type("Layer", (types.ModuleType,), {"__call__": staticmethod(called)})
    module.__signature__ = inspect.signature(called)


@functools.cache
def _names(function: Any) -> tuple[str, ...]:
    return tuple(inspect.signature(function).parameters)


@functools.cache
def _hints(function: Any) -> dict[str, Any]:
    return {name: hint for name, hint in typing.get_type_hints(function).items() if name != "return"}


_ALIKE = {float, int, bool, type(None)}
"""Types of which all values fit, or none."""


def _fits(value: object, hint: Any) -> bool:
    """Return False only for what is certainly of another type."""
    origin, inside = get_origin(hint), get_args(hint)
    if origin in (Union, types.UnionType):
        return any(_fits(value, alternative) for alternative in inside)
    if origin is Literal:
        return any(type(value) is type(literal) and value == literal for literal in inside)
    if hint is None or hint is type(None):
        return value is None
    if origin is not None:
        return _holds(value, origin, inside)
    if hint is Any:
        return True
    if hint is bool:
        return type(value).__name__ in ("bool", "bool_")
    return not isinstance(hint, type) or isinstance(value, _PLAIN.get(hint, hint))


def _holds(value: object, origin: Any, inside: tuple[Any, ...]) -> bool:
    """Return whether a container is of its kind and holds what it must; an array is a sequence, a text is none."""
    if not isinstance(origin, type):
        return True
    if origin.__module__ == "numpy" or (issubclass(origin, Sequence | Iterable) and not issubclass(origin, Mapping)):
        fits = isinstance(value, Iterable) and not isinstance(value, str | bytes | Mapping)
        return fits and all(_fits(member, inside[0]) for member in _some(value, origin, inside))
    if issubclass(origin, Mapping):
        return isinstance(value, Mapping) and all(_fits(member, inside[1]) for member in value.values())
    return isinstance(value, origin)


def _some(value: object, origin: type, inside: tuple[Any, ...]) -> Iterator[object]:
    """Yield the members that can be looked at: of lists and tuples that hold one kind of thing; of numbers, some."""
    if isinstance(value, list | tuple) and inside and origin is not tuple and origin.__module__ != "numpy":
        alike = set(map(type, value)) <= _ALIKE
        yield from {type(member): member for member in value}.values() if alike else value


def _sentence(value: object, hint: Any) -> str:
    shown = value.__name__ if isinstance(value, type) else repr(value)
    kind = "a class" if isinstance(value, type) else f"of type {type(value).__name__}"
    shown = shown if len(shown) <= LONGEST and "\n" not in shown else ""
    stated = f"{shown} is {kind}" if shown else f"what is given is {kind}"
    wanted = [alternative for alternative in _alternatives(hint) if alternative is not type(None)]
    names = [str(arg) for literal in wanted if get_origin(literal) is Literal for arg in get_args(literal)]
    if names and isinstance(value, str):
        return f"{shown or 'this'} is none of {', '.join(names)}; {near(value, names)}"
    return f"{stated}; give {' or '.join(dict.fromkeys(_words(alternative) for alternative in wanted))}"


def _alternatives(hint: Any) -> tuple[Any, ...]:
    return get_args(hint) if get_origin(hint) in (Union, types.UnionType) else (hint,)


def _words(hint: Any) -> str:
    """Return what a type is called, with the call that makes one."""
    origin, inside = get_origin(hint), get_args(hint)
    if origin is Annotated:
        return _words(inside[0])
    if origin is Literal:
        return " or ".join(repr(literal) for literal in inside)
    if origin is not None:
        return _container(origin, inside)
    name = getattr(hint, "__name__", str(hint))
    if hint is Path:
        return "a path"
    named = f"{'an' if name[0] in 'AEIOU' else 'a'} {name}"
    return f"{named}, from {MAKES[name]}" if name in MAKES else _WORDS.get(hint, named)


def _container(origin: Any, inside: tuple[Any, ...]) -> str:
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return f"a mapping of names to each {_words(inside[1])}"
    if origin is Callable or not inside or origin is tuple or origin.__module__ == "numpy":
        kinds = {"Callable": "a function", "tuple": "a tuple", "ndarray": "an array of numbers"}
        return kinds.get(getattr(origin, "__name__", ""), f"a {origin}")
    return f"a sequence, each member {_words(inside[0])}"


# ----------------------------------------------------------------------------------------------------------------------
# Values show themselves: a few lines at a prompt, tables and a figure in a notebook.
#
# Only `render` words and draws, and it stands above the values: what asks for it here finds it by name when it is
# asked, so that no layer depends on it and none loads it before.
# ----------------------------------------------------------------------------------------------------------------------


class Shown:
    """A value that people look at."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(import_module("gearwright.render.pages.notebook").short(self))

    def _repr_html_(self) -> str:
        return str(import_module("gearwright.render.pages.notebook").html(self))


def extra(package: str) -> Any:
    """Return a package that only an extra of the same name brings.

    Args:
        package: ``pandas`` or ``xarray``.

    Raises:
        DesignError: If it is not installed; with how to get it.
    """
    try:
        return import_module(package)
    except ModuleNotFoundError:
        message = f"this needs {package}, which is not here; {install(package)}"
        raise DesignError([Problem("", message)]) from None


def frame(columns: Mapping[str, tuple[Iterable[Any], str]], index: str) -> Any:
    """Return columns as a pandas ``DataFrame`` whose ``attrs["units"]`` says the unit of each.

    Args:
        columns: Name -> values and unit.
        index: Column that names the rows; empty: they are counted.

    Raises:
        DesignError: If pandas is not installed.
    """
    made = extra("pandas").DataFrame({name: values for name, (values, _) in columns.items()})
    made = made.set_index(index) if index else made
    made.attrs["units"] = {name: unit for name, (_, unit) in columns.items()}
    return made
