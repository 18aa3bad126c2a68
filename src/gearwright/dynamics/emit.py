"""Emitter: a few words of LLVM assembly, for numbers alone (one trajectory) or side by side (lanes).

Only what the generated right-hand side needs: loads, stores, sums, products, the larger and smaller of two.
"""

from __future__ import annotations

FLAGS = "contract nsz"
"""Products and sums may fuse; the sign of zero does not matter. Nothing else may change."""


class Emitter:
    """Writes the body of one function of straight-line code."""

    def __init__(self, lanes: int) -> None:
        self.lanes = lanes
        self.type = "double" if lanes == 1 else f"<{lanes} x double>"
        self.lines: list[str] = []
        self.count = 0
        self.zero = "0.0" if lanes == 1 else "zeroinitializer"

    def value(self, text: str) -> str:
        """Write an instruction and return the name of its result.

        Args:
            text: Right-hand side of the assignment.
        """
        name = f"%v{self.count}"
        self.count += 1
        self.lines.append(f"  {name} = {text}")
        return name

    def at(self, pointer: str, index: int, *, lanes: int | None = None) -> str:
        """Return the address of an entry.

        Args:
            pointer: Base address.
            index: Entry.
            lanes: Width of the array's entries; by default the emitter's.
        """
        offset = index * (self.lanes if lanes is None else lanes)
        return self.value(f"getelementptr double, ptr {pointer}, i64 {offset}")

    def load(self, pointer: str, index: int) -> str:
        """Load an entry of an array that is as wide as the lanes.

        Args:
            pointer: Base address.
            index: Entry.
        """
        return self.value(f"load {self.type}, ptr {self.at(pointer, index)}, align 8")

    def spread(self, pointer: str, index: int) -> str:
        """Load an entry of an array of single numbers, the same for all lanes.

        Args:
            pointer: Base address.
            index: Entry.
        """
        number = self.value(f"load double, ptr {self.at(pointer, index, lanes=1)}, align 8")
        if self.lanes == 1:
            return number
        first = self.value(f"insertelement {self.type} poison, double {number}, i64 0")
        mask = f"<{self.lanes} x i32> zeroinitializer"
        return self.value(f"shufflevector {self.type} {first}, {self.type} poison, {mask}")

    def store(self, value: str, pointer: str, index: int) -> None:
        """Store an entry of an array that is as wide as the lanes.

        Args:
            value: What to store.
            pointer: Base address.
            index: Entry.
        """
        self.lines.append(f"  store {self.type} {value}, ptr {self.at(pointer, index)}, align 8")

    def add(self, a: str, b: str) -> str:
        """Return a + b; a zero is dropped."""
        if self.zero in (a, b):
            return b if a == self.zero else a
        return self.value(f"fadd {FLAGS} {self.type} {a}, {b}")

    def subtract(self, a: str, b: str) -> str:
        """Return a − b; a zero b is dropped."""
        return a if b == self.zero else self.value(f"fsub {FLAGS} {self.type} {a}, {b}")

    def multiply(self, a: str, b: str) -> str:
        """Return a b; a zero stays one."""
        return self.zero if self.zero in (a, b) else self.value(f"fmul {FLAGS} {self.type} {a}, {b}")

    def larger(self, a: str, b: str) -> str:
        """Return the larger of two; the first if either is not a number."""
        return self._chosen("ugt", a, b)

    def smaller(self, a: str, b: str) -> str:
        """Return the smaller of two; the first if either is not a number."""
        return self._chosen("ult", a, b)

    def _chosen(self, relation: str, a: str, b: str) -> str:
        truth = "i1" if self.lanes == 1 else f"<{self.lanes} x i1>"
        mask = self.value(f"fcmp {relation} {self.type} {a}, {b}")
        return self.value(f"select {truth} {mask}, {self.type} {a}, {self.type} {b}")

    def size(self, a: str) -> str:
        """Return |a|."""
        suffix = "f64" if self.lanes == 1 else f"v{self.lanes}f64"
        return self.value(f"call {self.type} @llvm.fabs.{suffix}({self.type} {a})")
