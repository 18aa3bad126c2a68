"""How deep two meshing gears on parallel axes stand in each other, by their outlines in polar coordinates."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.gears import TransverseTooth, transverse_form
from gearwright.shape.contacts import Contact, contacts_of
from gearwright.shape.gears import Leaning, leanings
from gearwright.shape.phases import Phases, helix_rate, phases_of
from gearwright.shape.stands import stands_of
from gearwright.shape.teeth import kind_of
from gearwright.sizing import Sizing
from gearwright.sizing.mass import tooth_of

POINTS = 40
"""Points on a fillet and on a flank [-]."""
NEAR = np.arange(-6, 7)
"""Teeth beside the touching point that are looked at; no mesh has more in contact."""


class Planar(NamedTuple):
    """The meshes of parallel axes, and how their gears stand and lean."""

    contacts: tuple[Contact, ...]
    phases: Phases
    leaning: Mapping[str, Leaning]


def planar_contacts(sizing: Sizing) -> Planar:
    """Return the meshes of parallel axes, with how their gears stand and lean.

    Args:
        sizing: As sized.
    """
    stands = stands_of(sizing)
    leaning, contacts = leanings(sizing, stands), contacts_of(sizing, stands)
    phases = phases_of(sizing, stands, contacts, {name: lean.turning for name, lean in leaning.items()})
    planar = tuple(contact for contact in contacts if kind_of(sizing, contact.mesh.stage) == "cylindrical")
    return Planar(planar, phases, leaning)


def deepest(sizing: Sizing, contact: Contact, planar: Planar, moments: Sequence[float]) -> float:
    """Return how deep teeth stand in each other at moments of the case that speaks for the design [m].

    Args:
        sizing: As sized.
        contact: A mesh of parallel axes.
        planar: Of the sizing.
        moments: [s].
    """
    pair, phases = (contact.first, contact.second), planar.phases
    teeth = [tooth_of(sizing, stand.gear) for stand in pair]
    forms = [transverse_form(tooth, fillet=POINTS, flank=POINTS) for tooth in teeth]
    flow, carrier = sizing.reference, contact.mesh.nodes[2]
    base = phases.senses[carrier] * flow.speeds[carrier]
    speeds = [phases.senses[stand.node] * flow.speeds[stand.node] - base for stand in pair]
    between = pair[1].axes.origin - pair[0].axes.origin
    apart = complex(*(float(between @ pair[0].axes.turned[:, k]) for k in (0, 1)))
    lean = helix_rate(pair[1], planar.leaning[pair[1].name].turning) * contact.offset
    worst = -1.0
    for moment in moments:
        turned = [phases.turned[stand.name] + speed * moment for stand, speed in zip(pair, speeds, strict=True)]
        turned[1] -= lean
        for one, other, there in ((0, 1, -apart), (1, 0, apart)):
            radius, half = forms[one]
            pitch = 2.0 * math.pi / teeth[one].teeth
            first = round((contact.angles[one] - turned[one]) / pitch)
            angle = turned[one] + pitch * (first + NEAR)[:, None, None] + np.stack([half, -half])
            seen = (radius * np.exp(1j * angle) + there).ravel()
            worst = max(worst, _depth(seen * np.exp(-1j * turned[other]), teeth[other], forms[other]))
    return worst


def _depth(points: Floats, tooth: TransverseTooth, form: tuple[Floats, Floats]) -> float:
    """Return how deep points, complex, stand in a gear whose tooth 0 stands about the angle 0 [m]."""
    radius, half = form
    order = np.argsort(radius)
    far, pitch = np.abs(points), 2.0 * math.pi / tooth.teeth
    beside = np.abs(np.angle(points) - np.round(np.angle(points) / pitch) * pitch)
    between = (far >= radius.min()) & (far <= radius.max())
    flank = (np.interp(far, radius[order], half[order]) - beside) * far * math.cos(tooth.pressure_angle)
    root = tooth.side * (tooth.root_radius - far)
    return float(max(np.max(flank[between], initial=-1.0), np.max(root, initial=-1.0)))
