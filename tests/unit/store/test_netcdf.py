"""A run that is saved is loaded equal; what is no run of gearwright is refused."""

from dataclasses import fields, is_dataclass
from itertools import pairwise

import h5netcdf
import numpy as np
import pytest

from designs import HYBRID
from gearwright.dynamics import Outputs, replay, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.store import load, netcdf, save


@pytest.fixture(scope="module")
def design():
    return parse(HYBRID + '\n[dynamics]\nstiffness = "constant"\n')


@pytest.fixture(scope="module")
def trace(design):
    """A millisecond of cruise, with a window of full rate in it."""
    return simulate(assemble(size(design), "cruise"), 1e-3, outputs=Outputs(start=2.5e-4))


def same(one, two):
    """Tell whether two values of records, tuples and arrays are equal, kind for kind; NaN equals NaN."""
    if is_dataclass(one):
        return type(one) is type(two) and all(same(getattr(one, f.name), getattr(two, f.name)) for f in fields(one))
    if isinstance(one, np.ndarray):
        return (
            one.dtype == two.dtype
            and one.shape == two.shape
            and np.array_equal(one, two, equal_nan=one.dtype.kind == "f")
        )
    if isinstance(one, tuple):
        return len(one) == len(two) and all(same(a, b) for a, b in zip(one, two, strict=True))
    return one == two or (one != one and two != two)


def test_what_is_saved_is_loaded_equal(tmp_path, trace, design):
    path = tmp_path / "run.nc"
    save(path, trace, design=design, case="cruise")
    found = load(path)
    assert found.design == design
    assert found.case == "cruise"
    assert same(found.trace, trace)
    assert len(trace.samples.time) > 1
    assert all(earlier < later for earlier, later in pairwise(trace.samples.time))


def test_equality_notices_a_difference(trace):
    """The comparison above would see one changed sample."""
    changed = trace.samples.velocity.copy()
    changed[0, 0] += 1e-9
    assert not same(trace.samples.velocity, changed)


def test_a_file_carries_units_names_and_the_design(tmp_path, trace, design):
    path = tmp_path / "run.nc"
    save(path, trace, design=design, case="cruise")
    with h5netcdf.File(path, "r") as file:
        assert file.attrs["format"] == netcdf.FORMAT
        assert "two planetary stages in line" in file.attrs["design"]
        assert file.groups["samples"].variables["time"].attrs["units"] == "s"
        assert file.attrs["lines"].split("\n") == list(trace.labels.lines)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(DesignError, match="there is no such file"):
        load(tmp_path / "none.nc")


def test_a_broken_file_is_refused(tmp_path, trace, design):
    path = tmp_path / "run.nc"
    save(path, trace, design=design, case="cruise")
    path.write_bytes(path.read_bytes()[:2000])
    with pytest.raises(DesignError, match="cannot be read as netCDF-4"):
        load(path)
    path.write_bytes(b"this is text")
    with pytest.raises(DesignError, match="cannot be read as netCDF-4"):
        load(path)


def test_a_foreign_file_is_refused(tmp_path):
    path = tmp_path / "weather.nc"
    with h5netcdf.File(path, "w") as file:
        file.dimensions["time"] = 3
        file.create_variable("temperature", ("time",), float, data=np.arange(3.0))
    with pytest.raises(
        DesignError, match=r"this is not a gearwright run; `gearwright simulate --output` writes one"
    ) as caught:
        load(path)
    assert caught.value.source == str(path)


def test_a_file_that_lacks_a_part_is_refused(tmp_path):
    path = tmp_path / "half.nc"
    with h5netcdf.File(path, "w") as file:
        file.attrs["format"] = netcdf.FORMAT
    with pytest.raises(DesignError, match="is incomplete"):
        load(path)


def test_a_folder_is_no_file(tmp_path, trace, design):
    with pytest.raises(DesignError, match="this is a folder"):
        load(tmp_path)
    with pytest.raises(DesignError, match="cannot be written"):
        save(tmp_path / "missing" / "run.nc", trace, design=design, case="cruise")


def test_an_interrupted_write_leaves_the_old_file(tmp_path, trace, design, monkeypatch):
    path = tmp_path / "run.nc"
    save(path, trace, design=design, case="cruise")
    before = path.read_bytes()

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(netcdf, "_write_part", interrupted)
    with pytest.raises(KeyboardInterrupt):
        save(path, trace, design=design, case="rated")
    assert path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == ["run.nc"]


def test_orders_and_the_tolerance_of_adaptive_steps_are_kept(tmp_path):
    """A stored Tsit5 run can be replayed, and streamed order amplitudes come back complex."""
    sizing = size(parse(HYBRID))
    system = assemble(sizing, "cruise")
    trace = simulate(system, 0.002, method="tsit5", outputs=Outputs(orders=("first.sun-planet-1",)))
    save(tmp_path / "run.nc", trace, design=sizing.design, case="cruise")
    found = load(tmp_path / "run.nc").trace
    assert found.tolerance == trace.tolerance > 0.0
    assert found.orders.names == trace.orders.names
    assert found.orders.tones == trace.orders.tones
    assert np.array_equal(found.orders.amplitude, trace.orders.amplitude)
    part = replay(system, found, 0.0005, 0.001)
    assert np.array_equal(part.position, replay(system, trace, 0.0005, 0.001).position)
