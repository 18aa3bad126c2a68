"""Cases that only sizes are asked of, sized together: with the bits of each alone, whatever stands beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gearwright.arrays import Bools
from gearwright.errors import GearwrightError
from gearwright.sizing import in_lanes
from gearwright.spec import MISSION_PATH, Design, Study, edited
from gearwright.study.answers import Blocks, block_of_columns, blocks_of
from gearwright.study.cases.flights import flown_together
from gearwright.study.cases.sampling import Case

LEAST = 64
"""Cases of one design below which each is sooner sized alone [-]."""
_OTHERS = ("fly", "modes", "simulate", "review")
"""Verbs that compute one case at a time."""


def goes_together(study: Study) -> bool:
    """Tell whether nothing but sizes is asked of the cases of a study.

    Args:
        study: With its results and changes.
    """
    flies = study.flies or any(path.startswith(MISSION_PATH) for path in (*study.axes, *study.changes))
    return not flies and not any(name.partition(".")[0] in _OTHERS for name in study.asked)


def evaluated(study: Study, designs: Mapping[str, Design], cases: Sequence[Case]) -> Blocks:
    """Return the rows of cases, each as `evaluate` gives it of the case alone, bit for bit.

    Args:
        study: Changes, and the results that are asked for.
        designs: Name -> design.
        cases: Any of it.
    """
    done = np.zeros(len(cases), dtype=bool)
    found = Blocks(())
    if goes_together(study) and len(cases) >= LEAST:
        places: dict[tuple[str, ...], list[int]] = {}
        for place, case in enumerate(cases):
            places.setdefault((case.design, *case.inputs), []).append(place)
        for own in places.values():
            if len(own) >= LEAST:
                blocks, sized = _together(study, designs[cases[own[0]].design], [cases[place] for place in own])
                done[np.array(own)[sized]] = True
                found = Blocks((*found.blocks, *blocks.blocks))
    alone = [cases[place] for place in np.flatnonzero(~done).tolist()]
    rest = blocks_of(zip((case.number for case in alone), flown_together(study, designs, alone), strict=True))
    return Blocks((*found.blocks, *rest.blocks))


def _together(study: Study, design: Design, cases: Sequence[Case]) -> tuple[Blocks, Bools]:
    """Return the rows of those cases that could be sized together, and which they are."""
    none = Blocks(()), np.zeros(len(cases), dtype=bool)
    columns = {path: [case.inputs[path] for case in cases] for path in cases[0].inputs}
    try:
        base = edited(design, {path: value for path, value in study.changes.items() if path not in columns})
    except GearwrightError:
        return none
    found, _ = in_lanes(base, columns, study.asked, count=len(cases))
    if not all(name in found.values for name in study.asked):
        return none
    sized = found.done.copy()
    for name in study.asked:
        sized &= ~np.isnan(found.values[name])  # a part that others have: alone it says so
    place = np.flatnonzero(sized)
    inputs = {path: [values[k] for k in place.tolist()] for path, values in columns.items()}
    results = {name: (found.values[name][place], found.dimensions[name]) for name in study.asked}
    numbers = np.array([cases[k].number for k in place.tolist()], dtype=np.int64)
    return block_of_columns(cases[0].design, numbers, inputs, results), sized
