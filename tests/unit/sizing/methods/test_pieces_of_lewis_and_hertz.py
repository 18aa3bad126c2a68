"""Pieces of the rating by Lewis and Hertz, without a sizing."""

import math
from dataclasses import replace

import pytest

from gearwright.parts.gears import contact_angles
from gearwright.sizing.rating import Ask
from gearwright.sizing.rating.lewis_hertz import (
    LewisHertz,
    bending_allowable,
    contact_allowable,
    first_modules,
    width_ratio,
)
from gearwright.sizing.rating.protocol import Load, LoadedMesh
from rated_pieces import FIRST, MESH, METHODS, SECOND, loaded, near, rating


def test_lewis_and_hertz_by_hand():
    """m³ = 2 T/z cos β …/(λ Y σ): checked by σ = F/(b m Y) and the allowables that it was asked for."""
    own = rating("lewis-hertz", idler_factor=0.7)
    material, rules = own.material, own.rules
    assert rules.idler_factor == 0.7
    allowed = material.yield_strength / rules.bending_safety
    assert bending_allowable(own, idler=False) == near(allowed)
    assert bending_allowable(own, idler=True) == near(allowed * rules.idler_factor)
    assert contact_allowable(own) == near(2.5e6 * material.surface_hardness / rules.contact_safety)
    assert width_ratio(rules.model_copy(update={"face_width_ratio": 7.0}), 0.3) == 7.0
    open_width = rules.model_copy(update={"face_width_ratio": None, "overlap_ratio": 1.2})
    assert width_ratio(open_width, 0.0) == 10.0
    assert width_ratio(open_width, math.radians(20.0)) == near(1.2 * math.pi / math.sin(math.radians(20.0)))


@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("idlers", [(False, False), (True, False)])
def test_modules_of_lewis_and_hertz_are_at_their_allowables(internal, idlers):
    """Rated with the module that it asks for, each stress is what is allowed; its margin is 1."""
    own, ask = rating("lewis-hertz", idler_factor=0.7), Ask(31.0, (23, 59), 9.0, internal=internal, idlers=idlers)
    for mode, module in zip(("bending", "contact"), first_modules(ask, own), strict=True):
        load = Load("x", 31.0 * 23, ask, 1.0)
        rated = METHODS["lewis-hertz"].rate(
            LoadedMesh(own, float(module), 9.0 * float(module), load, (load,), (1e-3, 2e-3))
        )
        assert getattr(rated, f"{mode}_margin") == pytest.approx(1.0, rel=1e-9)
        assert getattr(rated, f"{mode}_stress") == pytest.approx(getattr(rated, f"{mode}_allowable"), rel=1e-9)
        assert (rated.module_bending, rated.module_contact, rated.case) == (1e-3, 2e-3, "x")


def test_an_idle_mesh_of_lewis_and_hertz_has_margins_without_end():
    rated = METHODS["lewis-hertz"].rate(loaded("lewis-hertz", 0.0))
    assert (rated.bending_stress, rated.contact_stress) == (0.0, 0.0)
    assert (rated.bending_margin, rated.contact_margin) == (math.inf, math.inf)


def test_a_steel_that_is_not_known_bears_nothing_by_lewis_and_hertz():
    own = rating("lewis-hertz")
    unknown = replace(own, material=replace(own.material, surface_hardness=None, yield_strength=None))
    assert contact_allowable(unknown) == bending_allowable(unknown, idler=False) == 0.0


def test_stresses_of_lewis_and_hertz_are_judged_with_their_margins():
    rated = METHODS["lewis-hertz"].rate(loaded("lewis-hertz"))
    checks = LewisHertz().checks(rated, MESH, (FIRST, SECOND))
    rows = [(c.part, c.mode, c.clause, c.value, c.limit, c.case) for c in checks]
    assert rows == [
        (MESH, "bending", "Pulvirenti 2023, eq. 2.1", rated.bending_stress, near(rated.bending_allowable), "case 0"),
        (MESH, "contact", "Pulvirenti 2023, eq. 2.2", rated.contact_stress, near(rated.contact_allowable), "case 0"),
    ]


def test_lewis_and_hertz_of_a_mesh_by_hand():
    """F = 2 T/d_1, σ = F/(b m Y) with the smaller gear's Y, 1/r_1 ± 1/r_2; d = z m/cos β."""
    own = rating("lewis-hertz")
    own = replace(own, shifts=own.shifts._replace(centre=None))
    for internal in (False, True):
        ask = Ask(30.0, (23, 59), 10.0, internal=internal)
        load = Load("x", 690.0, ask, 1.0)
        rated = LewisHertz().rate(LoadedMesh(own, 4e-3, 40e-3, load, (load,), (0.0, 0.0)))
        diameters = [z * 4e-3 / math.cos(own.helix_angle) for z in (23, 59)]
        force = 2.0 * 690.0 / diameters[0]
        assert rated.bending_stress == near(force / (40e-3 * 4e-3 * rated.form_factor))
        curvature = 2.0 / diameters[0] + (-2.0 if internal else 2.0) / diameters[1]
        angles = contact_angles(
            own.rules.pressure_angle, own.helix_angle, transverse=own.rules.contact_angles == "transverse"
        )
        stress = 0.418 * math.sqrt(
            force * own.material.elastic_modulus * curvature * math.cos(angles.line)
            / (40e-3 * math.cos(angles.pressure) * math.sin(angles.pressure))
        )  # fmt: skip
        assert rated.contact_stress == pytest.approx(stress, rel=2e-3)  # 0.418 is √(0.35/2) to three digits
