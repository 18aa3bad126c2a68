"""Figures as values: panels, marks, scales, their layout on paper, and one writer of SVG with real text.

What is drawn is decided in the rooms above; the look and the seam to pages are in `style`.
"""
