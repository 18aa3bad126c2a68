"""What is right in place of what is wrong: values by gearwright's own parts, checks of what was designed, reasons.

The report's own numbers are in `report`.
"""
