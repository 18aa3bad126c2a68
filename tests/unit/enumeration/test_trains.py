"""Which trains there are, and what each is as a design."""

import math
from collections import Counter

import pytest

import gearwright as gw
from gearwright.enumeration import Architecture, Place, Seat, requirement_of, trains
from gearwright.enumeration.trains import built, freedoms, stepped_teeth
from gearwright.errors import DesignError
from gearwright.spec import GROUND

HYBRID = "in-line-h2"


def colours(design):
    """Return the colours of shafts and stages once neighbours no longer tell more apart: equal for equal graphs."""
    machines = {name: (*design.turbines, *design.motors, *design.propellers).index(name) for name in design.machines}
    joined = []
    for name, stage in design.simple_stages.items():
        for role in ("pinion", "wheel", "sun", "ring", "carrier"):
            told = getattr(stage, role, None)
            for other in told if isinstance(told, list) else [told]:
                if other is not None:
                    joined.append((f"stage {name}", role, f"stage {other.split('.')[0]}" if "." in other else other))
    for name, stage in design.epicyclics.items():
        members = {**{gear.shaft: role for role in ("suns", "rings") for gear in getattr(stage, role).values()},
                   stage.carrier: "carrier"}  # fmt: skip
        joined += [(f"stage {name}", f"stepped {role}", shaft) for shaft, role in members.items()]
    joined += [(f"machine {name}", "on", machine.shaft) for name, machine in design.machines.items()]
    nodes = {node for first, _, second in joined for node in (first, second)}
    colour = {node: str(machines.get(node.removeprefix("machine "), node == GROUND)) for node in nodes}
    for _ in nodes:
        seen = {
            node: (colour[node], sorted((role, colour[b]) for a, role, b in joined if a == node),
                   sorted((role, colour[a]) for a, role, b in joined if b == node and node != GROUND))
            for node in nodes
        }  # fmt: skip
        colour = {node: repr(told) if len(repr(told)) < 80 else str(hash(repr(told))) for node, told in seen.items()}
    return tuple(sorted(colour.values()))


def test_no_two_architectures_are_one_graph():
    asked = requirement_of(gw.read(HYBRID))
    seen = Counter()
    for one in trains(asked.ratio, stages=(2,), added=asked.added):
        try:
            seen[colours(built(asked, one, [0.5] * freedoms(one)).design)] += 1
        except DesignError:
            continue
    assert len(seen) > 75
    assert max(seen.values()) == 1


def test_every_architecture_has_a_file_of_its_own():
    slugs = Counter(one.slug for one in trains(16.5, stages=(1, 2, 3, 4), added=0.96))
    assert len(slugs) > 4000 and max(slugs.values()) == 1


def test_one_stage_of_five_is_a_pair_a_planetary_set_or_a_star():
    kinds = {one.kinds for one in trains(5.0, stages=(1,), motor=False)}
    assert kinds == {("pair",), ("planetary set",), ("star",)}


def test_a_motor_of_a_pair_has_five_places():
    """On both shafts, through a pair of its own on each, and through a pinion on the wheel."""
    places = [one.motor for one in trains(5.0, stages=(1,)) if one.kinds == ("pair",)]
    assert places == [
        Place(Seat.SHAFT, 0), Place(Seat.PAIR, 0), Place(Seat.SHAFT, 1), Place(Seat.PAIR, 1), Place(Seat.WHEEL, 0)
    ]  # fmt: skip


@pytest.mark.parametrize("place", [0.0, 0.3, 1.0])
def test_ratios_multiply_to_the_asked_one_within_what_each_kind_gives(place):
    asked = requirement_of(gw.read("in-line"))
    for one in trains(asked.ratio, stages=(2, 3), motor=False):
        made = built(asked, one, [place] * freedoms(one))
        assert math.isclose(math.prod(made.ratios), asked.ratio, rel_tol=1e-12)
        slots = [kind for kind in one.members for _ in range(kind.stages)]
        for kind, ratio in zip(slots, made.ratios, strict=True):
            assert kind.least * (1 - 1e-9) <= ratio <= kind.most * (1 + 1e-9), (one.name, made.ratios)


@pytest.mark.parametrize(
    ("kinds", "place", "speed"),
    [
        (("star", "planetary set"), Place(Seat.SHAFT, 0), 20000.0),
        (("star", "planetary set"), Place(Seat.SHAFT, 2), 1212.0),
    ],
)
def test_a_motor_on_a_shaft_turns_as_engine_or_propeller_do(kinds, place, speed):
    made = built(requirement_of(gw.read(HYBRID)), Architecture(kinds, place), [0.5])
    assert made.motor_speed == pytest.approx(speed * math.pi / 30.0, rel=1e-9)


@pytest.mark.parametrize(
    "kinds",
    [
        ("solar set", "star", "planetary set"),
        ("pair", "planetary set"),
        ("split path",),
        ("stepped set",),
        ("pair", "stepped star"),
    ],
)
def test_a_sized_train_gives_the_propeller_its_speed(kinds):
    asked = requirement_of(gw.read(HYBRID))
    one = Architecture(kinds, Place(Seat.SHAFT, 0))
    design = built(asked, one, [0.4] * freedoms(one)).design
    sizing = gw.size(design)
    assert abs(sizing.reference.speeds["output"]) == pytest.approx(asked.propeller_speed, rel=0.05)


@pytest.mark.parametrize(("wide", "narrow"), [(2.2, 2.2), (3.5, 4.7), (5.5, 5.5)])
def test_teeth_of_a_stepped_set_give_its_ratio_and_take_planets_at_equal_places(wide, narrow):
    sun, first, second, ring = stepped_teeth(wide, narrow)
    assert first / sun * ring / second == pytest.approx(wide * narrow, rel=2e-3)
    assert sun % 3 == ring % 3 == 0


@pytest.mark.parametrize(
    ("kinds", "place"),
    [
        (("differential", "planetary set"), Place(Seat.RING, 0)),
        (("differential", "pair"), Place(Seat.RIM, 0)),
        (("star", "differential"), Place(Seat.RING, 1)),
        (("pair", "differential"), Place(Seat.RIM, 1)),
    ],
)
def test_the_motor_of_a_differential_gives_its_power_in_every_case_whatever_turns_before(kinds, place):
    """The set fixes the ratio of the torques, so that the motor's speed, and the propeller's, follow its power."""
    asked = requirement_of(gw.read(HYBRID))
    one = Architecture(kinds, place)
    sizing = gw.size(built(asked, one, [0.5] * freedoms(one)).design)
    for case, added in asked.added_in.items():
        flow = sizing.flows[case]
        assert flow.machine_powers["electric"] == pytest.approx(added * 1046e3, rel=0.05)
        slower = (1.0 + added) / (1.0 + asked.added)
        assert abs(flow.speeds["output"]) == pytest.approx(slower * asked.propeller_speed, rel=0.05)


def test_what_no_train_serves_is_told_at_once():
    twin = gw.read("twin-engine-helicopter")
    with pytest.raises(DesignError) as told:
        requirement_of(twin)
    paths = {problem.path for problem in told.value.problems}
    assert {"turbines", "rotors"} <= paths or {"turbines", "propellers"} <= paths
