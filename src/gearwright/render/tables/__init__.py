"""Tables of results: one mechanism for terminal, page and machine, and what each result shows in it.

Sentences are in `words`, drawings of numbers in `figures`.
"""
