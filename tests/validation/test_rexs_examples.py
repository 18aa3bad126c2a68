"""Public gearboxes in REXS as designs: what their files print comes out, and everything runs on them.

Files and their sources: tests/rexs/README.md. None of them states a safety S_H or S_F.
"""

import math
import re
from xml.etree import ElementTree

import numpy as np
import pytest

import gearwright as gw
from rexs_database import EXAMPLES

GEARBOXES = {"fva_2stage_1.4": 2, "fva_planetary_1.1": 6, "sew_3stage_1.0": 3}
"""File -> how many stages it has."""
SHIFT = 1e-12
"""Shifts are those of the file, not those that would close the centre distance."""


@pytest.fixture(scope="module", params=GEARBOXES)
def gearbox(request):
    """Return an example: its name, what was read, its sizing, and the file itself, read by another reader."""
    path = EXAMPLES / f"{request.param}.rexs"
    read = gw.from_rexs(path)
    return request.param, read, gw.size(read.design), ElementTree.parse(path).getroot()


def printed(component, name):
    """Return the number that a file prints, without a thought of its unit."""
    found = [float(attribute.text) for attribute in component if attribute.get("id") == name]
    return found[0] if found else None


def stages(root):
    """Yield both gears of every stage of a file, with the stage."""
    parts = {component.get("id"): component for component in root.iterfind("components/component")}
    for relation in root.iterfind("relations/relation"):
        if relation.get("type") == "stage":
            ends = {ref.get("role"): parts[ref.get("id")] for ref in relation}
            yield ends["stage"], ends["gear_1"], ends["gear_2"]


def flanks(root, gear):
    parts = {component.get("id"): component for component in root.iterfind("components/component")}
    for relation in root.iterfind("relations/relation"):
        ends = {ref.get("role"): ref.get("id") for ref in relation}
        if relation.get("type") == "flank" and ends["gear"] == gear.get("id"):
            yield from (parts[ends["left"]], parts[ends["right"]])


def test_all_eleven_stages_are_meshes_of_the_design(gearbox):
    name, _, sizing, root = gearbox
    assert sum(mesh.count for mesh in sizing.meshes) == GEARBOXES[name] == len(list(stages(root)))


def test_teeth_modules_widths_distances_and_ratios_are_those_that_the_file_prints(gearbox):
    """Of every stage; the width of a mesh is the smaller one of its gears."""
    _, _, sizing, root = gearbox
    gears = {gear.name: gear for gear in sizing.gears}
    ours = {
        (*sorted(gears[gear].teeth for gear in mesh.gears), round(1e6 * mesh.centre_distance)):
            (mesh, [gears[gear] for gear in mesh.gears]) for mesh in sizing.meshes
    }  # fmt: skip
    for stage, *pair in stages(root):
        teeth, distance = (
            sorted(int(printed(gear, "number_of_teeth")) for gear in pair),
            printed(stage, "center_distance"),
        )
        mesh, found = ours[(*teeth, round(1e3 * distance))]
        assert 1e3 * mesh.centre_distance == pytest.approx(distance, rel=1e-12)
        for gear in found:
            assert 1e3 * gear.module == pytest.approx(printed(pair[0], "normal_module"), rel=1e-12)
            assert 1e3 * gear.face_width == pytest.approx(min(printed(one, "face_width") for one in pair), rel=1e-12)
            assert math.degrees(gear.helix_angle) == pytest.approx(
                abs(printed(pair[0], "helix_angle_reference_diameter")), abs=1e-9
            )
        assert max(gear.teeth for gear in found) / min(gear.teeth for gear in found) == teeth[1] / teeth[0]


def test_profile_shifts_are_those_that_the_file_prints(gearbox):
    _, _, sizing, root = gearbox
    shifts = {gear.teeth: gear.profile_shift for gear in sizing.gears}
    tried = 0
    for _, *pair in stages(root):
        for gear in pair:
            for flank in flanks(root, gear):
                stated = printed(flank, "addendum_modification_coefficient")
                if stated is not None:
                    assert shifts[int(printed(gear, "number_of_teeth"))] == pytest.approx(stated, abs=SHIFT)
                    tried += 1
    assert tried >= 6


@pytest.mark.parametrize(
    ("name", "ratio"),
    [
        ("fva_2stage_1.4", 51 / 27 * 34 / 23),
        ("fva_planetary_1.1", 1 + 61 / 17),
        ("sew_3stage_1.0", 67 / 23 * 76 / 13 * 87 / 14),
    ],
)
def test_the_whole_ratio_is_that_of_the_teeth(name, ratio):
    sizing = gw.size(gw.from_rexs(EXAMPLES / f"{name}.rexs").design)
    speeds = [abs(sizing.reference.speeds[machine.shaft]) for machine in sizing.machines]
    assert max(speeds) / min(speeds) == pytest.approx(ratio, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "power", "speed"),
    [("fva_planetary_1.1", 250e3, 1500), ("sew_3stage_1.0", 4.724562306435156 * 1400 * math.pi / 30, 1400)],
)
def test_power_and_speed_are_those_of_the_driving_load(name, power, speed):
    """1591.55 N m at 1500 1/min are 250 kW."""
    (motor,) = gw.from_rexs(EXAMPLES / f"{name}.rexs").design.motors.values()
    assert motor.power == pytest.approx(power, rel=1e-12)
    assert motor.speed == pytest.approx(speed * math.pi / 30, rel=1e-12)


def test_the_load_spectrum_of_four_cases_becomes_four_cases():
    """567 N m at 543 1/min for 20 %, and so on, as the file prints."""
    design = gw.from_rexs(EXAMPLES / "fva_2stage_1.4.rexs").design
    assert [case.share for case in design.cases.values()] == pytest.approx([0.2, 0.3, 0.35, 0.15], rel=1e-12)
    ((name, _),) = design.motors.items()
    powers = [case.machines[name].power for case in design.cases.values()]
    expected = [t * n * math.pi / 30 for t, n in ((567, 543), (345, 3456), (456, 1234), (789, 789))]
    assert powers == pytest.approx(expected, rel=1e-12)


def test_modes_are_found_and_motion_is_simulated(gearbox):
    _, _, sizing, _ = gearbox
    for case in sizing.flows:
        system = gw.assemble(sizing, case)
        frequencies = gw.modes(system).frequency
        assert frequencies[0] == pytest.approx(0.0, abs=1e-3) and frequencies[1] > 1.0
    trace = gw.simulate(system, 1e-3)
    for name in trace.force.names:
        assert np.isfinite(trace.force.of(name)["maximum"]).all(), name


def test_what_was_not_read_is_listed_with_line_and_path(gearbox):
    """Some bearings are not read, and the list says so at the line of the first one."""
    name, read, _, _ = gearbox
    lines = (EXAMPLES / f"{name}.rexs").read_text(encoding="utf-8-sig").splitlines()
    said = next(entry for entry in read.not_read if re.search(r"bearing\[\d+\]( |$)|geometry\[\d+\]( |$)", entry))
    number = int(said[len("line ") : said.index(":")])
    assert 'type="concept_bearing"' in lines[number - 1] or 'type="rolling_bearing' in lines[number - 1]


def test_gears_and_bearings_sit_where_the_files_say():
    """By hand: SEW's pinion from 146 to 162 mm and its bearings as printed; FVA's gears at 72 and 180 mm."""
    sew = gw.from_rexs(EXAMPLES / "sew_3stage_1.0.rexs").design
    assert sew.layout["ANW-4"].places["Stirnradstufe.pinion"].position == pytest.approx(0.154, rel=1e-12)
    seats = {seat.designation: seat for seat in sew.bearings.values() if seat.shaft == "ANW-4"}
    assert {name: seat.position for name, seat in seats.items()} == pytest.approx({"6305": 0.0655, "6205": 0.1118})
    assert (seats["6305"].locates, seats["6205"].locates) == ("both", "none")
    assert (seats["6305"].dynamic_rating, seats["6305"].static_rating) == pytest.approx((22.4e3, 11.4e3), rel=1e-12)
    fva = gw.from_rexs(EXAMPLES / "fva_2stage_1.4.rexs").design
    places = [place.position for place in fva.layout["Shaft-25"].places.values()]
    assert places == pytest.approx([0.072, 0.180], rel=1e-12)
    assert [seat.locates for seat in fva.bearings.values()] == ["first", "second"]
