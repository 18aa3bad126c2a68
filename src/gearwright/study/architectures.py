"""Architectures at equal life: each closed, and judged by an independent review of the design that was written."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from gearwright.base import Check, DesignError, Life, Mass, Problem, Ratio, Shown, margin_text, verb
from gearwright.closure import Closed, Outcome, Wishes, close, nearest_variant
from gearwright.closure.requirements import LONGEST
from gearwright.particulars import Particulars, particulars
from gearwright.reviews import Review, Verdict, review
from gearwright.sizing import size
from gearwright.sizing.mass import Statistics, statistics_beside
from gearwright.sizing.rating import MESHES
from gearwright.spec import Design, design_text, parse, read
from gearwright.study.running import comparison_of


@dataclass(frozen=True, repr=False)
class EqualLife(Shown):
    """A design closed for a life."""

    design: str
    """As it was named."""
    verdict: str
    """Of the independent review; refused where it cannot be sized."""
    complete_mass: Mass | None
    """Of the whole gearbox [kg]; None where there is none."""
    lightest: Mass | None
    """End of its band of 68 % [kg]."""
    heaviest: Mass | None
    """The other end [kg]."""
    machines: Mass | None
    """Motors, generators and accessories with inverters and cooling, which are not in the complete mass [kg]."""
    with_machines: Mass | None
    """Complete mass and machines, by which designs are ranked [kg]."""
    shortest_life: Life | None
    """Of the gear or bearing that ends first, gears at the asked safeties [s]; None where none ends."""
    limits: str
    """What ends it; what comes nearest to its limit where nothing ends."""
    fails: str
    """What no freedom met, with its best margin; empty where all is met."""
    worst: Ratio | None
    """Margin of the worst check of the review [-]."""
    statistics: Statistics | None = None
    """What real gearboxes of its power and speeds weigh; None where it is refused."""
    file: str = ""
    """The closed design as TOML."""
    variant: str = ""
    """What was changed of what the design gives, as it does not close itself; empty where it is as it was named."""
    motors: Mass | None = None
    """Of the machines motors, generators and accessories by themselves [kg]."""
    inverters: Mass | None = None
    """Of the machines their inverters [kg]."""
    cooling: Mass | None = None
    """Of the machines what cools them [kg]."""

    @property
    def title(self) -> str:
        """Of the design, and whether it is its variant; also the name of its file."""
        name = Path(self.design).stem
        return f"{name}-variant" if self.variant else name


@verb
def equal_life(
    designs: Mapping[str, Design] | None = None,
    *,
    wishes: Wishes | None = None,
    tell: Callable[[str], None] | None = None,
) -> tuple[EqualLife, ...]:
    """Return designs closed for one life, the lightest that meet everything first, then those that do not.

    A design that does not close has its nearest variant that does in a row of its own (`nearest_variant`).

    Args:
        designs: Name -> design; left out: the architectures of the shipped study.
        wishes: Life and rounding; left out: each as its design says.
        tell: Called with what is being done.
    """
    chosen = {name: read(name) for name in comparison_of(None).designs} if designs is None else dict(designs)
    asked, rows = wishes or Wishes(), list[EqualLife]()
    for name, design in chosen.items():
        say = None if tell is None else _named(tell, name)
        try:
            with MESHES.sharing():
                rows += _rows(name, design, asked, say)
        except DesignError as error:
            rows.append(_refused(name, error.problems))
    return tuple(sorted(rows, key=_order))


def closed_designs(rows: Iterable[EqualLife]) -> dict[str, Particulars]:
    """Return the particulars of the designs that were closed, by title: what a page shows of each.

    Args:
        rows: In any order.
    """
    return {row.title: particulars(size(parse(row.file))) for row in rows if row.file}


def _rows(name: str, design: Design, asked: Wishes, say: Callable[[str], None] | None) -> Iterator[EqualLife]:
    """Yield a design closed, and its nearest variant where it does not close itself."""
    closed = close(design, wishes=asked, tell=say)
    yield _row(name, closed)
    if closed.outcome is Outcome.OPEN and (variant := nearest_variant(design, closed, tell=say).nearest):
        yield replace(_row(name, variant.closed), variant=variant.what)


def _named(tell: Callable[[str], None], name: str) -> Callable[[str], None]:
    return lambda words: tell(f"{name}: {words}")


def _order(row: EqualLife) -> tuple[bool, float]:
    return row.verdict not in (str(Verdict.PASSES), str(Verdict.PASSES_SO_FAR)), row.with_machines or float("inf")


def _row(name: str, closed: Closed) -> EqualLife:
    """Return the row of a closed design, judged by a review of its text alone."""
    judged = review(parse(design_text(closed.design)))
    whole, (life, limits) = closed.whole, _shortest(closed, judged)
    low, high = whole.band
    return EqualLife(
        design=name,
        verdict=str(judged.verdict),
        complete_mass=whole.total,
        lightest=low,
        heaviest=high,
        machines=closed.sizing.machines_mass,
        with_machines=whole.total + closed.sizing.machines_mass,
        motors=closed.sizing.motor_mass,
        inverters=closed.sizing.inverter_mass,
        cooling=closed.sizing.cooling_mass,
        shortest_life=life,
        limits=limits,
        fails="; ".join(map(_words, judged.failing)),
        worst=None if judged.worst is None else judged.worst.margin,
        statistics=statistics_beside(closed.sizing, whole),
        file=design_text(closed.design),
    )


def _shortest(closed: Closed, judged: Review) -> tuple[float | None, str]:
    """Return the shortest life of gears and bearings [s] and whose it is; None, and what is nearest, if all last."""
    gears = [(row.life, row.governs) for row in closed.lives]
    bearings = [(check.value, check.name) for check in judged.checks if check.dimension == "life" and check.value]
    life, limits = min([*gears, *bearings], default=(math.inf, ""))
    return (None, limits) if life >= LONGEST else (life, limits)


def _words(check: Check) -> str:
    return f"{check.name} {margin_text(check.margin or 0.0, 4)}"


def _refused(name: str, problems: tuple[Problem, ...]) -> EqualLife:
    """Return the row of a design that cannot be sized, with the reason."""
    nothing = EqualLife(name, "refused", None, None, None, None, None, None, "", "", None)
    return replace(nothing, fails="; ".join(f"{problem.path}: {problem.message}" for problem in problems))
