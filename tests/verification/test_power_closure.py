"""Power closes in every shipped design, case and direction; the efficiency of planetary sets in closed form."""

import pytest

from gearwright.shipped import shipped_designs
from gearwright.spec import Case, Drive, case_named, cases_of, drives_of, parse
from gearwright.train import build_train, power_flow
from shipped_work import sized

CLOSURE = 1e-12
"""Part of the supplied power that rounding may leave."""


def machine_modes(design):
    """Return what machines can do alone: each drives the rest, and motors also generate."""
    turbines = {name: Drive(power=machine.power) for name, machine in design.turbines.items()}
    motors = {name: Drive(power=machine.power) for name, machine in design.motors.items()}
    modes = {"turbines alone": turbines, "motors generate": dict(turbines)}
    for name, motor in design.motors.items():
        modes["motors generate"][name] = Drive(power=-0.2 * motor.power)
    modes |= {f"{name} alone": {name: drive} for name, drive in {**turbines, **motors}.items()}
    rotors = {name: Drive(power=machine.power) for name in design.rotors for machine in design.generators.values()}
    modes |= {f"{name} turns the generator": {name: drive} for name, drive in rotors.items()}
    engaged = next((case.engaged for case in design.cases.values()), None)
    return {name: Case.model_validate({**drives, "engaged": engaged}) for name, drives in modes.items() if drives}


def backwards(design):
    """Return the cases that last, with every stated power and torque the other way round, whatever a machine is for."""
    lasting = [case for case in cases_of(design) if not case_named(design, case).static]
    drives = {case: drives_of(design, case) for case in lasting}
    turned = {case: {name: reversed_drive(drive) for name, drive in drives[case].items()} for case in lasting}
    return {case: {**turned[case], "engaged": case_named(design, case).engaged} for case in lasting}


def reversed_drive(drive):
    """Return a drive that gives what it took."""
    turned = {key: -value for key in ("power", "torque") if (value := getattr(drive, key)) is not None}
    return drive.model_copy(update=turned)


@pytest.mark.parametrize("name", shipped_designs())
def test_power_closes_in_every_case_of_every_shipped_design(name):
    for flow in sized(name).flows.values():
        assert flow.residual < CLOSURE


@pytest.mark.parametrize("name", shipped_designs())
def test_power_closes_backwards_in_every_case_that_lasts(name):
    """Freewheels made rigid: what drives is driven, and speeds stay what they are."""
    sizing = sized(name)
    held = {
        key: clutch.model_copy(update={"kind": "engaged"}) if clutch.kind == "overrunning" else clutch
        for key, clutch in sizing.design.clutches.items()
    }
    rigid = sizing.design.model_copy(update={"clutches": held})
    cases = {case: Case.model_validate(drives) for case, drives in backwards(rigid).items()}
    turned = rigid.model_copy(update={"cases": cases})
    for case in cases:
        forth = power_flow(rigid, build_train(rigid), sizing.teeth, case)
        back = power_flow(turned, build_train(turned), sizing.teeth, case)
        assert max(forth.residual, back.residual) < CLOSURE
        assert {name: -power for name, power in back.machine_powers.items()} == pytest.approx(
            dict(forth.machine_powers), rel=1e-9, abs=1e-6
        )


@pytest.mark.parametrize("lossy", [False, True])
@pytest.mark.parametrize("name", [name for name in shipped_designs() if name != "differential-hybrid"])
def test_power_closes_when_machines_drive_alone_or_motors_generate(name, lossy):
    """A machine left out idles. Losses follow the direction of the power: no case makes any."""
    sizing = sized(name)
    modes = machine_modes(sizing.design)
    design = sizing.design.model_copy(update={"cases": modes})
    efficiency = dict.fromkeys(design.stages, 0.99) if lossy else None
    for mode in modes:
        flow = power_flow(design, sizing.train, sizing.teeth, mode, efficiency=efficiency)
        assert flow.residual < CLOSURE, mode
        supplied = max(flow.machine_powers.values())
        assert all(mesh.loss >= -CLOSURE * supplied for mesh in flow.meshes.values()), mode
        assert (flow.loss > CLOSURE * supplied) is lossy, mode


def test_a_differential_closes_with_both_speeds_given_and_losses():
    sizing = sized("differential-hybrid")
    efficiency = dict.fromkeys(sizing.design.stages, 0.99)
    flow = power_flow(sizing.design, sizing.train, sizing.teeth, efficiency=efficiency)
    assert flow.residual < CLOSURE
    assert flow.loss > 0.0


SET = """\
schema = 1
name = "one planetary set"
level = "concept"
shafts = ["sun", "carrier"]
[turbines.turbine]
shaft = "{driving}"
power_kw = 100
speed_rpm = 6000
[propellers.propeller]
shaft = "{driven}"
speed_rpm = 1000
diameter_m = 2
[planetaries.set]
sun = "sun"
ring = "ground"
carrier = "carrier"
"""


@pytest.mark.parametrize(
    ("driving", "driven", "published"),
    [("sun", "carrier", 0.9876666666666667), ("carrier", "sun", 0.9876336898395721)],
)
def test_the_efficiency_of_a_planetary_set_is_the_closed_form(driving, driven, published):
    """i_0 = -4.625, η_0 = 0.985 over both meshes: (1 - i_0 η_0)/(1 - i_0) and (1 - i_0)/(1 - i_0/η_0).

    Müller 1998, Die Umlaufgetriebe; Wolf 1958. Power through teeth is relative to the carrier. Equality up to rounding.
    """
    design = parse(SET.format(driving=driving, driven=driven))
    teeth = {"set.sun": 16, "set.planet": 29, "set.ring": 74}
    flow = power_flow(design, build_train(design), teeth, efficiency={"set": 0.985**0.5})
    assert -flow.machine_powers["propeller"] / flow.machine_powers["turbine"] == pytest.approx(published, rel=1e-12)
    assert flow.residual < CLOSURE


def test_a_lossless_mesh_loses_nothing():
    flow = sized("in-line-h2").flows["rated"]
    assert all(abs(mesh.loss) <= CLOSURE * abs(mesh.tooth_power) for mesh in flow.meshes.values())
