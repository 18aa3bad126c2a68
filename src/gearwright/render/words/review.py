"""A review in words: the verdict, every check worst first, what is open; and what a closure met, on one screen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.closure import Closed, Contradiction, Round, Variants
from gearwright.closure.life import LONGEST, SHORTEST
from gearwright.render.grid.grid import Grid
from gearwright.render.tables.checks import check_sentence, review_tables
from gearwright.render.tables.sizing.masses import mass_sentence
from gearwright.render.words.headline import headline, unneeded_text
from gearwright.render.words.text import table_text
from gearwright.reviews import Review
from gearwright.units import shown, text, written


def review_text(review: Review) -> RenderableType:
    """Return a review for the terminal.

    Args:
        review: Of a design.
    """
    flown = f", flying {review.mission}" if review.mission else ""
    notes = [f"{unneeded_text(name)}." for name in review.unneeded]
    weighs = f"Complete mass: {mass_sentence(review.complete, review.statistics)}"
    head = [Text(f"{review.design}{flown}", style="bold"), Text(f"{headline(review)}."), Text(weighs), Text()]
    parts: list[RenderableType] = [*head]
    parts += [table_text(table) for table in review_tables(review.checks) if table.rows]
    return Group(*parts, *map(Text, notes))


def closure_text(closed: Closed, *, all_rounds: bool = False) -> RenderableType:
    """Return a closed design on one screen: what it meets, what it weighs and lives, how it came about.

    Args:
        closed: From `close`.
        all_rounds: Every round; else the first, the first of every other kind of step, and the last.
    """
    grid = Grid(show_header=False)
    grid.add_column("what", no_wrap=True)
    grid.add_column("value")
    for name, value in _closed_rows(closed, all_rounds=all_rounds):
        grid.add_row(name, value)
    first = f"{closed.outcome}: the worst is {check_sentence(closed.worst)}" if closed.worst else str(closed.outcome)
    return Group(Text(closed.design.name, style="bold"), Text(f"{first}."), Text(), grid)


def against_text(found: Sequence[Contradiction]) -> RenderableType:
    """Return what stands against the requirements that are not met.

    Args:
        found: From `contradictions`.
    """
    if not found:
        return Text(
            "No single requirement or given value stands against what is not met: without any of them it fails."
        )
    grid = Grid(show_header=False)
    grid.add_column("what", no_wrap=True)
    grid.add_column("value")
    for row in found:
        words = ", ".join(row.unmet)
        if row.requirements:
            words += f": without it met, {text(row.mass, 'mass')} of gears, shafts and carriers"
        grid.add_row(f"{row.against} contradicts", words)
    return grid


def variants_text(found: Variants) -> RenderableType:
    """Return the nearest variant that meets everything, and what was tried before it.

    Args:
        found: From `nearest_variant`.
    """
    grid = Grid(show_header=False)
    grid.add_column("what", no_wrap=True)
    grid.add_column("value")
    for row in found.tried:
        grid.add_row(row.what, f"does not meet {row.why}")
    if found.nearest is None:
        return Group(grid, Text("no variant that was tried meets everything."))
    nearest = found.nearest
    grid.add_row(nearest.what, f"{nearest.closed.outcome}, complete mass {text(nearest.closed.whole.total, 'mass')}")
    changes = "; ".join(
        f"{path} = {'(left out)' if value is None else value}" for path, value in nearest.changes.items()
    )
    return Group(grid, Text(f"The nearest variant: {changes}."))


def _closed_rows(closed: Closed, *, all_rounds: bool) -> Iterator[tuple[str, str]]:
    yield "train as sized", text(closed.mass, "mass")
    low, high = closed.whole.band
    yield "complete mass", f"{text(closed.whole.total, 'mass')}, {text(low, 'mass')} to {text(high, 'mass')}"
    yield "its train", text(closed.whole.train, "mass")
    for row in closed.lives:
        hours = f"{written(shown(row.life, 'life'))} h" if row.life < LONGEST else "endless: beyond 1e6 h"
        hours = hours if row.life > SHORTEST else "less than 0.1 h"
        yield f"life of {row.stage}", f"{hours}, by {row.governs}"
    if closed.lives:
        yield "life asked", text(closed.design.service.life, "life")
    for gear in closed.sizing.gears:
        size = f"z {gear.teeth}, m_n {text(gear.module, 'length')}, b {text(gear.face_width, 'length')}"
        yield gear.name, size
    told = _told(closed.rounds, all_rounds=all_rounds)
    for number, round_ in told.items():
        yield f"round {number}", f"{round_.step}, {text(round_.mass, 'mass')}: {round_.what}"
    if left := len(closed.rounds) - len(told):
        yield "rounds not shown", f"{left}: of kinds that are shown; --rounds shows all"
    for unmet in closed.unmet:
        kept = f"; given and kept: {unmet.kept}" if unmet.kept else ""
        yield f"not met: {unmet.requirement}", f"{check_sentence(unmet.check)}{kept}. What helps: {unmet.helps}"
    if closed.kept:
        yield "given and kept", ", ".join(closed.kept)


def _told(rounds: Sequence[Round], *, all_rounds: bool) -> dict[int, Round]:
    """Return number -> round: all, or the first of each kind of step and the last."""
    seen = {round_.step: number for number, round_ in reversed(list(enumerate(rounds, start=1)))}
    numbers = {*seen.values(), len(rounds)}
    return {number: round_ for number, round_ in enumerate(rounds, start=1) if all_rounds or number in numbers}
