"""The list of commands that ``--help`` shows: in sections, every summary whole.

Typer's own list cuts each summary to one line and loads rich's Markdown, which takes longer than all the rest.
"""

from __future__ import annotations

from collections import defaultdict
from typing import Any

from typer import BadParameter
from typer.core import TyperGroup


class Sections(TyperGroup):
    """A group of commands listed under their headings, which typer calls panels."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the list.

        Args:
            ctx: Of the call.
            formatter: Writes the help.
        """
        listed = defaultdict[str, list[tuple[str, str]]](list)
        for name, command in self.commands.items():
            if not command.hidden:
                title = getattr(command, "rich_help_panel", None)
                listed[title if isinstance(title, str) else "Commands"].append((name, _summary(command.help or "")))
        for title, rows in listed.items():
            with formatter.section(title):
                formatter.write_dl(rows)

    def invoke(self, ctx: Any) -> Any:
        """Call the command; what is wrong with an option is said without the words of the library that found it.

        Args:
            ctx: Of the call.
        """
        try:
            return super().invoke(ctx)
        except BadParameter as error:
            error.message = error.message.removeprefix("Value error, ")
            raise


def _summary(help_text: str) -> str:
    """Return the first sentence of a command's help.

    >>> _summary("Size a design: teeth, masses.")
    'Size a design: teeth, masses'
    """
    return help_text.partition("\n\n")[0].replace("\n", " ").strip().removesuffix(".")
