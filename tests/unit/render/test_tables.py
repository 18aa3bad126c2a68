import re
from dataclasses import dataclass
from typing import Annotated

import pytest
from drawn_designs import MIXED, sized

from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.particulars import particulars
from gearwright.render.answers.schema import described, plain
from gearwright.render.grid import table
from gearwright.render.tables.checks import check_sentence, review_tables
from gearwright.render.tables.sizing import given_by_user, tables_of
from gearwright.units import Length, Origin, Quantity, written


@dataclass(frozen=True)
class Part:
    name: str
    face_width: Annotated[float, Quantity("length"), Origin("b = λ m_n", "a book")]
    bore: Length | None = None


def test_a_column_takes_unit_equation_and_source_from_the_marks_of_its_field() -> None:
    column = table("Parts", [Part("wheel", 0.02)], ("name", "face_width")).columns[1]
    assert (column.header, column.symbol, column.unit) == ("face width", "b", "mm")
    assert column.origin == Origin("b = λ m_n", "a book")


def test_values_are_shown_in_the_unit_of_their_column() -> None:
    row = table("Parts", [Part("wheel", 0.02)], ("name", "face_width", "bore")).rows[0]
    assert [cell.text for cell in row] == ["wheel", "20.00", "–"]


@pytest.mark.parametrize(
    ("number", "text"),
    [(0.0, "0"), (1.0, "1.000"), (-16035.2, "−16035"), (0.99999999, "1.000"), (2.3e-5, "2.300e-05"),
     (999.96, "1000"), (float("inf"), "∞")],
)  # fmt: skip
def test_numbers_have_four_significant_digits(number: float, text: str) -> None:
    assert written(number) == text


def test_machines_get_every_digit_and_no_infinity() -> None:
    wheel, idle = plain([Part("wheel", 1 / 30), Part("idle", float("inf"))])
    assert wheel["face_width_mm"] == pytest.approx(1000 / 30, rel=1e-15)
    assert idle["face_width_mm"] is None
    definitions = {}
    described(Part, definitions)
    assert definitions["Part"]["properties"]["face_width_mm"]["source"] == "a book"


def test_values_that_the_user_gives_are_marked_where_they_act_and_nowhere_else() -> None:
    sizing = sized(MIXED + '[overrides]\n"second.module_mm" = 4\n"lay.diameter_mm" = 80\n')
    gears = tables_of(particulars(sizing))["gears"]
    module = [column.name for column in gears.columns].index("module")
    marks = {row[0].value: row[module].mark for row in gears.rows}
    assert marks == {
        "first.pinion": "", "first.wheel": "", "second.sun": "given", "second.planet": "given", "second.ring": "given",
    }  # fmt: skip
    shafts = {shaft.name: given_by_user(sizing, shaft, "diameter") for shaft in sizing.shafts}
    assert shafts == {"input": "", "lay": "given", "output": ""}


def test_a_carrier_that_is_given_leaves_the_gears_of_its_stage_computed() -> None:
    sizing = sized(MIXED + '[overrides]\n"second.carrier.mass_kg" = 9\n')
    marks = {carrier.stage: given_by_user(sizing, carrier, "mass") for carrier in sizing.carriers}
    assert marks == {"second": "given"}
    assert {gear.name for gear in sizing.gears if given_by_user(sizing, gear, "mass")} == set()


def test_an_inertia_is_marked_as_given_or_as_estimated() -> None:
    sizing = sized(MIXED)
    marks = {machine.name: given_by_user(sizing, machine, "inertia") for machine in sizing.machines}
    assert marks == {"gas-turbine": "estimated", "electric": "given", "propeller": "estimated"}
    assert tables_of(particulars(sizing))["machines"].marks == ("given", "estimated")


@pytest.mark.parametrize("margin", [0.7196, 0.99962, 0.99996, 0.9999996, 1.0, 1.00004])
def test_a_check_reads_in_a_sentence_as_in_its_table_and_never_on_the_other_side_of_its_limit(margin: float) -> None:
    check = Check(PartId(Kind.SHAFT, "output"), "Tresca", "a book", margin * 392.5e6, 392.5e6, "stress")
    sentence = check_sentence(check)
    value, limit, told = map(float, re.findall(r"([\d.]+) MPa, limit ([\d.]+) MPa .*margin ([\d.]+)$", sentence)[0])
    listed = review_tables([check])[0]
    (cell,) = (cell for cell, column in zip(listed.rows[0], listed.columns, strict=True) if column.name == "margin")
    assert told == pytest.approx(float(cell.text), abs=5e-4)
    assert (told < 1.0) == (float(cell.text) < 1.0) == (margin < 1.0)
    assert value < limit if margin < 1.0 else value >= limit
