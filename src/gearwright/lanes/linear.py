"""Linear algebra of matrices in lanes: by the same call for every one, alone or in numpy's own loop over them."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np

from gearwright.lanes.lanes import SEQUENTIAL, Lanes, lanes_of, per_lane, summed
from gearwright.lanes.made import asarray, has_lanes


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
