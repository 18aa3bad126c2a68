"""What a search found, in sentences."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.optimum import Optimum
from gearwright.render.tables.study.optimum import teeth_text
from gearwright.render.tables.study.variants import heading, percent
from gearwright.units import text


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
