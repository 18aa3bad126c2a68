"""Pins of compound sets: tooth forces around and along the radius, by the balance of torques and by each mesh."""

import math

import pytest

from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.gear_geometry import pins_of
from gearwright.sizing.loads import pin_loads
from gearwright.sizing.rating import context_of, rating_of
from gearwright.spec import edited, read


@pytest.mark.parametrize("efficiency", [1.0, 0.99, 0.9])
@pytest.mark.parametrize(
    "name", ["geared-turbofan-star", "wolfrom-reducer", "contra-rotating-propellers", "ravigneaux-automatic"]
)
def test_forces_on_pins_have_the_carriers_torque_in_every_case_with_losses_too(name, efficiency):
    """Σ N r_c F_t over the bodies of a set is T_c K_γ: equilibrium of the carrier; once 0.4 % apart with losses."""
    design = edited(read(shipped_design(name)), {"gears.mesh_efficiency": efficiency})
    sizing = size(design)
    ((stage, epicyclic),) = design.epicyclics.items()
    context = context_of(design, sizing.train, sizing.teeth, sizing.flows, {})
    gears = {gear.own: gear for gear in sizing.gears}
    centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes}
    radii = {body: abs(place) for body, place in pins_of(epicyclic, gears, centres).items()}
    loads = pin_loads(context, stage, gears)
    for case, flow in sizing.flows.items():
        around = sum(load.tangential * radii[load.body] for load in loads if load.case == case) * epicyclic.sets
        torques = [flow.meshes[mesh.name].torques[2] for mesh in sizing.train.meshes]
        expected = sum(torques) * context.ratings[stage].load_factor
        assert around == pytest.approx(expected, abs=1e-9 * max(map(abs, torques)))


@pytest.mark.parametrize("name", ["geared-turbofan-star", "wolfrom-reducer", "contra-rotating-propellers"])
def test_a_pin_bears_the_carriers_torque_around_and_what_separates_teeth_along_the_radius(name):
    """Of one planet body a set: F_t = T_c K_γ/(N r_c); suns push outwards and rings inwards, each F tan α_n. Without
    losses, whose friction is no force on a pin. Rounding, relative to the largest force."""
    sizing = size(edited(read(shipped_design(name)), {"gears.mesh_efficiency": 1.0}))
    (carrier,) = (carrier for carrier in sizing.carriers if carrier.stage in sizing.design.epicyclics)
    stage, rules = sizing.design.epicyclics[carrier.stage], rating_of(sizing.design, carrier.stage)
    gears = {gear.name: gear for gear in sizing.gears}
    flow, torque, outwards, largest = sizing.flows[carrier.case], 0.0, 0.0, 0.0
    for mesh in (mesh for mesh in sizing.train.meshes if mesh.stage == carrier.stage):
        central = next(gears[gear] for gear in mesh.gears if gears[gear].own not in stage.planets)
        force = abs(flow.meshes[mesh.name].multiplier) * central.teeth / (central.pitch_diameter / 2.0)
        force *= rules.load_factor / mesh.count
        torque += flow.meshes[mesh.name].torques[2]
        outwards += math.copysign(force, 1.0 if central.own in stage.suns else -1.0) * math.tan(
            rules.rules.pressure_angle
        )
        largest = max(largest, force)
    around = abs(torque) * rules.load_factor / (stage.sets * carrier.radius)
    assert carrier.tangential_force == pytest.approx(around, abs=1e-9 * largest)
    assert carrier.radial_force == pytest.approx(outwards, abs=1e-9 * largest)
