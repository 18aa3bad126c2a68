"""Teeth fly as they are made: with the relief and the class that their sizing gave them."""

from functools import cache

import pytest

from gearwright.mission import fly, gear_damage
from gearwright.mission.lives.damage import alike, extremes
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.sizing.insight import made_of, rating_as_sized
from gearwright.spec import edited, read, read_mission

STAGES = ("first", "second")


@cache
def flown(told):
    """Return the flight of the hybrid, its sizes given: with open relief and class, with those written, with others."""
    open_ = size(edited(read(shipped_design("in-line-h2")), {"gears.rating": "iso6336"}))
    gears = {gear.name: gear for gear in open_.gears}
    changes = dict[str, object]()
    for stage in STAGES:
        sun = gears[f"{stage}.sun"]
        own = {f"{role}_teeth": gears[f"{stage}.{role}"].teeth for role in ("sun", "planet", "ring")}
        own |= {"module_mm": 1e3 * sun.module, "face_width_mm": 1e3 * sun.face_width}
        changes |= {f"planetaries.{stage}.{key}": value for key, value in own.items()}
    sized = size(edited(open_.design, changes))
    if told != "open":
        for stage in STAGES:
            made = made_of(next(mesh for mesh in sized.meshes if mesh.stage == stage))
            own = {"tip_relief_um": 1e6 * made.relief, "tip_relief_tolerance_um": 1e6 * made.tolerance,
                   "tolerance_class": int(made.grade) + (told == "coarser")}  # fmt: skip
            changes |= {f"planetaries.{stage}.gears.iso6336.{key}": value for key, value in own.items()}
        sized = size(edited(open_.design, changes))
    return fly(sized, read_mission(shipped_mission("thesis")))


def damages(told):
    return {(row.gear, row.mode): row.damage for row in gear_damage(flown(told))}


def test_gears_wear_in_flight_with_the_relief_and_class_that_sizing_chose():
    """The same as if relief, tolerance and class were written; a class coarser wears them more."""
    assert damages("open") == pytest.approx(damages("written"), rel=1e-6)
    coarser = damages("coarser")
    assert all(coarser[key] >= damage for key, damage in damages("open").items())
    assert any(coarser[key] > 1.05 * damage for key, damage in damages("open").items())


def test_what_a_flight_asks_of_a_mesh_has_its_teeth_as_made():
    flight = flown("open")
    for mesh in flight.sizing.train.meshes:
        made = made_of(next(row for row in flight.sizing.meshes if row.name == mesh.name))
        ((ask, _, members),) = alike([flight], mesh, [extremes(flight)], [True])
        assert (ask.made, members) == (made, [0])
        assert made.relief > 0.0
        assert rating_as_sized(flight.sizing, mesh.stage).rules.iso6336.tolerance_class == int(made.grade)
