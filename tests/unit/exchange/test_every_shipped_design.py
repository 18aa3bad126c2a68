"""Every shipped design as every file and page, read back: each is whole, and holds what the sizing holds.

Elsewhere over all of them: sheets and their DXF in `render`, GLB in `shape`, REXS beside this file.
"""

import base64
import csv
import io
import math
import re
import zipfile
from xml.etree import ElementTree

import numpy as np
import pytest

import gearwright as gw
from gearwright.exchange.step import to_step
from gearwright.exchange.tables import all_tables, to_csv, to_netcdf, to_parquet, to_xlsx
from gearwright.render.pages.designs.report import report
from gearwright.render.pages.designs.review import review_page
from gearwright.render.pages.designs.turning import turning
from gearwright.reviews import review_of
from gearwright.shape import COLOURS, scene
from gearwright.shape.record import triangles_of
from gearwright.shape.solids import Fastener, Solid
from gearwright.store import text_of_value
from html_checks import stands_alone
from shipped_work import sized
from step_files import closed_solids, middle_of, place_of, read_back, volume_of
from workbooks import book

each_design = pytest.mark.parametrize("design", gw.shipped_designs())


@each_design
def test_report_review_and_turning_page_are_pages_that_stand_alone(design):
    sizing = sized(design)
    review = review_of(sizing)
    stands_alone(report(sizing, review=review))
    stands_alone(review_page(review))
    model = re.search(r'<script type="[^"]+" id="model">(.*?)</script>', turning(sizing, detail="coarse"), re.DOTALL)
    assert base64.b64decode(model[1])[:4] == b"glTF"


@each_design
def test_a_saved_sizing_is_loaded_as_it_was(design, tmp_path):
    path = tmp_path / "sizing.json"
    path.write_text(text_of_value(sized(design)), encoding="utf-8")
    assert gw.load(path) == sized(design)


@each_design
def test_csv_has_every_cell_of_every_table(design):
    rows, tables = list(csv.DictReader(io.StringIO(to_csv(sized(design))))), all_tables(sized(design)).values()
    assert {row["table"] for row in rows} == {table.title for table in tables}
    found = {(row["table"], row["row"], row["quantity"], row["value"].removeprefix("'")) for row in rows}
    assert all(math.isfinite(float(row["value"])) for row in rows if row["unit"] and row["value"][:1].isdigit())
    assert len(found) >= len({row["row"] for row in rows})


@each_design
@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_an_fmu_describes_its_variables_in_xml_and_brings_its_sources(design, version):
    """FMI 2.0.4, clause 2.5, and FMI 3.0, clause 2.5: modelDescription.xml at the root, unique references by name."""
    file = gw.to_fmu(sized(design), version=version)
    with zipfile.ZipFile(io.BytesIO(file.content)) as archive:
        assert archive.testzip() is None
        told = ElementTree.fromstring(archive.read("modelDescription.xml"))
        assert any(name.startswith("sources/") and name.endswith(".c") for name in archive.namelist())
    assert told.get("fmiVersion") == version
    names = [variable.get("name") for variable in told.find("ModelVariables") if variable.get("name") != "time"]
    assert len(names) == len(set(names))
    assert {port.name for port in file.ports} <= set(names)


@pytest.mark.extra("xlsxwriter")
@each_design
def test_a_workbook_has_a_sheet_for_every_table_and_a_cell_for_every_value(design):
    tables, sheets = all_tables(sized(design)), book(to_xlsx(sized(design)))
    assert list(sheets) == ["contents", *(name.replace("_", " ")[:31] for name in tables)]
    for table, sheet in zip(tables.values(), list(sheets.values())[1:], strict=True):
        assert sum(value is not None for value in sheet.values()) >= sum(
            bool(c.text) for row in table.rows for c in row
        )


@pytest.mark.extra("pyarrow")
@each_design
def test_parquet_has_the_rows_of_the_long_form(design):
    from pyarrow import parquet

    read = parquet.read_table(io.BytesIO(to_parquet(sized(design)))).to_pylist()
    for row, line in zip(read, csv.DictReader(io.StringIO(to_csv(sized(design)))), strict=True):
        assert (row["table"], row["quantity"], row["unit"]) == (line["table"], line["quantity"], line["unit"])
        value = row["text"] if row["value"] is None else row["value"]
        assert value == (line["value"].removeprefix("'") if row["value"] is None else float(line["value"]))


@pytest.mark.extra("h5netcdf")
@each_design
def test_netcdf_has_a_group_for_every_table_with_a_variable_for_every_column(design):
    import h5netcdf

    with h5netcdf.File(io.BytesIO(to_netcdf(sized(design))), "r") as read:
        assert set(read.groups) == set(all_tables(sized(design)))
        for name, table in all_tables(sized(design)).items():
            rows = [value.decode() if isinstance(value, bytes) else value for value in read[name]["row"][:]]
            assert rows == [row[0].text for row in table.rows]
            assert len(read[name].variables) == len(table.columns) + 1


@pytest.mark.extra("OCP")
@each_design
def test_step_is_read_back_as_closed_valid_solids_that_fill_what_is_weighed(design, tmp_path):
    """Solids weigh what sizing weighs (`shape`); read back, each fills what its triangles of 720 corners enclose.

    Open CASCADE integrates over ends with many teeth to 3 %; circles of 720 corners lose 1.3e-5, and thin or small
    bodies several times that share.
    """
    built = scene(sized(design), detail="smooth")
    title, bodies, painted = read_back(to_step(sized(design)).content, tmp_path)
    nodes = {node.name: node for node in built.nodes if node.surface}
    assert title == built.name
    assert bodies.keys() == nodes.keys()
    solids = {}
    for name, node in nodes.items():
        solid, body = built.solids[node.surface], bodies[name]
        if node.surface not in solids:
            solids[node.surface] = volume_of(body)
            toothed = isinstance(solid, Solid) and solid.edges is not None and solid.edges.any()
            near = 0.04 if toothed else 0.03 if isinstance(solid, Fastener) else 6e-3
            assert closed_solids(body) == 1, name
            assert solids[node.surface] == pytest.approx(triangles_of(solid, 720).volume, rel=near), name
            if isinstance(solid, Solid) and "mount" not in name:  # round bodies, on their axes
                along = (middle_of(body) - node.axes.origin) @ node.axes.turned
                assert math.hypot(along[0], along[1]) < 1e-3 * built.surfaces[node.surface].reach, name
            assert painted[node.surface] == pytest.approx(COLOURS[node.look], abs=2e-3), name
        assert np.allclose(place_of(body), node.axes.origin, rtol=0.0, atol=1e-9), name
