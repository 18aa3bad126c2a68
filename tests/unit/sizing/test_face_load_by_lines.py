"""K_Hβ by the bending lines of built shafts: against method C without slopes, by hand, and what is left open."""

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating import context_of
from gearwright.sizing.shafts.stretches import face_factor_by_lines
from gearwright.spec import edited, read

HELICOPTER = read(shipped_design("ec120b"))
METHOD_B = size(edited(HELICOPTER, {"gears.iso6336.face_method": "B"}))
CONTEXT = context_of(METHOD_B.design, METHOD_B.train, METHOD_B.teeth, METHOD_B.flows, METHOD_B.given)
GEARS = {gear.name: gear for gear in METHOD_B.gears}
HELICAL = next(mesh for mesh in METHOD_B.meshes if mesh.name == "helical")


def factor(first: float, second: float) -> float:
    return face_factor_by_lines(CONTEXT, HELICAL, GEARS, dict(zip(HELICAL.gears, (first, second), strict=True)))


def test_without_slopes_method_b_is_method_c():
    assert factor(0.0, 0.0) == pytest.approx(float(HELICAL.rating.factors.face.contact), rel=1e-12)


def test_slopes_add_their_part_of_the_misalignment_after_running_in():
    """Helices are corrected, B_1 = 0.1: F_βx grows by 1.33 · 0.1 b (θ_1 + θ_2), of which running in leaves 0.85."""
    face, loads = HELICAL.rating.factors.face, HELICAL.rating.factors.loads
    width = GEARS["helical.pinion"].face_width
    more = 0.85 * 1.33 * 0.1 * width * 3e-4
    expected = 1.0 + (float(face.contact) - 1.0) * (float(face.misalignment) + more) / float(face.misalignment)
    assert factor(2e-4, 1e-4) == pytest.approx(expected, rel=1e-9)
    assert factor(1e-4, 2e-4) == factor(2e-4, 1e-4)
    assert loads.face_contact == face.contact


def test_the_check_holds_it_against_what_the_safeties_leave():
    checks = {str(check.part): check for check in METHOD_B.checks if check.mode == "face load"}
    assert set(checks) == {"helical", "tail-take-off"}
    slopes = {place: slope for shaft in METHOD_B.built_shafts for place, slope in shaft.slopes}
    check = checks["helical"]
    assert check.value == pytest.approx(factor(*(slopes[name] for name in HELICAL.gears)))
    assert check.limit > float(HELICAL.rating.factors.face.contact)
    assert not any(check.mode == "face load" for check in size(HELICOPTER).checks)


def test_shafts_that_are_not_built_are_told():
    shipped = read(shipped_design("wind-turbine-5mw"))
    told = [
        check for check in size(edited(shipped, {"gears.iso6336.face_method": "B"})).checks if check.mode == "face load"
    ]
    assert told
    assert all(check.value is not None or "[bearings]" in check.why for check in told)
