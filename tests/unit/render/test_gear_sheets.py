"""Sheets of gears say where teeth are hard, and how a bevel pair bears."""

import math

import pytest

from gearwright.render.drawings.catalogue import contents, sheets
from gearwright.render.drawings.entities import Layer, Path, Words, drawn
from gearwright.render.drawings.gear_sheet import hard_grid, hard_teeth
from gearwright.shape.stands import gear_of
from shipped_work import coarse, sized


def shown(design, gear):
    (sheet,) = sheets(sized(design), [f"gear-{gear}"])
    lines = [mark for mark in sheet.entities if isinstance(mark, Path) and mark.layer is Layer.HARDENED]
    return sheet, lines, [mark.text for mark in drawn(sheet.entities) if isinstance(mark, Words)]


@pytest.mark.parametrize(
    ("design", "gear", "length"),
    [
        ("ec120b", "helical.wheel", 35.0),
        ("in-line-h2", "first.ring", None),
        ("face-gear-split-torque", "first.wheel-left", None),
    ],
)
def test_a_line_as_long_as_the_teeth_stands_beside_them(design, gear, length):
    sheet, lines, said = shown(design, gear)
    (line,) = lines
    name = gear.removesuffix("-left")
    own = gear_of(sized(design), name)
    wanted = length or 1e3 * own.face_width
    if name == "first.wheel":
        wanted = float(said[said.index("Width of whole teeth") + 2])
    assert abs(line.points[1] - line.points[0]) / sheet.scale == pytest.approx(wanted, abs=1e-3)
    assert "1" in said


def test_the_line_of_a_bevel_gear_lies_along_its_face_cone():
    """Face cone of the EC120B's wheel: 74.0405 degrees."""
    _, (line,), said = shown("ec120b", "bevel.wheel")
    way = line.points[1] - line.points[0]
    assert math.degrees(math.atan2(way.imag, way.real)) == pytest.approx(74.0405, abs=1e-3)
    assert "700 +100 HV, CHD 1.19 +0.4" in said  # 0.15 to 0.2 of 7.96 mm


def test_what_is_asked_is_the_rating_s_or_the_material_s():
    rated, plain = sized("hybrid-turboprop"), sized("in-line-h2")
    for sizing in (rated, plain):
        hard = hard_teeth(sizing, gear_of(sizing, "first.sun"))
        assert (hard.treatment, hard.hardness) == ("nitrided", 650.0)
        (grid,) = hard_grid(sizing, gear_of(sizing, "first.sun"))
        assert grid.rows[0] == ("1", "teeth", "at least 650 HV, NHD not sized")


def test_a_bevel_gear_says_how_long_its_contact_is_rated_and_names_its_spline():
    """0.85 b of ISO 10300-1: 49.3 of 58 mm."""
    _, _, said = shown("ec120b", "bevel.wheel")
    assert said[said.index("Contact pattern at full load, as rated") + 2] == "49.3 long"
    assert "DIN 5480 - N 78 x 3 x 24" in said


def test_a_ring_shows_its_edges_behind_the_section():
    sheet, _, said = shown("in-line-h2", "first.ring")
    tip = float(said[said.index("Tip diameter") + 2]) * sheet.scale
    edges = [mark for mark in sheet.entities
             if isinstance(mark, Path) and mark.layer is Layer.OUTLINE and len(mark.points) == 2
             and abs(abs(mark.points[1] - mark.points[0]) - tip) < 1e-2]  # fmt: skip
    assert len(edges) == 2


def test_the_back_of_a_face_gear_runs_out_against_its_bore():
    """IT5 of 218.4 mm: 20 µm."""
    _, _, said = shown("face-gear-split-torque", "first.wheel-left")
    assert "0.02" in said and said.count("A") >= 2


def test_a_shaft_that_no_solid_has_has_no_sheet():
    """The Wolfrom reducer's cage is a carrier without anything else on its axis: not weighed, not drawn."""
    names = [content.name for content in contents(sized("wolfrom-reducer"), coarse(sized("wolfrom-reducer")))]
    assert "shaft-cage" not in names and {"shaft-fast", "shaft-slow"} <= set(names)
