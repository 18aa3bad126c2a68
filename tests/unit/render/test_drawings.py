"""Technical drawings: their numbers are the sizing's, their DXF is sound, nothing on a sheet covers anything else."""

import io
import itertools
import math
import re
import sys
import xml.etree.ElementTree as ET

import ezdxf
import numpy as np
import pytest
from built_design import BORES, JOINTS, STEPS, built_sizing

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.particulars import particulars
from gearwright.parts.bevel_geometry import face_and_root
from gearwright.parts.gears import span_measurement, spanned_teeth
from gearwright.render.drawings.assembly_sheets import arrangement_content, housing_content, true_to
from gearwright.render.drawings.catalogue import contents, sheets
from gearwright.render.drawings.entities import (
    Arc,
    Corner,
    Distance,
    GeometricTolerance,
    Hatch,
    Layer,
    Path,
    Words,
    drawn,
    extent,
    frame_length,
    millimetres,
    runs,
    tolerance_frame,
    words_corners,
)
from gearwright.render.drawings.gear_view import hub_of
from gearwright.render.drawings.paper import SCALES, crossings, inside, segments, texts
from gearwright.render.drawings.positions import positions
from gearwright.render.drawings.shaft_sheet import hob_room
from gearwright.render.drawings.shaft_view import shaft_body
from gearwright.render.drawings.writers import sheet_document, sheet_dxf, sheet_svg
from gearwright.render.pages.report import DrawnSheet, sheets_page
from gearwright.shape.stands import cylindrical_gear, gear_of, hand_of
from gearwright.shipped import shipped_designs
from gearwright.sizing.mass import complete_mass, gear_blanks
from gearwright.sizing.mass.bodies import bevel_cones as bevel_pair
from gearwright.sizing.shafts import holders_of
from gearwright.spec import edited
from html_checks import stands_alone
from shipped_work import BY_HAND, coarse, sized, text_of


@pytest.fixture(scope="module")
def built():
    return built_sizing()


@pytest.fixture(scope="module")
def drawings(built):
    return {sheet.name: sheet for sheet in sheets(built)}


@pytest.fixture(scope="module")
def shipped():
    """Return the sheets of every shipped design, by its name."""
    return {name: sheets(sized(name)) for name in shipped_designs()}


@pytest.fixture(scope="module")
def every(drawings, shipped):
    """Return the sheets of the built train and of every shipped design."""
    return [*drawings.values(), *itertools.chain.from_iterable(shipped.values())]


def written(sheet):
    """Return a sheet as a reader of its DXF file finds it."""
    return ezdxf.read(io.StringIO(sheet_dxf(sheet)))


def measured(sheet):
    """Return what the linear DIMENSION entities of the written file measure [mm]."""
    found = written(sheet).modelspace().query("DIMENSION")
    return [float(each.get_measurement()) for each in found if each.dimtype == 0]


def words_of(sheet):
    """Return every text of a sheet, those of dimensions too."""
    yield from (mark for mark in drawn(sheet.entities) if isinstance(mark, Words))


def table(sheet):
    """Return the rows of a sheet's tooth data by their names: the third column."""
    rows = {}
    cells = [each for each in sheet.entities if isinstance(each, Words) and each.layer is Layer.TABLE]
    for one in cells:
        row = sorted((each for each in cells if abs(each.at.imag - one.at.imag) < 0.1), key=lambda each: each.at.real)
        if len(row) == 3:
            rows.setdefault(row[0].text, row[2].text)  # of a gear before those of splines
    return rows


AUDITED = ("ec120b", "face-gear-split-torque", "off-set-h3", "ravigneaux-automatic")
"""Designs whose sheets, with those of the built train, have everything that sheets are made of."""


def test_every_file_passes_the_audit_of_ezdxf(drawings):
    for sheet in (*drawings.values(), *(sheet for name in AUDITED for sheet in sheets(sized(name)))):
        audit = sheet_document(sheet).audit()
        assert (audit.errors, audit.fixes) == ([], []), sheet.name


def test_layers_are_named_by_content_with_the_widths_of_iso_128(drawings):
    document = written(drawings["arrangement"])
    for layer in Layer:
        assert document.layers.get(layer.name).dxf.lineweight == round(100 * layer.width)
    assert {each.dxf.layer for each in document.modelspace()} <= {layer.name for layer in Layer}
    assert document.layers.get("CENTRE").dxf.linetype == "CENTRE"


@pytest.mark.parametrize("name", list(STEPS))
def test_dimensions_of_a_shaft_measure_what_the_sizing_says(drawings, name):
    """Diameters, shoulders and bore, read back from the DXF file; teeth cover some steps of the engine's shaft."""
    values = measured(drawings[f"shaft-{name}"])
    covered = {"engine": {58.0}, "middle": {50.0}}.get(name, set())
    asked = {float(across) for _, _, across, _ in STEPS[name]} - covered
    asked |= {float(end) for _, end, _, seat in STEPS[name] if "pinion" not in seat} - {190.0, 240.0}
    asked |= {float(BORES[name]), float(STEPS[name][-1][1])}
    for value in asked:
        assert any(math.isclose(value, each, abs_tol=1e-6) for each in values), value


def _chained(sheet, shaft, end):
    """Return whether one or two lengths with tolerances lead from another end of a step to this one [mm]."""
    chained = [mark.measured for mark in sheet.entities if isinstance(mark, Distance) and mark.suffix]
    ways = [sign * each for each in (0.0, *chained) for sign in (-1.0, 1.0)]
    others = [1e3 * step.start for step in shaft.steps if abs(1e3 * step.start - end) > 1e-6]
    return any(math.isclose(end, other + one + two, abs_tol=1e-6) for other in others for one in ways for two in ways)


def test_dimensions_of_the_helicopter_gearbox_are_its_sizing():
    """Every diameter outside of teeth, every end of a step, every fillet of the shafts that were built."""
    sizing = sized(BY_HAND)
    found = {sheet.name: sheet for sheet in sheets(sizing, ["shaft"])}
    inside = {joint.part for joint in sizing.joints if joint.kind == "integral"}
    for shaft in sizing.built_shafts:
        sheet = found[f"shaft-{shaft.name}"]
        values = measured(sheet)
        seats = [step for step in shaft.steps if step.seat not in inside]
        last = 1e3 * shaft.steps[-1].end
        for value in (*(1e3 * step.diameter for step in seats), last):
            assert any(math.isclose(value, each, abs_tol=1e-6) for each in values), (shaft.name, value)
        for bearing in (each for each in sizing.bearings if each.shaft == shaft.name):
            ends = [1e3 * (bearing.position + side * bearing.bearing.width / 2.0) for side in (-1.0, 1.0)]
            for end in ends:
                told = any(math.isclose(end, each, abs_tol=1e-6) for each in values) or _chained(sheet, shaft, end)
                assert end < 1e-6 or told, bearing.name
        texts = {words.text for words in words_of(sheet)}
        outside = [
            each.fillet for each in shaft.sections if each.fillet and not any(part in each.place for part in inside)
        ]
        assert {f"R{millimetres(1e3 * each)}" for each in outside} <= texts


def test_dimensions_of_a_keyway_are_those_of_din_6885(drawings):
    """20 × 12 in a shaft of 66 mm: length 50, width 20, d − t_1 = 58.5; in the hub d + t_2 = 70.9."""
    values = measured(drawings["shaft-middle"])
    for value in (50.0, 20.0, 58.5):
        assert any(math.isclose(value, each, abs_tol=1e-6) for each in values), value
    assert any(math.isclose(70.9, each, abs_tol=1e-6) for each in measured(drawings["gear-helical.wheel"]))


def test_keyways_have_the_ends_of_their_keys(built):
    """Form A with round ones, form B with square ones: 5 mm of a gearbox that is drawn although it does not fit."""
    (slot,) = shaft_body(built, "middle").slots
    (square,) = shaft_body(sized("ec120b-as-reported"), "input").slots
    assert (slot.form, square.form) == ("A", "B")
    assert square.end - square.start == pytest.approx(5.0)
    texts = [words.text for sheet in sheets(sized("ec120b-as-reported"), ["shaft-input"]) for words in words_of(sheet)]
    assert any("DIN 6885-1, form B" in each for each in texts)


def test_dimensions_of_a_bevel_gear_are_its_cones(built, drawings):
    pair, sheet = bevel_pair(built, "bevel"), drawings["gear-bevel.wheel"]
    values = measured(sheet)
    tip = pair.outer_diameters[1] + 2.0 * pair.addenda[1] * math.cos(pair.pitch_angles[1]) * (
        pair.outer_cone_distance / pair.mean_cone_distance
    )
    for value in (pair.face_width, pair.outer_cone_distance, tip):
        assert any(math.isclose(1e3 * value, each, rel_tol=1e-9) for each in values), value
    assert float(table(sheet)["Pitch cone angle"].rstrip("°")) == pytest.approx(
        math.degrees(pair.pitch_angles[1]), abs=5e-5
    )


@pytest.mark.parametrize("side", [0, 1])
def test_every_angle_on_the_sheet_of_a_bevel_gear_is_one_of_its_cones_and_the_table_has_all_three(built, side):
    """Where a line would run through the text of an angle at every radius, the table has it alone."""
    for sizing in (built, sized(BY_HAND)):
        (sheet,) = sheets(sizing, [f"gear-bevel.{('pinion', 'wheel')[side]}"])
        pair = bevel_pair(sizing, "bevel")
        face, root = face_and_root(pair, side)
        cones = {"Pitch cone angle": pair.pitch_angles[side], "Face cone angle": face, "Root cone angle": root}
        for name, angle in cones.items():
            assert float(table(sheet)[name].rstrip("°")) == pytest.approx(math.degrees(angle), abs=5e-5), name
        drawn_angles = [each for each in written(sheet).modelspace().query("DIMENSION") if each.dimtype]
        for each in drawn_angles:
            assert any(math.isclose(float(each.get_measurement()), math.degrees(cone), abs_tol=1e-6)
                       for cone in cones.values())  # fmt: skip
    (wheel,) = sheets(sized(BY_HAND), ["gear-bevel.wheel"])
    cone = bevel_pair(sized(BY_HAND), "bevel").pitch_angles[1]
    angles = [float(each.get_measurement()) for each in written(wheel).modelspace().query("DIMENSION") if each.dimtype]
    assert any(math.isclose(math.degrees(cone), each, abs_tol=1e-6) for each in angles)


def test_the_text_of_a_dimension_is_its_measured_value(every):
    for sheet in every:
        for entity in sheet.entities:
            if isinstance(entity, Distance):
                assert entity.text == f"{entity.prefix}{millimetres(entity.measured)}{entity.suffix}"
                assert entity.measured > 0.0


def test_dxf_and_svg_show_the_same_numbers(drawings):
    """The text override of a DIMENSION keeps the measured value in place of <>."""
    sheet = drawings["shaft-middle"]
    given = {f"{each.prefix}<>{each.suffix}" for each in sheet.entities if isinstance(each, Distance)}
    assert {each.dxf.text for each in written(sheet).modelspace().query("DIMENSION")} == given
    texts = {
        "".join(each.itertext()) for each in ET.fromstring(sheet_svg(sheet)).iter("{http://www.w3.org/2000/svg}text")
    }
    assert {each.text for each in sheet.entities if isinstance(each, Distance)} <= texts


def test_an_svg_has_the_size_of_its_paper(drawings):
    for sheet in drawings.values():
        root = ET.fromstring(sheet_svg(sheet))
        assert root.get("width") == f"{sheet.size.width:g}mm"
        assert {each.get("id") for each in root.findall("{http://www.w3.org/2000/svg}g")} <= {
            each.name for each in Layer
        }


def apart(one, other):
    """Return True if a line parts two rectangles, each given by its corners."""
    for corners in (one, other):
        for edge in (corners[1] - corners[0], corners[2] - corners[0]):
            across = [[(point * edge.conjugate()).real for point in each] for each in (one, other)]
            if max(across[0]) <= min(across[1]) or max(across[1]) <= min(across[0]):
                return True
    return False


def inked(words):
    """Return the corners of the capitals of a text, without the room of descenders."""
    corners = list(words_corners(words))
    middle = sum(corners) / 4.0
    return [middle + 0.8 * (corner - middle) for corner in corners]


NO_NUMBER = re.compile(r"(?<![\w-])(?:nan|-?inf(?:inity)?)(?![\w-])", re.IGNORECASE)
"""What Python writes where a number is none, as a word of its own: also within points and lengths."""


def test_every_sheet_is_an_svg_whose_every_number_is_one(every):
    """Read as XML; its view is the paper, and each attribute of what is drawn and each text is free of nan and inf."""
    for sheet in every:
        root = ET.fromstring(sheet_svg(sheet))
        left, top, width, height = map(float, root.get("viewBox").split())
        assert (left, top, width, height) == (0.0, 0.0, sheet.size.width, sheet.size.height) and min(
            width, height
        ) > 0.0
        said = [text for each in root.iter() for text in (*each.attrib.values(), each.text or "", each.tail or "")]
        assert not [text for text in said if NO_NUMBER.search(text)], sheet.name
        assert sum(1 for _ in root.iter()) > 20, sheet.name


def test_no_number_is_seen_in_points_and_words():
    assert all(map(NO_NUMBER.search, ("1,nan 2,3", "M nan 2", "inf", "-inf", "d = NaN mm")))
    assert not any(map(NO_NUMBER.search, ("info", "nano", "infeed", "1,2 3,4")))


def test_every_part_of_every_shipped_design_has_its_sheet_and_the_page_shows_them_all(shipped):
    """Arrangement, shafts, gears that are no one piece with theirs, carriers; each name is one sheet's alone."""
    for name, its in shipped.items():
        sizing, found = sized(name), [sheet.name for sheet in its]
        assert len(found) == len(set(found)) and found[0] == "arrangement", name
        assert {f"shaft-{shaft.name}" for shaft in sizing.built_shafts if shaft.steps} <= set(found), name
        assert {f"carrier-{carrier.stage}" for carrier in sizing.carriers} <= set(found), name
        integral = {joint.part for joint in sizing.joints if joint.kind == "integral"}
        for gear in {gear.name for gear in sizing.gears} - integral:
            assert any(each == f"gear-{gear}" or each.startswith(f"gear-{gear}-") for each in found), (name, gear)
        rows = [DrawnSheet(one.name, one.name, one.size.name, "1:1", sheet_svg(one, f"{one.name}-")) for one in its]
        page = sheets_page(particulars(sizing), rows)
        stands_alone(page)
        ids = re.findall(r' id="?([^"> ]+)', page)
        assert len(ids) == len(set(ids)), name
        assert page.count("<svg") >= len(its) and all(f">{each}<" in page for each in found), name


def test_no_text_covers_another(every):
    for sheet in every:
        boxes = [(words.text, inked(words)) for words in words_of(sheet)]
        for k, j in meeting([box for _, box in boxes]):
            (text, one), (other, two) = boxes[k], boxes[j]
            assert apart(one, two), f"{sheet.title}: {text!r} and {other!r}"


def meeting(boxes):
    """Return the pairs of turned rectangles whose upright boxes meet: no others can cover each other."""
    corners = np.array(boxes)
    both = np.triu(np.ones((len(boxes), len(boxes)), dtype=bool), 1)
    for part in (corners.real, corners.imag):
        low, high = part.min(axis=1), part.max(axis=1)
        both &= (low[:, None] < high) & (low < high[:, None])
    return np.argwhere(both).tolist()


def test_no_line_runs_through_a_text(every):
    """Outlines, leaders, pitch circles, dimension and extension lines; hatching is parted around text."""
    crossed = set()
    for sheet in every:
        lines = np.array(list(segments(sheet.entities)))
        boxes = boxes_of(lines)
        for words in texts(sheet.entities):
            if crossings(words, lines[near(words, boxes)].tolist()):
                crossed.add((sheet.title, words.text))
    assert crossed == set()


def boxes_of(lines):
    """Return left, right, low and high of lines, each an array."""
    return [pick(part(lines), axis=1) for part in (np.real, np.imag) for pick in (np.min, np.max)]


def near(words, boxes):
    """Return which lines come within 1 mm of the box of a text: no other one can run through it."""
    left, right, low, high = boxes
    corners = list(words_corners(words))
    across, up = ([part(corner) for corner in corners] for part in (np.real, np.imag))
    return (left < max(across) + 1.0) & (right > min(across) - 1.0) & (low < max(up) + 1.0) & (high > min(up) - 1.0)


def test_a_line_through_letters_is_seen_and_one_beside_them_is_not():
    """Capitals of 3.5 mm on a base line at 0; the box of a line with descenders is 4.375 mm high, its ink 3.5 mm."""
    words = Words(0j, "Ra 0.8", 3.5)
    end = words.length
    assert crossings(words, [(complex(-5.0, 1.5), complex(end + 5.0, 1.5))]) == 1
    assert crossings(words, [(complex(end / 2.0, -9.0), complex(end / 2.0, 9.0)), (complex(1.0, 1.0), 2 + 2j)]) == 2
    assert crossings(words, [(complex(-5.0, -0.6), complex(end, -0.6)), (complex(-0.1, -9.0), complex(-0.1, 9.0))]) == 0
    turned = Words(0j, "Ra 0.8", 3.5, turn=math.pi / 2.0)
    assert crossings(turned, [(complex(-9.0, end / 2.0), complex(9.0, end / 2.0))]) == 1


def test_everything_stands_on_its_paper_in_a_scale_of_iso_5455(every):
    for sheet in every:
        left, low, right, high = extent(sheet.entities)
        assert left > 0.0 and low > 0.0 and right < sheet.size.width and high < sheet.size.height
        frame = inside(sheet.size)
        box = extent([each for each in sheet.entities if isinstance(each, Distance | Corner)] or sheet.entities)
        if any(isinstance(each, Distance | Corner) for each in sheet.entities):
            assert frame[0] < box[0] and frame[1] < box[1] and box[2] < frame[2] and box[3] < frame[3]
        assert sheet.scale in SCALES


def test_the_tooth_table_says_what_is_cut_and_measured(built, drawings):
    """Span with allowances by ISO/TR 10064-2 for class 5: least backlash 2/3 (0.06 + 0.0005 a + 0.03 m_n) mm."""
    gear = gear_of(built, "helical.pinion")
    teeth, rows = cylindrical_gear(built, gear), table(drawings["shaft-engine"])
    assert rows["Number of teeth"] == "27"
    assert float(rows["Reference diameter"]) == pytest.approx(2e3 * teeth.pitch_radius, abs=5e-4)
    assert float(rows["Root diameter"]) == pytest.approx(2e3 * teeth.root_radius, abs=5e-4)
    span = 1e3 * span_measurement(teeth, spanned_teeth(teeth))
    assert float(rows["Span without backlash"]) == pytest.approx(span, abs=5e-4)
    upper, lower = (float(each.replace("−", "-")) for each in rows["Allowances of the span"].split(" / "))
    least = 2.0 / 3.0 * (0.06 + 0.0005 * float(rows["Centre distance"]) + 0.03 * float(rows["Normal module"]))
    assert upper == pytest.approx(-least / 2.0, abs=6e-4) and lower < upper
    assert rows["Mating gear"] == "helical.wheel, z = 107"
    assert rows["Flank tolerance class"] == "5 ISO 1328-1"


def test_mating_gears_have_opposite_hands(built):
    """Parallel axes and bevel pairs alike (ISO 21771, ISO 23509)."""
    for pinion, wheel in (("helical.pinion", "helical.wheel"), ("bevel.pinion", "bevel.wheel")):
        gears = [gear_of(built, name) for name in (pinion, wheel)]
        hands = [hand_of(built, gear, gear.shafts[0]) for gear in gears]
        assert None not in hands and hands[0] is not hands[1]


def test_the_axes_of_a_bevel_pair_meet_in_the_common_apex(built):
    """Both mean points lie R_m from it, on axes that are square to each other."""
    found, pair = positions(built), bevel_pair(built, "bevel")
    pinion, wheel = found.shafts["middle"], found.shafts["mast"]
    reach = [1e3 * pair.mean_cone_distance * math.cos(angle) for angle in pair.pitch_angles]
    apexes = [
        lying.at(found.places[shaft][gear] + far)
        for lying, shaft, gear, far in (
            (pinion, "middle", "bevel.pinion", reach[0]),
            (wheel, "mast", "bevel.wheel", reach[1]),
        )
    ]
    assert abs(apexes[0] - apexes[1]) < 1e-9
    assert abs((pinion.along * wheel.along.conjugate()).real) < 1e-12


def test_the_arrangement_lists_every_part_and_shows_the_centre_distance(built, drawings):
    sheet = drawings["arrangement"]
    texts = {words.text for words in words_of(sheet)}
    assert {"Shaft mast", "Gear bevel.wheel", "Bearing 2a", "QJ 312", "with helical.pinion"} <= texts
    distance = sum(gear_of(built, f"helical.{role}").pitch_diameter for role in ("pinion", "wheel")) / 2.0
    assert any(math.isclose(1e3 * distance, each, rel_tol=1e-9) for each in measured(sheet))


def test_a_shaft_weighs_what_is_cut_from_its_piece():
    """Parts, bearings left out, weigh what the gearbox weighs; within the three digits of the list."""
    sizing = sized(BY_HAND)
    grid, axes = arrangement_content(sizing, coarse(sizing)).grids
    assert {row[0] for row in axes.rows} == {"input", "intermediate", "mast", "tail"}
    parts = [row for row in grid.rows if row[2].startswith(("Shaft", "Gear"))]
    assert len(parts) == 6
    groups = {group.group: group.total for group in complete_mass(sizing).groups}
    drawn = groups["gears"] + groups["shafts"]
    assert sum(int(row[1]) * float(row[4]) for row in parts) == pytest.approx(drawn, rel=2e-3)


def test_a_bevel_wheel_has_a_hub_as_long_as_its_seat_on_the_shaft():
    """Seat: the step of the mast that carries the wheel; its place from the apex: cone distance and pitch angle."""
    sizing = sized(BY_HAND)
    wheel, (mast,) = gear_of(sizing, "bevel.wheel"), [each for each in sizing.built_shafts if each.name == "mast"]
    (seat,) = [step for step in mast.steps if step.seat == "bevel.wheel"]
    hub, pair = hub_of(sizing, wheel, "mast"), bevel_pair(sizing, "bevel")
    assert hub.boss.end - hub.boss.start == pytest.approx(1e3 * (seat.end - seat.start), rel=1e-9)
    apex = 1e3 * pair.mean_cone_distance * math.cos(pair.pitch_angles[1])
    (sheet,) = sheets(sizing, ["gear-bevel.wheel"])
    for value in (1e3 * (seat.end - seat.start), 1.4 * hub.reach, apex + hub.boss.start):
        assert any(math.isclose(value, each, rel_tol=1e-9) for each in measured(sheet)), value
    assert hub_of(sizing, gear_of(sizing, "helical.wheel"), "intermediate").boss is None


def test_a_bevel_wheel_drawn_into_a_bearing_is_named_on_the_arrangement():
    """The mast's lower bearing, 4 mm nearer to a wheel whose back clears it by 3.2 mm."""
    design = gw.parse(text_of(BY_HAND))
    near = edited(design, {"bearings.mast-lower.position_mm": 29.0})
    said = [
        [note for note in arrangement_content(gw.size(each), coarse(gw.size(each))).notes if "elsewhere" in note]
        for each in (design, near)
    ]
    assert said == [
        [],
        ["bevel.wheel and mast-lower stand 0.822 mm into each other, bevel.wheel blank: put one of them elsewhere."],
    ]


def test_what_is_not_sized_is_not_drawn_and_the_sheet_says_so():
    texts = {sheet.name: " ".join(words.text for words in words_of(sheet)) for sheet in sheets(sized("off-set"))}
    assert "First sizing: one cylinder" in texts["shaft-left"]
    assert "No bearings, shoulders and joints are sized" in texts["arrangement"]
    assert "Unfolded: second.right" in texts["arrangement"]
    assert "no class" in texts["gear-second.wheel"]


def test_axes_that_no_plane_holds_are_seen_from_their_ends_too():
    """Off-set: two layshafts beside the input, the output below; centres of pitch circles are the sizing's axes."""
    sizing = sized("off-set")
    (sheet,) = sheets(sizing, ["arrangement"])
    circles = {arc.centre for arc in sheet.entities if isinstance(arc, Arc) and arc.layer is Layer.PITCH}
    axes = {shaft.name: complex(*shaft.axis) for shaft in sizing.shafts}
    apart = {abs(one - other) / sheet.scale for one, other in itertools.combinations(circles, 2)}
    for one, other in itertools.combinations(axes.values(), 2):
        assert any(math.isclose(1e3 * abs(one - other), each, abs_tol=1e-4) for each in apart)


def test_an_integral_gear_is_on_the_sheet_of_its_shaft(drawings):
    assert "gear-helical.pinion" not in drawings
    assert "Tooth data: helical.pinion" in {words.text for words in words_of(drawings["shaft-engine"])}


def test_fits_stand_in_a_table_with_their_deviations(drawings):
    """ISO 286-2: 45 k6 has +18/+2 µm, 45 m6 +25/+9."""
    texts = [words.text for words in words_of(drawings["shaft-engine"])]
    assert texts[texts.index("Ø45 m6", texts.index("Fit")) :][:3] == ["Ø45 m6", "+25", "+9"]
    assert texts[texts.index("Ø45 k6", texts.index("Fit")) :][:3] == ["Ø45 k6", "+18", "+2"]


def test_joints_stand_with_their_designations(drawings):
    shown = {words.text for sheet in drawings.values() for words in words_of(sheet)}
    assert {row[4] for row in JOINTS if row[4]} <= shown
    assert any("DIN 5480 - N 100 x 3 x 32" in text for text in shown)


@pytest.mark.parametrize("name", shipped_designs())
def test_every_gear_has_a_sheet_with_its_tooth_data_and_sheets_agree(name):
    """Its own, or that of the shaft that it is one piece with; a bevel pinion stands on both, with the same rows."""
    sizing = sized(name)
    told = {}
    for content in contents(sizing, coarse(sizing)):
        for grid in content.grids:
            if grid.title.startswith("Tooth data: "):
                told.setdefault(grid.title.removeprefix("Tooth data: "), []).append((content.name, grid.rows))
    assert told.keys() == {gear.name for gear in sizing.gears}
    for gear, listed in told.items():
        shafts = {rows for sheet, rows in listed if sheet.startswith("shaft-")}
        own = [rows for sheet, rows in listed if sheet.startswith("gear-")]
        assert all(rows in own for rows in shafts) or not own, gear


def test_seats_of_bearings_run_out_by_half_of_it5_against_both_radial_ones():
    """IT5 of 60 and of 75 mm is 13 µm (ISO 286-1:2010, table 1); the mast's tapers are its radial bearings."""
    sheet = next(sheet for sheet in sheets(sized(BY_HAND), ["shaft-mast"]))
    texts = [words.text for words in words_of(sheet)]
    assert texts.count("0.0065") == 2
    assert texts.count("A") == texts.count("B") == 2 + 1  # at the frame's edges, and the datum
    (first,) = [seat for seat in sized(BY_HAND).bearings if seat.name == "mast-lower"]
    (wide,) = [mark for mark in sheet.entities if isinstance(mark, Distance) and mark.text == "Ø60 m6"]
    assert wide.measured == pytest.approx(1e3 * first.bearing.bore)
    letter = next(words for words in words_of(sheet) if words.text == "A" and words.layer is Layer.SYMBOL)
    assert letter.at.real == pytest.approx(wide.first.real)  # in line with the dimension: the axis of the seat
    assert letter.at.imag < min(wide.first.imag, wide.second.imag)


def test_a_first_sizing_has_no_datums_and_a_bored_gear_has_its_bore():
    plain = {sheet.name: sheet for sheet in sheets(sized("in-line-h2"))}
    assert not any(words.text == "A–B" for words in words_of(plain["shaft-input"]))
    wheel = sheets(sized(BY_HAND), ["gear-helical.wheel"])[0]
    texts = [words.text for words in words_of(wheel)]
    assert "0.025" in texts  # IT5 of 348.73 mm, the root diameter (ISO 286-1:2010, table 1)


def test_a_spline_stands_with_its_data():
    """DIN 5480 - W 78 × 3 × 24: d_a1 = d_B − 0.2 m, d_f1 = d_B − 2.3 m hobbed, x = (d_B − m z − 1.1 m)/(2 m)."""
    sheet = sheets(sized(BY_HAND), ["shaft-mast"])[0]
    rows = table(sheet)
    assert (rows["Tip diameter"], rows["Root diameter, hobbed"]) == ("77.4", "71.1")


def test_a_file_is_the_same_each_time(drawings):
    for sheet in drawings.values():
        assert sheet_dxf(sheet) == sheet_dxf(sheet)


def test_crossed_axes_are_seen_along_the_first_shaft_too():
    """EC120B: pitch circles about input, intermediate and tail at their true places; the mast upright across them."""
    sizing = sized(BY_HAND)
    (sheet,) = sheets(sizing, ["arrangement"])
    circles = {arc.centre for arc in sheet.entities if isinstance(arc, Arc) and arc.layer is Layer.PITCH}
    frames = sizing.arrangement.frames
    axes = {name: complex(*frames[name].origin[1:]) for name in ("input", "intermediate", "tail")}
    # Upside down in space, as the mast's second end is drawn above its first one.
    apart = {(one - other) / sheet.scale for one, other in itertools.permutations(circles, 2)}
    for one, other in itertools.permutations(axes.values(), 2):
        assert any(abs(-1e3 * (one - other) - each) < 1e-4 for each in apart)
    wheel = [body for body in sizing.arrangement.bodies if str(body.part) == "bevel.wheel"]
    wide = 2e3 * max(body.radius for body in wheel) * sheet.scale
    box = extent([mark for mark in sheet.entities if isinstance(mark, Path) and mark.layer is Layer.HIDDEN])
    assert math.isclose(box[2] - box[0], wide, abs_tol=1e-6)  # within the housing, dashed


def test_bores_of_the_housing_have_their_bearings_sizes_and_what_they_must_keep():
    sizing = sized(BY_HAND)
    (sheet,) = sheets(sizing, ["housing-bores"])
    values = measured(sheet)
    for bearing in sizing.bearings:
        assert any(math.isclose(1e3 * bearing.outer_diameter, value, rel_tol=1e-9) for value in values), bearing.name
    first = min(bearing.position - bearing.width / 2.0 for bearing in sizing.bearings if bearing.shaft == "mast")
    last = max(bearing.position + bearing.width / 2.0 for bearing in sizing.bearings if bearing.shaft == "mast")
    assert any(math.isclose(1e3 * (last - first), value, rel_tol=1e-9) for value in values)
    texts_of = [mark.text for mark in words_of(sheet)]
    # Two radial bores a shaft are datums, the four-point bearings' are none: A to H.
    rows = {row[1]: row[3] for row in housing_content(sizing).grids[0].rows}
    assert "".join(rows.values()) == "ABCDEFGH" and not rows["input-axial"] and not rows["intermediate-axial"]
    # IT6 of 52 mm: 19 µm coaxial to A; js7 of 213.669 mm: IT7, 46 µm, to the axis A-B.
    assert {"Ø0.019", "Ø0.046"} <= set(texts_of)
    assert true_to(sizing, "input") is None
    # IT6 of the 295 mm between the mast's bearings, 32 µm, square to the axis of the bevel pinion.
    assert true_to(sizing, "mast") == GeometricTolerance("perpendicularity", pytest.approx(0.032), "intermediate")
    assert true_to(sizing, "tail") == GeometricTolerance("position", pytest.approx(0.030), "input")


def test_a_frame_has_the_symbol_its_zone_and_its_datums():
    for what, circles in (("coaxiality", 2), ("position", 1), ("flatness", 0), ("perpendicularity", 0)):
        marks = tolerance_frame(0j, GeometricTolerance(what, 0.02, "" if what == "flatness" else "A"))
        assert len([mark for mark in marks if isinstance(mark, Arc)]) == circles
        words = [mark.text for mark in marks if isinstance(mark, Words)]
        assert words == [("Ø0.02" if circles else "0.02"), *([] if what == "flatness" else ["A"])]
        assert extent(marks)[2] == pytest.approx(
            frame_length(GeometricTolerance(what, 0.02, "" if what == "flatness" else "A"))
        )


def test_a_groove_is_dimensioned_on_the_sheet_of_its_shaft():
    """DIN 471 - 25 x 1.2: Ø23.9, 1.3 mm wide; its loaded side at 216.8 mm is 37.3 mm from the shoulder at 179.5 mm."""
    (sheet,) = sheets(sized(BY_HAND), ["shaft-input"])
    values = measured(sheet)
    for value in (23.9, 1.3, 216.8 - 179.5):
        assert any(math.isclose(value, each, rel_tol=1e-9) for each in values), value
    assert not any(math.isclose(each, 216.8, rel_tol=1e-9) for each in values)  # given once
    said = {mark.text for mark in sheet.entities if isinstance(mark, Distance)}
    assert {"37.3 H11", "1.3 H13", "Ø23.9 h12"} <= said


def test_lengths_between_shoulders_of_bearings_and_to_teeth_have_tolerances():
    """ISO 286-1:2010, table 1: IT9 of 257.5 mm is 130 µm, of 84.5 mm 87 µm, IT10 of 51 and of 69 mm 120 µm."""
    said = {
        name: {mark.text for mark in sheets(sized(BY_HAND), [name])[0].entities if isinstance(mark, Distance)}
        for name in ("shaft-mast", "shaft-tail")
    }
    assert "257.5 ±0.065" in said["shaft-mast"] and "301.5" not in said["shaft-mast"]
    assert {"84.5 ±0.043", "51 ±0.06", "69 ±0.06", "190"} <= said["shaft-tail"]


def test_shoulders_teeth_and_splines_run_out_against_the_axis_of_both_seats():
    """IT5 of 60 and 75 mm: 13 µm; IT7 of 78 and 71 mm: 30 µm; ISO 1328-1 of z = 88, m = 1, class 4: 12 µm."""
    texts_of = {name: [words.text for words in words_of(sheets(sized(BY_HAND), [name])[0])]
                for name in ("shaft-mast", "shaft-tail")}  # fmt: skip
    assert texts_of["shaft-mast"].count("0.013") == texts_of["shaft-mast"].count("0.03") == 2
    assert texts_of["shaft-mast"].count("A–B") == 2 + 2 + 2 and texts_of["shaft-mast"].count("PD") == 2
    d = 88.0 / math.cos(math.radians(12.0))
    runout = 0.9 * (0.002 * d + 0.55 * math.sqrt(d) + 0.7 + 12.0) / math.sqrt(2.0)
    assert texts_of["shaft-tail"].count(f"{1e-3 * round(runout):g}") == 1


def test_a_spline_that_a_hob_cannot_leave_is_to_be_shaped():
    """2 mm from W 78 x 3 to the collar; a hob of Ø60 leaves teeth 3.15 mm deep over √(3.15 · 56.85) = 13.4 mm."""
    said = {name: " ".join(words.text for words in words_of(sheets(sized(BY_HAND), [name])[0]))
            for name in ("shaft-mast", "shaft-intermediate")}  # fmt: skip
    assert "DIN 5480 - W 78 x 3 x 24: shaped, as 2 mm lie before the next shoulder" in said["shaft-mast"]
    assert "runs out over 13.4 mm" in said["shaft-mast"] and "shaped" not in said["shaft-intermediate"]
    (teeth,) = shaft_body(sized(BY_HAND), "intermediate").splines
    assert hob_room(shaft_body(sized(BY_HAND), "intermediate"), teeth) == pytest.approx(151.0 - 110.0)


def test_hardened_teeth_have_a_line_beside_them_and_say_what_stays_soft():
    """ISO 15787; 700 HV as rated, up to the 800 HV of ISO 6336-5; 0.15 to 0.2 of the module of 2 mm.

    What runs under the lip of a seal, 26.5 mm, is hardened with them.
    """
    (sheet,) = sheets(sized(BY_HAND), ["shaft-input"])
    lines = [mark for mark in sheet.entities if isinstance(mark, Path) and mark.layer is Layer.HARDENED]
    widths = sorted(abs(line.points[1] - line.points[0]) / sheet.scale for line in lines)
    assert widths == pytest.approx([18.0, 26.5, 36.0])
    rows = table(sheet)
    assert {"700 +100 HV, CHD 0.3 +0.1", "soft: kept from carburizing (assumed)"} <= {
        words.text for words in words_of(sheet)
    }
    assert rows
    (plain,) = sheets(sized(BY_HAND), ["shaft-mast"])  # its wheel is splined on
    assert not any(isinstance(mark, Path) and mark.layer is Layer.HARDENED for mark in plain.entities)


def test_a_keyway_says_how_deep_it_may_be_and_how_symmetric_it_stands():
    """DIN 6885-1 for 32 mm: 10 P9 wide, t_1 = 5 mm + 0.2 mm, left are 27 mm; half of IT9 of 10 mm: 18 µm."""
    (sheet,) = sheets(sized("ec120b-as-reported"), ["shaft-input"])
    said = {mark.text for mark in sheet.entities if isinstance(mark, Distance)}
    assert {"10 P9", "27 0/−0.2"} <= said
    assert "0.018" in {words.text for words in words_of(sheet)}


def test_an_undercut_is_named_in_its_place_and_drawn_ten_times_as_large_with_its_sizes():
    """DIN 509 - F 1.6 x 0.3: f = 4, t_1 = 0.3, t_2 = 0.2; also as the DXF file measures them."""
    (sheet,) = sheets(sized(BY_HAND), ["shaft-mast"])
    said = [words.text for words in words_of(sheet)]
    assert said.count("DIN 509 - F 1.6 x 0.3") == 2 + 1 and "R1.6" in said and "R1.25" not in said
    detail = [mark for mark in sheet.entities if isinstance(mark, Distance) and mark.scale == 10.0]
    assert sorted(mark.measured for mark in detail) == pytest.approx([0.2, 0.3, 4.0])
    found = written(sheet).modelspace().query("DIMENSION")
    factors = [each.override().get("dimlfac") for each in found]
    enlarged = [
        each for each, factor in zip(found, factors, strict=True) if factor == pytest.approx(sheet.scale / 10.0)
    ]
    read = sorted(float(each.get_measurement()) * sheet.scale / 10.0 for each in enlarged)
    assert read == pytest.approx([0.2, 0.3, 4.0])


def test_fillets_beside_teeth_stand_in_the_table_too():
    """The weakest section of the intermediate shaft: R2.5 at the small end of the bevel pinion."""
    (sheet,) = sheets(sized(BY_HAND), ["shaft-intermediate"])
    ec120b = sized(BY_HAND)
    (grid,) = [grid for content in contents(ec120b, coarse(ec120b)) if content.name == "shaft-intermediate"
               for grid in content.grids if grid.title == "Fillets at shoulders"]  # fmt: skip
    weakest = next(shaft for shaft in sized(BY_HAND).built_shafts if shaft.name == "intermediate").weakest
    assert f"R{millimetres(1e3 * weakest.fillet)}" in {row[0] for row in grid.rows}
    assert any(words.text == "R2.5" for words in words_of(sheet))


def test_holes_of_a_web_are_cut_by_the_section_and_told():
    """0.6 of what the chord of six leaves: Ø63.36 on Ø211.21; the web is dimensioned between hub and holes."""
    sizing = gw.size(edited(gw.parse(text_of(BY_HAND)), {"gears.web_holes": 6}))
    (sheet,) = sheets(sizing, ["gear-helical.wheel"])
    blank = gear_blanks(sizing)["helical.wheel"]
    across, circle = (millimetres(2e3 * size) for size in (blank.hole_radius, blank.hole_circle))
    said = " ".join(words.text for words in words_of(sheet))
    assert f"6 holes Ø{across} through the web on Ø{circle}" in said
    assert any(math.isclose(1e3 * blank.web_width, each, rel_tol=1e-9) for each in measured(sheet))
    (plain,) = sheets(sized(BY_HAND), ["gear-helical.wheel"])
    hatched = [len([mark for mark in each.entities if isinstance(mark, Hatch)]) for each in (plain, sheet)]
    assert hatched == [2, 4]


def test_a_first_sizing_has_no_sheet_of_bores():
    assert "housing-bores" not in {
        content.name for content in contents(sized("in-line-h2"), coarse(sized("in-line-h2")))
    }


def test_the_arrangement_shows_and_lists_what_holds_bearings():
    sizing = sized(BY_HAND)
    (sheet,) = sheets(sizing, ["arrangement"])
    said = [mark.text for mark in sheet.entities if isinstance(mark, Words)]
    for holder in holders_of(sizing):
        assert f"{holder.mass:.3g}" in said, holder.name
    assert said.count("Cover") == len([holder for holder in holders_of(sizing) if holder.kind == "cover"])
    assert {"DIN 471 - 25 x 1.2", "6 screws M8, 8.8", "screw M20, 8.8"} <= set(said)


def test_sheets_are_found_by_name_and_by_kind(built):
    assert [each.name for each in sheets(built, ("arrangement", "shaft-mast"))] == ["arrangement", "shaft-mast"]
    assert len(sheets(built, ("gear",))) == 3
    with pytest.raises(DesignError, match=r"there is no sheet 'shaft-must'; did you mean shaft-mast\?"):
        sheets(built, ("shaft-must",))


def test_without_ezdxf_the_message_names_the_package(drawings, monkeypatch):
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(DesignError, match="pip install ezdxf"):
        sheet_dxf(drawings["arrangement"])


def test_an_index_is_written_low():
    assert runs("m_{et}") == [("m", False), ("et", True)]
