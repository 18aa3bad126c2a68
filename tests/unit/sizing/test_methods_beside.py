"""One mesh by every method: what stands in the table is what sizing by that method says of the same gears."""

import pytest

from designs import PAIR
from gearwright.render.tables.sizing.methods import method_tables
from gearwright.shipped import shipped_design
from gearwright.sizing import MeshBeside, methods_beside, size
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
            "work hardening Z_W", "size Z_X",
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
    note = method_tables(sizing)[ring.mesh].note
    assert "Not by DIN 3990:1987, method B: DIN 3990 rates no internal meshes here." in note


def test_a_bevel_pair_has_no_sisters_to_stand_beside():
    sizing = size(read(shipped_design("ec120b")))
    bevel = {mesh.name for mesh in sizing.meshes if mesh.rating.method == "iso10300"}
    assert bevel
    assert not bevel & {mesh.mesh for mesh in methods_beside(sizing)}
