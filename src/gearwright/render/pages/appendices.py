"""Appendices that pages share: what a file states and what is default, line by line."""

from __future__ import annotations

from collections.abc import Mapping

from markupsafe import Markup

from gearwright.render.pages.page import Section
from gearwright.render.style.templates import environment
from gearwright.render.words.inputs import Entry, entries
from gearwright.spec import Design, Mission
from gearwright.spec.lines import line_of

_ENTRIES = "entries.html.j2"


def inputs(written: Design | Mission, *, of: str, lines: Mapping[str, int], leaving: str = "") -> tuple[Section, ...]:
    """Return what a file states, and its defaults, as two appendices.

    Args:
        written: As read.
        of: Whose file it is, in a word.
        lines: Dotted path -> line in the file; empty where it is not known.
        leaving: Beginning of the paths that are left out.
    """
    listed = [entry for entry in entries(written) if not leaving or not entry.path.startswith(leaving)]
    given = [entry for entry in listed if entry.is_given]
    default = [entry for entry in listed if not entry.is_given]
    note = f"The {of} as read. What is left out there and has no default, gearwright chose."
    return (
        Section(f"Inputs: the {of} file", notes=(note,), content=_table(given, f"In the {of} file", lines)),
        Section("Defaults", content=_table(default, f"Defaults, not in the {of} file", {})),
    )


def _table(listed: list[Entry], caption: str, lines: Mapping[str, int]) -> Markup:
    at = {entry.path: line_in(entry.path, lines) for entry in listed}
    return Markup(environment().get_template(_ENTRIES).render(entries=listed, caption=caption, lines=at))


def line_in(path: str, lines: Mapping[str, int]) -> int | None:
    """Return the line that states a path, whose key has its unit behind it; the line of its table where none does.

    Args:
        path: Without the unit of its key.
        lines: Path as written -> line.
    """
    head = f"{path}_"
    exact = next((line for key, line in lines.items() if key == path or key.startswith(head)), None)
    return line_of(path, dict(lines)) if exact is None else exact
