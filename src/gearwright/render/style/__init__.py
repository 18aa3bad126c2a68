"""The look of everything that is drawn: one font, one palette, labels that do not overlap, HTML templates.

What is drawn is decided in the rooms above.
"""
