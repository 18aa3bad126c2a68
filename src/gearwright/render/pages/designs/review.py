"""The page that goes into a design review: the verdict, requirement by requirement, and every kilogram."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from gearwright.ranking import largest_first
from gearwright.render.figures.treemap import treemap_figure
from gearwright.render.grid.table import Table, table
from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Number,
    Page,
    Section,
    Stamp,
    figure,
    judged,
    quantity,
    reserve,
    set_page,
)
from gearwright.render.tables.requirements import failed_table, met_table, open_table, order_table, waived_table
from gearwright.render.tables.sizing.masses import mass_sentence
from gearwright.render.words.headline import unneeded_text
from gearwright.reviews import Review
from gearwright.spec import Design
from gearwright.units import CELSIUS, text

HEAVIEST = 8
"""Parts of the complete mass that are listed one by one [-]."""
_FOOTER = "Margins of stresses include the asked factor; of a life L of which L_a is asked, (L/L_a)^(1/p)."
_FACTS = {
    "heat": "heat at rated load",
    "oil_flow": "oil flow",
    "fuel": "fuel of the mission",
    "battery_energy": "battery energy",
    "hottest_oil": "hottest oil in flight",
}
"""Facts of a review beside its masses -> how the page calls them."""


def review_page(review: Review, *, design: Design | None = None, stamp: Stamp = UNSTAMPED) -> str:
    """Return a review as one self-contained HTML page; the same input gives the same bytes.

    Args:
        review: Of a design.
        design: That it judges, for its hash.
        stamp: Date of the page.
    """
    flown = f"Flying {review.mission}." if review.mission else "On the ground: no mission is flown."
    return set_page(
        Page("Design review", review.design, flown, judged(review), tuple(_numbers(review)), _sections(review),
             design=design, stamp=stamp, footer=_FOOTER)
    )  # fmt: skip


def _numbers(review: Review) -> Iterator[Number]:
    """Yield what a reader asks first."""
    yield from reserve(review.worst)
    yield quantity("complete mass", review.complete.total, "mass", digits=3, band=review.complete.band, share="68 %")
    machines = float(review.facts["motor_mass"].value)
    if machines:
        with_them = f"with machines of {text(machines, 'mass', 3)}"
        yield quantity(with_them, review.complete.total + machines, "mass", digits=3)
    known = review.statistics
    if known.mass is not None and known.low is not None and known.high is not None:
        band = (known.low, known.high)
        yield quantity("61 real gearboxes", known.mass, "mass", digits=3, band=band, share="68 %")
    sides = [1e3 * float(review.facts[f"envelope.{side}"].value) for side in ("width", "height", "length")]
    yield Number("bodies: width, height, length", " × ".join(f"{side:.0f}" for side in sides), "mm")
    for name, words in _FACTS.items():
        if name in review.facts:
            value, dimension = review.facts[name]
            hottest = name == "hottest_oil"
            shift, shown_as = (CELSIUS, "temperature") if hottest else (0.0, dimension)
            yield quantity(words, float(value) - shift, shown_as, digits=3)


def _sections(review: Review) -> tuple[Section, ...]:
    """Return the chapters; one without content is left out."""
    mass = review.complete
    groups = table("Groups", mass.groups, ("group", "total", "share", "deviation"))
    heaviest = largest_first(mass.parts, lambda item: item.total)[:HEAVIEST]
    parts = table("Heaviest parts", heaviest, ("part", "group", "count", "each", "total", "uncertainty", "formula"))
    nothing = () if review.waived else ("Nothing is waived.",)
    waived = (*nothing, *(f"{unneeded_text(name)}." for name in review.unneeded))
    chapters = (
        Section("What fails, and what would help", tables=(failed_table(review.checks),)),
        Section("Requirement by requirement", tables=(met_table(review.checks),)),
        Section("Kilograms", (groups, parts), (_areas(review),), notes=(mass_sentence(mass, review.statistics),)),
        Section("Orders and natural frequencies", tables=(order_table(review.checks),)),
        Section("Waived by the design", tables=(waived_table(review.checks),), notes=waived),
        Section("Not assessed, and why", tables=(open_table(review.checks),)),
    )
    return tuple(section for section in chapters if section.notes or _rows(section.tables))


def _areas(review: Review) -> Figure:
    drawn = treemap_figure(review.complete, review.statistics.low, review.statistics.high)
    return figure(drawn, "kilograms", "Every part as an area, in the colour of its group; below, where the whole lies.")


def _rows(tables: tuple[Table, ...]) -> bool:
    return any(chain.from_iterable(part.rows for part in tables))
