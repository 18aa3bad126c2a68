"""What `size --factors --methods --wish` answers as JSON: the numbers of the verbs, in the units beside them."""

import json

import pytest

import gearwright as gw
from designs import PAIR
from gearwright.cli.answers import answer_schema, answer_text
from gearwright.particulars import particulars
from gearwright.render.answers.design import Asked, SizeAnswer, size_answer
from gearwright.render.answers.schema import plain
from gearwright.render.tables.checks import influence_tables
from gearwright.sizing import influences, methods_beside, rated_factors
from gearwright.spec import parse
from json_schema import faults

SIZING = gw.size(parse(f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n\n[gears]\nrating = "agma2001"\n'))
FACTS = particulars(SIZING)
ASKED = Asked(rated_factors(SIZING), methods_beside(SIZING), influences(SIZING, 1.3))
ANSWER: SizeAnswer = size_answer(FACTS, ASKED)


def test_what_nobody_asks_for_is_null():
    told = plain(size_answer(FACTS))
    assert (told["factors"], told["methods"], told["influences"]) == (None, None, None)


def test_the_answer_with_everything_fits_its_schema():
    assert faults(json.loads(answer_text("size", ANSWER, design="pair")), answer_schema("size")) == []


def test_a_mesh_that_no_standard_rates_has_no_factors_in_the_answer():
    plainly = gw.size(parse(f"{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n"))
    assert size_answer(particulars(plainly), Asked(rated_factors(plainly))).factors == ()


def test_factors_stand_in_their_units_with_clause_and_limit():
    """Stresses in MPa: what the rating has in Pa; K_o is the design's K_A."""
    (mesh,) = ANSWER.factors
    rows = {(row.chapter, row.quantity): row for row in mesh.factors}
    stress = rows["stresses", "bending stress"]
    rated = SIZING.meshes[0].rating.factors
    assert stress.unit == "MPa"
    assert stress.values == pytest.approx([gear.bending_stress / 1e6 for gear in rated.gears], rel=1e-12)
    assert rows["mesh", "overload"].values == (SIZING.design.service.application_factor,)
    assert all(row.clause for row in mesh.factors)
    assert (mesh.method, mesh.gears) == ("agma2001", SIZING.meshes[0].gears)


def test_methods_are_those_of_the_verb():
    (mesh,), (beside,) = ANSWER.methods, gw.methods_beside(SIZING)
    assert {name: (both.flanks, both.roots) for name, both in mesh.margins.items()} == dict(beside.margins)
    forces = next(row for row in mesh.aspects if row.aspect.startswith("force"))
    assert forces.unit == "N"
    assert forces.values == dict(next(row for row in beside.rows if row.aspect.startswith("force")).values)


def test_influences_are_those_of_the_verb_in_units_that_people_read():
    (mesh,), (found,) = ANSWER.influences, gw.influences(SIZING, 1.3)
    assert (mesh.margin, mesh.wish) == (found.margin, 1.3)
    width = next(row for row in mesh.handles if row.handle == "face width b")
    handle = next(row for row in found.rows if row.handle == "face width b")
    assert (width.unit, width.flank, width.root) == ("mm", handle.flank, handle.root)
    assert (width.value, width.wanted) == pytest.approx((1e3 * handle.value, 1e3 * handle.wanted), rel=1e-12)


def test_what_moves_a_margin_is_one_block_on_eighty_columns():
    """Widest cell of every column, two spaces between them, one before the first and one after the last."""
    for table in influence_tables(influences(SIZING, 1.25)).values():
        cells = [[column.header for column in table.columns], *([cell.text for cell in row] for row in table.rows)]
        assert sum(max(map(len, column)) + 2 for column in zip(*cells, strict=True)) <= 80
