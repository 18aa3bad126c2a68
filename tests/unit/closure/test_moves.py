"""What single changes of a settled design lead to: what is screened a little heavier, critical speeds, common axes."""

from dataclasses import replace

import pytest

import gearwright.closure.moves as separate
from designs import PAIR, changed
from gearwright.closure import Wishes, close
from gearwright.closure.loop import Candidate, StageChange, Task, judged, options, settled
from gearwright.closure.moves import other_teeth
from gearwright.closure.requirements import stage_lives
from gearwright.sizing import size
from gearwright.spec import edited, parse

ISO = {"gears.rating": "iso6336", "pairs.stage.pinion_teeth": 25, "pairs.stage.wheel_teeth": 75}
THREE = changed(PAIR, '["fast", "slow"]', '["fast", "slow", "third"]')
COAXIAL = changed(THREE, 'shaft = "slow"\nspeed_rpm = 2000', 'shaft = "third"\nspeed_rpm = 900')
COAXIAL += '[pairs.next]\npinion = "slow"\nwheel = "third"\npinion_teeth = 30\nwheel_teeth = 67\n'
COAXIAL += 'coaxial_with = "stage"\n'


def test_other_teeth_are_confirmed_with_a_dynamic_factor_of_their_own():
    """Without relief: 46 teeth weigh more with the K_V of 42 than with their own, which the closed design has."""
    given = {**ISO, "pairs.stage.pinion_teeth": 42, "pairs.stage.wheel_teeth": 126, "pairs.stage.module_mm": 2,
             "gears.iso6336.tip_relief_um": 0.0}  # fmt: skip
    design = edited(parse(changed(PAIR, 'level = "concept"\n', "")), given)
    wishes = {"separate": False, "left_out": frozenset({"critical speeds"})}
    kept, free = (close(design, wishes=Wishes(free=own, **wishes)) for own in ((), ("teeth",)))
    found = {f"pairs.stage.{gear}_teeth": free.sizing.teeth[f"stage.{gear}"] for gear in ("pinion", "wheel")}
    others = kept.design.rules("stage").iso6336.least_dynamic_factor
    screened = size(edited(design, found | {"gears.iso6336.least_dynamic_factor": others}))
    assert free.sizing.gears[0].teeth == 46
    assert free.design.rules("stage").iso6336.least_dynamic_factor < others
    assert free.sizing.gear_mass < screened.gear_mass
    assert free.whole.total < 0.99 * kept.whole.total


def test_where_free_teeth_lead_nowhere_given_ones_are_tried(monkeypatch):
    """A search that finds clear critical speeds only among modules, as its best choices of teeth are none confirmed."""
    state = settled(Task(edited(parse(PAIR), ISO), Wishes(free=("teeth", "shifts"))))
    clear = settled(Task(edited(parse(PAIR), {**ISO, "pairs.stage.module_mm": 4}), Wishes(free=("shifts",))))
    asked = []

    def found(own, lacks, tell):
        asked.append(own.task.wishes.free)
        return Candidate(own, 0.4, 0.4) if "teeth" in own.task.wishes.free else Candidate(clear, 0.0, 0.0)

    monkeypatch.setattr(separate, "_moved", found)
    best = separate.separated(state, lambda words: None)
    assert asked == [("teeth", "shifts"), ("shifts",)]
    assert best.sizing is clear.sizing
    assert best.task.wishes == state.task.wishes


@pytest.mark.parametrize("step", [-3, 4])
def test_other_teeth_of_one_pair_leave_pairs_on_common_axes_at_one_distance(step):
    state = settled(Task(edited(parse(COAXIAL), ISO), Wishes(free=("teeth",))))
    frees = ("pairs.next.pinion_teeth", "pairs.next.wheel_teeth")
    change = StageChange(("pairs.next",), {frees[1]: None, frees[0]: 30 + step}, frees)
    (option,) = options(state, [change])
    other = option.settled
    first, second = (mesh.centre_distance for mesh in other.sizing.meshes)
    assert next(gear.teeth for gear in other.sizing.gears if gear.name == "next.pinion") == 30 + step
    assert second == pytest.approx(first, rel=1e-9)
    assert not [check.name for check in other.sizing.checks if check.fails and check.mode.startswith("axes of")]
    assert judged(other).settled is other


def test_a_pair_between_gears_of_two_other_pairs_is_closed_with_them():
    """It has no gear of its own: its module is theirs, and no teeth of it are varied; theirs are together."""
    shared = changed(PAIR, '["fast", "slow"]', '["fast", "slow", "left", "right"]')
    shared = changed(shared, 'wheel = "slow"\n', 'wheel = "left"\npinion_teeth = 25\nwheel_teeth = 75\n')
    shared = changed(shared, '[propellers.propeller]\nshaft = "slow"\nspeed_rpm = 2000\ndiameter_m = 2\n',
                     '[loads.load]\nshaft = "slow"\n')  # fmt: skip
    shared += '[pairs.last]\npinion = "right"\nwheel = "slow"\npinion_teeth = 25\nwheel_teeth = 75\n'
    shared += '[pairs.between]\npinion = "stage.wheel"\nwheel = "last.pinion"\n'
    state = settled(Task(edited(parse(shared), ISO), Wishes()))
    modules = {gear.stage: gear.module for gear in state.sizing.gears}
    assert modules["stage"] == modules["last"]
    assert {life.stage for life in stage_lives(state.sizing)} == {"stage", "last", "between"}
    free = replace(state, task=replace(state.task, wishes=Wishes(free=("teeth",))))
    (change,) = other_teeth(free, [1])
    assert {path: value for path, value in change.values.items() if value is not None} == {
        "pairs.stage.pinion_teeth": 26,
        "pairs.last.pinion_teeth": 26,
    }
