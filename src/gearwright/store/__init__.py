"""Save and load values."""

from gearwright.store.image import new_netcdf
from gearwright.store.netcdf import StoredRun, load, save

__all__ = ["StoredRun", "load", "new_netcdf", "save"]
