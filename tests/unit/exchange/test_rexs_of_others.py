"""What other tools write otherwise than gearwright does: fits, powers, mean modules, helical sets, gears to shift."""

import json
import math

import pytest

import gearwright as gw
from shipped_work import sized


def bare(design):
    """Return what REXS itself says of a shipped design, as records."""
    model = json.loads(gw.to_rexs(sized(design), form="rexsj").content)["model"]
    for part in model["components"]:
        part["attributes"] = [said for said in part["attributes"] if not said["id"].startswith("custom_")]
    return model


def read(model, folder):
    path = folder / "gearbox.rexsj"
    path.write_text(json.dumps({"model": model}), encoding="utf-8")
    return gw.from_rexs(path)


def of_kind(model, *kinds):
    return [part for part in model["components"] if part["type"] in kinds]


def without(parts, name):
    """Return components or cases without one of their attributes, each of which stood somewhere."""
    left_out = 0
    for part in parts:
        kept = [said for said in part["attributes"] if said["id"] != name]
        left_out += len(part["attributes"]) - len(kept)
        part["attributes"] = kept
    assert left_out


def said_of(part, name):
    return next(said for said in part["attributes"] if said["id"] == name)


def test_a_gear_that_a_fit_holds_stands_on_its_shaft(tmp_path):
    model = bare("e-axle")
    before = read(model, tmp_path).design
    number = of_kind(model, "cylindrical_gear")[0]["id"]
    held = next(one for one in model["relations"] if one["type"] == "assembly" and one["refs"][1]["id"] == number)
    held["type"] = "side"
    held["refs"][0]["role"], held["refs"][1]["role"] = "inner_part", "outer_part"
    held["refs"].append({"id": 9000, "role": "assembly"})
    model["components"].append({"id": 9000, "type": "cylindrical_interference_fit", "attributes": []})
    after = read(model, tmp_path).design
    assert (after.pairs, after.motors, after.cases) == (before.pairs, before.motors, before.cases)


def test_what_turns_faster_than_an_electric_rotor_bears_is_a_turbine(tmp_path):
    """2051 kW at 20000 rpm are 9.1e5 rpm √kW, of 8.6e5; REXS does not say what drives."""
    found = read(bare("star"), tmp_path)
    assert (list(found.design.turbines), list(found.design.motors)) == (["gas-turbine"], [])
    assert any("turbine where no electric rotor" in note for note in found.assumed)


def test_a_power_at_the_speed_of_its_shaft_is_a_torque(tmp_path):
    model = bare("star")
    before = read(model, tmp_path).design.turbines
    without(
        [part for case in model["load_spectrum"]["load_cases"] for part in case["components"]], "torque_around_u_axis"
    )
    after = read(model, tmp_path).design.turbines
    assert after.keys() == before.keys()
    for name, motor in after.items():
        assert (motor.power, motor.speed) == pytest.approx((before[name].power, before[name].speed), rel=1e-12)


def test_bevel_gears_of_a_mean_module_have_the_outer_one_of_their_cone(tmp_path):
    """ISO 23509: R_e = R_m + b/2."""
    model = bare("ec120b")
    (wanted,) = [pair.outer_module for pair in read(model, tmp_path).design.pairs.values() if pair.kind == "bevel"]
    without(of_kind(model, "bevel_gear"), "outer_pitch_diameter")
    (module,) = [pair.outer_module for pair in read(model, tmp_path).design.pairs.values() if pair.kind == "bevel"]
    assert module == pytest.approx(wanted, rel=1e-9)


def test_a_helical_set_is_read_by_its_transverse_section(tmp_path):
    """m_t = m_n/cos β and tan α_t = tan α_n/cos β, so that the ratio and the tooth outlines across the axis stay."""
    model, angle = bare("single-planetary"), 12.0
    (spur,) = read(model, tmp_path).design.planetaries.values()
    slope = math.cos(math.radians(angle))
    for gear in of_kind(model, "cylindrical_gear", "ring_gear"):
        said_of(gear, "helix_angle_reference_diameter")["floating_point"] = angle
    for stage in of_kind(model, "cylindrical_stage"):
        said_of(stage, "center_distance")["floating_point"] /= slope
    found = read(model, tmp_path)
    (helical,) = found.design.planetaries.values()
    assert helical.module * slope == pytest.approx(spur.module, rel=1e-12)
    assert math.tan(helical.gears.pressure_angle) * slope == pytest.approx(math.tan(math.radians(20.0)), rel=1e-12)
    assert helical.gears.helix_angle == 0.0
    assert any("12° are read as spur ones of the same transverse section" in note for note in found.assumed)


def test_a_shift_that_closes_nowhere_follows_from_the_others(tmp_path):
    """A planet of another shift than the stated centre distance wants, as in files that were never computed."""
    model = bare("single-planetary")
    planets = {part["id"] for part in of_kind(model, "cylindrical_gear") if "planet" in part["name"]}
    flanks = {ref["id"] for one in model["relations"] if one["type"] == "flank" for ref in one["refs"]
              if one["refs"][0]["id"] in planets}  # fmt: skip
    for flank in [part for part in of_kind(model, "cylindrical_gear_flank") if part["id"] in flanks]:
        said_of(flank, "addendum_modification_coefficient")["floating_point"] = 0.9
    found = read(model, tmp_path)
    assert any("has a profile shift of 0.9, which does not close" in note for note in found.assumed)
    (table,) = found.design.planetaries.values()
    assert table.planet_shift is None and gw.size(found.design).mass > 0.0


def test_gears_to_shift_are_load_cases(tmp_path):
    """An automatic of five gears, each of which engages two of five clutches, without a load spectrum."""
    model = bare("ravigneaux-automatic")
    before = read(model, tmp_path).design
    cases = [{part["id"]: part["attributes"] for part in case["components"]}
             for case in model.pop("load_spectrum")["load_cases"]]  # fmt: skip
    for part in model["components"]:
        if part["type"] == "switchable_coupling":
            held = [cases[place][part["id"]][0]["boolean_array"][0] for place in range(len(cases))]
            part["attributes"] = [{"id": "is_engaged", "unit": "none", "boolean_array": held}]
        elif part["id"] in cases[0] and part["type"] in ("shaft", "external_load"):
            part["attributes"] += cases[0][part["id"]]
        elif part["type"] == "gear_unit":
            part["attributes"].append({"id": "number_of_gears", "unit": "none", "integer": len(cases)})
    engaged = [case.engaged for case in read(model, tmp_path).design.cases.values()]
    assert engaged == [case.engaged for case in before.cases.values()]


def test_cylindrical_gears_on_axes_that_cross_are_refused(tmp_path):
    model = bare("e-axle")
    said_of(of_kind(model, "cylindrical_gear")[0], "u_axis_vector")["floating_point_array"] = [0.0, 1.0, 0.0]
    with pytest.raises(gw.DesignError, match="axes that cross"):
        read(model, tmp_path)
