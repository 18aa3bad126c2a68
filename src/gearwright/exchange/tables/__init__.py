"""Every table of a sizing for spreadsheets: as XLSX, a sheet each, and as one CSV text in long form.

What the tables hold is `render.tables`'; tables of studies are `study`'s to write.
"""

from gearwright.exchange.tables.long import all_tables, to_csv
from gearwright.exchange.tables.xlsx import to_xlsx

__all__ = ["all_tables", "to_csv", "to_xlsx"]
