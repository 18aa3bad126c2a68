"""Values of many designs in lanes, one lane for each design of a batch, and their arithmetic."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

# ----------------------------------------------------------------------------------------------------------------------
# What is computed with numbers in lanes, on their arrays: exact operations at once, all others lane by lane.
# ----------------------------------------------------------------------------------------------------------------------


Function = Callable[..., Any]
SEQUENTIAL = 8
"""Entries below which numpy sums one after the other [-]."""
_NUMBERS = (float, int, bool)


class Diverged(Exception):
    """Lanes part here: each goes the way of its label."""

    def __init__(self, labels: Any) -> None:
        super().__init__("lanes part")
        self.labels = labels


class Unsupported(TypeError):
    """What lanes cannot do: each design has to be computed by itself."""


class InLanes:
    """Values with one entry for each lane along the first axis, or one for all."""

    __slots__ = ("data",)

    def __init__(self, data: Any) -> None:
        self.data = data


def data_of(values: Any) -> Any:
    """Return a number or an array with an axis of lanes.

    Args:
        values: In lanes or not.
    """
    return values.data if isinstance(values, InLanes) else np.asarray(values)[None]


def is_numeric(value: Any) -> bool:
    """Tell whether something can be computed with.

    Args:
        value: Anything.
    """
    return isinstance(value, InLanes | np.ndarray | np.generic | float | int | complex)


def is_complex(value: Any) -> bool:
    """Tell whether numbers are complex.

    Args:
        value: A number or an array, in lanes or not.
    """
    if isinstance(value, InLanes):
        return bool(value.data.dtype.kind == "c")
    return bool(np.iscomplexobj(value))


def is_number(value: Any) -> bool:
    """Tell whether it is one number in every lane.

    Args:
        value: A number or an array, in lanes or not.
    """
    return bool(value.data.ndim == 1 if isinstance(value, InLanes) else np.ndim(value) == 0)


def aligned(*values: Any) -> list[Any]:
    """Return the arrays of operands with axes that stand below each other.

    Args:
        values: Lanes, arrays and numbers.
    """
    axes = max(value.data.ndim if isinstance(value, InLanes) else np.ndim(value) + 1 for value in values)
    made = list[Any]()
    for value in values:
        if isinstance(value, InLanes):
            data = value.data
            missing = axes - data.ndim
            made.append(data.reshape(len(data), *(1,) * missing, *data.shape[1:]) if missing else data)
        else:
            made.append(np.asarray(value)[None] if np.ndim(value) else value)
    return made


def exact(function: Function, one: Any, other: Any) -> Any:
    """Return what an operation gives that is the same for numbers and arrays.

    Args:
        function: Of two operands.
        one: First.
        other: Second; of both one is in lanes.
    """
    if isinstance(one, InLanes):
        if isinstance(other, InLanes):
            if one.data.ndim == other.data.ndim:
                return function(one.data, other.data)
        elif type(other) in _NUMBERS:
            return function(one.data, other)
    elif type(one) in _NUMBERS:
        return function(one, other.data)
    if not (is_numeric(one) and is_numeric(other)):
        return NotImplemented
    return function(*aligned(one, other))


def product(function: Function, one: Any, other: Any) -> Any:
    """Return a product; a complex one is not the same for numbers and arrays.

    Args:
        function: Of two operands.
        one: First.
        other: Second; of both one is in lanes.
    """
    if is_numeric(one) and is_numeric(other) and (is_complex(one) or is_complex(other)):
        return (each if is_number(one) and is_number(other) else per_lane)(function, one, other)
    return exact(function, one, other)


def quotient(function: Function, one: Any, other: Any) -> Any:
    """Return a quotient; lanes that would divide by zero part from the others.

    Args:
        function: Of two operands.
        one: First.
        other: Second; of both one is in lanes.
    """
    if isinstance(other, InLanes) and other.data.ndim == 1:
        zero = other.data == 0
        if zero.any():
            raise Unsupported("a division by zero") if zero.all() else Diverged(zero)
    elif type(other) in _NUMBERS and other == 0:
        raise Unsupported("a division by zero")
    return product(function, one, other)


def power(one: Any, other: Any) -> Any:
    """Return a power; numpy squares arrays exactly, and takes all others in its own way.

    Args:
        one: Base.
        other: Exponent; of both one is in lanes.
    """
    if not (is_numeric(one) and is_numeric(other)):
        return NotImplemented
    if is_number(one) and is_number(other):
        return _powers(one, other)
    if type(other) in (int, float) and other == 2 and not is_complex(one):
        return np.square(one.data)
    return _array_powers(one, other)


_SPECIAL = (-1.0, 0.0, 0.5, 1.0, 2.0)
"""Exponents for which numpy calls other functions of arrays."""


def _array_powers(one: Any, other: Any) -> Any:
    """Return powers of arrays of real numbers, entry by entry, over all lanes as over one long array."""
    base, exponent = (data_of(value).dtype.kind for value in (one, other))
    if base != "f" or exponent not in "fi":
        return per_lane(operator.pow, one, other)
    if is_number(other) and np.isin(data_of(other), _SPECIAL).any():
        return per_lane(operator.pow, one, other)
    if isinstance(other, InLanes):
        parts = np.broadcast_arrays(*aligned(one, other))
        return np.power(*(np.ascontiguousarray(part, dtype=float) for part in parts))
    return np.power(np.ascontiguousarray(one.data), np.asarray(other, dtype=float))


def _powers(one: Any, other: Any) -> Any:
    """Return powers of numbers; `float_power` calls the function that Python calls, which `power` does not."""
    base, exponent = (value.data if isinstance(value, InLanes) else np.asarray(value) for value in (one, other))
    if base.dtype != np.float64 or exponent.dtype.kind not in "fi" or not (base > 0.0).all():
        whole = base.dtype == np.float64 and exponent.dtype.kind in "fi" and (exponent >= 0).all()
        if not (whole and (exponent == np.floor(exponent)).all()):
            return each(operator.pow, one, other)
    found = np.float_power(base, exponent)
    return found if np.isfinite(found).all() else each(operator.pow, one, other)


def each(function: Function, *values: Any) -> Any:
    """Return what a function of numbers gives in every lane, by Python's own numbers.

    Args:
        function: Of numbers.
        values: Numbers, in lanes or not.
    """
    count = max(len(value.data) for value in values if isinstance(value, InLanes))
    if all(is_one(value.data) for value in values if isinstance(value, InLanes)):
        alone = function(*(value.data[0].item() if isinstance(value, InLanes) else value for value in values))
        return np.full(count, alone)
    columns = []
    for value in values:
        column = value.data.tolist() if isinstance(value, InLanes) else [value]
        columns.append(column if len(column) == count else column * count)
    return np.array(list(map(function, *columns)))


def is_one(data: Any) -> bool:
    """Tell whether all lanes have one number, bit for bit.

    Args:
        data: Numbers, shape (lanes,).
    """
    return data.ndim == 1 and (len(data) == 1 or data.tobytes() == data[:1].tobytes() * len(data))


def per_lane(function: Function, *values: Any) -> Any:
    """Return what a function of arrays gives in every lane, by numpy's own arrays.

    Args:
        function: Of arrays and numbers.
        values: Lanes, arrays and numbers.
    """
    count = max(len(value.data) for value in values if isinstance(value, InLanes))
    rows = [np.asarray(function(*(_lane(value, k) for value in values))) for k in range(count)]
    shapes = [str(row.shape) for row in rows]
    if len(set(shapes)) > 1:
        raise Diverged(np.array(shapes))
    return np.stack(rows)


def _lane(value: Any, k: int) -> Any:
    """Return what one lane holds."""
    if not isinstance(value, InLanes):
        return value
    own = value.data[k if len(value.data) > 1 else 0]
    return own.item() if own.ndim == 0 else own.copy(order="K")


def matmul(one: Any, other: Any) -> Any:
    """Return matrix products lane by lane, each by the call that numpy makes for one.

    Args:
        one: Array, in lanes or not.
        other: Array, in lanes or not.
    """
    first, second = data_of(one), data_of(other)
    if first.ndim == 3 and second.ndim == 2:
        return np.matmul(first, second[:, :, None])[:, :, 0]
    if first.ndim == 3 and second.ndim == 3:
        return np.matmul(first, second)
    return per_lane(operator.matmul, InLanes(first), InLanes(second))


def axes_of(data: Any, axis: int | None) -> Any:
    """Return the axes of an array in lanes that those of the array in each lane are.

    Args:
        data: With the axis of lanes.
        axis: Of the array in each lane; left out: all.
    """
    if axis is None:
        return tuple(range(1, data.ndim))
    return axis + 1 if axis >= 0 else axis


def summed(data: Any, axis: int | None, *, keepdims: bool = False) -> Any:
    """Return sums of entries, in the order in which numpy adds those of one array.

    Args:
        data: Arrays, with the axis of lanes.
        axis: Of the array in each lane; left out: all.
        keepdims: As numpy has it.
    """
    place = axes_of(data, axis)
    if axis is None or not 0 < data.shape[place] < SEQUENTIAL:
        return per_lane(lambda array: np.sum(array, axis=axis, keepdims=keepdims), InLanes(data))
    total = np.zeros_like(np.take(data, 0, axis=place))
    for k in range(data.shape[place]):
        total = total + np.take(data, k, axis=place)
    return np.expand_dims(total, place) if keepdims else total


def one_of(data: Any) -> Any:
    """Return the array that all lanes have, or part them by it.

    Args:
        data: Arrays, with the axis of lanes.
    """
    if (data != data[0]).any():
        raise Diverged(np.unique(data.reshape(len(data), -1), axis=0, return_inverse=True)[1].ravel())
    return data[0]


def looked_up(data: Any, entries: tuple[Any, ...]) -> Any:
    """Return the entries at places that differ from lane to lane.

    Args:
        data: Arrays, with the axis of lanes.
        entries: Places, in lanes or not.
    """
    if len(entries) == 1 and entries[0].data.dtype == np.bool_:
        return data[:, one_of(entries[0].data)]
    if not all(isinstance(entry, InLanes | int) for entry in entries):
        raise Unsupported("slices where lanes say")
    count = max(len(data), *(len(entry.data) for entry in entries if isinstance(entry, InLanes)))
    rows = np.arange(count) if len(data) > 1 else np.zeros(count, dtype=np.int64)
    places = [np.broadcast_to(entry.data, (count,)) if isinstance(entry, InLanes) else entry for entry in entries]
    return data[(rows, *places)]


# ----------------------------------------------------------------------------------------------------------------------
# A number, or an array of numbers, of every design of a batch at once: the lanes of one computation.
#
# Addition, multiplication, division, square roots and comparisons of arrays give the bits that Python's own give, and
# all else is computed lane by lane with Python's own functions (`work`). A truth that differs from lane to lane has no
# answer: `Diverged` says which lanes go which way, and who runs the computation splits them.
# ----------------------------------------------------------------------------------------------------------------------


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
