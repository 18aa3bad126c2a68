"""The answer of a search as tables: its front, what binds each design, what limits cost, what doubt does to it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearwright.optimum import Best, Optimum
from gearwright.render.grid.table import Cell, Column, Table
from gearwright.render.tables.study.lists import front_list, letter
from gearwright.render.tables.study.variants import heading
from gearwright.study import Row
from gearwright.study import Table as Rows
from gearwright.units import margin_text, shown, unit, written

SHOWN = 12
"""Designs of a front that are listed: evenly along it, the chosen one among them [-]."""


def front_rows(optimum: Optimum) -> Rows:
    """Return the front as rows of a study; of their inputs the freedoms alone.

    Args:
        optimum: From `optimise`.
    """
    study = optimum.study
    return Rows(study.name, study.description, study.asked, tuple(_free(optimum, best) for best in optimum.front))


def _free(optimum: Optimum, best: Best) -> Row:
    paths = {path: best.inputs[path] for path in optimum.study.axes}
    return Row(best.row.design, paths, best.row.results)


def listed(optimum: Optimum) -> list[int]:
    """Return the places of those designs of the front that are listed.

    Args:
        optimum: From `optimise`.
    """
    evenly = np.unique(np.linspace(0, len(optimum.front) - 1, SHOWN).astype(int)).tolist()
    near = min(evenly, key=lambda place: abs(place - optimum.chosen))
    return sorted({optimum.chosen if place == near else place for place in evenly})


def optimum_table(optimum: Optimum) -> Table:
    """Return the listed designs of the front with letters.

    Args:
        optimum: From `optimise`.
    """
    rows, places = front_rows(optimum), listed(optimum)
    table = front_list(optimum.study, rows, [rows.rows[place] for place in places])
    chosen = letter(places.index(optimum.chosen))
    count = f"{len(places)} of {len(optimum.front)}" if len(places) < len(optimum.front) else f"all {len(places)}"
    note = f"{chosen} is nearest to the best of every objective at once."
    return Table(f"Pareto front, {count}", table.columns, table.rows, note)


def teeth_text(best: Best) -> str:
    """Return the teeth of a design, such as ``first 47/33/113``.

    Args:
        best: Of the front.
    """
    return ", ".join(f"{stage} {'/'.join(map(str, numbers))}" for stage, numbers in best.teeth.items())


def binding_table(optimum: Optimum) -> Table:
    """Return what keeps each listed design from being better.

    Args:
        optimum: From `optimise`.
    """
    rows = []
    for k, place in enumerate(listed(optimum)):
        best = optimum.front[place]
        binds = "; ".join(_bound(binding.kind, binding.name, binding.margin) for binding in best.binds)
        teeth = teeth_text(best)
        rows.append((_words(letter(k)), _words(teeth), _words(binds or "nothing near")))
    note = "Checks within 2 % of their limits with their margins, the nearest first; ends of ranges."
    return Table("Why no better: what binds", _columns("", "teeth", "binds"), tuple(rows), note)


def _bound(kind: str, name: str, margin: float) -> str:
    return f"end of {name}" if kind == "end of a range" else f"{name} {margin_text(margin, 4)}"


def price_table(optimum: Optimum) -> Table:
    """Return what each limit costs the chosen design.

    Args:
        optimum: From `optimise`.
    """
    names = optimum.objectives
    dimensions = {name: optimum.best.row.results[name].dimension for name in names}
    columns = [*_columns("limit", "kind"), *_of_objectives(optimum)]
    rows = [
        (
            _words(price.limit),
            _words(price.kind),
            *(_number(shown(price.changes[name], dimensions[name])) for name in names),
        )
        for price in optimum.prices
    ]
    note = (
        "Change for each per cent by which the limit is relaxed, ranges polished along with teeth kept. Sizes that come"
        " in steps answer in steps: a price of nothing may mean the next step."
    )
    return Table("What limits cost the chosen design", tuple(columns), tuple(rows), note)


def regret_table(optimum: Optimum) -> Table:
    """Return how designs of the front do under what is uncertain, those that are best most often first.

    Args:
        optimum: From `optimise`, with something uncertain.
    """
    letters = {place: letter(k) for k, place in enumerate(listed(optimum))}
    names = optimum.objectives
    dimensions = {name: optimum.best.row.results[name].dimension for name in names}
    units = {name: unit(dimensions[name]) for name in names}
    heads = [f"{heading(name)}, 5–95 %{f' [{units[name]}]' if units[name] else ''}" for name in names]
    rows = []
    for regret in optimum.regrets:
        spread = [tuple(shown(end, dimensions[name]) for end in regret.spread[name]) for name in names]
        named = f"{letters.get(regret.place, regret.place + 1)}{' (chosen)' if regret.place == optimum.chosen else ''}"
        rows.append((
            _words(named), _number(100.0 * regret.best), _number(100.0 * regret.mean), _number(100.0 * regret.late),
            _number(100.0 * regret.keeps), *(_words(f"{written(low)}–{written(high)}") for low, high in spread),
        ))  # fmt: skip
    columns = _columns("design", "best in [%]", "regret, mean [%]", "regret, 95 % [%]", "keeps as built [%]", *heads)
    note = (
        "Sized anew in every sample with teeth kept: in which part of them it is best, and by how much of the span of"
        " the front it is worse than the best, objectives weighing the same. As built: teeth, modules and widths kept;"
        " in which part of the samples every constraint is."
    )
    return Table("Regret under uncertainty", columns, tuple(rows), note)


def influence_table(optimum: Optimum) -> Table:
    """Return what each assumption does to the chosen design, and whether another one would be chosen.

    Args:
        optimum: From `optimise`, with something uncertain.
    """
    names = optimum.objectives
    dimensions = {name: optimum.best.row.results[name].dimension for name in names}
    columns = [*_columns("assumption", "from", "to"), *_of_objectives(optimum)]
    rows = [
        (_words(own.path), _number(own.low), _number(own.high),
         *(_number(shown(own.changes[name], dimensions[name])) for name in names),
         _words("the same" if set(own.chosen) == {optimum.chosen} else "another one"))
        for own in optimum.influences
    ]  # fmt: skip
    note = "From the 16 % to the 84 % quantile, all else at its median: change of the chosen design, and the choice."
    return Table("Sensitivity to assumptions", (*columns, *_columns("chosen")), tuple(rows), note)


def fit_table(optimum: Optimum) -> Table:
    """Return how well surrogates foretell each result that they are not told.

    Args:
        optimum: From `optimise`, with surrogates.
    """
    rows = [(_words(heading(fit.result)), _number(100.0 * fit.error), Cell(fit.designs, str(fit.designs)))
            for fit in optimum.fits]  # fmt: skip
    note = (
        "Root mean square of what is foretold wrong of each design by all others, over the deviation of the values:"
        " 100 % is no better than their mean. Constraints that every design keeps need none."
    )
    return Table("How well surrogates foretell", _columns("result", "wrong by [%]", "designs"), tuple(rows), note)


def optimum_tables(optimum: Optimum) -> Iterator[Table]:
    """Yield all tables that there is something in.

    Args:
        optimum: From `optimise`.
    """
    yield optimum_table(optimum)
    yield binding_table(optimum)
    if optimum.prices:
        yield price_table(optimum)
    if optimum.regrets:
        yield regret_table(optimum)
        yield influence_table(optimum)
    if optimum.fits:
        yield fit_table(optimum)


def _of_objectives(optimum: Optimum) -> tuple[Column, ...]:
    """Return a column for each objective, in its unit."""
    results = optimum.best.row.results
    return tuple(Column(name, heading(name), "", results[name].dimension) for name in optimum.objectives)


def _columns(*names: str) -> tuple[Column, ...]:
    return tuple(Column(name, name, "", "") for name in names)


def _words(text: str) -> Cell:
    return Cell(text, text)


def _number(value: float) -> Cell:
    return Cell(value, written(value, 3))
