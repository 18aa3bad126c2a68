"""Sizings as REXS files: what the schema and the database of REXS say of them, and what they hold."""

from xml.etree import ElementTree

import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.exchange.rexs.files import words
from rexs_database import FOLDER, database, faults
from shipped_work import sized

VERSIONS = ("1.7", "1.6")


def root_of(design, version="1.7"):
    return ElementTree.fromstring(gw.to_rexs(sized(design), version=version).content)


def of_type(root, kind):
    return [part for part in root.iterfind("components/component") if part.get("type") == kind]


def value(component, name):
    (found,) = [attribute for attribute in component if attribute.get("id") == name]
    return float(found.text), found.get("unit")


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("design", gw.shipped_designs())
def test_every_shipped_design_is_a_file_with_which_the_database_has_no_problem(design, version):
    assert faults(gw.to_rexs(sized(design), version=version).content, version) == []


@pytest.mark.extra("lxml")
@pytest.mark.parametrize("design", gw.shipped_designs())
def test_every_shipped_design_is_valid_against_the_schema(design):
    from lxml import etree

    schema = etree.XMLSchema(etree.parse(FOLDER / "rexs-file.xsd"))
    for version in VERSIONS:
        assert schema.validate(etree.fromstring(gw.to_rexs(sized(design), version=version).content)), schema.error_log


def test_the_database_finds_what_is_wrong():
    """A wrong unit, an attribute of another component, a value out of its range, and a relation of wrong parts."""
    content = gw.to_rexs(sized("star")).content
    for old, new, said in (
        (b'id="normal_module" unit="mm"', b'id="normal_module" unit="m"', "in m, not in mm"),
        (b'id="normal_module"', b'id="shaft_angle"', "has no shaft_angle"),
        (b'role="inner_part"', b'role="part"', "is not allowed"),
        (b'type="ring_gear"', b'type="worm"', "no component worm"),
    ):
        assert any(said in fault for fault in faults(content.replace(old, new), "1.7")), said


def test_numbers_stand_in_the_units_of_rexs():
    """In-Line H2's second stage: module, width and teeth as sized, and torque and speed of the turbine."""
    sizing, root = sized("in-line-h2"), root_of("in-line-h2")
    gear = next(gear for gear in sizing.gears if gear.name == "second.ring")
    ring = next(part for part in of_type(root, "ring_gear") if part.get("name") == "second.ring")
    assert value(ring, "normal_module") == (pytest.approx(1e3 * gear.module, rel=1e-14), "mm")
    assert value(ring, "face_width") == (pytest.approx(1e3 * gear.face_width, rel=1e-14), "mm")
    assert value(ring, "number_of_teeth") == (gear.teeth, "none")
    case = root.find("load_spectrum/load_case")
    loads = {part.get("name"): part.get("id") for part in of_type(root, "external_load")}
    load = next(part for part in case if part.get("id") == loads["gas-turbine"])
    assert value(load, "power") == (pytest.approx(1046.0), "kW")
    shaft = next(part.get("id") for part in of_type(root, "shaft") if part.get("name") == "input")
    turning = next(part for part in case if part.get("id") == shaft and part.get("type") == "shaft")
    assert value(turning, "rotational_speed") == (pytest.approx(20000.0), "1 / min")


def test_planets_are_gears_of_their_own_with_two_stages_each():
    root = root_of("in-line-h2")
    assert len(of_type(root, "cylindrical_gear")) == 2 + 3 + 5
    assert len(of_type(root, "cylindrical_stage")) == 2 * (3 + 5)
    assert len(of_type(root, "planetary_stage")) == 2


def test_safeties_stand_beside_their_gears():
    """S_H of the helical pair of the EC120B, of which its sizing has two."""
    sizing, root = sized("ec120b"), root_of("ec120b")
    mesh = next(mesh for mesh in sizing.meshes if mesh.name == "helical")
    written = [value(part, "safety_factor_pitting_iso_6336_2019")[0]
               for part in of_type(root, "cylindrical_stage_gear_data") if "helical" in part.get("name")]  # fmt: skip
    assert written == pytest.approx(mesh.rating.pitting, rel=1e-14)


def test_what_rexs_cannot_hold_is_said():
    said = " ".join(gw.to_rexs(sized("face-gear-split-torque")).left_out)
    assert "pairs.first: REXS has no face gears" in said
    assert "thrust" in " ".join(gw.to_rexs(sized("ec120b")).left_out)
    assert "clutches.sprag-1: couplings of REXS do not overrun" in gw.to_rexs(sized("twin-engine-sprag")).left_out[0]


def test_attributes_that_version_1_6_lacks_are_named():
    said = gw.to_rexs(sized("ec120b"), version="1.6").left_out[-1]
    assert said.startswith("attributes that REXS 1.6 does not have: ")
    assert "safety_factor_pitting_iso_6336_2019" in said


def test_another_version_is_refused_with_those_that_are_written():
    with pytest.raises(DesignError, match=r"1\.5.*none of 1\.7, 1\.6"):
        gw.to_rexs(sized("star"), version="1.5")


def test_names_that_xml_cannot_hold_make_a_file_all_the_same():
    design = gw.read("star").model_copy(update={"name": "one\x00two", "description": "\ud800\ufffe <&>"})
    assert faults(gw.to_rexs(gw.size(design)).content, "1.7") == []


def test_the_attributes_that_are_known_have_the_units_and_kinds_of_the_database():
    """Those of components that are written; REXS 1.6 has all that are said to be in it."""
    tried = 0
    for version in VERSIONS:
        for name, word in words().items():
            known = database(version)["attributes"].get(name)
            if known is not None:
                assert (word.unit, word.kind) == (known[0], known[1]), name
                tried += 1
            assert known is not None or version == "1.6", name
            if version == "1.6":
                assert (known is not None) == (word.since == "1.6"), name
    assert tried > 150
