"""Materials of a design's own: used wherever one is named, refused where a half, a unit or a name is wrong."""

import tomllib

import pytest

from designs import PAIR, problem, problems
from gearwright.catalogue import materials
from gearwright.catalogue.tables import data_text
from gearwright.sizing import size
from gearwright.sizing.rating import METHODS, rating_of
from gearwright.sizing.rating.iso6336_inputs import steel_of
from gearwright.spec import edited, parse

ROWS = tomllib.loads(data_text("materials.toml"))
MINE = """
[materials.mine]
elastic_modulus_gpa = 206
poisson_ratio = 0.3
density_kg_m3 = 7830
yield_strength_mpa = 850
ultimate_strength_mpa = 1100
group = "nickel-case-hardened"
hardness_hrc = 61
steel = "case-hardened"
"""
LEWIS = PAIR + '[gears]\nmaterial = "mine"\n'
RATED = LEWIS + 'rating = "iso6336"\n'
STATED = "contact_strength_mpa = 1600\nbending_strength_mpa = 480\n"


def written(name, row):
    """Return a row of the catalogue as a design writes it."""
    lines = [f"{key} = {value!r}" for key, value in row.items() if not isinstance(value, dict)]
    tables = {key: inner for key, inner in row.items() if isinstance(inner, dict)}
    parts = [
        f"[materials.{name}.{key}]\n" + "".join(f"{k} = {v!r}\n" for k, v in table.items())
        for key, table in tables.items()
    ]
    return f"[materials.{name}]\n" + "\n".join(lines) + "\n" + "".join(parts)


def numbers(sizing):
    return (
        sizing.mass,
        [(gear.module, gear.mass, gear.inertia) for gear in sizing.gears],
        [(shaft.diameter, shaft.mass, shaft.stiffness) for shaft in sizing.shafts],
    )


@pytest.mark.parametrize("name", ROWS)
def test_a_row_of_the_catalogue_is_a_material_of_a_design(name):
    design = parse(PAIR + written("mine", ROWS[name]))
    mine, its = design.material("mine"), materials()[name]
    assert {**vars(mine), "name": name} == vars(its)


@pytest.mark.parametrize("rating", ["lewis-hertz", "iso6336"])
def test_a_design_with_its_own_copy_of_a_catalogue_material_sizes_bit_for_bit_the_same(rating):
    rules = f'[gears]\nrating = "{rating}"\nmaterial = '
    copied = size(parse(PAIR + rules + '"mine"\n' + written("mine", ROWS["AISI-9310"])))
    named = size(parse(PAIR + rules + '"AISI-9310"\n'))
    assert numbers(copied) == numbers(named)


@pytest.mark.parametrize(
    ("text", "clause"),
    [
        (RATED + MINE + STATED, "stated in the design"),
        (RATED + MINE + STATED + 'source = "test report 12"\n', "test report 12"),
        (RATED + MINE, "ISO 6336-5:2016, table 1, rows 42 and 45"),
        (PAIR + '[gears]\nrating = "iso6336"\nmaterial = "31CrMoV9"\n', "ISO 6336-5:2016, table 1, rows 57 and 63"),
    ],
)
def test_factors_say_where_the_strengths_come_from(text, clause):
    mesh = size(parse(text)).meshes[0]
    rows = METHODS[mesh.rating.method].factors(mesh.rating)
    assert {row.equation: row.clause for row in rows if row.chapter == "steel"} == {"σ_Hlim": clause, "σ_Flim": clause}


def test_an_own_material_serves_gears_stages_and_shafts():
    design = parse(PAIR + '[pairs.stage.gears]\nmaterial = "mine"\n[shafting]\nmaterial = "mine"\n' + MINE)
    assert rating_of(design, "stage").material.density == 7830.0
    assert design.shaft_material.yield_strength == 850e6
    heavier = size(edited(design, {"materials.mine.density_kg_m3": 15660.0}))
    assert heavier.gear_mass == pytest.approx(2.0 * size(design).gear_mass, rel=1e-9)
    assert heavier.shaft_mass == pytest.approx(2.0 * size(design).shaft_mass, rel=1e-9)


def test_stated_strengths_and_lines_are_those_of_the_rating():
    line = "[materials.mine.contact_life]\nknee_cycles = 1e8\nexponent = 12\nfactor_at_1e10 = 1\n"
    steel = steel_of(rating_of(parse(RATED + MINE + STATED + 'source = "test report 12"\n' + line), "stage"))
    assert (steel.contact_strength, steel.bending_strength) == (1600e6, 480e6)
    assert steel.contact_life.cycles[1:] == (1e8, 1e10)
    assert steel.contact_life.factors[1:] == (1.0, 1.0)
    assert steel.source == "test report 12"


def test_a_grade_that_is_asked_for_takes_its_strengths_from_the_table():
    steel = steel_of(rating_of(parse(RATED + 'iso6336.grade = "ME"\n' + MINE), "stage"))
    assert (steel.contact_strength, steel.bending_strength) == (1650e6, 525e6)


def test_gears_are_rated_as_the_material_that_is_named_and_not_as_another():
    """A nitriding steel was once rated as a case-hardened one where nothing else was said."""
    steel = steel_of(rating_of(parse(PAIR + '[gears]\nrating = "iso6336"\n'), "stage"))
    assert (steel.name, steel.contact_strength) == ("nitrided", 1250e6)


@pytest.mark.parametrize(
    ("text", "key", "words"),
    [
        (MINE.replace("density_kg_m3 = 7830\n", ""), "density_kg_m3", "is required"),
        (MINE.replace("elastic_modulus_gpa = 206\n", ""), "elastic_modulus_mpa", "is required"),
        (MINE.replace("modulus_gpa", "modulus_mpa"), "elastic_modulus_mpa", "50000 to 500000 MPa"),
        (MINE.replace("modulus_gpa", "modulus_GPa"), "elastic_modulus_GPa", "did you mean elastic_modulus_gpa"),
        (MINE.replace("density_kg_m3 = 7830", "density_kg_m3 = 7.83"), "density_kg_m3", "1000 to 20000"),
        (MINE.replace("density_kg_m3", "density"), "density", "the unit is missing"),
        (MINE.replace("hardness_hrc", "hardness"), "hardness", "did you mean hardness_h"),
        (MINE.replace("strength_mpa = 850", "strength_mpa = 1200"), "yield_strength_mpa", "more than the tensile"),
        (MINE + "contact_strength_mpa = 1500\n", "contact_strength_mpa", "needs; give bending_strength_mpa too"),
        (MINE + "hardness_hv = 800\n", "hardness_hrc", "61 HRC is about 720 HV"),
        (MINE.replace("= 61", "= 50"), "hardness_hrc", "nearest is 660"),
        (MINE.replace("hardness_hrc = 61\n", ""), "hardness_hv", "is required with steel"),
        (MINE.replace('steel = "case-hardened"', 'steel = "case-hardend"'), "steel", "did you mean case-hardened"),
        (MINE.replace('steel = "case-hardened"', 'grade = "ME"'), "grade", "give steel, one of"),
        (MINE.replace('steel = "case-hardened"', STATED), "contact_strength_mpa", "give steel, one of"),
        (MINE + '[materials.mine.estimated]\nyield = "0.8 R_m"\n', "estimated.yield", "yield_strength"),
        (MINE + '[materials.mine.estimated]\ndensity = " "\n', "estimated.density", "by which rule"),
        (MINE + "[materials.mine.contact_life]\nknee_cycles = 5e7\n", "contact_life.exponent", "is required"),
        (MINE + "[materials.mine.contact_life]\nknee_cycles = 5e7\nexponent = 60\nstatic_factor = 2\n",
         "contact_life.exponent", "less than one cycle"),
    ],
)  # fmt: skip
def test_a_material_that_is_wrong_is_refused_with_path_value_and_fix(text, key, words):
    found = {each.path: each.message for each in problems(PAIR + text)}
    assert words in found[f"materials.mine.{key}"], found


@pytest.mark.parametrize(("name", "whose"), [("16MnCr5", "the catalogue"), ("nitrided", "ISO 6336-5")])
def test_an_own_material_has_a_name_of_its_own(name, whose):
    """One name means one steel, in every design and report."""
    found = problem(PAIR + MINE.replace("mine", name))
    assert found.path == f"materials.{name}"
    assert found.message.startswith(whose)
    assert f"give it another, such as {name}-mine" in found.message


@pytest.mark.parametrize(
    ("text", "path", "words"),
    [
        (LEWIS + MINE.replace("mine", "mein"), "gears.material", "there is no material 'mine'; did you mean mein?"),
        (PAIR + '[gears]\nmaterial = "18crnimo7-6"\n', "gears.material", "did you mean 18CrNiMo7-6?"),
        (PAIR + '[gears]\nmaterial = "aisi9310"\n', "gears.material", "did you mean AISI-9310?"),
        (PAIR + '[gears]\nmaterial = "aisi 9310"\n', "gears.material", "did you mean AISI-9310?"),
        (PAIR + '[shafting]\nmaterial = "42CrMo"\n', "shafting.material", "did you mean 42CrMo4?"),
        (LEWIS + MINE.partition("hardness")[0], "gears.material", "give hardness_hv under [materials.mine]"),
        (LEWIS + MINE.replace("yield_strength_mpa = 850\n", "") + '[shafting]\nmaterial = "C45"\n', "gears.material",
         "give yield_strength_mpa under [materials.mine]"),
        (PAIR + '[gears]\nmaterial = "M50NiL"\nrating = "iso6336"\n', "shafting.material",
         "has no yield_strength, which a shaft needs;"),
        (RATED + MINE.replace('steel = "case-hardened"\n', ""), "gears.iso6336.steel", "no S-N data"),
        (RATED + 'iso6336.steel = "AISI-9310"\n' + MINE, "gears.iso6336.steel", "write material = 'AISI-9310'"),
        (RATED + 'iso6336.grade = "ME"\n' + MINE + STATED, "gears.iso6336.grade", "would replace"),
        (RATED + "iso6336.hardness_hv = 500\n" + MINE, "gears.iso6336.hardness_hv", "nearest is 660"),
    ],
)  # fmt: skip
def test_a_material_that_a_use_cannot_take_is_refused_with_the_near_one_or_what_it_lacks(text, path, words):
    found = problem(text)
    assert (found.path, words in found.message) == (path, True), str(found)


def test_a_required_key_in_the_wrong_case_is_told_in_one_place():
    found = problem(PAIR + MINE.replace("density_kg_m3", "Density_kg_m3"))
    assert (found.path, found.message) == (
        "materials.mine.Density_kg_m3", "no such field; did you mean density_kg_m3?",
    )  # fmt: skip


def test_everything_that_is_wrong_with_materials_is_told_at_once():
    wrong = MINE.replace("= 206", "= 2").replace('steel = "case-hardened"', 'steel = "soft"').replace("= 0.3", "= 3")
    found = problems(LEWIS.replace("mine", "mien") + wrong + "[materials.half]\npoisson_ratio = 0.3\n")
    assert {each.path for each in found} == {
        "materials.mine.elastic_modulus_gpa", "materials.mine.poisson_ratio", "materials.mine.steel",
        "materials.half.density_kg_m3", "materials.half.elastic_modulus_mpa", "gears.material",
    }  # fmt: skip
