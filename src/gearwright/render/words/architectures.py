"""What an enumeration of architectures comes to, in sentences."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.enumeration import Ranking, lighter
from gearwright.study import EqualLife
from gearwright.units import text


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
    if not passing:
        looked = f"of {len(ranking.closed)} that were closed" if ranking.closed else "as none was closed"
        yield f"None is known to meet everything for {text(ranking.life, 'life', 3)}, {looked}."
        return
    best = passing[0]
    yield lightest_sentence(ranking)
    if len(passing) > 1:
        yield f"The next, {ranking.called(passing[1])}, {_behind(best, passing[1])}"
    others = [row for row in ranking.beside if row is not best and row is not passing[min(1, len(passing) - 1)]]
    if others:
        yield f"The lightest of those compared with it, {ranking.called(others[0])}, {_behind(best, others[0])}"


def lightest_sentence(ranking: Ranking) -> str:
    """Return which is the lightest, with its band.

    Args:
        ranking: Of which one passes.
    """
    best = ranking.passing[0]
    life = text(ranking.life, "life", 3)
    return f"The lightest that passes its review for {life}: {ranking.called(best)}, {_weighs(best)}."


def _behind(best: EqualLife, other: EqualLife) -> str:
    """Say by how much another gearbox is heavier, and how sure that is."""
    ahead = (other.with_machines or 0.0) - (best.with_machines or 0.0)
    most = (best.heaviest or 0.0) + (best.machines or 0.0)
    within = "within" if (other.with_machines or 0.0) <= most else "beyond"
    alike, apart = (f"{min(100.0 * lighter(best, other, apart=one), 99.9):.3g} %" for one in (False, True))
    return (
        f"is {text(ahead, 'mass', 3)} heavier, {within} the band of the first; the first is lighter with"
        f" a probability of {alike} if the rules of mass err of both alike, part by part, and of {apart} if they err of"
        " each by itself."
    )


def _weighs(row: EqualLife) -> str:
    band = ""
    if row.lightest is not None and row.heaviest is not None:
        band = f" ({text(row.lightest, 'mass', 3)} to {text(row.heaviest, 'mass', 3)})"
    beside = f" and machines of {text(row.machines, 'mass', 3)}" if row.machines else ""
    return f"{text(row.complete_mass or 0.0, 'mass', 3)}{band}{beside}"
