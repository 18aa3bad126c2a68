"""Face gears as they are drawn: where they stand in space, as heavy as they are weighed, with their own tooth data."""

import math
from itertools import pairwise

import numpy as np
import pytest

from gearwright.parts.gears import face_crown
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.entities import Distance, Hatch, Layer, Words
from gearwright.render.drawings.gear_view import face_section, face_teeth, hub_of, toward_pinion
from gearwright.render.drawings.positions import positions
from gearwright.render.drawings.shaft_view import SheetAxis, made_of
from gearwright.shape.stands import gear_of, stands_of
from shipped_work import sized

NAME = "face-gear-split-torque"


@pytest.fixture(scope="module")
def sizing():
    return sized(NAME)


@pytest.fixture(scope="module")
def wheel(sizing):
    return gear_of(sizing, "first.wheel")


def test_wheels_lie_beside_their_pinion_as_in_space(sizing):
    """Also both of one pinion at once: their ways along and across its axis are those of space, turned in one piece."""
    plane = positions(sizing)
    stands = {stand.node: stand for stand in stands_of(sizing) if stand.gear.stage == "first"}
    pinion = stands.pop("input")
    ways = []
    for shaft, stand in stands.items():
        off = 1e3 * (stand.axes.origin - pinion.axes.origin)
        lying, other = plane.shafts["input"], plane.shafts[shaft]
        drawn = other.at(plane.places[shaft]["first.wheel"]) - lying.at(plane.places["input"]["first.pinion"])
        drawn *= lying.along.conjugate()
        assert drawn.real == pytest.approx(off @ pinion.axes.along, abs=1e-6)
        ways.append(drawn.imag / (off @ stand.axes.along) / (other.along / lying.along).imag)
    assert ways == pytest.approx([1.0, 1.0])


@pytest.mark.parametrize("shaft", ["left", "right"])
def test_teeth_look_at_the_pinion(sizing, wheel, shaft):
    stands = {stand.node: stand for stand in stands_of(sizing) if stand.gear.stage == "first"}
    own, toward = stands[shaft], toward_pinion(sizing, wheel, shaft)
    assert float((stands["input"].axes.origin - own.axes.origin) @ own.axes.along) * toward > 0.0
    section = face_section(
        sizing, wheel, hub_of(sizing, wheel, shaft), SheetAxis(0j, 1 + 0j, 1.0), toward=toward, lean=0.7
    )
    bodies = [each for each in section if isinstance(each, Hatch)]
    assert bodies
    assert all(toward * corner.real < 0.0 for body in bodies for corner in body.points)


def test_the_section_weighs_what_the_parts_list_says(sizing, wheel):
    """The hatched half turned about the axis, with the teeth before it (Guldin): the catalogue's density for both."""
    section = face_section(
        sizing, wheel, hub_of(sizing, wheel, "left"), SheetAxis(0j, 1 + 0j, 1.0), toward=1.0, lean=0.7
    )
    corners = next(each.points for each in section if isinstance(each, Hatch) and each.points[0].imag > 0.0)
    volume = 0.0
    for one, other in pairwise([*corners, corners[0]]):
        area = (one.conjugate() * other).imag / 2.0
        volume += 2.0 * math.pi * area * (one.imag + other.imag) / 3.0
    teeth = face_teeth(sizing, wheel)
    width = gear_of(sizing, "first.pinion").face_width
    found = abs(volume) * 1e-9 + face_crown(teeth.pinion, wheel.teeth, width)
    weighed = made_of(sizing).weights[wheel.name]
    assert found * sizing.design.material(sizing.design.rules("first").material).density == pytest.approx(
        weighed, rel=2e-3
    )


def test_the_sheet_has_the_sizes_of_the_wheel_and_its_own_tooth_data(sizing, wheel):
    (sheet,) = sheets(sizing, ["gear-first.wheel-left"])
    teeth = face_teeth(sizing, wheel)
    drawn = [each.measured for each in sheet.entities if isinstance(each, Distance)]
    for size in (2.0 * teeth.reach[0], 2.0 * teeth.reach[1]):
        assert np.min(np.abs(np.array(drawn) - size)) < 1e-6
    words = {each.text for each in sheet.entities if isinstance(each, Words) and each.layer is Layer.TABLE}
    assert {"face gear", "Teeth of the shaper", "218.4", "186.808"} <= words
    assert not {"Tip diameter", "Base diameter"} & words
