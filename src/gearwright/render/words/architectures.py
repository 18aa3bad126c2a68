"""What an enumeration of architectures comes to, in sentences."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.enumeration import Ranking
from gearwright.study import EqualLife
from gearwright.units import text


def ranking_sentences(ranking: Ranking) -> Iterator[str]:
    """Yield how many there are, which is the lightest and how sure that is, and what it is lighter than.

    Args:
        ranking: From `architectures`.
    """
    count, refused = len(ranking.candidates), ranking.refused
    yield f"{count} architectures can give the ratio; {refused} of them cannot be sized, each with its reason."
    passing = ranking.passing
    if not passing:
        looked = f"of {len(ranking.closed)} that were closed" if ranking.closed else "as none was closed"
        yield f"None is known to meet everything for {text(ranking.life, 'life', 3)}, {looked}."
        return
    best = passing[0]
    yield f"The lightest that passes its review for {text(ranking.life, 'life', 3)}: {best.title}, {_weighs(best)}."
    if len(passing) > 1 and ranking.confidence is not None:
        following = passing[1]
        ahead = (following.with_machines or 0.0) - (best.with_machines or 0.0)
        yield (
            f"The next, {following.title}, is {text(ahead, 'mass', 3)} heavier; by what the rules of mass do not know,"
            f" the first is lighter with a probability of {100.0 * ranking.confidence:.0f} %."
        )


def _weighs(row: EqualLife) -> str:
    beside = f" and machines of {text(row.machines, 'mass', 3)}" if row.machines else ""
    return f"{text(row.complete_mass or 0.0, 'mass', 3)}{beside}"
