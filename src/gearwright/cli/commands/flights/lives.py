"""The commands ``mix`` and ``duty``: a life of several missions, and measured torque over time as a load spectrum.

Imports that cost time stand inside the commands, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.completion import mixes
from gearwright.cli.designs import sized
from gearwright.cli.options import DesignArgument, JsonOption
from gearwright.cli.terminal.output import show, show_commands, tell
from gearwright.writing import write_text

MACHINE = "MACHINE"
"""Stands for a machine in the text for a design where none is named."""


def mix(
    design: DesignArgument,
    mix: Annotated[
        str, typer.Argument(help="Mix file, or the name of a shipped mix", metavar="MIX", autocompletion=mixes)
    ] = "regional-life",
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
    json: JsonOption = False,
) -> None:
    """Fly a life of several missions: what fails first, which mission eats the life, fuel and charge of all flights."""
    from gearwright.errors import DesignError
    from gearwright.mission import fly_mix
    from gearwright.render.answers.flights.mix import mix_answer
    from gearwright.render.words.flights.mix import mix_text
    from gearwright.shipped import find_mix
    from gearwright.spec import file_text, placed, read_mix

    asked, sizing = read_mix(mix), sized(design)
    try:
        flown = fly_mix(sizing, asked)
    except DesignError as error:
        raise DesignError(placed(error.problems, file_text(find_mix(mix))), mix) from None
    if json:
        show_answer("mix", mix_answer(flown), design=sizing.design.name)
    else:
        show(mix_text(flown))
    if report is not None:
        from gearwright.render.pages.mix import mix_page

        write_text(report, mix_page(flown))
        tell(f"wrote {report}")


def duty(
    file: Annotated[
        Path,
        typer.Argument(
            help="CSV file; its first line names columns with units: time_s, torque_nm or power_kw, speed_rpm",
            metavar="FILE",
        ),
    ],
    classes: Annotated[int, typer.Option(help="Classes of torque, of equal width", min=1, max=1000)] = 20,
    machine: Annotated[str, typer.Option(help="Machine of the design that gave what was measured")] = MACHINE,
    name: Annotated[str, typer.Option(help="Of load case and spectrum")] = "measured",
    out: Annotated[Path | None, typer.Option(help="Write load case and spectrum to this file, as TOML")] = None,
    cycles: Annotated[
        Literal["half-cycles", "repeated"] | None,
        typer.Option(help="Count cycles of torque for shafts, too, by rainflow; says what becomes of the residue"),
    ] = None,
    json: JsonOption = False,
) -> None:
    """Count measured torque over time into a load spectrum, and write it as a load case of a design."""
    from gearwright.mission import duty_spectrum, read_duty
    from gearwright.render.answers.flights.duty import duty_answer
    from gearwright.render.words.flights.duty import cycles_text, duty_text

    measured = read_duty(file)
    spectrum = duty_spectrum(measured, classes=classes)
    text = spectrum.text(machine, name)
    if json:
        show_answer("duty", duty_answer(measured, spectrum, text, cycles))
    else:
        show(duty_text(measured, spectrum))
        if cycles is not None:
            show(cycles_text(measured, cycles))
        fill = f", with the name of its machine for {MACHINE} (or from --machine)" if machine == MACHINE else ""
        show(f"For a design file{fill}:\n")
        show_commands(text.rstrip())
    if out is not None:
        write_text(out, text)
        tell(f"wrote {out}")
