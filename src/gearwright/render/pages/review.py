"""The page that goes into a design review: the verdict, requirement by requirement, and every kilogram."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from gearwright.render.grid.table import MARKS, Table, table
from gearwright.render.pages.report_parts import Section
from gearwright.render.style.templates import environment
from gearwright.render.tables.requirements import failed_table, met_table, open_table, order_table, waived_table
from gearwright.render.tables.sizing.masses import mass_sentence
from gearwright.render.words.headline import said_of, unneeded_text
from gearwright.reviews import Review, Verdict
from gearwright.units import CELSIUS, text
from gearwright.version import __version__

HEAVIEST = 8
"""Parts of the complete mass that are listed one by one [-]."""
_FACTS = {
    "heat": "heat at rated load",
    "oil_flow": "oil flow",
    "fuel": "fuel of the mission",
    "battery_energy": "battery energy",
    "hottest_oil": "hottest oil in flight",
}
"""Facts of a review beside its masses -> how the page calls them."""


def review_page(review: Review) -> str:
    """Return a review as one self-contained HTML page; the same input gives the same bytes.

    Args:
        review: Of a design.
    """
    flown = f"Flying {review.mission}." if review.mission else "On the ground: no mission is flown."
    return environment().get_template("review.html.j2").render(
        title=review.design, description=flown, verdict=str(review.verdict), said=_said(review),
        fails=review.verdict is Verdict.FAILS, numbers=tuple(_numbers(review)), sections=_sections(review), marks=MARKS,
        version=__version__,
    )  # fmt: skip


def _said(review: Review) -> str:
    """Return the headline without the verdict, which stands above it."""
    words = said_of(review)
    return f"{words[0].upper()}{words[1:]}."


def _numbers(review: Review) -> Iterator[tuple[str, str]]:
    """Yield what a reader asks first."""
    low, high = (text(mass, "mass", 3) for mass in review.complete.band)
    yield f"complete mass; 68 %: {low} to {high}", text(review.complete.total, "mass", 3)
    machines = float(review.facts["motor_mass"].value)
    if machines:
        yield f"with machines of {text(machines, 'mass', 3)}", text(review.complete.total + machines, "mass", 3)
    known = review.statistics
    if known.mass is not None and known.low is not None and known.high is not None:
        ends = f"{text(known.low, 'mass', 3)} to {text(known.high, 'mass', 3)}"
        yield f"61 real gearboxes; 68 %: {ends}", text(known.mass, "mass", 3)
    sides = [1e3 * float(review.facts[f"envelope.{side}"].value) for side in ("width", "height", "length")]
    yield "bodies: width, height, length", f"{' × '.join(f'{side:.0f}' for side in sides)} mm"
    for name, words in _FACTS.items():
        if name in review.facts:
            value, dimension = review.facts[name]
            yield words, _celsius(float(value)) if name == "hottest_oil" else text(float(value), dimension, 3)


def _celsius(temperature: float) -> str:
    """Return an absolute temperature as oil thermometers show it."""
    return text(temperature - CELSIUS, "temperature", 3)


def _sections(review: Review) -> tuple[Section, ...]:
    """Return the chapters; one without content is left out."""
    mass = review.complete
    groups = table("Groups", mass.groups, ("group", "total", "share", "deviation"))
    heaviest = sorted(mass.parts, key=lambda item: -item.total)[:HEAVIEST]
    parts = table("Heaviest parts", heaviest, ("part", "group", "count", "each", "total", "uncertainty", "formula"))
    nothing = () if review.waived else ("Nothing is waived.",)
    waived = (*nothing, *(f"{unneeded_text(name)}." for name in review.unneeded))
    chapters = (
        Section("What fails, and what would help", tables=(failed_table(review.checks),)),
        Section("Requirement by requirement", tables=(met_table(review.checks),)),
        Section("Kilograms", tables=(groups, parts), notes=(mass_sentence(mass, review.statistics),)),
        Section("Orders and natural frequencies", tables=(order_table(review.checks),)),
        Section("Waived by the design", tables=(waived_table(review.checks),), notes=waived),
        Section("Not assessed, and why", tables=(open_table(review.checks),)),
    )
    return tuple(section for section in chapters if section.notes or _rows(section.tables))


def _rows(tables: tuple[Table, ...]) -> bool:
    return any(chain.from_iterable(part.rows for part in tables))
