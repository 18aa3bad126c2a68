"""What holds both rings of every bearing, and the parts for it, against hand calculation."""

import math
import re
from itertools import pairwise

import numpy as np
import pytest

import gearwright as gw
from gearwright.checks import Status
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.entities import Distance, Words
from gearwright.shape import solid_masses
from gearwright.sizing.making import spanner_checks
from gearwright.sizing.shafts import (
    cut_steps,
    ends,
    groove_checks,
    grooves,
    held_rings,
    holders_of,
    holding_checks,
    threads,
    undercuts_of,
)
from gearwright.sizing.shafts.ends import groove_strengths
from gearwright.sizing.shafts.retention import clamped_plate
from gearwright.spec import edited
from shipped_work import BY_HAND, ball_bearings_of_the_tail, sized, text_of

TEXT = text_of(BY_HAND)


def by_side(sizing):
    return {(held.bearing, held.ring, held.way): held for held in held_rings(sizing)}


def test_every_ring_of_the_helicopters_gearbox_that_must_be_held_is():
    sizing = sized(BY_HAND)
    assert {held.bearing for held in held_rings(sizing)} == set(sizing.design.bearings)
    assert all(held.by for held in held_rings(sizing))
    assert all(check.status is Status.PASSES for check in holding_checks(sizing))


def test_what_a_bearing_locates_decides_which_rings_are_held():
    """A taper bearing two sides, one that floats by its rollers four, a ball bearing that floats its inner ring."""
    held = by_side(sized(BY_HAND))
    assert {key[1:] for key in held if key[0] == "mast-upper"} == {("inner", -1), ("outer", 1)}
    assert {key[1:] for key in held if key[0] == "mast-lower"} == {("inner", 1), ("outer", -1)}
    assert len([key for key in held if key[0] == "intermediate-nose"]) == 4
    floating = by_side(gw.size(gw.parse(ball_bearings_of_the_tail())))
    assert {key[1:] for key in floating if key[0] == "tail-front"} == {("inner", -1), ("inner", 1)}


def test_inner_rings_lean_on_shoulders_spacers_and_rings():
    held = by_side(sized(BY_HAND))
    assert held["mast-upper", "inner", -1].by == "a shoulder"
    assert held["intermediate-rear", "inner", 1].by == "a spacer of 8.5 mm to helical.wheel"
    assert held["intermediate-rear", "inner", -1].by == "a spacer of 6 mm to intermediate-axial"
    assert held["input-axial", "inner", 1].by == "DIN 471 - 25 x 1.2"
    assert held["intermediate-axial", "inner", -1].by == "an end plate with M20"
    assert held["input-rear", "inner", -1].by == "its fit alone"  # torque passes: a groove would weaken the shaft
    assert held["mast-lower", "outer", -1].by == "a cover with 6 screws M5, 8.8"


def test_a_spacer_between_two_bearings_is_one_part_that_both_lean_on():
    sizing = sized(BY_HAND)
    held = by_side(sizing)
    ways = (held["intermediate-rear", "inner", -1], held["intermediate-axial", "inner", 1])
    assert ways[0].holders == ways[1].holders
    (spacer,) = ways[0].holders
    assert spacer.end - spacer.start == pytest.approx(6e-3) and spacer.bore == pytest.approx(65e-3)
    # Thinner than what either bearing wants beside it: 65 mm + 0.175 (D − 65 mm), D = 120 and 140 mm.
    assert spacer.outer == pytest.approx(65e-3 + 0.175 * 55e-3)
    assert len(holders_of(sizing)) == len({holder.name for holder in holders_of(sizing)})


def test_a_cover_by_hand():
    """Six screws, the first whose preload is 1.5 times the force: 0.7 · 580 N/mm² on 20.1 mm² of M6."""
    sizing = sized(BY_HAND)
    cover = next(holder for holder in holders_of(sizing) if holder.kind == "cover" and holder.beside == "mast-upper")
    bearing = next(bearing for bearing in sizing.bearings if bearing.name == "mast-upper")
    force = sizing.design.service.application_factor * abs(bearing.axial)
    assert cover.force == pytest.approx(force)
    assert cover.designation == "6 screws M6, 8.8" and cover.capacity == pytest.approx(
        6 * 0.7 * 580.0 * 20.12, rel=1e-3
    )
    assert 6 * 0.7 * 580.0 * 14.18 < 1.5 * force < cover.capacity
    plate = [ring for ring in cover.rings if ring.outer == cover.outer]  # a boss with the seal stands on it
    lip = (max(ring.bore for ring in plate) + bearing.outer_diameter) / 2.0
    circle = bearing.outer_diameter + 3.0 * 6e-3
    moment = force * (circle - lip) / 2.0 / (math.pi * lip)  # N m on a metre of the smaller circle
    stress = math.sqrt(3.0) * 24e6  # aluminium
    assert plate[-1].end - plate[0].start == pytest.approx(math.sqrt(6.0 * moment / stress))
    assert clamped_plate(4.0 * force, lip, circle, stress) == pytest.approx(2.0 * (plate[-1].end - plate[0].start))


def test_a_plain_shaft_that_carries_thrust_needs_a_ring_at_both_ends():
    """The mast of the report is a cylinder: 24.5 kN either way, and no shoulder."""
    sizing = sized("ec120b-as-reported")
    rings = [holder for holder in holders_of(sizing) if holder.shaft == "mast" and holder.kind == "retaining ring"]
    assert [holder.designation for holder in rings] == ["DIN 471 - 60 x 2"]
    assert by_side(sizing)["mast-lower", "inner", -1].by.startswith("a spacer of 267 mm to mast-upper")


def test_grooves_are_cut_into_the_shaft_and_weighed():
    sizing = sized(BY_HAND)
    (groove,) = (groove for groove in grooves(sizing) if groove.shaft == "tail")
    tail = next(shaft for shaft in sizing.built_shafts if shaft.name == "tail")
    steps = cut_steps(sizing, tail)
    assert (groove.start, 2e3 * min(radius for low, high, radius in steps if low >= groove.start - 1e-9)) == (
        pytest.approx(0.131), pytest.approx(19.0))  # fmt: skip
    assert steps[0][0] == tail.steps[0].start and steps[-1][1] == tail.steps[-1].end
    assert all(low[1] == high[0] for low, high in pairwise(steps))
    whole = sum(math.pi / 4.0 * step.diameter**2 * (step.end - step.start) for step in tail.steps)
    cut = sum(math.pi * radius**2 * (high - low) for low, high, radius in steps)
    taken = (0.020**2 - 0.019**2) * 1.3e-3 + (0.020**2 - 0.0196**2) * 2.5e-3 + (0.010**2 - 0.0096**2) * 2e-3
    assert whole - cut == pytest.approx(math.pi / 4.0 * taken, rel=1e-6)


def test_undercuts_lie_in_the_seats_of_bearings_beside_their_shoulders():
    """DIN 509 - F 1.6 x 0.3 of 60 and 75 mm; none where a spacer lies on a shaft that is as thick."""
    sizing = sized(BY_HAND)
    cuts = {shaft.name: list(undercuts_of(sizing, shaft)) for shaft in sizing.built_shafts}
    assert [(cut.place, cut.edge, cut.bottom) for cut in cuts["mast"]] == [
        pytest.approx((0.044, 0.040, 0.0594)), pytest.approx((0.3015, 0.3055, 0.0744))]  # fmt: skip
    assert [round(1e3 * cut.place, 6) for cut in cuts["intermediate"]] == [233.5]
    plain = gw.size(edited(gw.parse(text_of(BY_HAND)), {"shafting.shoulders": "fillet"}))
    assert not any(list(undercuts_of(plain, shaft)) for shaft in plain.built_shafts)


def test_a_groove_where_torque_passes_is_as_weak_as_shigley_says():
    """K_ts = 3 of a ring's groove, felt with q of r = 0.12 mm; torque alone: τ = 16 T/(π d³)."""
    sizing = sized(BY_HAND)
    (found,) = {round(found.torsion_notch, 9) for found in groove_strengths(sizing) if found.shaft == "tail"}
    ksi = sizing.design.shaft_material.ultimate_strength / 6.894757e6
    root = 0.190 - 2.51e-3 * ksi + 1.35e-5 * ksi**2 - 2.67e-8 * ksi**3
    assert found == pytest.approx(1.0 + 2.0 / (1.0 + root / math.sqrt(0.12 / 25.4)), rel=1e-6)
    assert all(check.status is Status.PASSES for check in groove_checks(sizing))


def test_a_thinner_shaft_at_the_groove_fails():
    text = re.sub(r", diameter_mm = 20 \}", " }", TEXT)
    sizing = gw.size(gw.parse(text))
    failing = [check for check in groove_checks(sizing) if check.status is Status.FAILS]
    assert [(str(check.part), check.mode) for check in failing] == [("tail", "yield at its groove of DIN 471 - 17 x 1")]


def test_parts_that_hold_bearings_stand_in_the_scene_and_in_the_mass():
    sizing = sized(BY_HAND)
    scene, complete = gw.scene(sizing, detail="coarse"), gw.complete_mass(sizing)
    listed = {item.part: item.each for item in complete.parts}
    turning = sizing.flows[next(iter(sizing.flows))].speeds
    for holder in holders_of(sizing):
        node, surface = scene.by_name[holder.name], scene.surfaces[holder.name]
        assert listed[holder.name] == holder.mass > 0.0
        volume = sum(math.pi / 4.0 * (ring.outer**2 - ring.bore**2) * (ring.end - ring.start) for ring in holder.rings)
        assert surface.volume == pytest.approx(volume, rel=0.05)  # chords of a coarse circle
        frame = sizing.arrangement.frames[holder.shaft]
        middle = np.asarray(frame.origin) + (holder.start + holder.end) / 2.0 * np.asarray(frame.along)
        assert np.allclose(node.axes.origin, middle)
        speed = abs(node.spins[next(iter(sizing.flows))])
        assert speed == pytest.approx(abs(turning[holder.shaft]) if holder.turns else 0.0)
    rest = listed["fasteners and small parts"]
    assert rest > 0.0  # what is sized is taken out of the share of small parts
    assert all(
        abs(row.solid / row.weighed - 1.0) < 5e-3 for row in solid_masses(sizing, gw.scene(sizing)) if row.weighed
    )


def longer(shoulders):
    """Return the EC120B gearbox whose intermediate shaft goes on 14 mm further at its first end, as text."""
    text = TEXT.replace("length_mm = 270", "length_mm = 284").replace('"undercut" ', f'"{shoulders}" ')
    places = {"helical.wheel": 92, "bevel.pinion": 180}
    for name, place in places.items():
        text = text.replace(f'"{name}".position_mm = {place}', f'"{name}".position_mm = {place + 14}')
    for name, place in {"axial": 20, "rear": 54, "nose": 250}.items():
        head = rf"(\[bearings\.intermediate-{name}\][^\[]*?position_mm = ){place}\b"
        text = re.sub(head, lambda found, to=place + 14: f"{found.group(1)}{to}", text)
    return text


@pytest.fixture
def nutted(monkeypatch):
    """Return by how shoulders are made the gearbox whose intermediate shaft a nut holds, as there are no rings."""
    monkeypatch.setattr("gearwright.sizing.shafts.retention.retaining_ring", lambda diameter: None)
    return lambda shoulders: gw.size(gw.parse(longer(shoulders)))


def test_where_no_ring_can_be_had_a_nut_holds_with_its_thread_in_shaft_and_drawing(nutted):
    """KM 13 on 65 mm beside QJ 313, 17.5 mm from the end: washer 1.5 mm, nut 12 mm, thread M65 x 2, core 62.55 mm."""
    sizing = nutted("undercut")
    own = [holder for holder in holders_of(sizing) if holder.beside == "intermediate-axial" and "lock" in holder.kind]
    assert [(holder.kind, holder.mass) for holder in own] == [("lock nut", 0.19), ("lock washer", 0.03)]
    assert [(holder.start, holder.end) for holder in own] == [
        (pytest.approx(0.004), pytest.approx(0.016)), (pytest.approx(0.016), pytest.approx(0.0175))]  # fmt: skip
    cut, relief = (groove for groove in grooves(sizing) if groove.shaft == "intermediate")
    assert cut.is_thread and cut.what == "thread M65 x 2" and (cut.start, cut.end) == (0.0, pytest.approx(0.016))
    assert cut.diameter == pytest.approx(0.065 - 1.2269 * 2e-3)
    assert relief.what == "undercut of thread M65 x 2" and not relief.is_thread
    modes = {check.mode for check in groove_checks(sizing) if str(check.part) == "intermediate"}
    assert modes == {f"{mode} at its {what}" for mode in ("fatigue", "yield") for what in (cut.what, relief.what)}
    assert any(check.mode == "access to a nut at its first end" for check in spanner_checks(sizing))
    (sheet,) = sheets(sizing, ["shaft-intermediate"])
    said = {mark.text for mark in sheet.entities if isinstance(mark, Words)}
    assert {"M65 x 2 - 6g", "DIN 76 - A", "62.546", "Thread: M65 x 2 - 6g", "1.3 × 45°"} <= said
    assert any("KM 13 with MB 13" in text for text in said)
    assert "lock nut beside intermediate-axial, 4 mm" in gw.scene(sizing, detail="coarse").by_name


def test_a_thread_ends_beneath_washer_and_ring_in_an_undercut_that_shaft_mass_and_solid_lose(nutted):
    """DIN 76 - A of P = 2: d − 3 mm, 7 mm wide, R1; the nut begins 1.5 mm beside the ring, at 16 mm."""
    sizing = nutted("undercut")
    (thread,) = threads(sizing)
    assert (thread.turns, thread.fading) == (pytest.approx((0.0, 0.016)), pytest.approx((0.016, 0.023)))
    assert thread.bottom == pytest.approx(0.062)
    shaft = next(shaft for shaft in sizing.built_shafts if shaft.name == "intermediate")
    radii = [radius for low, high, radius in cut_steps(sizing, shaft) if low > 0.0159 and high < 0.0231]
    assert radii and max(radii) == pytest.approx(0.031)
    rows = solid_masses(sizing, gw.scene(sizing))
    assert all(abs(row.solid / row.weighed - 1.0) < 5e-3 for row in rows if row.weighed)
    (sheet,) = sheets(sizing, ["shaft-intermediate"])
    detail = [mark.measured for mark in sheet.entities if isinstance(mark, Distance) and mark.scale == 5.0]
    assert sorted(detail) == pytest.approx([1.5, 7.0])
    # A groove of r = 1 mm that is 1.5 mm deep in 65 mm, by DIN 743-2; the moment there is none.
    found = next(found for found in groove_strengths(sizing) if found.place.startswith("undercut"))
    slender = 1.0 / 62.0
    alpha = 1.0 + 1.0 / math.sqrt(0.2 / 1.5 + 2.0 * 2.75 * slender * (1.0 + 2.0 * slender) ** 2)
    ksi = sizing.design.shaft_material.ultimate_strength / 6.894757e6
    root = 0.246 - 3.08e-3 * ksi + 1.51e-5 * ksi**2 - 2.67e-8 * ksi**3
    assert found.bending_notch == pytest.approx(1.0 + (alpha - 1.0) / (1.0 + root / math.sqrt(1.0 / 25.4)), rel=1e-6)


def test_where_shoulders_have_fillets_turns_run_out_over_two_and_a_half_pitches(nutted):
    sizing = nutted("fillet")
    (thread,) = threads(sizing)
    assert thread.undercut is None and thread.fading == pytest.approx((0.016, 0.021))
    (groove,) = (groove for groove in grooves(sizing) if groove.shaft == "intermediate")
    assert groove.is_thread and (groove.start, groove.end) == pytest.approx((0.0, 0.021))
    (sheet,) = sheets(sizing, ["shaft-intermediate"])
    said = {mark.text for mark in sheet.entities if isinstance(mark, Words)}
    assert "Run-out, at most 2.5 P" in said and "DIN 76 - A" not in said


def test_a_nut_goes_on_where_nothing_beyond_is_as_thick_as_its_seat(nutted):
    """On the tail's shaft the hub of its drive sits on the same 20 mm as the bearing."""
    by = {(held.shaft, held.way): held for held in ends(nutted("undercut"))}
    assert by["tail", 1].room > 0.02 and by["tail", 1].nut is None
    assert by["intermediate", -1].nut is not None
