"""Gears seen along their axis, edges, and what their teeth may deviate by."""

import math

import pytest
from built_design import built_sizing

import gearwright as gw
from gearwright.parts.gears import runout_tolerance
from gearwright.parts.iso6336 import flank_tolerances
from gearwright.render.drawings.catalogue import contents, sheets
from gearwright.render.drawings.entities import Arc, Layer, Words
from gearwright.render.drawings.gear_sheet import edge_notes
from gearwright.render.drawings.gear_view import hub_of
from gearwright.sizing.mass import gear_blanks
from gearwright.spec import edited
from shipped_work import BY_HAND, coarse, sized, text_of


def arcs(sheet, layer):
    """Return radius [mm] and turn [rad] of the arcs of a layer, symbols left out."""
    return [(mark.radius / sheet.scale, mark.end - mark.start) for mark in sheet.entities
            if isinstance(mark, Arc) and mark.layer is layer]  # fmt: skip


def test_a_splined_wheel_is_seen_along_its_axis_by_its_right_half():
    """ISO 2203: tips and pitch circle; ISO 6413: the tip circle of the hub's spline wide, its root circle thin."""
    sizing = sized(BY_HAND)
    (sheet,) = sheets(sizing, ["gear-helical.wheel"])
    blank, wide = gear_blanks(sizing)["helical.wheel"], arcs(sheet, Layer.OUTLINE)
    wheel = next(gear for gear in sizing.gears if gear.name == "helical.wheel")
    bore = hub_of(sizing, wheel, wheel.shafts[0]).bore
    for radius in (357.73 / 2.0, 1e3 * blank.rim_radius, 1e3 * blank.hub_radius, bore / 2.0):
        assert any(math.isclose(ring, radius, abs_tol=5e-3) and about == math.pi for ring, about in wide), radius
    assert any(math.isclose(ring, 353.73 / 2.0, abs_tol=5e-3) for ring, _ in arcs(sheet, Layer.PITCH))
    assert any(about == math.pi for _, about in arcs(sheet, Layer.THIN))
    said = " ".join(words.text for words in sheet.entities if isinstance(words, Words))
    assert "Datum A is the pitch cylinder of the hub's spline." in said


def test_a_keyed_wheel_is_seen_whole():
    (sheet,) = sheets(built_sizing(), ["gear-helical.wheel"])
    assert any(math.isclose(about, 2.0 * math.pi) for _, about in arcs(sheet, Layer.PITCH))


@pytest.mark.parametrize(("holes", "whole", "cut"), [(6, 2, 2), (5, 2, 1), (3, 1, 1), (8, 3, 2)])
def test_holes_of_a_web_stand_on_their_circle_the_first_on_top(holes, whole, cut):
    """Those on the line of symmetry are halves: of an odd number the one on top alone."""
    sizing = gw.size(edited(gw.parse(text_of(BY_HAND)), {"gears.web_holes": holes}))
    (sheet,) = sheets(sizing, ["gear-helical.wheel"])
    blank = gear_blanks(sizing)["helical.wheel"]
    rings = [about for ring, about in arcs(sheet, Layer.OUTLINE) if math.isclose(ring, 1e3 * blank.hole_radius)]
    assert sum(math.isclose(about, 2.0 * math.pi) for about in rings) == whole
    assert sum(math.isclose(about, math.pi) for about in rings) == cut
    assert any(words.text.startswith(f"{holes} × Ø") for words in sheet.entities if isinstance(words, Words))


def test_bodies_of_revolution_have_one_view():
    (sheet,) = sheets(sized("in-line-h2"), ["gear-first.planet"])
    assert not arcs(sheet, Layer.PITCH)


def test_edges_follow_module_and_bore():
    """0.1 of the module, 0.2 mm at least; chamfers of bores as those of shafts: 1 mm up to 50 mm, 2 mm above."""
    assert list(edge_notes(0.0, 1.0)) == ["Edges of teeth, at tips and ends, 0.2 × 45°, as assumed; not weighed."]
    assert "0.8 × 45°, chamfers of the bore 1 × 45°," in next(edge_notes(50.0, 8.0))
    assert "chamfers of the bore 2 × 45°," in next(edge_notes(50.5, 8.0))


def test_the_table_of_a_rated_gear_has_what_its_class_allows_and_how_its_flanks_are_modified():
    """Class 4 of ISO 1328-1 for d = 353.73, m_n = 2, b = 37 mm; the design's relief and lead."""
    sizing = gw.size(edited(gw.parse(text_of(BY_HAND)), {"gears.iso6336.tip_relief_m": 2e-5}))
    (content,) = [one for one in contents(sizing, coarse(sizing)) if one.name == "gear-helical.wheel"]
    rows = {row[0]: row[2] for row in content.grids[0].rows}
    wheel = next(gear for gear in sizing.gears if gear.name == "helical.wheel")
    may = flank_tolerances(wheel.pitch_diameter, wheel.module, wheel.face_width, grade=4)
    assert rows["Single pitch"] == f"{1e6 * may.single_pitch:.1f} µm"
    assert rows["Run-out of the teeth"] == f"{1e6 * runout_tolerance(wheel.pitch_diameter, wheel.module, 4):.0f} µm"
    assert rows["Tip relief"] == "20 µm" and rows["Lead"].startswith("corrected")
    plain = (
        next(one for one in contents(sized("in-line-h2"), coarse(sized("in-line-h2"))) if one.name == "gear-first.sun")
        .grids[0]
        .rows
    )
    assert "Single pitch" not in {row[0] for row in plain}
