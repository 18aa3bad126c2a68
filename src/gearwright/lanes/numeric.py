"""Functions of numpy for arrays and for lanes of them: exact ones at once, all else lane by lane."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np

from gearwright.lanes import made
from gearwright.lanes.lanes import SEQUENTIAL, Lanes, Unsupported, aligned, axes_of, lanes_of, one_of, per_lane, summed
from gearwright.lanes.made import asarray, has_lanes

# ----------------------------------------------------------------------------------------------------------------------
# Linear algebra of matrices in lanes: by the same call for every one, alone or in numpy's own loop over them.
# ----------------------------------------------------------------------------------------------------------------------


def _norm(values: Any, axis: int | None = None, *, keepdims: bool = False) -> Any:
    """Return lengths."""
    if axis is None or _long(values, axis) or values.data.dtype.kind == "c":
        return Lanes(per_lane(lambda own: np.linalg.norm(own, axis=axis, keepdims=keepdims), values))
    return Lanes(np.sqrt(summed(np.square(values.data), axis, keepdims=keepdims)))


def _long(values: Any, axis: int) -> bool:
    return bool(values.data.shape[axis + 1 if axis >= 0 else axis] >= SEQUENTIAL)


def _stacked(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function of linear algebra that numpy loops over matrices."""

    def computed(*matrices: Any, **named: Any) -> Any:
        parts = [lanes_of(matrix).data for matrix in matrices]
        if len(parts) == 2 and parts[1].ndim == 2:
            return Lanes(function(parts[0], parts[1][:, :, None], **named)[:, :, 0])
        try:
            found = function(*parts, **named)
        except np.linalg.LinAlgError:
            return Lanes(per_lane(lambda *own: function(*own, **named), *(Lanes(part) for part in parts)))
        return type(found)(*(Lanes(part) for part in found)) if isinstance(found, tuple) else Lanes(found)

    return computed


def _unstacked(function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *values, **named: Lanes(per_lane(lambda *own: function(*own, **named), *values))


def _least_squares(matrix: Any, right: Any, *, rcond: Any = None) -> Any:
    """Return the least squares of every lane, with nothing of what numpy tells beside them."""
    found = per_lane(lambda own, wanted: np.linalg.lstsq(own, wanted, rcond=rcond)[0], lanes_of(matrix), right)
    return Lanes(found), None, None, None


_LINEAR: dict[str, Callable[..., Any]] = {
    "norm": _norm, "inv": _stacked(np.linalg.inv), "solve": _stacked(np.linalg.solve), "svd": _stacked(np.linalg.svd),
    "lstsq": _least_squares, "eigvals": _unstacked(np.linalg.eigvals), "matrix_rank": _unstacked(np.linalg.matrix_rank),
}  # fmt: skip


def _linear(name: str) -> Any:
    real, own = getattr(np.linalg, name), _LINEAR.get(name)
    if own is None:
        return real

    def computed(*values: Any, **named: Any) -> Any:
        if not has_lanes(values):
            return real(*values, **named)
        return own(*(asarray(value) if isinstance(value, list) else value for value in values), **named)

    return computed


linalg = SimpleNamespace(
    LinAlgError=np.linalg.LinAlgError,
    **{name: _linear(name) for name in ("norm", "inv", "solve", "svd", "eigvals", "matrix_rank", "lstsq")},
)


# ----------------------------------------------------------------------------------------------------------------------
# Functions of numpy for arrays and for lanes of them: exact ones at once, all else lane by lane.
# ----------------------------------------------------------------------------------------------------------------------


_EXACT = {
    "add", "subtract", "multiply", "divide", "true_divide", "negative", "absolute", "abs", "fabs", "sign", "sqrt",
    "square", "floor", "ceil", "trunc", "rint", "maximum", "minimum", "isfinite", "isnan", "isinf", "greater", "less",
    "greater_equal", "less_equal", "equal", "not_equal", "logical_and", "logical_or", "logical_not", "gcd",
    "clip", "cross",
}  # fmt: skip
"""Functions of arrays that give the same bits wherever an entry stands."""


def where(truth: Any, one: Any, other: Any) -> Any:
    """Return entries of one array where something is true, else of another.

    Args:
        truth: In lanes or not.
        one: First.
        other: Second.
    """
    return Lanes(np.where(*aligned(truth, one, other)))


def sum_(values: Any, axis: int | None = None, *, keepdims: bool = False) -> Any:
    """Return sums of entries.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
        keepdims: As numpy has it.
    """
    return Lanes(summed(asarray(values).data, axis, keepdims=keepdims))


def max_(values: Any, axis: int | None = None, **named: Any) -> Any:
    """Return the largest entries.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
        named: What else the function takes.
    """
    return asarray(values).max(axis, **named)


def min_(values: Any, axis: int | None = None, **named: Any) -> Any:
    """Return the least entries.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
        named: What else the function takes.
    """
    return asarray(values).min(axis, **named)


def any_(values: Any, axis: int | None = None) -> Any:
    """Tell where any entry is true.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
    """
    return asarray(values).any(axis)


def all_(values: Any, axis: int | None = None) -> Any:
    """Tell where all entries are true.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
    """
    return asarray(values).all(axis)


def count_nonzero(values: Any, axis: int | None = None) -> Any:
    """Return how many entries are not zero.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
    """
    data = lanes_of(values).data
    return Lanes(np.asarray(np.count_nonzero(data, axis=axes_of(data, axis))))


def argsort(values: Any, axis: int = -1, *, kind: Any = None) -> Any:
    """Return the order of entries, where it is one in all lanes; else lanes part by it.

    Args:
        values: One row in each lane.
        axis: The last.
        kind: As numpy has it.
    """
    return one_of(np.argsort(values.data, axis=axis, kind=kind))


def flatnonzero(values: Any) -> Any:
    """Return where entries are not zero, where it is one in all lanes; else lanes part by it.

    Args:
        values: In lanes.
    """
    return np.flatnonzero(one_of(values.data.reshape(len(values.data), -1) != 0))


def select(conditions: Any, choices: Any, default: Any = 0) -> Any:
    """Return entries of the array beside the first condition that is true.

    Args:
        conditions: In lanes or not.
        choices: One for each condition.
        default: Where none is true.
    """
    chosen = default
    for condition, choice in zip(reversed(conditions), reversed(choices), strict=True):
        chosen = where(condition, choice, chosen)
    return chosen


def argmax(values: Any, axis: int | None = None) -> Any:
    """Return the place of the largest entry.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
    """
    data = values.data
    return Lanes(np.argmax(data.reshape(len(data), -1) if axis is None else data, axis=1 if axis is None else axis + 1))


def argmin(values: Any, axis: int | None = None) -> Any:
    """Return the place of the least entry.

    Args:
        values: Numbers or an array, in lanes or not.
        axis: Of the array in each lane; left out: all.
    """
    data = values.data
    return Lanes(np.argmin(data.reshape(len(data), -1) if axis is None else data, axis=1 if axis is None else axis + 1))


def unravel_index(place: Any, shape: Any) -> Any:
    """Return the indices of a place.

    Args:
        place: Where, in lanes.
        shape: Of the array in each lane.
    """
    return tuple(Lanes(index) for index in np.unravel_index(place.data, shape))


def array_equal(one: Any, other: Any) -> Any:
    """Tell whether two arrays are the same.

    Args:
        one: First.
        other: Second.
    """
    first, second = lanes_of(one), lanes_of(other)
    return (first == second).all()


def broadcast_arrays(*values: Any) -> Any:
    """Return arrays of one shape.

    Args:
        values: Numbers or an array, in lanes or not.
    """
    parts = aligned(*(lanes_of(value) for value in values))
    shape = np.broadcast_shapes(*(part.shape[1:] for part in parts))
    return [Lanes(np.broadcast_to(part, (len(part), *shape))) for part in parts]


def ndim(value: Any) -> int:
    """Return how many axes there are.

    Args:
        value: A number, in lanes or not.
    """
    return int(value.ndim)


def size(value: Any) -> int:
    """Return how many entries there are.

    Args:
        value: A number, in lanes or not.
    """
    return int(value.size)


def shape(value: Any) -> tuple[int, ...]:
    """Return the shape.

    Args:
        value: A number, in lanes or not.
    """
    return tuple(value.shape)


def ravel(value: Any) -> Any:
    """Return all entries in one row.

    Args:
        value: A number, in lanes or not.
    """
    return value.ravel()


def isscalar(value: Any) -> bool:
    """Tell whether it is a number.

    Args:
        value: A number, in lanes or not.
    """
    return bool(value.ndim == 0)


def interp(place: Any, places: Any, values: Any) -> Any:
    """Return values between points; of points that are the same in all lanes once for each number that occurs.

    Args:
        place: Where, in lanes or not.
        places: Of the points.
        values: Numbers or an array, in lanes or not.
    """
    points = [asarray(part) if isinstance(part, list | tuple) else part for part in (places, values)]
    if any(type(part) is Lanes for part in points):
        return Lanes(per_lane(np.interp, place, *points))
    numbers, where_ = np.unique(place.data, return_inverse=True)
    found = np.array([np.interp(number, places, values) for number in numbers.tolist()])
    return Lanes(found[where_.reshape(place.data.shape)])


_ALONE = {"trapezoid", "mean", "cumsum", "diff", "searchsorted", "append", "geomspace"}
"""Functions of arrays that are called for the array of every lane."""
_SHAPED = ("broadcast_to", "linspace", "swapaxes")
_READY = {"zeros", "ones", "zeros_like", "ones_like", "full"}
"""What makes arrays that lanes are then written into."""
_ALWAYS = {name: getattr(made, name) for name in ("array", "asarray", *_READY)}
_BY_LANES = {
    **{name: globals()[f"{name}_"] for name in ("sum", "max", "min", "any", "all")},
    **{name: getattr(made, name) for name in ("stack", "concatenate", "vstack", "hstack", "full_like", *_SHAPED)},
    **{
        name: globals()[name]
        for name in (
            "where", "argmax", "argmin", "unravel_index", "array_equal",
            "broadcast_arrays", "count_nonzero", "select", "argsort", "flatnonzero",
            "ndim", "size", "shape", "ravel", "isscalar", "interp",
        )
    },
}  # fmt: skip


def _dispatched(name: str) -> Any:
    real, own = getattr(np, name), _BY_LANES.get(name)
    if isinstance(real, type) or not callable(real):
        return real
    if own is None:
        made_of = _elementwise if isinstance(real, np.ufunc) else _in_each if name in _ALONE else _refused
        own = _exactly(real) if name in _EXACT else made_of(real)

    def computed(*values: Any, **named: Any) -> Any:
        for value in values:
            if type(value) is Lanes or (type(value) in (list, tuple) and has_lanes(value)):
                return own(*values, **named)
        return real(*values, **named)

    return computed


def _exactly(function: Any) -> Callable[..., Any]:
    def computed(*values: Any) -> Any:
        return Lanes(function(*aligned(*(asarray(v) if isinstance(v, list | tuple) else v for v in values))))

    return computed


def _elementwise(function: Any) -> Callable[..., Any]:
    """Return a function of arrays entry by entry, over all lanes as over one long array."""

    def computed(*values: Any) -> Any:
        parts = np.broadcast_arrays(*aligned(*(asarray(v) if isinstance(v, list | tuple) else v for v in values)))
        return Lanes(function(*(np.ascontiguousarray(part) for part in parts)))

    return computed


def _in_each(function: Any) -> Callable[..., Any]:
    """Return a function of arrays that is called for the array of every lane."""

    def computed(*values: Any, **named: Any) -> Any:
        parts = (asarray(value) if isinstance(value, list | tuple) else value for value in values)
        return Lanes(per_lane(partial(function, **named), *parts))

    return computed


def _refused(function: Any) -> Callable[..., Any]:
    def computed(*values: Any, **named: Any) -> Any:
        raise Unsupported(f"numpy.{function.__name__} of lanes")

    return computed


class _Module:
    """What twins import as numpy."""

    linalg = linalg

    def __getattr__(self, name: str) -> Any:
        found = _ALWAYS[name] if name in _ALWAYS else _dispatched(name)
        setattr(self, name, found)
        return found


numpy: Any = _Module()
