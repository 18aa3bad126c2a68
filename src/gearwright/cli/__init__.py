"""The command line: each command calls the verb of its name and adds nothing.

Exit codes: 0 done, 1 a computation did not succeed, 2 the design or the call is wrong.
Heavy modules load inside the commands, so that ``--help`` answers at once.
"""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from gearwright.cli.colibri import colibri
from gearwright.cli.design import check, mass, modes, new, report, run, schema, simulate, size
from gearwright.cli.draw import draw
from gearwright.cli.dynamics import campbell, response, runup, validate
from gearwright.cli.mission import fly
from gearwright.cli.runs import cluster, resume, status
from gearwright.cli.sharing import sharing
from gearwright.cli.study import compare, study
from gearwright.cli.thesis import thesis
from gearwright.cli.weights import engines
from gearwright.cli.windows import window
from gearwright.version import __version__

app = typer.Typer(
    help="Design aircraft transmissions and see how they behave.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
COMMANDS = (
    *(new, run, check, size, modes, simulate, report, draw, schema),
    *(compare, study, status, resume, cluster),
    *(campbell, response, runup, sharing, fly, window),
    *(mass, engines, validate, thesis, colibri),
)
for _command in COMMANDS:
    app.command()(_command)


@app.callback(invoke_without_command=True)
def _main(version: Annotated[bool, typer.Option("--version", help="Print the version")] = False) -> None:
    if version:
        typer.echo(f"gearwright {__version__}")
        raise typer.Exit


def main() -> None:
    """Run the command line; design problems and failed computations become messages and exit codes."""
    from gearwright.errors import DesignError, GearwrightError

    try:
        app()
    except DesignError as error:
        typer.echo(str(error), err=True)
        sys.exit(2)
    except GearwrightError as error:
        typer.echo(str(error), err=True)
        sys.exit(1)
    except OSError as error:
        typer.echo(f"{error.filename}: {error.strerror}; name another file or folder", err=True)
        sys.exit(2)
