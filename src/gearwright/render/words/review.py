"""A review in words, what a closure met, and a run on one screen."""

from collections.abc import Iterator, Mapping, Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from gearwright.base import largest, shown, smallest, text, worst, written
from gearwright.closure import Arranged, Closed, ClosedArrangement, Contradiction, Eased, Effort, Round, Variants
from gearwright.closure.requirements import LONGEST, SHORTEST
from gearwright.dynamics import Modes, Trace
from gearwright.dynamics.vibration import SpeedCase, dynamic_loads
from gearwright.particulars import Particulars
from gearwright.render.tables.arranged import arranged_tables, unborne, unforced
from gearwright.render.tables.checks import check_sentence, review_tables
from gearwright.render.tables.housing import housing_tables
from gearwright.render.tables.sizing import mass_sentence
from gearwright.render.tables.weights import complete_words, train_mass
from gearwright.render.terminal import Grid
from gearwright.render.words.sizing import energy_text, headline, sizing_headline, table_text, unneeded_text
from gearwright.reviews import Review
from gearwright.sizing import Sizing

# ----------------------------------------------------------------------------------------------------------------------
# A review in words: the verdict, every check worst first, what is open; and what a closure met, on one screen.
# ----------------------------------------------------------------------------------------------------------------------


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
    tables = (*review_tables(review.checks), *housing_tables(review))
    parts += [table_text(table) for table in tables if table.rows]
    return Group(*parts, *map(Text, notes))


def closure_text(closed: Closed, nearest: Eased | None = None, *, all_rounds: bool = False) -> RenderableType:
    """Return a closed design on one screen: what it meets, what it weighs and lives, how it came about.

    Args:
        closed: From `close`.
        nearest: From `eased`, of one that does not meet everything; None where there is none.
        all_rounds: Every round; else the first, the first of every other kind of step, and the last.
    """
    grid = Grid(show_header=False)
    grid.add_column("what", no_wrap=True)
    grid.add_column("value")
    for name, value in _closed_rows(closed, nearest, all_rounds=all_rounds):
        grid.add_row(name, value)
    first = f"{closed.outcome}: the worst is {check_sentence(closed.worst)}" if closed.worst else str(closed.outcome)
    same = [Text("Nothing to change: the file gives the design as it is closed.")] if closed.changes_nothing else []
    return Group(Text(closed.design.name, style="bold"), Text(f"{first}."), *same, Text(), grid)


def arranged_text(
    arranged: Arranged, found: ClosedArrangement | None = None, *, stated: str = ""
) -> RenderableType:  # fmt: skip
    """Return a design in bearings on one screen: the verdict, its bearings, shafts, and masses before and after.

    Args:
        arranged: From `arrange`.
        found: From `close_arranged`; None where sizes are kept.
        stated: Level of the design where it was taken at another one; else empty.
    """
    worse, failing = arranged.worse, [check for check in arranged.sizing.checks if check.fails]
    said = [f"{sizing_headline(arranged.sizing)}."] if found is None else [*_rounds_in_bearings(found)]
    worse = worse if found is None else ()
    said += [
        f"Fails, and did not before: {check_sentence(check)}{f'; {check.why}' * bool(check.why)}." for check in worse
    ]
    if failing and not worse and found is None:
        said.append("What fails failed before, too.")
    if stated:
        said.append(f'Taken at level "{arranged.before.design.level}"; that of the design is "{stated}".')
    said += [f"{row.shaft} {row.why}." for row in unborne(arranged)]
    said += [
        f"{name} states no thrust_kn, in_plane_force_kn or hub_moment_nm: what {shaft} bears of it is assumed."
        for name, shaft in unforced(arranged)
    ]
    head = [Text(arranged.design.name, style="bold"), *map(Text, said), Text()]
    return Group(*head, *(table_text(table) for table in arranged_tables(arranged) if table.rows))


def _rounds_in_bearings(found: ClosedArrangement) -> Iterator[str]:
    """Yield whether a gearbox passes with its shafts in bearings, what was moved to that end, and what no freedom
    meets."""
    if first := worst(found.checks):
        outcome = f"{len(found.failing)} of {len(found.checks)} checks fail" if found.failing else "All checks pass"
        yield f"{outcome}, peaks and resonances with its bearings among them; the worst: {check_sentence(first)}."
    for number, one in enumerate(found.rounds, start=1):
        state = f"fails by {one.worst}" if one.worst else "passes"
        yield f"Round {number}, {one.what or 'as closed without bearings'}: {text(one.mass, 'mass')}, {state}."
    known = found.left_open
    for check in found.failing:
        looked = f"with bearings, over {', '.join(found.searched) or 'nothing'}" if check in known else "by the closure"
        why = f"; {check.why}" if check.why else ""
        yield f"Fails, and no freedom meets it that was looked for {looked}: {check_sentence(check)}{why}."


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


def _closed_rows(closed: Closed, nearest: Eased | None, *, all_rounds: bool) -> Iterator[tuple[str, str]]:
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
        best = f"the best that was found is {check_sentence(unmet.check)}{kept}"
        yield f"not met: {unmet.requirement}", f"{best}. What helps: {unmet.helps}"
    if closed.unmet:
        further = "--variants looks for the smallest change of what is given that meets everything"
        found = "none in these sizes with less life, less power or other speeds"
        if nearest is not None:
            found = f"in these sizes, {nearest.what}: then the worst is {check_sentence(nearest.worst)}"
        yield "nearest that meets all", f"{found}. {further}"
    if closed.kept:
        yield "given and kept", ", ".join(closed.kept)
    yield from effort_rows(closed.effort)


def effort_rows(effort: Effort) -> Iterator[tuple[str, str]]:
    """Yield what a closure cost, and over what it searched: what, and in words.

    Args:
        effort: Of it.
    """
    known = f", {effort.from_journal} answers from its journal" if effort.from_journal else ""
    cost = f"{effort.sizings} sizings{known}; {effort.looked_at} changes looked at, {effort.confirmed} confirmed"
    starts = "one start" if effort.starts == 1 else f"{effort.starts} starts"
    yield "effort", f"{cost}, {effort.taken} made; {starts}: a local search, no proof that nothing is lighter"
    yield "searched", ", ".join(effort.searched) or "nothing: all that may be changed is given"
    if effort.not_searched:
        yield "not searched", ", ".join(effort.not_searched)


def _told(rounds: Sequence[Round], *, all_rounds: bool) -> dict[int, Round]:
    """Return number -> round: all, or the first of each kind of step and the last."""
    seen = {round_.step: number for number, round_ in reversed(list(enumerate(rounds, start=1)))}
    numbers = {*seen.values(), len(rounds)}
    return {number: round_ for number, round_ in enumerate(rounds, start=1) if all_rounds or number in numbers}


# ----------------------------------------------------------------------------------------------------------------------
# A run on one screen: the verdict, ten key numbers, and nothing that a table says better.
# ----------------------------------------------------------------------------------------------------------------------


LABEL = 20
"""Width of the names of numbers [characters]."""


def run_text(
    facts: Particulars,
    modes: Modes,
    traces: Mapping[str, Trace],
    *,
    review: Review | None = None,
    campbell: Sequence[SpeedCase] = (),
) -> RenderableType:
    """Return the verdict and the key numbers of a run, one below the other.

    Args:
        facts: Of a sizing.
        modes: Of its train.
        traces: Load case -> run of it.
        review: Of the design; None where the run was interrupted.
        campbell: Critical speeds that were looked at.
    """
    sizing = facts.sizing
    numbers = (*_sized(facts), *_moved(modes, traces, campbell), *_peaks(sizing, traces))
    grid = Table.grid(padding=(0, 1))
    grid.add_column(no_wrap=True, min_width=LABEL)
    grid.add_column()
    for name, value in numbers:
        grid.add_row(name, value)
    return Group(Text("\n".join([sizing.design.name, "", *run_verdict(sizing, review), ""])), grid)


def run_verdict(sizing: Sizing, review: Review | None) -> tuple[str, ...]:
    """Return in a sentence whether everything holds, with the worst check.

    Args:
        sizing: As sized.
        review: Of the design; None where the run was interrupted: sizing then speaks for itself.
    """
    said = sizing_headline(sizing) if review is None else headline(review)
    return (f"{said[:1].upper()}{said[1:]}.",)


def _sized(facts: Particulars) -> Iterator[tuple[str, str]]:
    sizing, complete, box = facts.sizing, complete_words(facts), facts.envelope
    flow = sizing.reference
    if complete:
        yield "complete mass", complete
    yield "train as sized" if complete else "mass", train_mass(facts)
    yield "power", f"{text(sizing.rated_power, 'power')}, {text(sizing.power_density, 'specific_power')}"
    speeds = [f"{machine.name} {abs(shown(flow.speeds[machine.shaft], 'speed')):.0f}" for machine in sizing.machines]
    yield "speeds", f"{', '.join(speeds)} rpm{f', case {flow.case}' if len(sizing.flows) > 1 else ''}"
    yield "teeth", ", ".join(f"{gear.name} {gear.teeth}" for gear in sizing.gears)
    sides = " x ".join(f"{shown(side, 'length'):.0f}" for side in (box.width, box.height, box.length))
    yield "envelope", f"{sides} mm, without housing"


def _moved(modes: Modes, traces: Mapping[str, Trace], campbell: Sequence[SpeedCase]) -> Iterator[tuple[str, str]]:
    lowest = next((float(frequency) for frequency, _ in modes.groups() if frequency > 0.0), None)
    if lowest is not None:
        yield "lowest frequency", f"{text(lowest, 'frequency')}, of {len(modes.frequency) - modes.rigid} modes"
    judged = [critical for case in campbell for critical in case.nearest]
    if judged:
        near = smallest(judged, lambda critical: critical.over_limit)
        above = "above" if near.separation_margin > 0.0 else "below"
        apart = f"the gearbox runs {abs(near.separation_margin):.1%} {above} it"
        yield "nearest resonance", f"{near.order} meets mode {near.mode}; {apart}"
    for case, trace in traces.items():
        closes = f"closes {energy_text(trace.work.imbalance)} over {trace.duration:.4g} s"
        yield "energy balance", f"{closes}, case {case}"


def _peaks(sizing: Sizing, traces: Mapping[str, Trace]) -> Iterator[tuple[str, str]]:
    for case, trace in traces.items():
        if loads := dynamic_loads(sizing, trace):
            peak = largest(loads, lambda load: load.peak_over_mean)
            words = f"{written(peak.peak_over_mean, 3)} in the teeth of {peak.mesh}, case {case}"
            yield "peak over mean", words
