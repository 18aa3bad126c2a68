"""What a sheet is made of: entities, dimensions, symbols, tables, frame, and its DXF and SVG writers.

What is drawn of a part is in `views`.
"""
