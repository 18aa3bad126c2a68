"""Published shifted teeth written as compound sets: centre distances, tips and spans as printed, ready for more rings.

Sources: Nejad et al. 2016, Wind Energy 19, 1089-1106, and the KISSsoft report of its stages (gfsReboucas/Drivetrain);
L. Kos, LECAD, University of Ljubljana, Planetary Transmissions, printed test run of its program.
"""

import pytest

from gearwright.dynamics.assembly import gear_pairs
from gearwright.parts.gears import span_measurement
from gearwright.sizing import cylindrical_gear, size
from gearwright.spec import parse

SET = """\
schema = 1
name = "published"
level = "concept"
shafts = ["fast", "slow"]
motors.motor = {{ shaft = "fast", power_kw = 1, speed_rpm = {speed}, balances = false }}
loads.drum = {{ shaft = "slow", speed_rpm = 100 }}
[epicyclics.set]
carrier = "slow"
sets = 3
suns.sun = {{ shaft = "fast", teeth = {sun}, module_mm = {module}, face_width_mm = {width}{sun_keys} }}
rings.ring = {{ shaft = "ground", teeth = {ring}{ring_keys} }}
planets.planet = {{ teeth = {planet}, meshes = ["sun", "ring"]{planet_keys} }}
"""


def published(teeth, module, keys, *, width=50):
    sun, planet, ring = teeth
    return size(parse(SET.format(
        speed=100.0 * (1.0 + ring / sun), sun=sun, planet=planet, ring=ring, module=module, width=width,
        sun_keys=keys[0], planet_keys=keys[1], ring_keys=keys[2],
    )))  # fmt: skip


@pytest.mark.parametrize(
    ("module", "teeth", "shifts", "centre"),
    [
        (45, (19, 17, 56), (0.617, 0.802, -0.501), 862.996e-3),
        (21, (18, 36, 93), (0.389, 0.504, 0.117), 584.002e-3),
    ],
)
def test_both_meshes_of_the_wind_turbines_sets_stand_on_one_printed_pin_circle(module, teeth, shifts, centre):
    """862.996 and 584.002 mm of the sun's mesh; the ring's, printed 5 and 2 µm less, jams or plays by that little."""
    sizing = published(teeth, module, [f", shift = {shift}" for shift in shifts])
    assert [mesh.centre_distance for mesh in sizing.meshes] == pytest.approx([centre, centre], abs=0.6e-6)
    assert sizing.carriers[0].radius == pytest.approx(centre, abs=0.6e-6)
    assert all(abs(gear_pairs(sizing)[mesh.name].backlash) < 5e-6 for mesh in sizing.meshes)


@pytest.mark.parametrize("given", [0, 1, 2])
def test_any_one_shift_and_the_housing_leave_the_published_others(given):
    """19/17/56 at 863 mm: the sums that close there differ from the printed ones by 0.00013 and 0.00017."""
    shifts = (0.617, 0.802, -0.501)
    keys = [f", shift = {shift}" if k == given else "" for k, shift in enumerate(shifts)]
    keys[1] += ", centre_distance_mm = 863"
    gears = {gear.own: gear.profile_shift for gear in published((19, 17, 56), 45, keys).gears}
    assert [gears[name] for name in ("sun", "planet", "ring")] == pytest.approx(list(shifts), abs=5e-4)


def test_tips_and_spans_of_a_printed_set_are_its_own():
    """21/43/108, m 1.75, a = 56.8 mm, x = 0.4380: planet 0.0426, tips 41.7008, 78.8170, 185.4992 mm, spans of 3 and 5
    teeth 13.9546, 24.3530 mm. Printed shifts round tips by 0.2 µm, spans by 0.06; the ring is printed 0.8 smaller."""
    sizing = published((21, 43, 108), 1.75, (", shift = 0.438", ", centre_distance_mm = 56.8", ""), width=38)
    gears = {gear.own: gear for gear in sizing.gears}
    assert gears["planet"].profile_shift == pytest.approx(0.0426, abs=6e-5)
    assert gears["ring"].profile_shift == pytest.approx(0.0, abs=3e-4)
    sun, planet = (cylindrical_gear(sizing.design, gears[name]) for name in ("sun", "planet"))
    assert 2e3 * sun.tip_radius == pytest.approx(41.7008, abs=3e-4)
    assert 2e3 * planet.tip_radius == pytest.approx(78.8170, abs=3e-4)
    assert 1e3 * span_measurement(sun, 3) == pytest.approx(13.9546, abs=2e-4)
    assert 1e3 * span_measurement(planet, 5) == pytest.approx(24.3530, abs=2e-4)
    ring = gears["ring"]
    tip = ring.pitch_diameter - 2.0 * ring.module * (1.0 + ring.profile_shift + ring.tip_alteration)
    assert 1e3 * tip == pytest.approx(185.4992, abs=1e-3)
