"""Every published number beside what gearwright finds, as one self-contained HTML page."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.render.pages.page import UNSTAMPED, Number, Page, Section, Stamp, Tone, Verdict, set_page
from gearwright.render.tables.validation import source_table, verdict
from gearwright.validate import Checked


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
