"""A number, or an array of numbers, of every design of a batch at once: the lanes of one computation.

Addition, multiplication, division, square roots and comparisons of arrays give the bits that Python's own give, and
all else is computed lane by lane with Python's own functions (`work`). A truth that differs from lane to lane has no
answer: `Diverged` says which lanes go which way, and who runs the computation splits them.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from typing import Any

import numpy as np

from gearwright.lanes.work import (
    Diverged,
    InLanes,
    Unsupported,
    axes_of,
    data_of,
    each,
    exact,
    looked_up,
    matmul,
    power,
    product,
    quotient,
    summed,
)


class Lanes(InLanes):
    """One value for each lane; the first axis of the data, which is one long where all lanes have the same."""

    __slots__ = ()
    __array_priority__ = 1000.0
    __array_ufunc__ = None  # of an array and lanes, lanes compute

    # what a number, or an array, is

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the array in each lane."""
        return tuple(self.data.shape[1:])

    @property
    def ndim(self) -> int:
        """Axes of the array in each lane."""
        return int(self.data.ndim - 1)

    @property
    def size(self) -> int:
        """Entries of the array in each lane."""
        return int(np.prod(self.shape))

    @property
    def dtype(self) -> Any:
        """Of the entries."""
        return self.data.dtype

    def __len__(self) -> int:
        if self.data.ndim == 1:
            raise TypeError("a number has no length")
        return int(self.data.shape[1])

    def __iter__(self) -> Iterator[Lanes]:
        if self.data.ndim == 1:
            raise TypeError("a number has no entries")
        return (Lanes(self.data[:, k]) for k in range(self.data.shape[1]))

    def __repr__(self) -> str:
        return f"Lanes({self.data!r})"

    def __format__(self, spec: str) -> str:
        return "…"  # words are for one design alone

    def __hash__(self) -> int:
        return id(self)

    # truths

    def __bool__(self) -> bool:
        data = self.data
        if data.ndim > 1 and data[0].size == 1:
            data = data.reshape(len(data))
        if data.ndim > 1:
            raise ValueError("the truth of an array of more than one entry is none")
        truths = data if data.dtype == np.bool_ else data != 0
        if truths.all():
            return True
        if not truths.any():
            return False
        raise Diverged(truths)

    def only(self) -> Any:
        """Return the one value that all lanes have, or part them by it."""
        data = self.data
        if data.ndim > 1:
            raise Unsupported("an array is no number")
        if len(data) == 1 or bool((data == data[0]).all()):
            return data[0].item()
        raise Diverged(data)

    def __index__(self) -> int:
        if self.data.dtype.kind not in "iu":
            raise TypeError("no whole number")
        return int(self.only())

    def __int__(self) -> int:
        raise Unsupported("int() of lanes outside of their functions")

    def __float__(self) -> float:
        raise Unsupported("float() of lanes outside of their functions")

    def __complex__(self) -> complex:
        raise Unsupported("complex() of lanes outside of their functions")

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise Unsupported("an array of lanes outside of their functions")

    # arithmetic

    def __add__(self, other: Any) -> Any:
        return _made(exact(operator.add, self, other))

    def __radd__(self, other: Any) -> Any:
        return _made(exact(operator.add, other, self))

    def __sub__(self, other: Any) -> Any:
        return _made(exact(operator.sub, self, other))

    def __rsub__(self, other: Any) -> Any:
        return _made(exact(operator.sub, other, self))

    def __mul__(self, other: Any) -> Any:
        return _made(product(operator.mul, self, other))

    def __rmul__(self, other: Any) -> Any:
        return _made(product(operator.mul, other, self))

    def __truediv__(self, other: Any) -> Any:
        return _made(quotient(operator.truediv, self, other))

    def __rtruediv__(self, other: Any) -> Any:
        return _made(quotient(operator.truediv, other, self))

    def __floordiv__(self, other: Any) -> Any:
        return _made(quotient(operator.floordiv, self, other))

    def __rfloordiv__(self, other: Any) -> Any:
        return _made(quotient(operator.floordiv, other, self))

    def __mod__(self, other: Any) -> Any:
        return _made(quotient(operator.mod, self, other))

    def __rmod__(self, other: Any) -> Any:
        return _made(quotient(operator.mod, other, self))

    def __pow__(self, other: Any) -> Any:
        return _made(power(self, other))

    def __rpow__(self, other: Any) -> Any:
        return _made(power(other, self))

    def __matmul__(self, other: Any) -> Any:
        return Lanes(matmul(self, other))

    def __rmatmul__(self, other: Any) -> Any:
        return Lanes(matmul(other, self))

    def __neg__(self) -> Lanes:
        return Lanes(-self.data)

    def __pos__(self) -> Lanes:
        return self

    def __abs__(self) -> Lanes:
        if self.data.dtype.kind == "c":
            return Lanes(each(abs, self))
        return Lanes(np.abs(self.data))

    def __invert__(self) -> Lanes:
        return Lanes(~self.data)

    def __and__(self, other: Any) -> Any:
        return _made(exact(operator.and_, self, other))

    def __rand__(self, other: Any) -> Any:
        return _made(exact(operator.and_, other, self))

    def __or__(self, other: Any) -> Any:
        return _made(exact(operator.or_, self, other))

    def __ror__(self, other: Any) -> Any:
        return _made(exact(operator.or_, other, self))

    def __round__(self, digits: int | None = None) -> Lanes:
        return Lanes(each(lambda value: round(value, digits), self))

    # comparisons

    def __lt__(self, other: Any) -> Any:
        return _made(exact(operator.lt, self, other))

    def __le__(self, other: Any) -> Any:
        return _made(exact(operator.le, self, other))

    def __gt__(self, other: Any) -> Any:
        return _made(exact(operator.gt, self, other))

    def __ge__(self, other: Any) -> Any:
        return _made(exact(operator.ge, self, other))

    def __eq__(self, other: Any) -> Any:
        if other is None or isinstance(other, str):
            return False
        return _made(exact(operator.eq, self, other))

    def __ne__(self, other: Any) -> Any:
        if other is None or isinstance(other, str):
            return True
        return _made(exact(operator.ne, self, other))

    # numbers

    @property
    def real(self) -> Lanes:
        """Real part."""
        return Lanes(self.data.real)

    @property
    def imag(self) -> Lanes:
        """Imaginary part."""
        return Lanes(self.data.imag)

    def conjugate(self) -> Lanes:
        """Return the conjugate."""
        return Lanes(self.data.conjugate())

    conj = conjugate

    def is_integer(self) -> Lanes:
        """Tell whether it is a whole number."""
        return Lanes(self.data == np.floor(self.data))

    def item(self) -> Lanes:
        """Return an array of one entry as a number."""
        return Lanes(self.data.reshape(len(self.data)))

    # arrays

    def __getitem__(self, index: Any) -> Any:
        entries = index if isinstance(index, tuple) else (index,)
        if any(isinstance(entry, Lanes) for entry in entries):
            return Lanes(looked_up(self.data, entries))
        return Lanes(self.data[(slice(None), *entries)])

    def __setitem__(self, index: Any, value: Any) -> None:
        entries = index if isinstance(index, tuple) else (index,)
        if any(isinstance(entry, Lanes) for entry in entries):
            raise Unsupported("writing where lanes say")
        given = value.data if isinstance(value, Lanes) else np.asarray(value)[None]
        count = max(len(self.data), len(given))
        if len(self.data) < count:
            self.data = np.repeat(self.data, count, axis=0)
        if given.dtype.kind == "c" and self.data.dtype.kind != "c":
            raise Unsupported("a complex number in an array of real ones")
        target = self.data[(slice(None), *entries)]
        missing = target.ndim - given.ndim
        if missing > 0:
            given = given.reshape(len(given), *(1,) * missing, *given.shape[1:])
        self.data[(slice(None), *entries)] = given

    @property
    def T(self) -> Lanes:
        """Transposed."""
        return Lanes(self.data.transpose(0, *range(self.data.ndim - 1, 0, -1)))

    def tolist(self) -> Any:
        """Return nested lists of numbers."""
        if self.data.ndim == 1:
            return self
        return [entry.tolist() for entry in self]

    def copy(self) -> Lanes:
        """Return a copy."""
        return Lanes(self.data.copy(order="K"))

    def astype(self, kind: Any) -> Lanes:
        """Return the same as another kind of number."""
        return Lanes(self.data.astype(kind))

    def ravel(self) -> Lanes:
        """Return all entries in one row."""
        return Lanes(self.data.reshape(len(self.data), -1))

    def reshape(self, *shape: int) -> Lanes:
        """Return the entries in another shape."""
        return Lanes(self.data.reshape(len(self.data), *shape))

    def repeat(self, times: int) -> Lanes:
        """Return the entries of a row, each several times."""
        return Lanes(self.data.reshape(len(self.data), -1).repeat(times, axis=1))

    def cumsum(self, axis: int) -> Lanes:
        """Return sums up to every entry."""
        return Lanes(self.data.cumsum(axis=axes_of(self.data, axis)))

    def max(self, axis: int | None = None, *, initial: Any = None, keepdims: bool = False) -> Lanes:
        """Return the largest entries."""
        return _extreme(np.max, self, axis, initial, keepdims=keepdims)

    def min(self, axis: int | None = None, *, initial: Any = None, keepdims: bool = False) -> Lanes:
        """Return the least entries."""
        return _extreme(np.min, self, axis, initial, keepdims=keepdims)

    def sum(self, axis: int | None = None, *, keepdims: bool = False) -> Lanes:
        """Return sums of entries."""
        return Lanes(summed(self.data, axis, keepdims=keepdims))

    def any(self, axis: int | None = None) -> Lanes:
        """Tell where any entry is true."""
        return Lanes(np.any(self.data, axis=axes_of(self.data, axis)))

    def all(self, axis: int | None = None) -> Lanes:
        """Tell where all entries are true."""
        return Lanes(np.all(self.data, axis=axes_of(self.data, axis)))


def _made(data: Any) -> Any:
    return data if data is NotImplemented else Lanes(data)


def _extreme(function: Any, values: Lanes, axis: int | None, initial: Any, *, keepdims: bool) -> Lanes:
    if values.data.ndim == 1:
        return values
    more = {} if initial is None else {"initial": initial}
    return Lanes(function(values.data, axis=axes_of(values.data, axis), keepdims=keepdims, **more))


def lanes_of(values: Any) -> Lanes:
    """Return a number or an array as lanes of the same.

    Args:
        values: Lanes stay as they are.
    """
    return values if isinstance(values, Lanes) else Lanes(data_of(values))
