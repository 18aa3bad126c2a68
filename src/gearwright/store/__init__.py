"""Save and load values: runs as netCDF-4, everything else as JSON."""

from gearwright.store.image import netcdf_bytes, new_netcdf
from gearwright.store.netcdf import StoredRun, load_run, save_run
from gearwright.store.value import load, save, text_of_value

__all__ = ["StoredRun", "load", "load_run", "netcdf_bytes", "new_netcdf", "save", "save_run", "text_of_value"]
