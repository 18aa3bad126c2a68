"""Hold choices for harder requirements against those for easier ones: nobody should be better off asking for more.

    python tests/oracle/oracle_exchange.py --count 1000         # pairs of random designs, and those of data/; minutes

Of two designs that differ in what is asked alone (1.3 times the power, ten times the life, a weaker steel, the whole
life at full load instead of half of it at half load, a heavier case more), the gears that `size` chooses for the harder
one are written into the easier one, all teeth, planets, modules and face widths. Where these pass every check of the
easier one and its own choice fails some, or weighs more by over half a per cent, the choice has missed a gearbox that
it might have had. Checks that the gears pass at the harder requirement and fail at the easier one do not run one way
with the load; they are counted, since they part the two without a fault of the choice.
"""

from __future__ import annotations

import argparse
import json
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from oracle_answers import rounded
from oracle_designs import DATA, HARD, KINDS, MATERIALS, OF_FILES, Draw, design_of
from oracle_search import Changes, Outcome, blocks_of, no_worse_than, outcome_of

from gearwright import DesignError, edited, read, size
from gearwright.spec import Design

VIOLATIONS = Path(__file__).parent / "exchange.jsonl"
FROM = 1000
"""First number of the designs of pairs, beyond those that the search is asked about."""
PART = 0.005
"""Part of the mass that counts as lighter [-]."""
FILES = (
    ("st1005_2000h", "st1005_20000h"), ("pl1006", "pl1006_13"), ("bevel_half", "bevel_full"),
    ("halves_two", "halves_whole"), ("halves_whole", "halves_two"),
    ("halves_hybrid_20000_one", "halves_hybrid_20000_two"), ("halves_hybrid_20000_two", "halves_hybrid_20000_one"),
)  # fmt: skip
"""Easier and harder requirements in `data`; of those that ask the same both ways round."""

Two = tuple[Changes, Changes]
"""What makes a design easier, and what makes it harder."""


def _powers(design: Design, factor: float) -> Changes:
    found: Changes = {f"turbines.{name}.power_kw": factor * own.power / 1e3 for name, own in design.turbines.items()}
    return found | {f"motors.{name}.power_kw": factor * own.power / 1e3 for name, own in design.motors.items()}


def _power(design: Design, draw: Draw) -> Two:
    del draw
    return {}, _powers(design, 1.3)


def _life(design: Design, draw: Draw) -> Two:
    del draw
    life, bearings = (value / 3600.0 for value in (design.service.life, design.service.bearing_life))
    return {}, {"service.life_h": 10.0 * life, "service.bearing_life_h": 10.0 * bearings}


def _steel(design: Design, draw: Draw) -> Two:
    own = design.gears.material
    if design.gears.rating == "agma2001":  # whose table has other steels
        return _power(design, draw)
    weaker = MATERIALS[draw.whole(HARD, len(MATERIALS) - 1)]
    if own not in MATERIALS[:HARD]:
        return {"gears.material": MATERIALS[0]}, {}
    return {}, {"gears.material": weaker}


def _cases(*rows: tuple[float, float]) -> Changes:
    return {
        "cases": {
            name: {"share": share, "eng": {"rating": rating}}
            for name, (share, rating) in zip("abc", rows, strict=False)
        }
    }


def _half(design: Design, draw: Draw) -> Two:
    del design, draw
    return _cases((0.5, 1.0), (0.5, 0.5)), _cases((1.0, 1.0))


def _case(design: Design, draw: Draw) -> Two:
    del design
    light, heavy, share = draw.uniform(0.3, 0.6), draw.uniform(0.65, 1.0), round(draw.uniform(0.1, 0.4), 3)
    whole = _cases((0.4, 1.0), (0.6, light))
    return whole, _cases((0.4, 1.0), (round(0.6 - share, 3), light), (share, heavy))


ASKED: Mapping[str, Callable[[Design, Draw], Two]] = {
    "1.3 times the power": _power,
    "ten times the life": _life,
    "a weaker steel": _steel,
    "half of the life at half load": _half,
    "a heavier case more": _case,
}
"""In what requirements differ -> what makes them so."""


HEAVIER, FAILS = "both pass, own choice heavier", "own choice fails, the other's gears pass"
FAIL_ALIKE = "both fail, the other's gears nothing worse, own choice heavier"
"""What a choice may have missed."""


class Exchange(NamedTuple):
    """A choice for the easier requirement, and the gears chosen for the harder one held against it."""

    own: Outcome
    """Of the easier one's choice."""
    harder: Outcome
    """Of the harder one's choice."""
    other: Outcome
    """Of the gears of the harder one's choice at the easier requirement."""

    @property
    def violation(self) -> str:
        """What the choice has missed; empty where it has not."""
        if self.own.failing and not self.other.failing:
            return FAILS
        lighter = self.other.mass < self.own.mass * (1.0 - PART)
        if not lighter or not no_worse_than(self.own)(self.other):
            return ""
        return FAIL_ALIKE if self.own.failing else HEAVIER

    @property
    def turning(self) -> list[str]:
        """Checks that pass at the harder requirement and fail at the easier one, without their parts."""
        found = (name for name in self.other.failing if name not in self.harder.failing)
        return sorted({name.split(" ", 1)[1] for name in found})


def exchanged(easier: Design, harder: Design) -> Exchange:
    """Return what comes of the gears that are chosen for a harder requirement at an easier one.

    Args:
        easier: Design.
        harder: The same with more asked.
    """
    for_harder = size(harder)
    gears: Changes = {path: value for block in blocks_of(harder, for_harder) for path, value in block.start.items()}
    return Exchange(
        outcome_of(size(easier)), outcome_of(for_harder), outcome_of(size(edited(easier, gears)))
    )  # fmt: skip


def _of_files(easier: str, harder: str) -> tuple[Design, Design]:
    return read(DATA / f"{easier}.toml"), read(DATA / f"{harder}.toml")


def pairs(count: int) -> Iterator[tuple[str, str, str, Callable[[], tuple[Design, Design]]]]:
    """Yield kind, number, what differs, and what makes the easier and the harder design.

    Args:
        count: Of random ones [-].
    """
    for one, other in FILES:
        yield OF_FILES, one, other, partial(_of_files, one, other)
    names, kinds = list(ASKED), list(KINDS)
    for at in range(count):
        kind, number = kinds[at % len(kinds)], FROM + at // len(kinds)
        asked = names[(at // len(kinds) + at) % len(names)]

        def made(kind: str = kind, number: int = number, asked: str = asked) -> tuple[Design, Design]:
            design, draw = design_of(kind, number), Draw(100 + KINDS[kind].number, number)
            easier, harder = ASKED[asked](design, draw)
            return edited(design, easier), edited(design, harder)

        yield kind, str(number), asked, made


def main(words: Sequence[str] | None = None) -> None:
    """Go through pairs, keep the violations, and tell how many there are.

    Args:
        words: Of the command line.
    """
    parser = argparse.ArgumentParser(description=str(__doc__).splitlines()[0])
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--out", type=Path, default=VIOLATIONS)
    arguments = parser.parse_args(words)
    begun, done, refused = time.process_time(), 0, 0
    turning, violations = Counter[str](), Counter[tuple[str, str]]()
    with arguments.out.open("w") as file:
        for kind, number, asked, made in pairs(arguments.count):
            try:
                found = exchanged(*made())
            except DesignError as error:
                refused += 1
                print("refused:", kind, number, asked, str(error).replace("\n", " ")[:160])
                continue
            done += 1
            turning.update(found.turning)
            if found.violation:
                violations[asked if kind != OF_FILES else "files", found.violation] += 1
                file.write(json.dumps(_record(kind, number, asked, found), ensure_ascii=False) + "\n")
                file.flush()
    print(
        f"{done} pairs, {refused} refused, {sum(violations.values())} violations, {time.process_time() - begun:.0f} s"
    )
    for (asked, what), count in sorted(violations.items()):
        print(f"{asked}: {what} {count}")
    print("checks that pass at the harder requirement and fail at the easier one:", dict(turning.most_common()))


def _record(kind: str, number: str, asked: str, found: Exchange) -> dict[str, Any]:
    return {
        "kind": kind, "k": number, "asked": asked, "violation": found.violation, "own": round(found.own.mass, 4),
        "own_fails": rounded(found.own.failing), "other": round(found.other.mass, 4),
        "part": round(1.0 - found.other.mass / found.own.mass, 5),
    }  # fmt: skip


if __name__ == "__main__":
    main()
