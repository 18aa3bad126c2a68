"""The answer of a search as one page: what is best, why, what limits cost, how sure it is."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.optimum import Optimum
from gearwright.render.figures.study.optimum import growth_figure
from gearwright.render.figures.study.spread import parallel_figure, pareto_figure
from gearwright.render.pages.page import (
    UNSTAMPED,
    Figure,
    Number,
    Page,
    Section,
    Stamp,
    Tone,
    Verdict,
    figure,
    quantity,
    set_page,
)
from gearwright.render.tables.study.optimum import (
    binding_table,
    fit_table,
    front_rows,
    influence_table,
    listed,
    optimum_table,
    price_table,
    regret_table,
)
from gearwright.render.tables.study.variants import heading
from gearwright.render.words.optimum import optimum_sentences


def optimum_page(optimum: Optimum, *, stamp: Stamp = UNSTAMPED) -> str:
    """Return the answer of a search as one self-contained HTML page; the same input gives the same bytes.

    Args:
        optimum: From `optimise`.
        stamp: Date of the page.
    """
    said = tuple(optimum_sentences(optimum))
    word = f"{len(optimum.front)} designs that no other one beats"
    page = Page(
        "Search for the best", optimum.study.name, optimum.study.description, Verdict(Tone.OPEN, word, said[0]),
        tuple(_numbers(optimum)), tuple(_sections(optimum, said)), stamp=stamp,
    )  # fmt: skip
    return set_page(page)


def _numbers(optimum: Optimum) -> Iterator[Number]:
    """Yield the objectives of the chosen design, with their bands where something is uncertain."""
    bands = optimum.regrets[0].spread if optimum.regrets else {}
    for name in optimum.objectives:
        value = optimum.best.row.results[name]
        yield quantity(heading(name), optimum.best.row.number(name), value.dimension, band=bands.get(name),
                       share="90 %" if name in bands else "")  # fmt: skip


def _sections(optimum: Optimum, said: tuple[str, ...]) -> Iterator[Section]:
    yield Section("The front", (optimum_table(optimum),), tuple(_front(optimum)), listed=said)
    yield Section("Why no better", (binding_table(optimum),))
    if optimum.prices:
        yield Section("What limits cost", (price_table(optimum),))
    if optimum.regrets:
        yield Section("How sure the choice is", (regret_table(optimum), influence_table(optimum)))
    growth = figure(growth_figure(optimum), "growth", "Hypervolume of the front after every generation.")
    fits = (fit_table(optimum),) if optimum.fits else ()
    yield Section("How it was found", fits, (growth,))


def _front(optimum: Optimum) -> Iterator[Figure]:
    """Yield the front over the first two objectives, and what its designs have in common."""
    rows = front_rows(optimum)
    chosen = [rows.rows[place] for place in listed(optimum)]
    if len(optimum.objectives) > 1:
        yield figure(
            pareto_figure(optimum.study, rows, rows.rows, chosen), "front", "The front, listed designs by letter."
        )
    if len(optimum.front) > 1:
        best = [rows.rows[optimum.chosen]]
        yield figure(
            parallel_figure(rows, best), "parallel", "Freedoms and results of the front, the chosen one marked."
        )
