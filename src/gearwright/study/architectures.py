"""Architectures at equal life: each closed, its shafts put into bearings, and judged by an independent review of the
design that was written; and by how much one is lighter than another."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import NormalDist

import numpy as np

from gearwright.base import Check, DesignError, Life, Mass, Problem, Ratio, Shown, margin_text, verb
from gearwright.closure import (
    Closed,
    ClosedArrangement,
    Outcome,
    Wishes,
    arranged_where_needed,
    as_compared,
    close_arranged,
    closed_as_compared,
    nearest_variant,
)
from gearwright.closure.requirements import LONGEST
from gearwright.machines.electric import PUBLIC_BAND
from gearwright.particulars import Particulars, particulars
from gearwright.reviews import Review, review
from gearwright.sizing import Sizing, size
from gearwright.sizing.mass import MassGroup, Statistics, complete_mass, statistics_beside
from gearwright.sizing.rating import MESHES
from gearwright.spec import Design, design_text, edited, parse, read
from gearwright.study.measures import FRONTAL, Measures, measures_of
from gearwright.study.running import comparison_of
from gearwright.study.tables import non_dominated

PUBLIC = "public"
"""Law of electric machines by which designs are ranked: torque and speed of public ones."""


@dataclass(frozen=True, repr=False)
class EqualLife(Shown):
    """A design closed for a life, with bearings on every shaft that needs them."""

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
    without_bearings: str = ""
    """Shafts that need bearings and find none, and why, so that these are not in the mass; empty: there are none."""
    moved: str = ""
    """What was moved with bearings in the gearbox, so that it lacks less; empty where it stands as it was closed."""
    searched: str = ""
    """Over what it was looked for with bearings in the gearbox, where that left something unmet."""
    groups: tuple[MassGroup, ...] = ()
    """Of parts, of which the complete mass is the sum."""
    motors: Mass | None = None
    """Of the machines motors, generators and accessories by themselves [kg]."""
    inverters: Mass | None = None
    """Of the machines their inverters [kg]."""
    cooling: Mass | None = None
    """Of the machines what cools them [kg]."""
    measures: Measures | None = None
    """What else tells it apart; None where it is refused."""
    starts: tuple[Mass, ...] = ()
    """With machines, of each start of the search that passes, itself among them; empty where there was one [kg]."""

    @property
    def search_error(self) -> Mass | None:
        """What independent starts let one expect of a search without end [kg]; None where fewer than two pass.

        Source: results above the optimum as exponential: θ/r with θ = (x̄ − x_1) r/(r − 1) of r starts.
        """
        count = len(self.starts)
        return (math.fsum(self.starts) / count - min(self.starts)) / (count - 1) if count > 1 else None

    @property
    def title(self) -> str:
        """Of the design, and whether it is its variant; also the name of its file."""
        name = Path(self.design).stem
        return f"{name}-variant" if self.variant else name

    @property
    def is_compared(self) -> bool:
        """Whether it passes its review, and all its bearings are in its mass."""
        return not self.fails and not self.without_bearings and self.with_machines is not None

    @property
    def order(self) -> tuple[bool, bool, float]:
        """What passes comes first, then what is weighed with all its bearings, then what is lighter."""
        return bool(self.fails), bool(self.without_bearings), self.with_machines or math.inf


@verb
def equal_life(
    designs: Mapping[str, Design] | None = None,
    *,
    wishes: Wishes | None = None,
    tell: Callable[[str], None] | None = None,
) -> tuple[EqualLife, ...]:
    """Return designs closed for one life, the lightest that meet everything first, then those that do not.

    A design that does not close has its nearest variant that does in a row of its own (`nearest_variant`). Electric
    machines weigh by one law in all of them (`with_public_motors`).

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
                rows += _rows(name, with_public_motors(design), asked, say)
        except DesignError as error:
            rows.append(_refused(name, error.problems))
    return tuple(sorted(rows, key=lambda row: row.order))


def with_public_motors(design: Design) -> Design:
    """Return a design whose electric machines weigh as public ones do, so that rivals weigh by one law.

    Args:
        design: What it gives as a mass stays.
    """
    laws = {
        f"{table}.{name}.mass_law": PUBLIC
        for table in ("motors", "generators")
        for name, machine in getattr(design, table).items()
        if machine.mass is None and machine.mass_law != PUBLIC
    }
    return edited(design, laws) if laws else design


def closed_designs(rows: Iterable[EqualLife]) -> dict[str, Particulars]:
    """Return the particulars of the designs that were closed, by title: what a page shows of each.

    Args:
        rows: In any order.
    """
    return {row.title: particulars(size(parse(row.file))) for row in rows if row.file}


def _rows(name: str, design: Design, asked: Wishes, say: Callable[[str], None] | None) -> Iterator[EqualLife]:
    """Yield a design closed with its shafts in bearings, and its nearest variant where it does not close itself."""
    closed = closed_as_compared(design, asked, say)
    yield _row(name, close_arranged(design, closed, tell=say))
    if closed.outcome is Outcome.OPEN and (variant := nearest_variant(as_compared(design), closed, tell=say).nearest):
        yield replace(_row(name, close_arranged(variant.design, variant.closed, tell=say)), variant=variant.what)


def _named(tell: Callable[[str], None], name: str) -> Callable[[str], None]:
    return lambda words: tell(f"{name}: {words}")


def _row(name: str, found: ClosedArrangement) -> EqualLife:
    """Return the row of a closed design with its shafts in bearings, judged by a review of its text alone."""
    file, sizing = found.text, found.sizing
    judged, whole = review(parse(file)), complete_mass(sizing)
    (life, limits), (low, high) = _shortest(found.closed, judged), whole.band
    return EqualLife(
        design=name,
        verdict=str(judged.verdict),
        complete_mass=whole.total,
        lightest=low,
        heaviest=high,
        machines=sizing.machines_mass,
        with_machines=whole.total + sizing.machines_mass,
        motors=sizing.motor_mass,
        inverters=sizing.inverter_mass,
        cooling=sizing.cooling_mass,
        shortest_life=life,
        limits=limits,
        fails="; ".join(map(_words, judged.failing)),
        worst=None if judged.worst is None else judged.worst.margin,
        statistics=statistics_beside(sizing, whole),
        file=file,
        without_bearings=found.without_bearings,
        moved=found.what,
        searched=", ".join(found.searched) if found.left_open or found.without_bearings else "",
        groups=whole.groups,
        measures=measures_of(sizing),
    )


def in_bearings(sizing: Sizing) -> tuple[str, Sizing, str]:
    """Return a design with bearings on all shafts that need them as a file, its sizing, and what is without and why.

    Args:
        sizing: Of the design as it is.
    """
    arranged, bare = arranged_where_needed(sizing, sizing.design)
    if arranged is None:
        return design_text(sizing.design), sizing, bare
    return arranged.text, arranged.sizing, ""


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


def outdone(rows: Sequence[EqualLife]) -> list[bool]:
    """Return which of some designs another outdoes: no heavier, wider, longer or hotter, and less of one of these.

    Args:
        rows: That are compared with each other; those without a mass are outdone by none.
    """
    places = [place for place, row in enumerate(rows) if row.is_compared and row.measures is not None]
    beaten = ~non_dominated(np.array([_costs(rows[place]) for place in places]), np.zeros(len(places)))
    found = dict(zip(places, beaten.tolist(), strict=True))
    return [found.get(place, False) for place in range(len(rows))]


def _costs(row: EqualLife) -> tuple[float, ...]:
    assert row.measures is not None
    return row.with_machines or math.inf, row.measures.frontal_diameter, row.measures.overall_length, row.measures.heat


def wider(first: EqualLife, second: EqualLife) -> float | None:
    """Return the frontal diameter of one gearbox over that of another where they differ so that it may decide [-].

    Args:
        first: Of two closed designs.
        second: The other.
    """
    if first.measures is None or second.measures is None:
        return None
    ratio = first.measures.frontal_diameter / second.measures.frontal_diameter
    return ratio if max(ratio, 1.0 / ratio) > FRONTAL else None


# ----------------------------------------------------------------------------------------------------------------------
# By how much one is lighter than another, and how well that is known.
# ----------------------------------------------------------------------------------------------------------------------


OWN = 0.06
"""Error of a gearbox's complete mass that no rule shares with another, one standard deviation over it [-], an estimate:
what differs between two gearboxes that rules weigh alike."""
MOTORS = PUBLIC_BAND - 1.0
"""Error of the law of electric machines, one standard deviation over their mass [-]."""
SEPARABLE = 0.9
"""Probability of one sign from which two masses count as separable [-]."""


@dataclass(frozen=True)
class Difference:
    """By how much one gearbox is lighter than another, with its machines: errors that both share cancel."""

    first: str
    """Title of the one."""
    second: str
    """Of the other."""
    mass: Mass
    """By which the first is lighter, as found; negative where it is heavier [kg]."""
    deviation: Mass
    """One standard deviation [kg]."""
    rules: Mass
    """Of it what rules for groups of parts leave, which err of both alike [kg]."""
    own: Mass
    """Of it what each gearbox has for itself [kg]."""
    search: Mass | None
    """Of it what the search left [kg]; None where one of both was closed once: it is not known, and not in it."""
    probability: Ratio
    """That the first is the lighter of those that fit their installation envelope, by these errors alone [-]."""
    separable: bool
    """Whether that, or the opposite, is at least `SEPARABLE`."""


def difference(first: EqualLife, second: EqualLife) -> Difference | None:
    """Return by how much one gearbox is lighter than another; None where their masses are not sums of the same.

    A rule errs by one factor for a group of parts in both, groups apart: √Σ (s_g m_g1 − s_g m_g2)². Each has an error
    of its own besides. Inverters and cooling go by power, and are alike. What the search left of each is exponential
    with mean and deviation `search_error`.

    Args:
        first: Closed, of one requirement with the other.
        second: The other.
    """
    if first.without_bearings or second.without_bearings or first.complete_mass is None or second.complete_mass is None:
        return None
    errors = [{group.group: group.deviation for group in row.groups} for row in (first, second)]
    shared = [errors[0].get(name, 0.0) - errors[1].get(name, 0.0) for name in {**errors[0], **errors[1]}]
    rules = math.hypot(*shared, MOTORS * ((first.motors or 0.0) - (second.motors or 0.0)))
    own = OWN * math.hypot(first.complete_mass, second.complete_mass)
    left = first.search_error, second.search_error
    search = None if None in left else math.hypot(*(each or 0.0 for each in left))
    mass, deviation = (
        (second.with_machines or 0.0) - (first.with_machines or 0.0),
        math.hypot(rules, own, search or 0.0),
    )
    expected = mass if search is None else mass + (left[0] or 0.0) - (left[1] or 0.0)
    ahead = NormalDist(0.0, deviation).cdf(expected)
    fits = [1.0 if row.measures is None else row.measures.fits for row in (first, second)]
    wins = fits[0] * (ahead + (1.0 - ahead) * (1.0 - fits[1])), fits[1] * (1.0 - ahead + ahead * (1.0 - fits[0]))
    return Difference(first.title, second.title, mass, deviation, rules, own, search, wins[0], max(wins) >= SEPARABLE)
