"""What a researcher writes becomes a system, or an error that names the thing."""

import math

import numpy as np
import pytest

from gearwright.dynamics import DampingRatio, Model, Periodic
from gearwright.errors import DesignError


def pair() -> Model:
    """Return a pinion (radius 25 mm, 20 teeth) that drives a wheel (50 mm, 40 teeth)."""
    model = Model()
    pinion = model.rotation("pinion", inertia=1e-4, speed=1000.0)
    wheel = model.rotation("wheel", inertia=1e-3)
    model.mesh(
        "mesh",
        {pinion: 0.025, wheel: 0.05},
        stiffness=4e8,
        damping=DampingRatio(0.05),
        variation=Periodic({pinion: 20}, cosine=(0.2, 0.0, 0.05), offset=math.pi / 2),
    )
    return model


def problems_of(model: Model) -> str:
    with pytest.raises(DesignError) as caught:
        model.build()
    return str(caught.value)


def test_speeds_that_are_left_out_follow_from_the_lines():
    """A wheel twice as large turns half as fast, the other way: exact up to rounding."""
    assert pair().build().arrays.speed == pytest.approx([1000.0, -500.0], rel=1e-12)


def test_damping_ratio_uses_the_effective_mass_of_the_line():
    """c = 2 ζ √(k m_eff), 1/m_eff = r₁²/J₁ + r₂²/J₂."""
    effective = 1.0 / (0.025**2 / 1e-4 + 0.05**2 / 1e-3)
    assert pair().build().arrays.damping[0] == pytest.approx(2 * 0.05 * math.sqrt(4e8 * effective), rel=1e-12)


def test_tones_are_named_and_the_offset_is_worked_into_the_coefficients():
    """0.2 cos(φ + π/2) = −0.2 sin φ and 0.05 cos(3φ + 3π/2) = 0.05 sin 3φ; order 2 is absent."""
    system = pair().build()
    assert [str(tone) for tone in system.labels.tones] == ["20 pinion", "60 pinion"]
    assert system.arrays.tone_rate == pytest.approx([20e3, 60e3])
    assert system.arrays.variation.cosine == pytest.approx([0.0, 0.0], abs=1e-15)
    assert system.arrays.variation.sine == pytest.approx([-0.2, 0.05])


def test_meshes_of_one_stage_share_their_tones():
    model = pair()
    model.mesh("again", {"pinion": 0.025, "wheel": 0.05}, stiffness=1e8, variation=Periodic({"pinion": 20}, (0.1,)))
    assert len(model.build().labels.tones) == 2


@pytest.mark.parametrize("mass", [0.0, -1e-3, math.nan])
def test_a_mass_that_is_not_positive_is_named(mass):
    model = pair()
    model.translation("case", mass=mass)
    assert f"bodies.case: mass is {mass:g}; it must be positive and finite" in problems_of(model)


@pytest.mark.parametrize("inertia", [0.0, -1e-3, math.nan, math.inf])
def test_an_inertia_that_is_not_positive_and_finite_is_named(inertia):
    model = pair()
    model.rotation("idler", inertia=inertia)
    assert "bodies.idler: inertia" in problems_of(model)


def test_an_unknown_body_is_named_with_its_near_match():
    model = pair()
    model.support("bearing", "pinon", stiffness=1e8)
    model.load("whel", constant=3.0)
    message = problems_of(model)
    assert "lines.bearing: no such body: pinon; did you mean pinion?" in message
    assert "loads.whel: no such body; did you mean wheel?" in message


def test_duplicate_names_are_named():
    model = pair()
    model.rotation("wheel", inertia=1.0)
    model.shaft("mesh", "pinion", "wheel", stiffness=1.0)
    message = problems_of(model)
    assert "bodies.wheel: the name is used 2 times" in message
    assert "lines.mesh: the name is used 2 times" in message


@pytest.mark.parametrize("count", [20.5, math.nan, math.inf])
@pytest.mark.parametrize("of", ["variation", "errors"])
def test_a_phase_that_is_no_whole_number_of_teeth_is_refused(count, of):
    model = pair()
    wave = Periodic({"pinion": count}, (0.1,))
    parts = {"variation": wave} if of == "variation" else {"errors": [wave]}
    model.mesh("odd", {"pinion": 0.025, "wheel": 0.05}, stiffness=1.0, **parts)
    assert f"lines.odd: the phase takes {count:g} times pinion; it must be a whole number" in problems_of(model)


def test_a_phase_of_a_translation_is_refused():
    model = pair()
    model.translation("wheel.x", mass=1.0)
    model.mesh("odd", {"pinion": 0.025, "wheel": 0.05}, stiffness=1.0, errors=[Periodic({"wheel.x": 1}, (1e-6,))])
    assert "the phase names wheel.x, which is no rotation" in problems_of(model)


def test_a_stiffness_curve_that_goes_negative_is_refused():
    model = pair()
    weights = {"pinion": 0.025, "wheel": 0.05}
    model.mesh("touches zero", weights, stiffness=1.0, variation=Periodic({"pinion": 20}, (1.0,)))
    model.mesh("bad", weights, stiffness=1.0, variation=Periodic({"pinion": 20}, (1.5,)))
    message = problems_of(model)
    assert "lines.bad: the stiffness curve goes negative, to -0.5 of its mean" in message
    assert "touches zero" not in message


def test_speeds_that_do_not_fit_the_radii_are_refused():
    model = pair()
    model.bodies[1] = model.bodies[1]._replace(speed=-499.0)
    assert "lines.mesh: it would stretch steadily at the given speeds" in problems_of(model)


def test_a_speed_profile_gives_the_travel():
    """Factor 1 → 2 in 2 s, then held: τ(2) = 3 s."""
    model = pair()
    model.profile = ((0.0, 1.0), (2.0, 2.0))
    assert np.array_equal(model.build().arrays.profile.travel, [0.0, 3.0])


def test_every_problem_comes_at_once():
    model = Model()
    model.rotation("a", inertia=-1.0)
    model.support("s", "b", stiffness=0.0)
    model.load("a", schedule=((1.0, 0.0), (1.0, 2.0)))
    assert "4 problems" in problems_of(model)


def test_bodies_that_nothing_joins_are_refused():
    model = Model()
    model.rotation("alone", inertia=1.0)
    assert "lines: there is none" in problems_of(model)
