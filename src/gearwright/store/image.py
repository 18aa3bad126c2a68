"""NetCDF-4 files, filled in memory and then written whole.

HDF5 ends the process where a disk that is full meets one of its destructors; in memory it meets none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import Any

import h5netcdf

from gearwright.writing import write_bytes


def netcdf_bytes(fill: Callable[[Any], None]) -> bytes:
    """Return a netCDF-4 file as bytes.

    Args:
        fill: What writes into the empty file.
    """
    image = BytesIO()
    with h5netcdf.File(image, "w") as file:
        fill(file)
    return image.getvalue()


@contextmanager
def new_netcdf(path: Path) -> Iterator[Any]:
    """Hold an empty netCDF-4 file to fill; it is written when it is complete.

    Args:
        path: Of the file.

    Raises:
        DesignError: If no file can be there.
        SolveError: If the disk does not take it.
    """
    image = BytesIO()
    with h5netcdf.File(image, "w") as file:
        yield file
    write_bytes(path, image.getbuffer())
