"""Values given in place of computed ones: in [overrides] or in the table of their part, with one result."""

from dataclasses import fields

import pytest

from designs import PAIR, problem, problems
from gearwright.errors import DesignError
from gearwright.particulars import particulars
from gearwright.render.tables.sizing import tables_of
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, pair_data, size
from gearwright.spec import edited, parse, read
from gearwright.spec.design import NO_ORIGIN
from gearwright.spec.design.design import givable

MEMBERS = ("pinion", "wheel", "sun", "planet", "ring", "carrier")
KEYS = {
    **{key: key for key in ("module", "outer_module", "face_width", "pin_diameter", "plate_thickness", "eye_wall")},
    **{f"{member}.{what}": f"{member}_{what}" for member in MEMBERS for what in ("mass", "inertia")},
    **{key: key for key in ("length", "diameter", "mass", "inverter_mass", "cooling_mass")},
}
"""End of a path -> key in the table of its part."""
DESIGNS = {
    "mixed-h1": ("pairs.first", "planetaries.second", "layout.", "motors.electric", "gearbox"),
    "ec120b": ("pairs.bevel", "layout.mast"),
}
"""Design -> tables whose keys are tried on it."""


def table_of(design, name):
    """Return the table of a stage, shaft or motor."""
    tables = {"pairs": design.pairs, "planetaries": design.planetaries, "motors": design.motors}
    owner = next((table for table, entries in tables.items() if name in entries), "layout")
    return "gearbox" if name == "gearbox" else f"{owner}.{name}"


def computed(sizing):
    """Yield the path of everything that can be given, with its computed value [SI]."""
    for gear in sizing.gears:
        yield f"{gear.name}.mass", gear.mass
        yield f"{gear.name}.inertia", gear.inertia
        pair = sizing.design.pairs.get(gear.stage)
        if pair is not None and pair.kind == "bevel":
            mesh = next(mesh for mesh in sizing.meshes if mesh.name == gear.stage)
            yield f"{gear.stage}.outer_module", pair_data(sizing, mesh).outer_module
        else:
            yield f"{gear.stage}.module", gear.module
        yield f"{gear.stage}.face_width", gear.face_width
    for carrier in sizing.carriers:
        for field in ("pin_diameter", "plate_thickness", "eye_wall"):
            yield f"{carrier.stage}.{field}", getattr(carrier, field)
        yield f"{carrier.stage}.carrier.mass", carrier.mass
        yield f"{carrier.stage}.carrier.inertia", carrier.inertia
    for shaft in sizing.shafts:
        yield f"{shaft.name}.length", shaft.length
        yield f"{shaft.name}.diameter", shaft.diameter
        yield f"{shaft.name}.mass", shaft.mass
    for machine in sizing.machines:
        beside = {"mass": machine.mass, "inverter_mass": machine.inverter, "cooling_mass": machine.cooling}
        yield from ((f"{machine.name}.{key}", mass) for key, mass in beside.items() if mass)
    yield "gearbox.mass", sizing.mass


CHANGES = {"mixed-h1": {"motors.electric.mass_law": "public"}}
"""Design -> what makes it compute all that can be given."""
SIZED = {name: size(edited(read(shipped_design(name)), CHANGES.get(name, {}))) for name in DESIGNS}


def unit_of(path):
    """Return the suffix of a path's unit, and its SI value."""
    end = path.rpartition(".")[2]
    return ("_kg", 1.0) if end.endswith("mass") else ("_kg_m2", 1.0) if end == "inertia" else ("_mm", 1e-3)


def tried():
    """Yield design, path, key in its table, and a value a little above the computed one, in the unit of the key."""
    for name, tables in DESIGNS.items():
        for path, value in dict(computed(SIZED[name])).items():
            part, _, end = path.partition(".")
            key = f"{table_of(SIZED[name].design, part)}.{KEYS[end]}"
            if path not in SIZED[name].given and key.startswith(tables):
                yield name, path, key, 1.05 * value / unit_of(path)[1]


def results(sizing):
    """Return the mass of a sizing, and every field but the design itself and what is given of it."""
    own = [field.name for field in fields(Sizing) if field.name not in ("design", "given")]
    return sizing.mass, {name: getattr(sizing, name) for name in own}


@pytest.mark.parametrize(("name", "path", "key", "value"), list(tried()))
def test_a_value_acts_alike_in_both_places(name, path, key, value):
    """Bit for bit; and it acts: the sizing is another one than without it."""
    suffix, design = unit_of(path)[0], SIZED[name].design
    overridden = size(edited(design, {f"overrides.{path}{suffix}": value}))
    in_its_table = size(edited(design, {f"{key}{suffix}": value}))
    assert results(in_its_table) == results(overridden)
    assert results(in_its_table) != results(SIZED[name])
    assert in_its_table.given[path].value == overridden.given[path].value


def test_everything_that_can_be_given_is_tried():
    offered = {key.path.partition(".")[2] for name in DESIGNS for key in givable(SIZED[name].design)}
    assert {path.partition(".")[2] for _, path, _, _ in tried()} == offered == set(KEYS)


BOTH = [
    ('[overrides]\n"stage.module_mm" = 3\n', "module_mm = 3", "pairs.stage.module"),
    ('[overrides]\n"stage.pinion.mass_kg" = 3\n', "pinion_mass_kg = 3", "pairs.stage.pinion_mass"),
]


@pytest.mark.parametrize(("override", "own", "place"), BOTH)
def test_a_value_in_both_places_is_refused_with_both(override, own, place):
    found = problem(PAIR + f"{own}\n{override}")
    assert found.path.startswith("overrides.stage.")
    assert f"and as {place}" in found.message


def test_a_layout_and_an_override_do_not_say_the_same_twice():
    text = PAIR + '[layout.fast]\nlength_mm = 80\n[overrides]\n"fast.length_mm" = 90\n'
    assert problem(text).message == (
        "fast.length is given twice: here, and as layout.fast.length_mm; keep one of the two"
    )


def test_everything_that_names_nothing_is_told_at_once_when_the_file_is_read():
    text = PAIR + '[overrides]\n"stage.modul_mm" = 3\n"stag.face_width_mm" = 3\n[origins]\n"slow.mass_kg" = "scales"\n'
    found = problems(text)
    assert [each.path for each in found] == [
        "overrides.stage.modul_mm", "overrides.stag.face_width_mm", "origins.slow.mass_kg",
    ]  # fmt: skip
    assert "did you mean stage.module_mm?" in found[0].message
    assert "did you mean stage.face_width_mm?" in found[1].message


def test_an_origin_belongs_to_either_place():
    text = PAIR + 'module_mm = 3\n[overrides]\n"slow.mass_kg" = 2\n[origins]\n"stage.module_mm" = "hobs at hand"\n'
    given = size(parse(text)).given
    assert {path: entry.origin for path, entry in given.items()} == {
        "stage.module": "hobs at hand", "slow.mass": NO_ORIGIN,
    }  # fmt: skip
    rows = tables_of(particulars(size(parse(text))))["overrides"].rows
    assert [[cell.text for cell in row] for row in rows] == [
        ["pairs.stage.module_mm", "3.000", "hobs at hand"], ["slow.mass_kg", "2.000", NO_ORIGIN],
    ]  # fmt: skip


SHARED = """\
[pairs.drive]
pinion = "motor"
wheel = "stage.pinion"
"""


def test_a_pair_without_a_module_of_its_own_says_whose_it_has():
    text = PAIR.replace('["fast"', '["motor", "fast"') + SHARED
    text += 'module_mm = 2\nwheel_mass_kg = 3\n[motors.m]\nshaft = "motor"\npower_kw = 1\nspeed_rpm = 12000\n'
    found = {each.path: each.message for each in problems(text)}
    assert found["pairs.drive.module_mm"] == "has no effect: it has the module of pairs.stage; give it there"
    assert found["pairs.drive.wheel_mass_kg"] == "has no effect: the gear is that of pairs.stage; give it there"


def test_no_part_is_called_like_the_whole():
    """Its mass in [overrides] would be that of the gearbox, too."""
    assert problem(PAIR.replace('"slow"', '"gearbox"')).path == "shafts"


def test_only_a_bevel_pair_has_an_outer_module():
    assert problem(PAIR + "outer_module_mm = 3\n").message == "has no effect: only a bevel pair has one"
    with pytest.raises(DesignError, match="a bevel pair has an outer_module"):
        edited(read(shipped_design("ec120b")), {"pairs.bevel.module_mm": 3.0})
