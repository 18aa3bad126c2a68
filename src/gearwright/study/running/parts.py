"""Parts of one study for machines that know nothing of each other, and their journals as one."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from gearwright.errors import DesignError, Problem, refuse
from gearwright.spec import Study
from gearwright.study.journal.file import reading
from gearwright.study.journal.journal import Recorded, begin, opened, recorded
from gearwright.study.journal.made_with import changes_of
from gearwright.study.journal.salvage import kept_rows

MOST = 100_000
"""Parts of one study, at most [-]."""
_BATCH = 10_000
"""Rows that are written at once."""


@dataclass(frozen=True)
class Part:
    """Every so-manieth case of a study: parts cost alike, whatever an axis costs."""

    number: int = 1
    """Which part, from 1."""
    of: int = 1
    """How many parts there are."""

    def has(self, case: int) -> bool:
        """Tell whether a case belongs to it.

        Args:
            case: Its number, from 0.
        """
        return case % self.of == self.number - 1

    def cases(self, total: int) -> range:
        """Return the numbers of its cases.

        Args:
            total: Cases of the whole study.
        """
        return range(self.number - 1, total, self.of)


WHOLE = Part()


def part_of(text: str) -> Part:
    """Return the part that a text such as ``2/8`` means.

    Args:
        text: As a user wrote it.

    Raises:
        DesignError: If it means none.
    """
    number, _, of = text.partition("/")
    if number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of) <= MOST:
        return Part(int(number), int(of))
    raise DesignError([Problem("--shard", f"{text!r} is no part; give its number and how many there are, such as 2/8")])


def refuse_part(study: Study, part: Part) -> None:
    """Raise where a study cannot be taken in parts.

    Args:
        study: As read.
        part: Of it.

    Raises:
        DesignError: If its cases follow from earlier results.
    """
    if part.of > 1 and study.searches:
        message = (
            f"{study.sampling.method} goes on from the results of all its cases: it has no parts;"
            " take another method, or a cluster"
        )
        raise DesignError([Problem("sampling.method", message)])


def merge(journals: Sequence[Path], into: Path) -> tuple[int, int]:
    """Put the finished cases of several journals of one study into one; return how many it has, and of how many.

    A case that several have is taken from the first; all give it the same, bit for bit. What is damaged is left out.

    Args:
        journals: Of parts, or of whatever was finished of one study.
        into: New journal, or one of the same study, which `resume` completes and shows.

    Raises:
        DesignError: If they are not of one study, its designs and one version, or the file is something else.
        SolveError: If it cannot be written.
    """
    if not journals:
        raise DesignError([Problem("journals", "there are none; name those of the parts")])
    every = [*journals, into] if into.exists() else list(journals)
    known = [recorded(path) for path in every]
    first = known[0]
    refuse(
        Problem(str(path), f"is not of the same study as {journals[0]}: {why}; leave it out")
        for path, other in zip(every[1:], known[1:], strict=True)
        if (why := _other(first, other))
    )
    if not into.exists():
        begin(into, first.study, first.designs, origin=first.origin)
    with opened(into) as book:
        book.begin_run(0)
        for path in journals:
            with reading(path) as database:
                rows = ((number, row) for number, row in kept_rows(database, first.total) if row is not None)
                while batch := list(islice(rows, _BATCH)):
                    book.append(batch)
        return len(book.kept), first.total


def _other(first: Recorded, other: Recorded) -> str:
    """Return in what two journals differ; empty where they are of one study."""
    if other.study != first.study:
        return "other axes, results or sampling"
    if other.designs != first.designs:
        return "a design differs"
    changes = changes_of(first.made_with, other.made_with)
    return "; ".join(f"{name} {ours} there, {theirs} here" for name, ours, theirs in changes)


def slurm(study: Path, parts: int) -> str:
    """Return a script for Slurm that runs a study in parts, one task each, and what to do after it.

    Args:
        study: Its file.
        parts: How many.

    Raises:
        DesignError: If there are none, or too many.
    """
    if not 1 <= parts <= MOST:
        raise DesignError([Problem("--slurm", f"{parts} parts are asked; allowed are 1 to {MOST:,}")])
    stem, name = shlex.quote(study.stem), shlex.quote(str(study))
    journal = f"{stem}-$SLURM_ARRAY_TASK_ID.journal"
    return "\n".join([
        "#!/bin/bash",
        f"#SBATCH --job-name={stem}",
        f"#SBATCH --array=1-{parts}",
        "#SBATCH --cpus-per-task=4",
        f"shard=$SLURM_ARRAY_TASK_ID/{parts}",
        f"if [ -e {journal} ]; then",
        f"  gearwright resume {journal} --shard $shard --workers $SLURM_CPUS_PER_TASK",
        "else",
        f"  gearwright study {name} --shard $shard --journal {journal} --workers $SLURM_CPUS_PER_TASK",
        "fi",
        f"# when all tasks have ended:  gearwright merge {stem}-*.journal --into {stem}.journal",
        f"# then:                       gearwright resume {stem}.journal --export {stem}.parquet",
    ])  # fmt: skip
