"""The skeleton of a train, the power flow on it, and mode shapes drawn on it.

To scale, with dimensions, parts are drawn in `drawings`.
"""
