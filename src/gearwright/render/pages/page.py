"""What every page has: templates with their filters, a head with verdict and key numbers, contents, sections."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cache
from hashlib import sha256
from types import MappingProxyType
from typing import Any, NamedTuple

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from gearwright.base import Check, Origin, margin_text, number_text, shown, unit, written
from gearwright.render import live, style as theme, uplot
from gearwright.render.grid import MARKS, Table
from gearwright.render.style import mathml
from gearwright.render.vector.figure import Figure as Drawing
from gearwright.render.vector.live import Numbers, live_panels
from gearwright.render.vector.svg import style_of
from gearwright.render.words.design_file import Entry
from gearwright.render.words.sizing import said_of, sizing_headline
from gearwright.reviews import Review, Verdict as Judgement
from gearwright.sizing import Sizing
from gearwright.spec import Design, line_in
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# Where the templates of the HTML pages are, with the filters that they use.
# ----------------------------------------------------------------------------------------------------------------------


_SUBSCRIPT = re.compile(
    r"`([^`]+)`|(?<![\w.])([A-Za-zα-ωΑ-Ω]{1,2}[′*]?)_([A-Za-z0-9α-ω.]*[A-Za-z0-9α-ω])(?![A-Za-z0-9_α-ω])"
)
"""Code between backticks, or a symbol of one or two letters with its index: keys of files have longer names."""


@cache
def environment(package: str = "gearwright.render") -> Environment:
    """Return where the templates of a package are, with the filter that all of them use.

    Args:
        package: The one beside whose modules the folder ``templates`` is.
    """
    templates = Environment(
        loader=PackageLoader(package),
        autoescape=_is_html,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    templates.filters["symbols"] = symbols
    templates.filters["mathml"] = _mathematics
    templates.filters["exact"] = exact
    templates.filters["lean"] = lean
    return templates


def _is_html(template: str | None) -> bool:
    """Tell whether a template is HTML; Markdown is left as it is."""
    return template is None or ".html" in template


def symbols(words: str) -> Markup:
    """Return words whose ``m_n`` and the like are set with a subscript.

    Args:
        words: An equation or a symbol.
    """
    return Markup(_SUBSCRIPT.sub(_set, str(escape(words))))


def exact(number: float, text: str) -> Markup:
    """Return the attribute that holds a number's further digits; nothing where its text has all of them.

    Args:
        number: Of a cell.
        text: As it is read.
    """
    value = f"{number:.7g}"
    try:
        said = float(text.replace("−", "-"))
    except ValueError:
        return Markup(f" data-v={value}")
    return Markup("" if said == float(value) else f" data-v={value}")


def _set(match: re.Match[str]) -> str:
    code, symbol, index = match.groups()
    return f"<code>{code}</code>" if code else f"{symbol}<sub>{index}</sub>"


_INDENTED = re.compile(r"^[ \t]+|^/\*[^\n]*\*/\n", re.MULTILINE)


def lean(script: str) -> Markup:
    """Return a script or a style of ours without what only its readers need: indents, and comments of one line.

    Args:
        script: Without texts of several lines.
    """
    return Markup(_INDENTED.sub("", script))


def _mathematics(formula: str) -> Markup:
    return Markup(mathml(formula))


# ----------------------------------------------------------------------------------------------------------------------
# What every page has: a head with the verdict and key numbers, contents, numbered sections, appendices.
# ----------------------------------------------------------------------------------------------------------------------


_NONE = Markup()
_HASH = 12
"""Digits of a design's hash."""


class Tone(StrEnum):
    """Colour of a verdict; its word says the same."""

    GOOD = "good"
    OPEN = "open"
    BAD = "bad"


@dataclass(frozen=True)
class Verdict:
    """What a page says first, and never more than the worst thing on it."""

    tone: Tone
    word: str
    """In one or two words."""
    said: str
    """In a sentence."""


@dataclass(frozen=True)
class Number:
    """A key number of the head."""

    name: str
    text: str
    """As it is read, without its unit."""
    unit: str = ""
    value: float | None = None
    """In the unit; None for words."""
    band: tuple[float, float] | None = None
    """Least and most, in the unit."""
    share: str = ""
    """What the band holds, such as ``68 %``."""
    origin: Origin | None = None
    """Equation and source."""


@dataclass(frozen=True)
class PageFigure:
    """A figure in the page."""

    svg: str
    caption: str
    name: str = ""
    """Of its ids."""
    drawing: Drawing | None = None
    """What a page draws anew where a reader points."""


def figure(drawing: Drawing, name: str, caption: str) -> PageFigure:
    """Return a figure of a page.

    Args:
        drawing: As drawn.
        name: Goes before its ids.
        caption: Below it.
    """
    return PageFigure(theme.to_svg(drawing, name, styled=False), caption, name, drawing)


@dataclass(frozen=True)
class Section:
    """A chapter of a page."""

    title: str
    tables: tuple[Table, ...] = ()
    figures: tuple[PageFigure, ...] = ()
    notes: tuple[str, ...] = ()
    listed: tuple[str, ...] = ()
    """Sentences as a list, before all else."""
    content: Markup = _NONE
    """What a page sets itself, after all else."""


@dataclass(frozen=True)
class Formula:
    """An equation that made a column of a table."""

    quantity: str
    symbol: str
    equation: str
    source: str


@dataclass(frozen=True)
class Stamp:
    """What the caller knows of a page and its input does not."""

    date: str = ""
    """Of the page; none by itself, so that the same input gives the same bytes."""
    lines: Mapping[str, int] = field(default_factory=lambda: MappingProxyType({}))
    """Dotted path -> line in the design file."""


UNSTAMPED = Stamp()


@dataclass(frozen=True)
class Page:
    """A page before it is set."""

    kind: str
    """Such as ``Design review``."""
    title: str
    description: str
    verdict: Verdict
    numbers: tuple[Number, ...]
    sections: tuple[Section, ...]
    appendices: tuple[Section, ...] = ()
    design: Design | None = None
    """Whose hash the head shows."""
    stamp: Stamp = UNSTAMPED
    footer: str = "Everything inside is SI; units of the screen are mm, MPa, N, N m, kW, rpm."


def quantity(
    name: str,
    value: float,
    dimension: str,
    *,
    digits: int = 4,
    band: tuple[float, float] | None = None,
    share: str = "",
    origin: Origin | None = None,
) -> Number:
    """Return a key number with its unit.

    Args:
        name: In words.
        value: In SI.
        dimension: Key of the units.
        digits: Significant digits [-].
        band: Least and most, in SI.
        share: What the band holds.
        origin: Equation and source.
    """
    number = shown(value, dimension)
    ends = None if band is None else (shown(band[0], dimension), shown(band[1], dimension))
    return Number(name, number_text(value, dimension, digits), unit(dimension), number, ends, share, origin)


_TONES = {Judgement.FAILS: Tone.BAD, Judgement.PASSES_SO_FAR: Tone.OPEN, Judgement.PASSES: Tone.GOOD}


def judged(review: Review) -> Verdict:
    """Return the verdict of a review.

    Args:
        review: Of a design.
    """
    return Verdict(_TONES[review.verdict], _capital(str(review.verdict)), f"{_capital(said_of(review))}.")


def judged_by_sizing(sizing: Sizing) -> Verdict:
    """Return what a sizing alone can say: it fails, or it passes as far as assessed.

    Args:
        sizing: As sized.
    """
    failing = any(check.fails for check in sizing.checks)
    tone, word = (Tone.BAD, "Fails") if failing else (Tone.OPEN, "Passes as far as assessed")
    return Verdict(tone, word, f"{_capital(sizing_headline(sizing))}.")


def worst_of(verdicts: Iterable[Verdict]) -> Tone:
    """Return the worst tone of some verdicts; none at all leaves it open.

    Args:
        verdicts: Of what stands on a page.
    """
    tones = [verdict.tone for verdict in verdicts]
    return next((tone for tone in (Tone.BAD, Tone.OPEN) if tone in tones), Tone.GOOD if tones else Tone.OPEN)


def reserve(check: Check | None) -> tuple[Number, ...]:
    """Return the margin of the worst check as a key number.

    Args:
        check: The worst; None where none is assessed.
    """
    if check is None or check.margin is None:
        return ()
    origin = Origin("margin", f"{check.clause}; {check.part}: {check.what}")
    return (Number(f"worst margin: {check.part}", margin_text(check.margin), "", check.margin, origin=origin),)


def hash_of(design: Design) -> str:
    """Return the digest of what a design states; blanks, comments and the order of keys do not move it.

    Args:
        design: As read.
    """
    stated = json.loads(design.model_dump_json(by_alias=True, exclude_unset=True))
    return sha256(json.dumps(stated, sort_keys=True).encode()).hexdigest()[:_HASH]


def formulas(tables: Iterable[Table]) -> tuple[Formula, ...]:
    """Return every equation behind the columns of some tables, once each, in order.

    Args:
        tables: Of the page.
    """
    listed = {
        (column.header, origin.equation): Formula(column.header, column.symbol, origin.equation, origin.source)
        for table in tables
        for column in table.columns
        for origin in column.listed_origins
    }
    return tuple(listed.values())


def set_page(page: Page) -> str:
    """Return a page as self-contained HTML; the same input gives the same bytes.

    Args:
        page: With all that stands on it.
    """
    sections = (*page.sections, *page.appendices)
    known = formulas(table for section in sections for table in section.tables)
    drawn = [drawing for section in sections for drawing in section.figures]
    alive = _live(drawn)
    return environment().get_template("page.html.j2").render(
        page=page,
        live=alive,
        colours=Markup(style_of("".join(drawing.svg for drawing in drawn))),
        formulas=known,
        anchors={(formula.quantity, formula.equation): f"f{k}" for k, formula in enumerate(known, start=1)},
        hash=hash_of(page.design) if page.design is not None else "",
        marks=MARKS,
        written=written,
        version=__version__,
    )  # fmt: skip


def _live(drawn: Iterable[PageFigure]) -> dict[str, Any]:
    """Return what figures need to answer a pointer, by their names; nothing where none does."""
    numbers = Numbers()
    panels = {each.name: live_panels(each.drawing, numbers) for each in drawn if each.drawing is not None}
    panels = {name: records for name, records in panels.items() if records}
    if not panels:
        return {}
    across = any(record.get("k") == "parallel" for records in panels.values() for record in records)
    return {"names": set(panels), "given": numbers.packed(panels, _scripts(parallel=across))}


@cache
def _scripts(*, parallel: bool) -> tuple[str, ...]:
    own = (*live.OWN, *([live.PARALLEL] if parallel else []))
    return (uplot.text("uplot.min.js"), *(live.text(name) for name in own))


def _capital(words: str) -> str:
    return f"{words[:1].upper()}{words[1:]}"


# ----------------------------------------------------------------------------------------------------------------------
# Appendices that pages share: what a file states and what is default, line by line.
# ----------------------------------------------------------------------------------------------------------------------


_ENTRIES = "entries.html.j2"


def inputs(listed: Sequence[Entry], *, of: str, lines: Mapping[str, int]) -> tuple[Section, ...]:
    """Return what a file states, and its defaults, as two appendices.

    Args:
        listed: Entries of the file as read.
        of: Whose file it is, in a word.
        lines: Dotted path -> line in the file; empty where it is not known.
    """
    given = [entry for entry in listed if entry.is_given]
    default = [entry for entry in listed if not entry.is_given]
    note = f"The {of} as read. What is left out there and has no default, gearwright chose."
    return (
        Section(f"Inputs: the {of} file", notes=(note,), content=_table(given, f"In the {of} file", lines)),
        Section("Defaults", content=_table(default, f"Defaults, not in the {of} file", {})),
    )


def _table(listed: list[Entry], caption: str, lines: Mapping[str, int]) -> Markup:
    at = {entry.path: line_in(entry.path, lines) for entry in listed}
    rows: dict[tuple[str, ...], list[str]] = {}
    for entry in listed:
        alone = entry.path if at[entry.path] else entry.key
        rows.setdefault((alone, entry.value, entry.meaning), []).append(entry.path)
    merged = [_Row(tuple(paths), value, meaning) for (_, value, meaning), paths in rows.items()]
    return Markup(environment().get_template(_ENTRIES).render(entries=merged, caption=caption, lines=at))


class _Row(NamedTuple):
    """Entries of one name, value and meaning, such as those of every stage; one that has a line stands alone."""

    paths: tuple[str, ...]
    value: str
    meaning: str
