"""Makes the reference of the command line from the commands themselves."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from typing import Any, get_args, get_origin, get_type_hints

from gearwright.cli import COMMANDS
from gearwright.cli.commands.replay import COMMANDS as REPLAYS

_HEAD = """# The command line

Every command with its arguments and options; `gearwright COMMAND --help` says the same. What is printed for machines
and what the exit codes mean: [use it in scripts](../how-to/scripts.md). This page is made from the commands.

`gearwright --install-completion` lets the shell complete commands, options, shipped designs, missions and studies, and
files; `--show-completion` prints what it would install.
"""
_COLUMNS = "| | default | meaning |\n| --- | --- | --- |\n"


def commands_markdown() -> str:
    """Return the page."""
    parts = [_HEAD]
    for title, commands in COMMANDS.items():
        parts.append(f"\n## {title}\n")
        parts += [_command(command.__name__, command) for command in commands]
    parts += [_command(f"replay {name}", command) for name, command in REPLAYS.items()]
    return "".join(parts)


def _command(name: str, command: Callable[..., None]) -> str:
    words = " ".join((inspect.getdoc(command) or "").split())
    return f"\n### `gearwright {name}`\n\n{words}\n\n{_COLUMNS}{''.join(_rows(command))}"


def _rows(command: Callable[..., None]) -> Iterator[str]:
    hints = get_type_hints(command, include_extras=True)
    for name, parameter in inspect.signature(command).parameters.items():
        kind, mark = get_args(hints[name])[0], hints[name].__metadata__[0]
        flag = _flag(name, mark)
        yield f"| `{flag}` | {_default(kind, parameter.default)} | {str(mark.help).replace('|', chr(92) + '|')} |\n"


def _flag(name: str, mark: Any) -> str:
    """Return what is written: an argument by its place, an option by its name."""
    if type(mark).__name__ == "ArgumentInfo":
        return str(mark.metavar or name.upper()).strip("[]")
    written = (mark.default, *(mark.param_decls or ()))
    return next((str(word) for word in written if str(word).startswith("--")), f"--{name.replace('_', '-')}")


def _default(kind: Any, default: Any) -> str:
    if default is inspect.Parameter.empty:
        return "**required**"
    if default is None or default is False or default == "" or get_origin(kind) is list:
        return "–"
    return f"`{getattr(default, 'value', default)}`"
