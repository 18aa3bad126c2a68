"""The load sharing of a design for the terminal and as one page."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from markupsafe import Markup
from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.arrays import largest, smallest, smallest_first
from gearwright.dynamics.sharing import Allocation, PlanetCounts, SharingStudy, sharing_problem, support_sweep
from gearwright.render.figures.sharing import (
    LIMIT,
    RING,
    allocation_figure,
    around_figure,
    distribution_figure,
    one_turn,
    orbit_figure,
    planets_figure,
    published_notes,
    sharing_figure,
    support_figure,
    tornado_figure,
)
from gearwright.render.html import environment
from gearwright.render.pages.page import Figure, Number, Page, Section, Tone, Verdict, figure, set_page
from gearwright.render.terminal import Grid
from gearwright.render.vector.figure import Figure as Drawing
from gearwright.sizing import Sizing
from gearwright.units import Origin

# ----------------------------------------------------------------------------------------------------------------------
# The load sharing of a design for the terminal.
# ----------------------------------------------------------------------------------------------------------------------


PERCENTILES = (50.0, 95.0, 99.0)
_UNITS = {"clocking": ("mrad", 1e-3)}


def sharing_text(study: SharingStudy) -> RenderableType:
    """Return the answers of a load-sharing study as text and tables.

    Args:
        study: From `sharing_study`.
    """
    parts: list[RenderableType] = [Text(line) for line in summary(study)]
    if study.influences:
        parts.append(_influences(study))
    if study.allocation is not None:
        parts.append(_allocation(study.allocation))
    return Group(*parts)


def summary(study: SharingStudy) -> list[str]:
    """Return the answers in a few sentences.

    Args:
        study: From `sharing_study`.
    """
    problem, sharing = study.problem, study.sharing
    count, cycle = len(problem.lines), sharing.tooth_cycle
    perfect = ", ".join(
        f"{name} {value / count:.2%}" for name, value in zip(problem.lines, problem.perfect, strict=True)
    )
    cycled = ", ".join(
        f"{name} {_range(low / count, high / count)}"
        for name, low, high in zip(problem.lines, cycle.min(axis=0), cycle.max(axis=0), strict=True)
    )
    lines = [
        f"{problem.stage}: {count} paths; loops of the load in the train: {problem.train.count}",
        f"without errors: {perfect}",
        f"with the errors as given: {cycled} over a tooth cycle, K_γ {sharing.load_factor:.3f} ({sharing.reason})",
    ]
    if problem.stated is not None:
        stated = ", ".join(f"{name} {share:.2%}" for name, share in zip(problem.lines, problem.stated, strict=True))
        lines.insert(1, f"stated in the design and taken by sizing: {stated}; all below is what stiffness makes of it")
    if not problem.shifts:
        lines.append("statically determinate: equilibrium alone shares the load, and no error shifts it")
    if study.distribution is not None and problem.shifts:
        shares = ", ".join(
            f"{percent:g} % below {study.distribution.percentile(percent):.2%}" for percent in PERCENTILES
        )
        lines.append(
            f"{len(study.distribution.peak)} gearboxes with random phases (seed {study.distribution.seed}): {shares}"
        )
    if study.clocking is not None:
        angles = ", ".join(f"{gear} {1e3 * angle:+.3f} mrad" for gear, angle in study.clocking.angles)
        window, target = 1e3 * study.clocking.window, study.clocking.target
        lines.append(f"equal without errors with clocking: {angles}; {target:.0%} within ±{window:.2f} mrad of it")
    return lines


def _range(low: float, high: float) -> str:
    """Return a share that changes, or stays, in per cent."""
    ends = (f"{low:.2%}", f"{high:.2%}")
    return " to ".join(dict.fromkeys(ends))


def _influences(study: SharingStudy) -> Grid:
    table = Grid("One error at a time")
    table.add_column("error")
    for header in ("size", "change of b [%]"):
        table.add_column(header, justify="right")
    table.add_column("")
    for influence in study.influences:
        effect = f"±{100.0 * influence.effect:.3f}"
        table.add_row(
            influence.source, _size(influence.kind, influence.size), effect, "turns" if influence.turns else "stays"
        )
    return table


def _size(kind: str, size: float) -> str:
    unit, scale = _UNITS.get(kind, ("µm", 1e-6))
    return f"{size / scale:.4g} {unit}"


def _allocation(allocation: Allocation) -> Grid:
    share = f"{100.0 * allocation.target:g}/{100.0 * (1.0 - allocation.target):g}"
    title = f"Tolerances for {share} in {allocation.percent:g} % of gearboxes (reached: {allocation.reached:.2%})"
    table = Grid(title)
    table.add_column("error")
    for header in ("given", "allowed"):
        table.add_column(header, justify="right")
    for row in smallest_first(allocation.sizes, lambda row: row.allowed / row.given):
        allowed = _size(row.kind, row.allowed) if row.allowed < row.given else "as given"
        table.add_row(row.error, _size(row.kind, row.given), allowed)
    return table


# ----------------------------------------------------------------------------------------------------------------------
# The load sharing of a design as one self-contained HTML page: answers, figures, and a paper's claims.
# ----------------------------------------------------------------------------------------------------------------------


_FOOTER = "Shares are those of forces along the lines of action; b is the share times the number of paths."
_OF_A_HUNDRED = 95.0
"""Gearboxes below the share in the head [%]."""

SPREAD = tuple(float(factor) for factor in np.geomspace(1e-2, 1e2, 41))
"""Stiffnesses of a support that are shown, over the design's [-]."""
AROUND = 3
"""Paths that are drawn round their shaft, at least."""
Drawn = tuple[str, Drawing]
"""Caption and figure."""


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
    claims = () if paper is None else paper.claims
    if paper is not None:
        chapters.append(Section("Figures of the paper", figures=_drawn(tuple(paper.figures), "paper")))
        chapters.insert(0, _claimed(claims))
    return set_page(
        Page("Load sharing", sizing.design.name, sizing.design.description, _verdict(studies, claims, target),
             tuple(_numbers(studies)), tuple(chapters), design=sizing.design, footer=_FOOTER)
    )  # fmt: skip


def _verdict(studies: Sequence[SharingStudy], claims: Sequence[ClaimRow], target: float | None) -> Verdict:
    """Return how equally the paths share, whether a target is kept, and how many claims of a paper do not hold."""
    worst = largest(studies, lambda study: study.sharing.load_factor)
    factor = worst.sharing.load_factor
    said = f"With the errors as given the most loaded path of {worst.problem.stage} carries K_γ = {factor:.3f} times"
    said += " its equal share."
    failing = sum(claim.sign == "no" for claim in claims)
    if failing:
        return Verdict(Tone.BAD, f"{failing} of {len(claims)} claims of the paper do not hold", said)
    if target is not None:
        missed = any(study.sharing.load_factor > target * len(study.problem.lines) for study in studies)
        word = "Misses the target with the errors as given" if missed else "Keeps the target with the errors as given"
        return Verdict(Tone.BAD if missed else Tone.GOOD, word, said)
    return Verdict(Tone.OPEN, "No target is asked for", said)


def _numbers(studies: Sequence[SharingStudy]) -> Iterator[Number]:
    for study in studies:
        stage, sharing = study.problem.stage, study.sharing
        origin = Origin("K_γ = max(F_i) / mean(F_i)", sharing.reason)
        yield Number(f"K_γ of {stage}", f"{sharing.load_factor:.3f}", value=sharing.load_factor, origin=origin)
        yield Number(f"paths of {stage}", f"{len(study.problem.lines)}")
        if study.distribution is not None and study.problem.shifts:
            share = study.distribution.percentile(_OF_A_HUNDRED)
            yield Number(f"{_OF_A_HUNDRED:g} % of gearboxes below", f"{share:.2%}".replace("%", " %"))


def _claimed(claims: Sequence[ClaimRow]) -> Section:
    content = environment().get_template("claims.html.j2").render(claims=claims)
    return Section("Claims of the paper", content=Markup(content))


def _chapters(
    sizing: Sizing, studies: Sequence[SharingStudy], counts: Sequence[PlanetCounts], target: float | None
) -> list[Section]:
    stages = [
        Section(f"Stage {study.problem.stage}", notes=_sentences(summary(study)),
                figures=_drawn(tuple(_figures(study, target)), f"stage{k}"))
        for k, study in enumerate(studies)
    ]  # fmt: skip
    stages += [_planets(count, f"planets{k}") for k, count in enumerate(counts)]
    floating = _drawn(tuple(_supports(sizing)), "floating")
    return [*stages, Section("Floating", figures=floating)] if floating else stages


def _sentences(words: Iterable[str]) -> tuple[str, ...]:
    return tuple(f"{line[:1].upper()}{line[1:]}." for line in words)


def _planets(counts: PlanetCounts, prefix: str) -> Section:
    """Return K_γ against the number of planets of one set."""
    drawn = (f"K_γ against planets; {LIMIT}", planets_figure(counts))
    title = f"Planets of stage {counts.stage}"
    return Section(title, notes=_sentences(published_notes()), figures=_drawn((drawn,), prefix))


def _drawn(figures: Sequence[Drawn], prefix: str) -> tuple[Figure, ...]:
    """Draw figures; the prefix keeps their ids apart and the same each time."""
    return tuple(figure(drawn, f"{prefix}-{k}", words) for k, (words, drawn) in enumerate(figures))


def _figures(study: SharingStudy, target: float | None) -> Iterator[Drawn]:
    yield "Sharing with the errors as given", sharing_figure({study.problem.stage: study.sharing})
    if len(study.problem.lines) >= AROUND:
        yield (
            f"Round the shaft: wedges are mean coefficients b, bars go from the least to the greatest; rings stand"
            f" {RING:g} apart, the dark one is the equal share",
            around_figure(study.sharing),
        )
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
    shaft = smallest(supports, lambda name: supports[name].radial)
    stiffness = supports[shaft].radial
    sweep = support_sweep(sizing, shaft, [stiffness * factor for factor in SPREAD])
    yield f"Support of shaft {shaft}", support_figure(sweep, {stiffness: "design"})
    problem = sharing_problem(sizing)
    yield "Orbits of the shafts", orbit_figure(problem, list(supports)[:4], one_turn({"": problem}))
