"""Bands of frequencies at which no teeth shall pass: what the search finds beside brute force, checks, refusals."""

import math
import random

import pytest
from test_lightest_teeth import brute, chain

from designs import PAIR
from gearwright.errors import DesignError
from gearwright.sizing import size, size_many
from gearwright.spec import edited, parse, read
from gearwright.train import passes


def band(lowest: float, highest: float, *, name: str = "cabin", **given: object) -> str:
    """Return the table of a band."""
    lines = "".join(f"{key} = {value!r}\n".replace("'", '"') for key, value in given.items())
    return f"[teeth.forbidden.{name}]\nlowest_hz = {lowest}\nhighest_hz = {highest}\n{lines}"


CASES = {
    "": ((), lambda last: (1.0,)),
    "slower": (("turbine", 0.8), lambda last: (1.0, 0.8)),
    "propeller": (("propeller", 1.1), None),
}
"""What another case asks of which machine, part of its rated speed; factors of the speeds of all cases."""


def trains():
    """Yield trains with bands about the frequencies that they would have, the same every time."""
    draw = random.Random(190)
    for number in range(30):
        kinds = "".join(draw.choice("ps") for _ in range(draw.choice((1, 2, 2, 3))))
        part = draw.uniform(3.4, 4.6) if "s" in kinds else draw.uniform(1.5, 4.5)
        text = chain(kinds, part ** len(kinds), planets=3, most=draw.randint(21, 24))
        yield pytest.param(text, list(CASES)[number % 3], draw.randint(0, 10**6), id=f"{number}-{kinds}")


@pytest.mark.parametrize(("text", "other", "seed"), [*trains()])
def test_of_what_is_not_forbidden_the_lightest_is_found(text: str, other: str, seed: int):
    """Bands take what would win, again and again; cases turn faster, slower, or as another machine asks."""
    draw, asked = random.Random(seed), parse(text).propellers["propeller"].speed
    stated, factors = CASES[other]
    if stated:
        machine, part = stated
        rated = {"turbine": 6000.0, "propeller": asked * 30.0 / math.pi}[machine]
        text += "[cases.full.turbine]\npower_kw = 100\n" + f"[cases.other.{machine}]\nspeed_rpm = {part * rated}\n"
        text += "" if machine == "turbine" else "[cases.other.turbine]\n"
        text += "power_kw = 50\n"
    factors = factors or (lambda last: (1.0, 1.1 * asked / last))
    for number in range(3):
        try:
            sizing = size(parse(text))
        except DesignError:
            break
        every = [
            frequency for flow in sizing.flows.values()
            for _, frequency in passes(sizing.design, sizing.train, sizing.teeth, flow, "mesh")
        ]  # fmt: skip
        middle, harmonics = draw.choice(every), draw.choice((1, 1, 2))
        text += band(middle * 0.97 / harmonics, middle * 1.02, name=f"b{number}", harmonics=harmonics)
    design = parse(text)
    least, count = brute(design, factors)
    try:
        sizing = size(design)
    except DesignError as error:
        assert not count and any("teeth.forbidden" in problem.path for problem in error.problems)
        return
    assert all(check.ratio >= 1.0 - 1e-9 for check in sizing.checks if "mesh frequency in b" in check.mode)
    if not count:
        return  # beyond the teeth next to the exact ratio it looks at more of them
    assert sizing.gear_mass == pytest.approx(least, rel=1e-9)  # rounding of a few sums
    assert sizing.search.proven


@pytest.mark.parametrize(
    ("ends", "limit", "ratio"),
    [
        ((2000, 2150), 2150, 2100 / 2150),  # inside, the upper end is nearer: 2.4 % and 5 %
        ((2050, 2500), 2050, 2050 / 2100),  # inside, the lower end
        ((1000, 2000), 2000, 2100 / 2000),  # above
        ((2400, 2500), 2400, 2400 / 2100),  # below
        ((0, 2100), 2100, 1.0),  # at its end
    ],
)
def test_given_teeth_are_held_against_a_band_by_hand(ends, limit, ratio):
    """21 teeth at 100 turns a second mesh 2100 times."""
    sizing = size(parse(PAIR + "pinion_teeth = 21\nwheel_teeth = 63\n" + band(*ends, reason="the cabin hums")))
    (check,) = [check for check in sizing.checks if check.mode == "mesh frequency in cabin"]
    assert check.value == pytest.approx(2100.0, rel=1e-12)
    assert (check.limit, check.dimension, check.why) == (limit, "frequency", "the cabin hums")
    assert check.ratio == pytest.approx(ratio, rel=1e-12)
    assert check.fails is (ratio < 1.0) and check.reserve is None


def test_a_band_holds_in_its_cases_alone_and_not_in_static_ones():
    given = PAIR + "pinion_teeth = 21\nwheel_teeth = 63\n"
    given += "[cases.full.turbine]\npower_kw = 100\n[cases.slow.turbine]\npower_kw = 50\nspeed_rpm = 3000\n"
    given += "[cases.jam.turbine]\npower_kw = 150\nspeed_rpm = 4000\n[cases.jam]\nstatic = true\n"

    def failing(text: str) -> set[str]:
        checks = size(parse(given + text)).checks
        return {check.case for check in checks if check.mode.endswith("cabin") and check.fails}

    assert failing(band(1000, 1100)) == {"slow"}  # 21 · 50 = 1050 Hz
    assert failing(band(1000, 1100, cases=["full"])) == set()
    assert failing(band(1390, 1410)) == set()  # 21 · 66.7 = 1400 Hz in a limit load
    assert failing(band(1390, 1410, cases=["jam"])) == {"jam"}
    assert failing(band(4190, 4210)) == set()
    assert failing(band(4190, 4210, harmonics=2)) == {"full"}  # twice 2100 Hz


def test_planets_pass_as_often_as_counted():
    """Three planets of a carrier at 1500 rpm pass a tooth of a ring that stands still 75 times a second."""
    text = chain("s", 4.0) + band(70, 80, of="planet-pass")
    with pytest.raises(DesignError, match=r"planets pass at 73\.33 Hz to 76\.92 Hz") as caught:
        size(parse(text))
    assert caught.value.problems[0].path == "teeth.forbidden.cabin"
    open_count = size(parse(text.replace("planets = 3\n", "")))
    assert open_count.design.planetaries["a0"].planets_given != 3
    (check,) = [check for check in open_count.checks if check.mode == "planet pass in cabin"]
    sized = open_count.teeth
    turns = 100.0 / (1.0 + sized["a0.ring"] / sized["a0.sun"])
    assert check.value == pytest.approx(open_count.design.planetaries["a0"].planets * turns, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "path", "words"),
    [
        (band(2000, 1000), "cabin.highest_hz", "1000 Hz is not above lowest, 2000 Hz"),
        (band(1000, 1000), "cabin.highest_hz", "not above"),
        (band(-5, 1000), "cabin.lowest_hz", ""),
        (band(0, 0), "cabin.highest_hz", ""),
        (band(0, 1000, harmonics=0), "cabin.harmonics", ""),
        (band(0, 1000, cases=["cruse"]), "cabin.cases", "no case 'cruse'"),
        (band(0, 1000, cases=[]), "cabin.cases", "empty"),
        (band(0, 1000, of="planet-pass"), "cabin.of", "no planets"),
        (band(0, 1000, of="tooth"), "cabin.of", ""),
        ("[teeth.forbidden.cabin]\nlowest_hz = 0.3\n", "cabin.highest_hz", "is required"),
        (band(0, 1e6), "cabin", "takes 100% of what pairs.stage may have"),
        (band(0, 2300) + band(2200, 1e5, name="mast"), "cabin", "other bands the rest"),
        (band(0, 2300) + band(2200, 1e5, name="mast"), "mast", "other bands the rest"),
    ],
)
def test_a_band_that_cannot_be_is_refused_with_its_path(text, path, words):
    with pytest.raises(DesignError) as caught:
        size(parse(PAIR + text))
    (problem,) = [problem for problem in caught.value.problems if problem.path.endswith(f"forbidden.{path}")]
    assert words in problem.message


def test_where_whole_trains_alone_tell_what_is_forbidden_the_bands_are_named():
    """The propeller's case says how fast the turbine turns, by all teeth."""
    text = chain("pp", 9.0) + "[cases.full.turbine]\npower_kw = 100\n[cases.other.propeller]\nspeed_rpm = 700\n"
    with pytest.raises(DesignError) as caught:
        size(parse(text + "[cases.other.turbine]\npower_kw = 50\n" + band(0, 1e6, cases=["other"])))
    (problem,) = caught.value.problems
    assert problem.path == "teeth.forbidden.cabin" and "none of the" in problem.message


def test_rows_with_bands_go_together_with_the_bits_of_each_alone():
    """The band moves over the frequencies of a stage, in rows whose motor turns at other speeds."""
    design = edited(read("in-line-h2"), {})
    design = design.model_copy(
        update={"teeth": parse(PAIR + band(3000, 3600) + band(220, 226, name="p", harmonics=2)).teeth}
    )
    draw = random.Random(3)
    axes = {
        "teeth.forbidden.cabin.lowest_hz": [draw.uniform(2500, 3400) for _ in range(40)],
        "motors.electric.speed_rpm": [draw.uniform(3500, 5500) for _ in range(40)],
    }
    sizings = size_many(design, axes, results=["mass", "worst_margin"])
    assert sizings.together[sizings.sized].mean() > 0.8
    moved = 0
    for row in range(0, 40, 3):
        alone = size(edited(design, {path: values[row] for path, values in axes.items()}))
        assert sizings.columns["mass"][row] == alone.mass
        moved += alone.teeth != size(edited(alone.design, {"teeth.forbidden.cabin.lowest_hz": 3599.9})).teeth
    assert moved > 2
