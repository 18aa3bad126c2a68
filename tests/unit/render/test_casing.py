"""The housing in drawings: it is cut where the section lies, what is cut is the metal that is weighed."""

import itertools
import math

import numpy as np
import pytest

import gearwright as gw
from gearwright.render.drawings.assembly_sheets import casing_content
from gearwright.render.drawings.casing_section import casing_section, joints_of
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.entities import Arc, Distance, Hatch, Layer, Path, Words, extent
from gearwright.render.drawings.plane_section import (
    casing_of,
    closed_towards,
    end_outlines,
    seen_from_second_end,
    span_of,
    true_section,
)
from gearwright.render.drawings.positions import cutting_way, lanes, positions
from gearwright.shape import screw_places
from gearwright.shape.chambers import Chamber, depth_in
from gearwright.shipped import shipped_designs
from gearwright.sizing.casing import screw_volume
from gearwright.sizing.mass import complete_mass, weighed_flanges
from shipped_work import BY_HAND, coarse, sized

MM = 1e3
WITHOUT = {"face-gear-split-torque"}
"""Designs whose arrangements have axes or bodies where no true section has them."""
OWN = [name for name in shipped_designs() if sized(name).design.housing.own]


def in_space(way, x, height):
    """Return the point in space [m] of a place on the sheet [m]."""
    lane = next(lane for lane in way if x <= lane.end)
    leg = next(leg for leg in lane.legs if height <= leg.high)
    return np.array([x, *(leg.foot + height * leg.along)])


@pytest.mark.parametrize("name", OWN)
def test_the_section_runs_through_the_axes_that_are_drawn_or_is_none(name):
    """Both ends of every shaft on the sheet are in space where its frame has them."""
    sizing = sized(name)
    plane = positions(sizing)
    way = lanes(sizing, plane)
    assert (way is None) == (name in WITHOUT)
    for shaft, lying in plane.shafts.items() if way else ():
        frame = sizing.arrangement.frames[shaft]
        for place in (lying.start, lying.end):
            at = lying.at(place) / MM
            true = np.array(frame.origin) + place / MM * np.array(frame.along)
            assert np.allclose(in_space(way, at.real, at.imag), true, atol=1e-6), shaft


@pytest.mark.parametrize("name", ["ec120b", "in-line-h2", "mixed-h1", "off-set", "twin-engine-helicopter"])
def test_what_is_hatched_is_metal_and_what_is_not_is_none(name):
    """Points at random in the sheet's plane against the depth in the chambers and flanges of the scene."""
    sizing = sized(name)
    plane = positions(sizing)
    section, scene = casing_section(sizing, coarse(sizing), plane), gw.scene(sizing)
    way = lanes(sizing, plane, joints_of(scene))
    rectangles = [one for cut in section.cuts for one in cut.rectangles]
    box = [pick(values) for values in zip(*((one.start, one.end, one.low, one.high) for one in rectangles), strict=True)
           for pick in (min, max)]  # fmt: skip
    rng = np.random.default_rng(7)
    xs, ys = rng.uniform(box[0], box[3], 1500), rng.uniform(box[4], box[7], 1500)
    bosses = [node for node in scene.nodes if "boss of" in node.name or ", collar " in node.name]
    chambers = [node for node in scene.nodes
                if node.look == "housing" and isinstance(scene.solids[node.surface], Chamber)]  # fmt: skip
    metal = 0
    for x, y in zip(xs, ys, strict=True):
        point = in_space(way, x, y)
        if any(near(scene, node, point) for node in bosses):
            continue
        drawn = any(one.start < x < one.end and one.low < y < one.high for one in rectangles)
        if in_hole(section, x, y):
            assert not drawn
            continue
        depth = max(depth_in(((point - node.axes.origin) @ node.axes.turned)[None], scene.solids[node.surface])
                    for node in chambers)  # fmt: skip
        assert drawn == (depth > 0.0), (x, y)
        metal += drawn
    assert metal > 40


def in_hole(section, x, y):
    """Tell whether a point is in the clearance hole of a screw, which the solids of flanges do not have."""
    return any(one.start < x < one.end and one.low < y < one.high for one in section.holes)


def near(scene, node, point):
    """Tell whether a point is within the outside of a boss."""
    off = (point - node.axes.origin) @ node.axes.turned
    profile = scene.solids[node.surface].profile
    return math.hypot(*off[:2]) < max(radius for _, radius in profile) and abs(off[2]) <= profile[2][0]


def test_bosses_around_bearings_are_part_of_the_housing():
    """The boss of a bearing of the mast, 0.12 of its outside diameter thick, is hatched beside it."""
    sizing = sized("ec120b")
    section = casing_section(sizing, coarse(sizing), positions(sizing))
    lying = positions(sizing).shafts["mast"]
    for bearing in (one for one in sizing.bearings if one.shaft == "mast"):
        for side in (1.0, -1.0):
            at = lying.at(MM * bearing.position, side * MM * 0.56 * bearing.outer_diameter) / MM
            assert any(one.start < at.real < one.end and one.low < at.imag < one.high
                       for cut in section.cuts for one in cut.rectangles)  # fmt: skip


@pytest.mark.parametrize("name", OWN)
def test_halves_of_flanges_stand_apart_with_room_for_screws_outside_of_wider_chambers(name):
    scene = gw.scene(sized(name))
    halves = sorted((float(node.axes.origin[0]), scene.solids[node.surface]) for node in scene.nodes
                    if "flange" in node.name)  # fmt: skip
    for (place, half), (other, _) in zip(halves[1::2], halves[2::2], strict=False):
        assert other - place > 1.5 * half.span[1]
    chambers = [scene.solids[node.surface] for node in scene.nodes if "chamber" in node.name]
    for place, half in halves:
        corners = half.outer[:, None, :] * np.ones((1, 2, 1))
        for chamber in chambers:
            heights = place + np.linspace(0.0, half.span[1], 5)
            points = np.array([[*corner, z] for corner in corners[:, 0] for z in heights])
            assert depth_in(points, chamber) == 0.0


def test_the_list_of_parts_has_the_housing_with_its_mass():
    for name in ("ec120b", "in-line-h2"):
        sizing = sized(name)
        (sheet,) = sheets(sizing, ["arrangement"])
        said = [mark.text for mark in sheet.entities if isinstance(mark, Words)]
        mass = sum(item.total for item in complete_mass(sizing).parts
                   if item.group == "housing" and item.part != "housing bolts")  # fmt: skip
        assert said[said.index("Housing") + 2] == f"{mass:.3g}"
        flanges = weighed_flanges(sizing)
        row = said.index("Screw of flange")
        assert said[row - 1] == f"{flanges.number * flanges.screws}"
        assert said[row + 1 : row + 3] == ["M6 x 24, 10.9, nut, washers", f"{7850 * screw_volume(6e-3):.3g}"]
        assert {mark.spacing for mark in sheet.entities if isinstance(mark, Hatch)} >= {3.0, 4.0}


def test_a_housing_that_an_unfolded_section_cannot_hold_is_cut_by_one_plane_beside_it():
    """Face gears: input, left and right shaft lie in y = 0; the output, 233.6 mm off it, is unfolded alone."""
    sizing = sized("face-gear-split-torque")
    scene, unfolded = gw.scene(sizing), positions(sizing)
    section = true_section(sizing, scene, unfolded)
    assert set(section.plane.shafts) == {"input", "left", "right"}
    for name, lying in section.plane.shafts.items():
        frame = sizing.arrangement.frames[name]
        for place in (lying.start, lying.end):
            true = np.array(frame.origin) + place / MM * np.array(frame.along)
            assert lying.at(place) / MM == pytest.approx(complex(true[0], true[2]), abs=1e-9) and abs(true[1]) < 1e-9
    (sheet,) = sheets(sizing, ["arrangement"])
    said = [mark.text for mark in sheet.entities if isinstance(mark, Words)]
    assert "Housing" in said and "B-B" in said
    marks = [mark.at for mark in sheet.entities
             if isinstance(mark, Words) and mark.text == "B" and mark.layer is Layer.SYMBOL]  # fmt: skip
    assert len(marks) == 2
    assert marks[0].real == pytest.approx(marks[1].real)  # the plane is upright in the view along the first shaft


def test_machines_towards_which_the_housing_has_no_opening_are_named():
    """Ends of first sizings within the housing; the mast of the EC120B, which is built, goes out through its cover."""
    for name, closed in (("face-gear-split-torque", ("engine", "rotor")), ("ec120b", ()), ("off-set-h1", ())):
        assert closed_towards(sized(name), gw.scene(sized(name))) == closed
    notes = casing_content(sized("face-gear-split-torque"), coarse(sized("face-gear-split-torque"))).notes
    assert any("No opening is cut towards engine, rotor" in note for note in notes)


@pytest.mark.parametrize(
    ("name", "size", "scale"),
    [
        ("ec120b", "A1", 0.5),
        ("in-line-star", "A1", 0.5),
        ("twin-engine-helicopter", "A0", 0.5),
        ("wolfrom-reducer", "A2", 1.0),
    ],
)
def test_arrangements_fill_their_sheets(name, size, scale):
    """By turns: the second view over the tables, notes over the tables, and below the view."""
    (sheet,) = sheets(sized(name), ["arrangement"])
    assert (sheet.size.name, sheet.scale) == (size, scale)


def test_a_slim_view_has_a_smaller_scale_rather_than_a_large_empty_sheet():
    (sheet,) = sheets(sized("single-planetary"), ["arrangement"])
    assert (sheet.size.name, sheet.scale) == ("A1", 0.2)


def test_a_view_that_stands_elsewhere_has_an_arrow_and_a_letter():
    (sheet,) = sheets(sized("ec120b"), ["arrangement"])
    letters = [mark for mark in sheet.entities if isinstance(mark, Words) and mark.text == "A" and mark.height == 5.0]
    assert len(letters) == 2
    (none,) = sheets(sized("e-axle"), ["arrangement"])
    assert not [mark for mark in none.entities if isinstance(mark, Words) and mark.height == 5.0 and mark.text == "A"]


@pytest.mark.parametrize("name", ["ec120b", "face-gear-split-torque", "in-line-h2", "off-set-h2"])
def test_the_sheet_of_the_housing_cuts_the_metal_that_is_there(name):
    """Also where the arrangement has no true section: the plane goes through the first axis and most of the others."""
    scene = gw.scene(sized(name))
    casing = casing_of(sized(name), scene)
    rectangles = [one for cut in casing.section.cuts for one in cut.rectangles]
    bosses = [node for node in scene.nodes if "boss of" in node.name or ", collar " in node.name]
    box = [pick(values) for values in zip(*((one.start, one.end, one.low, one.high) for one in rectangles), strict=True)
           for pick in (min, max)]  # fmt: skip
    rng = np.random.default_rng(11)
    metal = 0
    for x, y in zip(rng.uniform(box[0], box[3], 1500), rng.uniform(box[4], box[7], 1500), strict=True):
        point = np.array([x, *(casing.foot + y * casing.up)])
        if any(near(scene, node, point) for node in bosses):
            continue
        drawn = any(one.start < x < one.end and one.low < y < one.high for one in rectangles)
        if in_hole(casing.section, x, y):
            assert not drawn
            continue
        local = [((point - node.axes.origin) @ node.axes.turned, solid) for node, solid in casing.pieces]
        depth = max(depth_in(at[None], solid) for at, solid in local)
        assert drawn == (depth > 0.0), (x, y)
        metal += drawn
    assert metal > 30


@pytest.mark.parametrize("name", OWN)
def test_screws_stand_in_the_faces_of_flanges_as_far_apart_as_a_spanner_asks(name):
    sizing = sized(name)
    casing = casing_of(sizing, gw.scene(sizing))
    flanges = weighed_flanges(sizing)
    for _, half in casing.halves:
        places = screw_places(half, flanges.screws)
        for shift in (0.0, 0.55 * flanges.thread, -0.55 * flanges.thread):
            off = places - places.mean(axis=0)
            moved = places + shift * off / np.linalg.norm(off, axis=1)[:, None]
            points = np.column_stack([moved, np.full(len(places), half.span[1] / 2.0)])
            assert all(depth_in(point[None], half) > 0.0 for point in points)
        apart = np.linalg.norm(places - np.roll(places, 1, axis=0), axis=1)
        assert apart.max() < 6.5 * flanges.thread  # 5 d along the wall that is weighed, more along the face


def test_the_sheet_of_the_housing_says_what_is_weighed_and_how_axes_stand():
    """js7 of 213.669 mm, 23 µm; the whole length by its chambers; 46 screws M6 for a girth of 1.377 m, 5 d apart."""
    sizing = sized(BY_HAND)
    content = casing_content(sizing, coarse(sizing))
    grids = {grid.title: grid.rows for grid in content.grids}
    assert {row[4] for row in grids["Flanges [mm]"]} == {"46 x M6"} and len(grids["Flanges [mm]"]) == 3
    assert ("tail", "-79.231", "0") in grids["Axes along the first shaft [mm]"]
    mass = sum(item.total for item in complete_mass(sizing).parts
               if item.group == "housing" and item.part != "housing bolts")  # fmt: skip
    assert content.title.mass == f"{mass:.1f}"
    (sheet,) = [sheet for sheet in sheets(sizing, ["housing"]) if sheet.name == "housing"]
    said = [mark for mark in sheet.entities if isinstance(mark, Distance)]
    assert any(mark.text == "213.67 ±0.023" for mark in said)
    casing = casing_of(sizing, gw.scene(sizing))
    ends = [place for piece in casing.chambers for place in span_of(*piece)]
    assert any(math.isclose(mark.measured, MM * (max(ends) - min(ends)), rel_tol=1e-9) for mark in said)


def test_what_is_seen_from_the_first_end_hides_what_is_behind_it():
    """In-line: four chambers, of which the last lies behind wider ones, and one flange before an equal one."""
    sizing = sized("in-line-h2")
    casing = casing_of(sizing, gw.scene(sizing))
    radii = sorted({round(max(abs(point) for point in path.points)) for path in end_outlines(casing, 1.0)})
    outer = [solid.outer for _, solid in (*casing.chambers[:3], casing.halves[0])]
    wide = [MM * float(np.linalg.norm(loop, axis=1).max()) * math.cos(math.pi / 48.0) for loop in outer]
    assert all(min(abs(radius - each) for radius in radii) < 1.5 for each in wide)  # circles that sides touch
    last = MM * float(np.linalg.norm(casing.chambers[3][1].outer, axis=1).max()) * math.cos(math.pi / 48.0)
    assert min(abs(radius - last) for radius in radii) > 5.0


@pytest.mark.parametrize("name", ["ec120b", "in-line-h2", "off-set"])
def test_centre_lines_of_screws_run_through_both_halves_of_flanges(name):
    """At least one above and one below for every flange that the section meets."""
    section = casing_section(sized(name), coarse(sized(name)), positions(sized(name)))
    rectangles = [one for cut in section.cuts for one in cut.rectangles]
    assert len(section.screws) >= 4
    for start, end in section.screws:
        middle = (start + end) / 2.0 / MM
        for x in (middle.real - 2e-3, middle.real + 2e-3):
            cut = [any(one.start < x < one.end and one.low < y < one.high for one in rectangles)
                   for y in (middle.imag + side * 0.56 * section.thread / MM for side in (-1.0, 0.0, 1.0))]  # fmt: skip
            assert cut == [True, False, True]  # a clearance hole of 1.1 d


@pytest.mark.parametrize("name", ["off-set-h1", "off-set-h1-free", "off-set-h2"])
def test_the_section_goes_round_and_says_whose_bodies_its_legs_cut_elsewhere(name):
    """Distances from axes to legs by hand: the legs that do not hold an axis but come nearer than its largest gear."""
    sizing = sized(name)
    plane = positions(sizing)
    way, section = lanes(sizing, plane), casing_section(sizing, coarse(sizing), plane)
    for shaft, lying in plane.shafts.items():
        foot, height = np.array(sizing.arrangement.frames[shaft].origin[1:]), lying.origin.imag / MM
        reach = max(body.radius for body in sizing.arrangement.bodies if body.shaft == shaft)
        cut = False
        for leg in way[0].legs:
            steps = np.linspace(max(leg.low, -2.0), min(leg.high, 2.0), 8001)
            near = np.linalg.norm(leg.foot + steps[:, None] * leg.along - foot, axis=1)
            holds = np.linalg.norm(leg.foot + height * leg.along - foot) < 1e-6
            shown = holds and leg.low - reach < height < leg.high + reach
            cut |= bool(near.min() < reach - 1e-3 and not shown)
        assert cut == (shaft in section.crossed), shaft


def test_a_motor_in_line_with_another_shaft_lies_in_line_with_it():
    plane = positions(sized("off-set-h1"))
    assert abs(plane.shafts["motor"].origin.imag - plane.shafts["input"].origin.imag) < 1e-6
    assert plane.unfolded == ("second.right",)


@pytest.mark.parametrize("name", ["in-line-h2", "off-set-h1", "ravigneaux-automatic"])
def test_shafts_of_a_first_sizing_are_drawn_as_long_as_their_solids(name):
    sizing = sized(name)
    plane = positions(sizing)
    scene = gw.scene(sizing)
    for shaft, lying in plane.shafts.items():
        frame = sizing.arrangement.frames[shaft]
        ends = []
        for node in (node for node in scene.nodes if node.look == "shaft" and node.part.name == shaft):
            at = float((node.axes.origin - np.array(frame.origin)) @ np.array(frame.along))
            sense = float(node.axes.along @ np.array(frame.along))
            ends += [MM * (at + sense * z) for z, _ in scene.solids[node.surface].profile]
        assert not ends or (min(ends), max(ends)) == pytest.approx((lying.start, lying.end), abs=1e-6), shaft


@pytest.mark.parametrize("name", ["ec120b", "face-gear-split-torque", "off-set-h3"])
def test_the_view_from_the_second_end_has_the_outline_of_the_housing(name):
    """As wide and as high as the pieces of the scene; lines of bodies that it covers are dashed."""
    sizing = sized(name)
    scene = gw.scene(sizing)
    loops = [scene.solids[node.surface].outer for node in scene.nodes
             if node.look == "housing" and isinstance(scene.solids[node.surface], Chamber)]  # fmt: skip
    points = MM * np.concatenate(loops)
    lines, _ = seen_from_second_end(scene)
    box = extent(lines)
    assert (box[2] - box[0], box[3] - box[1]) == pytest.approx(tuple(np.ptp(points, axis=0)), abs=1e-6)
    (sheet,) = sheets(sizing, ["arrangement"])
    across = any(abs(frame.along.x) < 0.5 for frame in sizing.arrangement.frames.values())
    assert any(isinstance(mark, Path) and mark.layer is Layer.HIDDEN for mark in sheet.entities) == across


@pytest.mark.parametrize("name", OWN)
def test_the_view_from_the_first_end_stands_right_of_the_section_on_its_level(name):
    """First-angle projection (ISO 5456-2): as the symbol in the title block says."""
    (sheet,) = [sheet for sheet in sheets(sized(name), ["housing"]) if sheet.name == "housing"]
    titles = {mark.text: mark.at for mark in sheet.entities if isinstance(mark, Words)}
    assert titles["Section along the first shaft"].real < titles["From the first end"].real


def test_planets_stand_in_the_view_along_the_axis_with_their_distance():
    """In-line H2: 3 planets on 100.794 mm and 5 on 157.035 mm; pitch circles of suns and rings about the axis."""
    sizing = sized("in-line-h2")
    (sheet,) = sheets(sizing, ["arrangement"])
    circles = [mark for mark in sheet.entities if isinstance(mark, Arc) and mark.layer is Layer.PITCH]
    middle = max(circles, key=lambda circle: circle.radius).centre
    for carrier, count in zip(sizing.carriers, (3, 5), strict=True):
        far = [circle for circle in circles
               if abs(abs(circle.centre - middle) - MM * carrier.radius * sheet.scale) < 1e-4]  # fmt: skip
        assert len(far) == count
        said = [mark for mark in sheet.entities if isinstance(mark, Distance)]
        assert any(math.isclose(mark.measured, MM * carrier.radius, rel_tol=1e-6) for mark in said)
    assert len([circle for circle in circles if abs(circle.centre - middle) < 1e-6]) == 4


@pytest.mark.parametrize("name", ["off-set", "off-set-h1-free", "off-set-h2", "off-set-h3"])
def test_the_view_along_the_first_shaft_shows_where_an_unfolded_section_runs(name):
    """Its length is the height of the section; its corners are axes, in their order on the sheet; letters at both."""
    sizing = sized(name)
    plane = positions(sizing)
    _, covers = seen_from_second_end(gw.scene(sizing))
    way = cutting_way(sizing, plane, covers)
    section = casing_section(sizing, coarse(sizing), plane)
    high = max(one.high for cut in section.cuts for one in cut.rectangles)
    low = min(one.low for cut in section.cuts for one in cut.rectangles)
    long = sum(abs(other - one) for one, other in itertools.pairwise(way))
    assert long == pytest.approx(MM * (high - low), abs=1e-3)
    order = sorted(plane.shafts, key=lambda shaft: plane.shafts[shaft].origin.imag)
    axes = list(dict.fromkeys(tuple(round(MM * each, 2) for each in sizing.arrangement.frames[shaft].origin[1:])
                              for shaft in order))  # fmt: skip
    assert [(round(point.real, 2), round(point.imag, 2)) for point in way[1:-1]] == axes
    (sheet,) = sheets(sizing, ["arrangement"])
    said = [mark for mark in sheet.entities if isinstance(mark, Words) and mark.text in ("B", "B-B")]
    assert len([mark for mark in said if mark.layer is Layer.SYMBOL or mark.text == "B-B"]) == 3


def test_a_section_by_one_plane_or_one_that_steps_has_no_way_in_the_view_along_the_first_shaft():
    for name in ("ec120b", "in-line-h2"):
        sizing = sized(name)
        assert cutting_way(sizing, positions(sizing), seen_from_second_end(gw.scene(sizing))[1]) == ()


def test_ribs_as_far_aside_keep_their_order_whatever_rounding_says():
    """The rows above and below a section are drawn as they came on every processor."""
    from gearwright.render.drawings.casing_section import _apart

    low, high = (tuple(complex(x, y) for x, y in ((0, at), (1, at), (1, at + 1), (0, at + 1))) for at in (0, 5))
    for noise in (1e-18, -1e-18):
        assert [corners for _, corners in _apart({(-1.0,): (noise, low), (1.0,): (0.0, high)})] == [low, high]
