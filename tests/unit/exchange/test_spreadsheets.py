"""Tables of a sizing for spreadsheets: CSV in long form, and XLSX read back as the XML that it is."""

import csv
import dataclasses
import io
import zipfile
from xml.etree import ElementTree

import pytest

import gearwright as gw
from gearwright.exchange import tables as columns
from gearwright.exchange.tables import all_tables, formulas_of, table_csv, to_csv, to_netcdf, to_parquet, to_xlsx
from shipped_work import sized
from workbooks import SHEET, book


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text)))


def test_every_number_of_a_table_stands_with_its_unit_and_source():
    """The module of In-Line H2's second sun, in mm, with the equation of sizing."""
    gear = next(gear for gear in sized("in-line-h2").gears if gear.name == "second.sun")
    (row,) = [row for row in rows_of(to_csv(sized("in-line-h2")))
              if (row["table"], row["row"], row["quantity"]) == ("Gears", "second.sun", "module")]  # fmt: skip
    assert float(row["value"]) == pytest.approx(1e3 * gear.module, rel=1e-12)
    assert (row["symbol"], row["unit"]) == ("m_n", "mm")
    assert "m_n ≥" in row["equation"] and row["source"]


@pytest.mark.parametrize("design", ["ec120b", "ravigneaux-automatic", "off-set"])
def test_no_table_is_left_out_of_the_long_form(design):
    titles = {table.title for table in all_tables(sized(design)).values()}
    assert {row["table"] for row in rows_of(to_csv(sized(design)))} == titles


def test_a_name_that_spreadsheets_take_for_a_formula_stays_a_text():
    design = gw.parse(gw.design_text(sized("star").design).replace('name = "Star', 'name = "=Star'))
    assert "\n=" not in to_csv(gw.size(design))


@pytest.mark.extra("xlsxwriter")
@pytest.mark.parametrize("design", ["in-line-h2", "ec120b"])
def test_every_table_is_a_sheet_with_its_units_and_values(design):
    sizing = sized(design)
    sheets, tables = book(to_xlsx(sizing)), all_tables(sizing)
    assert list(sheets) == ["contents", *(name.replace("_", " ")[:31] for name in tables)]
    gears = sheets["gears"]
    place = next(cell for cell, value in gears.items() if cell.endswith("2") and value == "module")
    column = place[:-1]
    assert gears[f"{column}4"] == "mm" and "m_n" in gears[f"{column}5"]
    assert gears[f"{column}7"] == pytest.approx(1e3 * sizing.gears[0].module, rel=1e-12)


@pytest.mark.extra("xlsxwriter")
def test_what_follows_from_its_row_is_a_live_formula_with_its_value_beside():
    """d = m_n z / cos β and P = T n; numbers that a formula does not give stay numbers."""
    sizing = sized("ec120b")
    files = zipfile.ZipFile(io.BytesIO(to_xlsx(sizing)))
    place = ["contents", *all_tables(sizing)].index("gears") + 1
    cells = ElementTree.fromstring(files.read(f"xl/worksheets/sheet{place}.xml")).iter(f"{SHEET}c")
    found = {cell.get("r"): (cell.find(f"{SHEET}f"), cell.find(f"{SHEET}v")) for cell in cells}
    formula, value = found["G7"]
    assert formula.text == "D7*C7/COS(RADIANS(E7))"
    assert float(value.text) == pytest.approx(1e3 * sizing.gears[0].pitch_diameter, rel=1e-12)
    assert found["D7"][0] is None


def test_a_formula_that_does_not_give_the_value_is_none():
    table = next(table for table in all_tables(sized("ec120b")).values() if table.title == "Gears")
    row = table.rows[0]
    place = [column.name for column in table.columns].index("pitch_diameter")
    assert place in formulas_of(table, row, 7)
    changed = (*row[:place], dataclasses.replace(row[place], value=1.001 * row[place].value), *row[place + 1 :])
    assert place not in formulas_of(table, changed, 7)


@pytest.mark.extra("xlsxwriter")
def test_lives_without_end_are_words_in_a_workbook():
    """A spreadsheet has no infinite number: such cells are texts, and none is lost."""
    for table, sheet in zip(all_tables(sized("ec120b")).values(), list(book(to_xlsx(sized("ec120b"))).values())[1:],
                            strict=True):  # fmt: skip
        filled = sum(bool(cell.text) for row in table.rows for cell in row)
        assert sum(value is not None for value in sheet.values()) >= filled


@pytest.mark.extra("pyarrow")
def test_parquet_holds_what_the_long_form_holds():
    from pyarrow import parquet

    read = parquet.read_table(io.BytesIO(to_parquet(sized("in-line-h2")))).to_pylist()
    written = rows_of(to_csv(sized("in-line-h2")))
    assert len(read) == len(written)
    for row, line in zip(read, written, strict=True):
        assert (row["table"], row["quantity"], row["unit"]) == (line["table"], line["quantity"], line["unit"])
        if row["value"] is None:
            assert row["text"] == line["value"].removeprefix("'")
        else:
            assert row["value"] == float(line["value"])


def test_who_lacks_pyarrow_is_told_what_to_install(monkeypatch):
    monkeypatch.setattr(columns, "find_spec", lambda name: None)
    with pytest.raises(gw.DesignError, match=r"parquet needs PyArrow.*pip install.*\[parquet\].*or use netcdf"):
        to_parquet(sized("star"))


@pytest.mark.extra("xarray")
@pytest.mark.parametrize("design", ["in-line-h2", "ec120b", "off-set"])
def test_netcdf_has_a_group_for_each_table_with_its_rows_as_coordinate(design, tmp_path):
    import xarray

    path = tmp_path / "tables.nc"
    path.write_bytes(to_netcdf(sized(design)))
    for name, table in all_tables(sized(design)).items():
        with xarray.open_dataset(path, group=name, engine="h5netcdf") as read:
            assert list(read.coords["row"].values) == [row[0].text for row in table.rows]
            assert len(read.data_vars) == len(table.columns)
    gear = sized(design).gears[0]
    with xarray.open_dataset(path, group="gears", engine="h5netcdf") as read:
        assert float(read["module"].sel(row=gear.name)) == pytest.approx(1e3 * gear.module, rel=1e-12)
        assert read["module"].attrs["units"] == "mm"


def test_one_table_is_as_wide_as_it_is():
    rows = rows_of(table_csv(sized("in-line-h2"), "gears"))
    gears = {gear.name: gear for gear in sized("in-line-h2").gears}
    assert {row[""]: float(row["module [mm]"]) for row in rows} == pytest.approx(
        {name: 1e3 * gear.module for name, gear in gears.items()}, rel=1e-12
    )
    with pytest.raises(gw.DesignError, match=r"no table of this design.*gears"):
        table_csv(sized("star"), "gear")
