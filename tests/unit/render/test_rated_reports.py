"""What a report says of gears that ISO 6336 rates."""

import math

import pytest

from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.motion import simulate
from gearwright.dynamics.vibration import dynamic_loads
from gearwright.parts.iso10300 import BevelRating
from gearwright.render.tables.checks import check_sentence, factor_tables
from gearwright.render.words.design_file import entries
from gearwright.shipped import shipped_design
from gearwright.sizing import pair_data, rated_factors, size
from gearwright.spec import read

DESIGN = read(shipped_design("ec120b"))
SIZING = size(DESIGN)
FACTORS = rated_factors(SIZING)


def test_every_factor_of_both_standards_stands_in_a_table_with_its_clause():
    tables = factor_tables(FACTORS)
    helical, bevel = tables["helical"], tables["bevel"]
    for one, standard in ((helical, "ISO 6336"), (bevel, "ISO 10300")):
        rows = {row[2].text.partition(" = ")[0]: [cell.text for cell in row] for row in one.rows}
        assert all(row[-1] for row in rows.values())
        assert standard in one.title
    symbols = {row[2].text.partition(" = ")[0] for row in helical.rows}
    assert {
        "K_A",
        "K_V",
        "K_Hβ",
        "K_Hα",
        "Z_H",
        "Z_E",
        "Z_ε",
        "Z_NT",
        "Z_L",
        "Y_F",
        "Y_S",
        "Y_NT",
        "S_H",
        "S_F",
    } <= symbols


def test_the_tables_values_are_those_of_the_rating():
    """S_H and S_F as printed, to the digits that are shown (5)."""
    helical = next(mesh for mesh in SIZING.meshes if mesh.name == "helical")
    rows = {row[2].text.partition(" = ")[0]: row for row in factor_tables(FACTORS)["helical"].rows}
    pinion, wheel = (float(rows["S_H"][k].text) for k in (3, 4))
    assert (pinion, wheel) == pytest.approx([float(each) for each in helical.rating.factors.pitting.safeties], rel=5e-5)


def _numbers(one, column):
    """Return the values of a gear by their symbols; of the mesh where there is one value."""
    rows = {row[2].text.partition(" = ")[0]: (row[column].text or row[3].text) for row in one.rows}
    return {symbol: float(text.replace("−", "-")) for symbol, text in rows.items() if "," not in text}


@pytest.mark.parametrize("column", [3, 4])
def test_stresses_and_limits_are_the_products_of_the_shown_factors(column):
    """σ_H0, σ_HG, σ_F0 and σ_FG by hand from the other lines, in MPa and mm; to the digits that are shown."""
    it, pinion = (
        _numbers(factor_tables(FACTORS)["helical"], column),
        _numbers(factor_tables(FACTORS)["helical"], 3),
    )
    ratio = _numbers(factor_tables(FACTORS)["helical"], 4)["z"] / pinion["z"]
    flank = it["F_t"] / (pinion["d"] * it["b"]) * (ratio + 1.0) / ratio
    assert math.prod(it[each] for each in ("Z_H", "Z_E", "Z_ε", "Z_β")) * math.sqrt(flank) == pytest.approx(
        it["σ_H0"], rel=2e-4
    )
    assert math.prod(it[each] for each in ("σ_Hlim", "Z_NT", "Z_L", "Z_v", "Z_R", "Z_W", "Z_X")) == pytest.approx(
        it["σ_HG"], rel=2e-4
    )
    root = it["F_t"] / (it["b"] * it["m_n"])
    assert root * math.prod(it[each] for each in ("Y_F", "f_ε", "Y_S", "Y_β", "Y_B", "Y_DT")) == pytest.approx(
        it["σ_F0"], rel=2e-4
    )
    limit = 2.0 * it["σ_Flim"]
    assert limit * math.prod(it[each] for each in ("Y_NT", "Y_δrelT", "Y_RrelT", "Y_X", "Y_M")) == pytest.approx(
        it["σ_FG"], rel=2e-4
    )


def test_limits_of_a_bevel_pair_are_the_products_of_the_shown_factors():
    """σ_HP with Z_X = Z_W = 1 and Z_KP = 1.2, σ_FP with Y_ST = 2; to the digits that are shown."""
    bevel = factor_tables(FACTORS)["bevel"]
    films = next(row[3].text for row in bevel.rows if row[2].text == "Z_L, Z_v, Z_R")
    for it in (_numbers(bevel, 3), _numbers(bevel, 4)):
        flank = 1.2 * it["σ_Hlim"] * it["Z_NT"] * math.prod(map(float, films.split(", ")))
        assert flank == pytest.approx(it["σ_HP"], rel=2e-4)
        root = 2.0 * it["σ_Flim"] * math.prod(it[each] for each in ("Y_NT", "Y_δrelT", "Y_R,relT", "Y_X"))
        assert root == pytest.approx(it["σ_FP"], rel=2e-4)


def test_tooth_data_of_a_bevel_pair_are_its_cones():
    bevel = next(mesh for mesh in SIZING.meshes if mesh.name == "bevel")
    data = pair_data(SIZING, bevel)
    assert isinstance(bevel.rating.factors, BevelRating)
    assert data.outer_module == pytest.approx(bevel.rating.factors.virtual.bevel.outer_module, rel=1e-12)
    assert sum(data.pitch_angle) == pytest.approx(data.shaft_angle, rel=1e-12)


def test_a_margin_says_value_limit_and_clause():
    worst = SIZING.checks[0]
    assert check_sentence(worst).startswith(f"{worst.part}: {worst.what} ")
    assert "limit" in check_sentence(worst)
    assert worst.clause in check_sentence(worst)


def test_rules_that_a_stage_does_not_state_are_not_listed_as_its_own():
    listed = {entry.path for entry in entries(DESIGN)}
    assert "pairs.helical.gears.helix_angle" in listed
    assert "pairs.helical.gears.rating" not in listed
    assert "gears.rating" in listed


def test_peaks_of_a_run_are_held_against_the_force_with_application_and_dynamic_factor():
    trace = simulate(assemble(SIZING), 0.02)
    load = next(each for each in dynamic_loads(SIZING, trace) if each.mesh == "helical")
    mesh = next(each for each in SIZING.meshes if each.name == "helical")
    loads = mesh.rating.factors.loads
    assert load.rated_force == pytest.approx(mesh.tangential_force * 1.25 * float(loads.dynamic), rel=1e-12)
    assert load.bending_margin > 1.0
