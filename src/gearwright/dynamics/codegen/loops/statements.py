"""Statements: functions of translated Python as LLVM assembly, every local number in memory until LLVM moves it."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from gearwright.dynamics.codegen.loops.expressions import DECLARATIONS, Expressions
from gearwright.dynamics.codegen.loops.words import ADDRESS, KINDS, Kind

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
