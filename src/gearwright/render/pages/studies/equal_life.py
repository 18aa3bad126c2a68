"""Architectures at equal life as one page: which is lightest with its machines, how long it lives, what fails."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.render.pages.page import UNSTAMPED, Number, Page, Section, Stamp, Tone, Verdict, quantity, set_page
from gearwright.render.tables.study.equal_life import equal_life_table, group_table
from gearwright.sizing import size
from gearwright.sizing.mass import complete_mass
from gearwright.spec import parse
from gearwright.study.running.equal_life import EqualLife
from gearwright.units import text

_SHOWN = 5
"""Designs in the head [-]."""


def equal_life_page(rows: Sequence[EqualLife], title: str, *, stamp: Stamp = UNSTAMPED) -> str:
    """Return designs at equal life as one self-contained HTML page; the same input gives the same bytes.

    Args:
        rows: In their order.
        title: In words.
        stamp: Date of the page.
    """
    masses = {row.title: complete_mass(size(parse(row.file))) for row in rows if row.file}
    sections = [
        Section("Masses, lives and verdicts", tables=(equal_life_table(rows, title),), notes=_told(rows)),
        Section("Where the mass is", tables=(group_table(masses),)),
        Section("The sum of parts beside real gearboxes", notes=_beside(rows)),
    ]
    description = "Each design with every free size chosen, and judged by a review of its own."
    return set_page(
        Page("Comparison at equal life", title, description, _verdict(rows), tuple(_numbers(rows)), tuple(sections),
             stamp=stamp)
    )  # fmt: skip


def _verdict(rows: Sequence[EqualLife]) -> Verdict:
    """Return how many designs meet everything; one that does not keeps the page from saying that all is well."""
    failing, told = sum(bool(row.fails) for row in rows), _told(rows)
    said = told[0] if told else "No design is compared."
    if failing:
        return Verdict(Tone.BAD, f"{failing} of {len(rows)} designs do not meet everything", said)
    return Verdict(Tone.OPEN, "All pass as far as assessed", said)


def _numbers(rows: Sequence[EqualLife]) -> Iterator[Number]:
    """Yield the lightest that pass."""
    for row in [row for row in rows if not row.fails and row.with_machines is not None][:_SHOWN]:
        yield quantity(f"{row.title}, with machines", row.with_machines or 0.0, "mass", digits=3)


def _told(rows: Sequence[EqualLife]) -> tuple[str, ...]:
    """Return who is lightest, and who meets not everything and by what."""
    passing = [row for row in rows if not row.fails and row.with_machines is not None]
    first = () if not passing else (_lightest(passing[0]),)
    return first + tuple(f"{row.title} does not meet everything: {row.fails}." for row in rows if row.fails)


def _lightest(row: EqualLife) -> str:
    machines = f" with machines of {text(row.machines, 'mass', 3)}" if row.machines else ""
    weighs = text(row.with_machines or 0.0, "mass", 3)
    return f"The lightest that passes as far as assessed: {row.title}, {weighs}{machines}."


def _beside(rows: Sequence[EqualLife]) -> tuple[str, ...]:
    return tuple(f"{row.title}: {row.statistics.sentence}" for row in rows if row.statistics is not None)
