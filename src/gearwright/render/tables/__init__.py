"""Tables of results: what each of them shows, on a terminal, on a page and to machines.

Tables as such are in `grid`, sentences in `words`, drawings of numbers in `figures`.
"""
