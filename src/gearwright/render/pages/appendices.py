"""Appendices that pages share: what a file states and what is default, line by line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from markupsafe import Markup

from gearwright.render.pages.page import Section
from gearwright.render.style.templates import environment
from gearwright.render.words.inputs import Entry
from gearwright.spec.lines import line_in

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
