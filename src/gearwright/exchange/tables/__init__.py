"""Every table of a sizing for spreadsheets and programs: XLSX, CSV, Parquet, netCDF.

What the tables hold is `render.tables`'; tables of studies are `study`'s to write.
"""

from gearwright.exchange.tables.columns import table_csv, to_netcdf, to_parquet
from gearwright.exchange.tables.long import all_tables, to_csv
from gearwright.exchange.tables.xlsx import to_xlsx

__all__ = ["all_tables", "table_csv", "to_csv", "to_netcdf", "to_parquet", "to_xlsx"]
