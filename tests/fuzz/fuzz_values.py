"""What a fuzzed file may say: extreme values, odd names, and values that a field's own bounds allow."""

import math
import random
from types import UnionType
from typing import Literal, Union, get_args, get_origin

from gearwright.spec import Record, keys_of

EXTREMES = [
    0, 1, -1, 2, 10**9, 10**18, -(10**18), 2**63, 10**400, -(10**400), 0.0, -0.0, 5e-324, -5e-324, 1e-160, 1e-30, 1e-9,
    1e9, 1e30, 1e160, 1e308, -1e308, 1.7976931348623157e308, math.nan, math.inf, -math.inf, True, False, "", " ",
    "ground", "0", "nan", [], {}, [[]], [{}], [0, 0.0, ""], [1, 2, 3], {"": 0}, {"a": {"b": {"c": 1}}},
]  # fmt: skip
ODD_NAMES = [
    "", " ", ".", "..", "a.b", "a/b", "../../etc", "a\\b", "$x$", "$\\frac$", "%s", "{0}", "<b>", "&amp;", '"', "'",
    "=1+1", "-", "@x", "#", "[x]", "a\nb", "a\tb", "a\rb", "\x00", "\x1b[31mred", "\x7f", "\u202egnp", "\u2028",
    "ζώνη", "齿轮", "🛩", "e\u0301", "\ufeff", "ground", "rated", "input", "propeller", "None", "nan", "x" * 300,
    "x" * 20_000, "con", "shaft of", "case", "sun", "first.sun",
]  # fmt: skip
FACTORS = [0.0, -1.0, 1e-12, 1e-6, 1e-3, 0.01, 0.1, 0.5, 0.9, 0.999, 1.001, 1.1, 2.0, 10.0, 100.0, 1e3, 1e6, 1e12]
DEEP = 200
"""Levels of a nest that a reader should not mind."""


def extreme(rng: random.Random) -> object:
    """Return a value that no field is made for."""
    pick = rng.random()
    if pick < 0.75:
        return rng.choice(EXTREMES)
    if pick < 0.9:
        return rng.choice(ODD_NAMES)
    nest: object = 0
    for _ in range(rng.choice([3, 30, DEEP])):
        nest = [nest] if rng.random() < 0.5 else {"a": nest}
    return nest


def scaled(value: object, rng: random.Random) -> object:
    """Return a value near the one that is there, or some powers of ten from it."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int) and rng.random() < 0.6:
        return value + rng.choice([-10, -3, -2, -1, 1, 2, 3, 10, 100])
    if isinstance(value, int | float):
        factor = rng.choice(FACTORS)
        return value * factor if abs(value) < 1e300 else -value  # an integer may be larger than any float
    if isinstance(value, list) and value:
        return rng.choice([value[:-1], value + value, value[::-1], [value[0]]])
    return value


def parts(annotation: object) -> tuple[object, ...]:
    """Return the alternatives of a type."""
    return get_args(annotation) if get_origin(annotation) in (Union, UnionType) else (annotation,)


def plausible(model: type[Record], key: str, names: list[str], rng: random.Random) -> object:
    """Return a value that the field of a key may take, as far as its type can say."""
    meant = keys_of(model)[key]
    info = next(each for name, each in model.model_fields.items() if meant.field in (name, each.alias))
    bounds = {
        side: meant.written(float(getattr(mark, side)))
        for mark in info.metadata
        for side in ("gt", "ge", "lt", "le")
        if getattr(mark, side, None) is not None and not meant.inverse
    }
    low = bounds.get("ge", bounds.get("gt"))
    high = bounds.get("le", bounds.get("lt"))
    default = meant.written(info.default) if isinstance(info.default, float) else None
    return _of_type(info.annotation, (low, high, default), names, rng)


def _of_type(annotation, bounds, names, rng):
    part = rng.choice([each for each in parts(annotation) if each is not type(None)])
    origin = get_origin(part)
    if getattr(part, "__metadata__", None):
        return _of_type(part.__origin__, bounds, names, rng)
    if origin is Literal:
        return rng.choice(get_args(part))
    if origin is list:
        return [_of_type(get_args(part)[0], bounds, names, rng) for _ in range(rng.choice([0, 1, 1, 2, 3]))]
    if origin is dict:
        inner = get_args(part)[1]
        return {rng.choice(names): _of_type(inner, bounds, names, rng) for _ in range(rng.choice([1, 1, 2]))}
    if isinstance(part, type) and issubclass(part, Record):
        return table(part, names, rng)
    if part is bool:
        return rng.random() < 0.5
    if part is str:
        return rng.choice(names)
    number = within(*bounds, rng)
    return round(number) if part is int else number


def table(model: type[Record], names: list[str], rng: random.Random) -> dict[str, object]:
    """Return a table with what a record requires and a few of its other keys."""
    keys = keys_of(model)
    by_field: dict[str, list[str]] = {}
    for key, meant in keys.items():
        by_field.setdefault(meant.field, []).append(key)
    filled = {}
    for name, info in model.model_fields.items():
        if info.is_required() or rng.random() < 0.15:
            key = rng.choice(by_field[info.alias or name])
            filled[key] = plausible(model, key, names, rng)
    return filled


def within(low: float | None, high: float | None, default: float | None, rng: random.Random) -> float:
    """Return a number between bounds, of any order of magnitude, at times a bound itself."""
    pick = rng.random()
    if pick < 0.15 and (low is not None or high is not None):
        return rng.choice([bound for bound in (low, high) if bound is not None])
    if pick < 0.4 and default:
        number = default * 10.0 ** rng.uniform(-1.0, 1.0)
    elif pick < 0.6 and low is not None and high is not None:
        number = rng.uniform(low, high)
    else:
        smallest = low if low is not None and low > 0.0 else 1e-9
        largest = high if high is not None and high > smallest else max(1e9, 10.0 * smallest)
        number = 10.0 ** rng.uniform(math.log10(smallest), math.log10(largest))
    number = number if low is None else max(number, low)
    number = number if high is None else min(number, high)
    return float(f"{number:.{rng.choice([2, 3, 17])}g}")
