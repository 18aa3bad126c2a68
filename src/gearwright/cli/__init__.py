"""The command line: each command calls the verb of its name and adds nothing.

Exit codes: 0 done, 1 a computation did not succeed, 2 the design or the call is wrong or a file cannot be written,
130 interrupted (Ctrl-C; 143 by SIGTERM, 129 by SIGHUP), 141 nobody reads what is printed any more (a closed pipe).
Heavy modules load inside the commands, so that ``--help`` answers at once.
"""

import errno
import gc
import sys
import warnings
from collections.abc import Callable
from copy import copy
from typing import Annotated, TextIO

import typer
from typer.main import get_command_name
from typer.models import CommandInfo

from gearwright.cli.answers import (
    BROKEN_PIPE,
    CTRL_C,
    FAILED,
    WRONG,
    ended_well,
    interrupted,
    is_interrupted,
    listening,
)
from gearwright.cli.commands.designs import (
    app as app_,
    arrange,
    check,
    close,
    modes,
    new,
    report,
    review,
    run,
    schema,
    simulate,
    size,
)
from gearwright.cli.commands.dynamics import campbell, response, runup, sharing, validate, window
from gearwright.cli.commands.exchange import draw, export, import_
from gearwright.cli.commands.flights import duty, engines, fly, mass, mix, propeller, rotor, turboshaft
from gearwright.cli.commands.replay import colibri, replay, thesis
from gearwright.cli.commands.search import architectures, optimise
from gearwright.cli.commands.studies import cluster, compare, merge, resume, status, study
from gearwright.cli.streams import flushed, steady_streams
from gearwright.cli.terminal import STANDARD_OUTPUT, Sections, show, tell
from gearwright.errors import DesignError, GearwrightError
from gearwright.notices import noticed
from gearwright.version import __version__

YOUNG = 250_000
"""Objects after which Python looks for cycles among them: modules that load make few, and a look takes a while:
`run` ends without one."""
COMMANDS: dict[str, tuple[Callable[..., None], ...]] = {
    "Designs": (new, app_, run, check, size, close, arrange, review, report, draw, export, import_, schema),
    "Dynamics": (modes, simulate, campbell, response, runup, sharing),
    "Flights": (fly, window, mix, duty, propeller, rotor, turboshaft),
    "Studies": (compare, architectures, optimise, study, status, resume, merge, cluster),
    "Mass and engines": (mass, engines),
    "Published work": (validate,),
}
"""Heading of ``--help`` -> its commands."""
app = typer.Typer(
    cls=Sections,
    help="Design aircraft transmissions and see how they behave.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
for _title, _commands in COMMANDS.items():
    for _command in _commands:
        app.command(rich_help_panel=_title)(ended_well(_command))
for _command in (thesis, colibri):  # older names of two replays
    app.command(hidden=True)(ended_well(_command))
app.add_typer(replay, rich_help_panel="Published work")


@app.callback(invoke_without_command=True)
@ended_well
def _main(version: Annotated[bool, typer.Option("--version", help="Print the version")] = False) -> None:
    if version:
        show(f"gearwright {__version__}")
        raise typer.Exit


def main() -> None:
    """Run the command line; design problems and failed computations become messages and exit codes."""
    gc.set_threshold(YOUNG)
    steady_streams()
    warnings.showwarning = _say
    with listening(), noticed(tell):
        code = _code()
    unwritten = flushed()
    sys.exit(code or (_unwritten(unwritten) if unwritten else 0))


def _code() -> int | str | None:
    """Run the command; return its exit code."""
    try:
        _asked(sys.argv[1:])()
    except SystemExit as end:
        return interrupted() if is_interrupted() and end.code in (FAILED, CTRL_C) else end.code
    except KeyboardInterrupt:
        return interrupted()
    except GearwrightError as error:
        tell(str(error))
        return WRONG if isinstance(error, DesignError) else FAILED
    except OSError as error:
        return _unwritten(error)
    return 0


def _asked(arguments: list[str]) -> typer.Typer:
    """Return the command that is asked for alone: typer reads the options of all that it has, a tenth of a second."""
    one = [known for known in app.registered_commands if [_name(known)] == arguments[:1]]
    if not one:
        return app
    asked = copy(app)
    asked.registered_commands, asked.registered_groups = one, []
    return asked


def _name(command: CommandInfo) -> str:
    return command.name or get_command_name(getattr(command.callback, "__name__", ""))


def _say(message: Warning | str, category: type[Warning], filename: str, lineno: int,
         file: TextIO | None = None, line: str | None = None) -> None:  # fmt: skip
    """Say a warning to the user; one about a word of a file without the place in gearwright's source."""
    from gearwright.spec.record import FormerWord

    said = issubclass(category, FormerWord)
    tell(str(message) if said else warnings.formatwarning(message, category, filename, lineno, line).rstrip())


def _unwritten(error: OSError) -> int:
    """Say which file or stream cannot be used; return the exit code."""
    if error.errno == errno.EPIPE:
        return BROKEN_PIPE
    if error.filename in (None, STANDARD_OUTPUT):
        tell(f"{STANDARD_OUTPUT} cannot be written: {error.strerror}")
        return FAILED
    tell(f"{error.filename}: {error.strerror}; name another file or folder")
    return WRONG
