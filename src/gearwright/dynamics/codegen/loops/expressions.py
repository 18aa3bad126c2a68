"""Expressions: numbers, places in arrays and comparisons of translated functions, as LLVM assembly."""

from __future__ import annotations

import ast
import struct
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from gearwright.dynamics.codegen.loops.words import KINDS, NUMBER, TRUTH, WHOLE, Kind

_SIGNS: Mapping[type, tuple[str, str]] = {
    ast.Add: ("add", "fadd"), ast.Sub: ("sub", "fsub"), ast.Mult: ("mul", "fmul"), ast.Div: ("", "fdiv"),
    ast.FloorDiv: ("sdiv", ""), ast.Mod: ("srem", ""),
}  # fmt: skip
"""Of whole numbers, which must not be negative where they are divided, and of others."""
_RELATIONS: Mapping[type, str] = {
    ast.Lt: "lt", ast.LtE: "le", ast.Gt: "gt", ast.GtE: "ge", ast.Eq: "eq", ast.NotEq: "ne",
}  # fmt: skip
_MATHS = ("cos", "sin", "fabs", "sqrt")
"""Functions of one number that LLVM knows."""


class Value(NamedTuple):
    """A value that has been written."""

    text: str
    """Its name, or the number itself."""
    kind: Kind


class Expressions:
    """Writes the expressions of one function."""

    def __init__(self, around: Mapping[str, Any], known: Mapping[str, tuple[Kind, ...]]) -> None:
        self.around, self.known = around, known
        self.lines: list[str] = []
        self.rooms: list[str] = []
        self.kinds: dict[str, Kind] = {}
        self.count = 0

    def name(self, text: str) -> str:
        """Write an instruction and return the name of its result.

        Args:
            text: Right-hand side of the assignment.
        """
        self.count += 1
        self.lines.append(f"  %t{self.count} = {text}")
        return f"%t{self.count}"

    def room(self, kind: str) -> str:
        """Return room for a value that changes.

        Args:
            kind: In assembly.
        """
        self.count += 1
        self.rooms.append(f"  %r{self.count} = alloca {kind}")
        return f"%r{self.count}"

    def label(self) -> str:
        """Return a label that is not in use."""
        self.count += 1
        return f"l{self.count}"

    def goto(self, label: str) -> None:
        """Write a jump.

        Args:
            label: Where to.
        """
        self.lines.append(f"  br label %{label}")

    def branch(self, truth: str, yes: str, no: str) -> None:
        """Write a jump to one of two labels.

        Args:
            truth: What decides.
            yes: Label.
            no: Label.
        """
        self.lines.append(f"  br i1 {truth}, label %{yes}, label %{no}")

    def value(self, node: ast.expr) -> Value:
        """Return the value of an expression.

        Args:
            node: Of Python's syntax.
        """
        for kind, write in _WRITERS.items():
            if isinstance(node, kind):
                return write(self, node)
        raise NotImplementedError(ast.unparse(node))

    def number(self, node: ast.expr) -> str:
        """Return the value of an expression as a number that need not be whole.

        Args:
            node: Of Python's syntax.
        """
        return self.as_number(self.value(node))

    def as_number(self, value: Value) -> str:
        """Return a value as a number that need not be whole.

        Args:
            value: Written.
        """
        if value.kind.text == NUMBER:
            return value.text
        return self.name(f"sitofp i64 {value.text} to double")

    def pair(self, one: Value, other: Value) -> tuple[str, str, str]:
        """Return two values and the kind that both can have.

        Args:
            one: Written.
            other: Written.
        """
        if one.kind == other.kind:
            return one.text, other.text, one.kind.text
        return self.as_number(one), self.as_number(other), NUMBER

    def truth(self, node: ast.expr) -> str:
        """Return whether an expression holds.

        Args:
            node: Of Python's syntax.
        """
        value = self.value(node)
        return value.text if value.kind.text == TRUTH else self.name(f"icmp ne i64 {value.text}, 0")

    def place(self, node: ast.Subscript) -> tuple[str, str]:
        """Return the address of a number of an array, and its kind.

        Args:
            node: Of Python's syntax.
        """
        array, index = self.value(node.value), self.value(node.slice)
        member = array.kind.member
        return self.name(f"getelementptr {member}, ptr {array.text}, i64 {index.text}"), member


def literal(value: float) -> Value:
    """Return a number as it stands in assembly, all its digits.

    Args:
        value: Number.
    """
    if isinstance(value, bool | int):
        return Value(str(int(value)), Kind(WHOLE))
    return Value(f"0x{struct.pack('>d', value).hex().upper()}", Kind(NUMBER))


def _constant(_: Expressions, node: ast.Constant) -> Value:
    return literal(node.value)  # type: ignore[arg-type]


def _named(code: Expressions, node: ast.Name) -> Value:
    if node.id not in code.kinds:
        return literal(code.around[node.id])
    kind = code.kinds[node.id]
    return Value(code.name(f"load {kind.text}, ptr %{node.id}"), kind)


def _attribute(code: Expressions, node: ast.Attribute) -> Value:
    assert isinstance(node.value, ast.Name)
    record = code.kinds[node.value.id].record if node.value.id in code.kinds else None
    if record is None:
        return literal(getattr(code.around[node.value.id], node.attr))
    fields = record.__annotations__
    kind = KINDS[fields[node.attr].__forward_arg__]
    base = code.value(node.value).text
    place = code.name(f"getelementptr i64, ptr {base}, i64 {list(fields).index(node.attr)}")
    return Value(code.name(f"load {kind.text}, ptr {place}"), kind)


def _subscript(code: Expressions, node: ast.Subscript) -> Value:
    place, member = code.place(node)
    return Value(code.name(f"load {member}, ptr {place}"), Kind(member))


def _binary(code: Expressions, node: ast.BinOp) -> Value:
    one, other = code.value(node.left), code.value(node.right)
    if isinstance(node.op, ast.Div):
        return Value(code.name(f"fdiv double {code.as_number(one)}, {code.as_number(other)}"), Kind(NUMBER))
    a, b, kind = code.pair(one, other)
    sign = _SIGNS[type(node.op)][kind == NUMBER]
    return Value(code.name(f"{sign} {kind} {a}, {b}"), Kind(kind))


def _unary(code: Expressions, node: ast.UnaryOp) -> Value:
    if isinstance(node.op, ast.Not):
        return Value(code.name(f"xor i1 {code.truth(node.operand)}, true"), Kind(TRUTH))
    value = code.value(node.operand)
    text = f"fneg double {value.text}" if value.kind.text == NUMBER else f"sub i64 0, {value.text}"
    return Value(code.name(text), value.kind)


def _compare(code: Expressions, node: ast.Compare) -> Value:
    values = [code.value(each) for each in (node.left, *node.comparators)]
    found = []
    for number, relation in enumerate(node.ops):
        a, b, kind = code.pair(*values[number : number + 2])
        word = _RELATIONS[type(relation)]
        # Not equal holds of what is no number, as in Python; nothing else does.
        signed = word if word in ("eq", "ne") else f"s{word}"
        test = f"fcmp {'une' if word == 'ne' else f'o{word}'}" if kind == NUMBER else f"icmp {signed}"
        found.append(code.name(f"{test} {kind} {a}, {b}"))
    while len(found) > 1:
        found[:2] = [code.name(f"and i1 {found[0]}, {found[1]}")]
    return Value(found[0], Kind(TRUTH))


def _both(code: Expressions, node: ast.BoolOp) -> Value:
    """Write an and or an or, whose later parts are looked at only where they decide."""
    room, end = code.room(TRUTH), code.label()
    for number, part in enumerate(node.values):
        truth = code.truth(part)
        code.lines.append(f"  store i1 {truth}, ptr {room}")
        if number + 1 < len(node.values):
            more = code.label()
            code.branch(truth, *((more, end) if isinstance(node.op, ast.And) else (end, more)))
            code.lines.append(f"{more}:")
    code.goto(end)
    code.lines.append(f"{end}:")
    return Value(code.name(f"load i1, ptr {room}"), Kind(TRUTH))


def _chosen(code: Expressions, node: ast.IfExp) -> Value:
    truth = code.truth(node.test)
    a, b, kind = code.pair(code.value(node.body), code.value(node.orelse))
    return Value(code.name(f"select i1 {truth}, {kind} {a}, {kind} {b}"), Kind(kind))


def _called(code: Expressions, node: ast.Call) -> Value:
    name = node.func.attr if isinstance(node.func, ast.Attribute) else node.func.id  # type: ignore[attr-defined]
    if name in code.known:
        *kinds, result = code.known[name]
        given = [
            code.number(argument) if kind.text == NUMBER else code.value(argument).text
            for argument, kind in zip(node.args, kinds, strict=True)
        ]
        arguments = ", ".join(f"{kind.text} {text}" for kind, text in zip(kinds, given, strict=True))
        return _result(code, f"call {result.text} @{name}({arguments})", result)
    return _BUILT_IN[name](code, node.args)


def _result(code: Expressions, text: str, kind: Kind) -> Value:
    if kind.text != "void":
        return Value(code.name(text), kind)
    code.lines.append(f"  {text}")
    return Value("", kind)


def _at(code: Expressions, given: list[ast.expr]) -> Value:
    array, first = (code.value(each) for each in given)
    return Value(code.name(f"getelementptr {array.kind.member}, ptr {array.text}, i64 {first.text}"), array.kind)


def _by_address(code: Expressions, given: list[ast.expr]) -> Value:
    address, *values = (code.value(each) for each in given)
    function = code.name(f"inttoptr i64 {address.text} to ptr")
    code.lines.append(f"  call void {function}({', '.join(f'{one.kind.text} {one.text}' for one in values)})")
    return Value("", KINDS["None"])


def _floats(code: Expressions, given: list[ast.expr]) -> Value:
    return Value(code.name(f"inttoptr i64 {code.value(given[0]).text} to ptr"), KINDS["Floats"])


def _extreme(relation: str) -> Callable[[Expressions, list[ast.expr]], Value]:
    def written(code: Expressions, given: list[ast.expr]) -> Value:
        extreme = code.value(given[0])
        for argument in given[1:]:
            other, best, kind = code.pair(code.value(argument), extreme)
            test = f"fcmp o{relation}" if kind == NUMBER else f"icmp s{relation}"
            truth = code.name(f"{test} {kind} {other}, {best}")
            extreme = Value(code.name(f"select i1 {truth}, {kind} {other}, {kind} {best}"), Kind(kind))
        return extreme

    return written


def _maths(name: str) -> Callable[[Expressions, list[ast.expr]], Value]:
    def written(code: Expressions, given: list[ast.expr]) -> Value:
        return Value(code.name(f"call double @llvm.{name}.f64(double {code.number(given[0])})"), Kind(NUMBER))

    return written


def _whole(code: Expressions, given: list[ast.expr]) -> Value:
    return Value(code.name(f"fptosi double {code.number(given[0])} to i64"), Kind(WHOLE))


DECLARATIONS = "\n".join(f"declare double @llvm.{name}.f64(double)" for name in _MATHS)
"""Of what `_BUILT_IN` calls."""
_BUILT_IN: Mapping[str, Callable[[Expressions, list[ast.expr]], Value]] = {
    "at": _at, "call": _by_address, "floats": _floats, "int": _whole, "max": _extreme("gt"), "min": _extreme("lt"),
    "abs": _maths("fabs"), **{name: _maths(name) for name in _MATHS},
}  # fmt: skip
_WRITERS: Mapping[type, Callable[[Expressions, Any], Value]] = {
    ast.Constant: _constant, ast.Name: _named, ast.Attribute: _attribute, ast.Subscript: _subscript,
    ast.BinOp: _binary, ast.UnaryOp: _unary, ast.Compare: _compare, ast.BoolOp: _both, ast.IfExp: _chosen,
    ast.Call: _called,
}  # fmt: skip
