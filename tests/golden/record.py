"""What is remembered of a sizing, and where; ``python tests/golden/record.py`` writes all of it anew."""

from __future__ import annotations

import json
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import Sizing, size
from gearwright.spec import read

FOLDER = Path(__file__).parent / "sizing"
TOLERANCE = {"rel": 1e-9, "why": "rounding differs between linear algebra libraries; no rule of sizing moves less"}
PARTS = ("gears", "meshes", "shafts", "carriers", "machines")


def numbers(value: Any, path: str = "") -> dict[str, float]:
    """Return every number inside records, mappings and named rows by its dotted path; truth values are left out."""
    if isinstance(value, bool) or value is None or isinstance(value, str):
        return {}
    if isinstance(value, int | float):
        return {path: value}
    if is_dataclass(value):
        inner = {field.name: getattr(value, field.name) for field in fields(value)}
    elif isinstance(value, dict):
        inner = value
    else:
        inner = {getattr(each, "name", getattr(each, "stage", str(k))): each for k, each in enumerate(value)}
    found: dict[str, float] = {}
    for name, each in inner.items():
        found |= numbers(each, f"{path}.{name}" if path else str(name))
    return found


def recorded(sizing: Sizing) -> dict[str, float]:
    """Return what is remembered of a sizing: teeth, every part, and the powers and speeds of every case."""
    parts: dict[str, Any] = {"teeth": dict(sizing.teeth), **{name: getattr(sizing, name) for name in PARTS}}
    parts["cases"] = {
        case: {"powers": dict(flow.machine_powers), "speeds": dict(flow.speeds)} for case, flow in sizing.flows.items()
    }
    return numbers(parts)


def write_all() -> None:
    """Write the file of every shipped design; the difference shows in version control."""
    FOLDER.mkdir(exist_ok=True)
    for name in shipped_designs():
        values = recorded(size(read(shipped_design(name))))
        content = {"design": name, "tolerance": TOLERANCE, "values": values}
        (FOLDER / f"{name}.json").write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    write_all()
