"""Views and sections of gears, shafts and bearings, with the data that stands beside them.

Sheets are put together one folder up.
"""
