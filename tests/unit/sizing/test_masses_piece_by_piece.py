"""Pieces of the complete mass by hand: what planets turn on, seals, sensors and drives, how uncertainties add."""

import math
from functools import cache

import pytest

import gearwright as gw
from gearwright.catalogue import bearings
from gearwright.catalogue.bearing_choice import loaded_mass, rating_for, similar
from gearwright.parts.gears import blank_volume
from gearwright.sizing.casing import flanges_of, screw_volume, shell_of
from gearwright.sizing.mass import CompleteMass, MassItem, complete_mass, gear_blanks
from gearwright.sizing.mass.bodies import planet_bores, seat_duties
from gearwright.sizing.mass.complete import detail_items
from gearwright.sizing.mass.record import requirement_of
from gearwright.sizing.places import bells
from gearwright.spec import edited

near = pytest.approx


@cache
def sized(name, changes=()):
    return gw.size(edited(gw.read(name), dict(changes)))


def test_a_planet_turns_on_the_bearing_that_its_load_asks_for_within_its_rim():
    """0.69 π/4 b 7850 (D² − d²) = m(C), at least 0.08 d of section and at most d_p − 2 (1.2 · 2.25 + 1.25) m."""
    sizing = sized("in-line-h2")
    duties = list(seat_duties(sizing))
    pins = {carrier.stage: carrier.pin_diameter for carrier in sizing.carriers}
    bores = planet_bores(sizing, duties)
    assert bores
    for gear in sizing.gears:
        if gear.name not in bores:
            continue
        bore, pin = bores[gear.name], pins[gear.part.name]
        rating = max(duty.rating for duty in duties if duty.seat.part.name == gear.part.name)
        wanted = math.sqrt(pin**2 + loaded_mass(rating) / (0.69 * math.pi / 4.0 * gear.face_width * 7850.0))
        room = gear.pitch_diameter - 2.0 * 3.95 * gear.module
        outside = max(min(max(wanted, 1.16 * pin), room), pin)
        assert bore.bearing_diameter == near(outside)
        assert bore.mass == near(0.69 * math.pi / 4.0 * gear.face_width * 7850.0 * (outside**2 - pin**2))
        assert bore.crowded == (wanted > outside) and not bore.named
        assert bore.equal == gear.bodies


def test_similar_bearings_weigh_by_their_loads_and_bores():
    """Means over NU 2, 22, 3 and 23 of 30 to 150 mm: C/m^(2/3) of all, m/d³ of the light quarter."""
    usual = [size for name, size in bearings().items() if name.startswith(("NU 2", "NU 3"))]
    rollers = [size for size in usual if 0.03 <= size.bore <= 0.15]
    assert len(rollers) == 4 * 21
    logs = [math.log(size.dynamic_rating / size.mass ** (2.0 / 3.0)) for size in rollers]
    assert similar().by_load == near(math.exp(sum(logs) / len(logs)))
    bores = sorted(math.log(size.mass / size.bore**3) for size in rollers)
    place = 0.25 * (len(bores) - 1)
    below = int(place)
    assert similar().by_bore == near(
        math.exp(bores[below] + (place - below) * (bores[below + 1] - bores[below])), rel=1e-9
    )
    assert loaded_mass(2.0**2 * similar().by_load) == near(8.0)  # twice as large in all: four times C, eight times m
    assert rating_for(10e3, 3600.0 * 1e3, 2.0 * math.pi * 1e6 / 3.6e6) == near(10e3)  # one million turns in all
    assert rating_for(10e3, 3600.0 * 1e3, -2.0 * math.pi * 1e9 / 3.6e6) == near(10e3 * 1000.0**0.3)


def test_details_are_seals_sensors_drives_and_a_share_of_the_rest():
    """40 kg/m² d² a machine, 0.8 kg of sensors, 1.5 kg an accessory's drive, 5 % of 30 kg; each ± half."""
    sizing = sized("in-line-h2", (("housing.accessory_drives", 2),))
    counted = [
        MassItem("wheel", "gears", 3, 10.0, 0.1, "", ""),
        MassItem("oil", "lubrication", 1, 99.0, 0.1, "", ""),
        MassItem("lid", "details", 1, 99.0, 0.1, "", ""),
    ]
    items = {item.part: item for item in detail_items(sizing, counted)}
    diameters = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    for machine in sizing.machines:
        assert items[f"{machine.name} seal"].total == near(40.0 * diameters[machine.shaft] ** 2)
    assert items["accessory drives"].total == near(3.0)
    assert items["fasteners and small parts"].total == near(1.5)
    assert "sensors" not in items or items["sensors"].total == near(0.8)
    assert {item.uncertainty for item in items.values()} == {0.5}


def test_parts_of_a_group_err_alike_and_groups_apart():
    """s = √((10 · 0.1 + 2 · 20 · 0.3)² + (30 · 0.2)²), m = 80 kg, factor 1 + s/m."""
    parts = (
        MassItem("pinion", "gears", 1, 10.0, 0.1, "", ""),
        MassItem("wheel", "gears", 2, 20.0, 0.3, "", ""),
        MassItem("case", "housing", 1, 30.0, 0.2, "", ""),
    )
    mass = CompleteMass("any", parts, 1.05)
    assert mass.total == near(80.0)
    assert mass.deviation == near(math.hypot(10.0 * 0.1 + 40.0 * 0.3, 6.0))
    assert mass.factor == near(1.0 + mass.deviation / 80.0)
    assert mass.band == near((80.0 / mass.factor, 80.0 * mass.factor))
    assert CompleteMass("any", parts, 1.5).factor == 1.5
    assert mass.of("gears") == near(50.0) and mass.of("details") == 0.0


def test_weights_by_statistics_are_asked_with_the_fastest_engine_and_the_largest_load():
    sizing = sized("in-line-h2")
    flow, machines = sizing.reference, sizing.design.machines
    need = requirement_of(sizing)
    powers = flow.machine_powers
    engines = [abs(flow.speeds[machines[name].shaft]) for name in powers if powers[name] > 0.0]
    largest = min(powers, key=powers.get)
    assert len(engines) > 1 and powers[largest] < 0.0
    assert need.power == sizing.rated_power
    assert need.engine_speed == max(engines)
    assert need.propeller_speed == abs(flow.speeds[machines[largest].shaft])


@pytest.mark.parametrize("share", [0.3, 0.45, 0.7, 0.95])
def test_a_lightened_wheel_has_a_web_for_the_share_of_its_disc(share):
    """Rim, hub and web together weigh the share of the disc between root and bore."""
    sizing = sized("off-set", (("gears.web_ratio", share),))
    blank = gear_blanks(sizing)["second.wheel"]
    assert not blank.is_solid and blank.bore_radius < blank.hub_radius
    assert 0.0 < blank.web_width <= blank.width
    disc = math.pi * (blank.root_radius**2 - blank.bore_radius**2) * blank.width
    assert blank_volume(blank) == near(share * disc, rel=1e-9)
    module = next(gear.module for gear in sizing.gears if gear.name == "second.wheel")
    rim = blank.root_radius - 1.2 * 2.25 * module
    assert blank.rim_radius == near(rim) or (blank.rim_radius > rim and blank.web_width < 0.3 * blank.width)


def test_a_wheel_of_little_of_its_disc_keeps_a_rim_that_can_be_rated():
    """ISO 6336-3, clause 9: s_R >= 0.5 h_t. The share is met by a thinner web, down to a twentieth of the width."""
    for share, is_met in ((0.15, True), (0.02, False)):
        sizing = sized("differential-hybrid", (("pairs.motor-stage.gears.web_ratio", share),))
        blank = gear_blanks(sizing)["motor-stage.wheel"]
        module = next(gear.module for gear in sizing.gears if gear.name == "motor-stage.wheel")
        disc = math.pi * (blank.root_radius**2 - blank.bore_radius**2) * blank.width
        assert blank.root_radius - blank.rim_radius == near(0.5 * 2.25 * module)
        if is_met:
            assert blank_volume(blank) == near(share * disc, rel=1e-9)
        else:
            assert blank.web_width == near(0.05 * blank.width) and blank_volume(blank) > share * disc


def test_screws_of_a_flange_grip_its_torque():
    """n π/4 d² σ μ r ≥ T, n ≥ U/(5 d), r = U/(2 π), σ = 700 N/mm², μ = 0.15: a thread of ISO 261, M6 at least."""
    sizing = sized("in-line-h2")
    shell = shell_of(sizing)._replace(girth=0.9)
    for torque, thread in ((100.0, 6e-3), (10e3, 6e-3), (40e3, 20e-3), (1.3 * 40e3, 30e-3)):
        flanges = flanges_of(sizing, shell, torque)
        section = flanges.screws * math.pi / 4.0 * flanges.thread**2
        assert flanges.thread == thread and section * 700e6 * 0.15 * 0.9 / (2.0 * math.pi) >= torque
        assert 0.9 / flanges.screws <= 5.0 * thread < 0.9 / (flanges.screws - 1)
        assert (flanges.number, flanges.thickness) == (3, 1.2 * thread)  # one more than sets


def test_a_screw_with_its_nut_is_seven_cubed_diameters():
    """M6 x 24 with head 4 high and nut 5.2 high, both 10 across flats, two washers 12 x 1.6 of ISO 7089, by hand."""
    flats = math.sqrt(3.0) / 2.0 * 10.0**2
    by_hand = 24.0 * math.pi * 9.0 + 4.0 * flats + 5.2 * (flats - math.pi * 9.0) + 3.2 * math.pi * (36.0 - 3.2**2)
    assert screw_volume(6.0) == near(by_hand, rel=0.06)


@pytest.mark.parametrize("name", ["geared-turbofan-star", "star", "wolfrom-reducer"])
def test_a_turning_ring_hangs_on_a_bell_as_thick_as_its_torque_asks(name):
    """t = 2 T/(π d² τ) at the hub, τ = R_p/(2 S), a cone to a third or 3 mm, a wall of 3 mm; integrated in slices."""
    sizing = sized(name)
    item = next(item for item in complete_mass(sizing).parts if item.part.endswith(" bell"))
    ring = next(gear for gear in sizing.gears if item.part == f"{gear.name} bell")
    hub = next(shaft.diameter for shaft in sizing.shafts if shaft.name in ring.shafts) / 2.0
    material, safety = sizing.design.shaft_material, sizing.design.shafting.safety
    rows = [mesh for mesh in sizing.train.meshes if ring.name in mesh.gears]
    torque = abs(sum(sizing.reference.meshes[mesh.name].torques[mesh.gears.index(ring.name)] for mesh in rows))
    asked = torque / (2.0 * math.pi * hub**2 * material.yield_strength / safety / 2.0)
    thick = max(asked, 3e-3)
    thin = max(thick / 3.0, 3e-3)
    outside = ring.pitch_diameter / 2.0 + ring.rim
    (bell,) = bells(sizing)
    length = abs(bell.disc[0] - bell.middle) - ring.face_width / 2.0
    knee = hub * math.sqrt(thick / thin)

    def wall(radius):
        return thin + (thick - thin) * max(knee - radius, 0.0) / max(knee - hub, 1e-12)

    step = (outside - hub) / 20000
    disc = sum(2.0 * math.pi * r * wall(r) * step for r in (hub + (k + 0.5) * step for k in range(20000)))
    rim = math.pi * (outside**2 - (outside - 3e-3) ** 2) * length
    assert item.each == near(material.density * (disc + rim), rel=1e-6)
    assert abs(bell.disc[1] - bell.disc[0]) == near(thick)
    assert ("cone" in item.formula) and (len(bell.section) == 7) == (thick > thin + 5e-4)
