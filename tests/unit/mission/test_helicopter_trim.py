"""A helicopter's sortie by trim: main and tail rotor take what momentum and drag say, and bad input says so."""

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.mission.profile import moments
from gearwright.mission.thrust import trimmed
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import parse_mission, read
from gearwright.units import GRAVITY

SIZING = size(read(shipped_design("ec120b")))
TEXT = shipped_mission("ec120b-trim").read_text(encoding="utf-8").replace("step_s = 10", "step_s = 60")
MISSION = parse_mission(TEXT)
FLIGHT = fly(SIZING, MISSION)
PHASE = np.array(FLIGHT.phase)


def of(phase, values):
    """Return the mean of a phase."""
    return values[phase == PHASE].mean()


def test_the_rotors_take_their_trim():
    burnt = 0.0
    for k, moment in enumerate(moments(MISSION)):
        if moment.power is None:
            trim = trimmed(MISSION.rotorcraft, MISSION, moment, diameter=10.0, burnt=burnt)
            assert FLIGHT.history.propeller_power[k] == pytest.approx(trim.main, rel=1e-9)
            assert -FLIGHT.machines["tail-drive"].power[k] == pytest.approx(trim.tail, rel=1e-4)  # corrected once
        burnt += FLIGHT.history.fuel_flow[k] * moment.duration


def test_its_energies_close():
    assert FLIGHT.balance.residual < 1e-9


def test_hover_takes_more_than_cruise_and_a_climb_what_it_lifts():
    power = FLIGHT.history.propeller_power
    assert of("hover", power) > of("cruise", power) > of("descent", power) > 0.0
    climb, hover = (next(m for m in moments(MISSION) if m.phase == name) for name in ("climb", "hover"))
    level = trimmed(MISSION.rotorcraft, MISSION, climb._replace(climb=0.0), diameter=10.0, burnt=0.0)
    rising = trimmed(MISSION.rotorcraft, MISSION, climb, diameter=10.0, burnt=0.0)
    assert rising.main - level.main == pytest.approx(1600.0 * GRAVITY * climb.climb, rel=0.03)  # the stream helps
    assert trimmed(MISSION.rotorcraft, MISSION, hover, diameter=10.0, burnt=0.0).thrust == pytest.approx(
        1600.0 * GRAVITY * 1.03
    )


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            'machine = "tail-drive"',
            'machine = "tail-rotor"',
            "no load or tail rotor of the design is called 'tail-rotor'",
        ),
        ("mass_kg = 1600", "mass_kg = 4000", "and stall beyond 0.12"),
        ("tas_kt = 80\nrate_of_climb_ft_min = -600", "tas_kt = 20\nrate_of_climb_ft_min = -1500", "into its own wake"),
        ("mass_kg = 1600", "mass_kg = 2400", "arrius-2f"),
    ],
)
def test_what_it_cannot_fly_is_refused(old, new, message):
    with pytest.raises(DesignError) as error:
        fly(SIZING, parse_mission(TEXT.replace(old, new)))
    assert message in str(error.value)
    assert "phases." in str(error.value)


def test_a_helicopter_has_neither_wing_nor_propeller():
    with pytest.raises(DesignError, match="neither wing nor propeller"):
        parse_mission(TEXT.replace('"none"', '"6-blades-af115"'))
