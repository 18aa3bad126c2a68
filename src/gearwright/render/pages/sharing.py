"""The load sharing of a design as one self-contained HTML page: answers, figures, and a paper's claims."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure

from gearwright.dynamics.sharing import (
    PlanetCounts,
    SharingStudy,
    sharing_problem,
    support_sweep,
)
from gearwright.render.figures.planets import LIMIT, planets_figure, published_notes
from gearwright.render.figures.sharing import (
    allocation_figure,
    distribution_figure,
    one_turn,
    orbit_figure,
    sharing_figure,
    support_figure,
    tornado_figure,
)
from gearwright.render.style import theme
from gearwright.render.style.templates import environment
from gearwright.render.words.sharing import summary
from gearwright.sizing import Sizing
from gearwright.version import __version__

SPREAD = tuple(float(factor) for factor in np.geomspace(1e-2, 1e2, 41))
"""Stiffnesses of a support that are shown, over the design's [-]."""
Drawn = tuple[str, Figure]
"""Caption and figure."""


class _Chapter(NamedTuple):
    """Part of the page."""

    title: str
    sentences: tuple[str, ...]
    figures: tuple[Drawn, ...]
    """Captions and figures."""


class ClaimRow(NamedTuple):
    """A published claim and what becomes of it."""

    place: str
    """Where it stands."""
    printed: str
    """In few words."""
    verdict: str
    """In words."""
    sign: str
    """``yes``, ``partly`` or ``no``."""
    why: str
    """Reason, with numbers."""


class Paper(NamedTuple):
    """What a publication shows of such a design."""

    figures: Iterable[Drawn]
    """Counterparts of its figures, drawn as they are asked for."""
    claims: tuple[ClaimRow, ...]


def sharing_page(
    sizing: Sizing,
    studies: Sequence[SharingStudy],
    *,
    counts: Sequence[PlanetCounts] = (),
    target: float | None = None,
    paper: Paper | None = None,
) -> str:
    """Return the page; it makes no request to anywhere.

    Args:
        sizing: What was sized.
        studies: One for each stage that is shown.
        counts: K_γ against planets, of the sets that have it.
        target: Share that was asked for [-].
        paper: Figures and claims of a publication on such a design, which follow at the end.
    """
    chapters = _chapters(sizing, studies, counts, target)
    if paper is not None:
        chapters.append(_Chapter("Figures of the paper", (), tuple(paper.figures)))
    return _page(sizing, chapters, () if paper is None else paper.claims)


def _chapters(
    sizing: Sizing, studies: Sequence[SharingStudy], counts: Sequence[PlanetCounts], target: float | None
) -> list[_Chapter]:
    stages = [
        _Chapter(f"Stage {study.problem.stage}", tuple(summary(study)), tuple(_figures(study, target)))
        for study in studies
    ]
    stages += [_planets(count) for count in counts]
    floating = tuple(_supports(sizing))
    return [*stages, _Chapter("Floating", (), floating)] if floating else stages


def _planets(counts: PlanetCounts) -> _Chapter:
    """Return K_γ against the number of planets of one set."""
    drawn = (f"K_γ against planets; {LIMIT}", planets_figure(counts))
    return _Chapter(f"Planets of stage {counts.stage}", tuple(published_notes()), (drawn,))


def _page(sizing: Sizing, chapters: Sequence[_Chapter], claims: Sequence[ClaimRow]) -> str:
    # Numbers in the page keep the ids of its figures apart and the same each time.
    shown = [(chapter.title, chapter.sentences, _drawn(chapter.figures, f"f{i}")) for i, chapter in enumerate(chapters)]
    page = environment().get_template("sharing_page.html.j2")
    return page.render(name=sizing.design.name, chapters=shown, claims=claims, version=__version__)


def _drawn(figures: Sequence[Drawn], prefix: str) -> list[tuple[str, str]]:
    return [(words, theme.to_svg(figure, prefix=f"{prefix}-{k}")) for k, (words, figure) in enumerate(figures)]


def _figures(study: SharingStudy, target: float | None) -> Iterator[Drawn]:
    yield "Sharing with the errors as given", sharing_figure({study.problem.stage: study.sharing})
    if study.influences:
        yield "What every error does alone", tornado_figure(study)
        yield "What chance makes of all errors", distribution_figure(study, target)
    if study.allocation is not None:
        yield "Which tolerance to tighten", allocation_figure(study.allocation)


def _supports(sizing: Sizing) -> Iterator[Drawn]:
    """Yield what the softest support buys, and the orbits of all shafts that move."""
    supports = sizing.design.supports
    if not supports or not sizing.design.errors:
        return
    shaft = min(supports, key=lambda name: supports[name].radial)
    stiffness = supports[shaft].radial
    sweep = support_sweep(sizing, shaft, [stiffness * factor for factor in SPREAD])
    yield f"Support of shaft {shaft}", support_figure(sweep, {stiffness: "design"})
    problem = sharing_problem(sizing)
    yield "Orbits of the shafts", orbit_figure(problem, list(supports)[:4], one_turn({"": problem}))
