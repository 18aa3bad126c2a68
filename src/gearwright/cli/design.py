"""Commands of one design: new, check, size, modes, simulate, run, report, mass, schema."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from gearwright.cli.designs import sized
from gearwright.cli.ends import end_interrupted, named_after, save_run
from gearwright.cli.options import CaseOption, DesignArgument, JsonOption
from gearwright.cli.output import progress, show, show_json, tell
from gearwright.cli.weights import show_mass, stated_mass
from gearwright.writing import make_folder, write_text

if TYPE_CHECKING:
    from gearwright.dynamics import System, Trace
    from gearwright.sizing import Sizing
    from gearwright.store import StoredRun

WINDOW = 0.005
"""Last stretch of a run of which every step is kept, for spectra and close views [s]."""

StiffnessOption = Annotated[
    Literal["constant", "varying"] | None, typer.Option(help="Mesh stiffness; left out: as the design says")
]
DurationOption = Annotated[float, typer.Option(help="Time to simulate [s]", min=0.0)]


def new(
    name: Annotated[str | None, typer.Argument(help="A shipped design, mission or study; left out: list them")] = None,
    file: Annotated[Path | None, typer.Argument(help="File to write; left out: NAME.toml here")] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that is there")] = False,
) -> None:
    """Write a shipped design, mission or study as a file to start from, or list all of them."""
    from gearwright.errors import DesignError, Problem
    from gearwright.shipped import shipped_file

    if name is None:
        _list()
        return
    source = shipped_file(name)
    text = source.read_text(encoding="utf-8")
    target = file or Path(f"{name}.toml")
    if target.exists() and not force:
        raise DesignError(
            [Problem("", "the file is there already; give another name, or --force to replace it")], str(target)
        )
    write_text(target, text)
    follows = {"designs": "run", "missions": "fly DESIGN", "studies": "study"}[source.parent.name]
    show(f"wrote {target}; next: gearwright {follows} {target}")


def _list() -> None:
    """Print every shipped file with its name, under what it is."""
    from gearwright.shipped import (
        shipped_design,
        shipped_designs,
        shipped_mission,
        shipped_missions,
        shipped_studies,
        shipped_study,
    )
    from gearwright.spec import read, read_mission, read_study

    show("designs")
    for name in shipped_designs():
        show(f"{name:24} {read(shipped_design(name)).name}")
    show("\nmissions")
    for name in shipped_missions():
        show(f"{name:24} {read_mission(shipped_mission(name)).name}")
    show("\nstudies")
    for name in shipped_studies():
        show(f"{name:24} {read_study(shipped_study(name)).name}")


def check(design: DesignArgument) -> None:
    """Check a design file and say everything that is wrong with it; a margin below 1 ends with exit code 1."""
    from gearwright.dynamics.assembly import assemble
    from gearwright.render.tables.checks import check_sentence

    sizing = sized(design)
    for case in sizing.flows:  # what the dynamic model would refuse is said here
        assemble(sizing, case)
    weak = [check for check in sizing.checks if check.fails]
    for check in weak:
        tell(f"{check_sentence(check)}; the margin should be 1 or more")
    if weak:
        raise typer.Exit(1)
    show(f"{sizing.design.name}: no problems; {len(sizing.gears)} kinds of gears, {len(sizing.shafts)} shafts")


def size(
    design: DesignArgument,
    json: JsonOption = False,
    factors: Annotated[
        bool, typer.Option("--factors", help="Print every factor of the gears that ISO 6336 or ISO 10300 rates")
    ] = False,
) -> None:
    """Size a design: teeth, modules, stresses, margins, shafts, carriers, masses."""
    from gearwright.render.words.text import factors_text, sizing_json, sizing_text

    sizing = sized(design)
    if json:
        show_json(sizing_json(sizing))
    else:
        show(sizing_text(sizing), *([factors_text(sizing)] if factors else []))


def modes(design: DesignArgument, case: CaseOption = None, json: JsonOption = False) -> None:
    """Natural frequencies and mode shapes of a design's drive train."""
    from gearwright.dynamics import modes as find_modes
    from gearwright.render.words.text import modes_json, modes_text

    solved = find_modes(_assemble(sized(design), case))
    if json:
        show_json(modes_json(solved))
    else:
        show(modes_text(solved))


def simulate(
    design: DesignArgument,
    case: CaseOption = None,
    duration: DurationOption = 0.2,
    stiffness: StiffnessOption = None,
    output: Annotated[Path | None, typer.Option(help="Write the run to this netCDF-4 file")] = None,
    json: JsonOption = False,
) -> None:
    """Simulate a design's drive train in a load case."""
    from gearwright.dynamics.assembly import default_case
    from gearwright.render.words.text import trace_json, trace_text

    sizing = sized(design)
    system = _assemble(sizing, case, stiffness)
    trace = _simulate(system, duration)
    kept = save_run(output, trace, sizing, case or default_case(sizing)) if output is not None else None
    if json:
        show_json(trace_json(trace))
    else:
        show(trace_text(trace, sizing))
    end_interrupted(trace, kept)


def run(
    design: DesignArgument,
    case: CaseOption = None,
    duration: DurationOption = 0.2,
    stiffness: StiffnessOption = None,
    folder: Annotated[
        Path | None, typer.Option("--out", help="Folder for the results; left out: NAME-results here")
    ] = None,
) -> None:
    """Do everything: size, find modes, simulate, and write the report and the results."""
    from gearwright.dynamics import modes as find_modes
    from gearwright.dynamics.assembly import default_case
    from gearwright.dynamics.vibration import critical_speeds
    from gearwright.render.pages.report import report as make_report
    from gearwright.render.words.text import modes_text, sizing_json, sizing_text, trace_text

    sizing = sized(design)
    case = case or default_case(sizing)
    system = _assemble(sizing, case, stiffness)
    solved = find_modes(system)
    trace = _simulate(system, duration)
    campbell = () if trace.interrupted else critical_speeds(sizing)
    show(sizing_text(sizing, trace=trace, campbell=campbell), modes_text(solved), trace_text(trace, sizing))
    folder = folder or named_after(design, "results")
    make_folder(folder)
    write_text(folder / "sizing.json", sizing_json(sizing) + "\n")
    end_interrupted(trace, save_run(folder / "run.nc", trace, sizing, case))
    page = make_report(sizing, modes=solved, trace=trace, case=case, system=system, campbell=campbell)
    write_text(folder / "report.html", page)
    show(f"wrote {folder / 'report.html'}, {folder / 'run.nc'} and {folder / 'sizing.json'}")


def report(
    design: DesignArgument,
    file: Annotated[
        Path | None, typer.Option("--out", help="HTML file to write; left out: NAME-report.html here")
    ] = None,
    results: Annotated[Path | None, typer.Option(help="Run (netCDF-4) to show with it")] = None,
) -> None:
    """Write the report of a design as one self-contained HTML file that also prints well."""
    from gearwright.dynamics import modes as find_modes
    from gearwright.dynamics.assembly import default_case
    from gearwright.dynamics.vibration import critical_speeds
    from gearwright.render.pages.report import report as make_report

    sizing = sized(design)
    stored = _run_of(sizing, results) if results is not None else None
    case = stored.case if stored else default_case(sizing)
    system = _assemble(sizing, case)
    page = make_report(
        sizing,
        modes=find_modes(system),
        trace=stored.trace if stored else None,
        case=case,
        system=system,
        campbell=critical_speeds(sizing),
    )
    file = file or named_after(design, "report.html")
    write_text(file, page)
    show(f"wrote {file}")


def mass(
    power_kw: Annotated[float, typer.Option(help="Power at the rating that sizes the gearbox")],
    engine_rpm: Annotated[float, typer.Option(help="Speed of the input")],
    propeller_rpm: Annotated[float, typer.Option(help="Speed of the propeller or rotor")],
    design: Annotated[str | None, typer.Option(help="Design whose parts are summed up beside the statistics")] = None,
    mass_kg: Annotated[float | None, typer.Option(help="Your own mass; it wins over every estimate")] = None,
    origin: Annotated[str, typer.Option(help="Where your own mass comes from")] = "",
    json: Annotated[Path | None, typer.Option(help="Write the comparison as JSON")] = None,
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
) -> None:
    """Show what a gearbox weighs by every public method, with the band of the real weights."""
    bottom_up = sized(design).mass if design is not None else None
    stated = stated_mass(mass_kg, origin)
    show_mass(power_kw, engine_rpm, propeller_rpm, bottom_up=bottom_up, stated=stated, json=json, report=report)


def schema() -> None:
    """Print the JSON Schema of the design file, for editors."""
    import json

    from gearwright.spec import schema as make_schema

    show_json(json.dumps(make_schema(), indent=2, ensure_ascii=False))


def _run_of(sizing: Sizing, results: Path) -> StoredRun:
    """Return a stored run, if it is one of this design."""
    from gearwright.errors import DesignError, Problem
    from gearwright.store import load_run

    stored = load_run(results)
    if stored.design != sizing.design:
        message = (
            f"this is a run of another design, {stored.design.name!r}, or of an earlier state of it; simulate again"
        )
        raise DesignError([Problem("", message)], str(results))
    return stored


def _assemble(sizing: Sizing, case: str | None, stiffness: Literal["constant", "varying"] | None = None) -> System:
    from gearwright.dynamics.assembly import assemble

    return assemble(sizing, case, stiffness=stiffness)


def _simulate(system: System, duration: float) -> Trace:
    from gearwright.dynamics import Outputs
    from gearwright.dynamics import simulate as run_system

    window = (max(0.0, duration - WINDOW), duration)
    with progress("simulating") as update:
        return run_system(system, duration, outputs=Outputs(start=duration / 4.0, windows=(window,)), progress=update)
