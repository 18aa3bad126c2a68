"""By how much bodies of a scene turn in a motion of their train."""

import numpy as np
import pytest

from gearwright.dynamics import modes
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.assembly.bodies import turns_of
from gearwright.shape import scene
from gearwright.sizing import governing_case
from shipped_work import sized


@pytest.mark.parametrize(
    "name", ["in-line-h2", "ec120b", "face-gear-split-torque", "ravigneaux-automatic", "in-line-h2-star"]
)
def test_a_rigid_turn_of_the_train_turns_every_body_as_its_scene_spins(name):
    """q = Ω · 1 s against the spins of the scene, planets against their carriers: two ways to the same angles."""
    sizing = sized(name)
    case = governing_case(sizing)
    system, built = assemble(sizing, case), scene(sizing, detail="coarse")
    turned = turns_of(sizing, built, system, system.arrays.speed)
    spinning = {
        node.name: node.spins[case] for node in built.nodes if node.spins[case] and node.look not in ("bearing", "pin")
    }
    assert set(spinning) <= set(turned)
    for body, spin in spinning.items():
        assert turned[body] == pytest.approx(spin, rel=1e-9), body


def test_planets_that_swing_against_each_other_leave_sun_and_carrier_alone():
    """A mode that several planets share moves them alone: nothing else has a part in it."""
    sizing = sized("in-line-h2")
    system = assemble(sizing)
    found = modes(system)
    first = int(
        np.argmax(np.isclose(found.frequency[:-1], found.frequency[1:], rtol=1e-9) & (found.frequency[1:] > 0.0))
    )
    turned = turns_of(sizing, scene(sizing, detail="coarse"), system, found.shapes[:, first])
    most = max(abs(float(turn)) for turn in turned.values())
    moving = {name for name, turn in turned.items() if abs(float(turn)) > 1e-9 * most}
    assert moving and all(".planet" in name for name in moving)
