"""A flight loses by the formulas of its mission, and where that says nothing by those of its design."""

import functools

import pytest

from gearwright.errors import DesignError
from gearwright.mission import bearing_lives, fly
from gearwright.mission.plant import flown_oil
from gearwright.parts.losses import MeshLaw
from gearwright.sizing import size
from gearwright.spec import edited, edited_mission, read, read_mission


@functools.cache
def sized(**changes):
    return size(edited(read("ec120b"), {key.replace("__", "."): value for key, value in changes.items()}))


def sortie(**changes):
    return edited_mission(read_mission("ec120b-sortie"), {key.replace("__", "."): at for key, at in changes.items()})


def test_left_out_a_flight_has_the_oil_that_it_always_had():
    oil = flown_oil(sized(), sortie())
    assert (oil.friction, oil.bearings, oil.windage, oil.seals) == (
        MeshLaw.SCHLENK, "constant", "anderson-loewenthal", "none",
    )  # fmt: skip
    assert (oil.temperature, oil.roughness) == (read_mission("ec120b-sortie").oil.inlet_temperature_k, 0.4e-6)
    assert (*oil.grade, oil.density) == pytest.approx((26e-6, 5e-6, 950.0))


def test_the_mission_comes_before_the_design():
    asked = sized(losses__friction="iso-tr-14179-1", losses__bearings="skf", losses__roughness_um=0.8)
    assert flown_oil(asked, sortie()).friction is MeshLaw.ISO_TR_14179_1
    mission = sortie(oil__friction="niemann-winter", oil__roughness_um=0.2)
    oil = flown_oil(asked, mission)
    assert (oil.friction, oil.bearings, oil.roughness) == (MeshLaw.NIEMANN_WINTER, "skf", pytest.approx(0.2e-6))


def test_seals_take_in_flight_what_the_rotor_then_lacks():
    plain, sealed = fly(sized(), sortie()), fly(sized(), sortie(oil__seals="iso-tr-14179-2"))
    assert (sealed.history.bearing_loss > plain.history.bearing_loss).all()
    assert sealed.history.mesh_loss == pytest.approx(plain.history.mesh_loss, rel=5e-3)
    assert (sealed.history.propeller_power < plain.history.propeller_power).all()


def test_bearings_rub_in_flight_as_the_design_asks():
    rubbing = [
        float(fly(sized(losses__bearings=law), sortie()).history.bearing_loss.mean())
        for law in ("constant", "palmgren", "skf")
    ]
    assert len({round(loss) for loss in rubbing}) == 3 and min(rubbing) > 0.0


def test_a_gear_that_there_is_not_does_not_dip():
    mission = sortie()
    dipping = mission.model_copy(update={"oil": mission.oil.model_copy(update={"dip": {"helical.whel": 0.2}})})
    with pytest.raises(DesignError, match=r"oil\.dip\.helical\.whel.*did you mean"):
        fly(sized(), dipping)


def test_lives_over_a_flight_are_modified_where_the_design_asks():
    thick = {"oil__viscosity_40": 68.0, "oil__viscosity_100": 8.5, "gears__iso6336__oil_viscosity": 68.0}
    plain = {row.seat: row for row in bearing_lives(fly(sized(**thick), sortie())).rows}
    asked = fly(sized(bearing_rules__life="modified", **thick), sortie())
    for row in bearing_lives(asked).rows:
        assert row.life_factor is not None and plain[row.seat].life_factor is None
        if row.bearing == plain[row.seat].bearing:
            assert row.life == pytest.approx(row.life_factor * plain[row.seat].life, rel=1e-3)
