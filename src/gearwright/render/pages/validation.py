"""Every published number beside what gearwright finds, as tables and as one page."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby

from gearwright.render.grid import Cell, Table, table
from gearwright.render.pages.page import UNSTAMPED, Number, Page, Section, Stamp, Tone, Verdict, set_page
from gearwright.validate import Case, Checked, check

# ----------------------------------------------------------------------------------------------------------------------
# The validation tables: every published number beside what gearwright finds.
# ----------------------------------------------------------------------------------------------------------------------


SHOWN = ("expected", "got", "error", "unit", "case")
"""Columns for the terminal; the source is the title."""
DIGITS = 7
"""Significant digits that are shown [-]."""


def by_source(cases: Iterable[Case]) -> Iterator[tuple[Checked, ...]]:
    """Compute and yield the numbers of one source after the other.

    Args:
        cases: Published results, those of one source together.
    """
    for _, group in groupby(cases, key=lambda case: case.source):
        yield tuple(result for case in group for result in check(case))


def source_table(results: tuple[Checked, ...]) -> Table:
    """Return the numbers of one source for the terminal; what is missed is said below, with its tolerance's reason.

    Args:
        results: Numbers of that source.
    """
    plain = table(results[0].source, results, SHOWN)
    rows = tuple(_written(row, result) for row, result in zip(plain.rows, results, strict=True))
    missed = "; ".join(f"{result.case} (allowed because {result.reason})" for result in results if not result.holds)
    return replace(plain, rows=rows, note=f"Missed: {missed}." if missed else "")


def verdict(results: Iterable[Checked]) -> str:
    """Return how many numbers come out.

    Args:
        results: Of all sources.
    """
    holds = [result.holds for result in results]
    return f"{sum(holds)} of {len(holds)} published numbers come out within their tolerance."


def _written(row: tuple[Cell, ...], result: Checked) -> tuple[Cell, ...]:
    expected, got, error, *words = row
    shown = [replace(cell, text=f"{cell.value:.{DIGITS}g}") for cell in (expected, got)]
    return (*shown, replace(error, text=f"{result.error:+.1e}{'' if result.holds else ' missed'}"), *words)


# ----------------------------------------------------------------------------------------------------------------------
# Every published number beside what gearwright finds, as one self-contained HTML page.
# ----------------------------------------------------------------------------------------------------------------------


def validation_page(sources: Sequence[tuple[Checked, ...]], *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the page; it makes no request to anywhere, and the same input gives the same bytes.

    Args:
        sources: Numbers of each source, as `by_source` yields them.
        stamp: Date of the page.
    """
    checked = [number for numbers in sources for number in numbers]
    missed = [number for number in checked if not number.holds]
    tone, word = (Tone.BAD, "Misses published numbers") if missed else (Tone.GOOD, "All published numbers come out")
    numbers = (
        Number("published numbers", f"{len(checked)}", "", float(len(checked))),
        Number("within their tolerance", f"{len(checked) - len(missed)}", "", float(len(checked) - len(missed))),
        Number("sources", f"{len(sources)}", "", float(len(sources))),
        Number("cases", f"{len({number.case for number in checked})}"),
    )
    sections = tuple(Section(results[0].source, (source_table(results),)) for results in sources if results)
    return set_page(
        Page("Validation", "gearwright against published numbers", "", Verdict(tone, word, verdict(checked)), numbers,
             sections, stamp=stamp,
             footer="Each tolerance has its reason; `gearwright validate --json` gives it with every number.")
    )  # fmt: skip
