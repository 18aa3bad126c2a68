"""Sheets of carriers: their numbers are the sizing's, pins stand as they do in space, zones keep the load factor."""

import io
import math
from dataclasses import replace

import ezdxf
import numpy as np
import pytest

import gearwright as gw
from gearwright.catalogue import standard_tolerance
from gearwright.parts.planetary import pin_error_share, pin_error_within
from gearwright.render.drawings.carriers import (
    MESH_STIFFNESS,
    carrier_content,
    drawn_carrier,
    is_even,
    outline_radii,
    pin_places,
    places_of,
)
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.entities import Arc, Layer, Words
from gearwright.render.drawings.writers import sheet_dxf
from gearwright.shape.bodies import held_at
from gearwright.shape.stands import axes_at, middle_of, set_frame, stands_of
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing.mass import cage_of
from gearwright.sizing.places import runs
from gearwright.spec import parse
from shipped_work import sized

WITH_SETS = [name for name in shipped_designs() if sized(name).carriers]


def drawn_of(sizing, carrier):
    cage = cage_of(sizing, carrier, runs(sizing)[0])
    axes = axes_at(set_frame(sizing, carrier.stage), middle_of(cage.plates[0].body))
    own = [stand for stand in stands_of(sizing) if stand.gear.stage == carrier.stage and stand.carrier]
    along = float(axes.along @ np.asarray(cage.plates[0].body.direction))
    return drawn_carrier(cage, held_at(cage, axes, own), along=along)


def measured(sheet):
    """Return what the linear DIMENSION entities of the written file measure [mm]."""
    found = ezdxf.read(io.StringIO(sheet_dxf(sheet))).modelspace().query("DIMENSION")
    return [float(one.get_measurement()) for one in found]


@pytest.mark.parametrize("name", WITH_SETS)
def test_dimensions_of_carriers_are_their_sizing(name):
    """Pin circle, outer diameter, pins, plates and what lies between them, read back from the DXF file."""
    sizing = sized(name)
    found = {sheet.name: sheet for sheet in sheets(sizing, ["carrier"])}
    assert set(found) == {f"carrier-{carrier.stage}" for carrier in sizing.carriers}
    for carrier in sizing.carriers:
        values, cage = measured(found[f"carrier-{carrier.stage}"]), cage_of(sizing, carrier, runs(sizing)[0])
        asked = [2.0 * carrier.reach, carrier.pin_diameter, carrier.plate_thickness, cage.whole[1] - cage.whole[0]]
        asked += [2.0 * plate.bore for plate in cage.plates if plate.bore]
        asked += [cage.span[1] - cage.span[0]] if len(cage.plates) > 1 else []
        for value in asked:
            assert any(math.isclose(1e3 * value, one, abs_tol=1e-6) for one in values), (carrier.stage, value)


def test_pins_of_unequal_sets_have_a_table_and_stand_as_in_space():
    """A Ravigneaux set: from the left end, against the axis or along it, neighbours stand on the side that they do."""
    sizing = sized("ravigneaux-automatic")
    (carrier,) = sizing.carriers
    drawn = drawn_of(sizing, carrier)
    assert not is_even(drawn) and len(places_of(drawn)) == 6
    assert [grid.title for grid in carrier_content(sizing, carrier).grids][1].startswith("Pins, the first on top")
    cage = drawn.cage
    axes = axes_at(set_frame(sizing, carrier.stage), middle_of(cage.plates[0].body))
    # Seen from the left along +direction: the view's right is the direction crossed into up.
    body = np.asarray(cage.plates[0].body.direction)
    own = [stand for stand in stands_of(sizing) if stand.gear.stage == carrier.stage and stand.carrier]
    offsets = [stand.axes.origin - axes.origin for stand in own]
    offsets = [off - (off @ body) * body for off in offsets]
    top = max(offsets, key=lambda off: round(float(np.linalg.norm(off)), 9))
    up = top / np.linalg.norm(top)
    right = np.cross(body, up)
    seen = {(round(float(1e3 * off @ right), 3), round(float(1e3 * off @ up), 3)) for off in offsets}
    shown = {(round(1e3 * eye.radius * math.cos(eye.angle), 3), round(1e3 * eye.radius * math.sin(eye.angle), 3))
             for eye in drawn.eyes}  # fmt: skip
    assert {(x + 0.0, y + 0.0) for x, y in seen} == {(x + 0.0, y + 0.0) for x, y in shown}


def test_an_outline_reaches_as_far_as_the_plate_over_its_outermost_pins():
    sizing = sized("hybrid-turboprop")
    for carrier in sizing.carriers:
        drawn = drawn_of(sizing, carrier)
        top = float(outline_radii(drawn, drawn.plates[0][2], np.array([math.pi / 2.0]))[0])
        assert top == pytest.approx(1e3 * carrier.reach, rel=1e-9)
        assert is_even(drawn)


def test_the_end_view_has_every_pin_with_its_bore():
    sizing = sized("in-line-h2")
    (sheet,) = sheets(sizing, ["carrier-second"])
    carrier = sizing.carriers[1]
    rings = [
        mark.radius / sheet.scale for mark in sheet.entities if isinstance(mark, Arc) and mark.layer is Layer.OUTLINE
    ]
    pins = [ring for ring in rings if math.isclose(ring, 1e3 * carrier.pin_diameter / 2.0, rel_tol=1e-9)]
    assert len(pins) == 5
    assert any(words.text.startswith("5 × Ø20.63 H7") for words in sheet.entities if isinstance(words, Words))


def test_a_zone_without_a_factor_is_it6_and_says_what_it_costs():
    """Three planets: one pin 11 µm off costs nothing where a member floats; else K_γ = 1 + 3 (2/3) K e/F."""
    sizing = sized("in-line-h2")
    carrier = sizing.carriers[0]
    places = pin_places(sizing, carrier)
    assert places.zone == pytest.approx(standard_tolerance(carrier.radius, 6)) == pytest.approx(22e-6)
    planet = next(gear for gear in sizing.gears if gear.name == "first.planet")
    loop = 4.0 * math.cos(math.radians(20.0)) ** 2 * MESH_STIFFNESS * planet.face_width / 2.0
    assert places.floating == pytest.approx(1.0)
    assert places.fixed == pytest.approx(1.0 + 2.0 * loop * 11e-6 / (carrier.torque / carrier.radius), rel=1e-6)


def test_a_zone_keeps_the_load_factor_that_a_design_is_rated_with():
    """Five planets rated with K_γ = 1.1: the closed form solved for the error, to the micrometre below."""
    text = shipped_design("in-line-h2").read_text(encoding="utf-8")
    sizing = gw.size(parse(text.replace("[gears]", "[gears]\nmesh_load_factor = 1.1", 1)))
    carrier = sizing.carriers[1]
    places = pin_places(sizing, carrier)
    assert places.asked == 1.1 and "keeps" in places.origin
    assert places.floating == pytest.approx(1.1, abs=0.03) and places.floating <= 1.1
    planet = next(gear for gear in sizing.gears if gear.name == "second.planet")
    stiffness = (MESH_STIFFNESS * planet.face_width,) * 2
    force, angle = carrier.torque / carrier.radius, math.radians(20.0)
    asked = {"stiffness": stiffness, "pressure_angle": angle, "floating": True}
    error = pin_error_within(5, 1.1, force, **asked)
    assert 5 * pin_error_share(5, error, force, **asked) == pytest.approx(1.1)
    assert places.zone == pytest.approx(math.floor(2e6 * error) / 1e6)
    assert pin_error_within(3, 1.1, force, **asked) == math.inf


def test_a_zone_is_twice_the_error_that_a_design_states():
    text = shipped_design("in-line-h2").read_text(encoding="utf-8")
    sizing = gw.size(parse(text + '\n[errors."first.planet-1"]\npin_tangential_mm = 0.02\n'))
    places = pin_places(sizing, sizing.carriers[0])
    assert places.zone == pytest.approx(40e-6) and "[errors]" in places.origin


def test_no_closed_form_speaks_of_compound_sets():
    sizing = sized("ravigneaux-automatic")
    places = pin_places(sizing, sizing.carriers[0])
    assert not places.is_simple and places.floating is None
    large = replace(sizing.carriers[0], radius=4.0)
    assert pin_places(sizing, large).zone is None  # beyond ISO 286-1
