"""How far the gearbox that `size` chooses is from the lightest that passes: answers of a search, and today's choices.

    python tests/oracle/oracle_answers.py answer                # answers what answers.jsonl lacks; 13 minutes for all
    python tests/oracle/oracle_answers.py answer --again        # searches anew, and keeps the lighter of both answers
    python tests/oracle/oracle_answers.py compare               # sizes every design anew beside the kept answers
    python tests/oracle/oracle_answers.py compare --keep        # and keeps today's choices in answers.jsonl
    python tests/oracle/oracle_answers.py table                 # what is kept, as docs/theory/choice.md has it
    python tests/oracle/oracle_answers.py exhaust "spur pair" 4 # every width of one design, to judge the search itself

Another version of gearwright is held against the same answers by its path: PYTHONPATH=…/src python … compare.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from oracle_designs import KINDS, OF_FILES, all_designs, design_of
from oracle_search import (
    MOST,
    Changes,
    Outcome,
    Trials,
    accepted,
    blocks_of,
    no_worse_than,
    outcome_of,
    passes,
    searched,
)

from gearwright import DesignError, edited, size
from gearwright.sizing.result import Sizing
from gearwright.spec import Design, Planetary

ANSWERS = Path(__file__).parent / "answers.jsonl"
SAME = 1e-6
"""Part of the mass that is rounding, of gears that are written into a design [-]."""


# ----------------------------------------------------------------------------------------------------------------------
# Answers, kept as JSON lines.
# ----------------------------------------------------------------------------------------------------------------------


PASSES, MEETS, FAILS = "passes", "choice fails, another passes", "fails"
"""Classes: the choice passes; it fails something and another gearbox does not; none is found that passes."""


def answer(kind: str, number: int | str, most: int = MOST) -> dict[str, Any]:
    """Return what the search finds of one design.

    Args:
        kind: Of the design.
        number: Of the design.
        most: Sizings that may be made [-].
    """
    begun = time.process_time()
    design = design_of(kind, number)
    sizing = size(design)
    choice, trials = outcome_of(sizing), Trials(design, most)
    changes, found = searched(trials, blocks_of(design, sizing), choice)
    if (
        found is None
        or (not passes(found) and found.mass >= choice.mass)
        or (passes(choice) and found.mass >= choice.mass)
    ):
        found, changes = choice, entries(design, sizing)
    own = Compared(
        kind, number, choice.mass, choice.failing, found.mass, found.failing, in_order(changes),
        {} if found is choice else was(design, sizing),
    )  # fmt: skip
    record = anew({"kind": kind, "k": number, "level": design.level, "open": open_in(design)}, own)
    return record | {"sizings": len(trials.known), "seconds": round(time.process_time() - begun, 1)}


def rounded(ratios: Mapping[str, float]) -> dict[str, float]:
    """Return ratios as they are kept.

    Args:
        ratios: Name of a check -> its ratio [-].
    """
    return {name: round(ratio, 4) for name, ratio in sorted(ratios.items(), key=lambda row: row[1])}


def open_in(design: Design) -> list[str]:
    """Return what a design leaves open beside modules and face widths.

    Args:
        design: As read.
    """
    found = []
    for stage in design.simple_stages.values():
        if isinstance(stage, Planetary):
            found += ["teeth"] if stage.known_teeth is None else []
            found += ["planets"] if stage.planets_given is None else []
        else:
            found += [] if stage.pinion_teeth and stage.wheel_teeth else ["teeth"]
    return sorted(set(found))


def entries(design: Design, sizing: Sizing) -> Changes:
    """Return the entries that give a design the gears of a sizing.

    Args:
        design: That leaves them open.
        sizing: With them.
    """
    return in_order({path: value for block in blocks_of(design, sizing) for path, value in block.start.items()})


def in_order(changes: Changes) -> Changes:
    """Return entries in the order of their paths.

    Args:
        changes: Of a design.
    """
    return {path: changes[path] for path in sorted(changes)}


def was(design: Design, sizing: Sizing) -> dict[str, str]:
    """Return stage -> teeth, planets, module and face width of a choice, in short.

    Args:
        design: With its stages.
        sizing: The choice.
    """
    found = {}
    for stage in design.stages:
        gears = [gear for gear in sizing.gears if gear.stage == stage]
        count = max(gear.bodies for gear in gears)
        found[stage] = (
            "/".join(str(gear.teeth) for gear in gears) + (f" ×{count}" if count > 1 else "")
            + " m " + "/".join(dict.fromkeys(f"{1e3 * gear.module:.4g}" for gear in gears))
            + " b " + "/".join(dict.fromkeys(f"{1e3 * gear.face_width:.4g}" for gear in gears))
        )  # fmt: skip
    return found


def kept(path: Path = ANSWERS) -> list[dict[str, Any]]:
    """Return the kept answers.

    Args:
        path: Where they are kept.
    """
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


# ----------------------------------------------------------------------------------------------------------------------
# How far today's choices are from the kept answers.
# ----------------------------------------------------------------------------------------------------------------------


class Compared(NamedTuple):
    """A design sized today beside its kept answer."""

    kind: str
    number: int | str
    mass: float
    """Of today's choice [kg]."""
    fails: Mapping[str, float]
    """What fails in it."""
    best: float
    """Mass of the kept gearbox as it is sized today [kg]."""
    best_fails: Mapping[str, float]
    """What fails in that."""
    changes: Changes
    """Entries of that gearbox."""
    was: Mapping[str, str]
    """The choice in short, where another one is lighter."""

    @property
    def verdict(self) -> str:
        """Class of today's choice."""
        return PASSES if not self.fails else FAILS if self.best_fails else MEETS

    @property
    def gap(self) -> float:
        """Part of its mass that the choice could save [-]; below zero where it is lighter than the kept answer."""
        return 1.0 - self.best / self.mass


def compared(record: Mapping[str, Any]) -> Compared:
    """Return a design as `size` chooses it today, beside its kept answer.

    Args:
        record: A kept answer.
    """
    key = record["kind"], record["k"]
    design = design_of(*key)
    sizing = size(design)
    choice = outcome_of(sizing)
    best = outcome_of(size(edited(design, record["changes"])))
    if not _is_better(best, choice):
        return Compared(
            *key, choice.mass, choice.failing, choice.mass, choice.failing, entries(design, sizing), {}
        )  # fmt: skip
    return Compared(
        *key, choice.mass, choice.failing, best.mass, best.failing, record["changes"], was(design, sizing)
    )  # fmt: skip


def _is_better(best: Outcome, choice: Outcome) -> bool:
    """Tell whether a kept gearbox is better than a choice: it passes alone, or is lighter and fails nothing worse."""
    if choice.failing and not best.failing:
        return True
    return best.mass < choice.mass * (1.0 - SAME) and no_worse_than(choice)(best)


def as_kept(record: Mapping[str, Any]) -> Compared:
    """Return a kept answer as it was compared when it was kept.

    Args:
        record: A kept answer.
    """
    return Compared(
        record["kind"], record["k"], record["choice"], record["choice_fails"], record["best"],
        record.get("best_fails", {}), record["changes"], record["was"],
    )  # fmt: skip


def anew(record: Mapping[str, Any], today: Compared) -> dict[str, Any]:
    """Return an answer to keep with today's choice in it.

    Args:
        record: As it was kept.
        today: As it is compared today.
    """
    found = dict(record) | {"choice": round(today.mass, 4), "choice_fails": rounded(today.fails)}
    found |= {"class": today.verdict, "best": round(today.best, 4), "gap": round(today.gap, 5)}
    found |= {"changes": dict(today.changes), "was": dict(today.was)}
    found.pop("best_fails", None)
    return found | ({"best_fails": rounded(today.best_fails)} if today.verdict == FAILS else {})


def table(rows: Sequence[Compared]) -> str:
    """Return the gaps of every kind as a table of Markdown.

    Args:
        rows: Designs.
    """
    lines = [
        "| kind | designs | choice passes | gap: median | 95 % | worst | choice fails, another passes | none passes |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    kinds = [*KINDS, OF_FILES]
    for kind in (*kinds, "all"):
        own = [row for row in rows if kind in (row.kind, "all")]
        if not own:
            continue
        gaps = [max(row.gap, 0.0) for row in own if row.verdict == PASSES]
        told = [f"{100 * value:.1f} %" for value in np.percentile(gaps, (50, 95, 100))] if gaps else ["–"] * 3
        meets, fails = (sum(row.verdict == which for row in own) for which in (MEETS, FAILS))
        lines.append(f"| {kind} | {len(own)} | {len(gaps)} | {' | '.join(told)} | {meets} | {fails} |")
    return "\n".join(lines)


def better(before: dict[str, Any], found: dict[str, Any]) -> dict[str, Any]:
    """Return a new answer, with the gearbox that was kept where that is better than what is found.

    Args:
        before: As it was kept.
        found: By another search of the same design.
    """
    if "refused" in found or "refused" in before:
        return found
    today = compared(before)
    own = as_kept(found)
    was_found = Outcome(own.best, own.best_fails or {})
    return anew(found, today) if _is_better(Outcome(today.best, today.best_fails), was_found) else found


# ----------------------------------------------------------------------------------------------------------------------
# Commands.
# ----------------------------------------------------------------------------------------------------------------------


def _answer(arguments: argparse.Namespace) -> None:
    path: Path = arguments.answers
    done = {(record["kind"], record["k"]): record for record in kept(path)}
    asked = [key for key in all_designs() if arguments.again or key not in done]
    for kind, number in [key for key in asked if arguments.kind in (None, key[0])][: arguments.count]:
        try:
            record = answer(kind, number, arguments.most)
        except DesignError as error:
            record = {"kind": kind, "k": number, "refused": str(error)[:200]}
        done[kind, number] = better(done[kind, number], record) if (kind, number) in done else record
        path.write_text("".join(json.dumps(line, ensure_ascii=False) + "\n" for line in done.values()))
        print(kind, number, record.get("class", "refused"), record.get("gap"), record.get("sizings"), flush=True)


def _compare(arguments: argparse.Namespace) -> None:
    records = kept(arguments.answers)
    asked = [one for one in records if "refused" not in one and arguments.kind in (None, one["kind"])]
    rows = {(one["kind"], one["k"]): compared(one) for one in asked[: arguments.count]}
    _tell(list(rows.values()), arguments.worst)
    if arguments.keep:
        lines = (anew(one, rows[key]) if (key := (one["kind"], one["k"])) in rows else one for one in records)
        text = "".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines)
        arguments.answers.write_text(text)


def _table(arguments: argparse.Namespace) -> None:
    _tell([as_kept(record) for record in kept(arguments.answers) if "refused" not in record], arguments.worst)


def _tell(rows: Sequence[Compared], worst: int) -> None:
    print(table(rows))
    for row in sorted(rows, key=lambda row: -row.gap)[:worst]:
        fails = ", ".join(f"{name} {ratio:.3f}" for name, ratio in row.fails.items()) or "passes"
        print(f"{row.kind} {row.number}: {row.mass:.3f} kg, {fails}; best {row.best:.3f} kg, gap {100 * row.gap:.1f} %")


def _exhaust(arguments: argparse.Namespace) -> None:
    """Size every width of every combination of a design of one face width, and tell the lightest that passes."""
    design = design_of(arguments.kind, int(arguments.number))
    sizing = size(design)
    (block,) = blocks_of(design, sizing)
    trials, found = Trials(design, sys.maxsize), list[tuple[float, Changes]]()
    for own in block.combinations:
        for width in range(own.low[0], own.cap[0] + 1):
            changes = {**own.changes, block.widths[0]: width}
            if accepted(trials.of(changes), passes):
                found.append((trials.of(changes).mass, changes))  # type: ignore[union-attr]
    mass, changes = min(found, key=lambda row: row[0], default=(math.inf, {}))
    print(f"{arguments.kind} {arguments.number}: {len(trials.known)} sizings, {mass:.4f} kg, {changes}")


def main(words: Sequence[str] | None = None) -> None:
    """Run a command.

    Args:
        words: Of the command line.
    """
    parser = argparse.ArgumentParser(description=str(__doc__).splitlines()[0])
    commands = parser.add_subparsers(required=True)
    for name, run in (("answer", _answer), ("compare", _compare), ("table", _table)):
        command = commands.add_parser(name)
        command.add_argument("--answers", type=Path, default=ANSWERS)
        command.add_argument("--kind", default=None)
        command.add_argument("--count", type=int, default=None)
        command.add_argument("--most", type=int, default=MOST)
        command.add_argument("--worst", type=int, default=10)
        command.add_argument("--keep", action="store_true")
        command.add_argument("--again", action="store_true")
        command.set_defaults(run=run)
    command = commands.add_parser("exhaust")
    command.add_argument("kind")
    command.add_argument("number")
    command.set_defaults(run=_exhaust)
    arguments = parser.parse_args(words)
    arguments.run(arguments)


if __name__ == "__main__":
    main()
