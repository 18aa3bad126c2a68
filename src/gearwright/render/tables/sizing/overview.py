"""What a reader wants to see of a Sizing, as tables: load cases, margins worst first, gears, shafts, masses."""

from __future__ import annotations

import math

from gearwright.render.grid.table import Mark, Table, table
from gearwright.render.tables.checks import COLUMNS, JUST_ENOUGH, judged
from gearwright.render.tables.sizing.given import given_by_user, overrides_table
from gearwright.render.tables.sizing.losses import loss_tables
from gearwright.render.tables.sizing.masses import mass_tables
from gearwright.render.tables.sizing.materials import materials_table
from gearwright.render.tables.sizing.mounted import mounted_tables
from gearwright.render.tables.sizing.places import place_tables
from gearwright.render.tables.sizing.planets import planet_table
from gearwright.render.tables.sizing.teeth import chosen_teeth
from gearwright.sizing import Sizing, asked_speeds, bearing_forces, mass_groups, mass_parts, passing, planet_positions
from gearwright.sizing.arrangement import envelope
from gearwright.sizing.summaries import mesh_factors
from gearwright.train import Branch, branches

_FACTORS = (
    "name", "load_factor", "shared", "case", "resonance_ratio", "dynamic_factor", "relief_term", "tip_relief",
    "tolerance_class",
)  # fmt: skip
_OF_FACTORS = "N in the case nearest to the main resonance; K_V and B_k in the heaviest case."
_KEPT = (
    "Whole teeth give them. A speed is kept, met exactly, of the first machine that [speeds] keep names: left out, a"
    " turbine's, else a motor's."
)
_PASSING = "Backwards: with every torque turned; what gives nothing then is self-locking. Clutches stay as they are."
_BEARINGS = "Positions from the shaft's first end; shafts that only torque acts on need none for it."
_THICKEST = "d of a shaft with steps is its thickest; the stress is of a section, listed with its own d under strength."
_ENVELOPE = "Box around tip circles and shafts, without housing."


def not_in_the_mass(sizing: Sizing) -> str:
    """Return what the mass of the train leaves out.

    Args:
        sizing: As sized.
    """
    bearings = "bearings of shafts" if "planet bearings" in mass_groups(sizing) else "bearings"
    return f"Not in the mass: housing, {bearings}, oil system, accessories, motors."


def flow_tables(sizing: Sizing) -> tuple[Table, ...]:
    """Return one table per load case: speed, torque and power of every part on every shaft.

    Args:
        sizing: As sized.
    """
    note = "Torque on the shaft; power into the shaft is positive."
    fields = ("shaft", "part", "speed", "torque", "power")
    return tuple(table(f"Case {case}", shaft_by_shaft(sizing, case), fields, note=note) for case in sizing.flows)


def shaft_by_shaft(sizing: Sizing, case: str) -> list[Branch]:
    """Return every part on every shaft in a load case, shaft by shaft.

    Args:
        sizing: As sized.
        case: Load case.
    """
    of_case = branches(sizing.train, sizing.flows[case])
    return [branch for shaft in sizing.design.shafts for branch in of_case if branch.shaft == shaft]


def passing_table(sizing: Sizing) -> Table:
    """Return how the gearbox and its epicyclic sets pass power, forwards and backwards, in every case.

    Args:
        sizing: As sized.
    """
    fields = ("case", "part", "driving", "driven", "forwards", "backwards", "locking")
    return table("Efficiency of the teeth", passing(sizing), fields, note=_PASSING)


def tables_of(sizing: Sizing) -> dict[str, Table]:
    """Return every table of a sizing, by a short name.

    Args:
        sizing: As sized.
    """

    def mark(record: object, field: str) -> Mark:
        return given_by_user(sizing, record, field)

    return {
        **mounted_tables(sizing),
        **loss_tables(sizing),
        **place_tables(sizing),
        **mass_tables(sizing),
        "margins": table("Margins, worst first", judged(sizing.checks), COLUMNS, note=JUST_ENOUGH),
        "speeds": table("Speeds that deviate from those asked", asked_speeds(sizing),
                        ("case", "machine", "asked", "actual", "deviation"), note=_KEPT),
        "passing": passing_table(sizing),
        "gears": table("Gears", sizing.gears, _gear_fields(sizing), mark=mark, note=_searched(sizing)),
        "meshes": table("Mesh forces", sizing.meshes, _mesh_fields(sizing), note="Forces of one mesh."),
        "load_factors": table("Load factors", tuple(mesh_factors(sizing)), _FACTORS, note=_OF_FACTORS),
        "rating": table("Mesh rating", sizing.meshes,
                        ("name", "module_bending", "module_contact", "bending_stress", "bending_margin",
                         "contact_stress", "contact_margin")),
        "shafts": table("Shafts: loads and stresses", sizing.shafts,
                        ("name", "case", "torque", "bending_moment", "axial_force", "diameter", "stress", "margin"),
                        mark=mark, note=_THICKEST if sizing.built_shafts else ""),
        "shaft_sizes": table("Shafts: sizes", sizing.shafts,
                             ("name", "length", "diameter", "bore", "stiffness", "mass", "inertia"), mark=mark),
        "bearings": table("Bearing loads", bearing_forces(sizing), ("shaft", "case", "position", "radial_force"),
                          note=_BEARINGS),
        "envelope": table("Envelope", [envelope(sizing)], ("width", "height", "length", "volume"),
                          note=_ENVELOPE),
        "overrides": overrides_table(sizing),
        "materials": materials_table(sizing),
        "carriers": table("Carriers", sizing.carriers,
                          ("stage", "torque", "tangential_force", "centrifugal_force", "radius", "pin_diameter",
                           "plate_thickness", "mass", "inertia"), mark=mark, note=_unequal(sizing)),
        "planet_bearings": planet_table(sizing),
        "machines": table("Machines", sizing.machines, ("name", "kind", "shaft", "torque", "mass", "inertia"),
                          mark=mark),
        "mass": table("Train as sized", mass_parts(sizing), ("part", "group", "count", "each", "total", "share"),
                      note=not_in_the_mass(sizing)),
    }  # fmt: skip


def _searched(sizing: Sizing) -> str:
    """Say of how many combinations the teeth are the lightest."""
    chosen = chosen_teeth(sizing)
    return f"Teeth: {chosen}." if chosen else ""


def _unequal(sizing: Sizing) -> str:
    """Say at which angles the pins of carriers stand that are not evenly divided."""
    words = []
    for stage, planetary in sizing.design.planetaries.items():
        if planetary.unequal_places:
            angles = planet_positions(sizing.design, stage, sizing.teeth)
            words.append(f"Pins of {stage} stand at {', '.join(f'{math.degrees(angle):.7g}°' for angle in angles)}.")
    return " ".join(words)


def _gear_fields(sizing: Sizing) -> tuple[str, ...]:
    helical = ("helix_angle",) if any(gear.helix_angle for gear in sizing.gears) else ()
    shift = ("profile_shift", "tip_alteration") if _shifted(sizing) else ()
    return ("name", "bodies", "teeth", "module", *helical, *shift, "face_width", "pitch_diameter", "mass", "inertia")


def _mesh_fields(sizing: Sizing) -> tuple[str, ...]:
    working = ("centre_distance", "working_pressure_angle") if _shifted(sizing) else ()
    forces = ("tangential_force", "radial_force", "axial_force")
    return ("name", "count", "case", *working, "load_factor", *forces, "pitch_line_velocity")


def _shifted(sizing: Sizing) -> bool:
    return any(gear.profile_shift or gear.tip_alteration for gear in sizing.gears)
