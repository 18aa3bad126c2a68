"""Shipped designs put into bearings, and a gearbox that was drawn by hand beside the same one arranged anew.

``python benchmarks/arranged.py`` prints both tables of docs/how-to/arrange.md, and with ``--write`` writes them there;
names of designs behind it print the first one for these alone. ``--closed`` prints the third instead: designs closed
for 20,000 h, put into bearings as they are closed, and moved until they pass; it takes a quarter of an hour of
processor time.
"""

from __future__ import annotations

import re
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import gearwright as gw
from gearwright.closure import Arranged, BearingRound, close_arranged
from gearwright.errors import DesignError
from gearwright.sizing import Sizing
from gearwright.sizing.mass import CompleteMass
from gearwright.spec import Design
from gearwright.spec.design import BUILT, CONCEPT, PRELIMINARY
from gearwright.spec.edit import Value
from gearwright.study.architectures import with_public_motors
from gearwright.study.running import comparison_of

SHOWN = ("shafts", "carriers", "bearings", "housing")
"""Groups of the complete mass that the table shows."""
BY_HAND = "ec120b"
"""Shipped design whose bearings were placed by hand."""
MM = 1e3
WRITE, CLOSED = "--write", "--closed"
HOURS = 20_000
"""Life that closed designs are asked for [h]: that of docs/how-to/architectures.md."""
BESIDE = ("off-set-h1-free", "contra-rotating-propellers", "differential-hybrid")
"""Designs that are closed beside the architectures of the thesis."""
PAGE = Path(__file__).parents[1] / "docs" / "how-to" / "arrange.md"
LONGEST = 160
"""Characters of what fails that a row of the table shows."""


def main() -> None:
    names = [word for word in sys.argv[1:] if word not in (WRITE, CLOSED)]
    if CLOSED in sys.argv:
        made = ["\n".join(closed_table(names or [*comparison_of(None).designs, *BESIDE]))]
    else:
        made = ["\n".join(table(names or [name for name in gw.shipped_designs() if gw.read(name).level != BUILT]))]
        made += [] if names else ["\n".join(beside(gw.read(BY_HAND)))]
    print("\n\n".join(made))
    if WRITE in sys.argv:
        text = PAGE.read_text(encoding="utf-8")
        for new in made:
            head = re.escape(new.partition("\n")[0])
            text = re.sub(rf"^{head}\n(?:\|.*\n)*", lambda _, new=new: f"{new}\n", text, flags=re.MULTILINE)
        PAGE.write_text(text, encoding="utf-8")


def table(names: Sequence[str]) -> Iterator[str]:
    """Yield a table of designs before and after, row by row."""
    heads = " | ".join(f"{group}, kg" for group in SHOWN)
    yield f"| design | bearings | complete mass, kg | {heads} | s | fails, and did not before |"
    yield f"| --- |{' --- |' * (len(SHOWN) + 4)}"
    for name in names:
        yield row(name)


def row(name: str) -> str:
    """Return what becomes of a shipped design."""
    design, started = gw.read(name), time.process_time()
    try:
        arranged = gw.arrange(gw.at_level(design, PRELIMINARY) if design.level == CONCEPT else design)
    except DesignError as error:
        return (
            f"| `{name}` | – | – |{' – |' * len(SHOWN)} {time.process_time() - started:.1f} | refused: {told(error)} |"
        )
    seconds, (before, after) = time.process_time() - started, arranged.masses
    groups = " | ".join(change(before.of(group), after.of(group)) for group in SHOWN)
    fails = "; ".join(check.name for check in arranged.worse) or "–"
    count = len(arranged.sizing.bearings)
    return f"| `{name}` | {count} | {change(before.total, after.total)} | {groups} | {seconds:.1f} | {cut(fails)} |"


def change(before: float, after: float) -> str:
    return f"{before:.1f} → {after:.1f}" if before or after else "–"


def told(error: DesignError) -> str:
    """Return the first of what is wrong, and how much more is."""
    first, *others = error.problems
    return cut(f"{first.path}: {first.message}") + (f" (and {len(others)} more)" if others else "")


def cut(words: str) -> str:
    return words if len(words) <= LONGEST else f"{words[: LONGEST - 2].rstrip()} …"


# ----------------------------------------------------------------------------------------------------------------------
# Designs closed for one life: as they stand in bearings first, and what is moved until they pass.
# ----------------------------------------------------------------------------------------------------------------------


def closed_table(names: Sequence[str]) -> Iterator[str]:
    """Yield a table of designs that are closed, put into bearings and moved, row by row, as each is found."""
    yield "| closed design | without bearings, kg | in bearings | then | moved | s |"
    yield f"| --- |{' --- |' * 5}"
    for name in names:
        started = time.process_time()
        found = close_arranged(with_public_motors(gw.read(name)), wishes=gw.Wishes(life=HOURS * 3600.0))
        first, last = found.rounds[0], next(one for one in found.rounds if one.what == found.what)
        then = f"no bearings: {cut(found.without_bearings)}" if found.without_bearings else state(last)
        row = (
            f"| `{name}` | {first.before:.1f} | {state(first)} | {'–' if first is last else then} |"
            f" {found.what or '–'} | {time.process_time() - started:.0f} |"
        )
        print(row, file=sys.stderr, flush=True)
        yield row


def state(one: BearingRound) -> str:
    """Return the mass of a round, and what it fails by."""
    if one.mass == one.before:
        return "a shaft finds none"
    return f"{one.mass:.1f} kg, " + (f"fails: {one.worst}" if one.worst else "passes")


# ----------------------------------------------------------------------------------------------------------------------
# The gearbox that was drawn by hand, and the same one without bearings, joints, lengths and places, arranged anew.
# ----------------------------------------------------------------------------------------------------------------------


def stripped(design: Design) -> Design:
    """Return a design without bearings, joints, lengths of shafts and places on them; angles of axes stay."""
    gone: dict[str, Value] = {"bearings": {}, "joints": {}}
    for shaft, layout in design.layout.items():
        if layout.length is not None:
            gone[f"layout.{shaft}.length_mm"] = None
        if layout.places:
            gone[f"layout.{shaft}.places"] = {}
    return gw.edited(design, gone)


class Beside(NamedTuple):
    """A quantity of both gearboxes, in words."""

    what: str
    by_hand: str
    arranged: str


def beside(design: Design) -> Iterator[str]:
    """Yield a table of a gearbox drawn by hand and arranged anew, row by row."""
    by_hand, arranged = gw.size(design), gw.arrange(stripped(design))
    yield f"| `{BY_HAND}` | drawn by hand | arranged |"
    yield "| --- | --- | --- |"
    for one in (*masses(gw.complete_mass(by_hand), arranged.masses[1]), *shafts(by_hand, arranged)):
        yield f"| {one.what} | {one.by_hand} | {one.arranged} |"


def masses(by_hand: CompleteMass, arranged: CompleteMass) -> Iterator[Beside]:
    for group in by_hand.groups:
        yield Beside(f"{group.group}, kg", f"{group.total:.1f}", f"{arranged.of(group.group):.1f}")
    yield Beside("complete mass, kg", f"{by_hand.total:.1f}", f"{arranged.total:.1f}")


def shafts(by_hand: Sizing, arranged: Arranged) -> Iterator[Beside]:
    weights = [
        {item.part: item.total for item in mass.parts if item.group == "shafts"}
        for mass in (gw.complete_mass(by_hand), arranged.masses[1])
    ]
    for own, other in zip(by_hand.shafts, arranged.sizing.shafts, strict=True):
        sizes = (f"{one.length * MM:.0f}, {one.diameter * MM:.0f}, {one.bore * MM:.0f}" for one in (own, other))
        yield Beside(f"{own.name}: length, largest diameter, bore, mm", *sizes)
        yield Beside(f"{own.name}: mass, kg", *(f"{weight.get(own.name, 0.0):.2f}" for weight in weights))
        words = (bearings(sizing, own.name) for sizing in (by_hand, arranged.sizing))
        yield Beside(f"{own.name}: bearings, place in mm", *words)


def bearings(sizing: Sizing, shaft: str) -> str:
    """Return the bearings of a shaft in order along it, each with its place."""
    own = sorted((one for one in sizing.bearings if one.shaft == shaft), key=lambda one: one.position)
    return ", ".join(f"{one.designation} at {one.position * MM:.0f}" for one in own)


if __name__ == "__main__":
    main()
