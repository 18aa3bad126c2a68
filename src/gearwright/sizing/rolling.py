"""Where two gears roll on each other, and what their teeth push with: the working pitch circles of a sized mesh."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from gearwright.identity import Role, gear_part
from gearwright.parts.gears import transverse_pressure_angle
from gearwright.sizing.compound import pins_of
from gearwright.sizing.rating import Context, Rating, push_angle, working_radii
from gearwright.sizing.result import GearSizing
from gearwright.train import INTERNAL, Mesh


class Rolling(NamedTuple):
    """Working pitch circles of a mesh; of bevel and face gears their pitch circles."""

    radii: tuple[float, float]
    """r_w of both gears [m]."""
    centre_distance: float
    """a_w [m]."""
    pressure_angle: float
    """α_wt [rad]."""
    lean: float
    """tan β at the working pitch circle [-]."""

    def radial(self, force: float) -> float:
        """Return the force that parts the gears [N].

        Args:
            force: Tangential at the working pitch circle [N].
        """
        return force * math.tan(self.pressure_angle)

    def axial(self, force: float) -> float:
        """Return the force along the axes [N].

        Args:
            force: Tangential at the working pitch circle [N].
        """
        return force * self.lean


def rolling_of(rating: Rating, pair: tuple[GearSizing, GearSizing], mesh: Mesh) -> Rolling:
    """Return where the gears of a mesh roll on each other.

    Args:
        rating: Resolved rules of its stage.
        pair: Its gears.
        mesh: A row of the train.

    Source: ISO 21771:2007: r_w1 = a_w z_1/(z_1 + z_2), cos α_wt = a cos α_t/a_w, tan β_w = tan β r_w/r.
    """
    internal, teeth = mesh.sign == INTERNAL, (pair[0].teeth, pair[1].teeth)
    first, second = (gear.pitch_diameter / 2.0 for gear in pair)
    lean = math.tan(rating.helix_angle)
    if rating.shifts.centre is None or rating.kind != "cylindrical":
        angle = transverse_pressure_angle(rating.rules.pressure_angle, rating.helix_angle)
        return Rolling((first, second), second - first if internal else second + first, angle, lean)
    radii = working_radii(*teeth, rating, internal=internal, module=pair[0].module)
    angle = push_angle(*teeth, rating, internal=internal)
    centre = rating.shifts.centre * pair[0].module
    return Rolling(radii, centre, angle, lean * radii[0] / first)


def rollings(context: Context, gears: Mapping[str, GearSizing]) -> dict[str, Rolling]:
    """Return mesh row -> where its gears roll on each other.

    Args:
        context: What sizing reads.
        gears: By name.
    """
    return {
        mesh.name: rolling_of(context.rating(mesh), (gears[mesh.gears[0]], gears[mesh.gears[1]]), mesh)
        for mesh in context.train.meshes
    }


def set_rollings(context: Context, stage: str, gears: Mapping[str, GearSizing]) -> dict[str, Rolling]:
    """Return mesh, by the names of its gears in the design -> where they roll on each other.

    Args:
        context: What sizing reads.
        stage: Name of a compound set.
        gears: Its gears by the design's names.
    """
    names = {gear.name: gear for gear in gears.values()}
    return {
        mesh.own: rolling_of(context.rating(mesh), (names[mesh.gears[0]], names[mesh.gears[1]]), mesh)
        for mesh in context.train.meshes
        if mesh.stage == stage
    }


def set_pins(context: Context, stage: str, gears: Mapping[str, GearSizing]) -> dict[str, complex]:
    """Return planet body -> place of its pin in the first set of a compound set, y + i z [m].

    Args:
        context: What sizing reads.
        stage: Name of a compound set.
        gears: Its gears by the design's names.
    """
    centres = {mesh: rolls.centre_distance for mesh, rolls in set_rollings(context, stage, gears).items()}
    return pins_of(context.design.epicyclics[stage], gears, centres)


def pin_circle(context: Context, stage: str, gears: Mapping[str, GearSizing]) -> float:
    """Return the radius of the circle on which the pins of a planetary set stand [m].

    Args:
        context: What sizing reads.
        stage: Name of a planetary set.
        gears: By name.
    """
    sun, planet = (gears[str(gear_part(stage, role))] for role in (Role.SUN, Role.PLANET))
    centre = context.ratings[stage].shifts.centre
    return (sun.pitch_diameter + planet.pitch_diameter) / 2.0 if centre is None else centre * sun.module


def planet_push(context: Context, gears: Mapping[str, GearSizing], stage: str) -> float:
    """Return the radial force of both meshes on a planet over their tangential force, outwards [-].

    Args:
        context: What sizing reads.
        gears: By name.
        stage: Name of a planetary set.

    Source: equal normal forces of both meshes: (sin α_ws − sin α_wr)/(cos α_ws + cos α_wr); 0 without shift.
    """
    angles = {
        mesh.sign: rolling_of(context.ratings[stage], (gears[mesh.gears[0]], gears[mesh.gears[1]]), mesh).pressure_angle
        for mesh in context.train.meshes
        if mesh.stage == stage
    }
    sun, ring = (angle for sign, angle in sorted(angles.items(), key=lambda entry: entry[0] == INTERNAL))
    return math.tan(0.5 * (sun - ring))
