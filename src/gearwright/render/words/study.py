"""What a study, a search and an enumeration of architectures say in sentences."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np

from gearwright.base import SolveError, largest_first, smallest, smallest_first, text, written
from gearwright.enumeration import Ranking
from gearwright.optimum import Optimum, hypervolume
from gearwright.render.tables.study import chance, letter, likeliest_words, teeth_text
from gearwright.render.tables.variants import FLAT, heading, numeric_axis, percent, reasons
from gearwright.spec import Study
from gearwright.spec.studies import RELIABILITY
from gearwright.study import EqualLife, Row, Table
from gearwright.study.answers import Verdict, bound, confidence, kept, scenarios, sensitivity, verdict
from gearwright.study.architectures import difference, wider
from gearwright.study.reliability import reliability
from gearwright.study.tables import front_table, quantiles, violations

# ----------------------------------------------------------------------------------------------------------------------
# What a study says in sentences: which design wins, by how much, and how sure that is.
# ----------------------------------------------------------------------------------------------------------------------


DRAWN = 3
"""Designs of a front that are shown: its ends and the one between them."""
STILL = 0.5
"""Gain of the last quarter of a search below which it stands still [%]."""
LEAST_SURE = 20
"""Cases that keep the constraints below which nothing is said of how sure a best one is."""
SAMPLED = ("random", "sobol", "latin-hypercube")
"""Methods whose cases are samples of what is not known, not choices."""


def answer(study: Study, table: Table) -> Iterator[str]:
    """Yield what a reader asks first, in sentences.

    Args:
        study: As run.
        table: Its rows.
    """
    outcome = verdict(study, table)
    if outcome is not None:
        yield from _wins(outcome)
        yield from _duel(study, table, outcome)
    if study.sampling.method in RELIABILITY:
        yield from _chances(study, table)
    elif study.sampling.method == "saltelli":
        yield from _drivers(study, table)
    elif study.sampling.method in SAMPLED and len(study.designs) == 1 and not study.objectives:
        yield from (_range(table, name) for name in table.numbers)
    if outcome is None or study.sampling.method not in SAMPLED:
        yield from (_best(study, table, name, sense) for name, sense in study.objectives.items())
        yield from _ends(study, table)
        yield from _sureness(study, table)
    if study.sampling.method not in RELIABILITY:  # their cases are where failures are, not as often as they come
        yield from _constraints(study, table)
    failed = len(table.failed)
    designs = f"{len(study.designs)} designs" if len(study.designs) > 1 else study.designs[0]
    cases = f"{len(table.rows):,} case{'s' if len(table.rows) > 1 else ''}"
    yield f"{cases} of {designs}; {f'{failed:,} infeasible' if failed else 'none failed'}."
    yield from (f"Infeasible: {reason}." for reason in reasons(table))


def key_numbers(outcome: Verdict | None) -> list[tuple[str, str]]:
    """Return what a reader of the page sees first: name and value.

    Args:
        outcome: How the designs stand; None gives nothing.
    """
    if outcome is None:
        return []
    first, second = outcome.standings[:2]
    return [
        ("wins", first.design),
        (f"first in, of {outcome.scenarios:,} cases", percent(first.first / outcome.scenarios)),
        ("first, over all weights", percent(first.weights)),
        ("mean rank", f"{first.place:.1f}"),
        ("next", f"{second.design}, {second.place:.1f}"),
    ]


def _wins(outcome: Verdict) -> Iterator[str]:
    first, second = outcome.standings[:2]
    text = (
        f"{first.design} wins: with objectives of the same weight its mean rank is {first.place:.1f} of"
        f" {len(outcome.standings)}; next is {second.design} with {second.place:.1f}."
    )
    if outcome.scenarios == 1:
        yield f"{text} This is one case; sample what is not known ([sampling]) to see how sure it is."
    else:
        low, high = outcome.sureness
        yield (
            f"{text} It is first in {first.first:,} of {outcome.scenarios:,} cases with equal inputs,"
            f" {percent(first.first / outcome.scenarios)} (95 % confidence: {percent(low)} to {percent(high)})."
        )
    shares = largest_first(outcome.standings, lambda standing: standing.weights)
    named = ", ".join(f"{share.design} {percent(share.weights)}" for share in shares[:3] if share.weights >= 0.005)
    changed = ", ".join(f"{design} without {heading(name)}" for name, design in outcome.without.items())
    decisive = (
        f"If one did not count, it would be {changed}" if changed else "It wins whichever one of them does not count"
    )
    yield f"If nothing is known of the objectives' weights, the chance to be first is: {named}. {decisive}."


def _duel(study: Study, table: Table, outcome: Verdict) -> Iterator[str]:
    """Compare the winner with the next one, objective by objective, at equal inputs."""
    first, second = (standing.design for standing in outcome.standings[:2])
    better, worse, undecided = list[str](), list[str](), list[str]()
    for name, sense in study.objectives.items():
        ratios = _ratios(table, name, first, second)
        if len(ratios):
            median = float(np.median(ratios))
            gains = int(((ratios < 1.0) if sense == "minimum" else (ratios > 1.0)).sum())
            low, high = confidence(gains, len(ratios)) if len(ratios) > 1 else (gains, gains)
            side = better if low > 0.5 else worse if high < 0.5 else undecided
            much = "" if side is undecided else f" {_more(median)}"
            side.append(f"{heading(name)}{much} ({gains:,} of {len(ratios):,} better)")
    groups = ((better, "better in"), (worse, "worse in"), (undecided, "no difference to tell in"))
    said = "; ".join(f"{words} {', '.join(names)}" for names, words in groups if names)
    yield f"{first} against {second}, medians at equal inputs: {said}."


def _ratios(table: Table, name: str, first: str, second: str) -> np.ndarray:
    pairs = [
        (by_design[first].number(name), by_design[second].number(name))
        for by_design in ({row.design: row for row in rows if not row.problem} for rows in scenarios(table))
        if first in by_design and second in by_design
    ]
    return np.array([ours / theirs for ours, theirs in pairs if theirs and np.isfinite(ours) and np.isfinite(theirs)])


def _more(ratio: float) -> str:
    """Say a ratio as a reader does: in per cent near 1, in times far from it."""
    if ratio >= 2.0:
        return f"{ratio:.3g} times"
    if ratio <= 0.5:
        return f"1/{1.0 / ratio:.3g}"
    return f"{abs(ratio - 1.0) * 100.0:.2g} % {'more' if ratio > 1.0 else 'less'}"


def _best(study: Study, table: Table, name: str, sense: str) -> str:
    """Say which case that keeps the constraints is best, by how much over other designs, or how flat the optimum is."""
    sign = 1.0 if sense == "minimum" else -1.0
    best: dict[str, Row] = {}
    allowed = [row for row in table.good if not violations(study, [row])[0]]
    for row in smallest_first(allowed or table.good, lambda row: sign * row.number(name)):
        best.setdefault(row.design, row)
    first, *others = best.values()
    text = f"{sense.capitalize()} {heading(name)}: {first.design}{at(table, first)}, {value(table, first, name)}"
    if others:
        return f"{text}; next {others[0].design}, {value(table, others[0], name)}{_off(first, others[0], name)}."
    return f"{text}{_flat(study, table, name, first)}."


def _sureness(study: Study, table: Table) -> Iterator[str]:
    """Say how sure it is that nothing better was left out: by how a search still gained, or by how many were drawn."""
    allowed = [row for row, broken in zip(table.good, violations(study, table.good), strict=True) if not broken]
    if not study.objectives or len(allowed) < LEAST_SURE:
        return
    if study.sampling.method in SAMPLED:
        better = 100.0 * (1.0 - 0.05 ** (1.0 / len(allowed)))
        yield f"Of all such cases {better:.2g} % at most beat the best of an objective, with 95 % confidence."
    elif study.sampling.method == "nsga2":
        signs = [1.0 if sense == "minimum" else -1.0 for sense in study.objectives.values()]
        values = np.array([[row.number(name) for name in study.objectives] for row in allowed]) * signs
        worst = values.max(axis=0)
        before, after = (hypervolume(some, worst) for some in (values[: 3 * len(values) // 4], values))
        gain = 100.0 * (after / before - 1.0) if before else np.inf
        yield (
            f"The last quarter of the search made the front better by {gain:.2g} % (hypervolume): "
            + ("it stands still." if gain <= STILL else "it still gains, and a larger count may find better.")
        )


def _off(first: Row, second: Row, name: str) -> str:
    """Say how far the next one is off, where a ratio says anything."""
    best, next_best = first.number(name), second.number(name)
    if next_best == best:
        return ", as good"
    return f", {percent(abs(next_best / best - 1.0), 1)} off" if best and np.isfinite(best) else ""


def _flat(study: Study, table: Table, name: str, best: Row) -> str:
    """Say how far an axis may move from the optimum."""
    axis = numeric_axis(table)
    if axis is None or len(table.free) > 1 or study.sampling.method not in ("grid", "list"):
        return ""
    top = best.number(name)
    near = [float(row.inputs[axis]) for row in table.good if abs(row.number(name) - top) <= FLAT * abs(top)]
    return f"; within {percent(FLAT)} of it from {min(near):g} to {max(near):g}" if len(near) > 1 else ""


def _ends(study: Study, table: Table) -> Iterator[str]:
    """Say what the objectives do from one end of a sweep to the other."""
    axis = numeric_axis(table)
    if axis is None or len(table.free) > 1 or len(study.designs) > 1 or len(study.objectives) < 2 or not table.tied:
        return
    rows = sorted(table.good, key=lambda row: float(row.inputs[axis]))
    first, last = rows[0], rows[-1]
    changes = [
        f"{heading(name)} {value(table, first, name)} to {value(table, last, name)}" for name in study.objectives
    ]
    yield f"From {axis} = {first.inputs[axis]:g} to {last.inputs[axis]:g}: {', '.join(changes)}."


def _range(table: Table, name: str) -> str:
    """Say where a result lies, and how sure that is."""
    unit = f" {table.unit(name)}" if table.unit(name) else ""
    values = [row.shown(name) for row in table.good]
    low, median, high = (written(quantile) for quantile in quantiles(values, (0.05, 0.5, 0.95)))
    limit = bound(values)
    sure = "" if limit is None else f"; 95 % of all that may come stay below {written(limit)}{unit}, 95 % sure"
    return f"{heading(name)}: median {median}{unit}, 5 to 95 %: {low} to {high}{unit}{sure}."


def _drivers(study: Study, table: Table) -> Iterator[str]:
    """Say which axis decides most about each result."""
    for name in table.numbers:
        try:
            strongest, *rest = sensitivity(study, table, name)
        except SolveError:
            continue
        parts = []
        for index in (strongest, *rest[:1]):
            low, high = index.total_interval
            parts.append(f"{index.axis} {percent(index.total)} ({percent(low)} to {percent(high)})")
        yield f"{heading(name)} depends most on {', then '.join(parts)}, as shares of its variance, 95 % confidence."


def _chances(study: Study, table: Table) -> Iterator[str]:
    """Say how likely each design breaks a constraint, how sure that is, and what the likeliest failure is."""
    for found in reliability(study, table):
        low, high = (chance(end) for end in found.interval)
        likely = f"{chance(found.probability)} (95 % confidence: {low} to {high}), β = {written(found.index)}"
        if not found.settled:
            yield f"{found.design}: not settled; a larger count is needed. So far a constraint is broken with {likely}."
            continue
        yield f"{found.design} breaks a constraint with a probability of {likely}."
        if found.limits[0].likeliest:
            yield f"The likeliest failure: {likeliest_words(found.limits[0])}."


def _constraints(study: Study, table: Table) -> Iterator[str]:
    """Say in how many cases each constraint is kept, and how sure that is if the cases are samples."""
    for name, hits in kept(study, table).items():
        limit, count = study.constraints[name], len(table.rows)
        asked = [
            f"{word} {bound:g}" for word, bound in (("≥", limit.minimum), ("≤", limit.maximum)) if bound is not None
        ]
        low, high = confidence(hits, count)
        sure = f", {percent(hits / count)} (95 % confidence: {percent(low)} to {percent(high)})"
        unit = f" {table.unit(name)}" if table.unit(name) else ""
        kind = sure if study.sampling.method in SAMPLED else ""
        yield f"{heading(name)} {' and '.join(asked)}{unit} is kept in {hits:,} of {count:,} cases{kind}."


def at(table: Table, row: Row) -> str:
    """Return the inputs of a case in words; empty if nothing varies.

    Args:
        table: Of the study.
        row: Of the table.
    """
    values = {path: row.inputs[path] for path in table.free}
    inputs = [f"{path} = {x:.6g}" if isinstance(x, float) else f"{path} = {x}" for path, x in values.items()]
    return f" at {', '.join(inputs)}" if inputs else ""


def value(table: Table, row: Row, name: str) -> str:
    """Return a result of a case as it is read, with its unit.

    Args:
        table: Of the study.
        row: Of the table.
        name: Of the result.
    """
    return f"{row.text(name)} {table.unit(name)}".rstrip()


def chosen(study: Study, table: Table, outcome: Verdict | None) -> Iterator[tuple[str, Row]]:
    """Yield caption and case of the designs that a study ends with: winner and next, or ends and middle of a front.

    Args:
        study: As run.
        table: Its rows.
        outcome: Who wins, of a study with scenarios.
    """
    if outcome is not None:
        for place, standing in enumerate(outcome.standings[:2]):
            row = next((row for row in table.good if row.design == standing.design), None)
            if row is not None:
                yield f"{'The winner' if place == 0 else 'The next'}, {row.design}, in the first case of the study", row
    elif study.objectives:
        rows = front_table(study, table).rows
        for k in sorted({0, len(rows) // 2, len(rows) - 1})[:DRAWN]:
            name = f"{letter(k)}: " if len(rows) > 1 else ""
            yield f"{name}{rows[k].design}{at(table, rows[k])}", rows[k]


# ----------------------------------------------------------------------------------------------------------------------
# What a search found, in sentences.
# ----------------------------------------------------------------------------------------------------------------------


def optimum_sentences(optimum: Optimum) -> Iterator[str]:
    """Yield what is best, how much was looked at, and how sure the choice is.

    Args:
        optimum: From `optimise`.
    """
    best, counts = optimum.best, optimum.counts
    results = best.row.results
    said = ", ".join(
        f"{heading(name)} {text(best.row.number(name), results[name].dimension)}".strip() for name in optimum.objectives
    )
    teeth = f"; teeth {teeth_text(best)}" if teeth_text(best) else ""
    inputs = ", ".join(f"{path} = {_written(best.inputs[path])}" for path in optimum.study.axes)
    yield f"Chosen of {len(optimum.front)} on the front: {said}, with {best.row.design}: {inputs}{teeth}."
    generations = f"{counts.generations} generation{_s(counts.generations)}"
    looked = f"{counts.screened:,} designs screened, {counts.bred:,} in {generations}"
    ended = "the hypervolume stands still" if optimum.still else "the evaluations ran out while the hypervolume grew"
    yield f"Looked at: {looked}, {counts.polished:,} in the polish; {ended}."
    if not optimum.gaps:
        yield "One start: it tells nothing of how far the best lies; --restarts 4 does."
    else:
        gaps = ", ".join(
            f"{heading(gap.objective)} {text(gap.best, results[gap.objective].dimension)} at best, and by about"
            f" {text(gap.beyond, results[gap.objective].dimension)} better may be had"
            for gap in optimum.gaps
        )
        yield f"{optimum.starts} independent starts of as many designs: {gaps}."
    if optimum.regrets:
        own = optimum.regrets[0]
        yield (
            f"Under what is uncertain it is the best of the front in {percent(own.best)} of the samples; in 95 % of"
            f" them it is worse than the best by no more than {percent(own.late)} of the span of the front."
        )
        yield f"Built as it is, it keeps every constraint in {percent(own.keeps)} of them."


def _s(count: int) -> str:
    return "" if count == 1 else "s"


def _written(value: object) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


# ----------------------------------------------------------------------------------------------------------------------
# What designs at equal life come to, in sentences: which is lightest, by how much, and whether that can be told.
# ----------------------------------------------------------------------------------------------------------------------


def equal_life_sentences(rows: Sequence[EqualLife]) -> Iterator[str]:
    """Yield who is lightest and by how much, who cannot be compared, and who meets not everything and by what.

    Args:
        rows: In their order.
    """
    passing = [row for row in rows if row.is_compared]
    if passing:
        yield _lightest(passing[0])
    if len(passing) > 1:
        yield f"The next, {passing[1].title}, {behind(*passing[:2])}"
    yield from not_comparable(rows, lambda row: row.title)
    yield from (f"Moved with bearings in it: {row.title}, to {row.moved}." for row in rows if row.moved)
    yield from (f"{row.title} does not meet everything: {row.fails}{_searched(row)}." for row in rows if row.fails)


def _searched(row: EqualLife) -> str:
    """Return over what it was looked for with bearings in a gearbox; empty where bearings leave nothing unmet."""
    return f"; with bearings in it looked for over {row.searched}" if row.searched else ""


def _lightest(row: EqualLife) -> str:
    machines = f" with machines of {text(row.machines, 'mass', 3)}" if row.machines else ""
    weighs = text(row.with_machines or 0.0, "mass", 3)
    return f"The lightest that passes as far as assessed: {row.title}, {weighs}{machines}."


def behind(best: EqualLife, other: EqualLife) -> str:
    """Return by how much another gearbox is heavier, and whether that separates both with what is known of masses.

    Args:
        best: With all its bearings.
        other: Likewise.
    """
    found = difference(best, other)
    if found is None:
        return "is not comparable."
    parts = [f"rules of mass {found.rules:.0f}", f"own of each gearbox {found.own:.0f}"]
    left = "; what the search left is not in it"
    if found.search is not None:
        parts, left = [f"search {found.search:.0f}", *parts], ""
    word = "separable" if found.separable else "not separable with what is known"
    across = wider(other, best)
    apart = (
        "" if across is None else f" Its frontal diameter is {across:.2f} times as large: mass alone does not decide."
    )
    return (
        f"is {text(found.mass, 'mass', 3)} heavier: {found.mass:.0f} ± {found.deviation:.0f} kg (of the ±:"
        f" {', '.join(parts)}{left}): {word}.{apart}"
    )


def not_comparable(rows: Iterable[EqualLife], called: Callable[[EqualLife], str]) -> Iterator[str]:
    """Yield whose masses leave bearings of shafts out, so that they are compared with no others.

    Args:
        rows: Of designs closed for one life.
        called: What a row is called.
    """
    for row in rows:
        if row.without_bearings:
            yield f"Not comparable: {called(row)} has no bearings on {row.without_bearings}."


# ----------------------------------------------------------------------------------------------------------------------
# What an enumeration of architectures comes to, in sentences.
# ----------------------------------------------------------------------------------------------------------------------


def ranking_sentences(ranking: Ranking) -> Iterator[str]:
    """Yield how many there are, which is the lightest and how sure that is, and what it is lighter than.

    Args:
        ranking: From `architectures`.
    """
    count, refused = len(ranking.candidates), ranking.refused
    yield f"{count} architectures can give the ratio; {refused} of them are refused, each with its reason."
    if ranking.unborne:
        fatigued = sum(row.design is not None for row in ranking.candidates)
        yield (
            f"In {ranking.unborne} of the {fatigued} that were sized against fatigue planets have no bearing that lives"
            " as long, ratios chosen anew or not."
        )
    passing = ranking.passing
    yield from not_comparable(ranking.closed, ranking.called)
    if not passing:
        looked = f"of {len(ranking.closed)} that were closed" if ranking.closed else "as none was closed"
        yield f"None is known to meet everything for {text(ranking.life, 'life', 3)}, {looked}."
        yield from _lightest_that_fails(ranking)
        return
    yield from _lightest_that_fails(ranking)
    best = passing[0]
    yield lightest_sentence(ranking)
    if len(passing) > 1:
        yield f"The next, {ranking.called(passing[1])}, {behind(best, passing[1])}"
    yield from _restarts(ranking)
    others = [row for row in ranking.beside if row is not best and row is not passing[min(1, len(passing) - 1)]]
    if others:
        yield f"The lightest of those compared with it, {ranking.called(others[0])}, {behind(best, others[0])}"


def _restarts(ranking: Ranking) -> Iterator[str]:
    """Yield how often the search was begun anew, and why no oftener."""
    if ranking.stopped:
        times = "once" if ranking.restarts == 1 else f"{ranking.restarts} times"
        yield f"Those that could be the lightest were closed from other numbers {times}: {ranking.stopped}."


def _lightest_that_fails(ranking: Ranking) -> Iterator[str]:
    """Yield which gearbox is lighter than all that pass, and what it lacks with its shafts in bearings."""
    known = [row for row in ranking.closed if row.fails and not row.without_bearings and row.with_machines is not None]
    if not known:
        return
    best, most = smallest(known, lambda row: row.with_machines or 0.0), math.inf
    if ranking.passing:
        most = ranking.passing[0].with_machines or 0.0
    if (best.with_machines or 0.0) < most:
        yield f"Lighter, but for what it lacks: {ranking.called(best)}, {_weighs(best)}; {best.fails}."


def lightest_sentence(ranking: Ranking) -> str:
    """Return which is the lightest, with its band.

    Args:
        ranking: Of which one passes.
    """
    best = ranking.passing[0]
    life = text(ranking.life, "life", 3)
    return f"The lightest that passes its review for {life}: {ranking.called(best)}, {_weighs(best)}."


def _weighs(row: EqualLife) -> str:
    band = ""
    if row.lightest is not None and row.heaviest is not None:
        band = f" ({text(row.lightest, 'mass', 3)} to {text(row.heaviest, 'mass', 3)})"
    beside = f" and machines of {text(row.machines, 'mass', 3)}{_of_machines(row)}" if row.machines else ""
    return f"{text(row.complete_mass or 0.0, 'mass', 3)}{band}{beside}"


def _of_machines(row: EqualLife) -> str:
    """Say of what the mass of machines is, where inverters and cooling are counted."""
    if not (row.inverters or row.cooling):
        return ""
    parts = (("motors", row.motors), ("inverters", row.inverters), ("cooling", row.cooling))
    said = ", ".join(f"{name} {text(mass, 'mass', 3)}" for name, mass in parts if mass)
    return f" ({said})"
