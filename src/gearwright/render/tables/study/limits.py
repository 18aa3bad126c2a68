"""How likely a design breaks the constraints of its study: every limit, and the likeliest failure."""

from __future__ import annotations

from gearwright.ranking import largest, largest_first
from gearwright.render.grid.table import Cell, Column, Table
from gearwright.render.tables.study.variants import heading, percent
from gearwright.spec import Study, value_at
from gearwright.study.answers import Limit
from gearwright.study.running.reliable import LimitState, Reliability
from gearwright.units import written

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
            *(_given(value) for value in (value_at(path, study.axes[path], 0.5), state.likeliest[path])),
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


def _given(value: object) -> Cell:
    return Cell(value, _text(value))


def _text(value: object) -> str:
    return f"{value:.5g}" if isinstance(value, float) else str(value)
