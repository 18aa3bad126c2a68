"""Compilation of loops in a subset of Python to LLVM assembly.

What is translated runs as plain Python too. What is computed with it is decided by those who write the functions.
"""

from __future__ import annotations

import ast
import ctypes
import inspect
import struct
import textwrap
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from threading import Lock
from typing import Any, NamedTuple, TypeVar

import numpy as np

from gearwright.base import Floats, Ints
from gearwright.dynamics.codegen.assembler import address, machine_code

# ----------------------------------------------------------------------------------------------------------------------
# Words: what translated functions call beside mathematics, as plain Python does it, and the kinds of their values.
# ----------------------------------------------------------------------------------------------------------------------


WHOLE, NUMBER, TRUTH, ADDRESS = "i64", "double", "i1", "ptr"
"""Kinds of values in assembly."""


class Kind(NamedTuple):
    """Of a value: a number, an array's place, or a record of them."""

    text: str
    """In assembly."""
    member: str = ""
    """Kind of an array's numbers."""
    record: type | None = None
    """Kind of a record, a named tuple."""


KINDS = {"int": Kind(WHOLE), "float": Kind(NUMBER), "bool": Kind(TRUTH), "Floats": Kind(ADDRESS, NUMBER),
         "Ints": Kind(ADDRESS, WHOLE), "None": Kind("void")}  # fmt: skip
"""By what an annotation says; all else is a record."""


def floats(address: int) -> Floats:
    """Return the array at an address; for translated functions, in which its length does not count.

    Args:
        address: Of its first number.
    """
    return np.ctypeslib.as_array(ctypes.cast(address, ctypes.POINTER(ctypes.c_double)), (1 << 20,))


Numbers = TypeVar("Numbers", Floats, Ints)


def at(array: Numbers, first: int) -> Numbers:
    """Return an array from one of its numbers on.

    Args:
        array: Numbers.
        first: Place.
    """
    return array[first:]


def call(address: int, *given: Any) -> None:
    """Call machine code with whole numbers and arrays.

    Args:
        address: Of the code.
        given: Arguments.
    """
    kinds = [ctypes.c_int64 if isinstance(one, int) else ctypes.c_void_p for one in given]
    ctypes.CFUNCTYPE(None, *kinds)(address)(*(one if isinstance(one, int) else one.ctypes.data for one in given))


# ----------------------------------------------------------------------------------------------------------------------
# Expressions: numbers, places in arrays and comparisons of translated functions, as LLVM assembly.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Statements: functions of translated Python as LLVM assembly, every local number in memory until LLVM moves it.
# ----------------------------------------------------------------------------------------------------------------------


Known = Mapping[str, tuple[Kind, ...]]
"""Kinds of the arguments of a function and of its result, by its name."""


def assembly(functions: Sequence[Callable[..., Any]]) -> str:
    """Return functions as LLVM assembly.

    They know whole numbers, numbers, arrays and named tuples of these; ``if``, ``for`` over a range, ``while`` and
    each other.

    Args:
        functions: With annotated arguments.
    """
    known = {function.__name__: kinds_of(function) for function in functions}
    return "\n\n".join([DECLARATIONS, *(_Function(function, known).text for function in functions)])


def kinds_of(function: Callable[..., Any]) -> tuple[Kind, ...]:
    """Return the kinds of a function's arguments and of its result.

    Args:
        function: With annotated arguments.
    """
    return tuple(_kind(note, function.__globals__) for note in function.__annotations__.values())


def _kind(note: str, around: Mapping[str, Any]) -> Kind:
    return KINDS[note] if note in KINDS else Kind(ADDRESS, record=around[note])


class _Function:
    """One function."""

    def __init__(self, function: Callable[..., Any], known: Known) -> None:
        self.code = code = Expressions(function.__globals__, known)
        self.loops: list[tuple[str, str]] = []
        (node,) = ast.parse(textwrap.dedent(inspect.getsource(function))).body
        assert isinstance(node, ast.FunctionDef)
        *kinds, self.result = known[node.name]
        names = [argument.arg for argument in node.args.args]
        for name, kind in zip(names, kinds, strict=True):
            self.local(name, kind)
            code.lines.append(f"  store {kind.text} %{name}.in, ptr %{name}")
        self.body(node.body)
        end = "  ret void" if self.result.text == "void" else "  unreachable"
        arguments = ", ".join(
            f"{kind.text}{' noalias' * (kind.member != '')} %{name}.in" for name, kind in zip(names, kinds, strict=True)
        )
        head = f"define {self.result.text} @{node.name}({arguments}) nounwind {{\nentry:"
        self.text = "\n".join([head, *code.rooms, *code.lines, end, "}"])

    def local(self, name: str, kind: Kind) -> None:
        """Make room for a local name at its first use."""
        if name not in self.code.kinds:
            self.code.kinds[name] = kind
            self.code.rooms.append(f"  %{name} = alloca {kind.text}")

    def body(self, nodes: Sequence[ast.stmt]) -> None:
        """Write statements."""
        for node in nodes:
            getattr(self, f"on_{type(node).__name__}")(node)

    def on_Expr(self, node: ast.Expr) -> None:
        if not isinstance(node.value, ast.Constant):  # a docstring
            self.code.value(node.value)

    def on_Assign(self, node: ast.Assign) -> None:
        targets = [each for target in node.targets for each in getattr(target, "elts", [target])]
        several = isinstance(node.targets[0], ast.Tuple) and isinstance(node.value, ast.Tuple)
        sources = node.value.elts if several and isinstance(node.value, ast.Tuple) else [node.value]
        values = [self.code.value(each) for each in sources]
        for target, value in zip(targets, values if several else values * len(targets), strict=True):
            if isinstance(target, ast.Subscript):
                place, member = self.code.place(target)
                text = value.text if member == value.kind.text else self.code.as_number(value)
                self.code.lines.append(f"  store {member} {text}, ptr {place}")
            else:
                self.local(target.id, value.kind)
                kind = self.code.kinds[target.id]
                text = value.text if kind == value.kind else self.code.as_number(value)
                self.code.lines.append(f"  store {kind.text} {text}, ptr %{target.id}")

    def on_AnnAssign(self, node: ast.AnnAssign) -> None:
        assert node.value is not None
        self.on_Assign(ast.Assign([node.target], node.value))

    def on_AugAssign(self, node: ast.AugAssign) -> None:
        again = ast.parse(ast.unparse(node.target), mode="eval").body
        self.on_Assign(ast.Assign([node.target], ast.BinOp(again, node.op, node.value)))

    def on_If(self, node: ast.If) -> None:
        code, (yes, no, end) = self.code, (self.code.label() for _ in range(3))
        code.branch(code.truth(node.test), yes, no)
        for label, nodes in ((yes, node.body), (no, node.orelse)):
            code.lines.append(f"{label}:")
            self.body(nodes)
            code.goto(end)
        code.lines.append(f"{end}:")

    def on_While(self, node: ast.While) -> None:
        code, (head, inside, end) = self.code, (self.code.label() for _ in range(3))
        code.goto(head)
        code.lines.append(f"{head}:")
        code.branch(code.truth(node.test), inside, end)
        code.lines.append(f"{inside}:")
        self.repeated(node.body, head, end)
        code.goto(head)
        code.lines.append(f"{end}:")

    def on_For(self, node: ast.For) -> None:
        code, (head, inside, more, end) = self.code, (self.code.label() for _ in range(4))
        assert isinstance(node.iter, ast.Call)
        assert isinstance(node.target, ast.Name)
        bounds = [code.value(each).text for each in node.iter.args]
        start, stop, step = (["0", *bounds] if len(bounds) == 1 else bounds) + ["1"] * (len(bounds) < 3)
        name = node.target.id
        self.local(name, KINDS["int"])
        at = code.room("i64")
        code.lines.append(f"  store i64 {start}, ptr {at}")
        code.goto(head)
        code.lines.append(f"{head}:")
        here = code.name(f"load i64, ptr {at}")
        code.branch(code.name(f"icmp slt i64 {here}, {stop}"), inside, end)
        code.lines += [f"{inside}:", f"  store i64 {here}, ptr %{name}"]
        self.repeated(node.body, more, end)
        code.goto(more)
        code.lines.append(f"{more}:")
        code.lines.append(f"  store i64 {code.name(f'add i64 {here}, {step}')}, ptr {at}")
        code.goto(head)
        code.lines.append(f"{end}:")

    def repeated(self, nodes: Sequence[ast.stmt], again: str, end: str) -> None:
        """Write the body of a loop."""
        self.loops.append((again, end))
        self.body(nodes)
        self.loops.pop()

    def on_Break(self, _: ast.Break) -> None:
        self.leave(self.loops[-1][1])

    def on_Continue(self, _: ast.Continue) -> None:
        self.leave(self.loops[-1][0])

    def leave(self, label: str) -> None:
        """Jump, and begin a part that nothing leads to, for what is written after it."""
        self.code.goto(label)
        self.code.lines.append(f"{self.code.label()}:")

    def on_Return(self, node: ast.Return) -> None:
        if node.value is None:
            self.code.lines.append("  ret void")
        else:
            value = self.code.value(node.value)
            text = value.text if value.kind.text == self.result.text else self.code.as_number(value)
            self.code.lines.append(f"  ret {self.result.text} {text}")
        self.code.lines.append(f"{self.code.label()}:")


# ----------------------------------------------------------------------------------------------------------------------
# Library: translated functions compiled together, and records as they read them.
# ----------------------------------------------------------------------------------------------------------------------


class Library:
    """Machine code of translated functions."""

    def __init__(self, functions: tuple[Callable[..., Any], ...]) -> None:
        self.engine = machine_code(assembly(functions), optimised=True)
        self.functions = {function.__name__: function for function in functions}
        self.made: dict[str, Callable[..., Any]] = {}

    def address(self, name: str) -> int:
        """Return where a function begins.

        Args:
            name: Of the function.
        """
        return int(self.engine.get_function_address(name))

    def function(self, name: str) -> Callable[..., Any]:
        """Return a function to call with numbers and addresses.

        Args:
            name: Of the function.
        """
        if name not in self.made:
            by_kind = {ADDRESS: ctypes.c_void_p, NUMBER: ctypes.c_double, "void": None}
            kinds: list[Any] = [by_kind.get(kind.text, ctypes.c_int64) for kind in kinds_of(self.functions[name])]
            self.made[name] = ctypes.CFUNCTYPE(kinds.pop(), *kinds)(self.address(name))
        return self.made[name]


def library(*functions: Callable[..., Any]) -> Library:
    """Return functions compiled together, once in a process, whoever asks first: what runs must not be let go.

    Args:
        functions: In the part of Python that `statements` knows.
    """
    with _LOCK:
        return _library(functions)


_library, _LOCK = cache(Library), Lock()


def packed(record: NamedTuple) -> Ints:
    """Return a record as translated functions read it, eight bytes a field: numbers, and addresses of arrays.

    Args:
        record: Whose arrays must live as long as it is read.
    """
    return np.array([_number(field) for field in record], dtype=np.int64)


def _number(field: Any) -> int:
    if isinstance(field, np.ndarray):
        return int(field.__array_interface__["data"][0])
    return struct.unpack("q", struct.pack("d", field))[0] if isinstance(field, float) else field  # type: ignore[no-any-return]


class Room:
    """A record whose arrays stand behind it in one piece of memory, so that it is had anew by one copy."""

    def __init__(self, record: NamedTuple) -> None:
        self.shapes, image, place = dict[str, tuple[slice, Any, tuple[int, ...]]](), [], len(record)
        for name, field in record._asdict().items():
            if isinstance(field, np.ndarray):
                self.shapes[name] = slice(place, place + field.size), field.dtype, field.shape
                image.append(np.ravel(field).view(np.int64))
                place += field.size
        head = [8 * self.shapes[name][0].start if name in self.shapes else _number(field)
                for name, field in record._asdict().items()]  # fmt: skip
        self.image = np.concatenate([np.array(head, dtype=np.int64), *image])
        self.pointers = np.array([place for place, name in enumerate(record._fields) if name in self.shapes])

    def fresh(self) -> Held:
        """Return the record anew, its arrays as they were given."""
        return Held(self)


class Held:
    """A record in one piece of memory; its arrays are looked at by name."""

    def __init__(self, room: Room) -> None:
        self.shapes, self.memory = room.shapes, room.image.copy()
        self.place = address(self.memory)
        self.memory[room.pointers] += self.place

    def __getattr__(self, name: str) -> Any:
        """Return one of the arrays."""
        place, kind, shape = self.shapes[name]
        array = self.memory[place].view(kind).reshape(shape)
        setattr(self, name, array)
        return array
