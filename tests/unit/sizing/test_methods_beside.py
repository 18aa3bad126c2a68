"""One mesh by every method: what stands in the table is what sizing by that method says of the same gears."""

import math

import pytest

from designs import PAIR
from gearwright.render.tables.checks import method_tables
from gearwright.shipped import shipped_design
from gearwright.sizing import MeshBeside, methods_beside, size
from gearwright.sizing.insight import ASPECTS
from gearwright.spec import edited, parse, read

DESIGN = (
    f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n\n[gears]\nrating = "METHOD"\nhelix_angle_deg = 15\n'
    '[overrides]\n"stage.module_mm" = 3\n"stage.face_width_mm" = 40\n'
)
METHODS = ("iso6336", "iso6336-2006", "din3990", "agma2001")


def beside(method: str) -> MeshBeside:
    (mesh,) = methods_beside(size(parse(DESIGN.replace("METHOD", method))))
    return mesh


def test_a_column_is_what_sizing_by_that_method_finds():
    mesh = beside("iso6336")
    assert tuple(mesh.margins) == (*METHODS, "lewis-hertz")
    for method, margins in mesh.margins.items():
        rated = size(parse(DESIGN.replace("METHOD", method))).meshes[0].rating
        assert margins == pytest.approx((rated.contact_margin, rated.bending_margin), rel=1e-12), method


def test_the_table_does_not_ask_by_which_method_the_design_was_sized():
    ours, theirs = beside("iso6336"), beside("agma2001")
    assert ours.rows == theirs.rows


def test_a_method_that_has_a_factor_has_its_column():
    """Every place in a method's factors that a line names is there: ISO's under ISO, AGMA's under AGMA."""
    families = ("iso6336", "agma2001", "lewis-hertz")
    lines = {line.aspect: line.values for line in beside("iso6336").rows}
    told = [aspect for aspect in ASPECTS if aspect.name in lines]
    for aspect in told:
        named = dict(zip(families, (aspect.iso, aspect.agma, aspect.lewis), strict=True))
        assert {method for method in families if named[method]} == lines[aspect.name].keys() & set(families), aspect
    assert len(told) > 30


def test_every_difference_has_its_reason_and_equal_values_have_none():
    for line in beside("iso6336").rows:
        firsts = {round(values[0], 12) for values in line.values.values()}
        if len(line.values) < 5 or (len(firsts) > 1 and max(firsts) / min(firsts) > 1.01):
            assert line.why, line.aspect
        if len(line.values) == 5 and len(firsts) == 1:
            assert not line.why, line.aspect


def test_a_limit_is_the_product_of_its_factors_in_every_column():
    """σ_HG of ISO and DIN from the rows above it; s_c's limit of AGMA from its own two."""
    rows = {line.aspect: line.values for line in beside("iso6336").rows}
    for method in METHODS[:3]:
        product = 1.0
        for aspect in (
            "strength σ_Hlim, s_ac", "life Z_NT, Z_N", "lubricant Z_L", "speed Z_v", "roughness Z_R",
            "work hardening Z_W, C_H", "size Z_X",
        ):  # fmt: skip
            product *= rows[aspect][method][0]
        assert product == pytest.approx(rows["limit σ_HG"][method][0], rel=1e-12)
    agma = rows["strength σ_Hlim, s_ac"]["agma2001"][0] * rows["life Z_NT, Z_N"]["agma2001"][0]
    assert agma == pytest.approx(rows["limit σ_HG"]["agma2001"][0], rel=1e-12)


def test_methods_without_rings_say_so():
    sizing = size(edited(read(shipped_design("in-line")), {"gears.rating": "iso6336"}))
    ring = next(mesh for mesh in methods_beside(sizing) if mesh.mesh.endswith("planet-ring"))
    assert set(ring.refused) == {"din3990", "agma2001"}
    assert all("internal" in why for why in ring.refused.values())
    note = method_tables(methods_beside(sizing))[ring.mesh].note
    assert "Not by DIN 3990:1987, method B: DIN 3990 rates no internal meshes here." in note


def test_a_bevel_pair_stands_beside_the_standards_of_bevel_gears():
    """What stands in the column of AGMA 2003 is what AGMA 2003 says of the gears that ISO 10300 sized."""
    design = read(shipped_design("ec120b"))
    sizing = size(design)
    (bevel,) = [mesh for mesh in methods_beside(sizing) if mesh.mesh == "bevel"]
    assert tuple(bevel.margins) == ("iso10300", "agma2003")
    (gear,) = [gear for gear in sizing.gears if gear.name == "bevel.pinion"]
    (mesh,) = [mesh for mesh in sizing.meshes if mesh.name == "bevel"]
    assert bevel.margins["iso10300"] == pytest.approx((mesh.rating.contact_margin, mesh.rating.bending_margin))
    outer = 1e3 * bevel_outer_module(gear.module, gear.face_width, (14, 43), 35.0)
    asked = {"pairs.bevel.outer_module_mm": outer, "pairs.bevel.face_width_mm": 1e3 * gear.face_width}
    other = size(edited(design, {"pairs.bevel.gears.rating": "agma2003", **asked}))
    (rated,) = [mesh.rating for mesh in other.meshes if mesh.name == "bevel"]
    assert rated.method == "agma2003"
    assert bevel.margins["agma2003"] == pytest.approx((rated.contact_margin, rated.bending_margin), rel=1e-9)
    rows = {line.aspect: line for line in bevel.rows}
    assert rows["elasticity Z_E, C_p"].values["agma2003"] == pytest.approx(
        rows["elasticity Z_E, C_p"].values["iso10300"]
    )
    assert all(line.why for line in bevel.rows if len(line.values) < 2)


def bevel_outer_module(mean_normal, face_width, teeth, spiral):
    """m_et = m_mn/cos β_m + b/(2 R_e/m_et), R_e/m_et = √(z_1² + z_2²)/2 (ISO 23509)."""
    return mean_normal / math.cos(math.radians(spiral)) + face_width / math.hypot(*teeth)
