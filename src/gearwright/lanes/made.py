"""Arrays made of numbers and of others, in lanes where any of them are."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwright.lanes.lanes import Lanes, aligned, lanes_of


def has_lanes(values: Any) -> bool:
    """Tell whether lanes are among values, or in lists among them.

    Args:
        values: Arguments.
    """
    return any(type(value) is Lanes or (type(value) in (list, tuple) and has_lanes(value)) for value in values)


def array(content: Any, dtype: Any = None) -> Any:
    """Return numbers as an array.

    Args:
        content: Numbers, in lists or not.
        dtype: As numpy has it.
    """
    if type(content) is Lanes:
        return content if dtype is None else content.astype(dtype)
    if not isinstance(content, list | tuple) or not has_lanes(content):
        return np.array(content, dtype=dtype)
    entries = [array(entry) if isinstance(entry, list | tuple) else entry for entry in content]
    made = stack(entries)
    return made if dtype is None else made.astype(dtype)


def asarray(content: Any, dtype: Any = None) -> Any:
    """Return numbers as an array.

    Args:
        content: Numbers, in lists or not.
        dtype: As numpy has it.
    """
    if type(content) is not Lanes and not (isinstance(content, list | tuple) and has_lanes(content)):
        return np.asarray(content, dtype=dtype)
    return array(content, dtype)


def stack(entries: Any, axis: int = 0) -> Any:
    """Return arrays as entries of one.

    Args:
        entries: Arrays, in lanes or not.
        axis: Of the array in each lane; left out: all.
    """
    parts = [lanes_of(entry).data for entry in entries]
    count = max(len(part) for part in parts)
    whole = [np.broadcast_to(part, (count, *part.shape[1:])) for part in parts]
    return Lanes(np.stack(whole, axis=axis + 1 if axis >= 0 else axis))


def concatenate(entries: Any, axis: int = 0) -> Any:
    """Return arrays one after the other.

    Args:
        entries: Arrays, in lanes or not.
        axis: Of the array in each lane; left out: all.
    """
    parts = [lanes_of(entry).data for entry in entries]
    count = max(len(part) for part in parts)
    whole = [np.broadcast_to(part, (count, *part.shape[1:])) for part in parts]
    return Lanes(np.concatenate(whole, axis=axis + 1 if axis >= 0 else axis))


def vstack(entries: Any) -> Any:
    """Return arrays below each other.

    Args:
        entries: Arrays, in lanes or not.
    """
    rows = [lanes_of(entry) for entry in entries]
    return concatenate([Lanes(row.data[:, None]) if row.data.ndim == 2 else row for row in rows])


def hstack(entries: Any) -> Any:
    """Return arrays beside each other.

    Args:
        entries: Arrays, in lanes or not.
    """
    parts = [lanes_of(entry) for entry in entries]
    return concatenate(parts, axis=0 if parts[0].data.ndim == 2 else 1)


def zeros(shape: Any, dtype: Any = float) -> Any:
    """Return zeros, ready for lanes.

    Args:
        shape: Of the array in each lane.
        dtype: As numpy has it.
    """
    return Lanes(np.zeros((1, *(shape if isinstance(shape, tuple) else (shape,))), dtype))


def ones(shape: Any, dtype: Any = float) -> Any:
    """Return ones, ready for lanes.

    Args:
        shape: Of the array in each lane.
        dtype: As numpy has it.
    """
    return Lanes(np.ones((1, *(shape if isinstance(shape, tuple) else (shape,))), dtype))


def zeros_like(values: Any, dtype: Any = None) -> Any:
    """Return zeros, ready for lanes.

    Args:
        values: Numbers or an array, in lanes or not.
        dtype: As numpy has it.
    """
    data = lanes_of(values).data
    return Lanes(np.zeros((1, *data.shape[1:]), dtype or data.dtype))


def full(shape: Any, value: Any, dtype: Any = None) -> Any:
    """Return an array of one value.

    Args:
        shape: Of the array in each lane.
        value: A number, in lanes or not.
        dtype: As numpy has it.
    """
    own = shape if isinstance(shape, tuple) else (shape,)
    data = lanes_of(value).data
    return Lanes(np.broadcast_to(data.reshape(len(data), *(1,) * len(own)), (len(data), *own)).copy())


def ones_like(values: Any, dtype: Any = None) -> Any:
    """Return ones, ready for lanes.

    Args:
        values: Numbers or an array, in lanes or not.
        dtype: As numpy has it.
    """
    data = lanes_of(values).data
    return Lanes(np.ones((1, *data.shape[1:]), dtype or data.dtype))


def full_like(values: Any, value: Any, dtype: Any = None) -> Any:
    """Return an array of one value in the shape of another.

    Args:
        values: Numbers or an array, in lanes or not.
        value: A number, in lanes or not.
        dtype: As numpy has it.
    """
    return full(lanes_of(values).data.shape[1:], value, dtype)


def broadcast_to(value: Any, shape: Any) -> Any:
    """Return an array in a larger shape.

    Args:
        value: Numbers or an array, in lanes or not.
        shape: Of the array in each lane.
    """
    data, shape = lanes_of(value).data, (shape,) if isinstance(shape, int) else shape
    missing = (1,) * (len(shape) - (data.ndim - 1))
    return Lanes(np.broadcast_to(data.reshape(len(data), *missing, *data.shape[1:]), (len(data), *shape)))


def linspace(start: Any, stop: Any, num: int = 50) -> Any:
    """Return places at equal distances.

    Args:
        start: First of them, in lanes or not.
        stop: Last of them, in lanes or not.
        num: How many.
    """
    first, last = (np.asarray(end, dtype=float) for end in np.broadcast_arrays(*aligned(start, stop)))
    if (first == last).any():  # which numpy divides in another order, in all rows of an array
        ends = zip(first.tolist(), last.tolist(), strict=True)
        return Lanes(np.stack([np.linspace(*pair, num) for pair in ends]))
    return Lanes(np.linspace(first, last, num, axis=-1))


def swapaxes(value: Any, first: int, second: int) -> Any:
    """Return an array with two axes interchanged.

    Args:
        value: In lanes.
        first: One of them, from the front.
        second: The other.
    """
    return Lanes(np.swapaxes(lanes_of(value).data, first + 1, second + 1))
