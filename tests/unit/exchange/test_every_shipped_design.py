"""Every shipped design as every file and page, read back: each is whole, and holds what the sizing holds.

Elsewhere over all of them: sheets and their DXF in `render`, GLB in `shape`, REXS beside this file.
"""

import base64
import csv
import io
import math
import re
import zipfile
from functools import cache
from string import ascii_uppercase
from xml.etree import ElementTree

import numpy as np
import pytest

import gearwright as gw
from gearwright.exchange.step import to_step
from gearwright.exchange.tables import all_tables, letters, table_csv, to_csv, to_netcdf, to_parquet, to_xlsx
from gearwright.particulars import particulars
from gearwright.render.pages.motion import turning
from gearwright.render.pages.report import report, review_page
from gearwright.reviews import review_of
from gearwright.shape import COLOURS, glb, scene
from gearwright.shape.solids import Fastener, Solid
from gearwright.shape.stands import triangles_of
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
    built = scene(sizing, detail="coarse")
    page = turning(particulars(sizing), built, glb(built))
    model = re.search(r'<script type="[^"]+" id="model">(.*?)</script>', page, re.DOTALL)
    assert base64.b64decode(model[1])[:4] == b"glTF"


@each_design
def test_a_saved_sizing_is_loaded_as_it_was(design, tmp_path):
    path = tmp_path / "sizing.json"
    path.write_text(text_of_value(sized(design)), encoding="utf-8")
    assert gw.load(path) == sized(design)


@cache
def tables_of(design):
    """Return the tables of a shipped design, by name."""
    return all_tables(sized(design))


def is_same(read, cell):
    """Tell whether what was read is what a cell holds: a number to its last bits, else the text that is shown."""
    if cell.is_number:
        found = float(read)
        return math.isclose(found, cell.value, rel_tol=1e-14) or (math.isnan(found) and math.isnan(cell.value))
    return read == cell.text


def read_csv(text):
    """Return the rows of a CSV file; the apostrophe before what a spreadsheet takes for a formula is no part of it."""
    return [[cell.removeprefix("'") for cell in row] for row in csv.reader(io.StringIO(text))]


@each_design
def test_tables_hold_what_the_sizing_holds(design):
    """In the units of the trade: teeth, m_n, b, m of gears; length, d, m of shafts; L_10h of bearings."""
    sizing = sized(design)
    asked = {
        "gears": (
            ("teeth", "module", "face_width", "mass"),
            ("", "mm", "mm", "kg"),
            (1.0, 1e3, 1e3, 1.0),
            sizing.gears,
        ),
        "shaft_sizes": (("length", "diameter", "mass"), ("mm", "mm", "kg"), (1e3, 1e3, 1.0), sizing.shafts),
        "bearing_sizes": (("life",), ("h",), (1.0 / 3600.0,), sizing.bearings),
    }
    for name, (fields, units, factors, records) in asked.items():
        if not records and name not in tables_of(design):
            continue
        table = tables_of(design)[name]
        places = [[column.name for column in table.columns].index(field) for field in ("name", *fields)]
        assert tuple(table.columns[place].unit for place in places) == ("", *units)
        for row, record in zip(table.rows, records, strict=True):
            known = [factor * getattr(record, field) for field, factor in zip(fields, factors, strict=True)]
            found = [row[place].value for place in places]
            assert found[0] == record.name and found[1:] == pytest.approx(known, rel=1e-12), (name, record.name)


@each_design
def test_csv_has_every_cell_of_every_table(design):
    """A line a cell that holds something, in order; a row's first cell is what the row is called."""
    header, *lines = read_csv(to_csv(sized(design)))
    cells = [
        (table.title, row[0].text, column, cell)
        for table in tables_of(design).values()
        for row in table.rows
        for place, (column, cell) in enumerate(zip(table.columns, row, strict=True))
        if cell.value is not None and (place or len(row) == 1)
    ]
    for line, (title, label, column, cell) in zip(lines, cells, strict=True):
        read = dict(zip(header, line, strict=True))
        assert (read["table"], read["row"], read["quantity"]) == (title, label, column.header or column.name)
        assert (read["unit"], read["symbol"], read["mark"]) == (column.unit, column.symbol, cell.mark)
        assert is_same(read["value"], cell), (title, label, column.name)


@each_design
def test_a_table_alone_is_read_back_with_its_headings_and_units(design):
    """Gears, and in turn another one of each design."""
    tables = tables_of(design)
    for name in {"gears", list(tables)[gw.shipped_designs().index(design) % len(tables)]}:
        table, (header, *rows) = tables[name], read_csv(table_csv(sized(design), name))
        assert header == [f"{each.header} [{each.unit}]" if each.unit else each.header for each in table.columns]
        for read, row in zip(rows, table.rows, strict=True):
            assert all(map(is_same, read, row)) and len(read) == len(row), (name, row[0].text)


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
    """Under the title: headings, symbols, units, equations, sources, then the rows. An infinite number is a text."""
    tables, sheets = tables_of(design), book(to_xlsx(sized(design)))
    assert list(sheets) == ["contents", *(name.replace("_", " ")[:31] for name in tables)]
    for table, sheet in zip(tables.values(), list(sheets.values())[1:], strict=True):
        assert sheet["A1"] == table.title
        for place, column in enumerate(table.columns):
            name = letters(place)
            heads = [sheet.get(f"{name}{line}", "") for line in (2, 3, 4)]
            assert heads == [column.header or column.name, column.symbol, column.unit]
            for line, row in enumerate(table.rows, start=7):
                assert is_same(sheet.get(f"{name}{line}", ""), row[place]), (table.title, row[0].text, column.name)
        below = {place for place in sheet if int(place.lstrip(ascii_uppercase)) == 7 + len(table.rows)}
        assert not any(sheet[place] for place in below), table.title


@pytest.mark.extra("pyarrow")
@each_design
def test_parquet_has_the_rows_of_the_long_form(design):
    """Which is compared with the tables cell by cell; here numbers are apart from words."""
    from pyarrow import parquet

    read = parquet.read_table(io.BytesIO(to_parquet(sized(design)))).to_pylist()
    header, *lines = read_csv(to_csv(sized(design)))
    for row, line in zip(read, (dict(zip(header, each, strict=True)) for each in lines), strict=True):
        assert [row[key].strip() for key in header if key != "value"] == [
            line[key].strip() for key in header if key != "value"
        ]
        assert (row["value"] is None) != (row["text"] is None)
        value = row["text"] if row["value"] is None else row["value"]
        assert value == (line["value"] if row["value"] is None else float(line["value"]))


@pytest.mark.extra("h5netcdf")
@each_design
def test_netcdf_has_a_group_for_every_table_with_a_variable_for_every_column(design):
    """Numbers with their unit, NaN where there is none; a column with words among its numbers is words."""
    import h5netcdf

    with h5netcdf.File(io.BytesIO(to_netcdf(sized(design))), "r") as read:
        assert set(read.groups) == set(tables_of(design))
        for name, table in tables_of(design).items():
            group, left = read[name], set(read[name].variables) - {"row"}
            assert (group.attrs["title"], words(group["row"])) == (table.title, [row[0].text for row in table.rows])
            for place, column in enumerate(table.columns):
                plain = column.name.replace("/", " over ")
                variable = group[plain if plain in left else f"{plain} of it"]
                left.remove(variable.name.rpartition("/")[2])
                cells = [row[place] for row in table.rows]
                assert variable.attrs["long_name"] == (column.header or column.name)
                if variable.dtype.kind == "f":
                    assert variable.attrs["units"] == (column.unit or "1")
                    known = [math.nan if cell.value is None else cell.value for cell in cells]
                    assert np.array_equal(variable[:], np.array(known, dtype=float), equal_nan=True), (name, plain)
                else:
                    assert any(not cell.is_number and cell.value is not None for cell in cells) or not any(
                        cell.is_number for cell in cells
                    )
                    assert words(variable) == [cell.text for cell in cells], (name, plain)
            assert left == set(), name


def words(variable):
    """Return the texts of a variable of netCDF."""
    return [value.decode() if isinstance(value, bytes) else value for value in variable[:]]


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
