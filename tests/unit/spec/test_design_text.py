"""A design as the text of a file: what is read from it is the design."""

import math

import pytest

from designs import PAIR
from gearwright.errors import DesignError
from gearwright.shipped import shipped_designs
from gearwright.spec import design_text, edited, parse, read


def flat(value, path=""):
    """Yield every number and text below a path."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from flat(inner, f"{path}.{key}")
    elif isinstance(value, list | tuple):
        for place, inner in enumerate(value):
            yield from flat(inner, f"{path}.{place}")
    else:
        yield path, value


def same(first, second):
    """Quantities go through their unit, which costs the last bit of some."""
    if isinstance(first, float):
        return math.isclose(first, second, rel_tol=1e-14)
    return first == second


@pytest.mark.parametrize("name", shipped_designs())
def test_a_shipped_design_is_read_as_itself_from_its_text(name):
    design = read(name)
    again = parse(design_text(design))
    before, after = (dict(flat(row.model_dump(exclude_unset=True))) for row in (design, again))
    assert before.keys() == after.keys()
    assert [path for path in before if not same(before[path], after[path])] == []


def test_a_text_is_written_in_the_units_that_people_read():
    text = design_text(edited(parse(PAIR), {"turbines.turbine.power_kw": 250, "pairs.stage.face_width_mm": 40}))
    assert "power_kw = 250.0" in text
    assert "face_width_mm = 40.0" in text
    assert "diameter_mm = 2000.0" in text


def test_names_with_dots_stand_in_quotes():
    waived = edited(parse(PAIR), {"waivers.stage.pinion bending": "tried"})
    assert '"stage.pinion bending" = "tried"' in design_text(waived)
    assert parse(design_text(waived)).waivers == {"stage.pinion bending": "tried"}


def test_what_is_no_design_is_told_how_to_read_one():
    with pytest.raises(DesignError, match=r"gw\.read"):
        design_text("in-line-h2")
