"""Solids are closed, their volumes those of closed forms, their outlines those of the tool."""

import math

import numpy as np
import pytest

import gearwright as gw
from gearwright.catalogue import housing_materials
from gearwright.errors import DesignError
from gearwright.identity import Kind
from gearwright.parts.bevel_geometry import BevelPair, bevel_way
from gearwright.parts.gears import (
    BasicRack,
    Blank,
    CylindricalGear,
    TransverseTooth,
    half_angle_at,
    outline_area,
    tooth_form,
    transverse_form,
)
from gearwright.shape import DETAILS, casing_masses, edges_of, scene, short_of, solid_masses
from gearwright.shape.casings import flange_screw
from gearwright.shape.chambers import (
    Chamber,
    End,
    Opening,
    chamber_surface,
    chamber_volume,
    depth_in,
    has_room,
    round_hole,
)
from gearwright.shape.solids import (
    Arm,
    Fastener,
    Outline,
    bevel_gear,
    disc_gear,
    face_wheel,
    fastener_surface,
    loop_of,
    plate,
    plate_form,
    ring_gear,
    stepped,
    surface_of,
)
from gearwright.shape.stands import triangles_of
from gearwright.shipped import shipped_designs
from gearwright.sizing.casing import screw_volume
from gearwright.sizing.mass import complete_mass
from gearwright.sizing.shafts import holders_of
from overlaps import overlaps
from shipped_work import sized

NAMES = shipped_designs()
FINE = DETAILS["fine"]


KINDS = ("ec120b", "face-gear-split-torque", "mixed-h1", "off-set-h3", "ravigneaux-automatic", "wolfrom-reducer")
"""Designs with every kind of solid: what finer cutting could open shows in them."""
CUT = [(name, "coarse") for name in NAMES] + [
    (name, detail) for name in KINDS for detail in DETAILS if detail != "coarse"
]


@pytest.mark.parametrize(("name", "detail"), CUT)
def test_every_solid_of_a_shipped_design_is_closed(name, detail):
    built = scene(sized(name), detail=detail)
    for label, surface in built.surfaces.items():
        edges = edges_of(surface)
        assert edges.open == 0, label
        solid = built.solids[label]
        if isinstance(solid, Chamber):  # a ball with a room inside, which openings join: each but the first a handle
            openings = sum(len(end.holes) if end else 1 for end in solid.ends) + len(solid.openings)
            assert edges.euler == 4 - 2 * openings, label
        elif isinstance(solid, Fastener):  # a ball each layer without a bore
            assert edges.euler == 2 * sum(not layer.bore for layer in solid.layers), label
        else:
            holes = 2 * len(solid.bores.middles) if solid.bores else 0
            assert edges.euler + holes in (0, 2), label  # a ring, or a shaft without a bore; each hole a handle
        assert surface.volume > 0.0, label
        assert np.allclose(np.linalg.norm(surface.normals, axis=1), 1.0), label


@pytest.mark.parametrize(("teeth", "shift"), [(12, 0.0), (15, 0.0), (20, 0.0), (60, 0.3), (18, 0.4)])
def test_a_spur_tooth_is_the_one_that_is_bent_in_the_stiffness_of_meshes(teeth, shift):
    radius, half = transverse_form(TransverseTooth(teeth, 1e-3, profile_shift=shift), fillet=20, flank=20)
    form = tooth_form(CylindricalGear(teeth, 1e-3, 0.01, profile_shift=shift))
    upright = form.height + form.root_radius * math.cos(form.root_half_angle)
    other = np.interp(radius, np.hypot(form.half_thickness, upright), np.arctan2(form.half_thickness, upright))
    # 400 points against 128, along the circle: below a tenth of a micrometre for a module of a millimetre.
    assert np.max(np.abs(other - half) * radius) < 1e-7


def test_a_helical_tooth_has_the_involute_of_its_transverse_section():
    tooth = TransverseTooth(31, 2e-3, math.radians(25.0), 0.2)
    gear = CylindricalGear(31, 2e-3, 0.02, math.radians(25.0), profile_shift=0.2)
    radius, half = transverse_form(tooth, fillet=4, flank=6)
    assert radius[0] == pytest.approx(gear.root_radius, abs=1e-12)
    assert half[4:] == pytest.approx([half_angle_at(gear, float(place)) for place in radius[4:]], abs=1e-12)


def test_the_fillet_of_a_helical_tooth_meets_its_involute_without_a_corner():
    """Both have one tangent where they meet: the fillet's last chord leans as the involute does."""
    radius, half = transverse_form(TransverseTooth(40, 2e-3, math.radians(30.0)), fillet=60, flank=60)
    slopes = np.diff(radius[54:66] * half[54:66]) / np.diff(radius[54:66])
    assert np.max(np.abs(np.diff(slopes))) < 0.15


def test_the_root_of_a_ring_is_cut_by_its_shaper():
    tooth = TransverseTooth(84, 1e-3, side=-1, shaper=21)
    radius, half = transverse_form(tooth, fillet=20, flank=20)
    assert radius[0] == pytest.approx(tooth.root_radius, rel=1e-12)
    assert np.all(np.diff(radius) < 1e-12)
    assert np.all(half >= tooth.half_angles(radius) - 1e-9)  # the fillet adds to the involute
    assert half[0] < math.pi / 84


def test_a_tip_that_is_too_narrow_for_its_rounding_is_refused():
    with pytest.raises(DesignError, match="too narrow"):
        transverse_form(TransverseTooth(30, 1e-3, rack=BasicRack(math.radians(25.0))), fillet=3, flank=3)


@pytest.mark.parametrize("beta", [0.0, 0.35])
def test_a_gear_has_the_volume_of_its_teeth_and_its_body(beta):
    tooth = TransverseTooth(40, 2e-3, beta)
    root = tooth.root_radius
    blank = Blank(root, 0.8 * root, 0.4 * root, 0.25 * root, 0.02, 0.006)
    levels = [(place, place * math.tan(beta) / tooth.pitch_radius) for place in np.linspace(-0.01, 0.01, 11)]
    form = transverse_form(tooth, fillet=16, flank=16)
    solid = surface_of(disc_gear(loop_of(form, 40), levels, blank), 720)
    teeth = 40 * 2.0 * np.trapezoid(form[1] * form[0], form[0]) + math.pi * root**2
    body = math.pi * ((0.8 * root) ** 2 - (0.4 * root) ** 2) * 0.014 + math.pi * (0.25 * root) ** 2 * 0.02
    # Straight lines between the points: circles of 720 corners lose 1e-5, teeth of 32 points and slices of 2 mm less
    # than 2e-5, the chord of the root's land 3e-4.
    assert solid.volume == pytest.approx(teeth * 0.02 - body, rel=5e-4)
    assert edges_of(solid) == (0, 0)
    assert solid.volume == pytest.approx(40 * outline_area(tooth) * 0.02 + math.pi * root**2 * 0.02 - body, rel=5e-4)


@pytest.mark.parametrize("holes", [3, 5, 6, 12])
@pytest.mark.parametrize("hub", [0.3, 0.7])
def test_holes_in_a_web_are_closed_and_no_face_folds_over_them(holes, hub):
    """Euler's number falls by 2 with every hole beside the bore; faces have the area of the web less the polygons."""
    tooth = TransverseTooth(40, 2e-3)
    root = tooth.root_radius
    blank = Blank(root, 0.85 * root, hub * root, 0.25 * root, 0.02, 0.006)
    loop, ends = loop_of(transverse_form(tooth, fillet=3, flank=4), 40), [(-0.01, 0.0), (0.01, 0.0)]
    for segments in (30, 60, 720):
        plain, bored = (
            surface_of(disc_gear(loop, ends, blank._replace(holes=count)), segments) for count in (0, holes)
        )
        assert edges_of(bored) == (0, -2 * holes)
        first, second, third = (bored.points[bored.triangles[:, k]] for k in range(3))
        areas = np.cross(second - first, third - first) / 2.0
        assert np.all(np.einsum("ij,ij->i", areas, bored.normals[bored.triangles[:, 0]]) > 0.0)
        taken = holes * math.pi * blank._replace(holes=holes).hole_radius ** 2 * 0.006
        near = 0.05 if segments < 720 else 5e-3  # polygons of 12 and of 180 corners; other circles differ a little, too
        if segments % holes == 0:
            assert plain.volume - bored.volume == pytest.approx(taken, rel=near)


def test_a_plate_that_is_left_whole_is_a_disc_less_its_holes():
    """π (100² − 20² − 3 · 12²) mm² · 8 mm, closed, with a hole for shafts and three for pins."""
    pins = [Arm(angle, 0.07, 0.02) for angle in (0.1, 2.2, 4.3)]
    body = plate(pins, Outline(0.1, 0.02, 1.0), 0.008, pin=0.012, segments=720)
    surface = surface_of(body, 720)
    volume = math.pi * (0.1**2 - 0.02**2 - 3 * 0.012**2) * 0.008
    assert surface.volume == pytest.approx(volume, rel=4e-4)  # chords of holes
    assert edges_of(surface) == (0, -6)  # χ = 2 − 2 · 4 holes
    blind = surface_of(plate(pins, Outline(0.1, 0.0, 1.0), 0.008, pin=0.012, segments=60), 60)
    assert edges_of(blind) == (0, -4)


@pytest.mark.parametrize("count", [3, 4, 5, 7])
@pytest.mark.parametrize("fill", [0.2, 0.3, 0.4])
def test_a_plate_with_equal_arms_is_the_same_at_each_and_balanced(count, fill):
    """Turned by one arm its outline falls on itself, and its middle is on the axis: rounding only."""
    turn = 2.0 * math.pi / count
    eyes = [Arm(turn * k + 0.1, 0.0772, 0.0203) for k in range(count)]
    bridges = [Arm(turn * (k + 0.5) + 0.1, 0.0824, 0.005, 0.04, is_round=False) for k in range(count)]
    body = plate([*eyes, *bridges], Outline(0.1, 0.02, fill), 0.008, pin=0.012, segments=24 * count)
    corners = body.sections[0].radius * np.exp(1j * body.sections[0].angle)
    turned = corners * np.exp(1j * turn)
    assert np.abs(turned[:, None] - corners[None, :]).min(axis=1).max() < 1e-12
    after = np.roll(corners, -1)
    areas = 0.5 * (np.conj(corners) * after).imag
    assert abs(np.sum(areas * (corners + after)) / 3.0 / np.sum(areas)) < 1e-12


@pytest.mark.parametrize("fill", [0.1, 0.35, 0.6, 0.9])
def test_a_plate_has_metal_all_around_its_pins_and_bridges_and_the_area_that_is_asked(fill):
    """Eyes of 22 mm on 70 mm and bridges of 12 × 20 mm: no ray ends within them; as much is left as they let."""
    angles = np.arange(3600) * (math.pi / 1800.0)
    eyes = [Arm(2.0 * math.pi * k / 3, 0.07, 0.022) for k in range(3)]
    bridges = [Arm(eye.angle + math.pi / 3.0, 0.075, 0.006, 0.055, is_round=False) for eye in eyes]
    outline = Outline(0.092, 0.025, fill)
    radii = plate_form([*eyes, *bridges], outline).radii(angles)
    around = np.exp(1j * angles)
    parts = [eye.radius * np.exp(1j * eye.angle) + eye.half * around for eye in eyes]
    parts += [np.array([x + 1j * y for x in (0.055, 0.075) for y in (-0.006, 0.006)]) * np.exp(1j * one.angle)
              for one in bridges]  # fmt: skip
    for points in parts:
        before = np.floor(np.angle(points) / angles[1] + 1e-9).astype(int)
        at = np.maximum(radii[before % 3600], radii[(before + 1) % 3600])  # rays of 0.1°
        assert np.all(np.abs(points) <= at * (1.0 + 2e-3))
    assert radii.max() <= outline.reach and radii.min() >= 1.05 * outline.bore - 1e-9
    left = np.mean(radii**2) / outline.reach**2 - (outline.bore / outline.reach) ** 2
    assert left == pytest.approx(fill, rel=2e-3) if fill > 0.2 else left > fill


def test_a_ring_has_the_volume_of_its_wall_and_its_teeth():
    tooth = TransverseTooth(90, 2e-3, side=-1, shaper=30)
    loop = loop_of(transverse_form(tooth, fillet=20, flank=20), 90)
    solid = surface_of(ring_gear(loop, [(-0.01, 0.0), (0.01, 0.0)], 0.1), 720)
    wall = math.pi * (0.1**2 - tooth.root_radius**2) * 0.02
    assert solid.volume == pytest.approx(wall + 90 * outline_area(tooth) * 0.02, rel=5e-4)


@pytest.mark.parametrize("side", [0, 1])
def test_bevel_teeth_fill_the_cones_of_their_blank(side):
    """Between root and tip cones, by Pappus about half of the space: teeth and gaps are alike on the pitch cone."""
    pair = BevelPair((14, 43), 9e-3, 0.06, math.radians(35.0))
    solid = surface_of(bevel_gear(pair, side, bevel_way(pair, side, 0.02), hand=1.0, fine=FINE), FINE.circle)
    assert edges_of(solid).open == 0
    height = pair.addenda[side] * pair.outer_cone_distance / pair.mean_cone_distance
    reach = pair.outer_diameters[side] / 2.0 + height * math.cos(pair.pitch_angles[side])
    assert solid.reach == pytest.approx(reach, rel=1e-9)


def test_a_face_gear_is_a_rack_on_its_pitch_cylinder():
    pinion = TransverseTooth(32, 1.6e-3)
    solid = surface_of(face_wheel(pinion, 124, width=0.02, bore=0.02, fine=FINE), FINE.circle)
    assert edges_of(solid) == (0, 0)
    assert solid.points[:, 2].min() == pytest.approx(-1.6e-3)


def test_a_shaft_has_the_volume_of_its_steps():
    solid = surface_of(stepped([(0.0, 0.1, 0.02), (0.1, 0.15, 0.03)], 0.01), 720)
    volume = math.pi * (0.1 * (0.02**2 - 0.01**2) + 0.05 * (0.03**2 - 0.01**2))
    assert solid.volume == pytest.approx(volume, rel=2e-5)  # of 720 corners
    assert edges_of(solid) == (0, 0)


NEAR = 5e-3
"""Of a mass, by which the solid may differ: straight lines between the points of flanks, spirals and plates [-]."""


def test_bosses_around_sized_bearings_weigh_what_is_drawn():
    sizing = sized("ec120b")
    built = scene(sizing, detail="coarse")
    bosses = [node for node in built.nodes if "boss of" in node.name]
    volume = sum(triangles_of(built.solids[node.surface], 720).volume for node in bosses)
    density = housing_materials()[sizing.design.housing.material].density
    weighed = next(item.each for item in complete_mass(sizing).parts if item.part == "housing bosses")
    assert len(bosses) == len(sizing.bearings) and volume * density == pytest.approx(weighed, rel=2e-4)


@pytest.mark.parametrize("name", ["star", "differential-hybrid", "ravigneaux-automatic"])
def test_bells_of_turning_rings_weigh_what_is_drawn(name):
    """On either side of their ring; of one shape with the section of the arrangement, the sizing's."""
    sizing = sized(name)
    built = scene(sizing, detail="coarse")
    (node,) = (node for node in built.nodes if node.look == "bell")
    volume = triangles_of(built.solids[node.surface], 720).volume
    weighed = next(item.each for item in complete_mass(sizing).parts if item.part == node.name)
    assert volume * sizing.design.shaft_material.density == pytest.approx(weighed, rel=2e-4)


@pytest.mark.parametrize("name", ["ec120b", "in-line-h2", "twin-engine-helicopter", "wind-turbine-5mw"])
def test_flanges_and_their_screws_weigh_what_is_drawn(name):
    sizing = sized(name)
    built = scene(sizing, detail="coarse")
    drawn, short = casing_masses(sizing, built), short_of(sizing, built)
    assert {"housing flanges", "housing bolts"} <= drawn.keys() - short.keys()
    for part, (solid, weighed) in drawn.items():
        assert solid < weighed if part in short else solid == pytest.approx(weighed, rel=5e-4), part


def test_a_screw_has_the_volume_that_is_weighed():
    """Of M10: head and nut of hexagons 16 mm wide, a shank of 40 mm, two washers."""
    surface = fastener_surface(flange_screw(0.01), 5000)
    assert surface.volume == pytest.approx(screw_volume(0.01), rel=1e-5)
    assert np.ptp(surface.points[:, 2]) == pytest.approx(0.0065 + 0.04)
    assert surface.reach == pytest.approx(0.01)


@pytest.mark.parametrize("name", NAMES)
def test_solids_of_shipped_designs_weigh_as_the_complete_mass_has_them(name):
    """Gears of every kind, shafts, carriers; planets of the helicopter have a given mass."""
    sizing = sized(name)
    given = {path.removesuffix(".mass") for path in sizing.given if path.endswith(".mass")}
    rows = solid_masses(sizing, scene(sizing, detail="smooth"))
    parts = len(sizing.gears) + len(sizing.shafts) + len(sizing.carriers)
    assert len(rows) == parts + sizing.design.housing.own
    for row in rows:
        if str(row.part) not in given:
            assert row.solid == pytest.approx(row.weighed or 0.0, rel=NEAR), row.part


@pytest.mark.parametrize("name", ["in-line-h2", "wolfrom-reducer", "face-gear-split-torque"])
def test_gears_of_a_preliminary_sizing_weigh_as_their_solids(name):
    """Planets on catalogue bearings, on what their load asks where none fits, and both wheels of a face gear."""
    sizing = gw.size(gw.at_level(gw.read(name), "preliminary"))
    for row in solid_masses(sizing, scene(sizing, detail="smooth")):
        if row.part.kind is Kind.GEAR:
            assert row.solid == pytest.approx(row.sized, rel=NEAR), row.part


def test_a_shaft_that_goes_through_others_is_weighed_as_long_as_it_is():
    """By hand: π/4 (d² − d_i²) ρ times what lies between the ends of its first and last piece, and of no other."""
    sizing = sized("geared-turbofan-star")
    (shaft,) = (one for one in sizing.shafts if one.name == "low-pressure")
    (row,) = (one for one in solid_masses(sizing, scene(sizing)) if one.part.name == shaft.name)
    section = math.pi / 4.0 * (shaft.diameter**2 - shaft.bore**2) * sizing.design.shaft_material.density
    bodies = [body for body in sizing.arrangement.bodies if body.shaft == shaft.name]
    ends = [body.origin.x + far for body in bodies for far in (0.0, body.direction.x * body.length)]
    assert row.weighed / section == pytest.approx(max(ends) - min(ends), abs=1e-3)
    assert row.weighed > 1.5 * shaft.mass


def test_a_chamber_has_the_volume_of_its_wall_and_of_plates_with_holes():
    """A square tube with walls of 10 mm and plates of 5 mm, one with a round and a square hole, one closed, by hand."""
    square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    hole = round_hole((0.04, 0.04), 0.02)
    ends = (End(0.005, (hole, 0.02 * square)), End(0.005, ()))
    chamber = Chamber(0.11 * square, 0.1 * square, (0.0, 0.3), ends)
    round_area = 48 * math.tan(math.pi / 48) * 0.02**2
    volume = 0.3 * (0.22**2 - 0.2**2) + 0.005 * (2 * 0.2**2 - round_area - 0.04**2)
    surface = chamber_surface(chamber)
    assert surface.volume == pytest.approx(volume, rel=1e-12) == chamber_volume(chamber)
    assert edges_of(surface) == (0, 0)
    places = np.array([[0.0, 0.0, 0.002], [0.04, 0.04, 0.002], [0.08, 0.0, 0.004], [0.0, 0.0, 0.1], [0.0, 0.0, 0.298]])
    depths = [depth_in(place[None], chamber) for place in places]
    assert depths == pytest.approx([0.0, 0.0, 0.001, 0.0, 0.003])


def test_a_shaft_square_to_a_wall_leaves_through_an_opening_in_its_side():
    """A square tube with walls of 10 mm, a hole of 30 mm through one, by hand; a side that is too small has none."""
    square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    opening = Opening(np.array([0.0, 1.0]), np.array([0.02, 0.0, 0.1]), 0.03)
    plain = Chamber(0.11 * square, 0.1 * square, (0.0, 0.3), (End(0.005, ()), None))
    assert has_room(plain, opening)
    assert not has_room(plain, opening._replace(middle=np.array([0.09, 0.0, 0.1])))
    assert not has_room(plain, opening._replace(middle=np.array([0.02, 0.0, 0.03])))
    chamber = plain._replace(openings=(opening,))
    surface, hole = chamber_surface(chamber), 48 * math.tan(math.pi / 48) * 0.03**2
    assert surface.volume == pytest.approx(chamber_volume(plain) - 0.01 * hole, rel=1e-12) == chamber_volume(chamber)
    assert edges_of(surface) == (0, 0)
    places = np.array([[0.02, 0.105, 0.1], [0.02, 0.105, 0.132], [0.02, -0.105, 0.1]])
    assert [depth_in(place[None], chamber) for place in places] == pytest.approx([0.0, 0.002, 0.005])


def test_the_mast_of_the_helicopter_leaves_its_housing():
    """Its chamber ends a wall above the upper bearing, 181 mm short of the mast; the cover lies in its hole."""
    sizing = sized("ec120b")
    built = scene(sizing, detail="coarse")
    chambers = [solid for solid in built.solids.values() if isinstance(solid, Chamber)]
    (chamber,) = (chamber for chamber in chambers if chamber.openings)
    (opening,) = chamber.openings
    mast = next(bearing for bearing in sizing.bearings if bearing.name == "mast-upper")
    cover = next(one for one in holders_of(sizing) if one.kind == "cover" and one.beside == mast.name)
    assert opening.radius == pytest.approx(cover.outer / 2.0 + 5e-4)
    frame = sizing.arrangement.frames["mast"]
    face = frame.origin.z + frame.along.z * (mast.position + mast.width / 2.0)
    wall = next(end.thickness for end in chamber.ends if end is not None)
    assert face - chamber.outer[:, 1].min() == pytest.approx(wall + 5e-4, abs=1e-4)


@pytest.mark.parametrize("name", ["ec120b", "in-line-h1-star", "in-line-h2", "off-set-h2", "twin-engine-helicopter"])
def test_nothing_that_turns_stands_in_the_housing(name):
    sizing = sized(name)
    built = scene(sizing, detail="coarse")
    assert sum(isinstance(built.solids[node.surface], Chamber) for node in built.nodes) > 4
    assert overlaps(sizing, built) == ()
