"""Factors where the printed formula, or a limit of it, gives their value: no number here was recorded from the code."""

import math
from dataclasses import replace
from types import SimpleNamespace

import pytest

from gearwright.parts.bevel_geometry import BevelPair
from gearwright.parts.iso6336 import (
    Edition,
    GearSteel,
    MeshDeviations,
    MeshSprings,
    TipRelief,
    Treatment,
    dynamic_factor,
    helix_factor,
    lead_allowance,
    load_sharing_factor,
    relief_term,
    running_in_allowance,
)
from gearwright.parts.losses import ToothContact, mesh_friction, oil_viscosity
from gearwright.parts.scuffing import SPRAY, Oil, ScuffingMesh, integral_temperature
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating import bevel_pair, cylindrical_mesh, rating_of, stage_width_ratio
from gearwright.spec import read
from mounted_designs import PAIR, sized

HELICOPTER = read(shipped_design("ec120b"))
SOFT = GearSteel("soft", Treatment.THROUGH_HARDENED, "MQ", 300.0, 640e6, 310e6, yield_strength=700e6)
HARD = GearSteel("hard", Treatment.CASE_HARDENED, "MQ", 700.0, 1500e6, 461e6)


def teeth(**values):
    """A mesh of which only what is named is known."""
    return SimpleNamespace(base_helix_angle=0.0, **values)


UNIT = ToothContact(
    loss_factor=0.2, curvature=1e-3, pressure_angle=math.radians(30.0), base_helix=0.0, pinion_diameter=0.1
)
"""2 sin 30° = 1: the sum of the rolling speeds is the pitch-line velocity."""


def friction(load=1e3, velocity=1.0, viscosity=1e-3, roughness=1e-6, contact=UNIT):
    return mesh_friction(contact, load, velocity, viscosity=viscosity, roughness=roughness)


def test_friction_has_schlenks_factor_and_exponents():
    """0.048 where all is 1 N/mm, m/s, mm, mPa s and µm; powers 0.2, −0.2, −0.2, −0.05, 0.25 by whole factors."""
    assert friction() == pytest.approx(0.048)
    assert friction(load=32e3) == pytest.approx(2.0 * 0.048)
    assert friction(velocity=32.0) == pytest.approx(0.048 / 2.0)
    assert friction(contact=UNIT._replace(curvature=32e-3)) == pytest.approx(0.048 / 2.0)
    assert friction(viscosity=1e-3 * 2.0**20) == pytest.approx(0.048 / 2.0)
    assert friction(roughness=16e-6) == pytest.approx(2.0 * 0.048)
    assert friction(load=3125e3) == 0.2 and friction(velocity=0.0) == friction(velocity=1e-3)


@pytest.mark.parametrize(
    ("contact_ratio", "overlap", "printed"),
    [(1.5, 0.0, 1.0), (1.99, 0.0, 1.0), (2.0, 0.0, 0.7), (2.3, 0.0, 0.7),
     (1.6, 1.0, 1.6**-0.5), (1.6, 1.7, 1.6**-0.5), (2.4, 1.0, 2.4**-0.5),
     (1.6, 0.5, math.sqrt(0.5 + 0.5 / 1.6)), (2.5, 0.5, math.sqrt(0.25 + 0.2)), (2.5, 0.2, math.sqrt(0.4 + 0.08))],
)  # fmt: skip
def test_load_sharing_is_that_of_its_four_ranges(contact_ratio, overlap, printed):
    """ISO 6336-3:2019, clause 6.2, read off its four lines."""
    mesh = teeth(transverse_contact_ratio=contact_ratio, overlap_ratio=overlap)
    assert load_sharing_factor(mesh) == pytest.approx(printed, rel=1e-12)


def test_load_sharing_of_deep_teeth_goes_over_from_spur_to_helical():
    """Two pairs share the load evenly: 0.7 for spur teeth is √½ to one digit, and the helical branch begins there."""
    assert load_sharing_factor(teeth(transverse_contact_ratio=2.2, overlap_ratio=1e-9)) == pytest.approx(math.sqrt(0.5))


@pytest.mark.parametrize(
    ("overlap", "degrees", "printed"),
    [(1.0, 15.0, 0.875), (2.5, 30.0, 0.75), (1.0, 40.0, 0.75), (0.5, 24.0, 0.9), (0.0, 20.0, 1.0)],
)
def test_the_helix_factor_of_bending_is_one_less_the_overlap_by_a_third_of_a_turn(overlap, degrees, printed):
    """DIN 3990-3 and ISO 6336-3: Y_β = 1 − ε_β β/120°, not below 0.75; since 2019 over cos³ β."""
    mesh = teeth(overlap_ratio=overlap, helix_angle=math.radians(degrees))
    assert helix_factor(mesh, Edition.ISO2006) == pytest.approx(printed)
    cosine = math.cos(math.radians(min(degrees, 30.0)))
    assert helix_factor(mesh, Edition.ISO2019) == pytest.approx(printed / cosine**3)


C_V = {
    1.2: (0.34, 0.23, 0.90, 0.47, 0.75),
    1.8: (0.34, 0.23, 0.90, 0.47, 0.875 - 0.125 * math.sin(0.2 * math.pi)),
    2.8: (0.57 / 2.5, 0.096 / 1.24, 0.43 / 1.36, 0.12 / 1.06, 1.0),
}
"""ISO 6336-1, table of C_v2, C_v3, C_v4, C_v6 and C_v7 over ε_γ; C_v1 = 0.32 and C_v5 = 0.47 everywhere."""


@pytest.mark.parametrize("overlap", C_V)
@pytest.mark.parametrize(("pitch", "profile", "relief"), [(3e-6, 0.0, 0.0), (0.0, 2e-6, 0.0), (1e-6, 2e-6, 4e-6)])
def test_the_dynamic_factor_has_the_printed_coefficients_in_every_range(overlap, pitch, profile, relief):
    """K_V from the printed table, with c′ = 1e10 N/m², 100 N/mm and resonance at N = 1."""
    single, load = 1e10, 1e5
    b_p, b_f, b_k = single * pitch / load, single * profile / load, abs(1.0 - single * relief / load)
    c_2, c_3, c_4, c_6, c_7 = C_V[overlap]

    def factor(ratio, specific_load=load, scale=1.0):
        left = relief_term(TipRelief(relief * scale, 0.0, stiffness=single), specific_load, grade=4)
        deviations = MeshDeviations(pitch * scale, profile * scale, left)
        mesh = SimpleNamespace(teeth=(20, 60), total_contact_ratio=overlap)
        found = dynamic_factor(
            mesh,
            MeshSprings(single, 4e8, 4e8),
            deviations,
            specific_load=specific_load,
            pinion_speed=1e3 * ratio,
            masses=(1.0,),
        )
        assert found.resonance_ratio == pytest.approx(ratio)
        return found.factor

    below, resonant = 0.32 * b_p + c_2 * b_f + c_3 * b_k, 1.0 + 0.32 * b_p + c_2 * b_f + c_4 * b_k
    above = 0.47 * b_p + c_6 * b_f + c_7
    assert factor(0.6) == pytest.approx(1.0 + 0.6 * below)
    assert factor(0.84) == pytest.approx(1.0 + 0.84 * below)
    assert factor(0.86) == factor(1.14) == pytest.approx(resonant)
    assert factor(1.2) == pytest.approx(above + (resonant - above) * 0.3 / 0.35)
    assert factor(1.5) == factor(2.5) == pytest.approx(above)
    # Below 100 N/mm the range of resonance begins at 0.5 + 0.35 √(w/100): at 0.675 with a quarter of the load.
    assert factor(0.67, load / 4.0, 0.25) == pytest.approx(1.0 + 0.67 * below)
    assert factor(0.68, load / 4.0, 0.25) == pytest.approx(resonant)


@pytest.mark.parametrize(("speed", "most"), [(4.9, math.inf), (5.1, 20.0), (10.1, 10.0)])
def test_running_in_of_soft_flanks_is_held_by_speed(speed, most):
    """ISO 6336-1: y_α = 160/640 f = f/4 held at 12800/640 = 20 and 6400/640 = 10 µm, y_β twice both of these."""
    for micron in (4.0, 60.0, 200.0):
        assert running_in_allowance(micron * 1e-6, SOFT, speed) == pytest.approx(min(micron / 4.0, most) * 1e-6)
        assert lead_allowance(micron * 1e-6, SOFT, speed) == pytest.approx(min(micron / 2.0, 2.0 * most) * 1e-6)


def test_running_in_of_hard_flanks_is_held_at_3_and_6_micrometres():
    """ISO 6336-1: 0.075 f up to 3 µm, 0.15 F_βx up to 6 µm; both reach them at 40 µm."""
    for micron in (10.0, 40.0, 90.0):
        share = min(micron, 40.0) / 40.0
        assert running_in_allowance(micron * 1e-6, HARD, 20.0) == pytest.approx(3e-6 * share)
        assert lead_allowance(micron * 1e-6, HARD, 20.0) == pytest.approx(6e-6 * share)


@pytest.mark.parametrize("teeth_", [(17, 43), (23, 25), (40, 80), (60, 90)])
def test_bevel_gears_are_as_wide_as_annex_b_allows(teeth_):
    """b = 0.30 R_e, or 10 m_et where that is less, R_e of the very pair that the width makes: rounding only."""
    rating = rating_of(HELICOPTER, "bevel")
    free = replace(rating, rules=rating.rules.model_copy(update={"face_width_ratio": None}))
    width = float(stage_width_ratio(free, *teeth_)) * 3e-3
    pair = bevel_pair(teeth_, 3e-3, width, free)
    radius = 0.5 * pair.outer_module * math.hypot(*teeth_)
    assert width == pytest.approx(min(0.30 * radius, 10.0 * pair.outer_module), rel=1e-12)


def test_a_bevel_pair_has_its_mean_module_in_the_middle_of_its_face():
    """The mean cone ends half a face before the outer one; m_mn = m_et cos β_m R_m/R_e: rounding only."""
    rating = rating_of(HELICOPTER, "bevel")
    pair = bevel_pair((17, 43), 3e-3, 20e-3, rating)
    outer = 0.5 * pair.outer_module * math.hypot(17, 43)
    assert pytest.approx(pair.outer_module * math.cos(rating.helix_angle) * (outer - 10e-3) / outer) == 3e-3
    assert BevelPair((17, 43), 4e-3, 20e-3).mean_diameters[0] == pytest.approx(
        4e-3 * 17 * (1.0 - 10e-3 / (2e-3 * math.hypot(17, 43)))
    )


def test_the_rim_under_a_gear_is_counted_in_teeth_of_iso_53():
    """h = 2.25 m: (d_f/2 − d/2) over it, with d_f of the tooth that stands above; rounding only."""
    sizing = sized(PAIR)
    joint = next(each for each in sizing.joints if each.part == "helical.wheel")
    gear = next(each for each in sizing.gears if each.name == "helical.wheel")
    mesh = cylindrical_mesh((27, 107), gear.module, gear.face_width, rating_of(sizing.design, "helical"))
    root = mesh.pitch_diameters[1] / 2.0 - gear.module * (1.25 - mesh.proportions[1].profile_shift)
    assert joint.rim == pytest.approx((root - joint.diameter / 2.0) / (2.25 * gear.module))


def stiffness_by_hand(pair, elastic_modulus):
    """Return c′ and c_γα of solid helical gears without shift under more than 100 N/mm [N/m²].

    Source: ISO 6336-1:2006, clause 9: q′ = 0.04723 + 0.15551/z_n1 + 0.25791/z_n2 mm µm/N, C_M = 0.8,
        C_B = 1 + 0.5 (1.2 − 1.25), E/206 GPa; z_n = z/(cos² β_b cos β).
    """
    assert [each.profile_shift for each in pair.proportions] == [0.0, 0.0]
    base = math.asin(math.sin(pair.helix_angle) * math.cos(math.radians(20.0)))
    first, second = (float(count) / (math.cos(base) ** 2 * math.cos(pair.helix_angle)) for count in pair.teeth)
    theory = 1e9 / (0.04723 + 0.15551 / first + 0.25791 / second)
    single = theory * 0.8 * 0.975 * math.cos(pair.helix_angle) * elastic_modulus / 206e9
    return single, single * (0.75 * pair.transverse_contact_ratio + 0.25)


def test_scuffing_takes_a_sixth_of_the_peak_to_valley_roughness_as_the_mean_one():
    """ISO 6336-2: R_a ≈ R_z/6. The mesh once more by hand, with 4 µm/6 and its relief over its own stiffness."""
    sizing = size(HELICOPTER)
    helical = next(mesh for mesh in sizing.meshes if mesh.name == "helical").rating
    rating, gears = rating_of(HELICOPTER, "helical"), {gear.name: gear for gear in sizing.gears}
    rules, pinion = rating.rules.iso6336, gears["helical.pinion"]
    assert rules.flank_roughness == pytest.approx(4e-6)
    load = float(helical.factors.tangential_force) / pinion.face_width
    loads = helical.factors.loads
    hot = rules.oil_viscosity * 1e-6 * oil_viscosity(rules.oil_temperature + 273.15) / oil_viscosity(40.0 + 273.15)
    oil = Oil(
        rules.oil_temperature,
        hot * 950.0,
        float(rules.scuffing_stage),
        supply=SPRAY,
        viscosity_40=rules.oil_viscosity * 1e-6,
    )
    pair = cylindrical_mesh((pinion.teeth, gears["helical.wheel"].teeth), pinion.module, pinion.face_width, rating)
    relief = float(helical.factors.relief.amount)
    mesh = ScuffingMesh(
        pair,
        specific_load=load * float(loads.contact),
        nominal_load=load * float(loads.application) * float(loads.mesh_load),
        speed=float(helical.factors.speed),
        roughness=4e-6 / 6.0,
        stiffness=stiffness_by_hand(pair, rating.material.elastic_modulus),
        reliefs=(relief, relief),
        grade=rules.tolerance_class,
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
    )
    assert helical.scuffing.safety == pytest.approx(integral_temperature(mesh, oil).safety, rel=1e-9)
