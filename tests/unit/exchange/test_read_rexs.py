"""REXS files as designs: round trips, what other tools have changed, and everything that can be wrong with a file."""

import re

import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.exchange.rexs import LARGEST
from gearwright.units import RPM
from mounted_designs import PAIR
from rexs_database import EXAMPLES
from shipped_work import sized

HEAD = '<model version="1.7" applicationId="x" applicationVersion="1" date="2026-01-01">'


def read(text, folder):
    path = folder / "gearbox.rexs"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return gw.from_rexs(path)


def without_own(content):
    """Return a file without the attributes of gearwright's own, as a tool would write it that does not keep them."""
    return re.sub(rb'<attribute id="custom_[^>]*>[^<]*</attribute>', b"", content)


def problems(text, folder):
    with pytest.raises(DesignError) as caught:
        read(text, folder)
    return caught.value.problems


def said(text, folder):
    return "\n".join(map(str, problems(text, folder)))


@pytest.fixture
def pair():
    """Return the plain file of a shipped design with two pairs."""
    return without_own(gw.to_rexs(sized("e-axle")).content).decode()


def test_bearings_and_places_come_back_from_what_rexs_itself_says(tmp_path):
    before = gw.parse(PAIR)
    after = read(without_own(gw.to_rexs(gw.size(before)).content), tmp_path).design
    for name, seat in before.bearings.items():
        again = after.bearings[name]
        assert (again.shaft, again.kind, again.locates, again.radial) == (
            seat.shaft,
            seat.kind,
            seat.locates,
            seat.radial,
        )
        assert again.position == pytest.approx(seat.position, rel=1e-12)
        assert again.designation in {bearing.designation for bearing in gw.size(before).bearings}
    (pinion,) = [place for name, place in after.layout["input"].places.items() if name.endswith(".pinion")]
    assert pinion.position == pytest.approx(0.090, rel=1e-9)


def test_bearings_with_which_nothing_can_be_sized_are_left_out_with_the_reason():
    """The gearbox of SEW has a shaft in three bearings, and a pinion cut into its shaft below the bearings' bore."""
    found = gw.from_rexs(EXAMPLES / "sew_3stage_1.0.rexs")
    assert {seat.shaft for seat in found.design.bearings.values()} == {"ANW-4", "ABW-54"}
    assert any("RW3-5 5 of 14 to 16 mm" in note and "layout.NAME" in note for note in found.assumed)
    assert any("3 radial bearings of RW5-36 are not read" in note for note in found.assumed)
    assert any("bearings of RW3-5 are not taken, for" in note and "root circle" in note for note in found.assumed)
    assert any("rolling_bearing_with_catalog_geometry[32] and 4 more" in entry for entry in found.not_read)


@pytest.mark.parametrize("design", gw.shipped_designs())
def test_every_shipped_design_that_goes_out_and_in_sizes_the_same(design, tmp_path):
    """To 1e-12: a design's numbers are written with 15 digits."""
    before, found = sized(design), read(gw.to_rexs(sized(design)).content, tmp_path)
    after = gw.size(found.design)
    assert after.teeth == before.teeth
    assert after.mass == pytest.approx(before.mass, rel=1e-12)
    for one, other in zip(before.meshes, after.meshes, strict=True):
        margins = (other.bending_margin, other.contact_margin, other.centre_distance)
        assert margins == pytest.approx((one.bending_margin, one.contact_margin, one.centre_distance), rel=1e-12)
    assert found.not_read == ()


BARE = sorted({*gw.shipped_designs()} - {"face-gear-split-torque"})
"""REXS has no face gears."""


@pytest.mark.parametrize("design", BARE)
def test_what_rexs_itself_says_is_enough_for_the_gears_of_pairs_and_planetary_sets(design, tmp_path):
    """Without the attributes of gearwright's own: every gear with its teeth, module, width and shift."""

    def gears(sizing):
        return sorted(
            (gear.teeth, *(round(value, 10) for value in (gear.module, gear.face_width, gear.profile_shift)))
            for gear in sizing.gears
            for _ in range(gear.bodies)
        )

    found = read(without_own(gw.to_rexs(sized(design)).content), tmp_path)
    assert gears(gw.size(found.design)) == gears(sized(design))


def test_what_another_tool_changed_is_taken_over(tmp_path):
    """Module, width, teeth and centre distance of a pair; all else stays as the design has it."""
    text = gw.to_rexs(sized("e-axle")).content.decode()
    gear = next(gear for gear in sized("e-axle").gears if gear.name == "first.pinion")
    old = f'<attribute id="face_width" unit="mm">{1e3 * gear.face_width:.15g}</attribute>'
    found = read(text.replace(old, '<attribute id="face_width" unit="mm">33.25</attribute>'), tmp_path)
    assert found.design.pairs["first"].face_width == pytest.approx(33.25e-3)
    assert found.design.pairs["second"] == sized("e-axle").design.pairs["second"]
    assert any("pairs.first.face_width_m is 0.03325" in entry for entry in found.assumed)


def test_a_file_without_gears_is_refused_with_what_is_in_it(tmp_path):
    only = f'{HEAD}<components><component id="1" type="gear_casing" name="housing"/></components></model>'
    (problem,) = problems(only, tmp_path)
    assert problem.path == "components"
    assert "no cylindrical, bevel or planetary stage among gear_casing" in problem.message


def test_a_worm_stage_is_refused_as_what_it_is(tmp_path):
    with pytest.raises(DesignError, match=r"among .*worm_stage"):
        gw.from_rexs(EXAMPLES / "fva_worm_1.4.rexs")


@pytest.mark.parametrize(
    "document",
    [
        '<!DOCTYPE model [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]>' + HEAD + "&b;</model>",
        '<!DOCTYPE model [<!ENTITY x SYSTEM "file:///etc/passwd">]>' + HEAD + "&x;</model>",
        '<!DOCTYPE model SYSTEM "http://localhost/x.dtd">' + HEAD + "</model>",
    ],
)
def test_entities_and_document_types_are_refused_before_they_are_looked_at(document, tmp_path):
    assert "declares a document type" in said(document, tmp_path)


def test_elements_that_stand_deep_in_each_other_are_refused(tmp_path):
    assert "more than 20 deep" in said(HEAD + "<components>" * 5000, tmp_path)


def test_a_truncated_file_is_refused_with_its_line(tmp_path, pair):
    (problem,) = problems(pair[: len(pair) // 2], tmp_path)
    assert "no whole XML file" in problem.message and problem.line > 100


def test_a_file_of_a_gigabyte_is_refused_without_being_read(tmp_path):
    path = tmp_path / "large.rexs"
    with path.open("wb") as file:
        file.truncate(1_000_000_000)  # holes: nothing is stored
    with pytest.raises(DesignError, match=f"more than {LARGEST:,} bytes"):
        gw.from_rexs(path)


@pytest.mark.parametrize("version", ["2.0.0", "0.9", ""])
def test_other_versions_are_refused_with_those_that_are_read(version, tmp_path, pair):
    (problem,) = problems(pair.replace('version="1.7"', f'version="{version}"', 1), tmp_path)
    assert problem.path == "model.version" and "REXS 1.0 to 1.7 is read" in problem.message


def test_a_file_that_is_no_rexs_is_refused(tmp_path):
    assert "no REXS file" in said("<svg/>", tmp_path)
    assert "no whole XML file" in said("shafts = []", tmp_path)
    assert "no whole XML file" in said("", tmp_path)


def test_parts_of_each_other_in_a_circle_are_named(tmp_path):
    parts = "".join(f'<component id="{k}" type="shaft" name="s"/>' for k in (1, 2, 3))
    ends = "".join(
        f'<relation id="{k}" type="assembly"><ref id="{k}" role="assembly"/>'
        f'<ref id="{k % 3 + 1}" role="part"/></relation>'
        for k in (1, 2, 3)
    )
    text = f"{HEAD}<relations>{ends}</relations><components>{parts}</components></model>"
    assert "1 > 2 > 3 > 1 are parts of each other in a circle" in said(text, tmp_path)


def test_every_problem_of_a_file_comes_at_once_with_line_path_and_what_is_allowed(tmp_path, pair):
    """A unit of another quantity, a missing one, a word for a number, and a missing width."""
    wrong = pair.replace('id="normal_module" unit="mm"', 'id="normal_module" unit="kg"', 1)
    wrong = wrong.replace('id="center_distance" unit="mm"', 'id="center_distance"', 1)
    wrong = re.sub(r'(id="number_of_teeth" unit="none">)\d+', r"\1many", wrong, count=1)
    wrong = wrong.replace('id="face_width"', 'id="width_of_face"', 1)
    listed = said(wrong, tmp_path)
    for words in ("normal_module: is in 'kg'; allowed: mm or m or mum", "center_distance: has no unit; allowed: mm",
                  "number_of_teeth: is 'many'; give a number", "face_width: is missing; give it in mm"):  # fmt: skip
        assert words in listed
    assert all(problem.line for problem in problems(wrong, tmp_path))


def test_a_reference_to_nothing_is_named(tmp_path, pair):
    assert "there is no component with the id 999999" in said(
        re.sub(r'<ref id="\d+"', '<ref id="999999"', pair, count=1), tmp_path
    )


def test_an_id_that_is_no_number_and_one_that_stands_twice_are_named(tmp_path):
    parts = '<component id="x" type="shaft"/><component id="2" type="shaft"/><component id="2" type="shaft"/>'
    listed = said(f"{HEAD}<components>{parts}</components></model>", tmp_path)
    assert "is 'x'; give a whole number" in listed and "the id 2 stands at line" in listed


def test_gears_in_mesh_with_different_modules_are_refused(tmp_path, pair):
    wrong = re.sub(r'(id="normal_module" unit="mm">)[\d.]+', r"\g<1>9", pair, count=1)
    assert "which has another module; they must be equal" in said(wrong, tmp_path)


def test_a_train_without_torques_is_refused_with_what_is_missing(tmp_path, pair):
    wrong = re.sub(r"<load_spectrum.*</load_spectrum>", "", pair, flags=re.DOTALL)
    assert "no external_load has a torque_around_u_axis" in said(wrong, tmp_path)


def test_a_broken_design_in_the_file_is_named_as_such(tmp_path):
    text = gw.to_rexs(sized("star")).content.replace(b"planetaries", b"planetarys")
    assert "custom_gearwright_design: does not give a design" in said(text, tmp_path)


def test_names_of_other_tools_become_names_of_a_design(tmp_path):
    """Brackets, dots and blanks are left out, equal names are counted."""
    design = gw.from_rexs(EXAMPLES / "fva_planetary_1.1.rexs").design
    assert design.shafts == ["Sonnenwelle-34", "Steg-1-4"]
    assert list(design.planetaries) == ["Planetenstufe-9"]


RATED = ["e-axle", "ec120b", "ec120b-as-reported", "twin-engine-helicopter", "wind-turbine-5mw"]
"""Designs whose gears ISO standards rate."""


@pytest.mark.parametrize("design", RATED)
def test_safeties_that_a_file_states_stand_beside_ours(design, tmp_path):
    """Written from the same sizing, so that they are the same to the 15 digits of a file."""
    found = read(gw.to_rexs(sized(design)).content, tmp_path)
    rated = {mesh.gears for mesh in sized(design).meshes if hasattr(mesh.rating, "pitting")}
    assert len(found.stated) == 4 * len(rated)
    for stated in found.stated:
        assert stated.ours(sized(design)) == pytest.approx(stated.value, rel=1e-12)


def test_safeties_come_out_by_what_rexs_itself_says(tmp_path):
    """The e-axle's S_H and S_F: K_A, materials, oil, loads, speeds and levels of the life are words of REXS."""
    found = read(without_own(gw.to_rexs(sized("e-axle")).content), tmp_path)
    sizing = gw.size(found.design)
    assert len(found.stated) == 8
    for stated in found.stated:
        assert stated.ours(sizing) == pytest.approx(stated.value, rel=1e-7)


def test_safeties_of_gears_that_are_not_rated_by_iso_are_not_compared(tmp_path):
    text = without_own(gw.to_rexs(sized("e-axle")).content).replace(b">20MnCr5<", b">unknown<")
    found = read(text, tmp_path)
    assert found.stated and {stated.ours(gw.size(found.design)) for stated in found.stated} == {None}


def test_a_gear_on_no_shaft_is_refused_by_its_line(tmp_path, pair):
    number = re.search(r'<component id="(\d+)" type="cylindrical_gear"', pair)[1]
    wrong = re.sub(rf'<ref id="{number}" role="part"[^>]*>', '<ref id="2" role="part"/>', pair)
    assert "stands on no shaft" in said(wrong, tmp_path)


def test_an_unequal_pair_of_clutch_states_makes_a_clutch(tmp_path, pair):
    """The e-axle's parking lock holds in the last of its cases alone."""
    design = read(pair, tmp_path).design
    assert [clutch.kind for clutch in design.clutches.values()] == ["open"]
    assert [case.engaged for case in design.cases.values()] == [[]] * 10 + [["parking-lock"]]


def test_levels_of_a_spectrum_are_load_cases_of_their_part_of_load_and_life(tmp_path, pair):
    """Four levels of the e-axle's town, of 40 % of its life at 28 kW; the other cases have their own."""
    cases = list(read(pair, tmp_path).design.cases.values())
    levels = gw.read("e-axle").spectra["pedal"]
    town = cases[5:9]
    assert [case.machines["motor"].power for case in town] == pytest.approx([28e3 * load for load in levels.load])
    assert [case.share for case in town] == pytest.approx([0.40 * share for share in levels.share])
    assert [case.machines["motor"].speed for case in town] == pytest.approx([3400 * RPM] * 4)
    assert sum(case.share or 0.0 for case in cases) == pytest.approx(1.0) and cases[-1].static
