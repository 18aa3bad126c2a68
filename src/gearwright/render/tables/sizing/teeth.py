"""How the teeth of a sizing were chosen, in a sentence."""

import math

from gearwright.sizing import Sizing
from gearwright.sizing.chosen import TeethSearch
from gearwright.sizing.result import PRELIMINARY


def chosen_teeth(sizing: Sizing) -> str:
    """Return among how many combinations the teeth were chosen and what the next costs; nothing where all are given.

    Args:
        sizing: As sized.
    """
    search = sizing.search
    if search is None:
        return ""
    proof = "proven" if search.proven else "not proven: too many to hold"
    if search.sized + search.refused == 1:
        following = _next(search.gear_mass, search.next_mass)
        return f"the lightest gears of {search.combinations:,.0f} combinations ({proof}){following}"
    refused = f", {search.refused} refused" if search.refused else ""
    if sizing.level == PRELIMINARY and sizing.design.teeth.sized == 1:
        return _looked_at(search, proof)
    none, some = search.sized == search.failing, 0 < search.failing < search.sized
    failing = ", none of which passes its checks" if none else f", {search.failing} fail checks" if some else ""
    sized = f"{search.sized} sized in full{failing}{refused}{_next(sizing.mass, search.next_sized_mass)}"
    lightest = f"those with the lightest gears of {search.combinations:,.0f} combinations ({proof})"
    return f"the lightest {'that passes its checks ' if some else ''}of {lightest}: {sized}"


def _looked_at(search: TeethSearch, proof: str) -> str:
    """Return how a preliminary sizing came to its teeth."""
    fall = f", {search.failing} of them fall short" if search.failing else ""
    refused = f", {search.refused} refused" if search.refused else ""
    nearest = "nearest to what is asked of gears" if search.failing == search.sized else "the lightest gears that pass"
    lightest = f"those with the lightest gears of {search.combinations:,.0f} combinations ({proof})"
    return f"{nearest} among {lightest}: gears of {search.sized} sized{fall}{refused}"


def _next(mass: float, heavier: float) -> str:
    """Say how much heavier the next one is; nothing where there is none."""
    more = heavier / mass - 1.0
    return f"; the next is {more:.2%} heavier" if math.isfinite(more) else ""
