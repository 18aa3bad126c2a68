"""Levels only add: a table more in a file neither lowers how its gears are rated nor drops a check that it had."""

import contextlib
import random

import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import design_text, edited, parse, read
from gearwright.spec.design import RATINGS

LEVELS = ("concept", "preliminary", "built")
TABLES = {
    "service": "[service]\nlife_h = 2000\n",
    "bearing rules": '[bearing_rules]\nlubrication = "jet"\n',
    "shafting": "[shafting]\nsafety = 2.5\n",
    "oil": "[oil]\ntemperature_c = 90\n",
    "housing": '[housing]\nmaterial = "elektron-21"\n',
    "teeth": "[teeth]\nsized = 2\n",
    "losses": "[losses]\nefficiency = 'constant'\n",
    "dynamics": "[dynamics]\nrelative_speed = true\n",
    "static rules": "[gears]\nbending_safety = 2\n",
}
"""Tables that a design may have, whatever is in it; one that it refuses lowers nothing."""


def silent(design):
    """Return a shipped design as it would be without a level, and without a static method by name."""
    text = design_text(design)
    lines = [line for line in text.splitlines() if not line.startswith("level =")]
    lines = [line for line in lines if line not in ('rating = "lewis-hertz"',) and not line.startswith(_OF_STATIC)]
    return parse("\n".join(lines))


_OF_STATIC = ("bending_safety", "contact_safety", "idler_factor", "contact_angles")


def pairs_at_random(seed):
    """Return a chain of one to three pairs, some of them helical, between a turbine and a load."""
    draw = random.Random(seed)
    count = draw.randint(1, 3)
    names = [f"s{k}" for k in range(count + 1)]
    fast = draw.uniform(3000, 20000)
    ratios = [draw.uniform(1.5, 4.5) for _ in range(count)]
    slow = fast
    for ratio in ratios:
        slow /= ratio
    text = f'schema = 1\nname = "chain {seed}"\nshafts = {names!r}\n'.replace("'", '"')
    text += f'[turbines.t]\nshaft = "s0"\npower_kw = {draw.uniform(50, 900):.1f}\nspeed_rpm = {fast:.1f}\n'
    text += f'[loads.l]\nshaft = "{names[-1]}"\nspeed_rpm = {slow:.1f}\n'
    for k in range(count):
        text += f'[pairs.p{k}]\npinion = "s{k}"\nwheel = "s{k + 1}"\n'
    return parse(text)


def in_bearings(design):
    """Return a design with two bearings beside all that sits on each shaft, as its own sizing lays the shaft out."""
    plans = size(design).arrangement.plans
    lines, end, beside = [], 0.03, 0.1
    for name, plan in plans.items():
        low, high = min(plan.places.values()), max(plan.places.values())
        length = 1.4 * (high - low) + 2.0 * (end + beside)
        lines.append(f"[layout.{name}]\nlength_mm = {1e3 * length:.2f}\n[layout.{name}.places]")
        lines += [
            f'"{part}".position_mm = {1e3 * (1.4 * (at - low) + end + beside):.2f}' for part, at in plan.places.items()
        ]
        for which, at, kind in (("a", end, 'kind = "deep-groove"\nlocates = "both"'), ("b", length - end, "")):
            lines.append(f'[bearings.{name}-{which}]\nshaft = "{name}"\nposition_mm = {1e3 * at:.2f}\n{kind}')
    text = design_text(edited(design, {"service.bearing_life_h": 200.0}))
    return parse(text), parse(text + "\n" + "\n".join(lines))


def lowered(before, after):
    """Return what a design has lost beside another: its level, methods against fatigue, bearings of planets."""
    lost = []
    if LEVELS.index(after.level) < LEVELS.index(before.level):
        lost.append(f"{before.level} -> {after.level}")
    for stage in before.stages:
        if RATINGS[before.rating(stage)].fatigue and not RATINGS[after.rating(stage)].fatigue:
            lost.append(f"{stage}: {before.rating(stage)} -> {after.rating(stage)}")
    for name, stage in before.planetaries.items():
        if stage.planet_bearing is not None and after.planetaries[name].planet_bearing is None:
            lost.append(f"{name}: no planet bearings")
    return lost


def dropped(before, after):
    """Return checks that a sizing had and that another lacks; a gear of one piece with its shaft has no web."""
    has = {(str(check.part), check.mode) for check in after.checks}
    solid = {joint.part for joint in after.joints if joint.kind == "integral"}
    names = [(str(check.part), check.mode) for check in before.checks]
    return [name for name in names if name not in has and not (name[0] in solid and name[1].endswith("of the web"))]


@pytest.mark.parametrize("name", sorted(shipped_designs()))
def test_no_table_lowers_a_shipped_design(name):
    as_shipped = read(shipped_design(name))
    designs = [as_shipped]
    with contextlib.suppress(DesignError):  # what a preliminary sizing asks for, such as how long its cases last
        designs.append(silent(as_shipped))
    for design in designs:
        text = design_text(design)
        for table in TABLES.values():
            try:
                more = parse(f"{text}\n{table}")
            except DesignError:  # refused, or there already
                continue
            assert lowered(design, more) == []


@pytest.mark.parametrize("seed", range(6))
def test_bearings_of_shafts_take_nothing_from_a_design(seed):
    plain, built = in_bearings(pairs_at_random(seed))
    assert (plain.level, built.level) == ("preliminary", "built")
    assert lowered(plain, built) == []
    first, second = size(plain), size(built)
    assert dropped(first, second) == []
    assert len(second.checks) > len(first.checks)
    for table in ("service", "shafting", "oil"):
        try:
            more = parse(f"{design_text(plain)}\n{TABLES[table]}")
        except DesignError:
            continue
        assert dropped(first, size(more)) == []


def test_bearings_of_shafts_take_nothing_from_planetary_stages():
    design = parse(
        """
schema = 1
name = "planetary stage and a pair"
shafts = ["in", "mid", "out"]
[turbines.t]
shaft = "in"
power_kw = 300
speed_rpm = 9000
[loads.l]
shaft = "out"
speed_rpm = 900
[planetaries.set]
sun = "in"
ring = "ground"
carrier = "mid"
planets = 3
[pairs.p]
pinion = "mid"
wheel = "out"
"""
    )
    plain, built = in_bearings(design)
    assert lowered(plain, built) == []
    assert built.planetaries["set"].planet_bearing is not None
    first, second = size(plain), size(built)
    assert dropped(first, second) == []
    assert second.planet_bearing_mass > 0.0
