"""Everything that can be wrong with a design file is told with its path, line, value, what is allowed and the fix."""

import tomllib
from itertools import combinations

import pytest

from designs import HYBRID, PAIR, changed, problem, problems
from gearwright.errors import DesignError
from gearwright.files import LARGEST_TEXT
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse, parse_mission, parse_study, read
from gearwright.units import RPM


def test_an_unknown_key_names_the_nearest_one():
    found = problem(changed(HYBRID, "planets = 3", "planetz = 3"))
    assert (found.path, found.line) == ("planetaries.first.planetz", 25)
    assert found.message == "no such field; did you mean planets?"


def test_an_unknown_key_that_resembles_none_lists_all():
    assert "allowed: " in problem(changed(HYBRID, "planets = 3", "xyz = 3")).message


@pytest.mark.parametrize("place", ["", "position_mm = 1000", "position_mm = 1250"])
def test_a_missing_place_is_one_problem_wherever_others_stand(place):
    """What stands for it while the rest is looked through stands in nobody's way."""
    front, rear = (f'[bearings.{name}]\nshaft = "fast"\nkind = "deep-groove"\n' for name in ("front", "rear"))
    found = [each for each in problems(f"{PAIR}{front}{place}\n{rear}") if ".rear." in each.path]
    assert [(each.path, each.message.partition(";")[0]) for each in found] == [
        ("bearings.rear.position_mm", "is required")
    ]


def test_a_misnamed_table_is_one_problem_not_many():
    """What refers to the machines of a misnamed table is no mistake of its own."""
    found = problem(changed(HYBRID, "[motors.electric]", "[motor.electric]"))
    assert found.path == "motor"
    assert "did you mean motors?" in found.message


def test_a_negative_power_is_refused():
    found = problem(changed(PAIR, "power_kw = 100", "power_kw = -100"))
    assert (found.path, found.line) == ("turbines.turbine.power_kw", 7)
    assert found.message == "-100 kW is not allowed; give a value from 0.0001 to 1e+06 kW"


def test_a_turbine_does_not_take_power():
    found = problem(PAIR + "[cases.brake.turbine]\npower_w = -5000\n")
    assert (found.path, found.line) == ("cases.brake.turbine.power_w", 19)
    assert "-5 kW: a turbine gives power; use 0 or more" in found.message


def test_a_motor_on_a_shaft_that_does_not_exist_is_refused():
    found = problem(changed(HYBRID, 'shaft = "middle"', 'shaft = "muddle"'))
    assert (found.path, found.line) == ("motors.electric.shaft", 11)
    assert found.message == "there is no shaft 'muddle'; did you mean middle?"


@pytest.mark.parametrize("word", ["nan", "inf", "-inf", "9" * 400])
def test_a_number_that_is_not_finite_is_refused(word):
    found = problem(changed(PAIR, "power_kw = 100", f"power_kw = {word}"))
    assert (found.path, found.line) == ("turbines.turbine.power_kw", 7)
    assert "not a finite number; give a finite number in kW" in found.message
    assert len(found.message) < 200


@pytest.mark.parametrize("value", ["true", '"100"', "1979-05-27", "[100]", "{ value = 100 }"])
def test_what_is_not_a_number_is_refused_as_a_quantity(value):
    found = problem(changed(PAIR, "power_kw = 100", f"power_kw = {value}"))
    assert found.path == "turbines.turbine.power_kw"
    assert found.message.endswith("is not a number; give a number in kW")


@pytest.mark.parametrize("value", ["true", '"3"', "3.0", "3.5", "nan"])
def test_a_count_is_a_whole_number(value):
    found = problem(changed(HYBRID, "planets = 3", f"planets = {value}"))
    assert (found.path, found.line) == ("planetaries.first.planets", 25)
    assert found.message.endswith("is not allowed; give a whole number")


@pytest.mark.parametrize(("key", "value"), [("module_m", 4), ("module_mm", 100.1), ("outer_module_m", 4)])
def test_a_module_is_no_larger_than_twice_the_largest_of_iso_54(key, value):
    """50 mm; 4 that are meant in mm would else be a gearbox of a million tons."""
    found = problem(f"{PAIR}{key} = {value}\n")
    assert found.path == f"pairs.stage.{key}" and found.message.startswith(f"{value} {key.rsplit('_', 1)[1]} is not")
    parse(f"{PAIR}module_mm = 100\n")


def test_a_count_has_bounds():
    found = problem(changed(HYBRID, "planets = 3", "planets = 0"))
    assert found.message == "0 is not allowed; give a value from 1 to 12"


def test_a_choice_lists_what_may_be_chosen():
    found = problem(PAIR + "halves = 3\n")
    assert (found.path, found.message) == ("pairs.stage.halves", "3 is not known; allowed: 1 or 2")


def test_a_text_is_in_quotes():
    found = problem(changed(PAIR, 'name = "one pair"', "name = 5"))
    assert (found.path, found.message) == ("name", "5 is not allowed; give a text in quotes")


def test_a_required_key_is_missed_with_its_units():
    found = problem(changed(PAIR, "power_kw = 100\n", ""))
    assert found.path == "turbines.turbine.power_kw"
    assert found.message == "is required; write power_kw or power_w or power_mw or power_hp"


def test_a_required_text_is_missed_with_an_example():
    found = problem(changed(PAIR, 'name = "one pair"\n', ""))
    assert (found.path, found.message) == ("name", 'is required; write name = "…", a text in quotes')


def test_a_row_that_is_no_table_is_refused():
    found = problem(changed(PAIR, "[turbines.turbine]", "[[turbines.turbine]]"))
    assert found.path == "turbines.turbine"
    assert "is not a table; write [turbines.turbine] and its fields below" in found.message


def test_a_table_that_is_a_number_is_refused():
    found = problem("pairs = 5\n" + PAIR.split("[pairs.stage]")[0])
    assert (found.path, found.line) == ("pairs", 1)
    assert "write [pairs.NAME]" in found.message


def test_all_problems_come_at_once_in_the_order_of_the_file():
    """Values, keys and references together, each with its line."""
    text = changed(HYBRID, "power_kw = 1046", "power_kw = -1046")
    text = changed(text, 'shaft = "middle"', 'shaft = "muddle"')
    text = changed(text, "blades = 6", "blades = true")
    text = changed(text, 'ring = "ground"', 'ring = "grund"')
    text = changed(text, "planets = 5", "planetz = 5")
    text = changed(text, "[cases.cruise.electric]", "[cases.cruise.electrik]")
    found = problems(text)
    assert [(each.path, each.line) for each in found] == [
        ("turbines.turbine.power_kw", 7),
        ("motors.electric.shaft", 11),
        ("propellers.propeller.blades", 19),
        ("planetaries.first.ring", 23),
        ("planetaries.second.planetz", 31),
        ("cases.cruise.electrik", 35),
    ]
    with pytest.raises(DesignError) as caught:
        parse(text, source="design.toml")
    assert str(caught.value).startswith("design.toml: 6 problems\n  line 7: turbines.turbine.power_kw: -1046 kW")


@pytest.mark.parametrize("text", ["", "   \n\t\n"])
def test_an_empty_file_says_where_to_start(text):
    found = problem(text)
    assert "the file is empty; `gearwright new` writes" in found.message


@pytest.mark.parametrize(
    "text", ["hello world", "[a", 'name = "unclosed', "a = 1\na = 2", "a = " + "[" * 5000, "a = " + "9" * 5000]
)
def test_what_is_not_toml_is_told_with_its_reason(text):
    found = problem(text)
    assert found.path == ""
    assert found.message.startswith("this is not TOML: ")
    assert found.message.endswith("a line reads  key = value  or  [table]")


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("name = 1\n\n[a\n", 3),
        ('name = 1\ntitle = "unclosed\n', 2),
        ("name = 1\nschema = 1\nschema = = 2\n", 3),
        ('name = """never\nclosed', 2),
    ],
)
@pytest.mark.parametrize("reader", [parse, parse_mission, parse_study])
def test_what_is_not_toml_is_told_with_its_line(reader, text, line):
    with pytest.raises(DesignError) as caught:
        reader(text)
    assert [found.line for found in caught.value.problems] == [line]


@pytest.mark.parametrize(
    "text",
    [
        "x = 1\n" + "a." * 20_000 + "b = 1",
        "x = 1\n[" + "a." * 20_000 + "b]",
        'x = 1\ny = {"a".' + "'b' . " * 20_000 + "c = 1}",
        "x = 1\n" + "".join("a." * 8 + f"b{k} = 1\n" for k in range(2_000)),
    ],
)
@pytest.mark.parametrize("reader", [parse, parse_mission, parse_study])
def test_a_key_of_more_names_than_any_has_is_refused_before_it_is_read(monkeypatch, reader, text):
    """TOML's reader takes time with the square of the names of a key."""
    monkeypatch.setattr(tomllib, "loads", lambda _: pytest.fail("it is read"))
    with pytest.raises(DesignError, match="has more than 8 names") as caught:
        reader(text)
    assert [found.line for found in caught.value.problems] == [2]


@pytest.mark.parametrize("entry", ["k{k} = 1\n", "[motors.m{k}]\n", "[[rows]]\na = 1\n", "[a.b{k}]\n", "a.b{k} = 1\n"])
def test_more_entries_than_any_file_has_are_refused_by_their_number(entry):
    found = problem("".join(entry.format(k=k) for k in range(6_000)))
    assert "tables and entries; 5,000 are allowed" in found.message


def test_points_in_texts_and_comments_are_no_names():
    words = ".".join("abcdefghijklmnopqrstuvwxyz")
    text = f'# {words}\nname = "{words}"\ndescription = """\n{words} \\" {words}\n"""\nx = \'{words}\'\n'
    assert not [found for found in problems(text) if "names with points" in found.message]


def test_what_many_tables_lack_is_named_for_each():
    text = "".join(f"[motors.m{k}]\n" for k in range(1, 12))
    lacking = {found.path for found in problems(text) if found.path.startswith("motors.")}
    assert lacking >= {f"motors.m{k}.power_kw" for k in range(1, 12)}


@pytest.mark.parametrize("reader", [parse_mission, parse_study])
@pytest.mark.parametrize("text", ["[a", "a = " + "[" * 5000, "a = " + "9" * 5000])
def test_missions_and_studies_are_told_alike(reader, text):
    with pytest.raises(DesignError, match="this is not TOML: "):
        reader(text)


@pytest.mark.parametrize("text", ['"" = 3', '[""]\na = 1', "a." * 7 + "b = 1", "overrides." + "a." * 6 + "b = 1"])
def test_odd_but_legal_toml_is_refused_by_name(text):
    """These need a name and shafts at the least."""
    assert {"name", "shafts"} <= {each.path for each in problems(text)}


def test_a_folder_is_not_a_file(tmp_path):
    with pytest.raises(DesignError, match=r"this is a folder; name a file in it") as caught:
        read(tmp_path)
    assert caught.value.source == str(tmp_path)


def test_a_missing_file_says_where_to_start(tmp_path):
    with pytest.raises(DesignError, match=r"there is no such file; `gearwright new` lists"):
        read(tmp_path / "none.toml")


def test_a_file_of_ten_megabytes_is_not_read(tmp_path):
    path = tmp_path / "big.toml"
    path.write_bytes(b"#" * 10_000_000)
    with pytest.raises(DesignError, match=f"more than {LARGEST_TEXT:,} bytes"):
        read(path)


def test_a_file_of_bytes_is_not_a_design(tmp_path):
    path = tmp_path / "design.toml"
    path.write_bytes(b"\xff\xfe\x00name")
    with pytest.raises(DesignError, match="not a text file in UTF-8"):
        read(path)


def test_a_windows_file_is_read(tmp_path):
    path = tmp_path / "design.toml"
    path.write_bytes(b"\xef\xbb\xbf" + PAIR.replace("\n", "\r\n").encode())
    assert read(path) == parse(PAIR)


def test_a_helix_too_flat_for_its_overlap_is_refused():
    """b/m_n = ε_β π / sin β: 1.15 π / 60 is sin 3.452°."""
    found = problem(PAIR + "[gears]\nhelix_angle_deg = 0.001\n")
    assert (found.path, found.line) == ("gears.helix_angle_deg", 19)
    assert "wider than 60 modules for the overlap ratio 1.15; use 0, 3.452 ° or more" in found.message
    parse(PAIR + "[gears]\nhelix_angle_deg = 0.001\nface_width_ratio = 10\n")


def test_names_must_be_names():
    for name in ("", " ", "a.b", "a\\nb"):
        text = changed(PAIR, '"slow"]', f'"slow", "{name}"]')
        assert any("cannot be a name" in each.message for each in problems(text)), name
    assert "cannot be a name" in problem(changed(PAIR, "[pairs.stage]", '[pairs."a.b"]')).message
    assert "is the frame and stands still" in problems(changed(PAIR, '"slow"]', '"slow", "ground"]'))[0].message


def test_a_shaft_stands_once_and_carries_something():
    assert "stands twice" in problem(changed(PAIR, '"slow"]', '"slow", "slow"]')).message
    found = problem(changed(PAIR, '"slow"]', '"slow", "spare"]'))
    assert (found.path, found.line) == ("shafts", 3)
    assert "'spare' carries nothing; remove it" in found.message


def test_two_machines_have_two_names():
    text = PAIR + '[motors.turbine]\nshaft = "fast"\npower_kw = 5\nspeed_rpm = 6000\n'
    found = problem(text)
    assert (found.path, found.line) == ("motors.turbine", 18)
    assert found.message.startswith("turbines.turbine is called 'turbine' already")


STAGED = """
schema = 1
name = "names"
level = "concept"
shafts = ["in", "mid", "sun", "out"]
turbines.{turbine} = {{ shaft = "in", power_kw = 300, speed_rpm = 6000 }}
rotors.{rotor} = {{ shaft = "out", speed_rpm = 600, diameter_m = 10, blades = 4 }}
accessories.{accessory} = {{ shaft = "mid", power_kw = 5 }}
pairs.{pair} = {{ pinion = "in", wheel = "mid", pinion_teeth = 25, wheel_teeth = 50 }}
clutches.{clutch} = {{ driving = "mid", driven = "sun" }}
planetaries.{set} = {{ sun = "sun", ring = "ground", carrier = "out", planets = 3, sun_teeth = 24, planet_teeth = 36 }}
"""
PARTS = {
    "turbine": "turbines", "rotor": "rotors", "accessory": "accessories", "pair": "pairs", "set": "planetaries",
    "clutch": "clutches",
}  # fmt: skip


@pytest.mark.parametrize(("one", "other"), list(combinations(PARTS, 2)))
def test_parts_that_lie_along_shafts_by_their_names_have_names_of_their_own(one, other):
    """Machines, stages and clutches of one name met in places along a shaft: both are told, and where the second is."""
    names = {part: f"the-{part}" for part in PARTS}
    text = STAGED.format(**names | {one: "same", other: "same"})
    found = problem(text)
    paths = {f"{PARTS[part]}.same" for part in (one, other)}
    assert found.path in paths
    first = (paths - {found.path}).pop()
    assert found.message.startswith(f"{first} is called 'same' already")
    assert found.line == 1 + next(k for k, line in enumerate(text.splitlines()) if line.startswith(found.path))


def test_a_bearing_and_a_machine_have_names_of_their_own():
    """A bearing called as the engine beside it took its joint, and weighed 0.5 % more."""
    text = shipped_design("ec120b").read_text(encoding="utf-8")
    found = problem(text.replace("[bearings.input-axial]", "[bearings.arrius-2f]"))
    assert found.path == "bearings.arrius-2f"
    assert found.message.startswith("turbines.arrius-2f is called 'arrius-2f' already")


def test_a_stage_may_be_called_as_a_shaft_is():
    names = {part: f"the-{part}" for part in PARTS}
    assert parse(STAGED.format(**names | {"pair": "in", "clutch": "sun"})).pairs.keys() == {"in"}


def test_two_machines_that_fight_over_one_speed_are_named():
    text = PAIR + '[motors.helper]\nshaft = "fast"\npower_kw = 5\nspeed_rpm = 4000\n'
    found = problem(text)
    assert (found.path, found.line) == ("motors.helper.speed_rpm", 21)
    assert "4000 rpm on shaft 'fast', where turbine turns at 6000 rpm" in found.message


def test_machines_on_one_shaft_may_agree_within_the_tolerance():
    """By 5 %; the shaft then turns as the first of them says."""
    design = parse(PAIR + '[motors.helper]\nshaft = "fast"\npower_kw = 5\nspeed_rpm = 6200\n')
    assert design.motors["helper"].speed == pytest.approx(6200 * RPM)
    assert abs(size(design).flows["rated"].speeds["fast"]) == pytest.approx(6000 * RPM, rel=1e-9)


def test_a_train_has_machines_and_a_taker():
    bare = 'schema = 1\nname = "bare"\nlevel = "concept"\nshafts = ["one"]\n'
    assert any("no machine drives or loads this train" in each.message for each in problems(bare))
    text = changed(PAIR, PAIR[PAIR.index("[propellers") : PAIR.index("[pairs")], "")
    assert "nothing takes the power; add a table" in problem(text).message


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ('wheel = []', "at least one shaft"),
        ('wheel = ["slow", "slow"]', "a list names different shafts"),
        ('wheel = "fast"', "pinion and wheel turn on two shafts"),
        ('wheel = "ground"', "there is no shaft 'ground'"),
        ('wheel = "other.wheel"', "there is no gear 'other.wheel' in another pair"),
        ('wheel = "slow"\nshare = [0.5, 0.5]', "does not share the load of 1 meshes"),
    ],
)  # fmt: skip
def test_a_pair_joins_two_shafts(change, words):
    assert any(words in each.message for each in problems(changed(PAIR, 'wheel = "slow"', change)))


def test_shares_are_positive():
    text = changed(changed(PAIR, '"slow"]', '"slow", "other"]'), 'wheel = "slow"', 'wheel = ["slow", "other"]')
    parse(text + "share = [0.4, 0.6]\n")
    found = problem(text + "share = [-1.0, 2.0]\n")
    assert found.path == "pairs.stage.share"
    assert "give as many positive numbers, sum 1" in found.message


def test_members_of_a_planetary_set_are_three_shafts():
    found = problem(changed(HYBRID, 'sun = "input"', 'sun = "ground"'))
    assert found.path == "planetaries.first.ring"
    assert "'ground' is the sun already" in found.message


def test_ring_teeth_close_the_set():
    text = changed(HYBRID, "planets = 3", "planets = 3\nsun_teeth = 30\nplanet_teeth = 30\nring_teeth = 91")
    found = problem(text)
    assert (found.path, found.line) == ("planetaries.first.ring_teeth", 28)
    assert found.message.startswith("91 does not close without profile shift: z_s + 2 z_p = 30 + 2·30 = 90")


def test_a_clutch_joins_two_shafts():
    text = PAIR + '[clutches.sprag]\ndriving = "fast"\ndriven = "fast"\n'
    found = problem(text)
    assert (found.path, found.line) == ("clutches.sprag.driven", 20)


def test_a_bore_is_thinner_than_its_shaft():
    found = problem(PAIR + "[layout.fast]\nbore_mm = 30\ndiameter_mm = 20\n")
    assert (found.path, found.line) == ("layout.fast.bore_mm", 19)
    assert found.message == "the bore 30 mm leaves no wall in a shaft of 20 mm"


def test_a_bore_is_given_once():
    assert "are both given; keep one" in problem(PAIR + "[layout.fast]\nbore_mm = 3\nbore_ratio = 0.3\n").message


def test_a_material_without_the_needed_property_is_refused():
    found = problem(PAIR + '[gears]\nmaterial = "structural-steel"\n')
    assert (found.path, found.line) == ("gears.material", 19)
    assert "'structural-steel' has no surface_hardness, which rating 'lewis-hertz' needs; use one of" in found.message


def test_an_unknown_material_is_refused_where_it_stands():
    found = problem(PAIR + '[pairs.stage.gears]\nmaterial = "carburized-9310"\n')
    assert (found.path, found.line) == ("pairs.stage.gears.material", 19)
    assert "did you mean carburised-9310?" in found.message


def test_the_limits_of_the_search_are_in_order():
    assert problem(PAIR + "[teeth]\nsun_minimum = 40\nsun_maximum = 20\n").path == "teeth.sun_minimum"
    assert problem(PAIR + "[teeth]\npinion_minimum = 40\npinion_maximum = 20\n").path == "teeth.pinion_minimum"


def test_the_rated_case_may_be_said_like_any_other():
    assert size(parse(PAIR + "[cases.rated.turbine]\npower_kw = 5\n")).rated_power == pytest.approx(5e3)


def test_a_case_names_machines_that_exist():
    found = problem(PAIR + "[cases.cruise.turbin]\npower_kw = 5\n")
    assert (found.path, found.line) == ("cases.cruise.turbin", 18)
    assert found.message == "there is no machine 'turbin'; did you mean turbine?"


def test_speeds_are_kept_of_machines_that_exist():
    found = problem(PAIR + '[speeds]\nkeep = ["prop"]\n')
    assert (found.path, found.line) == ("speeds.keep", 19)


@pytest.mark.parametrize("line", ['"stage.module_mm" = -3', "stage.module_mm = 0"])
def test_an_override_is_positive(line):
    found = problem(PAIR + f"[overrides]\n{line}\n")
    assert (found.path, found.line) == ("overrides.stage.module_mm", 19)
    assert "is not allowed; give a value from 0.1 to 100 mm" in found.message


def test_an_override_of_nothing_names_the_nearest():
    found = problem(PAIR + '[overrides]\n"stage.modul_mm" = 3\n')
    assert found.path == "overrides.stage.modul_mm"
    assert "nothing of this name is computed; did you mean stage.module_mm?" in found.message


def test_an_override_is_given_in_one_unit():
    found = problem(PAIR + '[overrides]\n"stage.module_mm" = 3\n"stage.module_m" = 0.003\n')
    assert found.path == "overrides.stage.module_m"
    assert "stage.module is given twice: here, and as overrides.stage.module_mm" in found.message


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("power_kw = 100", "power_kw = 2,67", "line 7: turbines.turbine.power_kw: numbers have a decimal point, not a"
         " comma; write 2.67"),
        ("[turbines.turbine]", '[pairs.stage]\npinion = "fast"\n[turbines.turbine]', "pairs.stage"),
        ("power_kw = 100", "power_kw = 100\npower_kw = 101", "turbines.turbine.power_kw: is given in line"),
        ("power_kw = 100", "power_ps = 136", "power_ps: this unit is not known: 1 PS (metric horsepower) = 0.7355 kW;"
         " write one of power_kw, power_w, power_mw, power_hp"),
    ],
)  # fmt: skip
def test_slips_of_the_hand_are_told_in_words_of_people(old, new, said):
    """Not in those of TOML's reader, and no nearest name that is another unit."""
    with pytest.raises(DesignError) as refused:
        parse(changed(PAIR, old, new))
    told = str(refused.value)
    assert said in told
    assert "did you mean" not in told
    assert "not TOML" not in told


def test_a_table_that_stands_twice_is_named_with_both_lines():
    with pytest.raises(DesignError) as refused:
        parse(f'{PAIR}\n[pairs.stage]\npinion = "fast"\n')
    assert "the table [pairs.stage] stands in line" in str(refused.value)
