"""Loads of propellers and rotors on shafts in bearings: by default, and as stated."""

import pytest

from designs import changed, problem
from gearwright.catalogue import equivalent_loads
from gearwright.particulars import particulars
from gearwright.render.answers.design import size_answer
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.airscrew_loads import airscrew_cases, loads_table, usual_loads
from gearwright.spec import parse, read
from mounted_designs import HELICOPTER, PAIR

ZEROS = "thrust_n = 0\nin_plane_force_n = 0\nhub_moment_nm = 0\n"
OPEN = changed(PAIR, ZEROS, "")
"""A pair whose propeller states no loads."""


def cases(text, name="rotor"):
    """Return the cases of an airscrew by name, and the sizing."""
    sizing = size(parse(text))
    return {case.name: case for case in airscrew_cases(sizing.design, sizing.flows, name)}, sizing


def checks(sizing, part):
    """Return mode -> check of a shaft or bearing."""
    return {check.mode: check for check in sizing.checks if check.part.name == part}


def test_what_is_left_open_is_taken_by_default_in_three_sets():
    found, sizing = cases(OPEN)
    assert [case.use for case in found.values()] == ["life"] * 3 + ["fatigue"] + ["limit"] * 4
    assert [found[name].share for name in ("take-off", "climb", "cruise")] == [0.05, 0.10, 0.85]
    assert all(case.origin.startswith("assumed: ") for case in found.values())
    assert found["static thrust"].thrust == pytest.approx(0.72 * (2 * 1.225 * 12.566 * 315e3**2) ** (1 / 3), rel=0.02)
    assert found["torque peak"].torque_factor == 1.6
    assert "limit load" in checks(sizing, "output")


def test_a_shaft_with_stated_loads_is_what_it_was():
    found, sizing = cases(PAIR)
    assert found == {}
    assert "limit load" not in checks(sizing, "output")
    assert [row.origin for row in loads_table(sizing.design, sizing.flows)] == ["stated"]
    assert {section.limit_safety for shaft in sizing.built_shafts for section in shaft.sections} == {None}


def test_assumed_loads_make_shaft_and_bearings_stronger():
    plain, loaded = size(parse(PAIR)), size(parse(OPEN))
    heavy = {name: sum(shaft.mass for shaft in one.shafts if shaft.name == "output")
             for name, one in (("plain", plain), ("loaded", loaded))}  # fmt: skip
    assert heavy["loaded"] > heavy["plain"]
    assert loaded.bearing_mass > plain.bearing_mass
    for mode in ("fatigue", "yield", "limit load"):
        assert not checks(loaded, "output")[mode].fails
    assert checks(loaded, "output")["fatigue"].case == "excitation factor 3"


def test_one_stated_load_holds_in_every_case_and_the_others_stay_assumed():
    found, _ = cases(changed(OPEN, "diameter_m = 4\n", "diameter_m = 4\nhub_moment_nm = 0\n"))
    assert {case.moment for case in found.values()} == {0.0}
    assert found["climb"].thrust > 0.0
    assert all(case.origin.startswith("stated: hub_moment; assumed: ") for case in found.values())


def test_keys_move_what_they_say():
    base, _ = cases(OPEN)
    moved, _ = cases(
        changed(OPEN, "diameter_m = 4\n", 'diameter_m = 4\nloads = { excitation_factor = 1, gyroscopic = "cs23",'
                " blade_mass_kg = 6, overhang_mm = 100, cases.cruise.incidence_deg = 4 }\n")
    )  # fmt: skip
    assert moved["excitation factor 1"].moment < base["excitation factor 3"].moment
    assert moved["turning"].moment > base["turning"].moment
    assert moved["climb"].force < base["climb"].force  # lighter
    assert moved["torque peak"].moment == pytest.approx(0.1 * moved["torque peak"].force)
    assert moved["cruise"].moment > 1.9 * (base["cruise"].moment)


def test_load_cases_of_the_design_take_the_flight_of_their_names():
    text = changed(OPEN, "[service]\n", "[cases.climb]\nshare = 0.2\nengine.rating = 1\n[cases.cruise-fast]\n"
                   "share = 0.8\nengine.rating = 0.8\n[service]\n")  # fmt: skip
    found, sizing = cases(text)
    assert [name for name, case in found.items() if case.use == "life"] == ["climb", "cruise-fast"]
    assert "as cruise" in found["cruise-fast"].origin
    usual = usual_loads(sizing.design, sizing.flows, "rotor", in_bearings=True)
    assert found["cruise-fast"].thrust < usual.thrust < found["climb"].thrust
    assert usual_loads(sizing.design, sizing.flows, "rotor", in_bearings=False).thrust == 0.0


def test_limit_loads_count_for_the_static_safety_without_the_application_factor():
    _, sizing = cases(changed(OPEN, "diameter_m = 4\n", 'diameter_m = 4\nloads.gyroscopic = "cs23"\n'))
    at_limit = [bearing for bearing in sizing.bearings if bearing.case == "turning"]
    assert at_limit
    for bearing in at_limit:
        load = equivalent_loads(bearing.bearing, bearing.radial, bearing.axial)[1]
        assert bearing.static_safety == pytest.approx(bearing.bearing.static_rating / load)


def test_a_rotor_hovers_at_its_power_and_bears_its_load_factor():
    text = changed(OPEN, "[propellers.rotor]", "[rotors.rotor]")
    found, _ = cases(text)
    assert [case.use for case in found.values()] == ["life", "fatigue", "limit"]
    life, limit = found["rated"], found["load factor 3.5"]
    assert limit.thrust == pytest.approx(3.5 * life.thrust)
    assert life.moment == pytest.approx(0.03 * life.thrust * 2.0)
    assert limit.moment == pytest.approx(2.0 * life.moment)
    assert life.force == pytest.approx(0.1 * life.thrust)


def test_the_replayed_helicopters_state_their_loads():
    for name in ("ec120b", "ec120b-as-reported"):
        design = read(shipped_design(name))
        assert len(design.rotors["main-rotor"].stated_loads) == 3


def test_a_shaft_that_nothing_locates_is_told_that_its_thrust_is_assumed():
    text = changed(HELICOPTER, "thrust_kn = 16.8\n", "").replace("in_plane_force_n = 500\n", "")
    text = text.replace('kind = "taper"\nlocates = "first"\n', "").replace('kind = "taper"\nlocates = "second"\n', "")
    with pytest.raises(Exception, match="are assumed where they are not stated"):
        size(parse(text))


def test_data_tell_every_case_with_its_origin():
    rows = size_answer(particulars(size(parse(OPEN)))).airscrew_loads
    assert {row.airscrew for row in rows} == {"rotor"}
    assert all(row.origin for row in rows)


@pytest.mark.parametrize(
    ("written", "path", "told"),
    [
        ("loads.cases.klimb.incidence_deg = 3", "propellers.rotor.loads.cases.klimb", "did you mean climb"),
        ("loads.cases.climb = {}", "propellers.rotor.loads.cases.climb", "give incidence_deg or airspeed_m_s"),
        ("loads.mass_kg = 10\nloads.blade_mass_kg = 14", "propellers.rotor.loads.mass_kg", "weigh 56 kg"),
        ("loads.gyroscopic = [1]", "propellers.rotor.loads.gyroscopic", "two numbers from 0 to 20"),
        ("loads.gyroscopic = [1, -2]", "propellers.rotor.loads.gyroscopic", "two numbers from 0 to 20"),
        ('loads.gyroscopic = "cs24"', "propellers.rotor.loads.gyroscopic", "'cs25' or 'cs23'"),
        ("loads.mass_kg = -3", "propellers.rotor.loads.mass_kg", "-3 kg is not allowed"),
        (f"{ZEROS}loads.mass_kg = 30", "propellers.rotor.loads.mass_kg", "has no effect"),
    ],
)
def test_loads_that_contradict_are_refused(written, path, told):
    found = problem(changed(OPEN, "diameter_m = 4\n", f"diameter_m = 4\n{written}\n"))
    assert (found.path, told in found.message) == (path, True)


@pytest.mark.parametrize(
    ("written", "key"),
    [
        ('loads.hub = "teetering"\nhub_moment_nm = 100', "hub"),
        ("loads.h_force = 0.2\nin_plane_force_n = 100", "h_force"),
        ("loads.load_factor = 3\nthrust_n = 100", "load_factor"),
    ],
)
def test_a_rotor_does_not_state_a_load_and_what_it_would_come_from(written, key):
    rotor = changed(OPEN, "[propellers.rotor]", "[rotors.rotor]")
    found = problem(changed(rotor, "diameter_m = 4\n", f"diameter_m = 4\n{written}\n"))
    assert found.path == f"rotors.rotor.loads.{key}"
    assert "leave one of both out" in found.message
