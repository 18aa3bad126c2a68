"""Tables of a study: the one of all variants, and the lists on its page.

How studies run is in `words`, their numbers over axes in `figures/study`.
"""
