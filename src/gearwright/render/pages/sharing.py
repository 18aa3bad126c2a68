"""The load sharing of a design as one self-contained HTML page: answers, figures, and a paper's claims."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure

from gearwright.dynamics.model import Floats
from gearwright.dynamics.sharing import (
    TRANSIENT,
    LoadSharing,
    PlanetCounts,
    SharingProblem,
    SharingStudy,
    load_sharing,
    parallel_meshes,
    sharing_problem,
    support_sweep,
)
from gearwright.render.figures.planets import LIMIT, planets_figure, published_notes
from gearwright.render.figures.sharing import (
    allocation_figure,
    displacement_figure,
    distribution_figure,
    orbit_figure,
    sharing_figure,
    single_error_figure,
    support_figure,
    tornado_figure,
)
from gearwright.render.style import theme
from gearwright.render.style.templates import environment
from gearwright.render.words.sharing import summary
from gearwright.replays.pulvirenti.claims import Verdict
from gearwright.replays.wang.claims import FLOATING, HALF, RIGID, SplitClaim, split_torque_claims, with_support
from gearwright.sizing import Sizing
from gearwright.study import SplitTorque, split_torque
from gearwright.version import __version__

SPREAD = tuple(float(each) for each in np.geomspace(1e-2, 1e2, 41))
"""Stiffnesses of a support that are shown, over the design's [-]."""
INSTANTS = 4000
_SIGNS = {Verdict.HOLDS: "yes", Verdict.CONDITION: "partly", Verdict.FAILS: "no"}
_Drawn = tuple[str, Figure]


class _Chapter(NamedTuple):
    """Part of the page."""

    title: str
    sentences: tuple[str, ...]
    figures: tuple[_Drawn, ...]
    """Captions and figures."""


def sharing_page(
    sizing: Sizing, studies: Sequence[SharingStudy], *, counts: Sequence[PlanetCounts] = (), target: float | None = None
) -> str:
    """Return the page; it makes no request to anywhere.

    A face-gear split torque gets the counterparts of the paper's figures and the paper's claims, too.

    Args:
        sizing: What was sized.
        studies: One for each stage that is shown.
        counts: K_γ against planets, of the sets that have it.
        target: Share that was asked for [-].
    """
    chapters, parts = _chapters(sizing, studies, counts, target), split_torque(sizing.design)
    if parts is None:
        return _page(sizing, chapters, ())
    paper = _Chapter("Figures of the paper", (), tuple(paper_figures(sizing, parts)))
    return _page(sizing, [*chapters, paper], split_torque_claims(sizing, parts))


def _chapters(
    sizing: Sizing, studies: Sequence[SharingStudy], counts: Sequence[PlanetCounts], target: float | None
) -> list[_Chapter]:
    stages = [
        _Chapter(f"Stage {study.problem.stage}", tuple(summary(study)), tuple(_figures(study, target)))
        for study in studies
    ]
    stages += [_planets(each) for each in counts]
    floating = tuple(_supports(sizing))
    return [*stages, _Chapter("Floating", (), floating)] if floating else stages


def _planets(counts: PlanetCounts) -> _Chapter:
    """Return K_γ against the number of planets of one set."""
    drawn = (f"K_γ against planets; {LIMIT}", planets_figure(counts))
    return _Chapter(f"Planets of stage {counts.stage}", tuple(published_notes()), (drawn,))


def _page(sizing: Sizing, chapters: Sequence[_Chapter], claims: Sequence[SplitClaim]) -> str:
    # Numbers in the page keep the ids of its figures apart and the same each time.
    shown = [(each.title, each.sentences, _drawn(each.figures, f"f{i}")) for i, each in enumerate(chapters)]
    page = environment().get_template("sharing_page.html.j2")
    return page.render(name=sizing.design.name, chapters=shown, claims=claims, version=__version__, sign=_SIGNS)


def _drawn(figures: Sequence[_Drawn], prefix: str) -> list[tuple[str, str]]:
    return [(words, theme.to_svg(each, prefix=f"{prefix}-{k}")) for k, (words, each) in enumerate(figures)]


def paper_figures(sizing: Sizing, parts: SplitTorque) -> Iterator[_Drawn]:
    """Yield the counterparts of the paper's figures 3 to 18, with captions.

    Args:
        sizing: Of the shipped design ``face-gear-split-torque``, or of another of this kind.
        parts: Its parts, from `split_torque`.

    Source: Wang, Zhao, Tao, Jia & Guo, "Floating shaft load sharing method for face gear split torque transmission
        system".
    """
    for stiffness, number in ((RIGID, "Figure 3"), (HALF, "Figure 4"), (FLOATING, "Figure 6")):
        softer = with_support(sizing, parts.pinion, stiffness)
        problems = {stage: sharing_problem(softer, stage) for stage in parallel_meshes(softer)}
        yield f"{number}: load sharing, support of shaft 1 {stiffness:.0e} N/m", sharing_figure(_solved(problems))
    soft = {each: with_support(sizing, parts.pinion, each) for each in (HALF, FLOATING)}
    problems = {f"{stiffness:.0e} N/m": sharing_problem(softer) for stiffness, softer in soft.items()}
    words = "Figures 5 and 7: displacement of shaft 1 by slow errors, without tooth ripple"
    yield words, displacement_figure(problems, parts.pinion, _turn(problems))
    alone = sharing_problem(sizing)
    span = (TRANSIENT, TRANSIENT + float(_turn({"": alone})[-1]))
    words = "Figures 8 to 18: one error at a time, and those that the paper leaves out"
    yield words, single_error_figure(alone, span, parts.single_errors)


def _solved(problems: dict[str, SharingProblem]) -> dict[str, LoadSharing]:
    return {name: load_sharing(each.system, each.lines, method="sidebands") for name, each in problems.items()}


def _turn(problems: dict[str, SharingProblem]) -> Floats:
    """Return instants over one turn of the slowest part that turns."""
    rates = [abs(source.rate) for each in problems.values() for source in each.sources if source.rate]
    return np.linspace(0.0, 2.0 * np.pi / min(rates), INSTANTS) if rates else np.zeros(1)


def _figures(study: SharingStudy, target: float | None) -> Iterator[_Drawn]:
    yield "Sharing with the errors as given", sharing_figure({study.problem.stage: study.sharing})
    if study.influences:
        yield "What every error does alone", tornado_figure(study)
        yield "What chance makes of all errors", distribution_figure(study, target)
    if study.allocation is not None:
        yield "Which tolerance to tighten", allocation_figure(study.allocation)


def _supports(sizing: Sizing) -> Iterator[_Drawn]:
    """Yield what the softest support buys, and the orbits of all shafts that move."""
    supports = sizing.design.supports
    if not supports or not sizing.design.errors:
        return
    shaft = min(supports, key=lambda name: supports[name].radial)
    own = supports[shaft].radial
    sweep = support_sweep(sizing, shaft, [own * each for each in SPREAD])
    yield f"Support of shaft {shaft}", support_figure(sweep, {own: "design"})
    problem = sharing_problem(sizing)
    yield "Orbits of the shafts", orbit_figure(problem, list(supports)[:4], _turn({"": problem}))
