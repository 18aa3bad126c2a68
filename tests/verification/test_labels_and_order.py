"""Names are names and the order of keys is none: every label of a design changed, every record turned round."""

import json
import tomllib

import numpy as np
import pytest

from gearwright.dynamics import modes
from gearwright.dynamics.assembly import assemble
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import parse

NAMED = (
    "turbines",
    "motors",
    "propellers",
    "rotors",
    "generators",
    "accessories",
    "loads",
    "pairs",
    "planetaries",
    "epicyclics",
    "clutches",
    "cases",
    "bearings",
)
"""Tables whose keys are labels. Their own order stays: stages stand along a shaft, and cases begin, in it."""
ENDS = ("locates", "pinion_apex", "wheel_apex")
"""Keys whose ``first`` and ``second`` are ends of a shaft."""


def labels(design):
    """Return every label -> another one, whose alphabetical order is the opposite one."""
    names = [*design["shafts"], *(name for table in NAMED for name in design.get(table, {}))]
    return {name: f"z{999 - place}-label" for place, name in enumerate(sorted(set(names))) if name != "rated"}


def renamed(value, names, key=""):
    if isinstance(value, dict):
        return {name_of(name, names): renamed(inner, names, name) for name, inner in value.items()}
    if isinstance(value, list):
        return [renamed(inner, names, key) for inner in value]
    return name_of(value, names) if isinstance(value, str) and key not in ENDS else value


def name_of(text, names):
    """Return a label or a dotted path with its labels changed."""
    return ".".join(names.get(part, part) for part in text.split("."))


def turned_round(value, key=""):
    """Return all records with their keys in the opposite order; what is labelled keeps its order."""
    if not isinstance(value, dict):
        return value
    inner = [(name, turned_round(each, name)) for name, each in value.items()]
    return dict(inner if key in (*NAMED, "layout", "joints", "suns", "rings", "planets") else reversed(inner))


def toml(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {toml(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False)


def numbers(text):
    """Return what sizing, checks and modes say of a design."""
    sizing = size(parse(text))
    found = {
        "gears": [[g.teeth, g.module, g.face_width, g.mass, g.inertia] for g in sizing.gears],
        "meshes": [[m.tangential_force, m.radial_force, m.bending_margin, m.contact_margin] for m in sizing.meshes],
        "shafts": [[s.diameter, s.mass, s.inertia, s.stiffness, s.axial_force, *s.axis] for s in sizing.shafts],
        "carriers": [[c.pin_diameter, c.mass, c.inertia] for c in sizing.carriers],
        "bearings": [[b.life, b.bearing.mass] for b in sizing.bearings],
        "checks": sorted([check.margin] for check in sizing.checks if check.margin is not None),
        "not assessed": [[sum(check.margin is None for check in sizing.checks)]],
    }
    return {name: np.array(rows, dtype=float) for name, rows in found.items()} | {
        "modes": modes(assemble(sizing)).frequency
    }


AS_WORDS = ("differential-hybrid", "ec120b", "ec120b-as-reported", "ravigneaux-automatic", "wind-turbine-5mw")
"""Designs with labels that are words of the file, too, such as a shaft ``ring``: `renamed` cannot tell them apart."""


@pytest.mark.parametrize("name", [name for name in shipped_designs() if name not in AS_WORDS])
def test_other_names_and_another_order_of_keys_give_the_same_numbers(name):
    """Rounding only: sums may run in another order. Free modes are zero to the square root of it."""
    text = shipped_design(name).read_text(encoding="utf-8")
    design = tomllib.loads(text)
    names = labels(design)
    other = turned_round(renamed(design, names))
    assert not set(names) & set(other["shafts"]) and list(other) != list(design)
    changed = "\n".join(f"{key} = {toml(value)}" for key, value in other.items())
    before, after = numbers(text), numbers(changed)
    for what in before:
        np.testing.assert_allclose(
            after[what], before[what], rtol=1e-6, atol=1e-3 if what == "modes" else 1e-12, err_msg=what
        )
