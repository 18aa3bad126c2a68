"""Fuzzed files, each made from a seed alone: the shipped files with their trees changed or their text damaged."""

import json
import math
import pickle
import random
import re
import tomllib
from collections.abc import Callable, Iterator
from copy import deepcopy
from functools import cache
from types import MappingProxyType
from typing import NamedTuple, get_args, get_origin

from fuzz_values import ODD_NAMES, extreme, parts, plausible, scaled

from gearwright.shipped import (
    shipped_design,
    shipped_designs,
    shipped_mission,
    shipped_missions,
    shipped_studies,
    shipped_study,
)
from gearwright.spec import Design, Mission, Record, Study, keys_of

MODELS = MappingProxyType({"design": Design, "mission": Mission, "study": Study})
Tree = dict[str, object]


class Case(NamedTuple):
    """One file to feed, and the shipped file that goes with it."""

    kind: str
    """design, mission or study."""
    base: str
    """Shipped file that it was made from."""
    text: str


@cache
def corpus(kind: str) -> dict[str, str]:
    """Return name -> text of every shipped file of a kind."""
    names, path = {
        "design": (shipped_designs, shipped_design),
        "mission": (shipped_missions, shipped_mission),
        "study": (shipped_studies, shipped_study),
    }[kind]
    return {name: path(name).read_text(encoding="utf-8") for name in names()}


def tree_of(kind: str, base: str) -> Tree:
    """Return the tree of a shipped file, to be changed."""
    return pickle.loads(_pickled(kind, base))


@cache
def _pickled(kind: str, base: str) -> bytes:
    return pickle.dumps(tomllib.loads(corpus(kind)[base]))


def case(
    seed: int, number: int, kinds: tuple[str, ...] = tuple(MODELS), *, damaged: float = 0.35, wild: float = 0.6
) -> Case:
    """Return one fuzzed file.

    Args:
        seed: Of the whole run.
        number: Of this file in it.
        kinds: Kinds to choose from.
        damaged: Part of the files whose text is damaged, after or instead of their tree.
        wild: Part of the changes of trees that most files do not survive.
    """
    rng = random.Random(f"{seed}/{number}")
    kind = rng.choice(kinds)
    base = rng.choice(sorted(corpus(kind)))
    text, pick = corpus(kind)[base], rng.random()
    if pick < 1.0 - damaged / 2.0:
        tree = tree_of(kind, base)
        for _ in range(_count(rng)):
            rng.choice(_WILD if rng.random() < wild else _TAME)(tree, kind, rng)
        text = written(tree)
    if pick > 1.0 - damaged:
        for _ in range(_count(rng)):
            text = rng.choice(_TEXT_CHANGES)(text, rng)
    return Case(kind, base, text)


def _count(rng: random.Random) -> int:
    return min(1 + int(rng.expovariate(0.8)), 8)


# Trees ---------------------------------------------------------------------------------------------------------------


def places(tree: object, path: tuple[str, ...] = ()) -> Iterator[tuple[dict, str, tuple[str, ...]]]:
    """Yield (table, key, path) of every entry of a tree."""
    if isinstance(tree, dict):
        for key, value in tree.items():
            yield tree, key, (*path, key)
            yield from places(value, (*path, key))


def names_of(tree: Tree) -> list[str]:
    """Return the names that a tree speaks of: short texts and keys of tables."""
    found = {"ground", "rated"}
    for table, key, _ in places(tree):
        found.add(key)
        value = table[key]
        found.update(each for each in (value if isinstance(value, list) else [value]) if isinstance(each, str))
    return sorted(each for each in found if len(each) < 40)


def model_at(model: object, path: tuple[str, ...]) -> type[Record] | None:
    """Return the record that a table at a path is read as, if any."""
    for part in (each for each in parts(model) if each is not type(None)):
        if get_origin(part) is dict:
            found = model_at(get_args(part)[1], path[1:]) if path else None
        elif isinstance(part, type) and issubclass(part, Record):
            if not path:
                return part
            info = next((each for name, each in part.model_fields.items() if path[0] in (name, each.alias)), None)
            found = model_at(info.annotation, path[1:]) if info is not None else None
        else:
            found = None
        if found is not None:
            return found
    return None


def _entry(tree: Tree, rng: random.Random) -> tuple[dict, str, tuple[str, ...]]:
    entries = list(places(tree))
    return rng.choice(entries) if entries else (tree, tree.setdefault("x", "x"), ("x",))


def _leaf(tree: Tree, rng: random.Random) -> tuple[dict, str, tuple[str, ...]]:
    leaves = [each for each in places(tree) if not isinstance(each[0][each[1]], dict)]
    return rng.choice(leaves) if leaves else (tree, tree.setdefault("x", "x"), ("x",))


def _put_extreme(tree: Tree, kind: str, rng: random.Random) -> None:
    table, key, _ = _leaf(tree, rng) if rng.random() < 0.8 else _entry(tree, rng)
    table[key] = extreme(rng)


def _scale(tree: Tree, kind: str, rng: random.Random) -> None:
    table, key, _ = _leaf(tree, rng)
    table[key] = scaled(table[key], rng)


def _redraw(tree: Tree, kind: str, rng: random.Random) -> None:
    """Give a key another value that its field allows."""
    table, key, path = _leaf(tree, rng)
    model = model_at(MODELS[kind], path[:-1])
    if model is not None and key in keys_of(model):
        table[key] = plausible(model, key, names_of(tree), rng)


def _add_known(tree: Tree, kind: str, rng: random.Random) -> None:
    """Write a key that the table may have, with a value that its field allows."""
    tables = [(tree, ())] + [(table[key], path) for table, key, path in places(tree) if isinstance(table[key], dict)]
    table, path = rng.choice(tables)
    model = model_at(MODELS[kind], path)
    if model is not None:
        key = rng.choice(sorted(keys_of(model)))
        table[key] = plausible(model, key, names_of(tree), rng)


def _delete(tree: Tree, kind: str, rng: random.Random) -> None:
    table, key, _ = _entry(tree, rng)
    del table[key]


def _duplicate(tree: Tree, kind: str, rng: random.Random) -> None:
    table, key, _ = _entry(tree, rng)
    table[rng.choice([f"{key}-2", *names_of(tree)])] = deepcopy(table[key])


def _rename_key(tree: Tree, kind: str, rng: random.Random) -> None:
    table, key, _ = _entry(tree, rng)
    table[rng.choice([*ODD_NAMES, *names_of(tree), key.upper(), key[:-1], f"{key}_mm"])] = table.pop(key)


def _retarget(tree: Tree, kind: str, rng: random.Random) -> None:
    """Point one text at another name of the file."""
    texts = [each for each in places(tree) if isinstance(each[0][each[1]], str | list)]
    if texts:
        table, key, _ = rng.choice(texts)
        name = rng.choice(names_of(tree))
        table[key] = name if isinstance(table[key], str) else [*table[key][:-1], name]


def _swap(tree: Tree, kind: str, rng: random.Random) -> None:
    first, second = _leaf(tree, rng), _leaf(tree, rng)
    first[0][first[1]], second[0][second[1]] = second[0][second[1]], first[0][first[1]]


def _rename_everywhere(tree: Tree, kind: str, rng: random.Random) -> None:
    """Give a name another one wherever it stands: the file keeps its sense."""
    names = names_of(tree)
    old, new = rng.choice(names), rng.choice([*ODD_NAMES, *ODD_NAMES, *names])
    renamed = _with_name(tree, old, new)
    tree.clear()
    tree.update(renamed)


def _with_name(value: object, old: str, new: str) -> object:
    if isinstance(value, dict):
        return {new if key == old else key: _with_name(each, old, new) for key, each in value.items()}
    if isinstance(value, list):
        return [_with_name(each, old, new) for each in value]
    return new if isinstance(value, str) and value == old else value


def _graft(tree: Tree, kind: str, rng: random.Random) -> None:
    """Take an entry over from another shipped file."""
    other_kind = kind if rng.random() < 0.85 else rng.choice(sorted(MODELS))
    other = tree_of(other_kind, rng.choice(list(corpus(other_kind))))
    table, key, path = _entry(other, rng)
    target = tree
    for step in path[:-1]:
        inner = target.setdefault(step, {})
        if not isinstance(inner, dict):
            return
        target = inner
    target[key] = table[key]


def _reorder(tree: Tree, kind: str, rng: random.Random) -> None:
    """Turn the order of a table's entries around: it means something for phases, and else must not."""
    tables = [each for table, key, _ in places(tree) if isinstance(each := table[key], dict)]
    if tables:
        table = rng.choice(tables)
        entries = list(table.items())[::-1]
        table.clear()
        table.update(entries)


TreeChange = Callable[[Tree, str, random.Random], None]
_WILD: list[TreeChange] = [
    _put_extreme, _put_extreme, _put_extreme, _delete, _duplicate, _rename_key, _retarget, _swap, _rename_everywhere,
    _rename_everywhere, _graft, _reorder,
]  # fmt: skip
"""Changes that most files do not survive."""
_TAME: list[TreeChange] = [_scale, _redraw, _add_known, _add_known, _graft]
"""Changes after which a file is often still one that can be read."""


# Text ----------------------------------------------------------------------------------------------------------------

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def _key(name: str) -> str:
    return name if _BARE.fullmatch(name) else _quoted(name)


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007F")


def _value(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return "1" + "0" * 400 if value > 10**300 else "-1" + "0" * 400 if value < -(10**300) else str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else f"{value}"
    if isinstance(value, list):
        return f"[{', '.join(_value(each) for each in value)}]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_key(key)} = {_value(each)}" for key, each in value.items()) + "}"
    return _quoted(str(value))


def written(tree: Tree, path: tuple[str, ...] = ()) -> str:
    """Return a tree as TOML, a table as a table where it is shallow and inline where it is deep."""
    deep = len(path) >= 3
    plain = {key: each for key, each in tree.items() if deep or not isinstance(each, dict)}
    lines = [f"{_key(key)} = {_value(each)}" for key, each in plain.items()]
    if path and (lines or not tree):
        lines.insert(0, f"\n[{'.'.join(_key(each) for each in path)}]")
    return "\n".join([*lines, *(written(tree[key], (*path, key)) for key in tree if key not in plain)])


def _lines(text: str, rng: random.Random) -> str:
    """Drop, double, exchange or move lines."""
    lines = text.split("\n")
    first, second = rng.randrange(len(lines)), rng.randrange(len(lines))
    match rng.randrange(5):
        case 0:
            del lines[first]
        case 1:
            lines.insert(second, lines[first])
        case 2:
            lines[first], lines[second] = lines[second], lines[first]
        case 3:
            del lines[first : first + rng.randrange(1, 8)]
        case _:
            lines[second:second] = lines[first : first + rng.randrange(1, 8)]
    return "\n".join(lines)


def _bytes(text: str, rng: random.Random) -> str:
    """Change, drop or put in some bytes; what is no UTF-8 any more reads as its replacement."""
    raw = bytearray(text.encode())
    for _ in range(rng.choice([1, 1, 2, 5, 20])):
        place = rng.randrange(len(raw) + 1)
        match rng.randrange(4):
            case 0:
                raw[place:place] = bytes([rng.randrange(256)])
            case 1:
                del raw[place : place + rng.choice([1, 1, 1, 10])]
            case 2:
                raw[place : place + 1] = bytes([rng.choice(b"0123456789.-+eE\"'[]{}=,#\n\t \x00\x7f\\_")])
            case _:
                raw[place : place + 1] = bytes([rng.randrange(256)])
    return raw.decode(errors="replace")


def _cut(text: str, rng: random.Random) -> str:
    return text[: rng.randrange(len(text) + 1)]


def _splice(text: str, rng: random.Random) -> str:
    """Go on with another shipped file from some line on."""
    other = rng.choice(list(corpus(rng.choice(sorted(MODELS))).values())).split("\n")
    lines = text.split("\n")
    return "\n".join(lines[: rng.randrange(len(lines) + 1)] + other[rng.randrange(len(other)) :])


def _retype(text: str, rng: random.Random) -> str:
    """Write another value, as text, after one equals sign."""
    lines = text.split("\n")
    place = rng.randrange(len(lines))
    value = rng.choice(
        ["0", "-1", "1e308", "5e-324", "nan", "-inf", "0x7f", "1_000", "1e", "07", "1979-05-27", "07:32:00",
         "1979-05-27T07:32:00Z", "'''", '"""', "[[[[", "{a=1", "9" * 5000, '"' + "y" * 50_000 + '"', "[" * 2000,
         "[" * 60 + "]" * 60, "a.b.c", "true", "'ground'"]
    )  # fmt: skip
    lines[place] = f"{lines[place].partition('=')[0]}= {value}"
    return "\n".join(lines)


def _insert(text: str, rng: random.Random) -> str:
    """Put in something that is odd by itself."""
    odd = rng.choice(["\x00", "\x0b", "\x0c", "\r", "\x1b[2J", "\ufeff", "\u2028", "\u202e", "[[shafts]]\n", "[a.b]\n",
                      "\n[shafts]\n", "x." * 500 + "x = 1\n", "[" + "x." * 500 + "x]\n", "#" * 1000, "\n" * 1000,
                      "".join(f"k{k} = {k}\n" for k in range(300))])  # fmt: skip
    place = rng.randrange(len(text) + 1)
    return text[:place] + odd + text[place:]


_TEXT_CHANGES: list[Callable[[str, random.Random], str]] = [
    _lines,
    _lines,
    _bytes,
    _bytes,
    _cut,
    _splice,
    _retype,
    _insert,
]
