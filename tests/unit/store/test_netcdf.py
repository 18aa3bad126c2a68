"""A run that is saved is loaded equal; what is no run of gearwright is refused."""

from itertools import pairwise

import h5netcdf
import numpy as np
import pytest

from designs import HYBRID
from gearwright import store as netcdf
from gearwright.dynamics import Outputs, replay, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.errors import DesignError
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.store import StoredRun, load, load_run, save
from same import same


@pytest.fixture(scope="module")
def design():
    return parse(HYBRID + '\n[dynamics]\nstiffness = "constant"\n')


@pytest.fixture(scope="module")
def trace(design):
    """A millisecond of cruise, with a window of full rate in it."""
    return simulate(assemble(size(design), "cruise"), 1e-3, outputs=Outputs(start=2.5e-4))


def test_what_is_saved_is_loaded_equal(tmp_path, trace, design):
    path = tmp_path / "run.nc"
    save(StoredRun(design, "cruise", trace), path)
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


def words(variable):
    """Return the texts of a variable, which versions of the library read as texts or as bytes."""
    return [name if isinstance(name, str) else name.decode() for name in variable[...]]


def test_a_file_carries_units_names_and_the_design(tmp_path, trace, design):
    path = tmp_path / "run.nc"
    save(StoredRun(design, "cruise", trace), path)
    with h5netcdf.File(path, "r") as file:
        assert file.attrs["format"] == netcdf.FORMAT
        assert "two planetary stages in line" in file.attrs["design"]
        assert file.groups["samples"].variables["time"].attrs["units"] == "s"
        assert file.attrs["lines"].split("\n") == list(trace.labels.lines)
        names = {"line": trace.labels.lines, "coordinate": trace.labels.coordinates}
        for dimension, labels in names.items():
            variable = file.groups["samples"].variables[dimension]
            assert variable.dimensions == (dimension,) and words(variable) == list(labels)
        assert words(file.groups["force"].variables["name"]) == list(trace.force.names)


def test_a_run_knows_whose_its_lines_are_also_one_of_a_version_that_did_not_say(tmp_path, trace, design):
    path = tmp_path / "run.nc"
    save(StoredRun(design, "cruise", trace), path)
    assert load(path).trace.labels == trace.labels
    assert trace.labels.line_owners[0].part is not None
    with h5netcdf.File(path, "a") as file:
        for name in ("coordinate_owners", "line_owners", "drive_owners"):
            del file.attrs[name]
    assert load(path).trace.labels == trace.labels


def test_a_run_of_the_former_format_is_loaded_equal(tmp_path, trace, design):
    """It called the variables of statistics `least` and `most`."""
    path = tmp_path / "run.nc"
    save(StoredRun(design, "cruise", trace), path)
    with h5netcdf.File(path, "a") as file:
        file.attrs["format"] = "gearwright trace 1"
        for group in ("force", "deflection", "velocity"):
            variables = file.groups[group]
            for name, former in (("minimum", "least"), ("maximum", "most")):
                values = np.asarray(variables.variables[name][...])
                variables.create_variable(former, ("bin", "name"), float, data=values)
                del variables._h5group[name]
    with h5netcdf.File(path, "r") as file:
        assert {"least", "most"} <= set(file.groups["force"].variables)
        assert not {"minimum", "maximum"} & set(file.groups["force"].variables)
    assert same(load(path).trace, trace)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(DesignError, match="there is no such file"):
        load(tmp_path / "none.nc")


def test_a_broken_file_is_refused(tmp_path, trace, design):
    path = tmp_path / "run.nc"
    save(StoredRun(design, "cruise", trace), path)
    path.write_bytes(path.read_bytes()[:2000])
    with pytest.raises(DesignError, match="cannot be read as netCDF-4"):
        load(path)
    path.write_bytes(b"this is text")
    with pytest.raises(DesignError, match=r"none of gearwright's: .*; gw\.save\(value, path\) writes one"):
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
        save(StoredRun(design, "cruise", trace), tmp_path / "missing" / "run.nc")


def test_an_interrupted_write_leaves_the_old_file(tmp_path, trace, design, monkeypatch):
    path = tmp_path / "run.nc"
    save(StoredRun(design, "cruise", trace), path)
    before = path.read_bytes()

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(netcdf, "_write_part", interrupted)
    with pytest.raises(KeyboardInterrupt):
        save(StoredRun(design, "rated", trace), path)
    assert path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == ["run.nc"]


def test_orders_and_the_tolerance_of_adaptive_steps_are_kept(tmp_path):
    """A stored Tsit5 run can be replayed, and streamed order amplitudes come back complex."""
    sizing = size(parse(HYBRID))
    system = assemble(sizing, "cruise")
    trace = simulate(system, 0.002, method="tsit5", outputs=Outputs(orders=("first.sun-planet-1",)))
    save(StoredRun(sizing.design, "cruise", trace), tmp_path / "run.nc")
    found = load(tmp_path / "run.nc").trace
    assert found.tolerance == trace.tolerance > 0.0
    assert found.orders.names == trace.orders.names
    assert found.orders.tones == trace.orders.tones
    assert np.array_equal(found.orders.amplitude, trace.orders.amplitude)
    part = replay(system, found, 0.0005, 0.001)
    assert np.array_equal(part.position, replay(system, trace, 0.0005, 0.001).position)


def test_a_trace_without_its_design_is_loaded_as_a_trace(tmp_path, trace):
    save(trace, tmp_path / "trace.nc")
    assert same(load(tmp_path / "trace.nc"), trace)
    with pytest.raises(DesignError, match=r"saved without its design; .*StoredRun"):
        load_run(tmp_path / "trace.nc")


def test_a_run_of_a_newer_version_is_refused(tmp_path):
    path = tmp_path / "run.nc"
    with h5netcdf.File(path, "w") as file:
        file.attrs["format"] = "gearwright trace 3"
    with pytest.raises(DesignError, match=r"a newer gearwright wrote this run .*; update gearwright"):
        load(path)
