"""Where the power of a case goes: sums, hand calculations, methods, and what cannot be."""

import functools
import math

import pytest

from gearwright.errors import DesignError
from gearwright.parts.losses import mesh_friction, oil_viscosity, tooth_contact
from gearwright.sizing import size
from gearwright.sizing.losses import loss_balance, teeth_of
from gearwright.sizing.shafts.ends import exits_of
from gearwright.spec import edited, read
from gearwright.units import RPM

near = pytest.approx


@functools.cache
def sized(name="ec120b", **changes):
    return size(edited(read(name), {key.replace("__", "."): value for key, value in changes.items()}))


def power(sizing, origin):
    return loss_balance(sizing).by_origin().get(origin, 0.0)


def test_the_parts_add_up_to_what_is_lost():
    balance = loss_balance(sized())
    assert balance.power == near(376e3)
    assert sum(balance.by_origin().values()) == near(balance.lost)
    assert balance.efficiency == near(1.0 - balance.lost / 376e3)
    assert sum(loss.share for loss in balance.losses) == near(1.0 - balance.efficiency)


def test_a_mesh_loses_its_power_times_friction_times_loss_factor():
    """ec120b's helical pair by hand from its sizes: P μ H_V with the oil of [oil] at 90 °C."""
    sizing = sized()
    mesh = next(mesh for mesh in sizing.meshes if mesh.stage == "helical")
    k = [row.name for row in sizing.train.meshes].index(mesh.name)
    pinion = next(gear for gear in sizing.gears if gear.name == "helical.pinion")
    contact = teeth_of(sizing).contacts[k]
    flow = sizing.reference
    torque, turning = flow.meshes[mesh.name].torques[0], flow.speeds[pinion.shafts[0]]
    normal = abs(torque) / (teeth_of(sizing).radii[k] * math.cos(contact.pressure_angle))
    friction = mesh_friction(
        contact, normal / pinion.face_width, turning * teeth_of(sizing).radii[k],
        viscosity=oil_viscosity(363.15) * 950.0, roughness=0.4e-6,
    )  # fmt: skip
    row = next(loss for loss in loss_balance(sizing).losses if loss.part == mesh.name)
    assert row.power == near(abs(torque * turning) * friction * contact.loss_factor)


@pytest.mark.parametrize("friction", ["niemann-winter", "iso-tr-14179-1", "anderson-loewenthal"])
def test_the_friction_of_the_teeth_is_a_choice(friction):
    changed = sized(losses__friction=friction)
    assert 0.2 * power(sized(), "meshes") < power(changed, "meshes") < 3.0 * power(sized(), "meshes")
    assert power(changed, "bearings") == power(sized(), "bearings")
    assert {loss.method for loss in loss_balance(changed).losses if loss.origin == "meshes"} == {friction}


@pytest.mark.parametrize("bearings", ["palmgren", "skf"])
def test_the_friction_of_the_bearings_is_a_choice_and_sees_thrust(bearings):
    rows = {loss.part: loss for loss in loss_balance(sized(losses__bearings=bearings)).losses}
    plain = {loss.part: loss for loss in loss_balance(sized()).losses}
    assert rows["input-axial"].power > plain["input-axial"].power == 0.0
    assert rows["input-rear"].method == bearings
    assert 0.3 < rows["input-rear"].power / plain["input-rear"].power < 5.0


def test_bearings_of_unknown_size_rub_by_a_constant_and_say_so():
    rows = loss_balance(sized("single-planetary", losses__bearings="skf")).losses
    assert {loss.method for loss in rows if loss.origin == "bearings"} == {"constant"}


@pytest.mark.parametrize("seals", ["iso-tr-14179-1", "iso-tr-14179-2", "simrit"])
def test_each_machine_has_a_seal_where_seals_are_counted(seals):
    sizing = sized(losses__seals=seals)
    rows = [loss for loss in loss_balance(sizing).losses if loss.origin == "seals"]
    assert len(rows) == len(sizing.machines) and power(sized(), "seals") == 0.0
    if seals == "iso-tr-14179-2":
        for leaves in exits_of(sizing):
            turns = abs(sizing.reference.speeds[leaves.shaft]) / RPM
            row = next(loss for loss in rows if loss.part == f"seal at {leaves.machine}")
            assert row.power == near(7.69e-6 * (1e3 * leaves.seal.shaft) ** 2 * turns)


def test_a_seal_of_nitrile_rubs_less_than_one_of_fluoro_rubber():
    """ISO/TR 14179-1: 2.429e-3 and 3.737e-3 N m per mm of the shaft; nitrile is asked for and would not be chosen."""
    method = {"losses__seals": "iso-tr-14179-1"}
    nitrile, fluoro = (power(sized(**method, shafting__seal=lip), "seals") for lip in ("nbr", "fkm"))
    assert nitrile / fluoro == near(2.429 / 3.737)


def test_a_gear_that_dips_churns_instead_of_stirring_mist():
    design = read("ec120b")
    bath = design.model_copy(update={"losses": design.losses.model_copy(update={"dip": {"helical.wheel": 0.3}})})
    rows = {loss.part: loss for loss in loss_balance(size(bath)).losses}
    assert rows["helical.wheel"].origin == "churning" and rows["helical.pinion"].origin == "windage"
    wrong = design.model_copy(update={"losses": design.losses.model_copy(update={"dip": {"helical.whel": 0.3}})})
    with pytest.raises(DesignError, match=r"losses\.dip\.helical\.whel.*did you mean"):
        size(wrong)
    deep = design.model_copy(update={"losses": design.losses.model_copy(update={"dip": {"helical.wheel": 1.3}})})
    with pytest.raises(DesignError, match=r"losses\.dip\.helical\.wheel: 1\.3 of a gear cannot dip"):
        size(deep)


def test_windage_in_air_takes_its_housing():
    free, boxed = (sized(losses__windage="dawson", losses__enclosure=part) for part in (1.0, 0.6))
    assert power(boxed, "windage") == near(0.6 * power(free, "windage"))


def test_a_case_that_there_is_not_is_refused():
    with pytest.raises(DesignError, match="case"):
        loss_balance(sized(), "takeof")


def test_a_train_at_no_load_loses_only_what_turns():
    """Friction of teeth is nothing without a load."""
    contact = tooth_contact((30, 90), 3e-3, pressure_angle=0.35)
    assert mesh_friction(contact, 0.0, 20.0, viscosity=8e-3, roughness=0.4e-6) == 0.0
