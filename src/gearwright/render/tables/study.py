"""Tables of answers: ranking, front, limits, searches, architectures, designs at equal life.

How studies run is in `words`, their numbers over axes in `figures/study`.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import astuple, dataclass, fields, make_dataclass
from typing import Any, get_type_hints

import numpy as np

from gearwright.base import Mass, Speed, largest, largest_first, margin_text, shown, smallest, text, unit, written
from gearwright.enumeration import Candidate
from gearwright.optimum import Best, Optimum
from gearwright.render.grid import Cell, Column, Table, table, table_csv
from gearwright.render.tables.variants import BESIDE_MOTORS, heading, percent, spread
from gearwright.sizing import Named
from gearwright.sizing.mass import GROUPS, CompleteMass, Statistics
from gearwright.spec import Axis, Study, value_at
from gearwright.study import Row, Table as Rows
from gearwright.study.answers import Verdict, bound
from gearwright.study.architectures import EqualLife, outdone
from gearwright.study.measures import Measures
from gearwright.study.reliability import LimitState, Reliability
from gearwright.study.tables import Limit, quantiles

# ----------------------------------------------------------------------------------------------------------------------
# Tables on the page of a study: ranking, Pareto front, the spread of results, and what was varied.
# ----------------------------------------------------------------------------------------------------------------------


MILLION = 1e6
"""From here a number is written with a power of ten in narrow columns."""


def standings_table(rows: Rows, outcome: Verdict) -> Table:
    """Return how the designs stand: their places, how often they are first, and results that are names.

    Args:
        rows: Cases of a study.
        outcome: How its designs stand.
    """
    names = [name for name in rows.results if name not in rows.numbers]
    columns = [
        _column("design"),
        _column("mean rank"),
        _column("first"),
        _column("all weights"),
        _column("non-dominated"),
    ]
    columns += [_result_column(name, rows.good[0].results[name]) for name in names]
    lines = []
    for standing in outcome.standings:
        cases = [row for row in rows.good if row.design == standing.design]
        cells = [Cell(standing.design, standing.design), Cell(standing.place, f"{standing.place:.1f}")]
        cells += [
            _share(part) for part in (standing.first / outcome.scenarios, standing.weights, standing.non_dominated)
        ]
        lines.append((*cells, *(_typical(cases, name, rows) for name in names)))
    note = (
        "Mean rank over all objectives; first: part of the cases with equal inputs in which that rank is the best;"
        " all weights: part of all weights of the objectives, drawn evenly, with which it is first; non-dominated:"
        " part of the cases in which it is on the Pareto front."
    )
    return Table("Ranking of the designs", tuple(columns), tuple(lines), note)


def values_table(study: Study, rows: Rows, outcome: Verdict) -> Table:
    """Return median and range of every result that is a number, designs in the order of their places.

    Args:
        study: With objectives, which come first.
        rows: Its cases.
        outcome: How its designs stand.
    """
    names = [*study.objectives, *(name for name in rows.numbers if name not in study.objectives)]
    columns = [_column("design"), *(_result_column(name, rows.good[0].results[name]) for name in names)]
    by_design = [[row for row in rows.good if row.design == standing.design] for standing in outcome.standings]
    lines = [
        (Cell(standing.design, standing.design), *(_typical(cases, name, rows) for name in names))
        for standing, cases in zip(outcome.standings, by_design, strict=True)
    ]
    note = "Medians; in brackets from 5 to 95 % of the cases." if outcome.scenarios > 1 else ""
    return Table("Results of the designs", tuple(columns), tuple(lines), note)


def _typical(cases: Sequence[Row], name: str, rows: Rows) -> Cell:
    """Return the median with its range, or the commonest name."""
    if not cases:
        return Cell(None, "–")
    if name not in rows.numbers:
        word, count = Counter(str(row.results[name].value) for row in cases).most_common(1)[0]
        return Cell(word, word if count == len(cases) else f"{word} ({percent(count / len(cases))})")
    low, median, high = quantiles([row.shown(name) for row in cases], (0.05, 0.5, 0.95))
    if low == high:
        return Cell(median, written(median))
    digits = 3 if high - low > 0.01 * abs(median) else 4
    short = [_short(quantile, digits) for quantile in (median, low, high)]
    return Cell(median, f"{short[0]} ({short[1]}–{short[2]})")


def _short(number: float, digits: int) -> str:
    return f"{number:.1e}".replace("e+0", "e") if MILLION <= abs(number) < np.inf else written(number, digits)


def front_list(study: Study, rows: Rows, chosen: Sequence[Row]) -> Table:
    """Return the designs of a front with their letters, inputs and results.

    Args:
        study: With objectives.
        rows: Its cases.
        chosen: Those of the front that are listed.
    """
    first = chosen[0].results
    names = [*study.objectives, *(name for name in rows.results if name not in study.objectives)]
    columns = [_column(""), _column("design"), *(_column(path) for path in rows.free)]
    columns += [_result_column(name, first[name]) for name in names]
    lines = [
        (Cell(letter(k), letter(k)), Cell(row.design, row.design), *(_given(row.inputs[path]) for path in rows.free),
         *(_typical([row], name, rows) for name in names))
        for k, row in enumerate(chosen)
    ]  # fmt: skip
    return Table("Pareto front", tuple(columns), tuple(lines))


def letter(place: int) -> str:
    """Return the letter of a design on the front.

    Args:
        place: From 0.
    """
    return chr(ord("A") + place)


def spread_table(rows: Rows, *, sampled: bool) -> Table:
    """Return how every result is spread, and what 95 % of all that may come keep, with 95 % confidence.

    Args:
        rows: Cases of a study.
        sampled: Whether they are samples, which a bound needs.
    """
    names = ["result", "unit", "minimum", "5 %", "median", "95 %", "maximum"]
    columns = [_column(name) for name in (names + (["95 % are above", "95 % are below"] if sampled else []))]
    lines = []
    for line in spread(rows):
        values = [row.shown(line.result) for row in rows.good]
        cells = [Cell(heading(line.result), heading(line.result)), Cell(line.unit, line.unit)]
        cells += [Cell(0.0, text) for text in line.values]
        if sampled:
            above = bound([-value for value in values])
            cells += [_limit(None if above is None else -above), _limit(bound(values))]
        lines.append(tuple(cells))
    note = (
        "The last two columns hold for 95 % of all that may come, with 95 % confidence (Wilks 1941; 59 cases or more)."
    )
    return Table("How the results are spread", tuple(columns), tuple(lines), note if sampled else "")


def inputs_table(study: Study) -> Table:
    """Return what was varied and what was set.

    Args:
        study: As run.
    """
    lines = [(Cell(path, path), _word(axis_words(axis))) for path, axis in study.axes.items()]
    lines += [(Cell(path, path), _word(f"{value} in all cases")) for path, value in study.changes.items()]
    return Table("What was varied", (_column("path"), _column("values")), tuple(lines))


def axis_words(axis: Axis) -> str:
    """Return the values of an axis in words.

    Args:
        axis: As written.
    """
    if axis.values is not None:
        return ", ".join(str(value) for value in axis.values)
    if axis.distribution == "normal":
        return f"normal, mean {axis.mean:g}, standard deviation {axis.deviation:g}"
    ends = f"{axis.first:g} to {axis.last:g}"
    if axis.step is not None:
        return f"{ends} in steps of {axis.step:g}"
    likeliest = f", likeliest {axis.likeliest:g}" if axis.likeliest is not None else ""
    return f"{ends}, {axis.distribution}{likeliest}"


def _column(name: str) -> Column:
    return Column(name, name, "", "")


def _result_column(name: str, example: Named) -> Column:
    return Column(name, heading(name), "", "" if isinstance(example.value, str) else example.dimension)


def _share(part: float) -> Cell:
    return Cell(part, percent(part))


def _limit(value: float | None) -> Cell:
    return Cell(value, "too few" if value is None else written(value))


def _given(value: object) -> Cell:
    return Cell(value, f"{value:.5g}" if isinstance(value, float) else str(value))


def _word(text: str) -> Cell:
    return Cell(text, text)


# ----------------------------------------------------------------------------------------------------------------------
# How likely a design breaks the constraints of its study: every limit, and the likeliest failure.
# ----------------------------------------------------------------------------------------------------------------------


LITTLE = 0.005
"""Weight of an axis below which it has no side [-]."""


def limits_table(found: Reliability) -> Table:
    """Return the probability and the index of every limit.

    Args:
        found: Of one design.
    """
    columns = [Column(name, name, "", "") for name in ("limit", "probability", "index β")]
    lines = [
        (Cell(limit_words(state.limit), limit_words(state.limit)), Cell(state.probability, chance(state.probability)),
         Cell(state.index, written(state.index)))
        for state in found.limits
    ]  # fmt: skip
    note = "That each limit alone is broken: to first order for the method form, else as counted among the failures."
    return Table(f"Limits of {found.design}", tuple(columns), tuple(lines), note)


def failure_table(study: Study, found: Reliability) -> Table:
    """Return the likeliest failure of the limit that is broken most often, axis by axis.

    Args:
        study: As run.
        found: Of one design, with a failure.
    """
    state = found.limits[0]
    columns = [Column(name, name, "", "") for name in ("axis", "median", "at the failure", "weight", "harm by")]
    lines = []
    for path, cosine in largest_first(state.influence.items(), lambda entry: abs(entry[1])):
        cells = [
            Cell(path, path),
            *(_given_text(value) for value in (value_at(path, study.axes[path], 0.5), state.likeliest[path])),
        ]
        side = "–" if cosine**2 < LITTLE else "larger values" if cosine > 0.0 else "smaller values"
        lines.append((*cells, Cell(cosine**2, percent(cosine**2)), Cell(side, side)))
    note = (
        f"The likeliest combination at which {limit_words(state.limit)} is broken. Weight: squared cosine of its"
        " direction in standard normal space; all of them add up to 100 %."
    )
    return Table("The likeliest failure", tuple(columns), tuple(lines), note)


def limit_words(limit: Limit) -> str:
    """Return a limit as it is read, such as ``worst margin ≥ 1``.

    Args:
        limit: Of a study.
    """
    return f"{heading(limit.result)} {'≥' if limit.is_minimum else '≤'} {limit.bound:g}"


def chance(probability: float) -> str:
    """Return a probability as it is read: in per cent where it is one, else with its power of ten.

    Args:
        probability: From 0 to 1 [-].

    >>> chance(0.034), chance(1.3e-6)
    ('3.4 %', '1.3e-06')
    """
    return percent(probability, 1) if probability >= 0.001 or not probability else f"{probability:.2g}"


def likeliest_words(state: LimitState) -> str:
    """Return the likeliest failure of a limit in words.

    Args:
        state: With a failure.
    """
    values = ", ".join(f"{path} = {_text(value)}" for path, value in state.likeliest.items())
    strongest = largest(state.influence, lambda path: abs(state.influence[path]))
    return f"{limit_words(state.limit)} at {values}; {strongest} has {percent(state.influence[strongest] ** 2)} of it"


def _given_text(value: object) -> Cell:
    return Cell(value, _text(value))


def _text(value: object) -> str:
    return f"{value:.5g}" if isinstance(value, float) else str(value)


# ----------------------------------------------------------------------------------------------------------------------
# The answer of a search as tables: its front, what binds each design, what limits cost, what doubt does to it.
# ----------------------------------------------------------------------------------------------------------------------


SHOWN_OF_FRONT = 12
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
    evenly = np.unique(np.linspace(0, len(optimum.front) - 1, SHOWN_OF_FRONT).astype(int)).tolist()
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
        rows.append((_word(letter(k)), _word(teeth), _word(binds or "nothing near")))
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
            _word(price.limit),
            _word(price.kind),
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
            _word(named), _number(100.0 * regret.best), _number(100.0 * regret.mean), _number(100.0 * regret.late),
            _number(100.0 * regret.keeps), *(_word(f"{written(low)}–{written(high)}") for low, high in spread),
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
        (_word(own.path), _number(own.low), _number(own.high),
         *(_number(shown(own.changes[name], dimensions[name])) for name in names),
         _word("the same" if set(own.chosen) == {optimum.chosen} else "another one"))
        for own in optimum.influences
    ]  # fmt: skip
    note = "From the 16 % to the 84 % quantile, all else at its median: change of the chosen design, and the choice."
    return Table("Sensitivity to assumptions", (*columns, *_columns("chosen")), tuple(rows), note)


def fit_table(optimum: Optimum) -> Table:
    """Return how well surrogates foretell each result that they are not told.

    Args:
        optimum: From `optimise`, with surrogates.
    """
    rows = [(_word(heading(fit.result)), _number(100.0 * fit.error), Cell(fit.designs, str(fit.designs)))
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


def _number(value: float) -> Cell:
    return Cell(value, written(value, 3))


# ----------------------------------------------------------------------------------------------------------------------
# Enumerated architectures as a table: what each is, with which numbers, what it weighs, and what it lacks.
# ----------------------------------------------------------------------------------------------------------------------


SHOWN_ARCHITECTURES = 24
"""Rows on the screen and on the page [-]."""
_ARCHITECTURE_NOTE = (
    "Each with the ratios, and the speed of its motor, with which it weighs least as a first sizing, of as many planets"
    " as stand beside each other, five at most; those not far from the lightest then against fatigue for the life, with"
    " everything in their mass but bearings of shafts, and the lightest of these with numbers chosen anew by that mass"
    " and what they lack, and then with those bearings. In the order in which they are looked at further: by mass, and"
    " by the load that what fails lacks, which closing may bring or not; those with all their bearings first."
)
_ARCHITECTURE_COLUMNS = (
    "architecture", "ratios", "motor_speed", "first_mass", "complete_mass", "motor_mass", "inverter_mass",
    "cooling_mass", "with_machines", "bearings", "lacks",
)  # fmt: skip


@dataclass(frozen=True)
class ArchitectureRow:
    """One of them, as tables and machines have it."""

    architecture: str
    """In words."""
    ratios: str
    """Of its stages, from the engine on."""
    motor_speed: Speed | None
    """[rad/s]"""
    first_mass: Mass | None
    """Of gears, shafts and carriers as a first sizing, with its motor [kg]."""
    complete_mass: Mass | None
    """[kg]"""
    motor_mass: Mass | None
    """Of the motor by itself [kg]."""
    inverter_mass: Mass | None
    """[kg]"""
    cooling_mass: Mass | None
    """Of motor and inverter [kg]."""
    with_machines: Mass | None
    """[kg]"""
    bearings: str
    """Whether bearings of shafts are in the complete mass, and why not; empty where it is not known."""
    lacks: str
    """What fails worst, with its margin, or why it is refused."""


def rows_of(candidates: Iterable[Candidate]) -> Iterator[ArchitectureRow]:
    """Yield the row of each.

    Args:
        candidates: In their order.
    """
    for row in candidates:
        yield ArchitectureRow(
            row.architecture.name,
            " · ".join(f"{ratio:.2f}" for ratio in row.ratios),
            row.motor_speed,
            row.first_mass,
            row.complete_mass,
            row.motor_mass,
            row.inverter_mass,
            row.cooling_mass,
            row.with_machines,
            "" if row.complete_mass is None else "no" if row.bare is None else row.bare or "yes",
            row.refused or _lacked(row),
        )


def _lacked(row: Candidate) -> str:
    """Return the worst of what fails, and how much more there is."""
    if not row.lacks:
        return ""
    name, margin = smallest(row.lacks, lambda lack: lack[1])
    more = f" and {len(row.lacks) - 1} more" if len(row.lacks) > 1 else ""
    return f"{name} {margin_text(margin)}{more}"


def architectures_table(candidates: Iterable[Candidate], title: str) -> Table:
    """Return the table.

    Args:
        candidates: In their order.
        title: In words.
    """
    rows = list(rows_of(candidates))
    counted = any(row.inverter_mass or row.cooling_mass for row in rows)
    columns = [name for name in _ARCHITECTURE_COLUMNS if counted or name not in BESIDE_MOTORS]
    return table(title, rows, columns, note=_ARCHITECTURE_NOTE)


def architectures_csv(candidates: Iterable[Candidate]) -> str:
    """Return all of them as CSV, in the units of the screen.

    Args:
        candidates: In their order.
    """
    return table_csv(architectures_table(candidates, ""))


# ----------------------------------------------------------------------------------------------------------------------
# Architectures at equal life as tables: what each weighs with everything in it, how long it lives, what it does not
# meet, and of what its mass is.
# ----------------------------------------------------------------------------------------------------------------------


_EQUAL_LIFE_COLUMNS = (
    "design", "variant", "verdict", "complete_mass", "lightest", "heaviest", "motors", "inverters", "cooling",
    "machines", "with_machines",
    "shortest_life",
    "limits", "without_bearings", "fails",
)  # fmt: skip
ALIKE = 1.1
"""Largest over smallest of the statistics' limits up to which designs are of one requirement [-]: teeth give speeds
only nearly."""
_NOTE = (
    "Complete mass, bearings of all shafts included, with its band of 68 %, machines beside it; those that pass come"
    " first, the lightest with its machines at the top. Verdict: that of an independent review of the written design;"
    " what fails stands with its best margin, and the nearest variant that closes has a row of its own. Shortest life:"
    " of the gear (at the asked safeties) or bearing that ends first; a dash where none ends before 1e6 h, and then"
    " what is nearest to its limit. Electric machines weigh as public ones of their torque and speed do, unless"
    " a design gives their mass."
)
_GROUPS = make_dataclass("_Groups", [("design", str), *((name, Mass) for name in GROUPS), ("total", Mass)], frozen=True)

_KINDS = get_type_hints(Measures, include_extras=True)
_MEASURES = make_dataclass(
    "_Measures",
    [("design", str), ("with_machines", Mass | None), *((one.name, _KINDS[one.name]) for one in fields(Measures)),
     ("outdone", str)],
    frozen=True,
)  # fmt: skip
_MEASURES_NOTE = (
    "Frontal diameter: of the smallest circle that holds the housing as seen along the first shaft, flanges left out;"
    " its area; offset: of the axis of what is driven most from that of what drives most. Efficiency: of all cases by"
    " their shares of the life; heat: of the hottest. System life: of all bearings of shafts together. Outdone: another"
    " that passes is no heavier, wider, longer or hotter, and less of one of these. A wider nacelle costs drag: mass"
    " alone does not rank diameters that differ by more than 15 %. Cost, noise and fuel are not in it."
)


def equal_life_table(rows: Sequence[EqualLife], title: str) -> Table:
    """Return the table.

    Args:
        rows: In their order.
        title: In words.
    """
    counted = any(row.inverters or row.cooling for row in rows)
    columns = [name for name in _EQUAL_LIFE_COLUMNS if counted or name not in ("motors", "inverters", "cooling")]
    return table(title, rows, columns, note=f"{_NOTE}{_beside(rows)}")


def measures_table(rows: Sequence[EqualLife]) -> Table:
    """Return what tells designs apart besides their mass: room, parts, heat, and which of them another outdoes.

    Args:
        rows: In their order.
    """
    lines = [
        _MEASURES(row.title, row.with_machines, *astuple(row.measures), "by another" if beaten else "")
        for row, beaten in zip(rows, outdone(rows), strict=True)
        if row.measures is not None
    ]
    bounded = any(line.fits < 1.0 for line in lines)
    columns = [field.name for field in fields(_MEASURES) if bounded or field.name != "fits"]
    return table("More than mass", lines, columns, note=_MEASURES_NOTE)


def group_table(masses: Mapping[str, CompleteMass]) -> Table:
    """Return the groups of parts of every design.

    Args:
        masses: Design -> its complete mass.
    """
    rows: list[Any] = [
        _GROUPS(name, *(mass.of(group) for group in GROUPS), mass.total) for name, mass in masses.items()
    ]
    return table("Complete masses by groups of parts", rows, tuple(field.name for field in fields(_GROUPS)))


def equal_life_csv(rows: Sequence[EqualLife]) -> str:
    """Return the table as CSV, in the units that it shows.

    Args:
        rows: In their order.
    """
    return table_csv(equal_life_table(rows, ""))


def _beside(rows: Sequence[EqualLife]) -> str:
    """Return what real gearboxes weigh and whose band does not meet theirs; for designs of about one requirement."""
    known = {row.title: (row, *_band(row.statistics)) for row in rows if row.statistics and row.statistics.mass}
    if not known or max(high for _, _, high in known.values()) > ALIKE * min(high for _, _, high in known.values()):
        return ""
    ends = [min(low for _, low, _ in known.values()), max(high for _, _, high in known.values())]
    lighter = [name for name, (row, low, _) in known.items() if (row.heaviest or 0.0) < low]
    heavier = [name for name, (row, _, high) in known.items() if (row.lightest or 0.0) > high]
    span = " to ".join(text(mass, "mass", 3) for mass in ends)
    said = f" 61 real gearboxes of this power and these speeds: 68 % from {span}."
    said += f" Lighter, bands apart: {', '.join(lighter)}." if lighter else ""
    said += f" Heavier, bands apart: {', '.join(heavier)}." if heavier else ""
    return said if lighter or heavier else f"{said} All bands meet it."


def _band(known: Statistics) -> tuple[float, float]:
    return known.low or 0.0, known.high or 0.0
