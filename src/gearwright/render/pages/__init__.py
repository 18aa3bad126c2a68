"""Self-contained HTML pages: report, flight, load sharing, study, comparison, masses.

What stands on them comes from `tables`, `words`, `figures` and `schematic`.
"""
