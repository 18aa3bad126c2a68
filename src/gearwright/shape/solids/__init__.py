"""Closed surfaces from numbers: toothed walls, cones, faces, bodies of revolution; none knows a sizing.

Which bodies a gearbox has, and where they stand, is for `shape`.
"""

from gearwright.shape.solids.chambers import (
    Chamber,
    End,
    Opening,
    chamber_surface,
    chamber_volume,
    depth_in,
    has_room,
    rim_of,
    round_hole,
)
from gearwright.shape.solids.crossed import Fineness, bevel_gear, face_wheel, spiral_turn
from gearwright.shape.solids.cuts import Cut, Leg, Rectangle, bored, cut_chamber, spans_in, united, without
from gearwright.shape.solids.fasteners import Fastener, Layer, fastener_surface
from gearwright.shape.solids.holes import Bores
from gearwright.shape.solids.plates import Arm, Form, Outline, plate, plate_form
from gearwright.shape.solids.round_bodies import bearing, block, stepped, tube, turned
from gearwright.shape.solids.solid import Section, Solid, surface_of
from gearwright.shape.solids.surface import Edges, Surface, around, circle, edges_of
from gearwright.shape.solids.toothed import Loop, disc_gear, loop_of, ring_gear

__all__ = [
    "Arm",
    "Bores",
    "Chamber",
    "Cut",
    "Edges",
    "End",
    "Fastener",
    "Fineness",
    "Form",
    "Layer",
    "Leg",
    "Loop",
    "Opening",
    "Outline",
    "Rectangle",
    "Section",
    "Solid",
    "Surface",
    "around",
    "bearing",
    "bevel_gear",
    "block",
    "bored",
    "chamber_surface",
    "chamber_volume",
    "circle",
    "cut_chamber",
    "depth_in",
    "disc_gear",
    "edges_of",
    "face_wheel",
    "fastener_surface",
    "has_room",
    "loop_of",
    "plate",
    "plate_form",
    "rim_of",
    "ring_gear",
    "round_hole",
    "spans_in",
    "spiral_turn",
    "stepped",
    "surface_of",
    "tube",
    "turned",
    "united",
    "without",
]
