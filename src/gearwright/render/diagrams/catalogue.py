"""Every diagram, with the tables whose keys it shows."""

from __future__ import annotations

from gearwright.render.diagrams import shafts, space, stages, teeth
from gearwright.render.diagrams.diagram import Diagram

DIAGRAMS: tuple[Diagram, ...] = (
    Diagram(
        "input-machines", "Diameters of machines",
        ("turbines.NAME", "propellers.NAME", "rotors.NAME"), shafts.machines,
    ),
    Diagram("input-pair", "A cylindrical pair", ("pairs.NAME", "gears"), teeth.pair),
    Diagram("input-bevel", "A bevel pair", ("pairs.NAME", "gears"), teeth.bevel),
    Diagram(
        "input-backlash", "Backlash of a mesh",
        ("pairs.NAME", "planetaries.NAME", "epicyclics.NAME"), teeth.mesh,
    ),
    Diagram(
        "input-teeth", "Teeth in a normal section",
        ("gears", "gears.iso6336", "gears.agma2001", "losses", "pairs.NAME", "errors.NAME"), teeth.teeth,
    ),
    Diagram("input-planetary", "A planetary set", ("planetaries.NAME",), stages.planetary),
    Diagram(
        "input-planet-bearing", "What a planet turns on",
        ("planetaries.NAME.planet_bearing",), stages.planet_bearing,
    ),
    Diagram(
        "input-compound", "A stepped planet of a compound set",
        ("epicyclics.NAME", "epicyclics.NAME.suns.NAME", "epicyclics.NAME.planets.NAME"), stages.compound,
    ),
    Diagram("input-shafting", "Lengths of shafts that are left open", ("shafting",), shafts.shafting),
    Diagram("input-shaft", "Along a shaft", ("layout.NAME", "layout.NAME.places.NAME"), shafts.layout),
    Diagram("input-angle", "Where an axis stands, seen along x", ("layout.NAME",), space.angles),
    Diagram(
        "input-keep-out", "A box and a cylinder that the gearbox may not take",
        ("keep_out.NAME", "keep_out.NAME.start"), space.keep_out,
    ),
    Diagram("input-errors", "What is not as drawn", ("errors.NAME",), space.errors),
    Diagram("input-bearing", "A bearing in its housing", ("bearings.NAME", "housing"), shafts.seat),
    Diagram("input-joint", "Between a shaft and what sits on it", ("joints.NAME",), shafts.joint),
)  # fmt: skip
"""In the order of the file."""
