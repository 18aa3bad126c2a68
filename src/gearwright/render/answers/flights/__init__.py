"""Answers about what flies: missions, mixes of them, measured duties, propellers, engines.

How a record becomes JSON is in `plain` and `described`.
"""
