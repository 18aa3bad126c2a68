"""Every single fault of a module: a constant, a sign, an operator, an exponent, a comparison, a choice, a swap.

What cannot change a number is left alone: docstrings and texts, annotations, descriptions of fields, errors. A
condition that only refuses is a `guard`, one that only chooses between two sentences a choice of `words`: their faults
are counted apart.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from dataclasses import dataclass

TINY = 1e-8
"""Constants at or below it are tolerances of numerics, where another one is as good."""

OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.Mod: ast.Mult,
    ast.Pow: ast.Mult,
}
COMPARISONS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.Gt,
    ast.Gt: ast.Lt,
    ast.LtE: ast.GtE,
    ast.GtE: ast.LtE,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
}
ALIKE = ("zip", "where", "hypot", "isinstance", "getattr", "setattr", "isclose", "dict", "clip", "TypeVar")
"""Calls whose arguments may not be swapped, or may be without a difference."""
NAMES = {"min": "max", "max": "min", "sin": "cos", "cos": "sin", "minimum": "maximum", "maximum": "minimum"}
NAMES |= {"ceil": "floor", "floor": "ceil", "any": "all", "all": "any"}
APART = ("guard", "words")
"""Kinds that are not drawn."""
TEXTS = ("Field", "Problem", "Quantity", "Origin", "Path", "field", "DesignError", "SolveError")
"""Calls whose arguments are words, bounds of what is allowed, or messages."""


@dataclass(frozen=True)
class Fault:
    """One fault: where, what kind, and the faulty tree."""

    module: str
    """Dotted name."""
    function: str
    """Qualified name of the function that holds it; ``<module>`` outside of functions."""
    name: str
    """Name that is assigned outside of functions, such as a constant's."""
    line: int
    """In the file, from 1."""
    kind: str
    """Such as ``constant``; ``guard`` for what only refuses, ``words`` for what only chooses a sentence."""
    change: str
    """Old and new text."""
    path: Path
    """Fields from the module to the faulty node."""
    new: ast.expr

    def __str__(self) -> str:
        return f"{self.module}:{self.line} {self.function}: {self.kind}: {self.change}"

    def tree(self, source: str) -> ast.Module:
        """Return the faulty module, by the text of the sound one."""
        tree = ast.parse(source)
        _put(tree, self.path, self.new)
        return ast.fix_missing_locations(tree)


Path = tuple[tuple[str, int | None], ...]


@dataclass(frozen=True)
class _Place:
    """A node that can be replaced, by the path of fields that leads to it."""

    path: Path
    node: ast.AST
    function: str
    name: str
    apart: str
    """Kind of a place whose faults are counted apart, or nothing."""


def faults_of(module: str, source: str) -> Iterator[Fault]:
    """Yield every fault of a module, in the order of its text.

    Args:
        module: Dotted name.
        source: Its text.
    """
    tree = ast.parse(source)
    for place in _places(tree, (), "<module>", "", ""):
        for kind, new in _replacements(place.node, _exponent(tree, place)):
            change, line = f"{ast.unparse(place.node)} -> {ast.unparse(new)}", getattr(place.node, "lineno", 0)
            yield Fault(module, place.function, place.name, line, place.apart or kind, change, place.path, new)


def _places(node: ast.AST, path: Path, function: str, name: str, apart: str) -> Iterator[_Place]:
    """Yield the nodes below one that may be faulty, with the function around them."""
    if isinstance(node, ast.IfExp) and _sentence(node.body) and _sentence(node.orelse):
        apart = apart or "words"
    if isinstance(node, ast.expr):
        yield _Place(path, node, function, name, apart)
    inside = function
    if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
        inside = node.name if function == "<module>" else f"{function}.{node.name}"
    if function == "<module>" and isinstance(node, (ast.Assign, ast.AnnAssign)):
        name = ast.unparse(node.targets[0] if isinstance(node, ast.Assign) else node.target)
    for field, value in ast.iter_fields(node):
        for index, child in enumerate(value) if isinstance(value, list) else ((None, value),):
            if isinstance(child, ast.AST) and not _silent(node, field, child):
                guard = field == "test" and isinstance(node, ast.If) and _refuses(node)
                yield from _places(child, (*path, (field, index)), inside, name, "guard" if guard else apart)


def _silent(parent: ast.AST, field: str, child: ast.AST) -> bool:
    """Tell whether nothing that counts stands below a child."""
    if field in ("annotation", "returns", "decorator_list", "bases", "keywords") and not isinstance(parent, ast.Call):
        return True
    if isinstance(child, (ast.Raise, ast.Assert, ast.JoinedStr, ast.Import, ast.ImportFrom)):
        return True
    if isinstance(child, (ast.FunctionDef, ast.ClassDef)) and child.name in ("__str__", "__repr__"):
        return True
    if isinstance(child, ast.keyword) and child.arg == "strict":
        return True
    if isinstance(child, ast.Expr) and isinstance(child.value, ast.Constant):
        return True
    if isinstance(child, ast.Call):
        called = _called(child)
        return called in TEXTS or called.endswith(("Error", "problem", "refused"))
    # A type's alias: one name, subscripted or joined by bars, that stands alone.
    return isinstance(parent, ast.Assign) and isinstance(child, ast.Subscript) and ast.unparse(child)[0].isupper()


def _sentence(node: ast.expr) -> bool:
    """Tell whether an expression is text of several words, or none; a single word may be a key."""
    if not _text(node):
        return False
    words = [part.value for part in ast.walk(node) if isinstance(part, ast.Constant)]
    return words == [""] or any(isinstance(word, str) and " " in word.strip() for word in words)


def _refuses(node: ast.If) -> bool:
    """Tell whether the body of a condition raises, or yields or returns problems, and does nothing else."""
    text = ast.unparse(ast.Module(node.body, []))
    return isinstance(node.body[-1], ast.Raise) or "Problem(" in text or "Error(" in text


def _exponent(tree: ast.Module, place: _Place) -> bool:
    """Tell whether a place is the right side of a power."""
    parent: object = tree
    for field, index in place.path[:-1]:
        parent = getattr(parent, field)
        parent = parent[index] if index is not None and isinstance(parent, list) else parent
    return (
        bool(place.path)
        and isinstance(parent, ast.BinOp)
        and isinstance(parent.op, ast.Pow)
        and place.path[-1][0] == "right"
    )


def _put(tree: ast.AST, path: Path, new: ast.AST) -> None:
    for field, index in path[:-1]:
        value = getattr(tree, field)
        tree = value if index is None else value[index]
    field, index = path[-1]
    if index is None:
        setattr(tree, field, new)
    else:
        getattr(tree, field)[index] = new


def _replacements(node: ast.AST, exponent: bool) -> Iterator[tuple[str, ast.expr]]:
    """Yield kind and replacement of every fault of one node."""
    make: dict[type[ast.AST], Callable[..., Iterator[tuple[str, ast.expr]]]] = {
        ast.BinOp: _operator,
        ast.UnaryOp: _sign,
        ast.Compare: _comparison,
        ast.BoolOp: _junction,
        ast.Call: _call,
        ast.IfExp: _choice,
    }
    if isinstance(node, ast.Constant):
        yield from _constant(node, "exponent" if exponent else "constant")
    elif type(node) in make:
        yield from make[type(node)](node)


def _constant(node: ast.Constant, kind: str) -> Iterator[tuple[str, ast.expr]]:
    value = node.value
    if isinstance(value, bool):
        yield "constant", ast.Constant(not value)
    elif isinstance(value, int):
        yield kind, ast.Constant(value + 1)
    elif isinstance(value, float) and value == 0.0:
        yield kind, ast.Constant(1.0)
    elif isinstance(value, float) and abs(value) > TINY:
        yield kind, ast.Constant(value * 1.25)


def _operator(node: ast.BinOp) -> Iterator[tuple[str, ast.expr]]:
    new = OPERATORS.get(type(node.op))
    if new and not any(_text(side) for side in (node.left, node.right)):
        yield "operator", ast.BinOp(node.left, new(), node.right)


def _text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def _sign(node: ast.UnaryOp) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node.op, (ast.USub, ast.Not)):
        yield "sign", node.operand


def _comparison(node: ast.Compare) -> Iterator[tuple[str, ast.expr]]:
    new = COMPARISONS[type(node.ops[0])]()
    yield "comparison", ast.Compare(node.left, [new, *node.ops[1:]], node.comparators)


def _junction(node: ast.BoolOp) -> Iterator[tuple[str, ast.expr]]:
    yield "junction", ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)


def _call(node: ast.Call) -> Iterator[tuple[str, ast.expr]]:
    called, name = node.func, _called(node)
    first, second = (*node.args, None, None)[:2]
    if name in NAMES:
        other = NAMES[name]
        load = ast.Load()
        new = ast.Attribute(called.value, other, load) if isinstance(called, ast.Attribute) else ast.Name(other, load)
        yield "choice", ast.Call(new, node.args, node.keywords)
    elif _differ(first, second) and name not in ALIKE:
        yield "swap", ast.Call(called, [second, first, *node.args[2:]], node.keywords)


def _differ(first: ast.expr | None, second: ast.expr | None) -> bool:
    if first is None or second is None or ast.Starred in (type(first), type(second)):
        return False
    return ast.dump(first) != ast.dump(second)


def _called(node: ast.Call) -> str:
    return node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")


def _choice(node: ast.IfExp) -> Iterator[tuple[str, ast.expr]]:
    yield "choice", ast.IfExp(node.test, node.orelse, node.body)
