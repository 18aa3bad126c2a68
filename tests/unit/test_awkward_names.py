"""Names with dashes, spaces and words of the trade: no page takes one part for another because of what it is called."""

import pytest

from designs import HYBRID, PAIR, changed
from gearwright.dynamics import Outputs, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import critical_speeds, dynamic_loads, first_meshes, order_name
from gearwright.identity import Kind, PartId, Role, Row, carrier_part, gear_part, mesh_part
from gearwright.render.figures.dynamics import campbell_figure
from gearwright.render.figures.motion import families
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse

SPLIT = shipped_design("off-set").read_text(encoding="utf-8")
RENAMED = SPLIT.replace("left", "out").replace("right", "out-1")
"""The layshaft of one path is called as the other one, with a dash and a number."""


@pytest.fixture(scope="module")
def ran():
    """The design under its two sets of names, each with a short run."""
    sizings = [size(parse(text)) for text in (SPLIT, RENAMED)]
    return [(sizing, simulate(assemble(sizing, "rated"), 2e-3, outputs=Outputs(start=1e-3))) for sizing in sizings]


def test_a_row_has_its_own_lines_only(ran):
    sizing, trace = ran[1]
    found = {mesh.name: trace.labels.lines_of(mesh.part) for mesh in sizing.train.meshes}
    assert found == {name: (name,) for name in ("first.out", "first.out-1", "second.out", "second.out-1")}
    assert first_meshes(sizing, assemble(sizing, "rated")) == list(found)


def test_peaks_do_not_depend_on_what_shafts_are_called(ran):
    """Halves of a double-helical gear are one line, and its neighbour's line is none of its own."""
    plain, renamed = ([vars(load) | {"mesh": ""} for load in dynamic_loads(*run)] for run in ran)
    assert renamed == plain


def test_parallel_meshes_are_no_planets_of_one_set(ran):
    plain, renamed = (families(trace.labels, "m") for _, trace in ran)
    assert len(renamed) == len(plain) == 4
    assert all(len(lines) == 1 for lines in renamed.values())


def test_planets_of_a_stage_whose_name_has_a_number_are_one_family():
    sizing = size(parse(HYBRID.replace(".first]", ".first-1]").replace(".second]", ".first-2]")))
    found = families(assemble(sizing, "rated").labels, "m")
    assert {row: len(lines) for row, lines in found.items()} == {
        "first-1.sun-planet": 3, "first-1.planet-ring": 3, "first-2.sun-planet": 5, "first-2.planet-ring": 5,
    }  # fmt: skip


def test_a_pair_may_be_called_as_orders_are():
    """``low mesh × 2`` is no order of a stage ``low``."""
    sizing = size(parse(changed(PAIR, "[pairs.stage]", '[pairs."low mesh"]')))
    (found,) = critical_speeds(sizing)
    names = [order_name(sizing, order.tone) for order in found.campbell.orders if order.excitation is None]
    assert {name.stage for name in names} == {"low mesh"}
    assert "low mesh mesh" in map(str, names)
    assert campbell_figure(sizing, found).axes


def test_every_coordinate_line_and_number_of_an_assembled_design_knows_whose_it_is():
    moving = HYBRID + '\n[dynamics]\nfidelity = "translational"\n'
    labels = assemble(size(parse(moving)), "rated").labels
    assert all(owner.part is not None for owner in (*labels.coordinate_owners, *labels.line_owners))
    assert labels.lines_of(mesh_part("first", Row.SUN_PLANET, number=2)) == ("first.sun-planet-2",)
    whose = dict(zip(labels.coordinates, labels.coordinate_owners, strict=True))
    assert whose["first.planet-2.radial"] == (gear_part("first", Role.PLANET, number=2), "radial")
    assert whose["second.carrier"] == (carrier_part("second"), "")
    assert whose["electric"] == (PartId(Kind.MACHINE, "electric"), "")
    supports = [owner for kind, owner in zip(labels.line_kinds, labels.line_owners, strict=True) if kind == "support"]
    assert {owner.what for owner in supports} >= {"support.x", "support.y", "pin.radial", "pin.tangential"}


def test_a_row_is_of_itself_and_so_is_each_of_its_planets():
    row = mesh_part("first", Row.SUN_PLANET)
    assert row.is_of(row) and row._replace(number=2).is_of(row) and not row.is_of(row._replace(number=2))
    assert not mesh_part("first-1", Row.SUN_PLANET).is_of(row)
