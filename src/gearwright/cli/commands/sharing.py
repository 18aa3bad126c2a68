"""The command ``sharing``: how parallel paths share their load, which errors matter, how tight tolerances must be.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.designs import sized
from gearwright.cli.options import CaseOption, DesignArgument, JsonOption, drawable
from gearwright.cli.terminal.output import show, tell, write_figure
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.dynamics.sharing import SharingStudy


def sharing(
    design: DesignArgument,
    stage: Annotated[str | None, typer.Option(help="Stage with parallel meshes; left out: the last one")] = None,
    case: CaseOption = None,
    method: Annotated[
        Literal["auto", "quasi-static", "frequency response", "sidebands", "dynamics"],
        typer.Option(help="Solution for the errors as given"),
    ] = "auto",
    target: Annotated[
        str | None, typer.Option(help="Sharing that is asked for, such as 52/48: says how tight tolerances must be")
    ] = None,
    percent: Annotated[float, typer.Option(help="Gearboxes that must keep the target [%]", min=1.0, max=99.9)] = 95.0,
    seed: Annotated[int, typer.Option(help="Of the random errors", min=0)] = 1,
    figure: Annotated[Path | None, typer.Option(help="Write the main figure (.svg or .png)", callback=drawable)] = None,
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
    json: JsonOption = False,
) -> None:
    """Say how parallel paths share their load, what each error does, and which tolerance to tighten."""
    from gearwright.dynamics.sharing import planet_counts, sharing_problem, sharing_study
    from gearwright.render.answers.vibration import sharing_answer
    from gearwright.render.figures.planets import planets_text
    from gearwright.render.words.sharing import sharing_text

    share = asked_share(target)
    sizing = sized(design)
    problem = sharing_problem(sizing, stage, case=case)
    study = sharing_study(problem, method=method, target=share, percent=percent, seed=seed)
    counts = planet_counts(sizing, problem, seed=seed) if report is not None or not json else None
    if json:
        show_answer("sharing", sharing_answer(study), design=sizing.design.name)
    else:
        show(sharing_text(study), *([planets_text(counts)] if counts is not None else []))
    if figure is not None:
        _draw(study, figure)
    if report is not None:
        from gearwright.render.pages.sharing import sharing_page
        from gearwright.replays import paper_on

        planets = [] if counts is None else [counts]
        drawn = sharing_page(sizing, [study], counts=planets, target=share, paper=paper_on(sizing))
        write_text(report, drawn)
        tell(f"wrote {report}")


def asked_share(target: str | None) -> float | None:
    """Return the share of the most loaded path that ``52/48`` or ``0.52`` asks for [-].

    Args:
        target: As written.

    Raises:
        DesignError: If it is no share.
    """
    from gearwright.errors import DesignError, Problem

    if target is None:
        return None
    parts = target.split("/")
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        numbers = []
    share = numbers[0] if len(numbers) == 1 else max(numbers) / sum(numbers) if numbers and sum(numbers) > 0.0 else 0.0
    if not 0.0 < share < 1.0:
        message = f"{target!r} is no sharing; write parts such as 52/48, or the largest share such as 0.52"
        raise DesignError([Problem("--target", message)])
    return share


def _draw(study: SharingStudy, path: Path) -> None:
    from gearwright.render.figures.sharing import allocation_figure, sharing_figure, tornado_figure

    if study.allocation is not None:
        drawn = allocation_figure(study.allocation)
    elif study.influences:
        drawn = tornado_figure(study)
    else:
        drawn = sharing_figure({study.problem.stage: study.sharing})
    write_figure(drawn, path)
    tell(f"wrote {path}")
