"""What the report prints, and its own computation executed step by step, the wrong steps on purpose.

What would have been right is in `verdicts`.
"""
