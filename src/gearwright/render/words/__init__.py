"""Results in words for the terminal, and as JSON and CSV for machines.

Tables come from `tables`.
"""
