"""Which load cases are looked at where none is named: the one that sizes, and those that fail."""

from __future__ import annotations

import math

from gearwright.sizing.result import Sizing

EQUAL = 1e-6
"""Part by which margins may differ and be equal [-]: what sizing makes just enough in two cases is so in both."""


def governing_case(sizing: Sizing) -> str:
    """Return the load case with the least margin of the sizing, the earlier in the file of equals.

    A case in which nothing turns is taken only where it does in none.

    Args:
        sizing: As sized.
    """
    turning = _turning(sizing)
    margins = dict.fromkeys(turning, math.inf)
    for check in sizing.checks:
        if check.case in margins and check.margin is not None:
            margins[check.case] = min(margins[check.case], check.margin)
    least = min(margins.values())
    return next(case for case in turning if margins[case] <= least * (1.0 + EQUAL))


def telling_cases(sizing: Sizing) -> tuple[str, ...]:
    """Return the governing case, and behind it every other one in which a check of the sizing fails.

    Args:
        sizing: As sized.
    """
    failing = {check.case for check in sizing.checks if check.fails}
    return tuple(dict.fromkeys([governing_case(sizing), *(case for case in _turning(sizing) if case in failing)]))


def _turning(sizing: Sizing) -> list[str]:
    """Return the cases in which a machine turns, in the order of the file; all where it does in none."""
    cases = list(sizing.design.cases or sizing.flows)
    turning = [case for case in cases if any(sizing.flows[case].speeds[one.shaft] for one in sizing.machines)]
    return turning or cases
