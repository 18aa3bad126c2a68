"""Tables for other programs: netCDF-4, Parquet and CSV hold the same numbers, units, names and reasons."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

import pytest
import xarray

from gearwright.errors import DesignError
from gearwright.render.tables.variants import study_csv
from gearwright.sizing import TEXT, Named
from gearwright.study import Row, Table, tables as export
from gearwright.study.tables import columns, refuse_export, write_table

GOOD = {"mass": Named(43.5, "mass"), "n": Named(2.0 * math.pi, "speed"), "fly.governing": Named("first.sun", TEXT)}
ENDLESS = {**GOOD, "n": Named(math.inf, "speed")}
TABLE = Table(
    "three cases",
    "one of them fails",
    ("mass", "n", "fly.governing"),
    (
        Row("a", {"gears.x": 1, "gears.material": "steel", "teeth.hunting": True}, GOOD),
        Row("b", {"gears.x": 2.5, "gears.material": "other", "teeth.hunting": False}, {}, 'too, "small"\nfor it'),
        Row("a", {"gears.x": 3, "gears.material": "steel", "teeth.hunting": True}, ENDLESS),
    ),
)


def test_columns_have_numbers_in_shown_units_and_texts_as_they_are() -> None:
    found = columns(TABLE)
    assert found["gears.x"] == ([1.0, 2.5, 3.0], "")
    assert found["teeth.hunting"] == (["True", "False", "True"], "")
    assert found["mass"][0][0] == 43.5 and math.isnan(found["mass"][0][1]) and found["mass"][1] == "kg"
    assert found["n"][0][0] == pytest.approx(60.0) and found["n"][1] == "rpm"
    assert found["fly.governing"] == (["first.sun", "", "first.sun"], "")


def test_netcdf_is_read_again(tmp_path: Path) -> None:
    write_table(tmp_path / "t.nc", TABLE)
    with xarray.open_dataset(tmp_path / "t.nc", engine="h5netcdf") as read:
        assert read["mass"].values[0] == 43.5 and read["mass"].attrs["units"] == "kg"
        assert read["n"].values[2] == math.inf
        assert list(read["fly.governing"].values) == ["first.sun", "", "first.sun"]
        assert read.attrs["title"] == "three cases"


@pytest.mark.extra("pyarrow")
def test_parquet_is_read_again(tmp_path: Path) -> None:
    from pyarrow import parquet

    write_table(tmp_path / "t.parquet", TABLE)
    read = parquet.read_table(tmp_path / "t.parquet")
    assert read.schema.field("mass").metadata == {b"unit": b"kg"}
    assert read.schema.metadata[b"title"] == b"three cases"
    for name, (values, _) in columns(TABLE).items():
        assert [str(each) for each in read[name].to_pylist()] == [str(each) for each in values]


def test_csv_quotes_what_it_must() -> None:
    rows = list(csv.DictReader(io.StringIO(study_csv(TABLE))))
    assert rows[1]["problem"] == 'too, "small"\nfor it'
    assert float(rows[0]["mass [kg]"]) == 43.5 and rows[1]["mass [kg]"] == ""
    assert rows[0]["fly.governing"] == "first.sun"


@pytest.mark.parametrize(("name", "said"), [("t.txt", ".nc or .parquet"), ("no/where.nc", "there is no folder")])
def test_a_file_that_cannot_be_written_is_told_first(tmp_path: Path, name: str, said: str) -> None:
    with pytest.raises(DesignError) as raised:
        refuse_export(tmp_path / name)
    assert said in str(raised.value)


def test_without_pyarrow_it_is_told_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(export, "find_spec", lambda name: None)
    with pytest.raises(DesignError, match=r"gearwright\[parquet\]"):
        write_table(tmp_path / "t.parquet", TABLE)
