"""What the other verbs answer about a sized design, one value a line, in a file of each design.

``PYTHONPATH=tests python tests/golden/answers.py`` writes the files in ``answers`` anew.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import fields
from math import inf, isclose
from pathlib import Path
from typing import Any

import numpy as np
from record import PARTS, designs, numbers, sized
from told import Fields, Group, Moved, condensed, groups, named, parsed, written

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

FOLDER = Path(__file__).with_name("answers")


def _whole(sizing: Sizing) -> Any:
    kept = (field.name for field in fields(sizing) if field.name not in ("design", "train", "checks", "given"))
    return Fields({name: getattr(sizing, name) for name in kept})


def _plays(sizing: Sizing) -> Any:
    gears = {gear.name: gear for gear in sizing.gears}
    return Fields(
        {
            "backlash": {mesh.name: backlash_of(sizing.design, gears, mesh) for mesh in sizing.meshes},
            "in motion": {mesh.name: play_in_motion(sizing, mesh.name) for mesh in sizing.meshes},
            "fits": {gear.name: fit_of(sizing.design, gear) for gear in sizing.gears},
            "thickness": {gear.name: thickness_of(sizing.design, gear) for gear in sizing.gears},
        }
    )


def _powers(sizing: Sizing) -> Any:
    return {
        case: Fields(
            {
                "branches": branches(sizing.train, flow),
                "loops": recirculation(sizing.train, flow),
                "shafts": shaft_powers(sizing.train, flow),
            }
        )
        for case, flow in sizing.flows.items()
    }


def _efficiencies(sizing: Sizing) -> Any:
    laws = sizing.design.efficiencies
    return {
        case: efficiencies(sizing.design, sizing.train, sizing.teeth, flow, laws) for case, flow in sizing.flows.items()
    }


def _beside(sizing: Sizing) -> Any:
    """Return margins, and means by dimension: aspects are known by words alone."""
    found: dict[str, dict[tuple[str, str], list[float]]] = {}
    for mesh in (beside := methods_beside(sizing)):
        for row in mesh.rows:
            means = found.setdefault(f"mean of each {row.dimension}", {})
            for method, own in row.values.items():
                means.setdefault((mesh.mesh, method), []).extend(own)
    return Fields(
        {
            "margins": {mesh.mesh: mesh.margins for mesh in beside},
            **{kind: {of: float(np.mean(each)) for of, each in means.items()} for kind, means in found.items()},
        }
    )


def _results(sizing: Sizing) -> Any:
    """Return quantity -> part -> value; of those that the file of the sizing has by the same name, only how many."""
    found: dict[str, dict[str, float]] = {}
    known, left = numbers({name: getattr(sizing, name) for name in PARTS}), 0
    for name, result in named_results(sizing).items():
        part, _, quantity = name.rpartition(".")
        if isclose(known.get(name, inf), result.value):
            left += 1
        else:
            found.setdefault(quantity, {})[part] = result.value
    return Fields({"as sized": left, **found})


ANSWERS: dict[str, Callable[[Sizing], Any]] = {
    "sizing": _whole,
    "asked speeds": lambda sizing: list(asked_speeds(sizing)),
    "assumptions": lambda sizing: assumptions(sizing, assemble(sizing)),
    "attachments": lambda sizing: attachments(sizing.train),
    "bearing forces": bearing_forces,
    "contacts": lambda sizing: contacts_of(sizing, sizing.flows[governing_case(sizing)]),
    "efficiencies": _efficiencies,
    "losses": lambda sizing: {case: loss_balance(sizing, case) for case in sizing.flows},
    "masses": lambda sizing: list(mass_parts(sizing)),
    "methods beside": _beside,
    "named results": _results,
    "pair data": lambda sizing: {mesh.name: pair_data(sizing, mesh) for mesh in sizing.meshes},
    "plays": _plays,
    "powers": _powers,
    "stages": lambda sizing: list(stage_summaries(sizing, "design")),
    "targets": lambda sizing: targets(sizing.design),
}


def _elsewhere(path: str) -> bool:
    """Tell whether ``record.py`` keeps the numbers of a path of the sizing."""
    return path.startswith(("flows.speeds", "flows.machine_powers")) or path.partition(".")[0] in (*PARTS, "teeth")


def answered(sizing: Sizing) -> dict[str, Group]:
    """Return answer and path -> identity -> value; numbers that the file of the sizing has are left to it.

    Args:
        sizing: That is asked.
    """
    found: dict[str, Group] = {}
    for name, answer in ANSWERS.items():
        for path, group in groups(answer(sizing)).items():
            if name == "sizing" and _elsewhere(path):
                group = {of: value for of, value in group.items() if isinstance(value, bool | str)}
            if group:
                found[f"{name}: {path}".removesuffix(": ")] = group
    return found


def stored(design: str) -> dict[str, Group]:
    """Return what is recorded of a design: answer and path -> identity -> value.

    Args:
        design: Its name.
    """
    file, kept = FOLDER / f"{design}.json", dict[str, Group]()
    for key, value in json.loads(file.read_text(encoding="utf-8")).items() if file.exists() else ():
        path, identity = parsed(key)
        kept.setdefault(path, {})[identity] = value
    return kept


def differences(was: dict[str, Group], now: dict[str, Group]) -> Moved:
    """Return what moved.

    Args:
        was: As stored.
        now: As it is, every value.
    """
    moved = Moved()
    for path in was.keys() | now.keys():
        moved.compare(path, was.get(path, {}), now.get(path, {}))
    return moved


def write_all() -> None:
    """Write the file of every design; what is the same but for rounding stays as it was written."""
    FOLDER.mkdir(exist_ok=True)
    for name in designs():
        kept, lines = stored(name), []
        for path, group in answered(sized(name)).items():
            was = kept.get(path, {})
            unmoved = was and not differences({path: was}, {path: group})
            for of, value in (was if unmoved else condensed(group)).items():
                lines.append(f"{json.dumps(named(path, of), ensure_ascii=False)}: {written(value)}")
        text = ",\n".join(sorted(lines))
        (FOLDER / f"{name}.json").write_text(f"{{\n{text}\n}}\n", encoding="utf-8")
    for file in FOLDER.glob("*.json"):
        if file.stem not in designs():
            file.unlink()


if __name__ == "__main__":
    write_all()
