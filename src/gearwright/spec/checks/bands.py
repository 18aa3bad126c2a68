"""What can be wrong with forbidden bands of frequencies: reversed ends, cases and planets that are not there."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem, near
from gearwright.spec.design import Design, cases_of
from gearwright.units import text


def band_problems(design: Design) -> Iterator[Problem]:
    """Yield what is wrong with the bands of frequencies that teeth shall not pass at.

    Args:
        design: As typed.
    """
    for name, band in design.teeth.forbidden.items():
        path = f"teeth.forbidden.{name}"
        if band.highest <= band.lowest:
            ends = f"{text(band.highest, 'frequency')} is not above lowest, {text(band.lowest, 'frequency')}"
            yield Problem(f"{path}.highest", f"{ends}; give the upper end here, or leave the band out")
        for case in band.cases or []:
            if case not in cases_of(design):
                yield Problem(f"{path}.cases", f"there is no case {case!r}; {near(case, cases_of(design))}")
        if band.cases == []:
            yield Problem(f"{path}.cases", "is empty, so that the band holds nowhere; name a case, or leave it out")
        if band.of == "planet-pass" and not design.sets:
            yield Problem(f"{path}.of", "'planet-pass', but the design has no planets; write \"mesh\"")
