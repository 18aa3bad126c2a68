"""Tables as such: records with columns, units and marks; on a terminal, on a page, as CSV text.

It knows no result: what a result shows as tables is in `tables`.
"""
