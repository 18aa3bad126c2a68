"""Commands of many designs: studies and their journals, searches, enumerated architectures.

What they share is in `options`, `running` (workers, progress) and `shown` (tables, verdicts, files).
"""
