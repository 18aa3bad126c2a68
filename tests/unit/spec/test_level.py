"""How far a design is worked out: stated in its file, or implied by what stands in it."""

import pytest

from designs import HYBRID, PAIR, changed, problem, problems
from gearwright.particulars import particulars
from gearwright.render.answers.design import check_answer, size_answer
from gearwright.render.pages.report import key_numbers
from gearwright.render.words.sizing import implied_text
from gearwright.shipped import shipped_design, shipped_designs, shipped_study
from gearwright.sizing import size
from gearwright.spec import at_level, design_text, edited, implied, parse, read, read_study
from mounted_designs import HELICOPTER, sized

SILENT = changed(PAIR, 'level = "concept"\n', "\n")
"""A pair whose file says nothing of its level, and nothing that would ask for one."""
SILENT_HYBRID = changed(HYBRID, 'level = "concept"\n', "\n")
STATIC = '[gears]\nrating = "lewis-hertz"\n'


def stating(text, level):
    """Return a design file that states its level."""
    return text.replace("shafts = ", f'level = "{level}"\nshafts = ', 1)


@pytest.mark.parametrize(
    ("text", "level"),
    [
        (SILENT, "preliminary"),
        (SILENT + STATIC, "concept"),
        (f"{SILENT}{STATIC.replace('gears', 'pairs.stage.gears')}", "concept"),
        (SILENT + '[gears]\nrating = "agma2001"\n', "preliminary"),
        (HELICOPTER, "built"),
    ],
)
def test_what_stands_in_a_silent_file_decides_its_level(text, level):
    sizing, stated = sized(text), sized(stating(text, level))
    assert sizing.level == stated.level == level
    assert (sizing.gears, sizing.shafts) == (stated.gears, stated.shafts)


def test_a_silent_file_is_sized_as_one_that_states_all_that_the_default_gives():
    design = parse(SILENT_HYBRID)
    taken = {
        "level": "preliminary",
        "gears.rating": "iso6336",
        "planetaries.first.planet_bearing.kind": "cylindrical",
        "planetaries.second.planet_bearing.kind": "cylindrical",
    }
    assert implied(design) == taken
    stated = edited(design, taken)
    assert implied(stated) == {}
    assert design == stated
    silent, said = size(design), size(stated)
    assert (silent.mass, silent.teeth, silent.gears) == (said.mass, said.teeth, said.gears)
    assert silent.planet_bearing_mass > 0.0
    first = size(parse(HYBRID))
    assert (first.level, first.planet_bearing_mass) == ("concept", 0.0)
    assert silent.mass != first.mass


def test_what_is_implied_is_no_entry_of_the_file_and_follows_from_changes():
    design = parse(SILENT_HYBRID)
    text = design_text(design)
    assert not [word for word in ("level", "[gears]", "planet_bearing") if word in text]
    assert parse(text) == design
    first = edited(design, {"level": "concept"})
    assert (first.gears.rating, first.planetaries["first"].planet_bearing) == ("lewis-hertz", None)
    again = at_level(first, "preliminary")
    assert (again.gears.rating, again.planetaries["first"].planet_bearing.kind) == ("iso6336", "cylindrical")
    lived = at_level(edited(design, {"service.life_h": 2000}), "concept")
    assert (lived.level, lived.gears.rating) == ("concept", "iso6336")
    static = edited(design, {"gears.rating": "lewis-hertz"})
    assert (static.level, static.planetaries["second"].planet_bearing) == ("concept", None)
    plain = edited(design, {"planetaries.first.planet_bearing.kind": "plain"})
    assert [stage.planet_bearing.kind for stage in plain.planetaries.values()] == ["plain", "cylindrical"]


def test_answers_say_once_which_level_was_taken():
    taken, stated = size(parse(SILENT)), size(parse(PAIR))
    assert implied_text(taken.design).startswith('By default level = "preliminary", gears.rating = "iso6336"; level =')
    assert implied_text(stated.design).startswith('First sizing by level = "concept", with no housing and no oil')
    assert implied_text(at_level(stated.design, "preliminary")) == 'Level = "preliminary", as stated.'
    assert implied_text(parse(HELICOPTER)).startswith('By default level = "built"; shafts with steps, bearings')
    assert implied_text(parse(stating(SILENT_HYBRID, "preliminary"))) == (
        'Level = "preliminary", as stated; by default gears.rating = "iso6336",'
        " bearings of the catalogue in planets of first, second."
    )
    assert "bearings of the catalogue in planets of first, second" in implied_text(parse(SILENT_HYBRID))
    assert implied_text(parse(SILENT + STATIC)).startswith(
        'By default level = "concept": its gears ask for lewis-hertz'
    )
    for answer in (size_answer(particulars(taken)), check_answer(taken)):
        assert answer.implied == {"level": "preliminary", "gears.rating": "iso6336"}
    assert size_answer(particulars(stated)).implied == check_answer(stated).implied == {}


def test_a_silent_file_whose_cases_say_no_duration_is_told_both_ways_out():
    cases = "[cases.one.turbine]\nrating = 1\n[cases.two.turbine]\nrating = 0.5\n"
    found = problem(SILENT + cases)
    assert found.path == "cases"
    assert "give each a duration_min or a share; no level is stated, so it is 'preliminary'" in found.message
    assert 'level = "concept"' in found.message
    assert parse(PAIR + cases).level == "concept"
    assert "concept" not in problem(stating(SILENT + cases, "preliminary")).message


def test_what_is_wrong_at_every_level_is_told_without_a_word_of_it():
    wrong = SILENT + "[gears]\nmaterial = 'butter'\n[cases.one.turbin]\nrating = 1\n"
    assert all("level" not in found.message for found in problems(wrong))


def test_a_material_without_a_class_for_fatigue_is_told_both_ways_out():
    own = """[gears]
material = "mine"
[materials.mine]
density_kg_m3 = 7800
elastic_modulus_gpa = 206
poisson_ratio = 0.3
yield_strength_mpa = 800
hardness_hv = 300
"""
    found = problem(SILENT + own)
    assert found.path == "gears.iso6336.steel"
    assert "no class of ISO 6336-5" in found.message and 'level = "concept" asks for nothing of it' in found.message


def test_rules_of_static_strength_alone_lower_no_rating():
    found = problem(SILENT + "[gears]\nbending_safety = 3\n")
    assert found.path == "gears.bending_safety"
    assert "ISO 6336 does not read it" in found.message and 'level = "concept"' in found.message


def test_a_stage_that_names_a_static_method_lowers_no_other():
    two = changed(SILENT, '"slow"]', '"slow", "last"]').replace('shaft = "slow"', 'shaft = "last"')
    more = '[pairs.more]\npinion = "slow"\nwheel = "last"\n[pairs.stage.gears]\nrating = "lewis-hertz"\n'
    design = parse(two + more)
    assert (design.level, design.rating("stage"), design.rating("more")) == ("concept", "lewis-hertz", "iso6336")
    assert edited(design, implied(design)) == design


def test_a_preliminary_level_and_a_rating_without_fatigue_contradict_each_other():
    found = problem(stating(SILENT + STATIC, "preliminary"))
    assert found.path == "pairs.stage.gears.rating"
    assert "'lewis-hertz' knows no fatigue" in found.message and 'rating = "iso6336"' in found.message


def test_a_preliminary_level_does_not_take_bearings_of_shafts():
    found = problem(stating(HELICOPTER, "preliminary"))
    assert (found.path, 'write level = "built"' in found.message) == ("level", True)


def test_a_concept_has_no_bearings_and_a_built_one_has():
    found = problem(stating(HELICOPTER, "concept"))
    assert found.path == "level"
    assert 'write level = "built"' in found.message
    found = problem(stating(SILENT, "built"))
    assert (found.path, found.line) == ("level", 3)
    assert "'built' needs [bearings]" in found.message


def test_a_level_that_there_is_not_is_told_with_those_that_there_are():
    found = problem(stating(SILENT, "final"))
    assert "'final' is not known; allowed: 'concept', 'preliminary' or 'built'" in found.message


def test_pages_and_data_say_the_level():
    stated, silent = size(parse(PAIR)), size(parse(SILENT))
    for sizing, said in ((stated, "concept"), (silent, "preliminary, by default")):
        assert ("level", said) in [(number.name, number.text) for number in key_numbers(particulars(sizing))]
        assert size_answer(particulars(sizing)).level == said.split(",")[0]


@pytest.mark.parametrize("name", [*read_study(shipped_study("architectures")).designs, "face-gear-split-torque"])
def test_what_is_replayed_states_its_level_and_its_rating(name):
    """So that neither a new default nor a new method moves what published work is held against."""
    design = read(shipped_design(name))
    assert (design.level, design.gears.rating) == ("concept", "lewis-hertz")
    assert {"level"} <= design.model_fields_set and "rating" in design.gears.model_fields_set


def test_the_reported_helicopter_states_that_it_is_built():
    assert "ec120b-as-reported" in shipped_designs()
    assert read(shipped_design("ec120b-as-reported")).level == "built"
