"""Where designs are evaluated: by workers, each kept in the journal as soon as it is finished, none computed twice."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, closing
from pathlib import Path

from gearwright.errors import Problem, refuse
from gearwright.spec import Design, Study
from gearwright.study.answers import Blocks, Row, blocks_of
from gearwright.study.cases import Case, refuse_unknown_paths
from gearwright.study.running import Compute, Journal, begin, in_memory, local, opened, recorded, refuse_changes


class Bench:
    """What evaluates the designs of one search, and remembers them."""

    def __init__(
        self, study: Study, designs: Mapping[str, Design], *, journal: Path | None, workers: int, anyway: bool = False
    ) -> None:
        self.study, self.designs = study, designs
        self.computed = 0
        """Designs that were evaluated since it was opened [-]."""
        self._open = ExitStack()
        try:
            refuse_unknown_paths(study, designs)
            self.book = self._book(journal, anyway=anyway)
            self.compute: Compute = self._open.enter_context(local(study, designs, workers))
            self.book.begin_run(workers)
        except BaseException:
            self._open.close()
            raise
        self._known = dict(self._kept()) if journal is not None else {}

    def _book(self, journal: Path | None, *, anyway: bool) -> Journal:
        """Return the journal, begun anew or gone on with."""
        if journal is None:
            book = in_memory(self.study, self.designs)
            self._open.enter_context(closing(book.database))
            return book
        if journal.exists():
            known = recorded(journal)
            if known.study != self.study:
                message = f"is of another search, {known.study.name!r}, or of one that asks for something else"
                refuse([Problem("journal", f"{journal} {message}; name another file, or take this one away")])
            if not anyway:
                refuse_changes(journal, known, self.designs)
        else:
            begin(journal, self.study, self.designs)
        return self._open.enter_context(opened(journal))

    def _kept(self) -> Iterator[tuple[int, Row]]:
        numbers = sorted(self.book.finished())
        yield from zip(numbers, self.book.rows(numbers), strict=True)

    def close(self) -> None:
        """End the workers and let the journal go."""
        self._open.close()

    def rows(self, cases: Sequence[Case]) -> list[Row]:
        """Return the rows of cases, those of the journal as they stand there.

        Args:
            cases: With numbers of their own.

        Raises:
            DesignError: If the journal has something else under a number.
        """
        found: dict[int, Row] = {}
        for blocks in self._finished(cases):
            found.update(blocks)
        return [found[case.number] for case in cases]

    def tried(self, cases: Sequence[Case]) -> list[Row]:
        """Return the rows of cases that are not kept: what follows from an answer and is soon computed again.

        Args:
            cases: Numbered from 0.
        """
        found: dict[int, Row] = {}
        for finished in self.compute(iter(cases), len(cases)):
            found.update(finished)
        return [found[case.number] for case in cases]

    def _finished(self, cases: Sequence[Case]) -> Iterator[Blocks]:
        """Yield cases in any order: those of the journal, then those that are computed."""
        missing = list[Case]()
        kept = list[tuple[int, Row]]()
        for case in cases:
            row = self.known(case)
            if row is None:
                missing.append(case)
            else:
                kept.append((case.number, row))
        if kept:
            yield blocks_of(kept)
        for finished in self.compute(iter(missing), len(missing)) if missing else ():
            blocks = blocks_of(finished)
            self.book.append(blocks)
            self.computed += len(blocks)
            yield blocks

    def known_between(self, first: int, end: int) -> list[tuple[int, Row]]:
        """Return number and row of what the journal has from one number up to another.

        Args:
            first: Number of a case.
            end: Number behind the last.
        """
        return [(number, row) for number, row in sorted(self._known.items()) if first <= number < end]

    def append(self, blocks: Blocks) -> None:
        """Keep cases that were computed elsewhere.

        Args:
            blocks: Finished cases.
        """
        self.book.append(blocks)
        self.computed += len(blocks)

    def known(self, case: Case) -> Row | None:
        """Return the row that the journal has of a case; None where it has none.

        Args:
            case: With its number.

        Raises:
            DesignError: If the journal has something else under its number.
        """
        row = self._known.get(case.number)
        if row is not None and (row.design, dict(row.inputs)) != (case.design, case.inputs):
            message = f"its evaluation {case.number} is of other inputs; it was made by another driver or seed"
            refuse([Problem("journal", f"{message}: drive it as it was begun, or name another file")])
        return row

    def keep(self, number: int, row: Row) -> Row:
        """Return a row that was computed elsewhere, kept under its number.

        Args:
            number: Of the evaluation, which the journal does not have.
            row: With its results.
        """
        self.book.append([(number, row)])
        self.computed += 1
        return row
