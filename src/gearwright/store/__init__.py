"""Save and load values."""

from gearwright.store.netcdf import StoredRun, load, save

__all__ = ["StoredRun", "load", "save"]
