"""Planetary sets: what is fixed, what floats, what errors and phases do."""

import math
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from gearwright.dynamics.equations import line_state, modes, statics
from gearwright.dynamics.model import Member, Model, PlanetarySet, PlanetError, add_planetary, rotational
from gearwright.dynamics.vibration import load_shares, mode_families
from gearwright.errors import DesignError
from gearwright.parts.planetary import PlanetPhases, even_positions
from gearwright.parts.stiffness import StiffnessCurve, stiffness_at

ANGLE = math.radians(22.0)


def planetary(planets=4, **changes):
    """A set of base radii 40, 50 and 140 mm; the pins stand where the base circles ask: r_c cos α = 90 mm."""
    base = PlanetarySet(
        sun=Member(0.6, 6e-4, 0.04, 1e8),
        ring=Member(3.0, 0.06, 0.14, 1e9, 5e7),
        carrier=Member(6.0, 0.05, 0.09 / math.cos(ANGLE), 2e8),
        planet=Member(0.8, 1e-3, 0.05, 3e8),
        sun_mesh=StiffnessCurve(4e8),
        ring_mesh=StiffnessCurve(5e8),
        pressure_angles=(ANGLE, ANGLE),
        positions=even_positions(planets),
    )
    return replace(base, **changes)


def model_of(given_set, **more):
    model = Model()
    add_planetary(model, given_set, **more)
    return model


def loaded(given_set, torque=100.0, **more):
    """The set with a torque on the sun that the carrier balances; the ring is held."""
    model = model_of(given_set, **more)
    model.load("sun", constant=torque)
    model.load("carrier", constant=-torque * (1.0 + 0.14 / 0.04))
    return model.build()


@settings(max_examples=25)
@given(st.integers(3, 7), st.floats(7.0, 9.5), st.floats(7.0, 9.5), st.floats(0.0, math.pi))
def test_modes_come_in_three_families(planets, support, pin, turn):
    """Lin & Parker 1999: 6 rotational (one of them rigid), 6 translational pairs, 3 planet modes of multiplicity N − 3.

    The first planet may stand anywhere; a frequency met by chance by two families may look mixed, which one in ten
    million random sets does.
    """
    given_set = planetary(planets, positions=tuple(turn + psi for psi in even_positions(planets)))
    given_set = replace(
        given_set,
        sun=replace(given_set.sun, support=10.0**support),
        planet=replace(given_set.planet, support=10.0**pin),
    )
    system = model_of(given_set).build()
    count = Counter(mode_families(system, modes(system), given_set.positions))
    assert count == Counter({"rigid": 1, "rotational": 5, "translational": 12, "planet": 3 * (planets - 3)})


@pytest.mark.parametrize("planets", [3, 5, 7])
def test_without_translations_only_rotations_are_left(planets):
    """Kahraman 1994: sun, ring, carrier and N planets turn."""
    system = model_of(rotational(planetary(planets))).build()
    assert set(system.labels.coordinate_units) == {"rad"}
    assert len(system.labels.coordinates) == 3 + planets


def test_rigid_pins_are_the_limit_of_stiff_ones():
    """A pin 1e5 times stiffer than the meshes moves the lowest frequencies by less than 1e-4."""
    stiff = replace(planetary(), planet=replace(planetary().planet, support=5e13))
    rigid = replace(planetary(), planet=replace(planetary().planet, support=math.inf))
    found = [modes(model_of(each).build()).frequency[1:10] for each in (stiff, rigid)]
    assert found[0] == pytest.approx(found[1], rel=1e-4)


def test_a_fixed_ring_is_the_limit_of_a_stiff_one():
    stiff = replace(planetary(), ring=Member(3.0, 0.06, 0.14, 1e14, 1e13))
    fixed = replace(planetary(), ring=Member(3.0, 0.06, 0.14, math.inf, math.inf))
    found = [modes(model_of(each).build()).frequency[1:10] for each in (stiff, fixed)]
    assert found[0] == pytest.approx(found[1], rel=1e-4)


def test_the_other_flanks_give_the_same_frequencies_and_forces():
    """Mirror the set and the torque: every frequency and every mesh force stays."""
    forward, backward = planetary(5), planetary(5, flank=-1)
    found = [modes(model_of(each).build()).frequency for each in (forward, backward)]
    assert found[0] == pytest.approx(found[1], rel=1e-9)
    one, other = statics(loaded(forward)), statics(loaded(backward, -100.0))
    meshes = [n for n, kind in enumerate(one.labels.line_kinds) if kind == "mesh"]
    assert np.all(one.force[meshes] > 0.0)
    assert other.force[meshes] == pytest.approx(one.force[meshes])


def test_mesh_forces_carry_the_torque_of_the_sun():
    """Each of N meshes bears T/(N r_s), on sun and ring alike, without errors."""
    system = loaded(planetary(4))
    found = statics(system)
    forces = {name: force for name, force in zip(system.labels.lines, found.force, strict=True) if "planet" in name}
    for n in range(1, 5):
        assert forces[f"sun-planet-{n}"] == pytest.approx(100.0 / 4 / 0.04)
        assert forces[f"planet-ring-{n}"] == pytest.approx(100.0 / 4 / 0.04)
        assert forces[f"planet-{n}.pin.tangential"] == pytest.approx(-2.0 * math.cos(ANGLE) * 100.0 / 4 / 0.04)


def test_backlash_does_not_matter_while_every_mesh_is_pressed_and_turns_round_with_the_torque():
    """The dead zone lies on the side that the torque leaves; reversed, the force is reached on the far flanks."""
    tight, loose = planetary(4), planetary(4, backlash=(2e-4, 2e-4))
    meshes = [n for n, kind in enumerate(loaded(tight).labels.line_kinds) if kind == "mesh"]
    forces = [statics(loaded(each)).force[meshes] for each in (tight, loose)]
    assert forces[0] == pytest.approx(forces[1])
    assert statics(loaded(loose, -100.0)).force[meshes] == pytest.approx(-forces[0], rel=1e-6)


@pytest.mark.parametrize("pin", [3e8, math.inf])
def test_a_thick_tooth_and_a_lagging_pin_take_more_load(pin):
    """Both close the sun mesh before its neighbours'. On elastic pins less than on rigid ones, but more than 1/N."""
    base = replace(planetary(4), planet=replace(planetary(4).planet, support=pin))
    for error in (PlanetError(tooth_thickness=2e-6), PlanetError(tangential=-2e-6)):
        system = loaded(replace(base, errors={2: error}))
        shares = load_shares(statics(system).force, system.labels)
        assert int(np.argmax(shares)) == 1 and shares[1] > 0.25


def test_a_radial_pin_error_alone_is_borne_alike_by_sun_and_ring():
    """Moving out opens the sun mesh and closes the ring's by the same amount, which the planet's turn evens out."""
    base = rotational(planetary(4, ring_mesh=StiffnessCurve(4e8)))
    system = loaded(replace(base, errors={3: PlanetError(radial=5e-6)}))
    assert load_shares(statics(system).force, system.labels) == pytest.approx([0.25] * 4)


def test_run_out_of_the_sun_goes_once_around_per_turn_and_a_floating_sun_escapes_it():
    """N = 3 on a floating sun is statically determinate: equal shares at every instant; on rigid bearings not.

    The floating sun's own centrifugal force, m e Ω² = 0.012 N of 2500 N, leaves 5e-6.
    """
    speeds = {"carrier": 100.0}
    held = rotational(planetary(3))
    held = replace(held, sun=replace(held.sun, run_out=2e-6), ring=replace(held.ring, torsion=math.inf))
    free = replace(held, sun=replace(held.sun, support=0.0))
    turn = 2.0 * math.pi / (100.0 * 0.14 / 0.04)  # of the sun against the carrier
    system = loaded(held, speeds=speeds)
    shares = np.array(
        [load_shares(statics(system, time=turn * part).force, system.labels) for part in (0.0, 1 / 3, 2 / 3, 1.0)]
    )
    assert np.ptp(shares[:, 0]) > 0.01
    # A third of a turn takes the eccentricity from one planet to the next.
    assert shares[1] == pytest.approx(np.roll(shares[0], 1))
    assert shares[3] == pytest.approx(shares[0])
    system = loaded(free, speeds=speeds)
    assert load_shares(statics(system, time=0.3 * turn).force, system.labels) == pytest.approx(
        [1.0 / 3.0] * 3, abs=5e-6
    )


def test_mesh_stiffness_follows_its_curve_with_the_planets_phase():
    """k(φ + 2π γ) with φ = z_s (θ_s − θ_c); rounding only."""
    curve = StiffnessCurve(4e8, (5e7, 1e7), (2e7, -1e7))
    phases = PlanetPhases((0.0, 0.25, 0.5, 0.75), (0.5, 0.75, 0.0, 0.25))
    given_set = planetary(4, sun_mesh=curve, ring_mesh=curve, sun_teeth=27, phases=phases)
    system = model_of(given_set, speeds={"carrier": 10.0}).build()
    time, rest = 0.0123, np.zeros(len(system.arrays.mass))
    stiffness = line_state(system.arrays, time, rest, rest).stiffness
    phase = 27 * 10.0 * 0.14 / 0.04 * time
    for n in range(4):
        for name, shift in ((f"sun-planet-{n + 1}", phases.sun[n]), (f"planet-ring-{n + 1}", phases.ring[n])):
            found = stiffness[system.labels.lines.index(name)]
            assert found == pytest.approx(float(stiffness_at(curve, phase + 2.0 * math.pi * shift)))


@pytest.mark.parametrize(("sun_teeth", "silent"), [(24, "translations"), (25, "rotation"), (26, "both")])
def test_phases_choose_what_the_sun_does(sun_teeth, silent):
    """Parker 2000: l z_s mod N = 0 moves the sun in rotation only, 1 or N − 1 in translation only, others not at all.

    Quasi-static over one mesh cycle, N = 4, first harmonic of a stiffness that varies by a tenth: silent is below
    1e-13 m (rounding of a millimetre), the rest moves by more than 1e-9 m.
    """
    curve = StiffnessCurve(4e8, (3e7, 1e7), (1e7, 0.0))
    # The ring meshes stay even: with equal curves half a cycle apart, sun and ring would cancel each other.
    phases = PlanetPhases(tuple(-sun_teeth * n / 4 % 1.0 for n in range(4)), (0.0,) * 4)
    system = loaded(planetary(4, sun_mesh=curve, sun_teeth=sun_teeth, phases=phases), speeds={"carrier": 1.0})
    rate = sun_teeth * 1.0 * 0.14 / 0.04
    cycle = 2.0 * np.pi / rate * np.arange(16) / 16
    places = np.array([statics(system, time=float(time)).position for time in cycle])
    names = system.labels.coordinates
    first = np.abs(np.fft.rfft(places, axis=0))[1]
    moving = {"rotation": first[names.index("sun")] * 0.04, "translations": first[names.index("sun.x")]}
    for motion, size in moving.items():
        if silent in (motion, "both"):
            assert size < 1e-13
        else:
            assert size > 1e-9


def test_the_carriers_speed_loads_the_pins_with_the_planets_weight():
    """m r_c Ω² outwards, less what the softened pin gives by; 1e-2 covers the displaced radius."""
    system = loaded(planetary(3), speeds={"carrier": 300.0})
    still = loaded(planetary(3))
    place = system.labels.lines.index("planet-1.pin.radial")
    pull = statics(still).force[place] - statics(system).force[place]
    assert pull == pytest.approx(0.8 * 0.09 / math.cos(ANGLE) * 300.0**2, rel=1e-2)


def test_names_carry_the_name_of_the_set():
    model = Model()
    add_planetary(model, planetary(3), name="first")
    add_planetary(model, planetary(3), name="second")
    model.shaft("middle", "first.carrier", "second.sun", stiffness=1e6)
    system = model.build()
    assert "first.planet-2.radial" in system.labels.coordinates and "second.planet-ring-3" in system.labels.lines
    assert modes(system).rigid == 1


@pytest.mark.parametrize(
    ("changes", "speeds", "path"),
    [
        ({"sun": Member(1.0, 1.0, 1.0, -1.0)}, {}, "sun.support"),
        ({"sun": Member(1.0, 1.0, 1.0, 1.0, math.nan)}, {}, "sun.torsion"),
        ({"positions": ()}, {}, "positions"),
        ({"errors": {5: PlanetError()}}, {}, "errors.5"),
        ({"sun_mesh": StiffnessCurve(1.0, (0.1,), (0.0,))}, {}, "phases"),
        ({}, {"sun": 10.0}, "speeds.carrier"),
        ({}, {"sol": 10.0, "carrier": 1.0}, "speeds.sol"),
        ({"ring": Member(1.0, 1.0, 1.0, torsion=math.inf)}, {"ring": 1.0, "carrier": 1.0}, "speeds.ring"),
    ],
)
def test_what_is_missing_is_named(changes, speeds, path):
    with pytest.raises(DesignError) as caught:
        model_of(planetary(4, **changes), speeds=speeds)
    assert path in {problem.path for problem in caught.value.problems}


def test_shares_of_a_set_that_is_not_there_are_refused():
    system = loaded(planetary(3))
    with pytest.raises(DesignError, match="no such mesh"):
        load_shares(statics(system).force, system.labels, name="third")
