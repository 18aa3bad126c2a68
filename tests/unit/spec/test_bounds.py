"""What no file may hold: numbers that no machine has, names that no path has, texts and lists without end."""

import pytest

from designs import HYBRID, PAIR, changed, problem, problems
from gearwright.catalogue import materials
from gearwright.errors import LONGEST_EXCERPT, MOST_SHOWN, DesignError, Problem
from gearwright.shipped import shipped_design, shipped_designs, shipped_mission
from gearwright.spec import (
    LONGEST_NAME,
    MOST_VALUES,
    Axis,
    Range,
    edited,
    is_name,
    parse,
    parse_mission,
    parse_study,
    read,
    value_at,
)
from gearwright.spec.record import Record, allowed_in

STUDY = 'schema = 1\nname = "s"\ndesigns = ["in-line-h2"]\n'
THESIS = shipped_mission("thesis").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "path", "allowed"),
    [
        (changed(PAIR, "power_kw = 100", "power_kw = 5e-324"), "turbines.turbine.power_kw", "from 0.0001 to 1e+06 kW"),
        (PAIR + "[gears]\nidler_factor = 5e-324\n", "gears.idler_factor", "from 0.1 to 1"),
        (PAIR + "[layout.slow]\ndiameter_mm = 4.94e-321\n", "layout.slow.diameter_mm", "from 0.1 to 300000 mm"),
        (PAIR + "[layout.slow]\ninertia_kg_m2 = 1e-160\n", "layout.slow.inertia_kg_m2", "0 or a value from 1e-12"),
        (changed(PAIR, "diameter_m = 2", "diameter_m = 1e-160"), "propellers.propeller.diameter_m", "from 0.0001 to"),
        (
            changed(PAIR, "diameter_m = 2", "diameter_m = 2\nthrust_n = 1e308"),
            "propellers.propeller.thrust_n",
            "1e+09 N",
        ),
        (PAIR + "backlash_mm = 1e300\n", "pairs.stage.backlash_mm", "to 10 mm"),
        (PAIR + "[shafting]\nsafety = 1e300\n", "shafting.safety", "from 1 to 1000"),
        (PAIR + '[overrides]\n"stage.module_mm" = 1e300\n', "overrides", "from -1e+15 to 1e+15"),
    ],
)
def test_a_number_that_no_machine_has_is_refused_with_what_is_allowed(text: str, path: str, allowed: str) -> None:
    found = problem(text)
    assert found.path.startswith(path)
    assert allowed in found.message


def test_a_change_is_held_to_the_same_bounds() -> None:
    with pytest.raises(DesignError, match=r"give a value from 0\.0001 to 300 m"):
        edited(parse(PAIR), {"propellers.propeller.diameter_m": 1e-160})


def test_a_change_is_refused_in_its_own_key_and_unit() -> None:
    with pytest.raises(DesignError) as refused:
        edited(parse(PAIR), {"propellers.propeller.speed_rpm": 300000.0, "pairs.stage.face_width_mm": -2.0})
    assert {problem.path: problem.message for problem in refused.value.problems} == {
        "propellers.propeller.speed_rpm": "300000.0 rpm is not allowed; give a value from 0.95493 to 190986 rpm",
        "pairs.stage.face_width_mm": "-2.0 mm is not allowed; give a value from 0.1 to 300000 mm",
    }


def test_the_bounds_refuse_nothing_that_is_shipped() -> None:
    assert all(read(shipped_design(name)).shafts for name in shipped_designs())
    assert materials()


def test_a_range_says_what_it_takes() -> None:
    assert Range(1.0, 5.0, above=True).words() == "a value above 1 and up to 5"
    assert not Range(1.0, 5.0, above=True).holds(1.0)
    assert Range(-1.0, 1.0, smallest=1e-9).holds(0.0)
    assert not Range(-1.0, 1.0, smallest=1e-9).holds(-1e-10)


@pytest.mark.parametrize("name", ["a", "gas-turbine", "input 1", "Läufer_2", "x" * LONGEST_NAME])
def test_a_name_is_letters_and_digits_with_hyphens_underscores_and_spaces(name: str) -> None:
    assert is_name(name)


@pytest.mark.parametrize(
    "name",
    ["", " ", "a ", "-a", "=a", "@a", "$\\\\frac$", "a/b", "a\\\\b", "..", "a:b", "a|b", "[b]", "a  b", "\\u001b[2J",
     "\\u202ea", "x" * (LONGEST_NAME + 1)],
)  # fmt: skip
def test_what_no_figure_file_or_table_could_show_is_no_name(name: str) -> None:
    for text in (
        changed(PAIR, '"slow"]', f'"slow", "{name}"]'),
        changed(PAIR, "[pairs.stage]", f'[pairs."{name}"]'),
        PAIR + f'[cases."{name}".turbine]\npower_kw = 5\n',
        PAIR + f'[joints."{name}"]\nkind = "key"\n',
    ):
        assert any("cannot be a name: use up to" in each.message for each in problems(text)), text
    with pytest.raises(DesignError, match="cannot be a name: use up to"):
        parse_mission(changed(THESIS, "[phases.cruise]", f'[phases."{name}"]'))


def test_the_free_name_of_a_design_may_hold_any_sign_that_can_be_printed() -> None:
    assert parse(changed(PAIR, "one pair", "=½ $\\\\frac$ [bold] <b> /")).name == "=½ $\\frac$ [bold] <b> /"
    found = problem(changed(PAIR, "one pair", "\\u001b[2Jone"))
    assert "control characters have no place in it" in found.message
    assert "\x1b" not in str(found)


def test_a_message_shows_an_excerpt_of_what_was_written() -> None:
    long = "x" * 100_000
    for text in (
        changed(PAIR, 'wheel = "slow"', f'wheel = "{long}"'),
        changed(PAIR, '"slow"]', f'"slow", "{long}"]'),
        changed(PAIR, "[pairs.stage]", f"[pairs.{long}]"),
        changed(PAIR, "one pair", long),
        PAIR + f"{long} = 1\n",
        PAIR + f'[gears]\nmaterial = "{long}"\n',
        PAIR + f"{long} = 1\n{long} = 2\n",
        PAIR + f"[{long}]\n",
    ):
        with pytest.raises(DesignError) as caught:
            parse(text)
        assert all(len(line) < 600 for line in str(caught.value).split("\n"))
        assert long[: 3 * LONGEST_EXCERPT] not in str(caught.value)


def test_a_terminal_obeys_nothing_that_a_file_says() -> None:
    for text in ('"\\u001b]0;owned\\u0007" = 1\n', '[gears]\nmaterial = "\\u001b[31mred"\n', '["\\u001b[2J"]\na = 1\n'):
        with pytest.raises(DesignError) as caught:
            parse(PAIR + text)
        assert "\x1b" not in str(caught.value)
        assert "\x07" not in str(caught.value)


def test_a_long_list_of_problems_is_cut_and_counted() -> None:
    told = str(DesignError(Problem(f"a{k}", "wrong") for k in range(MOST_SHOWN + 7)))
    assert told.count("\n") == MOST_SHOWN + 1
    assert told.startswith("57 problems")
    assert told.endswith("... and 7 more")


def test_a_list_has_an_end() -> None:
    names = ", ".join(f'"s{k}"' for k in range(1001))
    assert "1001 entries; give at most 1000" in problems(f'name = "n"\nshafts = [{names}]\n')[-1].message


@pytest.mark.parametrize("last", ["0x1" + "0" * 400, "1e300", "-1e-300"])
def test_an_end_of_an_axis_that_no_number_holds_is_refused(last: str) -> None:
    with pytest.raises(DesignError, match=r"gears\.bending_safety\.to: .*give a value from -1e\+15 to 1e\+15, 0 or"):
        parse_study(f'{STUDY}[axes]\n"gears.bending_safety" = {{from = 0, to = {last}}}\n')


def test_equal_steps_are_counted_and_not_built() -> None:
    with pytest.raises(DesignError, match=f"100,000,001 values; at most {MOST_VALUES:,} are taken: make the step"):
        value_at("a", Axis.model_validate({"from": 0, "to": 1e8, "step": 1}), 0.5)
    axis = Axis.model_validate({"from": 10, "to": 20, "step": 2})
    assert [value_at("a", axis, place) for place in (0.0, 0.5, 0.99)] == [10, 16, 20]


def test_a_step_of_a_flight_has_a_least_length() -> None:
    with pytest.raises(DesignError, match=r"3\.6e-09 s is not allowed; give a value from 0\.01 to 600 s"):
        parse_mission(changed(THESIS, "step_s = 10", "step_s = 3.6e-9"))


def test_two_machines_and_their_shafts_keep_their_names() -> None:
    assert parse(HYBRID).motors["electric"].shaft == "middle"


def test_every_field_of_every_record_knows_its_unit_and_its_range():
    """A record refuses by them; a dimension whose unit no key can name would leave its keys unreadable."""

    def kinds(record):
        return {record} | {kind for one in record.__subclasses__() for kind in kinds(one)}

    for record in kinds(Record):
        for name in record.model_fields:
            assert allowed_in(record, name) is not None
