"""The search for teeth against brute force: every combination of small trains, one by one, in plain loops."""

import math
import random
from itertools import pairwise

import numpy as np
import pytest

from designs import PAIR, changed
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.rating import Ask, modules, rating_of
from gearwright.sizing.teeth import choose_teeth, search, stage
from gearwright.spec import Planetary, edited, parse
from gearwright.train import build_train
from gearwright.units import RPM

RULES = "[teeth]\npinion_minimum = 18\npinion_maximum = {most}\nsun_minimum = 18\nsun_maximum = {most}\n"
WALL = 3.95
"""Wall of a ring over its module."""


def chain(kinds: str, ratio: float, *, planets: int = 3, most: int = 22, power: float = 100.0) -> str:
    """Return a train of stages in a row: p for a pair, s for a planetary set."""
    shafts = [f"s{k}" for k in range(len(kinds) + 1)]
    text = PAIR.partition("[pairs.stage]")[0].replace('["fast", "slow"]', str(shafts)).replace('"fast"', '"s0"')
    text = text.replace('shaft = "slow"\nspeed_rpm = 2000', f'shaft = "{shafts[-1]}"\nspeed_rpm = {6000 / ratio}')
    text = changed(text, "power_kw = 100", f"power_kw = {power}")
    for k, (kind, (near, far)) in enumerate(zip(kinds, pairwise(shafts), strict=True)):
        if kind == "p":
            text += f'[pairs.a{k}]\npinion = "{near}"\nwheel = "{far}"\n'
        else:
            text += f'[planetaries.a{k}]\nsun = "{near}"\nring = "ground"\ncarrier = "{far}"\nplanets = {planets}\n'
    return text + RULES.format(most=most)


def brute(design, factors=lambda speeds: ()) -> tuple[float, int]:
    """Return the least mass of gears of all combinations of a chain that no band forbids, and how many there are.

    The bands hold where all speeds are the rated ones times the factors, which may follow from the last shaft's speed.
    """
    power, first = design.turbines["turbine"].power, 6000 * RPM
    asked = design.propellers["propeller"].speed
    stages = sorted(design.simple_stages)
    part = (first / asked) ** (1.0 / len(stages))
    masses = []

    def extend(level: int, speed: float, mass: float, rates: tuple[float, ...] = ()) -> None:
        if level == len(stages):
            if not any(forbidden(design, factor * rate) for factor in factors(speed) for rate in rates):
                masses.append(mass)
            return
        last = level == len(stages) - 1
        wanted = speed / (asked if last else first / part ** (level + 1))
        for small, large, ratio in beside(design, stages[level], wanted):
            held = not last or abs(speed / ratio / asked - 1.0) <= 0.05
            if abs(ratio / wanted - 1.0) <= 0.025 and held:
                own = mass + weight(design, stages[level], small, large, power / speed)
                planetary = isinstance(design.stages[stages[level]], Planetary)
                rate = small * (speed - speed / ratio if planetary else speed) / (2.0 * math.pi)
                extend(level + 1, speed / ratio, own, (*rates, rate))

    extend(0, first, 0.0)
    return min(masses, default=math.inf), len(masses)


def forbidden(design, frequency: float) -> bool:
    """Tell whether a frequency or a multiple of it is inside a band [Hz]."""
    return any(
        band.lowest < k * frequency < band.highest
        for band in design.teeth.forbidden.values()
        for k in range(1, band.harmonics + 1)
    )


def beside(design, name: str, wanted: float):
    """Yield the teeth beside a ratio that can be put together, with what they give."""
    record, most = design.stages[name], design.teeth.pinion_maximum
    for small in range(18, most + 1):
        exact = wanted * small if not isinstance(record, Planetary) else (wanted - 2.0) / 2.0 * small
        low = math.ceil(exact * (1.0 - 1e-12)) - 1
        for large in (low, low + 1):
            if not isinstance(record, Planetary):
                if large >= 18:
                    yield small, large, large / small
                continue
            count = record.planets
            clear = (small + large) * math.sin(math.pi / count) > large + 2
            if large >= 12 and clear and (2 * small + 2 * large) % count == 0:
                yield small, large, 2.0 + 2.0 * large / small


def weight(design, name: str, small: int, large: int, torque: float) -> float:
    """Return the mass of the gears of a stage of its own [kg]."""
    record, rating = design.stages[name], rating_of(design, name)
    planetary = isinstance(record, Planetary)
    count = record.planets if planetary else 1
    ask = Ask(torque / count / small, (np.array([small]), np.array([large])), 10.0, idlers=(False, planetary))
    module = max(float(np.max(value)) for value in modules(ask, rating))
    ring = small + 2 * large
    squares = small**2 + count * large**2 + ((ring + 2 * WALL) ** 2 - ring**2 if planetary else 0.0)
    return 10.0 * module**3 * math.pi / 4.0 * rating.material.density * squares


def trains():
    """Yield fifty trains, the same every time."""
    draw = random.Random(19)
    for number in range(50):
        kinds = "".join(draw.choice("ps") for _ in range(draw.choice((1, 2, 2, 2, 3))))
        part = draw.uniform(3.4, 4.6) if "s" in kinds else draw.uniform(1.5, 4.5)
        yield pytest.param(
            chain(kinds, part ** len(kinds), planets=draw.choice((3, 4)), most=draw.randint(20, 24),
                  power=draw.uniform(5.0, 2000.0)),
            id=f"{number}-{kinds}",
        )  # fmt: skip


@pytest.mark.parametrize("text", [*trains()])
def test_no_combination_of_teeth_is_lighter_than_the_one_that_is_found(text: str):
    design = parse(text)
    least, count = brute(design)
    if not count:
        with pytest.raises(DesignError):
            size(design)
        return
    sizing = size(design)
    assert sizing.gear_mass == pytest.approx(least, rel=1e-9)  # rounding of a few sums
    assert sizing.search is not None and sizing.search.proven
    assert sizing.search.gear_mass == pytest.approx(least, rel=1e-9)
    assert sizing.search.combinations == count
    assert sizing.search.next_mass >= least * (1.0 - 1e-9)


@pytest.mark.parametrize("kinds", ["ppp", "psp", "ssp", "spp", "pps"])
def test_leaving_out_what_cannot_win_changes_nothing(kinds: str, monkeypatch: pytest.MonkeyPatch):
    """The bounds of the stages to come, tried on fronts of any size, against the same search without them."""
    design = parse(chain(kinds, 4.1 ** len(kinds), most=34))
    whole = size(design)
    monkeypatch.setattr(search, "MANY", 1)
    monkeypatch.setattr(search, "BEAM", 3)
    bounded = size(design)
    assert bounded.teeth == whole.teeth and bounded.mass == whole.mass
    assert bounded.search.proven and bounded.search.weighed != whole.search.weighed


def test_a_search_in_pieces_finds_the_same(monkeypatch: pytest.MonkeyPatch):
    design = parse(chain("ppp", 60.0))
    whole = size(design)
    monkeypatch.setattr(stage, "PARENTS", 7)
    pieces = size(design)
    assert (pieces.teeth, pieces.mass, pieces.search) == (whole.teeth, whole.mass, whole.search)


def test_where_too_many_are_left_the_search_says_that_nothing_is_proven(monkeypatch: pytest.MonkeyPatch):
    design = parse(chain("ppp", 60.0))
    whole = size(design)
    monkeypatch.setattr(search, "MOST", 4)
    cut = size(design)
    assert whole.search.proven and not cut.search.proven
    assert cut.gear_mass >= whole.gear_mass * (1.0 - 1e-9)


def test_five_open_stages_in_a_row_are_searched_to_the_end():
    """Some 10⁸ combinations, that were refused as too many to hold."""
    sizing = size(parse(chain("ppppp", 30.0, most=40)))
    assert sizing.search.proven and sizing.search.combinations > 1e6
    assert sizing.gear_mass == pytest.approx(sizing.search.gear_mass, rel=1e-9)


def twins(second: float) -> str:
    """Return two engines, each with a pair of its own, on one wheel."""
    text = 'schema = 1\nname = "twins"\nlevel = "concept"\nshafts = ["e1", "e2", "q1", "q2", "out"]\n'
    for k, power in enumerate((100.0, second), start=1):
        text += f'[turbines.t{k}]\nshaft = "e{k}"\npower_kw = {power}\nspeed_rpm = 6000\n'
        text += f'[pairs.in-{k}]\npinion = "e{k}"\nwheel = "q{k}"\n'
    text += '[pairs.combining]\npinion = ["q1", "q2"]\nwheel = "out"\n'
    return text + '[propellers.rotor]\nshaft = "out"\nspeed_rpm = 500\ndiameter_m = 2\n' + RULES.format(most=22)


def test_twins_have_the_same_teeth_and_count_once():
    """Two engines of one power: the pairs behind them are one choice; of 100 and 99 kW they are two."""
    alike, unlike = size(parse(twins(100.0))), size(parse(twins(99.0)))
    for side in ("pinion", "wheel"):
        assert alike.teeth[f"in-1.{side}"] == alike.teeth[f"in-2.{side}"]
    assert alike.search.combinations < unlike.search.combinations / 5.0
    assert alike.gear_mass == pytest.approx(unlike.gear_mass, rel=0.05)


@pytest.mark.parametrize("kinds", ["pp", "sp", "ss"])
def test_of_the_lightest_gears_that_are_sized_in_full_the_lightest_complete_gearbox_is_taken(kinds: str):
    """Shafts, carriers, housing count: as many are sized as there are combinations, each again with its teeth given."""
    design = parse(chain(kinds, 4.2 ** len(kinds), most=21))
    first, every = size(design), size(edited(design, {"teeth.sized": 1000}))
    masses = []
    for choice in choose_teeth(every.design, build_train(every.design)):
        changes = {}
        for name, record in design.stages.items():
            parts = ("sun", "planet") if isinstance(record, Planetary) else ("pinion", "wheel")
            table = "planetaries" if isinstance(record, Planetary) else "pairs"
            changes |= {f"{table}.{name}.{part}_teeth": choice.teeth[f"{name}.{part}"] for part in parts}
        masses.append(complete_mass(size(edited(design, changes))).total)
    least, second, *others = sorted(masses)
    assert others and complete_mass(every).total == pytest.approx(least, rel=1e-9)
    assert complete_mass(every).total <= complete_mass(first).total
    assert (every.search.sized, every.search.refused) == (len(masses), 0)
    assert every.search.next_sized_mass == pytest.approx(second, rel=1e-9)
    assert (first.search.sized, first.search.next_sized_mass) == (1, math.inf)
    assert f": {len(masses)} sized in full; the next complete gearbox weighs {second:.4g} kg" in repr(every)


@pytest.mark.parametrize(("kinds", "most"), [("pp", 21), ("sp", 21), ("ss", 21), ("ppp", 19)])
def test_as_many_are_sized_in_full_as_are_asked_for_and_none_that_is_heavier_goes_first(kinds: str, most: int):
    """What leaves the same to later stages is kept as often as is asked for: all are there, 7 are their first."""
    design = parse(chain(kinds, 4.2 ** len(kinds), most=most))
    train = build_train(design)
    every, some = (choose_teeth(edited(design, {"teeth.sized": count}), train) for count in (1000, 7))
    assert len(every) == min(every[0].search.combinations, 1000) > 7
    assert [choice.teeth for choice in some] == [choice.teeth for choice in every[:7]]
    assert len({tuple(choice.teeth.items()) for choice in every}) == len(every)
    assert some[0].search.next_mass == pytest.approx(every[0].search.next_mass, rel=1e-12)
    assert some[0].search.combinations == every[0].search.combinations


def with_few_teeth(most: int):
    """Return a pair of 5 kW whose pinion may have 12 teeth up, which undercut below 17, with all choices sized in full.

    Of so little power the housing is as thick as it can be cast, so that few teeth make the lightest gearbox.
    """
    text = chain("p", 4.2, most=most, power=5.0).replace("minimum = 18", "minimum = 12")
    return edited(parse(text), {"teeth.sized": 1000})


def test_the_lightest_that_passes_its_checks_is_taken_before_a_lighter_one_that_does_not():
    """Each choice again with its teeth given: the taken one is the lightest of those none of whose checks fail."""
    design = with_few_teeth(22)
    taken, masses = size(design), {True: [], False: []}
    for choice in choose_teeth(design, build_train(design)):
        given = {f"pairs.a0.{part}_teeth": choice.teeth[f"a0.{part}"] for part in ("pinion", "wheel")}
        alone = size(edited(design, given))
        masses[not any(check.fails for check in alone.checks)].append(complete_mass(alone).total)
    assert min(masses[False]) < min(masses[True])
    assert complete_mass(taken).total == pytest.approx(min(masses[True]), rel=1e-9)
    assert (taken.search.sized, taken.search.failing) == (sum(map(len, masses.values())), len(masses[False]))
    assert taken.search.next_sized_mass == pytest.approx(sorted(masses[True])[1], rel=1e-9)
    assert f"in full, {len(masses[False])} fail checks; the next" in repr(taken)


def test_where_no_choice_passes_its_checks_the_lightest_of_the_fewest_failing_is_taken_and_that_is_said():
    taken = size(with_few_teeth(15))
    assert taken.search.failing == taken.search.sized > 1
    assert complete_mass(taken).total <= taken.search.next_sized_mass
    assert "none of which passes its checks" in repr(taken)
