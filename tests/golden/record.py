"""What is remembered of a sizing and of its assembled system.

``PYTHONPATH=tests python tests/golden/record.py`` writes it anew.
"""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from variants import VARIANTS

from gearwright.checks import Check
from gearwright.dynamics import System
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import critical_speeds
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import Sizing, passing, size
from gearwright.spec import Design, parse, read

FOLDER = Path(__file__).parent / "sizing"
TOLERANCE = {"rel": 1e-9, "why": "rounding differs between linear algebra libraries; no rule of sizing moves less"}
PARTS = ("gears", "meshes", "shafts", "carriers", "machines", "built_shafts", "bearings", "joints")


def numbers(value: Any, path: str = "") -> dict[str, float]:
    """Return every number inside records, mappings and named rows by its dotted path; no words, no truth values."""
    if value is None or isinstance(value, bool | str | Enum):
        return {}
    if isinstance(value, int | float):
        return {path: value} if math.isfinite(value) else {}
    if is_dataclass(value):
        inner = {field.name: getattr(value, field.name) for field in fields(value)}
    elif isinstance(value, dict):
        inner = value
    else:
        inner = {getattr(member, "name", getattr(member, "stage", str(k))): member for k, member in enumerate(value)}
    found: dict[str, float] = {}
    for name, member in inner.items():
        found |= numbers(member, f"{path}.{name}" if path else str(name))
    return found


def recorded(sizing: Sizing, *, shaken: bool = True) -> dict[str, float]:
    """Return what is remembered of a sizing: teeth, every part and check, the powers and speeds of every case.

    Args:
        sizing: As sized.
        shaken: Whether its critical speeds are, too, which take as long as all else.
    """
    parts: dict[str, Any] = {"teeth": dict(sizing.teeth), **{name: getattr(sizing, name) for name in PARTS}}
    parts["checks"] = {
        name: {"value": check.value, "limit": check.limit} for name, check in identified(sizing.checks).items()
    }
    parts["cases"] = {
        case: {"powers": dict(flow.machine_powers), "speeds": dict(flow.speeds)} for case, flow in sizing.flows.items()
    }
    return {**numbers(parts), **_assembled(assemble(sizing)), **_answered(sizing, shaken=shaken)}


def identified(checks: Iterable[Check]) -> dict[str, Check]:
    """Return checks by who they are: mode, part, place and case; equal ones, as of two meshes, are counted.

    Args:
        checks: Of a sizing, the worst first.
    """
    found, met = dict[str, Check](), Counter[str]()
    for check in checks:
        name = f"{check.mode}.{', '.join(filter(None, (str(check.part), check.place, check.case)))}"
        met[name] += 1
        found[name if met[name] == 1 else f"{name} #{met[name]}"] = check
    return found


def _answered(sizing: Sizing, *, shaken: bool) -> dict[str, float]:
    """Return the numbers of answers that have too many of them to be kept: how many, and two sums of each kind."""
    speeds = critical_speeds(sizing) if shaken else ()
    answers = {
        "critical speeds": [(case.critical, case.assumed) for case in speeds],
        "passing": passing(sizing),
    }
    kinds: dict[str, list[float]] = {}
    for name, answer in answers.items():
        for path, number in numbers(tuple(answer), name).items():
            kinds.setdefault(f"{name}.{path.rpartition('.')[2]}", []).append(float(number))
    return {f"answers.{kind}.{what}": value for kind, each in kinds.items() for what, value in _sums(each).items()}


def _sums(values: list[float]) -> dict[str, float]:
    """Return count, sum of sizes, and a sum with weights of its own for every place: the least first, for ties."""
    weights = np.cos(np.arange(len(values)))
    size = float(np.sum(np.abs(values)))
    return {"count": len(values), "size": size, "order": float(weights @ np.sort(values)) / size if size else 0.0}


def _assembled(system: System) -> dict[str, float]:
    """Return the size of every array of a system, and a number in -1 to 1 that notices signs and places."""
    sums = {}
    for name, array in _arrays(system.arrays, ""):
        if (size := float(np.sum(np.abs(array)))) and math.isfinite(size):
            weight = np.cos(np.arange(array.size))
            sums |= {f"arrays.{name}.size": size, f"arrays.{name}.order": float(weight @ array.ravel()) / size}
    return sums


def _arrays(record: Any, path: str) -> Iterator[tuple[str, Any]]:
    for name in record._fields:
        value = getattr(record, name)
        if isinstance(value, np.ndarray):
            yield f"{path}{name}", value
        elif hasattr(value, "_fields"):
            yield from _arrays(value, f"{path}{name}.")


@cache
def designs() -> dict[str, Design]:
    """Return every shipped design, and those with the options that no shipped one has."""
    shipped = {name: read(shipped_design(name)) for name in shipped_designs()}
    return shipped | {f"variant-{name}": parse(text) for name, text in VARIANTS.items()}


@cache
def sized(name: str) -> Sizing:
    """Return one of the designs, sized; once for all golden files."""
    return size(designs()[name])


NOISE = 1e-6
"""Speeds [rad/s], powers [W] and, in diagrams, forces [N] and moments [N m] below this are zeros with rounding."""
CLOSING = ("cases.", ".diagram.", ".bearings.", ".bending_moment", ".tangential_force")
"""What closes to zero by subtraction."""
ORDER = 1e-9
"""What sums of unlike signs may differ by, over the sum of their sizes [-]."""


def noise(path: str) -> float:
    """Return up to where a number is a zero with rounding."""
    if path.startswith("arrays."):
        return ORDER
    if path.startswith("answers."):
        return 1e-6
    return NOISE if any(part in path for part in CLOSING) else 0.0


def same(path: str, was: float, is_now: float) -> bool:
    """Tell whether a number is what it was, but for rounding."""
    return math.isclose(was, is_now, rel_tol=TOLERANCE["rel"], abs_tol=noise(path))


def write_all() -> None:
    """Write the file of every design; what is the same but for rounding stays as it was written."""
    FOLDER.mkdir(exist_ok=True)
    for name in designs():
        path = FOLDER / f"{name}.json"
        stored = json.loads(path.read_text(encoding="utf-8"))["values"] if path.exists() else {}
        found = recorded(sized(name))
        kept = {key: was if same(key, was, found[key]) else found[key] for key, was in stored.items() if key in found}
        values = kept | {key: value for key, value in found.items() if key not in kept}
        content = {"design": name, "tolerance": TOLERANCE, "values": values}
        path.write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    write_all()
