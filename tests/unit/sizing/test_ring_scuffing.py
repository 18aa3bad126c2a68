"""Rings of a design against scuffing and micropitting: what is judged, what is said to lie beyond the documents."""

import pytest

from designs import PAIR
from gearwright.parts.scuffing import ScuffingMesh, flash_temperature, integral_temperature
from gearwright.reviews import review
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating import rating_of
from gearwright.sizing.rating.geometry import cylindrical_mesh
from gearwright.sizing.rating.iso6336_scuffing import oil_of
from gearwright.spec import edited, parse, read

WIND = read(shipped_design("wind-turbine-5mw"))
SIZED = size(edited(WIND, {"gears.iso6336.micropitting_stage": 10}))


def mesh(name):
    return next(found for found in SIZED.meshes if found.name == name)


def checks(sizing, part, mode):
    return [check for check in sizing.checks if str(check.part) == part and check.mode == mode]


@pytest.mark.parametrize("stage", ["first", "second"])
def test_a_ring_is_as_hot_as_its_mesh_by_hand(stage):
    """w_Bt = K_A K_γ K_V K_Hβ K_Hα F_t/b at v against the carrier; c_γα = c′ (0.75 ε_α + 0.25)."""
    rated, rating = mesh(f"{stage}.planet-ring").rating, rating_of(WIND, stage, SIZED.teeth)
    gears = {gear.name: gear for gear in SIZED.gears}
    planet, ring = gears[f"{stage}.planet"], gears[f"{stage}.ring"]
    factors, rules = rated.factors, rating.rules.iso6336
    width = min(planet.face_width, ring.face_width)
    force = factors.tangential_force / width
    geometry = cylindrical_mesh((planet.teeth, ring.teeth), planet.module, width, rating, internal=True)
    single = float(factors.relief.stiffness)
    by_hand = ScuffingMesh(
        geometry,
        force * factors.loads.contact,
        force * factors.loads.application * factors.loads.mesh_load,
        factors.speed,
        rules.flank_roughness / 6.0,
        (single, single * (0.75 * float(geometry.transverse_contact_ratio) + 0.25)),
        grade=int(factors.grade),
        elastic_modulus=rating.material.elastic_modulus,
        poisson_ratio=rating.material.poisson_ratio,
        reliefs=(factors.relief.amount, factors.relief.amount),
    )
    oil = oil_of(SIZED.design.rules(stage).iso6336)
    assert rated.flash.safety == pytest.approx(flash_temperature(by_hand, oil).safety, rel=1e-12)
    if rated.scuffing is not None:
        assert rated.scuffing.safety == pytest.approx(integral_temperature(by_hand, oil).safety, rel=1e-12)


def test_contact_on_one_side_of_the_pitch_point_is_judged_by_the_flash_temperature():
    """The second ring's tip reaches just beyond it: ε_2 = −0.012."""
    assert mesh("second.planet-ring").rating.scuffing is None
    assert mesh("first.planet-ring").rating.scuffing is not None
    (check,) = checks(SIZED, "second.planet-ring", "scuffing")
    assert (check.symbol, check.clause) == ("S_B", "ISO/TS 6336-20, eq. 100")
    (check,) = checks(SIZED, "first.planet-ring", "scuffing")
    assert check.symbol == "S_intS"


def test_films_of_rings_are_rated_and_said_to_lie_beyond_the_document():
    assert len(checks(SIZED, "first.planet-ring", "micropitting")) == 1
    (told,) = checks(SIZED, "first.planet-ring", "range of u of the oil film")
    assert told.value is None
    assert not checks(SIZED, "first.sun-planet", "range of u of the oil film")
    assert not checks(size(WIND), "first.planet-ring", "range of u of the oil film")


def test_a_review_leaves_no_scuffing_open_but_where_no_case_or_method_reaches():
    opened = [check for check in review(WIND).checks if check.mode == "scuffing" and check.value is None]
    assert not opened
    text = f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n[gears]\nrating = "agma2001"\n'
    (told,) = [check for check in review(parse(text)).checks if check.mode == "scuffing"]
    assert 'AGMA 2001 does not rate it; rating = "iso6336" does' in told.why
