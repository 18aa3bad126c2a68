"""Enumerated architectures as one page: the answer, what the best look like, all that were looked at."""

from __future__ import annotations

from collections.abc import Iterator

from markupsafe import Markup

from gearwright.enumeration import Ranking
from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Number,
    Page,
    Section,
    Stamp,
    Tone,
    Verdict,
    quantity,
    set_page,
)
from gearwright.render.schematic.schematic import schematic_figure
from gearwright.render.style import theme
from gearwright.render.tables.study.architectures import SHOWN, architectures_table
from gearwright.render.tables.study.equal_life import equal_life_table, group_table
from gearwright.render.words.architectures import lightest_sentence, ranking_sentences
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import complete_mass
from gearwright.spec import parse
from gearwright.study import EqualLife
from gearwright.units import text

DRAWN = 12
"""Closed designs that are drawn, the lightest first [-]."""
_HEAD = 5
"""Designs in the head [-]."""


def architectures_page(ranking: Ranking, *, turning: str = "", stamp: Stamp = UNSTAMPED) -> str:
    """Return the ranking as one self-contained HTML page; the same input gives the same bytes.

    Args:
        ranking: From `architectures`.
        turning: Name of the page beside it on which the lightest turns; empty where there is none.
        stamp: Date of the page.
    """
    sized = {row.title: size(parse(row.file)) for row in ranking.closed if row.file}
    said = tuple(ranking_sentences(ranking))
    life = text(ranking.life, "life", 3)
    masses = {name: complete_mass(one) for name, one in sized.items()}
    looks = (
        Section("What they look like", figures=tuple(_drawn(ranking, sized)), content=_link(ranking, turning)),
        Section("Where the mass is", tables=(group_table(masses),)),
    )
    sections = (
        Section("At equal life", tables=(equal_life_table(ranking.closed, f"Closed for {life}"),), listed=said),
        *(looks if sized else ()),
        Section(
            f"The {min(SHOWN, len(ranking.candidates))} most promising of {len(ranking.candidates)}",
            tables=(architectures_table(ranking.candidates[:SHOWN], ""),),
        ),
    )
    description = "Every train of a few stages that can give the ratio, with every place for the motor."
    return set_page(
        Page("Architectures", ranking.requirement, description, _verdict(ranking, said), tuple(_numbers(ranking)),
             sections, stamp=stamp)
    )  # fmt: skip


def _verdict(ranking: Ranking, said: tuple[str, ...]) -> Verdict:
    """Return whether any meets everything; that others do not is told beside."""
    passing, closed = len(ranking.passing), len(ranking.closed)
    if not closed:
        return Verdict(Tone.OPEN, "None is closed yet", said[-1])
    if not passing:
        return Verdict(Tone.BAD, "None meets everything", said[-1])
    word = f"{passing} of {closed} closed designs pass as far as assessed"
    return Verdict(Tone.OPEN, word, lightest_sentence(ranking))


def _numbers(ranking: Ranking) -> Iterator[Number]:
    """Yield the lightest that pass, with the band of the gearbox."""
    for row in ranking.passing[:_HEAD]:
        yield quantity(f"{ranking.called(row)}, with machines", row.with_machines or 0.0, "mass", digits=3)


def _drawn(ranking: Ranking, sized: dict[str, Sizing]) -> Iterator[Figure]:
    """Yield the skeletons of the lightest."""
    for row in [row for row in ranking.closed if row.title in sized][:DRAWN]:
        svg = theme.to_svg(schematic_figure(sized[row.title]), row.title)
        yield Figure(svg, f"{ranking.called(row)}: {_weight(row)}, {row.verdict}.")


def _link(ranking: Ranking, turning: str) -> Markup:
    """Return where the lightest turns."""
    if not turning or not ranking.passing:
        return Markup()
    words = f"The lightest, {ranking.called(ranking.passing[0])}, as solids that turn"
    return Markup('<p><a href="{}">{}</a></p>').format(turning, words)


def _weight(row: EqualLife) -> str:
    return f"{text(row.with_machines or 0.0, 'mass', 3)} with machines"
