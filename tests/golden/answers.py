"""What the other verbs answer about a sized design: how many numbers of each kind, and two sums of them.

``PYTHONPATH=tests python tests/golden/answers.py`` writes ``answers.json`` anew.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
from record import designs, sized

from gearwright.dynamics.assembly import assemble, assumptions, contacts_of
from gearwright.sizing import (
    Sizing,
    asked_speeds,
    backlash_of,
    bearing_forces,
    fit_of,
    governing_case,
    mass_parts,
    methods_beside,
    named_results,
    pair_data,
    play_in_motion,
    stage_summaries,
    thickness_of,
)
from gearwright.sizing.losses import loss_balance
from gearwright.train import attachments, branches, efficiencies, recirculation, shaft_powers, targets

FILE = Path(__file__).with_name("answers.json")
NOISE = 1e-6
"""Powers [W], speeds [rad/s] and forces [N] below it are zeros with rounding."""
ROUNDING = 1e-7
"""Relative difference that rounding and searches that stop at a tolerance leave."""


def _whole(sizing: Sizing) -> Any:
    kept = (field.name for field in fields(sizing) if field.name not in ("design", "train", "checks", "given"))
    return {name: getattr(sizing, name) for name in kept}


def _plays(sizing: Sizing) -> Any:
    gears = {gear.name: gear for gear in sizing.gears}
    return {
        "backlash": [backlash_of(sizing.design, gears, mesh) for mesh in sizing.meshes],
        "in motion": [play_in_motion(sizing, mesh.name) for mesh in sizing.meshes],
        "fits": [fit_of(sizing.design, gear) for gear in sizing.gears],
        "thickness": [thickness_of(sizing.design, gear) for gear in sizing.gears],
    }


def _powers(sizing: Sizing) -> Any:
    return {
        case: {
            "branches": branches(sizing.train, flow),
            "loops": recirculation(sizing.train, flow),
            "shafts": list(shaft_powers(sizing.train, flow).values()),
        }
        for case, flow in sizing.flows.items()
    }


def _efficiencies(sizing: Sizing) -> Any:
    laws = sizing.design.efficiencies
    return [efficiencies(sizing.design, sizing.train, sizing.teeth, flow, laws) for flow in sizing.flows.values()]


ANSWERS: dict[str, Callable[[Sizing], Any]] = {
    "sizing": _whole,
    "asked speeds": lambda sizing: list(asked_speeds(sizing)),
    "assumptions": lambda sizing: assumptions(sizing, assemble(sizing)),
    "attachments": lambda sizing: attachments(sizing.train),
    "bearing forces": bearing_forces,
    "contacts": lambda sizing: contacts_of(sizing, sizing.flows[governing_case(sizing)]),
    "efficiencies": _efficiencies,
    "losses": lambda sizing: [loss_balance(sizing, case) for case in sizing.flows],
    "masses": lambda sizing: list(mass_parts(sizing)),
    "methods beside": methods_beside,
    "named results": lambda sizing: [result.value for result in named_results(sizing).values()],
    "pair data": lambda sizing: [pair_data(sizing, mesh) for mesh in sizing.meshes],
    "plays": _plays,
    "powers": _powers,
    "stages": lambda sizing: list(stage_summaries(sizing, "design")),
    "targets": lambda sizing: targets(sizing.design),
}


def leaves(value: Any, path: str = "") -> Iterator[tuple[str, float]]:
    """Yield every number, truth value and single word inside an answer; names are not part of the path.

    Args:
        value: Records, named rows, mappings and sequences.
        path: Of fields that lead to it.
    """
    if isinstance(value, Enum):
        value = value.value
    if isinstance(value, bool | np.bool_):
        yield path, float(value)
    elif isinstance(value, int | float | np.number):
        yield path, float(value) if np.isfinite(value) else 1e30 * np.sign(value)
    elif isinstance(value, complex):
        yield from ((f"{path}.real", value.real), (f"{path}.imag", value.imag))
    elif isinstance(value, str):
        yield from [] if " " in value else [(path, crc32(value.encode()) / 2**32)]
    elif isinstance(value, np.ndarray):
        yield from ((path, float(part)) for part in value.ravel())
    elif is_dataclass(value):
        for field in fields(value):
            yield from leaves(getattr(value, field.name), f"{path}.{field.name}")
    elif hasattr(value, "_fields"):
        for name in value._fields:
            yield from leaves(getattr(value, name), f"{path}.{name}")
    elif isinstance(value, dict):
        for member in value.values():
            yield from leaves(member, path)
    elif isinstance(value, tuple | list | set | frozenset):
        for member in value:
            yield from leaves(member, path)


def sums(answer: Any) -> dict[str, list[float]]:
    """Return kind of number -> how many there are, the sum of their sizes, and a sum that tells their places.

    Args:
        answer: Of a verb.
    """
    kinds: dict[str, list[float]] = {}
    for path, number in leaves(answer):
        kinds.setdefault(path.lstrip("."), []).append(number)
    return {kind: _sums(np.array(numbers)) for kind, numbers in kinds.items()}


def _sums(numbers: Any) -> list[float]:
    total = float(np.sum(np.abs(numbers)))
    return [len(numbers), total, float(np.cos(np.arange(len(numbers))) @ numbers)]


def answered(sizing: Sizing) -> dict[str, dict[str, list[float]]]:
    """Return answer -> kind of number -> count and sums.

    Args:
        sizing: That is asked.
    """
    return {name: sums(answer(sizing)) for name, answer in ANSWERS.items()}


def differences(was: Any, now: Any) -> dict[str, Any]:
    """Return what moved, with both values.

    Args:
        was: As stored.
        now: As it is.
    """
    moved = {}
    for name in was.keys() | now.keys():
        before, after = was.get(name, {}), now.get(name, {})
        for kind in before.keys() | after.keys():
            pair = before.get(kind), after.get(kind)
            if None in pair or not _same(*pair):
                moved[f"{name}: {kind}"] = pair
    return moved


def _same(was: list[float], now: list[float]) -> bool:
    """Sums of unlike signs differ by what their sizes round to."""
    noise = NOISE + ROUNDING * abs(was[1])
    return was[0] == now[0] and all(abs(old - new) <= noise for old, new in zip(was[1:], now[1:], strict=True))


if __name__ == "__main__":
    stored = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    found = {name: answered(sized(name)) for name in designs()}
    kept = {name: stored[name] if not differences(stored.get(name, {}), new) else new for name, new in found.items()}
    rows = {name: ",\n".join(f'"{of}": {json.dumps(kinds)}' for of, kinds in own.items()) for name, own in kept.items()}
    text = ",\n".join(f'"{name}": {{\n{own}\n}}' for name, own in rows.items())
    FILE.write_text(f"{{\n{text}\n}}\n", encoding="utf-8")
