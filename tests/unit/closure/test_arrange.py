"""Shafts are put into bearings: what stands on them stays, what they bear is borne, the written design is the same."""

import json
import math
from functools import cache
from importlib import import_module
from itertools import pairwise

import pytest

import gearwright as gw
from designs import PAIR
from gearwright.base import Role
from gearwright.cli import main
from gearwright.closure import Arranged
from gearwright.errors import DesignError
from gearwright.render.tables.arranged import arranged_bearings, arranged_shafts, mass_changes, unborne
from gearwright.sizing.making import built_checks
from gearwright.spec.design import BUILT, PRELIMINARY

arrange_module = import_module("gearwright.closure.arrange")
NAMES = ("in-line", "in-line-h2", "star", "off-set", "off-set-h1", "mixed-h1", "e-axle")
PASSING = tuple(name for name in NAMES if name != "off-set-h1")
"""All but one whose motor stands between the wheels of two branches, where its bearings lack 1 mm."""
STEP = 1.2
"""Masses of two sizes of a bearing next to each other, at most."""
TOUCH = 1e-6
"""Lengths that differ by less are the same [m]."""


@cache
def arranged(name: str) -> Arranged:
    return gw.arrange(gw.at_level(gw.read(name), PRELIMINARY))


@cache
def pair(**changes: float) -> Arranged:
    """Return the pair of a turbine and a propeller with other values, ``table__key``."""
    edits = {path.replace("__", "."): value for path, value in changes.items()}
    return gw.arrange(gw.edited(gw.at_level(gw.parse(PAIR), PRELIMINARY), edits))


def weight(found: Arranged) -> float:
    """Return what shafts and bearings weigh [kg]."""
    return found.masses[1].of("shafts") + found.masses[1].of("bearings")


def bearings_of(found: Arranged, shaft: str):
    return sorted((one for one in found.sizing.bearings if one.shaft == shaft), key=lambda one: one.position)


@pytest.mark.parametrize("name", PASSING)
def test_it_is_a_built_design_in_which_nothing_fails_that_did_not_before(name):
    found = arranged(name)
    assert found.design.level == BUILT
    assert found.sizing.built_shafts
    assert found.worse == ()


@pytest.mark.parametrize("name", PASSING)
def test_its_review_lacks_nothing_of_what_holds_parts_and_puts_them_together(name):
    """Speeds and lives of planets are of the design as it is given; shafts, bearings and their seats are of this."""
    failing = {check.name for check in gw.review(gw.parse(arranged(name).text)).failing}
    assert not failing & {check.name for check in built_checks(arranged(name).sizing)}


@pytest.mark.parametrize("name", NAMES)
def test_shafts_with_gears_of_pairs_have_two_radial_bearings_and_one_that_locates_each_way(name):
    found = arranged(name)
    seats = found.design.bearings.values()
    shafts = {gear.shafts[0] for gear in found.sizing.gears if gear.stage in found.design.pairs}
    for shaft in shafts:
        own = [seat for seat in seats if seat.shaft == shaft]
        assert sum(seat.radial for seat in own) == 2
        located = [seat.locates for seat in own]
        assert "both" in located or {"first", "second"} <= set(located)


@pytest.mark.parametrize("name", NAMES)
def test_bearings_stand_beside_each_other_and_beside_gears_within_their_shafts(name):
    found = arranged(name)
    widths = {gear.name: gear.face_width for gear in found.sizing.gears if gear.stage in found.design.pairs}
    for shaft in found.sizing.shafts:
        taken = [(one.position, one.width) for one in bearings_of(found, shaft.name)]
        places = found.sizing.arrangement.plans[shaft.name].places
        taken += [(place, widths[label]) for label, place in places.items() if label in widths and taken]
        row = [(0.0, 0.0), *sorted(taken), (shaft.length, 0.0)]
        for (left, wide), (right, wider) in pairwise(row):
            assert right - left >= (wide + wider) / 2.0 - TOUCH, shaft.name


@pytest.mark.parametrize("name", NAMES)
def test_gears_stand_where_they_mesh(name):
    assert all(far < TOUCH for far in arranged(name).sizing.arrangement.apart.values())


@pytest.mark.parametrize("name", NAMES)
def test_teeth_modules_and_widths_stay_and_so_do_gears_that_no_shaft_goes_through(name):
    found = arranged(name)
    for before, after in zip(found.before.gears, found.sizing.gears, strict=True):
        assert (after.name, after.teeth) == (before.name, before.teeth)
        assert (after.module, after.face_width) == pytest.approx((before.module, before.face_width), rel=1e-9)
    hollow = {gear.name for gear in found.sizing.gears if gear.role in (Role.PLANET, Role.RING)}
    before, after = ({item.part: item.total for item in mass.parts if item.part in hollow} for mass in found.masses)
    assert after == pytest.approx(before, rel=1e-6)


@pytest.mark.parametrize("name", NAMES)
def test_the_text_read_again_is_sized_alike_and_arranged_as_it_stands(name):
    found = arranged(name)
    design = gw.parse(found.text)
    again = gw.arrange(design)
    assert again.design == design
    assert again.shafts == ()
    assert [one.designation for one in again.sizing.bearings] == [one.designation for one in found.sizing.bearings]
    assert gw.complete_mass(again.sizing).total == pytest.approx(found.masses[1].total, rel=1e-9)


def test_a_set_gets_the_room_that_its_most_crowded_neighbour_lacks_once():
    """Two shafts reach 7.5 mm into the second set of Mixed-H1, and a cover 7.5 mm: 8 mm and 1 mm, not three times."""
    found, plain = arranged("mixed-h1"), arrange_module.Room()
    crowded = [check for check in found.worse if check.mode.startswith("room")]
    assert not crowded
    room = plain.with_around("second", 0.009).with_around("second", 0.004).with_around("second", 0.009)
    assert room.around == {"second": 0.009}


def test_a_round_that_is_refused_leaves_the_best_so_far(monkeypatch):
    """Room that is made for a bearing may leave another none."""
    placed, rounds = arrange_module._placed, []

    def once(*args):
        rounds.append(args)
        if len(rounds) > 1:
            raise DesignError([])
        return placed(*args)

    monkeypatch.setattr(arrange_module, "_placed", once)
    found = gw.arrange(gw.at_level(gw.read("mixed-h1"), PRELIMINARY))
    assert len(rounds) == 2 and found.worse


def test_more_life_asks_for_no_lighter_bearings():
    masses = [pair(service__bearing_life_h=hours).masses[1].of("bearings") for hours in (2e3, 1e4, 4e4, 8e4)]
    assert all(more > less / STEP for less, more in pairwise(masses))
    assert masses[-1] > masses[0]


def test_more_power_asks_for_no_lighter_shafts_and_bearings():
    weights = [weight(pair(turbines__turbine__power_kw=power)) for power in (50.0, 100.0, 150.0, 300.0)]
    assert all(more > less / STEP for less, more in pairwise(weights))
    assert weights[-1] > weights[0]


def test_every_bearing_lives_as_long_as_asked():
    for name in NAMES:
        for one in arranged(name).sizing.bearings:
            assert one.judged_life >= one.wanted_life
            assert one.static_safety >= one.wanted_static_safety


def test_bearings_that_stand_stay():
    found = pair()
    kept = {name: seat for name, seat in found.design.bearings.items() if seat.shaft == "fast"}
    partly = found.design.model_copy(update={"bearings": kept, "joints": {}})
    again = gw.arrange(partly)
    assert {name: seat for name, seat in again.design.bearings.items() if seat.shaft == "fast"} == kept
    assert [one.line.name for one in again.shafts] == ["slow"]
    assert {row.bearing: row.given for row in arranged_bearings(again) if row.given} == dict.fromkeys(kept, True)
    assert [(row.shaft, row.why) for row in unborne(again)] == [("fast", "stands in the bearings of the design")]


def test_a_sun_that_floats_is_told_with_the_reason():
    found = arranged("in-line-h2")
    assert [(row.shaft, row.why) for row in unborne(found)] == [("input", "floats between its planets")]
    spans = {row.shaft: row.span for row in arranged_shafts(found)}
    assert spans["input"] is None
    assert spans["output"] > 0.0


@pytest.mark.parametrize("name", NAMES)
def test_groups_add_up(name):
    *groups, total = mass_changes(arranged(name))
    assert total.before == pytest.approx(sum(row.before for row in groups))
    assert total.after == pytest.approx(sum(row.after for row in groups))
    assert sum(row.mass_after for row in arranged_shafts(arranged(name))) == pytest.approx(
        next(row.after for row in groups if row.group == "shafts")
    )


# ----------------------------------------------------------------------------------------------------------------------
# On the command line.
# ----------------------------------------------------------------------------------------------------------------------


@pytest.fixture
def call(monkeypatch, capsys, tmp_path):
    """Run a command in a folder of its own; gives its exit code, output and errors."""
    monkeypatch.chdir(tmp_path)

    def run(line):
        monkeypatch.setattr("sys.argv", ["gearwright", *line.split()])
        with pytest.raises(SystemExit) as ended:
            main()
        printed = capsys.readouterr()
        return ended.value.code or 0, " ".join(printed.out.split()), printed.err

    return run


def test_the_file_keeps_comments_order_and_units(call, tmp_path):
    own = PAIR.replace("diameter_m = 2\n", "diameter_m = 2  # as flown\n")
    (tmp_path / "pair.toml").write_text(own, encoding="utf-8")
    code, out, err = call("arrange pair.toml --as-sized --out built.toml")
    assert (code, err) == (0, "wrote built.toml\n")
    assert 'Taken at level "preliminary"; that of the design is "concept".' in out
    written = (tmp_path / "built.toml").read_text(encoding="utf-8")
    assert "diameter_m = 2  # as flown\n" in written
    assert written.index("[turbines.turbine]") < written.index("[propellers.propeller]") < written.index("[bearings.")
    design = gw.read(tmp_path / "built.toml")
    assert design.level == BUILT
    assert gw.complete_mass(gw.size(design)).total == pytest.approx(pair().masses[1].total, rel=1e-9)


def test_json_says_what_the_screen_says(call, tmp_path):
    (tmp_path / "pair.toml").write_text(PAIR, encoding="utf-8")
    code, out, _ = call("arrange pair.toml --as-sized --json")
    result = json.loads(out)["result"]
    assert code == 0
    assert (result["level"], result["worse"], result["failing"]) == (PRELIMINARY, [], [])
    assert {row["shaft"] for row in result["bearings"]} == {"fast", "slow"}
    assert result["complete_mass"][-1]["group"] == "sum"


def test_what_fails_ends_with_exit_code_1(call, tmp_path):
    text = PAIR.replace('wheel = "slow"\n', 'wheel = "slow"\nmodule_mm = 1\nface_width_mm = 5\n')
    (tmp_path / "pair.toml").write_text(text, encoding="utf-8")
    code, out, _ = call("arrange pair.toml")
    assert code == 1
    assert "sizing checks fail, the worst: stage" in out


@pytest.mark.parametrize(
    ("text", "line", "said"),
    [
        (PAIR, "arrange pair.toml --out none/built.toml", "there is no folder none; make it, or name another one"),
        (
            PAIR.replace("diameter_m = 2\n", "diameter_m = 2\nthrust_kn = 2000\n"),
            "arrange pair.toml --as-sized",
            "bearings.slow-",
        ),
        (PAIR.replace('level = "concept"\n', "level = 3\n"), "arrange pair.toml", "level"),
        (None, "arrange ec120b --level concept", "[bearings] stand, which build the shafts"),
    ],
)
def test_bad_input_is_told(call, tmp_path, text, line, said):
    if text is not None:
        (tmp_path / "pair.toml").write_text(text, encoding="utf-8")
    code, out, err = call(line)
    assert (code, out) == (2, "")
    assert said in err
    assert "Traceback" not in err


def test_a_shaft_for_which_there_is_no_bearing_is_named():
    with pytest.raises(DesignError) as refused:
        pair(propellers__propeller__thrust_kn=2000.0)
    assert {problem.path.split("-")[0] for problem in refused.value.problems} == {"bearings.slow"}


def test_meshes_that_balance_each_other_leave_a_bearing_no_force():
    """The input of Off-Set stands between two equal wheels."""
    between = bearings_of(arranged("off-set"), "input")
    assert [one.radial for one in between] == [0.0] * len(between)
    assert all(one.life == math.inf for one in between)
