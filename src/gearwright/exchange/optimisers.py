"""Searches as problems of other optimisers: pymoo moves in the unit cube, Optuna suggests values.

Both need the extra `optimisers`; whatever else asks and tells needs none of this.
"""

from typing import Any

import numpy as np

from gearwright.base import verb
from gearwright.optimum import DESIGN, Search, is_continuous
from gearwright.spec.studies import Axis, Value, axis_values


@verb
def pymoo_problem(search: Search) -> Any:
    """Return a search as a problem of pymoo: the unit cube, objectives to be made small, one constraint for each.

    A population is evaluated at once, sized together and kept in the journal; what it was is in ``search.rows``.

    Args:
        search: From ``gw.search``.
    """
    from pymoo.core.problem import Problem

    count, constraints = len(search.names), len(search.study.constraints)
    low, high = np.zeros(count), np.ones(count)
    objectives = len(search.study.objectives)
    problem = Problem(n_var=count, n_obj=objectives, n_ieq_constr=max(constraints, 1), xl=low, xu=high)

    def evaluate(places: Any, out: dict[str, Any], algorithm: object = None) -> None:
        rows = search.evaluate(search.at(places))
        search.rows += rows
        judged = search.judged(rows)
        broken = judged.broken if constraints else np.zeros((len(rows), 1))
        out["F"], out["G"] = judged.values, broken + np.where(judged.failed, 1.0, 0.0)[:, None]

    problem._evaluate = evaluate
    return problem


@verb
def suggested(search: Search, trial: object) -> dict[str, Value]:
    """Return a row of a search that a trial of Optuna suggests: lists as categories, ranges as numbers.

    Args:
        search: From ``gw.search``.
        trial: Of Optuna, from ``study.ask()`` or inside an objective.
    """
    own: Any = trial
    row: dict[str, Value] = {}
    for name in search.names:
        if name == DESIGN:
            row[name] = own.suggest_categorical(name, list(search.freedoms.designs))
        else:
            row[name] = _suggested(own, name, search.freedoms.axes[name])
    return row


def _suggested(trial: Any, path: str, axis: Axis) -> Value:
    if not is_continuous(axis):
        value: Value = trial.suggest_categorical(path, axis_values(path, axis))
        return value
    number: float = trial.suggest_float(path, float(axis.first or 0.0), float(axis.last or 0.0),
                                        log=axis.distribution == "log-uniform")  # fmt: skip
    return number
