"""Pages of many designs: studies, searches, architectures, comparisons.

What follows from their rows is computed in `study`, `optimum`, `enumeration` and `closure`.
"""
